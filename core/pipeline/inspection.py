"""Step ``inspect``: every input with a verdict, before an hour is spent; as a table and, if asked for, a layer of the tiles."""

from __future__ import annotations

import io
import re
import sqlite3
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..common.atomic_files import write_whole
from ..common.errors import InputError, OutputError
from ..common.feedback import Feedback
from ..common.output_files import check_targets
from ..common.paths import sqlite_address
from ..common.sqlite_files import recover
from ..data.crs import LOCAL
from ..data.survey import Survey
from ..data.tile_dates import tile_dates
from ..data.tiles import TileInfo, inspect_tile
from .size_check import check_sizes
from .survey_check import Finding, Verdict, check_survey, first_error
from .target_check import check_spacing

LAYER = "tiles"
SEVERITY: tuple[Verdict, ...] = ("ok", "note", "warning", "refused")


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
            findings.append(Finding(verdict="refused", what="tile", name=path.name, message=str(error), error=error))
        else:
            said = [*tile.remarks, *([] if tile.used else [f"{path.name}: holds no points that are used"])]
            verdict: Verdict = "warning" if tile.unread or not tile.used else "note" if said else "ok"
            findings.append(Finding(verdict=verdict, what="tile", name=path.name, message="; ".join(said), tile=tile))
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
    alone = [item for item in inputs if isinstance(item, Path)]
    for item in inputs:
        if isinstance(item, Survey):
            findings += inspect_survey(item, feedback)
    findings += inspect_files(alone, feedback)
    tiles = [finding.tile for finding in findings if finding.tile is not None]
    rows = _rows(findings)
    if output is not None:
        write_tile_index(output, tiles, {row["path"]: row for row in rows})
    names = [tile.crs for tile in tiles]
    outputs = {
        "tiles": len(tiles),
        "points": sum(tile.points for tile in tiles),
        "density": float(np.median([tile.density for tile in tiles])) if tiles else 0.0,
        "crs": max(sorted(set(names)), key=names.count) if names else "",
        "verdict": max((finding.verdict for finding in findings), key=SEVERITY.index, default="ok"),
        "refused": sum(row["verdict"] == "refused" for row in rows),
        "warnings": sum(row["verdict"] == "warning" for row in rows),
        "table": [{name: value for name, value in row.items() if name != "path"} for row in rows],
    }
    return outputs, first_error(findings)


def _rows(findings: Sequence[Finding]) -> list[dict[str, Any]]:
    """One row an input, with the worst verdict on it and all that there is to say."""
    rows: dict[tuple[str, str, str], dict[str, Any]] = {}
    for finding in findings:
        key = (finding.epoch, finding.what, finding.name)
        row = rows.setdefault(
            key,
            {"epoch": finding.epoch, "input": finding.name, "what": finding.what, "verdict": "ok"}
            | {"points": "", "used": "", "density": "", "crs": "", "extent": "", "remark": "", "path": ""},
        )
        row["verdict"] = max(row["verdict"], finding.verdict, key=SEVERITY.index)
        named = {finding.name} if finding.error is None else {finding.name, str(finding.error.source)}
        said = re.sub(rf"(^|; )(?:{'|'.join(map(re.escape, named))}): ", r"\1", finding.message)
        row["remark"] = "; ".join(part for part in (row["remark"], said) if part)
        tile = finding.tile
        if tile is not None:
            row |= {
                "points": tile.points,
                "used": tile.used,
                "density": round(tile.density, 1),
                "crs": tile.crs if len(tile.crs) < 20 else f"{tile.crs[:19]}…",
                "extent": " ".join(f"{low:.2f}..{high:.2f}" for low, high in zip(tile.low, tile.high, strict=True)),
                "path": str(tile.path),
            }
    return list(rows.values())


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


def write_tile_index(path: Path, tiles: Sequence[TileInfo], rows: dict[str, dict[str, Any]]) -> None:
    """Write one rectangle per tile to the layer ``tiles`` of a new GeoPackage, replacing an earlier one.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import geopandas
    import shapely

    frame = geopandas.GeoDataFrame(
        {
            "file": [str(tile.path) for tile in tiles],
            "points": [tile.points for tile in tiles],
            "density": [tile.density for tile in tiles],
            "height_min": [tile.low[2] for tile in tiles],
            "height_max": [tile.high[2] for tile in tiles],
            "crs": [tile.crs for tile in tiles],
            "measured": [_day(tile.path) for tile in tiles],
            "las_version": [tile.version for tile in tiles],
            "point_format": [tile.point_format for tile in tiles],
            "copc": [tile.copc for tile in tiles],
            "used": [tile.used for tile in tiles],
            "verdict": [str(rows[str(tile.path)]["verdict"]) for tile in tiles],
            "remark": [str(rows[str(tile.path)]["remark"]) for tile in tiles],
        },
        geometry=[shapely.box(tile.low[0], tile.low[1], tile.high[0], tile.high[1]) for tile in tiles],
        crs=next((tile.crs for tile in tiles if tile.crs not in ("", LOCAL)), None),
    )
    # GDAL says little of a disk that is full: the file is made in memory and then written
    content = io.BytesIO()
    frame.to_file(content, layer=LAYER, driver="GPKG", engine="pyogrio")
    write_whole(path.absolute(), content.getvalue())
