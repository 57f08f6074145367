"""Step ``inspect``: every input with a verdict, before an hour is spent; as a table and, if asked for, a layer of the tiles."""

from __future__ import annotations

import io
import re
import sqlite3
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..common.atomic_files import cannot_write, temporary_beside
from ..common.errors import InputError, OutputError
from ..common.feedback import Feedback
from ..common.output_files import check_targets
from ..common.paths import sqlite_address
from ..common.sqlite_files import recover
from ..data.crs import LOCAL, parse_crs
from ..data.survey import Survey
from ..data.tile_dates import tile_dates
from ..data.tiles import TileInfo, inspect_tile
from ..results.result_replacement import put_whole_in_place
from .input_findings import Finding, Verdict, first_error, refused
from .size_check import check_sizes
from .survey_check import check_survey
from .target_check import check_spacing

LAYER = "tiles"
SEVERITY: tuple[Verdict, ...] = ("ok", "note", "warning", "refused")


@dataclass(frozen=True, kw_only=True)
class Row:
    """One input with all that there is to say of it.

    Attributes
    ----------
    cells
        Of the table, by column.
    path, tile
        The file of a tile, and what is known of it.
    crs
        CRS of its extent: the survey's, or its own where it is looked at by itself.
    """

    cells: dict[str, Any]
    path: Path | None = None
    tile: TileInfo | None = None
    crs: str = ""


def inspect_survey(survey: Survey, feedback: Feedback) -> tuple[Finding, ...]:
    """Findings on every input of a survey; tiles are stated as they go into a run."""
    check = check_survey(survey, feedback)
    used = {(label, tile.path): tile for label, tiles in check.tiles.items() for tile in tiles}
    # a size is only looked for in a cloud that is sound
    sound = first_error(check.findings) is None
    sizes = _sizes(survey, check.tiles[survey.epochs[0].label], feedback) if sound else []
    spacings = [found for epoch in survey.epochs for found in check_spacing(survey, epoch, check.tiles[epoch.label])] if sound else []
    return tuple(
        replace(finding, tile=used.get((finding.epoch, finding.tile.path), finding.tile)) if finding.tile is not None else finding
        for finding in [*check.findings, *sizes, *spacings]
    )


def _sizes(survey: Survey, tiles: Sequence[TileInfo], feedback: Feedback) -> list[Finding]:
    """Findings on the size of the units, held against the tiles of the first epoch."""
    said: list[Finding] = []

    def keep(verdict: Verdict) -> Callable[[str], None]:
        return lambda message: said.append(Finding(verdict=verdict, what="unit", name="height", message=message))

    try:
        check_sizes(survey, tiles, replace(feedback, info=keep("ok"), warning=keep("warning")))
    except InputError as error:
        said.append(Finding(verdict="refused", what="unit", name="height", message=str(error), error=error))
    return said


def inspect_files(paths: Sequence[Path], feedback: Feedback) -> tuple[Finding, ...]:
    """Findings on tiles by themselves, whatever their CRS; one that cannot be read does not hide the others."""
    findings = []
    for k, path in enumerate(paths):
        feedback.check()
        try:
            tile = inspect_tile(path, None, is_cancelled=feedback.is_cancelled)
        except InputError as error:
            findings.append(refused(None, "tile", error, path.name, path))
        else:
            said = [*tile.remarks, *([] if tile.used else [f"{path.name}: holds no points that are used"])]
            verdict: Verdict = "warning" if tile.unread or not tile.used else "note" if said else "ok"
            findings.append(Finding(verdict=verdict, what="tile", name=path.name, message="; ".join(said), tile=tile, path=path))
        feedback.progress((k + 1) / len(paths), f"checked {path.name}")
    return tuple(findings)


def run_inspect(inputs: Sequence[Survey | Path], output: Path | None, feedback: Feedback) -> tuple[dict[str, Any], InputError | None]:
    """Step ``inspect``.

    Parameters
    ----------
    inputs
        Surveys, and single tiles.
    output
        GeoPackage for a layer ``tiles`` of the tiles' extents, or None.
    feedback
        Messages and cancelling.

    Returns
    -------
    Numbers of tiles and points, median density, the CRS that most tiles declare, the worst verdict, and the rows of the table; and
    what a run would end with, or None.

    Raises
    ------
    OutputError
        The layer would replace something else than an earlier one.
    """
    files = [path for item in inputs for path in (item.files if isinstance(item, Survey) else (item,))]
    if output is not None:
        _check_index(output, files)
    findings: list[Finding] = []
    rows: list[Row] = []
    for item in inputs:
        if isinstance(item, Survey):
            own = inspect_survey(item, feedback)
            findings += own
            rows += _rows(own, item.crs)
    own = inspect_files([item for item in inputs if isinstance(item, Path)], feedback)
    findings += own
    rows += _rows(own)
    _tell_apart(rows)
    tiles = [row.tile for row in rows if row.tile is not None]
    if output is not None:
        write_tile_index(output, rows)
    names = [tile.crs for tile in tiles]
    outputs = {
        "tiles": len(tiles),
        "points": sum(tile.points for tile in tiles),
        "density": float(np.median([tile.density for tile in tiles])) if tiles else 0.0,
        "crs": max(sorted(set(names)), key=names.count) if names else "",
        "verdict": max((finding.verdict for finding in findings), key=SEVERITY.index, default="ok"),
        "refused": sum(row.cells["verdict"] == "refused" for row in rows),
        "warnings": sum(row.cells["verdict"] == "warning" for row in rows),
        "table": [row.cells for row in rows],
    }
    return outputs, first_error(findings)


def _rows(findings: Sequence[Finding], survey_crs: str | None = None) -> list[Row]:
    """One row an input of a survey, or of tiles by themselves, with the worst verdict on it and all that there is to say."""
    rows: dict[tuple[str, str, str, Path | None], Row] = {}
    for finding in findings:
        # tiles of several folders may have one name
        key = (finding.epoch, finding.what, finding.name, finding.path)
        blank = dict.fromkeys(("points", "used", "density", "crs", "extent", "remark"), "")
        named = {"epoch": finding.epoch, "input": finding.name, "what": finding.what, "verdict": "ok"}
        row = rows.setdefault(key, Row(cells=named | blank, path=finding.path))
        cells = row.cells
        cells["verdict"] = max(cells["verdict"], finding.verdict, key=SEVERITY.index)
        sources = {finding.name} if finding.error is None else {finding.name, str(finding.error.source)}
        said = re.sub(rf"(^|; )(?:{'|'.join(map(re.escape, sources))}): ", r"\1", finding.message)
        cells["remark"] = "; ".join(part for part in (cells["remark"], said) if part)
        tile = finding.tile
        if tile is not None:
            cells |= {
                "points": tile.points,
                "used": tile.used,
                "density": round(tile.density, 1),
                "crs": tile.crs if len(tile.crs) < 20 else f"{tile.crs[:19]}…",
                "extent": " ".join(f"{low:.2f}..{high:.2f}" for low, high in zip(tile.low, tile.high, strict=True)),
            }
            rows[key] = replace(row, tile=tile, crs=tile.crs if survey_crs is None else survey_crs)
    return list(rows.values())


def _tell_apart(rows: Sequence[Row]) -> None:
    """Name tiles of one epoch and name by their paths."""
    names = Counter((row.cells["epoch"], row.cells["input"]) for row in rows if row.path is not None)
    for row in rows:
        if row.path is not None and names[row.cells["epoch"], row.cells["input"]] > 1:
            row.cells["input"] = str(row.path)


def _check_index(output: Path, inputs: Sequence[Path]) -> None:
    """Refuse to replace what is no earlier layer of tiles."""
    check_targets([(output, "tiles")], inputs)
    if not output.exists():
        return
    useless = OutputError("exists and is no layer of tiles of tetratrack", source=output, remedy="Choose another name, or delete it first.")
    if not output.is_file():
        raise useless
    recover(output)
    try:
        with closing(sqlite3.connect(sqlite_address(output.resolve(), "mode=ro"), uri=True)) as connection:
            layers = {str(row[0]) for row in connection.execute("SELECT table_name FROM gpkg_contents")}
            columns = {str(row[1]) for row in connection.execute("PRAGMA table_info(tiles)")}
    except sqlite3.Error as error:
        raise useless from error
    if layers != {LAYER} or not {"file", "points", "density", "las_version"} <= columns:
        raise useless


def _day(path: Path) -> str:
    """Day on which a tile was measured, or made, which then carries a question mark."""
    dates = tile_dates(path)
    if dates.measured is not None:
        return dates.measured.date().isoformat()
    return f"{dates.made.isoformat()}?" if dates.made is not None else ""


def write_tile_index(path: Path, rows: Sequence[Row]) -> None:
    """Write one rectangle per tile to the layer ``tiles`` of a new GeoPackage, replacing an earlier one.

    The layer is in the first CRS of the extents; those in others are transformed, those of no place on earth stay as they are.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import geopandas

    known = [(row.tile, row) for row in rows if row.tile is not None]
    crs = next((row.crs for _, row in known if row.crs not in ("", LOCAL)), None)
    frame = geopandas.GeoDataFrame(
        {
            "file": [str(tile.path) for tile, _ in known],
            "points": [tile.points for tile, _ in known],
            "density": [tile.density for tile, _ in known],
            "height_min": [tile.low[2] for tile, _ in known],
            "height_max": [tile.high[2] for tile, _ in known],
            "crs": [tile.crs for tile, _ in known],
            "measured": [_day(tile.path) for tile, _ in known],
            "las_version": [tile.version for tile, _ in known],
            "point_format": [tile.point_format for tile, _ in known],
            "copc": [tile.copc for tile, _ in known],
            "used": [tile.used for tile, _ in known],
            "verdict": [str(row.cells["verdict"]) for _, row in known],
            "remark": [str(row.cells["remark"]) for _, row in known],
        },
        geometry=[_rectangle(tile, row.crs, crs) for tile, row in known],
        crs=crs,
    )
    # GDAL says little of a disk that is full: the file is made in memory and then written
    content = io.BytesIO()
    frame.to_file(content, layer=LAYER, driver="GPKG", engine="pyogrio")
    target = path.absolute()
    try:
        with temporary_beside(target) as temporary:
            temporary.write_bytes(content.getvalue())
            put_whole_in_place(temporary, target)
    except (sqlite3.Error, OSError) as error:
        raise cannot_write(target, error) from error


def _rectangle(tile: TileInfo, own: str, crs: str | None) -> Any:
    """Extent of a tile, stated in one CRS, as a rectangle in another."""
    import shapely
    from pyproj import Transformer

    bounds = (*tile.low[:2], *tile.high[:2])
    if crs is not None and own not in ("", LOCAL, crs):
        bounds = Transformer.from_crs(parse_crs(own), parse_crs(crs), always_xy=True).transform_bounds(*bounds)
    return shapely.box(*bounds)
