"""The locks: every library with its version and checksums, for every platform, and on the page of licences."""

from __future__ import annotations

import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from tetratrack.scripts.dev import lock, wheelhouse
from tetratrack.scripts.dev.lock import TARGETS, Target, marker_of, needed, normal, pins
from tiny_wheels import write_lock, write_wheel

WINDOWS = Target("win32", "3.12", ("win_amd64",))
MACOS = Target("darwin", "3.12", ("macosx_14_0_arm64",))


def test_every_pin_has_a_checksum_and_a_licence(repository: Path) -> None:
    found = pins((repository / "requirements-lock.txt").read_text(encoding="utf-8"))
    assert len(found) > 100
    assert [name for name, (_, hashes) in found.items() if not hashes] == [], "run: python -m tetratrack.scripts.dev.lock"
    page = (repository / "docs" / "licences.md").read_text(encoding="utf-8")
    assert [name for name, (version, _) in found.items() if f"| {name} | {version} |" not in page] == []
    assert "not stated" not in page
    assert "not installed here" not in page


def test_the_engine_has_the_developers_versions_and_all_it_needs_on_every_target(repository: Path) -> None:
    developers = pins((repository / "requirements-lock.txt").read_text(encoding="utf-8"))
    text = (repository / "requirements-engine.txt").read_text(encoding="utf-8")
    engine = pins(text)
    assert {name: version for name, (version, _) in engine.items()}.items() <= {n: v for n, (v, _) in developers.items()}.items()
    assert [name for name, (_, hashes) in engine.items() if not hashes] == []
    # compiled libraries have a file for each platform and Python
    assert len(engine["open3d"][1].split()) == 9
    for target in {(target.system, target.python): target for target in TARGETS}.values():
        lines = wheelhouse.lines_for(target, text)
        assert {normal(line.split("==")[0]) for line in lines} == needed(target), "run: python -m tetratrack.scripts.dev.lock"
        assert not [line for line in lines if ";" in line]


def test_what_only_some_systems_need_is_marked() -> None:
    assert marker_of(TARGETS, TARGETS) == ""
    assert marker_of([WINDOWS], TARGETS) == ' ; sys_platform == "win32"'
    assert marker_of([t for t in TARGETS if t.system != "win32"], TARGETS) == ' ; sys_platform != "win32"'


def test_what_is_no_pin_is_refused() -> None:
    assert pins("# text\nnumpy==2.0\n") == {"numpy": ("2.0", "")}
    assert pins('a-b==2.0 ; sys_platform == "win32" --hash=sha256:' + "0" * 64) == {"a-b": ("2.0", "--hash=sha256:" + "0" * 64)}
    with pytest.raises(ValueError, match="not a pinned version"):
        pins("numpy>=2\n")


def test_a_wheelhouse_serves_several_systems(tmp_path: Path) -> None:
    """Files of each from one lock, without those that only another needs."""
    source = tmp_path / "registry"
    everywhere = write_wheel(source, "everywhere")
    windows = write_wheel(source, "compiled", tag="cp312-cp312-win_amd64", content=b"windows")
    macos = write_wheel(source, "compiled", tag="cp312-cp312-macosx_14_0_arm64", content=b"macos")
    only = write_wheel(source, "only_windows")
    text = write_lock(tmp_path / "lock.txt", [everywhere, windows, only]).read_text(encoding="utf-8")
    checksum = write_lock(tmp_path / "other.txt", [macos]).read_text(encoding="utf-8").split("compiled==1.0 ")[1].strip()
    text = text.replace("compiled==1.0 ", f"compiled==1.0 {checksum} ").replace(
        "only_windows==1.0 ", 'only_windows==1.0 ; sys_platform == "win32" '
    )
    (tmp_path / "lock.txt").write_text(text, encoding="utf-8")
    options = ["--no-index", "--find-links", str(source)]
    packed = wheelhouse.make(tmp_path / "out" / "wheels.zip", [WINDOWS, MACOS], tmp_path / "lock.txt", options)
    assert sorted(zipfile.ZipFile(packed).namelist()) == sorted(path.name for path in (everywhere, windows, macos, only))
    alone = wheelhouse.make(tmp_path / "macos", [MACOS], tmp_path / "lock.txt", options)
    assert sorted(path.name for path in alone.iterdir()) == sorted(path.name for path in (everywhere, macos))
    assert [path.name for path in packed.parent.iterdir()] == ["wheels.zip"]


@pytest.mark.network
@pytest.mark.slow
def test_wheels_of_all_locked_libraries_exist(repository: Path) -> None:
    """The registry is asked for every library by name, for Windows and for macOS on Apple silicon: the files are the lock's."""
    text = (repository / "requirements-engine.txt").read_text(encoding="utf-8")
    versions = {name: version for name, (version, _) in pins(text).items()}
    hashes = {normal(name): known for name, (_, known) in pins(text).items()}
    targets = [target for target in TARGETS if target.system in ("win32", "darwin")]

    def asked(target: Target) -> dict[str, str]:
        return lock.checksums({name: version for name, version in versions.items() if normal(name) in needed(target)}, target)

    with ThreadPoolExecutor(3) as pool:
        for target, found in zip(targets, pool.map(asked, targets), strict=True):
            assert set(found) == needed(target)
            assert [name for name, checksum in found.items() if checksum not in hashes[name]] == [], target
