"""Export of a result's layers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.common.errors import InputError
from tetratrack.core.results.export import export_layers
from tetratrack.core.results.geopackage_writer import write_geopackage

ROW = {
    "unit_id": "U0001",
    "epoch": "a",
    "epoch_time": "2025-03-14T02:30:00+00:00",
    "height": 2.3,
    "status": "found",
    "geometry": [1.0, 2.0, 3.0],
}
LINE = {"unit_id": "U0001", "feature": "centre", "de": 0.1, "significant": True, "geometry": [[1.0, 2.0, 3.0], [1.1, 2.0, 3.0]]}


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    lost = ROW | {"unit_id": "U0002", "status": "lost", "geometry": None}
    write_geopackage(path, "EPSG:32652", {"units": [ROW, lost], "displacements": [LINE]})
    return path


def test_csv_has_coordinates_as_columns(result: Path, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    files = export_layers(result, tmp_path / "out", ["csv"], ["units", "displacements"])
    units, lines = (pandas.read_csv(file) for file in files)
    assert units.loc[0, ["x", "y", "z"]].tolist() == [1, 2, 3]
    assert np.isnan(units.loc[1, "x"])
    assert units.loc[0, "epoch_time"] == "2025-03-14T02:30:00Z"
    assert lines.loc[0, ["x", "x_to"]].tolist() == [1, 1.1]


def test_parquet_keeps_geometry_crs_and_times(result: Path, tmp_path: Path) -> None:
    geopandas = pytest.importorskip("geopandas")
    export_layers(result, tmp_path / "out", ["parquet"])
    units = geopandas.read_parquet(tmp_path / "out" / "units.parquet")
    assert units.crs.to_epsg() == 32652
    assert units.geometry[0].z == 3
    assert str(units["epoch_time"].dtype).startswith("datetime64")


def test_formats_are_known_by_their_names(result: Path, tmp_path: Path) -> None:
    """CSV in capitals gave a Parquet file under the name units.CSV, and xlsx one under that of a spreadsheet."""
    with pytest.raises(InputError, match="cannot be written as xlsx"):
        export_layers(result, tmp_path / "out", ["csv", "xlsx"], ["units"])
    assert not (tmp_path / "out").exists()
    assert [path.name for path in export_layers(result, tmp_path / "out", ["CSV"], ["units"])] == ["units.csv"]
    assert (tmp_path / "out" / "units.csv").read_text(encoding="utf-8-sig").startswith("unit_id,")


def test_unknown_layer_is_named(result: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="has no layer roads"):
        export_layers(result, tmp_path / "out", layers=["roads"])


def test_whole_numbers_and_truth_values_stay_such_beside_empty_ones(tmp_path: Path) -> None:
    """A lost unit without points made 828 points 828.0, or 828,0, and what is observed 1.0."""
    geopandas = pytest.importorskip("geopandas")
    pandas = pytest.importorskip("pandas")
    path = tmp_path / "result.gpkg"
    seen = ROW | {"n_points": 828, "legs_visible": 3}
    point = {"unit_id": "U0001", "epoch": "a", "feature": "centre", "observed": True, "geometry": [1.0, 2.0, 3.0]}
    rows = {"units": [seen, ROW | {"unit_id": "U0002", "geometry": None}], "feature_points": [point, point | {"observed": None}]}
    write_geopackage(path, "EPSG:32652", rows | {"displacements": [LINE]})
    folder = tmp_path / "out"
    export_layers(path, folder, separator="semicolon")
    units, points, lines = (
        pandas.read_csv(folder / f"{name}.csv", sep=";", dtype=str, keep_default_na=False)
        for name in ("units", "feature_points", "displacements")
    )
    assert units[["n_points", "legs_visible"]].to_numpy().tolist() == [["828", "3"], ["", ""]]
    assert units["height"].tolist() == ["2,3", "2,3"]
    assert points["observed"].tolist() == ["True", ""]
    assert lines["significant"].tolist() == ["True"]
    kept, truths = (geopandas.read_parquet(folder / f"{name}.parquet") for name in ("units", "feature_points"))
    assert kept["n_points"].dtype.kind == "i"
    assert truths["observed"].dtype.kind == "b"
    assert kept["n_points"].isna().tolist() == [False, True]
