"""Frames of all epochs from targets and resting units together."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from bent_coast import DIRECTION, BentCoast, bent_coast
from numpy.typing import NDArray
from tetratrack.core.deformation.chained_frames import chained_errors
from tetratrack.core.deformation.elastic_congruence import ElasticDatum, elastic_congruence_of
from tetratrack.core.deformation.epoch_frames import EpochFrames, PairShifts, estimate_frames
from tetratrack.core.deformation.target_shifts import TargetShifts
from tetratrack.core.registration.frame_field import FieldBasis, FieldEstimate, FieldModel, information_of

HEIGHT = 2.3
FloatArray = NDArray[np.float64]


def frames_and_datum(
    coast: BentCoast, with_targets: tuple[bool, bool] = (True, True), drift: float = 0.0, control_sd: float = 0.0, told: bool = True
) -> tuple[EpochFrames, ElasticDatum]:
    """``told`` says whether it is known that both epochs have the same surveyed coordinates, good to ``control_sd``."""
    names = tuple(f"T{k:02d}" for k in range(len(coast.targets)))
    targets = [
        TargetShifts(
            ids=names,
            positions=coast.targets,
            residuals=own,
            variances=np.full(own.shape, coast.target_sd**2 + control_sd**2),
            surveyed_variances=np.full(own.shape, control_sd**2 * told),
            drift_variances=np.full(3, drift**2),
        )
        if given
        else None
        for own, given in zip(coast.residuals, with_targets, strict=True)
    ]
    shifts = PairShifts(places=coast.places, vectors=coast.displacements, covariances=coast.covariances)
    frames = estimate_frames([shifts], targets, coast.places, HEIGHT, "auto")
    assert frames is not None
    control, precision = frames.between(0, 1)
    suspects = frames.jumped(0, 1, coast.places)
    datum = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, frames.degrees, suspects, frames.controlled(0, 1)
    )[1]
    return frames, datum


def errors_of(coast: BentCoast, fields: tuple[FieldEstimate | None, ...]) -> tuple[list[float], list[float]]:
    """RMSE of each epoch's field in metres, and mean squared normalised error."""
    lengths, squares = [], []
    for field, bend in zip(fields, coast.bends, strict=True):
        assert field is not None
        known = field.at(coast.places)
        away = known.means[:, :3] - bend
        lengths.append(float(np.sqrt(np.mean(np.sum(away**2, axis=1)))))
        squares.append(float(np.mean(away**2 / np.einsum("kii->ki", known.covariances[:, :3, :3]))))
    return lengths, squares


@pytest.mark.parametrize(("told", "least", "most"), [(0.0, 3.0, 30.0), (0.015, 0.5, 1.6)])
def test_what_strips_drift_in_the_mean_is_in_the_deviations_of_positions(told: float, least: float, most: float) -> None:
    """Units share a drift of 15 mm that no target sees: positions are as far off as they say where that is known."""
    squares = []
    for seed in range(3):
        coast = bent_coast(seed, rms=0.015, station=24.0)
        noise = np.random.default_rng(seed).normal(0, coast.target_sd, (2, *coast.targets.shape))
        coast = replace(coast, residuals=(noise[0], noise[1]))
        frames, datum = frames_and_datum(coast, drift=told)
        squares += errors_of(coast, chained_errors(frames, [datum]))[1]
    assert least < np.mean(squares) < most


def test_units_that_rest_bring_the_targets_of_both_epochs_together() -> None:
    """Far from targets the error of a frame is less by the square root of two, and its deviation stays true."""
    alone, chained, squares = [], [], []
    for seed in range(4):
        coast = bent_coast(seed, station=70.0)
        frames, datum = frames_and_datum(coast)
        alone += errors_of(coast, frames.errors)[0]
        lengths, normalised = errors_of(coast, chained_errors(frames, [datum]))
        chained += lengths
        squares += normalised
    assert np.sqrt(np.mean(np.square(chained)) / np.mean(np.square(alone))) < 0.8
    assert 0.5 < np.mean(squares) < 1.6


@pytest.mark.parametrize(("told", "least", "most"), [(False, 1.6, 5.0), (True, 0.6, 1.5)])
def test_coordinates_surveyed_once_for_all_epochs_count_once(told: bool, least: float, most: float) -> None:
    """Control is good to 8 mm, the cloud to 2: both epochs of a frame that hardly bends err by what the control does."""
    squares = []
    for seed in range(3):
        coast = bent_coast(seed, rms=0.02, station=40.0, target_sd=0.002, control_sd=0.008)
        frames, datum = frames_and_datum(coast, control_sd=0.008, told=told)
        squares += errors_of(coast, chained_errors(frames, [datum]))[1]
    assert least < np.mean(squares) < most


def test_displacements_against_control_surveyed_once_are_known_as_well_as_the_cloud_is() -> None:
    """What both epochs share drops out of the difference of their frames, whose deviation is true."""
    squares, shares = [], []
    for seed in range(2):
        coast = bent_coast(seed, rms=0.02, station=25.0, target_sd=0.002, control_sd=0.008)
        away, sds = [], []
        for told in (True, False):
            known = frames_and_datum(coast, control_sd=0.008, told=told)[0].between(0, 1)[0].at(coast.places)
            away.append(known.means[:, :3] - (coast.bends[1] - coast.bends[0]))
            sds.append(np.einsum("kii->ki", known.covariances[:, :3, :3]))
        squares.append(np.mean(away[0] ** 2 / sds[0]))
        shares.append(np.mean(sds[0]) / np.mean(sds[1]))
    assert 0.5 < np.mean(squares) < 1.6
    assert np.mean(shares) < 0.6


def test_an_epoch_without_targets_stands_on_those_of_the_other() -> None:
    coast = bent_coast(1, station=25.0)
    frames, datum = frames_and_datum(coast, (True, False))
    assert frames.errors[1] is None
    lengths, normalised = errors_of(coast, chained_errors(frames, [datum]))
    assert max(lengths) < 0.03
    assert all(0.3 < value < 2.5 for value in normalised)


def test_without_targets_nothing_is_known_of_any_epoch() -> None:
    frames, datum = frames_and_datum(bent_coast(1, station=0.0))
    assert chained_errors(frames, [datum]) == (None, None)


def test_a_chain_of_three_epochs_is_one_adjustment() -> None:
    coast = bent_coast(3, station=70.0)
    frames, datum = frames_and_datum(coast)
    first, last = frames.errors
    assert first is not None
    assert last is not None
    other = replace(datum, information=0.5 * datum.information, rhs=-0.3 * datum.rhs)
    chained = chained_errors(replace(frames, errors=(first, last, first)), [datum, other])
    size = frames.basis.size
    normal, rhs = np.zeros((3 * size, 3 * size)), np.zeros(3 * size)
    for k, own in enumerate((first, last, first)):
        part = slice(k * size, (k + 1) * size)
        inverse = np.linalg.inv(own.covariance)
        normal[part, part] += inverse
        rhs[part] += inverse @ own.mean
    for k, data in enumerate((datum, other)):
        a, b = slice(k * size, (k + 1) * size), slice((k + 1) * size, (k + 2) * size)
        for one, two in ((a, b), (b, a)):
            normal[one, one] += data.information
            normal[one, two] -= data.information
        rhs[a] -= data.rhs
        rhs[b] += data.rhs
    solved = np.linalg.solve(normal, rhs).reshape(3, size)
    design = frames.basis.design(coast.places[::20])
    for field, mean in zip(chained, solved, strict=True):
        assert field is not None
        np.testing.assert_allclose(design @ field.mean, design @ mean, atol=2e-4)


def test_positions_between_two_stations_are_as_far_off_as_stated() -> None:
    """A hundred metres hold few bends, so that single coasts scatter; no component is taken for stiff because its few were small."""
    squares, lengths, stated = [], [], []
    for seed in range(20, 44):
        coast = bent_coast(seed, length=105.0, station=52.5, density=2.0)
        frames, datum = frames_and_datum(coast)
        chained = chained_errors(frames, [datum])
        rmse, normalised = errors_of(coast, chained)
        squares.append(np.mean(normalised))
        lengths += rmse
        stated += [np.trace(field.at(coast.places).covariances[:, :3, :3].mean(axis=0)) for field in chained if field is not None]
    assert 0.7 < np.mean(squares) < 1.4
    assert max(squares) < 6.0
    assert 0.8 < np.sqrt(np.mean(np.square(lengths)) / np.mean(stated)) < 1.2


def test_a_long_coast_holds_few_matrices_of_all_unknowns_at_a_time() -> None:
    coast = bent_coast(3, length=250.0, shortest=40.0, longest=80.0)
    axis = (float(DIRECTION[0]), float(DIRECTION[1]))
    model = FieldModel(sds=(0.04, 0.04, 0.04), length=10.0, across=160.0, axis=axis)
    basis = FieldBasis.over(model, np.vstack([coast.places, coast.targets]), 0.001)
    precision = basis.precision()
    weights = np.tile(np.eye(3) / coast.target_sd**2, (len(coast.targets), 1, 1))
    matrix = 8 * basis.size**2
    tracemalloc.start()
    try:
        known = FieldEstimate.from_observations(basis, precision, coast.targets, coast.residuals[0], weights)
        estimated = tracemalloc.get_traced_memory()[1]
        information, rhs = information_of(basis, coast.places, coast.displacements, np.linalg.inv(coast.covariances))
        tracemalloc.reset_peak()
        known.informed(information, rhs)
        informed = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert basis.size > 500
    assert np.array_equal(known.covariance, known.covariance.T)
    # the covariance takes the place of the normal matrix; with it stay its product with what is added, a copy, and their symmetric part
    assert estimated < 1.7 * matrix
    assert informed < 5.5 * matrix
    # each entry there once, and most are not
    assert information.nnz < basis.size**2 / 4
