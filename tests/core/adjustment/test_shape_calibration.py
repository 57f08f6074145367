"""Calibration of the shape shared by a survey, and the printed model of the paper."""

from __future__ import annotations

import laspy
import numpy as np
import pytest
from conftest import SHARED
from scipy.spatial.transform import Rotation
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.adjustment.shape_calibration import calibrate
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.trajectory import beam_covariances
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation.segment import segment

NOMINAL = UnitType.tetrapod(2.92)
MOULD = NOMINAL.with_shape(0.776, 0.203)


def units(count: int, rng: np.random.Generator, *, legs: int = 3, spread: float = 0.0) -> tuple[list[np.ndarray], list[Pose]]:
    """Clouds of one mould's units seen from one side, and rough poses."""
    clouds, poses = [], []
    for _ in range(count):
        pose = Pose(rng.normal(size=3), Rotation.random(random_state=rng).as_matrix())
        own = MOULD.with_shape(MOULD.radius * (1 + rng.normal(0, spread)), MOULD.gradient)
        body, _, leg = sample_surface(own, 1500, rng, end_discs=False)
        seen = leg < legs
        clouds.append(pose.to_frame(body[seen] + rng.normal(0, 0.006, (seen.sum(), 3))))
        poses.append(pose.perturbed(rng.normal(0, 0.04, 3), rng.normal(0, 0.02, 3)))
    return clouds, poses


def test_shape_is_recovered_with_its_deviation() -> None:
    rng = np.random.default_rng(1)
    clouds, poses = units(12, rng)
    result = calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())
    assert result.used.sum() >= 11
    assert abs(result.unit.radius - 0.776) < 4 * result.sd[0] < 0.004
    assert abs(result.unit.gradient - 0.203) < 4 * result.sd[1] < 0.004
    assert result.unit.leg_length == NOMINAL.leg_length


@pytest.mark.parametrize("count", [1, 2, 4])
def test_units_calibrated_on_few_are_as_far_off_as_stated(count: int) -> None:
    """Units seen from above, of sizes that scatter: the error of the common shape is in their heights. Held as known, 1.5 to 2."""
    rng = np.random.default_rng(count)
    squares = []
    for _ in range(36 // count):
        clouds, poses = [], []
        for _ in range(count):
            pose = Pose(np.zeros(3), Rotation.random(random_state=rng).as_matrix())
            own = MOULD.with_shape(MOULD.radius * (1 + rng.normal(0, 0.005)), MOULD.gradient)
            body, _, _ = sample_surface(own, 1500, rng, end_discs=False)
            cloud = pose.to_frame(body + rng.normal(0, 0.02, body.shape))
            clouds.append(cloud[cloud[:, 2] > 0.1 * NOMINAL.height])
            poses.append(pose)
        result = calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())
        radius_sd, gradient_sd = result.unit_sds
        for cloud, pose in zip(clouds, poses, strict=True):
            fit = adjust(cloud, result.unit, pose, options=AdjustmentOptions(radius_sd=float(radius_sd), gradient_sd=float(gradient_sd)))
            error = fit.pose.centre - pose.centre
            squares.append(error @ np.linalg.solve(fit.covariance[:3, :3], error) / 3)
    assert np.mean(squares) == pytest.approx(1.0, abs=0.3)


def test_scatter_between_units_is_found() -> None:
    rng = np.random.default_rng(2)
    clouds, poses = units(16, rng, spread=0.01)
    result = calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())
    assert 0.3 < result.between[0] / (0.01 * 0.776) < 2.0


def test_shape_is_sharper_where_the_beams_are_known() -> None:
    """3 cm along the beam and 3 mm across, units seen from the side: eight surveys of six units, half of them with covariances of all."""
    rng = np.random.default_rng(6)
    errors, deviations = np.empty((8, 2)), np.empty((8, 2))
    for k in range(8):
        clouds, poses, covariances = [], [], []
        for _ in range(6):
            pose = Pose(rng.normal(size=3), Rotation.random(random_state=rng).as_matrix())
            body, normals, _ = sample_surface(MOULD, 3000, rng, end_discs=False)
            sensor = pose.centre + np.array([12.0, 0.0, 2.0])
            exact = pose.to_frame(body)
            seen = np.einsum("ij,ij->i", normals @ pose.rotation.T, sensor - exact) > 1.0
            noise = np.linalg.cholesky(beam_covariances(exact[seen], sensor, 0.03, 0.00025))
            clouds.append(exact[seen] + np.einsum("ijk,ik->ij", noise, rng.normal(size=(seen.sum(), 3))))
            poses.append(pose.perturbed(rng.normal(0, 0.04, 3), rng.normal(0, 0.02, 3)))
            covariances.append(beam_covariances(clouds[-1], sensor, 0.03, 0.00025))
        for j, known in enumerate((None, covariances)):
            result = calibrate(clouds, NOMINAL, poses, covariances=known, options=AdjustmentOptions.ideal())
            errors[k, j], deviations[k, j] = result.unit.radius - MOULD.radius, result.sd[0]
    rmse = np.sqrt(np.mean(errors**2, axis=0))
    assert rmse[1] < 0.8 * rmse[0]
    assert rmse[1] < 2.0 * deviations[:, 1].mean()


def test_covariances_of_some_clouds_and_wrong_numbers_of_them() -> None:
    clouds, poses = units(3, np.random.default_rng(8))
    noise = [np.tile(0.006**2 * np.eye(3), (len(clouds[0]), 1, 1)), None, None]
    mixed = calibrate(clouds, NOMINAL, poses, covariances=noise, options=AdjustmentOptions.ideal())
    plain = calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())
    assert mixed.shapes == pytest.approx(plain.shapes, abs=1e-4)
    with pytest.raises(ValueError, match="covariances of 2"):
        calibrate(clouds, NOMINAL, poses, covariances=noise[:2])


def test_a_strange_unit_is_left_out() -> None:
    rng = np.random.default_rng(3)
    clouds, poses = units(10, rng)
    clouds[4] = (clouds[4] - clouds[4].mean(0)) * 1.08 + clouds[4].mean(0)
    result = calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())
    assert not result.used[4]
    assert abs(result.unit.radius - 0.776) < 0.004


def test_single_legs_cannot_calibrate() -> None:
    clouds, poses = units(3, np.random.default_rng(4), legs=1)
    with pytest.raises(InputError, match="calibrate = false"):
        calibrate(clouds, NOMINAL, poses, options=AdjustmentOptions.ideal())


@pytest.mark.shared_data
def test_real_units_give_the_mould_found_by_independent_fits() -> None:
    """Six crops of real units, no survey truth: r0 = 0.776 +- 0.012 m and c = 0.203 +- 0.010 by free fits made elsewhere."""
    clouds, poses = [], []
    for tile in sorted((SHARED / "data" / "real" / "tiles" / "2019").glob("*.la[sz]")):
        cloud = laspy.read(tile)
        points = np.column_stack([cloud.x, cloud.y, cloud.z])
        points -= points.mean(axis=0)
        found = segment(points, NOMINAL)
        if found.units:
            largest = max(range(len(found.units)), key=lambda k: int(np.sum(found.labels == k)))
            clouds.append(points[:: len(points) // 6000])
            poses.append(found.units[largest].pose)
    result = calibrate(clouds, NOMINAL, poses)
    assert result.used.sum() >= 4
    assert result.unit.radius == pytest.approx(0.776, abs=0.012)
    assert result.unit.gradient == pytest.approx(0.203, abs=0.010)
