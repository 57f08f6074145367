#!/usr/bin/env bash
# Set everything up and run all checks and tests: lint, types, QGIS tests, the engine's tests.
# Usage: scripts/test.sh [arguments for the engine's pytest], such as --cov --cov-fail-under=90, which takes a quarter longer
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

failed=()

check() { # check "what" "how to mend it" command...
    step "$1" "$2"
    local what="$1" remedy="$2"
    shift 2
    if ! "$@"; then
        failed+=("$what (to mend it: $remedy)")
    fi
}

setup_qgis() {
    local release
    release="$(. /etc/os-release && echo "$VERSION_CODENAME")"
    step "QGIS from Debian backports" "run: apt-get install -t $release-backports qgis python3-qgis xvfb xauth"
    if ! installed qgis python3-qgis xvfb xauth python3-venv qttools5-dev-tools git; then
        if ! apt-cache policy qgis 2>/dev/null | grep -q backports; then
            # the mirror this machine uses already, whichever it is
            local mirror
            mirror="$(apt-get indextargets --format '$(SITE) $(CODENAME) $(COMPONENT)' | awk -v r="$release" '$2 == r && $3 == "main" {print $1; exit}')"
            echo "deb $mirror $release-backports main" | as_root tee /etc/apt/sources.list.d/tetratrack-backports.list >/dev/null
            apt_updated=false
        fi
        # git: the plugin's ZIP is made of what is committed, and a checkout may have come without it
        apt_install python3-venv xvfb xauth qttools5-dev-tools git
        apt_install -t "$release-backports" qgis python3-qgis
    fi
    step "Python environment of the QGIS tests in .venv-qgis" "delete .venv-qgis and run again"
    local stamp
    stamp="$(stamp_of requirements-qgis.txt)"
    if [ "$(cat .venv-qgis/tetratrack.stamp 2>/dev/null)" != "$stamp" ]; then
        [ -x .venv-qgis/bin/python ] || /usr/bin/python3 -m venv --system-site-packages .venv-qgis
        .venv-qgis/bin/python -m pip install --quiet --disable-pip-version-check -r requirements-qgis.txt
        echo "$stamp" >.venv-qgis/tetratrack.stamp
    else
        echo "   ready"
    fi
}

test_qgis() {
    setup_qgis
    step "translations" "run: apt-get install qttools5-dev-tools"
    .venv-qgis/bin/python scripts/dev/translations.py build
    step "QGIS tests" "run: xvfb-run -a .venv-qgis/bin/python -m pytest tests/qgis"
    xvfb-run -a .venv-qgis/bin/python -m pytest tests/qgis -q -p no:cacheprovider
}

setup_system
setup_engine

export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
# many tests start commands: where Python is told to keep nothing, each would make the engine's bytecode anew
unset PYTHONDONTWRITEBYTECODE
logs="$(mktemp -d)"
# beside all else: what it installs waits for the network, and its one process leaves a core idle
test_qgis >"$logs/qgis" 2>&1 &
qgis=$!
# nobody waits for it where this ends early
trap 'pkill -P "$qgis" || true; rm -rf "$logs"' EXIT
check "lint" "run: .venv/bin/ruff check --fix ." .venv/bin/ruff check --quiet .
check "format" "run: .venv/bin/ruff format ." .venv/bin/ruff format --quiet --check .
check "types" "run: .venv/bin/python scripts/dev/types.py" .venv/bin/python scripts/dev/types.py
step "engine tests" "run: .venv/bin/python -m pytest -n 2"
engine=0
.venv/bin/python -m pytest -n 2 "$@" | tee "$logs/engine" || engine=$?
summary="$(grep -E '^=+ .* in [0-9.]+s' "$logs/engine" | tail -n 1 || true)"
if [ "$engine" -ne 0 ]; then failed+=("engine tests (to mend it: $REMEDY)"); fi
check "QGIS tests" "look at what is written below; run: xvfb-run -a .venv-qgis/bin/python -m pytest tests/qgis" wait "$qgis"
cat "$logs/qgis"
printf '%s\n' "$summary"
if [ ${#failed[@]} -gt 0 ]; then
    # the last line names all that failed, whatever was looked at last
    all="$(printf '; %s' "${failed[@]}")"
    printf 'failed: %s\n' "${all:2}" >&2
    exit 1
fi
