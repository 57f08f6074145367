"""Inputs held against the cloud, the other epochs and common sense: what cannot be is refused with its likely cause."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from crooked_las import write_survey
from las_files import ORIGIN, grid_points, write_las
from pyproj import Transformer
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.epoch_plans import plan_survey
from tetratrack.core.pipeline.given_survey import Given
from tetratrack.core.pipeline.inspection import inspect_survey
from tetratrack.core.pipeline.new_survey import draft_survey
from tetratrack.core.registration.stable_areas import read_areas

TARGETS = ORIGIN + np.array([[0, 0, 1], [6, 1, 1], [1, 7, 2], [8, 8, 0.0]])


def write_control(folder: Path, surveyed: np.ndarray = TARGETS, seen: np.ndarray = TARGETS, sd: float = 0.003) -> str:
    """Control and targets, and the lines of survey.toml that name them."""
    control = [f"T{k},{e},{n},{h},{sd},{sd},{sd}" for k, (e, n, h) in enumerate(surveyed)]
    targets = [f"T{k},{e},{n},{h}" for k, (e, n, h) in enumerate(seen)]
    (folder / "control.csv").write_text("point_id,easting,northing,height,sd_e,sd_n,sd_h\n" + "\n".join(control) + "\n")
    (folder / "targets.csv").write_text("point_id,x,y,z\n" + "\n".join(targets) + "\n")
    return 'control = "control.csv"\ntargets = "targets.csv"'


def refused(folder: Path, **how: object) -> str:
    """What a run over the tiles of a folder is refused with."""
    with pytest.raises(InputError) as caught:
        plan_survey(read_survey(write_survey(folder, **how)))
    return str(caught.value)


@pytest.fixture
def site(tmp_path: Path) -> Path:
    write_las(tmp_path / "a.laz", grid_points(2000))
    return tmp_path


def test_sound_control_passes(site: Path) -> None:
    plan_survey(read_survey(write_survey(site, more=write_control(site))))


@pytest.mark.parametrize(
    ("change", "cause"),
    [
        (lambda p: p[:, [1, 0, 2]], "Easting and northing seem to be exchanged"),
        (lambda p: p * 1000, "They seem to be in millimetres"),
        (lambda p: p / 0.3048, "They seem to be in feet"),
        (lambda p: np.column_stack(Transformer.from_crs(32650, 32651, always_xy=True).transform(*p.T)), "They seem to be in EPSG:32651"),
        (lambda p: np.column_stack([*Transformer.from_crs(32650, 4326, always_xy=True).transform(*p[:, :2].T), p[:, 2]]), "degrees"),
        (lambda p: p - ORIGIN, "in a local frame"),
        (lambda p: p + np.array([50e6, 0, 0]), "-50000000 m in easting would bring them there"),
        (lambda p: p + np.array([0, 10e6, 0]), "-10000000 m in northing would bring them there"),
        (lambda p: p - np.array([0, 3e6, 0]), "+3000000 m in northing would bring them there"),
        (lambda p: p + np.array([20_000, 0, 0]), "local or shifted frame"),
    ],
)
def test_control_and_targets_in_another_frame(site: Path, change, cause: str) -> None:
    said = refused(site, more=write_control(site, change(TARGETS), change(TARGETS)))
    assert "targets.csv: targets lie" in said
    assert cause in said
    assert "from the nearest point of the epoch's tiles" in said


def test_one_target_far_away_is_named(site: Path) -> None:
    wrong = TARGETS + np.array([[0, 0, 0], [0, 10_000, 0], [0, 0, 0], [0, 0, 0]])
    assert "T1 lies 10 km" in refused(site, more=write_control(site, TARGETS, wrong)).replace("9998 m", "10 km").replace("9997 m", "10 km")


def test_heights_of_targets_in_another_system(site: Path) -> None:
    said = refused(site, more=write_control(site, TARGETS, TARGETS + np.array([0, 0, 600])))
    assert "above the epoch's tiles" in said


def test_a_cloud_in_the_frame_of_its_scanner_is_registered_from_afar(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points(2000, origin=np.array([3.0, 4.0, -2.0])))
    plan_survey(read_survey(write_survey(tmp_path, more=write_control(tmp_path, TARGETS, TARGETS - ORIGIN))))


def test_standard_deviations_in_millimetres(site: Path) -> None:
    said = refused(site, more=write_control(site, sd=3.0))
    assert "control.csv: point T0 has a standard deviation of 3 m" in said
    assert "Then write 0.003" in said


def warned(survey: Path) -> list[str]:
    """What a look at all inputs warns of."""
    return [finding.message for finding in inspect_survey(read_survey(survey), Feedback()) if finding.verdict == "warning"]


def test_standard_deviations_that_are_too_small_or_large(site: Path) -> None:
    said = refused(site, more=write_control(site, sd=3e-9))
    assert "T0 has a standard deviation of 3e-09 m, which no survey reaches" in said
    survey = write_survey(site, more=write_control(site, sd=0.3))
    assert any("control.csv: point T0 has a standard deviation of 0.3 m; is it in centimetres?" in line for line in warned(survey))


@pytest.mark.parametrize(
    ("shift", "told"),
    [
        ((0, 0, 25.0), "lifts the cloud by 25.00 m and leaves it in plan"),
        ((60.0, 80.0, 0.5), "moves the cloud by 100.0 m in plan and 0.5 m up"),
        ((1.0, 1.5, 1.2), ""),
    ],
)
def test_control_that_moves_a_cloud_that_is_in_its_crs(site: Path, shift: tuple[float, ...], told: str) -> None:
    said = warned(write_survey(site, more=write_control(site, TARGETS + np.array(shift), TARGETS)))
    assert [line for line in said if "the cloud by" in line] == ([line for line in said if told in line] if told else [])
    assert bool(told) == any("the cloud by" in line for line in said)


def test_times_of_a_trajectory_and_of_the_tiles(tmp_path: Path) -> None:
    noise = "range_sd = 0.02\nangle_sd = 0.01\n"
    week = 172_800.0
    write_las(tmp_path / "a.laz", grid_points(2000), time=np.linspace(week, week + 100, 2000))

    def flown(first: float, last: float, height: float = 80.0) -> Path:
        rows = [f"{time},{ORIGIN[0]},{ORIGIN[1]},{height}" for time in np.arange(first, last, 0.5)]
        (tmp_path / "flight.csv").write_text("gps_time,x,y,z\n" + "\n".join(rows) + "\n")
        return write_survey(tmp_path, more=f'trajectory = "flight.csv"\n{noise}')

    def ended(survey: Path) -> str:
        with pytest.raises(InputError) as caught:
            plan_survey(read_survey(survey))
        return str(caught.value)

    assert "seem" not in "".join(warned(flown(week - 1, week + 101)))
    assert "points of a.laz were measured before or after" in "".join(warned(flown(week + 20, week + 101)))
    assert "runs below all points" in "".join(warned(flown(week - 1, week + 101, -300.0)))
    # 2000 weeks after the zero of GPS time: counted on, and less 10^9
    assert "The tiles count seconds of the GPS week" in ended(flown(2000 * 604_800 + week - 1, 2000 * 604_800 + week + 101))
    assert "Is it that of another flight?" in ended(flown(week + 200, week + 300))
    write_las(tmp_path / "a.laz", grid_points(2000), time=np.linspace(0, 100, 2000) + 2000 * 604_800 + week - 1e9)
    assert "It counts seconds of the GPS week" in ended(flown(week - 1, week + 101))
    assert "It counts standard GPS time, the tiles do not" in ended(flown(2000 * 604_800 + week - 1, 2000 * 604_800 + week + 101))


def test_stations_of_other_numbers(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points(2000), source=np.repeat([3, 4], 1000))
    survey = write_survey(tmp_path, more='stations = "stations.csv"\nrange_sd = 0.02\nangle_sd = 0.01\n')
    place = ",".join(map(str, ORIGIN))
    (tmp_path / "stations.csv").write_text(f"point_source_id,x,y,z\n1,{place}\n2,{place}\n")
    with pytest.raises(InputError, match="whose point source IDs are 3, 4"):
        plan_survey(read_survey(survey))
    (tmp_path / "stations.csv").write_text(f"point_source_id,x,y,z\n3,{place}\n2,{place}\n")
    assert any("has no station for point source ID 4" in line for line in warned(survey))


def test_an_epoch_of_another_time_or_with_the_tiles_of_another(tmp_path: Path) -> None:
    path = epochs_of(tmp_path, grid_points(6000))
    path.write_text(path.read_text().replace("2024-02", "2204-02"))
    said = warned(path)
    assert any("two.laz: holds the same points in epoch two as one.laz in epoch one" in line for line in said)
    assert any("two: its time, 2204-02-14, lies in the future" in line for line in said)


def test_keys_of_control_hold_for_the_check_too(site: Path) -> None:
    """Northing first, and no standard deviations in the file: read as the run reads it."""
    keys = write_control(site, TARGETS[:, [1, 0, 2]], TARGETS)
    assert "exchanged" in refused(site, more=keys)
    lines = [line.split(",")[:4] for line in (site / "control.csv").read_text().splitlines()]
    (site / "control.csv").write_text("".join(",".join(line) + "\n" for line in lines))
    (site / "check.csv").write_text("point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd\n")
    plan_survey(read_survey(write_survey(site, more=f'{keys}\ncontrol_axes = "ne"\ncontrol_sd = 0.003\ncheck = "check.csv"')))


def test_control_that_cannot_carry_a_registration_is_told_before_the_work(site: Path) -> None:
    keys = write_control(site)
    lines = (site / "control.csv").read_text().splitlines(keepends=True)
    (site / "control.csv").write_text("".join(lines[:3]))
    assert "shares 2 targets with control.csv; a transformation needs 3" in refused(site, more=keys)
    findings = inspect_survey(read_survey(site / "survey.toml"), Feedback())
    assert [(finding.what, finding.name) for finding in findings if finding.verdict == "refused"] == [("targets", "targets.csv")]


def test_trajectory_and_stations_of_another_crs(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points(2000), time=np.arange(2000.0))
    noise = "range_sd = 0.02\nangle_sd = 0.01\n"
    other = np.column_stack(Transformer.from_crs(32650, 32651, always_xy=True).transform(*(ORIGIN + np.array([[0, 0, 80], [9, 0, 80]])).T))
    rows = [f"{time},{e},{n},{h}" for time, (e, n, h) in zip((0, 3000), other, strict=True)]
    (tmp_path / "trajectory.csv").write_text("gps_time,x,y,z\n" + "\n".join(rows) + "\n")
    said = refused(tmp_path, more=f'trajectory = "trajectory.csv"\n{noise}')
    assert "positions of the trajectory lie" in said
    assert "EPSG:32651" in said
    (tmp_path / "stations.csv").write_text(f"point_source_id,x,y,z\n0,{ORIGIN[1]},{ORIGIN[0]},9\n")
    assert "exchanged" in refused(tmp_path, more=f'stations = "stations.csv"\n{noise}')


def test_numbers_that_no_unit_has(site: Path) -> None:
    for height, likely in ((2300, "Then write 2.3"), (0.0023, "height must be a number above 0.01")):
        said = refused(site, height=height)
        assert likely in said
        assert "line 6" in said


def test_a_grid_that_is_no_metre_on_the_ground(site: Path) -> None:
    said = refused(site, crs="EPSG:3857")
    assert 'crs = "EPSG:32650"' in said
    assert "a metre on the ground is 1.17" in said


def test_such_a_grid_is_asked_about_in_a_new_survey(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points(), "EPSG:3857")
    draft = draft_survey([tmp_path], Given(), Feedback(), size=False)
    write_las(tmp_path / "a.laz", grid_points(origin=np.array([13_000_000.0, 3_700_000.0, 2.0])), "EPSG:3857")
    draft = draft_survey([tmp_path], Given(), Feedback(), size=False)
    assert any("a metre on the ground is 1.1" in question and "EPSG:32650" in question for question in draft.questions)


def test_no_grid_is_advised_where_there_is_none(tmp_path: Path) -> None:
    write_las(tmp_path / "a.laz", grid_points(origin=np.array([400_000.0, 3_500_000.0, 2.0])), "EPSG:4549")
    said = refused(tmp_path, crs="EPSG:32651")
    assert 'crs = "EPSG:4549"' in said
    assert "projsync" not in said


def epochs_of(folder: Path, second: np.ndarray, crs: tuple[str, str] = ("EPSG:32650", "EPSG:32650")) -> Path:
    """Two epochs without control."""
    write_las(folder / "one.laz", grid_points(6000), crs[0])
    write_las(folder / "two.laz", second, crs[1])
    text = "".join(
        f'[[epoch]]\nlabel = "{label}"\ntime = 2024-0{k}-14T02:30:00Z\ntiles = "{label}.laz"\n' for k, label in ((1, "one"), (2, "two"))
    )
    return write_survey(folder, epochs=text)


def test_epochs_of_other_heights_are_told_before_the_work(tmp_path: Path) -> None:
    said: list[str] = []
    # cells of 4 m: a cloud of at least three columns of them
    wide = np.vstack([grid_points(2000) + np.array([4.0 * k, 0, 0]) for k in range(4)])
    path = epochs_of(tmp_path, wide + np.array([0, 0, 20.3]), ("EPSG:32650+5773", "EPSG:32650"))
    write_las(tmp_path / "one.laz", wide, "EPSG:32650+5773")
    plan_survey(read_survey(path), Feedback(warning=said.append))
    assert any("height systems differ between tiles (EGM96 height: epoch one; none stated: epoch two)" in line for line in said)
    assert any("the cloud of two as a whole lies 20.3 m higher than that of one" in line for line in said)


def test_epochs_of_two_sites_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"the tiles of epoch two lie 30\.0 km from those of epoch one"):
        plan_survey(read_survey(epochs_of(tmp_path, grid_points(2000) + np.array([30_000.0, 0, 0]))))


def test_an_area_elsewhere_is_told(site: Path) -> None:
    path = write_survey(site)
    corners = [[float(ORIGIN[1] + a), float(ORIGIN[0] + b)] for a, b in ((0, 0), (9, 0), (9, 9))]
    path.write_text(path.read_text().replace("[[epoch]]", f"area = {corners}\n[[epoch]]"))
    said: list[str] = []
    plan_survey(read_survey(path), Feedback(warning=said.append))
    assert "area of unit 1 lie" in said[-1]
    assert "exchanged" in said[-1]


def write_layers(path: Path, *names: str) -> None:
    """GeoPackage with polygon layers."""
    import geopandas
    import shapely

    for name in names:
        frame = geopandas.GeoDataFrame({"a": [1]}, geometry=[shapely.box(*ORIGIN[:2], *(ORIGIN[:2] + 5))], crs="EPSG:32650")
        frame.to_file(path, layer=name, driver="GPKG", engine="pyogrio")


def test_the_first_of_several_layers_is_not_taken_for_granted(site: Path) -> None:
    write_layers(site / "a.gpkg", "site_boundary", "stable")
    path = write_survey(site)
    text = path.read_text()
    path.write_text(text.replace("[unit]", 'stable_areas = "a.gpkg"\n[unit]'))
    with pytest.raises(InputError, match=r"has 2 layers of polygons: site_boundary, stable. Name one: .*a.gpkg\|layername="):
        plan_survey(read_survey(path))
    path.write_text(text.replace("[unit]", 'stable_areas = "a.gpkg|layername=stable"\n[unit]'))
    survey = read_survey(path)
    plan_survey(survey)
    assert (survey.stable_areas.path.name, survey.stable_areas.layer) == ("a.gpkg", "stable")
    assert site / "a.gpkg" in survey.files
    with pytest.raises(InputError, match=r"has no layer 'none'. Its layers are: site_boundary, stable"):
        read_areas(site / "a.gpkg", "EPSG:32650", "none")
    with closing(sqlite3.connect(site / "empty.gpkg")) as connection:
        connection.execute("CREATE TABLE x (a)")
    with pytest.raises(InputError, match="is not a readable polygon layer"):
        read_areas(site / "empty.gpkg", "EPSG:32650")
