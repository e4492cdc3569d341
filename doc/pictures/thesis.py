# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the thesis's scenes and draws the pictures of doc/thesis.md from what they leave.

Usage, from the project's root: /usr/bin/python3 -B doc/pictures/thesis.py [PICTURE ...]
(Debian's python3-matplotlib, python3-vtk9)
Runs are kept in output/thesis/ and not repeated; remove them to run anew.
"""
import sys

import chapter_4_and_5
import chapter_6
import chapter_7
import margins
from runs import IMAGES

PICTURES = {name: function for chapter in (chapter_4_and_5, chapter_6, chapter_7, margins)
            for name, function in vars(chapter).items()
            if getattr(function, "__module__", None) == chapter.__name__ and (function.__doc__ or "").startswith(
                ("Figure", "What"))}

if __name__ == "__main__":
    IMAGES.mkdir(parents=True, exist_ok=True)
    for picture in sys.argv[1:] or PICTURES:
        PICTURES[picture]()
