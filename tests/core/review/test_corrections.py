"""Corrections by hand to a result: what they change, what they keep, and that they can be taken back."""

from __future__ import annotations

import multiprocessing
import sqlite3
from contextlib import closing, suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from synthetic_result import GRADIENT, HEIGHT, LEGS, NOMINAL_DIAMETER, RADIUS, features_of, write_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.model.outline import rotation_of_quaternion
from tetratrack.core.results.geopackage_reader import SELECT_ALL, EpochPair, epoch_pairs, read_layer_rows
from tetratrack.core.results.unit_rows import read_details, read_unit_rows
from tetratrack.core.review.corrections import (
    add_placeholder,
    delete_unit,
    last_edit_of,
    merge_units,
    placeholders,
    read_edits,
    read_picks,
    set_pose,
    split_unit,
    store_picks,
    undo_edit,
)
from tetratrack.core.review.decisions import confirm, decide, read_history, read_reviews, settle_decisions
from tetratrack.core.review.pose_consequences import NewPose, chi2_3_survival
from tetratrack.core.review.pose_from_picks import nearest_labels, pose_from_features
from tetratrack.core.review.unit_records import OF_UNITS

PAIR = EpochPair("2023-04-09", "2024-04-09")
SD = np.array([0.004, 0.004, 0.003])
LAYERS = ("units", "feature_points", "displacements", "displacements_other", "check_residuals")


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    write_result(path, 40, 3)
    return path


def dump(path: Path) -> dict[str, list[tuple[object, ...]]]:
    with closing(sqlite3.connect(path)) as connection:
        return {layer: connection.execute(SELECT_ALL[layer]).fetchall() for layer in LAYERS}


def new_pose(centre: np.ndarray, quaternion: np.ndarray) -> NewPose:
    return NewPose(
        centre=centre,
        rotation=rotation_of_quaternion(quaternion),
        radius=RADIUS,
        gradient=GRADIENT,
        height=HEIGHT,
        sd=SD,
        sd_rotation_deg=0.2,
        sigma0=1.0,
        n_points=500,
        legs_visible=3,
        coverage=0.4,
        score=0.8,
    )


def test_new_pose_moves_features_and_displacements_and_undo_restores_every_row(result: Path, tmp_path: Path) -> None:
    unit = next(u for u in write_result(tmp_path / "twin.gpkg", 40, 3) if u.fate == "stable")
    before = dump(result)
    first, second = epoch_pairs(result)[:2]
    old = next(r for r in read_unit_rows(result, first, "stable") if r.unit_id == unit.unit_id)
    shift = np.array([0.10, -0.05, -0.02])
    set_pose(result, unit.unit_id, first.epoch_to, new_pose(unit.centres[1] + shift, unit.quaternions[1]), editor="A")
    row = next(r for r in read_unit_rows(result, first, "stable") if r.unit_id == unit.unit_id)
    np.testing.assert_allclose(row.vector, old.vector + shift, atol=1e-9)
    np.testing.assert_allclose(row.sd, old.sd, atol=1e-9)
    assert row.kind == "moved"
    assert row.nominal_diameter == pytest.approx(NOMINAL_DIAMETER), "in the unit's own nominal diameter, as the run states it"
    assert row.rotation_deg == pytest.approx(0.0, abs=1e-5)
    later = next(r for r in read_unit_rows(result, second, "stable") if r.unit_id == unit.unit_id)
    np.testing.assert_allclose(later.place, unit.centres[1] + shift, atol=1e-9)
    details = read_details(result, unit.unit_id)
    for k, name in enumerate(("centre", "f123", "f124", "f134", "f234")):
        np.testing.assert_allclose(details.features[first.epoch_to][name][0], features_of(unit, 1)[k] + shift, atol=1e-6)
    undo_edit(result, read_edits(result)[-1].number, editor="A")
    assert dump(result) == before


@pytest.mark.parametrize(("shift", "turn", "kept"), [(0.05, 5.0, True), (0.5, 0.0, False), (0.0, 30.0, False)])
def test_what_was_seen_of_legs_goes_with_a_pose_that_was_another(
    result: Path, tmp_path: Path, shift: float, turn: float, kept: bool
) -> None:
    unit = next(u for u in write_result(tmp_path / "twin.gpkg", 40, 3) if u.fate == "stable")
    told = {"leg1": "whole", "leg2": "broken", "leg3": "unseen", "leg4": "whole", "leg_missing": 0.4, "leg2_missing": 0.4}
    told |= {"leg_probability": 0.9, "leg2_probability": 0.9}
    epoch = epoch_pairs(result)[0].epoch_to
    with closing(sqlite3.connect(result)) as connection, connection:
        for name, value in told.items():
            connection.execute(f"UPDATE units SET {name} = ?", (value,))  # noqa: S608 - names of the test
    before = dump(result)
    pose = new_pose(unit.centres[1] + [shift, 0, 0], unit.quaternions[1])
    about_up = rotation_of_quaternion([0, 0, np.sin(np.radians(turn) / 2), np.cos(np.radians(turn) / 2)])
    set_pose(result, unit.unit_id, epoch, replace(pose, rotation=about_up @ pose.rotation), editor="A")
    row = next(r for r in read_layer_rows(result, "units") if r["unit_id"] == unit.unit_id and r["epoch"] == epoch)
    assert {name: row[name] for name in told} == (told if kept else dict.fromkeys(told))
    undo_edit(result, read_edits(result)[-1].number, editor="A")
    assert dump(result) == before


def test_pose_with_renumbered_legs_keeps_the_old_numbers() -> None:
    rotation = rotation_of_quaternion([0.3, -0.2, 0.5, 0.78])
    third = rotation_of_quaternion([0, 0, np.sin(np.pi / 3), np.cos(np.pi / 3)])
    np.testing.assert_allclose(nearest_labels(rotation, rotation @ third), rotation, atol=1e-9)


def test_delete_takes_a_unit_out_and_undo_brings_it_back(result: Path) -> None:
    before = dump(result)
    delete_unit(result, "U00003", editor="A", comment="rock")
    assert not [r for r in read_unit_rows(result, epoch_pairs(result)[0], "stable") if r.unit_id == "U00003"]
    edit = read_edits(result)[-1]
    assert (edit.kind, edit.comment, edit.editor) == ("delete", "rock", "A")
    undo_edit(result, edit.number, editor="A")
    assert dump(result) == before
    with pytest.raises(InputError, match="does not stand"):
        undo_edit(result, edit.number, editor="A")


def test_split_then_merge_gives_the_same_displacements(result: Path) -> None:
    pair = epoch_pairs(result)[0]
    old = next(r for r in read_unit_rows(result, pair, "stable") if r.kind == "stable" and r.unit_id != "U00001")
    before = dump(result)
    name = split_unit(result, old.unit_id, pair.epoch_to, editor="A")
    rows = {r.unit_id: r for r in read_unit_rows(result, pair, "stable")}
    assert rows[name].kind == "new"
    assert rows[old.unit_id].vector is None
    merge_units(result, old.unit_id, name, editor="A")
    row = next(r for r in read_unit_rows(result, pair, "stable") if r.unit_id == old.unit_id)
    np.testing.assert_allclose(row.vector, old.vector, atol=1e-6)
    np.testing.assert_allclose(row.sd, old.sd, atol=1e-4)
    undo_edit(result, read_edits(result)[-1].number, editor="A")
    undo_edit(result, read_edits(result)[-2].number, editor="A")
    assert dump(result) == before


def test_units_found_in_the_same_epoch_are_not_merged(result: Path) -> None:
    with pytest.raises(InputError, match="both were found"):
        merge_units(result, "U00001", "U00002", editor="A")


def test_three_picks_give_the_pose_whatever_their_order() -> None:
    rng = np.random.default_rng(5)
    distance = RADIUS / (np.sin(np.arccos(1 / 3)) + GRADIENT / 3)
    for _ in range(20):
        rotation = rotation_of_quaternion(rng.normal(size=4))
        centre = rng.uniform(-5, 5, 3)
        order = rng.permutation(4)[:3]
        picks = centre - distance * LEGS[[3, 2, 1, 0]][order] @ rotation.T
        found, turned, names, misfit = pose_from_features(picks, RADIUS, GRADIENT, rotation)
        np.testing.assert_allclose(found, centre, atol=1e-6)
        np.testing.assert_allclose(turned, rotation, atol=1e-6)
        assert names == tuple(("f123", "f124", "f134", "f234")[k] for k in order)
        assert misfit < 1e-6
    with pytest.raises(InputError, match="three different"):
        pose_from_features(picks[[0, 1, 1]], RADIUS, GRADIENT)


def test_picks_stand_beside_the_fit_and_are_replaced_by_the_same_person_only(result: Path) -> None:
    store_picks(result, "U00001", "2023-04-09", {"f123": [1.0, 2.0, 3.0]}, editor="A")
    store_picks(result, "U00001", "2023-04-09", {"f123": [1.0, 2.0, 4.0]}, editor="A")
    store_picks(result, "U00001", "2023-04-09", {"f123": [1.0, 2.0, 5.0]}, editor="B")
    assert sorted(float(row["geom"][2]) for row in read_picks(result, "U00001")) == [4.0, 5.0]


def test_picks_are_taken_back_and_bring_back_those_they_replaced(result: Path) -> None:
    unit = _tracked(result)[0]
    before = result_rows(result)
    for east in (1.0, 2.0):
        store_picks(result, unit, PAIR.epoch_to, {"f123": [east, 2.0, 3.0], "f124": [east, 3.0, 3.0]}, editor="A")
    store_picks(result, unit, PAIR.epoch_to, {"f123": [5.0, 2.0, 3.0]}, editor="B")
    with pytest.raises(InputError, match="corrected again later, by A"):
        undo_edit(result, read_edits(result)[0].number, editor="A")
    undo_edit(result, last_edit_of(result, "A").number, editor="A")
    assert sorted(row["geom"][0] for row in read_picks(result, unit)) == [1.0, 1.0, 5.0]
    undo_edit(result, last_edit_of(result, "A").number, editor="A")
    assert [row["picked_by"] for row in read_picks(result, unit)] == ["B"]
    assert result_rows(result) == before, "picks stand beside the fit"


def test_picks_that_make_a_pose_stand_and_fall_with_it(result: Path) -> None:
    unit = _tracked(result)[0]
    store_picks(result, unit, PAIR.epoch_to, {"f123": [1.0, 2.0, 3.0]}, editor="A")
    before = result_rows(result)
    picks = {"f123": [4.0, 2.0, 3.0], "f124": [5.0, 2.0, 3.0], "f134": [6.0, 2.0, 3.0]}
    set_pose(result, unit, PAIR.epoch_to, _moved_pose(result, unit, PAIR.epoch_to, 0.1), editor="A", picks=picks)
    assert [edit.kind for edit in read_edits(result)] == ["pick", "pose"], "one act"
    assert sorted(row["geom"][0] for row in read_picks(result, unit)) == [4.0, 5.0, 6.0]
    # somebody else's pick is neither in the way nor lost
    store_picks(result, unit, PAIR.epoch_to, {"f234": [9.0, 2.0, 3.0]}, editor="B")
    undo_edit(result, last_edit_of(result, "A").number, editor="A")
    assert sorted(row["geom"][0] for row in read_picks(result, unit)) == [1.0, 9.0]
    assert result_rows(result) == before


def test_picks_taken_back_after_a_merge_come_back_to_the_unit_that_has_them(result: Path) -> None:
    unit = _tracked(result)[0]
    name = split_unit(result, unit, "2025-04-09", editor="Ben")
    store_picks(result, name, "2025-04-09", {"f123": [1.0, 2.0, 3.0]}, editor="A")
    merge_units(result, unit, name, editor="Ben")
    store_picks(result, unit, "2025-04-09", {"f123": [2.0, 2.0, 3.0]}, editor="A")
    undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")
    undo_edit(result, last_edit_of(result, "A").number, editor="A")
    assert [row["geom"][0] for row in read_picks(result, name)] == [1.0]
    assert read_picks(result, unit) == []


def test_placeholder_counts_until_it_is_taken_back(result: Path) -> None:
    name = add_placeholder(result, "2023-04-09", [1.0, 2.0, 3.0], editor="A")
    assert [found[0] for found in placeholders(result, "2023-04-09")] == [name]
    undo_edit(result, read_edits(result)[-1].number, editor="A")
    assert placeholders(result, "2023-04-09") == []


def test_chi_square_of_three_degrees_of_freedom() -> None:
    from scipy.stats import chi2

    for value in (0.0, 0.5, 7.814728, 30.0):
        assert chi2_3_survival(value) == pytest.approx(chi2.sf(value, 3), rel=1e-9)


def test_correction_never_makes_a_displacement_look_surer(result: Path, tmp_path: Path) -> None:
    unit = next(u for u in write_result(tmp_path / "twin.gpkg", 40, 3) if u.fate == "stable")
    pair = epoch_pairs(result)[0]
    old = next(r for r in read_unit_rows(result, pair, "stable") if r.unit_id == unit.unit_id)
    for sd, expected in ((SD / 2, old.sd), (5 * SD, np.sqrt(old.sd**2 + 24 * SD**2))):
        pose = new_pose(unit.centres[1], unit.quaternions[1])
        set_pose(result, unit.unit_id, pair.epoch_to, NewPose(**{**vars(pose), "sd": sd}), editor="A")
        row = next(r for r in read_unit_rows(result, pair, "stable") if r.unit_id == unit.unit_id)
        np.testing.assert_allclose(row.sd, expected, rtol=1e-6)
        undo_edit(result, read_edits(result)[-1].number, editor="A")


def _moved_pose(result: Path, unit: str, epoch: str, by: float) -> NewPose:
    """The pose a unit has, moved by some metres to the east."""
    row = next(r for r in read_layer_rows(result, "units") if (r["unit_id"], r["epoch"]) == (unit, epoch))
    return new_pose(row["geom"] + np.array([by, 0, 0]), np.array([row[name] for name in ("qx", "qy", "qz", "qw")]))


def test_a_decision_ends_with_its_numbers_and_comes_back_with_them(result: Path) -> None:
    unit = next(u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3)
    other = next(u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3 and u != unit)
    decide(result, [unit, other], PAIR, "accepted", comment="", reviewer="Anna")
    later = EpochPair("2024-04-09", "2025-04-09")
    decide(result, [unit], later, "accepted", comment="", reviewer="Anna")
    set_pose(result, unit, PAIR.epoch_from, _moved_pose(result, unit, PAIR.epoch_from, 0.9), editor="Ben")
    assert set(read_reviews(result)) == {(other, PAIR), (unit, later)}, "undecided again, and only where the numbers changed"
    lapse = read_history(result, unit)[-1]
    assert (lapse.action, lapse.decision, lapse.reviewer) == ("lapse", "accepted", "Ben")
    before, after = (float(part.split()[0]) for part in lapse.comment.split(" → "))
    assert after - before > 0.5
    with pytest.raises(InputError, match="no decision to confirm"):
        confirm(result, unit, PAIR, reviewer="Cleo")
    undo_edit(result, read_edits(result)[-1].number, editor="Ben")
    assert read_reviews(result)[unit, PAIR].reviewer == "Anna"
    assert [e.action for e in read_history(result, unit)] == ["decide", "decide", "lapse", "restore"]


def test_a_change_nobody_would_see_leaves_the_decision(result: Path) -> None:
    unit = next(u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3)
    decide(result, [unit], PAIR, "accepted", comment="", reviewer="Anna")
    set_pose(result, unit, PAIR.epoch_from, _moved_pose(result, unit, PAIR.epoch_from, 0.0), editor="Ben")
    assert (unit, PAIR) in read_reviews(result)


def test_a_new_run_with_other_numbers_ends_decisions(result: Path) -> None:
    unit, same = sorted(u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3)[:2]
    decide(result, [unit, same], PAIR, "accepted", comment="", reviewer="Anna")
    with closing(sqlite3.connect(result)) as connection:
        connection.execute("UPDATE displacements SET de = de + 0.2 WHERE unit_id = ?", (unit,))
        connection.commit()
    assert settle_decisions(result) == 1
    assert set(read_reviews(result)) == {(same, PAIR)}
    assert read_history(result, unit)[-1].reviewer == "tetratrack"
    assert settle_decisions(result) == 0


def test_nobody_decides_on_a_deleted_unit(result: Path) -> None:
    delete_unit(result, "U00002", editor="Ben")
    with pytest.raises(InputError, match="not in the result any more"):
        decide(result, ["U00001", "U00002"], PAIR, "accepted", comment="", reviewer="Anna")
    assert read_reviews(result) == {}, "all or nothing"


def test_corrections_are_taken_back_by_their_own_editor_only(result: Path) -> None:
    delete_unit(result, "U00002", editor="Ben")
    delete_unit(result, "U00003", editor="Anna")
    with pytest.raises(InputError, match="Ben's"):
        undo_edit(result, read_edits(result)[0].number, editor="Anna")
    last = last_edit_of(result, "anna ")
    assert last is not None
    undo_edit(result, last.number, editor="Anna")
    assert [(edit.editor, edit.undone, edit.undone_by) for edit in read_edits(result)] == [("Ben", False, ""), ("Anna", True, "Anna")]
    assert last_edit_of(result, "Anna") is None
    rows = read_layer_rows(result, "unit_edits")
    assert [(row["kind"], row["editor"]) for row in rows] == [("delete", "Ben"), ("delete", "Anna"), ("undo", "Anna")], "appended"


def test_a_correction_under_a_later_one_stands(result: Path) -> None:
    unit = next(u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3)
    name = split_unit(result, unit, PAIR.epoch_to, editor="Anna")
    split = read_edits(result)[-1].number
    set_pose(result, name, PAIR.epoch_to, _moved_pose(result, name, PAIR.epoch_to, 0.1), editor="Ben")
    with pytest.raises(InputError, match="corrected again later, by Ben"):
        undo_edit(result, split, editor="Anna")


def _epochs_of_units(result: Path) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for row in read_layer_rows(result, "units"):
        if row["geom"] is not None:
            found.setdefault(row["unit_id"], set()).add(row["epoch"])
    return found


def _decide_much(path: str, units: list[str], acts: int) -> None:
    for k in range(acts):
        with suppress(InputError):
            decide(Path(path), [units[k % len(units)]], PAIR, "accepted", comment=str(k), reviewer="Anna")


def _correct_much(path: str, units: list[str], acts: int) -> None:
    result = Path(path)
    for k in range(acts):
        unit = units[(7 * k) % len(units)]
        if k % 2 == 0:
            set_pose(result, unit, PAIR.epoch_to, _moved_pose(result, unit, PAIR.epoch_to, 0.01), editor="Ben", comment=str(k))
        else:
            undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")


def test_deciding_and_correcting_at_once_lose_nothing(result: Path) -> None:
    """Two processes, one deciding and one correcting, 200 acts each."""
    units = [u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3][:20]
    before = result_rows(result)
    context = multiprocessing.get_context("spawn")
    writers = [context.Process(target=act, args=(str(result), units, 200)) for act in (_decide_much, _correct_much)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join(240)
        assert writer.exitcode == 0
    decisions = [e for e in read_history(result) if e.action == "decide"]
    assert [e.comment for e in decisions] == [str(k) for k in range(200)]
    edits = read_edits(result)
    assert [e.comment for e in edits] == [str(k) for k in range(0, 200, 2)]
    assert all(e.undone_by == "Ben" for e in edits)
    assert result_rows(result) == before, "every correction was taken back"
    # a decision made while a correction stood rests on numbers that are gone
    reviews = read_reviews(result)
    for unit in units:
        events = read_history(result, unit)
        standing = [e for e in events if e.action == "decide"][-1]
        now = [e for e in events if e.action in ("decide", "lapse", "restore")][-1]
        assert ((unit, PAIR) in reviews) == (now.action != "lapse"), (standing, now)


def result_rows(result: Path) -> list[str]:
    rows = read_layer_rows(result, "units")
    return sorted(f"{r['unit_id']} {r['epoch']} {None if r['geom'] is None else np.round(r['geom'], 6)}" for r in rows)


PICKED_BY = "Anna"


def _pick(result: Path, unit: str, epoch: str, east: float = 1.0) -> None:
    store_picks(result, unit, epoch, {"f123": [east, 2.0, 3.0]}, editor=PICKED_BY)


def _with_every_layer(result: Path, units: list[str]) -> None:
    """Give units a row in each layer that names units and that the made-up result leaves empty of them."""
    with closing(sqlite3.connect(result)) as connection, connection:
        for unit in units:
            for row in (("2023-04-09", "2024-04-09"), ("2024-04-09", "2025-04-09")):
                connection.execute(
                    "INSERT INTO cross_checks (unit_id, epoch_from, epoch_to, difference) VALUES (?, ?, ?, 0.001)", (unit, *row)
                )
            connection.execute(
                "INSERT INTO velocities (unit_id, feature, epoch_from, epoch_to) VALUES (?, 'centre', '2023-04-09', '2025-04-09')", (unit,)
            )
            connection.execute("INSERT INTO gaps (unit_id, epoch, kind, status) VALUES (?, '2025-04-09', 'lost', 'placeholder')", (unit,))


def _rows_of(result: Path, unit: str) -> dict[str, int]:
    """Rows of a unit by table, as far as it has any; the records of who did what keep the name."""
    with closing(sqlite3.connect(result)) as connection:
        tables = [
            name
            for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'").fetchall()
            if name not in ("unit_edits", "review_log")
            and "unit_id" in [column[1] for column in connection.execute(f"PRAGMA table_info('{name}')")]
        ]
        counts = {name: connection.execute(f"SELECT count(*) FROM {name} WHERE unit_id = ?", (unit,)).fetchone()[0] for name in tables}  # noqa: S608 - names of the file
    return {name: count for name, count in counts.items() if count}


def _all_rows(result: Path) -> dict[str, list[tuple[object, ...]]]:
    with closing(sqlite3.connect(result)) as connection:
        return {layer: connection.execute(f"SELECT * FROM {layer} ORDER BY fid").fetchall() for layer in OF_UNITS}  # noqa: S608 - names of the schema


def _tracked(result: Path) -> list[str]:
    return [u for u, epochs in _epochs_of_units(result).items() if len(epochs) == 3]


def test_a_deleted_unit_leaves_nothing_behind(result: Path) -> None:
    unit = _tracked(result)[0]
    _with_every_layer(result, [unit])
    _pick(result, unit, PAIR.epoch_to)
    decide(result, [unit], PAIR, "accepted", comment="", reviewer="Anna")
    assert set(_rows_of(result, unit)) >= {*OF_UNITS, "reviews"} - {"check_residuals"}
    before = _all_rows(result)
    delete_unit(result, unit, editor="Ben")
    assert _rows_of(result, unit) == {}
    undo_edit(result, read_edits(result)[-1].number, editor="Ben")
    assert _all_rows(result) == before


def test_a_split_and_a_merge_take_every_row_along(result: Path) -> None:
    unit = _tracked(result)[0]
    _with_every_layer(result, [unit])
    _pick(result, unit, "2023-04-09")
    _pick(result, unit, "2025-04-09")
    before = _all_rows(result)
    name = split_unit(result, unit, "2025-04-09", editor="Ben")
    mine, others = _rows_of(result, unit), _rows_of(result, name)
    assert (mine["cross_checks"], others.get("cross_checks", 0)) == (1, 0), "the one across the split compares two units"
    assert (mine["manual_picks"], others["manual_picks"]) == (1, 1)
    assert (mine.get("gaps", 0), others["gaps"]) == (0, 1)
    merge_units(result, unit, name, editor="Ben")
    assert _rows_of(result, name) == {}
    assert [pick["epoch"] for pick in read_picks(result, unit)] == ["2023-04-09", "2025-04-09"]
    for _ in range(2):
        undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")
    assert _all_rows(result) == before


def test_where_one_was_found_the_other_is_not_missing(result: Path) -> None:
    unit = _tracked(result)[0]
    _pick(result, unit, "2023-04-09")
    name = split_unit(result, unit, "2025-04-09", editor="Ben")
    with closing(sqlite3.connect(result)) as connection, connection:
        statement = "INSERT INTO gaps (unit_id, epoch, kind, status) VALUES (?, ?, 'lost', 'placeholder')"
        connection.executemany(statement, [(unit, "2025-04-09"), (name, "2024-04-09"), (unit, "2026-04-09"), (name, "2026-04-09")])
    before = _all_rows(result)
    merge_units(result, unit, name, editor="Ben")
    assert [row["epoch"] for row in read_layer_rows(result, "gaps") if row["unit_id"] in (unit, name)] == ["2026-04-09"]
    undo_edit(result, read_edits(result)[-1].number, editor="Ben")
    assert _all_rows(result) == before


def test_picks_made_since_a_correction_outlive_its_end(result: Path) -> None:
    unit, other = _tracked(result)[:2]
    _pick(result, unit, PAIR.epoch_to)
    _with_every_layer(result, [unit])
    set_pose(result, unit, PAIR.epoch_to, _moved_pose(result, unit, PAIR.epoch_to, 0.1), editor="Ben")
    assert "cross_checks" not in _rows_of(result, unit), "they compare with the earlier pose"
    _pick(result, unit, PAIR.epoch_to, 7.0)
    name = split_unit(result, other, PAIR.epoch_to, editor="Ben")
    _pick(result, name, PAIR.epoch_to)
    for _ in range(2):
        undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")
    assert [pick["geom"][0] for pick in read_picks(result, unit)] == [7.0]
    assert len(read_picks(result, other)) == 1
    assert _rows_of(result, name) == {}
    assert _rows_of(result, unit)["cross_checks"] == 2


@pytest.mark.parametrize("layer", sorted(set(OF_UNITS) - {"units", "feature_points", "displacements", "manual_picks"}))
def test_results_without_a_layer_are_corrected_all_the_same(result: Path, layer: str) -> None:
    """Earlier versions wrote fewer layers."""
    unit, other = _tracked(result)[:2]
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute(f"DROP TABLE {layer}")
        connection.execute("DELETE FROM gpkg_contents WHERE table_name = ?", (layer,))
    before = result_rows(result)
    set_pose(result, unit, PAIR.epoch_to, _moved_pose(result, unit, PAIR.epoch_to, 0.1), editor="Ben")
    name = split_unit(result, unit, PAIR.epoch_to, editor="Ben")
    merge_units(result, unit, name, editor="Ben")
    delete_unit(result, other, editor="Ben")
    for _ in range(4):
        undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")
    assert result_rows(result) == before


def test_the_end_of_a_merge_leaves_each_unit_the_picks_made_in_its_epochs(result: Path) -> None:
    unit = _tracked(result)[0]
    name = split_unit(result, unit, "2025-04-09", editor="Ben")
    store_picks(result, name, "2025-04-09", {"f123": [1.0, 2.0, 3.0], "f124": [2.0, 2.0, 3.0]}, editor=PICKED_BY)
    _pick(result, unit, "2023-04-09", 3.0)
    _pick(result, unit, "2025-04-09", 4.0)
    store_picks(result, unit, "2025-04-09", {"f134": [5.0, 2.0, 3.0]}, editor="Cleo")
    merge_units(result, unit, name, editor="Ben")
    _pick(result, unit, "2023-04-09", 6.0)
    _pick(result, unit, "2025-04-09", 7.0)
    undo_edit(result, last_edit_of(result, "Ben").number, editor="Ben")

    def picks(of: str) -> set[tuple[str, str, float]]:
        return {(row["epoch"], row["feature"], float(row["geom"][0])) for row in read_picks(result, of)}

    assert picks(name) == {("2025-04-09", "f123", 7.0), ("2025-04-09", "f124", 2.0)}, "the one picked anew does not come back beside it"
    assert picks(unit) == {("2023-04-09", "f123", 6.0), ("2025-04-09", "f134", 5.0)}
