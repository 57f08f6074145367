"""Every reader against files that were changed at random: it reads, or refuses in one sentence.

Half a minute in the test suite. For hours: ``TETRATRACK_FUZZ_EXAMPLES=100000 pytest tests/fuzz``. What is found goes into ``corpus/``,
which is read again every time. Tiles have a test of their own (``tests/faults/test_damaged_tiles.py``), in a process of its own.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import synthetic_result
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from las_files import grid_points, write_las
from tetratrack.core.common.errors import TetratrackError
from tetratrack.core.data.point_tables import read_control, read_targets
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.job_runner import load_arrays, save_arrays
from tetratrack.core.report.alarms import write_alarms
from tetratrack.core.results.geopackage_reader import SELECT_ALL, read_layer_rows
from tetratrack.core.results.unit_rows import read_epochs
from tetratrack.core.review.point_index import PointIndex, index_folder

CORPUS = Path(__file__).parent / "corpus"
EXAMPLES = int(os.environ.get("TETRATRACK_FUZZ_EXAMPLES", "60"))
LONGEST_SECONDS = 60.0

Reader = Callable[[Path], None]

WORDS = [
    b"\x00",
    b"\xff",
    b'"',
    b"'",
    b"[",
    b"{",
    b"=",
    b".",
    b",",
    b"\n",
    b"-",
    b"9" * 400,
    b"1e308",
    b"nan",
    b"\xc3\x28",
    b"../",
    b"\x7f" * 8,
]
EDIT = st.tuples(st.floats(0, 1, exclude_max=True), st.sampled_from(["flip", "put", "insert", "cut", "end"]), st.sampled_from(WORDS))
EDITS = st.lists(EDIT, min_size=1, max_size=6)


def _edited(data: bytes, edits: list[tuple[float, str, bytes]]) -> bytes:
    changed = bytearray(data)
    for share, kind, word in edits:
        at = int(share * len(changed))
        if kind == "flip" and changed:
            changed[at] ^= 1 << (len(word) + word[0]) % 8
        elif kind == "put":
            changed[at : at + len(word)] = word
        elif kind == "insert":
            changed[at:at] = word
        elif kind == "cut":
            del changed[at : at + 8 * len(word)]
        elif kind == "end":
            del changed[at:]
    return bytes(changed)


def _survives(reader: Reader, path: Path) -> None:
    start = time.monotonic()
    told = ""
    try:
        reader(path)
    except TetratrackError as error:
        told = str(error)
    assert "\n" not in told
    assert len(told) < 1500 + len(str(path))
    assert time.monotonic() - start < LONGEST_SECONDS


def _read_survey(path: Path) -> None:
    read_survey(path)


def _read_table(path: Path) -> None:
    with suppress(TetratrackError):
        read_targets(path)
    read_control(path)


def _read_block(path: Path) -> None:
    load_arrays(path)


def _read_result(path: Path) -> None:
    read_epochs(path)
    for layer in SELECT_ALL:
        read_layer_rows(path, layer)
    write_alarms(path, path.with_suffix(".csv"), 0.0)


def _read_index(path: Path) -> None:
    index = PointIndex(path.parent)
    for epoch in index.epochs:
        index.read(epoch, synthetic_result.ORIGIN, 20.0)


@pytest.fixture(scope="module")
def seeds(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """A sound file for each reader."""
    folder = tmp_path_factory.mktemp("seeds")
    write_las(folder / "a.laz", grid_points())
    (folder / "survey.toml").write_text(
        '[survey]\nname = "s"\ncrs = "EPSG:32650"\n[[unit]]\ntype = "tetrapod"\nheight = 2.3\narea = [[1, 2], [3.5, 4], [5, 6]]\n'
        '[[epoch]]\nlabel = "a"\ntime = 2025-03-14T02:30:00Z\ntiles = ["a.laz"]\n[displacement]\nsignificance = 0.05\n',
        encoding="utf-8",
    )
    (folder / "control.csv").write_text(
        "point_id,easting,northing,height,sd_e,sd_n,sd_h\n" + "".join(f'"T{k}",{k}.5,2,3,0.01,0.01,0.01\n' for k in range(9)),
        encoding="utf-8",
    )
    save_arrays(folder / "block.npz", {"table": np.arange(40.0).reshape(8, 5), "kind": np.arange(8)})
    units = synthetic_result.write_result(folder / "result.gpkg", count=4, epochs=2)
    synthetic_result.write_points(folder / "result.gpkg", units, epochs=2, per_unit=50)
    index = index_folder(folder / "result.gpkg")
    return {
        "survey": folder / "survey.toml",
        "table": folder / "control.csv",
        "block": folder / "block.npz",
        "result": folder / "result.gpkg",
        "index": index / "index.json",
        "index cells": next(index.glob("*.cells.npy")),
        "index points": next(index.glob("*.points.npy")),
    }


READERS: dict[str, Reader] = {
    "survey": _read_survey,
    "table": _read_table,
    "block": _read_block,
    "result": _read_result,
    "index": _read_index,
    "index cells": _read_index,
    "index points": _read_index,
}


@pytest.mark.parametrize("name", READERS)
def test_changed_files_are_read_or_refused(seeds: dict[str, Path], name: str) -> None:
    path = seeds[name]
    good = path.read_bytes()

    @settings(max_examples=EXAMPLES, deadline=None, database=None, derandomize=EXAMPLES <= 60, suppress_health_check=list(HealthCheck))
    @given(EDITS)
    def change(edits: list[tuple[float, str, bytes]]) -> None:
        path.write_bytes(_edited(good, edits))
        _survives(READERS[name], path)

    try:
        change()
    finally:
        path.write_bytes(good)
    READERS[name](path)


@pytest.mark.parametrize("path", sorted(path for path in CORPUS.rglob("*") if path.is_file()), ids=lambda path: path.stem)
def test_cases_found_before(tmp_path: Path, path: Path) -> None:
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes())
    _survives(READERS[path.parent.name], copy)
