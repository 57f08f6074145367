"""The first run after set-up compiles nothing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tetratrack.scripts.warm_up import keep_bytecode

LISTENING = """
import sys
from numba.core import event

class Listener(event.Listener):
    compiled = []

    def on_start(self, found):
        self.compiled.append(found.data["dispatcher"].py_func.__qualname__)

    def on_end(self, found):
        pass

event.register("numba:compile", Listener())
from tetratrack.scripts.cli import app
app(sys.argv[1:], standalone_mode=False)
print(len(Listener.compiled), *Listener.compiled)
"""


@pytest.mark.slow
@pytest.mark.parametrize("poverty", [(), ("--density", "100"), ("--noise", "0.07")])
def test_a_run_after_the_warm_up_compiles_nothing(tmp_path: Path, repository: Path, poverty: tuple[str, ...]) -> None:
    survey = repository / "tests" / "data" / "sample" / "survey.toml"
    commands = [["warm-up"]]
    if poverty:
        survey = tmp_path / "survey" / "survey.toml"
        commands.append(["simulate", "-o", str(survey.parent), "--units", "12", "--epochs", "2", "--seed", "4", *poverty])
    commands.append(["run", str(survey), "-o", str(tmp_path / "result.gpkg"), "--workers", "1"])
    for arguments in commands:
        done = subprocess.run([sys.executable, "-c", LISTENING, *arguments, "--quiet"], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "0"


def test_bytecode_is_kept_where_python_writes_none_by_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    for folder in ("core", "scripts"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "module.py").write_text("X = 1\n", encoding="utf-8")
    # where no folder can be made a run goes on without
    (tmp_path / "scripts" / "__pycache__").write_text("", encoding="utf-8")
    keep_bytecode(tmp_path)
    assert [path.name for path in (tmp_path / "core" / "__pycache__").iterdir()] == [f"module.{sys.implementation.cache_tag}.pyc"]
