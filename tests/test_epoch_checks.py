"""Presence of missing units, direct registration as a cross-check, check points, and views."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, grid_poses, seen_from_above
from tetratrack.core import validation
from tetratrack.core.cross_check import cross_check
from tetratrack.core.errors import InputError
from tetratrack.core.feature_points import FEATURES, body_features
from tetratrack.core.pose import Pose, rotation_angle
from tetratrack.core.presence import look_up
from tetratrack.core.tetrapod import relate
from tetratrack.core.views import register_views

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())


def bed(rng: np.random.Generator, hidden_under: Pose | None) -> np.ndarray:
    """Ground below the unit, without what the unit hides from above."""
    flat = np.column_stack([rng.uniform(-2.5, 2.5, (6000, 2)), np.full(6000, -1.5) + rng.normal(0, 0.01, 6000)])
    if hidden_under is None:
        return flat
    heights = np.linspace(-1.4, 1.5, 30)
    column = flat[:, None] + np.array([0, 0, 1.0]) * (heights[:, None] + 1.5)[None]
    inside = (relate(hidden_under.to_body(column.reshape(-1, 3)), UNIT).distance < 0).reshape(len(flat), -1).any(axis=1)
    return np.asarray(flat[~inside])


def test_presence_tells_there_from_gone_from_hidden() -> None:
    rng = np.random.default_rng(0)
    own = seen_from_above(POSE, rng, 2000, 0.01).points
    before = np.vstack([own, bed(rng, POSE)])
    there = look_up(own, POSE, UNIT, before, np.vstack([seen_from_above(POSE, rng, 900, 0.01).points, bed(rng, POSE)]), 0.05)
    assert there.state == "there"
    assert there.support > 0.8
    gone = look_up(own, POSE, UNIT, before, bed(rng, None), 0.05)
    assert gone.state == "empty"
    assert gone.support < 0.1
    cover = POSE.shifted([0, 0, 2.0])
    roof = np.column_stack([rng.uniform(-2, 2, (5000, 2)), np.full(5000, 1.9)])
    assert look_up(own, POSE, UNIT, before, np.vstack([roof, seen_from_above(cover, rng, 500, 0.01).points]), 0.05).state == "hidden"
    assert look_up(own, POSE, UNIT, before, np.empty((0, 3)), 0.05).state == "hidden"


def test_direct_registration_agrees_with_the_true_motion() -> None:
    differences, agreed = [], 0
    for seed, pose in enumerate(grid_poses(np.random.default_rng(1), 3)):
        rng = np.random.default_rng(seed)
        after = pose.perturbed(rng.normal(0, 0.1, 3), rng.normal(0, 0.05, 3))
        clouds = [seen_from_above(p, np.random.default_rng([seed, k]), 1500, 0.006).points for k, p in enumerate((pose, after))]
        check = cross_check(*clouds, pose, after, np.eye(3) * 0.001**2, 0.006)
        differences.append(check.difference)
        agreed += check.agrees is True
        assert math.degrees(check.turn) == pytest.approx(math.degrees(rotation_angle(pose.rotation, after.rotation)), abs=0.5)
    assert np.sqrt(np.mean(np.square(differences))) < 0.004
    assert agreed >= 8


def test_direct_registration_disagrees_with_a_wrong_model() -> None:
    rng = np.random.default_rng(2)
    clouds = [seen_from_above(POSE, rng, 1500, 0.006).points for _ in range(2)]
    check = cross_check(*clouds, POSE, POSE.shifted([0.03, 0, 0.0]), np.eye(3) * 0.001**2, 0.006)
    assert check.agrees is False
    assert check.difference == pytest.approx(0.03, abs=0.006)
    assert "broken leg" in check.reason


def test_direct_registration_says_when_it_cannot_tell() -> None:
    rng = np.random.default_rng(3)
    points = seen_from_above(POSE, rng, 1500, 0.006).points
    few = cross_check(points[:20], points, POSE, POSE, np.eye(3) * 1e-6, 0.006)
    assert few.agrees is None
    assert "fewer than" in few.reason
    apart = cross_check(points[points[:, 0] > 0.6], points[points[:, 0] < -0.6], POSE, POSE, np.eye(3) * 1e-6, 0.006)
    assert apart.agrees is None
    assert math.isnan(apart.difference)


CHECK_HEADER = "point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd"


def features_of(pose: Pose) -> dict[str, np.ndarray]:
    return dict(zip(FEATURES, pose.to_frame(body_features(UNIT)), strict=True))


def test_check_points_find_their_unit_and_feature(tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    poses = grid_poses(rng, 3)
    moved = [p.perturbed(rng.normal(0, 0.05, 3), rng.normal(0, 0.02, 3)) for p in poses]
    residuals: list[validation.CheckResidual] = []
    for epoch, placed in (("a", poses), ("b", moved)):
        lines = [CHECK_HEADER]
        for k, pose in enumerate(placed):
            near, point = pose.centre + rng.uniform(-0.15, 0.15, 3), features_of(pose)["f134"]
            lines.append(f"K{k},{','.join(f'{v:.3f}' for v in near)},{','.join(f'{v:.5f}' for v in point)},0.003")
        lines.append("K9,900,0,0,900,0,0,0.003")
        path = tmp_path / f"{epoch}.csv"
        path.write_text("\n".join(lines), encoding="utf-8")
        features = {f"U{k}": features_of(p) for k, p in enumerate(placed)}
        residuals += validation.check_residuals(validation.read_check(path), features, UNIT.height, epoch)
    matched = [r for r in residuals if r.difference is not None]
    assert len(matched) == 18
    assert all(r.unit_id == f"U{r.point_id[1:]}" and r.feature == "f134" and r.length < 1e-4 for r in matched)
    picks = {("K0", "a"): residuals[0].position, ("K0", "b"): residuals[0].position}
    columns = validation.checked_displacements(residuals, ["a", "b"], picks)
    assert len(columns) == 9
    assert max(abs(c.error) for c in columns) < 1e-4
    assert columns[0].manual_error == pytest.approx(-columns[0].check)
    assert math.isnan(columns[1].manual_error)
    summary = validation.summarise([c.manual_error for c in columns])
    assert summary.count == 1
    assert summary.maximum == pytest.approx(columns[0].check)
    assert validation.residual_rows(residuals)[9]["unit_id"] is None


def test_a_survey_in_which_nothing_was_checked(tmp_path: Path) -> None:
    path = tmp_path / "check.csv"
    path.write_text(CHECK_HEADER, encoding="utf-8")
    assert validation.read_check(path) == ()


def test_mistakes_in_check_and_picks_are_placed(tmp_path: Path) -> None:
    path = tmp_path / "check.csv"
    path.write_text(f"{CHECK_HEADER}\nK1,1,2,3,4,5,6,-1", encoding="utf-8")
    with pytest.raises(InputError, match="line 2, field sd"):
        validation.read_check(path)
    path.write_text("point_id,epoch,easting,northing,height\nK1,a,1,2,3\nK1,b,1,2,3\nK1,a,1,2,3", encoding="utf-8")
    with pytest.raises(InputError, match="line 4: names point 'K1' in epoch 'a' again"):
        validation.read_picks(path)


def test_views_are_brought_into_the_frame_of_the_first() -> None:
    pytest.importorskip("open3d")
    rng = np.random.default_rng(5)
    scene = np.vstack([seen_from_above(p, rng, 6000, 0.0).points for p in grid_poses(rng, 2)])
    floor = np.column_stack([rng.uniform(-2, 6, (9000, 2)), rng.normal(0, 0.0, 9000) - 1.2])
    scene = np.vstack([scene, floor])
    views, motions = [], []
    for k in range(3):
        turn = Rotation.from_rotvec(np.radians(rng.normal(0, 0.0 if k == 0 else 1.0, 3))).as_matrix()
        shift = rng.normal(0, 0.0 if k == 0 else 0.03, 3)
        some = scene[rng.random(len(scene)) < 0.5]
        views.append((some + rng.normal(0, 0.004, some.shape)) @ turn.T + shift)
        motions.append((turn, shift))
    result = register_views(views)
    for (turn, shift), motion in zip(motions, result.motions, strict=True):
        there = scene @ turn.T + shift
        back = there @ motion[:3, :3].T + motion[:3, 3]
        assert np.sqrt(np.mean(np.sum((back - scene) ** 2, axis=1))) < 0.004
    assert len(result.overlaps) == 3


def test_views_that_do_not_hang_together() -> None:
    pytest.importorskip("open3d")
    rng = np.random.default_rng(6)
    views = [rng.uniform(0, 1, (500, 3)), rng.uniform(50, 51, (500, 3))]
    with pytest.raises(InputError, match="view 2 overlaps none"):
        register_views(views)
    with pytest.raises(InputError, match="at least two"):
        register_views(views[:1])
    with pytest.raises(InputError, match="view 2 holds 5 points"):
        register_views([views[0], views[1][:5]])
