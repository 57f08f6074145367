"""Tiles as people give them: quoted lists, patterns, folders of scans, virtual point clouds."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from qgis.core import QgsProcessingContext, QgsProcessingException
from tetratrack.algorithms.support.inputs import tile_paths


def _names(value: object) -> list[str]:
    return [Path(path).name for path in tile_paths(value, QgsProcessingContext(), "Tiles")]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("tiles/a.laz", "tiles/b.LAZ", "tiles/mesh.ply", "scans/c.E57", "scans/notes.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(b"")
    features = [{"assets": {"data": {"href": "tiles/a.laz"}, "thin": {"href": "tiles/thin.copc.laz", "roles": ["overview"]}}}]
    (tmp_path / "all.VPC").write_text(json.dumps({"features": features}))
    return tmp_path


def test_tiles_as_people_give_them(folder: Path) -> None:
    assert _names(str(folder / "tiles")) == ["a.laz", "b.LAZ"]
    assert _names(str(folder / "scans")) == ["c.E57"]
    assert _names(str(folder / "tiles" / "*.laz")) == ["a.laz", "b.LAZ"]
    assert _names(f'"{folder / "tiles" / "a.laz"}" "{folder / "scans" / "c.E57"}"') == ["a.laz", "c.E57"]
    assert _names([str(folder / "all.VPC"), str(folder / "tiles" / "a.laz")]) == ["a.laz"]
    with pytest.raises(QgsProcessingException, match=r"gone\.laz"):
        _names(f'"{folder / "tiles" / "a.laz"}" "{folder / "gone.laz"}"')
