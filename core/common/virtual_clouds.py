"""Virtual point clouds (.vpc) as QGIS and PDAL write them: a STAC collection in one JSON file, whose assets are the tiles."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlparse

from .errors import InputError
from .input_files import content_of

ENDING = ".vpc"


def expanded(paths: Iterable[Path]) -> list[Path]:
    """Files, with the tiles of virtual point clouds in the place of these; each once.

    Raises
    ------
    InputError
        A virtual point cloud is damaged, or a tile of it is not there.
    """
    out: dict[Path, None] = {}
    for path in paths:
        out |= dict.fromkeys(tiles_of(path) if path.suffix.lower() == ENDING else [path])
    return list(out)


def tiles_of(path: Path) -> list[Path]:
    """Tiles of a virtual point cloud; its overviews are thinned copies of them and left out.

    Raises
    ------
    InputError
        It is damaged, names no tile, or one that is not there.
    """
    try:
        features = json.loads(content_of(path).decode("utf-8-sig"))["features"]
        links = [asset["href"] for feature in features for asset in feature["assets"].values() if not _overview(asset)]
        tiles = [_located(path, str(link)) for link in links]
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError(
            "is not a virtual point cloud", source=path, remedy="Build it again (QGIS: Build virtual point cloud), or give its tiles."
        ) from error
    if not tiles:
        raise InputError("is a virtual point cloud without tiles", source=path, remedy="Build it again, or give its tiles.")
    return tiles


def _overview(asset: dict[str, Any]) -> bool:
    return "overview" in (asset.get("roles") or ())


def _located(path: Path, link: str) -> Path:
    """The tile that a link names, relative to the virtual point cloud."""
    address = urlparse(link)
    if address.scheme in ("http", "https", "s3"):
        raise InputError(f"has its tile {link} on a server", source=path, remedy="Download the tiles, and build it from the copies.")
    named = unquote(address.path) if address.scheme == "file" else link
    tile = (path.parent / named.replace("\\", "/")).absolute()
    if not tile.is_file():
        raise InputError(
            f"names the tile {link}, which is not there", source=path, remedy="Keep it beside its tiles, or build it again where they are."
        )
    return tile
