"""One CRS under two names, and two without a name, are told apart by what they are."""

from __future__ import annotations

import pytest
from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorLayer,
)
from tetratrack.algorithms.support.same_crs import crs_name, same_crs
from tetratrack.algorithms.trackdisplacements import TrackDisplacements

pytestmark = pytest.mark.qgis


def unnamed(meridian: float, name: str = "harbour grid") -> QgsCoordinateReferenceSystem:
    """A projected CRS that no authority knows."""
    wkt = QgsCoordinateReferenceSystem("EPSG:5186").toWkt(Qgis.CrsWktVariant.Preferred)
    wkt = wkt.replace('"Korea 2000 / Central Belt 2010"', f'"{name}"').replace(',ID["EPSG",5186]', "")
    found = QgsCoordinateReferenceSystem.fromWkt(wkt.replace("127,", f"{meridian},"))
    assert found.isValid()
    assert found.authid() == ""
    return found


def test_codes_do_not_count(qgis_app: object) -> None:
    assert same_crs(QgsCoordinateReferenceSystem("EPSG:3067"), QgsCoordinateReferenceSystem("ESRI:102139"))
    assert same_crs(unnamed(127.5, "harbour"), unnamed(127.5))
    assert not same_crs(unnamed(127.5), unnamed(128.5))
    # two datums 1.8 m apart, on one ellipsoid
    assert not same_crs(QgsCoordinateReferenceSystem("EPSG:28356"), QgsCoordinateReferenceSystem("EPSG:7856"))
    assert not same_crs(QgsCoordinateReferenceSystem("EPSG:5186"), QgsCoordinateReferenceSystem())
    assert same_crs(QgsCoordinateReferenceSystem(), QgsCoordinateReferenceSystem())
    assert crs_name(unnamed(127.5)) == "harbour grid"
    assert crs_name(QgsCoordinateReferenceSystem("EPSG:5186")) == "EPSG:5186"
    assert crs_name(QgsCoordinateReferenceSystem()) == ""


def prepared(*frames: QgsCoordinateReferenceSystem) -> bool:
    """Whether Track displacements takes layers of units in these CRS."""
    layers = []
    for number, frame in enumerate(frames):
        layer = QgsVectorLayer("PointZ", f"units {number}", "memory")
        layer.setCrs(frame)
        layers.append(layer)
    QgsProject.instance().addMapLayers(layers)
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    parameters = {"INPUT": [layer.id() for layer in layers], "UNITS": "TEMPORARY_OUTPUT", "OUTPUT": "TEMPORARY_OUTPUT"}
    try:
        return TrackDisplacements().create().prepareAlgorithm(parameters, context, QgsProcessingFeedback())
    finally:
        QgsProject.instance().clear()


def test_tracking_takes_one_crs_by_any_name(qgis_app: object) -> None:
    assert prepared(QgsCoordinateReferenceSystem("EPSG:3067"), QgsCoordinateReferenceSystem("ESRI:102139"))
    with pytest.raises(QgsProcessingException, match=r"different CRS: units 0 \(harbour grid\), units 1 \(east grid\)"):
        prepared(unnamed(127.5), unnamed(128.5, "east grid"))
    with pytest.raises(QgsProcessingException, match=r"units 1 \(no CRS\)"):
        prepared(QgsCoordinateReferenceSystem("EPSG:5186"), QgsCoordinateReferenceSystem())
