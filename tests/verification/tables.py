# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fills the tables of doc/verification.md from what the programs print. Usage: tables.py PROJECT BUILD"""
import pathlib
import re
import subprocess
import sys
import tempfile

project, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
programs = build / "tests" / "verification"
groups = ["heat", "waves", "damage", "deformation", "motion", "balance", "time_errors"]
line = re.compile(r"  (right|WRONG)  (.*), error (\S+) of (\S+)$")


def output(*command):
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(command, cwd=folder, capture_output=True, text=True).stdout


def exact():
    """Of each group: the number of comparisons, and the largest error as a part of what is allowed."""
    rows = ["| group | comparisons | wrong | largest error / tolerance |", "|---|---|---|---|"]
    for group in groups:
        text = output(programs / "exact", group)
        found = [match for match in map(line.match, text.splitlines()) if match]
        shares = [float(match[3]) / float(match[4]) for match in found]
        checks = len(re.findall(r"^  (?:right|WRONG)  ", text, re.M))
        rows.append(f"| {group} | {checks} | {text.count('  WRONG  ')} | {max(shares, default=0):.2f} |")
    return "\n".join(rows) + "\n"


tables = {
    "space": output(programs / "convergence", "space"),
    "time": output(programs / "convergence", "time"),
    "indicator": output(programs / "convergence", "indicator"),
    "exact": exact(),
}
page = project / "doc" / "verification.md"
text = page.read_text()
for name, table in tables.items():
    text = re.sub(rf"(<!-- {name} -->\n).*?(<!-- end -->)", lambda m: m[1] + "\n" + table + "\n" + m[2], text, flags=re.S)
page.write_text(text)
