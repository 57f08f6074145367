"""The review dock in a real window: open, filter, select, decide, undo, correct, reopen."""

from __future__ import annotations

import json
import multiprocessing
import stat
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas, QgsMapToolPan
from qgis.PyQt.QtCore import QItemSelectionModel, QPointF, Qt
from qgis.PyQt.QtGui import QAction, QKeyEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QMainWindow, QToolButton
from synthetic_result import SRS, SyntheticUnit, features_of, write_points, write_result
from tetratrack.core.result_tables import EpochPair
from tetratrack.core.reviews import decide, read_history, read_reviews
from tetratrack.core.unit_edits import placeholders, read_edits, read_picks
from tetratrack.plugin.review_dock import ReviewDock
from tetratrack.plugin.review_store import COLUMNS

pytestmark = pytest.mark.qgis

PAIR = EpochPair("2023-04-09", "2024-04-09")


@pytest.fixture
def result(tmp_path: Path) -> tuple[Path, list[SyntheticUnit]]:
    path = tmp_path / "north breakwater's result.gpkg"
    units = write_result(path, 60)
    write_points(path, units)
    return path, units


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
    assert dock.open(result[0]), dock.status.text()
    yield dock
    dock.close()
    window.close()
    window.deleteLater()
    QApplication.processEvents()


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
    dock.filters.threshold.setValue(5.0)
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
    assert dock.open(result[0])
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
    dock._take_in()
    assert dock.store.review(target).reviewer == "Ben"
    assert "another reviewer" in dock.status.text()


def test_no_name_no_decision(dock: ReviewDock) -> None:
    dock.store.select([shown(dock)[0]])
    dock.decisions.reviewer.setText(" ")
    click_button(dock, "accepted")
    assert "no name" in dock.status.text()
    assert read_reviews(dock.store.path) == {}


def test_read_only_file_is_shown_and_says_so(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    path = result[0]
    path.chmod(stat.S_IRUSR | stat.S_IRGRP)
    assert dock.open(path)
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
    assert f"{moved.d_3d:.3f} m" in text
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
    assert np.hypot(*(picked[0] - dock.tabs.plan.scene.middle)[:2]) < 12 / dock.tabs.plan._pixels_per_metre()
    assert len(read_picks(dock.store.path, unit.unit_id)) == 1


def test_map_click_puts_a_placeholder(dock: ReviewDock) -> None:
    row = next(row for row in dock.store.rows if row.place is not None)
    dock.corrections.start_picking("placeholder", 1)
    dock.canvas.mapTool().clicked.emit(QgsPointXY(row.place[0], row.place[1]))
    (name, place), *rest = placeholders(dock.store.path, PAIR.epoch_to)
    assert name == "P001"
    assert not rest
    np.testing.assert_allclose(place[:2], row.place[:2], atol=0.1)


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
    dock.filters.threshold.setValue(5.0)
    dock.filters.text.setText("0001")
    dock.filters.undecided.setChecked(True)
    dock.canvas.setExtent(dock.map.units.extent().buffered(-6))
    dock.set_area("map")
    assert dock.open(result[0])
    assert len(shown(dock)) == len(dock.store.rows)
    assert (dock.filters.threshold.value(), dock.filters.text.text(), dock.filters.undecided.isChecked()) == (0, "", False)
    assert dock.filters.area.text() == "Everywhere"


def test_opening_another_file_ends_picking(dock: ReviewDock, result: tuple[Path, list[SyntheticUnit]]) -> None:
    before = QgsMapToolPan(dock.canvas)
    dock.canvas.setMapTool(before)
    dock.corrections.start_picking("placeholder", 0)
    assert dock.canvas.mapTool() is not before
    assert dock.open(result[0])
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
