"""Frames that bend: learned from the survey, units judged by their neighbours, targets against the bend."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bent_coast import BentCoast, bent_coast
from numpy.typing import NDArray
from tetratrack.core.deformation.congruence import Congruence
from tetratrack.core.deformation.elastic_congruence import elastic_congruence_of
from tetratrack.core.deformation.epoch_frames import EpochFrames, PairShifts, estimate_frames
from tetratrack.core.deformation.target_shifts import TargetShifts
from tetratrack.core.registration.frame_field import LocalMotions

HEIGHT = 2.3
FloatArray = NDArray[np.float64]


def frames_of(coast: BentCoast, disturbed: int | None = None, choice: str = "auto") -> EpochFrames | None:
    targets: list[TargetShifts | None] = [None, None]
    if len(coast.targets):
        names = tuple(f"T{k:02d}" for k in range(len(coast.targets)))
        for epoch, residuals in enumerate(coast.residuals):
            own = residuals.copy()
            if disturbed is not None and epoch == 1:
                own[disturbed] += [0.06, 0.05, 0.0]
            targets[epoch] = TargetShifts(
                ids=names,
                positions=coast.targets,
                residuals=own,
                variances=np.full(own.shape, coast.target_sd**2),
                surveyed_variances=np.zeros(own.shape),
            )
    shifts = PairShifts(places=coast.places, vectors=coast.displacements, covariances=coast.covariances)
    return estimate_frames([shifts], targets, coast.places, HEIGHT, choice)  # type: ignore[arg-type]


def judged(coast: BentCoast) -> tuple[Congruence, LocalMotions, LocalMotions]:
    """Congruence, and what the others predict at every unit in datum stable and control."""
    frames = frames_of(coast)
    assert frames is not None
    control, precision = frames.between(0, 1)
    suspects = frames.jumped(0, 1, coast.places)
    result, datum = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, frames.degrees, suspects, frames.controlled(0, 1)
    )
    used = datum.used.astype(np.float64)
    stable = datum.stable.at(coast.places).without(coast.displacements, result.null.covariance(coast.covariances), used)
    return result, stable, datum.control.at(coast.places)


def squares(coast: BentCoast, result: Congruence, part: LocalMotions) -> FloatArray:
    """Normalised squared errors by coordinate of resting units."""
    error = coast.displacements - part.means[:, :3] - coast.motions
    variance = np.einsum("nii->ni", result.null.covariance(coast.covariances) + part.covariances[:, :3, :3])
    return np.asarray((error**2 / variance)[coast.resting])


def test_a_stiff_coast_has_rigid_frames() -> None:
    assert [frames_of(bent_coast(seed, rms=0.0)) for seed in range(3)] == [None] * 3


@pytest.mark.parametrize("tail", [np.inf, 8.0])
def test_a_bent_coast_at_rest_passes_the_global_test(tail: float) -> None:
    """Units judged by their neighbours depend on each other, and their tails are what they are."""
    p_values = []
    for seed in range(8):
        coast = bent_coast(seed, length=60.0, density=2.0, shortest=40.0, longest=80.0)
        heavy = 1.0 if np.isinf(tail) else np.sqrt(tail / np.random.default_rng(seed).chisquare(tail, (len(coast.places), 1)))
        errors = coast.displacements - coast.motions - (coast.bends[1] - coast.bends[0])
        at_rest = coast.bends[1] - coast.bends[0] + heavy * errors
        coast = replace(coast, displacements=at_rest, motions=np.zeros_like(at_rest))
        p_values.append(judged(coast)[0].global_p_value)
    assert np.mean(np.array(p_values) < 0.05) <= 0.25
    assert 0.25 < np.mean(p_values) < 0.8


def test_rigid_is_obeyed() -> None:
    assert frames_of(bent_coast(1), choice="rigid") is None


@pytest.mark.parametrize(("shortest", "longest"), [(60.0, 300.0), (30.0, 60.0)])
def test_units_on_a_bent_coast_are_judged_as_on_a_stiff_one(shortest: float, longest: float) -> None:
    """Bends of 3 cm: errors of resting units stay those of the units themselves, stated deviations are true, moves are found."""
    normalised, false, found, ratio = [], [], [], []
    for seed in range(3):
        coast = bent_coast(seed, shortest=shortest, longest=longest)
        result, stable, _ = judged(coast)
        normalised.append(squares(coast, result, stable))
        error = (coast.displacements - stable.means[:, :3])[coast.resting]
        own = 1.15**2 * np.einsum("nii->n", coast.covariances)[coast.resting]
        ratio.append(np.sqrt(np.mean(np.sum(error**2, axis=1)) / np.mean(own)))
        false += (result.p_values[coast.resting] < 0.05).tolist()
        found += (result.p_values[~coast.resting] < 0.05).tolist()
    assert 0.85 < np.mean(np.concatenate(normalised)) < 1.2
    assert 0.02 < np.mean(false) < 0.08
    assert np.mean(found) > 0.98
    assert max(ratio) < 1.15


@pytest.mark.parametrize("station", [24.0, 70.0])
def test_datum_control_knows_how_far_targets_are(station: float) -> None:
    """Every coast is one draw of a few independent bends, and on each one the stated deviation and the level of the test are true."""
    for seed in range(2):
        coast = bent_coast(seed, station=station)
        result, _, control = judged(coast)
        assert 0.7 < float(np.mean(squares(coast, result, control))) < 1.4
        assert 0.02 < float(np.mean(result.control_p_values[coast.resting] < 0.05)) < 0.08


def test_a_slide_that_sharp_eyes_see_is_no_bend() -> None:
    """Where units err by a millimetre, cells at the ends of a slide are outliers of any bend: without them a bend would explain it."""
    coast = bent_coast(7, slide=(75.0, 93.0), station=24.0, unit_sd=0.0008, target_sd=0.003)
    frames = frames_of(coast)
    assert frames is not None
    sliding = coast.sliding
    jumped = frames.jumped(0, 1, coast.places)
    assert jumped[sliding].mean() > 0.7
    assert jumped[~sliding].mean() < 0.1
    result, _, control = judged(coast)
    assert np.mean(result.control_p_values[sliding] < 0.05) > 0.95
    assert 0.5 < np.mean(squares(coast, result, control)) < 1.6


def test_a_sliding_stretch_with_targets_on_it_moves_in_both_datums() -> None:
    coast = bent_coast(4, slide=(88.0, 112.0), station=25.0)
    result = judged(coast)[0]
    sliding = coast.sliding
    assert np.mean(result.p_values[sliding] < 0.05) > 0.95
    assert np.mean(result.control_p_values[sliding] < 0.05) > 0.9


@pytest.mark.parametrize("seed", [4, 10, 15])
def test_a_slide_that_the_bend_of_all_cells_follows_is_told_by_that_of_the_others(seed: int) -> None:
    coast = bent_coast(seed, length=100.0, density=1.67, slide=(38.0, 62.0), station=24.0)
    result, _, control = judged(coast)
    sliding = coast.sliding
    assert np.mean(result.p_values[sliding] < 0.05) > 0.9
    assert np.mean(result.control_p_values[sliding] < 0.05) > 0.9
    assert 0.7 < np.mean(squares(coast, result, control)) < 1.4


@pytest.mark.parametrize(("seed", "low"), [(5101, 27.2), (5104, 37.7)])
def test_a_slide_that_a_bend_of_all_cells_hides_is_told(seed: int, low: float) -> None:
    """A bend that has to follow the slide is so rough that little of it is left as a step: the others are asked without it."""
    coast = bent_coast(seed, length=100.0, density=1.8, slide=(low, low + 24.0), station=24.0)
    frames = frames_of(coast)
    assert frames is not None
    sliding = coast.sliding
    jumped = frames.jumped(0, 1, coast.places)
    assert jumped[sliding].mean() > 0.8
    assert jumped[~sliding].mean() < 0.1


@pytest.mark.parametrize(("seed", "low"), [(3001, 24.0), (3003, 9.0)])
def test_units_that_slid_do_not_vouch_for_each_other(seed: int, low: float) -> None:
    """A third of a short coast slid: its units agree with each other, and by them alone they would rest."""
    coast = bent_coast(seed, length=60.0, slide=(low, low + 24.0), station=24.0, unit_sd=0.0008, target_sd=0.003)
    result, stable, _ = judged(coast)
    assert not result.stable[coast.sliding].any()
    assert np.mean(result.p_values[coast.sliding] < 0.05) > 0.95
    assert np.mean(result.p_values[coast.resting] < 0.05) < 0.08
    assert 0.7 < np.mean(squares(coast, result, stable)) < 1.4


@pytest.mark.parametrize(("seed", "low"), [(3000, 27.0), (3002, 10.0)])
def test_what_rests_beside_a_slide_is_not_told_as_another(seed: int, low: float) -> None:
    coast = bent_coast(seed, length=60.0, slide=(low, low + 24.0), station=24.0, unit_sd=0.0008, target_sd=0.003)
    frames = frames_of(coast)
    assert frames is not None
    jumped = frames.jumped(0, 1, coast.places)
    assert jumped[coast.sliding].mean() > 0.8
    assert jumped[~coast.sliding].mean() < 0.1


@pytest.mark.parametrize("seed", [5000, pytest.param(5001, marks=pytest.mark.slow)])
def test_a_body_that_moved_by_itself_is_no_stretch_of_a_long_coast(seed: int) -> None:
    frames = frames_of(bent_coast(seed, length=830.0, density=1.8, station=70.0))
    assert frames is not None
    assert [bending.jumps for bending in frames.bendings if bending is not None] == [()]


def test_a_disturbed_target_is_found_and_good_ones_stay_on_a_bent_coast() -> None:
    good = 0
    for seed in range(4):
        frames = frames_of(bent_coast(seed), disturbed=5)
        assert frames is not None
        first, second = (np.flatnonzero(~v.used).tolist() for v in frames.verdicts if v is not None)
        assert 5 in second
        good += len(first) + len(second) - 1
    # one good target in a hundred epochs may go
    assert good <= 1


def test_a_sliding_stretch_without_targets_moves_against_its_neighbours_alone() -> None:
    coast = bent_coast(11, slide=(80.0, 104.0), station=0.0)
    result, stable, _ = judged(coast)
    sliding = coast.sliding
    assert np.mean(result.p_values[sliding] < 0.05) > 0.95
    assert 0.85 < np.mean(squares(coast, result, stable)) < 1.25
    # nothing absolute is known there, and datum control says so
    assert np.mean(result.control_p_values[sliding] < 0.05) < 0.1


def test_the_middle_of_a_cell_may_lie_where_no_unit_is() -> None:
    """Cells of ground are places of their own, between units, for which a field over units alone has no nodes."""
    frames = frames_of(bent_coast(101, rms=0.05, station=50.0))
    assert frames is not None
    assert all(error is not None for error in frames.errors)


def test_badly_measured_targets_of_a_single_epoch_are_no_bend() -> None:
    """Targets 3 times worse than stated scatter: independent errors, not a smooth field."""
    rng = np.random.default_rng(3)
    for seed in range(3):
        coast = bent_coast(seed, rms=0.0)
        own = TargetShifts(
            ids=tuple(map(str, range(len(coast.targets)))), positions=coast.targets,
            residuals=rng.normal(0, 0.018, coast.targets.shape), variances=np.full(coast.targets.shape, 0.006**2),
            surveyed_variances=np.zeros(coast.targets.shape),
        )  # fmt: skip
        assert estimate_frames([], [own], coast.places, HEIGHT, "auto") is None


def test_a_single_epoch_bends_as_its_targets_show() -> None:
    coast = bent_coast(2, station=20.0)
    own = TargetShifts(
        ids=tuple(map(str, range(len(coast.targets)))), positions=coast.targets, residuals=coast.residuals[0],
        variances=np.full(coast.targets.shape, 0.006**2), surveyed_variances=np.zeros(coast.targets.shape),
    )  # fmt: skip
    frames = estimate_frames([], [own], coast.places, HEIGHT, "auto")
    assert frames is not None
    assert frames.errors[0] is not None
    found = frames.errors[0].at(coast.places)
    away = found.means[:, :3] - coast.bends[0]
    assert np.sqrt(np.mean(np.sum(away**2, axis=1))) < 0.02
    assert 0.3 < np.mean(away**2 / np.einsum("nii->ni", found.covariances[:, :3, :3])) < 2.0
