"""Alarm list: units displaced by more than a threshold, as CSV or GeoJSON, rejected units left out."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from io import StringIO
from pathlib import Path
from typing import Any

from ..common.atomic_files import write_whole
from ..common.csv_text import SPREADSHEET_ENCODING, signs, spreadsheet_safe
from ..common.errors import InputError
from ..common.output_files import check_own
from ..results.field_checks import foreign_contents
from ..results.geopackage_reader import EpochPair, crs_of
from ..results.unit_legs import FIELDS_OF_LEGS
from ..results.unit_rows import UnitRow, over, read_unit_rows
from ..review.decisions import read_reviews, rejected_units
from .result_choice import choose_pair

HIGHEST_THRESHOLD = 10.0
"""Metres, as of the grades in survey.toml: a threshold above it was meant in millimetres."""
COLUMNS_OF_UNITS = (
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
    "broken_legs",
    "leg_missing",
    "decision",
    "reviewer",
    "comment",
)
COLUMNS = COLUMNS_OF_UNITS + FIELDS_OF_LEGS
"""The last ones as in the layer ``units``, of the later epoch."""


def write_alarms(
    result: Path, output: Path, threshold: float, *, pair: EpochPair | None = None, datum: str | None = None, separator: str = "comma"
) -> int:
    """Write the alarm list of an epoch pair and return the number of units on it.

    Lost and relocated units and those with a broken leg are on the list whatever the threshold.

    Parameters
    ----------
    result
        result.gpkg.
    output
        ``.csv`` or, where the survey's CRS has an EPSG code, ``.geojson`` (coordinates in that CRS, named in the file's ``crs`` member).
    threshold
        3D displacement of the centre in metres.
    pair, datum
        The last consecutive pair and the default datum unless given.
    separator
        Of a CSV, by its name in :data:`~tetratrack.core.common.csv_text.SEPARATORS`.

    Raises
    ------
    InputError
        The result has no such pair, the threshold is none, the output's ending is another, or a GeoJSON could not say its CRS.
    OutputError
        The file cannot be written.
    """
    if not 0 <= threshold <= HIGHEST_THRESHOLD:
        likely = f"Is it in millimetres? Then write {threshold / 1000:g}." if threshold > 0 else ""
        raise InputError(f"threshold must be from 0 to {HIGHEST_THRESHOLD:g} metres, not {threshold:g}", remedy=likely)
    with foreign_contents(result):
        return _write_alarms(result, output, threshold, pair, datum, separator)


def _write_alarms(result: Path, output: Path, threshold: float, pair: EpochPair | None, datum: str | None, separator: str) -> int:
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
        check_own(output, COLUMNS[:3])
        content = _csv(records, separator).encode(SPREADSHEET_ENCODING)
    elif kind in (".geojson", ".json"):
        check_own(output, (_GEOJSON_START,))
        code = crs_of(result).horizontal_epsg
        if code is None:
            raise InputError(
                "the result's CRS has no EPSG code, without which GeoJSON means longitude and latitude",
                source=output,
                remedy="End the name in .csv.",
            )
        content = _geojson(rows, records, code).encode("utf-8")
    else:
        raise InputError(
            f"cannot be written as {kind or 'a file without ending'}", source=output, remedy="End the name in .csv or .geojson."
        )
    write_whole(output, content)
    return len(rows)


_GEOJSON_START = '{\n "type": "FeatureCollection",\n "features": ['


def _record(row: UnitRow, pair: EpochPair, datum: str, words: tuple[str, str, str]) -> dict[str, Any]:
    place = (None, None, None) if row.place is None else tuple(round(float(value), 4) for value in row.place)
    measures = (row.d_3d, row.sd_3d, row.d_horizontal, row.vertical, row.rotation_deg)
    rounded = [None if value is None else round(float(value), 5) for value in measures]
    legs = " ".join(str(k) for k in row.broken_legs)
    missing = None if row.leg_missing is None else round(float(row.leg_missing), 3)
    values = (row.unit_id, row.kind, pair.epoch_from, pair.epoch_to, datum, *place, *rounded, row.p_value, legs, missing, *words)
    return dict(zip(COLUMNS_OF_UNITS, values, strict=True)) | dict.fromkeys(FIELDS_OF_LEGS) | _leg_values(row)


def _leg_values(row: UnitRow) -> dict[str, Any]:
    """Of each leg its state, missing length in metres and probability of being broken; nothing where the result does not say."""
    values: dict[str, Any] = {}
    for leg in row.legs:
        missing, share = (None if value is None else round(float(value), 3) for value in (leg.missing, leg.probability))
        values |= {f"leg{leg.number}": leg.state, f"leg{leg.number}_missing": missing, f"leg{leg.number}_probability": share}
    return values


def _csv(records: Sequence[dict[str, Any]], separator: str) -> str:
    between, decimal = signs(separator)
    text = StringIO()
    writer = csv.DictWriter(text, COLUMNS, delimiter=between, lineterminator="\n")
    writer.writeheader()
    writer.writerows([{name: _cell(value, decimal) for name, value in record.items()} for record in records])
    return text.getvalue()


def _cell(value: Any, decimal: str) -> Any:
    return str(value).replace(".", decimal) if isinstance(value, float) else spreadsheet_safe(value)


def _geojson(rows: Sequence[UnitRow], records: Sequence[dict[str, Any]], epsg: int) -> str:
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
    content["crs"] = {"type": "name", "properties": {"name": f"urn:ogc:def:crs:EPSG::{epsg}"}}
    return json.dumps(content, ensure_ascii=False, indent=1)
