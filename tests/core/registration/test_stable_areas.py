"""Epochs tied to each other on stable areas: accuracy and its stated covariance, what is refused, and the way through a whole survey."""

from __future__ import annotations

import math
from collections.abc import Callable
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

import laspy
import numpy as np
import pytest
import shapely
from las_files import write_las
from scipy.spatial.transform import Rotation
from tetratrack.core.common.errors import CrsError, InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import inspect_tile
from tetratrack.core.deformation.common_motion import common_prior
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.epoch_registration import register_epochs
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_register
from tetratrack.core.registration.control import Registration
from tetratrack.core.registration.stable_areas import read_areas, read_stable_points, register_on_areas, surface_of
from tetratrack.core.registration.transformation import Transformation

HEIGHT = 2.3
ORIGIN = np.array([523_170.0, 3_884_600.0, 4.0])
MIDDLE = np.array([8.0, 4.0, 0.0])
LENGTH, SPACING, NOISE = 16.0, 0.1, 0.006
EAST, NORTH, UP = np.eye(3)
DECK = (np.zeros(3), LENGTH * EAST, 5 * NORTH)
PARAPET = (np.array([0, 5, 0.0]), LENGTH * EAST, 1.8 * UP)
ENDS = ((np.array([0, 0, -2.0]), 5 * NORTH, 2 * UP), (np.array([LENGTH, 0, -2.0]), 5 * NORTH, 2 * UP))
CORNERS = [(0, 0), (LENGTH, 0), (LENGTH, 6), (0, 6)]


def waves(rng: np.random.Generator, amplitude: float, longest: float) -> Callable[[np.ndarray], np.ndarray]:
    """A smooth random height with waves between a quarter of ``longest`` and that."""
    numbers = rng.normal(size=(40, 3))
    numbers *= 2 * np.pi / rng.uniform(longest / 4, longest, (40, 1)) / np.linalg.norm(numbers, axis=1, keepdims=True)
    phases = rng.uniform(0, 2 * np.pi, 40)
    return lambda points: amplitude * np.sqrt(2 / 40) * np.cos(points @ numbers.T + phases).sum(axis=1)


def wall(rng: np.random.Generator, faces: tuple = (DECK, PARAPET, *ENDS), drift: float = 0.002, relief: int = 0) -> np.ndarray:
    """(n, 3) points of a crown wall: the relief is the same in all epochs, noise and the slow drift of the sensor are not."""
    shape, sensor = waves(np.random.default_rng(relief), 0.004, 0.8), waves(rng, drift, 3.0)
    parts = []
    for corner, along, across in faces:
        size = np.linalg.norm(along), np.linalg.norm(across)
        where = rng.uniform(size=(int(size[0] * size[1] / SPACING**2), 2, 1))
        points = corner + where[:, 0] * along + where[:, 1] * across
        height = shape(points) + sensor(points) + rng.normal(0, NOISE, len(points))
        parts.append(points + np.cross(along, across) / (size[0] * size[1]) * height[:, None])
    return np.vstack(parts)


def moved(points: np.ndarray, shift: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Points in the frame of a cloud that is shifted and turned about the wall's middle."""
    return Rotation.from_rotvec(turn).apply(points - MIDDLE) + MIDDLE + shift


def errors(seed: int, **options: object) -> tuple[np.ndarray, Transformation]:
    """Error of the registration's six parameters for a cloud that is 5 cm and 1 mrad off, and the transformation."""
    rng = np.random.default_rng(seed)
    shift, turn = rng.normal(0, 0.05, 3), rng.normal(0, 0.001, 3)
    found = register_on_areas(wall(rng, **options), moved(wall(rng, **options), shift, turn), ORIGIN, HEIGHT).transformation
    true = found.origin_to
    placed = found.apply(moved((true - ORIGIN)[None], shift, turn) + ORIGIN)[0]
    return np.append(placed - true, Rotation.from_matrix(found.rotation @ Rotation.from_rotvec(turn).as_matrix()).as_rotvec()), found


@cache
def many() -> tuple[np.ndarray, np.ndarray]:
    """Errors of 16 registrations and their stated covariances."""
    found = [errors(seed) for seed in range(16)]
    return np.array([e for e, _ in found]), np.array([t.covariance[:6, :6] for _, t in found])


def test_clouds_are_brought_together_within_a_few_millimetres() -> None:
    found, _ = many()
    assert np.sqrt(np.mean(found[:, :3] ** 2)) < 0.002
    assert np.sqrt(np.mean(found[:, 3:] ** 2)) < 0.0004


def test_stated_covariance_is_that_of_the_errors() -> None:
    """The mean normalised square error of 16 times 6 parameters is 1, within what chance and two short-sighted estimates allow."""
    found, covariances = many()
    normalised = np.array([e @ np.linalg.solve(c, e) / 6 for e, c in zip(found, covariances, strict=True)])
    assert 0.5 < normalised.mean() < 1.6


def test_correlation_of_neighbours_counts() -> None:
    """A drift of 2 mm over metres adds nothing to the misfit of points with 6 mm of noise, and yet half or more to the error."""
    _, rough = errors(3)
    _, white = errors(3, drift=0.0)
    assert np.sqrt(np.trace(rough.covariance[:3, :3])) > 1.4 * np.sqrt(np.trace(white.covariance[:3, :3]))


def test_level_deck_at_the_side_of_a_voxel_is_not_drawn_to_it() -> None:
    """Cells parallel to a surface would part its points by their noise, and the mean of means would not be the mean."""
    rng = np.random.default_rng(5)
    low, high = wall(rng, relief=1), wall(rng, relief=1)
    found = register_on_areas(low, high + 0.004 * UP, ORIGIN, HEIGHT).transformation
    assert found.apply(MIDDLE[None] + ORIGIN)[0, 2] - ORIGIN[2] == pytest.approx(-0.004, abs=0.0015)


def test_straight_wall_keeps_the_position_of_the_cloud_along_it_and_says_so() -> None:
    rng = np.random.default_rng(8)
    faces = (DECK, PARAPET)
    cloud = moved(wall(rng, faces), np.array([0.05, 0.03, -0.02]), np.zeros(3))
    registration = register_on_areas(wall(rng, faces), cloud, ORIGIN, HEIGHT)
    found = registration.transformation
    error = found.apply(moved(MIDDLE[None], np.array([0.05, 0.03, -0.02]), np.zeros(3)) + ORIGIN)[0] - MIDDLE - ORIGIN
    assert error[0] == pytest.approx(0.05, abs=0.003)
    assert np.abs(error[1:]).max() < 0.003
    sds = np.sqrt(np.diag(found.covariance_at(MIDDLE + ORIGIN))[:3])
    assert sds[0] == pytest.approx(HEIGHT / 2, rel=0.01)
    assert sds[1:].max() < 0.003
    assert any("azimuth 90 degrees" in note for note in registration.notes)


@pytest.mark.parametrize(
    ("other", "problem"),
    [
        (lambda rng: wall(rng, (DECK,)), "leave 3 of six shifts and turns undetermined"),
        (lambda rng: wall(rng) + 40 * UP, "only 0 % of the points inside the areas lie on the surface"),
        (lambda rng: wall(rng)[:150], "only 150 points of this epoch lie inside"),
        (lambda rng: wall(rng, drift=0.15), "differ by|lie on the surface"),
    ],
)
def test_what_cannot_tie_an_epoch_is_refused(other: Callable[[np.random.Generator], np.ndarray], problem: str) -> None:
    rng = np.random.default_rng(4)
    reference = wall(rng, (DECK,)) if "undetermined" in problem else wall(rng)
    with pytest.raises(InputError, match=problem) as caught:
        register_on_areas(reference, other(rng), ORIGIN, HEIGHT)
    assert caught.value.remedy


def test_what_changed_on_a_part_of_the_areas_does_not_matter() -> None:
    """A tenth of the deck raised by 6 cm, as by a mat or debris."""
    rng = np.random.default_rng(12)
    before, after = wall(rng), wall(rng)
    covered = (np.abs(after[:, 2]) < 0.05) & (after[:, 0] < 2)
    after[covered, 2] += 0.06
    found = register_on_areas(before, after, ORIGIN, HEIGHT).transformation
    assert np.linalg.norm(found.apply(MIDDLE[None] + ORIGIN)[0] - MIDDLE - ORIGIN) < 0.003


def test_edges_have_no_tangent_plane() -> None:
    rng = np.random.default_rng(2)
    points = wall(rng, (DECK, PARAPET), drift=0.0)
    surface = surface_of(points)
    edge = np.hypot(points[:, 1] - 5, points[:, 2]) < 0.15
    assert surface.flat[~edge].mean() > 0.95
    assert surface.flat[edge].mean() < 0.6


def write_areas(path: Path, crs: str | None, polygon: shapely.Geometry) -> Path:
    import geopandas

    geopandas.GeoDataFrame(geometry=[polygon], crs=crs).to_file(path)
    return path


@pytest.mark.parametrize("name", ["areas.gpkg", "areas.geojson", "areas.shp"])
def test_areas_in_another_crs_come_into_the_surveys(tmp_path: Path, name: str) -> None:
    from pyproj import Transformer

    polygon = shapely.Polygon(np.array(CORNERS) + ORIGIN[:2])
    to_other = Transformer.from_crs("EPSG:32652", "EPSG:32651", always_xy=True)
    other = shapely.transform(polygon, lambda xy: np.column_stack(to_other.transform(xy[:, 0], xy[:, 1])))
    path = write_areas(tmp_path / name, "EPSG:32651", other)
    found = read_areas(path, "EPSG:32652")
    # GeoJSON is written in its own CRS with seven decimals of a degree or better
    assert shapely.hausdorff_distance(found, polygon) < 0.02
    assert read_areas(write_areas(tmp_path / f"own_{name}", "EPSG:32652", polygon), "EPSG:32652").equals_exact(
        polygon, 1e-6, normalize=True
    )


def test_layers_without_crs_or_polygons_are_refused(tmp_path: Path) -> None:
    polygon = shapely.Polygon(CORNERS)
    with pytest.warns(UserWarning, match="'crs' was not provided"):
        bare = write_areas(tmp_path / "bare.gpkg", None, polygon)
    assert shapely.area(read_areas(bare, "LOCAL")) == pytest.approx(6 * LENGTH)
    with pytest.raises(CrsError, match="has no CRS"):
        read_areas(bare, "EPSG:32652")
    with pytest.raises(InputError, match="holds no polygon"):
        read_areas(write_areas(tmp_path / "points.gpkg", "EPSG:32652", shapely.Point(1, 2)), "EPSG:32652")
    (tmp_path / "text.gpkg").write_text("no layer")
    with pytest.raises(InputError, match="not a readable polygon layer"):
        read_areas(tmp_path / "text.gpkg", "EPSG:32652")


def test_points_are_read_inside_the_areas_only_and_once_however_tiled(tmp_path: Path) -> None:
    points = wall(np.random.default_rng(1)) + ORIGIN
    west = points[:, 0] < ORIGIN[0] + 7
    tiles = [
        inspect_tile(write_las(tmp_path / name, part, "EPSG:32652"), "EPSG:32652")
        for name, part in (("a.laz", points[west]), ("b.laz", points[~west]), ("far.laz", points + 500 * EAST))
    ]
    areas = shapely.Polygon(np.array([(4, 1), (10, 1), (10, 4), (4, 4)]) + ORIGIN[:2])
    found = read_stable_points(tiles, "EPSG:32652", areas, ORIGIN, 0.07)
    assert found[:, :2].min(axis=0) == pytest.approx([4, 1], abs=0.1)
    assert found[:, :2].max(axis=0) == pytest.approx([10, 4], abs=0.1)
    assert 0.3 * 18 / 0.07**2 < len(found) < 18 / SPACING**2 * 1.1


@pytest.fixture
def site(tmp_path: Path) -> Path:
    """Three epochs of a wall; the first and the third are off by 3 cm and 2 cm; targets in the first only."""
    shifts = ([0.03, 0.0, -0.01], [0.0, -0.02, 0.02], [0.01, 0.01, -0.02])
    targets = np.array([[1, 1, 0], [15, 1, 0], [15, 5, 1.8], [1, 5, 1.8], [8, 2, 0]], dtype=float)
    lines = [
        "[survey]",
        'name = "wall"',
        'crs = "EPSG:32652"',
        'stable_areas = "areas.gpkg"',
        "[unit]",
        'type = "tetrapod"',
        "height = 2.3",
    ]
    for k, shift in enumerate(shifts):
        rng = np.random.default_rng(20 + k)
        write_las(tmp_path / f"{k}.laz", wall(rng) + shift + ORIGIN, "EPSG:32652")
        lines += ["[[epoch]]", f'label = "{k}"', f"time = 202{k}-01-01T00:00:00Z", f'tiles = "{k}.laz"']
        if k == 0:
            lines += ['control = "control.csv"', 'targets = "targets.csv"']
            for name, points, head, tail in (
                ("control", targets, "point_id,easting,northing,height,sd_e,sd_n,sd_h", ",0.003,0.003,0.003"),
                ("targets", targets + shift, "point_id,x,y,z", ""),
            ):
                rows = [f"T{j}," + ",".join(f"{v:.4f}" for v in p + ORIGIN) + tail for j, p in enumerate(points)]
                (tmp_path / f"{name}.csv").write_text("\n".join([head, *rows]) + "\n")
    write_areas(tmp_path / "areas.gpkg", "EPSG:32652", shapely.Polygon(np.array(CORNERS) + ORIGIN[:2]).buffer(0.5))
    path = tmp_path / "survey.toml"
    path.write_text("\n".join(lines) + "\n")
    return path


def registered(path: Path) -> dict[str, Registration]:
    survey = read_survey(path)
    return register_epochs(survey, plan_survey(survey), Feedback())


def test_survey_without_later_targets_is_registered_to_the_epoch_with_control(site: Path) -> None:
    found = registered(site)
    assert [found[label].reference for label in "012"] == [None, "0", "0"]
    for label, shift in zip("012", ([0.03, 0.0, -0.01], [0.0, -0.02, 0.02], [0.01, 0.01, -0.02]), strict=True):
        placed = found[label].transformation.apply(MIDDLE[None] + shift + ORIGIN)[0]
        assert placed == pytest.approx(MIDDLE + ORIGIN, abs=0.004)
    # what is tied to an epoch is never more certain than that epoch
    first = found["0"].transformation.covariance_at(MIDDLE + ORIGIN)
    later = found["1"].transformation.covariance_at(MIDDLE + ORIGIN)
    assert np.linalg.eigvalsh(later - first)[1:].min() > 0


def test_error_of_the_reference_epoch_drops_out_of_differences(site: Path) -> None:
    found = registered(site)
    start = datetime(2020, 1, 1, tzinfo=UTC)
    epochs = [
        TrackedEpoch(label=k, time=start, units=(), registration=found[k].transformation, redundancy=0, tied_to=None if k == "0" else 0)
        for k in "012"
    ]
    place = MIDDLE + ORIGIN
    own = [e.registration.covariance_at(place) for e in epochs if e.registration is not None]
    to_reference = common_prior(epochs, 0, 1, place)
    between = common_prior(epochs, 1, 2, place)
    assert to_reference is not None
    assert between is not None
    assert np.allclose(to_reference, own[1] - own[0], atol=1e-12)
    assert np.allclose(between, own[1] + own[2] - 2 * own[0], atol=1e-12)


def test_first_epochs_own_frame_is_the_datum_where_nobody_has_control(site: Path) -> None:
    lines = [line for line in site.read_text().splitlines() if not line.startswith(("control", "targets"))]
    site.write_text("\n".join(lines))
    found = registered(site)
    assert [found[label].reference for label in "012"] == [None, "0", "0"]
    assert np.allclose(found["0"].transformation.apply(ORIGIN[None]), ORIGIN)
    placed = found["1"].transformation.apply(MIDDLE[None] + [0.0, -0.02, 0.02] + ORIGIN)[0]
    assert placed == pytest.approx(MIDDLE + ORIGIN + [0.03, 0, -0.01], abs=0.004)


def test_step_register_states_the_datum_of_every_epoch(site: Path, tmp_path: Path) -> None:
    from tetratrack.core.results.geopackage_reader import read_layer_rows

    said: list[str] = []
    summary = run_register(read_survey(site), tmp_path / "registration.gpkg", RunOptions(workers=1), Feedback(info=said.append))
    assert summary["rmse"] < 0.003
    rows = {row["label"]: row for row in read_layer_rows(tmp_path / "registration.gpkg", "epochs")}
    assert [rows[k]["datum"] for k in "012"] == ["control", "stable areas", "stable areas"]
    assert [rows[k]["reference_epoch"] for k in "012"] == [None, "0", "0"]
    assert '"stable_areas": {"name": "areas.gpkg"' in rows["1"]["settings"]
    assert any(line.startswith("1: ") and "on the reference surface" in line for line in said)


def test_areas_beside_the_cloud_name_file_and_epoch(site: Path) -> None:
    write_areas(site.parent / "areas.gpkg", "EPSG:32652", shapely.box(0, 0, 5, 5))
    with pytest.raises(InputError, match=r"areas.gpkg, epoch 1: only 0 points of the reference epoch lie inside the areas"):
        registered(site)


def test_crops_of_real_points_are_read_as_they_are(site: Path) -> None:
    """The tile's own scale and offset survive: what is inside is what laspy reads there."""
    tile = inspect_tile(site.parent / "0.laz", "EPSG:32652")
    las = laspy.read(site.parent / "0.laz")
    areas = shapely.box(ORIGIN[0] + 2, ORIGIN[1] + 1, ORIGIN[0] + 4, ORIGIN[1] + 3)
    inside = (np.abs(las.x - ORIGIN[0] - 3) <= 1) & (np.abs(las.y - ORIGIN[1] - 2) <= 1)
    found = read_stable_points([tile], "EPSG:32652", areas, ORIGIN, 1e-3)
    assert math.isclose(found[:, 2].mean(), (np.array(las.z)[inside] - ORIGIN[2]).mean(), abs_tol=1e-4)
