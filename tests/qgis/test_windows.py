"""What only a whole QGIS shows: scripts of ``windows/`` click in a real window of a fresh profile and answer with what they found."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from synthetic_result import write_result
from tetratrack.core.review.corrections import read_edits
from tetratrack.core.review.decisions import read_history, read_reviews
from tetratrack.plugin.review_store import ReviewStore

pytestmark = [
    pytest.mark.qgis,
    pytest.mark.skipif(shutil.which("qgis") is None or not os.environ.get("DISPLAY"), reason="no QGIS with a window here"),
]


class Window:
    """A script in a QGIS window of its own profile that has nothing but the plugin."""

    def __init__(self, folder: Path, repository: Path, script: Path, environment: dict[str, str]) -> None:
        self.answers = folder / "window"
        self.answers.mkdir(parents=True)
        profile = folder / "profiles" / "profiles" / "default"
        plugins = profile / "python" / "plugins"
        plugins.mkdir(parents=True)
        (plugins / "tetratrack").symlink_to(repository, target_is_directory=True)
        (profile / "QGIS").mkdir()
        (profile / "QGIS" / "QGIS3.ini").write_text(
            "[PythonPlugins]\ntetratrack=true\nprocessing=true\n[qgis]\ncheckVersion=false\n[locale]\noverrideFlag=true\nuserLocale=en\n"
        )
        command = ["qgis", "--nologo", "--noversioncheck", "--profiles-path", str(folder / "profiles")]
        command += ["--code", str(script.with_name("start.py"))]
        inherited = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "QGIS_"))}
        variables = {
            **inherited,
            "PYTHONPATH": str(script.parent),
            "TETRATRACK_WINDOW": str(self.answers),
            "TETRATRACK_SCRIPT": str(script),
            **environment,
        }
        self._said = folder / "said.txt"
        with self._said.open("w", encoding="utf-8") as said:
            self._process = subprocess.Popen(command, env=variables, stdout=said, stderr=subprocess.STDOUT)

    def answer(self, seconds: float) -> dict[str, Any]:
        """What the script found, after checking that nothing was caught as an error."""
        try:
            self._process.wait(seconds)
        finally:
            self.close()
        answer = self.answers / "answer.json"
        assert answer.is_file(), self._said.read_text(encoding="utf-8", errors="replace")[-3000:]
        found = json.loads(answer.read_text(encoding="utf-8"))
        assert "failed" not in found, found["failed"]
        assert found["python_errors"] == []
        keep_pictures(self.answers)
        return found

    def close(self) -> None:
        """End the window, whatever it does."""
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait(30)


def keep_pictures(answers: Path) -> None:
    """Pictures of the scripts go to the folder that TETRATRACK_PICTURES names, if it does: those of the documentation are made so."""
    kept = os.environ.get("TETRATRACK_PICTURES")
    for picture in answers.glob("*.png") if kept else ():
        shutil.copy(picture, Path(kept) / picture.name)


@pytest.fixture
def open_window(tmp_path: Path, repository: Path) -> Iterator[Callable[..., Window]]:
    """Open a window with a script of ``windows/``; its environment is given by keywords."""
    opened: list[Window] = []

    def start(name: str, **environment: str) -> Window:
        script = repository / "tests" / "qgis" / "windows" / f"{name}.py"
        opened.append(Window(tmp_path / f"window{len(opened)}", repository, script, environment))
        return opened[-1]

    yield start
    for window in opened:
        window.close()


@pytest.fixture
def window(open_window: Callable[..., Window]) -> Callable[..., dict[str, Any]]:
    """Run a script in a window of its own; its answer."""

    def start(name: str, *, seconds: float = 240, **environment: str) -> dict[str, Any]:
        return open_window(name, **environment).answer(seconds)

    return start


def test_monitor_window_runs_and_batches(window: Callable[..., dict[str, Any]], tiny: Path, tmp_path: Path, fake_engine: Any) -> None:
    told = tmp_path / "window0" / "window" / "arguments.json"
    fake_engine(f"""
        open({str(told)!r}, "w").write(json.dumps(arguments))
        say(event="result", outputs={{"units": 1, "moved": 0, "check_rmse": None, "files": [], "epochs": []}})
    """)
    survey = tiny / "survey.toml"
    answer = window("monitor", TETRATRACK_SURVEY=str(survey))
    assert "Batch" in answer["batch"]
    assert "relief" in answer["arguments"] or str(survey) in answer["arguments"]


def test_one_click_opens_tetrapods_in_3d(window: Callable[..., dict[str, Any]], tmp_path: Path) -> None:
    result = tmp_path / "result.gpkg"
    write_result(result, 40, 2, seed=4)
    answer = window("view_3d", TETRATRACK_RESULT=str(result), TETRATRACK_WAIT="3000")
    assert answer["layers"] == ["Surfaces of the units (3D)", "Displacements in 3D"]
    assert "moved" in answer["legend"]
    assert "enlarged" in answer["legend"]
    # the whole structure is in sight, from its foot
    assert 15 < answer["distance"] < 60
    assert answer["pitch"] == pytest.approx(55, abs=1)


def test_tutorial_to_the_letter(window: Callable[..., dict[str, Any]], repository: Path) -> None:
    """The sample as a user goes through it with mouse and keyboard, by docs/tutorial.md alone."""
    sample = repository / "tests" / "data" / "sample"
    answer = window("tutorial", seconds=3600, TETRATRACK_SAMPLE=str(sample))
    assert {"Inspect tiles", "Monitor a survey", "Displacement report"} <= set(answer["found"])
    assert len(answer["tiles"]["chosen"]) == len(answer["tiles"]["rows"]) == 4
    assert all(row["crs"] == "EPSG:32650" and row["measured"].startswith("2024-04") for row in answer["tiles"]["rows"])
    assert (answer["tiles"]["coloured"], answer["tiles"]["by"], answer["tiles"]["labels"]) == ("graduatedSymbol", "density", True)
    assert answer["layers"]["Displacements"]
    assert answer["layers"]["Outlines of the units"]
    assert not answer["layers"]["Displacements, other pairs and datum"], "one arrow a unit"
    assert {"Units", "Outlines of the units", "Relief 2024-04-09", "Relief 2024-10-09"} <= set(answer["timed"])
    assert answer["span"] == ["2024-04-09", "2024-10-09"], "time begins with the first epoch, not today"
    assert answer["asked_for_points"]
    assert answer["picked"] == answer["unit"], "a click in the middle of its arrow"
    assert answer["decision"] == "accepted"
    assert "report.html" in answer["opens"]
    assert "href" in answer["opens"]
    assert answer["page"] == ["result"]
    assert answer["arrows"] == ["Displacements: stable units and control"]


def test_the_sample_runs_and_is_shown_after_one_click(open_window: Callable[..., Window], tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    answer = open_window("try_sample", HOME=str(home), XDG_CONFIG_HOME=str(home / ".config")).answer(1200)
    assert {"result.gpkg", "survey.toml", "tiles"} <= set(answer["files"])
    assert not answer["truth"]
    assert answer["units"] > 10
    assert {"Outlines of the units", "Relief 2024-10-09"} <= set(answer["layers"])
    assert min(answer["views"]) >= 120, "the views have room in a window of 1366 × 768"


def is_stored(said: str) -> bool:
    """Whether the dock said that a decision was stored."""
    return "stored" in said and "nothing was stored" not in said


@pytest.mark.parametrize("acts", [40, pytest.param(200, marks=pytest.mark.slow)])
def test_two_windows_one_deciding_one_correcting(open_window: Callable[..., Window], tmp_path: Path, acts: int) -> None:
    """Two QGIS at once on one file, with the buttons and menus: nothing is lost, and both show the same 5 s later."""
    result = tmp_path / "result.gpkg"
    write_result(result, 120)
    meeting = tmp_path / "meeting"
    meeting.mkdir()
    common = {"TETRATRACK_RESULT": str(result), "TETRATRACK_MEETING": str(meeting), "TETRATRACK_ACTS": str(acts)}
    opened = {role: open_window("reviewer", TETRATRACK_ROLE=role, **common) for role in ("deciding", "correcting")}
    answers = {role: window.answer(400) for role, window in opened.items()}
    assert answers["deciding"]["shown"] == answers["correcting"]["shown"]
    decided, corrected = (answers[role]["said"] for role in ("deciding", "correcting"))
    events, edits = read_history(result), read_edits(result)
    own = [event for event in events if event.reviewer == "deciding"]
    assert [event.action for event in own].count("decide") == sum(is_stored(text) for text in decided)
    assert [event.action for event in own].count("undo") == sum(text.startswith("Taken back") for text in decided)
    stored = [text for text in corrected if "was deleted" in text or "is called" in text]
    assert len(edits) == len(stored)
    assert sum(edit.undone for edit in edits) == sum(text.startswith("Taken back") for text in corrected)
    # what was refused was refused for a reason that the other's act gives
    refused = [text for text in decided if not is_stored(text) and not text.startswith("Taken back")]
    assert all("not in the result any more" in text or "other numbers than were shown" in text for text in refused), refused
    assert len(stored) + sum(text.startswith("Taken back") for text in corrected) == acts
    shown = answers["deciding"]["shown"]
    pair = ReviewStore(result).pair
    reviewed = {unit for unit, of in read_reviews(result) if of == pair}
    assert {unit for unit, (_, _, decision, _) in shown.items() if decision} == reviewed & shown.keys()


def test_from_a_folder_to_the_first_map(open_window: Callable[..., Window], tiny: Path, tmp_path: Path) -> None:
    """The dock's first page: a folder, its epochs as a table, a correction, Run, and the review of what comes."""
    folder = tmp_path / "harbour"
    shutil.copytree(tiny, folder, ignore=shutil.ignore_patterns("survey.toml", "truth", "*.gpkg"))
    answer = open_window("first_hour", TETRATRACK_FOLDER=str(folder)).answer(900)
    labels = [row["label"] for row in answer["found"]]
    assert len(labels) == 2
    assert all(row["points"] > 1000 and row["density"] > 10 and row["crs"] for row in answer["found"])
    assert answer["footprints"] == 2
    assert answer["editors"] == {"time": "QgsDateTimeEdit", "tiles": "QToolButton", "control": "PointsChoice"}
    assert answer["epochs"] == ["before the storm", labels[1]]
    assert answer["units"] > 0
    assert (folder / "result_survey" / "survey.toml").is_file()


def test_tables_and_the_identify_window_follow_the_projects_unit(window: Callable[..., dict[str, Any]], tmp_path: Path) -> None:
    """Layers dragged onto the map, without the dock: lengths in millimetres where the project counts so, in metres where it does not."""
    result = tmp_path / "result.gpkg"
    write_result(result, 40, 2, seed=4)
    answer = window("lengths", TETRATRACK_RESULT=str(result))
    assert answer["identified"]["Displacement"] == f"{1000 * answer['stored']:.1f} mm"
    assert {"Easting component", "Std. dev. height"} <= set(answer["headers"])
    assert not [text for text in answer["headers"] if "[m" in text]
    for small, large in zip(answer["millimetres"], answer["metres"], strict=True):
        assert (small.split()[1], large.split()[1]) == ("mm", "m")
        assert float(small.split()[0]) == pytest.approx(1000 * float(large.split()[0]), abs=0.51)
