"""Common motion of stretches against errors that neighbours share."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bent_coast import DIRECTION, BentCoast, bent_coast
from curved_structures import line_of, units_along
from tetratrack.core.deformation import stretches as stretches_module
from tetratrack.core.deformation.congruence import Congruence, congruence_of
from tetratrack.core.deformation.elastic_congruence import ElasticDatum, elastic_congruence_of
from tetratrack.core.deformation.epoch_frames import PairShifts, estimate_frames
from tetratrack.core.deformation.stretches import JudgedUnits, StretchMotion, motions_of_stretches, stretches_of
from tetratrack.core.deformation.target_shifts import TargetShifts
from tetratrack.core.registration.frame_field import FieldBasis, FieldEstimate, FieldModel

HEIGHT = 2.3
PATCH = 12.0
"""Length over which units share an error, metres: what one tripod sees best."""


def stretches(seed: int, shared: float, slide: tuple[float, float] | None = None) -> list[StretchMotion]:
    """Of a stiff coast whose units share errors of ``shared`` metres within every patch."""
    coast = bent_coast(seed, rms=0.0, slide=slide, unit_sd=0.001)
    patch = (coast.places[:, :2] @ DIRECTION / PATCH).astype(np.int64)
    errors = np.random.default_rng(seed).normal(0, shared * math.sqrt(2), (patch.max() + 1, 3))
    vectors = coast.displacements + errors[patch]
    origin = coast.places.mean(axis=0)
    found = congruence_of(vectors, coast.covariances, coast.places, None, origin, HEIGHT)
    units = JudgedUnits(places=coast.places, vectors=vectors, covariances=found.null.covariance(coast.covariances))
    return motions_of_stretches(units, found, None, HEIGHT)["stable"]


def test_errors_that_neighbours_share_are_no_motion() -> None:
    coasts = [stretches(seed, 0.002) for seed in range(6)]
    assert np.mean([any(s.adjusted < 0.05 for s in coast) for coast in coasts]) <= 0.2
    assert 0.5 < np.mean([s.motion @ np.linalg.solve(s.covariance, s.motion) / 3 for coast in coasts for s in coast]) < 2.0


def test_units_with_errors_of_their_own_show_no_motion_of_stretches() -> None:
    assert not any(s.adjusted < 0.05 for seed in range(6) for s in stretches(seed, 0.0))


def of_stiff_frames(seed: int, length: float, settlement: float) -> list[StretchMotion]:
    """Stretches of a coast whose 23 m in the middle settled, of units of 3 mm, in datum ``stable``."""
    rng = np.random.default_rng(seed)
    count = round(1.15 * length)
    places = np.column_stack([np.sort(rng.uniform(0, length, count)), rng.uniform(0, 8, count), rng.uniform(0, 3, count)])
    covariances, vectors = np.tile(np.eye(3) * 0.003**2, (count, 1, 1)), rng.normal(0, 0.003, (count, 3))
    vectors[np.abs(places[:, 0] - length / 2) < 11.5, 2] -= settlement
    prior = np.diag([0.01**2] * 3 + [0.001**2] * 3 + [0.0])
    congruence = congruence_of(vectors, covariances, places, prior, places.mean(axis=0), HEIGHT)
    units = JudgedUnits(places=places, vectors=vectors, covariances=congruence.null.covariance(covariances))
    return motions_of_stretches(units, congruence, None, HEIGHT)["stable"]


@pytest.mark.parametrize("length", [92.0, 161.0])
def test_a_settled_stretch_of_stiff_frames_is_told_and_no_other(length: float) -> None:
    """Its mean is known as well as its units scatter, and what it turned the frame by is not laid to the others."""
    told, others, squares = 0, 0, []
    for seed in range(100, 112):
        rows = of_stiff_frames(seed, length, 0.010)
        apart = [row for row in rows if abs(row.place[0] - length / 2) > 22]
        told += min(rows, key=lambda row: abs(row.place[0] - length / 2)).adjusted < 0.05
        others += sum(row.adjusted < 0.05 for row in apart)
        squares += [row.motion @ np.linalg.solve(row.covariance, row.motion) / 3 for row in apart]
    assert told >= 11
    assert others == 0
    # their variance is learned from a few others, with heavy tails
    assert 0.2 < np.mean(squares) < 1.5


def test_a_single_stretch_without_control_is_all_there_is() -> None:
    """No other unit and no target says how the frames lie: it rests in its own datum, and nothing of kilometres is stated."""
    rng = np.random.default_rng(4)
    places = np.column_stack([np.sort(rng.uniform(0, 20, 40)), rng.uniform(0, 8, 40), rng.uniform(0, 3, 40)])
    covariances, vectors = np.tile(np.eye(3) * 0.003**2, (40, 1, 1)), rng.normal([3.0, -2.0, 0.5], 0.003, (40, 3))
    congruence = congruence_of(vectors, covariances, places, None, places.mean(axis=0), HEIGHT)
    units = JudgedUnits(places=places, vectors=vectors, covariances=congruence.null.covariance(covariances))
    (only,) = motions_of_stretches(units, congruence, None, HEIGHT)["stable"]
    assert np.abs(only.motion).max() < 0.001
    assert only.detectable < 0.01


def test_a_stretch_of_stiff_frames_is_judged_by_all_others() -> None:
    """A third of 69 m settles by 8 mm, too little for units of 3 mm to leave the datum one by one."""
    away, found = [], []
    for seed in range(12):
        rows = of_stiff_frames(seed, 69.0, 0.008)
        middle = min(rows, key=lambda row: abs(row.place[0] - 34.5))
        away.append((middle.motion[2] + 0.008) / math.sqrt(middle.covariance[2, 2]))
        found.append(middle.motion[2])
    assert np.mean(found) < -0.007
    assert np.mean(np.square(away)) < 2.0


@pytest.mark.parametrize(
    ("coast", "count"),
    [(bent_coast(seed, length=80.0, station=24.0, unit_sd=0.0008, target_sd=0.003), 5) for seed in (3003, 3004, 3008)]
    + [(bent_coast(7009, length=300.0, density=3.1, station=24.0, unit_sd=0.0006, target_sd=0.005), 25)],
    ids=("80 m, 3003", "80 m, 3004", "80 m, 3008", "300 m, 7009"),
)
def test_a_coast_at_rest_known_to_a_millimetre_shows_no_motion(coast: BentCoast, count: int) -> None:
    """What others say of a stretch errs as the bend is rough there: with tails as heavy as the others show, or as so few leave them."""
    names = tuple(map(str, range(len(coast.targets))))
    variances = np.full(coast.targets.shape, coast.target_sd**2)
    targets = [
        TargetShifts(
            ids=names, positions=coast.targets, residuals=own, variances=variances, surveyed_variances=np.zeros_like(variances)
        )
        for own in coast.residuals
    ]  # fmt: skip
    shifts = PairShifts(places=coast.places, vectors=coast.displacements, covariances=coast.covariances)
    frames = estimate_frames([shifts], targets, coast.places, HEIGHT, "auto")
    assert frames is not None
    control, precision = frames.between(0, 1)
    found, elastic = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, frames.degrees,
        frames.jumped(0, 1, coast.places), frames.controlled(0, 1),
    )  # fmt: skip
    units = JudgedUnits(places=coast.places, vectors=coast.displacements, covariances=found.null.covariance(coast.covariances))
    rows = motions_of_stretches(units, found, elastic, HEIGHT)
    assert all(len(own) == count and not any(s.adjusted < 0.05 for s in own) for own in rows.values())


def test_a_slide_stands_out_of_them() -> None:
    for seed in range(3):
        coast = stretches(seed, 0.002, slide=(72.0, 96.0))
        inside = [s for s in coast if s.along_from >= 68 and s.along_to <= 100]
        apart = [s for s in coast if s.along_to <= 72 or s.along_from >= 96]
        assert all(s.adjusted < 0.05 for s in inside)
        assert sum(s.adjusted < 0.05 for s in apart) <= 1
        assert inside


def bent(length: float) -> tuple[JudgedUnits, Congruence, ElasticDatum]:
    """Units of a coast of ``length`` metres that bends by 3 cm over 15 m, with a slide, and both datums as fields."""
    coast = bent_coast(3, length=length, shortest=40.0, longest=80.0, slide=(40.0, 64.0))
    axis = (float(DIRECTION[0]), float(DIRECTION[1]))
    model = FieldModel(sds=(0.04, 0.04, 0.04), length=15.0, across=240.0, axis=axis)
    basis = FieldBasis.over(model, np.vstack([coast.places, coast.targets]), 0.002)
    targets = np.tile(np.eye(3) / (2 * coast.target_sd**2), (len(coast.targets), 1, 1))
    control = FieldEstimate.from_observations(
        basis, basis.precision(), coast.targets, coast.residuals[1] - coast.residuals[0], targets
    )  # fmt: skip
    precision = np.linalg.inv(control.covariance)
    nothing = np.zeros(len(coast.places), dtype=bool)
    found, elastic = elastic_congruence_of(
        coast.displacements, coast.covariances, coast.places, control, precision, HEIGHT, 40.0, nothing, controlled=True
    )
    units = JudgedUnits(places=coast.places, vectors=coast.displacements, covariances=found.null.covariance(coast.covariances))
    return units, found, elastic


def test_a_stretch_taken_out_leaves_what_an_adjustment_without_it_says(monkeypatch: pytest.MonkeyPatch) -> None:
    units, found, elastic = bent(250.0)
    assert elastic.control.basis.size > stretches_module.MOST_ANEW
    taken_out = motions_of_stretches(units, found, elastic, HEIGHT)
    monkeypatch.setattr(stretches_module, "MOST_ANEW", elastic.control.basis.size)
    anew = motions_of_stretches(units, found, elastic, HEIGHT)
    for datum in ("stable", "control"):
        assert len(anew[datum]) > 15
        for one, other in zip(taken_out[datum], anew[datum], strict=True):
            assert one.motion == pytest.approx(other.motion, abs=1e-8)
            assert one.covariance == pytest.approx(other.covariance, rel=1e-6, abs=1e-12)
            assert one.adjusted == pytest.approx(other.adjusted, rel=1e-5)


def test_a_longer_coast_has_no_larger_matrices_of_a_stretch(monkeypatch: pytest.MonkeyPatch) -> None:
    sizes: dict[float, list[int]] = {}
    solve = np.linalg.solve
    for length in (250.0, 500.0):
        units, found, elastic = bent(length)
        solved = sizes.setdefault(length, [])

        def counted(matrix: np.ndarray, right: np.ndarray, solved: list[int] = solved) -> np.ndarray:
            solved.append(len(matrix))
            return solve(matrix, right)

        with monkeypatch.context() as patch:
            patch.setattr(np.linalg, "solve", counted)
            patch.setattr(FieldEstimate, "from_observations", None)
            motions_of_stretches(units, found, elastic, HEIGHT)
    assert max(sizes[500.0]) <= 1.1 * max(sizes[250.0]) < elastic.control.basis.size / 3
    assert len(sizes[500.0]) < 2.2 * len(sizes[250.0])


def settled(places: np.ndarray, moved: np.ndarray, seed: int) -> list[tuple[StretchMotion, float]]:
    """Every stretch of units known to 3 mm, of which those ``moved`` settled by 20 mm, with the share of these in it."""
    noise = np.random.default_rng(seed).normal(0, 0.003, places.shape)
    vectors = noise - moved[:, None] * [0.0, 0.0, 0.02]
    covariances = np.tile(0.003**2 * np.eye(3), (len(places), 1, 1))
    registered = np.diag([0.004**2] * 3 + [1e-5**2] * 3 + [0.0])
    found = congruence_of(vectors, covariances, places, registered, places.mean(axis=0), HEIGHT)
    units = JudgedUnits(places=places, vectors=vectors, covariances=found.null.covariance(covariances))
    motions = motions_of_stretches(units, found, None, HEIGHT)["stable"]
    stretches = [own for own in stretches_of(places, HEIGHT)[0] if len(own) >= stretches_module.FEWEST_UNITS]
    return [(motion, float(moved[own].mean())) for motion, own in zip(motions, stretches, strict=True)]


@pytest.mark.parametrize("name", ["L", "U", "head", "ring"])
def test_a_settled_stretch_of_one_arm_is_found_where_a_structure_turns(name: str) -> None:
    """Chainage follows the structure: arms side by side, the far end behind a corner and a round head are stretches of their own."""
    for seed in range(2):
        places, chainage, _ = units_along(line_of(name), seed)
        stretches = [own for own in stretches_of(places, HEIGHT)[0] if len(own) >= stretches_module.FEWEST_UNITS]
        own = stretches[np.random.default_rng(seed).integers(len(stretches))]
        moved = (chainage >= chainage[own].min()) & (chainage <= chainage[own].max())
        assert moved.sum() < 2 * len(own), "a stretch is ground of one arm"
        found = settled(places, moved, seed)
        most = max(found, key=lambda stretch: stretch[1])[0]
        assert most.adjusted < 0.01
        assert abs(most.motion[2] + 0.02) < 2 * most.covariance[2, 2] ** 0.5
        assert not any(motion.adjusted < 0.05 for motion, share in found if share == 0)
