"""Lengths in tables, forms and the identify window: in the project's unit, while the file holds metres."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import Qgis, QgsApplication, QgsEditorWidgetSetup, QgsProject, QgsVectorLayer, QgsVectorLayerCache
from qgis.gui import QgsAttributeForm, QgsAttributeTableModel, QgsGui
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QLineEdit
from synthetic_result import write_result
from tetratrack.algorithms.support import length_fields
from tetratrack.algorithms.support.field_titles import field_title
from tetratrack.algorithms.support.layers import STYLES, apply_style, has_style, name_added_layers, name_fields
from tetratrack.algorithms.support.lengths import length_format
from tetratrack.core.results.added_layers import ADDED
from tetratrack.core.results.comparison_layers import COMPARISON_LAYERS
from tetratrack.core.results.schema import LAYERS
from tetratrack.plugin import length_widget

pytestmark = pytest.mark.qgis

KINDS = {"text": "string", "integer": "integer", "real": "double", "boolean": "boolean", "datetime": "datetime"}


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("lengths") / "result.gpkg"
    write_result(path, 12, 2)
    return path


@pytest.fixture(autouse=True)
def shown(qgis_app: QgsApplication) -> Iterator[None]:
    """What the plugin registers when QGIS starts; the project in metres again."""
    QgsGui.editorWidgetRegistry().initEditors()
    length_fields.register()
    length_widget.register()
    yield
    length_fields.unregister()
    QgsProject.instance().setDistanceUnits(Qgis.DistanceUnit.Meters)


def table(layer: QgsVectorLayer) -> QgsAttributeTableModel:
    """The attribute table of a layer."""
    cache = QgsVectorLayerCache(layer, 100, layer)
    cache.setFullCache(True)
    model = QgsAttributeTableModel(cache, layer)
    model.loadLayer()
    return model


def cells(model: QgsAttributeTableModel, field: str) -> dict[int, str]:
    """What the column of a field says, by feature."""
    column = model.fieldCol(model.layer().fields().lookupField(field))
    return {model.rowToId(row): model.index(row, column).data() for row in range(model.rowCount())}


def test_a_length_that_is_not_known_is_a_dash() -> None:
    assert (length_format().text(None), length_format().number(None)) == ("–", "–")
    assert length_format().text(0.0) == "0.000 m"


@pytest.mark.parametrize(
    ("unit", "factor", "decimals", "suffix"),
    [
        (Qgis.DistanceUnit.Meters, 1, 3, "m"),
        (Qgis.DistanceUnit.Centimeters, 100, 2, "cm"),
        (Qgis.DistanceUnit.Millimeters, 1000, 1, "mm"),
        (Qgis.DistanceUnit.Kilometers, 1, 3, "m"),
    ],
)
def test_attribute_table_states_lengths_in_the_projects_unit(
    result: Path, unit: Qgis.DistanceUnit, factor: float, decimals: int, suffix: str
) -> None:
    layer = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    apply_style(layer, "displacements")
    model = table(layer)
    # an open table follows
    QgsProject.instance().setDistanceUnits(unit)
    stored = {feature.id(): feature for feature in layer.getFeatures()}
    for field in ("de", "d_3d", "sd_h", "d_horizontal"):
        shown = cells(model, field)
        assert set(shown) == set(stored)
        for key, text in shown.items():
            value = stored[key][field]
            assert text == (f"{round(factor * value, decimals) + 0.0:.{decimals}f} {suffix}"), field
    column = model.fieldCol(layer.fields().lookupField("d_3d"))
    assert model.headerData(column, Qt.Orientation.Horizontal, Qt.ItemDataRole.DisplayRole) == field_title("d_3d")
    # sorted by the number, not by what it reads as
    formatter, index = QgsApplication.fieldFormatterRegistry().fieldFormatter(length_fields.WIDGET), layer.fields().lookupField("d_3d")
    assert formatter.sortValue(layer, index, {}, None, 0.0123) == 0.0123


def test_velocities_have_a_decimal_more_and_empty_values_no_unit(result: Path) -> None:
    QgsProject.instance().setDistanceUnits(Qgis.DistanceUnit.Millimeters)
    layer = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    assert length_fields.length_text(0.00123, "a") == "1.23 mm/a"
    formatter = QgsApplication.fieldFormatterRegistry().fieldFormatter(length_fields.WIDGET)
    assert formatter.representValue(layer, 0, {}, None, None) == QgsApplication.nullRepresentation()
    assert formatter.representValue(layer, 0, {"Per": "a"}, None, -0.001) == "-1.00 mm/a"


def test_form_states_lengths_and_keeps_the_stored_number(result: Path) -> None:
    QgsProject.instance().setDistanceUnits(Qgis.DistanceUnit.Millimeters)
    layer = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    apply_style(layer, "displacements")
    feature = next(layer.getFeatures())
    form = QgsAttributeForm(layer, feature)
    texts = [line.text() for line in form.findChildren(QLineEdit)]
    for field in ("de", "dn", "dh", "d_3d"):
        assert f"{round(1000 * feature[field], 1) + 0.0:.1f} mm" in texts, field
    layer.startEditing()
    assert form.save()
    assert not layer.editBuffer().isModified(), "nothing rounded by looking at it"
    layer.rollBack()


def test_every_length_of_every_layer_follows_or_is_a_place() -> None:
    """No length in metres beside one in millimetres; coordinates stay what they are; no field under the name that programs use."""
    for name, known in (LAYERS | ADDED | COMPARISON_LAYERS).items():
        if not has_style(name):
            continue
        fields = "&".join(f"field={field.name}:{KINDS[field.type]}" for field in known.fields)
        geometry = "NoGeometry" if known.geometry == "none" else known.geometry
        layer = QgsVectorLayer(f"{geometry}?{fields}", name, "memory")
        layer.loadNamedStyle(str(STYLES / f"{name}.qml"), True)
        name_fields(layer, name)
        for field in known.fields:
            index = layer.fields().lookupField(field.name)
            kind, alias = layer.editorWidgetSetup(index).type(), layer.attributeAlias(index)
            if kind == "Hidden":
                continue
            assert alias != field.name, (name, field.name)
            assert (kind == length_fields.WIDGET) == length_fields.follows_unit(field), (name, field.name)
            assert (kind == length_fields.WIDGET) != ("[m" in alias and "²" not in alias) or field.unit not in ("m", "m/a"), (name, alias)


def test_layer_dragged_onto_the_map_is_named_once(result: Path) -> None:
    layer = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    layer.loadDefaultStyle()
    index = layer.fields().lookupField("d_3d")
    layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("Range", {"Precision": 3}))
    name_added_layers([layer])
    assert layer.editorWidgetSetup(index).type() == length_fields.WIDGET
    layer.setFieldAlias(index, "mine")
    name_added_layers([layer])
    assert layer.attributeAlias(index) == "mine"
    other = QgsVectorLayer("Point?field=name:string", "displacements", "memory")
    name_added_layers([other])
    assert not other.customProperty("tetratrack/fields")


def test_without_the_plugin_lengths_stay_metres_with_their_unit(result: Path) -> None:
    length_fields.unregister()
    layer = QgsVectorLayer(f"{result}|layername=displacements", "displacements", "ogr")
    apply_style(layer, "displacements")
    index = layer.fields().lookupField("d_3d")
    assert layer.editorWidgetSetup(index).type() == "Range"
    assert layer.attributeAlias(index).endswith("[m]")
