"""Units of a drafted survey: their sizes from the cloud itself, and the areas of several sizes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..common.arrays import FloatArray
from ..common.feedback import Feedback
from ..data.folder_epochs import FoundEpoch
from ..data.survey import Ring
from ..data.survey_draft import DraftUnit
from ..data.tiles import inspect_tile
from ..model.unit_types import catalogue
from ..segmentation.unit_size import FoundSize, estimate_everywhere
from .cloud_sample import sample_points
from .no_units import why_no_units

CATALOGUE_NEAR = 0.012
"""A catalogue unit whose height differs by less is named beside the estimate."""
ASTRAY = 0.05
"""Share of the units of a size that may stand among those of another: what was taken for a unit there and is none."""


def draft_units(
    epochs: Sequence[FoundEpoch], crs: str, tiles_crs: str | None, height: float | None, feedback: Feedback
) -> tuple[tuple[DraftUnit, ...], list[str], list[str]]:
    """Types of unit, questions and warnings of a draft, from the cloud of its first epoch where the height is not given."""
    if height is not None:
        return (DraftUnit(height=height, reasons={"height": "given"}),), [], []
    if not crs:
        return (DraftUnit(height=None, reasons={"height": "estimated once the CRS is known"}),), [], []
    tiles = [inspect_tile(tile.path, crs, undeclared_crs=tiles_crs) for tile in epochs[0].tiles]
    points, origin = sample_points(tiles, crs, is_cancelled=feedback.is_cancelled)
    feedback.info(
        f"size of the units: looking at {len(points)} points of epoch {epochs[0].label}; the first time, programs are compiled: a minute"
    )
    sizes = estimate_everywhere(points, progress=feedback.progress)
    if not sizes:
        reason = why_no_units(points)
        question = f"no tetrapods were found: {reason}"
        return (DraftUnit(height=None, reasons={"height": "give it with --height"}),), [question], []
    for size in sizes:
        feedback.info(f"units of {_stated(size)}: {_evidence(size)}")
    areas = unit_areas(sizes, points, origin)
    warnings = []
    if len(sizes) > 1 and areas is None:
        warnings.append("units of several sizes lie among each other: give each [[unit]] an area, or keep the size you want")
    units = tuple(_unit(size, areas[k] if areas else None) for k, size in enumerate(sizes))
    questions = [_question(size) for size in sizes if not size.sure]
    return units, questions, warnings


def _unit(size: FoundSize, area: Ring | None) -> DraftUnit:
    unit = size.unit
    height = _rounded(unit.height, size.uncertainty)
    near = min(catalogue().values(), key=lambda other: abs(other.height / unit.height - 1))
    named = f"; near {near.name} ({near.height:.2f} m)" if abs(near.height / unit.height - 1) < CATALOGUE_NEAR else ""
    reasons = {"height": f"estimated from the cloud: {_evidence(size)}{named}", "area": "where units of this size were found"}
    if size.standard and not size.noisy:
        return DraftUnit(height=height, area=area, reasons=reasons)
    reasons["calibrate"] = (
        "the points are too noisy to tell the proportions at once" if size.noisy else "proportions differ from the standard"
    )
    shape = {} if size.noisy else {"radius": unit.radius, "gradient": unit.gradient}
    return DraftUnit(height=height, calibrate=True, area=area, reasons=reasons, **shape)


def _rounded(height: float, uncertainty: float) -> float:
    """The height with as many digits as it is known to."""
    digits = max(0, -math.floor(math.log10(max(uncertainty, 1e-6))))
    return round(height, digits)


def _stated(size: FoundSize) -> str:
    return f"{size.unit.height:.3g} m height"


def _evidence(size: FoundSize) -> str:
    low, high = size.unit.height - size.uncertainty, size.unit.height + size.uncertainty
    return f"{counted(size.trial.units, 'unit')} stand out, height between {low:.4g} and {high:.4g} m"


def _question(size: FoundSize) -> str:
    choices = [f"{size.unit.height:.3g} m ({_evidence(size)})"]
    choices += [f"{rival.height:.3g} m ({counted(rival.units, 'unit')})" for rival in size.rivals]
    return f"the size of the units is not sure; give one with --height: {', '.join(choices)}"


def unit_areas(sizes: Sequence[FoundSize], points: FloatArray, origin: FloatArray) -> list[Ring] | None:
    """Rectangles that part sizes which lie apart, absolute positions; None for one size, or where they lie among each other."""
    if len(sizes) == 1:
        return None
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    margin = 3 * max(size.unit.height for size in sizes)
    boxes = [[low - margin, high + margin] for _ in sizes]
    for a in range(len(sizes)):
        for b in range(a):
            parted = _parted(sizes[a].centres, sizes[b].centres)
            if parted is None:
                return None
            axis, cut, in_order = parted
            first, second = (a, b) if in_order else (b, a)
            boxes[first][1] = np.where(np.arange(2) == axis, np.minimum(boxes[first][1], cut), boxes[first][1])
            boxes[second][0] = np.where(np.arange(2) == axis, np.maximum(boxes[second][0], cut), boxes[second][0])
    rings: list[Ring] = []
    for south_west, north_east in boxes:
        w, s = (float(x) for x in south_west + origin[:2])
        e, n = (float(x) for x in north_east + origin[:2])
        rings.append(((w, s), (e, s), (e, n), (w, n)))
    return rings


def _parted(a: FloatArray, b: FloatArray) -> tuple[int, float, bool] | None:
    """Coordinate and value that part two groups of units but for single ones, and whether the first lies below; None where none does."""
    best: tuple[int, float, int, float, bool] | None = None
    for axis in (0, 1):
        for in_order, below, above in ((True, a[:, axis], b[:, axis]), (False, b[:, axis], a[:, axis])):
            places = np.unique(np.concatenate([below, above]))
            for before, after in pairwise(places):
                cut = 0.5 * (before + after)
                wrong = int((below > cut).sum()), int((above < cut).sum())
                if wrong[0] > ASTRAY * len(below) or wrong[1] > ASTRAY * len(above):
                    continue
                # fewest on the wrong side, then the widest gap
                found = (sum(wrong), before - after, axis, float(cut), in_order)
                best = found if best is None else min(best, found)
    return None if best is None else (best[2], best[3], best[4])


def counted(count: int, what: str) -> str:
    """``1 tile``, ``2 tiles``."""
    return f"{count} {what}{'' if count == 1 else 's'}"
