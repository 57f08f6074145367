"""What a very long coast asks of the parent before any work: time and memory to look through many tiles and cut them into blocks.

    python benchmarks/performance/plan.py SURVEY [--tiles 1000] [--thinner 36] [--folder DIR]

The first tile of a survey, with fewer points, is repeated along the coast, every 50 m. Nothing is remembered of the tiles.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import resource
import tempfile
import time
from pathlib import Path
from typing import Any

import laspy
import numpy as np
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.pipeline.epoch_plans import plan_survey

STEP = 50.0
"""Metres from tile to tile."""


def repeated(source: Path, folder: Path, tiles: int, thinner: int) -> Path:
    """Write so many tiles with one of so many points of the first tile of a survey; returns survey.toml."""
    survey = read_survey(source / "survey.toml")
    las = laspy.read(survey.epochs[0].tiles[0])
    las.points = las.points[np.arange(0, len(las.points), thinner)]
    first, step = np.array(las.X), round(STEP / las.header.scales[0])
    (folder / "tiles").mkdir(parents=True)
    for k in range(tiles):
        las.X = first + k * step
        las.write(str(folder / "tiles" / f"coast_{k:05d}.laz"))
    text = (source / "survey.toml").read_text(encoding="utf-8").split("[[epoch]]")[0]
    target = folder / "survey.toml"
    target.write_text(f'{text}[[epoch]]\nlabel = "first"\ntime = 2024-04-09T02:30:00Z\ntiles = "tiles/*.laz"\n', encoding="utf-8")
    return target


def planned(path: Path) -> dict[str, Any]:
    """Seconds, processor seconds, blocks, points and peak memory of a plan."""
    start, worked = time.perf_counter(), time.process_time()
    plans = plan_survey(read_survey(path))
    return {
        "seconds": time.perf_counter() - start,
        "cpu": time.process_time() - worked,
        "blocks": sum(len(plan.blocks) for plan in plans),
        "points": sum(tile.points for plan in plans for tile in plan.tiles),
        "gib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("survey", type=Path, metavar="SURVEY")
    parser.add_argument("--tiles", type=int, default=1000)
    parser.add_argument("--thinner", type=int, default=36)
    parser.add_argument("--folder", type=Path, help="where tiles are written (default: a temporary folder)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as name:
        os.environ["XDG_CACHE_HOME"] = name
        path = repeated(options.survey, Path(name) / "coast", options.tiles, options.thinner)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            found = pool.apply(planned, (path,))
    print(
        f"{options.tiles} tiles, {found['points']} points, {found['blocks']} blocks: {found['seconds']:.1f} s ({found['cpu']:.1f} CPU s), "
        f"{found['gib']:.2f} GiB"
    )


if __name__ == "__main__":
    main()
