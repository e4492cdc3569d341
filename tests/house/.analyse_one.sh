#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# What static analysis finds in the program's sources: cppcheck in a minute, clang-tidy in half an hour (deal.II's headers).
#   tests/house/analyse.sh cppcheck
#   tests/house/analyse.sh clang-tidy [FILE...]   after a build, which leaves build/compile_commands.json
# Packages: cppcheck, clang-tidy-14.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

case "${1:-}" in
cppcheck)
  command -v cppcheck >/dev/null || { echo 'skipped: cppcheck is not installed'; exit 77; }
  exec cppcheck --quiet --error-exitcode=1 --enable=warning,performance,portability --std=c++17 --inline-suppr \
    --suppressions-list=tests/house/cppcheck.txt -I include source include
  ;;
clang-tidy)
  shift
  commands=$(mktemp --directory)
  trap 'rm -rf "$commands"' EXIT
  # The program's own commands, without GCC's precompiled headers and the flags that clang does not know
  python3 - "$commands" <<'END'
import json, re, sys
entries = [entry for entry in json.load(open("build/compile_commands.json")) if " -o tests/" not in entry["command"]]
for entry in entries:
    entry["command"] = re.sub(r"-include \S*cmake_pch\.hxx| -[Wf]\S*", "", entry["command"])
json.dump(entries, open(sys.argv[1] + "/compile_commands.json", "w"))
END
  files=("$@")
  [ ${#files[@]} -gt 0 ] || mapfile -t files < <(find source -name '*.cc' -not -path '*/lanes/*' | sort)
  printf '%s\n' "${files[@]}" | xargs --max-procs=1 --max-args=1 clang-tidy-14 --quiet -p "$commands"
  ;;
*)
  sed -n 's/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
  ;;
esac
