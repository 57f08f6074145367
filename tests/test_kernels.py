"""Compiled loops: what numba compiles in one process and fails to in another is kept out."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parents[1] / "core"


def compiled_functions(path: Path) -> list[ast.FunctionDef]:
    """Functions of a module under ``@kernel`` or ``@njit``."""
    functions = [node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.FunctionDef)]
    return [f for f in functions if any(word in ast.unparse(d) for d in f.decorator_list for word in ("kernel", "njit"))]


COMPILING = [path for path in sorted(CORE.glob("*.py")) if compiled_functions(path)]


def test_modules_with_compiled_loops_are_seen():
    assert {"assembly.py", "cone_conditions.py", "gauss_helmert.py", "residual_correlation.py", "strip_offsets.py"} <= {
        path.name for path in COMPILING
    }


@pytest.mark.parametrize("path", COMPILING, ids=lambda path: path.stem)
def test_arrays_in_compiled_loops_are_made_from_tuples(path):
    lists = [(f.name, node.lineno) for f in compiled_functions(path) for node in ast.walk(f) if isinstance(node, ast.List)]
    assert lists == []


def test_compiled_loops_call_those_of_their_own_module():
    """The disk cache knows a loop by its own file: one that calls another module's keeps the old code when that module changes."""
    compiled = {path.stem: {f.name for f in compiled_functions(path)} for path in COMPILING}
    foreign = set()
    for path in COMPILING:
        imports = {
            alias.asname or alias.name: (node.module, alias.name)
            for node in ast.walk(ast.parse(path.read_text()))
            if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module in compiled
            for alias in node.names
        }
        used = {node.id for f in compiled_functions(path) for s in f.body for node in ast.walk(s) if isinstance(node, ast.Name)}
        foreign |= {imports[name] for name in used & imports.keys() if imports[name][1] in compiled[imports[name][0]]}
    # the search of neighbours alone is shared
    assert foreign == {("neighbourhood", "gather")}
