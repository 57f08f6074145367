"""Inputs held against the cloud and against what a quantity can be: what cannot be is refused with its likely cause."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import CrsError, InputError
from .crs import LOCAL, ground_scale, neighbouring_zones, parse_crs, tile_transform

MOST_CONTROL_SD = 0.5
"""Metres; nobody controls a survey with a standard deviation above."""
LEAST_CONTROL_SD, LARGE_CONTROL_SD = 1e-6, 0.1
"""Metres; nobody measures a coordinate better than the first, and with the second little is controlled."""
LARGE_HEIGHT_SHIFT, LARGE_SHIFT = 2.0, 10.0
"""Metres by which control seldom moves a cloud that is in the CRS of the survey."""
WEEK = 604_800.0
"""Seconds."""
MOST_SCALE_ERROR = 0.003
"""Largest difference from 1 of a grid's scale on the ground: a unit then seems 7 mm larger than it is."""
FAR_CONTROL = 10_000.0
"""Metres; a cloud nearer than this to the zero point of a grid may be in the frame of its scanner."""


@dataclass(frozen=True)
class Place:
    """Where an epoch's cloud lies.

    Attributes
    ----------
    low, high
        (3,) extent, metres.
    crs
        The survey's, in which it is stated.
    unit_height
        H in metres.
    """

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    crs: str
    unit_height: float

    @property
    def diagonal(self) -> float:
        """Of the extent in the plane, metres."""
        return float(np.hypot(self.high[0] - self.low[0], self.high[1] - self.low[1]))

    def away(self, points: FloatArray) -> FloatArray:
        """(n,) distance in the plane of (n, 3) positions from the extent, metres; 0 inside."""
        beyond = np.maximum(np.maximum(np.subtract(self.low[:2], points[:, :2]), np.subtract(points[:, :2], self.high[:2])), 0.0)
        return np.asarray(np.hypot(beyond[:, 0], beyond[:, 1]))

    def above(self, points: FloatArray) -> FloatArray:
        """(n,) height over the extent's top, negative below its bottom, 0 between, metres."""
        return np.asarray(np.maximum(points[:, 2] - self.high[2], 0.0) + np.minimum(points[:, 2] - self.low[2], 0.0))


def check_near(
    points: FloatArray,
    names: Sequence[str],
    place: Place,
    *,
    source: Path,
    what: str,
    reach: float | None = None,
    height_reach: float | None = None,
    each: bool = True,
) -> None:
    """Refuse positions that cannot belong to a cloud.

    Parameters
    ----------
    points, names
        (n, 3) metres in the frame of the cloud, and what to call each.
    place
        The cloud.
    source, what
        The file, and what the positions are ("targets").
    reach, height_reach
        Metres in the plane and up or down; by default some hundred unit heights, or what the size of the site allows.
    each
        Every position must be near, not only the nearest.

    Raises
    ------
    InputError
        With distance and likely cause.
    """
    if not len(points):
        return
    limit = max(100 * place.unit_height, 3 * place.diagonal) if reach is None else reach
    height_limit = max(50 * place.unit_height, place.diagonal) if height_reach is None else height_reach
    away, above = place.away(points), place.above(points)
    if away.min() > limit:
        raise InputError(
            f"{what} lie {_length(float(away.min()))} from the nearest point of the epoch's tiles",
            source=source,
            remedy=_likely(points, place, limit),
        )
    if each and away.max() > limit:
        k = int(away.argmax())
        raise InputError(
            f"{names[k]} lies {_length(float(away[k]))} from the nearest point of the epoch's tiles, the others do not",
            source=source,
            remedy="Check its coordinates for a slip of a digit.",
        )
    if np.abs(above).min() > height_limit:
        k = int(np.abs(above).argmin())
        side = "above" if above[k] > 0 else "below"
        raise InputError(
            f"{what} lie {_length(abs(float(above[k])))} {side} the epoch's tiles",
            source=source,
            remedy="Are heights in another height system, in feet or in millimetres, or do columns stand in another order?",
        )


def _likely(points: FloatArray, place: Place, limit: float) -> str:
    """What would bring the positions to the cloud, as a question."""

    def near(moved: FloatArray) -> bool:
        return bool(np.isfinite(moved).all() and np.median(place.away(moved)) <= max(limit, place.diagonal))

    if near(points[:, [1, 0, 2]]):
        return "Easting and northing seem to be exchanged: put the columns in the order of the header."
    for factor, unit in ((0.001, "millimetres"), (0.01, "centimetres"), (0.3048, "feet"), (1000.0, "kilometres")):
        if near(points * [factor, factor, 1.0]):
            return f"They seem to be in {unit}: give metres."
    if place.crs != LOCAL:
        if (np.abs(points[:, 0]) <= 180).all() and (np.abs(points[:, 1]) <= 180).all() and place.away(np.zeros((1, 3)))[0] > limit:
            return f"They seem to be degrees, or in a local frame: give easting and northing in {place.crs}."
        for zone in neighbouring_zones(place.crs):
            try:
                apply = tile_transform(parse_crs(zone), place.crs, points[:1], source="points").apply
            except CrsError:
                continue
            if apply is not None and near(apply(points)):
                return f"They seem to be in {zone}: transform them to {place.crs}."
    # a zone before the easting, the false northing of the other hemisphere, leading digits left away to type less
    lacking = np.round((np.add(place.low, place.high) / 2 - np.median(points, axis=0)) / 1e6) * [1e6, 1e6, 0.0]
    if lacking.any() and near(points + lacking):
        wanted = " and ".join(f"{value:+.0f} m in {axis}" for value, axis in zip(lacking, ("easting", "northing"), strict=False) if value)
        return f"Their leading digits seem to differ from the tiles': {wanted} would bring them there."
    return "Are they in another CRS, or in a local or shifted frame? They must be in the frame of the tiles."


def check_sds(sds: FloatArray, names: Sequence[str], *, source: Path) -> str:
    """Refuse (n, 3) standard deviations of control, metres, that no survey has; a sentence on those that control little.

    Raises
    ------
    InputError
        With the point and the likely unit.
    """
    if not len(sds):
        return ""
    # zero where none is stated
    small = np.where(sds > 0, sds, np.inf).min(axis=1)
    if small.min() < LEAST_CONTROL_SD:
        k = int(small.argmin())
        raise InputError(
            f"point {names[k]} has a standard deviation of {small[k]:g} m, which no survey reaches",
            source=source,
            remedy="Is it in kilometres, or a variance? Write the standard deviation in metres, 0.002 for 2 mm.",
        )
    if sds.max() <= MOST_CONTROL_SD:
        k = int(sds.max(axis=1).argmax())
        large = f"{source.name}: point {names[k]} has a standard deviation of {sds[k].max():g} m; is it in centimetres?"
        return large if sds.max() > LARGE_CONTROL_SD else ""
    k = int(sds.max(axis=1).argmax())
    value = float(sds[k].max())
    raise InputError(
        f"point {names[k]} has a standard deviation of {value:g} m, which is no survey control",
        source=source,
        remedy=f"Is it in millimetres? Then write {value / 1000:g}; standard deviations are metres.",
    )


def check_times(times: FloatArray, tiles: Sequence[tuple[str, float, float]], *, source: Path) -> str:
    """Refuse a trajectory at whose (m,) times no tile was measured; a sentence where some points were measured before or after.

    Parameters
    ----------
    times
        GPS time in seconds, rising.
    tiles
        Name, first and last GPS time of each tile.
    source
        The file of the trajectory.

    Raises
    ------
    InputError
        With the likely cause.
    """
    first, last = float(times[0]), float(times[-1])
    known = [tile for tile in tiles if tile[1] <= tile[2]]
    if not known:
        return f"{source.name}: the tiles have no GPS time by which it could be read"
    begin, end = min(tile[1] for tile in known), max(tile[2] for tile in known)
    if end < first or begin > last:
        raise InputError(
            f"covers GPS time {first:.3f} to {last:.3f}, the points of the epoch's tiles have {begin:.3f} to {end:.3f}",
            source=source,
            remedy=_likely_count((first, last), (begin, end)),
        )
    outside = [name for name, start, stop in known if start < first or stop > last]
    if not outside:
        return ""
    more = f" and {len(outside) - 1} more" if len(outside) > 1 else ""
    return (
        f"{source.name}: covers GPS time {first:.3f} to {last:.3f}; points of {outside[0]}{more} were measured before or after. "
        "A unit with such points ends a run"
    )


def _likely_count(ours: tuple[float, float], theirs: tuple[float, float]) -> str:
    """What would bring the times of a trajectory to those of the tiles."""
    middle = sum(theirs) / 2
    for moved, what in ((middle + 1e9, "standard GPS time"), (middle - 1e9, "standard GPS time less 1 000 000 000")):
        if ours[0] <= moved <= ours[1]:
            return f"It counts {what}, the tiles do not: export one of them again."
    if ours[0] >= 0 and ours[1] <= WEEK and any(ours[0] <= moved % WEEK <= ours[1] for moved in (middle, middle + 1e9)):
        return "It counts seconds of the GPS week, the tiles do not: export one of them again."
    if theirs[0] >= 0 and theirs[1] <= WEEK and ours[0] > WEEK:
        return "The tiles count seconds of the GPS week, the trajectory does not: export one of them again."
    return "Is it that of another flight? Give the trajectory of this epoch, with gps_time counted as in the tiles."


def check_station_ids(stations: Sequence[int], tiles: Sequence[int], *, source: Path) -> str:
    """Refuse stations none of which measured a point; a sentence where points have no station.

    Raises
    ------
    InputError
        With the IDs that occur in the tiles.
    """
    missing = sorted(set(tiles) - set(stations))
    some = ", ".join(map(str, missing[:5])) + (" …" if len(missing) > 5 else "")
    if missing and not set(tiles) & set(stations):
        raise InputError(
            f"none of its stations measured the epoch's points, whose point source IDs are {some}",
            source=source,
            remedy="Write the point source ID that the points of each station have in the tiles.",
        )
    return f"{source.name}: has no station for point source ID {some}; a unit with such points ends a run" if missing else ""


def said_of_shift(shift: FloatArray, *, source: Path) -> str:
    """A sentence where control moves a cloud that is in the survey's CRS by more than it should, (3,) metres; empty otherwise."""
    plan, up = float(np.hypot(*shift[:2])), float(shift[2])
    if abs(up) > LARGE_HEIGHT_SHIFT and plan < LARGE_HEIGHT_SHIFT:
        return (
            f"{source.name}: lifts the cloud by {up:.2f} m and leaves it in plan: are heights of control and cloud in different systems "
            "(ellipsoid, geoid, chart datum)?"
        )
    if plan > LARGE_SHIFT:
        return f"{source.name}: moves the cloud by {plan:.1f} m in plan and {up:.1f} m up: is control in the cloud's CRS and datum?"
    return ""


def check_scale(crs: str, place: Place, *, source: Path) -> None:
    """Refuse a grid on which a metre at the site is not a metre on the ground.

    Raises
    ------
    CrsError
        With the scale and a CRS that would do.
    """
    middle = np.add(place.low, place.high) / 2
    scales = ground_scale(crs, float(middle[0]), float(middle[1]))
    if scales is None:
        return
    least, most, zone = scales
    worst = max((least, most), key=lambda scale: abs(scale - 1))
    if abs(worst - 1) > MOST_SCALE_ERROR:
        raise CrsError(
            f"a metre on the ground is {worst:.3f} m in crs {crs} at the site, so that units would come out in a wrong size",
            source=source,
            where="section survey, key crs",
            remedy=f'Choose the UTM zone there, crs = "{zone}", or the national grid; tiles are transformed to it.',
        )


def height_systems(tiles: Sequence[tuple[str, str]]) -> str:
    """A sentence where tiles state different height systems, or only some state one; empty otherwise.

    Parameters
    ----------
    tiles
        Label of the epoch, and height system as stated (empty for none), of every tile.
    """
    systems: dict[str, list[str]] = {}
    for label, name in tiles:
        labels = systems.setdefault(name, [])
        if label not in labels:
            labels.append(label)
    if len(systems) < 2:
        return ""
    said = "; ".join(f"{name or 'none stated'}: epoch {', '.join(labels)}" for name, labels in sorted(systems.items(), reverse=True))
    return f"height systems differ between tiles ({said}): heights are compared as they stand, so make sure that they mean the same"


def _length(metres: float) -> str:
    return f"{metres / 1000:,.0f} km".replace(",", " ") if metres >= 10_000 else f"{metres:.0f} m"
