"""As-built units against plans and profiles whose deviations are known by construction, to 1 mm."""

from __future__ import annotations

from pathlib import Path

import ezdxf
import geopandas
import numpy as np
import pytest
import shapely
from scipy.spatial.transform import Rotation
from synthetic_result import HEIGHT, SRS, SyntheticUnit, make_units, write_result
from tetratrack.core.armour.as_built import read_as_built
from tetratrack.core.armour.comparisons import Design, compare_design, write_design_comparison
from tetratrack.core.armour.design_files import PlacementPlan
from tetratrack.core.armour.design_surface import design_surface
from tetratrack.core.armour.placement_plan import Tolerance, compare_with_plan
from tetratrack.core.common.axis import Axis
from tetratrack.core.common.errors import InputError, OutputError
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.report.structure_pages import StructureOptions
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

MILLIMETRE = 1e-3
SHIFT = np.array([0.120, -0.050, 0.080])


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("design") / "result.gpkg"
    units = [SyntheticUnit(unit.unit_id, "stable", unit.centres, unit.quaternions) for unit in make_units(30, 2)]
    write_result(path, epochs=2, units=units)
    return path


def _plan(result: Path, folder: Path, *, names: str = "B{}", turn: float = 12.0) -> Path:
    """A plan that every unit is shifted and turned from, but for one without a unit."""
    lines = ["unit_id,easting,northing,height,qx,qy,qz,qw"]
    rng = np.random.default_rng(5)
    for k, unit in enumerate(read_as_built(result).units):
        place = unit.shape.centre - SHIFT
        axis = rng.normal(size=3)
        own = Rotation.from_matrix(unit.shape.rotation) * Rotation.from_rotvec(np.radians(turn) * axis / np.linalg.norm(axis))
        values = ",".join(f"{value:.9f}" for value in (*place, *own.as_quat()))
        lines.append(f"{names.format(k) if names != 'own' else unit.unit_id},{values}")
    far = read_as_built(result).offset + np.array([500, 0, 0])
    if names != "own":
        lines.append("NONE," + ",".join(f"{value:.3f}" for value in far) + ",0,0,0,1")
    path = folder / "plan.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize("names", ["B{}", "own"])
def test_a_plan_in_csv_to_a_millimetre(result: Path, tmp_path: Path, names: str) -> None:
    design = Design(plan=str(_plan(result, tmp_path, names=names)), tolerance=Tolerance(place=0.10, turn=20.0))
    found = compare_design(result, design)
    assert found.plan is not None
    assert len(found.plan.deviations) == 30
    for row in found.plan.deviations:
        assert [row["de"], row["dn"], row["dh"]] == pytest.approx(SHIFT, abs=MILLIMETRE)
        assert row["d_3d"] == pytest.approx(np.linalg.norm(SHIFT), abs=MILLIMETRE)
        assert row["rotation_deg"] == pytest.approx(12.0, abs=0.01)
        # 15 cm with a standard deviation of 4 mm are more than 10 cm
        assert row["verdict"] == "outside"
    missing = [row["plan_id"] for row in found.plan.unmatched if row["kind"] == "missing"]
    assert missing == ([] if names == "own" else ["NONE"])


def test_tolerances_leave_open_what_the_deviations_leave_open(result: Path, tmp_path: Path) -> None:
    plan = str(_plan(result, tmp_path))
    length = float(np.linalg.norm(SHIFT))
    for limit, expected in ((length - 0.02, "outside"), (length, "open"), (length + 0.02, "within")):
        found = compare_design(result, Design(plan=plan, tolerance=Tolerance(place=limit)))
        assert found.plan is not None
        assert {row["verdict"] for row in found.plan.deviations} == {expected}
    unjudged = compare_design(result, Design(plan=plan))
    assert unjudged.plan is not None
    assert {row["verdict"] for row in unjudged.plan.deviations} == {None}


def test_a_plan_as_a_layer_in_another_crs(result: Path, tmp_path: Path) -> None:
    units = read_as_built(result).units
    points = [shapely.Point(*(unit.shape.centre - SHIFT)) for unit in units]
    frame = geopandas.GeoDataFrame({"unit_id": [unit.unit_id for unit in units]}, geometry=points, crs=f"EPSG:{SRS}")
    path = tmp_path / "plan.gpkg"
    frame.to_crs("EPSG:5179").to_file(path, layer="blocks", driver="GPKG")
    output = tmp_path / "deviations.gpkg"
    write_design_comparison(result, output, Design(plan=f"{path}|layername=blocks"))
    read = geopandas.read_file(output, layer="plan_deviations")
    assert read.crs.to_epsg() == SRS
    assert read[["de", "dn", "dh"]].to_numpy() == pytest.approx(np.tile(SHIFT, (30, 1)), abs=MILLIMETRE)
    ends = np.array([shapely.get_coordinates(line, include_z=True) for line in read.geometry])
    assert np.diff(ends, axis=1)[:, 0] == pytest.approx(np.tile(SHIFT, (30, 1)), abs=MILLIMETRE)
    assert len(geopandas.read_file(output, layer="plan_unmatched")) == 0


def _plane(result: Path) -> tuple[Axis, np.ndarray, float]:
    """An axis along the rows of the synthetic units, and a plane of 1 in 2 across it through their middle: its normal and height there."""
    origin = read_as_built(result).offset
    along = np.array([np.cos(0.6), np.sin(0.6)])
    return (
        Axis(np.array([origin[:2] - 50 * along, origin[:2] + 50 * along])),
        np.array([0.5 * np.sin(0.6), -0.5 * np.cos(0.6), 1.0]),
        origin[2],
    )


def _height(places: np.ndarray, result: Path) -> np.ndarray:
    _, normal, level = _plane(result)
    offsets = places[:, :2] - read_as_built(result).offset[:2]
    return level - offsets @ normal[:2]


@pytest.mark.parametrize("form", ["section.gpkg", "edges.gpkg", "edges.dxf"])
def test_a_design_profile_to_a_millimetre(result: Path, tmp_path: Path, form: str) -> None:
    axis, normal, _ = _plane(result)
    origin = read_as_built(result).offset
    along, left = np.array([np.cos(0.6), np.sin(0.6)]), np.array([-np.sin(0.6), np.cos(0.6)])
    if form.startswith("section"):
        corners = [np.array([origin[:2] + s * left for s in (-40, 0, 40)])]
    else:
        corners = [np.array([origin[:2] + s * left + a * along for a in (-45, 10, 45)]) for s in (-40, 3, 40)]
    lines = [np.column_stack([corner, _height(corner, result)]) for corner in corners]
    path = tmp_path / form
    if path.suffix == ".dxf":
        drawing = ezdxf.new()
        for line in lines:
            drawing.modelspace().add_polyline3d(line.tolist())
        drawing.saveas(path)
    else:
        geopandas.GeoDataFrame(geometry=[shapely.LineString(line) for line in lines], crs=f"EPSG:{SRS}").to_file(path, driver="GPKG")
    found = compare_design(result, Design(profile=str(path), axis=axis.corners, profile_tolerance=0.3, reference="centre"))
    units = {unit.unit_id: unit for unit in read_as_built(result).units}
    assert len(found.profile) == len(units)
    unit_normal = normal / np.linalg.norm(normal)
    for row in found.profile:
        shape = units[row["unit_id"]].shape
        expected = (shape.centre[2] - _height(shape.centre[None], result)[0]) * unit_normal[2]
        assert row["off_centre"] == pytest.approx(expected, abs=MILLIMETRE)
        # outermost of a dense net of points on the rims of the end discs
        rim = shape.radius - shape.gradient * shape.leg_length
        tips = []
        for leg in shape.legs @ shape.rotation.T:
            across = np.linalg.svd(leg[None])[2][1:]
            angle = np.linspace(0, 2 * np.pi, 20_000)
            circle = np.column_stack([np.cos(angle), np.sin(angle)]) @ across * rim
            tips.append((shape.leg_length * leg + circle) @ unit_normal)
        assert row["off_outer"] - row["off_centre"] == pytest.approx(np.max(tips), abs=MILLIMETRE)
        far = abs(expected) > 0.3
        assert row["verdict"] in ({"outside", "open"} if far else {"within", "open"})


@pytest.mark.parametrize(("moved_on", "by_name"), [(30, False), (6, True), (0, True)])
def test_names_of_another_run_do_not_pair_units_with_the_places_of_others(result: Path, moved_on: int, by_name: bool) -> None:
    model = read_as_built(result)
    centres = np.array([unit.shape.centre for unit in model.units])
    order = np.arange(30)
    order[:moved_on] = np.roll(order[:moved_on], 1)
    plan = PlacementPlan(
        ids=tuple(unit.unit_id for unit in model.units),
        places=centres[order] - SHIFT,
        rotations=np.tile(np.eye(3), (30, 1, 1)),
        turned=np.zeros(30, dtype=bool),
    )
    found = compare_with_plan(model, plan, Tolerance(place=0.5))
    assert [row["plan_id"] == row["unit_id"] for row in found.deviations].count(True) == (30 if by_name else 0)
    assert found.median == pytest.approx(np.linalg.norm(SHIFT), abs=MILLIMETRE)
    assert found.count("outside") == (moved_on if by_name else 0)
    assert (f"at {moved_on} of 30 planned places" in found.doubt) == (moved_on > 0)
    assert ("by name" if by_name else "by place") in found.doubt or not moved_on


def test_names_that_are_not_followed_are_said_by_the_command_and_the_report(result: Path, tmp_path: Path) -> None:
    units = read_as_built(result).units
    names = np.roll([unit.unit_id for unit in units], 1)
    lines = [f"{name}," + ",".join(f"{value:.4f}" for value in unit.shape.centre) for name, unit in zip(names, units, strict=True)]
    plan = tmp_path / "plan.csv"
    plan.write_text("unit_id,easting,northing,height\n" + "\n".join(lines) + "\n", encoding="utf-8")
    told = CliRunner().invoke(app, ["design", str(result), "-o", str(tmp_path / "deviations.gpkg"), "--plan", str(plan)])
    assert told.exit_code == 0
    assert "paired by place" in " ".join(told.output.split())
    structure = StructureOptions(design=Design(plan=str(plan)))
    notes = write_report(result, tmp_path / "report.html", ReportOptions(structure=structure, sections=("design",))).notes
    assert any("paired by place" in note for note in notes)


@pytest.mark.parametrize("axis", [Axis(np.array([[0.0, 0.0], [100.0, 0.0]])), Axis(np.array([[5e5, 6e6], [500_077.3, 6_000_044.1]]))])
@pytest.mark.parametrize("way", [1, -1])
def test_a_section_with_a_vertical_face_whichever_way_it_is_drawn(axis: Axis, way: int) -> None:
    place, heading = axis.frame(50.0)
    left = np.array([-heading[1], heading[0]])
    # a wall 6 m high, drawn to millimetres
    corners = [(0.0, 10.0), (5.0, 10.0), (5.0, 7.0), (5.0, 4.0), (12.0, 4.0), (20.0, -2.0)]
    line = np.round(np.array([[*(place + offset * left), height] for offset, height in corners]), 3)[::way]
    offset = np.array([1.0, 3.0, 4.98, 5.02, 8.0, 11.0, 16.0])
    found = design_surface([line], axis, HEIGHT).heights(place + offset[:, None] * left)
    assert found == pytest.approx([10, 10, 10, 4, 4, 4, 1], abs=0.002)


def test_profiles_with_two_heights_at_one_place_are_refused() -> None:
    axis = Axis(np.array([[0.0, 0.0], [100.0, 0.0]]))
    folded = np.array([[50.0, 0.0, 5.0], [50.0, 10.0, 5.0], [50.0, 8.0, 3.0], [50.0, 20.0, 0.0]])
    for line in (folded, folded[::-1], np.vstack([folded[[0, 1, 3]], folded[:1]])):
        with pytest.raises(InputError, match="folds back"):
            design_surface([line], axis, HEIGHT)

    def edge(offset: float, height: float) -> np.ndarray:
        return np.array([[0.0, offset, height], [100.0, offset, height]])

    with pytest.raises(InputError, match="one above the other"):
        design_surface([edge(0, 10), edge(5, 10), edge(5, 4), edge(12, 4)], axis, HEIGHT)
    wall = design_surface([edge(0, 10), edge(5, 10), edge(5.05, 4), edge(12, 4)], axis, HEIGHT)
    assert wall.heights(np.array([[50.0, 2.0], [50.0, 8.0]])) == pytest.approx([10.0, 4.0])
    # lines along and across with a corner in common
    across = np.array([[0.0, 0.0, 10.0], [0.0, 5.0, 10.0]])
    assert design_surface([edge(0, 10), edge(5, 10), across], axis, HEIGHT).heights(np.array([[50.0, 2.0]])) == pytest.approx([10.0])


def test_what_cannot_be_compared_is_said(result: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="nothing to compare"):
        compare_design(result, Design())
    empty = tmp_path / "a.csv"
    empty.write_text("unit_id,easting,northing\nB1,1,2\n", encoding="utf-8")
    with pytest.raises(InputError, match="no column height"):
        compare_design(result, Design(plan=str(empty)))
    empty.write_text("unit_id,easting,northing,height\nB1,1,2,3\n", encoding="utf-8")
    with pytest.raises(InputError, match="no place within one height"):
        compare_design(result, Design(plan=str(empty)))
    empty.write_text("unit_id,easting,northing,height,qx,qy,qz,qw\nB1,1,2,3,0.5,,,\n", encoding="utf-8")
    with pytest.raises(InputError, match="half an orientation"):
        compare_design(result, Design(plan=str(empty)))
    flat = tmp_path / "flat.gpkg"
    geopandas.GeoDataFrame(geometry=[shapely.LineString([(0, 0), (1, 1)])], crs=f"EPSG:{SRS}").to_file(flat, driver="GPKG")
    with pytest.raises(InputError, match="without heights"):
        compare_design(result, Design(profile=str(flat)))
    broken = tmp_path / "b.dxf"
    broken.write_text("no drawing", encoding="utf-8")
    with pytest.raises(InputError, match="no DXF"):
        compare_design(result, Design(profile=str(broken)))
    with pytest.raises(OutputError, match="inputs"):
        write_design_comparison(result, result, Design(plan=str(empty)))
