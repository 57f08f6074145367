"""Files appear whole or not at all, and what killed processes left goes with the next write."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tetratrack.core.common.atomic_files import temporary_beside, temporary_folder, write_whole
from tetratrack.core.common.errors import OutputError
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.geopackage_writer import write_result

KILLED = """
import os, signal, sys
from pathlib import Path
from tetratrack.core.common.atomic_files import temporary_beside, temporary_folder
with temporary_beside(Path(sys.argv[1])) as file, temporary_folder(Path(sys.argv[1]).parent) as folder:
    file.write_text("half"), (folder / "block.npz").write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(os.name != "posix", reason="on Windows every process counts as running")
def test_leftovers_of_killed_processes_go_and_those_of_living_ones_stay(tmp_path: Path) -> None:
    target = tmp_path / "a.csv"
    subprocess.run([sys.executable, "-c", KILLED, str(target)], check=False)
    assert len(list(tmp_path.iterdir())) == 2
    with temporary_beside(target) as living:
        write_whole(target, b"whole")
        assert living.exists()
    with temporary_folder(tmp_path):
        pass
    assert list(tmp_path.iterdir()) == [target]
    assert target.read_bytes() == b"whole"


def test_a_folder_in_the_place_of_a_file_is_refused_and_nothing_left(tmp_path: Path) -> None:
    (tmp_path / "a.csv").mkdir()
    with pytest.raises(OutputError, match="is a folder"):
        write_whole(tmp_path / "a.csv", b"text")
    with pytest.raises(OutputError, match="cannot be written"):
        write_whole(tmp_path / "none" / "a.csv", b"text")
    assert [path.name for path in tmp_path.iterdir()] == ["a.csv"]


@pytest.mark.skipif(os.name != "posix", reason="links need no rights there")
@pytest.mark.parametrize("there", [True, False], ids=["to a file", "to nothing yet"])
def test_a_link_is_followed_and_stays(tmp_path: Path, there: bool) -> None:
    (tmp_path / "disk").mkdir()
    (tmp_path / "site").mkdir()
    for name in ("page.html", "result.gpkg"):
        behind, link = tmp_path / "disk" / name, tmp_path / "site" / name
        link.symlink_to(Path("..") / "disk" / name)
        if name == "page.html":
            if there:
                behind.write_bytes(b"old")
            write_whole(link, b"new")
            assert behind.read_bytes() == b"new"
        else:
            if there:
                write_result(behind, "LOCAL", {})
            write_result(link, "LOCAL", {})
            assert read_layer_rows(behind, "units") == []
        assert link.is_symlink()
        assert not behind.is_symlink()
    assert sorted(path.name for path in tmp_path.rglob("*.*")) == ["page.html", "page.html", "result.gpkg", "result.gpkg"]


@pytest.mark.skipif(os.name != "posix", reason="another limit")
def test_a_name_that_is_too_long_is_said_to_be(tmp_path: Path) -> None:
    for length in (240, 300):
        with pytest.raises(OutputError, match=rf"Choose a shorter name: this one has {length} bytes"):
            write_whole(tmp_path / ("a" * (length - 4) + ".csv"), b"text")
