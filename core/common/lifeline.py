"""Processes that end with the one that started them, however that ends. Nothing heavy is imported here: a worker ties itself to its
parent before it loads anything else."""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
import sys
import threading
from multiprocessing.connection import wait

from .garbage_collection import collect_seldom

_PR_SET_PDEATHSIG = 1
PARENT_WATCH = "parent watch"
"""Name of a thread that waits for word from the parent, or its end, and locks nothing meanwhile: a copy of the process may lack it."""
IMPORTED_EXIT = 78
"""Exit code of a worker that would have started the run again, because the script it was started by has no main guard."""


def start_as_worker(parent: int, from_main_thread: bool) -> None:
    """First act of a worker process: leave Ctrl-C to the parent, and end with it.

    Parameters
    ----------
    parent
        The parent's process id.
    from_main_thread
        The worker was started from the parent's main thread. Linux ends a worker with the thread that started it, at once and even
        within compiled code; other threads may end long before their process, so that there only the watching thread remains.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if from_main_thread and sys.platform.startswith("linux"):
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, int(signal.SIGKILL))
    started_by = multiprocessing.parent_process()
    if started_by is None or (os.name == "posix" and os.getppid() != parent):
        os._exit(1)
    threading.Thread(target=_end_with, args=(started_by.sentinel,), daemon=True).start()
    collect_seldom()


def _end_with(sentinel: int) -> None:
    wait([sentinel])
    os._exit(1)


def leave_if_imported() -> None:
    """End quietly a worker process that is still importing the user's script, and with it would start the run once more."""
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        os._exit(IMPORTED_EXIT)
