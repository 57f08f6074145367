"""Exit codes of the command, and a cancel that a library swallowed."""

from __future__ import annotations

import contextlib
import io
import json
import signal
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tetratrack.core.common.errors import Cancelled, InputError, NoSolutionError, OutputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.scripts.console import BAD_INPUT, DONE, FAULT, INTERRUPTED, Console, execute


@pytest.fixture(autouse=True)
def heard_interrupts() -> Iterator[None]:
    """Ctrl-C reaches the test however pytest was started: a script in the background ignores it for all its children."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def failing(error: BaseException) -> Callable[[Console], dict[str, Any]]:
    def step(console: Console) -> dict[str, Any]:
        raise error

    return step


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (InputError("has no CRS", remedy="Declare it."), BAD_INPUT),
        (OutputError("cannot be written", remedy="Free some space."), BAD_INPUT),
        (NoSolutionError("too few points", remedy="Give more."), BAD_INPUT),
        (Cancelled("cancelled"), INTERRUPTED),
        (KeyboardInterrupt(), INTERRUPTED),
        (RuntimeError("boom"), FAULT),
    ],
)
def test_exit_codes(error: BaseException, code: int, capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(Console(), failing(error)) == code
    said = capsys.readouterr().err
    assert "error: " in said
    if getattr(error, "remedy", ""):
        assert str(error) in said, "the remedy is said too"


def test_a_cancel_that_was_swallowed_is_heard_at_the_next_look() -> None:
    looks = []

    def step(console: Console) -> dict[str, Any]:
        feedback = Feedback(is_cancelled=lambda: console.cancelled)
        feedback.check()
        looks.append("before")
        with contextlib.suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGTERM)
        feedback.check()
        looks.append("after")
        return {}

    assert execute(Console(quiet=True), step) == INTERRUPTED
    assert looks == ["before"]


def test_handlers_are_put_back() -> None:
    before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    assert execute(Console(quiet=True), lambda console: {"points": 1}) == DONE
    assert (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)) == before


def test_an_ignored_ctrl_c_stays_ignored() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)

    def step(console: Console) -> dict[str, Any]:
        signal.raise_signal(signal.SIGINT)
        return {}

    assert execute(Console(quiet=True), step) == DONE


def test_signs_that_steer_a_terminal_are_written_as_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    Console().error("\x1b[2Jname\x07 of \u202e a file\x9b")
    told = capsys.readouterr().err
    assert "\x1b" not in told
    assert "\\x1b[2Jname\\x07" in told


def test_letters_outside_the_code_page_do_not_end_a_run(monkeypatch: pytest.MonkeyPatch) -> None:
    page = io.TextIOWrapper(io.BytesIO(), encoding="cp1252")
    monkeypatch.setattr("sys.stdout", page)
    Console().result({"output": "波浪.gpkg"})
    Console(json_progress=True).result({"output": "波浪.gpkg"})
    lines = page.buffer.getvalue().decode("cp1252").splitlines()  # type: ignore[attr-defined]
    assert "\\u6ce2\\u6d6a.gpkg" in lines[0]
    assert json.loads(lines[1])["outputs"]["output"] == "波浪.gpkg"


def test_numbers_that_json_does_not_know_are_null(capsys: pytest.CaptureFixture[str]) -> None:
    Console(json_progress=True).result({"mean": float("nan"), "rows": [{"sd": float("inf")}], "count": 3})
    event = json.loads(capsys.readouterr().out, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))
    assert event["outputs"] == {"mean": None, "rows": [{"sd": None}], "count": 3}


def test_a_progress_bar_has_no_thread_before_there_is_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr("sys.stderr", Terminal())
    console, before = Console(), threading.active_count()
    with console.opened():
        console.info("said before")
        # workers may be copies of this process up to here
        assert threading.active_count() == before
        console.progress(0.1, "some of it")
        assert threading.active_count() == before + 1
