"""Bad days: a run that is killed anywhere, disks that fill up, workers that vanish. The same command then gives the same result."""

from __future__ import annotations

import os
import random
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from result_contents import contents

KILLS = 50


def _command(survey: Path, output: Path, *more: str) -> list[str]:
    return [sys.executable, "-m", "tetratrack.scripts.cli", "run", str(survey), "--output", str(output), "--quiet", *more]


@pytest.fixture(scope="module")
def survey(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the tiny survey: its files are damaged by some tests."""
    return Path(shutil.copytree(repository / "tests" / "data" / "tiny", tmp_path_factory.mktemp("survey") / "tiny")) / "survey.toml"


@pytest.fixture(scope="module")
def expected(survey: Path, tmp_path_factory: pytest.TempPathFactory) -> dict:
    path = tmp_path_factory.mktemp("expected") / "result.gpkg"
    subprocess.run(_command(survey, path, "--workers", "1"), check=True)
    return contents(path)


@pytest.mark.slow
def test_fifty_kills_and_every_resumed_result_is_the_same(survey: Path, expected: dict, tmp_path: Path) -> None:
    """Runs are killed with all their workers after a random time; every finished result is compared and the next run begins anew."""
    rng = random.Random(5)
    output = tmp_path / "result.gpkg"
    kills = finished = 0
    length = 8.0
    while kills < KILLS or finished == 0:
        process = subprocess.Popen(
            _command(survey, output, "--resume", "--workers", "2"), start_new_session=True, stdout=subprocess.DEVNULL
        )
        try:
            process.wait(timeout=rng.uniform(0.2, length) if kills < KILLS else None)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            kills += 1
            # killed while it was leaving, with the result in place: then it is whole
            if not output.exists():
                continue
        else:
            assert process.returncode == 0
        assert contents(output) == expected
        finished += 1
        output.unlink()
        shutil.rmtree(tmp_path / "result.gpkg.jobs")
    assert kills >= KILLS


def test_full_disk(survey: Path, expected: dict, tmp_path: Path) -> None:
    """On a disk of 300 kB the run ends with one sentence; with room the same command finishes."""
    disk = tmp_path / "disk"
    disk.mkdir()
    if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(disk)], capture_output=True).returncode:
        pytest.skip("mounting a small disk needs root")
    try:
        command = _command(survey, disk / "result.gpkg", "--resume", "--workers", "1")
        full = subprocess.run(command, capture_output=True, text=True)
        assert full.returncode == 2
        assert "No space left on device" in full.stderr
        assert full.stderr.count("error: ") == 1
        assert "Traceback" not in full.stderr
        assert not (disk / "result.gpkg").exists()
        assert not list(disk.rglob("*.part"))
        subprocess.run(["mount", "-o", "remount,size=60m", str(disk)], check=True)
        subprocess.run(command, check=True)
        assert contents(disk / "result.gpkg") == expected
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_clock_that_jumps_back(survey: Path, expected: dict, tmp_path: Path) -> None:
    """Finished blocks are known by what is in them, never by their time."""
    command = _command(survey, tmp_path / "result.gpkg", "--resume", "--workers", "1")
    subprocess.run(command, check=True)
    for path in [*(tmp_path / "result.gpkg.jobs").iterdir(), *survey.parent.rglob("*.laz")]:
        os.utime(path, (0, 0) if path.suffix == ".npz" else (4e9, 4e9))
    (tmp_path / "result.gpkg").unlink()
    subprocess.run(command, check=True)
    assert contents(tmp_path / "result.gpkg") == expected


def test_a_changed_tile_is_computed_again(survey: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(survey.parent, tmp_path / "site"))
    output = tmp_path / "result.gpkg"
    command = _command(folder / "survey.toml", output, "--resume", "--workers", "1")
    subprocess.run(command, check=True)
    before = contents(output)
    tiles = sorted((folder / "tiles").glob("*/*.laz"))
    tiles[0].unlink()
    subprocess.run(command, check=True)
    assert contents(output)["epochs"][0]["points"] < before["epochs"][0]["points"]


@pytest.mark.skipif(os.name != "posix", reason="permissions as POSIX has them")
def test_one_tile_unreadable_by_permission(survey: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(survey.parent, tmp_path / "site"))
    tile = sorted((folder / "tiles").glob("*/*.laz"))[1]
    tile.chmod(0)
    command = _command(folder / "survey.toml", tmp_path / "result.gpkg", "--workers", "1")
    if os.geteuid() == 0:
        for path in (tmp_path, folder, *folder.rglob("*")):
            if path != tile:
                path.chmod(0o777)
        for parent in tmp_path.parents[:3]:
            parent.chmod(parent.stat().st_mode | 0o011)
        if not shutil.which("setpriv"):
            pytest.skip("root reads everything, and there is no setpriv")
        command = ["setpriv", "--bounding-set", "-all", "--inh-caps", "-all", *command]
    refused = subprocess.run(command, capture_output=True, text=True)
    assert refused.returncode == 2, refused.stderr
    assert f"{tile.name}: cannot be read (Permission denied)" in refused.stderr
    assert "Traceback" not in refused.stderr
    assert not (tmp_path / "result.gpkg").exists()


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextmanager
def _started(*command: str) -> Iterator[subprocess.Popen]:
    process = subprocess.Popen(
        [sys.executable, "-m", *command], start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        yield process
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


@pytest.mark.slow
def test_a_worker_of_a_cluster_is_killed(survey: Path, expected: dict, tmp_path: Path) -> None:
    """A real scheduler and two workers on loopback; one worker is killed while it works."""
    pytest.importorskip("distributed")
    from distributed import Client

    address = f"tcp://127.0.0.1:{_free_port()}"
    worker = ("distributed.cli.dask_worker", address, "--nthreads", "1", "--no-dashboard", "--local-directory", str(tmp_path))
    scheduler = ("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", address.rsplit(":", 1)[1], "--no-dashboard")
    with _started(*scheduler), _started(*worker) as victim, _started(*worker):
        with Client(address, timeout="60s", set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
        run = subprocess.Popen(_command(survey, tmp_path / "result.gpkg", "--scheduler", address, "--resume"))
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and not (tmp_path / "result.gpkg.jobs").exists():
            time.sleep(0.05)
        time.sleep(1)
        os.killpg(victim.pid, signal.SIGKILL)
        assert run.wait(timeout=300) == 0
    assert contents(tmp_path / "result.gpkg") == expected
