"""Algorithms that work on one epoch's tiles: from parameters to the engine's survey.toml."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from datetime import MAXYEAR, UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsField,
    QgsFields,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import Qt

from ..core.results.schema import LAYERS
from .base import TetratrackAlgorithm
from .support.inputs import (
    AREA,
    CONTROL,
    CRS,
    EPOCH,
    LOCAL,
    TARGETS,
    TILES,
    TIME,
    UNIT,
    EpochInput,
    SurveyInput,
    check_crs,
    check_pair,
    check_unit,
    crs_text,
    epoch_time,
    ring_of,
    tile_paths,
    tiles_override,
    unit_values,
    write_points,
)
from .support.layers import FIELD_TYPES, wkb_type
from .support.point_files import FILE_COLUMNS
from .support.translation import tr
from .support.wording import few


class SurveyAlgorithm(TetratrackAlgorithm):
    """Reads whichever of the shared parameters the algorithm declares."""

    tiles_crs = ""
    """CRS that the user set for the layers of the tiles, in place of the one they declare."""

    def has(self, name: str) -> bool:
        """Whether this algorithm declares a parameter."""
        return self.parameterDefinition(name) is not None

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        problems = []
        if self.has(UNIT):
            problems.append(check_unit(self, parameters, context))
        if self.has(CRS):
            problems.append(check_crs(self, parameters, context))
        if self.has(CONTROL) and self.has(TARGETS):
            problems.append(check_pair(parameters))
        for problem in filter(None, problems):
            return False, problem
        return super().checkParameterValues(parameters, context)

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        if self.has(TILES) and parameters.get(TILES):
            self.tiles = tile_paths(parameters[TILES], context, self.parameterDefinition(TILES).description())
            self.tiles_crs = tiles_override(parameters[TILES], context)
        return True

    def survey(
        self, folder: Path, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> Path | None:
        """Write survey.toml for the parameters into a folder; None when the user cancelled."""
        crs = self.parameterAsCrs(parameters, CRS, context)
        chosen = crs_text(crs)
        text = chosen or self.tiles_crs or self.crs_of_tiles(folder, self.tiles, feedback)
        if text is None:
            return None
        crs = crs if crs.isValid() else QgsCoordinateReferenceSystem(text if text != LOCAL else "")
        label = self.parameterAsString(parameters, EPOCH, context).strip() or "1"
        files = self.point_files(folder, parameters, context, crs)
        tables = {key: self.parameterDefinition(key.upper()).description() for key in files}
        epoch = EpochInput(
            label,
            self.time(parameters, context),
            self.tiles,
            files,
            place=tr("Epoch {label}").format(label=label),
            tables=tables,
            tiles_crs=self.tiles_crs,
        )
        area = ring_of(self.parameterAsSource(parameters, AREA, context), crs, context) if self.has(AREA) else []
        given = SurveyInput(text, unit_values(self, parameters, context), [epoch], undeclared_crs=chosen, area=area)
        path, self.wording = given.write(folder)
        return path

    def crs_of_tiles(self, folder: Path, tiles: list[str], feedback: QgsProcessingFeedback) -> str | None:
        """CRS the tiles declare, ``LOCAL`` where they declare none; None when the user cancelled."""
        found = self.run_engine(["inspect", *tiles, "--output", str(folder / "tiles.gpkg")], feedback, 0, 2)
        if found is None:
            return None
        if not found["crs"]:
            feedback.pushWarning(
                tr("The tiles declare no CRS: results are in a local frame. Choose the CRS of the results to change that.")
            )
        return found["crs"] or LOCAL

    def time(self, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
        """Time of the epoch, ISO 8601 in UTC."""
        given = self.parameterAsDateTime(parameters, TIME, context)
        if given.isValid():
            # a time without zone is stated in UTC, though QGIS and its widget take it for local: as text it has no offset then
            return epoch_time(given.toString(Qt.DateFormat.ISODateWithMs))
        return creation_date(Path(self.tiles[0])).strftime("%Y-%m-%dT%H:%M:%SZ")

    def point_files(
        self, folder: Path, parameters: dict[str, Any], context: QgsProcessingContext, crs: QgsCoordinateReferenceSystem
    ) -> dict[str, Path]:
        """CSV files of control, targets and check points as far as they are given."""
        files = {}
        for key, columns, defaults in FILE_COLUMNS:
            name = key.upper()
            if not self.has(name) or not parameters.get(name):
                continue
            source = self.parameterAsSource(parameters, name, context)
            if source is None:
                raise QgsProcessingException(self.invalidSourceError(parameters, name))
            # targets stand in the frame of the cloud: a change of CRS would be wrong for them
            frame = QgsCoordinateReferenceSystem() if name == TARGETS else crs
            files[key] = write_points(source, columns, folder / f"{key}.csv", frame, context, defaults)
        return files


def creation_date(path: Path) -> datetime:
    """Creation date in a LAS header (day of year and year at byte 90), or the file's own date where it is blank."""
    with path.open("rb") as stream:
        header = stream.read(94)
    if len(header) == 94 and header[:4] == b"LASF":
        day, year = struct.unpack("<HH", header[90:94])
        if 1 <= day <= 366 and 1980 < year < MAXYEAR:
            return datetime(year, 1, 1, tzinfo=UTC) + timedelta(days=day - 1)
    return datetime.fromtimestamp(path.stat().st_mtime, tz=UTC)


def write_layers(
    sources: Sequence[QgsProcessingFeatureSource | QgsVectorLayer], path: Path, layer: str, context: QgsProcessingContext
) -> Path:
    """Write sources of the same kind, one after the other, as one layer of a GeoPackage for the engine.

    Raises
    ------
    QgsProcessingException
        A field of the schema is missing, or the file cannot be written.
    """
    names = LAYERS[layer].names
    fields = QgsFields()
    for field in LAYERS[layer].fields:
        fields.append(QgsField(field.name, FIELD_TYPES[field.type]))
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName, options.layerName = "GPKG", layer
    first = sources[0]
    crs = first.crs() if isinstance(first, QgsVectorLayer) else first.sourceCrs()
    kind = wkb_type(LAYERS[layer].geometry)
    writer = QgsVectorFileWriter.create(str(path), fields, kind, crs, context.transformContext(), options)
    for source in sources:
        # results of earlier versions do not say when the next epoch was
        missing = [name for name in names if source.fields().lookupField(name) < 0 and name != "epoch_until"]
        if missing:
            raise QgsProcessingException(
                tr("{layer} has no field {fields}; it has {present}.").format(
                    layer=source.name() if isinstance(source, QgsVectorLayer) else source.sourceName(),
                    fields=few(missing),
                    present=few(source.fields().names()),
                )
            )
        for feature in source.getFeatures():
            row = QgsFeature(fields)
            row.setGeometry(feature.geometry())
            row.setAttributes([feature.attribute(name) if source.fields().lookupField(name) >= 0 else None for name in names])
            writer.addFeature(row)
    problem = writer.errorMessage()
    # the file is complete when the writer is gone
    del writer
    if problem:
        raise QgsProcessingException(problem)
    return path
