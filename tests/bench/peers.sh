#!/usr/bin/env bash
# cracksim and CGAL, LAMMPS on the same block. Usage: tests/bench/peers.sh [--lammps PATH] [--pairs N] [--quick]
# --lammps: another build than Debian's, such as one with the package BPM; with the MPI of cracksim.
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
# Rows of both maps, one after the other.
build/release/tests/map_bench "${map[@]}"
