#!/usr/bin/env bash
# Prints all measurements of speed and memory as one table; README.md describes their questions. Takes half an hour;
# nothing else should run on the machine.
# Usage: tests/bench/run.sh [--lammps PATH] [--against CRACKSIM] [--quick]
set -euo pipefail
lammps=()
against=()
quick=()
while [[ $# -gt 0 ]]; do
    case $1 in
        --lammps) lammps=(--lammps "$(realpath "$(command -v "$2")")"); shift 2 ;;
        --against) against=(--against "$(realpath "$2")"); shift 2 ;;
        --quick) quick=(--quick); shift ;;
        *) echo "usage: tests/bench/run.sh [--lammps PATH] [--against CRACKSIM] [--quick]" >&2; exit 2 ;;
    esac
done
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
jobs/setup.sh build test long
jobs/build.sh long cracksim machine_bench physics_bench

physics=(--benchmark_repetitions=7 --benchmark_enable_random_interleaving=true)
[[ ${#quick[@]} -eq 0 ]] || physics=(--benchmark_filter=49000 --benchmark_min_time=0.05)
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
# Rows go to the terminal as they are measured; the table is printed at the end.
{
    build/release/tests/machine_bench
    build/release/tests/physics_bench "${physics[@]}"
    python3 tests/bench/peers.py build/release/cracksim "${lammps[@]}" "${quick[@]}"
    python3 tests/bench/programs.py build/release/cracksim "${against[@]}" "${quick[@]}"
} | tee "$rows" >&2
echo
python3 tests/bench/table.py <"$rows"
[[ ${#quick[@]} -gt 0 ]] || tests/long/measurements.sh
