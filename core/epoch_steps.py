"""Steps that work on earlier results alone: track units between epochs, compare with check points, register views."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .control import Transformation, transformation_of
from .displacement import grades_from
from .errors import InputError
from .feedback import Feedback
from .fitted_unit import FittedUnit
from .gap_rows import gap_rows
from .geopackage import check_output, from_upper_triangle, replace_durably, temporary_beside, write_result
from .pose import Pose
from .quality import state_quality
from .survey import SECTIONS
from .tracking import TrackedEpoch, track
from .tracking_tables import TableOptions, displacement_rows, pair_rows, unit_names, unit_tables, velocity_rows
from .unit_clouds import UnitCloud
from .unit_layer import crs_of_layer, read_units
from .unit_types import UnitType

if TYPE_CHECKING:
    import laspy

FloatArray = NDArray[np.float64]
FROM_FIT = ("legs_visible", "coverage", "score", "sigma0", "n_points", "distance_median", "supported")
"""Fields of ``units`` that tracking takes over."""
NOT_FITTED = "Give a result of tetratrack fit."


def run_track(units: Path, registrations: Sequence[Path], output: Path, feedback: Feedback) -> dict[str, Any]:
    """Step ``track``: identity, datum and displacements from fitted units alone.

    Without points there is no joint adjustment of strips and no look-up of missing units, so that ``run`` is the better way where the
    tiles are at hand.

    Parameters
    ----------
    units
        Layer ``units`` of several epochs with covariance, each in the frame of its cloud.
    registrations
        GeoPackages of the step ``register``.
    output
        Result to write.
    feedback
        Messages and cancelling.
    """
    check_output(output)
    rows = [row for row in read_units(units) if row["geometry"] is not None]
    labels = sorted({str(row["epoch"]) for row in rows}, key=lambda label: _time_of(rows, label, units))
    if len(labels) < 2:
        raise InputError(f"holds {len(labels)} epoch", source=units, remedy="Give the units of at least two epochs.")
    transformations, references = _transformations(registrations)
    for label in labels:
        if label not in transformations:
            feedback.info(f"{label}: no registration, its cloud's frame is taken as registered")
    origin: FloatArray = np.round(np.array([row["geometry"] for row in rows], dtype=np.float64).mean(axis=0))
    kinds = _kinds(rows, units)
    fits = {label: [row for row in rows if row["epoch"] == label] for label in labels}
    epochs = [
        _fitted_epoch(label, _time_of(rows, label, units), fits[label], transformations.get(label), kinds, origin, units)
        for label in labels
    ]
    # where the epoch it was tied to has no units here, its error counts as the epoch's own
    epochs = [
        replace(epoch, tied_to=labels.index(references[epoch.label])) if references.get(epoch.label) in labels else epoch
        for epoch in epochs
    ]
    types = list(kinds.values())
    result = track(epochs, types)
    names = unit_names(len(result.units))
    limits = {name: key.default for name, key in SECTIONS["displacement"].items()}
    options = TableOptions((float(origin[0]), float(origin[1]), float(origin[2])), limits["significance"], grades_from(limits))

    def from_fit(epoch: int, row: int | None) -> Mapping[str, Any]:
        if row is None:
            return {}
        known = fits[labels[epoch]][row]
        return {name: known.get(name) for name in FROM_FIT}

    unit_rows, points = unit_tables(result, epochs, types, names, origin, from_fit)
    moved, other = displacement_rows(result, epochs, types, names, options)
    feedback.check()
    gaps = gap_rows(unit_rows, [(epoch.label, epoch.time) for epoch in epochs], types)
    state_quality(unit_rows, types, labels, feedback)
    tables = {
        "units": unit_rows,
        "gaps": gaps,
        "feature_points": points,
        "displacements": moved,
        "displacements_other": other,
        "epoch_pairs": pair_rows(result, epochs, origin),
        "velocities": velocity_rows(result, epochs, names, origin),
    }
    write_result(output, crs_of_layer(units), tables)
    return {
        "output": str(output),
        "units": len(names),
        "displacements": len(moved),
        "moved": len({row["unit_id"] for row in moved if row["class"] == "moved"}),
    }


def run_validate(features: Path, check: Path, picks: Path | None, epoch: str | None, output: Path, feedback: Feedback) -> dict[str, Any]:
    """Step ``validate``: feature points of one epoch less surveyed check points.

    Parameters
    ----------
    features
        GeoPackage with the layer ``feature_points``.
    check
        CSV of check points.
    picks
        CSV of manual picks, compared in the same way; None for none.
    epoch
        Label; None where the layer holds a single epoch.
    output
        Result with the layer ``check_residuals``.
    feedback
        Messages and cancelling.
    """
    from .validation import check_residuals, read_check, read_picks, residual_rows, summarise

    check_output(output)
    by_epoch, crs = _read_features(features)
    if epoch is None and len(by_epoch) != 1:
        raise InputError(
            f"holds epochs {', '.join(by_epoch)}", source=features, remedy="Name the one the check points belong to (--epoch)."
        )
    label = epoch if epoch is not None else next(iter(by_epoch))
    if label not in by_epoch:
        raise InputError(f"has no epoch {label!r}", source=features, remedy=f"Epochs: {', '.join(by_epoch)}.")
    points = by_epoch[label]
    # a joint lies 0.264 H from the centre in a standard tetrapod
    arms = [
        float(np.linalg.norm(own[name] - own["centre"])) for own in points.values() if "centre" in own for name in own if name != "centre"
    ]
    if not arms:
        raise InputError(
            "holds no unit with centre and joints", source=features, remedy="Give a result of tetratrack features, fit or run."
        )
    residuals = check_residuals(read_check(check), points, float(np.median(arms)) / UnitType.tetrapod(1.0).crotch_distance, label)
    write_result(output, crs, {"check_residuals": residual_rows(residuals)})
    lengths = [r.length for r in residuals if r.difference is not None]
    if not lengths:
        raise InputError("matches no feature point", source=check, remedy="Check the CRS, and that the epoch is the right one.")
    found: dict[str, Any] = {"output": str(output), "points": len(lengths), "rmse": math.sqrt(sum(v**2 for v in lengths) / len(lengths))}
    fitted = summarise(lengths)
    feedback.info(
        f"{fitted.count} of {len(residuals)} check points: mean {1000 * fitted.mean_absolute:.1f} mm, "
        f"largest {1000 * fitted.maximum:.1f} mm"
    )
    if picks is not None:
        by_hand = read_picks(picks)
        manual = summarise([float(np.linalg.norm(by_hand[key] - r.position)) for r in residuals if (key := (r.point_id, label)) in by_hand])
        feedback.info(f"{manual.count} manual picks: mean {1000 * manual.mean_absolute:.1f} mm, largest {1000 * manual.maximum:.1f} mm")
        found |= {"manual_mean": manual.mean_absolute, "manual_maximum": manual.maximum}
    return found


def run_register_views(views: Sequence[Path], output: Path, voxel: float | None, feedback: Feedback) -> dict[str, Any]:
    """Step ``register-views``: several overlapping clouds in one LAZ file in the frame of the first; the point source ID is the view.

    Raises
    ------
    InputError
        A view cannot be read, or the views do not hang together.
    """
    import laspy

    from .tiles import inspect_tile, read_points
    from .views import register_views

    clouds = []
    origin: FloatArray | None = None
    crs = ""
    for number, path in enumerate(views):
        feedback.check()
        feedback.progress(0.3 * number / len(views), f"reading {path.name}")
        tile = inspect_tile(path, None)
        crs = crs or tile.crs
        cloud = read_points([tile], crs or "LOCAL", origin=origin)
        origin = cloud.origin
        clouds.append(cloud.xyz)
    feedback.progress(0.3, "registering views")
    result = register_views(clouds, voxel=voxel, is_cancelled=feedback.is_cancelled)
    feedback.check()
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.offsets = np.zeros(3) if origin is None else origin
    header.scales = np.full(3, 1e-5)
    merged = laspy.LasData(header)
    moved = [points @ motion[:3, :3].T + motion[:3, 3] + header.offsets for points, motion in zip(clouds, result.motions, strict=True)]
    merged.x, merged.y, merged.z = np.vstack(moved).T
    merged.point_source_id = np.repeat(np.arange(1, len(clouds) + 1, dtype=np.uint16), [len(points) for points in clouds])
    merged.return_number[:] = 1
    merged.number_of_returns[:] = 1
    _write_las(merged, output)
    return {"output": str(output), "views": len(clouds), "rmse": result.rmse}


def _write_las(merged: laspy.LasData, output: Path) -> None:
    target = output.absolute()
    with temporary_beside(target) as temporary:
        with temporary.open("wb") as stream:
            merged.write(stream, do_compress=target.suffix.lower() == ".laz")
        replace_durably(temporary, target)


def _time_of(rows: Sequence[Mapping[str, Any]], label: str, source: Path) -> datetime:
    value = next(row.get("epoch_time") for row in rows if row["epoch"] == label)
    if isinstance(value, np.datetime64):
        value = value.astype("datetime64[ms]").item()
    if not isinstance(value, datetime):
        raise InputError(f"epoch {label!r} has no epoch_time", source=source, remedy=NOT_FITTED)
    return value if value.tzinfo is not None else value.replace(tzinfo=UTC)


def _transformations(registrations: Sequence[Path]) -> tuple[dict[str, Transformation], dict[str, str]]:
    """Transformations, and the labels of the epochs that some were tied to on stable areas, by epoch label."""
    from .result_tables import read_layer_rows

    found, references = {}, {}
    for path in registrations:
        for row in read_layer_rows(path, "epochs"):
            known = transformation_of(json.loads(row.get("transformation") or "{}"))
            if known is not None:
                found[str(row["label"])] = known
            if row.get("reference_epoch"):
                references[str(row["label"])] = str(row["reference_epoch"])
    return found, references


def _kinds(rows: Sequence[Mapping[str, Any]], source: Path) -> dict[str, UnitType]:
    """Geometry by name of the type of unit, with the median shape of its fits."""
    kinds = {}
    for name in dict.fromkeys(str(row.get("unit_type") or "tetrapod") for row in rows):
        own = [row for row in rows if str(row.get("unit_type") or "tetrapod") == name]
        values = [[row.get(field) for field in ("height", "r0", "gradient")] for row in own]
        if any(v is None for row in values for v in row):
            raise InputError("layer units has no height, r0 or gradient", source=source, remedy=NOT_FITTED)
        height, radius, gradient = np.median(np.array(values, dtype=np.float64), axis=0)
        kinds[name] = UnitType.tetrapod(float(height), radius=float(radius), gradient=float(gradient), name=name)
    return kinds


def _fitted_epoch(
    label: str,
    time: datetime,
    rows: Sequence[Mapping[str, Any]],
    registration: Transformation | None,
    kinds: Mapping[str, UnitType],
    origin: FloatArray,
    source: Path,
) -> TrackedEpoch:
    transformation = Transformation.identity(origin) if registration is None else registration
    names = list(kinds)
    found = []
    for row in rows:
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        if not row.get("covariance"):
            raise InputError(f"unit {row.get('unit_id')} has no covariance", source=source, remedy=NOT_FITTED)
        turn = np.kron(np.eye(2), transformation.rotation)
        covariance = turn @ from_upper_triangle(row["covariance"])[:6, :6] @ turn.T
        kind = names.index(str(row.get("unit_type") or "tetrapod"))
        found.append(
            FittedUnit(
                transformation.apply_pose(pose).shifted(-origin), kinds[names[kind]], kind, row.get("status") != "uncertain",
                np.zeros(4, dtype=np.bool_), UnitCloud.none(), covariance,
            )
        )  # fmt: skip
    placed = None if registration is None else replace(registration, origin_to=registration.origin_to - origin)
    return TrackedEpoch(label, time, tuple(found), placed)


def _read_features(path: Path) -> tuple[dict[str, dict[str, dict[str, FloatArray]]], str]:
    """Epoch to unit_id to feature to (3,) position, and the layer's CRS."""
    import pyogrio
    import shapely
    from pyogrio.errors import DataLayerError, DataSourceError

    try:
        meta, _, geometry, columns = pyogrio.raw.read(path, layer="feature_points")
    except (DataSourceError, DataLayerError) as error:
        raise InputError(
            "has no readable layer feature_points", source=path, remedy="Give a result of tetratrack features, fit or run."
        ) from error
    table = dict(zip(meta["fields"], columns, strict=True))
    missing = [name for name in ("unit_id", "epoch", "feature") if name not in table]
    if missing:
        raise InputError(f"layer feature_points has no field {', '.join(missing)}", source=path, remedy="Give a result of tetratrack.")
    found: dict[str, dict[str, dict[str, FloatArray]]] = {}
    shapes = shapely.from_wkb(geometry)
    for unit, epoch, feature, shape in zip(table["unit_id"], table["epoch"], table["feature"], shapes, strict=True):
        if shape is not None and not shape.is_empty:
            position = shapely.get_coordinates(shape, include_z=True)[0]
            found.setdefault(str(epoch), {}).setdefault(str(unit), {})[str(feature)] = position
    return found, str(meta["crs"] or "LOCAL")
