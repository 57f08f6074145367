"""Files that appear whole or not at all: written under a temporary name beside the target, then renamed."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import secrets
import shutil
import socket
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from .errors import OutputError
from .paths import WINDOWS, remedy_for

_MARK = re.compile(r"(?P<pid>\d+)-(?P<host>[0-9a-z]+)-[0-9a-f]{8}")
"""Part of a temporary name: the process and machine that write it, so that others know when it is nobody's any more."""
PATIENCE_SECONDS = 3.0
"""How long a rename is tried on Windows while another program reads the target."""
RESERVE = 65536
"""Bytes of a disk that are left to the journals of reviewers' decisions: no output takes the last of them."""
FOLDER = ".tetratrack-"
"""Start of the names of temporary folders."""


@contextmanager
def temporary_beside(target: Path) -> Iterator[Path]:
    """An empty temporary file in the target's folder, or where the target as a link leads to, removed on leaving unless it was renamed.

    What killed processes left there under the names of this target is removed first.

    Raises
    ------
    OutputError
        The target is a folder, or its folder cannot be written.
    """
    target = followed(target)
    temporary = target.with_name(f".{target.name}.{process_mark()}.part")
    try:
        if target.is_dir():
            raise OutputError("is a folder", source=target, remedy="Give the name of a file.")
        if target.exists() and not target.is_file():
            raise OutputError("is a device, not a file, and would be replaced", source=target, remedy="Give the name of a file.")
        remove_leftovers(target)
        _check_room(target.parent)
        os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600))
    except OSError as error:
        raise cannot_write(target, error) from error
    try:
        yield temporary
    finally:
        for leftover in (temporary, temporary.with_name(temporary.name + "-journal")):
            with contextlib.suppress(FileNotFoundError):
                leftover.unlink()


@contextmanager
def temporary_folder(place: Path | None = None) -> Iterator[Path]:
    """An empty folder in ``place``, or among the system's temporary files, removed on leaving; those of killed processes go first.

    Raises
    ------
    OutputError
        It cannot be made.
    """
    parent = Path(tempfile.gettempdir()) if place is None else place
    _remove_marked(parent, FOLDER)
    folder = parent / f"{FOLDER}{process_mark()}"
    try:
        folder.mkdir(mode=0o700)
    except OSError as error:
        raise cannot_write(folder, error) from error
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def replace_durably(temporary: Path, target: Path) -> None:
    """Give a finished temporary file its name so that neither a crash nor power loss leaves a half-written file.

    Where the target is a symbolic link, the file it leads to is replaced and the link stays.
    """
    target = followed(target)
    with temporary.open("rb+") as stream:
        os.fsync(stream.fileno())
    # temporary files are for the owner alone; results are shared like any other file
    mask = os.umask(0)
    os.umask(mask)
    temporary.chmod(0o666 & ~mask)
    _take_place(temporary, target)
    if os.name == "posix":
        folder = os.open(target.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)


def followed(target: Path) -> Path:
    """Where a target that is a symbolic link leads to, though nothing may be there yet; others as they are."""
    return Path(os.path.realpath(target)) if os.path.islink(target) else target


def _take_place(temporary: Path, target: Path) -> None:
    """Rename; on Windows a program that reads the target at this moment (a scanner for viruses, QGIS) forbids it for a while."""
    until = time.monotonic() + (PATIENCE_SECONDS if WINDOWS else 0.0)
    while True:
        try:
            temporary.replace(target)
            return
        except PermissionError:
            if time.monotonic() >= until:
                raise
            time.sleep(0.1)


def write_all(contents: Mapping[Path, bytes]) -> None:
    """Write several files completely or none of them (but for a failure between two renames).

    Raises
    ------
    OutputError
        As :func:`write_whole`.
    """
    with contextlib.ExitStack() as stack:
        ready = {}
        for target, content in contents.items():
            temporary = stack.enter_context(temporary_beside(target.absolute()))
            try:
                _check_room(temporary.parent, len(content))
                temporary.write_bytes(content)
            except OSError as error:
                raise cannot_write(target, error) from error
            ready[target.absolute()] = temporary
        for target, temporary in ready.items():
            try:
                replace_durably(temporary, target)
            except OSError as error:
                raise cannot_write(target, error) from error


def write_whole(target: Path, content: bytes) -> None:
    """Write a file completely or not at all.

    Raises
    ------
    OutputError
        The folder does not exist or cannot be written, the target is a folder, or the disk is full.
    """
    write_all({target: content})


def _check_room(folder: Path, size: int = 0) -> None:
    usage = shutil.disk_usage(folder)
    # some network drives state no size at all
    if usage.total and usage.free < size + RESERVE:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def cannot_write(target: Path, error: Exception) -> OutputError:
    """What to say when a file cannot be written: which, why and what to do."""
    reason = getattr(error, "strerror", None) or str(error)
    return OutputError(f"cannot be written ({reason})", source=target, remedy=remedy_for(target, error))


def process_mark() -> str:
    """Part of a temporary name that tells which process of which machine writes it; another one at every call."""
    return f"{os.getpid()}-{_host()}-{secrets.token_hex(4)}"


def remove_leftovers(target: Path) -> None:
    """Remove temporary files of a target whose process is gone; those of other machines are left alone."""
    _remove_marked(target.parent, f".{target.name}.")


def _remove_marked(folder: Path, start: str) -> None:
    """Remove files and folders whose names begin so and bear the mark of a process of this machine that has ended."""
    try:
        names = [name for name in os.listdir(folder) if name.startswith(start)]
    except OSError:
        return
    for name in names:
        mark = _MARK.match(name, len(start))
        if mark is None or mark["host"] != _host() or _lives(int(mark["pid"])):
            continue
        with contextlib.suppress(OSError):
            if (folder / name).is_dir() and not (folder / name).is_symlink():
                shutil.rmtree(folder / name)
            else:
                (folder / name).unlink()


def _host() -> str:
    return re.sub(r"[^0-9a-z]", "", socket.gethostname().lower()) or "localhost"


def _lives(pid: int) -> bool:
    """Whether a process of this machine runs; on Windows, where asking would end it, every one counts as running."""
    if os.name != "posix":
        return True
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True
