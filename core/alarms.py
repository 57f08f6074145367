"""Alarm list: units displaced by more than a threshold, as CSV or GeoJSON, rejected units left out."""

from __future__ import annotations

import csv
import json
import os
import tempfile
from collections.abc import Sequence
from contextlib import closing
from io import StringIO
from pathlib import Path
from typing import Any

from .displacement_rows import UnitRow, datums, over, read_unit_rows
from .errors import InputError, OutputError
from .result_tables import EpochPair, connect, epoch_pairs, srs_of
from .reviews import read_reviews, rejected_units

COLUMNS = (
    "unit_id",
    "class",
    "epoch_from",
    "epoch_to",
    "datum",
    "easting",
    "northing",
    "height",
    "d_3d",
    "sd_3d",
    "d_horizontal",
    "dh",
    "rotation_deg",
    "p_value",
    "decision",
    "reviewer",
    "comment",
)


def write_alarms(result: Path, output: Path, threshold: float, *, pair: EpochPair | None = None, datum: str | None = None) -> int:
    """Write the alarm list of an epoch pair and return the number of units on it.

    Lost and relocated units are on the list whatever the threshold.

    Parameters
    ----------
    result
        result.gpkg.
    output
        ``.csv`` or ``.geojson`` (coordinates in the survey's CRS, named in the file's ``crs`` member).
    threshold
        3D displacement of the centre in metres.
    pair, datum
        The last consecutive pair and the default datum unless given.

    Raises
    ------
    InputError
        The result has no such pair, or the output's ending is another.
    OutputError
        The file cannot be written.
    """
    chosen, reference = choose_pair(result, pair, datum)
    rows = over(read_unit_rows(result, chosen, reference), threshold, rejected_units(result, chosen))
    reviews = read_reviews(result)
    records = []
    for row in rows:
        review = reviews.get((row.unit_id, chosen))
        words = (review.decision, review.reviewer, review.comment) if review else ("", "", "")
        records.append(_record(row, chosen, reference, words))
    kind = output.suffix.lower()
    if kind == ".csv":
        text = _csv(records)
    elif kind in (".geojson", ".json"):
        with closing(connect(result)) as connection:
            text = _geojson(rows, records, srs_of(connection))
    else:
        raise InputError(
            f"cannot be written as {kind or 'a file without ending'}", source=output, remedy="End the name in .csv or .geojson."
        )
    write_whole(output, text.encode("utf-8"))
    return len(rows)


def choose_pair(result: Path, pair: EpochPair | None, datum: str | None) -> tuple[EpochPair, str]:
    """The pair and datum asked for, or the last consecutive pair and its default datum.

    Raises
    ------
    InputError
        The result has no displacements, or none of that pair or datum.
    """
    pairs = epoch_pairs(result)
    if not pairs:
        raise InputError("holds no displacements", source=result, remedy="A survey of two epochs or more is needed.")
    with closing(connect(result)) as connection:
        statement = "SELECT epoch_from, epoch_to FROM displacements ORDER BY time_to DESC LIMIT 1"
        last = connection.execute(statement).fetchone()
    chosen = pair or (EpochPair(last["epoch_from"], last["epoch_to"]) if last else pairs[0])
    if chosen not in pairs:
        raise InputError(f"has no epoch pair {chosen}", source=result, remedy=f"It has {', '.join(str(p) for p in pairs)}.")
    available = datums(result, chosen)
    if datum is not None and datum not in available:
        raise InputError(f"has no datum {datum} for {chosen}", source=result, remedy=f"It has {', '.join(available)}.")
    return chosen, datum or available[0]


def write_whole(path: Path, content: bytes) -> None:
    """Write a file completely or not at all.

    Raises
    ------
    OutputError
        The folder does not exist or cannot be written.
    """
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f"{path.name}.", delete=False) as work:
            work.write(content)
        os.chmod(work.name, 0o644)
        os.replace(work.name, path)
    except OSError as error:
        raise OutputError(
            f"cannot be written ({error.strerror})", source=path, remedy="Choose a folder that exists and can be written."
        ) from error


def _record(row: UnitRow, pair: EpochPair, datum: str, words: tuple[str, str, str]) -> dict[str, Any]:
    place = (None, None, None) if row.place is None else tuple(round(float(value), 4) for value in row.place)
    measures = (row.d_3d, row.sd_3d, row.d_horizontal, row.vertical, row.rotation_deg)
    rounded = [None if value is None else round(float(value), 5) for value in measures]
    values = (row.unit_id, row.kind, pair.epoch_from, pair.epoch_to, datum, *place, *rounded, row.p_value, *words)
    return dict(zip(COLUMNS, values, strict=True))


def _csv(records: Sequence[dict[str, Any]]) -> str:
    text = StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows([{name: _safe(value) for name, value in record.items()} for record in records])
    return text.getvalue()


def _safe(value: Any) -> Any:
    """A comment that a spreadsheet would run as a formula becomes text."""
    return f"'{value}" if isinstance(value, str) and value.startswith(("=", "+", "-", "@")) else value


def _geojson(rows: Sequence[UnitRow], records: Sequence[dict[str, Any]], srs: int) -> str:
    features = [
        {
            "type": "Feature",
            "geometry": None if row.place is None else {"type": "Point", "coordinates": [round(float(value), 4) for value in row.place]},
            "properties": record,
        }
        for row, record in zip(rows, records, strict=True)
    ]
    content: dict[str, Any] = {"type": "FeatureCollection", "features": features}
    # RFC 7946 knows longitude and latitude only; the older crs member, which GDAL and QGIS read, keeps survey coordinates exact
    if srs > 0:
        content["crs"] = {"type": "name", "properties": {"name": f"urn:ogc:def:crs:EPSG::{srs}"}}
    return json.dumps(content, ensure_ascii=False, indent=1)
