"""CRS of survey and tiles: axis order, compound, bound and vertical ones, missing grids, and frames without a place on earth."""

from __future__ import annotations

import numpy as np
import pytest
from pyproj import CRS, Transformer
from tetratrack.core.common.errors import CrsError
from tetratrack.core.data.crs import LOCAL, check_survey_crs, crs_text, ground_scale, horizontal_transform, parse_crs, tile_transform

UTM = "EPSG:32650"
CORNERS = np.array([[648_000.0, 3_313_000.0, 2.0], [648_100.0, 3_313_080.0, 9.0]])
SITE = """LOCAL_CS["harbour grid", UNIT["metre", 1]]"""


def moved(tile: str | CRS, survey: str, corners: np.ndarray = CORNERS) -> np.ndarray | None:
    crs = tile if isinstance(tile, CRS) else CRS.from_user_input(tile)
    transform = tile_transform(crs, survey, corners, source="a.laz")
    return None if transform.apply is None else transform.apply(corners)


@pytest.mark.parametrize("text", [UTM, LOCAL, "EPSG:3006", "EPSG:32650+5773", parse_crs(UTM).to_wkt(), parse_crs(UTM).to_json()])
def test_what_a_survey_may_use(text: str) -> None:
    check_survey_crs(text)


@pytest.mark.parametrize("text", ["EPSG:3413", "EPSG:3031", "EPSG:2193", "EPSG:6677", "+proj=utm +zone=50 +datum=WGS84 +units=m +vunits=m"])
def test_axes_of_grids_that_are_no_mirror_image(text: str) -> None:
    """Polar grids run along meridians, some count to the north first, some have a third axis."""
    check_survey_crs(text)
    check_survey_crs(CRS(text).to_3d().to_wkt())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("EPSG:4326", "geographic"),
        ("EPSG:4978", "geocentric"),
        ("EPSG:2263", "not metres"),
        ("EPSG:32650+6360", "not metres"),
        ("EPSG:5773", "not a projected CRS"),
        ("EPSG:2053", "counts to the west and south"),
        ("EPSG:5513+8357", "counts to the south and west, not to the east and north.*EPSG:5514"),
        ("EPSG:1", "unknown CRS"),
        ("somewhere", "LOCAL"),
    ],
)
def test_what_it_may_not(text: str, said: str) -> None:
    with pytest.raises(CrsError, match=said) as caught:
        check_survey_crs(text, source="survey.toml", where="line 3, key crs")
    assert str(caught.value).startswith("survey.toml, line 3, key crs: ")
    assert caught.value.remedy


def test_coordinates_are_easting_first_whatever_the_definition_says() -> None:
    """SWEREF 99 TM lists northing first; ETRS89 / UTM 33 easting first; their numbers are those of one and the same projection."""
    northing_first, easting_first = CRS.from_epsg(3006), CRS.from_epsg(25833)
    assert [axis.direction for axis in northing_first.axis_info] == ["north", "east"]
    stockholm = np.array([[674_000.0, 6_580_000.0, 3.0], [674_050.0, 6_580_020.0, 5.0]])
    there = moved(easting_first, "EPSG:3006", stockholm)
    assert there is None or np.abs(there - stockholm).max() < 1e-3
    assert moved("EPSG:3006", "EPSG:3006", stockholm) is None


def test_tiles_that_count_to_the_west_are_refused() -> None:
    with pytest.raises(CrsError, match=r"EPSG:2053 counts to the west and south.*tiles_crs = "):
        moved("EPSG:2053", "EPSG:32736")


def test_another_zone_is_transformed_and_heights_are_left() -> None:
    there = moved(UTM, "EPSG:32651")
    assert there is not None
    expected = np.column_stack(Transformer.from_crs(32650, 32651, always_xy=True).transform(*CORNERS[:, :2].T))
    np.testing.assert_allclose(there[:, :2], expected, atol=1e-6)
    np.testing.assert_array_equal(there[:, 2], CORNERS[:, 2])
    note = tile_transform(parse_crs(UTM), "EPSG:32651", CORNERS, source="tiles/a.laz").note
    assert note.startswith("a.laz: ")
    assert "heights unchanged" in note


@pytest.mark.parametrize(("tile", "survey"), [("EPSG:32650+5773", UTM), (UTM, "EPSG:32650+5773"), ("EPSG:32650+5773", "EPSG:32650+5773")])
def test_a_compound_crs_counts_by_its_horizontal_part(tile: str, survey: str) -> None:
    assert moved(tile, survey) is None


def test_a_bound_crs_is_the_one_it_binds() -> None:
    bound = CRS.from_user_input("+proj=utm +zone=50 +ellps=WGS84 +towgs84=0,0,0,0,0,0,0 +units=m +type=crs")
    assert bound.is_bound
    assert crs_text(bound)
    compound = CRS.from_user_input("EPSG:32650+5773")
    assert crs_text(compound) == UTM
    of_utm = CRS.from_wkt(
        f"BOUNDCRS[SOURCECRS[{parse_crs(UTM).to_wkt()}],TARGETCRS[{CRS.from_epsg(4326).to_wkt()}],"
        'ABRIDGEDTRANSFORMATION["none",METHOD["Geocentric translations (geog2D domain)",ID["EPSG",9603]],'
        'PARAMETER["X-axis translation",0],PARAMETER["Y-axis translation",0],PARAMETER["Z-axis translation",0]]]'
    )
    assert of_utm.is_bound
    assert moved(of_utm, UTM) is None


def test_heights_are_never_left_as_they_are_in_silence() -> None:
    """From one geoid model to another needs grids; PROJ without them would change nothing and say nothing."""
    with pytest.raises(CrsError, match=r"a\.laz: cannot be transformed exactly"):
        moved("EPSG:32650+5773", "EPSG:32650+3855")


def test_a_missing_grid_is_an_error_and_not_a_worse_transformation() -> None:
    """The British grid comes to ETRS89 within decimetres by OSTN15, within metres without."""
    london = np.array([[530_000.0, 180_000.0, 1.0]])
    with pytest.raises(CrsError, match="cannot be transformed exactly") as caught:
        moved("EPSG:27700", "EPSG:25830", london)
    assert "grid" in caught.value.remedy


def test_a_local_frame_meets_local_tiles_only() -> None:
    site = CRS.from_wkt(SITE)
    assert moved(site, LOCAL) is None
    assert tile_transform(None, LOCAL, CORNERS, source="a.laz").apply is None
    assert crs_text(site) == LOCAL
    assert crs_text(None) == ""
    with pytest.raises(CrsError, match="LOCAL"):
        moved(UTM, LOCAL)
    with pytest.raises(CrsError):
        moved(site, UTM)
    with pytest.raises(CrsError, match="has no CRS") as caught:
        tile_transform(None, UTM, CORNERS, source="a.laz")
    assert f'tiles_crs = "{UTM}"' in caught.value.remedy


def test_layers_are_brought_in_by_their_horizontal_crs() -> None:
    assert horizontal_transform("EPSG:32650+5773", UTM, source="areas.gpkg") is None
    transform = horizontal_transform("EPSG:4326", UTM, source="areas.gpkg")
    assert transform is not None
    degrees = np.column_stack(Transformer.from_crs(32650, 4326, always_xy=True).transform(*CORNERS[:, :2].T))
    np.testing.assert_allclose(transform(degrees), CORNERS[:, :2], atol=1e-6)
    with pytest.raises(CrsError, match=r"areas\.gpkg: has no CRS"):
        horizontal_transform(None, UTM, source="areas.gpkg")


def test_a_transformation_is_looked_for_once(monkeypatch: pytest.MonkeyPatch) -> None:
    first = moved("EPSG:32649", UTM)
    monkeypatch.delattr(Transformer, "from_crs")
    again = moved("EPSG:32649", UTM)
    assert first is not None
    assert again is not None
    assert np.array_equal(first, again)


@pytest.mark.parametrize(
    ("code", "easting", "northing", "scale", "zone"),
    [  # on the line of true or stated scale of each: of its own meridian (Paris, Oslo), in grads, in feet, counted to the south
        (27572, 600_000, 2_200_000, 0.99987742, "EPSG:32631"),
        (27391, 0, 1_000, 1.0, "EPSG:32632"),
        (2046, 0, 3_700_000, 1.0, "EPSG:32733"),
        (32633, 500_000, 5_800_000, 0.9996, "EPSG:32633"),
    ],
)
def test_scale_of_the_grid_over_ground(code: int, easting: float, northing: float, scale: float, zone: str) -> None:
    least, largest, utm = ground_scale(f"EPSG:{code}", easting, northing)
    assert (least, largest) == (pytest.approx(scale, abs=2e-8), pytest.approx(scale, abs=2e-8))
    assert utm == zone
