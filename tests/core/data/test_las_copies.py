"""A copied tile holds everything of the original, byte by byte, and one dimension more."""

from __future__ import annotations

import struct
from pathlib import Path

import laspy
import numpy as np
import pytest
from las_files import grid_points, write_copc, write_las
from laspy.vlrs.vlr import VLR
from pyproj import CRS
from tetratrack.core.common.errors import InputError
from tetratrack.core.data.las_copies import Dimension, write_with_dimension
from tetratrack.core.data.las_files import read_header
from tetratrack.core.data.tiles import inspect_tile

UNIT = Dimension("unit_id", "number of the tetrapod")
OWN_FIELDS = (slice(96, 105), slice(105, 107), slice(227, 235), slice(235, 247))
"""Bytes of the header that may differ: where points begin, records, format and length of points, where extended records begin."""


def numbers(xyz: np.ndarray, *_records: object) -> np.ndarray:
    """A number by place."""
    return np.floor(10 * (xyz[:, 0] % 10)).astype(np.uint32)


def with_evlrs(path: Path, records: list[tuple[str, int, bytes]]) -> Path:
    """Append extended records."""
    data = bytearray(path.read_bytes())
    start = len(data)
    for user, number, content in records:
        data += struct.pack("<H16sHQ32s", 0, user.encode(), number, len(content), b"of the test") + content
    struct.pack_into("<QI", data, 235, start, len(records))
    path.write_bytes(data)
    return path


def rich_tile(path: Path, point_format: int = 6) -> Path:
    """A tile with scaled extra bytes, foreign records, and all fields of the header filled."""
    points = grid_points(3000)
    header = laspy.LasHeader(version="1.4", point_format=point_format)
    header.scales, header.offsets = np.array([0.001, 0.002, 0.0005]), np.floor(points.min(axis=0)) + 0.25
    header.system_identifier, header.generating_software, header.file_source_id = "SCANNER 7", "FIELD 1.2", 77
    header.global_encoding.wkt = True
    header.vlrs.append(VLR("harbour", 4711, "of the site", b"\x01\x02 anything \x00\xff"))
    header.vlrs.append(VLR("LASF_Spec", 3, "about", b"text area\0"))
    header.add_extra_dims(
        [
            laspy.ExtraBytesParams("Reflectance", "int16", "dB", offsets=np.array([5.0]), scales=np.array([0.01])),
            laspy.ExtraBytesParams("Deviation", "uint16"),
            laspy.ExtraBytesParams("Normal", "3f4", "unit vector"),
        ]
    )
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    rng = np.random.default_rng(5)
    las.Reflectance = rng.uniform(-20, 20, 3000)
    las.Deviation = rng.integers(0, 900, 3000)
    las.Normal = rng.normal(size=(3000, 3))
    las.intensity = rng.integers(0, 60000, 3000)
    las.gps_time = np.arange(3000.0)
    las.return_number[:] = 1
    las.number_of_returns[:] = 1
    las.write(str(path))
    return path


def assert_copied(before: Path, after: Path) -> None:
    """Everything but the new dimension is the same."""
    heads = [bytearray(path.read_bytes()[:375]) for path in (before, after)]
    for head in heads:
        for field in OWN_FIELDS:
            head[field] = bytes(field.stop - field.start)
    assert heads[0] == heads[1]
    old, new = read_header(before), read_header(after)
    kinds, others = (
        [(r.user_id, r.record_id, r.extended) for r in header.records if r.user_id not in ("laszip encoded", "copc")]
        for header in (old, new)
    )
    extra = ("LASF_Spec", 4, False)
    assert [kind for kind in others if kind != extra] == [kind for kind in kinds if kind != extra]
    for user, number, _ in kinds:
        content = new.content(user, number)
        assert content is not None
        if (user, number) == ("LASF_Spec", 4):
            assert content[:-192] == old.content(user, number)
        else:
            assert content == old.content(user, number)
    one, other = laspy.read(before), laspy.read(after)
    assert list(other.point_format.dimension_names) == [*one.point_format.dimension_names, "unit_id"]
    for name in one.point_format.dimension_names:
        np.testing.assert_array_equal(np.asarray(one[name]), np.asarray(other[name]), err_msg=name)
    np.testing.assert_array_equal(np.asarray(other["unit_id"]), numbers(one.xyz))


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("point_format", [1, 6, 8])
def test_everything_is_kept(tmp_path: Path, ending: str, point_format: int) -> None:
    source = rich_tile(tmp_path / f"a.{ending}", point_format)
    wkt = CRS.from_epsg(32650).to_wkt("WKT1_GDAL").encode() + b"\0"
    with_evlrs(source, [("LASF_Projection", 2112, wkt), ("harbour", 9, bytes(range(256)) * 300)])
    target = tmp_path / "labelled.laz"
    assert write_with_dimension(source, target, UNIT, numbers) > 2000
    assert_copied(source, target)
    assert inspect_tile(target, "EPSG:32650").crs == "EPSG:32650"


def test_waveforms_inside_and_beside(tmp_path: Path) -> None:
    source = write_las(tmp_path / "a.las", grid_points(), point_format=4)
    start = source.stat().st_size
    with_evlrs(source, [("LASF_Spec", 65535, b"\x07" * 5000)])
    data = bytearray(source.read_bytes())
    struct.pack_into("<Q", data, 227, start)
    source.write_bytes(data)
    (tmp_path / "a.wdp").write_bytes(b"waves")
    folder = tmp_path / "out"
    folder.mkdir()
    write_with_dimension(source, folder / "a.laz", UNIT, numbers)
    assert_copied(source, folder / "a.laz")
    (record,) = [r for r in read_header(folder / "a.laz").records if r.extended]
    assert struct.unpack_from("<Q", (folder / "a.laz").read_bytes(), 227)[0] == record.offset - 60
    assert (folder / "a.wdp").read_bytes() == b"waves"


def test_a_copc_becomes_a_plain_laz_with_the_same_points(tmp_path: Path) -> None:
    source = write_copc(tmp_path / "a.copc.laz", grid_points())
    write_with_dimension(source, tmp_path / "b.laz", UNIT, numbers)
    assert not inspect_tile(tmp_path / "b.laz", "EPSG:32650").copc
    np.testing.assert_array_equal(laspy.read(tmp_path / "b.laz").xyz, laspy.read(source).xyz)


def test_bytes_that_nobody_described_are_kept(tmp_path: Path) -> None:
    source = rich_tile(tmp_path / "a.las")
    data = bytearray(source.read_bytes())
    # the record of extra bytes under another name: the bytes stay without description
    at = data.index(b"LASF_Spec\0\0\0\0\0\0\0\x04\0")
    data[at : at + 9] = b"unknown__"
    source.write_bytes(data)
    write_with_dimension(source, tmp_path / "b.laz", UNIT, numbers)
    before, after = laspy.read(source), laspy.read(tmp_path / "b.laz")
    length = before.point_format.size
    raw = [np.frombuffer(las.points.array.tobytes(), np.uint8).reshape(len(las.points), -1)[:, :length] for las in (before, after)]
    np.testing.assert_array_equal(*raw)
    np.testing.assert_array_equal(np.asarray(after["unit_id"]), numbers(before.xyz))


def test_a_dimension_of_that_name_is_not_replaced(tmp_path: Path) -> None:
    source = rich_tile(tmp_path / "a.las")
    with pytest.raises(InputError, match="has a dimension Deviation already"):
        write_with_dimension(source, tmp_path / "b.laz", Dimension("Deviation", ""), numbers)
    assert not (tmp_path / "b.laz").exists()
