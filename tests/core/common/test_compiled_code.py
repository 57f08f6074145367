"""The cache of compiled loops: damaged files are made anew, and no folder of somebody else's is used."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from pathlib import Path

import pytest
from tetratrack.core.common.compiled_code import is_private

LOOP = """
from tetratrack.core.common.kernels import kernel

@kernel()
def doubled(x):
    return 2 * x

print(doubled(21), sum(doubled.stats.cache_hits.values()))
"""


CALLS = "from called import MORE, by_two"
CALLED = LOOP.partition("@kernel()")[0] + "MORE = 0\n\n@kernel()\ndef by_two(x):\n    return 2 * x\n"


def _run(folder: Path, loop: str = LOOP, called: str = "", **environment: str) -> subprocess.CompletedProcess[str]:
    module = folder / "loop.py"
    module.write_text(loop, encoding="utf-8")
    (folder / "called.py").write_text(called, encoding="utf-8")
    # -B: Python takes its own bytecode for current if the source has the same length and was written in the same second
    return subprocess.run(
        [sys.executable, "-B", str(module)], env=os.environ | environment, capture_output=True, text=True, check=False, timeout=120
    )


def test_damaged_files_are_made_anew(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    cache.mkdir(mode=0o755)
    kept = {"NUMBA_CACHE_DIR": str(cache)}
    assert _run(tmp_path, **kept).stdout.split() == ["42", "0"]
    assert _run(tmp_path, **kept).stdout.split() == ["42", "1"]
    rng = random.Random(1)
    for pattern in ("*.nbi", "*.nbc"):
        for damage in ("empty", "cut", "flipped"):
            (file,) = [path for path in cache.rglob(pattern) if "doubled" in path.name]
            data = bytearray(file.read_bytes())
            if damage == "flipped":
                data[rng.randrange(len(data) // 2, len(data))] ^= 16
            file.write_bytes({"empty": b"", "cut": data[: len(data) // 2], "flipped": bytes(data)}[damage])
            found = _run(tmp_path, **kept)
            assert found.stdout.split() == ["42", "0"], (pattern, damage, found.stderr)
            assert _run(tmp_path, **kept).stdout.split() == ["42", "1"]


def test_a_loop_is_compiled_anew_where_one_it_calls_changes(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    cache.mkdir(mode=0o755)
    kept = {"NUMBA_CACHE_DIR": str(cache)}
    called, caller = CALLED, LOOP.replace("2 * x", "by_two(x) + MORE").replace("@kernel()", f"{CALLS}\n@kernel()")
    assert _run(tmp_path, caller, called=called, **kept).stdout.split() == ["42", "0"]
    assert _run(tmp_path, caller, called=called, **kept).stdout.split() == ["42", "1"]
    for changed, answer in ((called.replace("2 * x", "4 * x"), "84"), (called.replace("MORE = 0", "MORE = 1"), "43")):
        assert _run(tmp_path, caller, called=changed, **kept).stdout.split() == [answer, "0"]


@pytest.mark.skipif(os.name != "posix", reason="permissions as POSIX has them")
def test_a_folder_that_others_can_write_is_not_used(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    cache.mkdir()
    cache.chmod(0o777)
    assert not is_private(cache)
    assert _run(tmp_path, NUMBA_CACHE_DIR=str(cache)).stdout.split()[0] == "42"
    (own,) = cache.iterdir()
    assert own.stat().st_mode & 0o777 == 0o700
    assert list(own.rglob("*.nbc"))


@pytest.mark.skipif(os.name != "posix", reason="permissions as POSIX has them")
def test_what_is_compiled_beside_the_program_serves_other_users(tmp_path: Path) -> None:
    """A second user, with a folder of one's own, need not compile again; what others could have written there is not used."""
    own = tmp_path / "own"
    own.mkdir(mode=0o755)
    clean = {"NUMBA_CACHE_DIR": ""}
    assert _run(tmp_path, **clean).stdout.split() == ["42", "0"]
    assert _run(tmp_path, NUMBA_CACHE_DIR=str(own)).stdout.split() == ["42", "1"]
    assert not list(own.rglob("*.nbc"))
    (tmp_path / "__pycache__").chmod(0o777)
    assert _run(tmp_path, NUMBA_CACHE_DIR=str(own)).stdout.split() == ["42", "0"]
    assert list(own.rglob("*.nbc"))
