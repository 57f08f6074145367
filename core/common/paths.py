"""Paths as other systems and libraries want them."""

from __future__ import annotations

import errno
import os
import unicodedata
from pathlib import PurePath

WINDOWS = os.name == "nt"
LONGEST_ON_WINDOWS = 259
"""Characters of a path that every program on Windows takes (MAX_PATH less the closing zero)."""
RESERVED = frozenset({"con", "prn", "aux", "nul", *(f"{device}{number}" for device in ("com", "lpt") for number in range(1, 10))})
"""Names that mean devices on Windows, whatever their ending."""


def sqlite_address(path: PurePath, way: str) -> str:
    r"""Absolute path as the address (URI) that SQLite opens, with how to open it, such as ``mode=ro``.

    A share (``\\server\folder``) has four slashes: SQLite takes what stands behind two for a machine, and refuses it. Source: SQLite,
    "Uniform Resource Identifiers", section 3.1.
    """
    address = path.as_uri()
    if not address.startswith("file:///"):
        address = address.replace("file://", "file:////", 1)
    return f"{address}?{way}"


def spelling(path: str | PurePath) -> str:
    """Absolute path by which two names of one file are the same on any system: Windows and macOS do not tell capitals apart, and macOS
    not whether an accent is part of its letter."""
    return unicodedata.normalize("NFC", os.path.normcase(os.path.abspath(path))).casefold()


def remedy_for(path: PurePath, error: Exception) -> str:
    """What a user can do where a file cannot be written."""
    if WINDOWS and len(os.path.abspath(path)) > LONGEST_ON_WINDOWS:
        return f"Choose a shorter path: Windows takes {LONGEST_ON_WINDOWS} characters."
    if WINDOWS and isinstance(error, PermissionError) and os.path.isfile(path):
        return "Close it in QGIS and other programs, or choose another name."
    if getattr(error, "errno", None) == errno.ENAMETOOLONG:
        size = len(os.fsencode(path.name))
        return f"Choose a shorter name: this one has {size} bytes, most disks take 255, some of them for a temporary name."
    return "Check the folder's permissions and free space."
