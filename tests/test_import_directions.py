"""The house stands: packages use one another in one direction, QGIS's process loads nothing heavy, rooms keep a size one can read.

The table is the order of packages; ``docs/architecture.md`` says what each is for. Whoever needs a new line in it moves the code instead.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

# package of core: what it may use beside itself
MAY_USE = {
    "common": "",
    "model": "common",
    "data": "common model",
    "segmentation": "common model data",
    "adjustment": "common model data",
    "registration": "common model data",
    "simulation": "common model data",
    "deformation": "common model data segmentation adjustment registration",
    "results": "common model data",
    "review": "common model data results",
    "armour": "common model data results review",
    "report": "common model data results review armour",
    "pipeline": "common model data segmentation adjustment registration deformation results review armour",
}

# outer package: what it may use of this repository beside itself
OUTER_MAY_USE = {
    "algorithms": "core",
    "plugin": "core algorithms",
    "scripts": "core",
    "scripts/dev": "core algorithms plugin scripts tests",
    "benchmarks": "core plugin tests",
}

# the door for scripts of users; leads into the rooms
DOORS = ("feedback", "result_tables", "reviews", "run_options", "survey", "workflow")

# modules of core that QGIS's process may load; `model.*` means every module of the package
INSIDE_QGIS = (
    "common.errors common.arrays common.atomic_files common.csv_text common.input_files common.output_files common.output_locks "
    "common.paths common.registration_records common.robust common.rotations common.sqlite_files common.virtual_clouds "
    "model.* results.* review.* report.alarms report.result_choice"
)

# what must never be loaded there: a second copy of what QGIS brings breaks QGIS
HEAVY = {"open3d", "geopandas", "pyogrio", "pyproj", "scipy", "numba", "pandas", "shapely", "rasterio", "laspy", "matplotlib", "small_gicp"}

MODULE_LINES = 500
FUNCTION_LINES = 80
KERNEL_LINES = 120
POSITIONAL_VALUES = 8


def modules(*folders: str) -> list[Path]:
    """Python files of some folders, relative to the checkout."""
    return sorted(path.relative_to(ROOT) for folder in folders for path in (ROOT / folder).rglob("*.py"))


def tree_of(path: Path) -> ast.Module:
    return ast.parse((ROOT / path).read_text(encoding="utf-8"))


def imported(path: Path, *, when_loaded: bool = False) -> Iterator[str]:
    """Full names of the modules and names a file imports; ``when_loaded`` leaves out what functions and type checkers import."""
    tree = tree_of(path)
    left_out = [node for node in ast.walk(tree) if when_loaded and _is_deferred(node)]
    deferred = {id(inner) for node in left_out for inner in ast.walk(node)}
    package = ("tetratrack", *path.parent.parts)
    for node in ast.walk(tree):
        if id(node) in deferred:
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            start = ".".join(package[: len(package) + 1 - node.level]) if node.level else ""
            module = ".".join(part for part in (start, node.module) if part)
            yield from (f"{module}.{alias.name}" for alias in node.names)


def _is_deferred(node: ast.AST) -> bool:
    if isinstance(node, ast.If):
        return ast.unparse(node.test) == "TYPE_CHECKING"
    return isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)


def module_file(name: str) -> Path | None:
    """File of a module of this repository from the full name of the module or of something in it."""
    parts = name.split(".")[1:]
    for candidate in (parts, parts[:-1]):
        path = Path(*candidate).with_suffix(".py") if candidate else Path("__init__.py")
        if (ROOT / path).is_file():
            return path
    return None


@pytest.mark.parametrize("package", MAY_USE)
def test_core_imports_downward_only(package: str) -> None:
    allowed = {package, *MAY_USE[package].split()}
    against = [
        f"{path} imports {name}"
        for path in modules(f"core/{package}")
        for name in imported(path)
        if name.startswith("tetratrack") and (name.split(".")[1] != "core" or name.split(".")[2] not in allowed)
    ]
    assert against == []


def test_every_package_of_core_is_in_the_table() -> None:
    assert {path.name for path in (ROOT / "core").iterdir() if (path / "__init__.py").exists()} == set(MAY_USE)
    roomless = {path.stem for path in modules("core") if path.parent == Path("core")} - {"__init__", *DOORS}
    assert roomless == set(), "a module in no package"


@pytest.mark.parametrize("name", DOORS)
def test_doors_lead_inside_and_nobody_in_the_house_uses_them(name: str) -> None:
    assert len(tree_of(Path("core") / f"{name}.py").body) <= 3, "a sentence, an import and its name"
    users = [
        path
        for path in modules("core", "algorithms", "plugin", "scripts", "benchmarks")
        if _imports_module(path, f"tetratrack.core.{name}")
    ]
    assert users == []


def _imports_module(path: Path, module: str) -> bool:
    return any(name == module or name.startswith(f"{module}.") for name in imported(path))


@pytest.mark.parametrize("package", OUTER_MAY_USE)
def test_the_shell_uses_the_core_and_never_the_other_way(package: str) -> None:
    allowed = {package.split("/")[0], *OUTER_MAY_USE[package].split()}
    nested = [other for other in OUTER_MAY_USE if other.startswith(f"{package}/")]
    against = [
        f"{path} imports {name}"
        for path in modules(package)
        if not any(path.is_relative_to(other) for other in nested)
        for name in imported(path)
        if name.startswith("tetratrack.") and name.split(".")[1] not in allowed
    ]
    assert against == []


def test_only_scripts_lead_the_pipeline() -> None:
    users = {
        path.parts[0]
        for path in modules("core", "algorithms", "plugin", "scripts")
        if not path.is_relative_to("core/pipeline") and path.parent != Path("core")
        for name in imported(path)
        if name.startswith("tetratrack.core.pipeline")
    }
    assert users == {"scripts"}


def test_core_knows_no_qgis() -> None:
    assert [f"{path} imports {name}" for path in modules("core", "scripts") for name in imported(path) if _qgis_in_core(path, name)] == []


def _qgis_in_core(path: Path, name: str) -> bool:
    return name.split(".")[0] in ("qgis", "PyQt5", "PyQt6") and not path.is_relative_to("scripts/dev")


def test_inside_qgis_only_light_modules_are_loaded() -> None:
    """From what the plugin and the algorithms import when they are loaded, through all that follows."""
    waiting = modules("algorithms", "plugin")
    seen = set(waiting)
    against = []
    while waiting:
        path = waiting.pop()
        for name in imported(path, when_loaded=True):
            if name.split(".")[0] in HEAVY:
                against.append(f"{path} loads {name}")
            following = module_file(name) if name.startswith("tetratrack.") else None
            if following is not None and following not in seen:
                seen.add(following)
                waiting.append(following)
    used = {".".join(path.with_suffix("").parts[1:]) for path in seen if path.parts[0] == "core" and path.stem != "__init__"}
    allowed = INSIDE_QGIS.split()
    against += [f"core.{name} is loaded" for name in sorted(used) if name not in allowed and f"{name.split('.')[0]}.*" not in allowed]
    assert against == []


def test_modules_can_be_read_at_a_sitting() -> None:
    lines = {str(path): len((ROOT / path).read_text(encoding="utf-8").splitlines()) for path in modules("core")}
    assert [f"{path}: {count} lines" for path, count in lines.items() if count > MODULE_LINES] == []


def test_functions_fit_on_a_screen() -> None:
    """Compiled kernels may be longer: a call costs time there."""
    over = []
    for path in modules("core", "algorithms", "plugin", "scripts"):
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                count = (node.end_lineno or 0) - node.lineno + 1
                kernel = any(word in ast.unparse(decorator) for decorator in node.decorator_list for word in ("kernel", "njit"))
                if count > (KERNEL_LINES if kernel else FUNCTION_LINES):
                    over.append(f"{path}: {node.name} has {count} lines")
    assert over == []


def test_no_call_is_a_riddle_of_positions() -> None:
    over = [
        f"{path}, line {node.lineno}: {ast.unparse(node.func)} gets {len(node.args)} values by position"
        for path in modules("core", "algorithms", "plugin", "scripts")
        for node in ast.walk(tree_of(path))
        if isinstance(node, ast.Call) and len(node.args) > POSITIONAL_VALUES and ast.unparse(node.func) != "struct.pack"
    ]
    assert over == []


def test_tests_and_benchmarks_need_no_private_names() -> None:
    """What is worth a test or a measurement has a name for others; widgets alone are looked into."""
    private = re.compile(r"_[a-z][a-z_]*")
    allowed = {"_replace", "_asdict", "_exit"}
    against = []
    for path in (path for path in modules("tests", "benchmarks") if not path.is_relative_to("tests/qgis")):
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("tetratrack"):
                against += [f"{path} imports {alias.name}" for alias in node.names if private.fullmatch(alias.name)]
            own = isinstance(node, ast.Attribute) and ast.unparse(node.value) in ("self", "cls")
            if isinstance(node, ast.Attribute) and private.fullmatch(node.attr) and node.attr not in allowed and not own:
                against.append(f"{path}, line {node.lineno}: {ast.unparse(node)}")
    assert against == []
