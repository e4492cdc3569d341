# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fails if a stage includes one above it, or one beside it. Usage: includes.py PROJECT"""
import pathlib
import re
import sys

RANK = {"base": 1, "laws": 2, "scene": 3, "space": 4, "solve": 4, "physics": 5, "time": 6, "output": 6,
        "problems": 7, "study": 8}
INCLUDE = re.compile(r"^\s*#\s*include\s*<cautery/(\w+)/")

root = pathlib.Path(sys.argv[1])
files = [f for folder in ("include/cautery", "source") for f in sorted((root / folder).glob("*/*")) if f.is_file()]
climbs = []
for file in files:
    stage = file.parent.name
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if (match := INCLUDE.match(line)) and (included := match.group(1)) != stage:
            if RANK[included] >= RANK[stage]:
                climbs.append(f"{file.relative_to(root)}:{number}: {stage} must not include {included}")
print(f"{len(files)} files", *climbs, sep="\n")
sys.exit(1 if climbs or not files else 0)
