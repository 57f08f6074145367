"""Overlap and distance of neighbours, and an epoch in a few numbers."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.epoch_quality import add_neighbours, describe, entering, summarise_epoch
from tetratrack.core.segmentation.overlaps import nearest_centres, overlap_shares

H = UNIT.height
FAR = np.array([500_000.0, 3_500_000.0, 2.0])


def row(name: str, place: list[float], status: str = "found", unit: UnitType = UNIT) -> dict:
    turn = Rotation.from_rotvec([0.3, -0.2, 0.5]).as_quat()
    return {
        "unit_id": name, "epoch": "a", "unit_type": unit.name, "height": unit.height, "status": status, "distance_median": 0.004,
        "geometry": FAR + place, **dict(zip(("qx", "qy", "qz", "qw"), turn, strict=True)),
    }  # fmt: skip


def table(*poses: Pose) -> np.ndarray:
    return np.array([np.concatenate([pose.centre, pose.rotation.ravel()]) for pose in poses])


def test_overlap_is_the_share_of_the_volume_inside_the_other() -> None:
    first = Pose(np.zeros(3), np.eye(3))
    second = Pose(np.array([0.35 * H, 0.1 * H, 0.0]), Rotation.from_rotvec([0.4, 0.1, -0.7]).as_matrix())
    lone = Pose(np.array([3 * H, 0, 0]), np.eye(3))
    shares = overlap_shares(table(first, second, lone), np.zeros(3, dtype=np.int64), [UNIT])
    # drawn at random through a box around the first unit, independent of the lattice in the product
    box = np.random.default_rng(5).uniform(-0.7 * H, 0.7 * H, (400_000, 3))
    inside = relate(first.to_body(box), UNIT).distance < 0
    both = inside & (relate(second.to_body(box), UNIT).distance < 0)
    assert shares[0] == pytest.approx(both.sum() / inside.sum(), abs=0.01)
    assert shares[0] > 0.05
    assert shares[2] == 0


def test_unit_of_another_type_is_entered_by_its_own_size() -> None:
    small = UnitType.tetrapod(0.2 * H, name="small")
    poses = table(Pose(np.zeros(3), np.eye(3)), Pose(np.array([0.0, 0.0, 0.05 * H]), np.eye(3)))
    shares = overlap_shares(poses, np.array([0, 1]), [UNIT, small])
    assert shares[1] == 1
    assert shares[0] == pytest.approx(0.2**3, abs=0.003)


def test_only_units_that_count_are_entered() -> None:
    poses = table(Pose(np.zeros(3), np.eye(3)), Pose(np.array([0.2 * H, 0, 0]), np.eye(3)))
    shares = overlap_shares(poses, np.zeros(2, dtype=np.int64), [UNIT], np.array([True, False]))
    assert shares[0] == 0
    assert shares[1] > 0.2


def test_nearest_centres() -> None:
    assert nearest_centres(np.array([[0.0, 0, 0], [3, 4, 0], [3, 4, 1]])).tolist() == [5, 1, 1]
    assert np.isinf(nearest_centres(np.zeros((1, 3)))).all()


def test_rows_and_summary_of_an_epoch() -> None:
    rows = [row("U1", [0, 0, 0]), row("U2", [0.4 * H, 0, 0], "uncertain"), row("U3", [2 * H, 0, 0]), {"unit_id": "U4", "epoch": "a"}]
    rows[3] |= {"geometry": None, "status": "lost"}
    rows[2]["distance_median"] = float("nan")
    add_neighbours(rows, [UNIT])
    assert rows[0]["nearest_centre"] == pytest.approx(0.4 * H)
    assert rows[2]["nearest_centre"] == pytest.approx(1.6 * H)
    assert rows[0]["overlap_share"] == 0
    assert rows[1]["overlap_share"] > 0.01
    assert "nearest_centre" not in rows[3]
    summary = summarise_epoch(rows, "a", 3)
    assert summary == {
        "found": 2, "uncertain": 1, "distance_median": 0.004, "overlap_share_max": 0.0, "close_pairs": 1, "gaps": 3
    }  # fmt: skip
    assert "4.0 mm" in describe("a", summary)
    alone = [row("U1", [0, 0, 0])]
    add_neighbours(alone, [UNIT])
    assert alone[0]["nearest_centre"] is None
    assert summarise_epoch([], "a", None)["distance_median"] is None


def test_the_weaker_of_two_that_share_a_volume_is_told() -> None:
    apart = 0.52 * UNIT.height
    centres = np.array([[0.0, 0, 0], [apart, 0, 0], [apart + 3 * UNIT.height, 0, 0]])
    poses = np.column_stack([centres, np.tile(np.eye(3).ravel(), (3, 1))])
    kinds = np.zeros(3, dtype=np.int64)
    assert overlap_shares(poses, kinds, [UNIT]).max() > 0.01
    assert entering(poses, kinds, [UNIT], np.array([0.9, 0.8, 0.7]), 0.01).tolist() == [False, True, False]
    assert entering(poses, kinds, [UNIT], np.array([0.8, 0.9, 0.7]), 0.01).tolist() == [True, False, False]
    assert not entering(poses, kinds, [UNIT], np.array([0.9, 0.8, 0.7]), 0.9).any()
