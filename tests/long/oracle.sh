#!/usr/bin/env bash
# Compares 2,000 random scenes with the oracle, on one rank and on two, and 200 each with AVX2 (the default except on
# machines with AVX-512) and without vectors. CRACKSIM_SEED repeats a campaign.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
seed=${CRACKSIM_SEED:-$((RANDOM * 32768 + RANDOM))}
export CRACKSIM_SCENES=500
failed=0
jobs/build.sh release verification_oracle_test >/dev/null

echo "$(date -u +%F), commit $(git rev-parse --short HEAD)"
for ranks in 1 2 1 2; do
    CRACKSIM_SEED=$seed mpirun -n "$ranks" build/release/tests/verification_oracle_test \
        --gtest_brief=1 --gtest_color=no || failed=1
    seed=$((seed + CRACKSIM_SCENES))
done
for target in AVX2 SCALAR; do
    CRACKSIM_SIMD=$target CRACKSIM_SCENES=200 CRACKSIM_SEED=$seed \
        mpirun -n 2 build/release/tests/verification_oracle_test --gtest_brief=1 --gtest_color=no || failed=1
done
exit "$failed"
