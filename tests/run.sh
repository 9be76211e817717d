#!/usr/bin/env bash
# Sets up, builds and tests everything; the last line is "N passed, N failed". Usage: tests/run.sh [--long]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=jobs/environment.sh
source jobs/environment.sh
log=$(mktemp)
trap 'rm -f "$log"' EXIT
passed=0
failed=0

# stage NAME COMMAND...: prints one line with the outcome and the time, and the output of the command only if it fails.
stage() {
    local name=$1 start=$SECONDS outcome=passed good bad
    shift
    "$@" >"$log" 2>&1 || outcome=FAILED
    [[ $outcome == passed ]] || cat "$log"
    # A run of ctest counts as its tests, any other stage as one test.
    read -r bad good < <(sed -nE 's/^.*tests passed, ([0-9]+) tests failed out of ([0-9]+)$/\1 \2/p' "$log") || bad=
    if [[ -n $bad ]]; then
        good=$((good - bad))
        [[ $outcome == passed || $bad -gt 0 ]] || bad=1
    else
        good=$([[ $outcome == passed ]] && echo 1 || echo 0)
        bad=$((1 - good))
    fi
    passed=$((passed + good))
    failed=$((failed + bad))
    printf '%-28s %-6s %4d s  %d passed, %d failed\n' "$name" "$outcome" $((SECONDS - start)) "$good" "$bad"
}

source_files() { git ls-files -co --exclude-standard -- {src,partition,io,tests}'/*.[ch]pp'; }

check_format() {
    [[ $(clang-format --version) == *" version 14."* ]] ||
        { echo "skipped: the format is that of clang-format 14"; return; }
    source_files | xargs clang-format --dry-run --Werror
}

# Sources changed since the main branch, or by the last commit, those of changed headers too.
changed_sources() {
    local base
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=
    if [[ -z $base || $base == $(git rev-parse HEAD) ]]; then
        base=$(git rev-parse -q --verify HEAD~1 || git hash-object -t tree /dev/null)
    fi
    { git ls-files -mo --exclude-standard; git diff --name-only --diff-filter=d "$base" HEAD; } |
        sed -E -e 's#^src/physics/lattice/sweep/.*-inl\.hpp$#src/physics/lattice/sweep/row_sweep_double.cpp#' \
            -e 's#^src/physics/standard/sweep/.*-inl\.hpp$#src/physics/standard/sweep/standard_row_double.cpp#' \
            -e 's#\.hpp$#.cpp#' |
        grep -E '^(src|partition|io)/.*\.cpp$' | awk '!seen[$0]++' | while read -r file; do
            [[ ! -f $file ]] || echo "$file"
        done
}

check_tidy() {
    local files
    files=$(changed_sources)
    [[ -n $files ]] || { echo "no source changed"; return; }
    xargs -P "$(nproc)" -n 1 clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option -p build/release <<<"$files"
}

run_ctest() { ctest --preset "$1" --no-tests=error -j 2; }

sections=(build test)
[[ ${1-} != --long ]] || sections+=(long)
stage "set-up" jobs/setup.sh "${sections[@]}"
stage "include rules" python3 tests/include_rules.py
stage "format" check_format
stage "build release" jobs/build.sh release
stage "build sanitize" jobs/build.sh sanitize
[[ ! -x build/sanitize/cracksim ]] || export CRACKSIM_SECOND_BINARY=$PWD/build/sanitize/cracksim
stage "tests release" run_ctest release
unset CRACKSIM_SECOND_BINARY
stage "tests sanitize" run_ctest sanitize
stage "clang-tidy" check_tidy

if [[ ${1-} == --long ]]; then
    mkdir -p tests/records
    for campaign in tests/long/*.sh; do
        # shellcheck disable=SC2016
        stage "$(basename "$campaign" .sh)" bash -c '"$1" 2>&1 | tee "$2"; exit "${PIPESTATUS[0]}"' _ \
            "$campaign" "tests/records/$(basename "$campaign" .sh).log"
    done
fi

echo "$passed passed, $failed failed"
[[ $failed -eq 0 ]]
