"""Outputs compared with inputs before anything is written: none may eat another."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

from .atomic_files import cannot_write
from .errors import OutputError
from .paths import RESERVED, spelling


def check_targets(targets: Iterable[tuple[Path, str]], inputs: Iterable[Path] = ()) -> None:
    """Refuse to write a file that is one of the inputs, or two outputs of one name.

    Parameters
    ----------
    targets
        File to be written, and what it is made of, for the message.
    inputs
        Files that are read; those that do not exist do not matter.

    Raises
    ------
    OutputError
        Before anything is written.
    """
    read = {_identity(path): path for path in inputs if path.exists()}
    made: dict[str, str] = {}
    for target, origin in targets:
        # seen as it will be once folders are made: ".." behind one that is not there yet leads to the inputs too
        place = Path(os.path.realpath(target))
        try:
            taken = place.exists() and _identity(place) in read
        except OSError as error:
            raise cannot_write(target, error) from error
        if taken:
            raise OutputError(
                "is one of the inputs and would be overwritten", source=target, remedy="Choose another folder or name for the output."
            )
        name = spelling(target)
        if name in made:
            raise OutputError(f"would be written twice, for {made[name]} and for {origin}", source=target, remedy="Rename one of the two.")
        made[name] = origin


def check_ending(target: Path, endings: tuple[str, ...]) -> None:
    """Refuse a name without one of the ``endings`` of the only forms in which a file is written, in capitals or not.

    Raises
    ------
    OutputError
        Before anything is written.
    """
    if target.suffix.lower() not in endings:
        raise OutputError("cannot be written in that form", source=target, remedy=f"End the name in {' or '.join(endings)}.")


def check_own(target: Path, marks: Iterable[str]) -> None:
    """Refuse to replace a file that another program or another command wrote; an empty one is nobody's.

    Parameters
    ----------
    target
        File to be written.
    marks
        Words near the start of every file of its kind, or at its end.

    Raises
    ------
    OutputError
        Before anything is written.
    """
    try:
        # a device is refused where it would be replaced
        if target.exists() and not target.is_file():
            return
        with target.open("rb") as stream:
            start = stream.read(65536)
            # what has its index at the end states itself there
            stream.seek(max(len(start), stream.seek(0, os.SEEK_END) - 4096))
            read = start + stream.read()
    except FileNotFoundError:
        return
    except OSError as error:
        raise cannot_write(target, error) from error
    if start.strip() and not all(mark.encode("utf-8") in read for mark in marks):
        raise not_own(target)


def not_own(target: Path) -> OutputError:
    """What to say of a file that would be replaced, and is somebody else's."""
    return OutputError(
        "exists and was not written by this command", source=target, remedy="Choose another name for the output, or delete it first."
    )


def _identity(path: Path) -> tuple[int, int] | str:
    """What tells whether two paths are one file, by links too."""
    state = path.stat()
    return (state.st_dev, state.st_ino) if state.st_ino else os.path.normcase(path.resolve())


def safe_name(label: str) -> str:
    """A label of an epoch as part of a file's name: letters of all scripts and digits stay, other signs become a dash, names of
    devices on Windows get one."""
    name = re.sub(r"[^\w.-]+", "-", label).strip(".") or "-"
    return f"{name}-" if name.split(".")[0].lower() in RESERVED else name
