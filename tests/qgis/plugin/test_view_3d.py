"""The scene of the 3D view: arrows in proportion to the units, on a breakwater and in a tank, and no layer twice."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsPointCloudLayer, QgsProject
from synthetic_result import HEIGHT, write_result
from tetratrack.algorithms.support.engine import find_engine
from tetratrack.core.results.geopackage_reader import epoch_pairs
from tetratrack.core.results.unit_rows import read_unit_rows
from tetratrack.plugin import view_3d

pytestmark = pytest.mark.qgis

# QGIS's own Python has no library for tiles, the engine's has
WRITE_CLOUD = """
import sys
from pathlib import Path
from las_files import grid_points, write_copc
write_copc(Path(sys.argv[1]) / "result.copc.laz", grid_points(), "EPSG:32651")
"""


@pytest.mark.parametrize("height", [HEIGHT, 0.105])
def test_arrows_are_in_proportion_to_the_units(
    qgis_app: QgsApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, height: float
) -> None:
    result = tmp_path / "result.gpkg"
    write_result(result, 40, 2, seed=4)
    assert view_3d.unit_height(result) == pytest.approx(HEIGHT)
    monkeypatch.setattr(view_3d, "unit_height", lambda path: height)
    project = QgsProject()
    scene = view_3d.scene_of(result, project)
    rows = read_unit_rows(result, epoch_pairs(result)[-1], "stable")
    moved = sorted(row.d_3d for row in rows if row.significant and row.kind != "relocated")
    drawn = scene.arrow_scale * moved[len(moved) // 2] / height
    # one of 1, 2, 5 times a power of ten; never smaller than life
    assert 0.4 * view_3d.TYPICAL_ARROW <= drawn <= view_3d.TYPICAL_ARROW * 1.001 or scene.arrow_scale == 1
    assert scene.unit_height == height


def test_a_second_view_uses_the_layers_of_the_first(qgis_app: QgsApplication, tmp_path: Path) -> None:
    result = tmp_path / "result.gpkg"
    write_result(result, 40, 2, seed=4)
    helpers = Path(__file__).resolve().parents[2] / "helpers"
    subprocess.run([str(find_engine().python), "-c", WRITE_CLOUD, str(tmp_path)], env={"PYTHONPATH": str(helpers)}, check=True)
    cloud = QgsPointCloudLayer(str(tmp_path / "result.copc.laz"), "cloud", "copc").isValid()
    project = QgsProject()
    first, second = view_3d.scene_of(result, project), view_3d.scene_of(result, project)
    assert [layer.id() for layer in first.layers] == [layer.id() for layer in second.layers]
    assert len(project.mapLayers()) == len(first.layers) == (3 if cloud else 2)
    arrows = first.layers[1]
    assert arrows.featureCount() == len(list(arrows.getFeatures())) > 0
