"""The crest of the armour by reaches of its axis: its height, its width and its change, and how well they are known."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.axis import Axis
from ..model.facets import plan_outline
from ..model.outline import nominal_diameter
from ..results.frame_heights import FrameHeights
from .as_built import AsBuilt, BuiltUnit
from .design_surface import support
from .placement_rows import COUNTED
from .sections import CutPlane

CREST_DIAMETERS = 0.5
"""Units whose top lies less than this below the highest one of a reach are its crest, nominal diameters."""
UP = np.array([0.0, 0.0, 1.0])
_NO_CHANGE = {"change": None, "sd_change": None}


@dataclass(frozen=True, eq=False)
class CrestErrors:
    """What is known of errors in height.

    Attributes
    ----------
    frames
        By epoch.
    changes
        Variances of displacements in height against control, square metres, by the two epochs and by unit; they hold both frames' error.
    """

    frames: Mapping[str, FrameHeights]
    changes: Mapping[tuple[str, str], Mapping[str, float]]


def crest_rows(models: Sequence[AsBuilt], axis: Axis, planes: Sequence[CutPlane], errors: CrestErrors) -> list[dict[str, Any]]:
    """Rows of ``crest``: height and width of the crest in the reach about every plane and epoch, and its change since the epoch before.

    Parameters
    ----------
    models, errors
        Units of every epoch, of which those that are uncertain do not count, and what is known of the errors of their heights.
    axis, planes
        Of the structure, and of the middles of its reaches, which are of one length and hold all units.
    """
    rows = []
    middles = np.array([plane.along for plane in planes])
    chainages = [axis.locate(np.array([unit.shape.centre for unit in model.units]))[0] for model in models]
    # a unit on a border, as rows of a regular placement lie, counts in one of the two reaches
    nearest = [np.abs(along[:, None] - middles).argmin(axis=1) for along in chainages]
    for number, plane in enumerate(planes, start=1):
        before: _Crest | None = None
        for model, reach in zip(models, nearest, strict=True):
            own = [unit for unit, its in zip(model.units, reach, strict=True) if its == number - 1 and unit.status in COUNTED]
            if not own:
                before = None
                continue
            crest = _Crest.of(own, errors.frames[model.epoch])
            rows.append(
                {"section": number, "along": plane.along, "epoch": model.epoch}
                | _crest_row(crest, axis, plane)
                | (_NO_CHANGE if before is None else _change(before, crest, errors))
            )
            before = crest
    return rows


@dataclass(frozen=True, eq=False)
class _Crest:
    """The crest of one reach in one epoch: units, tops (n,), and variances (n,) of their own heights, NaN where none is known."""

    frame: FrameHeights
    units: Sequence[BuiltUnit]
    tops: FloatArray
    variances: FloatArray

    @classmethod
    def of(cls, units: Sequence[BuiltUnit], frame: FrameHeights) -> _Crest:
        """Of the units of a reach: what was not adjusted, and so has no standard deviation, is left out where something else was."""
        known = [unit for unit in units if unit.row.get("sd_h") is not None] or list(units)
        tops = np.array([unit.shape.centre[2] + support(unit.shape, UP) for unit in known])
        limit = tops.max() - CREST_DIAMETERS * nominal_diameter([unit.shape for unit in known])
        crest = [unit for unit, top in zip(known, tops, strict=True) if top >= limit]
        stated = np.array([unit.row.get("sd_h") for unit in crest], dtype=np.float64) ** 2
        # the stated variance holds the frame's, which all units of the crest have in common
        return cls(frame, crest, tops[tops >= limit], np.maximum(stated - frame.single(_centres(crest)), 0.0))


def _crest_row(crest: _Crest, axis: Axis, plane: CutPlane) -> dict[str, Any]:
    across = np.concatenate([axis.locate(plan_outline(unit.shape))[1] for unit in crest.units])
    middle = (float(across.min()) + float(across.max())) / 2
    variance = crest.frame.mean(_centres(crest.units)) + float(crest.variances.sum()) / len(crest.units) ** 2
    return {
        "geometry": np.append(plane.place + middle * plane.left, crest.tops.mean()),
        "units": len(crest.units),
        "crest_height": float(crest.tops.mean()),
        "crest_highest": float(crest.tops.max()),
        "crest_width": float(across.max() - across.min()),
        "sd": _root(variance),
    }


def _change(before: _Crest, after: _Crest, errors: CrestErrors) -> dict[str, Any]:
    """Change of the mean top of the units that are the crest's in both epochs."""
    numbers = {unit.unit_id: k for k, unit in enumerate(before.units)}
    pairs = np.array([(numbers[unit.unit_id], k) for k, unit in enumerate(after.units) if unit.unit_id in numbers], dtype=np.int64)
    if not len(pairs):
        return _NO_CHANGE
    first, second = pairs.T
    same = [after.units[k] for k in second]
    shared = before.frame.mean(_centres(same)) + after.frame.mean(_centres(same))
    own = float(np.sum(before.variances[first] + after.variances[second])) / len(pairs) ** 2
    moved = errors.changes.get((before.frame.label, after.frame.label), {})
    # what both frames have in common, of targets surveyed once or of an epoch that both were tied to, is not in displacements; their mean
    # is known at least as well as they are in the mean
    single = float(np.mean([math.sqrt(moved.get(unit.unit_id, math.inf)) for unit in same]))
    sd = _root(float(np.fmin(single**2, shared + own)))
    return {"change": float(np.mean(after.tops[second] - before.tops[first])), "sd_change": sd}


def _root(variance: float) -> float | None:
    return math.sqrt(variance) if math.isfinite(variance) else None


def _centres(units: Sequence[BuiltUnit]) -> FloatArray:
    return np.array([unit.shape.centre for unit in units])
