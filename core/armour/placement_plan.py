"""As-built units against a placement plan: which unit stands at which place, how far from it, and whether that is within the tolerance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..results.geopackage_reader import Row
from ..results.unit_rows import Z_95, sd_of_length
from .as_built import AsBuilt
from .design_files import PlacementPlan
from .placement import turns

SEARCH_HEIGHTS = 1.0
"""A unit farther than this from every free place stands at none, heights H."""
MUCH_NEARER = 0.5
"""Distance of the nearest unit from a planned place over that of the unit of its name, below which the name is another unit's."""


@dataclass(frozen=True, kw_only=True)
class Tolerance:
    """What may be: ``place`` metres in space, ``turn`` degrees; None does not judge."""

    place: float | None = None
    turn: float | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class PlanComparison:
    """Units against their planned places.

    Attributes
    ----------
    deviations, unmatched
        Rows of ``plan_deviations`` and ``plan_unmatched``.
    doubt
        What is to be known of the names by which units were paired, or were not; '' for nothing.
    """

    deviations: list[dict[str, Any]]
    unmatched: list[dict[str, Any]]
    doubt: str = ""

    def count(self, verdict: str) -> int:
        """Units with a verdict."""
        return sum(row["verdict"] == verdict for row in self.deviations)

    @property
    def median(self) -> float:
        """Median deviation, metres."""
        return float(np.median([row["d_3d"] for row in self.deviations]))

    @property
    def most(self) -> float:
        """Largest deviation, metres."""
        return float(max(row["d_3d"] for row in self.deviations))

    @property
    def worst(self) -> list[dict[str, Any]]:
        """The units farthest from their place, at most twenty."""
        return sorted(self.deviations, key=lambda row: (-float(row["d_3d"]), str(row["plan_id"])))[:20]


def compare_with_plan(model: AsBuilt, plan: PlacementPlan, tolerance: Tolerance) -> PlanComparison:
    """Units of an epoch less their planned places.

    A unit stands at the place of its own name where all names of the plan are names of units, and at most planned places no other unit
    stands much nearer; else pairs are formed from the nearest on, up to one height H. Runs name units anew: a plan may bear the names of an
    earlier one.
    """
    names = [unit.unit_id for unit in model.units]
    centres = np.array([unit.shape.centre for unit in model.units])
    reach = SEARCH_HEIGHTS * max(float(unit.row["height"]) for unit in model.units)
    pairs, doubt = nearest_pairs(plan.places, centres, reach), ""
    if set(plan.ids) <= set(names):
        number = {name: k for k, name in enumerate(names)}
        named = np.array([number[name] for name in plan.ids])
        other = _others_stand_there(plan.places, centres, named)
        by_name = 2 * other <= len(named)
        pairs = list(enumerate(named.tolist())) if by_name else pairs
        if other:
            how = "all were paired by name" if by_name else "units were paired by place instead"
            doubt = f"at {other} of {len(named)} planned places another unit stands much nearer than the one of that name: {how}"
    deviations = [_deviation(model, plan, tolerance, planned, built) for planned, built in sorted(pairs)]
    at = {planned for planned, _ in pairs}
    standing = {built for _, built in pairs}
    missing = [k for k in range(len(plan.ids)) if k not in at]
    extra = [k for k in range(len(names)) if k not in standing]
    unmatched = [_unmatched("missing", plan.places[k], centres, model.epoch) | {"plan_id": plan.ids[k]} for k in missing]
    unmatched += [_unmatched("extra", centres[k], plan.places, model.epoch) | {"unit_id": names[k]} for k in extra]
    return PlanComparison(deviations=deviations, unmatched=unmatched, doubt=doubt)


def _others_stand_there(places: FloatArray, centres: FloatArray, named: IntArray) -> int:
    """Planned places (n, 3) at which a unit stands much nearer than the one with its name, by number (n,) among the ``centres``."""
    from scipy.spatial import cKDTree

    nearest = cKDTree(centres).query(places)[0]
    return int(np.sum(nearest < MUCH_NEARER * np.linalg.norm(centres[named] - places, axis=1)))


def nearest_pairs(first: FloatArray, second: FloatArray, reach: float) -> list[tuple[int, int]]:
    """Pairs of places nearer than ``reach`` metres, from the nearest on, each place in one pair at most."""
    from scipy.spatial import cKDTree

    found = cKDTree(first).sparse_distance_matrix(cKDTree(second), reach, output_type="ndarray")
    pairs: list[tuple[int, int]] = []
    taken: tuple[set[int], set[int]] = (set(), set())
    for i, j, _ in sorted(found.tolist(), key=lambda entry: (entry[2], entry[0], entry[1])):
        if i not in taken[0] and j not in taken[1]:
            pairs.append((i, j))
            taken[0].add(i)
            taken[1].add(j)
    return pairs


def verdict(values: Sequence[tuple[float | None, float | None, float | None]]) -> str | None:
    """``within``, ``outside`` or ``open`` of values with their standard deviations and limits; None where there is nothing to judge."""
    judged = [(abs(value), Z_95 * (sd or 0.0), limit) for value, sd, limit in values if value is not None and limit is not None]
    if not judged:
        return None
    if any(value - half > limit for value, half, limit in judged):
        return "outside"
    return "within" if all(value + half <= limit for value, half, limit in judged) else "open"


def _deviation(model: AsBuilt, plan: PlacementPlan, tolerance: Tolerance, planned: int, built: int) -> dict[str, Any]:
    unit = model.units[built]
    vector = unit.shape.centre - plan.places[planned]
    length = float(np.linalg.norm(vector))
    sd = _sds(unit.row)
    sd_3d = None if sd is None else sd_of_length(vector, sd)
    turn = None
    if plan.turned[planned]:
        symmetries = model.solids[unit.solid].unit.symmetries
        turn = float(turns(plan.rotations[planned][None], unit.shape.rotation[None], symmetries)[0])
    sd_turn = unit.row.get("sd_rotation_deg")
    return {
        "geometry": np.array([plan.places[planned], unit.shape.centre]),
        "plan_id": plan.ids[planned],
        "unit_id": unit.unit_id,
        "epoch": model.epoch,
        "de": float(vector[0]),
        "dn": float(vector[1]),
        "dh": float(vector[2]),
        "d_horizontal": math.hypot(vector[0], vector[1]),
        "d_3d": length,
        "sd_3d": sd_3d,
        "rotation_deg": turn,
        "sd_rotation_deg": sd_turn,
        "verdict": verdict([(length, sd_3d, tolerance.place), (turn, sd_turn, tolerance.turn)]),
    }


def _sds(row: Row) -> FloatArray | None:
    values = [row.get(name) for name in ("sd_e", "sd_n", "sd_h")]
    return None if any(value is None for value in values) else np.array(values, dtype=np.float64)


def _unmatched(kind: str, place: FloatArray, others: FloatArray, epoch: str) -> dict[str, Any]:
    return {"kind": kind, "geometry": place, "epoch": epoch, "nearest": float(np.linalg.norm(others - place, axis=1).min())}
