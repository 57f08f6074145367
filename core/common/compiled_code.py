"""Where compiled loops are kept between runs: in a folder of the user's own, and thrown away where they are damaged.

What numba keeps is neither forced to the disk nor checked: after a power loss every later run would end, or run machine code with wrong
bytes. Here each file begins with a checksum, and one that does not fit counts as none. The files are pickles, so that whoever can
write them can run code as the user: folders that others may write to are not used.
"""

from __future__ import annotations

import hashlib
import logging
import os
import pickle  # nosec B403 - reads what this module wrote, in a folder of the user's own, with its checksum
import stat
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Any

from numba.core import caching, config
from numba.core.dispatcher import Dispatcher

# numba states no types
_FunctionCache: Any = caching.FunctionCache
_CacheFile: Any = caching.IndexDataCacheFile
_settings: Any = config
_Dispatcher: Any = Dispatcher
LOG = logging.getLogger("tetratrack")
_DIGEST = hashlib.sha256().digest_size


class CheckedFiles(_CacheFile):  # type: ignore[misc]
    """Index and data files of one function's compiled code, with checksums."""

    def _dump(self, obj: Any) -> bytes:
        data: bytes = super()._dump(obj)
        return hashlib.sha256(data).digest() + data

    def _load_index(self) -> Any:
        try:
            with open(self._index_path, "rb") as stream:
                version = pickle.load(stream)  # noqa: S301  # nosec B301 - see the module
                data = stream.read()
            if version != self._version:
                return {}
            stamp, overloads = pickle.loads(_checked(data))  # noqa: S301  # nosec B301 - see the module
        except Exception:
            # whatever a damaged pickle raises: compiled anew and written anew
            return {}
        return overloads if stamp == self._source_stamp else {}

    def _load_data(self, name: str) -> Any:
        with open(self._data_path(name), "rb") as stream:
            # numba takes an OSError for a file that is gone
            return pickle.loads(_checked(stream.read()))  # noqa: S301  # nosec B301 - see the module


class CheckedCache(_FunctionCache):  # type: ignore[misc]
    """Compiled code of one function; a cache that cannot be read or written never ends a run."""

    def __init__(self, function: Any) -> None:
        super().__init__(function)
        stamp = source_stamp(function)
        self._cache_file = CheckedFiles(cache_path=self._cache_path, filename_base=self._impl.filename_base, source_stamp=stamp)
        # what the administrator's runs compiled serves all users, who can only read it; who could write it could write the program
        beside = Path(function.__code__.co_filename).parent / "__pycache__"
        installed = str(beside) != str(self._cache_path) and beside.is_dir() and is_private(beside)
        self._installed = (
            CheckedFiles(cache_path=str(beside), filename_base=self._impl.filename_base, source_stamp=stamp) if installed else None
        )

    def _load_overload(self, sig: Any, target_context: Any) -> Any:
        """Code for a signature from the user's folder, else from beside the program; None where neither has it."""
        found = super()._load_overload(sig, target_context)
        if found is not None or self._installed is None:
            return found
        data = self._installed.load(self._index_key(sig, target_context.codegen()))
        return None if data is None else self._impl.rebuild(target_context, data)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Code for a signature; None where there is none that can be used."""
        try:
            return super().load_overload(sig, target_context)
        except Exception as error:
            LOG.warning("compiled code in %s cannot be used (%s): it is compiled again", self.cache_path, type(error).__name__)
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep code for a signature, if the disk takes it."""
        try:
            super().save_overload(sig, data)
        except OSError as error:
            LOG.warning("compiled code cannot be kept in %s (%s)", self.cache_path, error.strerror or error)


def _checked(data: bytes) -> bytes:
    if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
        raise OSError("damaged")
    return data[_DIGEST:]


def source_stamp(function: Any) -> str:
    """What the code compiled from a function depends on: its file, the files of compiled loops of other modules that it can call, and
    the numbers that it can name, which are compiled into it.

    numba looks at the function's own file alone, and would go on using a loop whose callees have changed.
    """
    files: set[str] = set()
    numbers: set[str] = set()
    waiting = [function]
    while waiting:
        current = waiting.pop()
        if current.__code__.co_filename in files:
            continue
        files.add(current.__code__.co_filename)
        names = current.__globals__.items()
        numbers |= {f"{name}={value!r}" for name, value in names if isinstance(value, int | float)}
        waiting += [value.py_func for _, value in names if isinstance(value, _Dispatcher)]
    contents = sorted(_digest_of(file) for file in files)
    return hashlib.sha256(repr((contents, sorted(numbers))).encode()).hexdigest()


@lru_cache
def _digest_of(file: str) -> str:
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


def keep_compiled(dispatcher: Any) -> Any:
    """Give a compiled function its cache, where a folder for it is found."""
    if not isinstance(dispatcher, _Dispatcher):
        # NUMBA_DISABLE_JIT leaves it as Python
        return dispatcher
    try:
        dispatcher._cache = CheckedCache(dispatcher.py_func)
    except RuntimeError:
        # neither the program's folder nor the user's can be written
        LOG.debug("no folder for compiled code")
    return dispatcher


def choose_folder() -> None:
    """Settle once, before any loop is made, where compiled code is kept: where numba would, if that is nobody else's; otherwise in a
    folder of the user's own among the temporary files. Worker processes take over what is found."""
    chosen = _settings.CACHE_DIR
    if chosen and not is_private(Path(chosen)):
        chosen = _own_folder(Path(chosen))
    elif not chosen and _numba_finds_none():
        chosen = _own_folder(Path(tempfile.gettempdir()))
        if chosen:
            LOG.warning("compiled code is kept in %s: neither the program's folder nor the user's can be written", chosen)
    else:
        return
    _settings.CACHE_DIR = chosen
    if chosen:
        os.environ["NUMBA_CACHE_DIR"] = chosen


def is_private(folder: Path) -> bool:
    """Whether only this user, or the system's administrator, can put files into a folder; one that is not there yet will be made so."""
    if os.name != "posix" or not folder.exists():
        return True
    status = folder.stat()
    return status.st_uid in (0, os.geteuid()) and not status.st_mode & stat.S_IWOTH


def _own_folder(place: Path) -> str:
    """A folder in ``place`` that only this user can read and write; empty where somebody else has taken its name."""
    user = os.geteuid() if os.name == "posix" else "user"
    folder = place / f"tetratrack-compiled-{user}"
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
    except OSError:
        return ""
    mine = os.name != "posix" or (status.st_uid == os.geteuid() and not status.st_mode & 0o077)
    return str(folder) if stat.S_ISDIR(status.st_mode) and mine else ""


def _numba_finds_none() -> bool:
    try:
        _FunctionCache(_numba_finds_none)
    except RuntimeError:
        return True
    return False
