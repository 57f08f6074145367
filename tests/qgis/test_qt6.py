"""Readiness for QGIS 4: every Qt name the plugin uses exists under PyQt6, enums by their full names."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest
from synthetic_result import write_points, write_result

MODULES = ("algorithms", "plugin")
RESOLVE = """
import importlib, json, sys
missing = []
for module, chain in json.load(sys.stdin):
    value = importlib.import_module("PyQt6." + module)
    try:
        for name in chain:
            value = getattr(value, name)
    except AttributeError:
        missing.append(module + "." + ".".join(chain))
print(json.dumps(missing))
"""
SHIMMED = {"QAction", "QActionGroup", "QShortcut", "QSvgRenderer"}
"""Names that qgis.PyQt offers where Qt 5 has them; Qt 6 moved them to other modules."""


def chain_of(node: ast.Attribute) -> list[str]:
    """``Qt.AlignmentFlag.AlignRight`` as a list of names; empty if it does not start with a name."""
    names: list[str] = []
    current: ast.expr = node
    while isinstance(current, ast.Attribute):
        names.append(current.attr)
        current = current.value
    return [current.id, *reversed(names)] if isinstance(current, ast.Name) else []


def qt_names(path: Path) -> list[tuple[str, list[str]]]:
    """Qt modules and chains of names that a module of the plugin uses."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    origin = {
        alias.asname or alias.name: node.module.rsplit(".", 1)[1]
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("qgis.PyQt.")
        for alias in node.names
    }
    used = [(module, [name]) for name, module in origin.items() if name not in SHIMMED]
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            chain = chain_of(node)
            if chain and chain[0] in origin and chain[0] not in SHIMMED:
                used.append((origin[chain[0]], chain))
    return used


def test_every_qt_name_exists_under_pyqt6(repository: Path) -> None:
    pytest.importorskip("PyQt6", reason="PyQt6 is installed by requirements-qgis.txt")
    used = [entry for folder in MODULES for path in sorted((repository / folder).rglob("*.py")) for entry in qt_names(path)]
    assert len(used) > 100
    # in a process of its own: two Qt libraries in one do not go well
    done = subprocess.run([sys.executable, "-c", RESOLVE], input=json.dumps(used), capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == []


def qgis_chains(path: Path) -> list[list[str]]:
    """Chains of names that begin with something imported from qgis.core or qgis.gui."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    imported = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module in ("qgis.core", "qgis.gui")
        for alias in node.names
    }
    chains = [chain_of(node) for node in ast.walk(tree) if isinstance(node, ast.Attribute)]
    return [chain for chain in chains if chain and chain[0] in imported]


def test_enums_of_qgis_are_named_in_full(repository: Path) -> None:
    """``Qgis.Critical`` works in QGIS 3 alone; in QGIS 4 it is ``Qgis.MessageLevel.Critical``."""
    import qgis.core
    import qgis.gui

    short = []
    for path in (path for folder in MODULES for path in sorted((repository / folder).rglob("*.py"))):
        for chain in qgis_chains(path):
            value = getattr(qgis.core, chain[0], None) or getattr(qgis.gui, chain[0])
            for name in chain[1:]:
                value = getattr(value, name, None)
            kind = type(value).__name__
            if isinstance(value, int) and not isinstance(value, bool | type) and kind != chain[-2]:
                short.append(f"{path.name}: {'.'.join(chain)}")
    assert short == []


def test_everything_is_imported_built_and_used_under_pyqt6(repository: Path, tmp_path: Path) -> None:
    """All modules, algorithms and widgets with the real Qt 6; QGIS's own classes are stood in for."""
    pytest.importorskip("PyQt6", reason="PyQt6 is installed by requirements-qgis.txt")
    write_points(tmp_path / "result.gpkg", write_result(tmp_path / "result.gpkg", 40, 3))
    script = Path(__file__).parent / "qt6" / "build_all.py"
    command = [sys.executable, str(script), str(repository), str(tmp_path / "result.gpkg")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    made = json.loads(done.stdout)
    assert made["problems"] == []
    assert made["qt"].startswith("6.")
    assert made["modules"] >= 39
    assert len(made["algorithms"]) == 17
    assert made["painted"] == dict.fromkeys(made["painted"], True)
    assert len(made["painted"]) == 8


def test_nothing_gone_from_qt6_is_used(repository: Path) -> None:
    gone = (
        *("exec_(", "QVariant.", "resources_rc", "QRegExp(", "QtWebKit", "setMargin(", "QDesktopWidget", "QTextCodec", "QStringList"),
        *("globalPos()", ".delta()", "QFontMetrics(", "MidButton", "QSound", "toTime_t", "setTabStopWidth"),
    )
    for folder in MODULES:
        for path in sorted((repository / folder).rglob("*.py")):
            text = path.read_text(encoding="utf-8")
            assert not [word for word in gone if word in text], path
            assert "from PyQt5" not in text, path
