"""Epochs stated in a table of the plugin, as the file that carries them to the engine."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from ..common.errors import InputError
from ..common.input_files import content_of
from .new_survey import GivenEpoch


def read_given_epochs(path: Path) -> list[GivenEpoch]:
    """Epochs of a JSON list of objects with ``label``, ``time``, ``tiles`` and ``files``; label and time may be empty.

    Raises
    ------
    InputError
        The file is none of ours, or a time is none.
    """
    try:
        rows = json.loads(content_of(path).decode("utf-8"))
        return [_epoch(row, k + 1) for k, row in enumerate(rows)]
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"holds no epochs ({error})", source=path, remedy="Give the file that the plugin writes.") from error


def _epoch(row: dict[str, Any], number: int) -> GivenEpoch:
    tiles = tuple(Path(tile) for tile in row["tiles"])
    if not tiles:
        raise InputError("has no tiles", where=f"epoch in row {number}", remedy="Choose its LAS, LAZ, COPC, E57 or PLY files.")
    stated = str(row.get("time") or "")
    time = None
    if stated:
        found = datetime.fromisoformat(stated)
        time = found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)
    files = {str(role): Path(file) for role, file in row.get("files", {}).items() if file}
    return GivenEpoch(label=str(row.get("label") or "").strip(), time=time, tiles=tiles, files=files)
