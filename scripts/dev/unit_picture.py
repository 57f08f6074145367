"""The README's picture: one crop of real tetrapods from above, its points, the fitted outlines and feature points.

Usage: python scripts/dev/unit_picture.py SURVEY.toml RESULT.gpkg UNIT_ID OUTPUT.png
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.data.tiles import Window, inspect_tile, read_points
from tetratrack.core.model.outline import silhouette
from tetratrack.core.results.geopackage_reader import read_layer_rows
from tetratrack.core.results.unit_sizes import shape_of


def draw(survey_path: Path, result: Path, unit_id: str, output: Path) -> None:
    """Draw one unit of the first epoch seen from above and from the south, points coloured by height."""
    mpl.use("Agg")
    import matplotlib.pyplot as plt

    survey = read_survey(survey_path)
    rows = read_layer_rows(result, "units")
    unit = next(row for row in rows if row["unit_id"] == unit_id)
    features = [row for row in read_layer_rows(result, "feature_points") if row["unit_id"] == unit_id]
    shape = shape_of(unit)
    if shape is None:
        raise SystemExit(f"{unit_id} has no pose")
    e, n, _ = shape.centre
    half = 0.75 * unit["height"]
    epoch = survey.epoch(unit["epoch"])
    tiles = [inspect_tile(path, survey.crs, tiles_crs=epoch.tiles_crs) for path in epoch.tiles]
    cloud = read_points(tiles, survey.crs, window=Window(e - half, n - half, e + half, n + half))
    points = cloud.xyz + cloud.origin - shape.centre
    views = [("from above", [1, 0, 0], [0, 1, 0], 2), ("from the south", [1, 0, 0], [0, 0, 1], 1)]
    figure, axes = plt.subplots(1, 2, figsize=(11, 5.4), layout="constrained")
    for axis, (title, right, up, depth) in zip(axes, views, strict=True):
        order = np.argsort(points[:, 2] if depth == 2 else -points[:, 1])[:: max(1, len(points) // 60_000)]
        axis.scatter(points[order] @ right, points[order] @ up, c=points[order, 2], s=0.3, cmap="cividis", linewidths=0, rasterized=True)
        axis.plot(*silhouette(shape, right, up).T, color="#d1495b", linewidth=1.8, label="fitted outline")
        seen = [row for row in features if row["observed"]]
        hidden = [row for row in features if not row["observed"]]
        for group, style, label in ((seen, "o", "feature point, observed"), (hidden, "o", "feature point, inferred")):
            place = np.array([row["geom"] - shape.centre for row in group]).reshape(-1, 3)
            fill = "#d1495b" if group is seen else "white"
            axis.plot(place @ right, place @ up, style, color="#d1495b", markerfacecolor=fill, markersize=7, linestyle="", label=label)
        for row in features:
            offset = row["geom"] - shape.centre
            axis.annotate(row["feature"], (offset @ right, offset @ up), xytext=(6, 5), textcoords="offset points", fontsize=9)
        axis.set_title(title)
        axis.set_aspect("equal")
        axis.set_xlim(-half, half)
        axis.set_ylim(-half, half)
        axis.set_xlabel("m")
    axes[0].legend(loc="lower left", fontsize=8, framealpha=0.9)
    figure.savefig(output, dpi=110)


if __name__ == "__main__":
    draw(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3], Path(sys.argv[4]))
