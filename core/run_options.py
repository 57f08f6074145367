"""How a run is carried out: by how many processes, where, and what is kept of its blocks; no two runs write one output."""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from .errors import OutputError
from .feedback import Feedback
from .tile_jobs import JobRunner


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


@contextmanager
def job_runner(output: Path, options: RunOptions, feedback: Feedback) -> Iterator[JobRunner]:
    """A runner whose files are kept beside the output with ``resume`` and vanish otherwise.

    Raises
    ------
    OutputError
        Another run is writing this output.
    """
    workers = options.workers or os.cpu_count() or 1
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
            with JobRunner(folder, workers, options.scheduler, feedback.is_cancelled) as runner:
                yield runner
            return
        # workers of a cluster see the folder of the output, and nothing else for sure
        place = target.parent if options.scheduler else None
        with (
            tempfile.TemporaryDirectory(prefix=".tetratrack-", dir=place) as temporary,
            JobRunner(Path(temporary), workers, options.scheduler, feedback.is_cancelled) as runner,
        ):
            yield runner


@contextmanager
def _sole_writer(target: Path) -> Iterator[None]:
    """Hold a lock in the system's temporary folder that ends with the process, however that ends."""
    name = f"tetratrack-{hashlib.sha256(str(target).encode()).hexdigest()[:24]}.lock"
    handle = os.open(Path(tempfile.gettempdir()) / name, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise OutputError(
                "is being written by another run", source=target, remedy="Wait for it, or give this run another --output."
            ) from error
        yield
    finally:
        os.close(handle)
