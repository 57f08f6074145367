"""Tables beside tiles: told by columns, names and place, in the dialects offices write, and read back by the survey's reader."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.data.point_tables import read_control, read_targets
from tetratrack.core.data.recognised_tables import assign, find_tables, recognise

EXTENT = (500_000.0, 3_500_000.0, 500_030.0, 3_500_030.0)
CONTROL = """point_id,easting,northing,height,sd_e,sd_n,sd_h
T1,500001.5,3500002.25,4.5,0.003,0.003,0.003
T2,500021,3500012,4.1,0.003,0.003,0.003
"""
TARGETS = "point_id,x,y,z\nT1,500001.52,3500002.24,4.51\nT2,500021.02,3500012.01,4.12\n"
GERMAN = "Punkt;Rechtswert;Hochwert;Höhe\nT1;500001,5;3500002,25;4,5\nT2;500021,0;3500012,0;4,1\n"


def _write(folder: Path, **files: str) -> list[Path]:
    for name, text in files.items():
        (folder / f"{name}.csv").write_text(text, encoding="utf-8")
    return find_tables([folder])


def test_roles_and_epochs(tmp_path: Path) -> None:
    check = "point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd\nK1,500005,3500005,3,500005.2,3500005.1,3.4,0.003\n"
    paths = _write(
        tmp_path,
        control_20240409=CONTROL,
        targets_20240409=TARGETS,
        control_20241024=CONTROL,
        gcp_cloud_20241024=TARGETS,
        check_20240409=check,
    )
    tables, notes = recognise(paths, EXTENT)
    labels = ["2024-04-09", "2024-10-24"]
    first, second = (assign(tables, label, tmp_path / "tiles", others=labels) for label in labels)
    assert {role: table.path.stem for role, table in first.items()} == {
        "control": "control_20240409",
        "targets": "targets_20240409",
        "check": "check_20240409",
    }
    assert {role: table.path.stem for role, table in second.items()} == {"control": "control_20241024", "targets": "gcp_cloud_20241024"}
    assert notes == []


def test_decimal_commas_and_other_names(tmp_path: Path) -> None:
    paths = _write(tmp_path, Festpunkte_control=GERMAN)
    (table,), _ = recognise(paths, EXTENT)
    assert (table.role, table.swapped, table.unit, table.sds) == ("control", False, "m", False)
    assert "decimal commas" in table.reason
    assert table.changes == ()
    points = read_control(table.path, sd=0.005)
    assert points.ids == ("T1", "T2")
    np.testing.assert_allclose(points.coordinates[0], [500001.5, 3500002.25, 4.5])
    np.testing.assert_allclose(points.sds, 0.005)


def test_northing_first_and_feet_are_seen_by_place(tmp_path: Path) -> None:
    swapped = "name,x,y,z\nT1,3500002.25,500001.5,4.5\nT2,3500012,500021,4.1\n"
    feet = "id,east,north,elev\n" + "\n".join(f"T{k},{e / 0.3048:.4f},{n / 0.3048:.4f},14.76" for k, e, n in [(1, 500001.5, 3500002.25)])
    paths = _write(tmp_path, control_jgd=swapped, control_us=feet)
    tables, _ = recognise(paths, EXTENT)
    by_name = {table.path.stem: table for table in tables}
    assert by_name["control_jgd"].swapped
    assert by_name["control_us"].unit == "ft"
    np.testing.assert_allclose(read_control(by_name["control_jgd"].path, axes="ne", sd=0.01).coordinates[0], [500001.5, 3500002.25, 4.5])


def test_what_lies_elsewhere_or_lacks_a_header_is_named_and_not_used(tmp_path: Path) -> None:
    far = CONTROL.replace("5000", "6000")
    bare = "T1,500001.5,3500002.25,4.5\nT2,500021,3500012,4.1\n"
    notes_text = "date,weather\n2024-04-09,fine\n"
    tables, notes = recognise(_write(tmp_path, control=far, points=bare, diary=notes_text), EXTENT)
    assert tables == []
    assert len(notes) == 2
    assert any("elsewhere" in note for note in notes)
    assert any("no header" in note for note in notes)


@pytest.mark.parametrize("separator", [";", "\t"])
def test_targets_with_other_separators(tmp_path: Path, separator: str) -> None:
    path = tmp_path / "targets.csv"
    path.write_text(TARGETS.replace(",", separator))
    assert read_targets(path).ids == ("T1", "T2")
