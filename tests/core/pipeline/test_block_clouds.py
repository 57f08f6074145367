"""Points that blocks leave to later jobs are those that stand in the tiles."""

from __future__ import annotations

import math
import threading
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from tetratrack.core.data.tiles import Window, inspect_tile, read_points
from tetratrack.core.data.window_around import WindowAround
from tetratrack.core.pipeline import block_clouds
from tetratrack.core.pipeline.block_clouds import LEAST_FREE, MOST_KEPT, NOT_KEPT, BlockClouds
from tetratrack.core.pipeline.blocks import Block, plan_blocks

TILES = sorted((Path(__file__).resolve().parents[2] / "data" / "tiny" / "tiles" / "2024-04-09").glob("*.laz"))
CRS = "EPSG:32650"
ORIGIN = np.array([612_400.25, 3_456_700.5, 3.0])


@pytest.fixture
def block() -> Block:
    return plan_blocks("a/b: c", [inspect_tile(path, CRS) for path in TILES], 2.0)[0]


def _windows(block: Block) -> dict[str, Window]:
    cloud = read_points(block.tiles, CRS)
    places = cloud.xyz[:: len(cloud) // 4] + cloud.origin
    low, high = places.min(axis=0), places.max(axis=0)
    middle = 0.5 * (low + high)
    return {
        "all": Window(-math.inf, -math.inf, math.inf, math.inf),
        "part": Window(float(low[0]), float(low[1]), float(middle[0]), float(middle[1])),
        "around": WindowAround.of(block.core, places, 0.3),
    }


@pytest.mark.parametrize("name", ["all", "part", "around"])
def test_kept_points_are_those_of_the_tiles(tmp_path: Path, block: Block, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    window, grown = _windows(block)[name], block.core.grown(5.0)
    wanted = read_points(block.tiles, CRS, window=window, origin=ORIGIN)
    clouds = BlockClouds(tmp_path)
    clouds.keep(block, grown, read_points(block.tiles, CRS, window=grown))
    monkeypatch.setattr(block_clouds, "read_points", None)
    xyz, sources = clouds.points(block, CRS, window, ORIGIN)
    assert len(xyz) > 20
    np.testing.assert_allclose(xyz, wanted.xyz, rtol=0, atol=1e-12)
    assert np.array_equal(sources, wanted.source_id)


@pytest.mark.parametrize("trouble", ["no folder", "nothing kept", "damaged", "cut", "too narrow", "not written", "full disk"])
def test_tiles_are_read_where_points_are_not_kept(tmp_path: Path, block: Block, trouble: str, monkeypatch: pytest.MonkeyPatch) -> None:
    window = _windows(block)["all"]
    wanted = read_points(block.tiles, CRS, window=window, origin=ORIGIN)
    clouds = NOT_KEPT if trouble == "no folder" else BlockClouds(tmp_path / "gone" if trouble == "not written" else tmp_path)
    if trouble == "full disk":
        monkeypatch.setattr("shutil.disk_usage", lambda folder: SimpleNamespace(free=LEAST_FREE + 100))
    if trouble != "nothing kept":
        narrow = _windows(block)["part"] if trouble == "too narrow" else block.core.grown(5.0)
        clouds.keep(block, narrow, read_points(block.tiles, CRS, window=narrow))
    kept = list(tmp_path.iterdir())
    assert len(kept) == (trouble in ("damaged", "cut", "too narrow"))
    if trouble == "damaged":
        kept[0].write_bytes(kept[0].read_bytes()[:-100])
    if trouble == "cut":
        with kept[0].open("r+b") as stream:
            np.load(stream)
            np.load(stream)
            stream.truncate()
    xyz, sources = clouds.points(block, CRS, window, ORIGIN)
    np.testing.assert_allclose(xyz, wanted.xyz, rtol=0, atol=1e-12)
    assert np.array_equal(sources, wanted.source_id)


def test_a_whole_epoch_is_awaited_from_who_reads_it(tmp_path: Path, block: Block) -> None:
    clouds, whole = BlockClouds(tmp_path), read_points(block.tiles, CRS)
    grown = block.core.grown(5.0)
    cloud = read_points(block.tiles, CRS, window=grown)
    reader = threading.Timer(0.3, clouds.keep, (block, grown, cloud))
    reader.start()
    points = clouds.awaited([block], 60.0)
    reader.join()
    assert points is not None
    assert np.array_equal(points - whole.origin, whole.xyz)


@pytest.mark.parametrize("trouble", ["nobody reads it", "two blocks", "not kept", "thinned", "cancelled"])
def test_an_epoch_that_nobody_keeps_is_not_awaited_for_long(
    tmp_path: Path, block: Block, trouble: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    clouds = NOT_KEPT if trouble == "not kept" else BlockClouds(tmp_path)
    tiles = tuple(replace(tile, thinned="means") for tile in block.tiles) if trouble == "thinned" else block.tiles
    blocks = [replace(block, tiles=tiles)] * (2 if trouble == "two blocks" else 1)
    if trouble != "nobody reads it":
        monkeypatch.setattr("time.sleep", lambda _: pytest.fail("waits"))
    assert clouds.awaited(blocks, 0.1 if trouble == "nobody reads it" else math.inf, lambda: trouble == "cancelled") is None


def test_points_of_large_surveys_are_not_awaited_either(tmp_path: Path) -> None:
    clouds = BlockClouds(tmp_path)
    assert clouds.of_so_many(MOST_KEPT) is clouds
    assert clouds.of_so_many(MOST_KEPT + 1) is NOT_KEPT
