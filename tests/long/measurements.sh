#!/usr/bin/env bash
# Measures the map, the coat and the frames (tests/bench/README.md), and for comparison CGAL's map and labels of the
# whole block.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
jobs/build.sh long map_bench coat_bench frames_bench >/dev/null
build/release/tests/map_bench 2>/dev/null
build/release/tests/coat_bench 2>/dev/null
for ranks in 1 2; do
    echo "inputs/block.yaml on $ranks rank(s)"
    mpirun -n "$ranks" build/release/tests/frames_bench inputs/block.yaml "$frames"
done
