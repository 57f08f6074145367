"""Steps that work on earlier results alone: compare with check points, register views."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.atomic_files import replace_durably, temporary_beside
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..common.output_files import check_ending, check_own, check_targets
from ..model.unit_types import UnitType
from ..results.geopackage_reader import read_given_rows
from ..results.geopackage_writer import check_output, write_result
from .unit_input import crs_of_layer

if TYPE_CHECKING:
    import laspy

MERGED = "tetratrack views"
"""Software that merged clouds name, by which they are known."""


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

    Raises
    ------
    InputError
        A file cannot be used, no check point lies at a feature point, or no pick is of a check point; nothing is written then.
    """
    from ..deformation.validation import check_residuals, read_check, read_picks, residual_rows, summarise

    check_targets([(output, "the result")], [features, check, *([] if picks is None else [picks])])
    by_epoch, crs = _read_features(features)
    check_output(output, crs, step=("check_residuals",))
    if not by_epoch:
        raise InputError(
            "holds no feature points, so there is nothing to compare",
            source=features,
            remedy="No unit was found in these tiles: look at them with the inspection of tiles, and at height and type of the unit.",
        )
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
    lengths = [r.length for r in residuals if r.difference is not None]
    if not lengths:
        raise InputError("matches no feature point", source=check, remedy="Check the CRS, and that the epoch is the right one.")
    by_hand = {} if picks is None else read_picks(picks)
    away = [float(np.linalg.norm(by_hand[key] - r.position)) for r in residuals if (key := (r.point_id, label)) in by_hand]
    if picks is not None and not away:
        epochs = ", ".join(dict.fromkeys(epoch for _, epoch in by_hand)) or "none"
        raise InputError(f"holds no check point of epoch {label}", source=picks, remedy=f"It holds points of: {epochs}.")
    write_result(output, crs, {"check_residuals": residual_rows(residuals)})
    found: dict[str, Any] = {"output": str(output), "points": len(lengths), "rmse": math.sqrt(sum(v**2 for v in lengths) / len(lengths))}
    fitted = summarise(lengths)
    feedback.info(
        f"{fitted.count} of {len(residuals)} check points: mean {1000 * fitted.mean_absolute:.1f} mm, "
        f"largest {1000 * fitted.maximum:.1f} mm"
    )
    if away:
        manual = summarise(away)
        feedback.info(f"{manual.count} manual picks: mean {1000 * manual.mean_absolute:.1f} mm, largest {1000 * manual.maximum:.1f} mm")
        found |= {"manual_mean": manual.mean_absolute, "manual_maximum": manual.maximum}
    return found


def run_register_views(views: Sequence[Path], output: Path, voxel: float | None, feedback: Feedback) -> dict[str, Any]:
    """Step ``register-views``: overlapping clouds in one LAZ file in the frame and CRS of the first; the point source ID is the view.

    Raises
    ------
    InputError
        A view cannot be read, the voxels have no size, or the views do not hang together or state a CRS where the first states none.
    OutputError
        The file cannot be written, is neither .laz nor .las, or is another one than an earlier output of this step.
    """
    import laspy

    from ..data.crs import parse_crs
    from ..data.tiles import inspect_tile, read_points
    from ..registration.views import register_views

    check_ending(output, (".laz", ".las"))
    if voxel is not None and not 0 < voxel < math.inf:
        raise InputError(f"voxels of {voxel:g} m have no size", where="voxel", remedy="Give the length of their edges in metres, or none.")
    check_targets([(output, "the merged cloud")], views)
    check_own(output, ("LASF", MERGED))
    clouds = []
    origin: FloatArray | None = None
    crs, definition = "", ""
    for number, path in enumerate(views):
        feedback.check()
        feedback.progress(0.3 * number / len(views), f"reading {path.name}")
        tile = inspect_tile(path, None)
        if number == 0:
            crs, definition = tile.crs, tile.definition
        elif tile.crs and not crs:
            problem = f"is in {tile.crs}, and the first view, {views[0].name}, states no CRS"
            raise InputError(problem, source=path, remedy="Give a view that states it first, or write it into the header of all.")
        cloud = read_points([tile], crs or "LOCAL", origin=origin)
        origin = cloud.origin
        clouds.append(cloud.xyz)
    feedback.progress(0.3, "registering views")
    result = register_views(clouds, voxel=voxel, is_cancelled=feedback.is_cancelled)
    feedback.check()
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.generating_software = MERGED
    header.offsets = np.zeros(3) if origin is None else origin
    header.scales = np.full(3, 1e-5)
    if definition:
        header.add_crs(parse_crs(definition))
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


def _read_features(path: Path) -> tuple[dict[str, dict[str, dict[str, FloatArray]]], str]:
    """Epoch to unit_id to feature to (3,) position, and the layer's CRS."""
    found: dict[str, dict[str, dict[str, FloatArray]]] = {}
    for row in read_given_rows(path, "feature_points", ("unit_id", "epoch", "feature")):
        if row.get("geom") is not None and row["geom"].shape == (3,):
            found.setdefault(row["epoch"], {}).setdefault(row["unit_id"], {})[row["feature"]] = row["geom"]
    return found, crs_of_layer(path, "feature_points")
