"""Inputs that several algorithms share: their parameters, their checks, and how they become the engine's survey.toml."""

from __future__ import annotations

import csv
import fnmatch
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsFeatureRequest,
    QgsGeometry,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDateTime,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsProject,
    QgsVectorFileWriter,
    QgsWkbTypes,
)

from ...core.common.errors import InputError
from ...core.common.virtual_clouds import tiles_of
from ..base import TetratrackAlgorithm
from .same_crs import crs_name
from .translation import tr
from .wording import Wording, few

TILES, CRS, EPOCH, TIME = "TILES", "CRS", "EPOCH", "TIME"
UNIT, HEIGHT, RADIUS, GRADIENT, LEG_LENGTH, OPENING, CALIBRATE = (
    "UNIT",
    "HEIGHT",
    "RADIUS",
    "GRADIENT",
    "LEG_LENGTH",
    "OPENING",
    "CALIBRATE",
)
AREA, STABLE_AREAS, CONTROL, TARGETS, CHECK, WORKERS = "AREA", "STABLE_AREAS", "CONTROL", "TARGETS", "CHECK", "WORKERS"
FRAME = "FRAME"
POINT_CLOUD_ENDINGS = (".las", ".laz")
SCAN_ENDINGS = (".e57", ".ply")
"""Read by way of a copy; in a folder they count where no tiles stand beside them."""
OPENINGS = ("tetrahedral", "paper")
FRAMES = ("auto", "rigid", "elastic")
"""Choices of ``frame`` in survey.toml, in the order in which they are offered; a test compares them with the engine's."""
UNIT_HINTS = tuple(f"tetrapod {mass} t" for mass in ("0.5", 1, 2, "3.2", 4, 5, "6.3", 8, 10, "12.5", 16, 20, 25, 32, 40, 50, 64, 80))
"""Catalogue names offered; any other mass may be typed. A test compares them with the engine's catalogue."""
LOCAL = "LOCAL"
OWN_AUTHORITIES = ("USER", "QGIS", "CUSTOM")
"""Under these QGIS numbers CRS that only itself knows, such as those of the user."""
CONTROL_COLUMNS = ("point_id", "easting", "northing", "height", "sd_e", "sd_n", "sd_h")
TARGET_COLUMNS = ("point_id", "x", "y", "z")
CHECK_COLUMNS = ("point_id", "unit_easting", "unit_northing", "unit_height", "easting", "northing", "height", "sd")


@dataclass
class EpochInput:
    """One epoch as survey.toml states it.

    Attributes
    ----------
    label
        Name of the epoch.
    time
        ISO 8601 in UTC.
    tiles
        Absolute paths.
    files
        CSV file by key of survey.toml, inside the folder the survey is written to.
    place
        What the user calls the epoch, for messages.
    tables
        What the user calls the table behind each of ``files``, by the same keys.
    tiles_crs
        CRS that the user set for the layers of the tiles in place of the one they declare; empty where there is none.
    """

    label: str
    time: str
    tiles: list[str]
    files: dict[str, Path] = field(default_factory=dict)
    place: str = ""
    tables: dict[str, str] = field(default_factory=dict)
    tiles_crs: str = ""


@dataclass
class SurveyInput:
    """Everything survey.toml states."""

    crs: str
    unit: dict[str, Any]
    epochs: list[EpochInput]
    undeclared_crs: str = ""
    area: list[list[float]] = field(default_factory=list)
    stable_areas: str = ""
    frame: str = FRAMES[0]

    def write(self, folder: Path) -> tuple[Path, Wording]:
        """Write survey.toml into a folder; its path, and the user's words for what stands in it.

        Files beside it are named without their folder, so that the folder can be moved.
        """
        lines = ["[survey]", f"name = {_toml('QGIS')}", f"crs = {_toml(self.crs)}"]
        sections = [(1, tr("CRS of the results"))]
        if self.stable_areas:
            lines.append(f"stable_areas = {_toml(self.stable_areas)}")
        if self.frame != FRAMES[0]:
            lines.append(f"frame = {_toml(self.frame)}")
        lines += ["", "[unit]"]
        sections.append((len(lines), tr("Type of unit")))
        lines += [f"{key} = {_toml(value)}" for key, value in self.unit.items()]
        if self.area:
            lines.append(f"area = {_toml(self.area)}")
        for epoch in self.epochs:
            lines += ["", "[[epoch]]", f"label = {_toml(epoch.label)}", f"time = {epoch.time}", f"tiles = {_toml(epoch.tiles)}"]
            sections.append((len(lines) - 3, epoch.place))
            if self.undeclared_crs:
                lines.append(f"undeclared_crs = {_toml(self.undeclared_crs)}")
            if epoch.tiles_crs:
                lines.append(f"tiles_crs = {_toml(epoch.tiles_crs)}")
            lines += [f"{key} = {_toml(path.name)}" for key, path in epoch.files.items()]
        path = folder / "survey.toml"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        tables = {str(folder / file.name): epoch.tables[key] for epoch in self.epochs for key, file in epoch.files.items()}
        return path, Wording(str(path), tuple(sections), tables)


def epoch_time(text: str) -> str:
    """A time as users write it, as survey.toml wants it (ISO 8601 in UTC).

    Date alone, date and time with ``T`` or a space between, with or without seconds, with ``Z`` or an offset such as ``+09:00``; without
    either it is UTC.

    Raises
    ------
    ValueError
        No date can be made out.
    """
    plain = re.sub(r"\s+(?=[+-]\d\d:?\d\d$)", "", text.strip())
    plain = re.sub(r"\s*[zZ]$", "+00:00", plain).replace("/", "-")
    moment = datetime.fromisoformat(plain)
    moment = moment.replace(tzinfo=UTC) if moment.tzinfo is None else moment.astimezone(UTC)
    return moment.isoformat(timespec="seconds" if moment.microsecond == 0 else "milliseconds").replace("+00:00", "Z")


def _toml(value: Any) -> str:
    """Text, number, boolean or nested list as TOML; JSON writes these the same, but for the delete character."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


class TilesParameter(QgsProcessingParameterMultipleLayers):
    """Point cloud layers, or files and folders that QGIS itself may be unable to open: a QGIS without PDAL reads no LAZ."""

    def __init__(self, name: str, label: str) -> None:
        super().__init__(name, label, Qgis.ProcessingSourceType.PointCloud)

    def createFileFilter(self) -> str:
        """What *Add File(s)* and *Add Directory* of the parameter's window take: QGIS without PDAL would offer COPC alone."""
        tiles = " ".join(f"*{ending} *{ending.upper()}" for ending in (*POINT_CLOUD_ENDINGS, *SCAN_ENDINGS))
        return ";;".join((tr("Point clouds ({endings})").format(endings=tiles), tr("Virtual point clouds (*.vpc)"), tr("All files (*.*)")))

    def valueAsPythonString(self, value: Any, context: QgsProcessingContext) -> str:
        """The files as the history writes them down: QGIS keeps those only that it can open itself."""
        names = _names(value)
        if names is None:
            return super().valueAsPythonString(value, context)
        return repr(names if len(names) != 1 else names[0])

    def valueAsStringList(self, value: Any, context: QgsProcessingContext) -> tuple[list[str], bool]:
        """The files as command lines of the history need them."""
        names = _names(value)
        return super().valueAsStringList(value, context) if names is None else (names, True)

    def valueAsString(self, value: Any, context: QgsProcessingContext) -> tuple[str, bool]:
        """The files in one text."""
        names = _names(value)
        return super().valueAsString(value, context) if names is None else (";".join(names), True)

    def clone(self) -> TilesParameter:
        copy = TilesParameter(self.name(), self.description())
        copy.setHelp(self.help())
        copy.setFlags(self.flags())
        return copy

    def checkValueIsAcceptable(self, value: Any, context: QgsProcessingContext | None = None) -> bool:
        """Anything that names something; what it names is looked up with :func:`tile_paths`."""
        items = [item for item in (value if isinstance(value, (list, tuple)) else [value]) if item]
        if not items:
            return bool(self.flags() & Qgis.ProcessingParameterFlag.Optional)
        return all(isinstance(item, (str, QgsMapLayer)) for item in items)


def _names(value: Any) -> list[str] | None:
    """Sources behind the value of a tiles parameter; None where it holds anything else, such as an expression."""
    items = value if isinstance(value, (list, tuple)) else [value]
    if not items or not all(isinstance(item, (str, QgsMapLayer)) and item for item in items):
        return None
    return [item.source() if isinstance(item, QgsMapLayer) else item for item in items]


def add_tiles(algorithm: TetratrackAlgorithm, *, name: str = TILES, label: str = "") -> None:
    """Point cloud of one epoch: files, a folder, a virtual point cloud or layers."""
    algorithm.add(
        TilesParameter(name, label or tr("Point cloud tiles")),
        tr(
            "LAS, LAZ, COPC, E57 or PLY files, a folder of them, a virtual point cloud (.vpc) or point cloud layers; coordinates in metres."
        ),
    )


def add_crs(algorithm: TetratrackAlgorithm) -> None:
    """CRS of the results, by default that of the tiles."""
    algorithm.add(
        QgsProcessingParameterCrs(CRS, tr("CRS of the results"), optional=True),
        tr("Projected CRS in metres; empty takes that of the tiles, and a local frame if they declare none."),
    )


def add_epoch(algorithm: TetratrackAlgorithm) -> None:
    """Label and time of an epoch."""
    algorithm.add(
        QgsProcessingParameterString(EPOCH, tr("Epoch"), "1"),
        tr("Label of this survey in all results, for example its date."),
    )
    algorithm.add(
        QgsProcessingParameterDateTime(TIME, tr("Time of the survey (UTC)"), optional=True),
        tr("Drives the temporal controller; empty takes the date of the first tile."),
    )


def epoch_place(label: str, number: int) -> str:
    """What a message calls an epoch given as a row: its label and the number of the row, from 1."""
    if not label:
        return tr("Epoch in row {row}").format(row=number)
    return tr("Epoch {label} (row {row})").format(label=label, row=number)


def add_unit(algorithm: TetratrackAlgorithm) -> None:
    """Type of unit from the catalogue or own numbers, and whether its shape is calibrated."""
    add_unit_type(algorithm)
    algorithm.add(
        QgsProcessingParameterBoolean(CALIBRATE, tr("Calibrate radius and taper"), False),
        tr("Estimates both from the best-seen units and holds them: moulds differ by centimetres from the standard proportions."),
    )


def add_unit_type(algorithm: TetratrackAlgorithm) -> None:
    """Type of unit from the catalogue, or own numbers."""
    unit = QgsProcessingParameterString(UNIT, tr("Type of unit"), UNIT_HINTS[7])
    unit.setMetadata({"widget_wrapper": {"value_hints": list(UNIT_HINTS)}})
    algorithm.add(unit, tr("Catalogue name with the mass in tonnes, such as tetrapod 8 t; or tetrapod with a height of your own."))
    algorithm.add(
        _length(HEIGHT, tr("Height H of the unit (m)")),
        tr("From the plane under three legs to the top of the fourth, in metres; overrides the catalogue."),
    )
    algorithm.add(
        _length(RADIUS, tr("Cone radius at the centre (m)")),
        tr("Radius of a leg's cone at the unit's centre, in metres; empty takes 0.264 H."),
        advanced=True,
    )
    algorithm.add(
        _length(GRADIENT, tr("Taper of the leg")),
        tr("Loss of radius per metre along the leg's axis; empty takes 0.176."),
        advanced=True,
    )
    algorithm.add(
        _length(LEG_LENGTH, tr("Leg length (m)")),
        tr("From the centre to the end disc, in metres; empty takes 0.644 H."),
        advanced=True,
    )
    algorithm.add(
        QgsProcessingParameterEnum(
            OPENING, tr("Angle between the legs"), [tr("tetrahedral (109.5°)"), tr("as in the paper (120°)")], False, 0
        ),
        tr("Built tetrapods are tetrahedral; 120° between leg 1 and the others repeats the published equations."),
        advanced=True,
    )


def _length(name: str, label: str) -> QgsProcessingParameterNumber:
    parameter = QgsProcessingParameterNumber(name, label, Qgis.ProcessingNumberParameterType.Double, None, True, 1e-6)
    parameter.setMetadata({"widget_wrapper": {"decimals": 5}})
    return parameter


def add_area(algorithm: TetratrackAlgorithm) -> None:
    """Area of interest."""
    algorithm.add(
        QgsProcessingParameterFeatureSource(AREA, tr("Area of interest"), [Qgis.ProcessingSourceType.VectorPolygon], optional=True),
        tr("Polygon inside which units are looked for; its outer ring is used. Empty means everywhere."),
    )


def add_stable_areas(algorithm: TetratrackAlgorithm) -> None:
    """Surfaces that tie epochs without control to another epoch."""
    algorithm.add(
        QgsProcessingParameterFeatureSource(STABLE_AREAS, tr("Stable areas"), [Qgis.ProcessingSourceType.VectorPolygon], optional=True),
        tr(
            "Polygons around surfaces that do not move, such as the crown wall: they tie epochs without control to the earliest with "
            "control, or to the first."
        ),
    )


def add_frame(algorithm: TetratrackAlgorithm) -> None:
    """Whether the clouds of epochs may be bent."""
    choices = [tr("the survey itself tells"), tr("rigid"), tr("elastic")]
    algorithm.add(
        QgsProcessingParameterEnum(FRAME, tr("Frames of the epochs"), choices, False, 0),
        tr(
            "Long flights bend by centimetres over tens to hundreds of metres. The survey itself tells by its units and targets whether an "
            "epoch's cloud is bent; rigid holds it stiff (short sites, one set-up), elastic lets it bend on any evidence."
        ),
        advanced=True,
    )


def frame_value(algorithm: TetratrackAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
    """Choice of ``frame`` as survey.toml writes it."""
    return FRAMES[algorithm.parameterAsEnum(parameters, FRAME, context)]


def add_workers(algorithm: TetratrackAlgorithm) -> None:
    """Number of worker processes."""
    algorithm.add(
        QgsProcessingParameterNumber(WORKERS, tr("Worker processes"), Qgis.ProcessingNumberParameterType.Integer, 1, False, 1, 256),
        tr("Blocks of the survey worked on at the same time; each takes about 1 GB of memory."),
        advanced=True,
    )


def add_control(algorithm: TetratrackAlgorithm, *, optional: bool = True) -> None:
    """Surveyed control points and the same targets in the cloud."""
    algorithm.add(
        _points(CONTROL, tr("Control points"), optional),
        tr("Surveyed targets: point layer or CSV with point_id, easting, northing, height, sd_e, sd_n, sd_h (m)."),
    )
    algorithm.add(
        _points(TARGETS, tr("Targets in the cloud"), optional),
        tr("The same targets as measured in this epoch's cloud: point layer or CSV with point_id, x, y, z (m)."),
    )


def add_check(algorithm: TetratrackAlgorithm, *, optional: bool = True) -> None:
    """Surveyed check points."""
    algorithm.add(
        _points(CHECK, tr("Check points"), optional),
        tr(
            "Surveyed joints of cones, for validation only: CSV or layer with point_id, unit_easting, unit_northing, unit_height and "
            "position (m)."
        ),
    )


def _points(name: str, label: str, optional: bool) -> QgsProcessingParameterFeatureSource:
    return QgsProcessingParameterFeatureSource(name, label, [Qgis.ProcessingSourceType.Vector], optional=optional)


def tile_paths(value: Any, context: QgsProcessingContext, where: str) -> list[str]:
    """Files named by the value of a tiles parameter; call in the main thread, it looks at the project.

    Raises
    ------
    QgsProcessingException
        Nothing given, or a path that does not exist.
    """
    found: list[str] = []
    for item in value if isinstance(value, list | tuple) else [value]:
        found += _files_of(item, context, where)
    if not found:
        raise QgsProcessingException(tr("{where}: no point cloud is given.").format(where=where))
    return list(dict.fromkeys(found))


def tiles_override(value: Any, context: QgsProcessingContext) -> str:
    """CRS that the user set for point cloud layers in place of what their files declare; empty where no layer has one.

    Raises
    ------
    QgsProcessingException
        It holds for one layer, and another has its own: one CRS is given to all tiles of an epoch.
    """
    layers = [
        item if isinstance(item, QgsMapLayer) else _project_layer(str(item or ""), context)
        for item in (value if isinstance(value, list | tuple) else [value])
    ]
    known = [layer for layer in layers if layer is not None and layer.dataProvider() is not None and layer.crs().isValid()]
    changed = next((layer for layer in known if layer.crs() != layer.dataProvider().crs()), None)
    if changed is None:
        return ""
    other = next((layer for layer in known if layer.crs() != changed.crs()), None)
    if other is not None:
        raise QgsProcessingException(
            tr("The layers {one} and {other} have different CRS, and that of {one} is set by hand. Set the same one for both.").format(
                one=changed.name(), other=other.name()
            )
        )
    return crs_text(changed.crs())


def tiles_in(folder: Path) -> list[str]:
    """Point clouds of a folder: its tiles, or scans where it has none."""
    for endings in (POINT_CLOUD_ENDINGS, SCAN_ENDINGS):
        inside = sorted(str(path) for path in folder.iterdir() if path.suffix.lower() in endings)
        if inside:
            return inside
    return []


def _files_of(item: Any, context: QgsProcessingContext, where: str) -> list[str]:
    layer = item if isinstance(item, QgsMapLayer) else _project_layer(str(item or ""), context)
    text = layer.source() if layer is not None else str(item or "")
    if not text:
        return []
    path = Path(text.split("|")[0])
    quoted = re.findall(r'"([^"]+)"', text) if layer is None and not path.exists() else []
    if quoted:
        return [file for name in quoted for file in _files_of(name, context, where)]
    if path.is_dir():
        inside = tiles_in(path)
        if not inside:
            raise QgsProcessingException(
                tr("{where}: the folder {path} holds no point cloud (LAS, LAZ, COPC, E57, PLY).").format(where=where, path=path)
            )
        return inside
    if path.suffix.lower() == ".vpc" and path.is_file():
        return _virtual_point_cloud(path, where)
    if any(character in path.name for character in "*?") and path.parent.is_dir():
        matches = re.compile(fnmatch.translate(path.name), re.IGNORECASE).match
        return sorted(str(p) for p in path.parent.iterdir() if matches(p.name))
    if not path.is_file():
        raise QgsProcessingException(tr("{where}: there is no file or layer {path}.").format(where=where, path=text))
    return [str(path)]


def _project_layer(text: str, context: QgsProcessingContext) -> QgsMapLayer | None:
    project = context.project() or QgsProject.instance()
    named = project.mapLayersByName(text)
    return project.mapLayer(text) or (named[0] if named else None)


def _virtual_point_cloud(path: Path, where: str) -> list[str]:
    try:
        return [str(tile.resolve()) for tile in tiles_of(path)]
    except InputError as error:
        raise QgsProcessingException(f"{where}: {error}") from error


def unit_values(algorithm: TetratrackAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> dict[str, Any]:
    """Section [unit] of survey.toml; steps that do not look at units state any."""
    if algorithm.parameterDefinition(UNIT) is None:
        return {"type": UNIT_HINTS[7]}
    values: dict[str, Any] = {"type": algorithm.parameterAsString(parameters, UNIT, context).strip()}
    for name, key in ((HEIGHT, "height"), (RADIUS, "radius"), (GRADIENT, "gradient"), (LEG_LENGTH, "leg_length")):
        if parameters.get(name) is not None:
            values[key] = algorithm.parameterAsDouble(parameters, name, context)
    values["opening"] = OPENINGS[algorithm.parameterAsEnum(parameters, OPENING, context)]
    if algorithm.parameterDefinition(CALIBRATE) is not None:
        values["calibrate"] = algorithm.parameterAsBoolean(parameters, CALIBRATE, context)
    return values


def unit_arguments(algorithm: TetratrackAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> list[str]:
    """The unit as options of a subcommand without survey.toml; option names are the keys of section [unit]."""
    arguments = []
    for key, value in unit_values(algorithm, parameters, context).items():
        option = "unit" if key == "type" else key.replace("_", "-")
        arguments += [f"--{option}", str(value)]
    return arguments


def check_unit(algorithm: TetratrackAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
    """Reason why the unit's numbers cannot go together, empty if they can."""
    name = algorithm.parameterAsString(parameters, UNIT, context).strip().lower()
    given = parameters.get(HEIGHT) is not None
    if name == "tetrapod" and not given:
        return tr("Give the height H of the unit, or choose a catalogue name with its mass, such as tetrapod 8 t.")
    if not name.startswith("tetrapod"):
        return tr("The type of unit must be tetrapod, or a catalogue name such as tetrapod 8 t.")
    if given and parameters.get(RADIUS) is not None:
        height = algorithm.parameterAsDouble(parameters, HEIGHT, context)
        if algorithm.parameterAsDouble(parameters, RADIUS, context) >= height / 2:
            return tr("The cone radius must be smaller than half the height of the unit.")
    return ""


def check_crs(algorithm: TetratrackAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
    """Reason why the CRS cannot be used, empty if it can."""
    crs = algorithm.parameterAsCrs(parameters, CRS, context)
    if crs.isValid() and crs.isGeographic():
        return tr("{crs} is geographic; choose a projected CRS in metres.").format(crs=crs_name(crs))
    return ""


def check_pair(parameters: dict[str, Any]) -> str:
    """Reason why control cannot be used, empty if it can."""
    if bool(parameters.get(CONTROL)) != bool(parameters.get(TARGETS)):
        return tr("Control points and targets in the cloud belong together: give both, or neither.")
    return ""


def crs_text(crs: QgsCoordinateReferenceSystem) -> str:
    """CRS as survey.toml names it."""
    if not crs.isValid():
        return ""
    authority = crs.authid().partition(":")[0].upper()
    return crs.toWkt(Qgis.CrsWktVariant.Preferred) if authority in ("", *OWN_AUTHORITIES) else crs.authid()


def ring_of(
    source: QgsProcessingFeatureSource | None, crs: QgsCoordinateReferenceSystem, context: QgsProcessingContext
) -> list[list[float]]:
    """Outer ring of the area of interest in the survey's CRS; empty for no area."""
    if source is None:
        return []
    request = QgsFeatureRequest()
    if crs.isValid():
        request.setDestinationCrs(crs, context.transformContext())
    geometries = [feature.geometry() for feature in source.getFeatures(request) if feature.hasGeometry()]
    if not geometries or any(geometry.type() != Qgis.GeometryType.Polygon for geometry in geometries):
        raise QgsProcessingException(tr("The area of interest holds no polygon."))
    joined = QgsGeometry.unaryUnion(geometries)
    if joined.isMultipart() and len(joined.asMultiPolygon()) > 1:
        raise QgsProcessingException(tr("The area of interest has several separate parts; give one polygon."))
    polygon = joined.asMultiPolygon()[0] if joined.isMultipart() else joined.asPolygon()
    return [[point.x(), point.y()] for point in polygon[0][:-1]]


def write_polygons(source: QgsProcessingFeatureSource, path: Path, context: QgsProcessingContext) -> Path:
    """Write a polygon layer as GeoPackage in its own CRS, for the engine to transform."""
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "GPKG"
    layer = source.materialize(QgsFeatureRequest())
    error, message, *_ = QgsVectorFileWriter.writeAsVectorFormatV3(layer, str(path), context.transformContext(), options)
    if error != QgsVectorFileWriter.WriterError.NoError:
        raise QgsProcessingException(tr("{layer} cannot be written: {reason}.").format(layer=source.sourceName(), reason=message))
    return path


def write_points(
    source: QgsProcessingFeatureSource,
    columns: Iterable[str],
    path: Path,
    crs: QgsCoordinateReferenceSystem,
    context: QgsProcessingContext,
    defaults: dict[str, str],
) -> Path:
    """Write a point layer or CSV table as the engine's CSV.

    Columns are taken by name. Where easting or northing is missing, both come from the geometry, in the survey's CRS, and so does a
    height that is missing. A text such as ``1.2x`` is passed on as it is, for the engine to name its line.

    Raises
    ------
    QgsProcessingException
        A field is missing, also a height where the geometry has none, or a place cannot be transformed.
    """
    names = [field.name() for field in source.fields()]
    lookup = {name.lower(): name for name in names}
    columns = list(columns)
    position = [c for c in ("easting", "northing", "height", "x", "y", "z") if c in columns]
    kind = source.wkbType()
    drawn = [] if kind == Qgis.WkbType.NoGeometry else position if QgsWkbTypes.hasZ(kind) else position[:2]
    plane = position[:2] if not all(c in lookup for c in position[:2]) else []
    from_geometry = [c for c in drawn if c in plane or c not in lookup]
    missing = [c for c in columns if c not in lookup and c not in defaults and c not in drawn]
    if missing:
        raise QgsProcessingException(
            tr("{layer} has no field {fields}; it has {present}.").format(
                layer=source.sourceName(), fields=few(missing), present=few(names)
            )
        )
    transform = QgsCoordinateTransform()
    if from_geometry and crs.isValid() and source.sourceCrs().isValid() and source.sourceCrs() != crs:
        transform = QgsCoordinateTransform(source.sourceCrs(), crs, context.transformContext())
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(columns)
        for feature in source.getFeatures():
            row = {c: feature.attribute(lookup[c]) if c in lookup else defaults.get(c, "") for c in columns}
            if from_geometry:
                row |= {c: value for c, value in zip(position, _place(source, feature, transform)) if c in from_geometry}
            writer.writerow([_cell(row[c]) for c in columns])
    return path


def _place(source: QgsProcessingFeatureSource, feature: QgsFeature, transform: QgsCoordinateTransform) -> tuple[float, float, float]:
    """First vertex of a feature."""
    geometry = feature.geometry()
    try:
        geometry.transform(transform)
    except QgsCsException as error:
        raise QgsProcessingException(
            tr("{layer} cannot be transformed to the CRS of the results: {reason}.").format(layer=source.sourceName(), reason=error)
        ) from error
    vertex = geometry.vertexAt(0)
    return vertex.x(), vertex.y(), vertex.z()


def _cell(value: Any) -> str:
    return repr(value) if isinstance(value, float) else "" if value is None else str(value)
