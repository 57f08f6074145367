"""Nothing that ships relies on one system: no call that Windows lacks outside a guarded place, no text in the system's code page, no
process that would be forked; and the engine works under names and settings that this system does not have by itself."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path, PureWindowsPath

import pytest
from synthetic_result import write_result
from tetratrack.core.common import atomic_files, paths
from tetratrack.core.common.atomic_files import write_whole
from tetratrack.core.common.errors import OutputError
from tetratrack.core.common.output_files import check_targets, safe_name
from tetratrack.core.common.paths import sqlite_address

ROOT = Path(__file__).resolve().parents[1]
SHIPPED = [path for folder in ("core", "algorithms", "plugin", "scripts") for path in sorted((ROOT / folder).rglob("*.py"))]
SHIPPED = [path for path in SHIPPED if "dev" not in path.relative_to(ROOT).parts]

LACKING_MODULES = {"fcntl", "pwd", "grp", "resource", "termios", "tty", "pty", "posix", "syslog", "readline", "crypt"}
LACKING_NAMES = {
    "os": "fork forkpty getuid geteuid getgid getegid setsid getsid killpg getpgid setpgid fchmod fchown chown lchown mkfifo mknod pread "
    "pwrite uname wait wait3 wait4 waitid nice getpriority sched_getaffinity sched_setaffinity O_DIRECTORY O_NOFOLLOW O_CLOEXEC getloadavg "
    "sysconf statvfs posix_fadvise sendfile kill symlink link chroot ttyname initgroups",
    "signal": "SIGKILL SIGHUP SIGALRM SIGUSR1 SIGUSR2 SIGPIPE SIGSTOP SIGCONT SIGCHLD alarm setitimer pthread_kill pthread_sigmask "
    "sigwait pause",
    "time": "clock_gettime tzset",
    "socket": "AF_UNIX",
}
"""What Python lacks on Windows, and ``os.kill`` and links, which do something else or need a right there."""
LACKING_METHODS = {"symlink_to", "hardlink_to", "lchmod", "owner", "group"}
LACKING_ARGUMENTS = {"preexec_fn", "start_new_session", "pass_fds"}
GUARDS = ("sys.platform", "os.name", "hasattr(os", "hasattr(signal", "WINDOWS")
FORKING = {"Process", "Pool", "ProcessPoolExecutor", "set_start_method"}


def parents_of(tree: ast.Module) -> dict[ast.AST, ast.AST]:
    return {child: parent for parent in ast.walk(tree) for child in ast.iter_child_nodes(parent)}


def asks_the_system(node: ast.expr) -> bool:
    return any(word in ast.unparse(node) for word in GUARDS)


def guarded(node: ast.AST, parents: dict[ast.AST, ast.AST]) -> bool:
    """Whether the system is asked on the way to a node: around it, or by a statement before it that leaves the function."""
    while node in parents:
        above = parents[node]
        asked = above.test if isinstance(above, ast.If | ast.IfExp) else above if isinstance(above, ast.BoolOp) else None
        if asked is not None and asks_the_system(asked):
            return True
        for body in (getattr(above, "body", None), getattr(above, "finalbody", None)):
            if isinstance(body, list) and node in body:
                before = [statement for statement in body[: body.index(node)] if isinstance(statement, ast.If)]
                if any(asks_the_system(s.test) and isinstance(s.body[-1], ast.Return | ast.Raise | ast.Continue) for s in before):
                    return True
        node = above
    return False


def lacking_elsewhere(text: str) -> list[str]:
    """What a module uses unguarded that Windows lacks, with its line."""
    tree = ast.parse(text)
    parents = parents_of(tree)
    found = []
    for node in ast.walk(tree):
        name = ""
        if isinstance(node, ast.Import):
            name = next((alias.name for alias in node.names if alias.name.split(".")[0] in LACKING_MODULES), "")
        elif isinstance(node, ast.ImportFrom) and node.module in LACKING_MODULES:
            name = str(node.module)
        elif isinstance(node, ast.Attribute) and node.attr in LACKING_NAMES.get(ast.unparse(node.value), "").split():
            name = ast.unparse(node)
        if isinstance(node, ast.Call):
            if isinstance(node.func, ast.Attribute) and node.func.attr in LACKING_METHODS and not node.args[1:]:
                name = f".{node.func.attr}()"
            name = next((word.arg for word in node.keywords if word.arg in LACKING_ARGUMENTS), name)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.startswith(("/proc/", "/dev/", "/tmp/", "/usr/")):
            name = repr(node.value)
        if name and not guarded(node, parents):
            found.append(f"line {getattr(node, 'lineno', 0)}: {name}")
    return found


def texts_of_the_code_page(text: str) -> Iterator[str]:
    """Places where a module reads or writes text in whatever the system's encoding is."""
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.Call) or any(word.arg in ("encoding", None) for word in node.keywords):
            continue
        called = ast.unparse(node.func)
        if called == "laspy.open":
            # bytes, whatever its mode
            continue
        mode = next((str(ast.literal_eval(w.value)) for w in node.keywords if w.arg == "mode" and isinstance(w.value, ast.Constant)), "")
        if called.endswith((".read_text", ".write_text")) and len(node.args) <= called.endswith(".write_text"):
            yield f"line {node.lineno}: {called}"
        elif called == "open" or called.endswith(".open"):
            place = 1 if called in ("open", "io.open") else 0
            if len(node.args) > place and isinstance(node.args[place], ast.Constant):
                mode = str(node.args[place].value)
            if mode in ("r", "w", "a", "x", "r+", "w+", "rt", "wt") or (called == "open" and not mode):
                yield f"line {node.lineno}: {called}"
        elif any(word.arg in ("text", "universal_newlines") for word in node.keywords) and called.startswith("subprocess."):
            yield f"line {node.lineno}: {called}"


def test_nothing_that_windows_lacks_is_used_unguarded() -> None:
    assert len(SHIPPED) > 150
    found = {path: lacking_elsewhere(path.read_text(encoding="utf-8")) for path in SHIPPED}
    assert {path: lines for path, lines in found.items() if lines} == {}


def test_text_is_never_in_the_systems_code_page() -> None:
    found = {path: list(texts_of_the_code_page(path.read_text(encoding="utf-8"))) for path in SHIPPED}
    assert {path: lines for path, lines in found.items() if lines} == {}


def test_processes_are_spawned_everywhere() -> None:
    """But for the first workers of a run, where the process may be copied."""
    for path in SHIPPED:
        text = path.read_text(encoding="utf-8")
        tree = ast.parse(text)
        copies = path == ROOT / "core/pipeline/local_processes.py"
        assert copies or not forks(tree), path
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name | ast.Attribute):
                called = ast.unparse(node.func)
                if called.split(".")[-1] == "get_context":
                    arguments = [ast.unparse(argument) for argument in node.args]
                    assert arguments == ["method" if copies else "'spawn'"], path
                elif called.split(".")[-1] in FORKING and ("multiprocessing" in called or "futures" in called or called in FORKING):
                    assert "get_context(method)" in text if copies else 'get_context("spawn")' in text, path


def test_only_a_process_that_may_be_copied_is() -> None:
    tree = ast.parse((ROOT / "core/pipeline/local_processes.py").read_text(encoding="utf-8"))
    asked = [node for node in ast.walk(tree) if isinstance(node, ast.If) and "_may_be_copied()" in ast.unparse(node.test)]
    within = {constant for node in asked for statement in node.body for constant in forks(statement)}
    assert within
    assert set(forks(tree)) == within


def forks(tree: ast.AST) -> list[ast.Constant]:
    """Where the name of a way to copy a process stands."""
    return [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and node.value in ("fork", "forkserver")]


@pytest.mark.parametrize(
    "text",
    [
        "import fcntl",
        "from os import path\nimport os\nos.kill(1, 9)",
        "import signal\nx = signal.SIGKILL",
        "p.symlink_to(q)",
        "open('/proc/1/stat', 'rb')",
        "import os\ndef f():\n    if other:\n        return\n    os.geteuid()",
    ],
)
def test_the_check_finds_what_windows_lacks(text: str) -> None:
    assert len(lacking_elsewhere(text)) == 1


def test_the_check_knows_a_guard() -> None:
    assert lacking_elsewhere("import os, sys\nif sys.platform != 'win32':\n    os.fork()") == []
    assert lacking_elsewhere("import os\ndef f():\n    if os.name != 'posix':\n        return\n    os.geteuid()") == []
    assert list(texts_of_the_code_page("p.read_text()\nopen(p)\np.open('w')\np.read_text(encoding='utf-8')\np.open('rb')")) != []
    assert len(list(texts_of_the_code_page("p.read_text()\nopen(p)\np.open('w')\np.read_text(encoding='utf-8')\np.open('rb')"))) == 3


@pytest.mark.parametrize(
    ("path", "address"),
    [
        (r"C:\Daten\Mole Süd\ergebnis.gpkg", "file:///C:/Daten/Mole%20S%C3%BCd/ergebnis.gpkg?mode=ro"),
        (r"\\server\share\a b.gpkg", "file:////server/share/a%20b.gpkg?mode=ro"),
        (r"C:\what%20is#this?.gpkg", "file:///C:/what%2520is%23this%3F.gpkg?mode=ro"),
    ],
)
def test_sqlite_is_given_drives_and_shares_as_it_takes_them(path: str, address: str) -> None:
    assert sqlite_address(PureWindowsPath(path), "mode=ro") == address


def test_no_database_is_opened_by_an_address_of_its_own_making() -> None:
    for path in SHIPPED:
        text = path.read_text(encoding="utf-8")
        assert "as_uri()}?" not in text, f"{path}: take sqlite_address, which knows shares"


def test_patterns_know_drives_and_shares() -> None:
    for text, anchor in ((r"D:\tiles\*.laz", "D:\\"), (r"\\server\share\tiles\*.laz", "\\\\server\\share\\")):
        path = PureWindowsPath(text)
        assert path.is_absolute()
        assert (path.anchor, path.parts[1:]) == (anchor, ("tiles", "*.laz")), "as core/data/file_patterns.py takes them apart"


def test_a_file_that_is_read_meanwhile_is_replaced_a_moment_later(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """On Windows a program that has the target open forbids the rename; QGIS and scanners let go of it soon, or not."""
    target = tmp_path / "report.html"
    target.write_bytes(b"old")
    monkeypatch.setattr(atomic_files, "WINDOWS", True)
    monkeypatch.setattr(paths, "WINDOWS", True)
    left = [2]
    replace = Path.replace

    def held(self: Path, other: Path) -> Path:
        left[0] -= 1
        if left[0] >= 0:
            raise PermissionError(13, "The process cannot access the file because it is being used by another process")
        return replace(self, other)

    monkeypatch.setattr(Path, "replace", held)
    write_whole(target, b"new")
    assert target.read_bytes() == b"new"
    left[0] = 10**6
    monkeypatch.setattr(atomic_files, "PATIENCE_SECONDS", 0.2)
    with pytest.raises(OutputError, match="Close it in QGIS and other programs"):
        write_whole(target, b"newer")
    assert target.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [target]


def test_a_path_that_windows_does_not_take_is_named_as_such(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(paths, "WINDOWS", True)
    deep = tmp_path.joinpath(*["a folder with a long name"] * 12) / "report.html"
    with pytest.raises(OutputError, match="shorter path: Windows takes 259 characters"):
        write_whole(deep, b"text")


def test_names_that_other_systems_take_for_one_are_not_both_written(tmp_path: Path) -> None:
    for first, second in (("Relief_A.tif", "relief_a.tif"), ("M\u00e4rz.tif", "Ma\u0308rz.tif")):
        with pytest.raises(OutputError, match="written twice"):
            check_targets([(tmp_path / first, "A"), (tmp_path / second, "a")])
    assert safe_name("con") == "con-"
    assert safe_name("NUL.1") == "NUL.1-"
    assert safe_name("2025-03-14") == "2025-03-14"


STRANGE = "Übersicht 北防波堤 (Kopie) & Co"


@pytest.mark.parametrize("deep", [False, True], ids=["strange", "longer than 260 characters"])
def test_command_and_report_under_strange_names_and_code_pages(tmp_path: Path, deep: bool) -> None:
    """Folders with spaces, other scripts and great length, in a process whose own encoding is ASCII; what reads or writes text in it is an
    error."""
    folder = tmp_path / STRANGE
    if deep:
        folder = folder.joinpath(*["folder of a structure with a long name"] * 7)
        assert len(str(folder)) > 260
    folder.mkdir(parents=True)
    result = folder / "résultat é.gpkg"
    write_result(result, 10, 2)
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG", "PYTHON"))}
    environment |= {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "PYTHONIOENCODING": "cp1252:backslashreplace"}
    for output in ("報告.html", "alarms ü.csv"):
        step = "report" if output.endswith("html") else "alarms"
        command = [sys.executable, "-X", "warn_default_encoding", "-W", "error::EncodingWarning:tetratrack", "-m", "tetratrack.scripts.cli"]
        done = subprocess.run(
            [*command, step, str(result), "--output", str(folder / output)], env=environment, capture_output=True, check=False
        )
        assert done.returncode == 0, done.stderr.decode("utf-8", "replace")[-2000:]
        assert (folder / output).stat().st_size > 100


UNIT_TESTS = ("core/common", "core/data", "core/results", "core/review", "core/report", "scripts/test_cli.py", "scripts/test_init.py")


@pytest.mark.slow
def test_unit_tests_pass_under_strange_names_and_code_pages(tmp_path: Path) -> None:
    """The engine's own tests once more, all files of which lie under a long path with spaces and other scripts, in a process that takes for
    an error a text opened without its encoding, which would be that of the system's code page. Names of files are Unicode on Windows and
    macOS whatever the code page, so that the locale stays."""
    folder = tmp_path / STRANGE / "folder of a structure with a long name" / "and another one below it with a long name"
    folder.mkdir(parents=True)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST")} | {"PYTHONUTF8": "1"}
    warnings = "error\nignore:.*:DeprecationWarning\nignore::EncodingWarning\nerror::EncodingWarning:tetratrack.*"
    command = [
        sys.executable,
        "-X",
        "warn_default_encoding",
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "-o",
        f"filterwarnings={warnings}",
    ]
    places = [str(ROOT / "tests" / place) for place in UNIT_TESTS]
    done = subprocess.run([*command, "--basetemp", str(folder / "t"), *places], cwd=ROOT, env=environment, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout.decode("utf-8", "replace")[-6000:]
