"""The report shows the mould and the broken legs; the alarm list and the sections count them."""

from __future__ import annotations

import csv
import json
import sqlite3
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from synthetic_result import write_result
from tetratrack.core.adjustment.shape_effects import prior_surface
from tetratrack.core.adjustment.surface_estimation import mould_cells
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.report.castings_page import castings_page
from tetratrack.core.report.damage import damage
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.results.geopackage_reader import EpochPair, read_layer_rows
from tetratrack.core.results.unit_rows import read_epochs, read_unit_rows, unit_sizes
from tetratrack.core.results.unit_sizes import shape_of


def break_legs(path: Path, unit: str, **told: object) -> None:
    """State of a unit's legs in the latest epoch."""
    with closing(sqlite3.connect(path)) as connection, connection:
        (label,) = connection.execute("select label from epochs order by time desc limit 1").fetchone()
        for name, value in told.items():
            connection.execute(f"update units set {name} = ? where unit_id = ? and epoch = ?", (value, unit, label))  # noqa: S608 - names of the test


@pytest.fixture
def result(tmp_path: Path) -> Path:
    """A synthetic result with a mould of nine units, and one unit of which leg 2 broke before the later epoch, unseen in it."""
    path = tmp_path / "result.gpkg"
    write_result(path, 12)
    surface = prior_surface(2.5)
    mean = np.linspace(0.01, -0.02, mould_cells().max() + 1)[mould_cells()]
    record = (
        type(surface)(mean, surface.variances, surface.own, surface.uneven, 0.0, 0.005, 9).as_mould("n", UnitType.tetrapod(2.5)).as_record()
    )
    with closing(sqlite3.connect(path)) as connection, connection:
        for label, text in connection.execute("select label, settings from epochs").fetchall():
            settings = json.loads(text) | {
                "castings": {"tetrapod": record},
                "unit_types": [{"name": "tetrapod", "height": 2.5, "leg_length": 1.61, "opening": "tetrahedral"}],
            }
            connection.execute("update epochs set settings = ? where label = ?", (json.dumps(settings), label))
        labels = [row[0] for row in connection.execute("select label from epochs order by time")]
        connection.execute("update units set leg1 = 'whole', leg2 = 'unseen', leg3 = 'whole', leg4 = 'unseen'")
        unit = connection.execute("select unit_id from displacements where class = 'stable' order by unit_id").fetchone()[0]
        connection.execute(
            "update units set leg2 = 'broken', leg_missing = 0.42, leg_probability = 0.9 where unit_id = ? and epoch = ?",
            (unit, labels[-2]),
        )
    return path


def test_broken_legs_are_shown_listed_and_counted(result: Path, tmp_path: Path) -> None:
    data = write_report(result, tmp_path / "r.html", ReportOptions(sections=("damage", "castings")))
    (broken,) = data.castings.broken
    assert broken.broken_legs == (2,)
    assert broken.leg_missing == pytest.approx(0.42)
    page = (tmp_path / "r.html").read_text()
    assert '<td class="n">2</td><td class="n">0.42</td><td class="n">90.0 %</td>' in page
    assert "9 units of this survey" in page
    assert data.figures["mould_0"].startswith("data:image/png")
    assert data.damage is not None
    assert sum(section.broken for section in data.damage.sections) == data.damage.n_broken == 1
    write_alarms(result, tmp_path / "a.csv", 10.0)
    with (tmp_path / "a.csv").open(encoding="utf-8-sig") as stream:
        rows = list(csv.DictReader(stream))
    assert {row["unit_id"]: (row["broken_legs"], row["leg_missing"]) for row in rows}[broken.unit_id] == ("2", "0.42")


def test_two_broken_legs_of_a_unit_are_told_apart(result: Path, tmp_path: Path) -> None:
    """Leg 2 was broken before and is hidden now, leg 3 broke, the end of leg 4 is not seen; leg 1 was whole and is hidden now."""
    unit = next(row["unit_id"] for row in read_layer_rows(result, "units") if row["leg2"] == "broken")
    break_legs(result, unit, leg1="unseen", leg3="broken", leg3_missing=0.81, leg3_probability=0.75, leg_missing=0.81, leg_probability=0.75)
    epochs = read_epochs(result)
    pair = EpochPair(epochs[-2].label, epochs[-1].label)
    rows = read_unit_rows(result, pair, "stable")
    sizes = unit_sizes(epochs)
    shapes = {
        row["unit_id"]: shape_of(row, sizes) for row in read_layer_rows(result, "units") if row["epoch"] == pair.epoch_to and row["qx"]
    }
    harm = damage(rows)
    page = castings_page(epochs, rows, frozenset(), shapes, harm)
    assert [(b.leg.number, b.leg.missing, b.leg.probability, b.unseen) for b in page.broken_legs] == [
        (2, 0.42, 0.9, (1, 4)),
        (3, 0.81, 0.75, (1, 4)),
    ]
    assert all(b.end is not None and b.way is not None for b in page.broken_legs)
    assert harm.n_broken == sum(s.broken_units for s in page.sections) == 1
    assert {name: sum(getattr(s, name) for s in page.sections) for name in ("whole", "broken", "unseen")} == page.legs
    assert castings_page(epochs, rows, frozenset({unit}), shapes, harm).broken_legs == ()
    doubtful = [replace(row, kind="uncertain") if row.unit_id == unit else row for row in rows]
    assert castings_page(epochs, doubtful, frozenset(), shapes, damage(doubtful)).broken_legs == (), "as in the alarm list"
    write_alarms(result, tmp_path / "a.geojson", 10.0)
    found = {f["properties"]["unit_id"]: f["properties"] for f in json.loads((tmp_path / "a.geojson").read_text())["features"]}[unit]
    assert (found["broken_legs"], found["leg_missing"]) == ("2 3", 0.81)
    assert [found[f"leg{k}"] for k in range(1, 5)] == ["unseen", "broken", "broken", "unseen"]
    assert [found[f"leg{k}_missing"] for k in range(1, 5)] == [None, 0.42, 0.81, None]
    assert [found[f"leg{k}_probability"] for k in range(1, 5)] == [None, 0.9, 0.75, None]


def test_earlier_results_say_nothing_of_legs(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    write_result(path, 12)
    data = write_report(path, tmp_path / "r.html", ReportOptions(sections=("castings",)))
    assert not data.castings.legs
    assert not data.castings.moulds
    rows = read_unit_rows(path, EpochPair(data.pair.epoch_from, data.pair.epoch_to), data.datum)
    assert damage(rows).n_broken == 0
