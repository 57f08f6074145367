"""Folders beside other caches of the user: what can be made again, kept so that the next command need not."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from functools import cache
from pathlib import Path

UNUSED_DAYS = 30
"""What no command has read for so long goes, where it is large."""


@cache
def cache_folder(name: str) -> Path | None:
    """Folder of one kind of memory, made if need be; None where there can be none.

    ``XDG_CACHE_HOME``, ``LOCALAPPDATA`` on Windows, or ``~/.cache``.
    """
    home = os.environ.get("XDG_CACHE_HOME") or (os.environ.get("LOCALAPPDATA") if sys.platform == "win32" else None)
    try:
        folder = (Path(home) if home else Path.home() / ".cache") / "tetratrack" / name
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, RuntimeError):
        return None
    return folder if os.access(folder, os.W_OK) else None


def drop_unused(folder: Path, pattern: str) -> None:
    """Remove the files of a memory, named by a pattern, that no command has read for ``UNUSED_DAYS``; whoever reads one marks its time."""
    oldest = time.time() - UNUSED_DAYS * 86400
    for kept in folder.glob(pattern):
        with contextlib.suppress(OSError):
            if kept.stat().st_mtime < oldest:
                kept.unlink()
