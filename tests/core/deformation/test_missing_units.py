"""Places of units that an epoch does not show: few points are enough in a sparse cloud, no two solids share a place.

In poor clouds what one epoch alone shows is held against what the other says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import Any, cast

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT, seen_from_above
from tetratrack.core.deformation import evidence_of_epochs
from tetratrack.core.deformation.fitted_unit import FittedUnit
from tetratrack.core.deformation.missing_units import MissingUnits, look_for_missing, look_for_rest
from tetratrack.core.deformation.questions import Answer, Ask, Question
from tetratrack.core.deformation.tracked_epoch import TrackedEpoch
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.segmentation.second_look import SecondLook, second_look

POSE = Pose(np.array([0.0, 0.0, 0.0]), Rotation.from_euler("xyz", [0.3, 0.4, 0.5]).as_matrix())


def fitted(pose: Pose, points: np.ndarray, score: float = 1.0, certain: bool = True) -> FittedUnit:
    cloud = UnitCloud.held(points, np.zeros(len(points), dtype=np.uint16))
    return FittedUnit(pose=pose, shape=UNIT, kind=0, certain=certain, discs=ALL_DISCS, cloud=cloud, score=score)


def asked(
    now: np.ndarray,
    before: np.ndarray,
    owners: tuple[FittedUnit, ...] = (),
    score: float = 1.0,
    certain: bool = True,
    rival: FittedUnit | None = None,
    beside: tuple[FittedUnit, ...] = (),
) -> Answer:
    """What becomes of a unit whose epoch holds ``before``, and nothing else, in one that holds ``now``."""
    return MissingUnits(
        units=(fitted(POSE, before, score, certain),),
        moves=np.zeros((1, 3)),
        rivals=(rival,),
        owners=owners,
        beside=beside,
        now=lambda: (now, np.zeros(len(now), dtype=np.uint16)),
        before=lambda: (before, np.zeros(len(before), dtype=np.uint16)),
        reach=1.35 * UNIT.reach,
        height=UNIT.height,
    ).answer()


def test_few_points_are_enough_where_the_cloud_is_sparse() -> None:
    rng = np.random.default_rng(1)
    before = seen_from_above(POSE, rng, 60, 0.01).points
    few = seen_from_above(POSE.shifted([0.04, 0.0, -0.03]), rng, 45, 0.01).points
    answer = asked(few, before)
    assert answer["state"].tolist() == ["there"]
    assert len(answer["points"]) >= 40
    # the same number among many is a small part of the surface
    ground = np.column_stack([rng.uniform(-1.5, 1.5, (20000, 2)), rng.normal(-1.7, 0.01, 20000)])
    assert asked(np.vstack([few, ground]), before)["state"].tolist() == ["hidden"]


def test_where_an_epoch_has_no_points_nothing_is_known() -> None:
    answer = asked(np.zeros((0, 3)), seen_from_above(POSE, np.random.default_rng(3), 900, 0.01).points)
    assert answer["state"].tolist() == ["hidden"]
    assert not len(answer["points"])


def test_a_unit_is_not_taken_up_inside_another_one() -> None:
    rng = np.random.default_rng(2)
    before, now = (seen_from_above(POSE, rng, 900, 0.01).points for _ in range(2))
    beside, inside = (fitted(Pose(np.array([way * UNIT.height, 0.0, 0.0]), POSE.rotation), np.zeros((0, 3))) for way in (1.2, 0.4))
    assert asked(now, before, (beside,))["state"].tolist() == ["there"]
    answer = asked(now, before, (beside, inside))
    assert answer["state"].tolist() == ["hidden"]
    assert not len(answer["points"])


def test_layers_before_a_surface_show_no_unit() -> None:
    rng = np.random.default_rng(6)
    height = UNIT.height
    before = seen_from_above(POSE, rng, 20000, 0.003 * height).points
    outwards = relate(POSE.to_body(before), UNIT).normal @ POSE.rotation.T
    # the unit is gone: a surface lies 0.2 H deeper, and layers of images that bridge the hollow where it was
    bridged = rng.random(len(before)) < 0.4
    way = np.where(bridged, rng.uniform(-0.1, 0.03, len(before)), -0.2) * height
    now = (before + outwards * way[:, None])[outwards[:, 2] > 0.3]
    assert asked(now, before)["state"].tolist() != ["there"]
    assert asked(before, before)["state"].tolist() == ["there"]


def noisy_pile(rng: np.random.Generator) -> tuple[np.ndarray, tuple[FittedUnit, ...]]:
    """A unit in noise of 3 % of its height, and where its neighbours stand."""
    places = [np.array([1.3 * np.cos(a), 1.3 * np.sin(a), -0.2]) * UNIT.height for a in (0.0, 2.0, 4.0)]
    return seen_from_above(POSE, rng, 6000, 0.03 * UNIT.height).points, tuple(
        fitted(Pose(p, POSE.rotation), np.zeros((0, 3))) for p in places
    )


def test_noisy_points_say_again_how_sure_a_unit_is() -> None:
    rng = np.random.default_rng(4)
    points, owners = noisy_pile(rng)
    weak = asked(points, points, owners, score=0.6, certain=False)
    assert weak["state"].tolist() == ["there"]
    assert weak["score"][0] > 0.9
    # what is beyond doubt is not asked, and rich clouds cannot tell
    assert np.isnan(asked(points, points, owners, score=0.995)["score"][0])
    rich = seen_from_above(POSE, rng, 6000, 0.01).points
    assert np.isnan(asked(rich, rich, owners, score=0.6, certain=False)["score"][0])
    # a bed of rock fits it where points were taken for it, and does not look like a unit
    bed = np.column_stack([rng.uniform(-1.2, 1.2, (6000, 2)), rng.normal(0.55, 0.03 * UNIT.height, 6000)])
    own = bed[np.abs(relate(POSE.to_body(bed), UNIT).distance) < 0.1]
    rock = asked(bed, own, owners, score=0.7)
    assert rock["state"].tolist() == ["there"]
    assert rock["score"][0] < 0.05


def test_rich_points_speak_against_what_chance_aligned() -> None:
    """Where they agree nothing is said: rock that fits looks alike in all epochs."""
    rng = np.random.default_rng(11)
    _, owners = noisy_pile(rng)
    bed = np.column_stack([rng.uniform(-1.2, 1.2, (9000, 2)), rng.normal(0.55, 0.01, 9000)])
    own = bed[np.abs(relate(POSE.to_body(bed), UNIT).distance) < 0.05]
    rock = asked(bed, own, owners, score=0.8)
    assert rock["state"].tolist() == ["there"]
    assert rock["score"][0] < 0.3
    assert np.isnan(asked(bed, own, owners, score=0.8, certain=False)["score"][0])
    rich, again = (seen_from_above(POSE, rng, 6000, 0.01).points for _ in range(2))
    assert np.isnan(asked(again, rich, owners, score=0.8)["score"][0])


def among_noise(rng: np.random.Generator, noise: float) -> tuple[FittedUnit, ...]:
    """Neighbours of which one shows the noise of the cloud, metres."""
    _, (first, *others) = noisy_pile(rng)
    return fitted(first.pose, seen_from_above(first.pose, rng, 2500, noise).points), *others


def test_few_points_are_judged_as_their_cloud_is() -> None:
    """Noise is taken off a place that shows too little to tell: where a unit beside it shows that it is taken off the cloud."""
    rng = np.random.default_rng(21)
    noise = 0.021 * UNIT.height
    owners = among_noise(rng, noise)
    before, now = (seen_from_above(POSE, rng, 300, noise).points for _ in range(2))
    assert asked(now, before, owners, score=0.6, certain=False, beside=owners)["score"][0] > 0.9
    bed = np.column_stack([rng.uniform(-1.2, 1.2, (700, 2)), rng.normal(0.55, noise, 700)])
    own = bed[np.abs(relate(POSE.to_body(bed), UNIT).distance) < 0.1]
    assert asked(bed, own, owners, score=0.7, beside=owners)["score"][0] < 0.1


def test_what_moved_is_laid_together_as_it_moved() -> None:
    """As if it rested the points of both epochs fit no one pose."""
    rng = np.random.default_rng(22)
    noise = 0.013 * UNIT.height
    owners = among_noise(rng, noise)
    turn = Rotation.from_rotvec(np.radians([4.8, 0.0, 6.4])).as_matrix()
    moved = Pose(POSE.centre + np.array([0.05, 0.05, -0.04]) * UNIT.height, POSE.rotation @ turn)
    before, now = (seen_from_above(pose, rng, 1500, noise).points for pose in (POSE, moved))
    assert asked(now, before, owners, score=0.84, beside=owners)["score"][0] > 0.9


def test_noisy_points_say_whether_a_unit_rests_that_was_found_elsewhere() -> None:
    rng = np.random.default_rng(5)
    points, owners = noisy_pile(rng)
    turned = POSE.rotation @ Rotation.from_rotvec([0.0, 0.0, 0.3]).as_matrix()
    elsewhere = Pose(POSE.centre + np.array([0.15, 0.1, -0.15]) * UNIT.height, turned)
    rival = fitted(elsewhere, np.zeros((0, 3)))
    rests = asked(points, points, (*owners, rival), score=0.97, rival=rival)
    assert rests["state"].tolist() == ["there"]
    assert rests["score"][0] > 0.9
    moved = seen_from_above(elsewhere, rng, 6000, 0.03 * UNIT.height).points
    assert np.isnan(asked(moved, points, (*owners, rival), score=0.97, rival=rival)["score"][0])
    rich, other = (seen_from_above(pose, rng, 6000, 0.01).points for pose in (POSE, elsewhere))
    assert np.isnan(asked(other, rich, (*owners, rival), rival=rival)["score"][0])


def test_what_rests_counts_once_and_its_noise_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both epochs' points are judged laid together, among the units of both; odds that agree because the scene does are not multiplied."""
    rng = np.random.default_rng(7)
    points, owners = noisy_pile(rng)
    looks: list[tuple[int, int]] = []

    def look(around: np.ndarray, pose: np.ndarray, others: np.ndarray, *_: object, **__: object) -> SecondLook:
        looks.append((len(around), len(others)))
        return SecondLook(0.72, pose, noisy=True)

    monkeypatch.setattr(evidence_of_epochs, "second_look", look)
    # the first of the neighbours that the other epoch shows stands where this one shows it as well
    also = fitted(owners[0].pose.shifted([0.02, 0.0, 0.0]), np.zeros((0, 3)))
    alone = fitted(POSE.shifted([0.0, 0.0, -1.2 * UNIT.height]), np.zeros((0, 3)))
    answer = asked(points, points, owners, score=0.7, beside=(also, alone))
    assert sorted(looks) == [(len(points), 3), (2 * len(points), 4)]
    assert answer["score"][0] == 0.72
    # what its own epoch is surer of stays so unless the points speak against it
    assert asked(points, points, owners, score=0.9)["score"][0] == 0.72
    monkeypatch.setattr(evidence_of_epochs, "second_look", lambda _, pose, *__, **___: SecondLook(0.85, pose, noisy=True))
    assert asked(points, points, owners, score=0.9)["score"][0] == 0.9


def test_noise_that_neighbours_share_in_one_epoch_is_known_to_be_shared_in_two(monkeypatch: pytest.MonkeyPatch) -> None:
    points, owners = noisy_pile(np.random.default_rng(7))
    told: dict[int, bool] = {}

    def look(around: np.ndarray, pose: np.ndarray, *_: object, shared_noise: bool, **__: object) -> SecondLook:
        told[len(around)] = shared_noise
        return SecondLook(0.72, pose, noisy=True, shared_noise=len(around) == len(points))

    monkeypatch.setattr(evidence_of_epochs, "second_look", look)
    asked(points, points, owners, score=0.7)
    assert told == {len(points): False, 2 * len(points): True}


def test_where_both_epochs_are_rich_together_they_speak_once(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(8)
    points, owners = noisy_pile(rng)

    def look(around: np.ndarray, pose: np.ndarray, *_: object, **__: object) -> SecondLook | None:
        return SecondLook(0.7, pose, noisy=True) if len(around) == len(points) else None

    monkeypatch.setattr(evidence_of_epochs, "second_look", look)
    assert asked(points, points, owners, score=0.7)["score"][0] == pytest.approx(0.7)


def test_a_pose_is_judged_where_it_is_or_settled() -> None:
    rng = np.random.default_rng(9)
    points, _ = noisy_pile(rng)
    aside = POSE.shifted(np.array([0.03, 0.0, 0.0]) * UNIT.height)
    row = np.concatenate([aside.centre, aside.rotation.ravel()])
    left, drawn = (second_look(points, row, np.zeros((0, 12)), np.zeros(0), UNIT, settle=settle) for settle in (False, True))
    assert left is not None
    assert drawn is not None
    assert np.array_equal(left.pose, row)
    assert np.linalg.norm(drawn.place.centre - POSE.centre) < 0.01 * UNIT.height


def test_a_unit_rests_where_it_is_predicted_or_where_points_draw_it(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(9)
    points, _ = noisy_pile(rng)
    near, far = (POSE.shifted(np.array([way, 0.0, 0.0]) * UNIT.height) for way in (0.03, 0.15))
    said: dict[str, Any] = {"still": 0.8, "drawn": 0.1, "to": far, "together": 0.9}

    def look(around: np.ndarray, pose: np.ndarray, *_: object, settle: bool = True, **__: object) -> SecondLook:
        if len(around) > len(points):
            return SecondLook(said["together"], pose, noisy=True)
        if not settle:
            return SecondLook(said["still"], pose, noisy=True)
        return SecondLook(said["drawn"], np.concatenate([said["to"].centre, said["to"].rotation.ravel()]), noisy=True)

    monkeypatch.setattr(evidence_of_epochs, "second_look", look)
    rival = fitted(far, np.zeros((0, 3)))
    rests = asked(points, points, (rival,), score=0.95, rival=rival)
    assert rests["state"].tolist() == ["there"]
    assert rests["score"][0] == 0.95
    assert np.array_equal(rests["centre"][0], POSE.centre)
    said |= {"drawn": 0.85, "to": near}
    assert np.array_equal(asked(points, points, (rival,), rival=rival)["centre"][0], near.centre)
    # elsewhere likelier, or against it laid together
    said |= {"to": far}
    assert np.isnan(asked(points, points, (rival,), rival=rival)["score"][0])
    said |= {"to": near, "together": 0.6}
    assert np.isnan(asked(points, points, (rival,), rival=rival)["score"][0])


def test_a_unit_found_far_apart_is_taken_up_where_the_surer_epoch_shows_it() -> None:
    """The less sure epoch is asked; what moved little, or has no second certain sighting, is not."""
    far, little = 0.15 * UNIT.height, 0.08 * UNIT.height
    seen = [
        {0: seen_by(0.9, True, far), 1: seen_by(0.99, True, 0.0)},
        {0: seen_by(0.99, True, 20.0), 1: seen_by(0.9, True, 20.0 + far)},
        {0: seen_by(0.9, True, 40.0 + little), 1: seen_by(0.99, True, 40.0)},
        {0: seen_by(0.9, False, 60.0 + far), 1: seen_by(0.99, True, 60.0)},
    ]
    said = {0.0: 0.98, 20.0: np.nan}
    recovered = look_for_rest(seen, 2, [UNIT], np.zeros((2, 3)), lambda *_: seen_nothing, saying(said))
    assert [(unit, epoch, float(sighting.pose.centre[0])) for unit, epoch, sighting in recovered] == [(0, 0, 0.0)]


def seen_by(score: float, certain: bool, place: float) -> FittedUnit:
    return replace(fitted(POSE.shifted([place, 0.0, 0.0]), np.zeros((0, 3))), score=score, certain=certain, covariance=np.eye(6))


def test_what_another_epoch_says_changes_the_evidence() -> None:
    """Doubted, confirmed, left as it was, and of two confirmed in one place the better one."""
    epochs = [TrackedEpoch(label=str(k), time=datetime(2024, 1, 1 + k, tzinfo=UTC), units=(), registration=None) for k in range(2)]
    sightings = [(0.7, True, 0.0), (0.7, True, 9.0), (0.6, False, 20.0), (0.5, False, 20.3), (0.6, False, 40.0), (0.3, False, 60.0)]
    seen = [{0: seen_by(*sighting)} for sighting in sightings]
    said = {0.0: 0.4, 9.0: np.nan, 20.0: 0.9, 20.3: 0.95, 40.0: 0.5}
    states, recovered, verdicts = look_for_missing(epochs, seen, [UNIT], np.zeros((2, 3)), lambda *_: seen_nothing, saying(said))
    assert verdicts == {0: False, 3: True}
    assert [(unit, epoch, sighting.score) for unit, epoch, sighting in recovered] == [(1, 1, 0.7), (3, 1, 0.95)]
    assert all(sighting.certain for *_, sighting in recovered)
    assert states == [{1: "hidden"}, {1: "there"}, {}, {1: "there"}, {}, {}]


def seen_nothing() -> tuple[np.ndarray, np.ndarray]:
    return np.zeros((0, 3)), np.zeros(0, dtype=np.uint16)


def saying(scores: dict[float, float]) -> Ask:
    """Answers that all units are there, with joint scores by their place along x."""

    def ask(questions: Sequence[Question]) -> list[Answer]:
        return [answer(cast(MissingUnits, question).units) for question in questions]

    def answer(units: Sequence[FittedUnit]) -> Answer:
        return {
            "state": np.array(["there"] * len(units)),
            "centre": np.array([unit.pose.centre for unit in units]),
            "rotation": np.array([unit.pose.rotation for unit in units]),
            "score": np.array([scores[round(float(unit.pose.centre[0]), 1)] for unit in units]),
            "points": np.zeros((0, 3)),
            "sources": np.zeros(0, dtype=np.uint16),
            "offsets": np.zeros(len(units) + 1, dtype=np.int64),
        }

    return ask
