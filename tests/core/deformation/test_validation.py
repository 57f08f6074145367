"""Check points beside the feature points they were surveyed for."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT, grid_poses
from tetratrack.core.common.errors import InputError
from tetratrack.core.deformation import validation
from tetratrack.core.model.feature_points import FEATURES, body_features
from tetratrack.core.model.pose import Pose

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())
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
