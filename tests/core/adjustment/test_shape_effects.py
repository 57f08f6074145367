"""Castings as random effects: elimination equals the direct solution, variances and mould of simulated cells are found again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tetratrack.core.adjustment.shape_effects import (
    AXIAL_CELLS,
    AZIMUTH_CELLS,
    CELLS,
    COMPONENTS,
    LEG_CELLS,
    CellSums,
    SurfaceModel,
    cell_places,
    eliminate,
    prior_surface,
    smooth_factors,
    structures,
)
from tetratrack.core.adjustment.surface_estimation import LEAST_MOULD_UNITS, SampledUnit, estimate_surface

HEIGHT = 2.0
NOISE = 0.002


def sighting(rng: np.random.Generator, deviations: np.ndarray, seen: np.ndarray, columns: slice, size: int) -> CellSums:
    """Cells of one sighting of a unit whose pose is right, with random but smooth derivatives by its six unknowns."""
    _, axial, azimuth, disc = cell_places()
    weight = np.where(seen, 50 / NOISE**2, 0.0)
    design = np.zeros((CELLS, size))
    base = np.column_stack([np.cos(azimuth), np.sin(azimuth), disc, axial * np.cos(azimuth), axial * np.sin(azimuth), axial])
    leg = np.repeat(np.arange(4), LEG_CELLS)
    design[:, columns] = np.einsum("ck,ckl->cl", base, rng.normal(0, 1, (4, 6, 6))[leg])
    design[:, -1] = -0.5
    values = deviations + rng.normal(0, 1, CELLS) * NOISE / np.sqrt(50)
    return CellSums(design * weight[:, None], weight, -weight * values, weight * (values**2 + NOISE**2), NOISE)


def whole_unit(leg: np.ndarray) -> np.ndarray:
    """(CELLS, CELLS) of all legs, which nothing ties, from what holds of the cells of each."""
    return np.kron(np.eye(4), leg)


def castings(seed: int, count: int, variances: np.ndarray, mould: np.ndarray) -> list[SampledUnit]:
    """Units seen in two epochs from different sides."""
    rng = np.random.default_rng(seed)
    root = whole_unit(np.linalg.cholesky(np.tensordot(variances, structures(), axes=1) + 1e-12 * np.eye(LEG_CELLS)))
    units = []
    for _ in range(count):
        deviations = mould + root @ rng.normal(size=CELLS)
        pair = [sighting(rng, deviations, rng.random(CELLS) < 0.25, slice(6 * k, 6 * k + 6), 13) for k in range(2)]
        units.append(SampledUnit(0.0, pair, [prior_surface(HEIGHT).own_of(sums) for sums in pair]))
    return units


def test_elimination_equals_the_direct_solution() -> None:
    rng = np.random.default_rng(1)
    surface = replace(prior_surface(HEIGHT), mean=rng.normal(0, 0.003, CELLS))
    sums = sighting(rng, rng.normal(0, 0.004, CELLS), rng.random(CELLS) < 0.2, slice(0, 6), 7)
    cells = np.flatnonzero(sums.weight)
    x = sums.rows[cells] / sums.weight[cells, None]
    y = sums.rhs[cells] / sums.weight[cells] + surface.mean[cells]
    total = whole_unit(surface.covariance)[np.ix_(cells, cells)] + np.diag(1 / sums.weight[cells] + surface.own_of(sums)[cells])
    expected = x.T @ np.linalg.solve(total, x), x.T @ np.linalg.solve(total, y)
    found = eliminate(sums.rows[cells].T @ x, x.T @ sums.rhs[cells], [sums], surface, surface.covariance)
    assert found.normal == pytest.approx(expected[0], rel=1e-6, abs=1e-6 * np.abs(expected[0]).max())
    assert found.rhs == pytest.approx(expected[1], rel=1e-6, abs=1e-6 * np.abs(expected[1]).max())
    assert found.misfit == pytest.approx(y @ np.linalg.solve(total, y))
    assert found.seen == len(cells)


def test_smooth_parts_are_products_of_their_factors() -> None:
    _, axial, azimuth, disc = (values[:LEG_CELLS] for values in cell_places())
    tilt = structures()[COMPONENTS.index("tilt")]
    a, b = 3 * AZIMUTH_CELLS + 1, 7 * AZIMUTH_CELLS + 5
    expected = (axial[a] - 0.55) * (axial[b] - 0.55) / 0.09 * np.cos(azimuth[a] - azimuth[b])
    assert tilt[a, b] == pytest.approx(expected)
    assert not tilt[disc == 1].any()
    for columns, correlation in zip(smooth_factors(), structures(), strict=False):
        assert np.linalg.matrix_rank(correlation) == columns.shape[1]


def test_a_cell_in_which_two_epochs_contradict_each_other_loses_weight() -> None:
    rng = np.random.default_rng(2)
    surface = prior_surface(HEIGHT)
    pair = [sighting(rng, np.zeros(CELLS), np.ones(CELLS, dtype=bool), slice(6 * k, 6 * k + 6), 13) for k in range(2)]
    spoilt = 5 * AZIMUTH_CELLS + 3
    pair[1].rhs[spoilt] -= 0.02 * pair[1].weight[spoilt]
    found = eliminate(np.eye(13), np.zeros(13), pair, surface, surface.covariance)
    assert found.own[1][spoilt] > 30 * np.median(found.own[1])


def test_cells_that_stand_apart_in_all_epochs_no_longer_pull_the_pose() -> None:
    surface = prior_surface(HEIGHT)
    covariance = surface.covariance
    root = whole_unit(np.linalg.cholesky(covariance + 1e-12 * np.eye(LEG_CELLS)))
    touched = 5 * AZIMUTH_CELLS + np.array([0, 6, 12])
    forms = np.zeros(2)
    for seed in range(4):
        rng = np.random.default_rng(seed)
        shape, seen = root @ rng.normal(size=CELLS), rng.random(CELLS) < 0.3
        seen[touched] = True
        neighbour = np.zeros(CELLS)
        neighbour[touched] = -0.06
        clean, disturbed = (
            [sighting(np.random.default_rng(seed + 9), shape + beside, seen, slice(6 * k, 6 * k + 6), 13) for k in range(2)]
            for beside in (np.zeros(CELLS), neighbour)
        )
        known = adjusted(clean, surface, covariance, None)
        first = held = adjusted(disturbed, surface, covariance, None)
        for _ in range(4):
            held = adjusted(disturbed, surface, covariance, held[1])
        assert first[1][touched].min() > 3 * known[1].max()
        forms += [(found[0] - known[0]) @ known[2] @ (found[0] - known[0]) for found in (first, held)]
    assert forms[1] < 0.5 * forms[0]


def adjusted(
    pair: list[CellSums], surface: SurfaceModel, covariance: np.ndarray, apart: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unknowns of a unit, what stands apart in its cells, and its normal matrix."""
    normal, rhs = np.diag(np.full(13, 1e-6)), np.zeros(13)
    for sums in pair:
        cells = np.flatnonzero(sums.weight)
        design = sums.rows[cells] / sums.weight[cells, None]
        normal += design.T @ sums.rows[cells]
        rhs += design.T @ sums.rhs[cells]
    found = eliminate(normal, rhs, pair, surface, covariance, apart=apart)
    return np.linalg.solve(found.normal, found.rhs), found.apart, found.normal


def test_variances_and_mould_are_found_again() -> None:
    mould = np.zeros(CELLS)
    _, axial, _, disc = cell_places()
    mould[(axial < 0.3) & (disc == 0)] = 0.008
    true = (np.array([3.0, 0.5, 3.0, 0.5, 2.0, 2.0, 0.5, 1.0, 0.5]) * 1e-3) ** 2
    surface = estimate_surface(castings(3, 24, true, mould), HEIGHT, prior_surface(HEIGHT))
    found = dict(zip(COMPONENTS, np.sqrt(surface.variances) * 1e3, strict=True))
    assert 2.0 < found["radius"] < 4.2
    assert 2.0 < found["axis"] < 4.2
    assert 1.3 < found["ovality"] < 2.8
    rings = surface.mean[: AXIAL_CELLS * AZIMUTH_CELLS].reshape(AXIAL_CELLS, -1).mean(axis=1)
    assert rings[:3] - rings[4:8].mean() == pytest.approx(0.008, abs=0.002)


@pytest.mark.parametrize("count", [3, 10])
def test_true_cones_are_not_held_to_what_is_customary_of_castings(count: int) -> None:
    """Each smooth component of ten times truer units is told by a few degrees of freedom only: all together say how true they are."""
    smooth = slice(0, COMPONENTS.index("patch"))
    prior = prior_surface(HEIGHT)
    for share, low, high in ((0.1, 0.07, 0.4), (1.0, 0.6, 1.5)):
        true = prior.variances.copy()
        true[smooth] *= share**2
        found = estimate_surface(castings(7, count, true, np.zeros(CELLS)), HEIGHT, prior)
        ratios = np.sqrt(found.variances / prior.variances)[smooth]
        assert (ratios > low).all()
        assert (ratios < high).all()


def test_one_component_that_is_far_off_says_nothing_of_the_others() -> None:
    """Legs of a worn series are six times as uneven in radius as is customary; tilts of their ends are as before."""
    prior = prior_surface(HEIGHT)
    true = prior.variances.copy()
    true[COMPONENTS.index("radius")] *= 36
    ratios = [np.sqrt(estimate_surface(castings(seed, 4, true, np.zeros(CELLS)), HEIGHT, prior).variances / true) for seed in range(6)]
    typical = np.exp(np.mean(np.log(ratios), axis=0))
    smooth = slice(0, COMPONENTS.index("patch"))
    assert (typical[smooth] > 0.6).all()
    assert (typical[smooth] < 1.4).all()


def test_few_units_make_no_mould() -> None:
    few = castings(4, LEAST_MOULD_UNITS - 1, prior_surface(HEIGHT).variances, np.full(CELLS, 0.01))
    assert not estimate_surface(few, HEIGHT, prior_surface(HEIGHT)).mean.any()
    assert estimate_surface([], HEIGHT, prior_surface(HEIGHT)).units == 0


def test_a_stored_mould_is_held_and_its_spread_is_where_a_survey_starts() -> None:
    true = prior_surface(HEIGHT).variances
    learned = estimate_surface(castings(3, 24, true, np.full(CELLS, 0.004)), HEIGHT, prior_surface(HEIGHT))
    held = estimate_surface(castings(5, 2, true, np.zeros(CELLS)), HEIGHT, learned, learned)
    assert held.mean == pytest.approx(learned.mean)
    # two units say little against twenty-four
    assert np.sqrt(held.variances / learned.variances) == pytest.approx(np.ones(len(true)), abs=0.35)
    assert held.units == 2
