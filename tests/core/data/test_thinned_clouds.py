"""Tiles denser than is of use are read as means; others as they are."""

from __future__ import annotations

from dataclasses import replace

import laspy
import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.data import thinned_clouds
from tetratrack.core.data.thinned_clouds import LARGE, Thinning, is_large, patch_radius
from tetratrack.core.data.tiles import Window, inspect_tile, read_points, used_points

HEIGHT = 2.5
ORIGIN = np.array([500_000.0, 3_500_000.0, 10.0])


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    """A cache of the test's own."""
    from tetratrack.core.common.user_cache import cache_folder
    from tetratrack.core.data import scan_cache

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    for kept in (cache_folder, scan_cache.scans_folder, thinned_clouds.means_in):
        kept.cache_clear()
    yield
    for kept in (cache_folder, scan_cache.scans_folder, thinned_clouds.means_in):
        kept.cache_clear()


def wavy(count, seed=0, size=4.0):
    """Points with 3 mm of noise on a wavy floor."""
    rng = np.random.default_rng(seed)
    xy = rng.uniform(0, size, (count, 2))
    return ORIGIN + np.column_stack([xy, 0.2 * np.sin(xy[:, 0])]) + rng.normal(0, 0.003, (count, 3))


def write(path, xyz, crs_offset=ORIGIN):
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 0.001), crs_offset
    las = laspy.LasData(header)
    las.x, las.y, las.z = xyz.T
    las.point_source_id = np.full(len(xyz), 7, dtype=np.uint16)
    las.gps_time = np.arange(len(xyz), dtype=np.float64)
    las.write(str(path))
    return path


def looked(path, **options):
    return inspect_tile(path, "LOCAL", patch=patch_radius(HEIGHT), **options)


def test_a_dense_tile_is_read_as_means(tmp_path):
    """Fewer points, of the same surface, with their source and earliest time; windows and single tiles as with any tile."""
    xyz = wavy(600_000)
    tile = looked(write(tmp_path / "dense.laz", xyz))
    cloud = read_points([tile], "LOCAL")
    assert tile.thinned
    assert tile.used == 600_000
    assert len(cloud) == tile.means == tile.held < 60_000
    assert cloud.spread is not None
    assert set(cloud.source_id.tolist()) == {7}
    assert cloud.gps_time.min() == 0.0
    heights = cloud.xyz[:, 2] + cloud.origin[2] - ORIGIN[2] - 0.2 * np.sin(cloud.xyz[:, 0] + cloud.origin[0] - ORIGIN[0])
    assert np.median(np.abs(heights)) < 0.0012
    part = read_points([tile], "LOCAL", window=Window(500_001.0, 3_500_001.0, 500_002.0, 3_500_003.0))
    assert 0 < len(part) < len(cloud) / 4
    assert np.vstack(list(used_points(tile, "LOCAL"))).shape == (tile.means, 3)


def test_a_tile_of_usual_density_stays_as_it_is(tmp_path):
    """Bit by bit, and no spread is known."""
    path = write(tmp_path / "usual.laz", wavy(60_000))
    tile, plain = looked(path), inspect_tile(path, "LOCAL")
    assert not tile.thinned
    one, other = read_points([tile], "LOCAL"), read_points([plain], "LOCAL")
    assert np.array_equal(one.xyz, other.xyz)
    assert one.spread is None


def test_dense_and_usual_tiles_go_together(tmp_path):
    """Points as they are have no spread."""
    dense = looked(write(tmp_path / "dense.laz", wavy(600_000)))
    usual = looked(write(tmp_path / "usual.laz", wavy(20_000, seed=1) + np.array([5.0, 0.0, 0.0])))
    cloud = read_points([dense, usual], "LOCAL")
    assert len(cloud) == dense.means + 20_000
    east = cloud.xyz[:, 0] + cloud.origin[0] > ORIGIN[0] + 4.5
    assert not cloud.spread[east].any()
    assert np.median(cloud.spread[~east]) > 0


def test_means_are_formed_again_where_they_are_gone(tmp_path):
    """On another machine, or after the cache was emptied, the result is the same."""
    tile = looked(write(tmp_path / "dense.laz", wavy(600_000)))
    before = read_points([tile], "LOCAL")
    for copy in (tmp_path / "cache" / "tetratrack" / "thinned").iterdir():
        copy.unlink()
    thinned_clouds.means_in.cache_clear()
    after = read_points([tile], "LOCAL")
    assert np.array_equal(before.xyz, after.xyz)
    with pytest.raises(InputError, match="not as it was"):
        read_points([replace(tile, means=tile.means + 1, thinned="gone")], "LOCAL")


def test_a_damaged_copy_counts_as_none(tmp_path):
    """It is made again by the next look."""
    path = write(tmp_path / "dense.laz", wavy(600_000))
    tile = looked(path)
    for copy in (tmp_path / "cache" / "tetratrack" / "thinned").iterdir():
        copy.write_bytes(copy.read_bytes()[:1000])
    thinned_clouds.means_in.cache_clear()
    assert looked(path) == tile
    assert thinned_clouds.load(tile.thinned) is not None


def test_stray_points_are_left_out_of_means_too(tmp_path):
    """A trimmed tile gives the means within its extent only."""
    tile = looked(write(tmp_path / "dense.laz", wavy(600_000)))
    trimmed = replace(tile, strays=1, high=(tile.low[0] + 1.0, *tile.high[1:]))
    cloud = read_points([trimmed], "LOCAL")
    assert 0 < len(cloud) < tile.means / 3


def test_patches_grow_with_the_noise():
    """So that noise does not decide to which patch a point goes."""
    for noise, wide in ((0.002, False), (0.009, True)):
        xyz = wavy(400_000) + np.random.default_rng(3).normal(0, noise, (400_000, 3))
        thinning = Thinning(patch_radius(HEIGHT), len(xyz))
        thinning.add(xyz, np.zeros(len(xyz), dtype=np.uint16), np.zeros(len(xyz)))
        assert (thinning.radius > 1.2 * patch_radius(HEIGHT)) == wide


def test_large_clouds_are_told_by_their_headers(tmp_path):
    """All tiles together; what is no tile counts nothing."""
    path = write(tmp_path / "one.laz", wavy(LARGE // 10))
    (tmp_path / "no.laz").write_bytes(b"nothing")
    assert not is_large([path] * 9)
    assert is_large([path, tmp_path / "no.laz", tmp_path / "missing.laz", *[path] * 9])
