"""What the dock shows while no result is open: a result to open, or a folder of tiles to make one from."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import (
    Qgis,
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.gui import QgsFileWidget, QgsMapCanvas, QgsProjectionSelectionWidget, QgsRubberBand
from qgis.PyQt.QtCore import Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import (
    QDoubleSpinBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)
from qgis.utils import iface

from ..algorithms.support.inputs import crs_text, write_points
from ..algorithms.support.point_files import FILE_COLUMNS
from ..algorithms.support.translation import tr
from ..core.review.point_index import kept_survey
from .engine_task import EngineTask
from .epoch_rows import EpochRow, rows_for_engine, rows_of_draft
from .epoch_table import EpochTable, epoch_colour, layer_file, point_cloud_layers

TYPING_MILLISECONDS = 800
"""Pause after which a folder that is being typed is taken as meant."""


class StartPage(QScrollArea):
    """The first page of the dock.

    ``open_wanted`` asks for the window that chooses a result; ``run_wanted`` carries survey.toml and result of a survey to be run.
    """

    open_wanted = pyqtSignal()
    run_wanted = pyqtSignal(str, str)

    def __init__(self, canvas: QgsMapCanvas, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.footprints = Footprints(canvas)
        self._tasks: list[EngineTask] = []
        self._name = ""
        self.button = QToolButton(self)
        self.button.setText(tr("Open result…"))
        self.button.setIcon(QgsApplication.getThemeIcon("/mActionFileOpen.svg"))
        self.button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.button.clicked.connect(lambda checked=False: self.open_wanted.emit())
        self.status = _wrapped()
        self.folder = QgsFileWidget(self)
        self.folder.setStorageMode(QgsFileWidget.StorageMode.GetDirectory)
        self.folder.setDialogTitle(tr("Folder of tiles"))
        # a path being typed names other folders on the way
        self._typed = QTimer(self)
        self._typed.setSingleShot(True)
        self._typed.setInterval(TYPING_MILLISECONDS)
        self._typed.timeout.connect(lambda: self._folder_chosen(self.folder.filePath()))
        self.folder.fileChanged.connect(lambda name: self._typed.start())
        self.layers = QPushButton(tr("Take the point cloud layers"), self)
        self.layers.setToolTip(tr("The files of the project's point cloud layers, in place of a folder"))
        self.layers.clicked.connect(lambda checked=False: self.look_at_layers())
        self.epochs = EpochTable(self)
        self.epochs.changed.connect(self._show_footprints)
        self.epochs.looked_away.connect(self._look_again)
        self.epochs.table.itemSelectionChanged.connect(self._show_footprints)
        self.findings = _wrapped()
        self.findings.setObjectName("start_findings")
        self.height = QDoubleSpinBox(self)
        self.height.setObjectName("start_height")
        self.height.setRange(0, 20)
        self.height.setDecimals(3)
        self.height.setSuffix(" m")
        self.height.setSpecialValueText(tr("estimated from the cloud"))
        self.crs = QgsProjectionSelectionWidget(self)
        self.crs.setOptionVisible(QgsProjectionSelectionWidget.CrsOption.CrsNotSet, True)
        self.crs.setNotSetText(tr("as the tiles declare"))
        self.crs.setCrs(QgsCoordinateReferenceSystem())
        self.output = QgsFileWidget(self)
        self.output.setStorageMode(QgsFileWidget.StorageMode.SaveFile)
        self.output.setFilter("GeoPackage (*.gpkg)")
        self.run = QPushButton(QgsApplication.getThemeIcon("/mActionStart.svg"), tr("Run"), self)
        self.run.setObjectName("start_run")
        self.run.clicked.connect(lambda checked=False: self.start())
        self._lay_out()
        self._show_more()

    def _lay_out(self) -> None:
        body = QWidget(self)
        page, first = QVBoxLayout(body), QHBoxLayout()
        review, survey = _wrapped(), _wrapped()
        review.setText(tr("Open the result.gpkg of a survey with two epochs or more to review its displacements."))
        survey.setText(tr("Or make one: choose the folder that holds the tiles of all epochs, look through the table, press Run."))
        first.addWidget(self.layers)
        first.addStretch(1)
        self.form = QWidget(body)
        form = QFormLayout(self.form)
        form.setContentsMargins(0, 0, 0, 0)
        form.addRow(tr("Height H of the unit"), self.height)
        form.addRow(tr("CRS of the results"), self.crs)
        form.addRow(tr("Result"), self.output)
        for part in (review, self.button):
            page.addWidget(part)
        page.addSpacing(12)
        page.addWidget(survey)
        page.addWidget(self.folder)
        page.addLayout(first)
        for part in (self.epochs, self.findings, self.form, self.run, self.status):
            page.addWidget(part)
        page.addStretch(1)
        self.setWidget(body)

    # looking at files

    def look_at_layers(self) -> None:
        """Take the files of the project's point cloud layers."""
        files = [layer_file(layer) for layer in point_cloud_layers()]
        if not files:
            self.say(tr("The project has no point cloud layer that lies in a file: choose a folder instead."), bad=True)
            return
        self._take(files)

    def _folder_chosen(self, name: str) -> None:
        if name and Path(name).is_dir():
            self._take([name])

    def _take(self, places: list[str]) -> None:
        for task in self._tasks:
            task.cancel()
        folder = Path(places[0])
        self.output.setFilePath(str((folder if folder.is_dir() else folder.parent) / "result.gpkg"))
        self._start(tr("Looking at the tiles"), ["init", *places, "--no-size", *self._crs()], self._looked)

    def _look_again(self) -> None:
        """Points, density and CRS of tiles that were changed in the table; rows without tiles wait."""
        rows = self.epochs.rows()
        if all(row.tiles for row in rows):
            self._with_rows(tr("Looking at the tiles"), rows, ["--no-size"], self._looked)

    def _looked(self, found: dict[str, Any]) -> None:
        draft = found["draft"]
        rows = rows_of_draft(draft)
        before = self.epochs.rows()
        if len(before) == len(rows):
            # what was corrected by hand stays
            rows = [replace(row, files={**row.files, **old.files}) if old.tiles == row.tiles else row for row, old in zip(rows, before)]
        self._name = draft["name"]
        self.epochs.show_rows(rows)
        self._show_findings(draft)
        open_map(rows)
        self._show_footprints()
        self._show_more()
        self.footprints.zoom()
        self.say("")

    def _show_findings(self, draft: dict[str, Any]) -> None:
        self.findings.setText("\n".join(f"• {text}" for text in (*draft["questions"], *draft["warnings"])))
        self.findings.setVisible(bool(self.findings.text()))

    def _show_footprints(self) -> None:
        self.footprints.show_rows(self.epochs.rows(), self.epochs.selected())

    def _show_more(self) -> None:
        there = bool(self.epochs.rows())
        for part in (self.epochs, self.form, self.run):
            part.setVisible(there)
        self.findings.setVisible(there and bool(self.findings.text()))

    # running

    def start(self) -> None:
        """Write the survey that the table states and have it run."""
        output = Path(self.output.filePath())
        if not self.output.filePath() or not output.parent.is_dir():
            self.say(tr("Choose where the result is to be written."), bad=True)
            return
        survey = kept_survey(output)
        try:
            survey.parent.mkdir(exist_ok=True)
            survey.unlink(missing_ok=True)
            rows = self.epochs.rows()
            rows = files_of_layers(rows, survey.parent, self.crs.crs() if self.crs.crs().isValid() else declared_crs(rows))
        except (OSError, QgsProcessingException) as error:
            self.say(str(error), bad=True)
            return
        options = ["--output", str(survey), *self._height()]
        self._with_rows(tr("Writing the survey"), rows, options, lambda found: self._written(found, output))

    def _written(self, found: dict[str, Any], output: Path) -> None:
        self._show_findings(found["draft"])
        if found["questions"]:
            self.say(tr("Answer first what is asked above."), bad=True)
            return
        sizes = [unit["height"] for unit in found["draft"]["units"]]
        self.say(tr("Units of {heights} m height.").format(heights=", ".join(f"{size:.3g}" for size in sizes)))
        self.run_wanted.emit(found["survey"], str(output))

    def _height(self) -> list[str]:
        return ["--height", repr(self.height.value())] if self.height.value() > 0 else []

    def _crs(self) -> list[str]:
        return ["--crs", crs_text(self.crs.crs())] if self.crs.crs().isValid() else []

    def _with_rows(self, title: str, rows: list[EpochRow], options: list[str], done: Callable[[dict[str, Any]], None]) -> None:
        with tempfile.NamedTemporaryFile("w", suffix=".json", prefix="tetratrack-", delete=False, encoding="utf-8") as file:
            json.dump(rows_for_engine(rows), file)
        name = ["--name", self._name] if self._name else []
        self._start(title, ["init", "--epochs", file.name, *name, *options, *self._crs()], done, Path(file.name))

    def _start(self, title: str, arguments: list[str], done: Callable[[dict[str, Any]], None], scratch: Path | None = None) -> None:
        def ended(outputs: dict[str, Any] | None, message: str) -> None:
            self._tasks.remove(task)
            if scratch is not None:
                scratch.unlink(missing_ok=True)
            self.run.setEnabled(True)
            if outputs is None and not task.isCanceled():
                self.say(message, bad=True)
            elif outputs is not None and not task.isCanceled():
                done(outputs)

        task = EngineTask(title, arguments, ended)
        # the last steps are told after the end
        task.progressChanged.connect(lambda percent: self.say(f"{title}… {percent:.0f} %") if task in self._tasks else None)
        self._tasks.append(task)
        self.run.setEnabled(False)
        QgsApplication.taskManager().addTask(task)
        self.say(tr("{title}…").format(title=title))

    def say(self, message: str, *, bad: bool = False) -> None:
        """What is being done, or why it was not."""
        self.status.setStyleSheet("color: #B03A2E;" if bad else "")
        self.status.setText(message)


def open_map(rows: list[EpochRow]) -> None:
    """An empty project takes the CRS of the tiles, as with a first layer; the page that greets a user makes room for the map."""
    project = QgsProject.instance()
    if project.mapLayers() or project.isDirty():
        return
    crs = declared_crs(rows)
    if iface is not None:
        iface.newProject()
    if crs.isValid():
        project.setCrs(crs)


class Footprints:
    """Extents of the epochs' tiles on the map."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self.canvas = canvas
        self.bands: list[QgsRubberBand] = []

    def show_rows(self, rows: list[EpochRow], selected: list[int]) -> None:
        """Draw every epoch in a colour of its own, the selected ones stronger."""
        self.clear()
        for place, row in enumerate(rows):
            boxes = self._boxes(row)
            if not boxes:
                continue
            colour = epoch_colour(place)
            band = QgsRubberBand(self.canvas, Qgis.GeometryType.Polygon)
            band.setStrokeColor(colour)
            band.setWidth(3 if place in selected else 1)
            fill = QColor(colour)
            fill.setAlpha(90 if place in selected else 25)
            band.setFillColor(fill)
            for box in boxes:
                band.addGeometry(QgsGeometry.fromRect(box), None)
            self.bands.append(band)

    def clear(self) -> None:
        """Take them off the map."""
        for band in self.bands:
            self.canvas.scene().removeItem(band)
        self.bands.clear()

    def zoom(self) -> None:
        """Show all of them."""
        extent = QgsRectangle()
        for band in self.bands:
            extent.combineExtentWith(band.asGeometry().boundingBox())
        if not extent.isEmpty():
            extent.scale(1.15)
            self.canvas.setExtent(extent)
            self.canvas.refresh()

    def _boxes(self, row: EpochRow) -> list[QgsRectangle]:
        crs = declared_crs([row])
        project = QgsProject.instance()
        transform = QgsCoordinateTransform(crs, self.canvas.mapSettings().destinationCrs(), project)
        boxes = [QgsRectangle(*extent) for extent in row.footprint]
        if not crs.isValid():
            return boxes
        try:
            return [transform.transformBoundingBox(box) for box in boxes]
        except QgsCsException:
            return []


def declared_crs(rows: list[EpochRow]) -> QgsCoordinateReferenceSystem:
    """CRS that most tiles declare, in which the results will be where none is chosen; invalid where none declares any."""
    declared = [row.crs.split(", ")[0] for row in rows if row.crs for _ in row.tiles]
    return QgsCoordinateReferenceSystem(max(sorted(set(declared)), key=declared.count, default=""))


def files_of_layers(rows: list[EpochRow], folder: Path, crs: QgsCoordinateReferenceSystem) -> list[EpochRow]:
    """Rows with layers written as tables into a folder, for the engine to read, in the CRS of the results.

    Raises
    ------
    QgsProcessingException
        A layer lacks a field.
    """
    context, project = QgsProcessingContext(), QgsProject.instance()
    out = []
    for place, row in enumerate(rows):
        files = dict(row.files)
        for key, columns, defaults in FILE_COLUMNS:
            layer = project.mapLayer(files.get(key, ""))
            if isinstance(layer, QgsVectorLayer):
                # targets stand in the frame of the cloud: a change of CRS would be wrong for them
                frame = QgsCoordinateReferenceSystem() if key == "targets" else crs
                files[key] = str(write_points(layer, columns, folder / f"{key}_{place}.csv", frame, context, defaults))
        out.append(replace(row, files=files))
    return out


def _wrapped() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    return label
