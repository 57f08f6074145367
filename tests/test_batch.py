"""Many surveys and watched folders: one bad survey does not end the others; new epochs are run, unchanged ones are not."""

from __future__ import annotations

from pathlib import Path

import pytest
from las_files import grid_points, write_las
from tetratrack.core.feedback import Feedback
from tetratrack.core.result_tables import read_layer_rows
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


def test_watch_runs_what_is_new_and_only_that(tmp_path: Path, quick: None) -> None:
    survey = _site(tmp_path, "2024")
    options = ["--workers", "1"]
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 1}
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 0}
    _site(tmp_path, "2024", "2025")
    assert batch.watch(survey, options, 1, True, Feedback()) == {"runs": 1}
    assert [row["label"] for row in read_layer_rows(tmp_path / "survey.gpkg", "epochs")] == ["2024", "2025"]


def test_watch_waits_for_what_is_missing(tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch) -> None:
    survey = _site(tmp_path, "2024")
    tile = tmp_path / "2024" / "a.laz"
    content = tile.read_bytes()
    tile.unlink()
    waits: list[str] = []

    def come_back(seconds: float) -> None:
        if seconds:
            tile.write_bytes(content)

    monkeypatch.setattr(batch.time, "sleep", come_back)
    assert batch.watch(survey, ["--workers", "1"], 60, True, Feedback(progress=lambda f, m: waits.append(m))) == {"runs": 1}
    assert "no file matches 2024/*.laz" in waits[0]
