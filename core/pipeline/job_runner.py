"""Jobs run here, in local processes or on a cluster, in any order, with the same result.

A job is a pure function of files: it reads the points of its block and a halo around it, and writes one file named after
everything that went into it (checksums of the tiles, settings, version of the software). A file that exists is a job that
is done.
"""

from __future__ import annotations

import hashlib
import json
import socket
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Protocol, Self
from urllib.parse import urlsplit

from ..common.errors import Cancelled, InputError, TetratrackError
from ..common.kernels import threads_of_kernels
from ..common.software import JOB_PACKAGES, code_fingerprint
from .array_files import Arrays, load_arrays, save_arrays
from .block_clouds import NOT_KEPT, BlockClouds
from .local_processes import LocalProcesses

CONNECT_SECONDS = 5.0
ATTEMPTS = 3
"""Times a job is started before a worker that dies over it (for want of memory, say) ends the run."""


class Job(Protocol):
    """A pure function of files; must survive pickling."""

    @property
    def name(self) -> str:
        """File name of the result, which holds the key of everything that determines it."""
        ...

    def run(self) -> Arrays:
        """Compute the result."""
        ...


Task = tuple[Job, Path]
"""A job and the file its result goes to; the parent names it, whatever version of the software a worker has."""


def job_key(kind: str, settings: Mapping[str, Any], inputs: Iterable[str]) -> str:
    """Key of a result: kind of job, settings (JSON values), checksums of the inputs, and the software.

    The inputs' order does not matter.
    """
    content = json.dumps([kind, settings, sorted(inputs), code_fingerprint(JOB_PACKAGES)], sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()[:40]


@dataclass
class JobRunner:
    """Runs jobs here, in local processes or on a cluster; as a context manager it ends its processes.

    Attributes
    ----------
    folder
        Where results are kept; shared by all machines of a cluster.
    workers
        Number of local processes, and of cores used by all of them; 1 works in this process.
    scheduler
        Address of a dask scheduler, or None.
    is_cancelled
        Asked while waiting.
    processes
        As many local processes as workers, which may be loading libraries already; None starts them when first needed.
    clouds
        Where jobs keep points of blocks for later ones.
    has_company
        Whether other processes work on jobs while the caller does work of its own.
    """

    folder: Path
    workers: int = 1
    scheduler: str | None = None
    is_cancelled: Callable[[], bool] = lambda: False
    processes: LocalProcesses | None = None
    clouds: BlockClouds = NOT_KEPT
    has_company: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        self._processes = self.processes or LocalProcesses(self.workers)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._processes.close()

    def run(
        self,
        jobs: Sequence[Job],
        progress: Callable[[int, int], None] = lambda done, total: None,
        beside: Callable[[], None] = lambda: None,
    ) -> list[Path]:
        """Run what is not done yet; returns the result files in the order of the jobs.

        Parameters
        ----------
        jobs
            In any order.
        progress
            Told how many are done, of how many.
        beside
            The caller's own work meanwhile: while processes are busy, or before the jobs where there are none. What it raises ends the run.

        Raises
        ------
        TetratrackError
            A job's own error, or a worker died over the same job again and again.
        Cancelled
            ``is_cancelled`` said so; running jobs are ended at once.
        """
        paths = [self.folder / job.name for job in jobs]
        todo = [(job, path) for job, path in zip(jobs, paths, strict=True) if load_arrays(path) is None]
        done = len(jobs) - len(todo)
        progress(done, len(jobs))
        if self.scheduler is None and self.workers > 1 and len(todo) > 1:
            # jobs that are tried again do not have it done again
            finished = self._in_processes(todo, cache(beside))
        elif self.scheduler is None:
            # here, too, the caller may use the cores of all workers, and no more
            with threads_of_kernels(self.workers):
                beside()
            finished = self._here(todo)
        else:
            beside()
            finished = self._on_cluster(todo)
        for _ in finished:
            done += 1
            progress(done, len(jobs))
        return paths

    def _here(self, tasks: Sequence[Task]) -> Iterator[None]:
        for task in tasks:
            if self.is_cancelled():
                raise Cancelled("cancelled")
            # a single job may use the cores of all workers, and no more
            with threads_of_kernels(self.workers):
                _run_and_save(*task)
            yield

    def _in_processes(self, tasks: Sequence[Task], beside: Callable[[], None]) -> Iterator[None]:
        waiting = list(tasks)
        for attempt in range(1, ATTEMPTS + 1):
            try:
                for task in self._pass(tuple(waiting), beside):
                    waiting.remove(task)
                    yield
                return
            except BrokenProcessPool as error:
                if self._processes.imported:
                    raise InputError(
                        "the script that starts the run is imported by its worker processes, and would start it again in each",
                        remedy='Put the lines that start the run under: if __name__ == "__main__":',
                    ) from error
                if attempt == ATTEMPTS:
                    raise TetratrackError(
                        f"a worker process was ended from outside {ATTEMPTS} times. If memory ran out, use fewer --workers; "
                        "with --resume finished blocks are kept."
                    ) from error

    def _pass(self, tasks: Sequence[Task], beside: Callable[[], None]) -> Iterator[Task]:
        clean = False
        try:
            pending = self._processes.submitted([(_run_and_save, *task) for task in tasks])
            waiting = dict(zip(pending, tasks, strict=True))
            # the cores are the workers' now
            self.has_company = True
            try:
                with threads_of_kernels(1):
                    beside()
            finally:
                self.has_company = False
            while waiting:
                done, _ = wait(waiting, timeout=0.2, return_when=FIRST_COMPLETED)
                for future in done:
                    task = waiting.pop(future)
                    future.result()
                    yield task
                if self.is_cancelled():
                    raise Cancelled("cancelled")
            clean = True
        finally:
            if not clean:
                self._processes.kill()

    def _on_cluster(self, tasks: Sequence[Task]) -> Iterator[None]:
        try:
            from distributed import Client, as_completed
        except ImportError as error:
            raise TetratrackError("--scheduler needs dask.distributed. Install it with: pip install 'tetratrack[cluster]'") from error
        try:
            client: Any = Client(self.scheduler, timeout="20s", set_as_default=False)  # type: ignore[no-untyped-call]
        except Exception as error:
            # distributed raises OSError, TimeoutError, ValueError, ImportError and others, by scheme and state of the network
            raise no_scheduler(str(self.scheduler)) from error
        with client:
            # pure=False: a key is the job's own name, so that a rerun after a failure is not served a remembered error
            futures = [client.submit(_run_and_save, *task, pure=False, retries=ATTEMPTS - 1) for task in tasks]
            try:
                for future in as_completed(futures, loop=client.loop):  # type: ignore[no-untyped-call]
                    if self.is_cancelled():
                        raise Cancelled("cancelled")
                    future.result()
                    yield
            finally:
                client.cancel(futures)


def check_scheduler(address: str) -> None:
    """Find out before any work whether something listens at a scheduler's address.

    Raises
    ------
    InputError
        It is no address of a dask scheduler.
    TetratrackError
        Nothing listens there.
    """
    parts = urlsplit(address)
    try:
        place = parts.hostname, parts.port
    except ValueError:
        place = None, None
    if parts.scheme not in ("tcp", "tls") or not all(place):
        raise InputError(f"{address!r} is no address of a dask scheduler", remedy="Write it as tcp://HOST:8786, or tls://HOST:8786.")
    try:
        socket.create_connection((str(place[0]), int(place[1] or 0)), timeout=CONNECT_SECONDS).close()
    except OSError as error:
        raise no_scheduler(address) from error


def no_scheduler(address: str) -> TetratrackError:
    """What to say when a scheduler does not answer."""
    return TetratrackError(f"no dask scheduler answers at {address}. Start one with: dask scheduler, and workers with: dask worker ADDRESS")


def _run_and_save(job: Job, path: Path) -> None:
    """What a worker does: a job that another run finished meanwhile is not done again."""
    if load_arrays(path) is None:
        save_arrays(path, job.run())
