"""Vector files that the user names: only formats that hold their data themselves are opened.

GDAL reads descriptions too (VRT, WFS, catalogues) that make it ask the network or read other files, whatever their ending.
"""

from __future__ import annotations

from pathlib import Path

from ..common.errors import InputError
from ..common.sqlite_files import recover

_STARTS = (b"SQLite format 3\0", b"\x00\x00\x27\x0a", b"fgb\x03")
"""First bytes of GeoPackage, Shapefile and FlatGeobuf."""


def check_vector_file(path: Path) -> None:
    """Refuse a file that is no GeoPackage, GeoJSON, Shapefile or FlatGeobuf by its contents; what a killed writer left in a GeoPackage is
    recovered.

    Raises
    ------
    InputError
        It is another kind of file, or cannot be read.
    """
    try:
        with path.open("rb") as stream:
            start = stream.read(64)
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", source=path, remedy="Check the path and the permissions.") from error
    recover(path)
    if not start.startswith(_STARTS) and not start.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"{"):
        raise InputError(
            "is not a readable polygon layer", source=path, remedy="Save the stable areas as GeoPackage, GeoJSON, Shapefile or FlatGeobuf."
        )
