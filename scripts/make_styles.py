"""Write core/styles/*.qml, the QGIS styles of the result's layers; run with QGIS's Python after a change here.

Arrows and ellipses have a size on paper, not on the ground: 10 mm stand for 50 mm at every map scale and for every unit size.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from qgis._3d import QgsPhongMaterialSettings, QgsPoint3DSymbol, QgsVectorLayer3DRenderer
from qgis.core import (
    Qgis,
    QgsApplication,
    QgsArrowSymbolLayer,
    QgsGeometryGeneratorSymbolLayer,
    QgsLineSymbol,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsProperty,
    QgsRuleBasedRenderer,
    QgsSimpleLineSymbolLayer,
    QgsSymbol,
    QgsSymbolLayer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
    QgsVectorLayerTemporalProperties,
)
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QColor

ROOT = Path(__file__).resolve().parents[1]
STYLES = ROOT / "core" / "styles"
PAPER_PER_METRE = 0.2
"""Metres on paper for a metre of displacement: 10 mm for 50 mm."""
LONGEST_ON_PAPER = 0.03
"""Metres; a unit that was carried away gets an arrow of this length."""
ELLIPSE_95 = 2.448
"""sqrt of the 95 % quantile of chi-square with two degrees of freedom."""
GREY, BLUE, ORANGE, RED, PURPLE, GREEN, TEAL = "#8a949c", "#2b7bba", "#e08a1e", "#c62828", "#7b3fa0", "#2f8f4e", "#16857f"
LEG_WIDTH, LEG_LENGTH = 0.12, 0.644
"""Width of the drawn axis, thin enough to leave the relief visible, and length of a leg in unit heights (Shore Protection Manual)."""
LEGS = ((0.0, 0.0, 1.0), (0.942809, 0.0, -0.333333), (-0.471405, 0.816497, -0.333333), (-0.471405, -0.816497, -0.333333))
LATEST = '(@map_start_time is not null or "epoch_time" = maximum("epoch_time"))'
"""Without the temporal controller all epochs are drawn; only the latest is labelled."""
CATEGORIES = (
    QgsMapLayer.StyleCategory.Symbology
    | QgsMapLayer.StyleCategory.Symbology3D
    | QgsMapLayer.StyleCategory.Labeling
    | QgsMapLayer.StyleCategory.Temporal
    | QgsMapLayer.StyleCategory.Elevation
    | QgsMapLayer.StyleCategory.Rendering
    | QgsMapLayer.StyleCategory.MapTips
)


def leg_lines() -> str:
    """Expression: the four legs as lines in plan, from the quaternion."""
    lines = []
    for x, y, z in LEGS:
        east = f'(1-2*("qy"^2+"qz"^2))*{x}+2*("qx"*"qy"-"qw"*"qz")*{y}+2*("qx"*"qz"+"qw"*"qy")*{z}'
        north = f'2*("qx"*"qy"+"qw"*"qz")*{x}+(1-2*("qx"^2+"qz"^2))*{y}+2*("qy"*"qz"-"qw"*"qx")*{z}'
        length = f'{LEG_LENGTH}*"height"'
        lines.append(f"make_line(make_point($x,$y),make_point($x+{length}*({east}),$y+{length}*({north})))")
    return f"collect_geometries({','.join(lines)})"


def vector(east: str, north: str, length: str, x: str, y: str) -> str:
    """Expression: a line whose length on paper stands for a vector; cut at the longest length."""
    scale = f"min({PAPER_PER_METRE}, {LONGEST_ON_PAPER}/max({length},1e-6))*@map_scale"
    return f"make_line(make_point({x},{y}),make_point({x}+{scale}*{east},{y}+{scale}*{north}))"


def ellipse(east: str, north: str, length: str, x: str, y: str, sd_e: str = '"sd_e"', sd_n: str = '"sd_n"') -> str:
    """Expression: 95 % ellipse around the end of :func:`vector`, axes along the grid."""
    scale = f"min({PAPER_PER_METRE}, {LONGEST_ON_PAPER}/max({length},1e-6))*@map_scale"
    size = f"{ELLIPSE_95 * PAPER_PER_METRE:.4f}*@map_scale"
    return f"boundary(make_ellipse({x}+{scale}*{east},{y}+{scale}*{north},{size}*{sd_e},{size}*{sd_n},0))"


def point_ellipse() -> str:
    """Expression: 95 % ellipse of a feature point from its covariance, on the arrows' scale."""
    size = f"{ELLIPSE_95 * PAPER_PER_METRE:.4f}*@map_scale"
    middle = '("sd_e"^2+"sd_n"^2)/2'
    spread = 'sqrt((("sd_e"^2-"sd_n"^2)/2)^2+"cov_en"^2)'
    azimuth = 'degrees(0.5*atan2(2*"cov_en","sd_n"^2-"sd_e"^2))'
    return f"boundary(make_ellipse($x,$y,{size}*sqrt(max({middle}-{spread},0)),{size}*sqrt({middle}+{spread}),{azimuth}))"


def generated(expression: str, symbol: QgsSymbol) -> QgsGeometryGeneratorSymbolLayer:
    """Symbol layer that draws a computed geometry."""
    layer = QgsGeometryGeneratorSymbolLayer.create({"geometryModifier": expression})
    layer.setSymbolType(symbol.type())
    layer.setSubSymbol(symbol)
    return layer


def arrow(colour: str, width: float) -> QgsLineSymbol:
    """Arrow symbol."""
    shaft = QgsArrowSymbolLayer.create(
        {
            "arrow_width": str(width),
            "arrow_start_width": str(width),
            "head_length": str(2.2 * width + 0.6),
            "head_thickness": str(1.2 * width + 0.4),
            "is_curved": "0",
        }
    )
    shaft.subSymbol().setColor(QColor(colour))
    shaft.subSymbol().symbolLayer(0).setStrokeColor(QColor("#ffffff"))
    shaft.subSymbol().symbolLayer(0).setStrokeWidth(0.1)
    return symbol_of(QgsLineSymbol(), shaft)


def outline(colour: str, width: float = 0.2) -> QgsLineSymbol:
    """Line of an ellipse."""
    return symbol_of(QgsLineSymbol(), QgsSimpleLineSymbolLayer(QColor(colour), width))


def symbol_of(symbol: QgsSymbol, *layers: QgsSymbolLayer) -> Any:
    """Symbol made of given layers."""
    symbol.deleteSymbolLayer(0)
    for layer in layers:
        symbol.appendSymbolLayer(layer)
    return symbol


def rules(*entries: tuple[str, str, QgsSymbol]) -> QgsRuleBasedRenderer:
    """Rule-based renderer of (label, filter, symbol)."""
    root = QgsRuleBasedRenderer.Rule(None)
    for label, condition, symbol in entries:
        root.appendChild(QgsRuleBasedRenderer.Rule(symbol, 0, 0, condition, label))
    return QgsRuleBasedRenderer(root)


def unit_symbol(colour: str) -> QgsMarkerSymbol:
    """A unit seen from above: its legs in true size and direction, and its centre."""
    shades = []
    for tone, share in (("#ffffff", 1.5), (colour, 1.0)):
        leg = QgsSimpleLineSymbolLayer(QColor(tone), 1.2 * share)
        leg.setPenCapStyle(Qt.PenCapStyle.RoundCap)
        leg.setDataDefinedProperty(
            QgsSymbolLayer.Property.StrokeWidth, QgsProperty.fromExpression(f'{1000 * share * LEG_WIDTH:.0f}*"height"/@map_scale')
        )
        shades.append(generated(leg_lines(), symbol_of(QgsLineSymbol(), leg)))
    centre = QgsMarkerSymbol.createSimple(
        {"name": "circle", "size": "1.4", "color": "#ffffff", "outline_color": colour, "outline_width": "0.3"}
    )
    symbol = symbol_of(QgsMarkerSymbol(), *shades, centre.symbolLayer(0).clone())
    return symbol


def vector_symbol(colour: str, width: float, east: str, north: str, length: str, *, on_line: bool, with_ellipse: bool) -> QgsSymbol:
    """Arrow of a vector, on a line layer from its start or on a point layer, with the ellipse at its end."""
    x, y = ("x(start_point($geometry))", "y(start_point($geometry))") if on_line else ("$x", "$y")
    layers = [generated(vector(east, north, length, x, y), arrow(colour, width))]
    if with_ellipse:
        layers.insert(0, generated(ellipse(east, north, length, x, y), outline(colour)))
    return symbol_of(QgsLineSymbol() if on_line else QgsMarkerSymbol(), *layers)


def labels(field: str, smallest_scale: float, size: float, colour: str = "#20303a") -> QgsVectorLayerSimpleLabeling:
    """Labels beside the feature from a scale on."""
    settings = QgsPalLayerSettings()
    settings.fieldName = field
    settings.isExpression = True
    text = QgsTextFormat()
    text.setSize(size)
    text.setColor(QColor(colour))
    halo = QgsTextBufferSettings()
    halo.setEnabled(True)
    halo.setSize(0.7)
    text.setBuffer(halo)
    settings.setFormat(text)
    settings.scaleVisibility = True
    settings.minimumScale = smallest_scale
    settings.maximumScale = 0
    return QgsVectorLayerSimpleLabeling(settings)


def sphere(colour: str, radius: float) -> QgsVectorLayer3DRenderer:
    """3D symbol at the true height."""
    symbol = QgsPoint3DSymbol()
    symbol.setShape(Qgis.Point3DShape.Sphere)
    symbol.setShapeProperties({"radius": radius})
    symbol.setAltitudeClamping(Qgis.AltitudeClamping.Absolute)
    material = QgsPhongMaterialSettings()
    material.setDiffuse(QColor(colour))
    material.setAmbient(QColor(colour).darker(150))
    symbol.setMaterialSettings(material)
    return QgsVectorLayer3DRenderer(symbol)


def styled(name: str) -> QgsVectorLayer:
    """Empty layer with the fields of the schema and its style."""
    from tetratrack.core.schema import LAYERS

    kinds = {"text": "string", "integer": "integer", "real": "double", "boolean": "boolean", "datetime": "datetime"}
    fields = "&".join(f"field={f.name}:{kinds[f.type]}" for f in LAYERS[name].fields)
    layer = QgsVectorLayer(f"{LAYERS[name].geometry}?{fields}", name, "memory")
    globals()[f"style_{name}"](layer)
    elevation = layer.elevationProperties()
    elevation.setClamping(Qgis.AltitudeClamping.Absolute)
    elevation.setBinding(Qgis.AltitudeBinding.Vertex)
    elevation.setType(Qgis.VectorProfileType.IndividualFeatures)
    elevation.setShowMarkerSymbolInSurfacePlots(True)
    return layer


def instants(layer: QgsVectorLayer, field: str) -> None:
    """Temporal controller: a feature belongs to the moment of its epoch."""
    temporal: QgsVectorLayerTemporalProperties = layer.temporalProperties()
    temporal.setIsActive(True)
    temporal.setMode(Qgis.VectorTemporalMode.FeatureDateTimeInstantFromField)
    temporal.setStartField(field)


def style_units(layer: QgsVectorLayer) -> None:
    """Units by status."""
    layer.setRenderer(
        rules(
            *(
                (status, f"\"status\" = '{status}'", unit_symbol(colour))
                for status, colour in (("found", TEAL), ("uncertain", GREY), ("new", GREEN), ("relocated", PURPLE))
            )
        )
    )
    layer.setLabeling(labels(f"if({LATEST}, \"unit_id\", '')", 300, 8))
    layer.setLabelsEnabled(True)
    layer.setRenderer3D(sphere(TEAL, 0.15))
    layer.setMapTipTemplate(
        '<b>[% "unit_id" %]</b> [% "epoch" %]<br>[% "status" %], score [% round("score", 2) %]<br>'
        'sd [% round(1000*"sd_e",1) %] / [% round(1000*"sd_n",1) %] / [% round(1000*"sd_h",1) %] mm'
    )
    instants(layer, "epoch_time")


def style_gaps(layer: QgsVectorLayer) -> None:
    """Places of missing units by kind: a broken circle as large as the unit, and a cross at its centre."""
    entries = []
    for label, kind, colour in (
        ("lost: the place is empty", "lost", RED),
        ("unseen: known from another epoch", "unseen", GREY),
        ("unexplained points where a unit fits", "unexplained", ORANGE),
        ("hole where a unit fits", "hole", PURPLE),
    ):
        ring = QgsSimpleLineSymbolLayer(QColor(colour), 0.5, Qt.PenStyle.DashLine)
        cross = QgsMarkerSymbol.createSimple({"name": "cross", "size": "2.4", "outline_color": colour, "outline_width": "0.5"})
        circle = generated('boundary(buffer($geometry, "radius", 16))', symbol_of(QgsLineSymbol(), ring))
        entries.append((label, f"\"kind\" = '{kind}'", symbol_of(QgsMarkerSymbol(), circle, cross.symbolLayer(0).clone())))
    layer.setRenderer(rules(*entries))
    layer.setRenderer3D(sphere(ORANGE, 0.15))
    layer.setMapTipTemplate(
        '<b>[% "kind" %]</b> [% coalesce("unit_id", \'\') %] [% "epoch" %]<br>[% "status" %], score [% round("score", 2) %]<br>'
        '[% "nearest_units" %]'
    )
    instants(layer, "epoch_time")


def style_feature_points(layer: QgsVectorLayer) -> None:
    """Observed and derived feature points with their ellipses."""
    entries = []
    for label, condition, fill in (
        ("observed", '"observed"', RED),
        ("derived from the rest of the unit", 'not coalesce("observed", false)', "#ffffff"),
    ):
        marker = QgsMarkerSymbol.createSimple(
            {"name": "triangle", "size": "1.8", "color": fill, "outline_color": RED, "outline_width": "0.25"}
        )
        entries.append(
            (label, condition, symbol_of(QgsMarkerSymbol(), generated(point_ellipse(), outline(RED, 0.15)), marker.symbolLayer(0).clone()))
        )
    layer.setRenderer(rules(*entries))
    layer.setLabeling(labels('"feature"', 60, 7, RED))
    layer.setLabelsEnabled(True)
    layer.setScaleBasedVisibility(True)
    layer.setMinimumScale(400)
    layer.setRenderer3D(sphere(RED, 0.05))
    instants(layer, "epoch_time")


def style_displacements(layer: QgsVectorLayer) -> None:
    """Arrows of the centres by significance and size, with 95 % ellipses."""
    centre = "\"feature\" = 'centre'"
    counted = f"{centre} and \"class\" not in ('relocated', 'uncertain')"
    significant = f'{counted} and "significant"'
    entries = [("arrow of 10 mm: 50 mm; ellipse: 95 %", "false", arrow(GREY, 0.6))]
    for label, condition, colour, width in (
        ("below the detection limit", f'{counted} and not coalesce("significant", false)', GREY, 0.4),
        ("significant, up to 50 mm", f'{significant} and "d_3d" <= 0.05', BLUE, 0.6),
        ("50 to 100 mm: watch", f'{significant} and "d_3d" > 0.05 and "d_3d" <= 0.1', ORANGE, 0.7),
        ("more than 100 mm: alert", f'{significant} and "d_3d" > 0.1', RED, 0.8),
        ("relocated unit", f"{centre} and \"class\" = 'relocated'", PURPLE, 0.8),
        ("uncertain unit", f"{centre} and \"class\" = 'uncertain'", "#c9a227", 0.4),
    ):
        entries.append((label, condition, vector_symbol(colour, width, '"de"', '"dn"', '"d_horizontal"', on_line=True, with_ellipse=True)))
    layer.setRenderer(rules(*entries))
    text = f"if({centre} and \"significant\", round(1000*\"d_3d\") || ' mm', '')"
    layer.setLabeling(labels(text, 500, 8, "#7a1010"))
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate(
        '<b>[% "unit_id" %]</b> [% "feature" %]<br>[% "epoch_from" %] – [% "epoch_to" %]<br>[% round(1000*"de",1) %] / '
        '[% round(1000*"dn",1) %] / [% round(1000*"dh",1) %] mm, [% "class" %]'
    )
    temporal: QgsVectorLayerTemporalProperties = layer.temporalProperties()
    temporal.setIsActive(True)
    temporal.setMode(Qgis.VectorTemporalMode.FeatureDateTimeStartAndEndFromFields)
    temporal.setStartField("time_from")
    temporal.setEndField("time_to")


def style_displacements_other(layer: QgsVectorLayer) -> None:
    """As the displacements of the default datum."""
    style_displacements(layer)


def style_control_residuals(layer: QgsVectorLayer) -> None:
    """Residual vectors at control points."""
    length = 'sqrt("ve"^2+"vn"^2)'
    entries = []
    for label, condition, colour in (
        ("used", '"used"', GREEN),
        ("disturbed, not used", '"outlier" and not "used"', RED),
        ("not used", 'not "used" and not "outlier"', GREY),
    ):
        marker = QgsMarkerSymbol.createSimple(
            {"name": "triangle", "size": "2.6", "color": "#ffffff", "outline_color": colour, "outline_width": "0.5"}
        )
        symbol = vector_symbol(colour, 0.6, '"ve"', '"vn"', length, on_line=False, with_ellipse=False)
        symbol.appendSymbolLayer(marker.symbolLayer(0).clone())
        entries.append((label, condition, symbol))
    layer.setRenderer(rules(*entries))
    layer.setLabeling(labels('if("epoch" = maximum("epoch"), "point_id", \'\')', 1000, 8))
    layer.setLabelsEnabled(True)
    layer.setRenderer3D(sphere(GREEN, 0.1))


def style_check_residuals(layer: QgsVectorLayer) -> None:
    """Difference vectors at check points."""
    marker = QgsMarkerSymbol.createSimple(
        {"name": "diamond", "size": "2.4", "color": "#ffffff", "outline_color": PURPLE, "outline_width": "0.5"}
    )
    symbol = vector_symbol(PURPLE, 0.6, '"de"', '"dn"', 'sqrt("de"^2+"dn"^2)', on_line=False, with_ellipse=False)
    symbol.appendSymbolLayer(marker.symbolLayer(0).clone())
    layer.setRenderer(rules(("check point", "", symbol)))
    layer.setLabeling(labels('if("epoch" = maximum("epoch"), "point_id" || \' \' || round(1000*"d_3d") || \' mm\', \'\')', 150, 7, PURPLE))
    layer.setLabelsEnabled(True)
    layer.setRenderer3D(sphere(PURPLE, 0.08))


def main() -> None:
    """Write all styles."""
    sys.path.insert(0, str(ROOT / "scripts"))
    import engine

    engine.load_package()
    application = QgsApplication([], False)
    application.initQgis()
    for name in ("units", "gaps", "feature_points", "displacements", "displacements_other", "control_residuals", "check_residuals"):
        message, done = styled(name).saveNamedStyle(str(STYLES / f"{name}.qml"), CATEGORIES)
        if not done:
            raise SystemExit(message)
    application.exitQgis()


if __name__ == "__main__":
    main()
