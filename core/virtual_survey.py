"""Whole surveys with ground truth, written as a folder that ``tetratrack run`` reads: pile, instrument, epochs, control, truth."""

from __future__ import annotations

import csv
import math
import shutil
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from .armour_pile import Changes, PiledUnit, Site, change, settle, settle_models
from .errors import CrsError, InputError, OutputError
from .feature_points import FEATURES, body_features
from .pose import Pose
from .tetrapod import surface_cells
from .unit_types import Opening, UnitType
from .virtual_scanner import (
    Instrument,
    Returns,
    Scene,
    Surfaces,
    survey_depth_camera,
    survey_photogrammetry,
    survey_tls,
    survey_uav,
)

FloatArray = NDArray[np.float64]

_OPPOSITE = (3, 2, 1, 0)
"""Leg opposite to each feature point."""

SENSOR_FILES: dict[Instrument, str] = {"uav": "trajectory", "tls": "stations"}
"""Key of survey.toml under which an instrument's positions are given."""
ANGLE_SD = 0.002
"""Standard deviation of a beam's direction that the survey.toml proposes, degrees: the simulated beams are all but exact."""

LOCAL_WKT = (
    'ENGCRS["Laboratory frame",EDATUM["Laboratory"],CS[Cartesian,3],AXIS["x",east,ORDER[1],LENGTHUNIT["metre",1]],'
    'AXIS["y",north,ORDER[2],LENGTHUNIT["metre",1]],AXIS["z",up,ORDER[3],LENGTHUNIT["metre",1]]]'
)


@dataclass(frozen=True)
class VirtualInstrument:
    """What distinguishes one kind of survey; lengths in metres.

    Attributes
    ----------
    scan
        Function of ``virtual_scanner`` that measures a scene.
    density
        Points per square metre at which the site is sampled, all lines together, or per station after thinning.
    noise
        Standard deviation of a range.
    offset
        Greatest offset of a flight line, station or view per axis.
    registration
        Standard deviation of the shift of a whole epoch.
    turn_deg
        Standard deviation of the turn of a whole epoch about each axis, degrees.
    target, control
        Standard deviation of a target in the cloud, and of its surveyed coordinates.
    surfaces
        Relief of the units.
    generator
        Generating software named in the LAS header.
    """

    scan: Callable[..., Returns]
    density: float
    noise: float
    offset: float
    registration: float
    turn_deg: float
    target: float
    control: float
    surfaces: Surfaces
    generator: str


INSTRUMENTS: dict[Instrument, VirtualInstrument] = {
    "uav": VirtualInstrument(survey_uav, 950, 0.017, 0.01, 0.025, 0.01, 0.006, 0.003, Surfaces(0.003, 0.05, 0.03, 0.4), "virtual UAV"),
    "tls": VirtualInstrument(survey_tls, 1250, 0.004, 0.004, 0.02, 0.01, 0.003, 0.003, Surfaces(0.003, 0.05, 0.03, 0.4), "virtual TLS"),
    "photogrammetry": VirtualInstrument(
        survey_photogrammetry, 1100, 0.007, 0.0, 0.02, 0.01, 0.006, 0.003, Surfaces(0.004, 0.16, 0.08, 0.4), "virtual photogrammetry"
    ),
    "depth_camera": VirtualInstrument(
        survey_depth_camera,
        260_000,
        0.0017,
        0.0004,
        0.002,
        0.1,
        0.0004,
        0.0002,
        Surfaces(0.0001, 0.005, 0.003, 0.0),
        "virtual depth camera",
    ),
}


@dataclass(frozen=True)
class SimulationPlan:
    """What to simulate.

    Attributes
    ----------
    name
        Name of the survey and prefix of its tiles.
    instrument
        ``uav``, ``tls``, ``photogrammetry`` or ``depth_camera``.
    units
        Number of units of the first epoch; 0 gives rock, wall and water only.
    height
        Nominal unit height, metres.
    epochs
        Number of epochs.
    seed
        Seed of everything random; the same plan gives the same survey.
    density
        Points per square metre, or None for the instrument's own.
    noise
        Range noise in metres (standard deviation), or None for the instrument's own.
    crs
        Projected or compound CRS of the site, or ``LOCAL``.
    las_crs
        CRS declared by the tiles where it differs (a compound CRS with the same horizontal part).
    origin
        Easting, northing and height of the site's origin.
    azimuth_deg
        Direction of the wall's outward normal, degrees clockwise from north.
    changes
        Changes between consecutive epochs; None for a typical number.
    tiles
        Number of tiles along easting and northing.
    first_day
        Date of the first epoch.
    radius, gradient, leg_length
        Proportions of the units where they are not the standard ones.
    opening
        ``tetrahedral``, or ``paper`` (120 degrees between leg 1 and the others).
    """

    name: str
    instrument: Instrument = "uav"
    units: int = 75
    height: float = 2.3
    epochs: int = 2
    seed: int = 0
    density: float | None = None
    noise: float | None = None
    crs: str = "EPSG:32650"
    las_crs: str | None = None
    origin: tuple[float, float, float] = (500_000.0, 3_500_000.0, 0.0)
    azimuth_deg: float = 30.0
    changes: Changes | None = None
    tiles: tuple[int, int] = (2, 2)
    first_day: date = date(2024, 4, 9)
    radius: float | None = None
    gradient: float | None = None
    leg_length: float | None = None
    opening: Opening = "tetrahedral"

    def __post_init__(self) -> None:
        if self.instrument not in INSTRUMENTS:
            raise InputError(
                f"instrument {self.instrument!r} is not known", where="instrument", remedy=f"Use one of: {', '.join(INSTRUMENTS)}."
            )
        if not self.name or any(c in self.name for c in '/\\"*?[]'):
            raise InputError(
                f"survey name {self.name!r} cannot be used in file names", where="name", remedy="Use letters, digits and underscores."
            )
        for field, low in (("units", 0), ("epochs", 1), ("height", 1e-3)):
            value = getattr(self, field)
            if not math.isfinite(value) or value < low:
                raise InputError(f"{field} must be at least {low}, got {value!r}", where=field, remedy="Correct the number.")
        for field in ("density", "noise"):
            value = getattr(self, field)
            if value is not None and (not math.isfinite(value) or value <= 0):
                raise InputError(
                    f"{field} must be a positive number, got {value!r}", where=field, remedy="Leave it out for the instrument's own."
                )
        if min(self.tiles) < 1:
            raise InputError("tiles must be at least 1 x 1", where="tiles", remedy="Correct the numbers.")

    @property
    def laboratory(self) -> bool:
        """Whether models on a table are surveyed instead of a breakwater."""
        return self.instrument == "depth_camera"

    @property
    def unit(self) -> UnitType:
        """Nominal unit."""
        return UnitType.tetrapod(self.height, radius=self.radius, gradient=self.gradient, leg_length=self.leg_length, opening=self.opening)


@dataclass(frozen=True, eq=False)
class _Frame:
    """Site frame to survey CRS, and the survey CRS to the frame of an epoch's cloud."""

    origin: FloatArray
    turn: FloatArray

    def place(self, points: FloatArray) -> FloatArray:
        return np.asarray(points @ self.turn.T + self.origin)

    def pose(self, pose: Pose) -> Pose:
        return Pose(self.place(pose.centre), self.turn @ pose.rotation)


def simulate_survey(plan: SimulationPlan, folder: Path, progress: Callable[[float, str], None] | None = None) -> Path:
    """Simulate a survey and write it as a folder with ``survey.toml``, tiles, control and ``truth/``.

    Parameters
    ----------
    plan
        What to simulate.
    folder
        Folder to make; it must not exist yet, and appears whole or not at all.
    progress
        Called with the fraction done and what is being done.

    Returns
    -------
    Path of the survey.toml.

    Raises
    ------
    OutputError
        The folder exists or cannot be written.
    InputError
        MuJoCo is not installed, or the CRS is not projected.
    """
    report = progress or (lambda fraction, message: None)
    if folder.exists():
        raise OutputError("exists already", source=folder, remedy="Choose another folder, or remove it.")
    _vet_crs(plan)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
    except OSError as cause:
        raise OutputError(f"cannot be made: {cause.strerror}", source=folder, remedy="Choose a folder that can be written.") from cause
    try:
        _Simulation(plan, work).run(report)
        work.chmod(0o755)
        work.rename(folder)
    except OSError as cause:
        raise OutputError(f"cannot be written: {cause}", source=folder, remedy="Check free space and rights.") from cause
    finally:
        shutil.rmtree(work, ignore_errors=True)
    report(1.0, f"{plan.name} written")
    return folder / "survey.toml"


class _Simulation:
    """One run of ``simulate_survey``: the pile as it changes, and the files as they are written."""

    def __init__(self, plan: SimulationPlan, folder: Path) -> None:
        self.plan, self.folder = plan, folder
        self.rng = np.random.default_rng(plan.seed)
        self.instrument = INSTRUMENTS[plan.instrument]
        self.unit = plan.unit
        self.site = None if plan.laboratory else Site.of_height(plan.height, plan.units, parapet=plan.instrument != "tls")
        # x along the wall, y out to sea: y points to the azimuth of the outward normal
        azimuth = math.radians(plan.azimuth_deg)
        along, out = [math.cos(azimuth), -math.sin(azimuth), 0.0], [math.sin(azimuth), math.cos(azimuth), 0.0]
        self.frame = _Frame(np.array(plan.origin, dtype=float), np.array([along, out, [0.0, 0.0, 1.0]]).T)
        self.digits = 6 if plan.laboratory else 5
        self.cells = surface_cells(self.unit, 400)[0]
        self.units_rows: list[list[object]] = []
        self.feature_rows: list[list[object]] = []
        self.move_rows: list[list[object]] = []
        self.times = _times(plan)

    def run(self, report: Callable[[float, str], None]) -> None:
        plan, rng = self.plan, self.rng
        report(0.0, f"settling {plan.units} units")
        if self.site is None:
            pile = settle_models(self.unit, plan.units, rng)
        else:
            pile = settle(self.unit, self.site, plan.units, rng, broken=round(plan.units / 38))
        (self.folder / "truth").mkdir()
        targets = self._targets()
        checks = pile[:0]
        next_number = plan.units + 1
        for k, time in enumerate(self.times):
            report((k + 0.3) / plan.epochs, f"surveying epoch {_label(time)}")
            before = pile
            gone: tuple[int, ...] = ()
            if k:
                ground = self.site or Site(1.0, 0.0, 0.0, 0.0, -1e3, 0.0, 1e3, 1.0, -1.0)
                pile, gone = change(pile, self.unit, ground, self._changes(len(pile)), rng, next_number=next_number, planar=plan.laboratory)
                next_number = max([next_number, *(u.number + 1 for u in pile)])
            scene = Scene(pile, self.unit, self.site, self.instrument.surfaces, plan.seed)
            cloud = self.instrument.scan(
                scene,
                rng,
                density=plan.density or self.instrument.density * (1.0 if plan.laboratory else (2.3 / plan.height) ** 2),
                noise=plan.noise or self.instrument.noise,
                offset=self.instrument.offset,
            )
            seen = self._record_units(pile, gone, cloud, time)
            if k == 0:
                best = sorted(pile, key=lambda u: -seen[u.number])
                step = max(1, len(best) // 20)
                checks = tuple(best[::step][:10])
            self._record_moves(before if k else (), pile, k)
            self._write_control(targets, time, disturbed=k == 1)
            self._write_tiles(cloud, time)
            self._write_sensors(cloud, time)
            self._write_checks(checks, pile, time)
        self._write_truth()
        self._write_toml()

    def _changes(self, count: int) -> Changes:
        if self.plan.changes is not None:
            return self.plan.changes
        if self.plan.laboratory:
            return Changes(moved=max(1, count - 1))
        return Changes(moved=round(0.15 * count), removed=round(0.025 * count), new=round(0.013 * count), relocated=round(0.013 * count))

    def _targets(self) -> FloatArray:
        """Targets in the site frame: along the crown wall and the landward edge of the deck, or on board and table."""
        if self.site is None:
            h = self.plan.height
            return h * np.array(
                [[-2.4, 0, 0.4], [-0.9, 0, 2.0], [1.1, 0, 1.9], [2.5, 0, 0.5], [-2.5, 2.9, 0], [0.2, 3.3, 0], [2.4, 2.8, 0]]
            )
        h = self.plan.height / 2.3
        reach = self.site.half_length - 0.6 * h
        front = [[f * reach, self.site.wall - 0.25 * h, self.site.deck + self.site.parapet] for f in (-0.9, -0.45, -0.08, 0.32, 0.88)]
        back = [[f * reach, 0.8 * h, self.site.deck] for f in (-0.75, 0.05, 0.6)]
        places = np.array(front + back)
        places[:, 0] += self.rng.uniform(-0.4, 0.4, len(places)) * h
        return places

    def _record_units(self, pile: tuple[PiledUnit, ...], gone: tuple[int, ...], cloud: Returns, time: datetime) -> dict[int, float]:
        label, digits = _label(time), self.digits
        order = np.argsort(cloud.labels, kind="stable")
        sorted_labels = cloud.labels[order]
        seen: dict[int, float] = {}
        for u in sorted(pile, key=lambda v: v.number):
            shape = u.shape(self.unit)
            a, b = np.searchsorted(sorted_labels, [u.number, u.number + 1])
            body = u.pose.to_body(cloud.points[order[a:b]])
            scaled = body / u.scale
            cells = np.unique(cKDTree(self.cells).query(scaled)[1]) if len(body) else np.empty(0)
            seen[u.number] = len(cells) / len(self.cells)
            legs = np.bincount(np.argmax(body @ shape.leg_directions.T, axis=1), minlength=4) if len(body) else np.zeros(4)
            pose = self.frame.pose(u.pose)
            centre = [f"{v:.{digits}f}" for v in pose.centre]
            qx, qy, qz, qw = (round(float(q), 7) for q in pose.quaternion())
            self.units_rows.append(
                [
                    *(f"U{u.number:03d}", label, *centre, qw, qx, qy, qz, round(shape.height, 5), round(seen[u.number], 4)),
                    *(len(body), int(np.sum(legs >= 40)), int(u.broken_leg >= 0), u.status),
                ]
            )
            facing_centre = int(seen[u.number] >= 0.05)
            self.feature_rows.append([f"U{u.number:03d}", label, "centre", *centre, facing_centre])
            for name, opposite, place in zip(FEATURES[1:], _OPPOSITE, body_features(shape)[1:], strict=True):
                near = body[np.linalg.norm(body - place, axis=1) < 0.16 * shape.height]
                three = len(near) > 0 and len(set(np.argmax(near @ shape.leg_directions.T, axis=1).tolist()) - {opposite}) == 3
                self.feature_rows.append([f"U{u.number:03d}", label, name, *(f"{v:.{digits}f}" for v in pose.to_frame(place)), int(three)])
        for number in gone:
            self.units_rows.append([f"U{number:03d}", label, *[""] * 12, "removed"])
        return seen

    def _record_moves(self, before: Iterable[PiledUnit], pile: tuple[PiledUnit, ...], epoch: int) -> None:
        after = {u.number: u for u in pile}
        for old in before:
            new = after.get(old.number)
            if new is None:
                continue
            shift = self.frame.turn @ (new.pose.centre - old.pose.centre)
            angle = math.degrees(Rotation.from_matrix(new.pose.rotation @ old.pose.rotation.T).magnitude())
            moved = int(new.status != "stable")
            row = [f"U{old.number:03d}", _label(self.times[epoch - 1]), _label(self.times[epoch])]
            self.move_rows.append(
                [*row, *(f"{v:.{self.digits}f}" for v in shift), f"{np.linalg.norm(shift):.{self.digits}f}", round(angle, 4), moved]
            )

    def _write_control(self, targets: FloatArray, time: datetime, *, disturbed: bool) -> None:
        """Surveyed targets, and the registration error of this epoch with the targets as the cloud shows them."""
        s, rng = self.instrument, self.rng
        digits = 5 if self.plan.laboratory else 4
        truth = self.frame.place(targets)
        surveyed = truth + rng.normal(0, s.control, truth.shape)
        rows = [[f"T{k + 1:02d}", *(f"{v:.{digits}f}" for v in p), *[s.control] * 3] for k, p in enumerate(surveyed)]
        _write_csv(self.folder / f"control_{_label(time)}.csv", "point_id,easting,northing,height,sd_e,sd_n,sd_h", rows)
        self.shift = rng.normal(0, s.registration, 3)
        self.turn = Rotation.from_rotvec(np.radians(rng.normal(0, s.turn_deg, 3)))
        measured = self._in_cloud(truth) + rng.normal(0, s.target, truth.shape)
        if disturbed:
            # knocked between the total-station survey and the scan
            direction = rng.normal(size=3)
            measured[int(rng.integers(0, len(measured)))] += direction / np.linalg.norm(direction) * 12 * s.target
        rows = [[f"T{k + 1:02d}", *(f"{v:.{digits}f}" for v in p)] for k, p in enumerate(measured)]
        _write_csv(self.folder / f"targets_{_label(time)}.csv", "point_id,x,y,z", rows)

    def _in_cloud(self, truth: FloatArray) -> FloatArray:
        middle = self.frame.origin
        return np.asarray(self.turn.apply(truth - middle) + middle + self.shift)

    def _write_tiles(self, cloud: Returns, time: datetime) -> None:
        points = self._in_cloud(self.frame.place(cloud.points))
        label = _label(time)
        folder = self.folder / "tiles" / label
        folder.mkdir(parents=True)
        edges = [_edges(np.median(self.frame.place(cloud.points)[:, k]), points[:, k], n, self.plan) for k, n in enumerate(self.plan.tiles)]
        column, row = (np.searchsorted(edges[k], points[:, k], side="right") for k in (0, 1))
        labels: dict[str, NDArray[np.int16]] = {}
        for i in range(self.plan.tiles[0]):
            for j in range(self.plan.tiles[1]):
                inside = np.flatnonzero((column == i) & (row == j))
                if len(inside) == 0:
                    continue
                name = f"{self.plan.name}_{label.replace('-', '')}_{i}{j}"
                _write_las(folder / f"{name}.laz", points[inside], cloud.chosen(inside), self.plan, time, self.instrument.generator)
                labels[name] = cloud.labels[inside].astype(np.int16)
        np.savez_compressed(self.folder / "truth" / f"labels_{label}.npz", **labels)  # type: ignore[arg-type]

    def _write_sensors(self, cloud: Returns, time: datetime) -> None:
        """Where the scanner was, in the frame of the cloud: a trajectory by GPS time for the UAV, stations for the tripod."""
        kind = SENSOR_FILES.get(self.plan.instrument)
        if kind is None:
            return
        rows: list[list[object]] = []
        for source in np.unique(cloud.source):
            own = np.flatnonzero(cloud.source == source)
            moments = cloud.time[own]
            order = np.argsort(moments, kind="stable")
            if kind == "trajectory":
                # to the very first and last pulse of the line, ten times a second between
                steps = np.linspace(moments.min(), moments.max(), 2 + int(10 * np.ptp(moments)))
                places = np.column_stack([np.interp(steps, moments[order], cloud.sensor[own[order], k]) for k in range(3)])
                names = [repr(float(v)) for v in _gps_seconds(time) + steps]
            else:
                places, names = cloud.sensor[own[:1]], [str(int(source))]
            placed = self._in_cloud(self.frame.place(places))
            rows += [[name, *(f"{v:.4f}" for v in place)] for name, place in zip(names, placed, strict=True)]
        first = "gps_time" if kind == "trajectory" else "point_source_id"
        _write_csv(self.folder / f"{kind}_{_label(time)}.csv", f"{first},x,y,z", rows)

    def _write_checks(self, checks: Iterable[PiledUnit], pile: tuple[PiledUnit, ...], time: datetime) -> None:
        """Feature points by total station: those that can be seen, with the same name in every epoch."""
        label = _label(time)
        now = {u.number: u for u in pile}
        visible = {(r[0], r[2]) for r in self.feature_rows if r[1] == label and r[6] == 1}
        sd = self.instrument.control
        rows: list[list[object]] = []
        for k, check in enumerate(checks):
            u = now.get(check.number)
            if u is None:
                continue
            shape, pose = u.shape(self.unit), self.frame.pose(u.pose)
            for name, place in zip(FEATURES[1:], body_features(shape)[1:], strict=True):
                if (f"U{u.number:03d}", name) not in visible:
                    continue
                point = pose.to_frame(place) + self.rng.normal(0, sd, 3)
                rough = pose.centre + self.rng.normal(0, 0.03 * shape.height, 3)
                decimals, fine = (3, 5) if self.plan.laboratory else (2, 4)
                rows.append([f"K{k + 1:02d}{name[1:]}", *(round(float(v), decimals) for v in rough), *(f"{v:.{fine}f}" for v in point), sd])
                if not self.plan.laboratory:
                    break
        header = "point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd"
        _write_csv(self.folder / f"check_{label}.csv", header, rows)

    def _write_truth(self) -> None:
        truth = self.folder / "truth"
        _write_csv(
            truth / "units.csv",
            "unit_id,epoch,E,N,H,qw,qx,qy,qz,height,visible_area_fraction,n_points,legs_visible,broken,status",
            self.units_rows,
        )
        _write_csv(truth / "feature_points.csv", "unit_id,epoch,feature,E,N,H,facing", self.feature_rows)
        _write_csv(truth / "displacements.csv", "unit_id,epoch_from,epoch_to,de,dn,dh,d_3d,rotation_deg,moved", self.move_rows)

    def _write_toml(self) -> None:
        plan, unit = self.plan, self.unit
        lines = ["[survey]", f'name = "{plan.name}"', f'crs = "{plan.crs}"', f'description = "simulated: {self.instrument.generator}"', ""]
        lines += [
            "[unit]",
            'type = "tetrapod"',
            f"height = {plan.height!r}",
            f"radius = {unit.radius:.5f}",
            f"gradient = {unit.gradient:.5f}",
        ]
        lines += [f"leg_length = {unit.leg_length:.5f}", f'opening = "{unit.opening}"']
        for time in self.times:
            label = _label(time)
            lines += ["", "[[epoch]]", f'label = "{label}"', f"time = {time:%Y-%m-%dT%H:%M:%SZ}", f'tiles = "tiles/{label}/*.laz"']
            lines += [f'{kind} = "{kind}_{label}.csv"' for kind in ("control", "targets", "check")]
            if plan.instrument in SENSOR_FILES:
                kind = SENSOR_FILES[plan.instrument]
                lines += [f'# {kind} = "{kind}_{label}.csv"  # with the next two, points are weighted along and across their beams']
                lines += [f"# range_sd = {plan.noise or self.instrument.noise}", f"# angle_sd = {ANGLE_SD}"]
        (self.folder / "survey.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")


def _vet_crs(plan: SimulationPlan) -> None:
    if plan.crs == "LOCAL":
        return
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    for name in (plan.crs, plan.las_crs or plan.crs):
        try:
            crs = CRS.from_user_input(name)
        except CRSError as cause:
            raise CrsError(f"{name!r} is not a CRS", where="crs", remedy="Give an EPSG code or LOCAL.") from cause
        if not (crs.sub_crs_list[0] if crs.is_compound else crs).is_projected:
            raise CrsError(f"{name} is not projected", where="crs", remedy="Give a projected CRS or LOCAL.")


def _times(plan: SimulationPlan) -> tuple[datetime, ...]:
    """Epochs half a year apart, a day apart in the laboratory."""
    gap = timedelta(days=1) if plan.laboratory else timedelta(days=183)
    start = datetime(plan.first_day.year, plan.first_day.month, plan.first_day.day, 2, 30, tzinfo=UTC)
    return tuple(start + k * (gap + timedelta(minutes=67)) for k in range(plan.epochs))


def _label(time: datetime) -> str:
    return f"{time:%Y-%m-%d}"


def _edges(middle: float, values: FloatArray, count: int, plan: SimulationPlan) -> FloatArray:
    """Inner tile edges at round coordinates, about equal strips."""
    if count == 1:
        return np.array([])
    low, high = float(values.min()), float(values.max())
    inner = low + (high - low) * np.arange(1, count) / count
    if count == 2:
        inner = np.array([middle])
    step = 0.02 if plan.laboratory else 0.5
    return np.asarray(np.round(inner / step) * step)


def _write_las(path: Path, points: FloatArray, cloud: Returns, plan: SimulationPlan, time: datetime, generator: str) -> None:
    import laspy
    from laspy.vlrs.known import WktCoordinateSystemVlr
    from pyproj import CRS

    header = laspy.LasHeader(version="1.4", point_format=6)
    scale, block = (0.0001, 1.0) if plan.laboratory else (0.001, 100.0)
    header.scales = np.full(3, scale)
    header.offsets = np.floor(np.append(points[0, :2], 0.0) / block) * block
    header.generating_software = generator
    header.creation_date = time.date()
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.STANDARD
    header.global_encoding.wkt = True
    wkt = LOCAL_WKT if plan.crs == "LOCAL" else CRS.from_user_input(plan.las_crs or plan.crs).to_wkt("WKT1_GDAL")
    header.vlrs.append(WktCoordinateSystemVlr(wkt))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points[:, 0], points[:, 1], points[:, 2]
    las.intensity = cloud.intensity
    las.return_number = cloud.return_number
    las.number_of_returns = cloud.returns
    las.classification = np.ones(len(points), dtype=np.uint8)
    las.point_source_id = cloud.source.astype(np.uint16)
    las.gps_time = _gps_seconds(time) + cloud.time
    las.write(str(path))


def _gps_seconds(time: datetime) -> float:
    """Adjusted standard GPS time: seconds since 1980-01-06 less 1e9; 18 leap seconds since 2017."""
    return (time - datetime(1980, 1, 6, tzinfo=UTC)).total_seconds() + 18 - 1e9


def _write_csv(path: Path, header: str, rows: Iterable[Iterable[object]]) -> None:
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header.split(","))
        writer.writerows(rows)


def plan_of(
    instrument: str,
    name: str,
    unit: UnitType | None = None,
    *,
    units: int | None = None,
    epochs: int = 2,
    seed: int = 0,
    density: float | None = None,
    noise: float | None = None,
    crs: str = SimulationPlan.crs,
) -> SimulationPlan:
    """Plan for one instrument with a place and numbers that suit it: a breakwater, or models on a table for the depth camera.

    Raises
    ------
    InputError
        Something cannot be simulated; it names the field.
    """
    if instrument not in INSTRUMENTS:
        raise InputError(f"instrument {instrument!r} is not known", where="instrument", remedy=f"Use one of: {', '.join(INSTRUMENTS)}.")
    laboratory = SimulationPlan(
        name, "depth_camera", 4, 0.105, crs="LOCAL", origin=(1.0, 1.8, 0.75), azimuth_deg=0.0, tiles=(2, 1), first_day=date(2025, 2, 10)
    )
    base = laboratory if instrument == "depth_camera" else SimulationPlan(name, instrument, crs=crs)
    if unit is not None:
        base = replace(
            base, height=unit.height, radius=unit.radius, gradient=unit.gradient, leg_length=unit.leg_length, opening=unit.opening
        )
    return replace(base, units=base.units if units is None else units, epochs=epochs, seed=seed, density=density, noise=noise)
