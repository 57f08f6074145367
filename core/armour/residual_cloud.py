"""Points less blocks: the cloud of an epoch with each point's distance to the nearest fitted unit, as LAZ."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..common.arrays import FloatArray, IntArray
from ..common.atomic_files import write_whole
from ..common.errors import InputError, OutputError
from ..common.output_files import check_ending, check_own, check_targets
from ..data.crs import LOCAL, parse_crs
from ..model.tetrapod import distance_to_surface
from ..review.point_index import index_of
from .as_built import AsBuilt, of_height, read_as_built
from .contacts import reach_of

FULL_COLOUR, NEAR, SEARCHED = 0.10, 0.05, 0.5
"""Distance at which the colours end, up to which a point lies on a unit, and beyond a unit's reach to which points are held against it:
metres, of units of usual size (:func:`.as_built.of_height`)."""
FAR = 10.0
"""Distance in metres written for points near no unit."""
INSIDE, ON, OUTSIDE = (33, 102, 172), (247, 247, 247), (178, 24, 43)
"""Colours inside a body, on its surface and outside: the diverging scale RdBu of ColorBrewer, readable by the colour-blind."""
MOST_SCALE, SCALE_HEIGHTS = 1e-3, 1e-3
"""Steps of the coordinates, metres and heights H: a power of ten."""
_WHAT = "to the nearest unit, metres"
"""Description of the dimension ``distance``, by which a file of this kind is known."""


@dataclass(frozen=True, kw_only=True)
class ResidualCloud:
    """What was written: points, those on a unit (``NEAR``), and the median absolute distance of these, metres."""

    points: int
    near: int
    median: float


def write_residual_cloud(result: Path, output: Path, epoch: str | None = None) -> ResidualCloud:
    """Write the points around the units of an epoch with the dimensions ``distance`` (metres, positive outside) and ``unit`` (its place in
    the list of units by name, 0 for none), coloured by distance: blue within a body, white on it, red outside.

    Points are those of the index beside the result (``tetratrack unit-points``), in the control frame.

    Raises
    ------
    InputError
        The result cannot be read, has no such epoch, or no index of points that belongs to what it is now.
    OutputError
        The file cannot be written, or is another one than an earlier output of this kind.
    """
    check_ending(output, (".laz", ".las"))
    if not output.parent.is_dir():
        raise OutputError("cannot be written (its folder does not exist)", source=output, remedy="Choose a folder that exists.")
    check_targets([(output, "the points")], [result])
    check_own(output, ("LASF", _WHAT))
    model = read_as_built(result, epoch)
    index = index_of(result)
    if model.epoch not in index.epochs:
        raise InputError(f"holds no points of {model.epoch}", source=index.folder, remedy="Build it again with tetratrack unit-points.")
    parts = [(points, *distances(points, model)) for points in index.clouds(model.epoch)]
    points = np.vstack([np.empty((0, 3)), *(part for part, _, _ in parts)])
    distance = np.concatenate([np.empty(0), *(part for _, part, _ in parts)])
    number = np.concatenate([np.empty(0, dtype=np.int64), *(part for _, _, part in parts)])
    write_whole(output, _las(points, distance, number, model, compressed=output.suffix.lower() == ".laz"))
    near = np.abs(distance) < of_height(NEAR, model.height)
    return ResidualCloud(
        points=len(points), near=int(near.sum()), median=float(np.median(np.abs(distance[near]))) if near.any() else float("nan")
    )


def distances(points: FloatArray, model: AsBuilt) -> tuple[FloatArray, IntArray]:
    """(n,) distance of points (n, 3) to the nearest unit, metres, positive outside (``FAR`` where none is near), and its number from 1."""
    from scipy.spatial import cKDTree

    distance, number = np.full(len(points), FAR), np.zeros(len(points), dtype=np.int64)
    if not len(points):
        return distance, number
    reduced = points - model.offset
    tree = cKDTree(reduced)
    searched = of_height(SEARCHED, model.height)
    for k, unit in enumerate(model.units, start=1):
        own = np.array(tree.query_ball_point(unit.shape.centre - model.offset, reach_of(unit.shape) + searched), dtype=np.int64)
        if not len(own):
            continue
        body = (points[own] - unit.shape.centre) @ unit.shape.rotation
        kind = model.solids[unit.solid].unit.with_shape(unit.shape.radius, unit.shape.gradient)
        found = distance_to_surface(body, kind)
        # deep within one body counts more than just outside of another
        nearer = np.abs(found) < np.abs(distance[own])
        distance[own[nearer]], number[own[nearer]] = found[nearer], k
    return distance, number


def colours(distance: FloatArray, end: float) -> FloatArray:
    """(n, 3) red, green, blue, 0 to 255, of distances; the colours end at that of ``end`` metres."""
    share = np.clip(np.abs(distance) / end, 0, 1)[:, None]
    last = np.where((distance < 0)[:, None], np.array(INSIDE), np.array(OUTSIDE))
    return np.asarray(np.round((1 - share) * np.array(ON) + share * last))


def _las(points: FloatArray, distance: FloatArray, number: IntArray, model: AsBuilt, *, compressed: bool) -> bytes:
    import io

    import laspy

    header = laspy.LasHeader(point_format=7, version="1.4")
    header.scales = np.full(3, min(MOST_SCALE, 10.0 ** math.floor(math.log10(SCALE_HEIGHTS * model.height))))
    header.offsets = np.floor(points.min(axis=0)) if len(points) else np.zeros(3)
    header.add_extra_dim(laspy.ExtraBytesParams(name="distance", type=np.float32, description=_WHAT))
    header.add_extra_dim(laspy.ExtraBytesParams(name="unit", type=np.uint32, description="number of that unit, 0: none"))
    if model.crs.text != LOCAL:
        header.add_crs(parse_crs(model.crs.text))
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = points.T
    cloud.distance, cloud.unit = distance.astype(np.float32), number.astype(np.uint32)
    cloud.red, cloud.green, cloud.blue = (257 * colours(distance, of_height(FULL_COLOUR, model.height))).astype(np.uint16).T
    stream = io.BytesIO()
    cloud.write(stream, do_compress=compressed)
    return stream.getvalue()
