# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fails if clang-format 14 would change a source file; skipped (77) where it is missing. Usage: formatted.py PROJECT"""
import pathlib
import shutil
import subprocess
import sys

program = shutil.which("clang-format-14")
if program is None:
    print("skipped: clang-format-14 is not installed")
    sys.exit(77)
root = pathlib.Path(sys.argv[1])
files = [f for folder in ("include", "source", "tests") for pattern in ("*.h", "*.cc")
         for f in sorted((root / folder).rglob(pattern))]
sys.exit(subprocess.run([program, "--dry-run", "--Werror", "--style=file", *files], check=False).returncode)
