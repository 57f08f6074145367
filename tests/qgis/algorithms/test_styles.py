"""Styles that come with a result: what the map says agrees with the fields."""

from __future__ import annotations

import gzip
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from qgis.core import QgsFeature, QgsRenderContext, QgsRuleBasedRenderer, QgsVectorLayer
from tetratrack.algorithms.support.layers import apply_style, legend_label

STYLES = Path(__file__).parents[3] / "core" / "results" / "styles"
FIELDS = "field=feature:string&field=class:string&field=significant:boolean&field=d_3d:double&field=grade:string"


@pytest.mark.parametrize("style", ["displacements", "displacements_other"])
@pytest.mark.parametrize(
    ("length", "significant", "grade", "label"),
    [
        (0.12, True, "significant", "significant"),
        (0.04, True, "watch", "watch"),
        (0.12, True, "watch", "watch"),
        (0.12, True, "alert", "alert or more"),
        (1.5, True, "partly damaged", "alert or more"),
        (0.12, False, "below detection limit", "below the detection limit"),
        # corrected by hand
        (0.07, True, None, "watch"),
        (0.12, True, None, "alert or more"),
    ],
)
def test_displacements_are_painted_by_their_grade(style: str, length: float, significant: bool, grade: str | None, label: str) -> None:
    """Limits of grades are the survey's own."""
    layer = QgsVectorLayer(f"LineString?{FIELDS}", "displacements", "memory")
    message, done = layer.loadNamedStyle(str(STYLES / f"{style}.qml"))
    assert done, message
    renderer = layer.renderer()
    assert isinstance(renderer, QgsRuleBasedRenderer)
    feature = QgsFeature(layer.fields())
    feature.setAttributes(["centre", "moved", significant, length, grade])
    context = QgsRenderContext()
    context.expressionContext().setFields(layer.fields())
    context.expressionContext().setFeature(feature)
    met = [rule.label() for rule in renderer.rootRule().children() if rule.isFilterOK(feature, context)]
    assert met == [label]
    assert legend_label(label) == label


def test_the_legend_states_the_survey_s_own_limits(tmp_path: Path, repository: Path) -> None:
    result = tmp_path / "result.gpkg"
    result.write_bytes(gzip.decompress((repository / "tests" / "data" / "first_release" / "result.gpkg.gz").read_bytes()))
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute("UPDATE epochs SET settings = json_set(settings, '$.displacement.watch', 0.02)")
    layers = QgsVectorLayer(f"{result}|layername=displacements", "own"), QgsVectorLayer(f"LineString?{FIELDS}", "other", "memory")
    for layer in layers:
        apply_style(layer, "displacements")
    own, other = ({rule.label() for rule in layer.renderer().rootRule().children()} for layer in layers)
    assert {"watch: over 0.020 m", "alert or more: over 0.100 m"} <= own
    assert {"watch", "alert or more"} <= other, "layers that are no result's do not say what their limits are"
