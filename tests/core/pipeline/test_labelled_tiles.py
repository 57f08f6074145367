"""Tiles written back with the unit of each point."""

from __future__ import annotations

import json
import re
import shutil
import sqlite3
from contextlib import closing
from dataclasses import asdict, replace
from pathlib import Path

import laspy
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.las_files import checksum
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.labelled_tiles import points_of_units, write_labelled_tiles
from tetratrack.core.pipeline.refit import index_unit_points
from tetratrack.core.results.unit_rows import read_epochs


def test_labels_follow_the_truth_and_nothing_else_changes(tiny: Path, result: Path, tmp_path: Path):
    survey = read_survey(tiny / "survey.toml")
    outcome = write_labelled_tiles(survey, result, tmp_path / "labelled", Feedback())
    written = sorted((tmp_path / "labelled" / "2024-04-09").glob("*.laz"))
    assert [p.name for p in written] == [p.name for p in sorted((tiny / "tiles" / "2024-04-09").glob("*.laz"))]
    truth = np.load(tiny / "truth" / "labels_2024-04-09.npz")
    agreeing, mine = 0, 0
    for path in written:
        before, after = laspy.read(tiny / "tiles" / "2024-04-09" / path.name), laspy.read(path)
        for dimension in before.point_format.dimension_names:
            np.testing.assert_array_equal(before[dimension], after[dimension], err_msg=dimension)
        np.testing.assert_array_equal(before.header.offsets, after.header.offsets)
        assert after.header.parse_crs() == before.header.parse_crs()
        number = np.asarray(after.unit_id)
        of_unit = truth[path.stem]
        # points of one labelled unit come from one true unit
        for unit in np.unique(number[number > 0]):
            _, count = np.unique(of_unit[number == unit], return_counts=True)
            agreeing += int(count.max())
            mine += int(count.sum())
    assert mine > 3000
    assert agreeing / mine > 0.97
    assert outcome["tiles"] == 4

    labelled = laspy.read(written[0])
    assert labelled.header.point_count == laspy.read(tiny / "tiles" / "2024-04-09" / written[0].name).header.point_count


def test_units_of_the_second_type_have_its_size(tiny: Path, result: Path, tmp_path: Path):
    survey = read_survey(tiny / "survey.toml")
    kind = asdict(survey.unit)
    assert all(epoch.settings["unit_types"] == [kind] for epoch in read_epochs(result))
    twofold = tmp_path / "result.gpkg"
    shutil.copy(result, twofold)
    first = kind | {"name": "tetrapod 1 t", "height": 0.5 * kind["height"], "leg_length": 0.5 * kind["leg_length"]}
    with closing(sqlite3.connect(twofold)) as connection, connection:
        settings = json.dumps({"leg_length": first["leg_length"], "unit_types": [first, kind]})
        connection.execute("UPDATE epochs SET settings = json_patch(settings, ?)", (settings,))
    counts = [write_labelled_tiles(survey, path, tmp_path / path.parent.name, Feedback())["points"] for path in (result, twofold)]
    assert counts[0] == counts[1]


def test_points_of_a_noisy_cloud_are_labelled_as_far_as_noise_puts_them():
    """A fixed share of the height left out a sixth of the points at a noise of 1.6 % of it, and half of them at 3 %."""
    rng, unit, noise = np.random.default_rng(3), UnitType.tetrapod(2.3), 0.07
    exact, normals, _ = sample_surface(unit, 4000, rng)
    points = exact + rng.normal(0, noise, len(exact))[:, None] * normals
    row = {"geom": np.zeros(3), "qx": 0.0, "qy": 0.0, "qz": 0.0, "qw": 1.0, "unit_id": "U0007", "distance_median": noise / 1.4826}
    assert np.mean(points_of_units(points, {unit: [row]}) == 7) > 0.98
    assert np.mean(points_of_units(points, {unit: [row | {"distance_median": None}]}) == 7) < 0.6, "of an earlier version"


def test_points_that_may_be_the_neighbours_are_of_none():
    """Where two units all but touch, the nearer one would take points that noise moved towards it; a run leaves them out."""
    rng, unit, noise = np.random.default_rng(3), UnitType.tetrapod(2.3), 0.02
    apart = np.array([2.2, 0.0, 0.0])
    exact, normals, _ = sample_surface(unit, 20_000, rng)
    points = exact + rng.normal(0, noise, len(exact))[:, None] * normals
    row = {"qx": 0.0, "qy": 0.0, "qz": 0.0, "qw": 1.0, "distance_median": noise / 1.4826}
    rows = [row | {"geom": np.zeros(3), "unit_id": "U0007"}, row | {"geom": apart, "unit_id": "U0008"}]
    numbers, gap = points_of_units(points, {unit: rows}), relate(exact - apart, unit).distance
    assert np.sum(gap < 1.5 * noise) > 20
    assert not numbers[gap < 1.5 * noise].any()
    assert np.mean(numbers[gap > 0.2] == 7) > 0.99


def test_points_are_labelled_less_the_offsets_of_their_strips(tiny: Path, result: Path, tmp_path: Path):
    """A strip that lies aside by more than a point may be off its unit belongs to the same units, as the run took it."""
    folder, path = tmp_path / "survey", tmp_path / "aside.gpkg"
    shutil.copytree(tiny, folder)
    shutil.copy(result, path)
    moved, survey = np.array([0.06, -0.05, 0.04]), read_survey(folder / "survey.toml")
    strip = int(np.asarray(laspy.read(survey.epochs[0].tiles[0]).point_source_id)[0])
    counts = [write_labelled_tiles(read_survey(tiny / "survey.toml"), result, tmp_path / "as_it_is", Feedback())["points"]]
    for epoch in survey.epochs:
        for tile in epoch.tiles:
            cloud = laspy.read(tile)
            cloud.xyz = np.asarray(cloud.xyz) + moved * (np.asarray(cloud.point_source_id) == strip)[:, None]
            cloud.write(tile)
    digests = {tile.name: checksum(tile) for epoch in survey.epochs for tile in epoch.tiles}
    with closing(sqlite3.connect(path)) as connection, connection:
        for label, text, transformation in connection.execute("SELECT label, settings, transformation FROM epochs").fetchall():
            settings = json.loads(text)
            settings["inputs"] = [given | {"sha256": digests.get(given["name"], given["sha256"])} for given in settings["inputs"]]
            known = settings.get("source_offsets_m", {}).get(str(strip), (0.0, 0.0, 0.0))
            turn = Rotation.from_rotvec(json.loads(transformation)["rotation_vector_rad"])
            settings["source_offsets_m"] |= {str(strip): (turn.apply(moved) + known).tolist()}
            connection.execute("UPDATE epochs SET settings = ? WHERE label = ?", (json.dumps(settings), label))
    counts.append(write_labelled_tiles(survey, path, tmp_path / "aside", Feedback())["points"])
    assert counts[1] == pytest.approx(counts[0], rel=0.002)


def test_tiles_of_another_survey_are_refused(tiny: Path, result: Path, tmp_path: Path):
    text = (tiny / "survey.toml").read_text().replace('label = "2024-04-09"', 'label = "2023-01-01"')
    text = (
        text.replace('"tiles/', f'"{tiny}/tiles/')
        .replace('= "control_', f'= "{tiny}/control_')
        .replace('= "targets_', f'= "{tiny}/targets_')
    )
    other = tmp_path / "other.toml"
    other.write_text(text.replace('= "check_', f'= "{tiny}/check_'))
    with pytest.raises(InputError, match="has no epoch 2023-01-01"):
        write_labelled_tiles(read_survey(other), result, tmp_path / "labelled", Feedback())
    assert not (tmp_path / "labelled").exists()


def test_other_tiles_of_the_same_epochs_are_refused(tiny: Path, result: Path, tmp_path: Path):
    survey = read_survey(tiny / "survey.toml")
    first = survey.epochs[0]
    foreign, again = tmp_path / "foreign.laz", tmp_path / first.tiles[0].name
    for copy in (foreign, again):
        copy.write_bytes(first.tiles[0].read_bytes() + b" ")
    for tiles, words in (
        ((foreign, *first.tiles[1:]), f"epoch {first.label}: was not computed from {foreign}. Give the survey.toml this result"),
        ((*first.tiles, again), f"was not computed from {again}"),
    ):
        other = replace(survey, epochs=(replace(first, tiles=tiles), *survey.epochs[1:]))
        for step in (
            lambda: write_labelled_tiles(other, result, tmp_path / "labelled", Feedback()),  # noqa: B023 - called at once
            lambda: index_unit_points(other, result, Feedback()),  # noqa: B023
        ):
            with pytest.raises(InputError, match=re.escape(words)):
                step()
    assert not (tmp_path / "labelled").exists()
    more = tmp_path / "more.gpkg"
    shutil.copy(result, more)
    with closing(sqlite3.connect(more)) as connection, connection:
        added = 'json_insert(settings, \'$.inputs[#]\', json(\'{"name": "b.laz", "sha256": "00"}\'))'
        connection.execute(f"UPDATE epochs SET settings = {added}")  # noqa: S608 - constants
    with pytest.raises(InputError, match=r"was computed from b\.laz too"):
        index_unit_points(survey, more, Feedback())


@pytest.mark.parametrize("ending", [".laz", ".las"])
def test_a_tile_written_anew_is_taken_with_a_warning(tiny: Path, result: Path, tmp_path: Path, ending: str):
    survey, said = read_survey(tiny / "survey.toml"), list[str]()
    first = survey.epochs[0]
    again = tmp_path / f"{first.tiles[0].stem}{ending}"
    cloud = laspy.read(first.tiles[0])
    cloud.add_extra_dim(laspy.ExtraBytesParams(name="reflectance", type="u2"))
    cloud.write(again)
    other = replace(survey, epochs=(replace(first, tiles=(again, *first.tiles[1:])), *survey.epochs[1:]))
    write_labelled_tiles(other, result, tmp_path / "labelled", Feedback(warning=said.append))
    assert [line for line in said if "was written anew" in line] == said
    assert len(said) == 1
