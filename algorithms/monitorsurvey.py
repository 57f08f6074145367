"""All steps at once: from tiles or survey.toml to the result GeoPackage."""

from __future__ import annotations

import shutil
from itertools import count
from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMatrix,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QStandardPaths

from ..core.common.output_locks import clear_lock
from ..core.review.point_index import kept_survey
from .base import Texts
from .support.inputs import (
    AREA,
    CRS,
    LOCAL,
    STABLE_AREAS,
    WORKERS,
    EpochInput,
    SurveyInput,
    add_area,
    add_crs,
    add_frame,
    add_stable_areas,
    add_unit,
    add_workers,
    crs_text,
    epoch_place,
    epoch_time,
    frame_value,
    ring_of,
    tile_paths,
    tiles_override,
    unit_values,
    write_points,
    write_polygons,
)
from .support.layers import DRAWING_ORDER, epoch_spans, load_on_completion, set_project_time
from .support.point_files import FILE_COLUMNS
from .support.translation import tr
from .survey_algorithm import SurveyAlgorithm, creation_date

SECONDS_OF_COPIES = 0.5
"""How long workers may outlive an engine that was killed."""


class MonitorSurvey(SurveyAlgorithm):
    """Algorithm ``tetratrack:monitorsurvey``."""

    ID = "monitorsurvey"
    GROUP = "monitoring"
    ICON = "tetratrack.svg"
    SURVEY, EPOCHS, BACKDROP, LOAD, OUTPUT = "SURVEY", "EPOCHS", "BACKDROP", "LOAD", "OUTPUT"
    SINKS = (("UNITS", "units"), ("FEATURE_POINTS", "feature_points"), ("DISPLACEMENTS", "displacements"))
    COLUMNS = 6
    target: Path | None = None
    """The result to be loaded, once it is there."""

    def texts(self) -> Texts:
        return Texts(
            tr("Monitor a survey"),
            tr(
                "All steps at once: registers every epoch to survey control, finds the tetrapods, fits four cones that share a centre, "
                "derives feature points and tests their displacements. Give a survey.toml, or the epochs and the unit."
            ),
            tr(
                "Units of which less than about 5 % is seen are not found. Without control the cloud's own frame is used, and the result "
                "says so."
            ),
            tr("tetrapod,armour unit,breakwater,displacement,monitoring,LAS,LAZ,deformation"),
        )

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        self.add(
            QgsProcessingParameterFile(
                self.SURVEY, tr("Survey file"), Qgis.ProcessingFileParameterBehavior.File, optional=True, fileFilter="survey.toml (*.toml)"
            ),
            tr("A survey.toml; if given, it states everything, and the fields for epochs, unit, CRS and area are not used."),
        )
        headers = [tr("Label"), tr("Time (UTC)"), tr("Tiles"), tr("Control points"), tr("Targets in the cloud"), tr("Check points")]
        epochs = QgsProcessingParameterMatrix(self.EPOCHS, tr("Epochs"), 1, False, headers, optional=True)
        # by name: Processing loads the widget where there is a window, and only there
        epochs.setMetadata({"widget_wrapper": {"class": f"{__package__.rpartition('.')[0]}.plugin.epoch_wrapper.EpochsWrapper"}})
        self.add(
            epochs,
            tr("One row per epoch: label, time such as 2025-03-14T02:30, folder or files of tiles (separated by ;), CSV files or layers."),
        )
        add_unit(self)
        add_crs(self)
        add_area(self)
        add_stable_areas(self)
        add_frame(self)
        add_workers(self)
        self.add(
            QgsProcessingParameterBoolean(self.BACKDROP, tr("Shaded relief of each epoch"), True),
            tr("Writes a top view of each epoch as GeoTIFF beside the result, as a backdrop."),
            advanced=True,
        )
        self.add(
            QgsProcessingParameterBoolean(self.LOAD, tr("Load the result"), True),
            tr("Adds all layers to the project as a group with their styles."),
        )
        self.add(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Result"), "GeoPackage (*.gpkg)", own_result()),
            tr("GeoPackage with units, feature points, displacements, residuals, epochs and reviews, in the survey's CRS, times in UTC."),
        )
        for name, layer in self.SINKS:
            self.add_layer_sink(name, layer, optional=True)
        self.addOutput(QgsProcessingOutputNumber("UNITS_FOUND", tr("Units found")))
        self.addOutput(QgsProcessingOutputNumber("UNITS_MOVED", tr("Units moved")))
        self.addOutput(QgsProcessingOutputNumber("CHECK_RMSE", tr("RMSE at check points (m)")))

    def checkParameterValues(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        if parameters.get(self.SURVEY):
            # the file states everything; what the engine finds wrong in it is said with its line
            return self.base_check(parameters, context)
        rows = parameters.get(self.EPOCHS) or []
        if not any(rows):
            return False, tr("Give a survey.toml, or at least one epoch with its tiles.")
        if len(rows) % self.COLUMNS:
            return False, tr("Every epoch needs six columns: label, time, tiles, control points, targets, check points.")
        for number, start in enumerate(range(0, len(rows), self.COLUMNS), start=1):
            label, time = ("" if value is None else str(value).strip() for value in rows[start : start + 2])
            try:
                epoch_time(time or "2000-01-01")
            except ValueError:
                place = epoch_place(label, number)
                problem = tr("{place}: {time} is no time; write it as 2025-03-14, 2025-03-14T02:30 (UTC) or 2025-03-14T11:30+09:00.")
                return False, problem.format(place=place, time=time)
        return super().checkParameterValues(parameters, context)

    def base_check(self, parameters: dict[str, Any], context: QgsProcessingContext) -> tuple[bool, str]:
        """The checks of Processing itself."""
        return super(SurveyAlgorithm, self).checkParameterValues(parameters, context)

    def prepareAlgorithm(self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> bool:
        self.rows = []
        self.overrides: list[str] = []
        if parameters.get(self.SURVEY):
            return True
        values = ["" if value is None else str(value).strip() for value in self.parameterAsMatrix(parameters, self.EPOCHS, context)]
        for start in range(0, len(values), self.COLUMNS):
            label, time, tiles, *tables = values[start : start + self.COLUMNS]
            where = epoch_place(label, start // self.COLUMNS + 1)
            paths = tile_paths([part.strip() for part in tiles.split(";")], context, where)
            self.overrides.append(tiles_override([part.strip() for part in tiles.split(";")], context))
            self.rows.append((label, time, paths, [self.table(text, context, where) for text in tables]))
        return True

    def table(self, text: str, context: QgsProcessingContext, where: str) -> QgsVectorLayer | None:
        """Point layer or CSV named in a cell."""
        if not text:
            return None
        project = context.project() or QgsProject.instance()
        named = project.mapLayersByName(text)
        layer = project.mapLayer(text) or (named[0] if named else None)
        if layer is None and not Path(text).is_file():
            raise QgsProcessingException(tr("{where}: there is no file or layer {path}.").format(where=where, path=text))
        found = layer.clone() if isinstance(layer, QgsVectorLayer) else QgsVectorLayer(text, Path(text).stem, "ogr")
        if not found.isValid():
            raise QgsProcessingException(tr("{where}: {path} cannot be read as a point layer or CSV file.").format(where=where, path=text))
        return found

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        target = Path(self.parameterAsFileOutput(parameters, self.OUTPUT, context))
        if not target.parent.is_dir():
            raise QgsProcessingException(tr("The folder {folder} does not exist.").format(folder=target.parent))
        with self.scratch() as scratch:
            folder = Path(scratch)
            given = self.parameterAsFile(parameters, self.SURVEY, context)
            survey = Path(given) if given else self.survey_of_rows(folder, parameters, context, feedback)
            if survey is None:
                return {}
            workers = str(self.parameterAsInt(parameters, WORKERS, context))
            last = 90 if self.parameterAsBoolean(parameters, self.BACKDROP, context) else 100
            # the engine itself writes the file whole or not at all, and keeps the reviews of an earlier result of that name
            found = self.run_engine(["run", str(survey), "--output", str(target), "--workers", workers], feedback, 0, last)
            if found is None:
                # an engine that did not heed was killed, and left it
                clear_lock(target.absolute(), SECONDS_OF_COPIES)
                return {}
            reliefs: list[tuple[str, str]] = []
            if last < 100:
                drawn = self.run_engine(["relief", str(survey), "--output", str(target.with_suffix("")) + "_relief"], feedback, last, 100)
                if drawn is None:
                    return {}
                reliefs = list(zip(drawn["epochs"], drawn["files"]))
            if not given:
                # points around units are read from the survey later, in the review
                kept = kept_survey(target).parent
                shutil.copytree(folder, kept, dirs_exist_ok=True, ignore=shutil.ignore_patterns("tiles.gpkg*"))
        outputs: dict[str, Any] = {}
        for name, layer in self.SINKS:
            identifier, _ = self.copy_to_sink(target, layer, parameters, name, context)
            if identifier is not None:
                outputs[name] = identifier
        if self.parameterAsBoolean(parameters, self.LOAD, context):
            self.load(target, reliefs, context)
        return outputs | {
            self.OUTPUT: str(target),
            "UNITS_FOUND": found["units"],
            "UNITS_MOVED": found["moved"],
            "CHECK_RMSE": found["check_rmse"],
        }

    def postProcessAlgorithm(self, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        # in the main thread, where the project may be changed
        if self.target is not None and context.project() is not None:
            set_project_time(context.project(), self.target)
        return {}

    def load(self, target: Path, reliefs: list[tuple[str, str]], context: QgsProcessingContext) -> None:
        """Have all layers with rows loaded into one group named after the result."""
        self.target = target
        for layer in DRAWING_ORDER:
            source = f"{target}|layername={layer}"
            opened = QgsVectorLayer(source, layer, "ogr")
            if opened.isValid() and opened.featureCount() > 0:
                load_on_completion(context, source, layer, self.OUTPUT, target.stem)
        spans = epoch_spans(target)
        # the latest relief lies on top of the earlier ones
        for label, relief in reversed(reliefs):
            load_on_completion(context, relief, tr("Relief {epoch}").format(epoch=label), self.OUTPUT, target.stem, spans.get(label))

    def survey_of_rows(
        self, folder: Path, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> Path | None:
        """Write survey.toml from the table of epochs."""
        crs = self.parameterAsCrs(parameters, CRS, context)
        text = crs_text(crs) or self.overrides[0] or self.crs_of_tiles(folder, self.rows[0][2], feedback)
        if text is None:
            return None
        frame = crs if crs.isValid() else QgsCoordinateReferenceSystem(text if text != LOCAL else "")
        epochs = []
        for number, (label, time, tiles, tables) in enumerate(self.rows):
            files, names = {}, {}
            place = epoch_place(label, number + 1)
            for (key, columns, defaults), table in zip(FILE_COLUMNS, tables):
                if table is not None:
                    own = QgsCoordinateReferenceSystem() if key == "targets" else frame
                    files[key] = write_points(table, columns, folder / f"{key}_{number}.csv", own, context, defaults)
                    names[key] = f"{place}, {table.name()}"
            stamp = epoch_time(time) if time else creation_date(Path(tiles[0])).strftime("%Y-%m-%dT%H:%M:%SZ")
            epochs.append(
                EpochInput(label or str(number + 1), stamp, tiles, files, place=place, tables=names, tiles_crs=self.overrides[number])
            )
        area = ring_of(self.parameterAsSource(parameters, AREA, context), frame, context)
        stable = self.parameterAsSource(parameters, STABLE_AREAS, context)
        areas = "" if stable is None else write_polygons(stable, folder / "stable_areas.gpkg", context).name
        unit = unit_values(self, parameters, context)
        choice = frame_value(self, parameters, context)
        given = SurveyInput(text, unit, epochs, undeclared_crs=crs_text(crs), area=area, stable_areas=areas, frame=choice)
        path, self.wording = given.write(folder)
        return path


def own_result() -> str:
    """A file for the result that stays: beside the project, or among the user's documents; a temporary one would be gone with QGIS."""
    home = QgsProject.instance().absolutePath() or QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
    if not home or not Path(home).is_dir():
        home = str(Path.home())
    names = (f"tetratrack result{'' if k == 1 else f' {k}'}.gpkg" for k in count(1))
    return str(next(path for name in names if not (path := Path(home) / name).exists()))
