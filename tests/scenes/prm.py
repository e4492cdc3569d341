# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads scenes (.prm) and the parameter reference."""
import re

NAMED = ("Tissues", "Heat sources", "Boundaries", "Loads", "Tools", "Accuracy")  # sections with a subsection for each name


def entries(text):
    """(path, value, the comment above) of every `set`; the path's sections joined by slashes."""
    path, comment = [], ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("#"):
            comment += line[1:]
            continue
        if line.startswith("subsection "):
            path.append(line.removeprefix("subsection ").strip())
        elif line == "end":
            path.pop()
        elif line.startswith("set "):
            name, _, value = re.sub(r"\s#.*", "", line).removeprefix("set ").partition("=")
            yield "/".join([*path, name.strip()]), value.strip(), comment
        comment = ""


def values(text):
    return {path: value for path, value, _ in entries(text)}


def general(path):
    """The path with * in place of the name of a tissue, source, boundary, load or tool."""
    parts = path.split("/")
    if parts[0] in NAMED and len(parts) > 2:
        parts[1] = "*"
    return "/".join(parts)
