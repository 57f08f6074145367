"""Corrections by hand to a result: what they change, what they keep, and that they can be taken back."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from synthetic_result import GRADIENT, HEIGHT, LEGS, RADIUS, features_of, write_result
from tetratrack.core.displacement_rows import read_details, read_unit_rows
from tetratrack.core.errors import InputError
from tetratrack.core.outline import rotation_of_quaternion
from tetratrack.core.result_tables import SELECT_ALL, epoch_pairs
from tetratrack.core.unit_edits import (
    NewPose,
    add_placeholder,
    chi2_3_survival,
    delete_unit,
    merge_units,
    nearest_labels,
    placeholders,
    pose_from_features,
    read_edits,
    read_picks,
    set_pose,
    split_unit,
    store_picks,
    undo_edit,
)

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
    return NewPose(centre, rotation_of_quaternion(quaternion), RADIUS, GRADIENT, HEIGHT, SD, 0.2, 1.0, 500, 3, 0.4, 0.8)


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
    assert row.rotation_deg == pytest.approx(0.0, abs=1e-5)
    later = next(r for r in read_unit_rows(result, second, "stable") if r.unit_id == unit.unit_id)
    np.testing.assert_allclose(later.place, unit.centres[1] + shift, atol=1e-9)
    details = read_details(result, unit.unit_id)
    for k, name in enumerate(("centre", "f123", "f124", "f134", "f234")):
        np.testing.assert_allclose(details.features[first.epoch_to][name][0], features_of(unit, 1)[k] + shift, atol=1e-6)
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
