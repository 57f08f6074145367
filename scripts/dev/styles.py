"""Write core/results/styles/*.qml, the QGIS styles of the result's layers; run with QGIS's Python after a change here.

Arrows and ellipses have a size on paper, not on the ground: 10 mm stand for 50 mm at every map scale and for every unit size.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from qgis._3d import (
    QgsPhongMaterialSettings,
    QgsPoint3DSymbol,
    QgsPolygon3DSymbol,
    QgsRuleBased3DRenderer,
    QgsVectorLayer3DRenderer,
)
from qgis.core import (
    Qgis,
    QgsApplication,
    QgsArrowSymbolLayer,
    QgsAttributeTableConfig,
    QgsEditorWidgetSetup,
    QgsFillSymbol,
    QgsGeometryGeneratorSymbolLayer,
    QgsLineSymbol,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsNullSymbolRenderer,
    QgsPalLayerSettings,
    QgsProject,
    QgsProperty,
    QgsReadWriteContext,
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

ROOT = Path(__file__).resolve().parents[2]
STYLES = ROOT / "core" / "results" / "styles"
PAPER_PER_METRE = 0.2
"""Metres on paper for a metre of displacement: 10 mm for 50 mm."""
LONGEST_ON_PAPER = 0.03
"""Metres; a unit that was carried away gets an arrow of this length."""
ELLIPSE_95 = 2.448
"""sqrt of the 95 % quantile of chi-square with two degrees of freedom."""
GREY, BLUE, ORANGE, RED, PURPLE, GREEN, NAVY = "#8a949c", "#56a0d8", "#e69f00", "#c62828", "#3b0f5c", "#3fbf6f", "#0e6ba8"
"""Those of one legend differ for everybody, in numbers: ``tests/core/results/test_colours.py``."""
LEG_WIDTH_MM, LEG_LENGTH = 0.35, 0.644
"""Width of the drawn axes on paper, thin enough to leave outlines and relief visible, and length of a leg in unit heights (Shore
Protection Manual)."""
LEGS = ((0.0, 0.0, 1.0), (0.942809, 0.0, -0.333333), (-0.471405, 0.816497, -0.333333), (-0.471405, -0.816497, -0.333333))
LATEST = '(@map_start_time is not null or "epoch_until" is null)'
"""The epoch the temporal controller stands at, without it the latest: epochs drawn over each other show nothing."""
LENGTH_UNIT = "coalesce(@tetratrack_unit, 'm')"
"""Expression: the project's unit of lengths, which the plugin keeps in variables of the project; metres without it."""
CATEGORIES = (
    QgsMapLayer.StyleCategory.Symbology
    | QgsMapLayer.StyleCategory.Symbology3D
    | QgsMapLayer.StyleCategory.Labeling
    | QgsMapLayer.StyleCategory.Temporal
    | QgsMapLayer.StyleCategory.Elevation
    | QgsMapLayer.StyleCategory.Rendering
    | QgsMapLayer.StyleCategory.MapTips
    | QgsMapLayer.StyleCategory.Fields
    | QgsMapLayer.StyleCategory.Forms
    | QgsMapLayer.StyleCategory.AttributeTable
)
TECHNICAL = (
    "qx",
    "qy",
    "qz",
    "qw",
    "r0",
    "gradient",
    "covariance",
    "cov_en",
    "cov_eh",
    "cov_nh",
    "statistic",
    "transformation",
    "settings",
    "before",
    "undoes",
)
"""Fields for programs, left out of tables and the identify window."""
DECIMALS = {"m": 3, "m2": 2, "m/a": 4, "degrees": 2, "": 3}
"""Decimals shown of a real number by its unit."""


def length(metres: str) -> str:
    """Expression: a length in metres as the number that the project's unit of lengths makes of it."""
    return f"format_number(coalesce(@tetratrack_factor, 1)*({metres}), coalesce(@tetratrack_decimals, 3))"


def stated(field: str) -> str:
    """Expression: a field in metres with the project's unit."""
    return length(f'"{field}"') + f" || ' ' || {LENGTH_UNIT}"


def tip(*fields: str) -> str:
    """Fields in metres with the project's unit, for a map tip."""
    numbers = (length(f'"{field}"') for field in fields)
    return " / ".join(f"[% {number} %]" for number in numbers) + f" [% {LENGTH_UNIT} %]"


def leg_ways() -> list[tuple[str, str]]:
    """Expressions: east and north of the way along each leg, from the quaternion."""
    ways = []
    for x, y, z in LEGS:
        east = f'(1-2*("qy"^2+"qz"^2))*{x}+2*("qx"*"qy"-"qw"*"qz")*{y}+2*("qx"*"qz"+"qw"*"qy")*{z}'
        north = f'2*("qx"*"qy"+"qw"*"qz")*{x}+(1-2*("qx"^2+"qz"^2))*{y}+2*("qy"*"qz"-"qw"*"qx")*{z}'
        ways.append((east, north))
    return ways


def leg_lines() -> str:
    """Expression: the four legs as lines in plan."""
    reach = f'{LEG_LENGTH}*"height"'
    lines = [f"make_line(make_point($x,$y),make_point($x+{reach}*({east}),$y+{reach}*({north})))" for east, north in leg_ways()]
    return f"collect_geometries({','.join(lines)})"


def missing_ends() -> str:
    """Expression: of broken legs the part that is missing, as lines in plan."""
    lines = []
    for number, (east, north) in enumerate(leg_ways(), 1):
        whole = f'{LEG_LENGTH}*"height"'
        left = f'({whole}-"leg{number}_missing")'
        ends = ",".join(f"make_point($x+{reach}*({east}),$y+{reach}*({north}))" for reach in (left, whole))
        lines.append(f"if(\"leg{number}\" = 'broken', make_line({ends}), NULL)")
    return f"collect_geometries(array_filter(array({','.join(lines)}), @element is not null))"


def leg_tips() -> str:
    """Expression: what is broken and which ends are not seen, a line each; legs by name, which results of earlier versions may not have."""
    lines = []
    for number in (1, 2, 3, 4):
        state, missing, share = (f"attribute('leg{number}{what}')" for what in ("", "_missing", "_probability"))
        gone = f"coalesce(', ' || {length(missing)} || ' ' || {LENGTH_UNIT} || ' missing', '')"
        sure = f"coalesce(' (' || round(100*{share}) || ' %)', '')"
        lines.append(f"if({state} = 'broken', 'leg {number} broken' || {gone} || {sure}, NULL)")
        lines.append(f"if({state} = 'unseen', 'end of leg {number} not seen', NULL)")
    return f"array_to_string(array_filter(array({','.join(lines)}), @element is not null), '<br>')"


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
    for tone, width in (("#ffffff", LEG_WIDTH_MM + 0.4), (colour, LEG_WIDTH_MM)):
        leg = QgsSimpleLineSymbolLayer(QColor(tone), width)
        leg.setPenCapStyle(Qt.PenCapStyle.RoundCap)
        shades.append(generated(leg_lines(), symbol_of(QgsLineSymbol(), leg)))
    centre = QgsMarkerSymbol.createSimple(
        {"name": "circle", "size": "1.4", "color": "#ffffff", "outline_color": colour, "outline_width": "0.3"}
    )
    symbol = symbol_of(QgsMarkerSymbol(), *shades, centre.symbolLayer(0).clone())
    return symbol


def missing_end_symbol() -> QgsMarkerSymbol:
    """What is missing of broken legs, on the drawn legs."""
    shades = [
        generated(missing_ends(), symbol_of(QgsLineSymbol(), QgsSimpleLineSymbolLayer(QColor(tone), width)))
        for tone, width in (("#ffffff", 1.2), (RED, 0.8))
    ]
    return symbol_of(QgsMarkerSymbol(), *shades)


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


def unit_labels() -> QgsVectorLayerSimpleLabeling:
    """One label a unit: its name, and what it moved by; those that moved come first where there is no room for all."""
    moved = "\"class\" not in ('stable', 'found', 'uncertain')"
    shown = stated("d_3d")
    text = f"if({LATEST}, \"unit_id\" || if({moved}, coalesce('\\n' || {shown}, ''), ''), '')"
    labelling = labels(text, 400, 8)
    settings = labelling.settings()
    settings.placement = Qgis.LabelPlacement.OverPoint
    own = settings.dataDefinedProperties()
    own.setProperty(QgsPalLayerSettings.Property.Priority, QgsProperty.fromExpression(f"if({moved}, 10, 3)"))
    own.setProperty(QgsPalLayerSettings.Property.Color, QgsProperty.fromExpression(f"if({moved}, '#7a1010', '#20303a')"))
    settings.setDataDefinedProperties(own)
    return QgsVectorLayerSimpleLabeling(settings)


def sphere(colour: str, radius: float) -> QgsVectorLayer3DRenderer:
    """3D symbol at the true height."""
    symbol = QgsPoint3DSymbol()
    symbol.setShape(Qgis.Point3DShape.Sphere)
    symbol.setShapeProperties({"radius": radius})
    symbol.setAltitudeClamping(Qgis.AltitudeClamping.Absolute)
    symbol.setMaterialSettings(phong(colour))
    return QgsVectorLayer3DRenderer(symbol)


def phong(colour: str) -> QgsPhongMaterialSettings:
    """Material of a colour that stays recognisable in the shade."""
    material = QgsPhongMaterialSettings()
    material.setDiffuse(QColor(colour))
    material.setAmbient(QColor(colour).darker(150))
    return material


def styled(name: str) -> QgsVectorLayer:
    """Empty layer with the fields of the schema and its style."""
    from tetratrack.core.results.added_layers import known_layer

    described = known_layer(name)
    if described is None:
        raise ValueError(f"no result has a layer {name!r}")
    kinds = {"text": "string", "integer": "integer", "real": "double", "boolean": "boolean", "datetime": "datetime"}
    fields = "&".join(f"field={f.name}:{kinds[f.type]}" for f in described.fields)
    geometry = "NoGeometry" if described.geometry == "none" else described.geometry
    layer = QgsVectorLayer(f"{geometry}?{fields}", name, "memory")
    globals().get(f"style_{name}", plain)(layer)
    show_fields(layer, described.fields)
    if described.geometry == "none":
        return layer
    elevation = layer.elevationProperties()
    elevation.setClamping(Qgis.AltitudeClamping.Absolute)
    elevation.setBinding(Qgis.AltitudeBinding.Vertex)
    elevation.setType(Qgis.VectorProfileType.IndividualFeatures)
    elevation.setShowMarkerSymbolInSurfacePlots(True)
    # symbols made by generators of geometry leave the elevation profile blank
    elevation.setRespectLayerSymbology(False)
    elevation.setProfileMarkerSymbol(QgsMarkerSymbol.createSimple({"name": "circle", "size": "1.8", "color": NAVY, "outline_style": "no"}))
    colour, width = (RED, "0.6") if described.geometry == "LineStringZ" else ("#44505a", "0.12")
    elevation.setProfileLineSymbol(QgsLineSymbol.createSimple({"line_color": colour, "line_width": width}))
    elevation.setProfileFillSymbol(QgsFillSymbol.createSimple({"color": "#9fb8b6", "outline_color": "#44505a", "outline_width": "0.2"}))
    return layer


def plain(layer: QgsVectorLayer) -> None:
    """Nothing of its own: tables, and layers that are looked up rather than drawn."""


def style_unit_edits(layer: QgsVectorLayer) -> None:
    """Placeholders that stand, as broken squares with their names; other corrections as small dots."""
    square = QgsMarkerSymbol.createSimple(
        {"name": "square", "size": "5", "color": "0,0,0,0", "outline_color": ORANGE, "outline_width": "0.6", "outline_style": "dash"}
    )
    dot = QgsMarkerSymbol.createSimple({"name": "circle", "size": "1.6", "color": ORANGE, "outline_color": "#ffffff"})
    stands = 'not coalesce("undone", false) and "kind" <> \'undo\''
    layer.setRenderer(
        rules(
            ("placeholder for a unit not found", f"\"kind\" = 'placeholder' and {stands}", square),
            ("place of a correction", f"\"kind\" <> 'placeholder' and {stands}", dot),
        )
    )
    layer.setLabeling(labels(f"if(\"kind\" = 'placeholder' and {stands}, \"unit_id\", '')", 400, 8, ORANGE))
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate('<b>[% "unit_id" %]</b> [% "epoch" %]<br>[% "kind" %], [% "editor" %]<br>[% "comment" %]')


def style_manual_picks(layer: QgsVectorLayer) -> None:
    """Crosses where somebody picked a joint."""
    cross = QgsMarkerSymbol.createSimple({"name": "cross2", "size": "2.6", "outline_color": PURPLE, "outline_width": "0.5"})
    layer.setRenderer(rules(("picked by hand", "", cross)))
    layer.setLabeling(labels('"feature"', 25, 7, PURPLE))
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate('<b>[% "unit_id" %]</b> [% "feature" %], [% "epoch" %]<br>[% "picked_by" %]')


def show_fields(layer: QgsVectorLayer, fields: Any) -> None:
    """Names with their units, sensible decimals, and nothing that only programs read, in tables, forms and the identify window."""
    from tetratrack.algorithms.support.field_titles import field_alias

    table = QgsAttributeTableConfig()
    table.update(layer.fields())
    columns = table.columns()
    for field in fields:
        index = layer.fields().lookupField(field.name)
        layer.setFieldAlias(index, field_alias(field))
        if field.name in TECHNICAL:
            layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("Hidden", {}))
        elif field.type == "real":
            # a probability far below a thousandth must not read as zero
            decimals = 5 if field.name.startswith("p_") else DECIMALS.get(field.unit, 3)
            layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("Range", {"Precision": decimals, "AllowNull": True, "Style": "SpinBox"}))
    for column in columns:
        column.hidden = column.name in TECHNICAL
    table.setColumns(columns)
    layer.setAttributeTableConfig(table)


def lasting(layer: QgsVectorLayer) -> None:
    """Temporal controller: a feature stands from its epoch until the next one."""
    temporal: QgsVectorLayerTemporalProperties = layer.temporalProperties()
    temporal.setIsActive(True)
    temporal.setMode(Qgis.VectorTemporalMode.FeatureDateTimeStartAndEndFromFields)
    temporal.setStartField("epoch_time")
    temporal.setEndField("epoch_until")
    temporal.setLimitMode(Qgis.VectorTemporalLimitMode.IncludeBeginExcludeEnd)


def style_units(layer: QgsVectorLayer) -> None:
    """Units by status."""
    layer.setRenderer(
        rules(
            *(
                (status, f"\"status\" = '{status}' and {LATEST}", unit_symbol(colour))
                for status, colour in (("found", NAVY), ("uncertain", GREY), ("new", GREEN), ("relocated", PURPLE))
            ),
            ("missing end of a broken leg", f'\'broken\' in ("leg1", "leg2", "leg3", "leg4") and {LATEST}', missing_end_symbol()),
        )
    )
    layer.setRenderer3D(sphere(NAVY, 0.15))
    layer.setMapTipTemplate(
        f'<b>[% "unit_id" %]</b> [% "epoch" %]<br>[% "status" %], score [% round("score", 2) %]<br>sd {tip("sd_e", "sd_n", "sd_h")}'
        f"<br>[% {leg_tips()} %]"
    )
    lasting(layer)


def class_conditions() -> list[tuple[str, str, str]]:
    """Class, condition and colour of the layers that show units as bodies."""
    from tetratrack.core.results.class_colours import CLASS_COLOURS, class_colour

    kinds = ["found", *(kind for kind in CLASS_COLOURS if kind not in ("lost", "unseen"))]
    return [(kind, f"\"class\" = '{kind}'", class_colour(kind)) for kind in kinds]


def style_unit_outlines(layer: QgsVectorLayer) -> None:
    """Outlines from above by class, clear enough to leave the relief visible."""
    entries = []
    for kind, condition, colour in class_conditions():
        fill = QColor(colour)
        fill.setAlphaF(0.55)
        symbol = QgsFillSymbol.createSimple({"outline_color": "#44505a", "outline_width": "0.15"})
        symbol.symbolLayer(0).setFillColor(fill)
        entries.append((kind, f"{condition} and {LATEST}", symbol))
    layer.setRenderer(rules(*entries))
    layer.setLabeling(unit_labels())
    layer.setLabelsEnabled(True)
    moved = f"coalesce({stated('d_3d')}, '')"
    layer.setMapTipTemplate(f'<b>[% "unit_id" %]</b> [% "epoch" %]<br>[% "class" %] [% {moved} %]')
    lasting(layer)


def style_unit_surfaces(layer: QgsVectorLayer) -> None:
    """Nothing on the map, where the outlines show the same; bodies by class in 3D views."""
    layer.setRenderer(QgsNullSymbolRenderer())
    root = QgsRuleBased3DRenderer.Rule(None)
    for kind, condition, colour in class_conditions():
        symbol = QgsPolygon3DSymbol()
        symbol.setAltitudeClamping(Qgis.AltitudeClamping.Absolute)
        symbol.setAltitudeBinding(Qgis.AltitudeBinding.Vertex)
        symbol.setMaterialSettings(phong(colour))
        root.appendChild(QgsRuleBased3DRenderer.Rule(symbol, condition, kind))
    layer.setRenderer3D(QgsRuleBased3DRenderer(root))
    lasting(layer)


def placement_mark(colour: str, size: float, *, ring: bool = False) -> QgsMarkerSymbol:
    """A dot, or a ring around it for what is noted besides."""
    fill, outline_colour, width = ("#00ffffff", colour, "0.7") if ring else (colour, "#44505a", "0.15")
    properties = {"name": "circle", "size": str(size), "color": fill, "outline_color": outline_colour, "outline_width": width}
    return QgsMarkerSymbol.createSimple(properties)


def style_placement(layer: QgsVectorLayer) -> None:
    """Packing by its share of the design number, with rings around units that lie otherwise than they should."""
    from tetratrack.core.model.outline import SPM_PACKING

    loose, dense = 0.8 * SPM_PACKING, 1.2 * SPM_PACKING
    entries = [
        (label, f"({condition}) and {LATEST}", placement_mark(colour, 3.2))
        for label, condition, colour in (
            ("loose: below 80 % of the design number", f'"packing" < {loose:.3f}', ORANGE),
            ("as designed", f'"packing" >= {loose:.3f} and "packing" <= {dense:.3f}', "#7fc6c1"),
            ("dense: above 120 %", f'"packing" > {dense:.3f}', BLUE),
            ("edge of the armour", '"packing" is null', "#d5d8dc"),
        )
    ]
    entries += [
        (label, f"({condition}) and {LATEST}", placement_mark(colour, size, ring=True))
        for label, condition, colour, size in (
            ("more than 0.5 Dn off its neighbours' surface", 'abs("off_surface_dn") > 0.5', RED, 4.6),
            ("touches no other unit", '"contacts" = 0', PURPLE, 5.6),
            ("in a column", '"in_column"', "#20303a", 6.6),
        )
    ]
    layer.setRenderer(rules(*entries))
    layer.setMapTipTemplate(
        '<b>[% "unit_id" %]</b> [% "epoch" %]<br>layer [% "layer" %], [% coalesce(round("packing", 2) || \' per Dn², \', \'\') %]'
        '[% "contacts" %] contacts, gap [% round(100*"free_gap", 1) %] cm<br>'
        'turn [% round("turn_deg") %]°, [% round("off_surface", 2) %] m off its neighbours'
    )
    lasting(layer)


VERDICTS = (("within the tolerance", "within", GREEN), ("cannot be told", "open", ORANGE), ("outside the tolerance", "outside", RED))


def style_plan_deviations(layer: QgsVectorLayer) -> None:
    """Deviations from the plan as arrows on the displacements' scale, by verdict."""
    judged = [(title, f"\"verdict\" = '{verdict}'", colour) for title, verdict, colour in VERDICTS]
    layer.setRenderer(
        rules(
            *(
                (title, condition, vector_symbol(colour, 0.6, '"de"', '"dn"', '"d_horizontal"', on_line=True, with_ellipse=False))
                for title, condition, colour in (*judged, ("not judged", '"verdict" is null', GREY))
            )
        )
    )
    layer.setLabeling(labels("\"plan_id\" || '\\n' || round(1000*\"d_3d\") || ' mm'", 300, 7))
    layer.setLabelsEnabled(True)


def style_plan_unmatched(layer: QgsVectorLayer) -> None:
    """Places without a unit, and units without a place."""
    entries = []
    for title, kind, mark, colour in (
        ("planned place without a unit", "missing", "cross2", RED),
        ("unit without a planned place", "extra", "cross", PURPLE),
    ):
        properties = {"name": mark, "size": "4", "outline_color": colour, "outline_width": "0.7"}
        entries.append((title, f"\"kind\" = '{kind}'", QgsMarkerSymbol.createSimple(properties)))
    layer.setRenderer(rules(*entries))
    layer.setLabeling(labels('coalesce("plan_id", "unit_id")', 300, 7))
    layer.setLabelsEnabled(True)


def style_profile_deviations(layer: QgsVectorLayer) -> None:
    """Units against the design profile by verdict, with the distance of the outermost point."""
    judged = [(title, f"\"verdict\" = '{verdict}'", placement_mark(colour, 3.2)) for title, verdict, colour in VERDICTS]
    layer.setRenderer(rules(*judged, ("not judged", '"verdict" is null', placement_mark(GREY, 3.2))))
    layer.setLabeling(labels("format_number(\"off_outer\", 2) || ' m'", 300, 7))
    layer.setLabelsEnabled(True)


def style_sections(layer: QgsVectorLayer) -> None:
    """Cross-sections seen from above are lines; what they hold shows in elevation profiles and 3D views."""
    layer.setRenderer(
        rules(
            *(
                (title, f"\"kind\" = '{kind}'", outline(colour, width))
                for title, kind, colour, width in (
                    ("blocks", "blocks", "#44505a", 0.4),
                    ("surface of the points", "points", BLUE, 0.3),
                    ("design", "design", GREEN, 0.6),
                )
            )
        )
    )


def style_crest(layer: QgsVectorLayer) -> None:
    """Crest of each reach with its height and change."""
    layer.setRenderer(rules(("crest", "", placement_mark(NAVY, 3.0))))
    text = "format_number(\"crest_height\", 2) || ' m' || coalesce('\\n' || round(1000*\"change\") || ' mm', '')"
    layer.setLabeling(labels(text, 1000, 7))
    layer.setLabelsEnabled(True)


def style_settlement(layer: QgsVectorLayer) -> None:
    """Stretches of the axis by whether they moved, with the height change."""
    layer.setRenderer(
        rules(
            ("moved", '"datum" = \'control\' and "significant"', outline(RED, 1.2)),
            ("no motion that could be told", '"datum" = \'control\' and not "significant"', outline(GREY, 0.8)),
        )
    )
    layer.setLabeling(labels("if(\"datum\" = 'control', round(1000*\"dh\") || ' mm', '')", 2000, 7))
    layer.setLabelsEnabled(True)


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
        entries.append((label, f"\"kind\" = '{kind}' and {LATEST}", symbol_of(QgsMarkerSymbol(), circle, cross.symbolLayer(0).clone())))
    layer.setRenderer(rules(*entries))
    layer.setRenderer3D(sphere(ORANGE, 0.15))
    layer.setMapTipTemplate(
        '<b>[% "kind" %]</b> [% coalesce("unit_id", \'\') %] [% "epoch" %]<br>[% "status" %], score [% round("score", 2) %]<br>'
        '[% "nearest_units" %]'
    )
    lasting(layer)


def style_feature_points(layer: QgsVectorLayer) -> None:
    """Observed and derived feature points with their ellipses."""
    entries = []
    for label, condition, fill in (
        ("observed", f'"observed" and {LATEST}', RED),
        ("derived from the rest of the unit", f'not coalesce("observed", false) and {LATEST}', "#ffffff"),
    ):
        marker = QgsMarkerSymbol.createSimple(
            {"name": "triangle", "size": "1.8", "color": fill, "outline_color": RED, "outline_width": "0.25"}
        )
        entries.append(
            (label, condition, symbol_of(QgsMarkerSymbol(), generated(point_ellipse(), outline(RED, 0.15)), marker.symbolLayer(0).clone()))
        )
    layer.setRenderer(rules(*entries))
    layer.setLabeling(labels(f"if({LATEST} and \"feature\" <> 'centre', \"feature\", '')", 25, 7, RED))
    layer.setLabelsEnabled(True)
    layer.setScaleBasedVisibility(True)
    layer.setMinimumScale(400)
    layer.setRenderer3D(sphere(RED, 0.05))
    lasting(layer)


def style_displacements(layer: QgsVectorLayer) -> None:
    """Arrows of the centres by significance and grade, with 95 % ellipses."""
    centre = "\"feature\" = 'centre'"
    counted = f"{centre} and \"class\" not in ('relocated', 'uncertain')"
    significant = f'{counted} and "significant"'
    # corrected by hand: no grade by the survey's limits
    grade = "coalesce(\"grade\", if(\"d_3d\" > 0.1, 'alert', if(\"d_3d\" > 0.05, 'watch', 'significant')))"
    entries = [("arrow of 10 mm: 50 mm, at most 30 mm long; ellipse: 95 %", "false", arrow(GREY, 0.6))]
    for label, condition, colour, width in (
        ("below the detection limit", f'{counted} and not coalesce("significant", false)', GREY, 0.4),
        ("significant", f"{significant} and {grade} = 'significant'", BLUE, 0.6),
        ("watch", f"{significant} and {grade} = 'watch'", ORANGE, 0.7),
        ("alert or more", f"{significant} and {grade} not in ('significant', 'watch')", RED, 0.8),
        ("relocated unit", f"{centre} and \"class\" = 'relocated'", PURPLE, 0.8),
        ("uncertain unit", f"{centre} and \"class\" = 'uncertain'", "#d8c98a", 0.4),
    ):
        entries.append((label, condition, vector_symbol(colour, width, '"de"', '"dn"', '"d_horizontal"', on_line=True, with_ellipse=True)))
    layer.setRenderer(rules(*entries))
    # lengths are written beside the unit's name, by the outlines
    layer.setLabelsEnabled(False)
    layer.setMapTipTemplate(
        f'<b>[% "unit_id" %]</b> [% "feature" %]<br>[% "epoch_from" %] – [% "epoch_to" %]<br>{tip("de", "dn", "dh")}, [% "class" %]'
    )
    temporal: QgsVectorLayerTemporalProperties = layer.temporalProperties()
    temporal.setIsActive(True)
    temporal.setMode(Qgis.VectorTemporalMode.FeatureDateTimeStartAndEndFromFields)
    temporal.setStartField("time_from")
    temporal.setEndField("time_to")


def style_displacements_other(layer: QgsVectorLayer) -> None:
    """As the displacements of the default datum."""
    style_displacements(layer)


def style_frame_errors(layer: QgsVectorLayer) -> None:
    """Error of the frames as arrows on the displacements' scale: as targets, units and strips see it."""
    size = 'sqrt("de"^2+"dn"^2)'
    layer.setRenderer(
        rules(
            *(
                (title, f"\"known_by\" = '{kind}'", vector_symbol(colour, 0.6, '"de"', '"dn"', size, on_line=False, with_ellipse=True))
                for title, kind, colour in (
                    ("error as targets see it", "targets", BLUE),
                    ("difference of two epochs as units see it", "units", PURPLE),
                    ("strip against its epoch", "strips", GREY),
                )
            )
        )
    )
    layer.setMapTipTemplate(
        f'<b>[% "epoch" %]</b> [% round("along") %] m<br>{tip("de", "dn", "dh")} (e, n, h), sd {tip("sd_e", "sd_n", "sd_h")}'
    )


def style_stretches(layer: QgsVectorLayer) -> None:
    """Common motion of stretches as arrows, datum control, settlement as label."""
    size = 'sqrt("de"^2+"dn"^2)'
    layer.setRenderer(
        rules(
            *(
                (
                    title,
                    f"\"datum\" = 'control' and {test}",
                    vector_symbol(colour, 0.9, '"de"', '"dn"', size, on_line=False, with_ellipse=True),
                )
                for title, test, colour in (
                    ("moved as one", '"significant"', RED),
                    ("no common motion that could be told", 'not "significant"', GREY),
                )
            )
        )
    )
    text = stated("dh")
    layer.setLabeling(labels(f"if(\"datum\" = 'control' and \"significant\", {text}, '')", 300, 8))
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate(
        '<b>[% "epoch_from" %] – [% "epoch_to" %]</b>, datum [% "datum" %]<br>'
        f"{tip('de', 'dn', 'dh')} (e, n, h)<br>less than {tip('detectable')} cannot be told"
    )


def style_control_residuals(layer: QgsVectorLayer) -> None:
    """Residual vectors at control points."""
    size = 'sqrt("ve"^2+"vn"^2)'
    entries = []
    for label, condition, colour in (
        ("used", '"used"', GREEN),
        ("disturbed, not used", '"outlier" and not "used"', RED),
        ("not used", 'not "used" and not "outlier"', GREY),
    ):
        marker = QgsMarkerSymbol.createSimple(
            {"name": "triangle", "size": "2.6", "color": "#ffffff", "outline_color": colour, "outline_width": "0.5"}
        )
        symbol = vector_symbol(colour, 0.6, '"ve"', '"vn"', size, on_line=False, with_ellipse=False)
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
    text = stated("d_3d")
    layer.setLabeling(labels(f'if("epoch" = maximum("epoch"), "point_id" || \' \' || {text}, \'\')', 150, 7, PURPLE))
    layer.setLabelsEnabled(True)
    layer.setRenderer3D(sphere(PURPLE, 0.08))


def main() -> None:
    """Write all styles."""
    sys.path.insert(0, str(ROOT / "scripts"))
    import engine

    engine.load_package()
    application = QgsApplication([], False)
    application.initQgis()
    for name in (
        "units",
        "unit_outlines",
        "unit_surfaces",
        "placement",
        "gaps",
        "feature_points",
        "displacements",
        "displacements_other",
        "frame_errors",
        "stretches",
        "control_residuals",
        "check_residuals",
        "epochs",
        "reviews",
        "unit_edits",
        "manual_picks",
        "plan_deviations",
        "plan_unmatched",
        "profile_deviations",
        "sections",
        "crest",
        "settlement",
    ):
        message, done = styled(name).saveNamedStyle(str(STYLES / f"{name}.qml"), CATEGORIES)
        if not done:
            raise SystemExit(message)
        written = STYLES / f"{name}.qml"
        # without a family the font of the user's own QGIS is taken; that of this machine may be nowhere else
        written.write_text(re.sub(r' fontFamily="[^"]*"', "", written.read_text(encoding="utf-8")), encoding="utf-8")
    write_page()
    application.exitQgis()


def write_page() -> None:
    """Write the template of the page to print, without fonts and paths of this machine."""
    from tetratrack.plugin.print_map import TEMPLATE, build_page

    layout = build_page(QgsProject())
    TEMPLATE.parent.mkdir(exist_ok=True)
    if not layout.saveAsTemplate(str(TEMPLATE), QgsReadWriteContext()):
        raise SystemExit(f"{TEMPLATE} cannot be written")
    text = re.sub(r' fontFamily="[^"]*"', "", TEMPLATE.read_text(encoding="utf-8"))
    TEMPLATE.write_text(re.sub(r' file="[^"]*NorthArrow', ' file="arrows/NorthArrow', text), encoding="utf-8")


if __name__ == "__main__":
    main()
