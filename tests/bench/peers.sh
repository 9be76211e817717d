#!/usr/bin/env bash
# cracksim and CGAL, LAMMPS on the same block. Usage: tests/bench/peers.sh [--lammps PATH] [--pairs N] [--quick]
# --lammps: another build than Debian's, such as one with the package BPM; with the MPI of cracksim.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
quick=()
for argument in "$@"; do
    [[ $argument != --quick ]] || quick=(quick)
done
jobs/setup.sh build test long
jobs/build.sh long cracksim peers_cgal
{
    python3 tests/bench/peers.py build/release/cracksim "$@"
    build/release/tests/peers_cgal "${quick[@]}"
} | python3 tests/bench/table.py
