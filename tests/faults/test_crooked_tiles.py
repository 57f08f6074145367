"""Tiles whose headers are wrong, stale or odd, and clouds that are not as headers say: read rightly, or refused in one sentence."""

from __future__ import annotations

import struct
from pathlib import Path

import laspy
import numpy as np
import pytest
from crooked_las import COUNT_AT, HEADER_SIZE_AT, LEGACY_COUNT_AT, VERSION_AT, patched, with_extent, write_keys, write_survey, write_wkt
from las_files import ORIGIN, grid_points, write_copc, write_las
from tetratrack.core.common.errors import CrsError, InputError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.data.crs import parse_crs
from tetratrack.core.data.occupancy import Occupancy, common_height_shift, stray_cells
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.pipeline.epoch_plans import EpochPlan, plan_survey
from tetratrack.core.segmentation.unit_size import dense_windows

CRS = "EPSG:32650"
HIGH = ORIGIN + np.array([4, 4, 1.6])


def moved(points: np.ndarray, *by: float) -> np.ndarray:
    """Points shifted in easting, and northing and height if given."""
    return points + np.array([*by, 0.0, 0.0][:3])


def planned(survey: Path) -> tuple[EpochPlan, list[str]]:
    """Plan of the only epoch of a survey, and the warnings."""
    said: list[str] = []
    (plan,) = plan_survey(read_survey(survey), Feedback(warning=said.append))
    return plan, said


@pytest.mark.parametrize(
    "place",
    [(300_000.0, 2_000_000.0, 0.0), (505_000.0, 3_500_000.0, 2.0), (500_002.0, 3_500_002.0, 5002.0), (500_002.0, 3_500_002.0, -999.0)],
)
@pytest.mark.parametrize("ending", ["las", "laz"])
def test_a_stray_point_is_named_and_left_out(tmp_path: Path, place: tuple[float, float, float], ending: str) -> None:
    points = grid_points(2000)
    write_las(tmp_path / f"good.{ending}", points)
    write_las(tmp_path / f"stray.{ending}", np.vstack([moved(points, 4), [place]]))
    plan, said = planned(write_survey(tmp_path))
    assert len(plan.blocks) == 1
    assert len(said) == 1
    assert f"stray.{ending}: 1 point lies far from all others" in said[0]
    cloud = read_points(plan.tiles, CRS)
    assert len(cloud) == 4000
    stray = next(tile for tile in plan.tiles if tile.strays)
    assert stray.low == pytest.approx((moved(points, 4)).min(axis=0), abs=2e-3)


def test_points_without_coordinates_are_left_out_however_many(tmp_path: Path) -> None:
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales = np.full(3, 0.01)
    las = laspy.LasData(header)
    las.x, las.y, las.z = np.vstack([grid_points(3000), np.zeros((100, 3))]).T
    las.write(str(tmp_path / "a.laz"))
    plan, said = planned(write_survey(tmp_path, more=f'tiles_crs = "{CRS}"'))
    assert "a.laz: 100 points lie far from all others" in said[0]
    assert plan.tiles[0].used == 3000


def test_two_sites_far_apart_have_blocks_only_where_points_are(tmp_path: Path) -> None:
    write_las(tmp_path / "one.laz", grid_points(2000))
    write_las(tmp_path / "other.laz", moved(grid_points(2000), 40_000, 30_000))
    plan, said = planned(write_survey(tmp_path))
    assert len(plan.blocks) == 2
    assert not said


def test_two_sites_far_apart_take_the_memory_of_their_points(tmp_path: Path) -> None:
    """A grid from one to the other would have 10^10 squares."""
    points = np.vstack([grid_points(2000), moved(grid_points(3000), 400_000, 300_000)])
    places = dense_windows(points - ORIGIN, 2.3, 2)
    assert {bool(place.min() >= 2000) for place in places} == {True, False}


def test_a_height_in_another_unit_is_no_reason_for_endless_blocks(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    points = np.column_stack([rng.uniform(0, 3000, (60_000, 2)), np.zeros(60_000)]) + ORIGIN
    write_las(tmp_path / "a.laz", points)
    with pytest.raises(InputError, match=r"would be cut into \d+ blocks of 0.303 m. Is the unit's height of 0.01"):
        planned(write_survey(tmp_path, height=0.0101))


@pytest.mark.parametrize(
    ("low", "high", "said"),
    [
        (np.zeros(3), np.zeros(3), "gives no extent"),
        (np.full(3, 1e300), np.full(3, -1e300), "gives no extent"),
        (np.full(3, np.nan), np.full(3, np.nan), "gives no extent"),
        (np.full(3, 1e-300), np.full(3, 1e-300), "none of its points lie in"),
        (ORIGIN - 900, ORIGIN - 600, "none of its points lie in"),
        (ORIGIN - 3000, HIGH + 3000, "larger than that of its points"),
        (ORIGIN - 9000, HIGH - 9000, ""),
    ],
)
def test_extents_are_those_of_the_points(tmp_path: Path, low: np.ndarray, high: np.ndarray, said: str) -> None:
    points = grid_points()
    if not said:
        # moved as a whole without a new header
        low, high, said = points.min(axis=0) - [0, 0, 20], points.max(axis=0) - [0, 0, 20], "as if it had been moved"
    tile = inspect_tile(with_extent(write_las(tmp_path / "a.laz", points), low, high), CRS)
    assert any(said in remark for remark in tile.remarks)
    assert tile.low == pytest.approx(points.min(axis=0), abs=2e-3)
    assert len(read_points([tile], CRS)) == 400


@pytest.mark.parametrize("step", [0.01, 0.1, 1.0])
def test_an_extent_may_be_rounded(tmp_path: Path, step: float) -> None:
    points = grid_points()
    low, high = (np.round(corner / step) * step for corner in (points.min(axis=0), points.max(axis=0)))
    tile = inspect_tile(with_extent(write_las(tmp_path / "a.laz", points), low, high), CRS)
    assert len(read_points([tile], CRS)) == 400


def test_old_header_lengths_and_counts(tmp_path: Path) -> None:
    short = write_las(tmp_path / "short.las", grid_points(), None, point_format=1)
    data = bytearray(short.read_bytes())
    (start,) = struct.unpack_from("<I", data, 96)
    head = data[:227]
    head[VERSION_AT] = 3
    struct.pack_into("<HI", head, HEADER_SIZE_AT, 227, 227)
    struct.pack_into("<I", head, LEGACY_COUNT_AT, 400)
    short.write_bytes(bytes(head) + bytes(data[start:]))
    tile = inspect_tile(short, CRS, tiles_crs=CRS)
    assert "227 bytes where LAS 1.3 needs 235" in tile.remarks[0]
    assert len(read_points([tile], CRS)) == 400

    legacy = write_las(tmp_path / "legacy.laz", grid_points(), point_format=1)
    patched(legacy, {COUNT_AT: bytes(8), LEGACY_COUNT_AT: struct.pack("<I", 400)})
    tile = inspect_tile(legacy, CRS)
    assert tile.points == len(read_points([tile], CRS)) == 400
    assert "that count, 400, is taken" in tile.remarks[0]

    unfinished = patched(write_las(tmp_path / "unfinished.las", grid_points()), {COUNT_AT: bytes(8)})
    with pytest.raises(InputError, match="its header was never finished"):
        inspect_tile(unfinished, CRS)


def test_points_that_the_header_does_not_count_are_told(tmp_path: Path) -> None:
    patched(write_las(tmp_path / "a.las", grid_points()), {COUNT_AT: struct.pack("<Q", 300)})
    plan, said = planned(write_survey(tmp_path))
    assert plan.tiles[0].used == 300
    assert said == ["a.las: its header counts 300 points, the file seems to hold 400; those behind are not read"]


def test_compression_by_points_is_named(tmp_path: Path) -> None:
    path = write_las(tmp_path / "old.laz", grid_points())
    data = path.read_bytes()
    at = data.index(b"laszip encoded") - 2 + 54
    patched(path, {at: struct.pack("<H", 1)})
    with pytest.raises(InputError, match=r"is compressed point by point.*pdal translate"):
        inspect_tile(path, CRS)


@pytest.mark.parametrize("point_format", [6, 7, 8])
def test_a_chunk_that_claims_gigabytes_is_refused_before_room_is_made(tmp_path: Path, point_format: int) -> None:
    path = write_las(tmp_path / "a.laz", grid_points(120_000), point_format=point_format)
    assert inspect_tile(path, CRS).used == 120_000
    (start, length) = struct.unpack_from("<I4xxH", path.read_bytes(), 96)
    # behind the first point and the number of points, the size of the second layer
    patched(path, {start + 8 + length + 4 + 4: struct.pack("<I", 0xF0000000)})
    with pytest.raises(InputError, match="a compressed chunk claims more bytes than there are"):
        inspect_tile(path, CRS)


def test_geotiff_keys_are_read_whole(tmp_path: Path) -> None:
    plain = {1024: 1, 3072: 32650}
    assert inspect_tile(write_keys(tmp_path / "plain.las", plain), CRS).crs == CRS
    compound = inspect_tile(write_keys(tmp_path / "compound.las", plain | {4096: 5773}), CRS)
    assert compound.heights == "EGM96 height"
    for unit, name in ((9003, "US survey foot"), (9002, "foot")):
        with pytest.raises(CrsError, match=rf"is in {name}, not metres \(heights\).*tiles_crs = "):
            inspect_tile(write_keys(tmp_path / "heights.las", plain | {4099: unit}), CRS)
        with pytest.raises(CrsError, match=rf"is in {name}, not metres \(easting and northing\)"):
            inspect_tile(write_keys(tmp_path / "plane.las", plain | {3076: unit}), CRS)
    with pytest.raises(CrsError, match=r"cannot be understood \('Gauss-Kruger of the harbour'\).*tiles_crs"):
        inspect_tile(write_keys(tmp_path / "named.las", {1024: 1, 3072: 32767}, "Gauss-Kruger of the harbour"), CRS)
    overruled = inspect_tile(write_keys(tmp_path / "over.las", plain | {4099: 9003}), CRS, tiles_crs=CRS)
    assert "tiles_crs overrules it: EPSG:32650" in overruled.remarks[0]


@pytest.mark.parametrize(
    ("wkt", "said"),
    [
        (b'PROJCS["Projected",GEOGCS["x"]]', "cannot be understood"),
        (b'""', "declares an empty CRS"),
        (b'LOCAL_CS["Local Coordinates (m)",UNIT["metre",1]]', r'is in a local frame.*crs = "LOCAL"'),
    ],
)
def test_no_crs_is_a_dead_end(tmp_path: Path, wkt: bytes, said: str) -> None:
    path = write_wkt(tmp_path / "a.las", wkt)
    with pytest.raises(CrsError, match=said) as caught:
        inspect_tile(path, CRS)
    assert "tiles_crs" in caught.value.remedy
    tile = inspect_tile(path, CRS, tiles_crs=CRS)
    assert "tiles_crs overrules it" in tile.remarks[0]
    assert len(read_points([tile], CRS)) == 400
    # looked at by itself it can be read, and what is odd is said
    assert inspect_tile(path, None).points == 400


def test_a_refused_transformation_names_the_key_that_gets_past_it(tmp_path: Path) -> None:
    """A datum shift that somebody typed in belongs to no code that the survey could take."""
    wkt = (
        'PROJCS["typed in",GEOGCS["y",DATUM["z",SPHEROID["w",6378137,298.257223563],TOWGS84[100,200,300,0,0,0,0]],PRIMEM["Greenwich",0],'
        'UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],'
        'PARAMETER["central_meridian",117],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],'
        'PARAMETER["false_northing",0],UNIT["metre",1]]'
    )
    with pytest.raises(CrsError, match="cannot be transformed exactly") as caught:
        inspect_tile(write_wkt(tmp_path / "a.las", wkt.encode()), CRS)
    assert 'tiles_crs = "EPSG:32650"' in caught.value.remedy
    assert 'crs = "typed in' not in caught.value.remedy


def test_two_statements_of_the_crs_are_told(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.las", grid_points())
    for code, told in ((32650, 0), (32651, 1)):
        data = bytearray(write_las(path, grid_points()).read_bytes())
        text = parse_crs(f"EPSG:{code}").to_wkt("WKT1_GDAL").encode()
        struct.pack_into("<QI", data, 235, len(data), 1)
        path.write_bytes(data + struct.pack("<H16sHQ32s", 0, b"LASF_Projection", 2112, len(text), b"") + text)
        tile = inspect_tile(path, CRS)
        assert tile.crs == CRS
        assert len(tile.remarks) == told
    assert "its header declares WGS 84 / UTM zone 50N and WGS 84 / UTM zone 51N; the former is taken" in tile.remarks[0]
    assert inspect_tile(path, CRS, tiles_crs=CRS).remarks == ()


def test_tiles_crs_overrules_a_wrong_header(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.laz", grid_points(), "EPSG:32651")
    tile = inspect_tile(path, CRS, tiles_crs=CRS)
    assert tile.low == pytest.approx(grid_points().min(axis=0), abs=2e-3)
    assert "EPSG:32650" in tile.remarks[0]
    assert inspect_tile(write_las(tmp_path / "b.laz", grid_points(), CRS), CRS, tiles_crs=CRS).remarks == ()


def test_copies_of_a_tile_count_once(tmp_path: Path) -> None:
    points = grid_points(2000)
    write_las(tmp_path / "a.laz", points)
    write_copc(tmp_path / "a.copc.laz", moved(points, 0.0004))
    plan, said = planned(write_survey(tmp_path))
    assert [tile.path.name for tile in plan.tiles] == ["a.laz"]
    assert said == ["a.copc.laz: holds the same points as a.laz and is left out"]


def test_overlapping_tiles_rounded_otherwise_count_once(tmp_path: Path) -> None:
    points = grid_points(3000)
    west, east = points[:, 0] < ORIGIN[0] + 2.5, points[:, 0] > ORIGIN[0] + 1.5
    for time in (None, np.arange(3000.0)):
        folder = tmp_path / ("timed" if time is not None else "untimed")
        folder.mkdir()
        one = write_las(folder / "west.laz", points[west], time=None if time is None else time[west])
        other = write_las(folder / "east.laz", points[east], time=None if time is None else time[east])
        # the same points, with the zero of their numbers half a millimetre aside
        zero = np.array(struct.unpack_from("<3d", other.read_bytes(), 155)) + 0.0005
        with_extent(patched(other, {155: struct.pack("<3d", *zero)}), np.zeros(3), np.zeros(3))
        tiles = [inspect_tile(path, CRS) for path in (one, other)]
        assert len(read_points(tiles, CRS)) == 3000


def test_noise_and_empty_tiles_are_counted_and_named(tmp_path: Path) -> None:
    points = grid_points(2000)
    write_las(tmp_path / "a.laz", points, classification=np.full(2000, 7, np.uint8))
    with pytest.raises(InputError, match=r"epoch a: all 2000 points are classed as noise"):
        planned(write_survey(tmp_path))
    write_las(tmp_path / "b.laz", moved(points[:500], 4))
    write_las(tmp_path / "c.laz", np.empty((0, 3)))
    plan, said = planned(write_survey(tmp_path))
    assert [tile.path.name for tile in plan.tiles] == ["b.laz"]
    assert len(said) == 3
    assert "a.laz: holds 2000 points, all classed as noise or withheld, and is left out" in said[0]
    assert "c.laz: holds no points and is left out" in said[1]
    assert "2000 of 2500 points (80 %)" in said[2]


def test_one_bad_tile_does_not_hide_another(tmp_path: Path) -> None:
    for name in ("a.laz", "b.laz", "c.laz"):
        write_las(tmp_path / name, grid_points())
    for name in ("a.laz", "c.laz"):
        (tmp_path / name).write_bytes(b"LASF" * 200)
    with pytest.raises(InputError, match=r"a\.laz: .* 1 more input is refused"):
        planned(write_survey(tmp_path))


def test_what_is_looked_at_is_remembered_as_long_as_the_file_is_the_same(tmp_path: Path) -> None:
    path = write_las(tmp_path / "a.laz", grid_points())
    assert inspect_tile(path, CRS).used == inspect_tile(path, CRS).used == 400
    write_las(path, grid_points(300))
    assert inspect_tile(path, CRS).used == 300


def test_stray_cells_and_heights_of_clouds() -> None:
    rng = np.random.default_rng(3)
    cloud = np.column_stack([rng.uniform(0, 60, (9000, 2)), rng.uniform(0, 3, 9000)])
    site = Occupancy.of(np.vstack([cloud, moved(cloud[:100], 900), [[0, 0, 500]]]), 2)
    stray = stray_cells(site)
    # a hundred points may be a unit; a single one is none
    assert int(site.counts[stray].sum()) == 1
    shift = common_height_shift(Occupancy.of(cloud, 2), Occupancy.of(moved(cloud, 0, 0, 20.3), 2))
    assert shift == pytest.approx(20.3, abs=0.01)
    assert common_height_shift(Occupancy.of(cloud, 2), Occupancy.of(moved(cloud, 500), 2)) is None
    coarse = site.coarser(4)
    assert coarse.points == site.points
    assert coarse.size == 16.0
