# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fails if a stage includes one above it, or one beside it. Usage: includes.py PROJECT"""
import pathlib
import re
import sys

RANK = {"base": 1, "laws": 2, "scene": 3, "space": 4, "solve": 4, "physics": 5, "time": 6, "output": 6,
        "problems": 7, "study": 8}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)')


def offences(file, stage):
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if not (match := INCLUDE.match(line)):
            continue
        quote, name = match.groups()
        if quote == '"':
            yield number, f'write <cautery/...>, not "{name}"'
        elif name.startswith("cautery/"):
            included = name.split("/")[1]
            if included not in RANK:
                yield number, f"{included} is no stage"
            elif included != stage and RANK[included] >= RANK[stage]:
                yield number, f"{stage} must not include {included}"


root = pathlib.Path(sys.argv[1])
files = climbs = 0
for folder in (root / "include/cautery", root / "source"):
    for file in sorted(folder.glob("*/**/*")):
        if not file.is_file():
            continue
        files += 1
        for number, offence in offences(file, file.relative_to(folder).parts[0]):
            climbs += 1
            print(f"{file.relative_to(root)}:{number}: {offence}")
print(f"{climbs} offences in {files} files")
sys.exit(1 if climbs or not files else 0)
