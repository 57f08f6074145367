"""LAS/LAZ/COPC reading: what is kept, that tiling does not matter, and that every damage ends in one sentence."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from las_files import ORIGIN, grid_points, write_copc, write_las
from tetratrack.core.common.errors import Cancelled, CrsError, InputError
from tetratrack.core.data import las_files
from tetratrack.core.data.las_files import checksum
from tetratrack.core.data.tiles import Window, inspect_tile, read_points

CRS = "EPSG:32650"


@pytest.fixture(params=["las", "laz"])
def tile(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    return write_las(tmp_path / f"tile.{request.param}", grid_points(), CRS)


def test_header(tile: Path) -> None:
    info = inspect_tile(tile, CRS)
    assert (info.points, info.version, info.point_format, info.copc, info.crs) == (400, "1.4", 6, False, CRS)
    assert info.compressed == (tile.suffix == ".laz")
    assert info.low == pytest.approx(grid_points().min(axis=0), abs=1e-3)
    assert info.density == pytest.approx(25, rel=0.05)
    assert info.note == ""


def test_points_come_reduced_and_complete(tile: Path) -> None:
    cloud = read_points([inspect_tile(tile, CRS)], CRS)
    expected = grid_points()
    expected = expected[np.lexsort(expected.T[::-1])]
    assert cloud.xyz.dtype == np.float64
    assert np.abs(cloud.xyz).max() < 100
    assert np.allclose(cloud.xyz + cloud.origin, expected, atol=0.0011)
    assert len(cloud.select(cloud.xyz[:, 0] < 1)) < len(cloud)


def test_noise_and_withheld_are_dropped(tmp_path: Path) -> None:
    kinds = np.tile([1, 7, 18, 2], 100).astype(np.uint8)
    hidden = np.arange(400) < 40
    path = write_las(tmp_path / "a.laz", grid_points(), CRS, classification=kinds, withheld=hidden)
    cloud = read_points([inspect_tile(path, CRS)], CRS)
    assert len(cloud) == int((np.isin(kinds, [1, 2]) & ~hidden).sum())


def test_result_does_not_depend_on_tiling_order_or_repetition(tmp_path: Path) -> None:
    points = grid_points(900)
    source = (np.arange(900) % 3).astype(np.uint16)
    time = np.arange(900.0)
    whole = write_las(tmp_path / "whole.laz", points, CRS, source=source, time=time)
    part = np.arange(900) % 4
    parts = [write_las(tmp_path / f"part{k}.laz", points[part == k], CRS, source=source[part == k], time=time[part == k]) for k in range(4)]
    window = Window(*(ORIGIN[:2] + 0.5), *(ORIGIN[:2] + 3))
    for chosen in (None, window):
        one = read_points([inspect_tile(whole, CRS)], CRS, window=chosen, origin=ORIGIN)
        many = read_points([inspect_tile(p, CRS) for p in [*reversed(parts), parts[0], whole]], CRS, window=chosen, origin=ORIGIN)
        for name in ("xyz", "source_id", "gps_time"):
            assert np.array_equal(getattr(one, name), getattr(many, name))
    assert window.contains(one.xyz + ORIGIN).all()


def test_copc_is_read_by_window(tmp_path: Path) -> None:
    path = write_copc(tmp_path / "a.copc.laz", grid_points())
    info = inspect_tile(path, CRS)
    assert info.copc
    assert len(read_points([info], CRS)) == 400
    window = Window(*(ORIGIN[:2] + 1), *(ORIGIN[:2] + 2))
    plain = inspect_tile(write_las(tmp_path / "b.laz", grid_points(), CRS), CRS)
    found, expected = (read_points([tile], CRS, window=window, origin=ORIGIN) for tile in (info, plain))
    assert 0 < len(found) < 100
    assert np.array_equal(found.xyz, expected.xyz)
    data = bytearray(path.read_bytes())
    data[375 + 54 + 40 : 375 + 54 + 48] = b"\xff" * 8
    path.write_bytes(data)
    with pytest.raises(InputError, match="copc"):
        read_points([info], CRS, window=window, origin=ORIGIN)


def test_chunks_bound_memory_and_can_be_cancelled(tile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(las_files, "CHUNK_POINTS", 37)
    assert len(read_points([inspect_tile(tile, CRS)], CRS)) == 400
    with pytest.raises(Cancelled):
        read_points([inspect_tile(tile, CRS)], CRS, is_cancelled=lambda: True)


def test_other_projected_crs_is_transformed_and_said_so(tmp_path: Path) -> None:
    from pyproj import Transformer

    there = np.column_stack(Transformer.from_crs(32650, 32651, always_xy=True).transform(*grid_points().T))
    path = write_las(tmp_path / "a.las", there, "EPSG:32651")
    info = inspect_tile(path, CRS)
    assert "a.las: transformed from EPSG:32651 to EPSG:32650, heights unchanged" in info.note
    cloud = read_points([info], CRS)
    found = cloud.xyz + cloud.origin
    expected = grid_points()
    assert np.allclose(found[np.lexsort(found.T)], expected[np.lexsort(expected.T)], atol=2e-3)


def test_compound_crs_counts_by_its_horizontal_part(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.las", grid_points(), "EPSG:32650+5773")
    assert inspect_tile(path, CRS).note == ""


@pytest.mark.parametrize(
    ("crs", "survey", "said"),
    [
        (None, CRS, "has no CRS"),
        ("EPSG:4326", CRS, "is geographic"),
        ("EPSG:2264", CRS, "US survey foot"),
        ("EPSG:32650+8228", CRS, "is in foot"),
        ("EPSG:32650", "LOCAL", "the survey's crs is LOCAL"),
        ("EPSG:5186+5193", "EPSG:5186+3855", "cannot be transformed exactly"),
    ],
)
def test_crs_that_cannot_be_used(tmp_path: Path, crs: str | None, survey: str, said: str) -> None:
    path = write_las(tmp_path / "a.las", grid_points(), crs)
    with pytest.raises(CrsError, match=said) as caught:
        inspect_tile(path, survey)
    assert "a.las" in str(caught.value)
    assert caught.value.remedy


def test_crs_that_contradicts_its_own_code(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.las", grid_points(), CRS)
    data = path.read_bytes()
    assert data.count(b'"central_meridian",117') == 1
    path.write_bytes(data.replace(b'"central_meridian",117', b'"central_meridian",107'))
    with pytest.raises(CrsError, match="declares EPSG:32650 with the parameters of another CRS"):
        inspect_tile(path, CRS)


def test_tiles_crs_helps_tiles_without_one(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.laz", grid_points(), None)
    info = inspect_tile(path, CRS, tiles_crs=CRS)
    assert len(read_points([info], CRS)) == 400
    assert inspect_tile(path, "LOCAL").crs == ""
    assert len(read_points([inspect_tile(path, "LOCAL")], "LOCAL")) == 400


def test_missing_empty_and_foreign_files(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        inspect_tile(tmp_path / "none.laz", CRS)
    with pytest.raises(InputError, match="there is no such file"):
        checksum(tmp_path / "none.laz")
    (tmp_path / "empty.laz").write_bytes(b"")
    with pytest.raises(InputError, match="is empty"):
        inspect_tile(tmp_path / "empty.laz", CRS)
    (tmp_path / "text.las").write_text("not a point cloud" * 100)
    with pytest.raises(InputError, match="is not a LAS or LAZ file"):
        inspect_tile(tmp_path / "text.las", CRS)


def test_a_tile_without_usable_points_is_no_error(tmp_path: Path) -> None:
    empty = inspect_tile(write_las(tmp_path / "none.las", np.empty((0, 3)), None), CRS)
    assert (empty.points, empty.used) == (0, 0)
    noise = inspect_tile(write_las(tmp_path / "noise.las", grid_points(), CRS, classification=np.full(400, 7, np.uint8)), CRS)
    assert (noise.points, noise.dropped, noise.used) == (400, 400, 0)
    assert len(read_points([empty, noise], CRS)) == 0


@pytest.mark.parametrize("share", [0.05, 0.3, 0.6, 0.9, 0.99])
def test_truncated_files(tile: Path, share: float) -> None:
    data = tile.read_bytes()
    tile.write_bytes(data[: int(share * len(data))])
    with pytest.raises(InputError, match=r"truncated|not a LAS|damaged") as caught:
        read_points([inspect_tile(tile, CRS)], CRS)
    assert tile.name in str(caught.value)


@pytest.mark.parametrize(
    ("offset", "value", "said"),
    [
        (25, struct.pack("<B", 9), "LAS 1.9"),
        (104, struct.pack("<B", 60), "point format 60"),
        (131, struct.pack("<d", 0.0), "impossible scale"),
        (131, struct.pack("<d", float("nan")), "impossible scale"),
        (155, struct.pack("<d", float("nan")), "impossible scale"),
        (100, struct.pack("<I", 2**31), "damaged or truncated header"),
        (105, struct.pack("<H", 3), "damaged or truncated header"),
        (247, struct.pack("<Q", 2**40), "truncated|damaged"),
        (179, struct.pack("<d", 500_001.0), "outside the extent"),
        (96, struct.pack("<I", 2**31 - 1), "truncated|damaged"),
    ],
)
def test_damaged_headers(tile: Path, offset: int, value: bytes, said: str) -> None:
    data = bytearray(tile.read_bytes())
    data[offset : offset + len(value)] = value
    tile.write_bytes(data)
    with pytest.raises(InputError, match=said):
        read_points([inspect_tile(tile, CRS)], CRS)


def test_damage_between_inspection_and_reading_is_found(tile: Path) -> None:
    info = inspect_tile(tile, CRS)
    tile.write_bytes(tile.read_bytes()[:300])
    with pytest.raises(InputError):
        read_points([info], CRS)


def test_windows() -> None:
    window = Window(0, 0, 10, 5)
    assert window.grown(1) == Window(-1, -1, 11, 6)
    assert window.contains(np.array([[0, 0], [10, 1], [9.99, 4.99], [1, 5]])).tolist() == [True, False, True, False]
    assert window.meets((-5, -5), (0, 0))
    assert not window.meets((10, 0), (12, 1))
