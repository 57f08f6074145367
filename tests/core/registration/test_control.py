"""Registration to control: estimates, their covariance, snooping, other CRS and units, and every mistake a CSV can hold."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.stats import chi2, kstest
from tetratrack.core.common.errors import CrsError, InputError
from tetratrack.core.common.registration_records import mean_offset_variance
from tetratrack.core.data.point_tables import CONTROL_COLUMNS, SurveyedPoints, read_control, read_targets
from tetratrack.core.data.survey import Epoch
from tetratrack.core.model.pose import Pose
from tetratrack.core.registration import control as module
from tetratrack.core.registration.survey_frame import METRES_PER, grid_scale, to_survey_frame
from tetratrack.core.registration.surveyed_epochs import control_of
from tetratrack.core.registration.transformation import Transformation
from tetratrack.core.registration.weighted_transformation import weighted_fit

CENTRE = np.array([523_170.0, 3_884_615.0, 7.5])
NETWORK = np.array(
    [[-8, -6, 0.4], [-4, -3, 0.4], [0, 0, 0.4], [4, 3, 0.4], [9, 7, 0.4], [-3, -9, -0.6], [3, -4, -0.6], [8, -1, -0.6]], dtype=np.float64
)
SHIFT = np.array([0.031, -0.022, 0.017])
TURN = np.radians([0.02, -0.015, 0.03])


def network(
    rng: np.random.Generator, sd: float = 0.005, scale: float = 1.0, truth: np.ndarray = NETWORK
) -> tuple[SurveyedPoints, SurveyedPoints]:
    """Control and targets whose true transformation is SHIFT and TURN about CENTRE, each coordinate with half the variance."""
    names = tuple(f"T{k + 1:02d}" for k in range(len(truth)))
    turn = Rotation.from_rotvec(TURN).as_matrix()
    part = sd / np.sqrt(2)
    cloud = truth + rng.normal(0, part, truth.shape) + CENTRE
    surveyed = scale * truth @ turn.T + SHIFT + rng.normal(0, part, truth.shape) + CENTRE
    sds = np.full(truth.shape, part)
    return SurveyedPoints(names, surveyed, sds), SurveyedPoints(names, cloud, sds)


def write(path: Path, header: str, rows: list[str]) -> Path:
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    return path


def write_network(folder: Path, surveyed: np.ndarray, measured: np.ndarray, names: list[str] | None = None) -> tuple[Path, Path]:
    names = names or [f"T{k + 1:02d}" for k in range(len(surveyed))]
    one = write(
        folder / "control.csv",
        ",".join(CONTROL_COLUMNS),
        [f"{n},{','.join(f'{v:.4f}' for v in p)},.003,.003,.003" for n, p in zip(names, surveyed)],
    )
    other = write(folder / "targets.csv", "point_id,x,y,z", [f"{n},{','.join(f'{v:.4f}' for v in p)}" for n, p in zip(names, measured)])
    return one, other


def test_transformation_without_noise_is_recovered_and_inverted() -> None:
    control, targets = network(np.random.default_rng(0), sd=1e-9)
    found = module.register(control, targets).transformation
    turn = Rotation.from_rotvec(TURN).as_matrix()
    points = np.random.default_rng(1).normal(0, 30, (20, 3))
    assert np.allclose(found.apply(points + CENTRE), points @ turn.T + SHIFT + CENTRE, atol=1e-6)
    assert np.allclose(found.invert(found.apply(points + CENTRE)), points + CENTRE, atol=1e-8)
    again = Transformation.from_record(found.as_record())
    assert np.allclose(again.apply(points + CENTRE), found.apply(points + CENTRE), atol=1e-9)


def test_covariance_of_a_pose_follows_the_seven_parameters() -> None:
    rng = np.random.default_rng(4)
    turn = Rotation.from_rotvec([0.4, -0.2, 1.1]).as_matrix()
    root = rng.normal(size=(7, 7))
    given = Transformation(
        origin_from=np.zeros(3), origin_to=CENTRE, translation=np.zeros(3), rotation=turn, scale=1.0, covariance=1e-6 * root @ root.T
    )
    pose = Pose(np.array([12.0, -7.0, 3.0]), Rotation.from_rotvec([0.3, 0.9, -0.5]).as_matrix())
    placed = given.apply_pose(pose)
    effect, step = np.empty((6, 7)), 1e-6
    for k, change in enumerate(step * np.eye(7)):
        moved = replace(given.with_shift(change[:3], change[3:6], given.covariance), scale=1 + change[6]).apply_pose(pose)
        turned = Rotation.from_matrix(moved.rotation @ placed.rotation.T).as_rotvec()
        effect[:, k] = np.append(moved.centre - placed.centre, turned) / step
    np.testing.assert_allclose(given.pose_covariance(placed), effect @ given.covariance @ effect.T, rtol=1e-3, atol=1e-8)
    more = given.with_offset(np.array([0.01, 0.02, 0.03])).pose_covariance(placed) - given.pose_covariance(placed)
    np.testing.assert_allclose(more, np.diag([0.01, 0.02, 0.03, 0.0, 0.0, 0.0]), atol=1e-9)


def test_variance_of_a_mean_offset() -> None:
    """Of strips whose offsets are known against their mean only, as the joint adjustment gives them."""
    offsets = np.random.default_rng(6).normal(0, 0.02, (2000, 5, 3))
    means = offsets.mean(axis=1, keepdims=True)
    stated = [mean_offset_variance(own) for own in offsets - means]
    assert np.mean(stated) == pytest.approx(means.var(), rel=0.08)
    assert mean_offset_variance(np.ones((1, 3))) == mean_offset_variance([]) == 0


def test_similarity_recovers_the_scale() -> None:
    control, targets = network(np.random.default_rng(0), sd=1e-7, scale=1.0004)
    assert module.register(control, targets, similarity=True).transformation.scale == pytest.approx(1.0004, abs=1e-6)
    assert module.register(control, targets).transformation.scale == 1


def test_covariance_describes_the_errors_at_the_toe() -> None:
    """Quadratic forms of the error of a point 15 m from the wall follow chi-square of three degrees."""
    toe = np.array([[2.0, 15.0, -6.0]])
    turn = Rotation.from_rotvec(TURN).as_matrix()
    forms = []
    for seed in range(250):
        control, targets = network(np.random.default_rng(seed))
        fit = weighted_fit(
            control.coordinates, targets.coordinates, control.sds**2 + targets.sds**2, np.ones(len(NETWORK), dtype=bool), False
        ).transformation
        error = fit.apply(toe + CENTRE) - (toe @ turn.T + SHIFT + CENTRE)
        jacobian = fit.jacobian(fit.apply(toe + CENTRE))[0][:, :6]
        forms.append(float(error[0] @ np.linalg.solve(jacobian @ fit.covariance[:6, :6] @ jacobian.T, error[0])))
    assert kstest(forms, chi2(3).cdf).pvalue > 0.01


def test_good_targets_are_kept_and_a_disturbed_one_is_excluded() -> None:
    excluded_good, missed, wrong = 0, 0, 0
    for seed in range(100):
        control, targets = network(np.random.default_rng(seed))
        excluded_good += bool(module.register(control, targets).excluded)
        direction = np.random.default_rng(1000 + seed).normal(size=3)
        disturbed = targets.coordinates.copy()
        victim = seed % len(NETWORK)
        disturbed[victim] += 0.05 * direction / np.linalg.norm(direction)
        found = module.register(control, SurveyedPoints(targets.ids, disturbed, targets.sds))
        missed += targets.ids[victim] not in found.excluded
        wrong += any(name != targets.ids[victim] for name in found.excluded)
    # level 1 % for the whole network: 100 runs give 5 or more exclusions with a probability below 0.4 %
    assert excluded_good <= 4
    # ten standard deviations exceed the minimal detectable bias of every target (power 80 %) by about a half
    assert missed <= 2
    assert wrong <= 4


def test_effect_of_an_excluded_target_is_stated_at_the_units() -> None:
    control, targets = network(np.random.default_rng(3), sd=0.001)
    disturbed = targets.coordinates.copy()
    disturbed[2] += [0.04, 0, 0]
    spoiled = SurveyedPoints(targets.ids, disturbed, targets.sds)
    found = module.register(control, spoiled, reference=CENTRE[None])
    assert found.excluded == ("T03",)
    # one of eight targets 4 cm off shifts the middle of the network by about an eighth of that
    assert found.exclusion_effect == pytest.approx(0.005, abs=0.003)
    row = next(r for r in found.residuals if r.point_id == "T03")
    assert not row.used
    assert row.outlier
    assert row.w_max > 10
    assert np.linalg.norm(row.residual) == pytest.approx(0.04, abs=0.003)
    assert any("T03" in note and "mm" in note for note in found.notes)


def test_three_targets_register_without_a_check() -> None:
    control, targets = network(np.random.default_rng(4), truth=NETWORK[[0, 4, 5]])
    found = module.register(control, targets)
    assert found.redundancy == 3
    assert not found.excluded


def test_two_disturbed_targets_of_eight_are_both_excluded() -> None:
    control, targets = network(np.random.default_rng(5))
    disturbed = targets.coordinates.copy()
    disturbed[1] += [0.08, 0, 0]
    disturbed[6] += [0, -0.07, 0.02]
    assert set(module.register(control, SurveyedPoints(targets.ids, disturbed, targets.sds)).excluded) == {"T02", "T07"}


@pytest.mark.parametrize(
    ("order", "words"), [((1, 0, 2), "easting holds northing"), ((0, 2, 1), "northing holds height"), ((2, 0, 1), "exchanged")]
)
def test_exchanged_columns_are_named(tmp_path: Path, order: tuple[int, ...], words: str) -> None:
    paths = write_network(tmp_path, (NETWORK + CENTRE)[:, order], NETWORK + CENTRE)
    with pytest.raises(InputError, match=words) as caught:
        module.register(read_control(paths[0]), read_targets(paths[1]))
    assert "control.csv" in str(caught.value)
    assert caught.value.remedy


def test_heights_with_the_wrong_sign_are_reported(tmp_path: Path) -> None:
    """Targets on two levels lie nearly in a plane, so that a tilt of the cloud can mimic the wrong sign: the tilt is named."""
    paths = write_network(tmp_path, (NETWORK + CENTRE) * [1, 1, -1], NETWORK + CENTRE)
    found = module.register(read_control(paths[0]), read_targets(paths[1]))
    assert any("vertical" in note and "sign of heights" in note for note in found.notes)


def test_control_that_does_not_fit_is_refused(tmp_path: Path) -> None:
    scattered = np.random.default_rng(0).normal(0, 10, NETWORK.shape)
    paths = write_network(tmp_path, scattered + CENTRE, NETWORK + CENTRE)
    with pytest.raises(InputError, match=r"does not fit targets\.csv"):
        module.register(read_control(paths[0]), read_targets(paths[1]))


def test_fewer_than_three_common_targets(tmp_path: Path) -> None:
    one, other = write_network(tmp_path, NETWORK + CENTRE, NETWORK + CENTRE)
    other.write_text(other.read_text().replace("T0", "P0", 6), encoding="utf-8")
    with pytest.raises(InputError, match=r"shares 2 targets with control\.csv; a transformation needs 3"):
        module.register(read_control(one), read_targets(other))


def test_collinear_targets(tmp_path: Path) -> None:
    line = np.outer(np.arange(5.0), [3.0, 1.0, 0.1])
    paths = write_network(tmp_path, line + CENTRE, line + CENTRE)
    with pytest.raises(InputError, match="lie on one line"):
        module.register(read_control(paths[0]), read_targets(paths[1]))


CONTROL_HEADER = "point_id,easting,northing,height,sd_e,sd_n,sd_h"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no column point_id"),
        (CONTROL_HEADER, "holds no points"),
        (CONTROL_HEADER.replace("northing", "depth") + "\nT1,1,2,3,.1,.1,.1", "line 1: has no column northing"),
        (CONTROL_HEADER + ",easting\nT1,1,2,3,.1,.1,.1,1", "column easting twice"),
        (CONTROL_HEADER + "\nT1,1,2,3,.1,.1", "line 2: has 6 fields, the header 7"),
        (CONTROL_HEADER + "\nT1,1,two,3,.1,.1,.1", "line 2, field northing: 'two' is not a number"),
        (CONTROL_HEADER + "\nT1,1,nan,3,.1,.1,.1", "line 2, field northing: nan is not finite"),
        (CONTROL_HEADER + "\nT1,1,2,3,.1,0,.1", "line 2, field sd_n: standard deviation 0 is not positive"),
        (CONTROL_HEADER + "\n,1,2,3,.1,.1,.1", "line 2, field point_id: has an empty name"),
        (
            CONTROL_HEADER + "\nT1,1,2,3,.1,.1,.1\n\nT1,1,2,3,.1,.1,.1",
            r"line 4, field point_id: names point 'T1' again \(first in line 2\)",
        ),
    ],
)
def test_mistakes_in_the_file_are_placed(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "control.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words) as caught:
        read_control(path)
    assert str(path) in str(caught.value)
    assert caught.value.remedy


@pytest.mark.parametrize("value", ["9" * 400, "-" + "1" * 400, "x" * 400, "7" * 200])
def test_a_long_field_is_told_in_one_sentence(tmp_path: Path, value: str) -> None:
    for fields in (f"{value},2,3,.1,.1,.1", f"1,2,3,.1,{value},.1"):
        path = tmp_path / "control.csv"
        path.write_text(f"{CONTROL_HEADER}\nT1,{fields}\n", encoding="utf-8")
        with pytest.raises(InputError, match="line 2, field") as caught:
            read_control(path)
        assert len(str(caught.value)) < 200 + len(str(path))


@pytest.mark.parametrize("blank", [0, 1, 2])
def test_a_target_without_its_standard_deviation_is_named(tmp_path: Path, blank: int) -> None:
    lines = [f"T{k},{k},2,3,{'' if k == blank else 0.002}" for k in range(3)]
    path = tmp_path / "targets.csv"
    path.write_text("\n".join(["point_id,x,y,z,sd", *lines]), encoding="utf-8")
    with pytest.raises(InputError, match=f"line {blank + 2}, field sd: has no standard deviation"):
        read_targets(path)
    path.write_text("point_id,x,y,z,sd\nT1,1,2,3,\nT2,2,2,3,\n", encoding="utf-8")
    assert not read_targets(path).sds.any()


HEADER_IN = "point_id,easting [{0}],northing [{0}],height [{1}],sd_e [{2}],sd_n [{2}],sd_h [{2}]\nT1,1,2,3,.1,.1,.1\n"


@pytest.mark.parametrize(
    ("units", "unit", "crs", "words"),
    [
        (("m", "m", "ft"), "m", None, r"states sd_e \[ft\].*control_unit = \"ft\""),
        (("ft", "ft", "m"), "ft", None, r"states sd_e \[m\]"),
        (("m", "US ft", "m"), "m", None, r"states height \[us ft\]"),
        (("m", "m", "mm"), "m", None, "0.003 for 3 mm"),
        (("ft", "ft", "ft"), "m", "EPSG:32651", r"states easting \[ft\]"),
        (("ft", "ft", "cm"), "ft", "EPSG:2263", r"states sd_e \[cm\]"),
        (("ft", "ft", "ft"), "us-ft", None, ""),
        (("ft", "m", "ft"), "m", "EPSG:2263", ""),
        (("UTM 50N", "DHHN2016", "m"), "m", None, ""),
    ],
)
def test_units_in_the_header_must_be_those_of_the_survey(
    tmp_path: Path, units: tuple[str, ...], unit: Literal["m", "ft", "us-ft"], crs: str | None, words: str
) -> None:
    path = tmp_path / "control.csv"
    path.write_text(HEADER_IN.format(*units), encoding="utf-8")
    epoch = Epoch(label="a", time=datetime(2025, 1, 1, tzinfo=UTC), tiles=(), control=path, control_unit=unit, control_crs=crs)
    with pytest.raises(InputError, match=words) if words else nullcontext():
        control_of(epoch, path)


def test_targets_are_in_metres(tmp_path: Path) -> None:
    path = tmp_path / "targets.csv"
    path.write_text("point_id,x [ft],y [ft],z [ft]\nT1,1,2,3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"line 1: states x \[ft\]. Give metres"):
        read_targets(path)


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_control(tmp_path / "no.csv")


def points_at(coordinates: np.ndarray) -> SurveyedPoints:
    return SurveyedPoints(tuple(f"T{k}" for k in range(len(coordinates))), coordinates, np.full(coordinates.shape, 0.003))


def test_control_in_feet_gives_the_same() -> None:
    metres = NETWORK + CENTRE
    for unit, factor in METRES_PER.items():
        found = to_survey_frame(points_at(metres / factor), None, "EPSG:32652", unit)
        assert np.abs(found.coordinates - metres).max() < 1e-6
        assert found.sds[0, 0] == pytest.approx(0.003 * factor)


def test_control_in_another_projected_crs_gives_the_same_registration() -> None:
    """Metric zone 52 into its neighbour zone, and a CRS in US feet: registered, units lie within 1 mm of the direct result."""
    import pyproj

    control, targets = network(np.random.default_rng(7))
    direct = module.register(control, targets).transformation.apply(CENTRE[None] + [3, 12, -6])
    for code in ("EPSG:32651", "+proj=tmerc +lon_0=129 +lat_0=38 +k=1 +x_0=200000 +y_0=600000 +datum=WGS84 +units=us-ft +type=crs"):
        there = pyproj.Transformer.from_crs("EPSG:32652", code, always_xy=True)
        e, n = there.transform(control.coordinates[:, 0], control.coordinates[:, 1])
        unit = pyproj.CRS(code).axis_info[0].unit_conversion_factor
        foreign = SurveyedPoints(control.ids, np.column_stack([e, n, control.coordinates[:, 2]]), control.sds / [unit, unit, 1])
        back = to_survey_frame(foreign, code, "EPSG:32652")
        found = module.register(back, targets).transformation.apply(CENTRE[None] + [3, 12, -6])
        assert np.abs(found - direct).max() < 1e-3


@pytest.mark.parametrize(
    ("crs", "survey_crs", "words"),
    [
        ("EPSG:4326", "EPSG:32652", "not projected"),
        ("EPSG:999999", "EPSG:32652", "not known"),
        ("EPSG:32652", "LOCAL", "local frame"),
        ("EPSG:32652+5773", "EPSG:32652", "has no height system"),
        ("EPSG:32652+5773", "EPSG:32652+5703", "grid|no transformation is known|cannot be transformed"),
    ],
)
def test_control_crs_that_cannot_be_used(crs: str, survey_crs: str, words: str) -> None:
    with pytest.raises(CrsError, match=words):
        to_survey_frame(points_at(NETWORK + CENTRE), crs, survey_crs)


def test_grid_scale_of_a_utm_zone() -> None:
    # on the central meridian the UTM scale is 0.9996; 637 m up reduce it by 1e-4
    assert grid_scale("EPSG:32652", [500_000, 3_884_615, 0]) == pytest.approx(0.9996, abs=1e-6)
    assert grid_scale("EPSG:32652", [500_000, 3_884_615, 637.1]) == pytest.approx(0.9996 * (1 - 1e-4), abs=1e-6)


@pytest.mark.shared_data
@pytest.mark.parametrize(
    ("site", "epoch", "disturbed"), [("uav", "2024-04-09", ()), ("uav", "2024-10-24", ("T03",)), ("tls_quay", "2025-09-30", ())]
)
def test_sample_surveys(shared_data: Path, site: str, epoch: str, disturbed: tuple[str, ...]) -> None:
    folder = shared_data / site
    found = module.register(read_control(folder / f"control_{epoch}.csv"), read_targets(folder / f"targets_{epoch}.csv"))
    assert found.excluded == disturbed


def test_targets_of_one_row_never_condemn_the_others() -> None:
    """Five targets on a parapet agree whatever the rotation about it; taking them alone once turned a cloud by 24 degrees."""
    row = np.array([[x, 6.0, 1.0] for x in (-7, -3.5, -0.5, 2.5, 7)])
    layout = np.vstack([row, [[-6, 1, 0.2], [0.5, 1, 0.2], [5, 1, 0.2]]])
    for seed in range(25):
        # noise is twice what the file states
        control, targets = network(np.random.default_rng(seed), sd=0.014, truth=layout)
        stated = SurveyedPoints(control.ids, control.coordinates, np.full(layout.shape, 0.003))
        found = module.register(stated, SurveyedPoints(targets.ids, targets.coordinates, np.zeros(layout.shape)))
        assert any(r.used for r in found.residuals[5:])
        turn = found.transformation.rotation @ Rotation.from_rotvec(TURN).as_matrix().T
        assert Rotation.from_matrix(turn).magnitude() < 0.02


@pytest.mark.parametrize(("count", "apart", "off", "sd"), [(20, 1.0, 0.02, 0.007), (8, 6.0, 0.05, 0.018)])
def test_a_row_of_targets_is_enough_off_one_line_though_no_three_of_them_are(count: int, apart: float, off: float, sd: float) -> None:
    layout = np.array([[apart * k, off * (-1) ** k, 0.0] for k in range(count)])
    names = tuple(f"T{k:02d}" for k in range(count))
    control = SurveyedPoints(names, layout, np.full(layout.shape, sd / np.sqrt(2)))
    found = module.register(control, control)
    assert all(r.used for r in found.residuals)
    assert np.abs(found.transformation.translation).max() < 1e-9


def test_residuals_of_other_epochs_sharpen_the_test() -> None:
    """A target 9 sd off in one coordinate, among noise larger than stated: found more often with the residuals of three other epochs."""
    alone, together = 0, 0
    for seed in range(20):
        rng = np.random.default_rng(seed)
        pairs = []
        for k in range(4):
            control, targets = network(rng, sd=0.006)
            measured = targets.coordinates.copy()
            if k == 3:
                measured[2, 0] += 0.032
            pairs.append(
                (
                    SurveyedPoints(control.ids, control.coordinates, np.full(NETWORK.shape, 0.003)),
                    SurveyedPoints(targets.ids, measured, np.zeros(NETWORK.shape)),
                )
            )
        others = [module.register(*pair) for pair in pairs[:3]]
        alone += module.register(*pairs[3]).excluded == ("T03",)
        together += module.register(*pairs[3], others=others).excluded == ("T03",)
    assert together > alone
    assert together >= 15
