#!/usr/bin/env bash
# The hashes of inputs/block.yaml on 1, 2, 3, 4 and 7 ranks, METIS and slab, with and without --audit, in both builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
export ASAN_OPTIONS=fast_unwind_on_malloc=0
export LSAN_OPTIONS=suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
expected=
failed=0

# compare BINARY RANKS OPTIONS...
compare() {
    local binary=$1 ranks=$2 found outcome=equal
    shift 2
    mpirun -n "$ranks" "$binary" inputs/block.yaml --out "$work/run" --quiet --set output.surface=false --set output.crack=false "$@"
    found=$(python3 -c 'import json, sys; s = json.load(open(sys.argv[1])); print(s["event_hash"], s["state_hash"], s["events"]["splits"], "splits")' "$work/run/summary.json")
    expected=${expected:-$found}
    [[ $found == "$expected" ]] || { outcome=DIFFERENT; failed=1; }
    echo "$outcome: $found  $ranks ranks, ${binary#"$PWD"/}, $*"
}

for ranks in 1 2 3 4 7; do
    for kind in metis slab; do
        compare build/release/cracksim "$ranks" --set "partition.kind=$kind"
        compare build/release/cracksim "$ranks" --set "partition.kind=$kind" --audit
    done
done
compare build/sanitize/cracksim 2
exit "$failed"
