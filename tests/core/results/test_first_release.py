"""A result of the first usable version opens, is reviewed, corrected, reported and exported by this one.

``tests/data/first_release/result.gpkg.gz`` is what that version (commit eb3d2ff) made of the tiny survey; layers and fields that came later
are not in it.
"""

from __future__ import annotations

import gzip
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.report.model_export import write_model
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.results.export import export_layers
from tetratrack.core.results.geopackage_reader import epoch_pairs
from tetratrack.core.results.schema import LAYERS
from tetratrack.core.results.unit_rows import read_details, read_unit_rows
from tetratrack.core.review.corrections import delete_unit, read_edits, undo_edit
from tetratrack.core.review.decisions import confirm, decide, read_reviews, undo


@pytest.fixture
def old(tmp_path: Path, repository: Path) -> Path:
    """The old result in a folder that can be written."""
    path = tmp_path / "result.gpkg"
    path.write_bytes(gzip.decompress((repository / "tests" / "data" / "first_release" / "result.gpkg.gz").read_bytes()))
    return path


def test_it_lacks_what_came_later(old: Path) -> None:
    """Otherwise the tests below would show nothing."""
    with closing(sqlite3.connect(old)) as connection:
        there = {row[0] for row in connection.execute("SELECT table_name FROM gpkg_contents")}
        fields = {row[1] for row in connection.execute("PRAGMA table_info(units)")}
    assert {"unit_surfaces", "unit_outlines", "frame_errors", "stretches"} & set(LAYERS) - there
    assert {field.name for field in LAYERS["units"].fields} - fields


def test_it_opens_with_its_numbers(old: Path) -> None:
    (pair,) = epoch_pairs(old)
    rows = {row.unit_id: row for row in read_unit_rows(old, pair, "stable")}
    assert {name: row.kind for name, row in rows.items()} == {"U0001": "stable", "U0002": "moved", "U0003": "stable", "U0004": "stable"}
    assert rows["U0002"].d_3d == pytest.approx(0.213978, abs=1e-6)
    assert set(read_details(old, "U0002").features) == {"2024-04-09", "2024-10-09"}


def test_it_is_reviewed_and_corrected(old: Path) -> None:
    (pair,) = epoch_pairs(old)
    decide(old, ["U0002"], pair, "accepted", comment="seen on site", reviewer="A")
    act = confirm(old, "U0002", pair, reviewer="B")
    assert read_reviews(old)["U0002", pair].confirmed_by == "B"
    undo(old, [act], reviewer="B")
    assert read_reviews(old)["U0002", pair].confirmed_by == ""
    delete_unit(old, "U0003", editor="A")
    assert "U0003" not in {row.unit_id for row in read_unit_rows(old, pair, "stable")}
    undo_edit(old, read_edits(old)[-1].number, editor="A")
    assert "U0003" in {row.unit_id for row in read_unit_rows(old, pair, "stable")}


def test_it_is_reported_and_exported(old: Path, tmp_path: Path) -> None:
    data = write_report(old, tmp_path / "report.html", ReportOptions())
    assert len(data.kept) == 4
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "U0002" in page
    assert "2024-10-09" in page
    write_alarms(old, tmp_path / "alarms.csv", 0.1)
    assert "U0002" in (tmp_path / "alarms.csv").read_text(encoding="utf-8-sig")
    write_model(old, tmp_path / "model.glb")
    assert (tmp_path / "model.glb").stat().st_size > 1000
    assert len(export_layers(old, tmp_path / "layers")) > 5
