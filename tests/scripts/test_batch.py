"""Many surveys and watched folders: one bad survey does not end the others; new epochs are run, unchanged ones are not."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError, TetratrackError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey import LayerFile
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline import layer_tracking, single_steps
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.scripts import batch
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

HEAD = '[survey]\nname = "s"\ncrs = "EPSG:32650"\n[unit]\ntype = "tetrapod"\nheight = 2.3\n'
EPOCH = '[[epoch]]\nlabel = "{label}"\ntime = {label}-03-14T02:30:00Z\ntiles = "{label}/*.laz"\n'


def _site(folder: Path, *labels: str) -> Path:
    for label in labels:
        (folder / label).mkdir(parents=True, exist_ok=True)
        write_las(folder / label / "a.laz", grid_points())
    survey = folder / "survey.toml"
    survey.write_text(HEAD + "".join(EPOCH.format(label=label) for label in labels), encoding="utf-8")
    return survey


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "SETTLED_SECONDS", 0.0)


def test_batch_runs_all_and_names_the_bad_one(tmp_path: Path) -> None:
    good, bad, other = (_site(tmp_path / name, "2024") for name in ("good", "bad", "other"))
    (tmp_path / "bad" / "2024" / "a.laz").write_bytes(b"no cloud")
    result = CliRunner().invoke(app, ["batch", str(good), str(bad), str(other), "--workers", "1"])
    assert result.exit_code == 2
    assert "1 of 3 surveys failed" in result.stderr
    assert str(bad) in result.stderr
    assert "is not a LAS or LAZ file" in result.stderr
    for survey in (good, other):
        assert len(read_layer_rows(batch.result_of(survey), "epochs")) == 1
    assert not batch.result_of(bad).exists()


def test_a_batch_that_is_ended_does_not_say_that_nothing_was_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    surveys = [_site(tmp_path / name, "2024") for name in ("one", "two")]
    outcomes = [batch.Outcome(0), batch.Outcome(130)]
    monkeypatch.setattr(batch, "_run", lambda *_: outcomes.pop(0))
    told = CliRunner().invoke(app, ["batch", *map(str, surveys)])
    assert told.exit_code == 130
    assert "error: cancelled; files finished before are whole and stay" in told.stderr


def test_watch_runs_what_is_new_and_only_that(tmp_path: Path, quick: None) -> None:
    survey = _site(tmp_path, "2024")
    options = ["--workers", "1"]
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 1}
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 0}
    batch.result_of(survey).unlink()
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 1}, "a result that is gone is made again"
    assert batch.result_of(survey).is_file()
    _site(tmp_path, "2024", "2025")
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 1}
    assert [row["label"] for row in read_layer_rows(tmp_path / "survey.gpkg", "epochs")] == ["2024", "2025"]


def test_a_run_that_the_system_ends_is_told(tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Out of memory: the engine is killed and says nothing itself."""
    survey = _site(tmp_path, "2024")
    engine = tmp_path / "engine.py"
    monkeypatch.setattr(batch, "ENGINE", engine)
    for script, said in (
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", r"ended by signal 9 \(SIGKILL\).*fewer --workers"),
        ("import os; os.abort()", r"ended by signal 6 \(SIGABRT\)"),
        ("raise SystemExit(7)", "ended with exit code 7"),
    ):
        engine.write_text(script, encoding="utf-8")
        told: list[str] = []
        with pytest.raises(InputError, match="1 of 1 surveys failed"):
            batch.run_batch([survey], [], Feedback(warning=told.append))
        assert re.search(f"^survey: error: the run (was )?{said}", told[-1])
        with pytest.raises(TetratrackError, match=said):
            batch.watch(survey, [], 1, True, Feedback())


def test_batch_takes_patterns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Shells of Windows leave patterns to the program."""
    surveys = [_site(tmp_path / name, "2024") for name in ("one", "two")]
    ran: list[Path] = []
    monkeypatch.setattr(batch, "_run", lambda survey, *_: ran.append(survey) or batch.Outcome(0))
    assert CliRunner().invoke(app, ["batch", str(tmp_path / "*" / "survey.toml")]).exit_code == 0
    assert ran == surveys


def test_views_and_registrations_take_patterns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    paths = [write_las(tmp_path / f"view{k}.laz", grid_points()) for k in range(2)]
    given: list[Sequence[Path]] = []
    monkeypatch.setattr(single_steps, "run_register_views", lambda views, *_: given.append(views) or {})
    monkeypatch.setattr(layer_tracking, "run_track", lambda units, registrations, *_: given.append(registrations) or {})
    pattern = str(tmp_path / "view*.laz")
    assert CliRunner().invoke(app, ["register-views", pattern, "-o", str(tmp_path / "all.laz")]).exit_code == 0
    units = ["track", str(paths[0]), "-o", str(tmp_path / "r.gpkg")]
    assert CliRunner().invoke(app, [*units, "--registration", pattern]).exit_code == 0
    assert given == [paths, paths]


def test_watch_sees_every_file_of_a_survey_and_reads_what_changed_alone(
    tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    survey = _site(tmp_path, "2024")
    areas, mould = tmp_path / "areas.geojson", tmp_path / "mould.json"
    for path in (areas, mould):
        path.write_text("{}")
    described = replace(read_survey(survey), stable_areas=LayerFile(areas, ""), moulds=(mould,))
    monkeypatch.setattr(batch, "read_survey", lambda _: described)
    read: list[Path] = []
    monkeypatch.setattr(batch, "checksum", lambda path: read.append(path) or hashlib.sha256(path.read_bytes()).hexdigest())
    known: dict[Path, tuple[tuple[int, int], str]] = {}
    first = batch.settled_state(survey, known)
    assert read == [survey, areas, mould, tmp_path / "2024" / "a.laz"]
    assert batch.settled_state(survey, known) == first
    assert len(read) == 4
    for path in (areas, mould):
        path.write_text('{"new": 1}')
        assert batch.settled_state(survey, known) != first
        assert read.pop() == path
        first = batch.settled_state(survey, known)


class _Enough(Exception):
    """Ends a watch in a test."""


def _watch(monkeypatch: pytest.MonkeyPatch, survey: Path, outcomes: list[batch.Outcome], looks: int) -> tuple[list[str], list[float]]:
    """Watch with prescribed outcomes of the runs for a number of looks: what was said, and the pauses."""
    said: list[str] = []
    pauses: list[float] = []

    def sleep(seconds: float) -> None:
        if seconds:
            pauses.append(seconds)
        if len(pauses) >= looks:
            raise _Enough

    def run(*_: object) -> batch.Outcome:
        outcome = outcomes.pop(0)
        if outcome.code == 0:
            batch.result_of(survey).touch()
        return outcome

    monkeypatch.setattr(batch, "_run", run)
    monkeypatch.setattr(batch.time, "sleep", sleep)
    with pytest.raises(_Enough):
        batch.watch(survey, [], 60, False, Feedback(info=said.append, warning=said.append))
    return said, pauses


def test_watch_says_once_what_it_waits_for(tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch) -> None:
    survey = _site(tmp_path, "2024")
    (tmp_path / "2024" / "a.laz").unlink()
    said, pauses = _watch(monkeypatch, survey, [], 3)
    assert len(said) == 1
    assert "no file matches 2024/*.laz" in said[0]
    assert pauses == [60, 60, 60]


def test_watch_tries_again_what_failed_for_a_passing_reason(tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch) -> None:
    survey = _site(tmp_path, "2024")
    locked = batch.Outcome(2, "is locked", passing=True)
    _, pauses = _watch(monkeypatch, survey, [locked, locked, batch.Outcome(0)], 4)
    assert pauses == [120, 240, 60, 60]


def test_watch_remembers_input_that_is_refused(tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch) -> None:
    survey = _site(tmp_path, "2024")
    _, pauses = _watch(monkeypatch, survey, [batch.Outcome(2, "has no CRS")], 4)
    assert pauses == [60, 60, 60, 60]


def test_watch_once_ends_as_the_run_did(tmp_path: Path) -> None:
    survey = _site(tmp_path, "2024")
    (tmp_path / "2024" / "a.laz").write_bytes(b"no cloud")
    refused = CliRunner().invoke(app, ["watch", str(survey), "--once", "--workers", "1", "--quiet"])
    assert refused.exit_code == 2
    assert "is not a LAS or LAZ file" in refused.stderr
    (tmp_path / "2024" / "a.laz").unlink()
    missing = CliRunner().invoke(app, ["watch", str(survey), "--once", "--workers", "1", "--quiet"])
    assert missing.exit_code == 2
    assert "no file matches 2024/*.laz" in missing.stderr


def test_nothing_of_the_working_directory_is_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Modules of a stranger's folder, of libraries and of Python's own, stay unread by the engine and by worker processes."""
    survey = _site(tmp_path / "site", "2024", "2025")
    for name in ("typer", "numpy", "pickle", "selectors", "threading", "tetratrack"):
        (tmp_path / f"{name}.py").write_text(f"open({str(tmp_path / 'RUN')!r}, 'w')\nraise SystemExit(0)\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert batch.run_batch([survey], ["--workers", "2"], Feedback()) == {"surveys": 1}
    assert not (tmp_path / "RUN").exists()
    assert len(read_layer_rows(batch.result_of(survey), "epochs")) == 2
