"""Locks of outputs: no two processes write one, and a lock whose holder was killed is taken away or taken over."""

from __future__ import annotations

import os
import socket
import stat
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from .atomic_files import cannot_write
from .errors import OutputError

PAUSE = 0.02
"""Seconds between two looks whether a lock is held."""


@contextmanager
def sole_writer(target: Path) -> Iterator[None]:
    """Hold a lock beside the output, which all users and machines see; it ends with the process, however that ends.

    Raises
    ------
    OutputError
        Another run holds it, or the folder cannot be written.
    """
    path = _lock_of(target)
    handle = _locked(path, target)
    try:
        os.ftruncate(handle, 0)
        os.write(handle, f"process {os.getpid()} on {socket.gethostname()}\n".encode())
        yield
    finally:
        if sys.platform != "win32":
            # removed while it is held; one who waits for this file sees that it is gone and makes another
            with suppress(OSError):
                path.unlink()
        os.close(handle)


def clear_lock(target: Path, seconds: float) -> None:
    """Take away the lock of a process that was killed, as soon as its copies have ended, too; one still held after so long stays."""
    end = time.monotonic() + seconds
    while _lock_of(target).exists() and time.monotonic() < end:
        with suppress(OutputError), sole_writer(target):
            return
        time.sleep(PAUSE)


def _lock_of(target: Path) -> Path:
    return target.with_name(f"{target.name}.lock")


def _no_lock(path: Path) -> OutputError:
    """In a folder of several people somebody may have put a link to another's file there, to have it overwritten."""
    return OutputError("is no lock of a run but a link, or no file", source=path, remedy="Delete it.")


def _locked(path: Path, target: Path) -> int:
    """Handle of the lock file, locked."""
    while True:
        try:
            handle = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError as error:
            if path.is_symlink():
                raise _no_lock(path) from error
            raise cannot_write(path, error) from error
        state = os.fstat(handle)
        if not stat.S_ISREG(state.st_mode) or state.st_nlink > 1:
            os.close(handle)
            raise _no_lock(path)
        try:
            if sys.platform != "win32":
                with suppress(PermissionError):
                    # whatever the umask: a run that was killed leaves the file, and the next may be another user's
                    os.fchmod(handle, 0o666)  # nosec B103 - an empty lock, and the next to lock it may be another user
        except OSError as error:
            raise cannot_write(path, error) from error
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
                return handle
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            holder = os.pread(handle, 200, 0).decode("utf-8", "replace").strip() if sys.platform != "win32" else ""
            os.close(handle)
            who = f" ({holder})" if holder else ""
            raise OutputError(
                f"is being written by another run{who}", source=target, remedy="Wait for it, or give this run another --output."
            ) from error
        if path.exists() and os.path.samestat(os.fstat(handle), path.stat()):
            return handle
        os.close(handle)
