"""Copies of surveys with ground truth whose clouds are poorer: thinned, noised, or seen from one station alone.

Not run by itself: ``poor_clouds.py`` measures on these copies. The truth stays that of the source survey, so that recall by visible share
compares like with like; where a station is taken away what the others alone saw is hidden, and the shares are counted anew.
"""

from __future__ import annotations

import csv
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import laspy
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from tetratrack.benchmarks.ground_truth import number_of, point_labels, read_epoch
from tetratrack.core.data.survey import Survey
from tetratrack.core.data.survey_reader import read_survey
from tetratrack.core.model.tetrapod import surface_cells
from tetratrack.core.segmentation.surface_elements import surface_elements

CELLS = 400
"""Equal parts of a unit's surface by which its visible share is told."""
PLAN_CELL = 0.2
"""Edge of the squares, as a share of the height, by which the area of the armour is told from above."""


@dataclass(frozen=True)
class Poverty:
    """What is taken from a cloud.

    Attributes
    ----------
    kind
        ``density``: what stays, in points on units per H² of armour seen from above. ``noise``: standard deviation of a point across the
        surface afterwards, as a share of H. ``station``: point source ID of the only one that stays.
    value
        See there.
    """

    kind: Literal["density", "noise", "station"]
    value: float

    @property
    def name(self) -> str:
        """For folders and tables."""
        return f"{self.kind}_{self.value:g}"


def poor_copy(source: Path, target: Path, poverty: Poverty, seed: int = 0) -> Path:
    """Write a poorer copy of the survey in a folder to another one, which must not exist; returns it."""
    survey = read_survey(source / "survey.toml")
    shutil.copytree(source, target)
    for path in [target, *target.rglob("*")]:
        path.chmod(0o755 if path.is_dir() else 0o644)
    for number, epoch in enumerate(survey.epochs):
        rng = np.random.default_rng([seed, number])
        labels_path = target / "truth" / f"labels_{epoch.label}.npz"
        with np.load(labels_path) as stored:
            labels = {name: stored[name] for name in stored.files}
        tiles = sorted((target / "tiles" / epoch.label).glob("*.laz"))
        clouds = [laspy.read(tile) for tile in tiles]
        chosen, shifts = _impoverished(clouds, [labels[t.stem] for t in tiles], survey, poverty, rng)
        for tile, cloud, stay, shift in zip(tiles, clouds, chosen, shifts, strict=True):
            cloud.points = cloud.points[stay]
            if shift is not None:
                cloud.xyz = np.asarray(cloud.xyz) + shift[stay]
            cloud.write(tile)
            labels[tile.stem] = labels[tile.stem][stay]
            if not len(cloud.points):
                tile.unlink()
        np.savez_compressed(labels_path, **labels)
    if poverty.kind == "station":
        _count_anew(target)
    return target


def _impoverished(
    clouds: list[Any], labels: list[NDArray[Any]], survey: Survey, poverty: Poverty, rng: np.random.Generator
) -> tuple[list[NDArray[np.bool_]], list[NDArray[np.float64] | None]]:
    """By tile: which points stay, and by how much each point moves."""
    everything = [np.ones(len(c.points), dtype=np.bool_) for c in clouds]
    height = survey.unit.height
    if poverty.kind == "station":
        return [np.asarray(c.point_source_id) == int(poverty.value) for c in clouds], [None] * len(clouds)
    if poverty.kind == "density":
        share = poverty.value / points_per_square(clouds, labels, height)
        return [rng.random(len(c.points)) < share for c in clouds], [None] * len(clouds)
    xyz = np.vstack([np.asarray(c.xyz) for c in clouds])
    present = surface_elements(xyz - xyz.mean(axis=0), height).noise
    more = np.sqrt(max((poverty.value * height) ** 2 - present**2, 0.0))
    return everything, [rng.normal(0.0, more, (len(c.points), 3)) for c in clouds]


def points_per_square(clouds: list[Any], labels: list[NDArray[Any]], height: float) -> float:
    """Points on units per square of edge H of the armour as seen from above."""
    on_units = np.vstack([np.asarray(c.xyz)[own >= 0, :2] for c, own in zip(clouds, labels, strict=True)])
    cells = len(np.unique(np.floor(on_units / (PLAN_CELL * height)).astype(np.int64), axis=0))
    return len(on_units) / (cells * PLAN_CELL**2)


def _count_anew(folder: Path) -> None:
    """Visible shares and numbers of points in ``truth/units.csv`` from the points that are left."""
    survey = read_survey(folder / "survey.toml")
    path = folder / "truth" / "units.csv"
    with path.open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    cells = cKDTree(surface_cells(survey.unit, CELLS)[0])
    for epoch in survey.epochs:
        cloud = read_epoch(survey, epoch.label)
        # tiles are read one by one here: the points of an epoch are sorted when they are read together
        xyz = np.vstack([np.asarray(laspy.read(tile).xyz) for tile in epoch.tiles]) - cloud.origin
        labels = np.concatenate([point_labels(survey, epoch.label, tile) for tile in epoch.tiles])
        places = {unit.unit_id: unit.pose for unit in cloud.truth}
        for row in rows:
            if row["epoch"] == epoch.label and row["unit_id"] in places:
                own = xyz[labels == number_of(row["unit_id"])]
                seen = np.unique(cells.query(places[row["unit_id"]].to_body(own))[1]) if len(own) else []
                row["visible_area_fraction"], row["n_points"] = f"{len(seen) / CELLS:.4f}", str(len(own))
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
