"""No output eats an input or another output; whatever is refused is as it was."""

from __future__ import annotations

import hashlib
import os
import shutil
from pathlib import Path

import pytest
from crooked_las import write_survey
from las_files import grid_points, write_las
from tetratrack.core.common.atomic_files import write_whole
from tetratrack.core.common.errors import OutputError
from tetratrack.core.common.output_files import check_targets, safe_name
from tetratrack.scripts.cli import app
from typer.testing import CliRunner


@pytest.fixture
def site(tiny: Path, result: Path, tmp_path: Path) -> Path:
    """A copy of the tiny survey with its result."""
    shutil.copytree(tiny, tmp_path / "site", ignore=shutil.ignore_patterns("truth"))
    shutil.copy(result, tmp_path / "site" / "result.gpkg")
    return tmp_path / "site"


def sums(folder: Path) -> dict[str, str]:
    """Checksum of every file."""
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest() for p in folder.rglob("*") if p.is_file()}


def refused(site: Path, *arguments: str, said: str) -> None:
    """The command ends with exit code 2 and one sentence, and changes no file."""
    before = sums(site)
    done = CliRunner().invoke(app, [argument.replace("SITE", str(site)) for argument in arguments])
    assert done.exit_code == 2, done.output
    assert said in done.stderr
    assert "Traceback" not in done.output
    assert sums(site) == before


INPUT = "is one of the inputs and would be overwritten"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("label-tiles", "SITE/survey.toml", "SITE/result.gpkg", "--folder", "SITE/tiles"), INPUT),
        (
            ("inspect", "-o", "SITE/tiles/2024-04-09/tiny_20240409_00.laz", "SITE/tiles/2024-04-09/tiny_20240409_10.laz"),
            "is no layer of tiles",
        ),
        (("inspect", "SITE/survey.toml", "-o", "SITE/survey.toml"), INPUT),
        (("inspect", "SITE/survey.toml", "-o", "SITE/control_2024-04-09.csv"), INPUT),
        (("inspect", "SITE/survey.toml", "-o", "SITE/result.gpkg"), "exists and is no layer of tiles"),
        (("run", "SITE/survey.toml", "-o", "SITE/survey.toml"), INPUT),
        (("segment", "SITE/survey.toml", "-o", "SITE/tiles/2024-04-09/tiny_20240409_00.laz"), INPUT),
        (("fit", "SITE/survey.toml", "--units", "SITE/result.gpkg", "-o", "SITE/result.gpkg"), INPUT),
        (("features", "SITE/result.gpkg", "-o", "SITE/result.gpkg"), INPUT),
        (("track", "SITE/result.gpkg", "-o", "SITE/result.gpkg"), INPUT),
        (("track", "SITE/result.gpkg", "--registration", "SITE/survey.toml", "-o", "SITE/survey.toml"), INPUT),
        (("validate", "SITE/result.gpkg", "--check", "SITE/check_2024-04-09.csv", "-o", "SITE/check_2024-04-09.csv"), INPUT),
        (("report", "SITE/result.gpkg", "-o", "SITE/result.gpkg"), "End the name in .html or .pdf"),
        (("alarms", "SITE/result.gpkg", "-o", "SITE/result.gpkg"), "End the name in .csv or .geojson"),
        (("register-views", "SITE/tiles/2024-04-09/tiny_20240409_00.laz", "-o", "SITE/tiles/2024-04-09/tiny_20240409_00.laz"), INPUT),
        (("batch", "SITE/survey.toml", "SITE/survey.toml"), "would be written twice"),
        (("inspect", "SITE/survey.toml", "--log-file", "SITE/survey.toml"), "is no name for a log"),
    ],
)
def test_an_output_that_is_an_input_is_refused(site: Path, arguments: tuple[str, ...], said: str) -> None:
    refused(site, *arguments, said=said)


def test_links_and_other_ways_to_write_a_path_are_seen_through(tmp_path: Path) -> None:
    tile = write_las(tmp_path / "a.laz", grid_points())
    (tmp_path / "link.laz").symlink_to(tile)
    (tmp_path / "hard.laz").hardlink_to(tile)
    (tmp_path / "x").mkdir()
    for name in ("link.laz", "hard.laz", "x/../a.laz"):
        with pytest.raises(OutputError, match=INPUT):
            check_targets([(tmp_path / name, "tiles")], [tile])
    with pytest.raises(OutputError, match="would be written twice, for one and for two"):
        check_targets([(tmp_path / "b.laz", "one"), (tmp_path / "x" / ".." / "b.laz", "two")])
    check_targets([(tmp_path / "b.laz", "one")], [tile, tmp_path / "gone.laz"])


def test_a_way_that_leads_over_a_folder_not_there_yet_is_seen_through(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Once the folder is made, ``x/../tiles`` is the folder of the tiles."""
    monkeypatch.chdir(site)
    refused(site, "label-tiles", "survey.toml", "result.gpkg", "--folder", "x/../tiles", said=INPUT)


def test_a_device_is_no_file_to_be_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    with pytest.raises(OutputError, match="is a device, not a file"):
        write_whole(tmp_path / "pipe.csv", b"a")
    with pytest.raises(OutputError, match="too long"):
        write_whole(tmp_path / ("x" * 300), b"a")
    with pytest.raises(OutputError, match="too long"):
        check_targets([(tmp_path / ("x" * 300), "the result")])


def test_tables_of_others_are_not_replaced(site: Path) -> None:
    """Neither control, which a result does not know the place of, nor what a user wrote into a table of an earlier export."""
    result = str(site / "result.gpkg")
    foreign = "exists and was not written by this command"
    refused(site, "alarms", result, "-o", "SITE/control_2024-04-09.csv", "--threshold", "0", said=foreign)
    (site / "areas.geojson").write_text('{"type": "FeatureCollection", "features": [{"type": "Feature"}]}')
    refused(site, "alarms", result, "-o", "SITE/areas.geojson", "--threshold", "0", said=foreign)
    (site / "out").mkdir()
    (site / "out" / "units.csv").write_text("my notes on units\n")
    refused(site, "export", result, "-o", "SITE/out", said=foreign)
    (site / "out" / "units.csv").write_text("")
    for _ in range(2):
        for arguments in (
            ("export", "-o", "out"),
            ("alarms", "-o", "a.csv", "--threshold", "0"),
            ("alarms", "-o", "a.geojson", "--threshold", "9"),
        ):
            done = CliRunner().invoke(app, [arguments[0], result, "-o", str(site / arguments[2]), *arguments[3:]])
            assert done.exit_code == 0, done.output


def test_two_reliefs_of_one_name_are_refused(tmp_path: Path) -> None:
    for k in (1, 2):
        write_las(tmp_path / f"{k}.laz", grid_points())
    epochs = "".join(
        f'[[epoch]]\nlabel = "{label}"\ntime = 2024-0{k}-14T02:30:00Z\ntiles = "{k}.laz"\n' for k, label in ((1, "a b"), (2, "a/b"))
    )
    survey = write_survey(tmp_path, epochs=epochs)
    done = CliRunner().invoke(app, ["relief", str(survey), "-o", str(tmp_path / "relief")])
    assert done.exit_code == 2
    assert "relief_a-b.tif: would be written twice, for epoch a b and for epoch a/b" in done.stderr
    # letters of other scripts stay apart
    assert [safe_name(label) for label in ("봄", "가을", "../up")] == ["봄", "가을", "-up"]


def test_a_layer_of_tiles_may_be_written_again(site: Path) -> None:
    for _ in range(2):
        done = CliRunner().invoke(app, ["inspect", str(site / "survey.toml"), "-o", str(site / "tiles.gpkg")])
        assert done.exit_code == 0, done.output
