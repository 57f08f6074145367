"""The review dock in a real window: open, filter, select, decide, undo, correct, reopen."""

from __future__ import annotations

import gzip
import json
import multiprocessing
import os
import shutil
import sqlite3
import stat
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeature,
    QgsLayoutExporter,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.gui import QgsMapCanvas, QgsMapToolPan
from qgis.PyQt.QtCore import QItemSelectionModel, QLocale, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QAction, QKeyEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QLabel, QMainWindow, QMessageBox, QToolButton
from synthetic_result import LEGS, SRS, SyntheticUnit, features_of, run_again, write_points, write_result
from tetratrack.algorithms.support.layers import STYLES
from tetratrack.core.model.outline import rotation_of_quaternion
from tetratrack.core.results.geopackage_reader import EpochPair
from tetratrack.core.review.corrections import delete_unit, last_edit_of, placeholders, read_edits, read_picks, set_pose
from tetratrack.core.review.decisions import decide, read_history, read_reviews
from tetratrack.core.review.point_index import index_folder, kept_survey
from tetratrack.core.review.pose_consequences import NewPose
from tetratrack.plugin.review_dock import ReviewDock
from tetratrack.plugin.review_store import COLUMNS
from tetratrack.plugin.review_text import datum_label

pytestmark = pytest.mark.qgis

PAIR = EpochPair("2023-04-09", "2024-04-09")


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[SyntheticUnit]]:
    """A result with its points, of which every test gets a copy."""
    path = tmp_path_factory.mktemp("drawn") / "north breakwater's result.gpkg"
    units = write_result(path, 60)
    write_points(path, units)
    return path, units


@pytest.fixture
def result(tmp_path: Path, drawn: tuple[Path, list[SyntheticUnit]]) -> tuple[Path, list[SyntheticUnit]]:
    original, units = drawn
    shutil.copytree(original.parent, tmp_path, dirs_exist_ok=True)
    return tmp_path / original.name, units


@pytest.fixture
def dock(qgis_app: object, result: tuple[Path, list[SyntheticUnit]]) -> Iterator[ReviewDock]:
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem(f"EPSG:{SRS}"))
    window.setCentralWidget(canvas)
    dock = ReviewDock(canvas, QgsProject.instance(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.resize(1366, 768)
    window.show()
    dock.decisions.reviewer.setText("Anna")
    assert reopen(dock, result[0]), dock.status.text()
    yield dock
    dock.close()
    window.close()
    window.deleteLater()
    QApplication.processEvents()


def reopen(dock: ReviewDock, path: Path) -> bool:
    """Open a result, and compare its first epochs, of which these tests know what is what."""
    opened = dock.open(path)
    if opened:
        dock.store.set_pair(PAIR)
    return opened


def keep_picture(picture: Path) -> None:
    """For eyes, where the environment names a folder (TETRATRACK_PICTURES)."""
    if os.environ.get("TETRATRACK_PICTURES"):
        shutil.copy(picture, os.environ["TETRATRACK_PICTURES"])


def press(dock: ReviewDock, key: Qt.Key) -> None:
    QTest.keyClick(dock.table, key)


def shown(dock: ReviewDock) -> list[str]:
    return [dock.model.index(k, 0).data() for k in range(dock.model.rowCount())]


def click_button(dock: ReviewDock, name: str) -> None:
    QTest.mouseClick(dock.findChild(QToolButton, f"review_{name}"), Qt.MouseButton.LeftButton)


def test_opens_with_every_unit_largest_displacement_first(dock: ReviewDock) -> None:
    lengths = [row.d_3d for k in range(len(dock.store.order)) if (row := dock.store.shown(k)).d_3d is not None]
    assert len(shown(dock)) == len(dock.store.rows) > 50
    assert lengths == sorted(lengths, reverse=True)
    # units without a displacement come last and show a dash, not a zero
    without = [row for row in dock.store.rows if row.d_3d is None]
    assert len(lengths) + len(without) == dock.model.rowCount()


def test_filters_by_class_threshold_area_text_and_decision(dock: ReviewDock) -> None:
    dock.filters.threshold.setValue(0.05)
    rows = {row.unit_id: row for row in dock.store.rows}
    assert set(shown(dock)) == {u for u, r in rows.items() if (r.d_3d or 0) >= 0.05 or r.kind in ("lost", "new", "relocated")}
    dock.filters.threshold.setValue(0.0)
    dock.filters.kinds.setCheckedItems([dock.filters.kinds.itemText(1)])
    assert set(shown(dock)) == {u for u, r in rows.items() if r.kind == "moved"}
    dock.filters.kinds.deselectAllOptions()
    dock.filters.text.setText("0001")
    assert shown(dock)
    assert all("0001" in unit for unit in shown(dock))
    dock.filters.text.clear()
    middle = np.mean([r.place[:2] for r in rows.values() if r.place is not None], axis=0)
    dock.canvas.setExtent(dock.map.units.extent().buffered(-6))
    box = dock.canvas.extent()
    dock.set_area("map")
    inside = {u for u, r in rows.items() if r.place is not None and box.contains(QgsPointXY(r.place[0], r.place[1]))}
    assert set(shown(dock)) == inside
    assert 0 < len(inside) < len(rows)
    assert box.contains(QgsPointXY(*middle))
    dock.set_area("everywhere")
    first = shown(dock)[0]
    dock.store.select([first])
    press(dock, Qt.Key.Key_A)
    assert first in shown(dock)
    dock.filters.undecided.setChecked(True)
    assert first not in shown(dock)


def test_selection_is_in_step_between_table_map_and_plots(dock: ReviewDock) -> None:
    target = shown(dock)[4]
    index = dock.model.index(4, 0)
    dock.table.selectionModel().select(index, QItemSelectionModel.SelectionFlag.ClearAndSelect | QItemSelectionModel.SelectionFlag.Rows)
    assert dock.store.selected == (target,)
    assert [f["unit_id"] for f in dock.map.units.selectedFeatures()] == [target]
    assert dock.tabs.plan.scene.shapes[0] is not None
    np.testing.assert_allclose(dock.tabs.plan.scene.shapes[0].centre, dock.store.details(target).shapes[PAIR.epoch_from].centre)
    # and from the map to the table
    other = shown(dock)[9]
    fid = next(f.id() for f in dock.map.units.getFeatures() if f["unit_id"] == other)
    dock.map.units.selectByIds([fid])
    assert dock.store.selected == (other,)
    assert [i.data() for i in dock.table.selectionModel().selectedRows()] == [other]
    np.testing.assert_allclose(dock.tabs.section.scene.shapes[1].centre, dock.store.details(other).shapes[PAIR.epoch_to].centre)


def test_keyboard_moves_and_decides(dock: ReviewDock) -> None:
    dock.step(1)
    first, second, third = shown(dock)[:3]
    assert dock.store.current == first
    press(dock, Qt.Key.Key_Down)
    assert dock.store.current == second
    press(dock, Qt.Key.Key_R)
    press(dock, Qt.Key.Key_Up)
    assert dock.store.current == first
    press(dock, Qt.Key.Key_N)
    assert dock.store.current == third, "N leaves out what is decided"
    reviews = read_reviews(dock.store.path)
    assert {unit: r.decision for (unit, _), r in reviews.items()} == {second: "rejected"}


def test_rejected_unit_leaves_map_and_statistics_visibly(dock: ReviewDock) -> None:
    before = dock.store.statistics()
    target = shown(dock)[0]
    largest = dock.store.row(target).d_3d
    dock.store.select([target])
    click_button(dock, "rejected")
    after = dock.store.statistics()
    assert (after.units, after.rejected) == (before.units - 1, 1)
    assert after.largest < largest
    assert target not in {f["unit_id"] for f in dock.map.units.getFeatures()}
    assert target not in {f["unit_id"] for f in dock.map.displacements.getFeatures()}
    assert {f["unit_id"] for f in dock.map.rejected.getFeatures()} == {target}
    assert "1 rejected" in dock._counts.text()
    font = dock.model.index(0, 0).data(Qt.ItemDataRole.FontRole)
    assert font.strikeOut()


def test_decision_survives_reopening_and_undo_takes_it_back(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    target = shown(dock)[2]
    dock.store.select([target])
    dock.decisions.comment.setText("toe, <b>check</b> & photo")
    click_button(dock, "inspect")
    assert dock.decisions.comment.text() == ""
    assert reopen(dock, result[0])
    review = dock.store.review(target)
    assert (review.decision, review.reviewer, review.comment) == ("inspect", "Anna", "toe, <b>check</b> & photo")
    row = dock.store.place_of(target)
    assert "inspect" in dock.model.index(row, COLUMNS.index("decision")).data()
    dock.store.select([target])
    dock.tabs.setCurrentIndex(3)
    assert "toe, <b>check</b> & photo" in dock.tabs.history.toPlainText()
    click_button(dock, "undo")
    assert dock.store.review(target) is None
    assert [e.action for e in read_history(result[0], target)] == ["decide", "undo"]


def test_second_reviewer_confirms_but_nobody_confirms_himself(dock: ReviewDock) -> None:
    target = shown(dock)[1]
    dock.store.select([target])
    click_button(dock, "accepted")
    click_button(dock, "confirm")
    assert "second reviewer" in dock.status.text()
    dock.decisions.reviewer.setText("Ben")
    click_button(dock, "confirm")
    review = dock.store.review(target)
    assert (review.reviewer, review.confirmed_by) == ("Anna", "Ben")
    assert dock.model.index(dock.store.place_of(target), COLUMNS.index("reviewer")).data() == "Anna ✓ Ben"


def test_decisions_of_others_are_taken_in(dock: ReviewDock) -> None:
    target = shown(dock)[3]
    decide(dock.store.path, [target], PAIR, "accepted", comment="", reviewer="Ben")
    dock.take_in()
    assert dock.store.review(target).reviewer == "Ben"
    assert "another reviewer" in dock.status.text()


def test_what_a_run_replaced_is_shown(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    target = shown(dock)[3]
    dock.store.select([target])
    run_again(result[0], "UPDATE displacements SET de = de + 5, d_3d = d_3d + 5 WHERE unit_id = ?", target)
    dock.take_in()
    assert "A run replaced the result" in dock.status.text()
    assert shown(dock)[0] == target, "it has moved farthest now"
    arrows = {f["unit_id"]: f["d_3d"] for f in dock.map.displacements.getFeatures()}
    assert 5 < arrows[target] == pytest.approx(dock.store.row(target).d_3d)
    assert (dock.store.selected, dock.store.pair) == ((target,), PAIR)
    assert dock.comparison.pair.currentData() == PAIR
    assert [f["unit_id"] for f in dock.map.units.selectedFeatures()] == [target]


def test_no_name_no_decision(dock: ReviewDock) -> None:
    dock.store.select([shown(dock)[0]])
    dock.decisions.reviewer.setText(" ")
    click_button(dock, "accepted")
    assert dock.status.text().startswith("Enter your name")
    assert read_reviews(dock.store.path) == {}


def test_read_only_file_is_shown_and_says_so(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    path = result[0]
    path.chmod(stat.S_IRUSR | stat.S_IRGRP)
    assert reopen(dock, path)
    assert "read-only" in dock.status.text()
    dock.store.select([shown(dock)[0]])
    click_button(dock, "accepted")
    assert "read-only" in dock.status.text()
    assert read_reviews(path) == {}
    assert dock.findChildren(QAction, "correction")
    assert not any(action.isEnabled() for action in dock.findChildren(QAction, "correction"))
    path.chmod(stat.S_IRUSR | stat.S_IWUSR)


def test_unreadable_file_is_refused_with_a_reason(dock: ReviewDock, tmp_path: Path) -> None:
    other = tmp_path / "notes.gpkg"
    other.write_text("no database")
    assert not dock.open(other)
    assert "cannot be read as a GeoPackage" in dock.status.text()


def test_the_latest_epochs_are_compared_first_and_the_list_says_so(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    assert dock.open(result[0])
    assert dock.store.pair == EpochPair("2024-04-09", "2025-04-09")
    assert dock.comparison.pair.currentText() == str(dock.store.pair)


def test_filters_act_on_the_map_where_that_is_wanted(dock: ReviewDock) -> None:
    dock.filters.text.setText("0001")
    everything = {f["unit_id"] for f in dock.map.units.getFeatures()}
    assert len(everything) > len(shown(dock)) > 0
    dock.filters.on_map.setChecked(True)
    assert {f["unit_id"] for f in dock.map.units.getFeatures()} <= set(shown(dock))
    dock.filters.text.clear()
    assert {f["unit_id"] for f in dock.map.units.getFeatures()} == everything
    dock.filters.on_map.setChecked(False)


def test_points_are_read_from_the_survey_kept_beside_the_result(
    dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]], fake_engine: Callable[[str], Path], tmp_path: Path
) -> None:
    told = tmp_path / "arguments.json"
    fake_engine(f"""
        open({str(told)!r}, "w").write(json.dumps(arguments))
        say(event="result", outputs={{}})
    """)
    assert not dock.tabs.read_points.isVisible(), "they are there"
    shutil.rmtree(index_folder(result[0]))
    assert reopen(dock, result[0])
    dock.store.select([shown(dock)[0]])
    assert dock.tabs.read_points.isVisible()
    survey = kept_survey(result[0])
    survey.parent.mkdir()
    survey.write_text("")
    QTest.mouseClick(dock.tabs.read_points, Qt.MouseButton.LeftButton)
    until = time.monotonic() + 20
    while "Points read" not in dock.status.text() and time.monotonic() < until:
        QApplication.processEvents()
    assert json.loads(told.read_text())[-4:-1] == ["unit-points", str(survey), str(result[0])]


def test_pair_and_datum_change_rows_and_map(dock: ReviewDock) -> None:
    moved = next(row.unit_id for row in dock.store.rows if row.kind == "moved")
    length = dock.store.row(moved).d_3d
    dock.comparison.pair.setCurrentIndex(2)
    dock.comparison.pair.activated.emit(2)
    assert dock.store.pair == EpochPair("2023-04-09", "2025-04-09")
    assert dock.store.row(moved).d_3d > 1.5 * length
    dock.comparison.datum.setCurrentIndex(1)
    dock.comparison.datum.activated.emit(1)
    assert dock.store.datum == "control"
    lines = {f["unit_id"]: f for layer in (dock.map.displacements, dock.map.other) for f in layer.getFeatures()}
    assert lines[moved]["datum"] == "control"
    assert lines[moved]["d_3d"] == pytest.approx(dock.store.row(moved).d_3d)


@pytest.mark.parametrize("datum", ["stable", "control"])
def test_table_arrow_and_views_are_of_one_datum_and_name_it(dock: ReviewDock, datum: str) -> None:
    dock.store.set_datum(datum)
    root = dock.project.layerTreeRoot()
    shown_arrows = [layer for layer in (dock.map.displacements, dock.map.other) if root.findLayer(layer.id()).isVisible()]
    assert len(shown_arrows) == 1
    assert datum_label(datum) in shown_arrows[0].name()
    arrows = {f["unit_id"]: f for f in shown_arrows[0].getFeatures()}
    for row in [row for row in dock.store.rows if row.vector is not None][:10]:
        dock.store.select([row.unit_id])
        scene = dock.tabs.plan.scene
        np.testing.assert_allclose(scene.shapes[1].centre - scene.shapes[0].centre, row.vector, atol=1e-9)
        assert scene.datum == datum_label(datum)
        assert arrows[row.unit_id]["datum"] == datum
        assert arrows[row.unit_id]["de"] == pytest.approx(row.vector[0])


def test_a_click_on_the_later_epoch_means_its_place_in_the_control_frame(dock: ReviewDock) -> None:
    row = next(row for row in dock.store.rows if row.kind == "moved")
    dock.store.select([row.unit_id])
    dock.corrections.start_picking("pick", 1)
    shift = dock.tabs.plan.scene.shift
    picked: list[np.ndarray] = []
    dock.tabs.picked.connect(picked.append)
    dock.tabs.plan.picked.emit(row.place + shift)
    np.testing.assert_allclose(picked[0], row.place)


def test_layers_of_the_result_already_in_the_map_are_hidden_meanwhile(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    dock.close()
    before = {}
    for name in ("units", "displacements", "displacements_other", "gaps"):
        layer = QgsVectorLayer(f"{result[0]}|layername={name}", name, "ogr")
        dock.project.addMapLayer(layer)
        before[name] = dock.project.layerTreeRoot().findLayer(layer.id())
    before["units"].setItemVisibilityChecked(False)
    dock.show()
    assert reopen(dock, result[0])
    assert [name for name, node in before.items() if node.itemVisibilityChecked()] == []
    dock.close()
    assert [name for name, node in before.items() if node.itemVisibilityChecked()] == ["displacements", "displacements_other", "gaps"]
    dock.project.clear()


def test_views_series_and_numbers_show_the_unit(dock: ReviewDock) -> None:
    moved = next(row for row in dock.store.rows if row.kind == "moved")
    dock.store.select([moved.unit_id])
    scene = dock.tabs.plan.scene
    assert all(len(points) > 1000 for points in scene.points)
    assert np.hypot(*(scene.points[0] - scene.middle)[:, :2].T).max() < 1.5 * scene.half_size
    dock.tabs.setCurrentIndex(1)
    assert [p.epoch for p in dock.tabs.series.series["centre"]] == ["2023-04-09", "2024-04-09", "2025-04-09"]
    assert dock.tabs.series.limit == pytest.approx(moved.detection_limit)
    dock.tabs.setCurrentIndex(2)
    text = dock.tabs.numbers.toPlainText()
    assert f"{moved.d_3d:.3f} ± {moved.sd_3d:.3f} m" in text
    azimuth = round(np.degrees(np.arctan2(moved.vector[0], moved.vector[1]))) % 360
    assert f"{moved.d_horizontal:.3f} m, towards {azimuth}° from grid north" in text
    assert f"{dock.store.pair}, datum:" in text
    assert "H" in text
    assert "Dn" in text
    checked = dock.store.details("U00001").checks
    assert checked
    dock.store.select(["U00001"])
    assert "Check points" in dock.tabs.numbers.toPlainText()


def test_three_clicks_in_the_view_pin_the_pose(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    unit = next(u for u in result[1] if u.fate == "stable")
    dock.store.select([unit.unit_id])
    dock.corrections.start_picking("pin", 1)
    truth = features_of(unit, 1)
    for name in (1, 2, 4):
        dock.corrections.add_pick(truth[name])
    np.testing.assert_allclose(dock.store.details(unit.unit_id).shapes[PAIR.epoch_to].centre, truth[0], atol=1e-6)
    assert sorted(row["feature"] for row in read_picks(dock.store.path, unit.unit_id)) == ["f123", "f124", "f234"]
    assert [edit.kind for edit in read_edits(dock.store.path)] == ["pose"]
    dock.corrections.undo()
    assert "Taken back" in dock.status.text()


@pytest.mark.parametrize(("kind", "clicks"), [("pin", 3), ("refit", 1), ("pick", 1)])
def test_a_unit_deselected_while_picking_is_asked_for(
    dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]], kind: str, clicks: int
) -> None:
    unit = next(u for u in result[1] if u.fate == "stable")
    dock.store.select([unit.unit_id])
    dock.corrections.start_picking(kind, 1)
    dock.store.select([])
    for place in features_of(unit, 1)[1 : 1 + clicks]:
        dock.corrections.add_pick(place)
    assert dock.status.text() == "Select a unit first."
    assert read_edits(dock.store.path) == []


def test_click_in_the_plan_picks_the_point_under_the_cursor(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    unit = next(u for u in result[1] if u.fate == "stable")
    dock.store.select([unit.unit_id])
    dock.corrections.start_picking("pick", 0)
    QApplication.processEvents()
    picked: list[np.ndarray] = []
    dock.tabs.plan.picked.connect(picked.append)
    dock.tabs.plan._pressed = None
    QTest.mouseClick(
        dock.tabs.plan,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
        QPointF(dock.tabs.plan.width() / 2, dock.tabs.plan.height() / 2).toPoint(),
    )
    assert len(picked) == 1
    assert np.hypot(*(picked[0] - dock.tabs.plan.scene.middle)[:2]) < 12 / dock.tabs.plan.pixels_per_metre()
    assert len(read_picks(dock.store.path, unit.unit_id)) == 1


@pytest.mark.parametrize("where", ["map", "dock"])
def test_escape_ends_picking_wherever_the_focus_is_and_says_so(dock: ReviewDock, where: str) -> None:
    dock.store.select([shown(dock)[0]])
    dock.corrections.start_picking("pin", 1)
    assert "Escape" in dock.status.text()
    focused = dock.canvas.viewport() if where == "map" else dock.tabs.plan
    focused.setFocus()
    QTest.keyClick(focused, Qt.Key.Key_Escape)
    QApplication.processEvents()
    assert dock.status.text() == "Ended: nothing was stored."
    assert dock.tabs.plan.picking_epoch is None
    # what is picked now is no correction, and Escape means nothing any more
    dock.corrections.add_pick(np.zeros(3))
    dock.status.say("something else")
    QTest.keyClick(focused, Qt.Key.Key_Escape)
    assert dock.status.text() == "something else"
    assert read_edits(dock.store.path) == []


def test_a_pin_and_its_picks_are_taken_back_as_one(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    unit = next(u for u in result[1] if u.fate == "stable")
    dock.store.select([unit.unit_id])
    dock.corrections.start_picking("pin", 1)
    for place in features_of(unit, 1)[1:4]:
        dock.corrections.add_pick(place)
    assert len(read_picks(dock.store.path, unit.unit_id)) == 3
    dock.corrections.undo()
    assert read_picks(dock.store.path, unit.unit_id) == []
    assert last_edit_of(dock.store.path, "Anna") is None
    # a pick beside the fit can be taken back as well
    dock.corrections.start_picking("pick", 1)
    dock.corrections.add_pick(features_of(unit, 1)[1])
    dock.corrections.undo()
    assert dock.status.text() == f"Taken back: points picked {unit.unit_id}."
    assert read_picks(dock.store.path, unit.unit_id) == []


def test_all_units_means_their_bodies_where_they_lie_now(dock: ReviewDock) -> None:
    dock.zoom_to_all()
    assert dock.canvas.extent().contains(dock.map.outlines.extent())
    assert dock.canvas.extent().contains(dock.map.units.extent())


def test_an_area_without_polygons_hides_and_shows_nothing(dock: ReviewDock) -> None:
    layer = QgsVectorLayer(f"Polygon?crs=EPSG:{SRS}", "areas", "memory")
    feature = QgsFeature()
    layer.dataProvider().addFeatures([feature])
    dock.canvas.setCurrentLayer(layer)
    everything = shown(dock)
    dock.set_area("polygon")
    assert dock.status.text() == "The active layer holds no polygon."
    assert (shown(dock), dock.filters.area.text()) == (everything, "Everywhere")


def test_map_click_puts_a_placeholder(dock: ReviewDock) -> None:
    row = next(row for row in dock.store.rows if row.place is not None)
    dock.corrections.start_picking("placeholder", 1)
    dock.canvas.mapTool().clicked.emit(QgsPointXY(row.place[0], row.place[1]))
    (name, place), *rest = placeholders(dock.store.path, PAIR.epoch_to)
    assert name == "P001"
    assert not rest
    np.testing.assert_allclose(place[:2], row.place[:2], atol=0.1)


def visible_layer(dock: ReviewDock, title: str) -> QgsVectorLayer:
    root = dock.project.layerTreeRoot()
    (layer,) = (layer for layer in dock.project.mapLayers().values() if layer.name() == title)
    assert root.findLayer(layer.id()).isVisible()
    return layer


def test_placeholders_picks_and_gaps_are_layers_of_the_map(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    row = next(row for row in dock.store.rows if row.kind == "stable")
    dock.corrections.start_picking("placeholder", 1)
    dock.canvas.mapTool().clicked.emit(QgsPointXY(row.place[0] + 1, row.place[1]))
    (placed,) = visible_layer(dock, "Placeholders and corrections").getFeatures()
    assert (placed["kind"], placed["unit_id"]) == ("placeholder", "P001")
    dock.store.select([row.unit_id])
    dock.corrections.start_picking("pick", 1)
    dock.corrections.add_pick(features_of(next(u for u in result[1] if u.unit_id == row.unit_id), 1)[1])
    (pick,) = visible_layer(dock, "Points picked by hand").getFeatures()
    assert pick["unit_id"] == row.unit_id
    assert {f["epoch"] for f in visible_layer(dock, "Gaps").getFeatures()} <= {PAIR.epoch_to}
    assert dock.store.selected == (row.unit_id,)


def screen_place(dock: ReviewDock, e: float, n: float) -> QPoint:
    place = dock.canvas.getCoordinateTransform().transform(QgsPointXY(e, n))
    return QPoint(round(place.x()), round(place.y()))


def test_a_click_picks_the_arrow_anywhere_along_it_whatever_layer_is_active(dock: ReviewDock) -> None:
    row = max((row for row in dock.store.rows if row.kind == "moved"), key=lambda row: row.d_horizontal)
    dock.canvas.setExtent(QgsRectangle.fromCenterAndSize(QgsPointXY(*row.place[:2]), 14, 14))
    dock.canvas.setCurrentLayer(None)
    direction = row.vector[:2] / np.hypot(*row.vector[:2])
    on_paper = min(0.2 * np.hypot(*row.vector[:2]), 0.03) * dock.canvas.scale()
    viewport = dock.canvas.viewport()
    for share in (0.1, 0.5, 0.95):
        dock.store.select([])
        e, n = row.place[:2] + share * on_paper * direction
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, screen_place(dock, e, n))
        assert dock.store.selected == (row.unit_id,), share
    before = dock.canvas.extent()
    other = next(r for r in dock.store.rows if r.kind == "stable" and r.place is not None)
    dock.follow.setChecked(False)
    dock.canvas.setExtent(QgsRectangle.fromCenterAndSize(QgsPointXY(*other.place[:2]), 14, 14))
    assert dock.canvas.extent() != before
    place = screen_place(dock, *other.place[:2])
    QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier, place)
    assert set(dock.store.selected) == {row.unit_id, other.unit_id}


def test_another_tool_ends_picking_units_and_the_button_brings_it_back(dock: ReviewDock) -> None:
    pick = dock.canvas.mapTool()
    assert dock.pick.isChecked()
    hand = QgsMapToolPan(dock.canvas)
    dock.canvas.setMapTool(hand)
    assert not dock.pick.isChecked()
    dock.pick.trigger()
    assert dock.canvas.mapTool() is pick
    dock.corrections.start_picking("placeholder", 1)
    assert dock.pick.isChecked()
    dock.corrections.end_picking()
    assert dock.canvas.mapTool() is pick


def test_lengths_follow_the_unit_of_the_project(dock: ReviewDock) -> None:
    moved = next(row for row in dock.store.rows if row.kind == "moved")
    place = dock.store.place_of(moved.unit_id)
    assert dock.filters.threshold.suffix() == " m"
    dock.filters.threshold.setValue(0.05)
    dock.project.setDistanceUnits(Qgis.DistanceUnit.Centimeters)
    try:
        place = dock.store.place_of(moved.unit_id)
        assert (dock.filters.threshold.suffix(), dock.filters.threshold.value()) == (" cm", 5.0)
        headings = [dock.model.headerData(place, Qt.Orientation.Horizontal) for place in range(len(COLUMNS))]
        assert [text for text in headings if "cm" in text] == ["Displ. (cm)", "Horiz. (cm)", "Vert. (cm)"]
        assert dock.model.index(place, COLUMNS.index("d_3d")).data() == f"{100 * moved.d_3d:.2f}"
        labels = [rule.label() for rule in dock.map.displacements.renderer().rootRule().descendants()]
        assert any("5.00 cm" in label for label in labels)
        # what is on paper stays in millimetres
        assert not any("mm" in label.replace("10 mm", "").replace("30 mm", "") for label in labels)
        feature = next(f for f in dock.map.outlines.getFeatures() if f["unit_id"] == moved.unit_id)
        context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(dock.map.outlines))
        context.setFeature(feature)
        text = QgsExpression(dock.map.outlines.labeling().settings().fieldName).evaluate(context)
        assert text.endswith(" cm")
    finally:
        dock.project.setDistanceUnits(Qgis.DistanceUnit.Meters)


def test_click_fits_the_unit_again_with_the_engine(dock: ReviewDock, fake_engine: Callable[[str], Path], tmp_path: Path) -> None:
    told = tmp_path / "arguments.json"
    fake_engine(f"""
        open({str(told)!r}, "w").write(json.dumps(arguments))
        say(event="result", outputs={{}})
    """)
    row = next(row for row in dock.store.rows if row.kind == "stable")
    dock.store.select([row.unit_id])
    dock.corrections.start_picking("refit", 1)
    dock.tabs.section.picked.emit(row.place)
    until = time.monotonic() + 20
    while "was fitted again" not in dock.status.text() and time.monotonic() < until:
        QApplication.processEvents()
    assert dock.status.text() == f"{row.unit_id} was fitted again."
    arguments = json.loads(told.read_text())
    place = ",".join(f"{value:.3f}" for value in row.place)
    expected = ["refit", str(dock.store.path), "--unit", row.unit_id, "--epoch", PAIR.epoch_to, "--near", place, "--editor", "Anna"]
    assert arguments[-len(expected) - 1 : -1] == expected


def test_a_correction_keeps_the_selection(dock: ReviewDock) -> None:
    unit = shown(dock)[3]
    dock.store.select([unit])
    dock.corrections.reload()
    QTest.qWait(50)
    assert dock.store.selected == (unit,)
    assert dock.table.currentIndex().row() == dock.store.place_of(unit)


def test_another_file_is_shown_whole(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    dock.filters.threshold.setValue(0.05)
    dock.filters.text.setText("0001")
    dock.filters.undecided.setChecked(True)
    dock.canvas.setExtent(dock.map.units.extent().buffered(-6))
    dock.set_area("map")
    assert reopen(dock, result[0])
    assert len(shown(dock)) == len(dock.store.rows)
    assert (dock.filters.threshold.value(), dock.filters.text.text(), dock.filters.undecided.isChecked()) == (0, "", False)
    assert dock.filters.area.text() == "Everywhere"


def test_opening_another_file_ends_picking(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    before = QgsMapToolPan(dock.canvas)
    dock.canvas.setMapTool(before)
    dock.corrections.start_picking("placeholder", 0)
    assert dock.canvas.mapTool() is not before
    assert reopen(dock, result[0])
    assert dock.canvas.mapTool() is before
    assert dock.tabs.plan.picking_epoch is None
    dock.tabs.plan.picked.emit(np.zeros(3))
    assert placeholders(dock.store.path, PAIR.epoch_from) == []


def test_split_merge_and_delete_from_the_menu(dock: ReviewDock) -> None:
    unit = next(row.unit_id for row in dock.store.rows if row.kind == "stable")
    dock.store.select([unit])
    dock.corrections.split()
    assert dock.store.row(f"{unit}b").kind == "new"
    dock.store.select([unit, f"{unit}b"])
    dock.corrections.merge()
    assert dock.store.row(f"{unit}b") is None
    assert dock.store.row(unit).d_3d is not None
    dock.store.select([unit])
    dock.corrections.delete()
    assert dock.store.row(unit) is None
    dock.corrections.undo()
    assert dock.store.row(unit) is not None


def test_a_page_to_print_holds_what_a_reader_needs(dock: ReviewDock, tmp_path: Path) -> None:
    dock.zoom_to_all()
    layout = dock.print_map()
    assert layout in dock.project.layoutManager().printLayouts()
    assert str(dock.store.path.stem) in layout.itemById("title").text()
    assert datum_label(dock.store.datum) in layout.itemById("subtitle").text()
    assert "at most 30 mm long" in layout.itemById("note").text()
    assert layout.itemById("map").extent().contains(dock.canvas.extent())
    assert layout.itemById("scale_bar").linkedMap() is layout.itemById("map")
    assert Path(layout.itemById("north").picturePath()).is_file()
    legend = [node.name() for node in layout.itemById("legend").model().rootGroup().findLayers()]
    assert "Outlines of the units" in legend
    picture = tmp_path / "page.png"
    settings = QgsLayoutExporter.ImageExportSettings()
    settings.dpi = 100
    assert QgsLayoutExporter(layout).exportToImage(str(picture), settings) == QgsLayoutExporter.ExportResult.Success
    second = dock.print_map()
    assert second.name() != layout.name()
    before = QLocale()
    try:
        QLocale.setDefault(QLocale(QLocale.Language.French, QLocale.Country.France))
        dock.canvas.zoomScale(20_000)
        page = dock.print_map()
        assert f"1 : {QLocale().toString(round(page.itemById('map').scale()))}" in page.itemById("subtitle").text()
        assert "," not in page.itemById("subtitle").text().partition("1 : ")[2]
    finally:
        QLocale.setDefault(before)
    keep_picture(picture)


def test_alarm_list_leaves_rejected_units_out(dock: ReviewDock, tmp_path: Path) -> None:
    worst = shown(dock)[0]
    dock.store.select([worst])
    press(dock, Qt.Key.Key_R)
    for name in ("alarms.csv", "alarms.geojson"):
        dock.export_alarms(tmp_path / name, 0.10)
        text = (tmp_path / name).read_text(encoding="utf-8")
        expected = [r for r in dock.store.rows if r.unit_id != worst and ((r.d_3d or 0) > 0.10 or r.kind in ("lost", "relocated"))]
        assert expected
        assert all(r.unit_id in text for r in expected)
        assert worst not in text


def test_views_paint_for_units_with_one_pose_or_none(dock: ReviewDock) -> None:
    kinds = {row.kind: row.unit_id for row in dock.store.rows}
    dock.comparison.pair.setCurrentIndex(1)
    dock.comparison.pair.activated.emit(1)
    kinds |= {row.kind: row.unit_id for row in dock.store.rows}
    assert {"lost", "unseen", "new"} & kinds.keys()
    for unit in kinds.values():
        dock.store.select([unit])
        for tab in range(4):
            dock.tabs.setCurrentIndex(tab)
            assert not dock.grab().isNull()


def test_closing_takes_the_layers_out_of_the_project(dock: ReviewDock) -> None:
    project = QgsProject.instance()
    ids = [layer.id() for layer in dock.map.layers]
    assert all(project.mapLayer(layer_id) is not None for layer_id in ids)
    dock.close()
    assert all(project.mapLayer(layer_id) is None for layer_id in ids)


def _write_many(path: str, who: str, start: object) -> None:
    start.wait()
    for k in range(40):
        decide(Path(path), [f"U{k + 1:05d}"], PAIR, "accepted", comment=who, reviewer=who)


def test_two_processes_writing_at_once_lose_nothing(dock: ReviewDock) -> None:
    """Three writers on one file: two processes, and this dock, which has the file open on the map."""
    context = multiprocessing.get_context("fork")
    start = context.Event()
    writers = [context.Process(target=_write_many, args=(str(dock.store.path), who, start)) for who in ("Ben", "Cleo")]
    for writer in writers:
        writer.start()
    start.set()
    for unit in [f"U{k + 1:05d}" for k in range(40)]:
        dock.store.select([unit])
        dock.decide("inspect")
        told = dock.status.text()
        assert told.startswith(f"{unit}: ") or dock.store.row(unit) is None, told
    for writer in writers:
        writer.join(60)
        assert writer.exitcode == 0
    events = read_history(dock.store.path)
    for who, decision in (("Anna", "inspect"), ("Ben", "accepted"), ("Cleo", "accepted")):
        mine = [event for event in events if event.reviewer == who and event.decision == decision]
        expected = [f"U{k + 1:05d}" for k in range(40)]
        if who == "Anna":
            expected = [unit for unit in expected if dock.store.row(unit) is not None]
        assert [event.unit_id for event in mine] == expected
    last = {event.unit_id: event for event in events}
    for (unit, _), review in read_reviews(dock.store.path).items():
        assert (review.decision, review.reviewer) == (last[unit].decision, last[unit].reviewer)


def test_key_events_of_other_keys_stay_with_the_table(dock: ReviewDock) -> None:
    event = QKeyEvent(QKeyEvent.Type.KeyPress, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    dock.table.keyPressEvent(event)
    assert len(dock.store.selected) == dock.model.rowCount(), "Ctrl+A selects all"
    assert read_reviews(dock.store.path) == {}


def test_the_dock_needs_no_numeric_library_beyond_numpy(repository: Path) -> None:
    """QGIS's Python must not load a second PROJ or GDAL, and may lack SciPy and Matplotlib."""
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); import conftest; import tetratrack.plugin.review_dock; "
        "print([m for m in ('scipy', 'matplotlib', 'geopandas', 'pyogrio', 'open3d', 'pyproj', 'numba') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code, str(repository / "tests")], capture_output=True, text=True, check=True)
    assert done.stdout.strip().splitlines()[-1] == "[]"


def review_groups(project: QgsProject) -> list[str]:
    return [group.name() for group in project.layerTreeRoot().findGroups(True) if group.name().startswith("Displacement review")]


@pytest.mark.parametrize("removal", ["project", "group", "layer"])
def test_layers_may_leave_while_a_result_is_open(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]], removal: str) -> None:
    unit = shown(dock)[0]
    dock.store.select([unit])
    project = dock.project
    if removal == "project":
        project.clear()
    elif removal == "group":
        (group,) = (g for g in project.layerTreeRoot().findGroups() if g.name() in review_groups(project))
        project.removeMapLayers([node.layerId() for node in group.findLayers()])
        project.layerTreeRoot().removeChildNode(group)
    else:
        project.removeMapLayer(dock.map.displacements.id())
    assert dock.store is None
    assert "open it again" in dock.status.text()
    for command in ("accepted", "confirm", "undo", "zoom", "next", "previous"):
        dock.run_command(command)
    dock.zoom_to_all()
    QApplication.processEvents()
    assert review_groups(project) == []
    assert reopen(dock, result[0])
    assert len(review_groups(project)) == 1
    dock.store.select([unit])
    press(dock, Qt.Key.Key_A)
    assert dock.store.review(unit).decision == "accepted"


def test_a_saved_project_does_not_double_the_group(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]], tmp_path: Path) -> None:
    saved = tmp_path / "with the dock open.qgz"
    assert dock.project.write(str(saved))
    assert dock.project.read(str(saved))
    QApplication.processEvents()
    assert len(review_groups(dock.project)) == 1, "what was saved"
    assert reopen(dock, result[0])
    assert len(review_groups(dock.project)) == 1
    assert len(dock.project.mapLayers()) == len(dock.map.layers)


@pytest.fixture
def second_dock(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> Iterator[ReviewDock]:
    """Another window on the same file."""
    window = QMainWindow()
    canvas = QgsMapCanvas(window)
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem(f"EPSG:{SRS}"))
    window.setCentralWidget(canvas)
    second = ReviewDock(canvas, QgsProject(), window)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, second)
    window.show()
    second.decisions.reviewer.setText("Ben")
    assert reopen(second, result[0])
    yield second
    second.close()
    window.close()
    window.deleteLater()


def state(dock: ReviewDock) -> dict[str, tuple[object, ...]]:
    rows = {row.unit_id: row for row in dock.store.rows}
    reviews = {unit: dock.store.review(unit) for unit in rows}
    return {u: (row.kind, row.d_3d and round(row.d_3d, 6), reviews[u] and reviews[u].decision) for u, row in rows.items()}


def test_two_windows_one_deciding_one_correcting(dock: ReviewDock, second_dock: ReviewDock) -> None:
    """40 acts each; nothing is lost, and both windows show the same within five seconds."""
    found = [row.unit_id for row in dock.store.rows if row.kind == "stable"][:20]
    for k in range(40):
        dock.store.select([found[k % 20]])
        dock.decide(("accepted", "inspect", "rejected")[k % 3])
        if k % 2:
            second_dock.corrections.undo()
        else:
            unit = found[(7 * k) % 20]
            shape = second_dock.store.details(unit).shapes[PAIR.epoch_to]
            pose = NewPose(
                centre=shape.centre + np.array([0.01, 0, 0]),
                rotation=shape.rotation,
                radius=shape.radius,
                gradient=shape.gradient,
                height=2.3,
                sd=np.full(3, 0.004),
                sd_rotation_deg=0.2,
            )
            set_pose(second_dock.store.path, unit, PAIR.epoch_to, pose, editor="Ben")
            second_dock.corrections.reload()
    second_dock.store.select([found[0]])
    second_dock.corrections.delete()
    until = time.monotonic() + 5
    while time.monotonic() < until and (found[0] in shown(dock) or state(dock) != state(second_dock)):
        QTest.qWait(50)
    assert state(dock) == state(second_dock)
    assert found[0] not in shown(dock)
    assert [event.action for event in read_history(dock.store.path)].count("decide") == 40
    edits = read_edits(dock.store.path)
    assert len(edits) == 21
    assert [edit.undone for edit in edits] == [True] * 20 + [False]


def test_a_unit_deleted_elsewhere_is_neither_accepted_nor_taken_back_here(dock: ReviewDock) -> None:
    target = shown(dock)[3]
    dock.store.select([target])
    delete_unit(dock.store.path, target, editor="Ben")
    click_button(dock, "accepted")
    assert "not in the result any more" in dock.status.text()
    dock.corrections.undo()
    assert "no correction of yours" in dock.status.text()
    dock.take_in()
    assert "Corrections of another reviewer" in dock.status.text()
    assert target not in shown(dock)


@pytest.mark.parametrize(("answer", "kept"), [(QMessageBox.StandardButton.No, 0), (QMessageBox.StandardButton.Yes, 1)])
def test_picks_that_do_not_fit_are_asked_about(
    dock: ReviewDock,
    result: tuple[Path, list[SyntheticUnit]],
    monkeypatch: pytest.MonkeyPatch,
    answer: QMessageBox.StandardButton,
    kept: int,
) -> None:
    asked: list[str] = []

    def question(parent: object, title: str, text: str, *rest: object) -> QMessageBox.StandardButton:
        asked.append(text)
        return answer

    monkeypatch.setattr(QMessageBox, "question", question)
    unit = next(u for u in result[1] if u.fate == "stable")
    dock.store.select([unit.unit_id])
    dock.corrections.start_picking("pin", 1)
    truth = features_of(unit, 1)
    # the middle one of the three picked far outside
    away = truth[2] - (truth[1] + truth[4]) / 2
    for place in (truth[1], truth[2] + 0.7 * away, truth[4]):
        dock.corrections.add_pick(place)
    assert len(asked) == 1
    assert unit.unit_id in asked[0]
    assert len(read_edits(dock.store.path)) == kept
    if kept:
        row = next(r for r in dock.store.details(unit.unit_id).rows.values() if r["epoch"] == PAIR.epoch_to)
        assert row["sd_e"] > 0.05, "what does not fit is not stated as sure"


def test_a_result_of_the_first_release_is_reviewed(dock: ReviewDock, tmp_path: Path, repository: Path) -> None:
    old = tmp_path / "first release.gpkg"
    old.write_bytes(gzip.decompress((repository / "tests" / "data" / "first_release" / "result.gpkg.gz").read_bytes()))
    assert dock.open(old), dock.status.text()
    assert shown(dock)[0] == "U0002", "the unit that moved comes first"
    dock.store.select(("U0002",))
    for page in range(dock.tabs.count()):
        dock.tabs.setCurrentIndex(page)
        dock.grab()
    dock.decide("accepted")
    assert {unit for unit, _ in read_reviews(old)} == {"U0002"}


def test_broken_legs_are_counted_sorted_and_told_apart(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    """Of one unit two legs, one of which an earlier epoch alone shows, with the end of a third not seen."""
    stable = [row.unit_id for row in dock.store.rows if row.kind == "stable" and row.d_3d < 0.05]
    with closing(sqlite3.connect(result[0])) as connection, connection:
        connection.execute("UPDATE units SET leg1 = 'whole', leg1_probability = 0.001, leg2 = 'whole', leg3 = 'unseen', leg4 = 'whole'")
        for epoch, state in ((PAIR.epoch_from, "broken"), (PAIR.epoch_to, "unseen")):
            connection.execute(
                "UPDATE units SET leg2 = ?, leg2_missing = 0.42, leg2_probability = 0.97, leg4 = 'broken', leg4_missing = 0.811, "
                "leg4_probability = 0.62 WHERE unit_id = ? AND epoch = ?",
                (state, stable[3], epoch),
            )
    assert reopen(dock, result[0])
    assert "1 with a broken leg" in dock.findChild(QLabel, "review_counts").text().replace("\u00a0", " ")
    dock.filters.threshold.setValue(5.0)
    assert stable[3] in shown(dock)
    dock.filters.threshold.setValue(0.0)
    dock.store.sort("broken_legs", True)
    assert shown(dock)[0] == stable[3]
    assert [dock.model.index(k, COLUMNS.index("broken_legs")).data() for k in (0, 1)] == ["2, 4", "–"]
    dock.store.select([stable[3]])
    dock.tabs.setCurrentIndex(2)
    lines = dock.tabs.numbers.toPlainText().splitlines()
    table = lines[lines.index("Legs") + 1 :]
    assert [table[k : k + 4] for k in range(5, 25, 5)] == [
        ["1", "whole", "–", "< 1 %"],
        ["2", "broken", "0.420", "97 %"],
        ["3", "not seen", "–", "–"],
        ["4", "broken", "0.811", "62 %"],
    ]
    assert lines[lines.index("Ends not seen, of legs") + 1] == "3"


def test_the_map_shows_what_is_missing_of_a_leg_and_its_tip_says_it(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    with closing(sqlite3.connect(result[0])) as connection, connection:
        connection.execute("UPDATE units SET leg1 = 'whole', leg2 = 'broken', leg2_missing = 0.4, leg2_probability = 0.9, leg3 = 'unseen'")
    layer = QgsVectorLayer(f"{result[0]}|layername=units", "units")
    layer.loadNamedStyle(str(STYLES / "units.qml"))
    feature = next(feature for feature in layer.getFeatures() if feature["qx"] is not None and feature.hasGeometry())
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    tip = QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context)
    assert "leg 2 broken, 0.400 m missing (90 %)<br>end of leg 3 not seen" in tip
    context.setFields(layer.fields())
    (rule,) = [rule for rule in layer.renderer().rootRule().children() if rule.label() == "missing end of a broken leg"]
    drawn = QgsExpression(rule.symbol().symbolLayer(0).properties()["geometryModifier"])
    drawn.prepare(context)
    line = drawn.evaluate(context)
    assert not drawn.hasEvalError(), drawn.evalErrorString()
    body = rotation_of_quaternion([feature[name] for name in ("qx", "qy", "qz", "qw")]) @ LEGS[1]
    assert line.length() == pytest.approx(0.4 * np.hypot(*body[:2]), rel=1e-3)
