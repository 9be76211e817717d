#!/usr/bin/env bash
# Measures the modification (tests/bench/README.md) and draws tests/charts/complexity.png from the new complexity.csv.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
table=$(mktemp)
trap 'rm -f "$table"' EXIT
jobs/build.sh long modification_bench >/dev/null
build/release/tests/modification_bench --benchmark_repetitions=15 --benchmark_enable_random_interleaving=true \
    --benchmark_report_aggregates_only=true --benchmark_out="$table" --benchmark_out_format=csv 2>&1 | grep -v '_cv '
grep -E '^name,|_(median|stddev)"' "$table" >tests/charts/complexity.csv
# Called by its path, because packages.txt installs matplotlib for the system's Python, which may not be the first one.
/usr/bin/python3 tests/charts/complexity.py
