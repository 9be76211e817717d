#!/usr/bin/env bash
# Configures and builds a preset; prints the build's output only if it fails. Usage: jobs/build.sh PRESET [target...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=$1
shift
targets=()
[[ $# -eq 0 ]] || targets=(--target "$@")

log=$(mktemp)
trap 'rm -f "$log"' EXIT
if [[ ! -f build/$preset/build.ninja ]]; then
    echo "building cracksim, preset $preset (first time: about 3 minutes on 2 cores)"
fi
if ! { cmake --preset "$preset" &&
    cmake --build --preset "$preset" --parallel "${JOBS:-$(nproc)}" "${targets[@]}"; } >"$log" 2>&1; then
    cat "$log" >&2
    echo "building preset $preset failed" >&2
    exit 1
fi
