"""E57 and PLY: the same points as from LAS, and one sentence for what cannot be read."""

from __future__ import annotations

import errno
from datetime import date
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import open3d
import pytest
from las_files import ORIGIN, grid_points, write_las
from scipy.spatial import cKDTree
from tetratrack.core.common import user_cache
from tetratrack.core.common.errors import InputError, OutputError
from tetratrack.core.data import other_clouds
from tetratrack.core.data.las_copies import Dimension, write_with_dimension
from tetratrack.core.data.las_files import read_header
from tetratrack.core.data.tile_dates import tile_dates
from tetratrack.core.data.tiles import inspect_tile, read_points


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    user_cache.cache_folder.cache_clear()


def write_ply(path: Path, points: np.ndarray, kind: type = np.float64) -> Path:
    cloud = open3d.t.geometry.PointCloud(open3d.core.Tensor(points.astype(kind)))
    assert open3d.t.io.write_point_cloud(path, cloud)
    return path


def write_e57(path: Path, scans: list[np.ndarray], wkt: str = "", **stated: object) -> Path:
    """Scans with poses: turned by a quarter about the vertical, and moved to their place."""
    pye57 = pytest.importorskip("pye57")
    lib = pye57.libe57

    class File(pye57.E57):
        def write_default_header(self) -> None:
            image = self.image_file
            image.extensionsAdd("", lib.E57_V1_0_URI)
            for name, text in (("formatName", "ASTM E57 3D Imaging Data File"), ("guid", "{1}"), ("coordinateMetadata", wkt)):
                self.root.set(name, lib.StringNode(image, text))
            for name, number in (("versionMajor", lib.E57_FORMAT_MAJOR), ("versionMinor", lib.E57_FORMAT_MINOR)):
                self.root.set(name, lib.IntegerNode(image, number))
            self.root.set("data3D", lib.VectorNode(image, True))

    half = np.sqrt(0.5)
    file = File(str(path), mode="w")
    for points in scans:
        local = points - ORIGIN
        turned = np.column_stack([local[:, 1], -local[:, 0], local[:, 2]])
        data = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), turned.T, strict=True))
        header = SimpleNamespace(**dict.fromkeys([f"{axis}{end}" for axis in "xyz" for end in ("Minimum", "Maximum")], 0.0), **stated)
        file.write_scan_raw(data, rotation=np.array([half, 0, 0, half]), translation=ORIGIN, scan_header=header)
    file.close()
    return path


def _read(path: Path, **given: str) -> np.ndarray:
    tile = inspect_tile(path, "EPSG:32650", **given)
    cloud = read_points([tile], "EPSG:32650")
    return np.asarray(cloud.xyz + cloud.origin)


def _same(points: np.ndarray, wanted: np.ndarray) -> bool:
    """Whether two clouds have the same points, in any order, to two steps of the copies' coordinates."""
    return len(points) == len(wanted) and bool(
        (cKDTree(points).query(wanted)[0] < 2e-4).all() and (cKDTree(wanted).query(points)[0] < 2e-4).all()
    )


@pytest.mark.parametrize("ending", [".ply", ".PLY", ".e57", ".E57"])
def test_points_are_those_of_the_las_file(tmp_path: Path, ending: str) -> None:
    points = grid_points()
    path = tmp_path / f"scan{ending}"
    write = write_ply if ending.lower() == ".ply" else lambda path, points: write_e57(path, [points[:250], points[250:]])
    write(path, points)
    wanted = _read(write_las(tmp_path / "scan.las", points))
    for _ in range(2):
        assert _same(_read(path, undeclared_crs="EPSG:32650"), wanted)
    assert [kept.suffix for kept in (tmp_path / "cache" / "tetratrack" / "clouds").iterdir()] == [".laz"]


def test_a_crs_is_asked_for(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"undeclared_crs|tiles_crs"):
        inspect_tile(write_ply(tmp_path / "scan.ply", grid_points()), "EPSG:32650")


def test_what_an_e57_states_of_itself(tmp_path: Path) -> None:
    from pyproj import CRS

    path = write_e57(tmp_path / "scan.e57", [grid_points()[:200], grid_points()[200:]], CRS.from_epsg(32650).to_wkt("WKT1_GDAL"))
    tile = inspect_tile(path, None)
    assert (tile.crs, tile.points, tile.has_time) == ("EPSG:32650", 400, False)
    cloud = read_points([tile], "EPSG:32650")
    assert sorted(set(cloud.source_id.tolist())) == [1, 2]
    assert tile_dates(path).measured is None


def test_the_day_of_an_e57(tmp_path: Path) -> None:
    seconds = (date(2024, 4, 9) - date(1980, 1, 6)).days * 86400.0 + 3600
    path = write_e57(tmp_path / "scan.e57", [grid_points()], acquisitionStart_dateTimeValue=seconds)
    assert tile_dates(path).made == date(2024, 4, 9)


def test_scans_in_ranges_and_angles(tmp_path: Path) -> None:
    pye57 = pytest.importorskip("pye57")
    lib = pye57.libe57
    points = grid_points() - ORIGIN + 5
    distance = np.linalg.norm(points, axis=1)
    polar = {
        "sphericalRange": distance,
        "sphericalAzimuth": np.arctan2(points[:, 1], points[:, 0]),
        "sphericalElevation": np.arcsin(points[:, 2] / distance),
    }
    path = tmp_path / "scan.e57"
    file = pye57.E57(str(path), mode="w")
    image = file.image_file
    scan, prototype = lib.StructureNode(image), lib.StructureNode(image)
    scan.set("guid", lib.StringNode(image, "{1}"))
    for name in polar:
        prototype.set(name, lib.FloatNode(image, 0.0, lib.E57_DOUBLE, -1e4, 1e4))
    stored = lib.CompressedVectorNode(image, prototype, lib.VectorNode(image, True))
    scan.set("points", stored)
    file.data3d.append(scan)
    arrays, buffers = file.make_buffers(list(polar), len(points))
    for name, values in polar.items():
        arrays[name][:] = values
    writer = stored.writer(buffers)
    writer.write(len(points))
    writer.close()
    file.close()
    cloud = read_points([inspect_tile(path, None)], "LOCAL")
    assert _same(cloud.xyz + cloud.origin, points)


def test_points_of_invalid_beams_are_left_out(tmp_path: Path) -> None:
    pye57 = pytest.importorskip("pye57")
    path = tmp_path / "scan.e57"
    local = grid_points() - ORIGIN
    state = np.zeros(len(local), dtype=np.int8)
    state[:30] = 2
    file = pye57.E57(str(path), mode="w")
    columns = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), local.T, strict=True))
    file.write_scan_raw({**columns, "cartesianInvalidState": state})
    file.close()
    assert read_header(path).count == len(local) - 30


def test_a_full_disk_is_that_of_the_copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(other_clouds, "_write", full)
    with pytest.raises(OutputError, match="No space left") as refused:
        read_header(write_ply(tmp_path / "scan.ply", grid_points()))
    assert "clouds" in str(refused.value.source)
    assert list((tmp_path / "cache" / "tetratrack" / "clouds").iterdir()) == []


def test_labels_go_into_a_copy_as_laz(tmp_path: Path) -> None:
    source = write_ply(tmp_path / "scan.ply", grid_points())
    target = tmp_path / "labelled.laz"
    found = write_with_dimension(source, target, Dimension("unit_id", "number of the unit"), lambda xyz, *_: np.arange(len(xyz)))
    assert found == 399
    assert _same(_read(target, undeclared_crs="EPSG:32650"), grid_points())


@pytest.mark.parametrize("ending", [".ply", ".e57"])
@pytest.mark.parametrize(
    "content", [b"", b"hello", b"ply\nformat binary_little_endian 1.0\n", b"ply\nformat binary_little_endian 1.0\ncomment"]
)
def test_what_is_no_cloud(tmp_path: Path, ending: str, content: bytes) -> None:
    if ending == ".e57":
        pytest.importorskip("pye57")
    path = tmp_path / f"scan{ending}"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"is empty|cannot be read as") as refused:
        read_header(path)
    assert refused.value.source == path
    assert "LAZ" in refused.value.remedy or "Export" in refused.value.remedy
    assert path.read_bytes() == content


@pytest.mark.parametrize("ending", [".ply", ".e57"])
def test_a_file_that_ends_early(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"scan{ending}"
    write_ply(path, grid_points()) if ending == ".ply" else write_e57(path, [grid_points()])
    whole = path.read_bytes()
    path.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InputError, match="cannot be read as"):
        read_header(path)
    assert path.stat().st_size == len(whole) // 2
    assert list((tmp_path / "cache" / "tetratrack" / "clouds").iterdir()) == []


def test_single_precision_far_from_the_origin_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"single precision, which stand 0\.25 m apart"):
        read_header(write_ply(tmp_path / "scan.ply", grid_points(), np.float32))
    near = read_header(write_ply(tmp_path / "near.ply", grid_points() - ORIGIN, np.float32))
    assert near.count == 400


def test_a_reader_that_is_missing_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "scan.e57").write_bytes(b"ASTM-E57")
    monkeypatch.setitem(__import__("sys").modules, "pye57", None)
    with pytest.raises(InputError, match="pye57 is not installed") as refused:
        read_header(tmp_path / "scan.e57")
    assert "tetratrack[e57]" in refused.value.remedy
