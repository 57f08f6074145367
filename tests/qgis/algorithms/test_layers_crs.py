"""The CRS that a user sets for point cloud layers overrules what their files declare, and is the same for all tiles of an epoch."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsPointCloudLayer,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProject,
)
from tetratrack.algorithms.segmenttetrapods import SegmentTetrapods
from tetratrack.algorithms.support.engine import find_engine
from tetratrack.algorithms.support.inputs import tiles_override

pytestmark = pytest.mark.qgis


# QGIS's own Python has no library for tiles, the engine's has
WRITE = """
import sys
from pathlib import Path
from las_files import grid_points, write_copc
for name in ("a", "b"):
    write_copc(Path(sys.argv[1]) / f"{name}.copc.laz", grid_points(), "EPSG:32651")
"""


@pytest.fixture
def layers(qgis_app: object, tmp_path: Path) -> Iterator[list[QgsPointCloudLayer]]:
    """Two layers of tiles that declare zone 51, where they are not."""
    helpers = Path(__file__).resolve().parents[2] / "helpers"
    subprocess.run([str(find_engine().python), "-c", WRITE, str(tmp_path)], env={"PYTHONPATH": str(helpers)}, check=True)
    found = [QgsPointCloudLayer(str(tmp_path / f"{name}.copc.laz"), name, "copc") for name in ("a", "b")]
    if not all(layer.isValid() and layer.dataProvider().crs().authid() == "EPSG:32651" for layer in found):
        pytest.skip("this QGIS reads no COPC")
    QgsProject.instance().addMapLayers(found)
    yield found
    QgsProject.instance().clear()


def _set(layer: QgsPointCloudLayer, code: str) -> None:
    layer.setCrs(QgsCoordinateReferenceSystem(code))


def test_what_files_declare_is_no_override(layers: list[QgsPointCloudLayer]) -> None:
    assert tiles_override(layers, QgsProcessingContext()) == ""
    assert tiles_override("/no/layer.laz", QgsProcessingContext()) == ""


def test_an_override_goes_to_the_survey(layers: list[QgsPointCloudLayer], tmp_path: Path) -> None:
    for layer in layers:
        _set(layer, "EPSG:32650")
    context, feedback = QgsProcessingContext(), QgsProcessingFeedback()
    context.setProject(QgsProject.instance())
    algorithm = SegmentTetrapods().create()
    parameters = {"TILES": [layer.id() for layer in layers], "UNIT": "tetrapod", "HEIGHT": 2.3, "UNITS": "TEMPORARY_OUTPUT"}
    assert algorithm.prepare(parameters, context, feedback)
    path = algorithm.survey(tmp_path, parameters, context, feedback)
    text = path.read_text(encoding="utf-8")
    assert 'tiles_crs = "EPSG:32650"' in text
    assert 'crs = "EPSG:32650"' in text


def test_one_layer_of_several_set_by_hand(layers: list[QgsPointCloudLayer]) -> None:
    _set(layers[1], "EPSG:32650")
    with pytest.raises(QgsProcessingException, match="layers b and a have different CRS, and that of b is set by hand"):
        tiles_override(layers, QgsProcessingContext())
