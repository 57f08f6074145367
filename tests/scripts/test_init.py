"""Command ``init`` and ``run FOLDER``: what the files say goes into survey.toml, what they leave open is asked, nothing is guessed."""

from __future__ import annotations

import json
import re
import shutil
import tomllib
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import open3d
import pytest
from las_files import grid_points, write_las
from tetratrack.core.common.errors import InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.pipeline.given_survey import Given
from tetratrack.core.pipeline.new_survey import survey_of_tiles
from tetratrack.scripts.cli import app
from typer.testing import CliRunner

TINY = Path(__file__).resolve().parents[1] / "data" / "tiny"


def _init(*arguments: object) -> tuple[str, str]:
    result = CliRunner().invoke(app, ["init", *map(str, arguments)])
    assert result.exit_code == 0, result.output
    return result.stdout, result.stderr


def test_everything_that_the_files_of_a_survey_say(tmp_path: Path) -> None:
    text, _ = _init(TINY / "tiles", "--height", 2.3)
    (tmp_path / "survey.toml").write_text(text, encoding="utf-8")
    drafted, given = read_survey(tmp_path / "survey.toml"), read_survey(TINY / "survey.toml")
    assert (drafted.name, drafted.crs, drafted.unit.height) == ("tiny", given.crs, given.unit.height)
    for ours, theirs in zip(drafted.epochs, given.epochs, strict=True):
        assert (ours.label, ours.tiles, ours.control, ours.targets, ours.check) == (
            theirs.label,
            theirs.tiles,
            theirs.control,
            theirs.targets,
            theirs.check,
        )
        assert abs((ours.time - theirs.time).total_seconds()) < 600


def test_check_points_that_a_run_cannot_read_are_named(tmp_path: Path) -> None:
    """Northing before easting, or feet: no key of survey.toml turns them, and they were left out without a word.

    Decimal commas can be read.
    """
    shutil.copytree(TINY, tmp_path / "site")
    (tmp_path / "site" / "survey.toml").unlink()
    table = tmp_path / "site" / "check_2024-04-09.csv"
    head, *rows = (line.split(",") for line in table.read_text(encoding="utf-8").splitlines())
    turned = [head, *([r[0], r[2], r[1], r[3], r[5], r[4], *r[6:]] for r in rows)]
    table.write_text("\n".join(map(";".join, turned)).replace(".", ","), encoding="utf-8")
    text, _ = _init(tmp_path / "site", "--height", 2.3)
    assert "check_2024-04-09.csv looks like check points (northing before easting)" in text
    assert 'check_2024-04-09.csv"' not in text


@pytest.mark.parametrize(("turned", "said"), [(True, "northing before easting"), (False, "feet")])
def test_targets_that_a_run_refuses_are_asked_about(tmp_path: Path, turned: bool, said: str) -> None:
    shutil.copytree(TINY, tmp_path / "site")
    (tmp_path / "site" / "survey.toml").unlink()
    table = tmp_path / "site" / "targets_2024-04-09.csv"
    head, *rows = (line.split(",") for line in table.read_text(encoding="utf-8").splitlines())
    others = [[r[0], r[2], r[1], *r[3:]] if turned else [r[0], *(f"{float(v) / 0.3048:.4f}" for v in r[1:4]), *r[4:]] for r in rows]
    table.write_text("\n".join(map(",".join, [head, *others])), encoding="utf-8")
    _, errors = _init(tmp_path / "site", "--height", 2.3)
    assert f"targets_2024-04-09.csv holds targets otherwise than the tiles ({said}): write them as x,y,z in metres" in " ".join(
        errors.split()
    )


def test_paths_are_relative_to_a_file_beside_the_data(tmp_path: Path) -> None:
    shutil.copytree(TINY / "tiles", tmp_path / "site" / "tiles")
    _init(tmp_path / "site", "--height", 2.3, "--output", tmp_path / "site" / "survey.toml")
    data = tomllib.loads((tmp_path / "site" / "survey.toml").read_text(encoding="utf-8"))
    assert [epoch["tiles"] for epoch in data["epoch"]] == ["tiles/2024-04-09/*.laz", "tiles/2024-10-09/*.laz"]


def test_a_file_of_the_users_own_is_not_replaced(tmp_path: Path) -> None:
    own = tmp_path / "survey.toml"
    own.write_text("# mine\n")
    result = CliRunner().invoke(app, ["init", str(TINY / "tiles"), "--height", "2.3", "--output", str(own)])
    assert result.exit_code == 2
    assert "is there already" in result.stderr
    assert own.read_text() == "# mine\n"


def test_a_draft_is_written_again_until_it_is_corrected(tmp_path: Path) -> None:
    draft = tmp_path / "survey.toml"
    words = ["init", str(TINY / "tiles"), "--height", "2.3", "--output", str(draft)]
    for _ in range(2):
        assert CliRunner().invoke(app, words).exit_code == 0
    as_drafted = draft.read_text(encoding="utf-8")
    # as an editor on Windows or a pipe leaves it
    draft.write_bytes((as_drafted + "\n").replace("\n", "\r\n").encode("utf-8"))
    assert CliRunner().invoke(app, words).exit_code == 0
    assert draft.read_text(encoding="utf-8") == as_drafted
    for corrected in (as_drafted.replace("height = 2.3", "height = 2.4"), re.sub(r"\. Checksum \w+", "", as_drafted)):
        assert corrected != as_drafted
        draft.write_text(corrected, encoding="utf-8")
        for again in (words, ["run", str(TINY / "tiles"), "--height", "2.3", "-o", str(tmp_path / "survey.gpkg")]):
            refused = CliRunner().invoke(app, again)
            assert refused.exit_code == 2, refused.output
            assert "survey.toml: was corrected since it was drafted" in refused.stderr
            assert f"tetratrack run {draft}" in refused.stderr
        assert draft.read_text(encoding="utf-8") == corrected


def test_a_run_that_drafted_a_folders_survey_can_be_made_again(tmp_path: Path) -> None:
    """The draft lies beside the result, here in the folder itself: it is no survey of the folder's own until somebody corrects it."""
    shutil.copytree(TINY / "tiles", tmp_path / "tiles")
    draft = tmp_path / "tiles" / "survey.toml"
    for height in (2.3, 2.4):
        survey = survey_of_tiles([tmp_path / "tiles"], Given(height=height), draft, Feedback())
        assert survey.unit.height == height
    draft.write_text(draft.read_text(encoding="utf-8") + "# mine\n", encoding="utf-8")
    with pytest.raises(InputError, match="are for folders without"):
        survey_of_tiles([tmp_path / "tiles"], Given(height=2.3), draft, Feedback())


def test_a_missing_crs_is_asked_for(tmp_path: Path) -> None:
    write_las(tmp_path / "a_20240409.laz", grid_points(), crs=None)
    text, said = _init(tmp_path)
    assert 'crs = ""  # ASK' in text
    assert "--crs" in said
    refused = CliRunner().invoke(app, ["run", str(tmp_path), "--output", str(tmp_path / "result.gpkg")])
    assert refused.exit_code == 2
    assert "--crs" in refused.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a_20240409.laz"]


def test_folders_that_may_be_two_epochs_are_asked_about(tmp_path: Path) -> None:
    for k in (1, 2):
        (tmp_path / "site_2024" / f"run{k}").mkdir(parents=True)
        write_las(tmp_path / "site_2024" / f"run{k}" / "a.laz", grid_points() + 0.1 * k)
    text, _ = _init(tmp_path / "site_2024", "--height", 2.3)
    assert "ASK: 2024: folders run1 and run2 show the same ground" in text
    refused = CliRunner().invoke(app, ["run", str(tmp_path / "site_2024"), "--height", "2.3", "--output", str(tmp_path / "result.gpkg")])
    assert (refused.exit_code, "if they are one, take this line out" in refused.stderr) == (2, True)


def test_a_folder_with_its_own_survey_says_all_itself(tmp_path: Path) -> None:
    own = tmp_path / "survey.toml"
    own.write_text("[survey]\n", encoding="utf-8")
    for option in (["--height", "4.4"], ["--crs", "EPSG:32651"]):
        told = CliRunner().invoke(app, ["run", str(tmp_path), *option, "--output", str(tmp_path / "result.gpkg")])
        assert (told.exit_code, f"{own}: --crs and --height are for folders without" in told.stderr) == (2, True), told.output


def test_a_crs_given_for_tiles_without_one(tmp_path: Path) -> None:
    write_las(tmp_path / "a_20240409.laz", grid_points(), crs=None)
    data = tomllib.loads(_init(tmp_path, "--crs", "EPSG:32650", "--height", 2.3)[0])
    assert (data["survey"]["crs"], data["epoch"][0]["undeclared_crs"]) == ("EPSG:32650", "EPSG:32650")


def test_epochs_that_do_not_overlap_are_named(tmp_path: Path) -> None:
    write_las(tmp_path / "a_20240409.laz", grid_points())
    write_las(tmp_path / "a_20250409.laz", grid_points() + np.array([200, 0, 0]))
    _, said = _init(tmp_path, "--height", 2.3)
    assert "do not overlap" in said


def _found(*arguments: object) -> dict[str, Any]:
    stdout, _ = _init(*arguments, "--json-progress")
    return next(found for line in stdout.splitlines() if (found := json.loads(line))["event"] == "result")["outputs"]


def test_a_table_of_epochs_comes_without_the_size() -> None:
    draft = _found(TINY / "tiles", "--no-size")["draft"]
    first, second = draft["epochs"]
    assert (first["label"], second["label"]) == ("2024-04-09", "2024-10-09")
    assert len(first["tiles"]) == len(first["footprint"]) == 2
    assert first["points"] > 10_000
    assert first["density"] > 50
    assert first["crs"] == "EPSG:32650"
    assert Path(first["files"]["control"]).name == "control_2024-04-09.csv"
    assert draft["units"][0]["height"] is None


def test_corrected_epochs_become_a_survey(tmp_path: Path) -> None:
    draft = _found(TINY / "tiles", "--no-size")["draft"]
    rows = [{key: epoch[key] for key in ("label", "time", "tiles", "files")} for epoch in draft["epochs"]]
    rows[0] |= {"label": "before", "time": "2024-04-08T05:00:00+09:00"}
    rows[1]["files"] = {"check": rows[1]["files"]["check"]}
    table = tmp_path / "rows.json"
    table.write_text(json.dumps(rows), encoding="utf-8")
    written = _found("--epochs", table, "--name", "harbour", "--height", 2.3, "--output", tmp_path / "survey.toml")
    survey = read_survey(Path(written["survey"]))
    assert (survey.name, [epoch.label for epoch in survey.epochs]) == ("harbour", ["before", "2024-10-09"])
    assert survey.epochs[0].time == datetime(2024, 4, 7, 20, tzinfo=UTC)
    assert survey.epochs[0].control is not None
    assert (survey.epochs[1].control, survey.epochs[1].check is None) == (None, False)


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([], "no epoch is given"),
        ([{"tiles": []}], "has no tiles"),
        ([{"tiles": ["a.laz"], "time": "soon"}], "holds no epochs"),
        ([{"tiles": ["a.laz"]}, {"label": "2", "tiles": ["a.laz"]}], "tile of two epochs"),
    ],
)
def test_rows_that_make_no_survey_are_refused(tmp_path: Path, rows: list[dict[str, object]], said: str) -> None:
    write_las(tmp_path / "a.laz", grid_points())
    stated = [row | {"tiles": [str(tmp_path / str(tile)) for tile in row["tiles"]]} for row in rows]  # type: ignore[union-attr]
    (tmp_path / "rows.json").write_text(json.dumps(stated), encoding="utf-8")
    result = CliRunner().invoke(app, ["init", "--epochs", str(tmp_path / "rows.json"), "--height", "2.3"])
    assert result.exit_code == 2
    assert said in result.stderr


def test_no_units_says_why(tmp_path: Path) -> None:
    write_las(tmp_path / "a_20240409.laz", grid_points())
    text, said = _init(tmp_path)
    assert "# height" in text
    assert "400 points" in said


def test_scans_without_a_crs_make_a_survey_once_it_is_given(tmp_path: Path) -> None:
    for day in ("2024-04-09", "2024-10-09"):
        (tmp_path / day).mkdir()
        open3d.t.io.write_point_cloud(tmp_path / day / "wall.PLY", open3d.t.geometry.PointCloud(open3d.core.Tensor(grid_points())))
    _, said = _init(tmp_path, "--height", 2.3)
    assert "declare no CRS: give it with --crs" in said
    text, _ = _init(f'"{tmp_path / "2024-04-09"}" "{tmp_path / "2024-10-09"}"', "--height", 2.3, "--crs", "EPSG:32650")
    (tmp_path / "survey.toml").write_text(text, encoding="utf-8")
    survey = read_survey(tmp_path / "survey.toml")
    assert [(epoch.label, epoch.tiles[0].name, epoch.undeclared_crs) for epoch in survey.epochs] == [
        ("2024-04-09", "wall.PLY", "EPSG:32650"),
        ("2024-10-09", "wall.PLY", "EPSG:32650"),
    ]


def test_points_of_the_buffers_of_tiles_count_once(tmp_path: Path) -> None:
    points = grid_points()
    for name, part in (("a_20240409.LAZ", points[:300]), ("b_20240409.laz", points[200:])):
        write_las(tmp_path / name, part)
    text, _ = _init(tmp_path / "*.laz", "--height", 2.3)
    (tmp_path / "survey.toml").write_text(text, encoding="utf-8")
    survey = read_survey(tmp_path / "survey.toml")
    tiles = [inspect_tile(path, survey.crs) for path in survey.epochs[0].tiles]
    assert sum(tile.points for tile in tiles) == len(points) + 100
    assert len(read_points(tiles, survey.crs)) == len(points)


def test_a_survey_among_tiles_is_refused(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["run", str(TINY / "survey.toml"), str(TINY / "tiles"), "--output", str(tmp_path / "result.gpkg")])
    assert result.exit_code == 2
    assert "Give the survey file alone" in result.stderr


def test_where_nothing_can_be_written_is_said_before_the_tiles_are_looked_at(tmp_path: Path) -> None:
    (tmp_path / "own.toml").write_text("# mine\n")
    for output, said in ((tmp_path / "gone" / "result.gpkg", "its folder does not exist"), (tmp_path / "own.gpkg", "is there already")):
        result = CliRunner().invoke(app, ["run", str(TINY / "tiles"), "--output", str(output)])
        assert result.exit_code == 2
        assert said in result.stderr
        assert "epoch 2024-04-09" not in result.stderr
    assert (tmp_path / "own.toml").read_text() == "# mine\n"


def test_no_folder_is_said(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["init"])
    assert result.exit_code == 2
    assert "no folder is given" in result.stderr


def test_folders_and_patterns_can_be_inspected(tmp_path: Path) -> None:
    for name in ("a.laz", "b.LAZ"):
        write_las(tmp_path / name, grid_points())
    for given in (str(tmp_path), str(tmp_path / "*.laz"), f'"{tmp_path / "a.laz"}" "{tmp_path / "b.LAZ"}"'):
        result = CliRunner().invoke(app, ["inspect", given])
        assert result.exit_code == 0, result.output
        assert "tiles 2, points 800" in result.output
    (tmp_path / "empty").mkdir()
    result = CliRunner().invoke(app, ["inspect", str(tmp_path / "empty")])
    assert result.exit_code == 2
    assert "holds no point cloud" in result.stderr


@pytest.mark.slow
def test_a_folder_runs_without_asking(tmp_path: Path) -> None:
    output = tmp_path / "result.gpkg"
    result = CliRunner().invoke(app, ["run", str(TINY / "tiles"), "--output", str(output), "--workers", "1"])
    assert result.exit_code == 0, result.output
    assert output.is_file()
    assert read_survey(tmp_path / "result.toml").unit.height == pytest.approx(2.3, rel=0.01)
