"""Fetch the engine's wheels for computers without a network: ``python -m tetratrack.scripts.dev.wheelhouse OUTPUT``.

OUTPUT is a folder, or a ZIP if it ends so; the plugin's options take either (*Settings > Options > Tetratrack*). ``--system`` (windows,
macos, linux) and ``--python`` say for which computers, each as often as wanted: one OUTPUT may serve several. Files are those of
requirements-engine.txt and are held against its checksums.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from packaging.markers import Marker
from tetratrack.scripts.dev.lock import ENGINE_LOCK, MACOS, PIN, PYTHONS, Target, linux_tags

SYSTEMS = {
    "windows": ("win32", ("win_amd64",)),
    "macos": ("darwin", tuple(f"macosx_{version}_0_arm64" for version in sorted(MACOS, reverse=True))),
    "linux": ("linux", linux_tags(36)),
}
QGIS_PYTHON = "3.12"
"""The Python that QGIS brings to Windows and macOS."""


def lines_for(target: Target, lock: str) -> list[str]:
    """Lines of a lock that a target needs, without markers: pip would hold these against the computer it runs on."""
    found = []
    for line in lock.splitlines():
        pin = PIN.fullmatch(line.strip())
        if pin is not None and (pin["marker"] is None or Marker(pin["marker"]).evaluate(target.markers())):
            found.append(f"{pin['name']}=={pin['version']}{pin['hashes']}")
    return found


def fetch(target: Target, folder: Path, lock: Path = ENGINE_LOCK, source: list[str] | None = None) -> None:
    """Fetch the wheels of a target into a folder, from ``source`` (options of pip) or the registry.

    Raises
    ------
    subprocess.CalledProcessError
        pip found no file, or one that is not the lock's.
    """
    with tempfile.TemporaryDirectory() as scratch:
        wanted = Path(scratch) / "wanted.txt"
        wanted.write_text("\n".join(lines_for(target, lock.read_text(encoding="utf-8"))), encoding="utf-8")
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--require-hashes", *(source or [])]
        subprocess.run([*command, *target.options(), "--dest", str(folder), "-r", str(wanted)], check=True)


def make(output: Path, targets: list[Target], lock: Path = ENGINE_LOCK, source: list[str] | None = None) -> Path:
    """Fill a folder, or write a ZIP, with the wheels of some targets."""
    if output.suffix.lower() != ".zip":
        output.mkdir(parents=True, exist_ok=True)
        for target in targets:
            fetch(target, output, lock, source)
        return output
    output.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=output.parent) as scratch:
        folder = make(Path(scratch) / "wheels", targets, lock, source)
        complete = Path(scratch) / "wheels.zip"
        # wheels are compressed already
        with zipfile.ZipFile(complete, "w", zipfile.ZIP_STORED) as packed:
            for wheel in sorted(folder.glob("*.whl")):
                packed.write(wheel, wheel.name)
        complete.replace(output)
    return output


def main() -> None:
    """Fetch what the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--system", action="append", choices=list(SYSTEMS), help="default: all three")
    parser.add_argument("--python", action="append", choices=PYTHONS, help=f"default: {QGIS_PYTHON}")
    options = parser.parse_args()
    targets = [Target(*_of(system, python)) for system in options.system or SYSTEMS for python in options.python or [QGIS_PYTHON]]
    output = make(options.output, targets)
    size = output.stat().st_size if output.is_file() else sum(path.stat().st_size for path in output.glob("*.whl"))
    print(f"{output}: {size / 1e6:.0f} MB for {', '.join(f'{target.system} with Python {target.python}' for target in targets)}")


def _of(system: str, python: str) -> tuple[str, str, tuple[str, ...]]:
    name, tags = SYSTEMS[system]
    return name, python, tags


if __name__ == "__main__":
    main()
