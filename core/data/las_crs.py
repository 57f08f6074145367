"""The CRS that a LAS header declares: WKT or GeoTIFF keys, with units, user-defined systems and citations, as files have them."""

from __future__ import annotations

import struct
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from .las_files import LasHeader

if TYPE_CHECKING:
    from pyproj import CRS

PROJECTION = "LASF_Projection"
WKT_RECORD, KEYS_RECORD, DOUBLES_RECORD, TEXTS_RECORD = 2112, 34735, 34736, 34737
MODEL_TYPE, CITATIONS, PLANE_UNIT, PLANE_UNIT_SIZE, HEIGHT_SYSTEM, HEIGHT_UNIT = 1024, (3073, 1026, 2049, 4097), 3076, 3077, 4096, 4099
"""Keys of GeoTIFF (OGC 19-008r4, 7)."""
USER_DEFINED, PROJECTED = 32767, 1
METRE = 9001
UNITS = {
    9002: "foot", 9003: "US survey foot", 9005: "Clarke's foot", 9014: "fathom", 9030: "nautical mile", 9031: "German legal metre",
    9036: "kilometre", 9084: "Indian foot", 9094: "Gold Coast foot", 9096: "yard", 1025: "millimetre", 1033: "centimetre",
}  # fmt: skip
"""Names of units of length by EPSG code."""


@dataclass(frozen=True, eq=False)
class DeclaredCrs:
    """What a header says of its CRS.

    Attributes
    ----------
    crs
        None where it declares none, or one that cannot be understood.
    problem
        Why coordinates are not to be taken as they stand, as a clause ("is in US survey foot, not metres (heights)"); empty where
        nothing is wrong.
    name
        What to call it; empty where nothing is declared.
    other
        What to call another CRS that the header declares too; empty where there is none.
    """

    crs: CRS | None = None
    problem: str = ""
    name: str = ""
    other: str = ""


def declared_crs(header: LasHeader) -> DeclaredCrs:
    """CRS of a header: its WKT if the header says so, else its GeoTIFF keys; the other of the two where that one is absent or useless."""
    ways = (_from_wkt, _from_keys) if header.wkt or header.point_format >= 6 else (_from_keys, _from_wkt)
    found = [declared for way in ways for declared in way(header)]
    usable = [declared for declared in found if declared.crs is not None]
    chosen = (usable or found or [DeclaredCrs()])[0]
    # a program that transforms a cloud may leave the old statement beside the new one
    other = next((rest for rest in usable[1:] if not _same_place(chosen.crs, rest.crs)), None)
    return chosen if other is None else replace(chosen, other=other.name)


def _same_place(one: CRS | None, other: CRS | None) -> bool:
    """Whether two definitions give a place the same easting and northing, but for how they are written."""
    if one is None or other is None:
        return one is other
    flat = [(crs.sub_crs_list[0] if crs.is_compound else crs) for crs in (one, other)]
    codes = [crs.to_epsg() for crs in flat]
    return bool(None in codes or codes[0] == codes[1])


def _from_wkt(header: LasHeader) -> list[DeclaredCrs]:
    contents = [header.content_of(record) for record in header.records if (record.user_id, record.record_id) == (PROJECTION, WKT_RECORD)]
    return [declared for content in contents if (declared := _of_wkt(content)) is not None]


def _of_wkt(content: bytes | None) -> DeclaredCrs | None:
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    if content is None:
        return None
    text = content.split(b"\0")[0].decode("utf-8", "replace").strip().strip("\"'").strip()
    if not text:
        return DeclaredCrs(problem="declares an empty CRS", name="an empty CRS") if content.strip(b"\0 \r\n\t") else None
    try:
        crs = CRS.from_wkt(text)
    except CRSError:
        name = " ".join(text.split('"')[1:2]).strip()[:40]
        return DeclaredCrs(problem="declares a CRS that cannot be understood", name=f"{name!r}, which cannot be understood")
    return DeclaredCrs(crs, name=str(crs.name))


def _from_keys(header: LasHeader) -> list[DeclaredCrs]:
    content = header.content(PROJECTION, KEYS_RECORD)
    if content is None or len(content) < 8:
        return []
    shorts = struct.unpack(f"<{len(content) // 2}H", content[: len(content) // 2 * 2])
    rows = [shorts[k : k + 4] for k in range(4, min(len(shorts), 4 + 4 * shorts[3]) - 3, 4)]
    if not any(key for key, *_ in rows):
        return []
    doubles = (header.content(PROJECTION, DOUBLES_RECORD) or b"").ljust(8, b"\0")
    texts = (header.content(PROJECTION, TEXTS_RECORD) or b"").rstrip(b"\0") + b"\0"
    plain = {key: value for key, place, _, value in rows if place == 0}
    named = {key: texts[at : at + n].rstrip(b"|\0 ").decode("latin-1") for key, place, n, at in rows if place == TEXTS_RECORD}
    sizes = {key: _double(doubles, at) for key, place, _, at in rows if place == DOUBLES_RECORD}
    citation = next((named[key] for key in CITATIONS if named.get(key)), "")
    units = _unit_problem(plain, sizes)
    crs = _crs_of_tags(struct.pack(f"<{4 + 4 * len(rows)}H", *shorts[:3], len(rows), *(v for row in rows for v in row)), doubles, texts)
    if crs is not None and plain.get(MODEL_TYPE) == PROJECTED and not (crs.is_projected or crs.is_compound):
        # a projection by its name alone: GDAL makes a frame without place of it
        crs = None
    if crs is None:
        name = f"{citation!r}" if citation else "GeoTIFF keys without a name"
        problem = units or f"declares a CRS that cannot be understood ({name})"
        return [DeclaredCrs(problem=problem, name=f"{name}, which cannot be understood")]
    return [DeclaredCrs(crs, units, citation or str(crs.name))]


def _double(content: bytes, at: int) -> float:
    return float(struct.unpack_from("<d", content, 8 * at)[0]) if 8 * at + 8 <= len(content) else float("nan")


def _unit_problem(plain: dict[int, int], sizes: dict[int, float]) -> str:
    """What the keys say of units that are not metres, whatever the system's own are."""
    for key, what in ((PLANE_UNIT, "easting and northing"), (HEIGHT_UNIT, "heights")):
        code = plain.get(key, METRE)
        if code in (0, METRE) or (key == PLANE_UNIT and plain.get(MODEL_TYPE) == 2):
            continue
        if code == USER_DEFINED:
            if key != PLANE_UNIT or abs(sizes.get(PLANE_UNIT_SIZE, 1.0) - 1) < 1e-9:
                continue
            name = f"a unit of {sizes[PLANE_UNIT_SIZE]:.7g} m"
        else:
            name = UNITS.get(code, f"unit EPSG:{code}")
        return f"is in {name}, not metres ({what})"
    return ""


def _crs_of_tags(keys: bytes, doubles: bytes, texts: bytes) -> CRS | None:
    """CRS of GeoTIFF keys as GDAL reads them from an image of one pixel: it knows user-defined systems and citations."""
    from pyproj import CRS
    from pyproj.exceptions import CRSError
    from rasterio import Env
    from rasterio.errors import RasterioError
    from rasterio.io import MemoryFile

    try:
        with Env(GTIFF_REPORT_COMPD_CS=True), MemoryFile(_one_pixel(keys, doubles, texts), ext=".tif") as memory, memory.open() as image:
            wkt = image.crs.to_wkt() if image.crs else ""
        return CRS.from_wkt(wkt) if wkt else None
    except (RasterioError, CRSError, ValueError):
        return None


def _one_pixel(keys: bytes, doubles: bytes, texts: bytes) -> bytes:
    """A TIFF of one grey pixel with the keys' tags, placed somewhere."""
    short, long, double, ascii_ = 3, 4, 12, 2
    tags: list[tuple[int, int, int, bytes]] = [
        (256, short, 1, struct.pack("<H", 1)), (257, short, 1, struct.pack("<H", 1)), (258, short, 1, struct.pack("<H", 8)),
        (259, short, 1, struct.pack("<H", 1)), (262, short, 1, struct.pack("<H", 1)), (273, long, 1, struct.pack("<I", 8)),
        (277, short, 1, struct.pack("<H", 1)), (278, short, 1, struct.pack("<H", 1)), (279, long, 1, struct.pack("<I", 1)),
        (33550, double, 3, struct.pack("<3d", 1, 1, 0)), (33922, double, 6, bytes(48)),
        (KEYS_RECORD, short, len(keys) // 2, keys), (DOUBLES_RECORD, double, len(doubles) // 8, doubles[: len(doubles) // 8 * 8]),
        (TEXTS_RECORD, ascii_, len(texts), texts),
    ]  # fmt: skip
    start = 16
    extra_at = start + 2 + 12 * len(tags) + 4
    directory, extra = struct.pack("<H", len(tags)), b""
    for tag, kind, number, content in tags:
        if len(content) <= 4:
            value = content.ljust(4, b"\0")
        else:
            value = struct.pack("<I", extra_at + len(extra))
            extra += content + bytes(len(content) % 2)
        directory += struct.pack("<HHI", tag, kind, number) + value
    return struct.pack("<2sHI", b"II", 42, start) + bytes(8) + directory + bytes(4) + extra
