"""Quality that users of armour models ask for: how near the units of one epoch lie to each other, and the epoch in a few numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..common.feedback import Feedback
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..segmentation.overlaps import CLOSEST_HEIGHTS, REACH_HEIGHTS, nearest_centres, overlap_shares
from ..segmentation.verification import overlap

Row = dict[str, Any]
AnyRow = TypeVar("AnyRow", bound=Mapping[str, Any])

ACCEPTED = ("found", "new", "relocated")
"""States of a unit that counts."""


def entering(poses: FloatArray, kinds: NDArray[np.int64], units: Sequence[UnitType], scores: FloatArray, most: float) -> NDArray[np.bool_]:
    """(k,) units that share more than ``most`` of a volume with one of higher score that does not do so itself; arguments as above."""
    inside = np.zeros(len(poses), dtype=np.bool_)
    if len(poses) < 2:
        return inside
    tree = cKDTree(poses[:, :3])
    rank = np.argsort(np.argsort(-scores, kind="stable"))
    for k in np.argsort(rank):
        near = tree.query_ball_point(poses[k, :3], REACH_HEIGHTS * max(unit.height for unit in units))
        stronger = [j for j in near if rank[j] < rank[k] and not inside[j]]
        pairs = [pair for j in stronger for pair in ((k, j), (j, k))]
        inside[k] = any(overlap(poses[a], poses[b], units[kinds[a]], units[kinds[b]]) > most for a, b in pairs)
    return inside


def reduced(poses: FloatArray) -> FloatArray:
    """(k, 12) poses less a common point near their middle: differences of seven-digit coordinates lose digits."""
    if not len(poses):
        return poses
    return np.column_stack([poses[:, :3] - np.round(poses[:, :3].mean(axis=0)), poses[:, 3:]])


def placed_rows(rows: Iterable[AnyRow], label: str) -> list[AnyRow]:
    """Rows of an epoch that have a pose, of rows of the layer ``units``."""
    return [row for row in rows if row["epoch"] == label and row["geometry"] is not None]


def pose_table(rows: Sequence[Mapping[str, Any]]) -> FloatArray:
    """(k, 12) centre and rotation by rows of rows of the layer ``units`` that have a geometry."""
    poses = [Pose.from_quaternion(row["geometry"], [row[q] for q in ("qx", "qy", "qz", "qw")]) for row in rows]
    return np.array([pose.as_row() for pose in poses]).reshape(-1, 12)


def kinds_of(rows: Iterable[Mapping[str, Any]], units: Sequence[UnitType]) -> NDArray[np.int64]:
    """(k,) index of the type of each row of the layer ``units``."""
    number = {unit.name: k for k, unit in enumerate(units)}
    return np.array([number[row["unit_type"]] for row in rows], dtype=np.int64)


def state_quality(
    rows: Sequence[dict[str, Any]],
    units: Sequence[UnitType],
    labels: Sequence[str],
    feedback: Feedback,
    gaps: Sequence[Mapping[str, Any]] | None = None,
) -> dict[str, dict[str, Any]]:
    """Fill what rows of ``units`` say of their neighbours, log each epoch's summary, and return the summaries by label.

    ``gaps`` are the rows of that layer, None where gaps were not looked for.
    """
    add_neighbours(rows, units)
    summaries = {}
    for label in labels:
        count = None if gaps is None else sum(row["epoch"] == label for row in gaps)
        summaries[label] = summarise_epoch(rows, label, count)
        feedback.info(describe(label, summaries[label]))
    return summaries


def add_neighbours(rows: Sequence[Row], units: Sequence[UnitType]) -> None:
    """Fill ``nearest_centre`` and ``overlap_share`` of rows of the layer ``units``, epoch by epoch, from their final poses."""
    for label in dict.fromkeys(row["epoch"] for row in rows):
        own = placed_rows(rows, label)
        if not own:
            continue
        poses = reduced(pose_table(own))
        accepted = np.array([row["status"] in ACCEPTED for row in own], dtype=np.bool_)
        nearest, shares = nearest_centres(poses[:, :3]), overlap_shares(poses, kinds_of(own, units), units, accepted)
        for row, distance, share in zip(own, nearest, shares, strict=True):
            row["nearest_centre"] = float(distance) if np.isfinite(distance) else None
            row["overlap_share"] = float(share)


def summarise_epoch(rows: Iterable[Mapping[str, Any]], label: str, gaps: int | None) -> Row:
    """An epoch in a few numbers, from rows of the layer ``units`` after :func:`add_neighbours`.

    Returns
    -------
    summary
        ``found``, ``uncertain``; ``distance_median`` of the counting units' own (metres) and ``overlap_share_max`` among them, None where
        no unit tells; ``close_pairs``, of all units with centres nearer than 0.5 H; ``gaps``, None where they were not looked for.
    """
    placed = placed_rows(rows, label)
    counting = [row for row in placed if row["status"] in ACCEPTED]
    distances = [row["distance_median"] for row in counting if _known(row.get("distance_median"))]
    shares = [row["overlap_share"] for row in counting if row.get("overlap_share") is not None]
    pairs = 0
    if len(placed) > 1:
        centres = np.array([row["geometry"] for row in placed])
        pairs = len(cKDTree(centres - centres[0]).query_pairs(CLOSEST_HEIGHTS * max(row["height"] for row in placed)))
    return {
        "found": len(counting),
        "uncertain": len(placed) - len(counting),
        "distance_median": float(np.median(distances)) if distances else None,
        "overlap_share_max": float(max(shares)) if shares else None,
        "close_pairs": pairs,
        "gaps": gaps,
    }


def describe(label: str, summary: Mapping[str, Any]) -> str:
    """The summary of an epoch as a line of the log."""
    parts = [f"{label}: {summary['found']} units found, {summary['uncertain']} uncertain"]
    if summary["distance_median"] is not None:
        parts.append(f"median distance of points to the surface {1000 * summary['distance_median']:.1f} mm")
    if summary["overlap_share_max"] is not None:
        parts.append(f"largest overlap {100 * summary['overlap_share_max']:.2f} % of a unit")
    parts.append(f"{summary['close_pairs']} pairs closer than solids can be")
    if summary["gaps"] is not None:
        parts.append(f"{summary['gaps']} gaps")
    return ", ".join(parts)


def _known(value: Any) -> bool:
    return value is not None and bool(np.isfinite(value))
