"""The engine process as QGIS sees it, with engines that behave, misbehave, crash and hang."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tetratrack.algorithms.support.engine import (
    EngineCancelled,
    EngineError,
    Listener,
    engine_environment,
    find_engine,
    missing_engine_message,
    run_engine,
)


class Told:
    """Listener that keeps everything and cancels after a delay."""

    def __init__(self, cancel_after: float = 1e9) -> None:
        self.progress: list[tuple[float, str]] = []
        self.infos: list[str] = []
        self.warnings: list[str] = []
        self.until = time.monotonic() + cancel_after
        self.listener = Listener(
            lambda fraction, message: self.progress.append((fraction, message)),
            self.infos.append,
            self.warnings.append,
            lambda: time.monotonic() > self.until,
        )


def test_events_reach_the_listener(fake_engine: Callable[[str], Path]) -> None:
    fake_engine("""
        say(event="progress", fraction=0.31, message="finding units")
        say(event="log", level="info", message="four tiles")
        say(event="log", level="warning", message="no control")
        print("a library prints this")
        say(event="result", outputs={"units": 7, "arguments": arguments})
    """)
    told = Told()
    outputs = run_engine(["segment", "survey.toml"], told.listener)
    assert told.progress == [(0.31, "finding units")]
    assert told.infos == ["four tiles", "a library prints this"]
    assert told.warnings == ["no control"]
    assert outputs["units"] == 7
    assert outputs["arguments"][-3:] == ["segment", "survey.toml", "--json-progress"]
    assert outputs["arguments"][0] == "-I"


def test_bad_input_is_one_message_with_its_remedy(fake_engine: Callable[[str], Path]) -> None:
    fake_engine("""
        say(event="error", message="a.laz has no CRS.", remedy="Declare it.")
        sys.exit(2)
    """)
    with pytest.raises(EngineError, match=r"^a\.laz has no CRS\. Declare it\.$"):
        run_engine(["inspect"], Told().listener)


@pytest.mark.parametrize("death", ["os.kill(os.getpid(), signal.SIGSEGV)", "sys.exit(1)", "raise MemoryError('tile too large')"])
def test_a_crash_is_a_message(fake_engine: Callable[[str], Path], death: str) -> None:
    fake_engine(f"""
        print("the last words", file=sys.stderr, flush=True)
        {death}
    """)
    with pytest.raises(EngineError, match=r"(?s)ended unexpectedly.*the last words"):
        run_engine(["run"], Told().listener)


def test_an_engine_that_cannot_start_is_a_message(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "python"
    broken.write_text("no interpreter")
    monkeypatch.setenv("TETRATRACK_ENGINE_PYTHON", str(broken))
    with pytest.raises(EngineError, match="could not be started"):
        run_engine(["run"], Told().listener)


def test_cancel_ends_even_an_engine_that_does_not_listen(fake_engine: Callable[[str], Path], tmp_path: Path) -> None:
    fake_engine(f"""
        os.setsid()
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        child = os.fork()
        open({str(tmp_path / "pids")!r}, "a").write(f"{{os.getpid()}}\\n")
        time.sleep(60)
    """)
    started = time.monotonic()
    with pytest.raises(EngineCancelled):
        run_engine(["run"], Told(cancel_after=0.7).listener)
    assert time.monotonic() - started < 0.7 + 2.0
    time.sleep(0.1)
    pids = [int(line) for line in (tmp_path / "pids").read_text().split()]
    assert len(pids) == 2
    assert not any(_alive(pid) for pid in pids)


def _alive(pid: int) -> bool:
    """Whether a process runs (one that has ended but is not yet waited for does not)."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def test_missing_engine_says_what_to_do(no_engine: None) -> None:
    assert find_engine() is None
    with pytest.raises(EngineError, match="Settings > Options > Tetratrack"):
        run_engine(["run"], Told().listener)
    assert missing_engine_message().count(".") == 1


def test_environment_holds_nothing_of_qgis(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("PYTHONPATH", "PYTHONHOME", "PROJ_LIB", "PROJ_DATA", "GDAL_DATA", "GDAL_DRIVER_PATH"):
        monkeypatch.setenv(name, "/qgis")
    monkeypatch.setenv("TETRATRACK_KEPT", "1")
    names = engine_environment().keys()
    assert not [name for name in names if name.startswith(("PYTHON", "PROJ_", "GDAL_"))]
    assert "TETRATRACK_KEPT" in names
    assert "PATH" in names


def test_real_engine_answers_from_a_folder_of_any_name(repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from tetratrack.algorithms.support import engine

    other = tmp_path / "some other folder"
    other.mkdir()
    for name in ("__init__.py", "metadata.txt", "core", "scripts", "plugin", "algorithms"):
        os.symlink(repository / name, other / name)
    # a link in the path is resolved by the bootstrap: a copy keeps the other name
    (other / "scripts").unlink()
    (other / "scripts").mkdir()
    for script in (repository / "scripts").glob("*.py"):
        (other / "scripts" / script.name).write_bytes(script.read_bytes())
    monkeypatch.setattr(engine, "BOOTSTRAP", other / "scripts" / "engine.py")
    outputs = run_engine(["plan", "--density", "200", "--noise", "0.02", "--unit", "tetrapod 8 t"], Told().listener)
    assert outputs["detectable_worst"] > 0
