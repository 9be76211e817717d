#!/usr/bin/env bash
# Feeds random bytes to the readers of scenes and expressions (tests/fuzz), CRACKSIM_FUZZ_RUNS runs each, with clang's
# sanitizers. Findings are written to build/fuzz/findings, the grown corpus to build/fuzz/grown; both are kept.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
runs=${CRACKSIM_FUZZ_RUNS:-10000000}
jobs/build.sh fuzz
failed=0

for target in scene expression; do
    grown=build/fuzz/grown/$target
    mkdir -p "$grown" build/fuzz/findings
    outcome=passed
    nice -n 19 "build/fuzz/tests/fuzz/fuzz_$target" "$grown" "tests/fuzz/corpus/$target" -runs="$runs" \
        -seed="${CRACKSIM_SEED:-1}" -max_len=4096 -rss_limit_mb=2048 -timeout=10 -dict=tests/fuzz/dictionary.txt \
        -artifact_prefix=build/fuzz/findings/ -print_final_stats=1 >"build/fuzz/$target.log" 2>&1 || outcome=FAILED
    echo "$outcome: fuzz_$target"
    if [[ $outcome == passed ]]; then
        grep -E '^(#[0-9]+[[:space:]]+DONE|Done|stat::)' "build/fuzz/$target.log"
    else
        failed=1
        tail -n 100 "build/fuzz/$target.log"
    fi
done
exit "$failed"
