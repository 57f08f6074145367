"""Which pair is told of: the last one that a run compared, though nothing may be left that both of its epochs see."""

from __future__ import annotations

import csv
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from synthetic_result import make_units, write_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.report.report import write_report
from tetratrack.core.report.result_choice import choose_pair
from tetratrack.core.results.geopackage_reader import EpochPair, add_spatial_functions, epoch_pairs, latest_pair
from tetratrack.core.results.unit_rows import datums


def _all_lost(path: Path, epochs: int) -> EpochPair:
    """A result in the last of whose epochs every unit is lost; the last pair."""
    write_result(path, epochs=epochs, units=[unit for unit in make_units(40, epochs) if unit.fate in ("stable", "moved")])
    pair = EpochPair(f"{2023 + epochs - 2}-04-09", f"{2023 + epochs - 1}-04-09")
    with closing(sqlite3.connect(path)) as connection, connection:
        add_spatial_functions(connection)
        for layer in ("displacements", "displacements_other"):
            connection.execute(f"DELETE FROM {layer} WHERE epoch_to = ?", (pair.epoch_to,))  # noqa: S608
        connection.execute("DELETE FROM feature_points WHERE epoch = ?", (pair.epoch_to,))
        connection.execute("UPDATE units SET status = 'lost', geom = NULL, qw = NULL WHERE epoch = ?", (pair.epoch_to,))
    return pair


@pytest.mark.parametrize("epochs", [2, 3])
def test_units_that_are_all_lost_are_told_of(tmp_path: Path, epochs: int) -> None:
    """With two epochs the list was refused for want of a second one, with three the pair before was told of as the last."""
    path = tmp_path / "result.gpkg"
    pair = _all_lost(path, epochs)
    assert choose_pair(path, None, None) == (pair, "stable")
    assert choose_pair(path, pair, "control") == (pair, "control")
    count = write_alarms(path, tmp_path / "alarms.csv", 0.1)
    with (tmp_path / "alarms.csv").open(encoding="utf-8-sig", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert count == len(rows) > 30
    assert {(row["class"], row["epoch_from"], row["epoch_to"]) for row in rows} == {("lost", pair.epoch_from, pair.epoch_to)}
    data = write_report(path, tmp_path / "report.html")
    assert data.damage is not None
    assert data.damage.n_lost == data.damage.units == count


def test_epochs_that_no_run_compared_are_no_pair(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    pair = _all_lost(path, 2)
    with closing(sqlite3.connect(path)) as connection, connection:
        add_spatial_functions(connection)
        connection.execute("DELETE FROM epoch_pairs")
    assert epoch_pairs(path) == ()
    assert datums(path, pair) == ()
    with pytest.raises(InputError, match="two epochs or more"):
        choose_pair(path, None, None)


def test_the_latest_pair_is_one_of_consecutive_epochs() -> None:
    pairs = [EpochPair("a", "b"), EpochPair("b", "c"), EpochPair("a", "c")]
    assert latest_pair(pairs, ["a", "b", "c"]) == EpochPair("b", "c")
    assert latest_pair(pairs[2:], ["a", "b", "c"]) == EpochPair("a", "c")
