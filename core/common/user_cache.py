"""Folders beside other caches of the user: what can be made again, kept so that the next command need not."""

from __future__ import annotations

import os
import sys
from functools import cache
from pathlib import Path


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
