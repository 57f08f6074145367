"""The engine's environment made by the plugin: without a network, with a broken one, on a full disk, killed; stale ones are noticed."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import Qgis, QgsApplication, QgsNetworkAccessManager
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkProxy
from qgis.PyQt.QtWidgets import QApplication, QMessageBox, QPushButton
from tetratrack.algorithms.support import engine, environment
from tetratrack.algorithms.support.environment import OUTDATED, PYTHON_GONE, Places, environment_python, fault_of
from tetratrack.plugin import network, options
from tetratrack.plugin.environment_task import CreateEnvironment, Wish, serves
from tetratrack.plugin.pip_words import what_failed
from tiny_wheels import registry, write_lock, write_wheel

PYTHON = Path("/usr/bin/python3")
NOWHERE = dict.fromkeys(("HTTP_PROXY", "HTTPS_PROXY", "http_proxy", "https_proxy"), "http://127.0.0.1:9")
"""Proxies that nobody listens at: whoever asks the network gets no answer."""
NO_CACHE = {"PIP_NO_CACHE_DIR": "1", "PIP_FIND_LINKS": ""}


@pytest.fixture
def wheels(tmp_path: Path) -> Path:
    """Folder of two wheels."""
    for name in ("first_library", "second_library"):
        write_wheel(tmp_path / "wheels", name)
    return tmp_path / "wheels"


@pytest.fixture
def wish(tmp_path: Path, wheels: Path) -> Callable[..., Wish]:
    """What is to be made of the two wheels, without a network."""
    lock = write_lock(tmp_path / "lock.txt", sorted(wheels.glob("*.whl")))

    def make(**changed: Any) -> Wish:
        given = {
            "python": PYTHON,
            "environment": tmp_path / "profile of ユーザー" / "engine",
            "wheels": wheels,
            "lock": lock,
            "modules": ("first_library", "second_library"),
            "first_run": (),
            "variables": NO_CACHE | NOWHERE,
            "installed_bytes": 1,
            "downloaded_bytes": 1,
        }
        return Wish(**(given | changed))

    return make


def left(wish: Wish) -> list[str]:
    """What lies beside the environment, and itself."""
    return sorted(path.name for path in wish.environment.parent.iterdir())


def test_it_compiles_once_made_and_does_not_fail_for_that(wish: Callable[..., Wish], tmp_path: Path) -> None:
    came = tmp_path / "came"
    compiling = f"import first_library, pathlib, sys; pathlib.Path({str(came)!r}).touch(); sys.exit('no room to compile')"
    task = CreateEnvironment(wish(first_run=("-I", "-c", compiling)))
    steps: list[str] = []
    task.step.connect(steps.append)
    assert task.run(), task.problem
    assert came.is_file()
    assert fault_of(task.wish.environment, task.wish.lock) == ""
    assert "no room to compile" in task.log.read_text()
    assert steps[-1] == "Compiling, so that the first run need not wait"


def test_made_without_a_network_from_a_folder(wish: Callable[..., Wish]) -> None:
    task = CreateEnvironment(wish())
    steps: list[str] = []
    task.step.connect(steps.append)
    assert task.run(), task.problem
    assert left(task.wish) == ["engine", "engine.log"]
    assert fault_of(task.wish.environment, task.wish.lock) == ""
    assert "Installing collected packages" in task.log.read_text()
    assert steps[0] == "Making an empty environment"
    assert steps[-1] == "Trying the libraries"
    assert task.progress() > 90


def test_a_zip_serves_with_what_it_holds_for_others(wish: Callable[..., Wish], wheels: Path, tmp_path: Path) -> None:
    write_wheel(wheels, "first_library", tag="cp39-cp39-win_amd64")
    packed = tmp_path / "wheels.zip"
    with zipfile.ZipFile(packed, "w") as archive:
        for wheel in wheels.glob("*.whl"):
            archive.write(wheel, f"folder/{wheel.name}")
    task = CreateEnvironment(wish(wheels=packed))
    task.places.making.mkdir(parents=True)
    task._check_wheels(packed)
    (tmp_path / "pyvenv.cfg").write_text("home = /usr/bin\nversion = 3.12.4\n")
    folder = task._unpacked(packed, tmp_path)
    assert sorted(path.name for path in folder.iterdir()) == ["first_library-1.0-py3-none-any.whl", "second_library-1.0-py3-none-any.whl"]


@pytest.mark.parametrize(
    ("tags", "there"),
    [
        ("py3-none-any", "linux win32 darwin"),
        ("py2.py3-none-any", "linux win32 darwin"),
        ("cp312-cp312-win_amd64", "win32"),
        ("cp311-cp311-win_amd64", ""),
        ("cp311-abi3-macosx_11_0_arm64", "darwin"),
        ("cp312-cp312-manylinux_2_27_x86_64.manylinux_2_28_x86_64", "linux"),
        ("py3-none-manylinux2014_x86_64", "linux"),
    ],
)
def test_only_wheels_of_the_computer_are_unpacked(tags: str, there: str) -> None:
    systems = [system for system in ("linux", "win32", "darwin") if serves(f"library-1.0-{tags}.whl", system, 12)]
    assert systems == there.split()


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("empty", "holds no wheels"),
        ("lacking", "lacks 1 of the wheels that this version of the plugin needs: second-library 1.0"),
        ("changed", "damaged or changed on its way"),
        ("truncated ZIP", "damaged or changed on its way"),
        ("disk", "and 0.0 GB are free"),
        ("import", "could not be created: ModuleNotFoundError: No module named 'third_library'"),
    ],
)
def test_what_does_not_serve_is_one_message_and_leaves_nothing(
    wish: Callable[..., Wish], wheels: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str, words: str
) -> None:
    second = wheels / "second_library-1.0-py3-none-any.whl"
    wanted = wish()
    (wanted.environment / "bin").mkdir(parents=True)
    (wanted.environment / "bin" / "works").touch()
    if kind == "empty":
        shutil.rmtree(wheels)
        wheels.mkdir()
    elif kind == "lacking":
        second.unlink()
    elif kind == "changed":
        write_wheel(wheels, "second_library", content=b"another")
    elif kind == "truncated ZIP":
        (tmp_path / "wheels.zip").write_bytes(b"PK\3\4 and no more")
        wanted = wish(wheels=tmp_path / "wheels.zip")
    elif kind == "disk":
        monkeypatch.setattr(shutil, "disk_usage", lambda place: shutil._ntuple_diskusage(10**12, 10**12, 1))
        wanted = wish(installed_bytes=2 * 10**9)
    else:
        wanted = wish(modules=("third_library",))
    task = CreateEnvironment(wanted)
    assert not task.run()
    assert words in task.problem
    assert (wanted.environment / "bin" / "works").exists(), "the one that works stays"
    assert [name for name in left(wanted) if name != "engine.log"] == ["engine"]


def test_a_broken_download_is_one_message_and_can_be_tried_again(wish: Callable[..., Wish], wheels: Path) -> None:
    for broken in (True, False):
        with registry(wheels, broken=broken) as address:
            wanted = wish(wheels=None, variables=NO_CACHE | {"PIP_INDEX_URL": address, "PIP_RETRIES": "0", "NO_PROXY": "*"})
            task = CreateEnvironment(wanted)
            done = task.run()
        if broken:
            assert not done
            assert "try again" in task.problem
            assert left(wanted) == ["engine.log"]
        else:
            assert done, task.problem
            assert left(wanted) == ["engine", "engine.log"]


def test_a_folder_that_goes_while_it_is_looked_at_ends_nothing(
    wish: Callable[..., Wish], wheels: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def gone(self: Path, pattern: str) -> Iterator[Path]:
        raise FileNotFoundError(2, "No such file or directory", str(self))

    with registry(wheels, broken=False) as address:
        task = CreateEnvironment(wish(wheels=None, variables=NO_CACHE | {"PIP_INDEX_URL": address, "NO_PROXY": "*"}))
        monkeypatch.setattr(Path, "rglob", gone)
        assert task.run(), task.problem
    monkeypatch.undo()
    assert left(task.wish) == ["engine", "engine.log"]


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk that holds an empty environment and little more."""
    place = tmp_path / "small disk"
    place.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=40m", "tmpfs", str(place)], capture_output=True, check=False)
    if mounted.returncode != 0:
        pytest.skip("no right to make a small disk")
    yield place
    subprocess.run(["umount", "--lazy", str(place)], check=True)


def test_a_full_disk_is_one_message_and_leaves_nothing(wish: Callable[..., Wish], wheels: Path, tmp_path: Path, small_disk: Path) -> None:
    large = write_wheel(tmp_path / "large", "large_library", content=os.urandom(50_000_000))
    lock = write_lock(tmp_path / "large.txt", [large])
    task = CreateEnvironment(wish(environment=small_disk / "engine", wheels=large.parent, lock=lock))
    assert not task.run()
    assert "the disk is full" in task.problem
    assert left(task.wish) == ["engine.log"]
    again = CreateEnvironment(wish(environment=small_disk / "engine"))
    assert again.run(), again.problem


MAKER = """
import sys
from pathlib import Path
sys.path[:0] = {paths!r}
import conftest
from qgis.core import QgsApplication
app = QgsApplication([], False)
from tetratrack.plugin.environment_task import CreateEnvironment, Wish
CreateEnvironment(Wish(python=Path({python!r}), environment=Path({environment!r}), wheels=Path({wheels!r}), lock=Path({lock!r}),
                       modules=("first_library",), first_run=(), installed_bytes=1, downloaded_bytes=1)).run()
"""


def test_a_killed_creation_leaves_the_one_in_use_and_is_cleared_away(
    wish: Callable[..., Wish], wheels: Path, tmp_path: Path, repository: Path
) -> None:
    wanted = wish()
    (wanted.environment / "bin").mkdir(parents=True)
    places = Places(wanted.environment)
    text = MAKER.format(
        paths=[str(repository / "tests")],
        python=str(PYTHON),
        environment=str(wanted.environment),
        wheels=str(wheels),
        lock=str(wanted.lock),
    )
    maker = subprocess.Popen([sys.executable, "-c", text], start_new_session=True, env=os.environ | {"QT_QPA_PLATFORM": "offscreen"})
    until = time.monotonic() + 60
    while not (places.making / "venv").exists() and time.monotonic() < until:
        time.sleep(0.05)
    assert environment.in_making(places)
    meanwhile = CreateEnvironment(wanted)
    assert not meanwhile.run()
    assert "Another window of QGIS" in meanwhile.problem
    os.killpg(maker.pid, signal.SIGKILL)
    maker.wait()
    assert places.making.exists()
    assert places.environment.is_dir()
    long_ago = time.time() - 2 * environment.SECONDS_OF_LIFE
    os.utime(places.making / environment.SIGN_OF_LIFE, (long_ago, long_ago))
    environment.clear_leftovers(places)
    assert left(wanted) == ["engine", "engine.log"]
    again = CreateEnvironment(wanted)
    assert again.run(), again.problem


def test_killed_between_two_names_the_old_one_comes_back(tmp_path: Path) -> None:
    places = Places(tmp_path / "engine")
    places.before.mkdir()
    places.making.mkdir()
    environment.clear_leftovers(places)
    assert [path.name for path in tmp_path.iterdir()] == ["engine"]


def test_cancelled_it_leaves_nothing_and_ends_soon(wish: Callable[..., Wish], tmp_path: Path) -> None:
    slow = tmp_path / "slow python"
    slow.write_text("#!/bin/sh\nsleep 60\n")
    slow.chmod(0o755)
    task = CreateEnvironment(wish(python=slow))
    task.cancel()
    began = time.monotonic()
    assert not task.run()
    assert time.monotonic() - began < 5
    assert task.problem == "Cancelled."
    assert left(task.wish) == ["engine.log"]


def managed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A complete environment in the profile, with this Python."""
    folder = tmp_path / "profile" / "engine"
    python = environment_python(folder)
    python.parent.mkdir(parents=True)
    python.symlink_to(sys.executable)
    environment.write_stamp(folder, environment.LOCK)
    monkeypatch.delenv(engine.PYTHON_VARIABLE, raising=False)
    monkeypatch.setattr(engine, "managed_environment", lambda: folder)
    return folder


def test_a_stale_environment_is_noticed_at_the_start_of_a_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from tetratrack.algorithms.planningdetectability import PlanningDetectability

    folder = managed(tmp_path, monkeypatch)
    assert engine.find_engine() == engine.Engine(environment_python(folder), "managed")
    assert PlanningDetectability().canExecute()[0]
    stamp = folder / environment.STAMP
    stamp.write_text(json.dumps({"version": "0.0.1", "lock": "another"}))
    assert engine.find_engine().fault == OUTDATED
    possible, why = PlanningDetectability().canExecute()
    assert not possible
    assert "another version of the plugin" in why
    assert 'href="tetratrack:mend"' in why
    stamp.unlink()
    assert engine.find_engine().fault == OUTDATED
    environment_python(folder).unlink()
    environment_python(folder).symlink_to(tmp_path / "python that was here once")
    assert engine.find_engine().fault == PYTHON_GONE
    with pytest.raises(engine.EngineError, match="is gone"):
        engine.run_engine(["plan"], engine.Listener(lambda *_: None, print, print, lambda: False))


def test_one_click_mends_a_stale_environment_after_asking(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wish: Callable[..., Wish], qgis_iface: Any
) -> None:
    from tetratrack.plugin import tetratrack_plugin

    folder = managed(tmp_path, monkeypatch)
    (folder / environment.STAMP).unlink()
    monkeypatch.setattr(tetratrack_plugin, "managed_environment", lambda: folder)
    monkeypatch.setattr(options, "managed_environment", lambda: folder)
    prepared: list[Wish] = []  # what the click wishes for, with two small wheels in the place of the libraries
    monkeypatch.setattr(
        options, "Wish", lambda **given: prepared.append(wish(python=PYTHON, environment=given["environment"])) or prepared[-1]
    )
    asked: list[str] = []
    answer = [QMessageBox.StandardButton.No]
    monkeypatch.setattr(options.QMessageBox, "question", lambda parent, title, text: asked.append(text) or answer[0])
    plugin = tetratrack_plugin.TetratrackPlugin(qgis_iface)
    plugin.provider = object()
    plugin._say_what_is_missing()
    message = qgis_iface.messageBar().currentItem()
    assert "another version of the plugin" in message.text()
    button = message.findChild(QPushButton, "tetratrack_engine")
    button.click()
    assert str(folder) in asked[0]
    assert prepared == [], "nothing is done without a yes"
    answer[0] = QMessageBox.StandardButton.Yes
    plugin.open_link(QUrl("tetratrack:mend"))
    until = time.monotonic() + 120
    while options.running_task() is not None and time.monotonic() < until:
        QApplication.processEvents()
        time.sleep(0.02)
    QApplication.processEvents()
    assert len(asked) == 2
    assert fault_of(folder, prepared[0].lock) == ""
    assert any("ready" in said for said in qgis_iface.messageBar().get_messages(Qgis.MessageLevel.Success))
    assert qgis_iface.messageBar().currentItem() is None, "what was mended is no longer complained about"


def test_the_page_follows_what_is_being_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wish: Callable[..., Wish], qgis_iface: Any
) -> None:
    """Another window of the options finds the task that the first one started, and can end it."""
    slow = tmp_path / "slow python"
    slow.write_text("#!/bin/sh\nexec sleep 60\n")
    slow.chmod(0o755)
    task = CreateEnvironment(wish(python=slow))
    QgsApplication.taskManager().addTask(task)
    until = time.monotonic() + 20
    while not task.places.making.exists() and time.monotonic() < until:
        QApplication.processEvents()
    page = options.TetratrackOptionsPage()
    assert page.task is task
    assert not page.create_button.isEnabled()
    page.cancel_button.click()
    while options.running_task() is not None and time.monotonic() < until:
        QApplication.processEvents()
    QApplication.processEvents()
    assert page.create_button.isEnabled()
    assert page.step.text() == "Cancelled."
    assert not task.places.making.exists()


def test_without_windows_an_outdated_one_warns_and_runs(fake_engine: Callable[[str], Path]) -> None:
    python = fake_engine('say(event="result", outputs={"units": 1})')
    warned: list[str] = []
    listener = engine.Listener(lambda *_: None, print, warned.append, lambda: False)
    assert engine.run_engine(["plan"], listener, engine.Engine(python, "managed", OUTDATED)) == {"units": 1}
    assert "another version of the plugin" in warned[0]


def test_engine_and_plugin_refuse_each_other(fake_engine: Callable[[str], Path], repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    listener = engine.Listener(lambda *_: None, print, print, lambda: False)
    fake_engine("""
        say(event="hello", version="9.9.9")
        time.sleep(30)
    """)
    began = time.monotonic()
    with pytest.raises(engine.EngineError, match=r"its files are of version 9\.9\.9: restart QGIS"):
        engine.run_engine(["plan"], listener)
    assert time.monotonic() - began < 10
    monkeypatch.delenv(engine.PYTHON_VARIABLE)
    monkeypatch.setattr(engine, "PLUGIN_VERSION", "0.0.9")
    with pytest.raises(engine.EngineError, match=r"version 0\.0\.9 of the plugin, but its files are of version"):
        engine.run_engine(["plan"], listener, engine.Engine(Path(sys.executable), "setting"))


@pytest.mark.parametrize(
    ("kind", "person", "address"),
    [
        (QNetworkProxy.ProxyType.HttpProxy, ("", ""), "http://proxy.example:8080"),
        (QNetworkProxy.ProxyType.HttpProxy, ("do main\\me", "p@ss:w/rd"), "http://do%20main%5Cme:p%40ss%3Aw%2Frd@proxy.example:8080"),
        (QNetworkProxy.ProxyType.Socks5Proxy, ("", ""), "socks5h://proxy.example:8080"),
        (QNetworkProxy.ProxyType.NoProxy, ("", ""), ""),
    ],
)
def test_the_proxy_of_qgis_is_passed_on(kind: Any, person: tuple[str, str], address: str) -> None:
    manager = QgsNetworkAccessManager.instance()
    manager.setupDefaultProxyAndCache()
    before, excluded = manager.fallbackProxy(), manager.excludeList() if hasattr(manager, "excludeList") else []
    try:
        manager.setFallbackProxyAndExcludes(QNetworkProxy(kind, "proxy.example", 8080, *person), [], ["https://intranet.example"])
        variables = network.proxy_variables()
        assert variables.get("HTTPS_PROXY", "") == address
        if address:
            assert variables["NO_PROXY"] == "intranet.example"
    finally:
        manager.setFallbackProxyAndExcludes(before, excluded, [])


def test_certificates_of_the_user_join_those_that_pip_knows(wish: Callable[..., Wish], tmp_path: Path) -> None:
    known = tmp_path / "known.pem"
    known.write_text("KNOWN")
    task = CreateEnvironment(wish(certificates="GIVEN", variables={"PIP_CERT": str(known)}))
    bundled = tmp_path / "venv" / "lib" / "python3.12" / "site-packages" / "pip" / "_vendor" / "certifi" / "cacert.pem"
    bundled.parent.mkdir(parents=True)
    bundled.write_text("OF PIP")
    task.places.making.mkdir(parents=True)
    bundle = Path(task._certificates(tmp_path / "venv")["PIP_CERT"])
    assert bundle.read_text().split() == ["KNOWN", "OF", "PIP", "GIVEN"]
    assert CreateEnvironment(wish())._certificates(tmp_path / "venv") == {}


@pytest.mark.parametrize(
    ("output", "words"),
    [
        ("WARNING: Retrying ... ProxyError('Cannot connect to proxy.', NewConnectionError(...))\nERROR: No matching distribution", "proxy"),
        ("OSError('Tunnel connection failed: 407 Proxy Authentication Required')", "user name and password"),
        ("SSLError(SSLCertVerificationError(1, '[SSL: CERTIFICATE_VERIFY_FAILED]'))", "authority in Settings"),
        (
            "Failed to resolve 'x' ([Errno -2] Name or service not known)\nERROR: No matching distribution found for open3d",
            "no package registry",
        ),
        ("ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device", "the disk is full"),
        ("error: incomplete-download\n\n× Download failed because not enough bytes were received", "connection broke"),
        ("OSError: [WinError 112] There is not enough space on the disk", "the disk is full"),
        ("Collecting numpy\nERROR: first\nERROR: second\n[notice] new pip", "ERROR: first"),
        ("only words", "only words"),
    ],
)
def test_what_pip_says_in_words(output: str, words: str) -> None:
    assert words in what_failed(output)


def test_only_a_python_of_the_lock_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    assert options.base_python() is not None
    monkeypatch.setattr(options, "LATEST_PYTHON", (3, 9))
    monkeypatch.setattr(shutil, "which", lambda name: f"/somewhere/{name}" if name == "python3.12" else None)
    assert options.base_python() == Path("/somewhere/python3.12")
