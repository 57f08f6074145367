"""What is done in one block: find the units, and adjust each to its points. Results are arrays that depend on files alone."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray, IntArray
from ..common.errors import InputError, NoSolutionError
from ..data.survey import Ring, SurveyUnit, inside
from ..data.tiles import PointCloud, Window, read_points
from ..data.trajectory import BeamNoise
from ..model.mould import Mould, onto_cones
from ..model.pose import Pose
from ..model.tetrapod import END_DISC, distance_to_surface, raise_means
from ..model.unit_types import UnitType
from .array_files import Arrays, load_arrays
from .block_clouds import NOT_KEPT, BlockClouds
from .blocks import HALO_HEIGHTS, MARGIN_HEIGHTS, Block
from .given_units import GivenUnit, place_given
from .job_runner import job_key

if TYPE_CHECKING:
    from ..adjustment.adjustment_records import Adjustment, AdjustmentOptions

SAME_UNIT_HEIGHTS = 0.4
"""Two found units whose centres are nearer than this are one unit: solid tetrapods cannot come nearer than about 0.5 H."""
NEAR_FEATURE_HEIGHTS = 0.15
"""A feature point counts as observed if each of its legs holds points this near to it."""
OBSERVED_CENTRE_COVERAGE = 0.05
RADIUS_TOLERANCE, GRADIENT_TOLERANCE = 0.01, 0.01
"""Standard deviation of a unit's radius (relative) and gradient about the nominal shape, as prior observations."""
NEARBY_HEIGHTS = 0.25
"""An adjustment that moves the centre farther has found something else: segmented poses are good to a few hundredths."""
DISC_USES: tuple[bool | Literal["auto"], ...] = ("auto", True)
"""How end discs are used by an adjustment, and by the next one if that finds something else."""
ROUGHNESS_RATIO = 0.0015
"""Standard deviation of a unit's surface about its four cones as a share of its height, where beams are known: 3.5 mm at 2.3 m."""


@dataclass(frozen=True, kw_only=True)
class SegmentJob:
    """Find the units of one block.

    Attributes
    ----------
    block
        Where; units centred in its core, or just outside, are reported.
    survey_crs, tiles_crs
        As in survey.toml.
    units
        Types of unit to look for.
    seed
        Of the random draws.
    checksums
        Of the block's tiles.
    given
        Units that are known already; None looks for units.
    timed
        Keep the GPS time of the units' points, by which a trajectory is read.
    clouds
        Where the block's points are kept for later jobs.
    """

    block: Block
    survey_crs: str
    tiles_crs: str | None
    units: tuple[SurveyUnit, ...]
    seed: int
    checksums: tuple[str, ...]
    given: tuple[GivenUnit, ...] | None = None
    timed: bool = False
    clouds: BlockClouds = NOT_KEPT

    @property
    def name(self) -> str:
        """File name of the result."""
        settings = {
            "crs": self.survey_crs,
            "tiles_crs": [self.tiles_crs, *sorted({tile.crs for tile in self.block.tiles})],
            "thinned": sorted({(repr(tile.patch), tile.means) for tile in self.block.tiles if tile.thinned}),
            "trimmed": sorted(repr((tile.low, tile.high)) for tile in self.block.tiles if tile.strays),
            "strips": sorted({repr(tile.strip_starts) for tile in self.block.tiles}),
            "core": [repr(v) for v in (self.block.core.west, self.block.core.south, self.block.core.east, self.block.core.north)],
            "units": repr(self.units),
            "seed": self.seed,
            "given": self.given,
            "timed": self.timed,
        }
        return f"segment-{job_key('segment', settings, self.checksums)}.npz"

    def run(self) -> Arrays:
        """Arrays of the block's units: see :func:`unit_arrays`."""
        height = max(unit.type.height for unit in self.units)
        window = self.block.core.grown(HALO_HEIGHTS * height)
        cloud = read_points(self.block.tiles, self.survey_crs, window=window)
        self.clouds.keep(self.block, window, cloud)
        if self.given is None:
            found = [_found(cloud, k, unit, self.seed) for k, unit in enumerate(self.units)]
            table, labels = _best_types(found, self.units)
        else:
            table, labels = _given(cloud, self.given, self.units)
        margin = self.block.core.grown(MARGIN_HEIGHTS * height)
        keep = margin.contains(table["poses"][:, :3] + cloud.origin)
        kept = {name: values[keep] for name, values in table.items()}
        kept |= _leg_ends(cloud, kept, [unit.type for unit in self.units])
        if cloud.spread is not None:
            cloud = replace(cloud, xyz=_raised(cloud, table, labels, self.units))
        return unit_arrays(cloud, kept, labels, np.flatnonzero(keep), timed=self.timed)


@dataclass(frozen=True)
class FitJob:
    """Adjust units of one block to their points.

    Attributes
    ----------
    segmented
        Result of the block's :class:`SegmentJob`.
    rows
        Which of its units.
    units
        Geometry by type, calibrated where that was asked for.
    shape_sds
        By type, standard deviations of radius (metres) and gradient as prior observations; 0 holds the shape.
    beams
        Noise of ranges and angles with the sensor's positions; None for equal noise in all directions.
    moulds
        By type, the mould that is held, or None; empty for none of any.
    """

    segmented: Path
    rows: tuple[int, ...]
    units: tuple[UnitType, ...]
    shape_sds: tuple[tuple[float, float], ...]
    beams: BeamNoise | None = None
    moulds: tuple[Mould | None, ...] = ()

    @property
    def name(self) -> str:
        """File name of the result."""
        settings: dict[str, Any] = {"rows": self.rows, "units": repr(self.units), "sds": repr(self.shape_sds), "moulds": repr(self.moulds)}
        inputs = [self.segmented.name]
        if self.beams is not None:
            settings["beams"] = [repr(self.beams.range_sd), repr(self.beams.angle_sd)]
            inputs += self.beams.checksums
        return f"fit-{job_key('fit', settings, inputs)}.npz"

    def run(self) -> Arrays:
        """Arrays of the units with their adjustment, points included.

        ``source_ids[source_offsets[i]:source_offsets[i + 1]]`` are the strips or stations that see unit i, ascending, so that nobody
        reads its points to know them.
        """
        from ..adjustment.adjustment_records import AdjustmentOptions

        source = load_arrays(self.segmented)
        if source is None:
            raise InputError("is missing or damaged", source=self.segmented, remedy="Run again; finished blocks are kept with --resume.")
        table = {name: source[name][list(self.rows)] for name in (*SEGMENT_COLUMNS, *LEG_COLUMNS)}
        count = len(self.rows)
        table |= _not_adjusted(count)
        parts, sources = [], []
        for k, row in enumerate(self.rows):
            own = slice(source["offsets"][row], source["offsets"][row + 1])
            points = source["points"][own]
            kind = int(table["type"][k])
            unit = self.units[kind]
            table["shape"][k] = unit.radius, unit.gradient
            options = AdjustmentOptions(radius_sd=self.shape_sds[kind][0], gradient_sd=self.shape_sds[kind][1])
            used = kept = np.ones(len(points), dtype=np.bool_)
            covariances = None
            if self.beams is not None:
                covariances = covariances_of(source, own, self.beams, unit)
            start = Pose.of_row(table["poses"][k])
            mould = self.moulds[kind] if self.moulds else None
            on_cones = points if mould is None else onto_cones(points, start.rotation, start.centre, unit, mould)
            try:
                result = adjusted_nearby(on_cones, unit, start, options, covariances)
            except NoSolutionError:
                # too little is seen of it for an adjustment: it stays as segmented, as uncertain evidence without covariance
                table["status"][k] = "uncertain"
            else:
                used = result.weights > 0
                pose = result.pose
                on_disc = used & (result.parts == END_DISC)
                if result.legs_visible == 1:
                    leg = int(np.argmax(np.bincount(result.legs[used])))
                    # the few points that chance puts on the sides of other legs would settle a twist that nothing shows; end discs show it
                    kept = (result.legs == leg) | on_disc
                    if not on_disc[result.legs != leg].any():  # room among its neighbours settled its twist: its points let it drift
                        pose = pose.twisted_as(Pose.of_row(table["poses"][k]), unit.leg_directions[leg])
                table["poses"][k] = pose.as_row()
                table["shape"][k] = result.radius, result.gradient
                table["covariance"][k] = result.covariance
                table["sigma0"][k], table["noise"][k], table["n_effective"][k] = result.sigma0, result.noise, result.n_effective
                table["converged"][k] = result.converged
                table["determined"][k] = len(result.undetermined) == 0
                table["legs_visible"][k] = result.legs_visible
                table["n_points"][k] = int(used.sum())
                table["distance_median"][k] = _median_distance(points[used], result.pose, result.unit(unit))
                table["observed"][k, 0] = table["coverage"][k] >= OBSERVED_CENTRE_COVERAGE
                table["observed"][k, 1:] = _joints_observed(points, result, pose, unit)
                table["discs"][k] = np.bincount(result.legs[on_disc], minlength=4) > 0
            parts.append(points[kept])
            sources.append(source["sources"][own][kept])
        ids = [np.unique(own) for own in sources]
        return table | {
            "origin": source["origin"],
            "points": np.concatenate(parts) if parts else np.empty((0, 3)),
            "sources": np.concatenate(sources) if sources else np.empty(0, np.uint16),
            "offsets": _offsets([len(own) for own in sources]),
            "source_ids": np.concatenate(ids) if ids else np.empty(0, np.uint16),
            "source_offsets": _offsets([len(own) for own in ids]),
        }


def _not_adjusted(count: int) -> dict[str, NDArray[Any]]:
    """Columns of an adjustment for units that have none."""
    return {
        "shape": np.zeros((count, 2)),
        "covariance": np.full((count, 8, 8), np.nan),
        "sigma0": np.full(count, np.nan),
        "noise": np.full(count, np.nan),
        "n_points": np.zeros(count, dtype=np.int64),
        "distance_median": np.full(count, np.nan),
        "n_effective": np.zeros(count),
        "observed": np.zeros((count, 5), dtype=np.bool_),
        "discs": np.zeros((count, 4), dtype=np.bool_),
        "converged": np.zeros(count, dtype=np.bool_),
        "determined": np.zeros(count, dtype=np.bool_),
    }


def _joints_observed(points: FloatArray, result: Adjustment, pose: Pose, unit: UnitType) -> list[bool]:
    """For each joint of three legs, whether all three have points next to it."""
    from ..model.feature_points import TRIPLES, body_features

    observed = []
    for place, triple in zip(pose.to_frame(body_features(result.unit(unit)))[1:], TRIPLES, strict=True):
        away = np.linalg.norm(points - place, axis=1)
        near = result.legs[(away < NEAR_FEATURE_HEIGHTS * unit.height) & (result.legs >= 0)]
        observed.append(set(triple) <= set(near.tolist()))
    return observed


def adjusted_nearby(
    points: FloatArray, unit: UnitType, pose: Pose, options: AdjustmentOptions, covariances: FloatArray | None
) -> Adjustment:
    """Adjustment of a unit that stays where the segmentation found it.

    Where little more than the end of a leg is seen, an approach without the end discs may turn to another surface.

    Raises
    ------
    NoSolutionError
        Too few points, or no solution near the pose.
    """
    from ..adjustment.gauss_helmert import adjust

    for end_discs in DISC_USES:
        try:
            result = adjust(points, unit, pose, options=replace(options, end_discs=end_discs), covariances=covariances)
        except NoSolutionError:
            continue
        if np.linalg.norm(result.pose.centre - pose.centre) < NEARBY_HEIGHTS * unit.height:
            return result
    raise NoSolutionError("no adjustment stays near the pose that was found", remedy="Check the points of the unit.")


SEGMENT_COLUMNS = ("poses", "type", "score", "coverage", "legs_visible", "status", "misfit", "supported", "twist_open")
"""Arrays of a block's units before adjustment, one row per unit."""
LEG_COLUMNS = ("leg_states", "leg_missing", "leg_broken", "leg_evidence")
"""What the cloud around each unit shows of the ends of its legs, (k, 4) each: see :class:`..segmentation.leg_ends.LegEnds`."""
POINT_ARRAYS = ("points", "sources", "times")
"""Arrays of a job with one row per point; all others are small."""
BLOCK_ARRAYS = ("origin", "offsets", "source_ids", "source_offsets")
"""Arrays without a row per unit or point."""


def unit_arrays(
    cloud: PointCloud, table: Mapping[str, NDArray[Any]], labels: IntArray, numbers: IntArray, *, timed: bool = False
) -> dict[str, NDArray[Any]]:
    """Arrays of units with their points, sorted by unit.

    Parameters
    ----------
    cloud
        Points of the block.
    table
        ``SEGMENT_COLUMNS``: ``poses`` (k, 12) reduced centre and row-major rotation, ``type`` index of the type, and so on.
    labels
        (n,) number of the unit of each point, or -1.
    numbers
        (k,) number of each row of the table.
    timed
        Keep GPS times too.

    Returns
    -------
    arrays
        The table, ``origin`` (3,), ``points`` (m, 3) reduced, ``sources`` (m,), ``times`` (m,) if asked for, and ``offsets`` (k + 1,):
        points of row i are ``points[offsets[i]:offsets[i + 1]]``.
    """
    rows = np.full(int(labels.max(initial=-1)) + 2, -1, dtype=np.int64)
    rows[numbers] = np.arange(len(numbers))
    row = rows[labels]
    mine = np.flatnonzero(row >= 0)
    mine = mine[np.argsort(row[mine], kind="stable")]
    sizes = np.bincount(row[mine], minlength=len(numbers))
    return {
        **table,
        "origin": cloud.origin,
        "points": cloud.xyz[mine],
        "sources": cloud.source_id[mine],
        **({"times": cloud.gps_time[mine]} if timed else {}),
        "offsets": _offsets(sizes),
    }


def covariances_of(arrays: Mapping[str, NDArray[Any]], own: slice, beams: BeamNoise, unit: UnitType) -> FloatArray:
    """(n, 3, 3) covariance of a unit's points, square metres.

    Parameters
    ----------
    arrays
        Arrays of the block's units, see :func:`unit_arrays`; ``times`` may be missing where no trajectory is read.
    own
        Which of the points are the unit's.
    beams
        Noise of ranges and angles with the sensor's positions.
    unit
        The unit's type: the roughness of its surface goes with its height.

    Raises
    ------
    InputError
        The sensor's position is not known for a point.
    """
    points = arrays["points"][own]
    times = arrays["times"][own] if "times" in arrays else np.zeros(len(points))
    return beams.covariances(points, arrays["origin"], arrays["sources"][own], times, ROUGHNESS_RATIO * unit.height)


def _leg_ends(cloud: PointCloud, table: Mapping[str, NDArray[Any]], units: Sequence[UnitType]) -> dict[str, NDArray[Any]]:
    """``LEG_COLUMNS`` of the units of a table, from all points around them."""
    from ..segmentation.ends_of_units import ends_of_units

    kinds, certain = np.asarray(table["type"]), np.asarray(table["status"]) == "found"
    found = ends_of_units(cloud.xyz, cloud.source_id, np.asarray(table["poses"]), kinds, certain, units)
    columns = ("states", "missing", "broken", "evidence")
    return {name: np.array([getattr(f, c) for f in found]).reshape(-1, 4) for name, c in zip(LEG_COLUMNS, columns, strict=True)}


def _raised(cloud: PointCloud, table: Mapping[str, NDArray[Any]], labels: IntArray, units: Sequence[SurveyUnit]) -> FloatArray:
    """(n, 3) points of a block of which some are means of others, these moved onto the surfaces of their units."""
    xyz, spread = cloud.xyz.copy(), np.asarray(cloud.spread)
    for k, row in enumerate(table["poses"]):
        own, unit = np.flatnonzero(labels == k), units[table["type"][k]].type
        xyz[own] = Pose.of_row(row).to_frame(raise_means(Pose.of_row(row).to_body(xyz[own]), spread[own], unit))
    return xyz


def _found(cloud: PointCloud, number: int, unit: SurveyUnit, seed: int) -> tuple[dict[str, NDArray[Any]], IntArray]:
    from ..segmentation.segment import segment

    near = np.arange(len(cloud))
    if unit.area is not None:
        corners = np.array(unit.area)
        reach = HALO_HEIGHTS * unit.type.height
        around = Window(*corners.min(axis=0).tolist(), *corners.max(axis=0).tolist()).grown(reach)
        near = np.flatnonzero(around.contains(cloud.xyz + cloud.origin))
    result = segment(cloud.xyz[near], unit.type, seed=seed, workers=1)
    table = _table(
        [u.pose.as_row() for u in result.units],
        [number] * len(result.units),
        [u.score for u in result.units],
        [u.coverage for u in result.units],
        [u.legs_visible for u in result.units],
        [u.status for u in result.units],
        [u.misfit for u in result.units],
        [u.supported for u in result.units],
    )
    table["twist_open"] = np.array([u.twist_open for u in result.units], dtype=np.bool_)
    labels = np.full(len(cloud), -1, dtype=np.int64)
    labels[near] = result.labels
    if unit.area is not None:
        labels = _only_inside(table, labels, unit.area, cloud.origin)
    return table, labels


def _only_inside(table: dict[str, NDArray[Any]], labels: IntArray, area: Ring, origin: FloatArray) -> IntArray:
    """Drop the units outside a type's area from the table; returns the labels of those that stay."""
    keep = np.array([inside(area, *(pose[:2] + origin[:2])) for pose in table["poses"]], dtype=np.bool_)
    number = np.append(np.where(keep, np.cumsum(keep) - 1, -1), -1)
    for name in table:
        table[name] = table[name][keep]
    return np.asarray(number[labels], dtype=np.int64)


def _best_types(
    found: Sequence[tuple[dict[str, NDArray[Any]], IntArray]], units: Sequence[SurveyUnit]
) -> tuple[dict[str, NDArray[Any]], IntArray]:
    """Units of several types compete for their place: the better supported one stays."""
    if len(found) == 1:
        return found[0]
    table = {name: np.concatenate([t[name] for t, _ in found]) for name in SEGMENT_COLUMNS}
    shift = np.concatenate([[0], np.cumsum([len(t["type"]) for t, _ in found])])
    labels = [np.where(own >= 0, own + shift[k], -1) for k, (_, own) in enumerate(found)]
    points = np.concatenate([np.bincount(own[own >= 0], minlength=len(t["type"])) for t, own in found])
    heights = np.array([unit.type.height for unit in units])[table["type"]]
    kept: list[int] = []
    for k in np.argsort(-table["score"] * points, kind="stable"):
        away = np.linalg.norm(table["poses"][kept, :3] - table["poses"][k, :3], axis=1)
        if (away >= SAME_UNIT_HEIGHTS * np.maximum(heights[kept], heights[k])).all():
            kept.append(int(k))
    number = np.full(len(table["type"]) + 1, -1, dtype=np.int64)
    number[kept] = np.arange(len(kept))
    merged = np.full(len(labels[0]), -1, dtype=np.int64)
    for own in reversed(labels):
        merged = np.where(number[own] >= 0, number[own], merged)
    return {name: values[kept] for name, values in table.items()}, merged


def _given(cloud: PointCloud, given: Sequence[GivenUnit], units: Sequence[SurveyUnit]) -> tuple[dict[str, NDArray[Any]], IntArray]:
    poses, labels = place_given(cloud, given, [unit.type for unit in units])
    return _table(
        list(poses),
        [unit.kind for unit in given],
        [unit.score for unit in given],
        [unit.coverage for unit in given],
        [unit.legs_visible for unit in given],
        [unit.status for unit in given],
        [math.nan] * len(given),
        [unit.supported for unit in given],
    ), labels


def _table(
    poses: Sequence[FloatArray],
    kinds: Sequence[int],
    scores: Sequence[float],
    coverages: Sequence[float],
    legs: Sequence[int],
    statuses: Sequence[str],
    misfits: Sequence[float],
    supported: Sequence[float],
) -> dict[str, NDArray[Any]]:
    return {
        "poses": np.array(poses, dtype=np.float64).reshape(-1, 12),
        "type": np.array(kinds, dtype=np.int64),
        "score": np.array(scores, dtype=np.float64),
        "coverage": np.array(coverages, dtype=np.float64),
        "legs_visible": np.array(legs, dtype=np.int64),
        "status": np.array(statuses, dtype="U12"),
        "misfit": np.array(misfits, dtype=np.float64),
        "supported": np.array(supported, dtype=np.float64),
        "twist_open": np.zeros(len(poses), dtype=np.bool_),
    }


def _offsets(sizes: Sequence[int] | IntArray) -> IntArray:
    """(k + 1,) where each of k parts of the given sizes begins in the array of all, and where the last one ends."""
    return np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)


def _median_distance(points: FloatArray, pose: Pose, unit: UnitType) -> float:
    """Median absolute distance of (n, 3) points to the surface of a unit, metres; nan without points."""
    return float(np.median(np.abs(distance_to_surface(pose.to_body(points), unit)))) if len(points) else float("nan")
