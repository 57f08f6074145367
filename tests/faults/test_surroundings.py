"""Surroundings that differ: a service account without home and nothing to write to, and children that write in another code page."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from tetratrack.core.common import kernels

COMMAND = [sys.executable, "-m", "tetratrack.scripts.cli"]
LOOP = """
from tetratrack.core.common.kernels import kernel

@kernel()
def doubled(x):
    return 2 * x

print(doubled(21))
"""


@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0 or not shutil.which("setpriv"), reason="becomes another user")
@pytest.mark.parametrize("temporary", [True, False], ids=["temporary files", "nothing at all to write to"])
def test_a_service_account_without_home(temporary: bool) -> None:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        (Path(folder) / "loop.py").write_text(LOOP)
        environment = {name: value for name, value in os.environ.items() if not name.startswith(("XDG", "NUMBA"))} | {
            "HOME": "/nonexistent"
        }
        if not temporary:
            environment["TMPDIR"] = "/proc"
        another = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        if subprocess.run([*another, "test", "-r", kernels.__file__], cwd="/", check=False).returncode != 0:
            pytest.skip("another user cannot read this checkout")
        command = [*another, sys.executable, "-P", f"{folder}/loop.py"]
        told = subprocess.run(command, cwd="/", env=environment, capture_output=True, text=True, check=False)
        assert (told.returncode, told.stdout.strip()) == (0, "42"), told.stderr


def test_a_batch_of_surveys_whose_names_a_code_page_lacks(tmp_path: Path) -> None:
    """What a child says in another code page does not end the batch: all surveys are named."""
    surveys = []
    for name in ("blåcksten", "구역"):
        surveys.append(tmp_path / f"{name}.toml")
        surveys[-1].write_text(
            f'[survey]\nname = "{name}"\ncrs = "EPSG:32650"\n[unit]\ntype = "tetrapod"\nheight = 2.3\n'
            f'[[epoch]]\nlabel = "a"\ntime = 2025-03-14T02:30:00Z\ntiles = "{name}.laz"\n',
            encoding="utf-8",
        )
    environment = os.environ | {"PYTHONUTF8": "0", "PYTHONIOENCODING": "cp1252"}
    told = subprocess.run([*COMMAND, "batch", *map(str, surveys)], env=environment, capture_output=True, check=False)
    words = (told.stdout + told.stderr).decode("cp1252", "replace")
    assert told.returncode == 2, words
    assert "Traceback" not in words
    assert "warning: blåcksten: error: " in words
    assert r"\uad6c\uc5ed.toml. Their messages are above; the others are done." in words
