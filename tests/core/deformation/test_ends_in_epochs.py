"""Ends of legs that a single epoch missed, and poses that it did: found where other epochs have them, and used from there."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT, grid_poses, seen_from_above
from tetratrack.core.common.arrays import FloatArray
from tetratrack.core.deformation.ends_in_epochs import ends_shown, way_to_ends
from tetratrack.core.deformation.joint_records import UnitSighting
from tetratrack.core.deformation.strip_observations import Body
from tetratrack.core.deformation.strip_offsets import adjust_jointly
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import leg_frame, relate, sample_surface

NOISE, LEG = 0.006, 2
NO_DISCS = np.zeros(4, dtype=np.bool_)


def leg_of(pose: Pose, rng: np.random.Generator, count: int = 6000) -> FloatArray:
    """Points of the outer part of one leg, its end included, and of a strip of another one."""
    body, normals, _ = sample_surface(UNIT, count, rng)
    found = relate(body, UNIT)
    shown = (found.leg == LEG) & (found.axial > 0.4 * UNIT.height) | (found.leg == 0) & (normals @ UNIT.leg_directions[LEG] > 0.7)
    return pose.to_frame((body + normals * rng.normal(0, NOISE, (len(body), 1)))[shown])


def body_at(pose: Pose) -> Body:
    return Body(
        centre=pose.centre,
        rotation=pose.rotation,
        axes=np.ascontiguousarray(UNIT.leg_directions),
        across=np.stack(leg_frame(UNIT)),
        discs=NO_DISCS,
        radius=UNIT.radius,
        gradient=UNIT.gradient,
        length=UNIT.leg_length,
    )


@pytest.mark.parametrize(("sd", "off", "seen"), [(0.02, 0.05, True), (0.002, 0.05, False), (0.1, 0.15, False), (0.001, 0.004, True)])
def test_an_end_counts_where_the_place_along_its_leg_may_be_so_far_off(sd: float, off: float, seen: bool) -> None:
    rng = np.random.default_rng(1)
    pose = grid_poses(rng)[1]
    points = leg_of(pose, rng)
    axis = pose.rotation @ UNIT.leg_directions[LEG]
    shown = ends_shown(points, body_at(pose.shifted(-off * axis)), np.eye(3) * sd**2, UNIT.height, 0.01, NOISE)
    assert np.isfinite(shown).tolist() == [False, False, seen, False]
    if seen:
        assert shown[LEG] == pytest.approx(off, abs=0.002)
        # what lies within reach of robust weights is left to them
        way = way_to_ends(shown, body_at(pose), NOISE)
        np.testing.assert_allclose(way, shown[LEG] * axis if off > 0.02 else np.zeros(3), atol=1e-12)


def test_what_is_no_plane_is_no_end() -> None:
    rng = np.random.default_rng(2)
    pose = grid_poses(rng)[1]
    points = leg_of(pose, rng)
    beyond = (points - pose.centre) @ pose.rotation @ UNIT.leg_directions[LEG] - UNIT.leg_length
    face = np.abs(beyond) < 0.02
    points[face] += rng.uniform(-0.05, 0.05, (face.sum(), 1)) * (pose.rotation @ UNIT.leg_directions[LEG])
    assert np.isnan(ends_shown(points, body_at(pose), np.eye(3), UNIT.height, 0.01, NOISE)).all()


def test_an_end_that_one_epoch_missed_is_used_in_both() -> None:
    rng = np.random.default_rng(3)
    poses = grid_poses(rng)
    sightings = []
    for unit, pose in enumerate(poses):
        for epoch in range(2):
            points = leg_of(pose, rng) if unit == 0 else seen_from_above(pose, rng, 1500, NOISE).points
            start, discs = pose, ALL_DISCS
            if (unit, epoch) == (0, 1):
                start, discs = pose.shifted(0.05 * pose.rotation @ UNIT.leg_directions[LEG]), NO_DISCS
            cloud = UnitCloud.held(points, np.ones(len(points), dtype=np.int64))
            sightings.append(UnitSighting(unit=unit, epoch=epoch, pose=start, cloud=cloud, discs=discs, shape=UNIT))
    joint = adjust_jointly(sightings)
    first, second = joint.order[0]
    assert np.linalg.norm(joint.poses[second].centre - joint.poses[first].centre) < 0.005
    # two fifths of the points of both are on the end
    assert joint.used[second] > 0.9 * joint.used[first]


@pytest.mark.parametrize("moved", [0.0, 0.1])
def test_a_sighting_begins_where_more_of_its_points_lie_on_the_unit(moved: float) -> None:
    """Turned by 19 degrees and slid along its leg a fit stays where most of its points lie beside; what has moved is not brought back."""
    rng = np.random.default_rng(5)
    move = moved * np.array([0.6, 0.0, 0.8])
    sightings = []
    for unit, pose in enumerate(grid_poses(rng)):
        for epoch in range(2):
            there = pose.shifted(epoch * move) if unit == 0 else pose
            points = leg_of(there, rng) if unit == 0 else seen_from_above(there, rng, 700, NOISE).points
            start, discs = there, ALL_DISCS
            if (unit, epoch, moved) == (0, 1, 0.0):
                axis = UNIT.leg_directions[LEG]
                turn = Rotation.from_rotvec(np.radians(20) * np.cross(axis, UNIT.leg_directions[0])).as_matrix()
                start, discs = Pose(pose.centre + 0.15 * UNIT.height * (pose.rotation @ axis), pose.rotation @ turn), NO_DISCS
            cloud = UnitCloud.held(points, np.ones(len(points), dtype=np.int64))
            sightings.append(UnitSighting(unit=unit, epoch=epoch, pose=start, cloud=cloud, discs=discs, shape=UNIT))
    joint = adjust_jointly(sightings)
    first, second = joint.order[0]
    assert np.linalg.norm(joint.poses[second].centre - joint.poses[first].centre - move) < 0.005
