"""Two results beside each other: the same file has no difference, one bit is found and named."""

from __future__ import annotations

import math
import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from synthetic_result import write_result
from tetratrack.scripts.dev.compare_results import differences


@pytest.fixture
def pair(tmp_path: Path) -> tuple[Path, Path]:
    before, after = tmp_path / "before.gpkg", tmp_path / "after.gpkg"
    write_result(before, 12, 2)
    shutil.copy(before, after)
    return before, after


def change(path: Path, statement: str, *values: object) -> None:
    with closing(sqlite3.connect(path)) as connection:
        connection.execute(statement, values)
        connection.commit()


def test_a_result_equals_itself(pair: tuple[Path, Path]) -> None:
    assert list(differences(*pair)) == []


def test_the_last_bit_is_found_and_named(pair: tuple[Path, Path]) -> None:
    with closing(sqlite3.connect(pair[1])) as connection:
        (value,) = connection.execute("SELECT sd_e FROM units WHERE unit_id = 'U00003' LIMIT 1").fetchone()
    change(pair[1], "UPDATE units SET sd_e = ? WHERE unit_id = 'U00003' AND sd_e = ?", math.nextafter(value, 1), value)
    found = list(differences(*pair))
    assert found
    assert all(sentence.startswith("units U00003") and "sd_e" in sentence for sentence in found)
    assert list(differences(*pair, tolerance=1e-9)) == []


def test_rows_and_layers_that_are_missing_are_named(pair: tuple[Path, Path]) -> None:
    change(pair[1], "DELETE FROM displacements WHERE unit_id = 'U00002' AND feature = 'centre'")
    change(pair[1], "DELETE FROM gpkg_contents WHERE table_name = 'gaps'")
    found = list(differences(*pair))
    assert any(sentence.startswith("gaps: only in") for sentence in found)
    assert any(sentence.startswith("displacements U00002") and "only in" in sentence for sentence in found)


def test_who_wrote_it_and_in_which_order_does_not_matter(pair: tuple[Path, Path]) -> None:
    change(pair[1], "UPDATE epochs SET software = 'another'")
    change(pair[1], "UPDATE units SET fid = 1000 - fid")
    assert list(differences(*pair)) == []
