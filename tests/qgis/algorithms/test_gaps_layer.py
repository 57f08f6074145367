"""The layer of gaps in QGIS: fields, style, and a ring as large as the missing unit on the map."""

from __future__ import annotations

from pathlib import Path

import pytest
from qgis.core import QgsMapRendererParallelJob, QgsMapSettings, QgsRectangle, QgsVectorLayer
from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QColor
from synthetic_result import HEIGHT, write_result
from tetratrack.algorithms.support.layers import DRAWING_ORDER, apply_style, layer_title
from tetratrack.core.results.schema import GAP_KINDS, LAYERS


def load_gaps(folder: Path) -> QgsVectorLayer:
    """Gaps of a made-up result with lost and unseen units; no fixture, which would keep the layer beyond the end of QGIS."""
    path = folder / "result.gpkg"
    write_result(path, 400)
    layer = QgsVectorLayer(f"{path}|layername=gaps", "gaps", "ogr")
    apply_style(layer, "gaps")
    return layer


def test_fields_and_style(tmp_path: Path) -> None:
    gaps = load_gaps(tmp_path)
    assert set(LAYERS["gaps"].names) <= set(gaps.fields().names())
    assert "gaps" in DRAWING_ORDER
    assert gaps.metadata().title() == layer_title("gaps")
    renderer = gaps.renderer()
    conditions = [rule.filterExpression() for rule in renderer.rootRule().descendants()]
    assert len(conditions) == len(GAP_KINDS)
    assert all(any(f"'{kind}'" in condition for condition in conditions) for kind in GAP_KINDS)
    assert gaps.temporalProperties().startField() == "epoch_time"


def test_lost_unit_is_a_red_ring_of_its_size(tmp_path: Path) -> None:
    gaps = load_gaps(tmp_path)
    lost = next(feature for feature in gaps.getFeatures() if feature["kind"] == "lost")
    assert lost["status"] == "placeholder"
    gaps.setSubsetString(f"unit_id = '{lost['unit_id']}'")
    place = lost.geometry().asPoint()
    settings = QgsMapSettings()
    settings.setLayers([gaps])
    settings.setDestinationCrs(gaps.crs())
    settings.setOutputSize(QSize(400, 400))
    settings.setExtent(QgsRectangle(place.x() - HEIGHT, place.y() - HEIGHT, place.x() + HEIGHT, place.y() + HEIGHT))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    red = QColor("#c62828").rgb()
    columns = [x for x in range(400) for y in range(400) if image.pixel(x, y) == red]
    # the map shows 2 H in 400 pixels, the ring 2 x 0.66 H
    assert min(columns) == pytest.approx(200 - 132, abs=6)
    assert max(columns) == pytest.approx(200 + 132, abs=6)
