# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills the tables of doc/stability.md from what the hard cases find. Usage: tables.py PROJECT BUILD [CASE...]"""
import importlib
import pathlib
import re
import sys
import tempfile

from lab import Lab

if __name__ == "__main__":
    project, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    page = project / "doc" / "stability.md"
    wrong = 0
    for case in sys.argv[3:] or re.findall(r"<!-- (\w+) -->", page.read_text()):
        if case == "end":
            continue
        with tempfile.TemporaryDirectory() as folder:
            lab = Lab(build / "cautery", folder)
            importlib.import_module(case).check(lab)
        wrong += lab.wrong()
        text = re.sub(rf"(<!-- {case} -->\n).*?(<!-- end -->)", lambda m: f"{m[1]}\n{lab.table()}\n\n{m[2]}",
                      page.read_text(), flags=re.S)
        page.write_text(text)
    sys.exit(wrong > 0)
