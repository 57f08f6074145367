"""Tiles written back with the number of each point's unit, as an extra dimension of the LAS format (extra bytes)."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import astuple
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from ..common.errors import InputError, OutputError
from ..common.feedback import Feedback
from ..common.output_files import check_targets, safe_name
from ..common.robust import MAD_TO_SD
from ..data.las_copies import Dimension, write_with_dimension
from ..data.survey import Survey
from ..data.tiles import TileInfo, transform_of
from ..model.pose import Pose
from ..model.unit_types import UnitType
from ..results.geopackage_reader import Row, read_layer_rows
from ..results.run_record import epochs_of
from ..results.unit_rows import unit_sizes
from ..results.unit_sizes import unit_of
from ..segmentation.segment import KnownUnits, points_of_known
from .epoch_plans import plan_survey
from .placed_points import Placing, placing

Transform = Callable[[FloatArray], FloatArray]

DIMENSION = "unit_id"


def write_labelled_tiles(survey: Survey, result: Path, folder: Path, feedback: Feedback) -> dict[str, Any]:
    """Write every tile of a survey to ``folder``/epoch/ as LAZ with dimension ``unit_id``, and nothing else changed.

    The dimension holds the number in the unit's id (17 for U0017) of the units found in that epoch, 0 for points of none and
    for those between two units that either may have.

    Raises
    ------
    InputError
        Survey and result do not belong together, or a tile is damaged.
    OutputError
        The folder cannot be written, or a file would replace an input or another output.
    """
    infos = epochs_of(survey, result, feedback)
    sizes = unit_sizes(list(infos.values()))
    rows = [row for row in read_layer_rows(result, "units") if row["geom"] is not None and row["status"] != "uncertain"]
    bends = read_layer_rows(result, "frame_errors")
    plans = plan_survey(survey, feedback.part(0, 0.05))
    targets = {
        (plan.epoch.label, tile.path): folder / safe_name(plan.epoch.label) / f"{tile.path.stem}.laz"
        for plan in plans
        for tile in plan.tiles
    }
    check_targets([(target, str(tile)) for (_, tile), target in targets.items()], (*survey.files, result))
    total = sum(len(plan.tiles) for plan in plans)
    done = labelled = 0
    for plan in plans:
        placed = placing(infos[plan.epoch.label], bends)
        units: dict[UnitType, list[Row]] = {}
        for row in rows:
            if row["epoch"] == plan.epoch.label:
                units.setdefault(unit_of(row, sizes), []).append(row)
        for tile in plan.tiles:
            feedback.check()
            feedback.progress(0.05 + 0.95 * done / total, f"labelling {tile.path.name}")
            target = targets[plan.epoch.label, tile.path]
            try:
                target.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise OutputError(f"cannot be made ({error.strerror})", source=target.parent, remedy="Choose another folder.") from error
            numbers = partial(_numbers_of, tile=tile, transform=transform_of(tile, survey.crs), placed=placed, units=units)
            labelled += write_with_dimension(tile.path, target, Dimension(DIMENSION, "number of the tetrapod"), numbers)
            done += 1
    return {"folder": str(folder), "tiles": done, "points": labelled}


def _numbers_of(
    xyz: FloatArray,
    source_ids: NDArray[np.uint16],
    gps_time: FloatArray,
    tile: TileInfo,
    transform: Transform | None,
    placed: Placing,
    units: Mapping[UnitType, list[Row]],
) -> NDArray[np.uint32]:
    """(n,) number of the unit of each point, in the CRS of its tile."""
    return points_of_units(placed(xyz if transform is None else transform(xyz), tile.strips_of(source_ids, gps_time)), units)


def points_of_units(points: FloatArray, units: Mapping[UnitType, list[Row]]) -> NDArray[np.uint32]:
    """(n,) number of the unit of each of (n, 3) points of the control frame, metres, 0 for none; rows of units by their type.

    As in a run, points that may as well be a neighbour's are of none.
    """
    if not len(points):
        return np.zeros(0, dtype=np.uint32)
    origin = np.floor(points.mean(axis=0))
    known = []
    for unit, members in sorted(units.items(), key=lambda item: astuple(item[0])):
        poses = [Pose.from_quaternion(row["geom"] - origin, [row[q] for q in ("qx", "qy", "qz", "qw")]) for row in members]
        numbers = np.array([_number_of(row["unit_id"]) for row in members], dtype=np.int64)
        known.append(KnownUnits(unit, np.array([pose.as_row() for pose in poses]), _noise(members), numbers))
    return np.maximum(points_of_known(points - origin, known), 0).astype(np.uint32)


def _noise(members: Sequence[Row]) -> float:
    """Standard deviation of a point in the cloud of these units, metres; 0 where the result does not tell."""
    medians = [row["distance_median"] for row in members if row["distance_median"] is not None]
    return MAD_TO_SD * float(np.median(medians)) if medians else 0.0


def _number_of(unit_id: str) -> int:
    digits = re.search(r"(\d+)$", unit_id)
    if digits is None:
        raise InputError(f"unit {unit_id} has no number in its id", remedy="Give a result of tetratrack run.")
    return int(digits[1])
