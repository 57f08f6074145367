"""One way to open a result: what another process left in the middle of a write is recovered first, and a file that a stranger made
can neither run anything nor keep the reader for ever.

A writer that was killed leaves a rollback journal or a write-ahead log beside the result. SQLite rolls it back for whoever may write;
therefore files are opened for writing even to be read, then read-only, and as unchangeable only where nothing lies beside them.
"""

from __future__ import annotations

import os
import sqlite3
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from contextvars import ContextVar
from functools import partial
from pathlib import Path
from typing import TypeVar

from ..common.errors import InputError, OutputError
from ..common.paths import sqlite_address
from ..common.sqlite_files import has_leftovers, may_recover
from .schema import LAYERS

BUSY_SECONDS = 30.0
"""How long one process waits for another that is writing to the same file."""
READING_SECONDS = 45.0
"""Longest time a connection opened for reading may compute: a file made to never end is refused."""
PROGRESS_STEPS = 100_000
"""Steps of SQLite's machine between two looks at the time and at signals."""
ASK_SECONDS = 0.05
"""How long SQLite itself waits for another process where something else is to go on meanwhile."""
MEANWHILE: ContextVar[Callable[[], object] | None] = ContextVar("meanwhile", default=None)
Found = TypeVar("Found")
LONGEST_VALUE = 200_000_000
"""Bytes of a text, a geometry or a row."""
REQUIRED = ("units", "feature_points", "displacements", "epochs")
OWN_TABLES = frozenset({*LAYERS, "review_log", "unit_edits", "manual_picks"})
"""Tables that this program reads: they must be tables, since a view of a stranger computes whatever it likes."""
CHANGED = "Run tetratrack again; the file was changed by another tool."
CHOOSE = "Choose the result.gpkg that tetratrack run wrote."


@contextmanager
def meanwhile(act: Callable[[], object]) -> Iterator[None]:
    """Call ``act`` every now and then while files are read or written inside and that takes long, or others hold them: a window that
    draws itself then does not stand still."""
    token = MEANWHILE.set(act)
    try:
        yield
    finally:
        MEANWHILE.reset(token)


def patiently(act: Callable[[], Found]) -> Found:
    """Result of an act on a database, tried again while another process holds that, up to ``BUSY_SECONDS``."""
    end = time.monotonic() + BUSY_SECONDS
    while True:
        try:
            return act()
        except sqlite3.OperationalError as error:
            other = MEANWHILE.get()
            if other is None or "locked" not in str(error) or time.monotonic() > end:
                raise
            other()


def limit_computing(connection: sqlite3.Connection, seconds: float) -> None:
    """Let a connection compute no longer than that in all, heed signals, and let other things go on meanwhile."""
    end, other = time.monotonic() + seconds, MEANWHILE.get()

    def look() -> int:
        if other is not None:
            other()
        return int(time.monotonic() > end)

    connection.set_progress_handler(look, PROGRESS_STEPS)


def connect(path: Path, *, write: bool = False, needed: Sequence[str] = REQUIRED) -> sqlite3.Connection:
    """Open a result file for reading, or for writing; the caller closes it.

    What a killed writer left is recovered. Reading sees no view in place of a layer, trusts no function that the file names, heeds
    signals, and ends after ``READING_SECONDS``. Layers that are ``needed`` must be there.

    Raises
    ------
    InputError
        The file does not exist, is no GeoPackage of tetratrack, or was changed so that it cannot be read.
    """
    if not path.is_file():
        raise InputError("there is no such file", source=path, remedy=CHOOSE)
    connection = _opened(path, write)
    try:
        if not write:
            limit_computing(connection, READING_SECONDS)
            connection.execute("PRAGMA trusted_schema = OFF")
        connection.execute("PRAGMA cell_size_check = ON")
        with _told(path):
            _check_layout(connection, path, needed)
    except BaseException:
        connection.close()
        raise
    return connection


@contextmanager
def reading(path: Path, needed: Sequence[str] = REQUIRED) -> Iterator[sqlite3.Connection]:
    """A connection for reading a file with the ``needed`` layers, closed on leaving; what SQLite finds wrong is said in one sentence.

    Raises
    ------
    InputError
        As :func:`connect`, or what is read is damaged.
    """
    with closing(connect(path, needed=needed)) as connection, _told(path):
        yield connection


def is_writable(path: Path) -> bool:
    """Whether SQLite can write the file: it carries a write permission and its folder takes the journal."""
    # an administrator may write anything, yet a file without any write bit was protected on purpose
    return bool(path.stat().st_mode & 0o222) and os.access(path, os.W_OK) and os.access(path.parent, os.W_OK)


def _opened(path: Path, write: bool) -> sqlite3.Connection:
    """The first way to open the file that SQLite can read by."""
    writable = may_recover(path)
    ways = ["mode=rw"] if write or writable else []
    if not write:
        ways.append("mode=ro")
        if not has_leftovers(path):
            # in a folder that may only be read, SQLite cannot make the files it needs beside a result in write-ahead mode
            ways.append("mode=ro&immutable=1")
    problem: Exception | None = None
    for way in ways:
        connection = _connection(path, way)
        try:
            patiently(partial(_look_into, connection))
            return connection
        except (sqlite3.Error, UnicodeDecodeError) as error:
            connection.close()
            if "locked" in str(error):
                raise _held(path) from error
            problem = problem or error
    if has_leftovers(path) and not writable:
        raise InputError(
            f"was left in the middle of a write, and it or its folder is read-only ({problem})",
            source=path,
            remedy="Copy it with the -journal or -wal file beside it to a folder that can be written, and open it there.",
        ) from problem
    raise InputError(f"cannot be read as a GeoPackage ({problem})", source=path, remedy=CHOOSE) from problem


def _connection(path: Path, way: str) -> sqlite3.Connection:
    wait = BUSY_SECONDS if MEANWHILE.get() is None else ASK_SECONDS
    connection = sqlite3.connect(sqlite_address(path.resolve(), way), uri=True, timeout=wait, isolation_level=None)
    connection.row_factory = sqlite3.Row
    # no value of a result is as long, but a stranger's expression can make one that fills the memory
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST_VALUE)
    return connection


def _look_into(connection: sqlite3.Connection) -> None:
    connection.execute("SELECT count(*) FROM sqlite_master").fetchone()


def _held(path: Path) -> OutputError:
    return OutputError("is being written by another program", source=path, remedy="Wait until it has finished, then try again.")


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """Say what SQLite finds wrong with a file while it is read; an interrupt that SQLite swallowed goes on."""
    start = time.monotonic()
    try:
        yield
    except sqlite3.OperationalError as error:
        if "locked" in str(error):
            raise _held(path) from error
        if "interrupted" not in str(error):
            raise _damaged(path, error) from error
        if time.monotonic() - start < 0.9 * READING_SECONDS:
            # SQLite calls back while it computes, and drops what a signal handler raises there
            raise KeyboardInterrupt from error
        problem = f"takes longer than {READING_SECONDS:.0f} s to read"
        raise InputError(problem, source=path, remedy=CHANGED) from error
    except (sqlite3.Error, UnicodeDecodeError) as error:
        raise _damaged(path, error) from error


def _damaged(path: Path, error: Exception) -> InputError:
    words = " ".join(str(error).split())
    return InputError(f"cannot be read ({words[:200]})", source=path, remedy=CHANGED)


def _check_layout(connection: sqlite3.Connection, path: Path, needed: Sequence[str]) -> None:
    """Refuse a file without the needed layers, or with something else in the place of one."""
    present = {
        str(row["name"]): (str(row["type"]), str(row["sql"] or ""))
        for row in connection.execute("SELECT name, type, sql FROM sqlite_master WHERE type IN ('table', 'view')")
    }
    missing = [name for name in needed if name not in present]
    if missing:
        raise InputError(
            f"has no layer {', '.join(missing)}", source=path, remedy="Choose a result of tetratrack; this is another GeoPackage."
        )
    for name in sorted(OWN_TABLES & present.keys()):
        kind, definition = present[name]
        if kind != "table" or definition.lstrip().upper().startswith("CREATE VIRTUAL"):
            raise InputError(f"layer {name} is no plain table", source=path, remedy=CHANGED)
