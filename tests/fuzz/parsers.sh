#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# AFL++ on the parsers that are the project's own: scenes, expressions, properties, changes of a study, quantities.
#   tests/fuzz/parsers.sh [SECONDS]     default 600, of one process; ends with 1 where one crashed or hung
# What it finds stays in build-afl/found. Package: afl++. It builds with GCC, as clang cannot link deal.II.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v afl-fuzz >/dev/null || { echo 'skipped: afl++ is not installed'; exit 77; }

cmake -S . -B build-afl -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=afl-g++ >/dev/null
AFL_QUIET=1 ninja -C build-afl fuzz_parsers

seeds=build-afl/seeds
mkdir -p "$seeds"
seed() { printf '%s\n%s\n' "$2" "$3" >"$seeds/$1"; }
seed expression expression 'if(t < 10, 310 + 2 * sin(pi * x), exp(-y^2)) + max(z, 1)'
seed constant expression '-1.5e-3'
seed property property '300: 4192, 373: 5e4, 400: 2000'
seed polynomial property '0.5 + 1e-3 * (T - 310)'
seed changes changes 'Mesh/Subdivisions = 20; Time/Integrator = IDA'
seed probe quantity 'P1 temperature_K at 120'
seed summary quantity '/ablation/volume_m3'
for scene in prm/thesis/*.prm; do
  seed "$(basename "$scene")" scene "$(cat "$scene")"
done

# each word of the scenes once, for mutations that know them
sed -nE 's/^ *(set|subsection) ([A-Za-z ]*[A-Za-z]).*/"\2"/p' prm/thesis/*.prm | sort -u >build-afl/words
rm -rf build-afl/found
export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1
export ASAN_OPTIONS=abort_on_error=1:detect_leaks=0:symbolize=0:allocator_may_return_null=1
export UBSAN_OPTIONS=abort_on_error=1:symbolize=0
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 DEAL_II_NUM_THREADS=1
afl-fuzz -V "${1:-600}" -m none -t 2000 -x build-afl/words -i "$seeds" -o build-afl/found build-afl/tests/fuzz/fuzz_parsers |
  tail -n 4
grep -E 'execs_done|saved_crashes|saved_hangs|corpus_count' build-afl/found/default/fuzzer_stats
! grep -qE '(saved_crashes|saved_hangs) *: [1-9]' build-afl/found/default/fuzzer_stats
