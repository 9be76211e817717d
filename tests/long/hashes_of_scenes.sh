#!/usr/bin/env bash
# Compares the hashes of the large scenes on 1, 2, 3, 4 and 7 ranks, METIS and slab, with and without --audit, in both
# builds, in both precisions, with the widest vectors of this machine, with AVX2, and without vectors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
export ASAN_OPTIONS=fast_unwind_on_malloc=0
export LSAN_OPTIONS=suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
declare -A expected
label=""
failed=0
jobs/build.sh release cracksim >/dev/null
jobs/build.sh sanitize cracksim >/dev/null

# compare SCENE BINARY RANKS OPTIONS...: runs with the same LABEL must agree
compare() {
    local scene=$1 binary=$2 ranks=$3 found outcome=equal
    shift 3
    mpirun -n "$ranks" "$binary" "inputs/$scene.yaml" --out "$work/run" --quiet --set output.surface=false \
        --set output.crack=false --set output.masses=false --set output.topology=false "$@"
    found=$(python3 -c 'import json, sys
s = json.load(open(sys.argv[1]))
print(s["event_hash"], s["state_hash"], s["events"]["splits"], "splits")' "$work/run/summary.json")
    expected[$scene$label]=${expected[$scene$label]:-$found}
    [[ $found == "${expected[$scene$label]}" ]] || { outcome=DIFFERENT; failed=1; }
    echo "$scene $outcome: $found  $ranks ranks, $binary, $*"
}

for ranks in 1 2 3 4 7; do
    for kind in metis slab; do
        compare block build/release/cracksim "$ranks" --set "partition.kind=$kind"
        compare block build/release/cracksim "$ranks" --set "partition.kind=$kind" --audit
    done
    for scene in block_b tear; do
        compare "$scene" build/release/cracksim "$ranks"
    done
done
for scene in block_b tear; do
    compare "$scene" build/release/cracksim 3 --set partition.kind=slab --audit
    compare "$scene" build/release/cracksim 2 --set sensors.prefilter=false
done
compare block build/sanitize/cracksim 2
for ranks in 1 2 7; do
    compare block build/release/cracksim "$ranks" --simd AVX2
done
label=", single"
for ranks in 1 2 3 4 7; do
    for scene in block block_b tear; do
        compare "$scene" build/release/cracksim "$ranks" --set time.precision=single
    done
done
for ranks in 1 2 7; do
    compare block build/release/cracksim "$ranks" --set time.precision=single --simd AVX2
done
label=", standard entities"
for ranks in 1 2 3 4 7; do
    for kind in metis slab; do
        compare block build/release/cracksim "$ranks" --set material.model=standard --set sensors.kind=stress \
            --set "partition.kind=$kind"
    done
done
compare block build/release/cracksim 2 --set material.model=standard --set sensors.kind=stress \
    --set sensors.prefilter=false
label=", standard entities, single"
for ranks in 1 2 7; do
    compare block build/release/cracksim "$ranks" --set material.model=standard --set sensors.kind=stress \
        --set time.precision=single
done
label=", SCALAR"
for ranks in 1 2 7; do
    compare block build/release/cracksim "$ranks" --simd SCALAR
done
exit "$failed"
