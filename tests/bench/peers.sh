#!/usr/bin/env bash
# Measures cracksim, CGAL and LAMMPS on the same block.
# Usage: tests/bench/peers.sh [--lammps PATH] [--pairs N] [--quick]
# --lammps: a build other than Debian's, such as one with the package BPM; it must use cracksim's MPI.
set -euo pipefail
options=()
map=()
while [[ $# -gt 0 ]]; do
    case $1 in
        --lammps) options+=(--lammps "$(realpath "$(command -v "$2")")"); shift 2 ;;
        --pairs) options+=(--pairs "$2"); shift 2 ;;
        --quick) options+=(--quick); map=(--benchmark_min_time=0.01); shift ;;
        *) echo "usage: tests/bench/peers.sh [--lammps PATH] [--pairs N] [--quick]" >&2; exit 2 ;;
    esac
done
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
jobs/setup.sh build test long
jobs/build.sh long cracksim map_bench
python3 tests/bench/peers.py build/release/cracksim "${options[@]}" | python3 tests/bench/table.py
# Prints the rows of both maps, one map after the other.
build/release/tests/map_bench "${map[@]}"
