"""Arrays in files that appear whole or not at all: what jobs leave to each other and to a later run."""

from __future__ import annotations

import io
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.atomic_files import replace_durably, temporary_beside
from ..common.errors import InputError, OutputError

Arrays = Mapping[str, NDArray[Any]]


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
        # opened here: numpy forgets to close a file in which it finds no archive
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            return {name: archive[name] for name in archive.files if name not in without}
    except Exception:
        # a damaged archive raises whatever its bytes lead to (BadZipFile, NotImplementedError, RuntimeError, TokenError, MemoryError ...)
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
