"""Every algorithm through Processing with the real engine on the tiny survey, and everything that can be wrong with its input."""

from __future__ import annotations

import json
import os
import subprocess
import time
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from qgis import processing
from qgis.core import (
    Qgis,
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QByteArray, Qt
from qgis.PyQt.QtGui import QImage, QPainter
from qgis.PyQt.QtSvg import QSvgRenderer
from tetratrack.algorithms.provider import ALGORITHMS, TetratrackProvider
from tetratrack.algorithms.support import engine as engine_support
from tetratrack.algorithms.support.field_titles import field_alias
from tetratrack.algorithms.support.inputs import epoch_time
from tetratrack.algorithms.support.layers import apply_style, has_style
from tetratrack.core.results.schema import LAYERS
from tetratrack.core.review.point_index import kept_survey

EPOCHS = ("2024-04-09", "2024-10-09")
UNIT = {"UNIT": "tetrapod", "HEIGHT": 2.3, "RADIUS": 0.60814, "GRADIENT": 0.1761, "LEG_LENGTH": 1.4812}
NAMES = [algorithm.ID for algorithm in ALGORITHMS]


def run(name: str, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> dict[str, Any]:
    """Run an algorithm by name."""
    return processing.run(f"tetratrack:{name}", parameters, context=context, feedback=feedback)


def epoch(tiny: Path, label: str) -> dict[str, Any]:
    """Parameters of an epoch of the tiny survey."""
    return {"TILES": str(tiny / "tiles" / label), "EPOCH": label, "CRS": "EPSG:32650"}


@pytest.fixture(scope="module")
def segmented(repository: Path) -> dict[str, Any]:
    """Units found in the first epoch; the chain starts from them."""
    tiny = repository / "tests" / "data" / "tiny"
    return processing.run("tetratrack:segmenttetrapods", {**epoch(tiny, EPOCHS[0]), **UNIT, "UNITS": "TEMPORARY_OUTPUT"})


@pytest.fixture(scope="module")
def fitted(repository: Path, segmented: dict[str, Any]) -> dict[str, Any]:
    """The same units, fitted."""
    tiny = repository / "tests" / "data" / "tiny"
    parameters = {**epoch(tiny, EPOCHS[0]), **UNIT, "INPUT": segmented["UNITS"], "UNITS": "TEMPORARY_OUTPUT"}
    return processing.run("tetratrack:fittetrapods", parameters)


@pytest.fixture(scope="module")
def monitored(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """All steps on the tiny survey, by survey.toml."""
    target = tmp_path_factory.mktemp("monitored") / "result.gpkg"
    survey = repository / "tests" / "data" / "tiny" / "survey.toml"
    return processing.run("tetratrack:monitorsurvey", {"SURVEY": str(survey), "OUTPUT": str(target)})


def test_all_algorithms_are_listed(provider: TetratrackProvider) -> None:
    assert len(NAMES) == 17
    assert sorted(a.name() for a in provider.algorithms()) == sorted(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_every_algorithm_explains_itself(name: str) -> None:
    algorithm: QgsProcessingAlgorithm = QgsApplication.processingRegistry().algorithmById(f"tetratrack:{name}")
    assert algorithm.displayName()
    assert algorithm.group()
    assert len(algorithm.tags()) >= 3
    assert not algorithm.icon().isNull()
    text = algorithm.shortHelpString()
    for definition in algorithm.parameterDefinitions():
        assert definition.help(), f"{name} {definition.name()} has no help"
        assert definition.help() in text
    assert len(algorithm.shortDescription()) > 40


def test_inspect_lists_tiles(tiny: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    found = run("inspecttiles", {"TILES": str(tiny / "tiles" / EPOCHS[0]), "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    layer: QgsVectorLayer = found["OUTPUT"]
    assert layer.featureCount() == found["TILE_COUNT"] == 2
    assert layer.crs().authid() == found["TILES_CRS"] == "EPSG:32650"
    assert found["POINT_COUNT"] == sum(feature["points"] for feature in layer.getFeatures())
    assert found["DENSITY"] > 50


def test_register_finds_the_transformation(
    tiny: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    parameters = {
        **epoch(tiny, EPOCHS[0]),
        "CONTROL": str(tiny / f"control_{EPOCHS[0]}.csv"),
        "TARGETS": str(tiny / f"targets_{EPOCHS[0]}.csv"),
        "RESIDUALS": "TEMPORARY_OUTPUT",
        "OUTPUT": str(tmp_path / "registration.gpkg"),
    }
    found = run("registertocontrol", parameters, context, feedback)
    assert found["RMSE"] < 0.02
    assert found["RESIDUALS"].wkbType() == Qgis.WkbType.PointZ
    assert found["RESIDUALS"].featureCount() >= 4
    (row,) = QgsVectorLayer(f"{found['OUTPUT']}|layername=epochs", "epochs", "ogr").getFeatures()
    assert "covariance" in json.loads(row["transformation"])


def test_steps_feed_each_other(fitted: dict[str, Any], segmented: dict[str, Any]) -> None:
    layer: QgsVectorLayer = fitted["UNITS"]
    assert fitted["UNITS_FITTED"] == segmented["UNITS_FOUND"] == layer.featureCount() == 4
    assert QgsWkbTypes.displayString(layer.wkbType()) == "PointZ"
    assert [field.name() for field in layer.fields()] == list(LAYERS["units"].names)
    assert layer.fields().field("epoch_time").typeName().lower().startswith("datetime")
    best = max(layer.getFeatures(), key=lambda feature: feature["coverage"])
    assert 0 < best["sd_e"] < 0.02


def test_feature_points_follow_from_units(fitted: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    found = run("extractfeaturepoints", {"INPUT": fitted["UNITS"], "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    assert found["POINT_COUNT"] == 5 * fitted["UNITS_FITTED"]
    assert {feature["feature"] for feature in found["OUTPUT"].getFeatures()} == {"centre", "f123", "f124", "f134", "f234"}
    parameters = {"INPUT": fitted["UNITS"], "END_DISCS": True, "LEG_LENGTH": 1.5, "OUTPUT": "TEMPORARY_OUTPUT"}
    more = run("extractfeaturepoints", parameters, context, feedback)
    discs = [feature for feature in more["OUTPUT"].getFeatures() if feature["feature"] in ("d1", "d2", "d3", "d4")]
    assert len(discs) == 4 * fitted["UNITS_FITTED"]
    places = {(f["unit_id"], f["feature"]): next(f.geometry().vertices()) for f in more["OUTPUT"].getFeatures()}
    assert [places[f["unit_id"], "centre"].distance3D(places[f["unit_id"], f["feature"]]) for f in discs] == pytest.approx(
        [1.5] * len(discs), abs=1e-6
    )
    assert more["POINT_COUNT"] == found["POINT_COUNT"] + len(discs)


def test_displacements_and_check_points_by_steps(
    tiny: Path, tmp_path: Path, fitted: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    """Two epochs fitted, tracked with their registrations, and the later one compared with its check points."""
    found = run("segmenttetrapods", {**epoch(tiny, EPOCHS[1]), **UNIT, "UNITS": "TEMPORARY_OUTPUT"}, context, feedback)
    parameters = {**epoch(tiny, EPOCHS[1]), **UNIT, "INPUT": found["UNITS"], "UNITS": "TEMPORARY_OUTPUT"}
    later = run("fittetrapods", parameters, context, feedback)
    registrations = []
    for label in EPOCHS:
        parameters = {
            **epoch(tiny, label),
            "CONTROL": str(tiny / f"control_{label}.csv"),
            "TARGETS": str(tiny / f"targets_{label}.csv"),
            "RESIDUALS": "TEMPORARY_OUTPUT",
            "OUTPUT": str(tmp_path / f"registration_{label}.gpkg"),
        }
        registrations.append(run("registertocontrol", parameters, context, feedback)["OUTPUT"])
    parameters = {
        "INPUT": [fitted["UNITS"], later["UNITS"]],
        "REGISTRATIONS": registrations,
        "UNITS": "TEMPORARY_OUTPUT",
        "OUTPUT": "TEMPORARY_OUTPUT",
    }
    tracked = run("trackdisplacements", parameters, context, feedback)
    assert tracked["UNITS_MOVED"] == 1
    assert tracked["OUTPUT"].wkbType() == Qgis.WkbType.LineStringZ
    assert tracked["OUTPUT"].featureCount() == 4 * 5
    features = run("extractfeaturepoints", {"INPUT": tracked["UNITS"], "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    only = processing.run(
        "native:extractbyattribute",
        {"INPUT": features["OUTPUT"], "FIELD": "epoch", "OPERATOR": 0, "VALUE": EPOCHS[1], "OUTPUT": "TEMPORARY_OUTPUT"},
    )["OUTPUT"]
    parameters = {"INPUT": only, "CHECK": str(tiny / f"check_{EPOCHS[1]}.csv"), "OUTPUT": "TEMPORARY_OUTPUT"}
    checked = run("validatesurvey", parameters, context, feedback)
    assert checked["POINT_COUNT"] > 0
    assert checked["RMSE"] < 0.05


def test_views_become_one_cloud(tiny: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    views = sorted(str(path) for path in (tiny / "tiles").glob("*/*_00.laz"))
    found = run("registerviews", {"TILES": views, "VOXEL": 0.1, "OUTPUT": str(tmp_path / "cloud.laz")}, context, feedback)
    assert found["VIEW_COUNT"] == 2
    assert 0 < found["RMSE"] < 0.1
    assert (tmp_path / "cloud.laz").stat().st_size > 10_000


def test_simulated_survey_can_be_inspected(tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    parameters = {"UNIT": "tetrapod 8 t", "UNITS": 4, "EPOCHS": 1, "OUTPUT": str(tmp_path / "site")}
    found = run("simulatesurvey", parameters, context, feedback)
    assert Path(found["SURVEY"]).is_file()
    tiles = run(
        "inspecttiles", {"TILES": [str(p) for p in Path(found["OUTPUT"]).rglob("*.laz")], "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback
    )
    assert tiles["POINT_COUNT"] > 1000


def test_report_of_a_result(
    tmp_path: Path, monitored: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    found = run("displacementreport", {"INPUT": monitored["OUTPUT"], "OUTPUT": str(tmp_path / "report.html")}, context, feedback)
    text = Path(found["OUTPUT"]).read_text(encoding="utf-8")
    assert "<html" in text
    assert "U0001" in text
    assert "≥ 0.61 m" in text


def test_report_with_bands_sections_and_design(
    tmp_path: Path, monitored: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    units = QgsVectorLayer(f"{monitored['OUTPUT']}|layername=units", "units", "ogr")
    latest = next(f for f in units.getFeatures() if f["epoch"] == EPOCHS[1] and f.hasGeometry())
    place = next(latest.geometry().vertices())
    plan = tmp_path / "plan.csv"
    plan.write_text(f"unit_id,easting,northing,height\n{latest['unit_id']},{place.x() - 0.2},{place.y()},{place.z()}\n", encoding="utf-8")
    parameters = {"INPUT": monitored["OUTPUT"], "BANDS": 1, "STEP": 3, "PLAN": str(plan), "TOLERANCE": 0.1}
    found = run("displacementreport", parameters | {"OUTPUT": str(tmp_path / "report.html")}, context, feedback)
    text = Path(found["OUTPUT"]).read_text(encoding="utf-8")
    assert "≥ 0.10 m" in text
    assert "≥ 0.61 m" not in text
    assert "As-built against design" in text


def test_model_of_a_result(
    tmp_path: Path, monitored: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    parameters = {"INPUT": monitored["OUTPUT"], "OUTPUT": str(tmp_path / "model.json")}
    latest = json.loads(Path(run("exportmodel", parameters, context, feedback)["OUTPUT"]).read_text(encoding="utf-8"))
    earlier = json.loads(
        Path(run("exportmodel", parameters | {"EPOCH": "2024-04-09"}, context, feedback)["OUTPUT"]).read_text(encoding="utf-8")
    )
    assert [model["epoch"] for model in (latest, earlier)] == ["2024-10-09", "2024-04-09"]
    assert len(latest["units"]) == 4
    with pytest.raises(QgsProcessingException, match="has no units of an epoch"):
        run("exportmodel", parameters | {"EPOCH": "x"}, context, feedback)


def test_a_result_against_its_own_poses_and_its_sections(
    tmp_path: Path, monitored: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    units = QgsVectorLayer(f"{monitored['OUTPUT']}|layername=units", "units", "ogr")
    lines = ["unit_id,easting,northing,height"]
    for feature in units.getFeatures():
        if feature["epoch"] == EPOCHS[1] and feature.hasGeometry():
            place = next(feature.geometry().vertices())
            lines.append(f"{feature['unit_id']},{place.x() - 0.2},{place.y()},{place.z()}")
    plan = tmp_path / "plan.csv"
    plan.write_text("\n".join(lines), encoding="utf-8")
    parameters = {"INPUT": monitored["OUTPUT"], "PLAN": str(plan), "TOLERANCE": 0.1, "OUTPUT": str(tmp_path / "deviations.gpkg")}
    found = run("comparedesign", parameters, context, feedback)
    assert (found["OUTSIDE"], found["MISSING"]) == (4, 0)
    deviations = QgsVectorLayer(f"{found['OUTPUT']}|layername=plan_deviations", "deviations", "ogr")
    assert [feature["de"] for feature in deviations.getFeatures()] == pytest.approx([0.2] * 4, abs=1e-3)
    sections = run("crosssections", {"INPUT": monitored["OUTPUT"], "STEP": 3, "OUTPUT": str(tmp_path / "sections.gpkg")}, context, feedback)
    assert QgsVectorLayer(f"{sections['OUTPUT']}|layername=sections", "sections", "ogr").featureCount() > 4
    with pytest.raises(QgsProcessingException, match="no point index"):
        run("residualpoints", {"INPUT": monitored["OUTPUT"], "OUTPUT": str(tmp_path / "points.laz")}, context, feedback)


def test_plan_states_numbers(context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    coarse = run("planningdetectability", {"UNIT": "tetrapod 8 t", "DENSITY": 50}, context, feedback)
    fine = run("planningdetectability", {"UNIT": "tetrapod 8 t", "DENSITY": 500}, context, feedback)
    assert 0 < fine["DETECTABLE_WORST"] < coarse["DETECTABLE_WORST"] < 1


def test_plan_is_drawn_as_a_chart(context: QgsProcessingContext, feedback: QgsProcessingFeedback, tmp_path: Path) -> None:
    chart = tmp_path / "plan.html"
    found = run("planningdetectability", {"UNIT": "tetrapod 8 t", "DENSITY": 200, "CHART": str(chart)}, context, feedback)
    text = chart.read_text(encoding="utf-8")
    assert found["CHART"] == str(chart)
    assert text.count("<polyline") == 3
    assert f"{found['DETECTABLE_WORST']:.3f} m" in text
    drawing = QSvgRenderer(QByteArray(text[text.index("<svg") : text.index("</svg>") + 6].encode()))
    assert drawing.isValid()
    if os.environ.get("TETRATRACK_PICTURES"):
        image = QImage(drawing.defaultSize(), QImage.Format.Format_RGB32)
        image.fill(Qt.GlobalColor.white)
        painter = QPainter(image)
        drawing.render(painter)
        painter.end()
        image.save(str(Path(os.environ["TETRATRACK_PICTURES"]) / "plan.png"))


def test_fields_are_named_rounded_and_technical_ones_hidden(monitored: dict[str, Any]) -> None:
    """In every table and identify window."""
    for name, layer in LAYERS.items():
        opened = QgsVectorLayer(f"{monitored['OUTPUT']}|layername={name}", name, "ogr")
        apply_style(opened, name)
        if not has_style(name):
            continue
        for field in layer.fields:
            index = opened.fields().lookupField(field.name)
            alias, setup = opened.attributeAlias(index), opened.editorWidgetSetup(index)
            if setup.type() == "Hidden":
                continue
            assert alias == field_alias(field), (name, field.name)
            assert alias != field.name, (name, field.name)
            assert field.type != "real" or setup.config()["Precision"] <= 5, (name, field.name)
        columns = {column.name: column.hidden for column in opened.attributeTableConfig().columns()}
        assert not [name for name in ("covariance", "settings", "qx", "cov_en") if columns.get(name) is False], name


def test_result_holds_every_layer_with_its_style(monitored: dict[str, Any]) -> None:
    assert monitored["UNITS_FOUND"] == 4
    for name, layer in LAYERS.items():
        opened = QgsVectorLayer(f"{monitored['OUTPUT']}|layername={name}", name, "ogr")
        assert opened.isValid(), name
        assert set(layer.names) <= set(opened.fields().names()), name
    units = QgsVectorLayer(f"{monitored['OUTPUT']}|layername=units", "units", "ogr")
    assert units.renderer().type() == "RuleRenderer"
    # QGIS makes the temporal properties only after the style was read: a script reads it again, the plugin's loader does so by itself
    for layer in (units, arrows := QgsVectorLayer(f"{monitored['OUTPUT']}|layername=displacements", "displacements", "ogr")):
        assert layer.loadDefaultStyle()[1]
        assert layer.temporalProperties().isActive()
    assert units.temporalProperties().startField() == "epoch_time"
    assert units.elevationProperties().clamping() == Qgis.AltitudeClamping.Absolute
    # names stand once a unit, on its outline
    outlines = QgsVectorLayer(f"{monitored['OUTPUT']}|layername=unit_outlines", "unit_outlines", "ogr")
    assert outlines.loadDefaultStyle()[1]
    assert outlines.labelsEnabled()
    assert not units.labelsEnabled()
    assert arrows.temporalProperties().startField() == "time_from"
    assert arrows.temporalProperties().endField() == "time_to"


def test_result_loads_as_a_styled_group(
    repository: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the dialog does it: the algorithm names the layers, Processing loads them, post-processors style them."""
    from processing.gui import Postprocessing
    from processing.gui.Postprocessing import handleAlgorithmResults

    # QGIS 3.44 hands the view of the layer tree to C++, which takes no stand-in
    monkeypatch.setattr(Postprocessing, "iface", None)

    algorithm = QgsApplication.processingRegistry().createAlgorithmById("tetratrack:monitorsurvey")
    survey = repository / "tests" / "data" / "tiny" / "survey.toml"
    results, done = algorithm.run({"SURVEY": str(survey), "OUTPUT": str(tmp_path / "north.gpkg")}, context, feedback)
    assert done, results
    handleAlgorithmResults(algorithm, context, feedback, parameters={})
    project = context.project()
    group = project.layerTreeRoot().findGroup("north")
    titles = [node.name() for node in group.findLayers()]
    assert {"Units", "Feature points", "Control residuals"} <= set(titles)
    assert any(title.startswith("Relief 2024-04-09") for title in titles), "no shaded relief"
    relief = project.mapLayersByName("Relief 2024-10-09")[0]
    assert (relief.renderer().type(), relief.renderer().alphaBand()) == ("singlebandgray", 2), "grey, and clear where there are no points"
    (arrows,) = project.mapLayersByName("Displacements")
    labels = [rule.label() for rule in arrows.renderer().rootRule().descendants()]
    assert any("0.050 m" in label for label in labels), "in the project's unit"
    units = project.mapLayersByName("Units")[0]
    assert units.renderer().type() == "RuleRenderer"
    assert units.temporalProperties().isActive()
    assert units.metadata().title() == "Units"


def test_epochs_as_rows_give_the_same_result(
    tiny: Path, tmp_path: Path, monitored: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    rows: list[str] = []
    for label, stamp in zip(EPOCHS, ("2024-04-09T02:30:00Z", "2024-10-09T03:37:00Z")):
        tables = [str(tiny / f"{kind}_{label}.csv") for kind in ("control", "targets", "check")]
        rows += [label, stamp, str(tiny / "tiles" / label), *tables]
    parameters = {"EPOCHS": rows, **UNIT, "OUTPUT": str(tmp_path / "rows.gpkg"), "UNITS": "TEMPORARY_OUTPUT", "BACKDROP": False}
    found = run("monitorsurvey", parameters, context, feedback)
    assert centres(found["OUTPUT"]) == pytest.approx(centres(monitored["OUTPUT"]), abs=1e-6)
    assert found["UNITS"].featureCount() == len(centres(monitored["OUTPUT"])) // 3


def centres(path: str) -> list[float]:
    """Coordinates of all units, in order of epoch and id."""
    layer = QgsVectorLayer(f"{path}|layername=units", "units", "ogr")
    rows = sorted((f for f in layer.getFeatures() if f.hasGeometry()), key=lambda f: (f["epoch"], f["unit_id"]))
    return [value for f in rows for value in (f.geometry().constGet().x(), f.geometry().constGet().y(), f.geometry().constGet().z())]


def test_toolbox_and_command_give_the_same_numbers(repository: Path, tiny: Path, tmp_path: Path, monitored: dict[str, Any]) -> None:
    command = [str(repository / ".venv" / "bin" / "tetratrack"), "run", str(tiny / "survey.toml"), "-o", str(tmp_path / "r.gpkg"), "-q"]
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "PROJ_", "GDAL_"))}
    subprocess.run(command, check=True, env=environment, capture_output=True)
    assert centres(str(tmp_path / "r.gpkg")) == pytest.approx(centres(monitored["OUTPUT"]), abs=1e-6)


@pytest.fixture(scope="module")
def qgis_process(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str, dict[str, Any]], dict[str, Any]]:
    """qgis_process with the plugin enabled in a clean profile, under a folder of another name; JSON in, JSON out."""
    profile = tmp_path_factory.mktemp("profile")
    plugins = profile / "profiles" / "default" / "python" / "plugins"
    plugins.mkdir(parents=True)
    os.symlink(repository, plugins / "breakwater_watch")
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        "QGIS_CUSTOM_CONFIG_PATH": str(profile),
        "TETRATRACK_ENGINE_PYTHON": str(repository / ".venv" / "bin" / "python"),
        "QGIS_OPTS": "",
    }
    subprocess.run(["qgis_process", "plugins", "enable", "breakwater_watch"], env=environment, check=True, capture_output=True)

    def call(algorithm: str, inputs: dict[str, Any]) -> dict[str, Any]:
        command = ["qgis_process", "run", algorithm, "-"]
        text = json.dumps({"inputs": inputs})
        done = subprocess.run(command, env=environment, input=text, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr[-3000:]
        return json.loads(done.stdout)["results"]

    return call


def test_qgis_process_reads_and_writes_json(
    qgis_process: Callable[[str, dict[str, Any]], dict[str, Any]], tiny: Path, tmp_path: Path
) -> None:
    inputs = {"TILES": [str(tiny / "tiles" / EPOCHS[0])], "OUTPUT": str(tmp_path / "index.gpkg")}
    assert qgis_process("tetratrack:inspecttiles", inputs)["TILE_COUNT"] == 2


def test_shipped_model_runs_the_chain(
    qgis_process: Callable[[str, dict[str, Any]], dict[str, Any]], repository: Path, tiny: Path, tmp_path: Path
) -> None:
    inputs = {
        "TILES": [str(path) for path in sorted((tiny / "tiles" / EPOCHS[0]).glob("*.laz"))],
        "UNIT": "tetrapod",
        "HEIGHT": 2.3,
        "EPOCH": EPOCHS[0],
        "CRS": "EPSG:32650",
        "CHECK": str(tiny / f"check_{EPOCHS[0]}.csv"),
        "units": str(tmp_path / "units.gpkg"),
        "feature_points": str(tmp_path / "feature_points.gpkg"),
        "check_residuals": str(tmp_path / "check_residuals.gpkg"),
    }
    qgis_process(str(repository / "algorithms" / "stepsofoneepoch.model3"), inputs)
    counts = {name: QgsVectorLayer(str(tmp_path / f"{name}.gpkg"), name, "ogr").featureCount() for name in ("units", "feature_points")}
    assert counts == {"units": 4, "feature_points": 20}
    assert QgsVectorLayer(str(tmp_path / "check_residuals.gpkg"), "check", "ogr").featureCount() > 0


@pytest.mark.parametrize("grace", [engine_support.CANCEL_GRACE_MILLISECONDS, 0], ids=["heeded", "killed"])
def test_cancel_leaves_nothing(
    grace: int,
    tmp_path: Path,
    repository: Path,
    context: QgsProcessingContext,
    feedback: QgsProcessingFeedback,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(engine_support, "CANCEL_GRACE_MILLISECONDS", grace)
    started = time.monotonic()
    original = feedback.isCanceled
    feedback.isCanceled = lambda: time.monotonic() - started > 2.0 or original()
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("tetratrack:monitorsurvey")
    survey = repository / "tests" / "data" / "tiny" / "survey.toml"
    results, done = algorithm.run({"SURVEY": str(survey), "OUTPUT": str(tmp_path / "result.gpkg")}, context, feedback)
    assert time.monotonic() - started < 4.0
    assert done
    assert results.get("UNITS_FOUND") is None
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", NAMES)
def test_missing_engine_is_said_in_one_sentence(name: str, no_engine: None) -> None:
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"tetratrack:{name}")
    possible, message = algorithm.canExecute()
    assert not possible
    assert "Options" in message


def test_missing_engine_is_an_error_under_qgis_process_too(
    no_engine: None, tiny: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("tetratrack:inspecttiles")
    parameters = {"TILES": str(tiny / "tiles" / EPOCHS[0]), "OUTPUT": "TEMPORARY_OUTPUT"}
    algorithm.prepare(parameters, context, feedback)
    with pytest.raises(QgsProcessingException, match="not installed"):
        algorithm.runPrepared(parameters, context, feedback)


@pytest.mark.parametrize(
    ("name", "parameters", "words"),
    [
        ("segmenttetrapods", {"UNIT": "tetrapod"}, "height H"),
        ("segmenttetrapods", {"UNIT": "dolos"}, "must be tetrapod"),
        ("segmenttetrapods", {**UNIT, "RADIUS": 2.0}, "smaller than half"),
        ("segmenttetrapods", {**UNIT, "CRS": "EPSG:4326"}, "geographic"),
        ("planningdetectability", {"SIGNIFICANCE": 0.4, "POWER": 0.3}, "below the power"),
        ("displacementreport", {"INPUT": "result.gpkg", "FROM": "2024-04-09"}, "both epochs"),
        ("monitorsurvey", {}, "survey.toml"),
        ("monitorsurvey", {"EPOCHS": ["a", "b"], **UNIT}, "six columns"),
    ],
)
def test_parameters_that_do_not_go_together(
    name: str, parameters: dict[str, Any], words: str, tiny: Path, tmp_path: Path, context: QgsProcessingContext
) -> None:
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"tetratrack:{name}")
    given = {"TILES": str(tiny / "tiles" / EPOCHS[0]), "UNITS": "TEMPORARY_OUTPUT", "OUTPUT": str(tmp_path / "r.gpkg"), **parameters}
    accepted, message = algorithm.checkParameterValues(given, context)
    assert not accepted
    assert words in message


def failure(name: str, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> str:
    """Message with which an algorithm refuses."""
    with pytest.raises(QgsProcessingException) as caught:
        run(name, parameters, context, feedback)
    return str(caught.value)


def test_missing_tiles_are_named(tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("tetratrack:inspecttiles")
    parameters = {"TILES": str(tmp_path / "absent.laz"), "OUTPUT": "TEMPORARY_OUTPUT"}
    with pytest.raises(QgsProcessingException, match=r"absent\.laz"):
        algorithm.prepareAlgorithm(parameters, context, feedback)


def test_a_file_that_is_no_cloud_is_named(tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    (tmp_path / "notes.laz").write_text("not a point cloud")
    message = failure("inspecttiles", {"TILES": str(tmp_path / "notes.laz"), "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    assert "notes.laz" in message
    assert "Traceback" not in message


def test_wrong_crs_is_refused(tiny: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    parameters = {**epoch(tiny, EPOCHS[0]), **UNIT, "CRS": "EPSG:2229", "UNITS": "TEMPORARY_OUTPUT"}
    message = failure("segmenttetrapods", parameters, context, feedback)
    assert "2229" in message
    assert "metre" in message


def test_output_that_cannot_be_written_is_said(
    repository: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    survey = repository / "tests" / "data" / "tiny" / "survey.toml"
    message = failure("monitorsurvey", {"SURVEY": str(survey), "OUTPUT": str(blocked / "result.gpkg")}, context, feedback)
    assert "result.gpkg" in message or "file" in message
    assert "Traceback" not in message


def test_layer_without_the_fields_is_named(context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    layer = QgsVectorLayer("PointZ?crs=EPSG:32650&field=name:string", "trees", "memory")
    message = failure("extractfeaturepoints", {"INPUT": layer, "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    assert "trees" in message
    assert "unit_id" in message


def test_a_crash_of_the_engine_is_a_message(
    fake_engine: Callable[[str], Path], tiny: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    fake_engine("os.kill(os.getpid(), signal.SIGKILL)")
    message = failure("inspecttiles", {"TILES": str(tiny / "tiles" / EPOCHS[0]), "OUTPUT": "TEMPORARY_OUTPUT"}, context, feedback)
    assert "ended unexpectedly" in message


def test_stable_areas_reach_the_survey_file_in_their_own_crs(tmp_path: Path, context: QgsProcessingContext) -> None:
    import tomllib

    from tetratrack.algorithms.support.inputs import EpochInput, SurveyInput, write_polygons

    layer = QgsVectorLayer("Polygon?crs=EPSG:32651", "crown wall", "memory")
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromWkt("POLYGON((0 0, 20 0, 20 5, 0 5, 0 0))"))
    layer.dataProvider().addFeatures([feature])
    written = write_polygons(QgsProcessingFeatureSource(layer, context), tmp_path / "stable_areas.gpkg", context)
    again = QgsVectorLayer(str(written), "again", "ogr")
    assert again.crs().authid() == "EPSG:32651"
    assert next(again.getFeatures()).geometry().area() == pytest.approx(100)
    epoch = EpochInput("a", "2024-01-01T00:00:00Z", ["a.laz"])
    path, _ = SurveyInput("EPSG:32652", {"type": "tetrapod 8 t"}, [epoch], stable_areas=str(written)).write(tmp_path)
    assert tomllib.loads(path.read_text(encoding="utf-8"))["survey"]["stable_areas"] == str(written)


@pytest.mark.parametrize(("number", "choice"), [(0, None), (1, "rigid"), (2, "elastic")])
def test_the_choice_of_frame_reaches_the_survey_file(
    number: int, choice: str | None, tiny: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    import tomllib

    from tetratrack.algorithms.monitorsurvey import MonitorSurvey
    from tetratrack.algorithms.support.inputs import FRAME, FRAMES

    algorithm = MonitorSurvey().create()
    definition = algorithm.parameterDefinition(FRAME)
    assert definition is not None
    assert len(definition.options()) == len(FRAMES)
    assert definition.defaultValue() == 0
    rows = [value for label in EPOCHS for value in (label, f"{label}T00:00", str(tiny / "tiles" / label), "", "", "")]
    parameters = {"EPOCHS": rows, "UNIT": "tetrapod", "HEIGHT": 2.3, "CRS": "EPSG:32650", FRAME: number, "OUTPUT": str(tmp_path / "r.gpkg")}
    assert algorithm.prepareAlgorithm(parameters, context, feedback)
    path = algorithm.survey_of_rows(tmp_path, parameters, context, feedback)
    assert tomllib.loads(path.read_text(encoding="utf-8"))["survey"].get("frame") == choice


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("2025-03-14", "2025-03-14T00:00:00Z"),
        ("2025-03-14T02:30", "2025-03-14T02:30:00Z"),
        ("2025-03-14 02:30", "2025-03-14T02:30:00Z"),
        (" 2025-03-14T02:30:15Z", "2025-03-14T02:30:15Z"),
        ("2025-03-14T11:30+09:00", "2025-03-14T02:30:00Z"),
        ("2025-03-14 11:30:00 +09:00", "2025-03-14T02:30:00Z"),
        ("2025/03/14 02:30 Z", "2025-03-14T02:30:00Z"),
        ("2025-03-14T02:30:00.250", "2025-03-14T02:30:00.250Z"),
    ],
)
def test_times_as_users_write_them(written: str, meant: str) -> None:
    assert epoch_time(written) == meant


def rows_of(tiny: Path, *labels_and_times: tuple[str, str], control: str = "") -> list[str]:
    """Rows of the table of epochs over the tiny survey's tiles."""
    return [cell for label, time in labels_and_times for cell in (label, time, str(tiny / "tiles" / EPOCHS[0]), control, control, "")]


def test_a_time_that_is_none_is_named_with_its_row(tiny: Path, context: QgsProcessingContext) -> None:
    algorithm = QgsApplication.processingRegistry().algorithmById("tetratrack:monitorsurvey").create()
    rows = rows_of(tiny, ("spring", "2025-03-14"), ("autumn", "14 October"))
    good, reason = algorithm.checkParameterValues({"EPOCHS": rows, **UNIT, "OUTPUT": "result.gpkg"}, context)
    assert not good
    assert "Epoch autumn (row 2)" in reason
    assert "14 October" in reason
    assert "2025-03-14T02:30" in reason


def test_messages_name_rows_and_tables_never_files_made_for_the_engine(
    tiny: Path, tmp_path: Path, context: QgsProcessingContext, feedback: Any, fake_engine: Callable[[str], Path]
) -> None:
    table = tmp_path / "crown wall.csv"
    table.write_text("point_id,easting,northing,height,x,y,z\nA,1,2,3,1,2,3\n")
    kept = tmp_path / "survey.toml"
    fake_engine(f"""
        survey = next(a for a in arguments if a.endswith("survey.toml"))
        text = open(survey).read()
        open({str(kept)!r}, "w").write(text)
        line = 1 + max(n for n, found in enumerate(text.splitlines()) if found.startswith("label"))
        control = os.path.join(os.path.dirname(survey), "control_1.csv")
        say(event="log", level="warning", message=f"{{control}}, line 2, field sd_e: is large")
        say(event="error", message=f"{{survey}}, line {{line}}, section epoch: label a belongs to two epochs. Give every epoch its own.")
        sys.exit(2)
    """)
    rows = rows_of(tiny, ("a", "2025-03-14T02:30"), ("a", "2025-10-14T11:30+09:00"), control=str(table))
    parameters = {"EPOCHS": rows, **UNIT, "CRS": "EPSG:32650", "OUTPUT": str(tmp_path / "result.gpkg")}
    with pytest.raises(QgsProcessingException) as caught:
        run("monitorsurvey", parameters, context, feedback)
    assert str(caught.value) == "Epoch a (row 2): label a belongs to two epochs. Give every epoch its own."
    assert feedback.warnings == ["Epoch a (row 2), crown wall, row 1, field sd_e: is large"]
    stated = tomllib.loads(kept.read_text())
    assert [epoch["time"].isoformat() for epoch in stated["epoch"]] == ["2025-03-14T02:30:00+00:00", "2025-10-14T02:30:00+00:00"]
    assert stated["epoch"][1]["control"] == "control_1.csv"
    assert not (tmp_path / "result_survey").exists(), "a run that failed leaves nothing"


def test_the_survey_of_a_dialog_is_kept_beside_its_result(
    tiny: Path,
    tmp_path: Path,
    context: QgsProcessingContext,
    feedback: QgsProcessingFeedback,
    fake_engine: Callable[[str], Path],
    monitored: dict[str, Any],
) -> None:
    fake_engine(f"""
        import shutil
        if "run" in arguments:
            shutil.copy({monitored["OUTPUT"]!r}, arguments[arguments.index("--output") + 1])
        say(event="result", outputs={{"units": 4, "moved": 1, "check_rmse": None, "files": [], "epochs": []}})
    """)
    table = str(tiny / f"control_{EPOCHS[0]}.csv")
    rows = rows_of(tiny, ("a", "2025-03-14"), control="")
    rows[3], rows[4] = table, str(tiny / f"targets_{EPOCHS[0]}.csv")
    target = tmp_path / "north.gpkg"
    run("monitorsurvey", {"EPOCHS": rows, **UNIT, "CRS": "EPSG:32650", "OUTPUT": str(target), "LOAD": False}, context, feedback)
    stated = tomllib.loads(kept_survey(target).read_text())
    assert (kept_survey(target).parent / stated["epoch"][0]["control"]).read_text().startswith("point_id")
    assert all(Path(tile).is_file() for tile in stated["epoch"][0]["tiles"])


def test_a_folder_becomes_a_survey(tiny: Path, tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> None:
    target = tmp_path / "survey.toml"
    found = run("newsurvey", {"FOLDER": str(tiny / "tiles"), "HEIGHT": 2.3, "OUTPUT": str(target)}, context, feedback)
    assert found["OUTPUT"] == str(target)
    text = target.read_text(encoding="utf-8")
    assert 'crs = "EPSG:32650"' in text
    assert text.count("[[epoch]]") == 2


def test_a_folder_of_ply_becomes_a_survey_once_its_crs_is_given(
    tmp_path: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    head = "ply\nformat ascii 1.0\nelement vertex 400\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
    places = "".join(f"{500000 + 0.2 * (k % 20):.3f} {3500000 + 0.2 * (k // 20):.3f} {0.01 * (k % 7):.3f}\n" for k in range(400))
    for day in EPOCHS:
        (tmp_path / day).mkdir()
        (tmp_path / day / "wall.PLY").write_text(head + places)
    target = tmp_path / "survey.toml"
    parameters = {"FOLDER": str(tmp_path), "HEIGHT": 2.3, "CRS": "EPSG:32650", "OUTPUT": str(target)}
    run("newsurvey", parameters, context, feedback)
    drafted = tomllib.loads(target.read_text(encoding="utf-8"))
    assert [(found["label"], found["tiles"], found["undeclared_crs"]) for found in drafted["epoch"]] == [
        (day, f"{day}/wall.PLY", "EPSG:32650") for day in EPOCHS
    ]


@pytest.mark.parametrize(("algorithm", "names"), [("comparedesign", ("PLAN", "PROFILE")), ("crosssections", ("PROFILE",))])
def test_plans_and_profiles_can_be_looked_for(algorithm: str, names: tuple[str, ...]) -> None:
    """A button beside the field, and layers in files as before."""
    found = QgsApplication.processingRegistry().algorithmById(f"tetratrack:{algorithm}")
    for name in names:
        definition = found.parameterDefinition(name)
        assert definition.type() == "file"
        assert all(definition.checkValueIsAcceptable(value) for value in (None, "plan.csv", "design.dxf", "plan.gpkg|layername=plan"))
