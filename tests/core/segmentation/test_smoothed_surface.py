"""Elements of noisy clouds lie where the surface is, and rock smoothed alike is told from units by where it lies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.segmentation import segment as segment_module
from tetratrack.core.segmentation.pose_score import (
    AMONG_HEIGHTS,
    RICH,
    SMOOTHED,
    SPARSE,
    ScoreModel,
    TypicalUnit,
    score,
    score_among,
)
from tetratrack.core.segmentation.restarts import begun_anew
from tetratrack.core.segmentation.scene import Evidence, Scene
from tetratrack.core.segmentation.segment import FOUND_SCORE, segment
from tetratrack.core.segmentation.smoothed_surface import NOISY_RATIO, smoothed
from tetratrack.core.segmentation.surface_elements import surface_elements
from tetratrack.core.simulation.sampled_unit import cloud_of, interlocked_poses

UNIT = UnitType.tetrapod(2.3)
H = UNIT.height
ROWS = interlocked_poses(UNIT, columns=3, lower_rows=2, upper_rows=1)
WEAK = Evidence(np.array([[200.0, 230.0, 0.0, 20.0, 3.0, 0.42, 252.0]]))
"""Support, close, inside, cells, legs, misfit over the tolerance, reached: a fifth of a unit, or a rock, in noise of 3 % of H."""
ROCK = Evidence(np.array([[190.0, 193.0, 0.0, 14.0, 3.0, 0.51, 195.0]]))
"""A pose in rock before the toe of a simulated pile: nearly all elements agree."""
SURE = Evidence(np.array([[700.0, 720.0, 0.0, 60.0, 4.0, 0.36, 730.0]]))
TYPICAL = TypicalUnit(misfit=0.38, agreement=0.97, model=SMOOTHED)


def cosines(points: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Between normals and those of the nearest unit's surface."""
    relations = [relate(pose.to_body(points), UNIT) for pose in ROWS]
    nearest = np.argmin([np.abs(r.distance) for r in relations], axis=0)
    true = np.array([r.normal @ pose.rotation.T for r, pose in zip(relations, ROWS, strict=True)])
    return np.sum(true[nearest, np.arange(len(points))] * normals, axis=1)


@pytest.fixture(scope="module")
def noisy_cloud() -> np.ndarray:
    return cloud_of(UNIT, ROWS, 0.03 * H, np.random.default_rng(5), count=8000).points


def distances(points: np.ndarray) -> np.ndarray:
    """Unsigned distance of each point to the nearest unit's surface, in heights."""
    return np.min([np.abs(relate(pose.to_body(points), UNIT).distance) for pose in ROWS], axis=0) / H


def test_noise_is_taken_off_elements_and_their_normals(noisy_cloud):
    elements = surface_elements(noisy_cloud, H)
    assert 2.5 * elements.element_noise > NOISY_RATIO * H
    result = smoothed(noisy_cloud, elements, H)
    before, after = np.median(distances(elements.points)), np.median(distances(result.points))
    assert after < 0.4 * before
    # the stated deviation is that of the elements: the median of a normal deviate's size is 0.67 of it
    assert result.element_noise / H == pytest.approx(after / 0.6745, rel=0.4)
    assert (result.noise, result.spacing, result.smoothed, elements.smoothed) == (elements.noise, elements.spacing, True, False)
    assert np.linalg.norm(result.normals, axis=1) == pytest.approx(1)
    assert np.mean(np.abs(cosines(result.points, result.normals)) > 0.9) > 0.9
    bent = result.curved == 1
    assert np.mean(cosines(result.points[bent], result.normals[bent]) > 0.9) > 0.8


def test_units_are_found_in_noise(noisy_cloud, monkeypatch):
    asked = []

    def spied(poses, found, doubted, *others):
        asked.append((len(poses), len(doubted)))
        return begun_anew(poses, found, doubted, *others)

    monkeypatch.setattr(segment_module, "begun_anew", spied)
    units = [u for u in segment(noisy_cloud, UNIT).units if u.status == "found"]
    centres = np.array([u.pose.centre for u in units])
    away = [np.linalg.norm(centres - pose.centre, axis=1).min() for pose in ROWS]
    assert len(units) == len(ROWS)
    assert max(away) < 0.03 * H
    # what is in doubt begins anew, once
    assert len(asked) == 1
    assert asked[0][0] == asked[0][1] >= len(ROWS)


def test_the_place_decides_where_the_elements_do_not():
    unit = 1.2 * H
    around = np.vstack([[0, 0, 0], unit * np.eye(3), -unit * np.eye(3)])
    evidence = Evidence.joined([WEAK, *[SURE] * 6])
    alone = score(evidence, 1.0, TYPICAL)
    assert (alone[1:] > 0.99).all()
    beside = score_among(evidence, around, 1.0, TYPICAL, UNIT)
    apart = score_among(evidence, around + np.vstack([[2 * AMONG_HEIGHTS * H + unit, 0, 0], np.zeros((6, 3))]), 1.0, TYPICAL, UNIT)
    assert alone[0] < 0.65
    assert apart[0] < 0.2 < 0.65 < beside[0]
    # a unit does not stand beside itself, and one that shows well needs no neighbour
    assert FOUND_SCORE < score_among(SURE, np.zeros((1, 3)), 1.0, TYPICAL, UNIT)[0] < alone[1]
    rich = replace(TYPICAL, model=RICH)
    assert (score_among(evidence, around, 1.0, rich, UNIT) == score(evidence, 1.0, rich)).all()
    assert len(score_among(Evidence.joined([]), np.zeros((0, 3)), 1.0, TYPICAL, UNIT)) == 0


@pytest.mark.parametrize("model", [SMOOTHED, SPARSE])
def test_odds_against_what_stands_apart_lower_what_its_own_elements_say(model: ScoreModel):
    typical = replace(TYPICAL, model=model)
    poses = Evidence.joined([ROCK, *[SURE] * 6])
    alone = score(poses, 1.0, typical)
    assert FOUND_SCORE < alone[0] < 0.99
    beside = 0.9 * H * np.vstack([np.zeros(3), np.eye(3), -np.eye(3)])
    assert score_among(poses, beside, 1.0, typical, UNIT)[0] >= alone[0]
    beside[0, 0] += 3 * AMONG_HEIGHTS * H
    apart = score_among(poses, beside, 1.0, typical, UNIT)
    assert apart[0] == pytest.approx(alone[0] / (alone[0] + model.apart_odds * (1 - alone[0])))
    assert apart[0] < FOUND_SCORE
    assert (apart[1:] >= alone[1:]).all()


def test_a_scene_knows_whether_it_was_smoothed(noisy_cloud):
    elements = surface_elements(noisy_cloud, H)
    assert Scene.of(smoothed(noisy_cloud, elements, H), UNIT, 0.05).smoothed
    assert not Scene.of(elements, UNIT, 0.05).smoothed


def test_too_few_points_are_left_as_they_are(noisy_cloud):
    few = noisy_cloud[np.random.default_rng(6).random(len(noisy_cloud)) < 0.08]
    elements = surface_elements(few, H)
    assert 2.5 * elements.element_noise > NOISY_RATIO * H
    assert smoothed(few, elements, H) is elements
