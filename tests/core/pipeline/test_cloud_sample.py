"""A large cloud is known by places spread over it: no more points than memory is meant to hold, whole where they are, however it is cut."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tetratrack.core.data.tiles import TileInfo, inspect_tile, read_points, used_points
from tetratrack.core.pipeline import cloud_sample
from tetratrack.core.pipeline.cloud_sample import PLACES, sample_points

TILES = sorted((Path(__file__).resolve().parents[2] / "data" / "tiny" / "tiles" / "2024-04-09").glob("*.laz"))
CRS = "EPSG:32650"
HEIGHT = 0.15


def test_a_small_cloud_is_read_whole() -> None:
    tiles = [inspect_tile(path, CRS) for path in TILES]
    points, origin = sample_points(tiles, CRS)
    whole = read_points(tiles, CRS)
    assert np.array_equal(points, whole.xyz)
    assert np.array_equal(origin, whole.origin)
    # who has read it already is asked first
    given, same = sample_points(tiles, CRS, whole=lambda: whole.xyz + whole.origin)
    np.testing.assert_allclose(given, points, rtol=0, atol=1e-9)
    assert np.array_equal(same, origin)


def test_a_large_cloud_is_read_at_places_of_every_part(monkeypatch: pytest.MonkeyPatch) -> None:
    tiles = [inspect_tile(path, CRS) for path in TILES]
    whole = read_points(tiles, CRS)
    monkeypatch.setattr(cloud_sample, "MOST_POINTS", len(whole) // 2)
    points, origin = sample_points(tiles, CRS, HEIGHT)
    assert len(points) < 0.5 * len(whole)
    # they are points of the cloud, each once, and of a place all of them
    every = {tuple(p) for p in np.round(whole.xyz + whole.origin, 4)}
    taken = np.round(points + origin, 4)
    assert {tuple(p) for p in taken} <= every
    assert len(np.unique(taken, axis=0)) == len(taken)
    axis = int(np.argmax(np.ptp(whole.xyz[:, :2], axis=0)))
    along = whole.xyz[:, axis] + whole.origin[axis]
    parts = np.floor((taken[:, axis] - along.min()) / np.ptp(along) * PLACES)
    assert set(range(PLACES)) <= set(parts.astype(int))
    place = taken[parts == 0]
    low, high = place[:, :2].min(axis=0), place[:, :2].max(axis=0)
    absolute = whole.xyz[:, :2] + whole.origin[:2]
    middle = ((absolute >= low + 0.1) & (absolute <= high - 0.1) & (along[:, None] - along.min() < np.ptp(along) / PLACES)).all(axis=1)
    assert 0 < middle.sum() <= len(place)


def test_denser_places_are_narrower_and_at_most_so_many_points(monkeypatch: pytest.MonkeyPatch) -> None:
    tiles = [inspect_tile(path, CRS) for path in TILES]
    monkeypatch.setattr(cloud_sample, "MOST_POINTS", 10_000)
    wide, _ = sample_points(tiles, CRS, HEIGHT)
    monkeypatch.setattr(cloud_sample, "MOST_OF_PLACES", len(wide) // 3)
    narrow, _ = sample_points(tiles, CRS, HEIGHT)
    assert len(narrow) < 0.6 * len(wide)


def test_tiles_are_read_once_where_they_can_be_held(monkeypatch: pytest.MonkeyPatch) -> None:
    tiles = [inspect_tile(path, CRS) for path in TILES]
    monkeypatch.setattr(cloud_sample, "MOST_POINTS", 10_000)
    read: list[Path] = []

    def counted(tile: TileInfo, *arguments: Any) -> Iterator[np.ndarray]:
        read.append(tile.path)
        return used_points(tile, *arguments)

    monkeypatch.setattr(cloud_sample, "used_points", counted)
    held, _ = sample_points(tiles, CRS, HEIGHT)
    assert sorted(read) == sorted(tile.path for tile in tiles)
    monkeypatch.setattr(cloud_sample, "MOST_HELD", 0)
    again, _ = sample_points(tiles, CRS, HEIGHT)
    assert np.array_equal(held, again)
    assert len(read) > 2 * len(tiles)
