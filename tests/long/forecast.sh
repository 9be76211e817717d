#!/usr/bin/env bash
# Compares the forecast for inputs/block.yaml with the run's needs on 1, 2 and 4 ranks: unchanged, with no breaking, and
# with everything broken at once (for a shorter time: its frames are large); also for larger blocks that do not break.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
export OMPI_MCA_mpi_yield_when_idle=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
jobs/build.sh release cracksim >/dev/null

# compare intact|broken|between NAME RANKS OPTIONS...
compare() {
    local end=$1 name=$2 ranks=$3
    shift 3
    rm -rf "$work/run"
    mpirun -n "$ranks" build/release/cracksim inputs/block.yaml --out "$work/run" --quiet "$@" 2>&1
    python3 - "$work/run" "$end" "$name, $ranks ranks" <<'PYTHON' || failed=1
import json, pathlib, sys
directory, end, name = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
summary = json.loads((directory / "summary.json").read_text())
forecast = summary["forecast"]
written = sum(path.stat().st_size for path in directory.rglob("*") if path.is_file())
good = True
for quantity, measured in (("memory", summary["memory"]["per_rank_max"]), ("output", written)):
    low, high = forecast[quantity + "_intact"], forecast[quantity + "_broken"]
    if end == "between":
        holds = 0.85 * low <= measured <= 1.15 * high
        print(f"{name:34} {quantity:9} {low / 1e6:9.1f} to {high / 1e6:8.1f} MB {measured / 1e6:9.1f} MB  "
              f"{'between' if holds else 'OUTSIDE'}")
    else:
        said = forecast[f"{quantity}_{end}"]
        # How much of a coat's memory the allocator can reuse is not known beforehand.
        holds = abs(said - measured) <= (0.2 if quantity == "memory" and end == "broken" else 0.15) * measured
        print(f"{name:34} {quantity:9} {said / 1e6:21.1f} MB {measured / 1e6:9.1f} MB  "
              f"{100 * (said / measured - 1):+6.1f} %{'' if holds else '  TOO FAR'}")
    good = good and holds
low, high = forecast["exchange_intact"], forecast["exchange_broken"]
measured = summary["exchange"]["bytes_per_step"]
right = {"intact": measured == low, "broken": abs(measured - high) <= 0.05 * high,
         "between": low <= measured <= high}[end]
print(f"{name:34} {'exchange':9} {low:10.0f} to {high:8.0f} B {measured:10.0f} B  {end if right else 'DIFFERENT'}")
sys.exit(0 if good and right else 1)
PYTHON
}

printf '%-34s %-9s %24s %12s  %s\n' run quantity forecast measured error
for ranks in 1 2 4; do
    compare between "block.yaml" "$ranks"
    compare intact "intact" "$ranks" --set sensors.threshold=.inf
    compare broken "broken, 0.1 s" "$ranks" --set 'sensors={threshold: 1.0e-9}' --set 'initial.velocity=[x, y, z]' \
        --set time.end=0.1
    for cells in "[20,20,5]" "[35,35,10]" "[100,100,10]" "[60,60,60]" "[200,200,20]"; do
        compare intact "intact $cells" "$ranks" --set sensors.threshold=.inf --set "block.cells=$cells" \
            --set time.end=0.02
    done
done
exit "$failed"
