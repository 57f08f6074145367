"""Normal equations of strips that drift: the sum of what units say, in a memory that follows the strips and not the units."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from curved_structures import line_of, units_along
from tetratrack.core.deformation.strip_drifts import GAUGE_WEIGHT, DriftSystem, Knots, StripDrifts, UnitEquations
from tetratrack.core.deformation.strip_systems import DriftStep

HEIGHT, STRIPS = 2.3, 12


def coast(units: int, length: float, reach: int = STRIPS) -> tuple[Knots, list[UnitEquations]]:
    """Units along ``length`` metres, each seen by some strips out of ``reach`` that follow each other."""
    rng = np.random.default_rng(units)
    along = np.sort(rng.uniform(0, length, units))
    along[[0, -1]] = 0, length
    knots = Knots.along(np.column_stack([along, np.zeros((units, 2))]), HEIGHT)
    assert knots is not None
    equations = []
    for unit, place in enumerate(along):
        first = round(place / length * (STRIPS - reach))
        strips = np.sort(rng.permutation(np.arange(first, first + reach))[: max(reach - 2, 1)])
        root = rng.normal(size=(3 * len(strips), 8)) / 0.01
        equations.append(
            UnitEquations(
                unit=unit, strips=strips, upper=(root @ root.T)[np.triu_indices(len(root))], rhs=root @ rng.normal(size=8)
            )
        )  # fmt: skip
    return knots, equations


def system(knots: Knots, equations: list[UnitEquations]) -> DriftSystem:
    epochs = np.repeat([0, 1], STRIPS // 2)
    return DriftSystem(knots, epochs, equations, np.full(STRIPS, 0.02), {k: k for k in range(len(equations))})


@pytest.mark.parametrize("reach", [STRIPS, 4])
def test_every_unit_counts_between_its_two_knots(reach: int) -> None:
    knots, equations = coast(60, 80.0, reach)
    drifts = system(knots, equations)
    total = np.zeros((drifts.size, drifts.size))
    for own in equations:
        rows = np.zeros((3 * len(own.strips), drifts.size))
        for knot, weight in knots.weights(own.unit):
            rows[np.arange(len(rows)), drifts.columns(knot, own.strips)] = weight
        total += rows.T @ own.normal @ rows
    assert drifts.normal.toarray() == pytest.approx(total, rel=1e-12, abs=1e-12 * np.abs(total).max())
    assert drifts.gauge.toarray() == pytest.approx(drifts.gauge.toarray().T)


@pytest.mark.parametrize("reach", [STRIPS, 4])
def test_covariance_of_the_strips_that_see_a_unit_is_that_of_all_unknowns(reach: int) -> None:
    knots, equations = coast(60, 80.0, reach)
    drifts = system(knots, equations)
    rate = 0.002
    _, factor = drifts.solve(rate, np.zeros((knots.count, STRIPS, 3)))
    whole = np.linalg.inv((drifts.normal + drifts.prior(rate)).toarray())
    cofactors = drifts.cofactors(factor)
    for own in equations[::7]:
        rows = np.zeros((3 * len(own.strips), drifts.size))
        for knot, weight in knots.weights(own.unit):
            rows[np.arange(len(rows)), drifts.columns(knot, own.strips)] = weight
        lever = drifts.lever(own.unit, own.strips)
        covariance = lever @ cofactors[int(knots.first[own.unit])] @ lever.T
        assert covariance == pytest.approx(rows @ whole @ rows.T, rel=1e-6, abs=1e-9 * np.abs(covariance).max())
    assert drifts.mean_sds(cofactors).shape == (STRIPS, 3)


def at_all_knots(knots: Knots, equations: list[UnitEquations], rate: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Normal matrix, prior and right-hand side of every strip at every knot, by knot, strip and axis."""
    size = 3 * STRIPS * knots.count
    normal, prior, rhs, seen = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size), np.zeros((knots.count, STRIPS))
    for own in equations:
        rows = np.zeros((3 * len(own.strips), size))
        for knot, weight in knots.weights(own.unit):
            columns = (3 * (knot * STRIPS + own.strips)[:, None] + np.arange(3)).ravel()
            rows[np.arange(len(rows)), columns] = weight
            seen[knot, own.strips] += weight
        normal += rows.T @ own.normal @ rows
        rhs += rows.T @ own.rhs
    steps = np.kron(np.diff(np.eye(knots.count), axis=0), np.eye(3 * STRIPS))
    prior = steps.T @ steps / (rate**2 * knots.spacing) + np.eye(size) / (knots.count * 0.02**2)
    for knot in range(knots.count):
        for own in np.split(np.arange(STRIPS), 2):
            if seen[knot, own].any():
                share = seen[knot, own] / seen[knot, own].sum()
                for axis in range(3):
                    columns = 3 * (knot * STRIPS + own) + axis
                    prior[np.ix_(columns, columns)] += GAUGE_WEIGHT / 0.02**2 * np.outer(share, share)
    return normal, prior, rhs


@pytest.mark.parametrize("reach", [STRIPS, 4])
def test_what_no_unit_sees_of_a_strip_is_eliminated_exactly(reach: int) -> None:
    knots, equations = coast(60, 80.0, reach)
    # without units in the middle, where some strips end
    equations = [own for own in equations if not 3 <= knots.first[own.unit] <= 5]
    drifts = system(knots, equations)
    rate, at = 0.002, np.zeros((knots.count, STRIPS, 3))
    normal, prior, rhs = at_all_knots(knots, equations, rate)
    whole = np.linalg.inv(normal + prior)
    for _ in range(2):
        # the second step ends where the first one did, had the right-hand side stayed
        expected = (whole @ (rhs - prior @ at.ravel())).reshape(at.shape)
        change, factor = drifts.solve(rate, at)
        assert change == pytest.approx(expected, rel=1e-6, abs=1e-9 * np.abs(expected).max())
        at = at + change
    cofactors = drifts.cofactors(factor)
    for k, strips in drifts.seen.items():
        columns = np.concatenate([(3 * (knot * STRIPS + strips)[:, None] + np.arange(3)).ravel() for knot in (k, k + 1)])
        assert cofactors[k] == pytest.approx(whole[np.ix_(columns, columns)], rel=1e-6, abs=1e-9 * np.abs(cofactors[k]).max())

    def log_likelihood(rate: float) -> float:
        normal, prior, rhs = at_all_knots(knots, equations, rate)
        return float(
            0.5 * rhs @ np.linalg.solve(normal + prior, rhs)
            - 0.5 * np.linalg.slogdet(normal + prior)[1]
            + 0.5 * np.linalg.slogdet(prior)[1]
        )

    gain = drifts.log_likelihood(0.004) - drifts.log_likelihood(0.001)
    assert gain == pytest.approx(log_likelihood(0.004) - log_likelihood(0.001), rel=1e-6)


def test_unknowns_grow_with_the_coast() -> None:
    """Strips of a long coast see stretches of it: twice as many of them have twice the unknowns."""

    def long_coast(stretches: int) -> DriftSystem:
        parts = [coast(40, 40.0) for _ in range(stretches)]
        along = np.concatenate([(knots.first + knots.share) * knots.spacing + 40.0 * k for k, (knots, _) in enumerate(parts)])
        knots = Knots.along(np.column_stack([along, np.zeros((len(along), 2))]), HEIGHT)
        assert knots is not None
        moved = [
            UnitEquations(unit=40 * k + own.unit, strips=STRIPS * k + own.strips, upper=own.upper, rhs=own.rhs)
            for k, (_, equations) in enumerate(parts)
            for own in equations
        ]
        strips = STRIPS * stretches
        return DriftSystem(knots, np.arange(strips) % 2, moved, np.full(strips, 0.02), {k: k for k in range(len(moved))})

    few, many = long_coast(4), long_coast(8)
    assert many.size < 2.2 * few.size
    assert (many.normal + many.prior(0.002)).nnz < 2.2 * (few.normal + few.prior(0.002)).nnz


def test_covariances_wait_until_they_are_asked_for() -> None:
    knots, equations = coast(60, 80.0)
    step = DriftStep(system(knots, equations), 0.002, np.zeros((knots.count, STRIPS, 3)))
    assert "cofactors" not in vars(step)
    assert step.covariance(3, equations[3].strips).shape == (3 * len(equations[3].strips),) * 2
    assert "cofactors" in vars(step)


def test_memory_follows_the_coast_and_not_the_units_on_it() -> None:
    def peak(units: int) -> int:
        knots, equations = coast(units, 80.0)
        tracemalloc.start()
        system(knots, equations)
        try:
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    few, many = peak(100), peak(400)
    # one unit's own entries are 86 kB
    assert (many - few) / 300 < 1000


def test_strips_that_see_a_stretch_take_memory_there_alone() -> None:
    wide, local = (system(*coast(200, 160.0, reach)) for reach in (STRIPS, 4))
    assert local.normal.nnz < wide.normal.nnz / 4
    _, factor = local.solve(0.002, np.zeros((local.knots.count, STRIPS, 3)))
    assert max(len(c) for c in local.cofactors(factor).values()) <= 6 * 6


@pytest.mark.parametrize("groups", [1, 6])
def test_variance_of_the_mean_drift_is_what_strips_that_differ_say(groups: int) -> None:
    """Four strips about their own mean at every place, 400 draws: half of their own deviation is stated, however many see other places."""
    rng = np.random.default_rng(7)
    knots = Knots(count=5 * groups, spacing=8.0, first=np.zeros(1, dtype=np.int64), share=np.zeros(1))
    lone = 4 * groups
    numbers = {(0, source): source for source in range(lone)} | {(1, 9): lone}
    seen = {5 * g + k: np.array([*range(4 * g, 4 * g + 4), lone]) for g in range(groups) for k in range(4)}
    stated = []
    for _ in range(400):
        values = np.zeros((5 * groups, lone + 1, 3))
        for g in range(groups):
            own = rng.normal(0, [0.03, 0.02, 0.01], (4, 3))
            values[5 * g : 5 * g + 5, 4 * g : 4 * g + 4] = own - own.mean(axis=0)
        drifts = StripDrifts(knots=knots, numbers=numbers, values=values, places={0: 0}, seen=seen)
        stated.append(drifts.variances_of_mean(0))
    assert np.mean(stated, axis=0) == pytest.approx(np.square([0.015, 0.01, 0.005]), rel=0.1)
    assert not drifts.variances_of_mean(1).any()


def test_arms_of_a_harbour_share_no_knots() -> None:
    for name in ("L", "U", "head"):
        places, chainage, straight = units_along(line_of(name), 0)
        knots, reference = Knots.along(places, HEIGHT), Knots.along(straight, HEIGHT)
        assert knots is not None
        assert reference is not None
        assert abs(knots.count - reference.count) <= 2
        for k in range(knots.count - 1):
            assert np.ptp(chainage[knots.first == k]) < 3 * knots.spacing
