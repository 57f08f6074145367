"""Which software made a result: version, and checksums of the code that a result depends on."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib import metadata
from pathlib import Path

CORE = Path(__file__).resolve().parents[1]
PROJECT = CORE.parent / "pyproject.toml"
JOB_PACKAGES = ("common", "model", "data", "segmentation", "adjustment", "pipeline")
"""Packages of ``core`` that decide what a block job computes."""


@cache
def software_version() -> str:
    """Version of tetratrack: of the plugin's or checkout's own files, otherwise of the installed package.

    The environment of an engine may hold a package of another version than the plugin that starts it.
    """
    if PROJECT.is_file():
        import tomllib

        return str(tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]["version"])
    return metadata.version("tetratrack")


@cache
def code_fingerprint(packages: tuple[str, ...] | None = None, core: Path = CORE) -> str:
    """Checksum (SHA-256, hexadecimal) of the Python files of some packages of ``core``, or of all.

    Results of other code are never taken for this one's: block jobs hold the fingerprint of :data:`JOB_PACKAGES`, run records that of
    everything.

    Raises
    ------
    ValueError
        A package has no Python file: its name is wrong.
    """
    digest = hashlib.sha256()
    for folder in [core] if packages is None else [core / name for name in packages]:
        modules = sorted(folder.rglob("*.py"))
        if not modules:
            raise ValueError(f"{folder} holds no Python file")
        for path in modules:
            digest.update(path.relative_to(core).as_posix().encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()
