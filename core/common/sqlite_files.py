"""Databases that another process left in the middle of a write: recovered before anybody reads them.

A writer that was killed leaves a rollback journal or a write-ahead log beside its file. SQLite rolls it back for whoever may write; a
reader that opens the file read-only, as GDAL does, is refused or sees half a write.
"""

from __future__ import annotations

import os
import sqlite3
from contextlib import closing, suppress
from pathlib import Path

from .paths import sqlite_address

CHECKPOINT_SUFFIXES = ("-journal", "-wal")
"""Endings of the files in which SQLite keeps what is not yet, or no longer, in the database."""


def recover(path: Path) -> None:
    """Let SQLite finish or undo what a killed writer left beside any database, so that other readers (GDAL) find it sound.

    Nothing happens where the file does not exist, may not be written, or is no database: its reader says so.
    """
    if path.is_file() and has_leftovers(path) and may_recover(path):
        with suppress(sqlite3.Error), closing(sqlite3.connect(sqlite_address(path.resolve(), "mode=rw"), uri=True)) as connection:
            connection.execute("SELECT count(*) FROM sqlite_master").fetchone()


def may_recover(path: Path) -> bool:
    """Whether the system lets SQLite write; to put a file right is no change to it, even to one that was protected."""
    return os.access(path, os.W_OK) and os.access(path.parent, os.W_OK)


def has_leftovers(path: Path) -> bool:
    """Whether a journal or write-ahead log with contents lies beside a database: its writer is at work, or was killed."""
    beside = [path.with_name(path.name + suffix) for suffix in CHECKPOINT_SUFFIXES]
    return any(file.is_file() and file.stat().st_size > 0 for file in beside)
