"""What a killed program (QGIS, say) left beside a GeoPackage is recovered before GDAL reads it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import geopandas
import pytest
import shapely
from tetratrack.core.common.sqlite_files import has_leftovers, recover
from tetratrack.core.registration.stable_areas import read_areas

KILLED_EDITOR = """
import os, signal, sqlite3, sys
c = sqlite3.connect(sys.argv[1], isolation_level=None)
c.execute("PRAGMA cache_size = 1")
for name, in c.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
    c.execute(f"DROP TRIGGER {name}")
c.execute("BEGIN IMMEDIATE")
c.execute("UPDATE stable SET geom = zeroblob(3000)")
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(os.name != "posix", reason="kills as POSIX has them")
def test_stable_areas_of_a_killed_editor(tmp_path: Path) -> None:
    path = tmp_path / "areas.gpkg"
    boxes = [shapely.box(10 * k, 0, 10 * k + 5, 5) for k in range(200)]
    geopandas.GeoDataFrame(geometry=boxes, crs="EPSG:32650").to_file(path, layer="stable", driver="GPKG")
    killed = subprocess.run([sys.executable, "-c", KILLED_EDITOR, str(path)], check=False)
    assert killed.returncode == -signal.SIGKILL
    assert has_leftovers(path)
    assert read_areas(path, "EPSG:32650").area == pytest.approx(200 * 25)
    assert not has_leftovers(path)


def test_what_is_no_database_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "areas.gpkg"
    path.write_bytes(b"text")
    path.with_name("areas.gpkg-journal").write_bytes(b"text")
    recover(path)
    assert path.read_bytes() == b"text"
    recover(tmp_path / "none.gpkg")
