"""What the documentation names exists: files, subcommands, and the names a script is shown to import."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "benchmarks" / "README.md", *(ROOT / "docs").glob("*.md")])
FILE = re.compile(r"`((?:core|algorithms|plugin|scripts|benchmarks|tests)/[\w/]+\.(?:py|sh|md))`")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_are_named_exist(page: Path) -> None:
    named = FILE.findall(page.read_text(encoding="utf-8"))
    assert [name for name in named if not (ROOT / name).is_file()] == []


def test_modules_of_the_house_are_all_on_the_page() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    missing = [
        str(path.relative_to(ROOT))
        for path in sorted((ROOT / "core").rglob("*.py"))
        if path.stem != "__init__" and f"`{path.stem}`" not in text
    ]
    assert missing == [], "docs/architecture.md lists every module of core"


def test_every_subcommand_is_in_the_readme_and_on_its_page() -> None:
    from tetratrack.scripts.cli import app

    names = [command.name or command.callback.__name__ for command in app.registered_commands if not command.hidden]
    assert len(names) > 15
    for page in ("README.md", "docs/command-line.md"):
        text = (ROOT / page).read_text(encoding="utf-8")
        assert [name for name in names if f"`{name}" not in text] == [], page


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_what_the_pages_import_exists(page: Path) -> None:
    imports = re.findall(r"^from (tetratrack[\w.]*) import ([\w, ]+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    if page.name == "README.md" and page.parent == ROOT:
        assert len(imports) >= 4
    for module, names in imports:
        assert [name for name in names.split(", ") if not hasattr(importlib.import_module(module), name)] == [], module


def test_the_five_questions_have_answers_that_exist() -> None:
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (.+\?) \| (.+) \|$", text, re.MULTILINE)
    assert len(rows) == 5
    for question, answer in rows:
        assert FILE.findall(answer), question
        path = ROOT / FILE.findall(answer)[0]
        names = re.findall(r"`(\w+)`", answer.partition(";")[0])
        assert all(re.search(rf"^def {name}\b", path.read_text(encoding="utf-8"), re.MULTILINE) for name in names), question


FIRST_HOUR = (
    "data/folder_epochs", "data/looks_at_ground", "data/other_clouds", "common/virtual_clouds", "data/las_files", "data/recognised_tables",
    "pipeline/new_survey", "pipeline/given_epochs", "pipeline/size_check", "pipeline/no_units",
)  # fmt: skip
"""Modules whose messages somebody meets before the first map."""
SAYING = ("InputError", "OutputError", "CrsError", "warning", "append")


def _said(node: ast.expr) -> str:
    """A text of the source, three dots for what is filled in."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "…" for part in node.values)
    return _said(node.left) + _said(node.right) if isinstance(node, ast.BinOp) else ""


def _messages(path: Path) -> set[str]:
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and node.args:
            name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            if name in SAYING:
                found.add(_said(node.args[0]))
        elif isinstance(node, ast.Assign) and any(getattr(target, "id", "") in ("question", "notes") for target in node.targets):
            found |= {_said(part) for part in (node.value.elts if isinstance(node.value, ast.Tuple) else [node.value])}
    return {text for text in found if " " in text}


def test_messages_of_the_first_hour_are_on_the_page_of_troubles() -> None:
    """Four words of the longest part of each that is not filled in."""
    page = re.sub(r"[*`]|\s+", " ", (ROOT / "docs" / "troubleshooting.md").read_text(encoding="utf-8").lower())
    page = re.sub(r" +", " ", page)
    messages = {text for name in FIRST_HOUR for text in _messages(ROOT / "core" / f"{name}.py")}
    assert len(messages) > 50
    missing = []
    for text in sorted(messages):
        longest = max(re.split(r"…|: ", text.lower()), key=lambda part: len(part.split()))
        words = " ".join(longest.split()[:4]).strip(" .,;:()")
        if words not in page:
            missing.append((words, text))
    assert missing == []
