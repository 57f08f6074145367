"""Processes of this machine that jobs run in: started once, before they are needed, and ended with the process that started them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any, Self

import numpy as np

from ..common.errors import TetratrackError
from ..common.lifeline import IMPORTED_EXIT, PARENT_WATCH, leave_if_imported, start_as_worker

CORE = __package__.rpartition(".")[0]
LIBRARIES = (f"{CORE}.pipeline.block_jobs", f"{CORE}.segmentation.segment", f"{CORE}.segmentation.ends_of_units", "laspy", "pyproj")
"""What the first jobs of a run import."""
WHOLE_RUN = f"{CORE}.pipeline.whole_survey"
"""What imports nearly all that this process and later jobs need."""
MOST_IDLE_COPIES = 2
"""Copies are all made at once: so many without work yet are worth that libraries are loaded once."""


class LocalProcesses:
    """So many processes, started when first needed or before by :meth:`start`; as a context manager it ends them.

    They serve all later calls, so that libraries are loaded once.

    Parameters
    ----------
    count
        How many.
    forked
        The first ones may be copies of this process, made by :meth:`start`: nothing but the run is its work.
    """

    def __init__(self, count: int, *, forked: bool = False) -> None:
        self.count = count
        self._forked = forked
        self._pool: ProcessPoolExecutor | None = None
        self._strangers: frozenset[Any] = frozenset()
        self._processes: frozenset[Any] = frozenset()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if kind is not None:
            # what they were to load or do is of no use any more
            self.kill()
        self.close()

    def start(self, jobs: int) -> None:
        """Have as many of them as will have work load what that needs while the caller does other work; none where jobs run here.

        Where they may be copies of this process, it loads that itself, once for all; of copies those without work yet start, too, so that
        none are made where these would be more than two.

        Parameters
        ----------
        jobs
            How many there will be at least.

        Raises
        ------
        TetratrackError
            The script that starts the run would be run again by each of them.
        """
        if min(self.count, jobs) < 2 or self._pool is not None:
            return
        # where numba is loaded, something has been computed already, on threads perhaps
        few = self.count <= jobs + MOST_IDLE_COPIES
        if self._forked and few and "numba" not in sys.modules and _may_be_copied():
            import_module(WHOLE_RUN)
            _load_libraries()
            if _may_be_copied():
                from multiprocessing import resource_tracker

                # beside spawned workers there is one, and who watches a run from outside counts on it
                with _interrupts_held(), _worker_environment(1):
                    resource_tracker.ensure_running()
                self._pool = self._opened("fork", _start_as_copy)
        self.submitted([(_load_libraries,)] * min(self.count, jobs))

    def submitted(self, calls: Sequence[tuple[Any, ...]]) -> list[Future[None]]:
        """Have functions called there, each followed by its arguments; in any order.

        Raises
        ------
        TetratrackError
            The script that starts the run would be run again by each of them.
        """
        if self._pool is None:
            _check_main_guard()
            # spawned, not forked: forked copies of a process with threads (numba, OpenMP) can hang
            self._pool = self._opened("spawn", start_as_worker)
        # an executor starts its processes as calls come in: these inherit the environment of this moment
        with _interrupts_held(), _worker_environment(max(1, (os.cpu_count() or 1) // self.count)):
            futures = [self._pool.submit(*call) for call in calls]
            self._processes = frozenset(multiprocessing.active_children()) - self._strangers
            return futures

    def _opened(self, method: str, first_act: Callable[[int, bool], None]) -> ProcessPoolExecutor:
        """Executor whose processes come to be by a method of multiprocessing."""
        self._strangers = frozenset(multiprocessing.active_children())
        parent = os.getpid(), threading.current_thread() is threading.main_thread()
        return ProcessPoolExecutor(self.count, multiprocessing.get_context(method), initializer=first_act, initargs=parent)

    @property
    def imported(self) -> bool:
        """Whether one of them ended because the script that starts the run was imported by it."""
        return any(process.exitcode == IMPORTED_EXIT for process in self._processes)

    def kill(self) -> None:
        """End them at once; a later call starts new ones."""
        for process in self._processes:
            process.kill()
        self.close()

    def close(self) -> None:
        """End them once their jobs are done; a later call starts new ones."""
        if self._pool is not None:
            self._pool.shutdown(wait=True, cancel_futures=True)
            self._pool = None


def cores(workers: int) -> int:
    """Local processes that are asked for: one a core where ``workers`` is 0."""
    return workers or os.cpu_count() or 1


def processes_for(workers: int, scheduler: str | None, *, forked: bool = False) -> LocalProcesses:
    """The local processes that a run may use, not started yet: one where a scheduler works; ``forked`` as for :class:`LocalProcesses`."""
    leave_if_imported()
    return LocalProcesses(1 if scheduler is not None else cores(workers), forked=forked)


def _may_be_copied() -> bool:
    """Whether copies of this process can work: they lack its other threads, and what these have locked stays locked."""
    if not sys.platform.startswith("linux"):
        return False
    try:
        threads = len(os.listdir("/proc/self/task"))
    except OSError:
        # a container without /proc does not tell
        return False
    return threads == 1 + sum(thread.name == PARENT_WATCH for thread in threading.enumerate())


def _start_as_copy(parent: int, from_main_thread: bool) -> None:
    """First act of a worker process that is a copy of its parent: leave the parent's ways behind."""
    import numba

    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    start_as_worker(parent, from_main_thread)
    # numba, which states no types, read its number of threads when the parent loaded it
    config: Any = numba.config
    # the folder of compiled code is settled already, and the environment may name one that was refused
    folder = config.CACHE_DIR
    config.reload_config()
    config.CACHE_DIR = folder
    numba.set_num_threads(config.NUMBA_NUM_THREADS)


def _load_libraries() -> None:
    """What most jobs need and the start of a process does not bring along, numba's own tables included."""
    for name in LIBRARIES:
        import_module(name)
    from ..common.neighbourhood import build_grid

    build_grid(np.zeros((1, 3)), 1.0)


def _check_main_guard() -> None:
    """Refuse to start workers from a script that would start itself again in each of them.

    Raises
    ------
    TetratrackError
        With the line that is missing.
    """
    main = sys.modules.get("__main__")
    script = Path(getattr(main, "__file__", None) or "")
    # a module run with -m, a console command or a notebook is not imported anew under its own name
    if getattr(main, "__spec__", None) is not None or script.suffix != ".py" or not script.is_file():
        return
    if "__main__" not in script.read_text(encoding="utf-8", errors="replace"):
        raise TetratrackError(
            f"{script}: worker processes import this script, so that its work must stand under a line of its own: "
            'if __name__ == "__main__": and what it does indented below. Or use workers=1.'
        )


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
def _worker_environment(threads: int) -> Iterator[None]:
    """Let started processes use that many threads each, so that workers do not compete for the cores, and import nothing from the
    working directory."""
    wanted = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), str(threads))
    wanted["PYTHONSAFEPATH"] = "1"
    before = {name: os.environ.get(name) for name in wanted}
    os.environ.update(wanted)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
