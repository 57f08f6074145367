"""Gaps: one where a unit is taken out of a pile, none elsewhere, none at the border; and what other epochs know."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import UNIT
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate, sample_surface
from tetratrack.core.pipeline.gap_table import CoveredGround, gap_rows
from tetratrack.core.registration.frame_correction import FrameCorrection
from tetratrack.core.registration.transformation import Transformation
from tetratrack.core.segmentation.gaps import Gap, armour_of, clearest, find_gaps, needed_area

H = UNIT.height
SIDE = 5
MIDDLE, CORNER = 12, 0
TIMES = [("a", datetime(2024, 4, 9, tzinfo=UTC)), ("b", datetime(2025, 4, 9, tzinfo=UTC))]


@pytest.fixture(scope="module")
def poses() -> np.ndarray:
    """A layer of five by five units 1.15 H apart on a slope, (25, 12)."""
    rng = np.random.default_rng(4)
    turns = Rotation.random(SIDE**2, random_state=rng).as_matrix()
    places = [np.array([i, j, 0.4 * i]) * 1.15 * H + rng.normal(0, 0.03 * H, 3) for i in range(SIDE) for j in range(SIDE)]
    return np.array([np.concatenate([place, turn.ravel()]) for place, turn in zip(places, turns, strict=True)])


def cloud(poses: np.ndarray, shown: np.ndarray) -> np.ndarray:
    """Points on the upper side of the units ``shown``, and rock beneath the layer, seen from straight above."""
    rng = np.random.default_rng(9)
    parts = []
    for row in poses[shown]:
        body, normals, _ = sample_surface(UNIT, 4000, rng)
        rotation = row[3:].reshape(3, 3)
        up = (normals @ rotation.T)[:, 2] > 0.1
        parts.append((body[up] + rng.normal(0, 0.005, (int(up.sum()), 1)) * normals[up]) @ rotation.T + row[:3])
    x, y = np.meshgrid(np.arange(-H, 6 * H, 0.05 * H), np.arange(-H, 6 * H, 0.05 * H))
    parts.append(np.column_stack([x.ravel(), y.ravel(), 0.4 * x.ravel() - 0.6 * H]))
    points = np.vstack(parts)
    hidden = np.zeros(len(points), dtype=bool)
    for rise in np.arange(0, 1.5, 0.1) * H:
        up = np.array([0, 0, rise])
        for row in poses[shown]:
            near = np.flatnonzero(np.linalg.norm(points + up - row[:3], axis=1) < 0.7 * H)
            above = points[near] + up - row[:3]
            hidden[near] |= relate(above @ row[3:].reshape(3, 3), UNIT).distance < -0.02 * H
    return points[~hidden]


def gaps_of(points: np.ndarray, poses: np.ndarray) -> list[Gap]:
    armour = armour_of(poses, np.zeros(len(poses), dtype=np.int64), [UNIT])
    assert armour is not None
    return find_gaps(points, armour)


def but(number: int) -> np.ndarray:
    return np.arange(SIDE**2) != number


def test_whole_layer_has_no_gap(poses: np.ndarray) -> None:
    assert gaps_of(cloud(poses, np.ones(SIDE**2, dtype=bool)), poses) == []


def test_unit_that_was_not_found_is_where_its_points_are(poses: np.ndarray) -> None:
    (gap,) = gaps_of(cloud(poses, np.ones(SIDE**2, dtype=bool)), poses[but(MIDDLE)])
    assert gap.kind == "unexplained"
    assert np.linalg.norm(gap.place - poses[MIDDLE, :3]) < 0.05 * H
    assert 0.75 <= gap.score <= 1
    assert gap.area > needed_area(UNIT)


def test_unit_taken_away_leaves_a_hole(poses: np.ndarray) -> None:
    place = poses[MIDDLE, :3]
    rubble = np.random.default_rng(2).uniform(-0.45 * H, 0.45 * H, (6000, 2))
    rubble = np.column_stack([rubble, 0.4 * rubble[:, 0] - 0.05 * H]) + place
    points = np.vstack([cloud(poses, but(MIDDLE)), rubble])
    (gap,) = gaps_of(points, poses[but(MIDDLE)])
    assert gap.kind == "hole"
    assert np.linalg.norm(gap.place - place) < 0.5 * H


def test_border_of_the_layer_is_no_gap(poses: np.ndarray) -> None:
    assert gaps_of(cloud(poses, np.ones(SIDE**2, dtype=bool)), poses[but(CORNER)]) == []


def test_no_points_no_gap_and_too_few_units(poses: np.ndarray) -> None:
    assert gaps_of(np.zeros((0, 3)), poses[but(MIDDLE)]) == []
    assert armour_of(poses[:3], np.zeros(3, dtype=np.int64), [UNIT]) is None


def test_one_gap_for_one_missing_unit() -> None:
    places = [np.array([x, 0.0, 0.0]) for x in (0.0, 0.3, 0.6, 5.0)]
    gaps = [Gap(place, "hole", 1.0, area, 0) for place, area in zip(places, (1.0, 2.0, 1.0, 1.0), strict=True)]
    assert [float(gap.place[0]) for gap in clearest(gaps, 1.0)] == [0.3, 5.0]


def test_places_that_another_epoch_knows() -> None:
    far = np.array([500_000.0, 3_500_000.0, 2.0])

    def row(name: str, epoch: str, x: float | None, status: str) -> dict:
        pose = Pose(far + np.array([x or 0.0, 0.0, 0.0]), np.eye(3))
        quaternion = dict(zip(("qx", "qy", "qz", "qw"), pose.quaternion(), strict=True))
        base = {"unit_id": name, "epoch": epoch, "unit_type": UNIT.name, "height": H, "status": status}
        return base | quaternion | {"geometry": None if x is None else pose.centre}

    rows = [
        row("U1", "a", 0, "found"), row("U1", "b", 0, "found"),
        row("U2", "a", 2 * H, "found"), row("U2", "b", None, "lost"),
        row("U3", "a", 4 * H, "found"), row("U3", "b", None, "unseen"),
        row("U4", "b", 6 * H, "new"), row("U5", "b", 8 * H, "found"),
        row("U6", "a", 10 * H, "found"), row("U6", "b", None, "lost"), row("U7", "b", 10.2 * H, "new"),
        row("U8", "a", 12 * H, "uncertain"),
    ]  # fmt: skip

    # beside U2, whose place is known better, and by itself
    seen = {"b": [Gap(far + np.array([x * H, 0, 0]), "hole", 0.8, 0.3, 0) for x in (2.5, 20)]}
    found = gap_rows(rows, TIMES, [UNIT], seen)
    assert [(g["epoch"], g["kind"], g.get("unit_id"), round((g["geometry"][0] - far[0]) / H, 3)) for g in found] == [
        ("a", "unseen", "U5", 8), ("b", "lost", "U2", 2), ("b", "unseen", "U3", 4), ("b", "hole", None, 20)
    ]  # fmt: skip
    assert {g["status"] for g in found} == {"placeholder"}
    lost = found[1]
    assert lost["nearest_centre"] == pytest.approx(2 * H)
    assert json.loads(lost["nearest_units"]) == ["U1", "U4", "U5"]
    assert lost["radius"] == pytest.approx(np.hypot(UNIT.leg_length, UNIT.end_radius))
    assert [g["kind"] for g in gap_rows(rows, TIMES, [UNIT])] == ["unseen", "lost", "unseen"]
    # U3 lies 4 H to the east: where an epoch has no points, it misses nothing
    for boxed, cells, kinds in ((3.6, 5, ["lost", "unseen"]), (3.4, 5, ["lost"]), (4.6, 3, ["lost"])):
        ground = CoveredGround(
            low=np.array([-H, -H]), high=np.array([boxed * H, H]), size=H,
            columns=frozenset((e, n) for e in range(-1, cells) for n in (-1, 0)),
            transformation=replace(Transformation.identity(far), origin_from=np.zeros(3)), correction=FrameCorrection.none(),
        )  # fmt: skip
        own = [g["kind"] for g in gap_rows(rows, TIMES, [UNIT], covered={"b": ground}) if g["epoch"] == "b"]
        assert own == kinds
