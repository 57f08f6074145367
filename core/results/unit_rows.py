"""What a result says about each unit in one epoch pair and datum, as the review dock, the report and the alarm list see it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.robust import CHI2_3_95
from ..model.outline import PlacedShape
from .geopackage_reader import EpochPair, Row, epoch_pairs, parse_settings, parse_time, query, read_layer_rows, table_names
from .result_access import reading
from .schema import DATUMS
from .unit_legs import UNSEEN, Leg, legs_of_pair, most_broken
from .unit_sizes import UnitSize, shape_of, sizes_of_settings

Z_95 = 1.959963985
"""Half width of a two-sided 95 % band in standard deviations."""


# the geometry of ten thousand lines costs more than all their numbers; where a unit lies is known from the layer units
SELECT_MOTION = (
    "SELECT unit_id, class, de, dn, dh, d_3d, d_horizontal, sd_e, sd_n, sd_h, rotation_deg, sd_rotation_deg, p_value, significant, "
    "detectable, d_over_dn FROM displacements WHERE feature = 'centre' AND epoch_from = ? AND epoch_to = ? AND datum = ?"
)
SELECT_OTHER_MOTION = SELECT_MOTION.replace("FROM displacements ", "FROM displacements_other ")
SELECT_UNITS = "SELECT * FROM units WHERE epoch = ?"


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitRow:
    """One unit in one epoch pair; measures are None where one end does not exist (lost, unseen, new).

    Attributes
    ----------
    kind
        ``displacements.class``, or ``units.status`` of the later epoch where there is no displacement.
    place
        (3,) centre in the earlier epoch, or the later where it is new; None when neither is known.
    vector, sd
        (3,) displacement de, dn, dh and its standard deviations, metres.
    d_3d, d_horizontal
        Lengths in metres.
    rotation_deg, sd_rotation_deg
        Rotation between the epochs, degrees.
    p_value, significant
        Test of the displacement against zero.
    coverage
        Share of the surface that holds points, the smaller of the two epochs.
    height
        Nominal height H, metres.
    detectable
        Displacement the run would have found with a probability of 80 %, metres.
    d_over_dn
        Length of the displacement over the nominal diameter Dn of the unit's own volume.
    legs
        The four legs as they are in the later epoch; () where the result does not say.
    leg_missing, leg_probability
        Length that the most broken leg lacks, metres, and probability that it is broken; None where none is.
    """

    unit_id: str
    kind: str
    place: FloatArray | None
    coverage: float | None
    height: float | None
    vector: FloatArray | None = None
    sd: FloatArray | None = None
    d_3d: float | None = None
    d_horizontal: float | None = None
    rotation_deg: float | None = None
    sd_rotation_deg: float | None = None
    p_value: float | None = None
    significant: bool = False
    detectable: float | None = None
    d_over_dn: float | None = None
    legs: tuple[Leg, ...] = ()
    leg_missing: float | None = None
    leg_probability: float | None = None

    @property
    def is_judged(self) -> bool:
        """Whether the unit's motion is known: both ends are, or it is lost; what is uncertain is not counted."""
        return (self.d_3d is not None or self.kind == "lost") and self.kind != "uncertain"

    @property
    def broken_legs(self) -> tuple[int, ...]:
        """Numbers 1 to 4 of the legs that are broken."""
        return tuple(leg.number for leg in self.legs if leg.is_broken)

    @property
    def unseen_legs(self) -> tuple[int, ...]:
        """Numbers 1 to 4 of the legs whose ends are not seen, of which nothing is said."""
        return tuple(leg.number for leg in self.legs if leg.state == UNSEEN)

    @property
    def nominal_diameter(self) -> float | None:
        """Dn in metres as the run used it; None where the unit has not moved at all or has no displacement."""
        return self.d_3d / self.d_over_dn if self.d_3d and self.d_over_dn else None

    @property
    def vertical(self) -> float | None:
        """Vertical displacement in metres, positive up."""
        return None if self.vector is None else float(self.vector[2])

    @property
    def sd_3d(self) -> float | None:
        """Standard deviation of the displacement's length, metres."""
        return None if self.vector is None or self.sd is None else sd_of_length(self.vector, self.sd)

    @property
    def detection_limit(self) -> float | None:
        """Displacement in metres that is found in any direction: as the run states it, or by the 95 % test of the standard deviations."""
        if self.detectable is not None:
            return self.detectable
        return None if self.sd is None else float(math.sqrt(CHI2_3_95) * np.max(self.sd))


@dataclass(frozen=True, eq=False)
class SeriesPoint:
    """Displacement of one feature since the first epoch: length, its standard deviation and vector, metres."""

    epoch: str
    time: datetime | None
    d_3d: float
    sd: float
    vector: FloatArray


@dataclass(frozen=True, eq=False)
class CheckComparison:
    """Displacement of a surveyed check point beside that of its feature, metres."""

    point_id: str
    feature: str
    measured: float
    fitted: float
    difference: float


@dataclass(frozen=True, eq=False, kw_only=True)
class UnitDetails:
    """Everything the file holds on one unit.

    Attributes
    ----------
    shapes
        Fitted outline per epoch label, in the control frame.
    features
        Feature points per epoch label: name to (position, standard deviations, observed).
    rows
        Rows of ``units`` per epoch label.
    checks
        Rows of ``check_residuals``.
    """

    unit_id: str
    shapes: dict[str, PlacedShape]
    features: dict[str, dict[str, tuple[FloatArray, FloatArray, bool]]]
    rows: dict[str, Row]
    displacements: tuple[Row, ...]
    checks: tuple[Row, ...]


@dataclass(frozen=True, kw_only=True)
class EpochInfo:
    """One row of ``epochs``."""

    label: str
    time: datetime | None
    points: int | None
    sigma0: float | None
    software: str
    settings: dict[str, Any]
    transformation: dict[str, Any]
    tiles: str


def sd_of_length(vector: FloatArray, sd: FloatArray) -> float:
    """Standard deviation of the length of a vector with independent components; of the largest component for a zero vector."""
    length = float(np.linalg.norm(vector))
    if length == 0:
        return float(np.max(sd))
    return float(np.linalg.norm(vector / length * sd))


def shift_to_datum(row: UnitRow, details: UnitDetails, pair: EpochPair) -> FloatArray:
    """(3,) metres by which what was seen in the later epoch is drawn aside, so that a drawing shows the displacement of the row's datum.

    Poses and points stand in the control frame of their epoch; between two of them a displacement of the datum ``stable`` differs by
    what all stable units have in common.
    """
    first, second = details.shapes.get(pair.epoch_from), details.shapes.get(pair.epoch_to)
    if row.vector is None or first is None or second is None:
        return np.zeros(3)
    return np.asarray(row.vector - (second.centre - first.centre))


def read_epochs(path: Path) -> tuple[EpochInfo, ...]:
    """Epochs in the order of time."""
    rows = read_layer_rows(path, "epochs")
    infos = [
        EpochInfo(
            label=str(row["label"]),
            time=parse_time(row["time"]),
            points=row.get("points"),
            sigma0=row.get("sigma0"),
            software=str(row.get("software") or ""),
            settings=parse_settings(row.get("settings")),
            transformation=parse_settings(row.get("transformation")),
            tiles=str(row.get("tiles") or ""),
        )
        for row in rows
    ]
    return tuple(sorted(infos, key=lambda info: (info.time is None, info.time.timestamp() if info.time else 0.0)))


def datums(path: Path, pair: EpochPair) -> tuple[str, ...]:
    """Datums in which a pair has displacements, ``stable`` first; all where the pair was compared and no unit is seen in both epochs."""
    have_other = _has_other(path)
    default = "SELECT 1 FROM displacements WHERE epoch_from = ? AND epoch_to = ? AND datum = ? LIMIT 1"
    other = "SELECT 1 FROM displacements_other WHERE epoch_from = ? AND epoch_to = ? AND datum = ? LIMIT 1"
    found = []
    with reading(path) as connection:
        for datum in DATUMS:
            key = (pair.epoch_from, pair.epoch_to, datum)
            if connection.execute(default, key).fetchone() or (have_other and connection.execute(other, key).fetchone()):
                found.append(datum)
    return tuple(found) if found or pair not in epoch_pairs(path) else DATUMS


def read_unit_rows(path: Path, pair: EpochPair, datum: str) -> list[UnitRow]:
    """All units of an epoch pair, those without a displacement (lost, unseen, new, uncertain) included, by unit_id.

    Raises
    ------
    InputError
        The file cannot be read, or has no such epochs.
    """
    key = (pair.epoch_from, pair.epoch_to, datum)
    with reading(path) as connection:
        moved = query(connection, SELECT_MOTION, key)
        if not moved and _has_other(path):
            moved = query(connection, SELECT_OTHER_MOTION, key)
        early = {row["unit_id"]: row for row in query(connection, SELECT_UNITS, (pair.epoch_from,))}
        late = {row["unit_id"]: row for row in query(connection, SELECT_UNITS, (pair.epoch_to,))}
    if not early and not late:
        raise InputError(f"has no epochs {pair}", source=path, remedy="Choose an epoch pair the result holds.")
    by_unit = {row["unit_id"]: row for row in moved}
    return [_unit_row(unit, by_unit.get(unit), early.get(unit), late.get(unit)) for unit in sorted(early.keys() | late.keys())]


def read_details(path: Path, unit_id: str, sizes: Sequence[UnitSize] = ()) -> UnitDetails:
    """Poses, features, displacements and check points of one unit in all epochs; ``sizes`` are those of :func:`unit_sizes`."""
    with reading(path) as connection:
        units = query(connection, "SELECT * FROM units WHERE unit_id = ?", (unit_id,))
        points = query(connection, "SELECT * FROM feature_points WHERE unit_id = ?", (unit_id,))
        displacements = query(connection, "SELECT * FROM displacements WHERE unit_id = ?", (unit_id,))
        names = table_names(path)
        if "displacements_other" in names:
            displacements += query(connection, "SELECT * FROM displacements_other WHERE unit_id = ?", (unit_id,))
        checks = query(connection, "SELECT * FROM check_residuals WHERE unit_id = ?", (unit_id,)) if "check_residuals" in names else []
    features: dict[str, dict[str, tuple[FloatArray, FloatArray, bool]]] = {}
    for row in points:
        if row["geom"] is not None:
            sd = np.array([row["sd_e"], row["sd_n"], row["sd_h"]], dtype=np.float64)
            features.setdefault(row["epoch"], {})[row["feature"]] = (row["geom"], sd, bool(row["observed"]))
    shapes = {row["epoch"]: shape for row in units if (shape := shape_of(row, sizes)) is not None}
    return UnitDetails(
        unit_id=unit_id,
        shapes=shapes,
        features=features,
        rows={row["epoch"]: row for row in units},
        displacements=tuple(displacements),
        checks=tuple(checks),
    )


def unit_sizes(epochs: Sequence[EpochInfo]) -> tuple[UnitSize, ...]:
    """Types of unit as the run's settings state them; () where they do not."""
    return sizes_of_settings(epoch.settings for epoch in epochs)


def series(details: UnitDetails, epochs: Sequence[EpochInfo], datum: str, feature: str = "centre") -> list[SeriesPoint]:
    """Displacement of a feature since the unit's first epoch.

    Displacements straight from the first epoch are used where the result has them, otherwise those of consecutive epochs are
    added (and their variances with them).
    """
    rows = [row for row in details.displacements if row["feature"] == feature and row["datum"] == datum]
    by_pair = {(row["epoch_from"], row["epoch_to"]): row for row in rows}
    seen = [epoch for epoch in epochs if epoch.label in details.shapes]
    if not seen:
        return []
    first = seen[0]
    points = [SeriesPoint(first.label, first.time, 0.0, 0.0, np.zeros(3))]
    vector: FloatArray | None = np.zeros(3)
    variance: FloatArray = np.zeros(3)
    for before, epoch in pairwise(seen):
        direct, step = by_pair.get((first.label, epoch.label)), by_pair.get((before.label, epoch.label))
        if direct is not None:
            vector, variance = _vector(direct), _sd(direct) ** 2
        elif step is not None and vector is not None:
            vector, variance = vector + _vector(step), variance + _sd(step) ** 2
        else:
            # a gap in the chain: what follows can only come from a direct pair
            vector = None
            continue
        points.append(SeriesPoint(epoch.label, epoch.time, float(np.linalg.norm(vector)), sd_of_length(vector, np.sqrt(variance)), vector))
    return points


def check_comparisons(details: UnitDetails, pair: EpochPair) -> list[CheckComparison]:
    """Surveyed check points of the unit that both epochs of a pair have, beside the fit, in the control frame.

    A residual is feature less check point, so the surveyed displacement is the feature's less the change of its residual.
    """
    residuals = {(row["point_id"], row["epoch"]): row for row in details.checks}
    found = []
    for (point, epoch), row in sorted(residuals.items()):
        late = residuals.get((point, pair.epoch_to))
        if epoch != pair.epoch_from or late is None or late["feature"] != row["feature"]:
            continue
        start = details.features.get(pair.epoch_from, {}).get(row["feature"])
        stop = details.features.get(pair.epoch_to, {}).get(row["feature"])
        if start is None or stop is None:
            continue
        fitted = stop[0] - start[0]
        surveyed = fitted - (_vector(late) - _vector(row))
        lengths = float(np.linalg.norm(surveyed)), float(np.linalg.norm(fitted))
        found.append(CheckComparison(str(point), str(row["feature"]), *lengths, float(lengths[1] - lengths[0])))
    return found


def over(rows: Sequence[UnitRow], threshold: float, excluded: frozenset[str] = frozenset()) -> list[UnitRow]:
    """Units displaced by more than a threshold in metres, lost, relocated or with a broken leg, largest first; uncertain and rejected ones
    left out."""
    known = [row for row in rows if row.unit_id not in excluded and row.kind != "uncertain"]
    chosen = [row for row in known if _exceeds(row, threshold) or _is_damaged(row)]
    return sorted(chosen, key=lambda row: (-math.inf if row.d_3d is None else -row.d_3d, row.unit_id))


def _exceeds(row: UnitRow, threshold: float) -> bool:
    return row.d_3d is not None and row.d_3d > threshold


def _is_damaged(row: UnitRow) -> bool:
    return row.kind in ("lost", "relocated") or bool(row.broken_legs)


def _unit_row(unit: str, moved: Row | None, early: Row | None, late: Row | None) -> UnitRow:
    ends = [row for row in (early, late) if row is not None]
    place = next((row["geom"] for row in ends if row["geom"] is not None), None)
    coverage = [row["coverage"] for row in ends if row["coverage"] is not None]
    height = next((row["height"] for row in ends if row["height"] is not None), None)
    least = min(coverage) if coverage else None
    legs = _legs(early, late)
    if moved is None:
        status = late["status"] if late is not None else "unseen"
        # found in one epoch only and no displacement: nothing can be said of its motion
        kind = "uncertain" if status == "found" else str(status)
        return UnitRow(unit_id=unit, kind=kind, place=place, coverage=least, height=height, **legs)
    return UnitRow(
        unit_id=unit,
        kind=str(moved["class"] or "uncertain"),
        place=place,
        coverage=least,
        height=height,
        vector=_vector(moved),
        sd=_sd(moved),
        d_3d=moved["d_3d"],
        d_horizontal=moved["d_horizontal"],
        rotation_deg=moved["rotation_deg"],
        sd_rotation_deg=moved["sd_rotation_deg"],
        p_value=moved["p_value"],
        significant=bool(moved["significant"]),
        detectable=moved["detectable"],
        d_over_dn=moved["d_over_dn"],
        **legs,
    )


def _legs(early: Row | None, late: Row | None) -> dict[str, Any]:
    legs = legs_of_pair(early, late)
    worst = most_broken(legs)
    if worst is None:
        return {"legs": legs}
    if worst.missing is not None or worst.probability is not None:
        return {"legs": legs, "leg_missing": worst.missing, "leg_probability": worst.probability}
    # of several broken legs an earlier version states one length and one probability
    source = next((row for row in (late, early) if row is not None and row.get("leg_missing") is not None), {})
    return {"legs": legs, "leg_missing": source.get("leg_missing"), "leg_probability": source.get("leg_probability")}


def _vector(row: Row) -> FloatArray:
    return np.array([row["de"], row["dn"], row["dh"]], dtype=np.float64)


def _sd(row: Row) -> FloatArray:
    return np.array([row["sd_e"], row["sd_n"], row["sd_h"]], dtype=np.float64)


def _has_other(path: Path) -> bool:
    return "displacements_other" in table_names(path)
