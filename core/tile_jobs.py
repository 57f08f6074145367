"""Tile jobs: the survey cut into blocks that are worked on alone, anywhere, in any order, with the same result.

A job is a pure function of files: it reads the points of its block and a halo around it, and writes one file named after
everything that went into it (checksums of the tiles, settings, version of the software). A file that exists is a job that
is done. Blocks are laid out from the extent of the epoch's points alone, so that neither the way the points were cut into files
nor the number of workers changes anything.
"""

from __future__ import annotations

import hashlib
import io
import json
import math
import multiprocessing
import os
import signal
import threading
import zipfile
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from .errors import Cancelled, InputError, OutputError, TetratrackError
from .geopackage import replace_durably, temporary_beside
from .kernels import threads_of_kernels
from .tiles import TileInfo, Window

FloatArray = NDArray[np.float64]
Arrays = Mapping[str, NDArray[Any]]

BLOCK_HEIGHTS = 30.0
"""Side of a block in unit heights: some two hundred units of surface, large beside the halo and small beside memory."""
LEAST_BLOCK_HEIGHTS = 5.0
MOST_BLOCK_POINTS = 3_000_000
"""Points per block that a worker with 1 GiB can hold with all that is derived from them."""
HALO_HEIGHTS = 2.5
"""A unit centred on the edge of a block reaches 0.66 H; the neighbours that compete with it for points, another 1.3 H."""
MARGIN_HEIGHTS = 0.5
"""Units centred this far outside their block are reported too, and the block they lie in decides."""
ATTEMPTS = 3
"""Times a job is started before a worker that dies over it (for want of memory, say) ends the run."""


@dataclass(frozen=True)
class Block:
    """Part of an epoch that one job works on.

    Attributes
    ----------
    epoch
        Label of the epoch.
    column, row
        Place in the epoch's grid of blocks.
    core
        The block itself; blocks of an epoch do not overlap.
    tiles
        Tiles that hold points of the core or its halo.
    """

    epoch: str
    column: int
    row: int
    core: Window
    tiles: tuple[TileInfo, ...]


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


def plan_blocks(epoch: str, tiles: Sequence[TileInfo], unit_height: float) -> tuple[Block, ...]:
    """Cut an epoch into equal blocks from the extent and number of its points.

    Parameters
    ----------
    epoch
        Label.
    tiles
        All tiles of the epoch.
    unit_height
        Largest nominal height H, metres.
    """
    low = np.min([tile.low for tile in tiles], axis=0)[:2]
    high = np.max([tile.high for tile in tiles], axis=0)[:2]
    size = high - low
    count = np.maximum(1, np.ceil(size / (BLOCK_HEIGHTS * unit_height))).astype(int)
    most = np.maximum(1, np.floor(size / (LEAST_BLOCK_HEIGHTS * unit_height))).astype(int)
    points = sum(tile.points for tile in tiles)
    while points / math.prod(count) > MOST_BLOCK_POINTS and (count < most).any():
        side = np.where(count < most, size / count, -1.0)
        count[int(np.argmax(side))] += 1
    blocks = []
    for column, row in product(range(count[0]), range(count[1])):
        # the last block of a row is open to the east and north, so that no point lies on an edge and in no block
        east = low[0] + size[0] * (column + 1) / count[0] if column + 1 < count[0] else math.inf
        north = low[1] + size[1] * (row + 1) / count[1] if row + 1 < count[1] else math.inf
        core = Window(float(low[0] + size[0] * column / count[0]), float(low[1] + size[1] * row / count[1]), float(east), float(north))
        grown = core.grown(HALO_HEIGHTS * unit_height)
        near = tuple(tile for tile in tiles if grown.meets(tile.low, tile.high))
        if any(core.meets(tile.low, tile.high) for tile in near):
            blocks.append(Block(epoch, column, row, core, near))
    return tuple(blocks)


@cache
def software_fingerprint() -> str:
    """Checksum of the numeric code, so that results of another version are never taken for this one's."""
    digest = hashlib.sha256()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.name.encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


def job_key(kind: str, settings: Mapping[str, Any], inputs: Iterable[str]) -> str:
    """Key of a result: kind of job, settings (JSON values), checksums of the inputs, and the software.

    The inputs' order does not matter.
    """
    content = json.dumps([kind, settings, sorted(inputs), software_fingerprint()], sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()[:40]


def save_arrays(path: Path, arrays: Arrays) -> None:
    """Write arrays to a .npz whole or not at all.

    Raises
    ------
    OutputError
        The file cannot be written, or the disk is full.
    """
    try:
        buffer = io.BytesIO()
        np.savez(buffer, **{name: np.asarray(array) for name, array in arrays.items()})  # type: ignore[arg-type]
        with temporary_beside(path) as temporary:
            temporary.write_bytes(buffer.getbuffer())
            replace_durably(temporary, path)
    except OSError as error:
        raise OutputError(
            f"cannot be written ({error.strerror or error})", source=path, remedy="Free some disk space, then run again with --resume."
        ) from error


def load_arrays(path: Path, without: Collection[str] = ()) -> dict[str, NDArray[Any]] | None:
    """Arrays of a finished job but those named in ``without``; None where there is no file or what is read of it is damaged."""
    try:
        with np.load(path, allow_pickle=False) as archive:
            return {name: archive[name] for name in archive.files if name not in without}
    except (FileNotFoundError, zipfile.BadZipFile, ValueError, EOFError, KeyError, OSError):
        return None


def loaded_arrays(path: Path, without: Collection[str] = ()) -> dict[str, NDArray[Any]]:
    """Arrays of a job that is done; those named in ``without`` are not read.

    Raises
    ------
    InputError
        Its file is gone.
    """
    arrays = load_arrays(path, without)
    if arrays is None:
        raise InputError("vanished while the run was using it", source=path, remedy="Run again, and leave the folder alone meanwhile.")
    return arrays


@dataclass
class JobRunner:
    """Runs jobs here, in local processes or on a cluster; as a context manager it ends its processes.

    Local processes are started when first needed and serve all later calls, so that libraries are loaded once.

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
    """

    folder: Path
    workers: int = 1
    scheduler: str | None = None
    is_cancelled: Callable[[], bool] = lambda: False
    _pool: ProcessPoolExecutor | None = field(default=None, init=False, repr=False)
    _strangers: frozenset[Any] = field(default=frozenset(), init=False, repr=False)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the local processes once their jobs are done; a later call starts new ones."""
        if self._pool is not None:
            self._pool.shutdown(wait=True, cancel_futures=True)
            self._pool = None

    def run(self, jobs: Sequence[Job], progress: Callable[[int, int], None] = lambda done, total: None) -> list[Path]:
        """Run what is not done yet; returns the result files in the order of the jobs.

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
        if self.scheduler is not None:
            finished = self._on_cluster(todo)
        elif self.workers > 1 and len(todo) > 1:
            finished = self._in_processes(todo)
        else:
            finished = self._here(todo)
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

    def _in_processes(self, tasks: Sequence[Task]) -> Iterator[None]:
        waiting = list(tasks)
        for attempt in range(1, ATTEMPTS + 1):
            try:
                for task in self._pool_pass(tuple(waiting)):
                    waiting.remove(task)
                    yield
                return
            except BrokenProcessPool as error:
                if attempt == ATTEMPTS:
                    raise TetratrackError(
                        f"a worker process was ended from outside {ATTEMPTS} times. If memory ran out, use fewer --workers; "
                        "with --resume finished blocks are kept."
                    ) from error

    def _pool_pass(self, tasks: Sequence[Task]) -> Iterator[Task]:
        clean = False
        try:
            pending = self._submitted(tasks)
            while pending:
                done, _ = wait(pending, timeout=0.2, return_when=FIRST_COMPLETED)
                for future in done:
                    task = pending.pop(future)
                    future.result()
                    yield task
                if self.is_cancelled():
                    raise Cancelled("cancelled")
            clean = True
        finally:
            if not clean:
                for process in set(multiprocessing.active_children()) - self._strangers:
                    process.kill()
                self.close()

    def _submitted(self, tasks: Sequence[Task]) -> dict[Future[None], Task]:
        # an executor starts its processes as tasks come in: these inherit the environment of this moment
        with _interrupts_held(), _threads_per_worker(max(1, (os.cpu_count() or 1) // self.workers)):
            if self._pool is None:
                self._strangers = frozenset(multiprocessing.active_children())
                # spawned, not forked: forked copies of a process with threads (numba, OpenMP) can hang
                self._pool = ProcessPoolExecutor(self.workers, multiprocessing.get_context("spawn"), initializer=_ignore_interrupt)
            return {self._pool.submit(_run_and_save, *task): task for task in tasks}

    def _on_cluster(self, tasks: Sequence[Task]) -> Iterator[None]:
        try:
            from distributed import Client, as_completed
        except ImportError as error:
            raise TetratrackError("--scheduler needs dask.distributed. Install it with: pip install 'tetratrack[cluster]'") from error
        try:
            client: Any = Client(self.scheduler, timeout="20s", set_as_default=False)  # type: ignore[no-untyped-call]
        except OSError as error:
            raise TetratrackError(
                f"no dask scheduler answers at {self.scheduler}. Start one with: dask scheduler, and workers with: dask worker ADDRESS"
            ) from error
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


def _run_and_save(job: Job, path: Path) -> None:
    """What a worker does: a job that another run finished meanwhile is not done again."""
    if load_arrays(path) is None:
        save_arrays(path, job.run())


def _ignore_interrupt() -> None:
    """Ctrl-C goes to the whole group of processes; only the parent decides what it means."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """Let Ctrl-C and SIGTERM wait: a worker whose parent is interrupted in the middle of starting it would complain of its own."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    held: list[int] = []
    before = {number: signal.signal(number, lambda number, _: held.append(number)) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if held:
            signal.raise_signal(held[0])


@contextmanager
def _threads_per_worker(count: int) -> Iterator[None]:
    """Let started processes use that many threads each, so that workers do not compete for the cores."""
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, str(count)))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
