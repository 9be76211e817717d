#!/usr/bin/env bash
# Compares cracksim's map with CGAL's generalized map, dart by dart, on 1, 2 and 3 ranks. CRACKSIM_SEED=n sets the first
# seed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
jobs/build.sh long map_oracle >/dev/null
for ranks in 1 2 3; do
    mpirun -n "$ranks" build/release/tests/map_oracle --gtest_color=no --gtest_brief=1
done
