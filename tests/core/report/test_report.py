"""The report: what it says agrees with the result, rejected units are out, texts are escaped, files are whole."""

from __future__ import annotations

import csv
import json
import math
import re
import shutil
import sqlite3
from collections import Counter
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pyproj import CRS
from pyproj.enums import WktVersion
from synthetic_result import features_of, make_units, write_points, write_result
from tetratrack.core.armour.comparisons import Design
from tetratrack.core.armour.placement_rows import placement_rows
from tetratrack.core.common.axis import parse_axis
from tetratrack.core.common.errors import InputError, OutputError
from tetratrack.core.report import figures
from tetratrack.core.report import report as report_module
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.report.number_formats import number_formats
from tetratrack.core.report.report import SECTIONS, ReportOptions, translator, write_report
from tetratrack.core.report.structure_pages import StructureOptions
from tetratrack.core.results.geopackage_reader import EpochPair, add_spatial_functions, epoch_pairs, read_layer_rows
from tetratrack.core.results.unit_rows import read_epochs, read_unit_rows, unit_sizes
from tetratrack.core.review.corrections import add_placeholder, store_picks
from tetratrack.core.review.decisions import confirm, decide

PAIR = EpochPair("2024-04-09", "2025-04-09")


@pytest.fixture(scope="module")
def reviewed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "result.gpkg"
    units = write_result(path, 60)
    write_points(path, units, per_unit=400)
    rows = sorted(read_unit_rows(path, PAIR, "stable"), key=lambda row: -(row.d_3d or 0))
    decide(path, [rows[0].unit_id], PAIR, "rejected", comment="two units, <script>alert(1)</script>", reviewer="Anna & Co")
    decide(path, [rows[1].unit_id], PAIR, "inspect", comment="", reviewer="Anna & Co")
    confirm(path, rows[1].unit_id, PAIR, reviewer="Ben")
    add_placeholder(path, PAIR.epoch_to, [236500, 285150, 3], editor="Anna & Co")
    checked = next(u for u in units if u.fate in ("stable", "moved"))
    for epoch, label in ((1, PAIR.epoch_from), (2, PAIR.epoch_to)):
        store_picks(path, checked.unit_id, label, {"f123": features_of(checked, epoch)[1]}, editor="Anna & Co")
    return path


@pytest.fixture(scope="module")
def page(reviewed: Path) -> str:
    output = reviewed.with_name("report.html")
    write_report(reviewed, output, ReportOptions(worst=3))
    return output.read_text(encoding="utf-8")


def text_of(page: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", re.sub(r'src="data:[^"]*"', "", page)))


def test_html_states_the_last_pair_and_leaves_the_rejected_unit_out(reviewed: Path, page: str) -> None:
    text = text_of(page)
    rows = sorted(read_unit_rows(reviewed, PAIR, "stable"), key=lambda row: -(row.d_3d or 0))
    assert "2024-04-09 → 2025-04-09" in text
    assert "Units rejected by reviewers and left out of all figures, maps and tables below: 1." in text
    worst = re.findall(r"<h3>(U\d+) – \w+: ([\d.]+) ±", page)
    assert [name for name, _ in worst] == [row.unit_id for row in rows[1:4]]
    assert [float(length) for _, length in worst] == [round(100 * row.d_3d, 1) for row in rows[1:4]]
    significant = sum(row.significant for row in rows[1:])
    assert f"Significant displacements {significant} " in text
    assert "Completeness" in text


def test_table_of_check_points_has_picks_fit_and_survey(reviewed: Path, page: str) -> None:
    text = text_of(page)
    line = re.search(r"K1 (U\d+) f123 ([\d.]+) ([\d.]+) ([\d.]+) ([+-][\d.]+) ([+-][\d.]+)", text)
    assert line is not None
    manual, fitted, surveyed, error_manual, error_fitted = (float(value) for value in line.groups()[1:])
    assert manual == pytest.approx(fitted, abs=0.11), "the pick was put on the fit"
    assert error_fitted == pytest.approx(fitted - surveyed, abs=0.11)
    assert error_manual == pytest.approx(error_fitted, abs=0.02)


def test_texts_of_the_result_are_escaped(page: str) -> None:
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "Anna &amp; Co" in page


def test_page_holds_everything_it_shows(page: str) -> None:
    sources = re.findall(r'src="([^"]{0,30})', page)
    assert len(sources) >= 7
    assert all(source.startswith("data:image/png;base64,") for source in sources)
    assert "http:" not in re.sub(r"base64,[^\"]*", "", page).replace("https:", "http:")


def test_pdf_has_pages(reviewed: Path) -> None:
    pytest.importorskip("weasyprint")
    output = reviewed.with_name("report.pdf")
    write_report(reviewed, output, ReportOptions(worst=1))
    content = output.read_bytes()
    assert content.startswith(b"%PDF-")
    assert len(content) > 50_000


def test_quality_of_the_units_is_shown_by_epoch(reviewed: Path, tmp_path: Path) -> None:
    quality = {"found": 118, "uncertain": 2, "distance_median": 0.0043, "overlap_share_max": 0.004, "close_pairs": 0, "gaps": 7}
    with closing(sqlite3.connect(reviewed)) as connection, connection:
        (settings,) = connection.execute("SELECT settings FROM epochs WHERE label = ?", (PAIR.epoch_to,)).fetchone()
        settings = json.dumps(json.loads(settings) | {"quality": quality})
        connection.execute("UPDATE epochs SET settings = ? WHERE label = ?", (settings, PAIR.epoch_to))
    write_report(reviewed, tmp_path / "r.html", ReportOptions(sections=("quality",)))
    page = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert re.search(rf'{PAIR.epoch_to}</td><td class="n">118</td><td class="n">2</td><td class="n">4.3</td><td class="n">0.4 %', page)


def laboratory_models(path: Path, change: str) -> Path:
    """A result of models of a tank, with one change more."""
    write_result(path, 20, 2)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE units SET height = 0.105")
        connection.execute(change)
    return path


def test_summary_names_its_thresholds_for_laboratory_models(tmp_path: Path) -> None:
    """Half of their nominal diameter is less than 5 cm."""
    path = laboratory_models(tmp_path / "small.gpkg", "UPDATE displacements SET d_over_dn = NULL")
    data = write_report(path, tmp_path / "small.html", ReportOptions(sections=("summary",)))
    assert data.damage is not None
    assert [c.name for c in data.damage.classes[:2]] != ["5 cm", "10 cm"]
    counts = {c.name: c.count for c in data.damage.classes}
    text = text_of((tmp_path / "small.html").read_text(encoding="utf-8"))
    assert f"Displaced by 5 cm or more {counts['5 cm']} (" in text
    assert f"Displaced by 10 cm or more {counts['10 cm']} (" in text


def test_lengths_have_decimals_that_suit_the_units(tmp_path: Path) -> None:
    """Models of a tank moved by 0.8 ± 0.0 cm."""
    said = {}
    for height in (0.105, 2.3):
        path = laboratory_models(tmp_path / f"{height}.gpkg", f"UPDATE units SET height = {height}")  # noqa: S608
        with closing(sqlite3.connect(path)) as connection, connection:
            add_spatial_functions(connection)
            scale = height / 2.3
            for name in ("de", "dn", "dh", "d_3d", "sd_e", "sd_n", "sd_h"):
                connection.execute(f"UPDATE displacements SET {name} = {name} * ?", (scale,))  # noqa: S608
            connection.execute("UPDATE displacements SET significant = 1")
        data = write_report(path, path.with_suffix(".html"), ReportOptions(sections=("worst", "explorer"), worst=1))
        (worst,) = data.worst
        decimals = 1 if height > 1 else 2
        assert data.explorer["decimals"] == decimals
        row, (shown,) = worst.row, [unit for unit in data.explorer["units"] if unit["id"] == worst.row.unit_id]
        assert row.sd_3d is not None
        assert shown["sd"] == pytest.approx(100 * row.sd_3d, abs=0.51 * 0.1 ** (decimals + 1))
        said[height] = f"{100 * row.d_3d:.{decimals}f} ± {100 * row.sd_3d:.{decimals}f} cm"
        assert said[height] in text_of(path.with_suffix(".html").read_text(encoding="utf-8"))
    assert not said[0.105].endswith("± 0.00 cm")


def test_heights_and_widths_in_metres_have_decimals_that_suit_the_units() -> None:
    model, prototype = number_formats(0.105), number_formats(2.3)
    assert (prototype["m"](1.23456), prototype["rough_m"](1.23456), prototype["m"](None)) == ("1.235", "1.23", "–")
    assert (model["m"](0.01234), model["rough_m"](0.01234)) == ("0.0123", "0.012")


def test_units_left_to_decide_are_said_though_others_are_rejected(tmp_path: Path) -> None:
    path = tmp_path / "four.gpkg"
    write_result(path, 4, 2)
    (pair,) = epoch_pairs(path)
    units = [row.unit_id for row in read_unit_rows(path, pair, "stable")]
    decide(path, units[:1], pair, "rejected", comment="", reviewer="A")
    decide(path, units[1:-1], pair, "accepted", comment="", reviewer="A")
    write_report(path, tmp_path / "four.html", ReportOptions(sections=("summary",)))
    assert "no reviewer has decided on yet: 1." in text_of((tmp_path / "four.html").read_text(encoding="utf-8"))


def test_frames_of_few_units_and_of_control_in_one_epoch_are_said_as_they_are(reviewed: Path, tmp_path: Path) -> None:
    few, one = tmp_path / "few.gpkg", tmp_path / "one.gpkg"
    for path in (few, one):
        shutil.copy(reviewed, path)
    with closing(sqlite3.connect(one)) as connection, connection:
        add_spatial_functions(connection)
        connection.execute("DELETE FROM control_residuals WHERE epoch = ?", (PAIR.epoch_to,))
        for datum in ("stable", "control"):
            connection.execute(
                "INSERT INTO stretches (epoch_from, epoch_to, datum, along_from, along_to, units, de, dn, dh, sd_e, sd_n, sd_h, p_value,"
                " significant, detectable) VALUES (?, ?, ?, 0, 20, 12, 0.001, 0, 0, 0.002, 0.002, 0.002, 0.8, 0, 0.005)",
                (PAIR.epoch_from, PAIR.epoch_to, datum),
            )
    said = {}
    for path in (few, one):
        write_report(path, path.with_suffix(".html"), ReportOptions(sections=("frames",)))
        said[path] = text_of(path.with_suffix(".html").read_text(encoding="utf-8"))
    assert "too few units to tell a common motion" in said[few]
    assert "says nothing of its frames" not in said[few]
    assert "Not both epochs have survey control" in said[one]
    assert "against the targets" not in said[one]


def test_sections_and_pair_are_chosen(reviewed: Path, tmp_path: Path) -> None:
    options = ReportOptions(pair=EpochPair("2023-04-09", "2024-04-09"), datum="control", sections=("summary", "control"))
    data = write_report(reviewed, tmp_path / "short.html", options)
    assert data.worst == (), "no picture is drawn that no section shows"
    text = text_of((tmp_path / "short.html").read_text(encoding="utf-8"))
    assert "control points alone" in text
    assert "2023-04-09 → 2024-04-09" in text
    assert "Damage" not in text
    with pytest.raises(InputError, match="no section 'weather'"):
        write_report(reviewed, tmp_path / "none.html", ReportOptions(sections=("weather",)))
    assert not (tmp_path / "none.html").exists()


def test_every_section_renders_without_reviews_control_or_motion(tmp_path: Path) -> None:
    import sqlite3
    from contextlib import closing

    path = tmp_path / "bare.gpkg"
    write_result(path, 3, 2)
    with closing(sqlite3.connect(path)) as connection, connection:
        for statement in ("DELETE FROM control_residuals", "DELETE FROM check_residuals", "DROP TABLE reviews", "DELETE FROM epoch_pairs"):
            connection.execute(statement)
        connection.execute("UPDATE displacements SET significant = 0, class = 'stable'")
    write_report(path, tmp_path / "bare.html")
    text = text_of((tmp_path / "bare.html").read_text(encoding="utf-8"))
    assert "There is no survey control" in text
    assert "No displacement is significant." in text
    assert "no check points" in text


def test_wrong_ending_and_missing_folder_are_refused(reviewed: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"\.docx"):
        write_report(reviewed, tmp_path / "report.docx")
    with pytest.raises(OutputError, match="folder does not exist"):
        write_report(reviewed, tmp_path / "no" / "report.html")
    with pytest.raises(InputError, match="no epoch pair"):
        write_report(reviewed, tmp_path / "r.html", ReportOptions(pair=EpochPair("a", "b")))


def test_translation_comes_from_the_catalogues_of_the_interface(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    catalogue = (
        "<TS><context><name>tetratrack</name><message><source>Summary</source><translation>Résumé</translation></message></context></TS>"
    )
    (tmp_path / "tetratrack_fr.ts").write_text(catalogue, encoding="utf-8")
    monkeypatch.setattr(report_module, "CATALOGUES", tmp_path)
    assert translator("fr_CA")("Summary") == "Résumé"
    assert translator("fr")("Damage") == "Damage"
    assert translator("xx")("Summary") == "Summary"


def test_axis_is_read_or_refused() -> None:
    np.testing.assert_array_equal(parse_axis("0,0 10,5;20,5"), [[0, 0], [10, 5], [20, 5]])
    for text in ("", "1,2", "1,2 3", "a,b c,d", "1,2 nan,3"):
        with pytest.raises(InputError, match="not a list of places"):
            parse_axis(text)


def test_alarms_agree_in_both_forms(reviewed: Path, tmp_path: Path) -> None:
    count = write_alarms(reviewed, tmp_path / "a.csv", 0.10)
    assert write_alarms(reviewed, tmp_path / "a.geojson", 0.10) == count
    with (tmp_path / "a.csv").open(encoding="utf-8-sig", newline="") as stream:
        lines = list(csv.DictReader(stream))
    features = json.loads((tmp_path / "a.geojson").read_text(encoding="utf-8"))["features"]
    assert len(lines) == len(features) == count > 0
    rows = {row.unit_id: row for row in read_unit_rows(reviewed, PAIR, "stable")}
    rejected = max(rows.values(), key=lambda row: row.d_3d or 0).unit_id
    expected = {n for n, r in rows.items() if n != rejected and ((r.d_3d or 0) > 0.10 or r.kind in ("lost", "relocated"))}
    assert {line["unit_id"] for line in lines} == {f["properties"]["unit_id"] for f in features} == expected
    known = [float(line["d_3d"]) for line in lines if line["d_3d"]]
    assert known == sorted(known, reverse=True)
    with pytest.raises(InputError, match=r"\.txt"):
        write_alarms(reviewed, tmp_path / "a.txt", 0.1)


def test_geojson_without_a_code_for_its_crs_is_refused(tmp_path: Path) -> None:
    """Readers would take easting and northing for longitude and latitude."""
    path = tmp_path / "lab.gpkg"
    write_result(path, 4, 2)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(
            "UPDATE gpkg_spatial_ref_sys SET organization = 'NONE', organization_coordsys_id = 100000, definition = 'undefined'"
        )
    with pytest.raises(InputError, match=r"no EPSG code.*\.csv"):
        write_alarms(path, tmp_path / "a.geojson", 0.1)
    assert not (tmp_path / "a.geojson").exists()
    assert write_alarms(path, tmp_path / "a.csv", 0.0) > 0


@pytest.mark.parametrize("version", [WktVersion.WKT1_GDAL, WktVersion.WKT2_2019])
def test_geojson_names_the_horizontal_part_of_a_compound_crs(tmp_path: Path, version: WktVersion) -> None:
    path = tmp_path / "heights.gpkg"
    write_result(path, 4, 2)
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(
            "UPDATE gpkg_spatial_ref_sys SET organization = 'NONE', organization_coordsys_id = 100000, definition = ?",
            (CRS("EPSG:25832+7837").to_wkt(version),),
        )
    write_alarms(path, tmp_path / "a.geojson", 0.0)
    assert json.loads((tmp_path / "a.geojson").read_text(encoding="utf-8"))["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::25832"


def test_formula_in_a_comment_stays_text(reviewed: Path, tmp_path: Path) -> None:
    rows = sorted(read_unit_rows(reviewed, EpochPair("2023-04-09", "2024-04-09"), "stable"), key=lambda row: -(row.d_3d or 0))
    pair = EpochPair("2023-04-09", "2024-04-09")
    decide(reviewed, [rows[0].unit_id], pair, "accepted", comment="=1+1", reviewer="A")
    write_alarms(reviewed, tmp_path / "a.csv", 0.01, pair=pair)
    assert "'=1+1" in (tmp_path / "a.csv").read_text(encoding="utf-8")


def test_every_section_has_a_template() -> None:
    assert {path.name for path in report_module.TEMPLATES.glob("section_*.html")} == {f"section_{name}.html" for name in SECTIONS}


def test_commands_end_with_their_exit_codes(reviewed: Path, tmp_path: Path) -> None:
    from tetratrack.scripts.cli import app
    from typer.testing import CliRunner

    runner = CliRunner()
    done = runner.invoke(
        app, ["report", str(reviewed), "-o", str(tmp_path / "r.html"), "--worst", "0", "--axis", "236490,285150 236540,285185"]
    )
    assert done.exit_code == 0, done.output
    assert "Sections along the axis" in (tmp_path / "r.html").read_text(encoding="utf-8")
    done = runner.invoke(app, ["alarms", str(reviewed), "-o", str(tmp_path / "a.csv"), "--from", PAIR.epoch_from, "--to", PAIR.epoch_to])
    assert done.exit_code == 0, done.output
    for arguments in (
        ["report", str(tmp_path / "none.gpkg"), "-o", str(tmp_path / "r.html")],
        ["report", str(reviewed), "-o", str(tmp_path / "r.html"), "--axis", "1,2"],
        ["alarms", str(reviewed), "-o", str(tmp_path / "a.csv"), "--from", "2024-04-09"],
        ["refit", str(reviewed), "--unit", "U00001", "--epoch", "2024-04-09", "--near", "here", "--editor", "A"],
    ):
        done = runner.invoke(app, arguments)
        assert done.exit_code == 2, done.output
        assert "Traceback" not in done.output


def test_page_of_laboratory_models_is_drawn_in_their_size(tmp_path: Path) -> None:
    """Arrows, outlines and the words for a frame without a CRS."""
    path = laboratory_models(tmp_path / "small.gpkg", "UPDATE gpkg_geometry_columns SET srs_id = -1")
    data = write_report(path, tmp_path / "small.html", ReportOptions(sections=("summary",)))
    assert data.explorer["height"] == 0.105
    assert data.explorer["outline_steps"] == 1000
    lengths = [math.hypot(dx, dn) for _, _, dx, dn, _ in data.explorer["arrows"]["drawn"]]
    assert lengths
    true = [math.hypot(u["e"], u["n"]) / 100 for u in data.explorer["units"] if u["significant"] and u["e"] is not None]
    assert max(lengths) <= max(4 * 0.105, *true) + 1e-3
    page = text_of((tmp_path / "small.html").read_text(encoding="utf-8"))
    assert "a local frame" in page
    assert "Undefined" not in page


def _with_doubtful_heap(path: Path) -> list[str]:
    """A result of 60 units with ten more, high above its crest, that are uncertain in the later epoch; their names."""
    units = make_units(70, 2, seed=5)
    units = [replace(unit, fate="stable", centres=unit.centres + np.array([0, 0, 6.0 * (k >= 60)])) for k, unit in enumerate(units)]
    write_result(path, epochs=2, units=units)
    names = [unit.unit_id for unit in units[60:]]
    with closing(sqlite3.connect(path)) as connection, connection:
        add_spatial_functions(connection)
        for name in names:
            connection.execute("UPDATE units SET status = 'uncertain' WHERE epoch = '2024-04-09' AND unit_id = ?", (name,))
            connection.execute("UPDATE displacements SET class = 'uncertain', d_3d = 0.4 WHERE unit_id = ?", (name,))
    return names


def test_pages_on_the_structure_and_the_layer_count_the_same_units(tmp_path: Path) -> None:
    """Uncertain units counted in the page on placement, in the crest and in the histogram, and nowhere else."""
    path = tmp_path / "result.gpkg"
    _with_doubtful_heap(path)
    rows = [{**row, "geometry": row["geom"]} for row in read_layer_rows(path, "units") if row["epoch"] == "2024-04-09"]
    layer = placement_rows(rows, unit_sizes(read_epochs(path)))
    data = write_report(path, tmp_path / "report.html", ReportOptions(sections=("placement", "profiles"), worst=0))
    placement, profiles = data.structure.placement, data.structure.profiles
    assert placement is not None
    assert profiles is not None
    assert placement.units == len(layer) == 60
    assert {found.number: found.units for found in placement.layers} == Counter(int(row["layer"]) for row in layer)
    tops = {row["along"]: row["crest_highest"] for row in profiles.crest if row["epoch"] == "2023-04-09"}
    sure = {row["along"]: row["crest_highest"] for row in profiles.crest if row["epoch"] == "2024-04-09"}
    assert max(tops.values()) > max(sure.values()) + 5, "of the epoch that has them for sure they are the crest"


def test_histogram_counts_the_units_that_the_table_of_damage_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "result.gpkg"
    doubtful = _with_doubtful_heap(path)
    drawn: list[str] = []
    monkeypatch.setattr(figures, "histogram", lambda rows, *others: drawn.extend(row.unit_id for row in rows) or "")
    data = write_report(path, tmp_path / "report.html", ReportOptions(sections=("displacements",), worst=0))
    assert data.damage is not None
    assert len(drawn) == data.damage.units
    assert not set(drawn) & set(doubtful)


def test_rejected_units_are_in_no_page_on_the_structure(tmp_path: Path) -> None:
    """The summary says that they are left out of all tables; crest, sections and design had them."""
    path, plan = tmp_path / "result.gpkg", tmp_path / "plan.csv"
    heap = _with_doubtful_heap(path)
    (pair,) = epoch_pairs(path)
    decide(path, heap, pair, "rejected", comment="", reviewer="A")
    rows = [row for row in read_layer_rows(path, "units") if row["epoch"] == pair.epoch_to]
    places = [",".join([row["unit_id"], *(f"{value:.3f}" for value in row["geom"])]) for row in rows]
    plan.write_text("\n".join(["unit_id,easting,northing,height", *places]) + "\n", encoding="utf-8")
    options = ReportOptions(sections=("summary", "profiles", "design"), worst=0, structure=StructureOptions(design=Design(plan=str(plan))))
    data = write_report(path, tmp_path / "report.html", options)
    profiles, design = data.structure.profiles, data.structure.design
    assert profiles is not None
    assert design is not None
    assert design.plan is not None
    assert not {row.get("unit_id") for row in profiles.sections} & set(heap)
    assert max(row["crest_highest"] for row in profiles.crest) < max(row["geom"][2] for row in rows)
    assert {row["unit_id"] for row in design.plan.deviations} == {row["unit_id"] for row in rows} - set(heap)
    assert {row["plan_id"] for row in design.plan.unmatched} == set(heap)
