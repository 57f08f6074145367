"""What dialogs hand to the engine: times, CRS and tables of points."""

from __future__ import annotations

import csv
import subprocess
from collections.abc import Iterator
from datetime import UTC
from datetime import datetime as moment
from pathlib import Path
from typing import Any

import pytest
from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsPoint,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QDateTime, Qt
from tetratrack.algorithms.newsurvey import NewSurvey
from tetratrack.algorithms.segmenttetrapods import SegmentTetrapods
from tetratrack.algorithms.support.engine import find_engine
from tetratrack.algorithms.support.inputs import CONTROL_COLUMNS, crs_text, ring_of, write_points
from tetratrack.plugin.epoch_rows import EpochRow
from tetratrack.plugin.start_page import declared_crs, files_of_layers

SITE_GRID = "+proj=tmerc +lat_0=35 +lon_0=129.3 +x_0=10000 +y_0=10000 +datum=WGS84 +units=m +no_defs"
FIELDS = "field=point_id:string"


@pytest.mark.parametrize(
    ("stated", "meant"),
    [
        ("2025-03-14T02:30:00", "2025-03-14T02:30:00Z"),
        ("2025-03-14T02:30:00Z", "2025-03-14T02:30:00Z"),
        ("2025-03-14T11:30:00+09:00", "2025-03-14T02:30:00Z"),
        ("2025-03-14T02:30:00-05:00", "2025-03-14T07:30:00Z"),
        (QDateTime(2025, 3, 14, 2, 30, 0), "2025-03-14T02:30:00Z"),
        (QDateTime.fromString("2025-03-14T02:30:00Z", Qt.DateFormat.ISODate), "2025-03-14T02:30:00Z"),
    ],
)
def test_a_time_of_a_single_step_keeps_its_offset(stated: Any, meant: str, context: QgsProcessingContext) -> None:
    algorithm = SegmentTetrapods().create()
    found = algorithm.time({"TIME": stated}, context)
    assert found == meant
    assert moment.fromisoformat(found).tzinfo == UTC


@pytest.fixture
def site_grid(qgis_app: QgsApplication) -> Iterator[QgsCoordinateReferenceSystem]:
    """A CRS that the user has defined."""
    QgsApplication.createDatabase()
    registry = QgsApplication.coordinateReferenceSystemRegistry()
    number = registry.addUserCrs(QgsCoordinateReferenceSystem.fromProj(SITE_GRID), "site grid")
    yield QgsCoordinateReferenceSystem(f"USER:{number}")
    registry.removeUserCrs(number)


def test_a_crs_of_the_user_reaches_the_engine_as_text_that_it_reads(
    site_grid: QgsCoordinateReferenceSystem, tmp_path: Path, context: QgsProcessingContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert site_grid.isValid()
    assert crs_text(QgsCoordinateReferenceSystem("EPSG:5186")) == "EPSG:5186"
    given: list[list[str]] = []
    monkeypatch.setattr(NewSurvey, "run_engine", lambda self, arguments, *others: given.append(arguments))
    parameters = {"FOLDER": str(tmp_path), "CRS": site_grid, "OUTPUT": str(tmp_path / "survey.toml")}
    NewSurvey().create().run(parameters, context, QgsProcessingFeedback())
    text = given[0][given[0].index("--crs") + 1]
    assert text == crs_text(site_grid)
    check = "import sys; from tetratrack.core.data.crs import check_survey_crs; check_survey_crs(sys.argv[1])"
    subprocess.run([str(find_engine().python), "-c", check, text], check=True)


def _layer(kind: str, fields: str, place: QgsGeometry, **values: Any) -> QgsVectorLayer:
    layer = QgsVectorLayer(f"{kind}&{FIELDS}{fields}", "control", "memory")
    feature = QgsFeature(layer.fields())
    for name, value in {"point_id": "T1", **values}.items():
        feature[name] = value
    feature.setGeometry(place)
    layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    return layer


def _written(layer: QgsVectorLayer, path: Path, context: QgsProcessingContext) -> dict[str, str]:
    defaults = dict.fromkeys(("sd_e", "sd_n", "sd_h"), "0.003")
    write_points(layer, CONTROL_COLUMNS, path, QgsCoordinateReferenceSystem("EPSG:5186"), context, defaults)
    with path.open(encoding="utf-8") as stream:
        return next(csv.DictReader(stream))


def test_only_what_a_layer_lacks_comes_from_its_geometry(tmp_path: Path, context: QgsProcessingContext) -> None:
    flat = _layer("Point?crs=EPSG:5186", "&field=height:double", QgsGeometry.fromWkt("POINT(236480 285120)"), height=8.25)
    row = _written(flat, tmp_path / "a.csv", context)
    assert [float(row[name]) for name in ("easting", "northing", "height")] == [236480, 285120, 8.25]
    # one of two coordinates alone may be of another frame: the geometry holds both
    half = _layer("PointZ?crs=EPSG:5186", "&field=easting:double", QgsGeometry(QgsPoint(236480, 285120, 8.5)), easting=500_000.0)
    row = _written(half, tmp_path / "b.csv", context)
    assert [float(row[name]) for name in ("easting", "northing", "height")] == [236480, 285120, 8.5]


def test_a_height_that_nothing_states_is_a_missing_field(tmp_path: Path, context: QgsProcessingContext) -> None:
    flat = _layer("Point?crs=EPSG:5186", "", QgsGeometry.fromWkt("POINT(236480 285120)"))
    with pytest.raises(QgsProcessingException, match="has no field height"):
        _written(flat, tmp_path / "a.csv", context)


def test_a_layer_of_something_else_is_refused_in_one_line(tmp_path: Path, context: QgsProcessingContext) -> None:
    """Layers of results have dozens of fields: the message names the first."""
    fields = "".join(f"&field=field{k}:string" for k in range(40))
    other = _layer("Point?crs=EPSG:5186", fields, QgsGeometry.fromWkt("POINT(236480 285120)"))
    with pytest.raises(QgsProcessingException, match=r"has no field height; it has point_id, field0, .*field4, …\.$"):
        _written(other, tmp_path / "a.csv", context)


@pytest.mark.parametrize("kind", ["Point", "LineString", "MultiPoint"])
def test_an_area_of_interest_that_is_no_polygon_is_refused(kind: str, context: QgsProcessingContext) -> None:
    """Dialogs offer polygon layers only; files, scripts and models bring any."""
    places = {"Point": "(1 2)", "LineString": "(1 2, 3 4)", "MultiPoint": "((1 2), (3 4))"}[kind]
    layer = _layer(f"{kind}?crs=EPSG:5186", "", QgsGeometry.fromWkt(f"{kind}{places}"))
    with pytest.raises(QgsProcessingException, match="holds no polygon"):
        ring_of(QgsProcessingFeatureSource(layer, context), QgsCoordinateReferenceSystem(), context)


@pytest.mark.parametrize("chosen", ["", "EPSG:5186"])
def test_control_of_the_start_page_is_written_in_the_crs_of_the_results(tmp_path: Path, context: QgsProcessingContext, chosen: str) -> None:
    layer = _layer("PointZ?crs=EPSG:4326", "", QgsGeometry(QgsPoint(127.35, 37.05, 8.2)))
    QgsProject.instance().addMapLayer(layer)
    rows = [EpochRow("a", "2025-01-01T00:00:00Z", ("x.laz",), {"control": layer.id()}, crs="" if chosen else "EPSG:5186")]
    crs = QgsCoordinateReferenceSystem(chosen) if chosen else declared_crs(rows)
    written = files_of_layers(rows, tmp_path, crs)[0].files["control"]
    with Path(written).open(encoding="utf-8") as stream:
        row = next(csv.DictReader(stream))
    assert (float(row["easting"]), float(row["northing"])) == pytest.approx((231133.73, 494619.16), abs=0.01)


def test_the_crs_of_the_results_is_that_of_most_tiles() -> None:
    rows = [EpochRow(tiles=("a", "b", "c"), crs="EPSG:5187"), EpochRow(tiles=("d",), crs="EPSG:5186"), EpochRow(tiles=("e", "f"), crs="")]
    assert declared_crs(rows).authid() == "EPSG:5187"
    assert not declared_crs(rows[2:]).isValid()
