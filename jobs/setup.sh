#!/usr/bin/env bash
# Installs the missing packages of the named sections of packages.txt. Usage: jobs/setup.sh build [test] [long]
set -euo pipefail
list=$(dirname "${BASH_SOURCE[0]}")/packages.txt
[[ $# -gt 0 ]] || { echo "usage: jobs/setup.sh SECTION... (the sections of $list)" >&2; exit 2; }

packages=$(awk -v wanted=" $* " '!/^#/ && index(wanted, " " $1 " ") { print $2 }' "$list" | sort -u)
if ! command -v apt-get >/dev/null; then
    # shellcheck disable=SC2086
    echo "setup: this is not a Debian or Ubuntu system; have the equivalents of these packages installed:" $packages >&2
    exit 0
fi

# shellcheck disable=SC2086
present=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $packages 2>/dev/null |
    awk '$1 == "installed" { print $2 }' | sort -u || true)
mapfile -t missing < <(comm -23 <(echo "$packages") <(echo "$present") | sed '/^$/d')
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
    if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; }; then
        as_root=(sudo)
    else
        echo "setup: ${#missing[@]} packages are missing, and neither root nor sudo is at hand." \
            "Have this run as root, then repeat:" >&2
        echo "  apt-get update && apt-get install -y --no-install-recommends ${missing[*]}" >&2
        exit 2
    fi
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" \
        </dev/null >>"$log" 2>&1
}
install() { apt install --no-install-recommends "${missing[@]}"; }

echo "setup: installing ${#missing[@]} packages (first time: some minutes)"
# On a fresh machine the package lists are absent or too old; they are updated only if the installation fails.
if ! install && ! { apt update && install; }; then
    cat "$log" >&2
    echo "setup: could not install: ${missing[*]}" >&2
    exit 2
fi
