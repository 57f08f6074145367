"""Compiled loops: what numba compiles in one process and fails to in another is kept out."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parents[3] / "core"


def compiled_functions(path: Path) -> list[ast.FunctionDef]:
    """Functions of a module under ``@kernel`` or ``@njit``."""
    functions = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.FunctionDef)]
    return [f for f in functions if any(word in ast.unparse(d) for d in f.decorator_list for word in ("kernel", "njit"))]


COMPILING = [path for path in sorted(CORE.rglob("*.py")) if compiled_functions(path)]


def test_modules_with_compiled_loops_are_seen():
    assert {
        *("assembly.py", "pose_refinement.py", "pose_evidence.py", "cone_conditions.py", "contested_points.py"),
        *("gauss_newton_step.py", "residual_correlation.py", "strip_observations.py"),
    } <= {path.name for path in COMPILING}


@pytest.mark.parametrize("path", COMPILING, ids=lambda path: path.stem)
def test_arrays_in_compiled_loops_are_made_from_tuples(path):
    lists = [(f.name, node.lineno) for f in compiled_functions(path) for node in ast.walk(f) if isinstance(node, ast.List)]
    assert lists == []
