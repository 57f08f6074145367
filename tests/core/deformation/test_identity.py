"""Identity over epochs: ids, leg numbers through the symmetry, hidden units, frames that differ."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.deformation.identity import FoundUnits, identify, nearest_labels
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(2.3)


def pile(rng: np.random.Generator, count: int = 60) -> list[Pose]:
    """Units in random orientation, no two centres nearer than 0.55 H."""
    centres: list[np.ndarray] = []
    while len(centres) < count:
        candidate = rng.uniform(0, [14, 12, 7])
        if all(np.linalg.norm(candidate - c) > 0.55 * UNIT.height for c in centres):
            centres.append(candidate)
    return [Pose(c, r.as_matrix()) for c, r in zip(centres, Rotation.random(count, random_state=rng), strict=True)]


def found(poses: list[Pose], rng: np.random.Generator | None = None, certain: list[bool] | None = None) -> FoundUnits:
    """As a detector gives them: any leg numbers, any order kept by the caller."""
    if rng is not None:
        poses = [p.relabelled(UNIT.symmetries[rng.integers(12)]) for p in poses]
    return FoundUnits(tuple(poses), np.zeros(len(poses), dtype=np.int64), np.array(certain or [True] * len(poses), dtype=bool))


def turned(pose: Pose, rng: np.random.Generator, degrees: float, move: float) -> Pose:
    axis, way = rng.normal(size=3), rng.normal(size=3)
    return pose.perturbed(move * way / np.linalg.norm(way), np.radians(degrees) * axis / np.linalg.norm(axis))


def test_ids_and_leg_numbers_through_turns_up_to_50_degrees() -> None:
    wrong_id = wrong_legs = total = 0
    for seed in range(5):
        rng = np.random.default_rng(seed)
        before = pile(rng)
        moved = set(rng.choice(len(before), 12, replace=False).tolist())
        after = [
            turned(p, rng, rng.uniform(0, 50), rng.uniform(0.02, 0.45) * UNIT.height) if k in moved else p for k, p in enumerate(before)
        ]
        order = rng.permutation(len(after))
        first, second = found(before, rng), found([after[k] for k in order], rng)
        for track in identify([first, second], [UNIT]).tracks:
            if len(track.rows) < 2:
                wrong_id += 1
                continue
            total += 1
            truth = track.rows[0]
            wrong_id += int(order[track.rows[1]]) != truth
            a = first.poses[track.rows[0]].relabelled(track.symmetries[0])
            b = second.poses[track.rows[1]].relabelled(track.symmetries[1])
            true_turn = after[truth].rotation @ before[truth].rotation.T
            wrong_legs += not np.allclose(b.rotation @ a.rotation.T, true_turn, atol=1e-6)
    assert total >= 290
    assert wrong_id <= 0.01 * total
    assert wrong_legs <= 0.01 * total


def test_turns_near_60_degrees_are_reported_as_ambiguous() -> None:
    pose = Pose(np.zeros(3), np.eye(3))
    # about a leg's axis 120 degrees is a symmetry, so that 60 degrees cannot be told from -60
    at_sixty = pose.perturbed([0.1, 0, 0], np.radians(58) * UNIT.leg_directions[0])
    clear = pose.perturbed([0.1, 0, 0], np.radians(30) * UNIT.leg_directions[0])
    assert identify([found([pose]), found([at_sixty])], [UNIT]).tracks[0].ambiguous == {1}
    assert identify([found([pose]), found([clear])], [UNIT]).tracks[0].ambiguous == frozenset()


def test_nearest_labels_undo_a_symmetry() -> None:
    rng = np.random.default_rng(3)
    pose = Pose(np.zeros(3), Rotation.random(random_state=rng).as_matrix())
    for symmetry in UNIT.symmetries:
        chosen, turn, next_best = nearest_labels(pose, pose.relabelled(symmetry), UNIT)
        assert turn == pytest.approx(0, abs=1e-6)
        assert next_best > np.radians(100)
        assert np.allclose(symmetry @ chosen, np.eye(3), atol=1e-9)


def test_a_unit_hidden_in_one_epoch_keeps_its_id() -> None:
    rng = np.random.default_rng(1)
    poses = pile(rng, 20)
    without = poses[:7] + poses[8:]
    tracks = identify([found(poses, rng), found(without, rng), found(poses, rng)], [UNIT]).tracks
    assert len(tracks) == 20
    assert sorted(tuple(sorted(t.rows)) for t in tracks) == [(0, 1, 2)] * 19 + [(0, 2)]
    assert next(t for t in tracks if 1 not in t.rows).rows == {0: 7, 2: 7}


def test_lost_and_new_units_are_not_joined() -> None:
    rng = np.random.default_rng(2)
    poses = pile(rng, 20)
    stranger = Pose(poses[3].centre + np.array([0, 0, 0.75 * UNIT.height]), Rotation.random(random_state=rng).as_matrix())
    tracks = identify([found(poses), found([*poses[:3], *poses[4:], stranger])], [UNIT]).tracks
    assert len(tracks) == 21
    assert next(t for t in tracks if t.rows == {0: 3})
    assert next(t for t in tracks if t.rows == {1: 19})


def test_frames_a_metre_apart_are_matched() -> None:
    rng = np.random.default_rng(4)
    poses = pile(rng)
    shift = np.array([0.9, -0.6, 0.4])
    result = identify([found(poses, rng), found([p.shifted(shift) for p in poses], rng)], [UNIT])
    assert np.allclose(result.shifts[1], shift, atol=1e-6)
    assert all(t.rows.get(0) == t.rows.get(1) for t in result.tracks)


def test_weak_evidence_confirms_a_unit_but_starts_no_identity() -> None:
    rng = np.random.default_rng(6)
    poses = pile(rng, 10)
    far = poses[0].perturbed([0.5, 0, 0], [0, 0, 0.5])
    tracks = identify([found(poses), found([poses[0], far, *poses[1:]], certain=[False, False] + [True] * 9)], [UNIT]).tracks
    assert next(t for t in tracks if t.rows.get(0) == 0).rows == {0: 0, 1: 0}
    assert next(t for t in tracks if t.rows == {1: 1})
