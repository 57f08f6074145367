"""Files of strangers: names that are formulas, style sheets or paths, numbers of a thousand digits, layers that ask the network."""

from __future__ import annotations

import json
import os
import re
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
import synthetic_result
from las_files import grid_points, write_las
from tetratrack.core.common.csv_text import spreadsheet_safe
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.point_tables import read_control
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.vector_files import check_vector_file
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.results.export import export_layers
from tetratrack.core.results.geopackage_reader import epoch_pairs, read_layer_rows
from tetratrack.core.review.decisions import decide
from tetratrack.core.review.point_index import PointIndex, index_folder
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

HEAD = '[survey]\nname = "s"\ncrs = "EPSG:32650"\n[unit]\ntype = "tetrapod"\nheight = 2.3\n'
EPOCH = '[[epoch]]\nlabel = "a"\ntime = 2025-03-14T02:30:00Z\ntiles = "a.laz"\n'


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    units = synthetic_result.write_result(path, count=24, epochs=2)
    synthetic_result.write_points(path, units, epochs=2, per_unit=100)
    return path


@pytest.fixture(scope="module")
def harmless(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The report of such a result as it is."""
    path = tmp_path_factory.mktemp("harmless") / "result.gpkg"
    synthetic_result.write_result(path, count=24, epochs=2)
    write_report(path, path.with_suffix(".html"), ReportOptions(worst=1))
    return path.with_suffix(".html").read_text(encoding="utf-8")


@pytest.mark.parametrize("text", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(1)", "\t=1", "\r=1", " =1", "\n@x", "＝1+1", "\x00=1"])
def test_formulas_become_text(text: str) -> None:
    assert spreadsheet_safe(text) == f"'{text}"


@pytest.mark.parametrize("value", ["-12.5", "+3", "1e-3", "a=b", "U0001", "", None, -1.5, True])
def test_numbers_and_other_texts_stay(value: object) -> None:
    assert spreadsheet_safe(value) is value


def test_no_formula_in_exported_tables(result: Path, tmp_path: Path) -> None:
    pair = epoch_pairs(result)[0]
    unit = next(row["unit_id"] for row in read_layer_rows(result, "displacements") if row["epoch_to"] == pair.epoch_to)
    decide(result, [unit], pair, "accepted", comment="=1+1", reviewer="@me")
    export_layers(result, tmp_path / "out", ["csv"])
    for table in (tmp_path / "out").glob("*.csv"):
        assert not re.search(r'(^|,)"?\s*[=@]', table.read_text(encoding="utf-8"), re.MULTILINE), table.name


@pytest.mark.parametrize(
    "name",
    ["north\f}} h1 {display: none} x{", "a\r\n} * {display:none} {", "</style><script>alert(1)</script>", r"$\frac{$ _^ \x $", "a\\"],
)
def test_a_name_is_a_name_in_the_report(result: Path, tmp_path: Path, harmless: str, name: str) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        for label, settings in connection.execute("SELECT label, settings FROM epochs").fetchall():
            changed = json.dumps(json.loads(settings) | {"survey": name})
            connection.execute("UPDATE epochs SET settings = ? WHERE label = ?", (changed, label))
        for table in ("units", "feature_points", "displacements"):
            connection.execute(f"UPDATE {table} SET unit_id = ? || unit_id", (name,))  # noqa: S608 - constants
        connection.execute("UPDATE epochs SET label = ? || label", ("$\\x",))
        connection.execute("UPDATE units SET epoch = ? || epoch", ("$\\x",))
        connection.execute("UPDATE feature_points SET epoch = ? || epoch", ("$\\x",))
        for end in ("epoch_from", "epoch_to"):
            connection.execute(f"UPDATE displacements SET {end} = ? || {end}", ("$\\x",))  # noqa: S608 - constants
    write_report(result, tmp_path / "report.html", ReportOptions(worst=1))
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    for element in ("style", "script"):  # of the report's own alone: what the name says changes neither
        assert _elements(page, element) == _elements(harmless, element)
    assert _elements(page, "style")
    assert "alert(1)</script>" not in page
    assert "Content-Security-Policy" in page


def _elements(page: str, name: str) -> list[str]:
    """The elements of a page that hold rules or programs, but for the data of its units."""
    return [text for head, text in re.findall(rf"<{name}\b([^>]*)>(.*?)</{name}>", page, re.DOTALL) if "application/json" not in head]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (HEAD.replace("2.3", "1" + "0" * 400) + EPOCH, "height must be a number, not a number of many digits"),
        (HEAD.replace("2.3", "1" + "0" * 5000) + EPOCH, "holds a value that cannot be read"),
        (HEAD + EPOCH.replace("2025-03-14T02:30:00Z", "0001-01-01T00:00:00+14:00"), "is no time in UTC"),
        (HEAD + EPOCH.replace("2025-03-14T02:30:00Z", "9999-12-31T23:59:59-12:00"), "is no time in UTC"),
        (HEAD + EPOCH.replace('"a.laz"', '"."'), "tiles"),
        (HEAD + EPOCH.replace('"a.laz"', '".."'), "tiles"),
        (HEAD + "area = " + "[" * 900 + "]" * 900 + "\n" + EPOCH, "nested too deeply"),
        (HEAD + "x = " + "{a = " * 900 + "1" + "}" * 900 + "\n" + EPOCH, "."),
        ("a." * 20000 + "b = 1\n" + HEAD + EPOCH, "is no survey.toml"),
        ('"a" . ' * 2000 + "b = 1\n" + HEAD + EPOCH, "is no survey.toml"),
        (HEAD + "area = [[" + "9" * 400 + ", 1], [1, 2], [3, 4]]\n" + EPOCH, "area must be"),
        ("#" * 5_000_000, "is no survey.toml"),
        (HEAD.replace('"s"', '"' + "n" * 100_000 + '"') + EPOCH, "name must be text in quotes, on one line"),
        (HEAD + EPOCH.replace('"a"', '"a\\u0000b"'), "label must be text in quotes, on one line"),
        (HEAD + EPOCH.replace('"a"', '"a\\nb"'), "label must be text in quotes, on one line"),
        (HEAD + "area = [[nan, 1], [1, 2], [3, 4]]\n" + EPOCH, "area must be"),
        (HEAD + "area = [[1e300, 1], [1, 2], [3, 4]]\n" + EPOCH, "area must be"),
        (HEAD.replace("2.3", "inf") + EPOCH, "at most 7, not inf. It is in metres"),
    ],
)
def test_surveys_made_to_break_the_reader(tmp_path: Path, text: str, told: str) -> None:
    write_las(tmp_path / "a.laz", grid_points())
    path = tmp_path / "survey.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=told) as error:
        read_survey(path)
    assert len(str(error.value)) < 1000


@pytest.mark.parametrize(
    ("row", "told"),
    [
        ("T1,1e300,2,3,0.01,0.01,0.01", "line 2, field easting: 1e300 is too large"),
        ('T1,"' + "1" * 200_000 + '",2,3,0.01,0.01,0.01', "is no table .field larger"),
        ('T1,"1,2,3\n' + "T2,1,2,3,1,1,1\n" * 20_000, "is no table|fields, the header"),
        ("T1,1\x00,2,3,0.01,0.01,0.01", "line 2"),
        ("T1,nan,2,3,0.01,0.01,0.01", "nan is not finite"),
    ],
)
def test_tables_made_to_break_the_reader(tmp_path: Path, row: str, told: str) -> None:
    path = tmp_path / "control.csv"
    path.write_text(f"point_id,easting,northing,height,sd_e,sd_n,sd_h\n{row}\n", encoding="utf-8")
    with pytest.raises(InputError, match=told) as error:
        read_control(path)
    assert len(str(error.value)) < 1000


CONTROL = "point_id,easting,northing,height,sd_e,sd_n,sd_h\nT1,1.5,2,3,0.01,0.01,0.01\n"


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (CONTROL.encode("utf-16"), ""),
        (CONTROL.replace(",", "\t").replace(".", ",").encode("utf-16-be").join((b"\xfe\xff", b"")), ""),
        (b"sep=;\r\n" + CONTROL.replace(",", ";").encode(), ""),
        (CONTROL.encode("utf-16-le"), "line 1: is no table .its text is not UTF-8.*CSV"),
        (CONTROL.replace("T1", "Größe").encode("latin-1"), "line 2: is no table .its text is not UTF-8.*CSV"),
        (b"PK\x03\x04" + bytes(300), "line 1: is no table .it is a spreadsheet.*CSV"),
        (CONTROL.replace("point_id", "p" * 90_000).encode(), "has no column point_id; found"),
        (CONTROL.replace("sd_h", "sd_h [mm]").encode(), r"line 1: states sd_h \[mm\]. Give metres"),
    ],
)
def test_tables_as_spreadsheets_write_them(tmp_path: Path, data: bytes, told: str) -> None:
    path = tmp_path / "control.csv"
    path.write_bytes(data)
    if not told:
        assert read_control(path).coordinates.tolist() == [[1.5, 2.0, 3.0]]
        return
    with pytest.raises(InputError, match=told) as error:
        read_control(path)
    assert len(str(error.value)) < 600


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="devices as Linux has them")
def test_devices_and_pipes_are_no_inputs(tmp_path: Path) -> None:
    """One never ends and fills the memory, the other waits for ever."""
    os.mkfifo(tmp_path / "pipe")
    for name in ("zero.toml", "zero.csv", "zero.laz", "zero.vpc"):
        (tmp_path / name).symlink_to("/dev/zero")
        (tmp_path / name.replace("zero", "pipe")).symlink_to(tmp_path / "pipe")
    for kind in ("zero", "pipe"):
        for name in (f"{kind}.toml", f"{kind}.laz", f"{kind}.vpc"):
            told = CliRunner().invoke(app, ["inspect", str(tmp_path / name)])
            assert told.exit_code == 2
            assert "is a device, not a file" in told.stderr
        with pytest.raises(InputError, match="is a device, not a file"):
            read_control(tmp_path / f"{kind}.csv")
    write_las(tmp_path / "a.laz", grid_points())
    told = CliRunner().invoke(app, ["init", str(tmp_path / "a.laz"), "--no-size", "-o", "/dev/full"])
    assert told.exit_code == 2
    assert "is a device, not a file, and would be replaced" in told.stderr


@pytest.mark.parametrize(
    "text",
    [
        '<OGRVRTDataSource><OGRVRTLayer name="x"><SrcDataSource>/vsicurl/http://127.0.0.1:1/x.gpkg</SrcDataSource></OGRVRTLayer>'
        "</OGRVRTDataSource>",
        "<OGRWFSDataSource><URL>http://127.0.0.1:1/wfs</URL></OGRWFSDataSource>",
        "WFS:http://127.0.0.1:1/wfs",
        "",
    ],
)
def test_layers_that_would_ask_the_network_are_not_opened(tmp_path: Path, text: str) -> None:
    path = tmp_path / "areas.gpkg"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="is not a readable polygon layer"):
        check_vector_file(path)


def _truncate(folder: Path) -> None:
    for path in folder.glob("*.points.npy"):
        path.write_bytes(path.read_bytes()[:500])


def _remove(folder: Path) -> None:
    for path in folder.glob("*.points.npy"):
        path.unlink()


def _empty(folder: Path) -> None:
    for path in folder.glob("*.cells.npy"):
        path.write_bytes(b"")


def _descending(folder: Path) -> None:
    for path in folder.glob("*.cells.npy"):
        np.save(path, np.load(path)[:, ::-1])


def _beyond(folder: Path) -> None:
    for path in folder.glob("*.cells.npy"):
        table = np.load(path)
        np.save(path, np.vstack([table[0], table[1] * 1000]))


def _pickled(folder: Path) -> None:
    for path in folder.glob("*.cells.npy"):
        np.save(path, np.array([{"a": 1}], dtype=object), allow_pickle=True)


def _described(old: str, new: str) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        path = folder / "index.json"
        path.write_text(re.sub(old, new, path.read_text(encoding="utf-8")), encoding="utf-8")

    return change


DAMAGES: list[Callable[[Path], None]] = [
    _truncate,
    _remove,
    _empty,
    _descending,
    _beyond,
    _pickled,
    _described(r'"stem": "[^"]*"', '"stem": "../../x"'),
    _described(r'"stem": "[^"]*"', '"stem": "/etc/x"'),
    _described(r'"stem": "[^"]*"', r'"stem": "\\\\\\\\server\\\\share\\\\x"'),
    _described(r'"cell": [0-9.]*', '"cell": 1e-9'),
    _described(r'"cell": [0-9.]*', '"cell": NaN'),
    _described(r'"cell": [0-9.]*', '"cell": "wide"'),
    _described(r'"count": \d+', '"count": ' + "9" * 5000),
    _described(r'"grid_origin": \[[^\]]*\]', '"grid_origin": [1e400]'),
    _described(r'"bounds": \[[^\]]*\]', '"bounds": []'),
    _described(r'"epochs": \{', '"epochs": [' + "[" * 100_000 + "{"),
]


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_point_index_counts_as_none(result: Path, tmp_path: Path, damage: Callable[[Path], None]) -> None:
    damage(index_folder(result))
    sections = ("profiles", "worst")  # those that show points
    notes = write_report(result, tmp_path / "r.html", ReportOptions(worst=1, sections=sections)).notes
    assert any("units are drawn without points" in note for note in notes)
    pair = epoch_pairs(result)[0]

    def read() -> None:
        PointIndex(index_folder(result)).read(pair.epoch_from, synthetic_result.ORIGIN, 100.0)

    with pytest.raises(InputError, match="is no point index, or a damaged one"):
        read()


def test_the_command_says_that_a_damaged_point_index_counts_as_none(result: Path, tmp_path: Path) -> None:
    _truncate(index_folder(result))
    told = CliRunner().invoke(app, ["report", str(result), "-o", str(tmp_path / "r.html"), "--worst", "1"])
    assert told.exit_code == 0, told.stderr
    assert "units are drawn without points" in told.stderr


def test_a_damaged_point_index_is_named_by_the_command_that_shows_its_points(result: Path, tmp_path: Path) -> None:
    (index_folder(result) / "index.json").write_text("{}", encoding="utf-8")
    told = CliRunner().invoke(app, ["profiles", str(result), "-o", str(tmp_path / "p.gpkg")])
    assert told.exit_code == 2
    assert "is no point index, or a damaged one" in told.stderr


def test_an_index_that_is_sound_is_read(result: Path, tmp_path: Path) -> None:
    told = CliRunner().invoke(app, ["report", str(result), "-o", str(tmp_path / "r.html"), "--worst", "1"])
    assert told.exit_code == 0, told.stderr
    assert "without points" not in told.stderr


def test_what_no_field_check_sees_ends_in_a_sentence(result: Path, tmp_path: Path) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute("UPDATE epochs SET settings = ?", (json.dumps({"quality": {"found": "many"}, "unit_types": [{"name": 1}]}),))
    for command in (["report", str(result), "-o", str(tmp_path / "r.html")], ["alarms", str(result), "-o", str(tmp_path / "a.csv")]):
        told = CliRunner().invoke(app, command)
        assert told.exit_code in (0, 2)
        assert "Traceback" not in told.output


def test_all_of_an_export_or_nothing(result: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    usage = shutil.disk_usage(tmp_path)
    monkeypatch.setattr("shutil.disk_usage", lambda _: usage._replace(free=100_000))
    told = CliRunner().invoke(app, ["export", str(result), "-o", str(tmp_path / "out")])
    assert told.exit_code == 2
    assert "No space left on device" in told.stderr
    assert list((tmp_path / "out").iterdir()) == []
