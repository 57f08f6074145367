"""Every step that writes, on a disk that is full: exit code 2, one sentence, earlier files whole, nothing left."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

ROOM = 400_000
"""Bytes of the disk; less than a tenth of them is free."""


@pytest.fixture
def disk(tmp_path: Path) -> Iterator[Path]:
    """A small disk that is nearly full; without an administrator's rights one that only says so."""
    folder = tmp_path / "disk"
    folder.mkdir()
    if (
        os.geteuid() != 0
        or subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={ROOM}", "tmpfs", str(folder)], capture_output=True).returncode
    ):
        pytest.skip("mounting a small disk needs root")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


@pytest.mark.skipif(os.name != "posix", reason="mounts a disk")
@pytest.mark.parametrize(
    "step",
    [
        ("export", "RESULT", "-o", "DISK/out"),
        ("label-tiles", "SURVEY", "RESULT", "--folder", "DISK/labelled"),
        ("relief", "SURVEY", "-o", "DISK/relief"),
        ("report", "RESULT", "-o", "DISK/r.html"),
        ("alarms", "RESULT", "-o", "DISK/a.csv"),
        ("model", "RESULT", "-o", "DISK/m.json"),
        ("features", "RESULT", "-o", "DISK/f.gpkg"),
        ("inspect", "SURVEY", "-o", "DISK/tiles.gpkg"),
        ("register", "SURVEY", "-o", "DISK/r.gpkg"),
    ],
    ids=lambda step: step[0],
)
def test_a_full_disk(disk: Path, result: Path, tiny: Path, step: tuple[str, ...]) -> None:
    (disk / "fill").write_bytes(bytes(ROOM - 40_000))
    known = {"RESULT": str(result), "SURVEY": str(tiny / "survey.toml")}
    command = [known.get(word, word.replace("DISK", str(disk))) for word in step]
    told = CliRunner().invoke(app, [*command, "--quiet"])
    assert told.exit_code == 2, told.output
    assert "No space left on device" in told.stderr or "cannot be written" in told.stderr
    assert told.stderr.count("error: ") == 1
    assert "Traceback" not in told.output
    assert [path.name for path in disk.rglob("*") if path.is_file()] == ["fill"]


@pytest.mark.skipif(os.name != "posix", reason="mounts a disk")
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is always full, as Linux has it")
@pytest.mark.parametrize("where", ["> /dev/full", "2> /dev/full", ">&-", "2>&-", "| true"])
def test_messages_and_documents_on_a_full_disk_or_to_nobody(tmp_path: Path, where: str) -> None:
    """What cannot be said is no fault of the program; a document that cannot be written is told."""
    write_las(tmp_path / "a.laz", grid_points())
    for step in ("template", f"inspect {tmp_path}/a.laz", f"init {tmp_path}/a.laz --no-size"):
        command = f"{sys.executable} -m tetratrack.scripts.cli {step} {where}"
        told = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
        assert told.returncode == (2 if where == "> /dev/full" else 0), (step, told.stderr)
        assert "Traceback" not in told.stderr
        assert "Exception ignored" not in told.stderr
        assert ("standard output: cannot be written (No space left on device)" in told.stderr) == (where == "> /dev/full")


def test_a_log_on_a_full_disk_ends_nothing(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points())
    (tmp_path / "full.log").symlink_to("/dev/full")
    told = CliRunner().invoke(app, ["inspect", str(tmp_path / "a.laz"), "--log-file", str(tmp_path / "full.log")])
    assert told.exit_code == 0, told.output


def test_good_reliefs_are_not_replaced_by_truncated_ones(disk: Path, tiny: Path, tmp_path: Path) -> None:
    assert CliRunner().invoke(app, ["relief", str(tiny / "survey.toml"), "-o", str(tmp_path / "good"), "--quiet"]).exit_code == 0
    good = {path.name.replace("good", "relief"): path.read_bytes() for path in tmp_path.glob("good_*.tif")}
    assert len(good) == 2
    for name, content in good.items():
        (disk / name).write_bytes(content)
    (disk / "fill").write_bytes(bytes(ROOM - 90_000))
    assert CliRunner().invoke(app, ["relief", str(tiny / "survey.toml"), "-o", str(disk / "relief"), "--quiet"]).exit_code == 2
    assert {path.name: path.read_bytes() for path in disk.glob("*.tif")} == good
    assert shutil.disk_usage(disk).free > 0
