"""Coordinate reference systems: what the survey may use, and how a tile's CRS relates to it.

Coordinates are always easting, northing, height in metres, whatever the axis order of the CRS's definition.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .errors import CrsError

if TYPE_CHECKING:
    from pyproj import CRS

FloatArray = NDArray[np.float64]

LOCAL = "LOCAL"
"""Name of a frame without place on earth: laboratory or site coordinates in metres."""

SAME_PLACE = 1e-4
"""Metres; two CRS that differ by less at a tile's corners are the same written differently (LAS stores 1 mm to 0.1 mm)."""


@dataclass(frozen=True)
class TileTransform:
    """How a tile's coordinates come into the survey's CRS.

    Attributes
    ----------
    apply
        (n, 3) tile coordinates to (n, 3) survey coordinates; None where they are the same.
    note
        One sentence for the log; empty where nothing was changed or assumed.
    """

    apply: Callable[[FloatArray], FloatArray] | None
    note: str = ""


@lru_cache(maxsize=64)
def parse_crs(text: str) -> CRS:
    """CRS from ``EPSG:xxxx``, WKT or PROJJSON.

    Raises
    ------
    CrsError
        The text names no CRS known to PROJ.
    """
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    try:
        return CRS.from_user_input(text)
    except CRSError as error:
        raise CrsError(f"unknown CRS {_short(text)}", remedy='Write an EPSG code such as "EPSG:32650".') from error


def check_survey_crs(text: str, *, source: str | Path | None = None, where: str = "") -> None:
    """Refuse a survey CRS that is unknown, not projected or not in metres.

    Raises
    ------
    CrsError
        One sentence with the remedy.
    """
    if text == LOCAL:
        return
    try:
        crs = parse_crs(text)
    except CrsError as error:
        raise CrsError(error.problem, source=source, where=where, remedy=f'{error.remedy} A laboratory frame is "LOCAL".') from error
    problem = _unusable(crs)
    if problem:
        raise CrsError(
            f"crs {_short(text)} {problem}",
            source=source,
            where=where,
            remedy="Choose a projected CRS in metres, for example the UTM zone.",
        )


def tile_transform(tile_crs: CRS | None, survey_crs: str, corners: FloatArray, *, source: str | Path) -> TileTransform:
    """Relate a tile's CRS to the survey's.

    A compound CRS counts by its horizontal part; heights are transformed only where both sides name a vertical CRS and they
    differ. Transformations are refused where the best one needs a grid that is not installed, because PROJ would otherwise
    use a worse one, or leave heights as they are, without a word.

    Parameters
    ----------
    tile_crs
        CRS of the tile's header (or the epoch's ``tiles_crs``), None where there is none.
    survey_crs
        As in survey.toml.
    corners
        (k, 3) corners of the tile in its own CRS, used to see whether two definitions place points alike.

    Raises
    ------
    CrsError
        No CRS, geographic, not in metres, or no exact transformation.
    """
    if survey_crs == LOCAL:
        if tile_crs is None or not (tile_crs.is_projected or tile_crs.is_geographic or tile_crs.is_geocentric):
            return TileTransform(None)
        raise CrsError(
            f"is in {_name(tile_crs)}, but the survey's crs is LOCAL", source=source, remedy="Write the tile's CRS into [survey] crs."
        )
    if tile_crs is None:
        raise CrsError("has no CRS", source=source, remedy=f'If it is in {survey_crs}, add to its [[epoch]]: tiles_crs = "{survey_crs}"')
    problem = _unusable(tile_crs)
    if problem:
        raise CrsError(f"CRS {_name(tile_crs)} {problem}", source=source, remedy=f"Reproject the tile to {survey_crs} in metres.")
    _check_declared_code(tile_crs, corners, source)
    target = parse_crs(survey_crs)
    flat_from, flat_to = _horizontal(tile_crs), _horizontal(target)
    up_from, up_to = _vertical(tile_crs), _vertical(target)
    heights_differ = up_from is not None and up_to is not None and not _equal(up_from, up_to)
    if _equal(flat_from, flat_to) and not heights_differ:
        return TileTransform(None)
    apply = _transformer(tile_crs, target, source) if heights_differ else _flat(_transformer(flat_from, flat_to, source))
    moved = apply(corners)
    if not np.isfinite(moved).all():
        raise CrsError(
            f"lies outside the area where {_name(tile_crs)} can be transformed to {survey_crs}",
            source=source,
            remedy="Check the CRS of the tile and of the survey.",
        )
    if np.abs(moved - corners).max() < SAME_PLACE:
        return TileTransform(None)
    heights = "heights included" if heights_differ else "heights unchanged"
    return TileTransform(apply, f"{Path(source).name}: transformed from {_name(tile_crs)} to {survey_crs}, {heights}")


def horizontal_transform(layer_crs: str | None, survey_crs: str, *, source: str | Path) -> Callable[[FloatArray], FloatArray] | None:
    """(n, 2) positions of a vector layer to the survey's CRS; None where both are the same.

    Raises
    ------
    CrsError
        The layer has no CRS, or no exact transformation is known.
    """
    if not layer_crs:
        raise CrsError("has no CRS", source=source, remedy=f"Save the layer with its CRS, for example {survey_crs}.")
    flat_from, flat_to = _horizontal(parse_crs(layer_crs)), _horizontal(parse_crs(survey_crs))
    if _equal(flat_from, flat_to):
        return None
    apply = _transformer(flat_from, flat_to, source)
    return lambda points: apply(np.column_stack([points, np.zeros(len(points))]))[:, :2]


def crs_text(crs: CRS | None) -> str:
    """What to write into survey.toml for a tile's CRS: a code of its horizontal part, LOCAL for a site frame, else WKT; empty for none."""
    if crs is None:
        return ""
    flat = _horizontal(crs)
    if not (flat.is_projected or flat.is_geographic or flat.is_geocentric):
        return LOCAL
    return _code(flat) or str(flat.to_wkt())


def _unusable(crs: CRS) -> str:
    """Why coordinates in this CRS cannot serve, or an empty text."""
    flat = _horizontal(crs)
    if flat.is_geographic:
        return "is geographic (degrees)"
    if flat.is_geocentric:
        return "is geocentric"
    if not flat.is_projected:
        return "is not a projected CRS"
    for part in (flat, _vertical(crs)):
        for axis in part.axis_info if part is not None else ():
            if abs(axis.unit_conversion_factor - 1) > 1e-12:
                return f"is in {axis.unit_name}, not metres"
    return ""


def _horizontal(crs: CRS) -> CRS:
    if crs.is_bound and crs.source_crs is not None:
        crs = crs.source_crs
    return _horizontal(crs.sub_crs_list[0]) if crs.is_compound else crs


def _vertical(crs: CRS) -> CRS | None:
    return crs.sub_crs_list[1] if crs.is_compound else None


def _equal(a: CRS, b: CRS) -> bool:
    return bool(a.equals(b, ignore_axis_order=True))


def _transformer(a: CRS, b: CRS, source: str | Path) -> Callable[[FloatArray], FloatArray]:
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        transformer = Transformer.from_crs(a, b, always_xy=True, only_best=True, allow_ballpark=False)
        # with only_best a missing grid is found out only when a point is transformed
    except ProjError as error:
        raise _no_transformation(a, b, source) from error

    def apply(points: FloatArray) -> FloatArray:
        try:
            return np.column_stack(transformer.transform(points[:, 0], points[:, 1], points[:, 2], errcheck=True))
        except ProjError as error:
            raise _no_transformation(a, b, source) from error

    return apply


def _flat(apply: Callable[[FloatArray], FloatArray]) -> Callable[[FloatArray], FloatArray]:
    """Transform easting and northing alone; heights stay what they were."""

    def transform(points: FloatArray) -> FloatArray:
        return np.column_stack([apply(points)[:, :2], points[:, 2]])

    return transform


def _no_transformation(a: CRS, b: CRS, source: str | Path) -> CrsError:
    return CrsError(
        f"cannot be transformed exactly from {_name(a)} to {_name(b)}",
        source=source,
        remedy="Install the PROJ grids of the region (projsync), or reproject the tile beforehand.",
    )


def _check_declared_code(crs: CRS, corners: FloatArray, source: str | Path) -> None:
    """Refuse a definition whose parameters are not those of the EPSG code it carries: one of them is wrong, nobody knows which."""
    flat = _horizontal(crs)
    code = _code(flat)
    if not code:
        return
    try:
        stated = parse_crs(code)
    except CrsError as error:
        raise CrsError(f"declares {code}, which does not exist", source=source, remedy="Write the right CRS into its header.") from error
    if not stated.is_projected or not (_equal(flat, stated) or _same_place(flat, stated, corners, source)):
        raise CrsError(f"declares {code} with the parameters of another CRS", source=source, remedy="Write the right CRS into its header.")


def _same_place(a: CRS, b: CRS, corners: FloatArray, source: str | Path) -> bool:
    moved = _flat(_transformer(a, b, source))(corners)
    return bool(np.isfinite(moved).all() and np.abs(moved - corners).max() < SAME_PLACE)


def _code(crs: CRS) -> str:
    """``EPSG:xxxx`` that the definition carries or certainly equals, else an empty text."""
    declared = crs.to_json_dict().get("id", {})
    if declared.get("authority") == "EPSG":
        return f"EPSG:{declared['code']}"
    code = crs.to_epsg()
    return "" if code is None else f"EPSG:{code}"


def _name(crs: CRS) -> str:
    return _code(crs) or str(crs.name)


def _short(text: str) -> str:
    return repr(text if len(text) < 60 else text[:57] + "...")
