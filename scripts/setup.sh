# Set-up shared by demo.sh and test.sh: sourced, not run. Every step is skipped where its work is done already, so that the second
# time needs neither network nor patience; a step that fails is named together with how to mend it.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

STEP="start"
REMEDY=""

step() { # step "what is done" "how to mend it if it fails"
    STEP="$1"
    REMEDY="${2:-}"
    printf '== %s\n' "$STEP"
}

report_failure() {
    local code=$?
    trap - ERR
    printf '\nfailed: %s (exit %s)\n' "$STEP" "$code" >&2
    [ -z "$REMEDY" ] || printf 'to mend it: %s\n' "$REMEDY" >&2
    exit "$code"
}
trap report_failure ERR

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

installed() { # all the given packages
    local package
    for package in "$@"; do
        dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || return 1
    done
}

apt_updated=false
apt_install() { # apt_install [-t release] packages...
    local options=()
    if [ "$1" = -t ]; then options=(-t "$2"); shift 2; fi
    installed "$@" && return 0
    if ! command -v apt-get >/dev/null; then
        echo "this machine has no apt-get; install by hand: $*" >&2
        return 1
    fi
    if ! $apt_updated; then
        as_root apt-get update -qq
        apt_updated=true
    fi
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${options[@]}" "$@" >/dev/null
}

find_python() { # Debian's own first: an interpreter from elsewhere may lack the shared libraries of a virtual environment
    local candidate
    for candidate in /usr/bin/python3 /usr/bin/python3.11 python3.11 python3.12 python3.13 python3; do
        # the versions whose files stand in the lock
        if command -v "$candidate" >/dev/null &&
            "$candidate" -c 'import sys, venv, ensurepip; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))' 2>/dev/null; then
            command -v "$candidate"
            return 0
        fi
    done
    return 1
}

stamp_of() { cat "$@" | sha256sum | cut -d' ' -f1; }

setup_system() {
    step "system packages for the engine" "run: apt-get install python3-venv libegl1 libgl1 libgomp1 libharfbuzz-subset0 libidn2-0 libpangoft2-1.0-0 libusb-1.0-0 libx11-6"
    find_python >/dev/null || apt_install python3 python3-venv
    apt_install libegl1 libgl1 libgomp1 libharfbuzz-subset0 libidn2-0 libpangoft2-1.0-0 libusb-1.0-0 libx11-6
}

install_locked() { # every file is checked against its checksum where the lock knows the files of this machine
    local pip=(.venv/bin/python -m pip install --quiet --disable-pip-version-check)
    if [ "$(uname -sm)" = "Linux x86_64" ] && ! grep -v '^#' requirements-lock.txt | grep -vq -- '--hash='; then
        # the lock is complete; pip would not find the checksum of a library that another asks for with extras
        "${pip[@]}" --require-hashes --no-deps -r requirements-lock.txt
    else
        echo "   the lock holds no checksums for this machine: versions are pinned, files are not checked"
        "${pip[@]}" -r <(sed 's/ --hash=.*//' requirements-lock.txt)
    fi
}

setup_engine() {
    step "engine's Python environment in .venv" "delete .venv and run again; a package registry must be reachable the first time"
    local stamp
    stamp="$(stamp_of requirements-lock.txt pyproject.toml)"
    if [ -x .venv/bin/tetratrack ] && [ "$(cat .venv/tetratrack.stamp 2>/dev/null)" = "$stamp" ] && .venv/bin/python -c 'import tetratrack' 2>/dev/null; then
        echo "   ready"
        return 0
    fi
    [ -x .venv/bin/python ] || "$(find_python)" -m venv .venv
    echo "   installing pinned libraries; a few minutes the first time"
    install_locked
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e . 2>/dev/null
    echo "   compiling what runs need"
    .venv/bin/tetratrack warm-up --quiet
    echo "$stamp" >.venv/tetratrack.stamp
}
