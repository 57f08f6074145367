"""All steps from survey.toml to result.gpkg, one function each; the console command and, through it, QGIS call these.

Units are found and adjusted block by block in the frame of each epoch's cloud; registration then takes poses, covariances and
feature points into the control frame, where epochs are compared.
"""

from __future__ import annotations

import hashlib
import math
import os
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from datetime import UTC
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .block_jobs import GRADIENT_TOLERANCE, POINT_ARRAYS, RADIUS_TOLERANCE, FitJob, SegmentJob, owners
from .crs import LOCAL
from .errors import Cancelled, InputError, OutputError
from .feature_points import FEATURES
from .geopackage import check_output, from_upper_triangle, replace_durably, write_geopackage
from .pose import Pose
from .result_rows import (
    EpochPlan,
    EpochUnits,
    control_rows,
    covariance_fields,
    epoch_row,
    feature_rows,
    fitted_feature_rows,
    provisional_ids,
    unit_rows,
)
from .run_record import RunRecord, record_run
from .schema import LAYERS
from .survey import Survey
from .tile_jobs import JobRunner, loaded_arrays, plan_blocks
from .tiles import TileInfo, inspect_tile, read_points
from .trajectory import noise_of, read_stations, read_trajectory
from .unit_types import UnitType

if TYPE_CHECKING:
    from .control import Registration
    from .tracking import Surroundings, TrackedEpoch
    from .unit_clouds import UnitCloud

FloatArray = NDArray[np.float64]
Tables = dict[str, list[dict[str, Any]]]

STYLES = Path(__file__).parent / "styles"
SHARES = {"read": 0.03, "fit": 0.82, "track": 0.14, "write": 0.01}
"""Share of each step in the time of a whole run, for the progress bar."""


@dataclass(frozen=True)
class Feedback:
    """Where a step's messages go, and who may end it.

    Attributes
    ----------
    progress
        Share done, 0 to 1, and what is being done.
    info, warning
        One sentence for the log.
    is_cancelled
        Asked often; True ends the run with :class:`Cancelled`.
    """

    progress: Callable[[float, str], None] = lambda fraction, message: None
    info: Callable[[str], None] = lambda message: None
    warning: Callable[[str], None] = lambda message: None
    is_cancelled: Callable[[], bool] = lambda: False

    def part(self, first: float, last: float) -> Feedback:
        """Feedback whose progress fills only a part of this one's."""
        return replace(self, progress=lambda fraction, message: self.progress(first + (last - first) * fraction, message))

    def check(self) -> None:
        """End here if the user wants it."""
        if self.is_cancelled():
            raise Cancelled("cancelled")


@dataclass(frozen=True)
class RunOptions:
    """How a run is carried out; nothing here changes its result but the seed.

    Attributes
    ----------
    workers
        Local processes; 0 takes one per core.
    scheduler
        Address of a dask scheduler instead.
    resume
        Keep finished blocks beside the output and use those of an earlier, interrupted run.
    seed
        Of the random draws.
    """

    workers: int = 0
    scheduler: str | None = None
    resume: bool = False
    seed: int = 0


def plan_survey(survey: Survey, feedback: Feedback | None = None) -> tuple[EpochPlan, ...]:
    """Check the headers of all tiles and the tables of points, so that what is wrong is said before hours of work; cut epochs into blocks.

    Raises
    ------
    InputError
        The first tile or table that cannot be used.
    """
    from .validation import read_check

    feedback = feedback or Feedback()
    height = max(unit.type.height for unit in survey.units)
    plans = []
    total = sum(len(epoch.tiles) for epoch in survey.epochs)
    done = 0
    for epoch in survey.epochs:
        if epoch.trajectory is not None:
            read_trajectory(epoch.trajectory)
        if epoch.stations is not None:
            read_stations(epoch.stations)
        if epoch.check is not None:
            read_check(epoch.check)
        tiles = []
        for path in epoch.tiles:
            feedback.check()
            feedback.progress(done / total, f"checking {path.name}")
            tile = inspect_tile(path, survey.crs, tiles_crs=epoch.tiles_crs)
            if tile.note:
                feedback.info(tile.note)
            if epoch.trajectory is not None and not tile.has_time:
                raise InputError(
                    f"has no GPS time by which trajectory {epoch.trajectory.name} could be read",
                    source=path,
                    remedy="Export the tiles with GPS time, or take trajectory, range_sd and angle_sd out of survey.toml.",
                )
            tiles.append(tile)
            done += 1
        plans.append(EpochPlan(epoch, tuple(tiles), plan_blocks(epoch.label, tiles, height)))
    return tuple(plans)


def segment_epochs(
    survey: Survey,
    plans: Sequence[EpochPlan],
    record: RunRecord,
    runner: JobRunner,
    feedback: Feedback,
    given: Mapping[str, Sequence[tuple[float, ...]]] | None = None,
) -> tuple[EpochUnits, ...]:
    """Find the units of every epoch (or take ``given`` poses by epoch label), each once.

    Raises
    ------
    InputError
        A tile is damaged.
    """
    blocks = [(plan, block) for plan in plans for block in plan.blocks]
    jobs = [
        SegmentJob(
            block,
            survey.crs,
            plan.epoch.tiles_crs,
            survey.units,
            record.seed,
            tuple(record.checksums[tile.path] for tile in block.tiles),
            None if given is None else tuple(given.get(plan.epoch.label, ())),
            timed=plan.epoch.trajectory is not None,
        )
        for plan, block in blocks
    ]
    what = "finding units" if given is None else "collecting points"
    files = runner.run(jobs, lambda done, total: feedback.progress(done / total, f"{what}, block {done} of {total}"))
    heights = [unit.type.height for unit in survey.units]
    result = []
    for plan in plans:
        mine = [k for k, (other, _) in enumerate(blocks) if other is plan]
        arrays = [loaded_arrays(files[k], without=POINT_ARRAYS) for k in mine]
        rows = owners([(blocks[k][1].core, a) for k, a in zip(mine, arrays, strict=True)], heights)
        result.append(_collected(plan, arrays, rows, tuple(files[k] for k in mine), tuple(unit.type for unit in survey.units)))
    return tuple(result)


def find_and_fit(
    survey: Survey,
    plans: Sequence[EpochPlan],
    record: RunRecord,
    runner: JobRunner,
    feedback: Feedback,
    given: Mapping[str, Sequence[tuple[float, ...]]] | None = None,
) -> tuple[tuple[EpochUnits, ...], dict[str, Any]]:
    """Find units and adjust each to its points; with ``calibrate`` the shape is first estimated from the best-seen units of all epochs,
    then the units are found and adjusted anew with it.

    Returns the adjusted units by epoch, and what calibration found, for the record.
    """
    calibrates = any(unit.calibrate for unit in survey.units)
    share = 0.4 if calibrates else 0.75
    found = segment_epochs(survey, plans, record, runner, feedback.part(0, share), given)
    shape_sds = tuple((RADIUS_TOLERANCE * unit.type.radius, GRADIENT_TOLERANCE) for unit in survey.units)
    notes: dict[str, Any] = {}
    if calibrates:
        feedback.progress(share, "calibrating radius and gradient")
        survey, shape_sds, notes = calibrate_shapes(survey, found, shape_sds, record, feedback)
        found = segment_epochs(survey, plans, record, runner, feedback.part(share, 0.8), given)
        share = 0.8
    return fit_epochs(found, shape_sds, record, runner, feedback.part(share, 1)), notes


def calibrate_shapes(
    survey: Survey, epochs: Sequence[EpochUnits], shape_sds: tuple[tuple[float, float], ...], record: RunRecord, feedback: Feedback
) -> tuple[Survey, tuple[tuple[float, float], ...], dict[str, Any]]:
    """Estimate radius and gradient of the types that ask for it.

    Returns the survey with the estimated shapes, the standard deviation of single units' radius and gradient by type, and the numbers
    for the record.

    Raises
    ------
    InputError
        No unit shows enough of itself, or the sensor's position is not known for a point, where positions are given.
    """
    from .calibration import CALIBRATION_UNITS, calibrate

    units, sds, notes = list(survey.units), list(shape_sds), {}
    for kind, unit in enumerate(survey.units):
        if not unit.calibrate:
            continue
        best: list[tuple[int, FloatArray, Pose, FloatArray | None]] = []
        for epoch in epochs:
            beams = noise_of(epoch.plan.epoch, record.checksums.__getitem__)
            covariances = epoch.covariances(beams) if beams is not None else None
            for row, points, _ in epoch.points():
                feedback.check()
                # a shape that is wrong yet weakens the evidence of good units: what is no unit shows as an outlier instead
                if int(epoch.table["type"][row]) != kind:
                    continue
                pose = epoch.pose(row)
                origin = np.round(pose.centre)
                noise = covariances(row) if covariances is not None else None
                best.append((len(points), points - origin, pose.shifted(-origin), noise))
                best = sorted(best, key=lambda item: -item[0])[:CALIBRATION_UNITS]
        _, clouds, poses, noises = zip(*best, strict=True) if best else ((), (), (), ())
        result = calibrate(clouds, unit.type, poses, covariances=noises)
        units[kind] = replace(unit, type=result.unit)
        sds[kind] = (float(result.between[0]), float(result.between[1]))
        used = int(result.used.sum())
        feedback.info(
            f"calibrated on {used} units: radius {result.unit.radius:.4f} m (sd {result.sd[0]:.4f}), "
            f"gradient {result.unit.gradient:.4f} (sd {result.sd[1]:.4f})"
        )
        notes[unit.type.name] = {
            "radius": result.unit.radius,
            "gradient": result.unit.gradient,
            "sd": result.sd.tolist(),
            "between_units": result.between.tolist(),
            "units": used,
        }
    return replace(survey, units=tuple(units)), tuple(sds), notes


def fit_epochs(
    epochs: Sequence[EpochUnits], shape_sds: tuple[tuple[float, float], ...], record: RunRecord, runner: JobRunner, feedback: Feedback
) -> tuple[EpochUnits, ...]:
    """Adjust every unit to its points.

    Parameters
    ----------
    epochs
        Units with approximate poses.
    shape_sds
        By type of unit, standard deviations of radius (metres) and gradient about the type's shape; 0 holds it.
    record
        Checksums of the inputs.

    Raises
    ------
    InputError
        The sensor's position is not known for a point, where positions are given.
    """
    jobs = []
    for epoch in epochs:
        beams = noise_of(epoch.plan.epoch, record.checksums.__getitem__)
        for number, path in enumerate(epoch.files):
            rows = tuple(int(row) for row in np.sort(epoch.places[epoch.places[:, 0] == number, 1]))
            jobs.append(FitJob(path, rows, epoch.units, shape_sds, beams))
    files = iter(runner.run(jobs, lambda done, total: feedback.progress(done / total, f"adjusting units, block {done} of {total}")))
    result = []
    for epoch in epochs:
        own = tuple(next(files) for _ in epoch.files)
        arrays = [loaded_arrays(path, without=POINT_ARRAYS) for path in own]
        result.append(_solid(_collected(epoch.plan, arrays, [np.arange(len(a["poses"])) for a in arrays], own, epoch.units)))
    return tuple(result)


def _solid(epoch: EpochUnits) -> EpochUnits:
    """The epoch with units uncertain that their adjustment moved into a stronger one."""
    from .quality import entering, reduced
    from .segmentation import MOST_INTERPENETRATION

    status = np.array(epoch.table["status"])
    found = np.flatnonzero(status == "found")
    poses = reduced(epoch.table["poses"][found])
    inside = entering(poses, epoch.table["type"][found], epoch.units, epoch.table["score"][found], MOST_INTERPENETRATION)
    status[found[inside]] = "uncertain"
    return replace(epoch, table={**epoch.table, "status": status})


def write_result(path: str | Path, survey_crs: str, tables: Mapping[str, Sequence[Mapping[str, Any]]]) -> None:
    """Write a result with the shipped QGIS styles."""
    styles = {style.stem: style.read_text(encoding="utf-8") for style in sorted(STYLES.glob("*.qml"))}
    write_geopackage(path, survey_crs, tables, styles=styles)


@contextmanager
def job_runner(output: Path, options: RunOptions, feedback: Feedback) -> Iterator[JobRunner]:
    """A runner whose files are kept beside the output with ``resume`` and vanish otherwise.

    Raises
    ------
    OutputError
        Another run is writing this output.
    """
    workers = options.workers or os.cpu_count() or 1
    target = output.absolute()
    with _sole_writer(target):
        if options.resume:
            folder = target.with_name(f"{target.name}.jobs")
            try:
                folder.mkdir(exist_ok=True)
            except OSError as error:
                raise OutputError(
                    f"cannot be made ({error.strerror})", source=folder, remedy="Check the folder's permissions and free space."
                ) from error
            with JobRunner(folder, workers, options.scheduler, feedback.is_cancelled) as runner:
                yield runner
            return
        # workers of a cluster see the folder of the output, and nothing else for sure
        place = target.parent if options.scheduler else None
        with (
            tempfile.TemporaryDirectory(prefix=".tetratrack-", dir=place) as temporary,
            JobRunner(Path(temporary), workers, options.scheduler, feedback.is_cancelled) as runner,
        ):
            yield runner


@contextmanager
def _sole_writer(target: Path) -> Iterator[None]:
    """Hold a lock in the system's temporary folder that ends with the process, however that ends."""
    name = f"tetratrack-{hashlib.sha256(str(target).encode()).hexdigest()[:24]}.lock"
    handle = os.open(Path(tempfile.gettempdir()) / name, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise OutputError(
                "is being written by another run", source=target, remedy="Wait for it, or give this run another --output."
            ) from error
        yield
    finally:
        os.close(handle)


def _collected(
    plan: EpochPlan,
    arrays: Sequence[Mapping[str, NDArray[Any]]],
    rows: Sequence[NDArray[np.int64]],
    files: tuple[Path, ...],
    units: tuple[UnitType, ...],
) -> EpochUnits:
    """Units of all blocks in one table, poses absolute, ordered by easting and northing."""
    skip = {"origin", "offsets"}
    table = {name: np.concatenate([a[name][r] for a, r in zip(arrays, rows, strict=True)]) for name in arrays[0] if name not in skip}
    table["poses"] = table["poses"].copy()
    table["poses"][:, :3] += np.concatenate([np.tile(a["origin"], (len(r), 1)) for a, r in zip(arrays, rows, strict=True)])
    places = np.concatenate([np.column_stack([np.full(len(r), k), r]) for k, r in enumerate(rows)]).astype(np.int64)
    order = np.lexsort((table["poses"][:, 1], table["poses"][:, 0]))
    return EpochUnits(plan, {name: values[order] for name, values in table.items()}, places[order], files, units)


def register_epochs(survey: Survey, plans: Sequence[EpochPlan], feedback: Feedback) -> dict[str, Registration]:
    """Registration of every epoch that has control, by label; with stable areas also of the others, to the reference epoch.

    Raises
    ------
    InputError
        Control, targets or stable areas cannot be used.
    """
    from .control import SurveyedPoints, grid_scale, read_control, read_targets, register, to_survey_frame

    pairs: dict[str, tuple[SurveyedPoints, SurveyedPoints]] = {}
    for epoch in survey.epochs:
        if epoch.control is None or epoch.targets is None:
            continue
        feedback.check()
        surveyed = to_survey_frame(read_control(epoch.control), epoch.control_crs, survey.crs, epoch.control_unit)
        pairs[epoch.label] = surveyed, read_targets(epoch.targets)
        if survey.crs != LOCAL:
            scale = grid_scale(survey.crs, surveyed.coordinates.mean(axis=0))
            feedback.info(f"{epoch.label}: scale factor grid over ground is {scale:.6f}; ground distances are not applied to coordinates")
    alone = {label: register(*points) for label, points in pairs.items()}
    found = {label: register(*points, others=[alone[k] for k in pairs if k != label]) for label, points in pairs.items()}
    return {**found, **tie_epochs(survey, plans, found, feedback)}


def tie_epochs(
    survey: Survey, plans: Sequence[EpochPlan], registered: Mapping[str, Registration], feedback: Feedback
) -> dict[str, Registration]:
    """Registration of epochs without control to the cloud of the reference epoch, on the survey's stable areas; none without areas.

    Where no epoch has control, the reference epoch's own frame is the datum, and its registration is the identity.

    Raises
    ------
    InputError
        The areas cannot be used; it names the epoch.
    """
    if survey.stable_areas is None:
        return {}
    loose = [plan for plan in plans if plan.epoch.label not in registered and plan.epoch is not survey.reference]
    if not loose:
        feedback.info(f"{survey.stable_areas.name} is not used: every epoch has control")
        return {}
    import shapely

    from .control import Registration
    from .stable_areas import REACH_HEIGHTS, VOXEL_HEIGHTS, read_areas, read_stable_points, register_on_areas

    areas = read_areas(survey.stable_areas, survey.crs)
    height = max(unit.type.height for unit in survey.units)
    root = next(plan for plan in plans if plan.epoch is survey.reference)
    label = root.epoch.label
    origin = np.floor(np.array([*shapely.bounds(areas)[:2], root.tiles[0].low[2]]))
    found = {} if label in registered else {label: Registration.own_frame(origin)}
    known = {**registered, **found}[label].transformation

    def points(plan: EpochPlan, inside: shapely.Geometry) -> FloatArray:
        return read_stable_points(
            plan.tiles, survey.crs, plan.epoch.tiles_crs, inside, origin, VOXEL_HEIGHTS * height, feedback.is_cancelled
        )

    def to_cloud(positions: FloatArray) -> FloatArray:
        return np.asarray(known.invert(np.column_stack([positions, np.full(len(positions), known.origin_to[2])]))[:, :2])

    # the other cloud may lie anywhere within reach of its registered place
    around = shapely.transform(shapely.buffer(areas, REACH_HEIGHTS * height), to_cloud)
    reference = known.apply(points(root, around) + origin) - origin
    for plan in loose:
        feedback.check()
        feedback.progress(0.0, f"registering {plan.epoch.label} on stable areas")
        try:
            tied = register_on_areas(reference, points(plan, areas), origin, height)
        except InputError as error:
            raise InputError(error.problem, source=survey.stable_areas, where=f"epoch {plan.epoch.label}", remedy=error.remedy) from error
        relative = tied.transformation
        total = relative.covariance + known.covariance_at(relative.origin_to)
        found[plan.epoch.label] = replace(tied, transformation=replace(relative, covariance=total), reference=label)
    return found


def run_inspect(paths: Sequence[Path], output: Path | None, feedback: Feedback) -> dict[str, Any]:
    """Step ``inspect``: extent, CRS, number and density of points of tiles, as a table and, with ``output``, a layer ``tiles``.

    Raises
    ------
    InputError
        A tile that cannot be read.
    """
    tiles = []
    for k, path in enumerate(paths):
        feedback.check()
        tile = inspect_tile(path, None)
        tiles.append(tile)
        feedback.progress((k + 1) / len(paths), f"checked {path.name}")
    if output is not None:
        write_tile_index(output, tiles)
    names = [tile.crs for tile in tiles]
    return {
        "tiles": len(tiles),
        "points": sum(tile.points for tile in tiles),
        "density": float(np.median([tile.density for tile in tiles])),
        "crs": max(sorted(set(names)), key=names.count),
        "table": [
            {
                "tile": tile.path.name,
                "points": tile.points,
                "density": round(tile.density, 1),
                "crs": tile.crs if len(tile.crs) < 20 else f"{tile.crs[:19]}…",
                "extent": " ".join(f"{low:.2f}..{high:.2f}" for low, high in zip(tile.low, tile.high, strict=True)),
            }
            for tile in tiles
        ],
    }


def write_tile_index(path: Path, tiles: Sequence[TileInfo]) -> None:
    """Write one rectangle per tile to the layer ``tiles`` of a new GeoPackage, replacing an earlier one.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    import geopandas
    import shapely
    from pyogrio.errors import DataSourceError

    frame = geopandas.GeoDataFrame(
        {
            "file": [str(tile.path) for tile in tiles],
            "points": [tile.points for tile in tiles],
            "density": [tile.density for tile in tiles],
            "height_min": [tile.low[2] for tile in tiles],
            "height_max": [tile.high[2] for tile in tiles],
            "crs": [tile.crs for tile in tiles],
            "las_version": [tile.version for tile in tiles],
            "point_format": [tile.point_format for tile in tiles],
            "copc": [tile.copc for tile in tiles],
        },
        geometry=[shapely.box(tile.low[0], tile.low[1], tile.high[0], tile.high[1]) for tile in tiles],
        crs=next((tile.crs for tile in tiles if tile.crs not in ("", "LOCAL")), None),
    )
    target = path.absolute()
    try:
        # GDAL warns of a GeoPackage whose name does not end in .gpkg
        with tempfile.TemporaryDirectory(prefix=".tetratrack-", dir=target.parent) as folder:
            temporary = Path(folder) / "tiles.gpkg"
            frame.to_file(temporary, layer="tiles", driver="GPKG", engine="pyogrio")
            replace_durably(temporary, target)
    except (DataSourceError, OSError) as error:
        raise OutputError("cannot be written", source=path, remedy="Check the folder's permissions and free space.") from error


def run_register(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``register``: transformation of each epoch's cloud to survey control, and the residuals."""
    check_output(output)
    plans = plan_survey(survey, feedback.part(0, 0.5))
    record = record_run(survey, options.seed, {"step": "register"})
    registrations = register_epochs(survey, plans, feedback.part(0.5, 1))
    if not registrations:
        raise InputError(
            "no epoch names control and targets",
            source=survey.path,
            remedy="Add control and targets to an [[epoch]], or stable_areas to [survey].",
        )
    tables: Tables = {"control_residuals": [], "epochs": []}
    squares, outliers = [], 0
    for plan in plans:
        registration = registrations.get(plan.epoch.label)
        if registration is None:
            tables["epochs"].append(epoch_row(plan, record, None, {}))
            continue
        for note in registration.notes:
            feedback.info(f"{plan.epoch.label}: {note}")
        tables["control_residuals"] += control_rows(plan.epoch.label, registration)
        tables["epochs"].append(epoch_row(plan, record, registration, {"redundancy": registration.redundancy}))
        squares += [float(np.sum(r.residual**2)) for r in registration.residuals if r.used]
        outliers += len(registration.excluded)
    write_result(output, survey.crs, tables)
    rmse = math.sqrt(sum(squares) / len(squares)) if squares else None
    return {"output": str(output), "rmse": rmse, "outliers": outliers}


def run_features(units: Path, output: Path, feedback: Feedback) -> dict[str, Any]:
    """Step ``features``: feature points with covariance from a layer ``units`` of any GeoPackage."""
    check_output(output)
    tables: Tables = {"units": [], "feature_points": []}
    for row in read_units(units):
        feedback.check()
        row = {name: _plain(value) for name, value in row.items() if name in {*LAYERS["units"].names, "geometry"}}
        tables["units"].append(row)
        if row["geometry"] is None:
            continue
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        unit = _unit_of(row, units)
        covariance = from_upper_triangle(row["covariance"]) if row.get("covariance") else None
        tables["feature_points"] += feature_rows(
            str(row["unit_id"]), str(row["epoch"]), row.get("epoch_time"), pose, unit, covariance, [None] * len(FEATURES)
        )
    write_result(output, crs_of_layer(units), tables)
    return {"output": str(output), "features": len(tables["feature_points"])}


def crs_of_layer(path: Path) -> str:
    """CRS of the layer ``units`` of a GeoPackage, as survey.toml writes it."""
    import pyogrio

    return str(pyogrio.read_info(path, layer="units")["crs"] or "LOCAL")


def _plain(value: Any) -> Any:
    """A cell as the writers take it: numpy's missing values become None, its times aware datetimes."""
    if isinstance(value, np.datetime64):
        return None if np.isnat(value) else value.astype("datetime64[ms]").item().replace(tzinfo=UTC)
    if isinstance(value, float | np.floating) and math.isnan(value):
        return None
    return value


def _unit_of(row: Mapping[str, Any], source: Path) -> UnitType:
    """Geometry of a row of ``units``."""
    values = [row.get(name) for name in ("height", "r0", "gradient")]
    if any(value is None for value in values):
        raise InputError(
            f"unit {row['unit_id']} has no height, r0 or gradient", source=source, remedy="Give a result of tetratrack fit or run."
        )
    return UnitType.tetrapod(float(values[0]), radius=float(values[1]), gradient=float(values[2]))  # type: ignore[arg-type]


def run_survey(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """All steps: tiles to units, feature points, registration and displacements, in one result.

    Raises
    ------
    InputError
        Input that cannot be used; nothing is written then.
    Cancelled
        The user ended the run; nothing is written.
    """
    check_output(output)
    start = SHARES["read"]
    plans = plan_survey(survey, feedback.part(0, start))
    record = record_run(
        survey,
        options.seed,
        {"step": "run", "survey": survey.name, "unit": [repr(unit) for unit in survey.units], "leg_length": survey.unit.leg_length},
    )
    registrations = register_epochs(survey, plans, feedback)
    with job_runner(output, options, feedback) as runner:
        fitted, calibration = find_and_fit(survey, plans, record, runner, feedback.part(start, start := start + SHARES["fit"]))
        feedback.progress(start, "tracking units")
        tables, summary = track_tables(survey, fitted, fitted[0].units, registrations, feedback)
        # compiled code: not before there is something to look at
        from .gap_rows import gap_rows, look_into_tiles

        feedback.progress(1 - 3 * SHARES["write"], "looking for gaps")
        when = [(plan.epoch.label, plan.epoch.time) for plan in plans]
        seen = look_into_tiles(tables["units"], survey, plans, fitted[0].units, registrations, record.checksums, runner)
        tables["gaps"] = gap_rows(tables["units"], when, fitted[0].units, seen)
        qualities = state_quality(tables["units"], fitted[0].units, [label for label, _ in when], feedback, tables["gaps"])
        tables |= {"control_residuals": [], "epochs": []}
        tables["check_residuals"], check_rmse = check_tables(survey, tables["feature_points"], feedback)
        for epoch in fitted:
            label = epoch.plan.epoch.label
            registration = registrations.get(label)
            if registration is None:
                feedback.info(f"{label}: no control, results stay in the frame of the cloud")
            else:
                tables["control_residuals"] += control_rows(label, registration)
                for note in registration.notes:
                    feedback.info(f"{label}: {note}")
            extra = summary["epochs"][label] | {"calibration": calibration, "quality": qualities[label]}
            tables["epochs"].append(epoch_row(epoch.plan, record, registration, extra))
        feedback.check()
        feedback.progress(1 - SHARES["write"], "writing")
        write_result(output, survey.crs, tables)
    feedback.progress(1.0, "done")
    return {"output": str(output), "units": summary["units"], "moved": summary["moved"], "check_rmse": check_rmse}


def state_quality(
    rows: Sequence[dict[str, Any]],
    units: Sequence[UnitType],
    labels: Sequence[str],
    feedback: Feedback,
    gaps: Sequence[Mapping[str, Any]] | None = None,
) -> dict[str, dict[str, Any]]:
    """Fill what rows of ``units`` say of their neighbours, log each epoch's summary, and return the summaries by label.

    ``gaps`` are the rows of that layer, None where gaps were not looked for.
    """
    from .quality import add_neighbours, describe, summarise_epoch

    add_neighbours(rows, units)
    summaries = {}
    for label in labels:
        count = None if gaps is None else sum(row["epoch"] == label for row in gaps)
        summaries[label] = summarise_epoch([row for row in rows if row["epoch"] == label], count)
        feedback.info(describe(label, summaries[label]))
    return summaries


def check_tables(survey: Survey, points: Sequence[Mapping[str, Any]], feedback: Feedback) -> tuple[list[dict[str, Any]], float | None]:
    """Rows of ``check_residuals`` of all epochs that have check points, and their root mean square length in metres."""
    from .validation import CheckResidual, check_residuals, checked_displacements, read_check, residual_rows, summarise

    residuals: list[CheckResidual] = []
    for epoch in survey.epochs:
        if epoch.check is None:
            continue
        features: dict[str, dict[str, FloatArray]] = {}
        for row in points:
            if row["epoch"] == epoch.label:
                features.setdefault(row["unit_id"], {})[row["feature"]] = row["geometry"]
        residuals += check_residuals(read_check(epoch.check), features, max(u.type.height for u in survey.units), epoch.label)
    summary = summarise([c.error for c in checked_displacements(residuals, [epoch.label for epoch in survey.epochs])])
    if summary.count:
        feedback.info(
            f"displacements of {summary.count} check points: mean absolute error {1000 * summary.mean_absolute:.1f} mm, "
            f"largest {1000 * summary.maximum:.1f} mm"
        )
    lengths = [r.length for r in residuals if r.difference is not None]
    return residual_rows(residuals), math.sqrt(sum(v**2 for v in lengths) / len(lengths)) if lengths else None


def track_tables(
    survey: Survey,
    fitted: Sequence[EpochUnits],
    units: tuple[UnitType, ...],
    registrations: Mapping[str, Registration],
    feedback: Feedback,
) -> tuple[Tables, dict[str, Any]]:
    """Rows of all layers that need several epochs, and of units and feature points; counts and settings by epoch for the record."""
    from .displacement import grades_from
    from .tracking import track
    from .tracking_tables import TableOptions, cross_check_rows, displacement_rows, pair_rows, unit_names, unit_tables, velocity_rows

    centres = np.concatenate([epoch.table["poses"][:, :3] for epoch in fitted])
    origin = np.round(centres.mean(axis=0)) if len(centres) else np.zeros(3)
    labels = [e.plan.epoch.label for e in fitted]
    placed = [_tracked_epoch(k, e, registrations.get(e.plan.epoch.label), units, origin, labels) for k, e in enumerate(fitted)]
    result = track(placed, units, _surroundings(survey, fitted, registrations, origin, feedback))
    names = unit_names(len(result.units))
    limits = survey.sections["displacement"]
    base = (float(origin[0]), float(origin[1]), float(origin[2]))
    options = TableOptions(base, limits["significance"], grades_from(limits))

    def from_fit(epoch: int, row: int | None) -> dict[str, Any]:
        if row is None:
            return {}
        table = fitted[epoch].table
        fields = ("legs_visible", "coverage", "score", "sigma0", "distance_median", "supported")
        return {name: table[name][row] for name in fields} | {"observed": [bool(v) for v in table["observed"][row]]}

    unit_rows_, points = unit_tables(result, placed, units, names, origin, from_fit, feature_rows, covariance_fields)
    moved, other = displacement_rows(result, placed, units, names, options)
    tables: Tables = {
        "units": unit_rows_,
        "feature_points": points,
        "displacements": moved,
        "displacements_other": other,
        "epoch_pairs": pair_rows(result, placed, origin),
        "cross_checks": cross_check_rows(result, placed, names, origin),
        "velocities": velocity_rows(result, placed, names, origin),
    }
    settings = {
        e.label: {
            "displacement": dict(limits),
            "source_offsets_m": {
                str(source): [round(float(v), 5) for v in offset]
                for (epoch, source), offset in sorted(result.joint.offsets.items())
                if epoch == k
            },
        }
        for k, e in enumerate(placed)
    }
    last = {row["unit_id"] for row in moved if row["class"] == "moved"}
    return tables, {"units": len(names), "moved": len(last), "epochs": settings}


def _tracked_epoch(
    number: int,
    epoch: EpochUnits,
    registration: Registration | None,
    units: tuple[UnitType, ...],
    origin: FloatArray,
    labels: Sequence[str],
) -> TrackedEpoch:
    """Units of an epoch (its number) with their clouds in the control frame, less the common reduction point."""
    from .control import Transformation
    from .fitted_unit import FittedUnit
    from .tracking import TrackedEpoch
    from .unit_clouds import UnitCloud

    known = None if registration is None else registration.transformation
    transformation = Transformation.identity(origin) if known is None else known
    table = epoch.table
    turn = np.kron(np.eye(2), transformation.rotation)
    points_of = epoch.reader()

    def cloud(row: int, sources: NDArray[np.uint16]) -> UnitCloud:
        def read() -> tuple[FloatArray, NDArray[np.uint16]]:
            points, sources = points_of(row)
            return transformation.apply(points) - origin, sources

        return UnitCloud(len(sources), np.unique(sources), read, (number, int(epoch.places[row, 0])))

    found: dict[int, FittedUnit] = {}
    for row, _, sources in epoch.points():
        pose = transformation.apply_pose(epoch.pose(row)).shifted(-origin)
        kind = int(table["type"][row])
        certain = table["status"][row] == "found"
        score = float(table["score"][row])
        own = table["covariance"][row][:6, :6]
        covariance = turn @ own @ turn.T if np.isfinite(own).all() else None
        n_points = int(table["n_points"][row])
        found[row] = FittedUnit(pose, units[kind], kind, certain, table["discs"][row], cloud(row, sources), covariance, score, n_points)
    return TrackedEpoch(
        epoch.plan.epoch.label,
        epoch.plan.epoch.time,
        tuple(found[row] for row in range(len(epoch))),
        None if known is None else replace(known, origin_to=known.origin_to - origin),
        0 if registration is None else registration.redundancy,
        None if registration is None or registration.reference is None else labels.index(registration.reference),
    )


def _surroundings(
    survey: Survey, epochs: Sequence[EpochUnits], registrations: Mapping[str, Registration], origin: FloatArray, feedback: Feedback
) -> Surroundings:
    """Reader of an epoch's cloud around places, for :func:`tetratrack.core.tracking.track`."""
    from scipy.spatial import cKDTree

    from .control import Transformation

    def read(number: int, places: FloatArray, reach: float) -> tuple[FloatArray, NDArray[np.integer[Any]]]:
        plan = epochs[number].plan
        registration = registrations.get(plan.epoch.label)
        transformation = Transformation.identity(origin) if registration is None else registration.transformation
        where = transformation.invert(places + origin)
        tree = cKDTree(where - origin)
        parts: list[FloatArray] = []
        sources: list[NDArray[np.integer[Any]]] = []
        for block in plan.blocks:
            if not block.core.grown(reach).contains(where).any():
                continue
            feedback.check()
            cloud = read_points(block.tiles, survey.crs, window=block.core, origin=origin, tiles_crs=plan.epoch.tiles_crs)
            near = np.isfinite(tree.query(cloud.xyz, distance_upper_bound=reach)[0])
            parts.append(transformation.apply(cloud.xyz[near] + origin) - origin)
            sources.append(cloud.source_id[near])
        if not parts:
            return np.empty((0, 3)), np.empty(0, dtype=np.uint16)
        return np.vstack(parts), np.concatenate(sources)

    return read


def run_segment(survey: Survey, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``segment``: units with approximate poses, in the frame of each epoch's cloud."""
    check_output(output)
    plans = plan_survey(survey, feedback.part(0, 0.05))
    record = record_run(survey, options.seed, {"step": "segment"})
    with job_runner(output, options, feedback) as runner:
        epochs = segment_epochs(survey, plans, record, runner, feedback.part(0.05, 0.98))
        tables: Tables = {"units": [], "epochs": []}
        for epoch in epochs:
            tables["units"] += unit_rows(epoch, provisional_ids(len(epoch)))
        qualities = state_quality(tables["units"], epochs[0].units, [epoch.plan.epoch.label for epoch in epochs], feedback)
        for epoch in epochs:
            tables["epochs"].append(epoch_row(epoch.plan, record, None, {"quality": qualities[epoch.plan.epoch.label]}))
        feedback.check()
        write_result(output, survey.crs, tables)
    return {"output": str(output), "units": sum(int((e.table["status"] == "found").sum()) for e in epochs), "epochs": len(epochs)}


def run_fit(survey: Survey, units: Path | None, output: Path, options: RunOptions, feedback: Feedback) -> dict[str, Any]:
    """Step ``fit``: adjusted units and feature points in the frame of each epoch's cloud, from given poses or from the points alone."""
    check_output(output)
    given = None if units is None else read_poses(units, survey)
    plans = plan_survey(survey, feedback.part(0, 0.05))
    record = record_run(survey, options.seed, {"step": "fit"})
    with job_runner(output, options, feedback) as runner:
        epochs, calibration = find_and_fit(survey, plans, record, runner, feedback.part(0.05, 0.98), given)
        tables: Tables = {"units": [], "feature_points": [], "epochs": []}
        for epoch in epochs:
            ids = provisional_ids(len(epoch))
            tables["units"] += unit_rows(epoch, ids)
            for k, name in enumerate(ids):
                tables["feature_points"] += fitted_feature_rows(epoch, k, name)
        qualities = state_quality(tables["units"], epochs[0].units, [epoch.plan.epoch.label for epoch in epochs], feedback)
        for epoch in epochs:
            extra = {"calibration": calibration, "quality": qualities[epoch.plan.epoch.label]}
            tables["epochs"].append(epoch_row(epoch.plan, record, None, extra))
        feedback.check()
        write_result(output, survey.crs, tables)
    return {"output": str(output), "units": sum(len(e) for e in epochs), "epochs": len(epochs)}


def read_poses(path: Path, survey: Survey) -> dict[str, list[tuple[float, ...]]]:
    """Poses of a layer ``units`` by epoch: type of unit, centre and row-major rotation, as :class:`SegmentJob` takes them.

    Raises
    ------
    InputError
        The file has no such layer or field.
    """
    kinds = {unit.type.name: k for k, unit in enumerate(survey.units)}
    poses: dict[str, list[tuple[float, ...]]] = {epoch.label: [] for epoch in survey.epochs}
    for row in read_units(path):
        if row["geometry"] is None:
            continue
        if row["epoch"] not in poses:
            raise InputError(f"names the epoch {row['epoch']!r}", source=path, remedy=f"Epochs of the survey: {', '.join(poses)}.")
        pose = Pose.from_quaternion(row["geometry"], [row["qx"], row["qy"], row["qz"], row["qw"]])
        poses[row["epoch"]].append((float(kinds.get(row.get("unit_type", ""), 0)), *pose.centre.tolist(), *pose.rotation.ravel().tolist()))
    return poses


def read_units(path: Path) -> list[dict[str, Any]]:
    """Rows of the layer ``units`` of any GeoPackage, with ``geometry`` (3,) or None.

    Raises
    ------
    InputError
        The file cannot be read, or has no such layer or field.
    """
    import pyogrio
    import shapely
    from pyogrio.errors import DataLayerError, DataSourceError

    try:
        meta, _, geometry, columns = pyogrio.raw.read(path, layer="units")
    except (DataSourceError, DataLayerError) as error:
        raise InputError("has no readable layer units", source=path, remedy="Give a result of tetratrack segment, fit or run.") from error
    names = list(meta["fields"])
    missing = [name for name in ("epoch", "qx", "qy", "qz", "qw") if name not in names]
    if missing:
        raise InputError(
            f"layer units has no field {', '.join(missing)}", source=path, remedy="Give a result of tetratrack segment, fit or run."
        )
    shapes = shapely.from_wkb(geometry)
    places = [None if shape is None or shape.is_empty else shapely.get_coordinates(shape, include_z=True)[0] for shape in shapes]
    return [dict(zip(names, values, strict=True)) | {"geometry": place} for *values, place in zip(*columns, places, strict=True)]
