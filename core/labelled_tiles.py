"""Tiles written back with the number of each point's unit, as an extra dimension of the LAS format (extra bytes)."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import astuple
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .aggregation import assign
from .control import transformation_of
from .crs import tile_transform
from .displacement_rows import epochs_of, unit_of, unit_sizes
from .epoch_plans import plan_survey
from .errors import InputError, OutputError
from .feedback import Feedback
from .geopackage import replace_durably, temporary_beside
from .pose import Pose
from .result_tables import Row, read_layer_rows
from .survey import Survey
from .tiles import TileInfo, tile_chunks, tile_crs
from .unit_types import UnitType

FloatArray = NDArray[np.float64]

DIMENSION = "unit_id"
NEAR_SURFACE_HEIGHTS = 0.02
"""A point is the unit's whose surface is nearest, if nearer than this share of the height."""


def write_labelled_tiles(survey: Survey, result: Path, folder: Path, feedback: Feedback) -> dict[str, Any]:
    """Write every tile of a survey to ``folder``/epoch/, points, order, CRS and offsets as they were, with dimension ``unit_id``.

    The dimension holds the number in the unit's id (17 for U0017) of the units found in that epoch, 0 for points of none.

    Raises
    ------
    InputError
        Survey and result do not belong together, or a tile is damaged.
    OutputError
        The folder cannot be written.
    """
    infos = epochs_of(survey, result)
    sizes = unit_sizes(list(infos.values()))
    rows = [row for row in read_layer_rows(result, "units") if row["geom"] is not None and row["status"] != "uncertain"]
    plans = plan_survey(survey, feedback.part(0, 0.05))
    total = sum(len(plan.tiles) for plan in plans)
    done = labelled = 0
    for plan in plans:
        transformation = transformation_of(infos[plan.epoch.label].transformation)
        to_control = (lambda xyz: xyz) if transformation is None else transformation.apply
        units: dict[UnitType, list[Row]] = {}
        for row in rows:
            if row["epoch"] == plan.epoch.label:
                units.setdefault(unit_of(row, sizes), []).append(row)
        for tile in plan.tiles:
            feedback.check()
            feedback.progress(0.05 + 0.95 * done / total, f"labelling {tile.path.name}")
            target = folder / plan.epoch.label / f"{tile.path.stem}.laz"
            try:
                target.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                raise OutputError(f"cannot be made ({error.strerror})", source=target.parent, remedy="Choose another folder.") from error
            labelled += _write_tile(tile, target, survey.crs, plan.epoch.tiles_crs, units, to_control)
            done += 1
    return {"folder": str(folder), "tiles": done, "points": labelled}


def _write_tile(
    tile: TileInfo,
    target: Path,
    survey_crs: str,
    tiles_crs: str | None,
    units: Mapping[UnitType, list[Row]],
    to_control: Callable[[FloatArray], FloatArray],
) -> int:
    """Copy one tile by chunks with the dimension added; returns how many points belong to a unit."""
    import laspy

    labelled = 0
    with laspy.open(str(tile.path), laz_backend=laspy.LazBackend.Lazrs) as reader:
        crs = tile_crs(reader.header, tile.path, tiles_crs)
        corners = np.array([reader.header.mins, reader.header.maxs])
        transform = tile_transform(crs, survey_crs, corners, source=tile.path).apply
        names = set(reader.header.point_format.dimension_names)
        if DIMENSION in names:
            raise InputError(f"has a dimension {DIMENSION} already", source=tile.path, remedy="Give the tiles as they were surveyed.")
        header = laspy.LasHeader(version=reader.header.version, point_format=laspy.PointFormat(reader.header.point_format.id))
        header.offsets, header.scales = reader.header.offsets, reader.header.scales
        header.global_encoding = reader.header.global_encoding
        # records of the compression are the writer's own business
        header.vlrs.extend(vlr for vlr in reader.header.vlrs if vlr.user_id not in ("laszip encoded", "copc", "LASF_Spec"))
        for dimension in reader.header.point_format.extra_dimensions:
            header.add_extra_dim(laspy.ExtraBytesParams(dimension.name, dimension.dtype, dimension.description))
        header.add_extra_dim(laspy.ExtraBytesParams(DIMENSION, np.uint32, "number of the tetrapod"))
        with temporary_beside(target.absolute()) as temporary:
            try:
                with laspy.open(str(temporary), mode="w", header=header, laz_backend=laspy.LazBackend.Lazrs, do_compress=True) as writer:
                    for chunk in tile_chunks(reader, tile.path):
                        xyz = np.column_stack([chunk.x, chunk.y, chunk.z]).astype(np.float64, copy=False)
                        numbers = _numbers(to_control(xyz if transform is None else transform(xyz)), units)
                        points = laspy.ScaleAwarePointRecord.zeros(len(chunk), header=header)
                        points.copy_fields_from(chunk)
                        points[DIMENSION] = numbers
                        writer.write_points(points)
                        labelled += int((numbers > 0).sum())
            except OSError as error:
                raise OutputError("cannot be written", source=target, remedy="Check the folder's permissions and free space.") from error
            replace_durably(temporary, target.absolute())
    return labelled


def _numbers(points: FloatArray, units: Mapping[UnitType, list[Row]]) -> NDArray[np.uint32]:
    """(n,) number of the unit of each point of the control frame, 0 for none."""
    numbers = np.zeros(len(points), dtype=np.uint32)
    if not len(points):
        return numbers
    origin = np.floor(points.mean(axis=0))
    nearest = np.full(len(points), np.inf)
    for unit, members in sorted(units.items(), key=lambda item: astuple(item[0])):
        poses = [Pose.from_quaternion(row["geom"] - origin, [row[q] for q in ("qx", "qy", "qz", "qw")]) for row in members]
        table = np.array([np.concatenate([pose.centre, pose.rotation.ravel()]) for pose in poses])
        labels, distance = assign(points - origin, table, unit, NEAR_SURFACE_HEIGHTS * unit.height)
        nearer = (labels >= 0) & (np.abs(distance) < nearest)
        nearest[nearer] = np.abs(distance[nearer])
        ids = np.array([_number_of(row["unit_id"]) for row in members], dtype=np.uint32)
        numbers[nearer] = ids[labels[nearer]]
    return numbers


def _number_of(unit_id: str) -> int:
    digits = re.search(r"(\d+)$", unit_id)
    if digits is None:
        raise InputError(f"unit {unit_id} has no number in its id", remedy="Give a result of tetratrack run.")
    return int(digits[1])
