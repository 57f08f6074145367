"""Units of an epoch between the steps, and the rows of the result they become."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .block_jobs import covariances_of
from .feature_points import FEATURES, feature_points
from .geopackage import upper_triangle
from .pose import Pose
from .run_record import RunRecord, software_version
from .survey import Epoch
from .tile_jobs import Block, loaded_arrays
from .tiles import TileInfo
from .unit_types import UnitType

if TYPE_CHECKING:
    from .control import Registration
    from .trajectory import BeamNoise

FloatArray = NDArray[np.float64]
Row = dict[str, Any]


@dataclass(frozen=True, eq=False)
class EpochPlan:
    """An epoch with its checked tiles and the blocks it is cut into."""

    epoch: Epoch
    tiles: tuple[TileInfo, ...]
    blocks: tuple[Block, ...]

    @property
    def points(self) -> int:
        """Points of all tiles."""
        return sum(tile.points for tile in self.tiles)


@dataclass(frozen=True, eq=False)
class EpochUnits:
    """Units of one epoch, in the frame of its cloud.

    Attributes
    ----------
    plan
        The epoch.
    table
        Arrays by column, one row per unit in order of easting; ``poses`` (k, 12) are absolute. See :mod:`block_jobs`.
    places
        (k, 2) number of the file in ``files`` and row in it that hold each unit's points.
    files
        Results of the blocks' jobs.
    units
        Geometry by type of unit, calibrated where that was asked for.
    """

    plan: EpochPlan
    table: Mapping[str, NDArray[Any]]
    places: NDArray[np.int64]
    files: tuple[Path, ...]
    units: tuple[UnitType, ...]

    def __len__(self) -> int:
        return len(self.places)

    def pose(self, row: int) -> Pose:
        """Absolute pose of a unit."""
        values = self.table["poses"][row]
        return Pose(values[:3], values[3:].reshape(3, 3))

    def reader(self) -> Callable[[int], tuple[FloatArray, NDArray[np.uint16]]]:
        """Reads (n, 3) absolute points and (n,) source ids of a unit by its row.

        It holds one file at a time: units of one file are to be asked for one after the other.

        Raises
        ------
        InputError
            When reading, if a file is gone.
        """
        arrays_of = self._arrays()

        def read(row: int) -> tuple[FloatArray, NDArray[np.uint16]]:
            arrays, own = arrays_of(row)
            return arrays["points"][own] + arrays["origin"], arrays["sources"][own]

        return read

    def points(self) -> Iterator[tuple[int, FloatArray, NDArray[np.uint16]]]:
        """Row, (n, 3) absolute points and (n,) source ids of every unit, file by file."""
        read = self.reader()
        for row in np.argsort(self.places[:, 0], kind="stable"):
            yield int(row), *read(int(row))

    def covariances(self, beams: BeamNoise) -> Callable[[int], FloatArray]:
        """Reads (n, 3, 3) covariances of a unit's points by its row, in the order of :meth:`reader`'s points; square metres.

        It holds one file at a time too.

        Raises
        ------
        InputError
            When reading, if a file is gone or the sensor's position is not known for a point.
        """
        arrays_of = self._arrays()

        def read(row: int) -> FloatArray:
            arrays, own = arrays_of(row)
            return covariances_of(arrays, own, beams, self.units[int(self.table["type"][row])])

        return read

    def _arrays(self) -> Callable[[int], tuple[Mapping[str, NDArray[Any]], slice]]:
        """Reads the arrays of the block that holds a unit, and which of their points are the unit's, by its row; holds one file."""
        held: dict[int, Mapping[str, NDArray[Any]]] = {}

        def read(row: int) -> tuple[Mapping[str, NDArray[Any]], slice]:
            number, place = self.places[row]
            if number not in held:
                held.clear()
                held[number] = loaded_arrays(self.files[number])
            arrays = held[number]
            return arrays, slice(arrays["offsets"][place], arrays["offsets"][place + 1])

        return read


def unit_rows(epoch: EpochUnits, ids: Sequence[str]) -> list[Row]:
    """Rows of layer ``units`` in the frame of the cloud; ``ids`` names the units in the table's order."""
    table = epoch.table
    fitted = "covariance" in table
    rows = []
    for k in range(len(epoch)):
        pose = epoch.pose(k)
        unit = epoch.units[int(table["type"][k])]
        radius, gradient = (float(v) for v in table["shape"][k]) if fitted else (unit.radius, unit.gradient)
        qx, qy, qz, qw = (float(v) for v in pose.quaternion())
        row: dict[str, Any] = {
            "unit_id": ids[k],
            "epoch": epoch.plan.epoch.label,
            "epoch_time": epoch.plan.epoch.time,
            "unit_type": unit.name,
            "height": unit.height,
            "r0": radius,
            "gradient": gradient,
            "qx": qx,
            "qy": qy,
            "qz": qz,
            "qw": qw,
            "legs_visible": table["legs_visible"][k],
            "coverage": table["coverage"][k],
            "score": table["score"][k],
            "supported": table["supported"][k],
            "status": str(table["status"][k]),
            "geometry": pose.centre,
        }
        if fitted and np.isfinite(table["covariance"][k]).all():
            row |= covariance_fields(table["covariance"][k]) | {name: table[name][k] for name in ("sigma0", "n_points", "distance_median")}
        rows.append(row)
    return rows


def covariance_fields(covariance: FloatArray) -> dict[str, Any]:
    """Fields of ``units`` that follow from the (8, 8) covariance."""
    variances = np.clip(np.diag(covariance), 0, None)
    return {
        "sd_e": math.sqrt(variances[0]),
        "sd_n": math.sqrt(variances[1]),
        "sd_h": math.sqrt(variances[2]),
        "sd_rotation_deg": math.degrees(math.sqrt(variances[3:6].sum())),
        "covariance": upper_triangle(covariance),
    }


def feature_rows(
    unit_id: str, epoch: str, time: Any, pose: Pose, unit: UnitType, covariance: FloatArray | None, observed: Sequence[bool | None]
) -> list[Row]:
    """Rows of layer ``feature_points`` of one unit."""
    points = feature_points(pose, unit, covariance)
    rows = []
    for k, name in enumerate(FEATURES):
        row: dict[str, Any] = {
            "unit_id": unit_id,
            "epoch": epoch,
            "epoch_time": time,
            "feature": name,
            "observed": observed[k],
            "geometry": points.positions[k],
        }
        if covariance is not None:
            c = points.covariances[k]
            sds = np.sqrt(np.clip(np.diag(c), 0, None))
            row |= {"sd_e": sds[0], "sd_n": sds[1], "sd_h": sds[2], "cov_en": c[0, 1], "cov_eh": c[0, 2], "cov_nh": c[1, 2]}
        rows.append(row)
    return rows


def epoch_row(plan: EpochPlan, record: RunRecord, registration: Registration | None, extra: Mapping[str, Any]) -> dict[str, Any]:
    """Row of layer ``epochs``; no registration means that the cloud's own frame was kept and nothing was tied to it."""
    reference = None if registration is None else registration.reference
    if reference is not None:
        datum = "stable areas"
    else:
        datum = "control" if registration is not None and registration.residuals else "cloud"
    return {
        "label": plan.epoch.label,
        "time": plan.epoch.time,
        "tiles": json.dumps([tile.path.name for tile in plan.tiles]),
        "points": plan.points,
        "transformation": None if registration is None else json.dumps(registration.transformation.as_record()),
        "sigma0": None if registration is None else registration.sigma0,
        "datum": datum,
        "reference_epoch": reference,
        "software": f"tetratrack {software_version()}",
        "settings": record.of_epoch(plan.epoch, extra),
    }


def control_rows(epoch: str, registration: Registration) -> list[Row]:
    """Rows of layer ``control_residuals``."""
    return [
        {
            "point_id": r.point_id,
            "epoch": epoch,
            "ve": r.residual[0],
            "vn": r.residual[1],
            "vh": r.residual[2],
            "w_max": r.w_max,
            "used": r.used,
            "outlier": r.outlier,
            "geometry": r.position,
        }
        for r in registration.residuals
    ]


def provisional_ids(count: int) -> list[str]:
    """Names of units in order of easting, where no other epoch says otherwise."""
    return [f"U{k + 1:04d}" for k in range(count)]


def fitted_feature_rows(epoch: EpochUnits, row: int, unit_id: str) -> list[Row]:
    table = epoch.table
    covariance = table["covariance"][row]
    known = bool(np.isfinite(covariance).all())
    unit = epoch.units[int(table["type"][row])].with_shape(*table["shape"][row])
    return feature_rows(
        unit_id,
        epoch.plan.epoch.label,
        epoch.plan.epoch.time,
        epoch.pose(row),
        unit,
        covariance if known else None,
        [bool(v) for v in table["observed"][row]],
    )
