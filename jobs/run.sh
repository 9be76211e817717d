#!/usr/bin/env bash
# Sets up, builds and runs cracksim. Usage: [RANKS=2] jobs/run.sh [INPUT.yaml] [options of cracksim]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
input=$root/inputs/block.yaml
if [[ $# -gt 0 && $1 != -* ]]; then
    input=$1
    shift
fi

"$root/jobs/setup.sh" build
"$root/jobs/build.sh" release cracksim
# shellcheck source=jobs/environment.sh
source "$root/jobs/environment.sh"

command=(mpirun -n "${RANKS:-2}" "$root/build/release/cracksim" "$input" "$@")
echo "+ ${command[*]@Q}"
started=$(mktemp)
trap 'rm -f "$started"' EXIT
status=0
"${command[@]}" || status=$?

directory=$(basename "${input%.*}").out
previous=
for argument in "$@"; do
    [[ $previous != --out ]] || directory=$argument
    [[ $argument != --out=* ]] || directory=${argument#--out=}
    previous=$argument
done
if [[ $directory/summary.json -nt $started ]]; then
    echo "a picture: xvfb-run -a pvpython $root/jobs/render.py $directory --out picture.png"
fi
exit "$status"
