"""How a run is carried out: by how many processes, where, and what is kept of its blocks; no two runs write one output."""

from __future__ import annotations

import os
import socket
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from ..common.atomic_files import cannot_write, temporary_folder
from ..common.errors import OutputError
from ..common.feedback import Feedback
from .block_clouds import BlockClouds
from .job_runner import JobRunner, check_scheduler
from .local_processes import LocalProcesses, cores, processes_for


@dataclass(frozen=True)
class RunOptions:
    """How a run is carried out; nothing here changes its result but the seed.

    Attributes
    ----------
    workers
        Local processes; 0 takes one per core.
    scheduler
        Address of a dask scheduler instead.
    resume
        Keep finished blocks beside the output and use those of an earlier, interrupted run.
    seed
        Of the random draws.
    """

    workers: int = 0
    scheduler: str | None = None
    resume: bool = False
    seed: int = 0

    @property
    def cores(self) -> int:
        """Local processes asked for: one a core where their number is left open."""
        return cores(self.workers)


@contextmanager
def job_runner(
    output: Path, options: RunOptions, feedback: Feedback, processes: LocalProcesses | None = None, *, keep_points: bool = False
) -> Iterator[JobRunner]:
    """A runner whose files are kept beside the output with ``resume`` and vanish otherwise.

    ``processes`` are those of :func:`.local_processes.processes_for`, started already; None makes them. ``keep_points``: later jobs look at
    the points of blocks again, which are kept where files vanish with the run.

    Raises
    ------
    InputError, TetratrackError
        The scheduler's address is wrong, or nothing answers there.
    OutputError
        Another run is writing this output.
    """
    processes = processes or processes_for(options.workers, options.scheduler)
    if options.scheduler is not None:
        check_scheduler(options.scheduler)
    target = output.absolute()
    with _sole_writer(target):
        if options.resume:
            folder = target.with_name(f"{target.name}.jobs")
            try:
                folder.mkdir(exist_ok=True)
            except OSError as error:
                raise OutputError(
                    f"cannot be made ({error.strerror})", source=folder, remedy="Check the folder's permissions and free space."
                ) from error
            with JobRunner(folder, options.cores, options.scheduler, feedback.is_cancelled, processes) as runner:
                yield runner
            return
        # workers of a cluster see the folder of the output, and nothing else for sure
        place = target.parent if options.scheduler else None
        with temporary_folder(place) as temporary:
            # workers of a cluster would have them sent through its network
            clouds = BlockClouds(temporary if keep_points and not options.scheduler else None)
            with JobRunner(temporary, options.cores, options.scheduler, feedback.is_cancelled, processes, clouds) as runner:
                yield runner


@contextmanager
def _sole_writer(target: Path) -> Iterator[None]:
    """Hold a lock beside the output, which all users and machines see; it ends with the process, however that ends.

    Raises
    ------
    OutputError
        Another run holds it, or the folder cannot be written.
    """
    path = target.with_name(f"{target.name}.lock")
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
