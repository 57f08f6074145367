"""Coordinate reference systems: what the survey may use, and how a tile's CRS relates to it.

Coordinates are always easting, northing, height in metres, whatever the axis order of the CRS's definition.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import CrsError
from .las_crs import DeclaredCrs

if TYPE_CHECKING:
    from pyproj import CRS, Transformer


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
    """Refuse a survey CRS that is unknown, not projected, not in metres, or not counted to the east and north.

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
            remedy="Choose a projected CRS in metres, for example the UTM zone"
            + (", or that of the same grid to the east and north, as EPSG:5514 is in place of EPSG:5513." if _other_axes(crs) else "."),
        )


def counts_in_metres(text: str) -> bool:
    """Whether the plane coordinates of a CRS are metres; also where it is not known, for whoever needs it to say so."""
    try:
        crs = _horizontal(parse_crs(text))
    except CrsError:
        return True
    return all(abs(axis.unit_conversion_factor - 1) < 1e-12 for axis in crs.axis_info)


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
        No CRS, geographic, not in metres, not counted to the east and north, or no exact transformation.
    """
    if survey_crs == LOCAL:
        if tile_crs is None or _is_site_frame(tile_crs):
            unit = "" if tile_crs is None else _foreign_unit(tile_crs)
            if unit:
                raise CrsError(
                    f"is in a local frame in {unit}, not metres", source=source, remedy=_overrule(LOCAL, "are metres all the same")
                )
            return TileTransform(None)
        raise CrsError(
            f"is in {_name(tile_crs)}, but the survey's crs is LOCAL",
            source=source,
            remedy=f"Write the tile's CRS into [survey] crs. {_overrule(LOCAL, 'are those of the local frame')}",
        )
    meant = _overrule(survey_crs, f"are those of {survey_crs}")
    if tile_crs is None:
        raise CrsError("has no CRS", source=source, remedy=meant)
    if _is_site_frame(tile_crs):
        raise CrsError(
            f"is in a local frame ({tile_crs.name}), the survey in {survey_crs}",
            source=source,
            remedy=f'{meant} If the whole survey is local, write crs = "{LOCAL}" into [survey].',
        )
    problem = _unusable(tile_crs)
    if problem:
        raise CrsError(f"CRS {_name(tile_crs)} {problem}", source=source, remedy=f"Reproject the tile to {survey_crs} in metres. {meant}")
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


def resolved_crs(
    declared: DeclaredCrs, tiles_crs: str | None, undeclared_crs: str | None = None, *, source: Path
) -> tuple[CRS | None, str]:
    """CRS to take a tile's coordinates in, and a sentence where that is not what its header says.

    Parameters
    ----------
    declared
        What the header says.
    tiles_crs
        CRS that the epoch states; it overrules the header.
    undeclared_crs
        CRS where the header declares none that can be understood.

    Raises
    ------
    CrsError
        The header's CRS is needed and cannot be used.
    """
    if tiles_crs is not None:
        stated = None if tiles_crs == LOCAL else parse_crs(tiles_crs)
        if not declared.name or (declared.crs is not None and stated is not None and not declared.problem and _equal(declared.crs, stated)):
            return stated, ""
        return stated, f"{source.name}: its header says {declared.name}; tiles_crs overrules it: {tiles_crs}"
    if undeclared_crs is not None and declared.crs is None:
        said = f"{source.name}: its header says {declared.name}; {undeclared_crs} is taken" if declared.name else ""
        return (None if undeclared_crs == LOCAL else parse_crs(undeclared_crs)), said
    if declared.problem:
        remedy = _overrule("EPSG:32650", "are metres of a CRS you know", "for example ")
        raise CrsError(declared.problem, source=source, remedy=f"Reproject it in metres. {remedy}" if declared.crs is not None else remedy)
    return declared.crs, ""


def wkt_of(crs: CRS) -> tuple[str, bool]:
    """WKT that most programs read, and whether its first version (OGC 01-009) can say this CRS; else it is ISO 19162:2019.

    Heights of their own, derived projected CRS and some projections are known to the later version alone.
    """
    from pyproj.exceptions import CRSError

    try:
        return str(crs.to_wkt("WKT1_GDAL")), True
    except CRSError:
        return str(crs.to_wkt()), False


def ground_scale(survey_crs: str, easting: float, northing: float) -> tuple[float, float, str] | None:
    """Least and largest scale of the grid at a place (grid over ground), and the UTM zone there; None where the place has none.

    A LOCAL frame, and a place the projection cannot take back to the earth, have none.
    """
    if survey_crs == LOCAL:
        return None
    from pyproj import Proj, Transformer
    from pyproj.exceptions import ProjError

    flat = _horizontal(parse_crs(survey_crs))
    geodetic = flat.geodetic_crs
    if geodetic is None:
        return None
    try:
        # from the CRS's own meridian, as its projection counts, and in degrees, as it may not: old zones of France do in grads
        own = Transformer.from_crs(flat, geodetic, always_xy=True).transform(easting, northing, errcheck=True)
        along, up = np.degrees(np.multiply(own, geodetic.axis_info[0].unit_conversion_factor))
        factors = Proj(flat).get_factors(along, up, errcheck=True)
        longitude, latitude = Transformer.from_crs(flat, "EPSG:4326", always_xy=True).transform(easting, northing, errcheck=True)
    except ProjError:
        return None
    scales = float(factors.tissot_semiminor), float(factors.tissot_semimajor)
    if not np.isfinite([longitude, latitude, *scales]).all():
        return None
    zone = min(60, int((longitude + 180) // 6) + 1)
    return *scales, f"EPSG:{(32600 if latitude >= 0 else 32700) + zone}"


def place_in_use(survey_crs: str, easting: float, northing: float) -> tuple[float, float]:
    """A place in metres where it lies in the area of use of a survey's CRS, else that area's middle, to a kilometre.

    It stays in a LOCAL frame, and in a CRS that states no area.
    """
    if survey_crs == LOCAL:
        return easting, northing
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    crs = parse_crs(survey_crs)
    flat = _horizontal(crs)
    area = crs.area_of_use or flat.area_of_use
    if area is None:
        return easting, northing
    # from the west to the east, across the date line, too
    width = (area.east - area.west) % 360 or 360.0
    on_earth = Transformer.from_crs(flat, "EPSG:4326", always_xy=True)
    try:
        longitude, latitude = on_earth.transform(easting, northing, errcheck=True)
        if (longitude - area.west) % 360 <= width and area.south <= latitude <= area.north:
            return easting, northing
    except ProjError:
        # no place on the earth has these coordinates
        pass
    middle = (area.west + width / 2 + 180) % 360 - 180, (area.south + area.north) / 2
    east, north = on_earth.transform(*middle, direction="INVERSE", errcheck=True)
    return round(float(east), -3), round(float(north), -3)


def neighbouring_zones(survey_crs: str) -> tuple[str, ...]:
    """Codes of the UTM zones beside a UTM zone of WGS 84; none for any other CRS."""
    code = "" if survey_crs == LOCAL else _code(_horizontal(parse_crs(survey_crs)))
    number = int(code.removeprefix("EPSG:")) if code.startswith("EPSG:") else 0
    if not (32601 <= number <= 32660 or 32701 <= number <= 32760):
        return ()
    base = number // 100 * 100
    return tuple(f"EPSG:{base + (number - base - 1 + step) % 60 + 1}" for step in (-1, 1))


def vertical_name(crs: CRS | None) -> str:
    """Name of the height system that a CRS states; empty where it states none."""
    up = None if crs is None else _vertical(crs)
    return "" if up is None else str(up.name)


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


def check_same_crs(layer_crs: str, expected: str, *, source: str | Path, whose: str) -> None:
    """Refuse positions of another CRS than that of what they belong to, both as survey.toml writes them.

    Heights may be of different systems only where one of the two states none.

    Raises
    ------
    CrsError
        They differ; ``whose`` says in words what the expected one is of.
    """
    if layer_crs == expected:
        return
    if layer_crs == LOCAL:
        raise CrsError("has no CRS", source=source, remedy=f"{whose} is in {_short(expected)}: save the layer with its CRS.")
    if expected != LOCAL:
        own, other = parse_crs(layer_crs), parse_crs(expected)
        up, other_up = _vertical(own), _vertical(other)
        if _equal(_horizontal(own).to_2d(), _horizontal(other).to_2d()) and (up is None or other_up is None or _equal(up, other_up)):
            return
    raise CrsError(
        f"is in {_short(layer_crs)}, {whose} in {_short(expected)}", source=source, remedy="Give what was computed in the same CRS."
    )


def crs_text(crs: CRS | None) -> str:
    """What to write into survey.toml for a tile's CRS: a code of its horizontal part, LOCAL for a site frame, else WKT; empty for none."""
    if crs is None:
        return ""
    flat = _horizontal(crs)
    if _is_site_frame(crs):
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
    unit = _foreign_unit(crs)
    if unit:
        return f"is in {unit}, not metres"
    axes = _other_axes(crs)
    return f"counts to the {axes}, not to the east and north" if axes else ""


def _other_axes(crs: CRS) -> str:
    """Where the axes of a CRS point that shows displacements turned or mirrored, or an empty text."""
    directions = [str(axis.direction) for axis in _horizontal(crs).axis_info if axis.direction not in ("up", "down")]
    # both axes of a polar grid run along meridians, and it is no mirror image
    return " and ".join(directions) if "west" in directions or sorted(directions) == ["east", "south"] else ""


def _foreign_unit(crs: CRS) -> str:
    """Name of a unit of length that is not the metre, or an empty text."""
    for part in (_horizontal(crs), _vertical(crs)):
        for axis in part.axis_info if part is not None else ():
            if abs(axis.unit_conversion_factor - 1) > 1e-12:
                return str(axis.unit_name)
    return ""


def _is_site_frame(crs: CRS) -> bool:
    flat = _horizontal(crs)
    return not (flat.is_projected or flat.is_geographic or flat.is_geocentric)


def _overrule(crs: str, condition: str, example: str = "") -> str:
    """How to get past what a header says: the key that overrules it."""
    return f'If its numbers {condition}, add to its [[epoch]], {example}tiles_crs = "{crs}": that overrules the header.'


def _horizontal(crs: CRS) -> CRS:
    if crs.is_bound and crs.source_crs is not None:
        crs = crs.source_crs
    return _horizontal(crs.sub_crs_list[0]) if crs.is_compound else crs


def _vertical(crs: CRS) -> CRS | None:
    return crs.sub_crs_list[1] if crs.is_compound else None


def _equal(a: CRS, b: CRS) -> bool:
    return bool(a.equals(b, ignore_axis_order=True))


@lru_cache(maxsize=64)
def _best_transformer(a: CRS, b: CRS) -> Transformer:
    """PROJ's best transformation, looked for once a process: every look into a tile asks for it."""
    from pyproj import Transformer

    return Transformer.from_crs(a, b, always_xy=True, only_best=True, allow_ballpark=False)


def _transformer(a: CRS, b: CRS, source: str | Path) -> Callable[[FloatArray], FloatArray]:
    from pyproj.exceptions import ProjError

    try:
        transformer = _best_transformer(a, b)
        # with only_best a missing grid is found out only when a point is transformed
    except ProjError as error:
        raise _no_transformation(a, b, source) from error

    def apply(points: FloatArray) -> FloatArray:
        columns = points[:, 0], points[:, 1], points[:, 2]
        try:
            return np.column_stack(transformer.transform(*columns, errcheck=True))
        except ProjError as error:
            # a stray point may lie where nothing can be transformed; with nothing transformed at all, a grid is missing
            moved = np.column_stack(transformer.transform(*columns))
            if np.isfinite(moved).all(axis=1).any():
                return moved
            raise _no_transformation(a, b, source) from error

    return apply


def _flat(apply: Callable[[FloatArray], FloatArray]) -> Callable[[FloatArray], FloatArray]:
    """Transform easting and northing alone; heights stay what they were."""

    def transform(points: FloatArray) -> FloatArray:
        return np.column_stack([apply(points)[:, :2], points[:, 2]])

    return transform


def _no_transformation(a: CRS, b: CRS, source: str | Path) -> CrsError:
    from pyproj.exceptions import ProjError
    from pyproj.transformer import TransformerGroup

    try:
        with warnings.catch_warnings():
            # it warns of the grids that are asked for here
            warnings.simplefilter("ignore")
            unavailable = TransformerGroup(a, b, always_xy=True, allow_ballpark=False).unavailable_operations
    except (ProjError, IndexError):
        # what pyproj makes of no operation at all
        unavailable = []
    missing = [grid for operation in unavailable for grid in operation.grids if not grid.available]
    grids = sorted({grid.short_name for grid in missing if grid.url or grid.direct_download})
    if grids:
        remedy = f"Install the grid it needs (projsync --file {grids[0]}), or reproject the tile beforehand."
    else:
        same = f'set the survey\'s crs to that of the tile, crs = "{_code(a)}". ' if _code(a) else ""
        remedy = f"No exact transformation between the two is known: {same}{_overrule(_name(b), f'are those of {_name(b)}')}"
    return CrsError(f"cannot be transformed exactly from {_name(a)} to {_name(b)}", source=source, remedy=remedy)


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
