"""What all tests share: the package under its name whatever the checkout's folder is called, and the optional sample surveys."""

from __future__ import annotations

import importlib.util
import logging
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

# as the command sets it: sums of several threads differ in the last bit from those of one
for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

ROOT = Path(__file__).resolve().parents[1]


def _import_package() -> None:
    """Load this checkout as ``tetratrack`` where it is not installed (QGIS's own Python)."""
    if importlib.util.find_spec("tetratrack") is not None:
        return
    spec = importlib.util.spec_from_file_location("tetratrack", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)])
    if spec is None or spec.loader is None:
        raise ImportError(f"{ROOT} is not a checkout of tetratrack")
    module = importlib.util.module_from_spec(spec)
    sys.modules["tetratrack"] = module
    spec.loader.exec_module(module)


_import_package()

SHARED = Path(os.environ.get("TETRATRACK_SHARED", ROOT.parent / "shared"))


def _has_qgis() -> bool:
    """Whether QGIS's own bindings are here; the folder of its tests has the same name."""
    try:
        return importlib.util.find_spec("qgis.core") is not None
    except ModuleNotFoundError:
        return False


collect_ignore = [] if _has_qgis() else ["qgis"]


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Skip what needs absent data; leave slow tests and those of the network out unless -m names them."""
    no_data = pytest.mark.skip(reason=f"no sample surveys at {SHARED / 'data'}")
    too_slow = pytest.mark.skip(reason="slow; run with -m slow")
    no_network = pytest.mark.skip(reason="asks a package registry; run with -m network")
    for item in items:
        if "shared_data" in item.keywords and not (SHARED / "data").is_dir():
            item.add_marker(no_data)
        if "slow" in item.keywords and "slow" not in (config.option.markexpr or ""):
            item.add_marker(too_slow)
        if "network" in item.keywords and "network" not in (config.option.markexpr or ""):
            item.add_marker(no_network)


@pytest.fixture(autouse=True)
def no_unexpected_warning(request: pytest.FixtureRequest, caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    """A warning that a library logs fails the test, unless the test bears the mark ``logs_warnings``; Python's own warnings are errors."""
    yield
    if "logs_warnings" not in request.keywords:
        said = [f"{record.name}: {record.getMessage()}" for record in caplog.get_records("call") if record.levelno >= logging.WARNING]
        assert said == [], "mark the test with logs_warnings if it is to be expected"


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of the sample surveys with ground truth; tests that use it carry the mark ``shared_data``."""
    return SHARED / "data"


@pytest.fixture(scope="session")
def repository() -> Path:
    """Root of the checkout."""
    return ROOT


@pytest.fixture(scope="session")
def tiny(repository: Path) -> Path:
    """Folder of the smallest sample survey: a few units, two epochs."""
    return repository / "tests" / "data" / "tiny"


@pytest.fixture(scope="session")
def result(tiny: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Result of a whole run on the tiny survey."""
    from tetratrack.core.common.feedback import Feedback
    from tetratrack.core.data.survey_reader import read_survey
    from tetratrack.core.pipeline.run_options import RunOptions
    from tetratrack.core.pipeline.whole_survey import run_survey

    path = tmp_path_factory.mktemp("result") / "result.gpkg"
    warned: list[str] = []
    run_survey(read_survey(tiny / "survey.toml"), path, RunOptions(workers=1), Feedback(warning=warned.append))
    assert warned == [], "nothing is wrong with the tiny survey"
    return path
