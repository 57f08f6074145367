"""Dates in names: the usual forms are read, numbers that are no dates are not."""

from __future__ import annotations

from datetime import date

import pytest
from tetratrack.core.data.dates_in_names import DAY, MONTH, YEAR, date_in_name, has_coordinates


@pytest.mark.parametrize(
    "name",
    [
        "2024-04-09",
        "uav_20240409_10",
        "2024_4_9 north",
        "9Apr2024",
        "Apr 9, 2024",
        "flight 2024-04-09T02-30",
        "DJI_202404090230_001",
        "DJI_20240409023011_001",
        "240409_flight",
        "2024年4月9日",
    ],
)
def test_day_of_the_usual_forms(name: str) -> None:
    found = date_in_name(name)
    assert found is not None
    assert (found.day, found.exactness, found.swapped) == (date(2024, 4, 9), DAY, None)


@pytest.mark.parametrize(("name", "label", "exactness"), [("2024-04", "2024-04", MONTH), ("2019 after the typhoon", "2019", YEAR)])
def test_less_than_a_day(name: str, label: str, exactness: int) -> None:
    found = date_in_name(name)
    assert found is not None
    assert (found.label, found.exactness) == (label, exactness)


@pytest.mark.parametrize("name", ["tile_236480_285132", "unit_2_6", "E523280N3884680", "strip0409", "20241399", "block 12"])
def test_other_numbers_are_no_dates(name: str) -> None:
    assert date_in_name(name, years_alone=False) is None


def test_day_or_month_first() -> None:
    either, sure = date_in_name("09.04.2024"), date_in_name("04/15/2024")
    assert either is not None
    assert sure is not None
    assert (either.day, either.swapped) == (date(2024, 4, 9), date(2024, 9, 4))
    assert (sure.day, sure.swapped) == (date(2024, 4, 15), None)


@pytest.mark.parametrize(
    ("name", "coordinates"),
    [
        ("tile_250310_4180100", True),
        ("4180100_250310", True),
        ("tile_250340", True),
        ("240601_a", False),
        ("240601_103015_b", False),
        ("240601_00012", False),
        ("20240601_100234", False),
        ("block_12", False),
    ],
)
def test_names_that_hold_coordinates(name: str, coordinates: bool) -> None:
    assert has_coordinates(name) == coordinates
