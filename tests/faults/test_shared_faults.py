"""Every case of what users met gives what its ``expect.txt`` says, and each has a test of the project's own."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from faults.run_all import EXPECTED, run_case

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.slow
@pytest.mark.shared_data
@pytest.mark.parametrize("number", EXPECTED)
def test_case(shared_data: Path, number: str) -> None:
    folders = sorted((shared_data.parent / "faults").glob(f"{number}_*"))
    if not folders:
        pytest.skip(f"no case {number}")
    outcome = run_case(folders[0], ROOT / ".venv" / "bin" / "tetratrack")
    assert not outcome.wrong, outcome.output


def test_every_case_has_a_test_and_every_test_is_there() -> None:
    table = (Path(__file__).parent / "README.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1:4] for line in table.splitlines() if re.match(r"\| (faults|hard)/", line)]
    cases = {number for cell, _, _ in rows for number in re.findall(r"\d\d", re.sub(r"hard/.*", "", cell))}
    assert cases == set(EXPECTED)
    every = {path.name: path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("test_*.py")}
    for _, _, tests in rows:
        file = ""
        for name in re.findall(r"`([\w.:]+)`", tests):
            file, _, function = name.rpartition("::") if "::" in name else (file, "", name)
            assert f"def {function}(" in every[file], name


@pytest.mark.shared_data
def test_no_shared_case_is_without_a_test(shared_data: Path) -> None:
    table = (Path(__file__).parent / "README.md").read_text(encoding="utf-8")
    hard = {number for cell in re.findall(r"hard/([\d, ]+)", table) for number in re.findall(r"\d\d", cell)}
    assert {folder.parent.name[:2] for folder in (shared_data.parent / "faults_hard").glob("*/run.sh")} <= hard
    assert {folder.parent.name[:2] for folder in (shared_data.parent / "faults").glob("*/run.sh")} <= set(EXPECTED)
