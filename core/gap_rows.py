"""Rows of the layer ``gaps``: what other epochs know of an epoch's missing units, and what its own cloud and packing say."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from .control import Transformation
from .gaps import Gap, armour_of, clearest, find_gaps
from .quality import ACCEPTED, CLOSEST_HEIGHTS, REACH_HEIGHTS, kinds_of, pose_table
from .schema import PLACEHOLDER
from .tiles import read_points
from .unit_types import UnitType

if TYPE_CHECKING:
    from .control import Registration
    from .result_rows import EpochPlan
    from .survey import Survey
    from .workflow import Feedback

FloatArray = NDArray[np.float64]
Row = dict[str, Any]
Look = Callable[[int, Sequence[Mapping[str, Any]], FloatArray], list[Gap]]
"""Gaps of an epoch (index) from its cloud and placed rows, in the control frame less a (3,) reduction point."""

NEAREST = 3


def look_into_tiles(
    survey: Survey, plans: Sequence[EpochPlan], units: tuple[UnitType, ...], registrations: Mapping[str, Registration], feedback: Feedback
) -> Look:
    """What :func:`gap_rows` needs to look into the clouds of the epochs, block by block."""

    def look(number: int, rows: Sequence[Mapping[str, Any]], origin: FloatArray) -> list[Gap]:
        poses = pose_table(rows)
        poses[:, :3] -= origin
        armour = armour_of(poses, kinds_of(rows, units), units)
        if armour is None:
            return []
        plan = plans[number]
        registration = registrations.get(plan.epoch.label)
        transformation = Transformation.identity(origin) if registration is None else registration.transformation
        where = transformation.invert(poses[:, :3] + origin)
        reach = 2 * REACH_HEIGHTS * armour.height
        found: list[Gap] = []
        for block in plan.blocks:
            if not block.core.grown(reach).contains(where).any():
                continue
            feedback.check()
            cloud = read_points(block.tiles, survey.crs, window=block.core.grown(reach), origin=origin, tiles_crs=plan.epoch.tiles_crs)
            gaps = find_gaps(transformation.apply(cloud.xyz + origin) - origin, armour)
            found += [gap for gap in gaps if block.core.contains(transformation.invert(gap.place[None] + origin))[0]]
        return clearest(found, armour.height)

    return look


def gap_rows(
    rows: Sequence[Mapping[str, Any]], epochs: Sequence[tuple[str, datetime]], units: Sequence[UnitType], look: Look | None = None
) -> list[Row]:
    """Rows of the layer ``gaps``.

    Parameters
    ----------
    rows
        Of the layer ``units``, final poses.
    epochs
        Label and time, in order of time.
    units
        Types of unit.
    look
        Looks into an epoch's cloud; without it only what other epochs know is stated.
    """
    result: list[Row] = []
    labels = [label for label, _ in epochs]
    known = _known_from_other_epochs(rows, labels)
    for number, (label, time) in enumerate(epochs):
        placed = [row for row in rows if row["epoch"] == label and row["geometry"] is not None]
        if not placed:
            continue
        centres = np.array([row["geometry"] for row in placed])
        origin: FloatArray = np.round(centres.mean(axis=0))
        tree = cKDTree(centres - origin)
        own: list[Row] = []
        for kind, seen in known[label]:
            # where another unit lies by now, nothing is missing
            if tree.query(seen["geometry"] - origin)[0] >= CLOSEST_HEIGHTS * seen["height"]:
                unit = units[int(kinds_of([seen], units)[0])]
                own.append({"kind": kind, "unit_id": seen["unit_id"], "score": 1.0, "geometry": np.asarray(seen["geometry"])} | _size(unit))
        taken = [row["geometry"] - origin for row in own]
        for gap in [] if look is None else look(number, placed, origin):
            unit = units[gap.unit]
            if all(np.linalg.norm(gap.place - place) >= unit.height for place in taken):
                own.append({"kind": gap.kind, "score": gap.score, "area": gap.area, "geometry": gap.place + origin} | _size(unit))
        for row in own:
            distance, index = tree.query(row["geometry"] - origin, k=min(NEAREST, len(placed)))
            row |= {
                "epoch": label,
                "epoch_time": time,
                "status": PLACEHOLDER,
                "nearest_units": json.dumps([placed[k]["unit_id"] for k in np.atleast_1d(index)]),
                "nearest_centre": float(np.atleast_1d(distance)[0]),
            }
        result += own
    return result


def _size(unit: UnitType) -> Row:
    return {"unit_type": unit.name, "height": unit.height, "radius": float(np.hypot(unit.leg_length, unit.end_radius))}


def _known_from_other_epochs(rows: Iterable[Mapping[str, Any]], labels: Sequence[str]) -> dict[str, list[tuple[str, Mapping[str, Any]]]]:
    """By epoch: ``lost`` or ``unseen``, and the row of the nearest epoch that shows the unit."""
    order = {label: k for k, label in enumerate(labels)}
    by_unit: dict[str, dict[int, Mapping[str, Any]]] = {}
    for row in rows:
        by_unit.setdefault(row["unit_id"], {})[order[row["epoch"]]] = row
    found: dict[str, list[tuple[str, Mapping[str, Any]]]] = {label: [] for label in labels}
    for states in by_unit.values():
        certain = sorted(e for e, row in states.items() if row["geometry"] is not None and row["status"] in ACCEPTED)
        # a new unit came later: the pile does not lack it before
        first = certain[0] if certain and states[certain[0]]["status"] == "new" else 0
        for epoch in range(first, len(labels) if certain else 0):
            state = states.get(epoch)
            if state is not None and state["geometry"] is not None:
                continue
            _, seen = min((abs(e - epoch), e) for e in certain)
            found[labels[epoch]].append(("unseen" if state is None else str(state["status"]), states[seen]))
    return found
