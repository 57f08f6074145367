"""Every exported model opened again by a library that did not write it, and compared with the poses of the result to 1 mm."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pytest
from synthetic_result import LEG_LENGTH, SyntheticUnit, make_units, write_result
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.run_options import RunOptions
from tetratrack.core.pipeline.whole_survey import run_survey
from tetratrack.core.report.model_export import ENDINGS, write_model
from tetratrack.core.results.geopackage_reader import Row, read_layer_rows

MILLIMETRE = 1e-3
REAL = pytest.param("uav", marks=[pytest.mark.shared_data, pytest.mark.slow])


@pytest.fixture(scope="module", params=["synthetic", REAL])
def result(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A result whose units are known, and that of a whole run on a sample survey."""
    path = tmp_path_factory.mktemp("models") / "result.gpkg"
    if request.param == "uav":
        survey = read_survey(request.getfixturevalue("shared_data") / "uav" / "survey.toml")
        run_survey(survey, path, RunOptions(workers=1), Feedback())
        return path
    units = make_units(30, 3)
    # a name with a quote, white space and letters beyond ASCII must survive every format
    first = units[0]
    units[0] = SyntheticUnit("é 'ブロック' 1", "stable", first.centres, first.quaternions)
    write_result(path, units=units)
    return path


def _latest(result: Path) -> str:
    return max(row["epoch"] for row in read_layer_rows(result, "units"))


def _movements(result: Path) -> dict[str, Row]:
    rows = read_layer_rows(result, "displacements")
    return {row["unit_id"]: row for row in rows if row["epoch_to"] == _latest(result) and row["feature"] == "centre"}


def _poses(result: Path, epoch: str | None = None) -> dict[str, tuple[Pose, UnitType]]:
    found = {}
    for row in read_layer_rows(result, "units"):
        if row["epoch"] == (epoch or _latest(result)) and row["geom"] is not None:
            pose = Pose.from_quaternion(row["geom"], [row[name] for name in ("qx", "qy", "qz", "qw")])
            unit = UnitType.tetrapod(row["height"], radius=row["r0"], gradient=row["gradient"], leg_length=LEG_LENGTH)
            found[row["unit_id"]] = (pose, unit)
    return found


def _check(corners: dict[str, np.ndarray], expected: dict[str, tuple[Pose, UnitType]]) -> None:
    """All corners lie on the surface of their unit, and reach all four end discs."""
    assert corners.keys() == expected.keys()
    for name, (pose, unit) in expected.items():
        relation = relate(pose.to_body(corners[name]), unit)
        assert np.abs(relation.distance).max() < MILLIMETRE
        tips = relation.axial > unit.leg_length - MILLIMETRE
        assert set(relation.leg[tips]) == {0, 1, 2, 3}


def _export(result: Path, tmp_path: Path, ending: str) -> Path:
    path = tmp_path / f"model{ending}"
    write_model(result, path)
    return path


def test_glb_read_by_trimesh(result: Path, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.load(_export(result, tmp_path, ".glb"))
    frame = scene.metadata
    offset = np.array(frame["offset"])
    assert frame["epsg"] == 5186
    corners, kinds = {}, {}
    for node in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[node]
        mesh = scene.geometry[geometry]
        placed = mesh.vertices @ transform[:3, :3].T + transform[:3, 3]
        # y is up in glTF
        corners[node] = np.column_stack([placed[:, 0], -placed[:, 2], placed[:, 1]]) + offset
        kinds[node] = mesh.visual.material.name
        assert mesh.volume > 0
    expected = _poses(result)
    _check(corners, expected)
    classes = {name: row["class"] for name, row in _movements(result).items()}
    assert all(kinds[name] == classes[name] for name in expected if name in classes)
    # few meshes, many nodes
    assert len(scene.geometry) < len(kinds) / 2


def test_glb_holds_the_properties_of_every_unit(result: Path, tmp_path: Path) -> None:
    content = _export(result, tmp_path, ".glb").read_bytes()
    length = int.from_bytes(content[12:16], "little")
    document = json.loads(content[20 : 20 + length])
    nodes = {node["name"]: node for node in document["nodes"] if "extras" in node}
    sds = {row["unit_id"]: row["sd_e"] for row in read_layer_rows(result, "units") if row["epoch"] == _latest(result)}
    for name, row in _movements(result).items():
        assert nodes[name]["extras"]["d_3d"] == row["d_3d"]
        assert nodes[name]["extras"]["sd_e"] == sds[name]


def test_obj_read_by_trimesh(result: Path, tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    path = _export(result, tmp_path, ".obj")
    text = path.read_text(encoding="utf-8")
    offset = np.array([float(v) for v in next(line for line in text.splitlines() if line.startswith("# offset")).split()[2:]])
    scene = trimesh.load(path, split_objects=True, process=False)
    corners = {name: mesh.vertices + offset for name, mesh in scene.geometry.items()}
    expected = {"_".join(name.split()): value for name, value in _poses(result).items()}
    assert corners.keys() == expected.keys()
    _check(corners, expected)
    assert all(mesh.is_watertight for mesh in scene.geometry.values())


def test_dxf_holds_names_of_any_characters_in_lines_of_their_own(tmp_path: Path) -> None:
    """A line break in a name made a file that no program read; text beside an entity has 255 bytes at most, whatever its letters."""
    ezdxf = pytest.importorskip("ezdxf")
    units = make_units(6, 2)
    names = ["a\nb", "c\r\nd\x00e", "f\u2028g\x85h", "é" * 240]
    for k, name in enumerate(names):
        units[k] = SyntheticUnit(name, "stable", units[k].centres, units[k].quaternions)
    path = tmp_path / "result.gpkg"
    write_result(path, epochs=2, units=units)
    output = tmp_path / "model.dxf"
    write_model(path, output)
    drawing = ezdxf.readfile(output)
    assert not drawing.audit().has_errors
    texts = {text.dxf.text for text in drawing.modelspace().query("TEXT")}
    assert {"a b", "c  d e", "f g h"} < texts
    held = [tag.value for insert in drawing.modelspace().query("INSERT") for tag in insert.get_xdata("TETRATRACK") if tag.code == 1000]
    assert max(len(value.encode("utf-8")) for value in held) in (254, 255)
    assert f"unit_id={'é' * 123}" in held


def test_dxf_read_by_gdal(result: Path, tmp_path: Path) -> None:
    pytest.importorskip("ezdxf")
    import geopandas
    import pyogrio
    import shapely

    path = _export(result, tmp_path, ".dxf")
    # DXF since 2007 is UTF-8, which GDAL does not assume; and it warns of the rings of 3D faces in blocks, which it closes itself
    pyogrio.set_gdal_config_options({"DXF_ENCODING": "UTF-8"})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        frame = geopandas.read_file(path)
    pyogrio.set_gdal_config_options({"DXF_ENCODING": None})
    expected = _poses(result)
    names = frame[frame["Text"].notna()]
    assert set(names["Text"]) == set(expected)
    bodies = frame[frame["Layer"].str.startswith("unit_")]
    outlines = frame[frame["Layer"].str.startswith("outline_")]
    assert len(outlines) == len(expected)
    centres = np.array([pose.centre for pose, _ in expected.values()])
    found: dict[str, list[np.ndarray]] = {name: [] for name in expected}
    keys = list(expected)
    for shape in bodies.geometry:
        points = shapely.get_coordinates(shape, include_z=True)
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        found[keys[int(np.argmin(np.linalg.norm(centres - middle, axis=1)))]].append(points)
    _check({name: np.vstack(parts) for name, parts in found.items()}, expected)
    for shape in outlines.geometry:
        near = np.argmin(np.linalg.norm(centres[:, :2] - [shape.centroid.x, shape.centroid.y], axis=1))
        assert shapely.get_coordinates(shape, include_z=True)[0, 2] == pytest.approx(centres[near, 2], abs=MILLIMETRE)


def test_ifc_read_and_validated_by_ifcopenshell(result: Path, tmp_path: Path) -> None:
    pytest.importorskip("ifcopenshell")
    import ifcopenshell
    import ifcopenshell.geom
    import ifcopenshell.util.element
    import ifcopenshell.util.placement
    import ifcopenshell.validate

    path = _export(result, tmp_path, ".ifc")
    file = ifcopenshell.open(path)
    logger = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(file, logger, express_rules=False)
    assert logger.statements == []
    (conversion,) = file.by_type("IfcMapConversion")
    assert conversion.TargetCRS.Name == "EPSG:5186"
    offset = np.array([conversion.Eastings, conversion.Northings, conversion.OrthogonalHeight])
    expected = _poses(result)
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    corners = {}
    for element in file.by_type("IfcBuildingElementProxy"):
        placed = ifcopenshell.util.placement.get_local_placement(element.ObjectPlacement)
        pose, _ = expected[element.Name]
        assert np.abs(placed[:3, 3] + offset - pose.centre).max() < MILLIMETRE
        assert np.abs(placed[:3, :3] - pose.rotation).max() < 1e-6
        shape = ifcopenshell.geom.create_shape(settings, element)
        corners[element.Name] = np.array(shape.geometry.verts).reshape(-1, 3) + offset
        assert element.ObjectType == "tetrapod"
    _check(corners, expected)
    row = next(iter(_movements(result).values()))
    element = next(e for e in file.by_type("IfcBuildingElementProxy") if e.Name == row["unit_id"])
    sets = ifcopenshell.util.element.get_psets(element)
    assert sets["Tetratrack_Movement"]["d_3d"] == row["d_3d"]
    assert sets["Tetratrack_Movement"]["significant"] is bool(row["significant"])
    assert 0 < sets["Tetratrack_Uncertainty"]["sd_h"] < 0.05
    assert file.by_type("IfcMarineFacility")[0].PredefinedType == "BREAKWATER"


def test_poses_as_json(result: Path, tmp_path: Path) -> None:
    document = json.loads(_export(result, tmp_path, ".json").read_text(encoding="utf-8"))
    expected = _poses(result)
    assert (document["format"], document["version"], document["crs"]["epsg"]) == ("tetratrack poses", 1, 5186)
    assert {unit["unit_id"] for unit in document["units"]} == expected.keys()
    for unit in document["units"]:
        pose, shape = expected[unit["unit_id"]]
        kind = document["types"][unit["type"]]
        read = Pose.from_quaternion(np.add(unit["translation"], document["offset"]), unit["quaternion"])
        tips = kind["leg_length"] * np.array(kind["leg_directions"])
        assert np.abs(read.to_frame(tips) - pose.to_frame(LEG_LENGTH * shape.leg_directions)).max() < MILLIMETRE
        # types are shared by units whose radius differs by half a millimetre: 0.2 % of the volume
        assert kind["volume"] == pytest.approx(shape.volume, rel=2.5e-3)


def test_an_earlier_epoch_and_refusals(result: Path, tmp_path: Path) -> None:
    first = min(row["epoch"] for row in read_layer_rows(result, "units"))
    model = write_model(result, tmp_path / "first.json", first)
    expected = _poses(result, first)
    assert {unit.unit_id for unit in model.units} == expected.keys()
    assert np.linalg.norm(model.offset - np.mean([pose.centre for pose, _ in expected.values()], axis=0)) < 1
    with pytest.raises(InputError, match="has no units of an epoch 'x'"):
        write_model(result, tmp_path / "a.glb", "x")
    for wrong in ("a.stl", "a"):
        with pytest.raises(InputError, match="cannot be written as"):
            write_model(result, tmp_path / wrong)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first.json"]
    assert set(ENDINGS) == {".glb", ".obj", ".dxf", ".ifc", ".json"}
