"""Whole files that a user gives, read with a bound: a device never ends, and many gigabytes of a wrong file would fill the memory."""

from __future__ import annotations

from pathlib import Path

from .errors import InputError

MOST_BYTES = 200_000_000
"""A table of five million points; clouds are read by chunks."""


def check_regular(path: Path) -> None:
    """Refuse a device or pipe before it is opened: that would wait for somebody to write into it.

    Raises
    ------
    InputError
        It is one.
    OSError
        The system does not say.
    """
    if path.exists() and not (path.is_file() or path.is_dir()):
        raise InputError("is a device, not a file", source=path, remedy="Give the name of a file.")


def content_of(path: Path, most: int = MOST_BYTES) -> bytes:
    """Bytes of a regular file of at most ``most`` of them.

    Raises
    ------
    InputError
        It is a device or pipe, or larger.
    OSError
        The system does not give it.
    """
    check_regular(path)
    with path.open("rb") as stream:
        content = stream.read(most + 1)
    if len(content) > most:
        raise InputError(f"has more than {most // 1_000_000} MB, which no such file has", source=path, remedy="Is it the right file?")
    return content
