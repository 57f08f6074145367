"""Units recognised by the relief of their surface: the same one in another attitude, never another one, and only where noise allows."""

from __future__ import annotations

from datetime import UTC, datetime
from functools import cache

import numpy as np
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT
from tetratrack.core.deformation import relocation
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.identity import Track
from tetratrack.core.deformation.missing_units import Around
from tetratrack.core.deformation.relocation import CARRIED_HEIGHTS, Followed, join_relocated
from tetratrack.core.deformation.surface_texture import Likeness, likeness, texture
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.deformation.tracking import Tracking, track
from tetratrack.core.deformation.unit_clouds import HeldPoints, UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.pipeline.displacement_table import unit_names, unit_tables

POINTS = 24_000
UPRIGHT = Pose(np.zeros(3), np.eye(3))
TIPPED = Pose(np.array([4.0, 3, -2]), Rotation.from_euler("xyz", [70, 130, 20], degrees=True).as_matrix())


def sighting(casting: int, pose: Pose, seed: int, noise: float = 0.004) -> FittedUnit:
    """What a scanner above shows of a casting: 3 mm of relief of its own, 2 mm from the mould on every leg, two stations 4 mm apart."""
    rng = np.random.default_rng(seed)
    body, normals, legs = sample_surface(UNIT, POINTS, rng)
    above = (normals @ pose.rotation.T)[:, 2] > -0.2
    body, normals, legs = body[above], normals[above], legs[above]
    own = np.random.default_rng(1000 + casting)
    waves = own.normal(size=(80, 3))
    waves *= 2 * np.pi / own.uniform(0.1, 0.2, (80, 1)) / np.linalg.norm(waves, axis=1, keepdims=True)
    relief = 0.003 * np.sqrt(2 / 80) * np.cos(body @ waves.T + own.uniform(0, 6.28, 80)).sum(axis=1)
    along = np.einsum("ni,ni->n", body, UNIT.leg_directions[legs])
    relief += 0.002 * np.cos(2 * np.pi * along / 0.15)
    sources = rng.integers(1, 3, len(body))
    points = pose.to_frame(body + normals * (relief + rng.normal(0, noise, len(body)))[:, None]) + 0.004 * sources[:, None]
    fitted = pose.perturbed(rng.normal(0, 0.001, 3), rng.normal(0, 0.0005, 3))
    return FittedUnit(
        pose=fitted.relabelled(UNIT.symmetries[rng.integers(12)]),
        shape=UNIT,
        kind=0,
        certain=True,
        discs=ALL_DISCS,
        cloud=UnitCloud.held(points, sources),
    )


def compared(first: FittedUnit, second: FittedUnit) -> Likeness:
    a, b = (texture(*s.cloud.read(), s.pose, s.shape) for s in (first, second))
    return likeness(a, b, UNIT)


@pytest.mark.parametrize("seed", range(4))
def test_unit_is_recognised_in_another_attitude_with_its_leg_numbers(seed: int) -> None:
    before, after = sighting(seed, UPRIGHT, 2 * seed), sighting(seed, TIPPED, 2 * seed + 1)
    found = compared(before, after)
    assert found.same_unit
    turn = after.pose.relabelled(found.symmetry).rotation @ before.pose.rotation.T
    assert Rotation.from_matrix(turn @ (TIPPED.rotation @ UPRIGHT.rotation.T).T).magnitude() < 0.01


def test_another_casting_of_the_same_mould_is_not_recognised() -> None:
    leads = [compared(sighting(one, UPRIGHT, one), sighting(one + 50, TIPPED, one + 50)).lead for one in range(12)]
    assert max(leads) < 5


def test_noise_above_the_relief_recognises_nothing() -> None:
    assert not compared(sighting(1, UPRIGHT, 1, noise=0.02), sighting(1, TIPPED, 2, noise=0.02)).same_unit


def test_too_little_surface_in_common_recognises_nothing() -> None:
    few = sighting(1, UPRIGHT, 1)
    points, sources = few.cloud.read()
    some = texture(points[:200], sources[:200], few.pose, UNIT)
    assert likeness(some, some, UNIT).lead == 0
    assert len(texture(points[:40], sources[:40], few.pose, UNIT).points) == 0


PLACES = [Pose(np.array([3.0 * (k % 3), 3.0 * (k // 3), 0]), r.as_matrix()) for k, r in enumerate(Rotation.random(6, random_state=3))]
ELSEWHERE = Pose(np.array([9.0, 1.5, 1.0]), Rotation.from_euler("x", 80, degrees=True).as_matrix())
HOLE = Pose(PLACES[1].centre + np.array([0.6, 0.2, 0.1]), PLACES[1].rotation @ Rotation.from_euler("z", 30, degrees=True).as_matrix())


@cache
def tracked(noise: float) -> tuple[Tracking, tuple[TrackedEpoch, ...], dict[int, int]]:
    """Six units; then unit 1 lies elsewhere, a new one (9) in its hole, unit 2 is gone and a new one (8) came to another place."""
    scenes = [
        {k: PLACES[k] for k in range(6)},
        {0: PLACES[0], 3: PLACES[3], 4: PLACES[4], 5: PLACES[5], 1: ELSEWHERE, 9: HOLE, 8: Pose(np.array([-4.0, 1, 0]), np.eye(3))},
    ]
    epochs, clouds = [], []
    for number, scene in enumerate(scenes):
        units = tuple(sighting(casting, pose, 100 * number + casting, noise) for casting, pose in scene.items())
        ground = np.random.default_rng(number).uniform([-8, -4, -1.7], [13, 7, -1.6], (150_000, 3))
        for pose in scene.values():
            ground = ground[np.linalg.norm(ground[:, :2] - pose.centre[:2], axis=1) > 1.2]
        epochs.append(TrackedEpoch(label=str(number), time=datetime(2020 + number, 1, 1, tzinfo=UTC), units=units, registration=None))
        clouds.append(np.vstack([*(u.cloud.read()[0] for u in units), ground]))

    def surroundings(epoch: int, places: np.ndarray, reach: float) -> Around:
        near = np.isfinite(cKDTree(places).query(clouds[epoch], distance_upper_bound=reach)[0])
        return HeldPoints(clouds[epoch][near], np.ones(int(near.sum()), dtype=np.int64))

    result = track(epochs, [UNIT], surroundings)
    castings = {}
    for k, states in enumerate(result.units):
        e = min(states)
        row = states[e].row
        castings[list(scenes[e])[row if row is not None else -1]] = k
    return result, tuple(epochs), castings


def test_relocated_unit_keeps_its_identity_though_another_fills_its_hole() -> None:
    result, _, castings = tracked(0.004)
    moved = result.units[castings[1]]
    assert moved[1].status == "relocated"
    assert moved[1].pose is not None
    assert moved[1].pose.centre == pytest.approx(ELSEWHERE.centre, abs=0.02)
    assert result.units[castings[9]][1].status == "new"
    assert [result.units[castings[k]][1].status for k in (0, 3, 4, 5)] == ["found"] * 4


def test_what_is_not_recognised_stays_lost_and_new_with_the_candidates_named() -> None:
    result, epochs, castings = tracked(0.004)
    names = unit_names(len(result.units))
    rows, _ = unit_tables(result, epochs, [UNIT], names, np.zeros(3), lambda e, r: {})
    by_name = {(row["unit_id"], row["epoch"]): row for row in rows}
    lost, new, refill = (names[castings[k]] for k in (2, 8, 9))
    assert by_name[lost, "1"]["status"] == "lost"
    assert by_name[lost, "1"]["may_be"].split() == sorted([new, refill])
    assert by_name[new, "1"]["status"] == "new"
    assert by_name[new, "1"]["may_be"] == lost
    assert by_name[names[castings[0]], "1"]["may_be"] is None


def test_a_unit_whose_hole_was_filled_stays_lost_in_all_later_epochs() -> None:
    seen = {0: sighting(1, PLACES[1], 1), 1: sighting(9, HOLE, 2), 2: sighting(9, HOLE, 3)}
    whole = Followed(Track({0: 0, 1: 0, 2: 0}, {}, frozenset(), 0), seen, {})
    assert whole.moved_far(1, np.zeros((3, 3)))
    assert whole.until(1, 3).states == {1: "empty", 2: "empty"}
    assert whole.since(2).states == {0: "empty", 1: "empty"}


def test_a_shift_of_the_whole_cloud_compares_no_reliefs(monkeypatch: pytest.MonkeyPatch) -> None:
    shift = np.array([0.9, -0.5, 0.1])
    compared = []
    monkeypatch.setattr(relocation, "likeness", lambda *args: compared.append(args))
    first = tuple(sighting(k, pose, k) for k, pose in enumerate(PLACES))
    second = tuple(sighting(k, pose.shifted(shift), 50 + k) for k, pose in enumerate(PLACES))
    epochs = [
        TrackedEpoch(label=str(e), time=datetime(2020 + e, 1, 1, tzinfo=UTC), units=units, registration=None)
        for e, units in enumerate((first, second))
    ]
    result = track(epochs, [UNIT])
    assert result.shifts[1] - result.shifts[0] == pytest.approx(shift, abs=0.05)
    assert [len(states) for states in result.units] == [2] * len(PLACES)
    assert compared == []


def test_nothing_is_joined_where_noise_drowns_the_relief() -> None:
    result, _, _ = tracked(0.02)
    assert not any(state.status == "relocated" for states in result.units for state in states.values())


def compared_along(monkeypatch: pytest.MonkeyPatch, units: int) -> list[tuple[float, float]]:
    """Places along a coast, in heights, of units whose reliefs are compared: every two heights one is lost, and another came beside it."""
    compared = []

    def noted(first: float, second: float, unit: object) -> Likeness:
        compared.append((first, second))
        return Likeness(np.eye(3), 0.0, 0.0)

    monkeypatch.setattr(relocation, "_relief_of", lambda unit: unit.pose.centre[0] / UNIT.height)
    monkeypatch.setattr(relocation, "likeness", noted)
    tracks, seen = [], []
    shifts = np.array([[0.0, 0, 0], [500.0, 0, 0]])
    for k in range(units):
        pose = Pose(np.array([2.0 * k * UNIT.height, 0, 0]), np.eye(3))
        for epoch in (0, 1):
            cloud = UnitCloud.held(np.empty((0, 3)), np.empty(0, dtype=np.int64))
            unit = FittedUnit(
                pose=pose.shifted(shifts[epoch]), shape=UNIT, kind=0, certain=True, discs=ALL_DISCS, cloud=cloud
            )  # fmt: skip
            tracks.append(Track({epoch: k}, {epoch: np.eye(3)}, frozenset(), 0))
            seen.append({epoch: unit})
    states: list[dict[int, str]] = [{} for _ in tracks]
    kept, _, _ = join_relocated(tracks, seen, states, shifts)
    assert len(kept) == 2 * units
    return [(first, second - 500.0 / UNIT.height) for first, second in compared]


def test_reliefs_are_compared_as_far_as_units_are_carried_and_no_further(monkeypatch: pytest.MonkeyPatch) -> None:
    short, long = (compared_along(monkeypatch, units) for units in (200, 400))
    within = int(CARRIED_HEIGHTS) // 2 * 2
    assert max(abs(first - second) for first, second in long) == pytest.approx(within, abs=1e-6)
    assert len(short) > 200 * within * 0.9
    # what grows faster than the coast would be four times as much
    assert len(long) < 2.1 * len(short)
    assert len(set(long)) == len(long)
