"""Processes: workers end with their parent, no two runs write one output, and a script without a main guard is told so."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError, OutputError, TetratrackError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.common.output_locks import clear_lock
from tetratrack.core.pipeline.array_files import load_arrays, save_arrays
from tetratrack.core.pipeline.job_runner import check_scheduler
from tetratrack.core.pipeline.run_options import RunOptions, job_runner

JOBS = """
import signal, sys, time
from dataclasses import dataclass
from pathlib import Path
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.pipeline.run_options import RunOptions, job_runner

if hasattr(signal, "SIGHUP"):
    # who starts the tests in the background may have this ignored, which is inherited
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

@dataclass(frozen=True)
class Sleep:
    number: int

    @property
    def name(self):
        return f"sleep-{self.number}.npz"

    def run(self):
        import os
        (Path(sys.argv[1]) / f"pid-{os.getpid()}").touch()
        time.sleep(600)
        return {}

def start():
    with job_runner(Path(sys.argv[1]) / "r.gpkg", RunOptions(workers=2), Feedback()) as runner:
        runner.run([Sleep(k) for k in range(2)])
"""
GUARDED = JOBS + '\nif __name__ == "__main__":\n    start()\n'
UNGUARDED = JOBS + "\nstart()\n"


def _started(folder: Path, script: str) -> subprocess.Popen[str]:
    path = folder / "script.py"
    path.write_text(script, encoding="utf-8")
    return subprocess.Popen([sys.executable, str(path), str(folder)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def _alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes as Linux shows them")
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGHUP, signal.SIGTERM])
def test_workers_end_with_their_parent_alone(tmp_path: Path, number: signal.Signals) -> None:
    parent = _started(tmp_path, GUARDED)
    deadline = time.monotonic() + 120
    while len(workers := list(tmp_path.glob("pid-*"))) < 2:
        assert time.monotonic() < deadline
        assert parent.poll() is None, parent.stderr
        time.sleep(0.1)
    parent.send_signal(number)
    # pipes end when the last worker has ended
    parent.communicate(timeout=30)
    pids = [int(path.name.removeprefix("pid-")) for path in workers]
    deadline = time.monotonic() + 5
    while any(map(_alive, pids)) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not any(map(_alive, pids))


def test_a_script_without_main_guard_is_told(tmp_path: Path) -> None:
    _, told = _started(tmp_path, UNGUARDED).communicate(timeout=200)
    assert "must stand under a line of its own: if __name__" in told.splitlines()[-1]
    assert 'if __name__ == "__main__":' in told.splitlines()[-1]


def test_the_lock_lies_beside_the_output_and_outlives_nobody(tmp_path: Path) -> None:
    output = tmp_path / "r.gpkg"
    lock = tmp_path / "r.gpkg.lock"
    lock.write_text("left by a run that was killed")
    with job_runner(output, RunOptions(workers=1), Feedback()):
        assert lock.stat().st_mode & 0o666 == 0o666 or os.name != "posix"
        with pytest.raises(OutputError, match=f"is being written by another run .process {os.getpid()} on"), _second_run(output):
            pass
    assert not lock.exists() or os.name != "posix"
    with _second_run(output):
        pass


HOLDER = """
import sys, time
from pathlib import Path
from tetratrack.core.common.output_locks import sole_writer

with sole_writer(Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(100)
"""


@pytest.mark.skipif(os.name != "posix", reason="the lock stays where Windows has it")
def test_the_lock_of_a_killed_run_is_taken_away_and_a_held_one_stays(tmp_path: Path) -> None:
    output, lock = tmp_path / "r.gpkg", tmp_path / "r.gpkg.lock"
    with subprocess.Popen([sys.executable, "-c", HOLDER, str(output)], stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "held\n"
        clear_lock(output, 0.1)
        assert lock.exists()
        holder.kill()
    clear_lock(output, 10.0)
    assert list(tmp_path.iterdir()) == []
    clear_lock(output, 10.0)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name != "posix", reason="links as POSIX has them")
@pytest.mark.parametrize("kind", ["link", "hard link", "link to nothing", "pipe", "folder"])
def test_a_lock_that_somebody_made_a_link_overwrites_nothing(tmp_path: Path, kind: str) -> None:
    """Neither is what it leads to written, nor its mode changed."""
    output, lock, other = tmp_path / "r.gpkg", tmp_path / "r.gpkg.lock", tmp_path / "keys"
    other.write_text("another's file")
    other.chmod(0o600)
    if kind == "hard link":
        lock.hardlink_to(other)
    elif kind == "pipe":
        os.mkfifo(lock)
    elif kind == "folder":
        lock.mkdir()
    else:
        lock.symlink_to(other if kind == "link" else tmp_path / "nothing")
    with pytest.raises(OutputError, match=r"is no lock of a run|Is a directory"), _second_run(output):
        pass
    assert other.read_text() == "another's file"
    assert other.stat().st_mode & 0o777 == 0o600
    assert not (tmp_path / "nothing").exists()
    assert lock.exists() or lock.is_symlink()


def _second_run(output: Path):  # type: ignore[no-untyped-def]
    return job_runner(output, RunOptions(workers=1), Feedback())


@pytest.mark.parametrize(
    "address", ["inproc://", "http://localhost:8786", "localhost:8786", "word", "tcp://", "tcp://host:port", "tls://:1"]
)
def test_what_is_no_address_of_a_scheduler(address: str) -> None:
    with pytest.raises(InputError, match="is no address of a dask scheduler"):
        check_scheduler(address)


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "tls://127.0.0.1:1", "tcp://does-not-exist.invalid:8786"])
def test_a_scheduler_that_does_not_answer(address: str) -> None:
    with pytest.raises(TetratrackError, match="no dask scheduler answers"):
        check_scheduler(address)


def test_damaged_blocks_count_as_not_done(tmp_path: Path) -> None:
    """Every byte of an archive's headers flipped in turn: read as it was or not at all, whatever the damage makes of it."""
    path = tmp_path / "block.npz"
    save_arrays(path, {"table": np.arange(6.0).reshape(2, 3), "kind": np.array([1, 2])})
    good = path.read_bytes()
    unread = 0
    for place in range(len(good)):
        for bit in (1, 8, 64):
            data = bytearray(good)
            data[place] ^= bit
            path.write_bytes(data)
            unread += load_arrays(path) is None
    assert unread > len(good)
