"""One pile surveyed in its epochs, and the files of that: tiles, control, targets, check points, sensors and ground truth."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..model.feature_points import FEATURES, body_features
from ..model.pose import Pose
from ..model.tetrapod import surface_cells
from .armour_pile import Changes, PiledUnit, Site, change, settle, settle_models
from .bent_frames import FrameOfEpoch
from .castings import SIZE_SD
from .leg_truth import COLUMNS, leg_columns
from .survey_files import gps_seconds, tile_edges, write_csv, write_las
from .survey_plan import SimulationPlan
from .virtual_instruments import ANGLE_SD, INSTRUMENTS, SENSOR_FILES
from .virtual_scanner import Returns
from .virtual_scene import Scene, Surfaces

TABLE_GROUND = Site(half_length=1.0, deck=0.0, deck_width=0.0, parapet=0.0, wall=-1e3, bench=0.0, bench_end=1e3, slope=1.0, bed=-1.0)
"""The plane on which models are moved about."""
_OPPOSITE = (3, 2, 1, 0)
"""Leg opposite to each feature point."""


@dataclass(frozen=True, eq=False)
class SiteFrame:
    """Site frame to survey CRS, and the survey CRS to the frame of an epoch's cloud."""

    origin: FloatArray
    turn: FloatArray

    def place(self, points: FloatArray) -> FloatArray:
        """(n, 3) points of the site in the CRS of the survey."""
        return np.asarray(points @ self.turn.T + self.origin)

    def pose(self, pose: Pose) -> Pose:
        """A pose of the site in the CRS of the survey."""
        return Pose(self.place(pose.centre), self.turn @ pose.rotation)


class Simulation:
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
        self.frame = SiteFrame(np.array(plan.origin, dtype=float), np.array([along, out, [0.0, 0.0, 1.0]]).T)
        self.digits = 6 if plan.laboratory else 5
        self.cells = surface_cells(self.unit, 400)[0]
        self.units_rows: list[list[object]] = []
        self.feature_rows: list[list[object]] = []
        self.move_rows: list[list[object]] = []
        self.times = _times(plan)
        self.controlled = plan.length <= 0 or plan.targets_every > 0

    def run(self, report: Callable[[float, str], None]) -> None:
        """Simulate all epochs and write the files."""
        plan, rng = self.plan, self.rng
        report(0.0, f"settling {plan.units} units")
        if self.site is None:
            pile = settle_models(self.unit, plan.units, rng)
        else:
            pile = settle(self.unit, self.site, plan.units, rng, broken=plan.broken_units, size_sd=SIZE_SD if plan.castings else 0.003)
        (self.folder / "truth").mkdir()
        targets = self.targets()
        checks = pile[:0]
        next_number = plan.units + 1
        for k, time in enumerate(self.times):
            report((k + 0.3) / plan.epochs, f"surveying epoch {label_of(time)}")
            before = pile
            gone: tuple[int, ...] = ()
            if k:
                ground = self.site or TABLE_GROUND
                pile, gone = change(pile, self.unit, ground, self._changes(len(pile)), rng, next_number=next_number, planar=plan.laboratory)
                next_number = max([next_number, *(u.number + 1 for u in pile)])
            scene = Scene(pile, self.unit, self.site, self._surfaces(), plan.seed, epoch=k)
            cloud = self._scanned(scene, rng, self.instrument.offset, k, rng)
            seen = self._record_units(pile, gone, cloud, time)
            if k == 0:
                best = sorted(pile, key=lambda u: -seen[u.number])
                step = max(1, len(best) // 20)
                checks = tuple(best[::step][:10])
            self._record_moves(before if k else (), pile, k)
            self.write_control(targets, time, disturbed=k == 1)
            self._write_tiles(cloud, time)
            self.write_sensors(cloud, time)
            self._write_checks(checks, pile, time)
        self._write_truth()
        self._write_toml()

    def _surfaces(self) -> Surfaces:
        return replace(self.instrument.surfaces, castings=self.plan.castings, bridging=self.plan.bridging)

    def _scanned(self, scene: Scene, rng: np.random.Generator, offset: float, epoch: int, views: np.random.Generator) -> Returns:
        """The instrument's points of a scene; ``views`` draws other lines or stations of later epochs."""
        plan = self.plan
        return self.instrument.scan(
            scene,
            rng,
            density=plan.density or self.instrument.density * (1.0 if plan.laboratory else (2.3 / plan.height) ** 2),
            noise=plan.noise or self.instrument.noise,
            offset=offset,
            views=views if plan.other_views and epoch > 0 else None,
        )

    def unit_name(self, number: int) -> str:
        """Name of a unit in ``truth/``."""
        return f"U{number:03d}"

    def _changes(self, count: int) -> Changes:
        if self.plan.changes is not None:
            return self.plan.changes
        if self.plan.laboratory:
            return Changes(moved=max(1, count - 1))
        return Changes(moved=round(0.15 * count), removed=round(0.025 * count), new=round(0.013 * count), relocated=round(0.013 * count))

    def targets(self) -> FloatArray:
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
        label, digits = label_of(time), self.digits
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
                    *(self.unit_name(u.number), label, *centre, qw, qx, qy, qz, round(shape.height, 5), round(seen[u.number], 4)),
                    *(len(body), int(np.sum(legs >= 40)), int(u.broken_leg >= 0), u.status),
                    *leg_columns(u, self.unit, scaled, self.cells, cloud),
                ]
            )
            facing_centre = int(seen[u.number] >= 0.05)
            name_of_unit = self.unit_name(u.number)
            self.feature_rows.append([name_of_unit, label, "centre", *centre, facing_centre])
            for name, opposite, place in zip(FEATURES[1:], _OPPOSITE, body_features(shape)[1:], strict=True):
                near = body[np.linalg.norm(body - place, axis=1) < 0.16 * shape.height]
                three = len(near) > 0 and len(set(np.argmax(near @ shape.leg_directions.T, axis=1).tolist()) - {opposite}) == 3
                at = (f"{v:.{digits}f}" for v in pose.to_frame(place))
                self.feature_rows.append([name_of_unit, label, name, *at, int(three)])
        for number in gone:
            self.units_rows.append([self.unit_name(number), label, *[""] * 12, "removed", *[""] * len(COLUMNS)])
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
            row = [self.unit_name(old.number), label_of(self.times[epoch - 1]), label_of(self.times[epoch])]
            self.move_rows.append(
                [*row, *(f"{v:.{self.digits}f}" for v in shift), f"{np.linalg.norm(shift):.{self.digits}f}", round(angle, 4), moved]
            )

    def write_control(self, targets: FloatArray, time: datetime, *, disturbed: bool) -> None:
        """Surveyed targets, and the registration error of this epoch with the targets as the cloud shows them."""
        s, rng = self.instrument, self.rng
        digits = 5 if self.plan.laboratory else 4
        truth = self.frame.place(targets)
        seen = self.frame.place(targets + self._bent(time).at(targets))
        surveyed = truth + rng.normal(0, s.control, truth.shape)
        rows = [[f"T{k + 1:02d}", *(f"{v:.{digits}f}" for v in p), *[s.control] * 3] for k, p in enumerate(surveyed)]
        write_csv(self.folder / f"control_{label_of(time)}.csv", "point_id,easting,northing,height,sd_e,sd_n,sd_h", rows)
        self._misplace()
        measured = self.in_cloud(seen) + rng.normal(0, s.target, truth.shape)
        if disturbed:
            # knocked between the total-station survey and the scan
            direction = rng.normal(size=3)
            measured[int(rng.integers(0, len(measured)))] += direction / np.linalg.norm(direction) * 12 * s.target
        rows = [[f"T{k + 1:02d}", *(f"{v:.{digits}f}" for v in p)] for k, p in enumerate(measured)]
        write_csv(self.folder / f"targets_{label_of(time)}.csv", "point_id,x,y,z", rows)

    def _misplace(self) -> None:
        """Draw how the epoch's cloud lies in the survey's frame."""
        self.shift = self.rng.normal(0, self.instrument.registration, 3)
        self.turn = Rotation.from_rotvec(np.radians(self.rng.normal(0, self.instrument.turn_deg, 3)))

    def _bent(self, time: datetime) -> FrameOfEpoch:
        length, across = (self.site.half_length, self.site.across) if self.site is not None else (3 * self.plan.height, (0.0, 0.0))
        return FrameOfEpoch(self.plan.frame, self.times.index(time), length, self.plan.seed, across=across)

    def in_cloud(self, truth: FloatArray) -> FloatArray:
        """(n, 3) points in the CRS of the survey where this epoch's cloud, which errs in its registration, shows them."""
        middle = self.frame.origin
        return np.asarray(self.turn.apply(truth - middle) + middle + self.shift)

    def registered(self, cloud: Returns, time: datetime) -> FloatArray:
        """(n, 3) points as the epoch's cloud has them: bent, turned and shifted, in the survey's CRS."""
        bent = cloud.points + self._bent(time).at(cloud.points, cloud.source)
        return self.in_cloud(self.frame.place(bent))

    def _write_tiles(self, cloud: Returns, time: datetime) -> None:
        points = self.registered(cloud, time)
        label = label_of(time)
        folder = self.folder / "tiles" / label
        folder.mkdir(parents=True)
        middle = np.median(self.frame.place(cloud.points), axis=0)
        edges = [tile_edges(middle[k], points[:, k], n, self.plan) for k, n in enumerate(self.plan.tiles)]
        column, row = (np.searchsorted(edges[k], points[:, k], side="right") for k in (0, 1))
        labels: dict[str, NDArray[np.int16]] = {}
        for i in range(self.plan.tiles[0]):
            for j in range(self.plan.tiles[1]):
                inside = np.flatnonzero((column == i) & (row == j))
                if len(inside) == 0:
                    continue
                name = f"{self.plan.name}_{label.replace('-', '')}_{i}{j}"
                write_las(folder / f"{name}.laz", points[inside], cloud.chosen(inside), self.plan, time, self.instrument.generator)
                labels[name] = cloud.labels[inside].astype(np.int16)
        np.savez_compressed(self.folder / "truth" / f"labels_{label}.npz", **labels)  # type: ignore[arg-type]

    def write_sensors(self, cloud: Returns, time: datetime) -> None:
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
                names = [repr(float(v)) for v in gps_seconds(time) + steps]
            else:
                places, names = cloud.sensor[own[:1]], [str(int(source))]
            placed = self.in_cloud(self.frame.place(places))
            rows += [[name, *(f"{v:.4f}" for v in place)] for name, place in zip(names, placed, strict=True)]
        first = "gps_time" if kind == "trajectory" else "point_source_id"
        write_csv(self.folder / f"{kind}_{label_of(time)}.csv", f"{first},x,y,z", rows)

    def _write_checks(self, checks: Iterable[PiledUnit], pile: tuple[PiledUnit, ...], time: datetime) -> None:
        """Feature points by total station: those that can be seen, with the same name in every epoch."""
        label = label_of(time)
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
                if (self.unit_name(u.number), name) not in visible:
                    continue
                point = pose.to_frame(place) + self.rng.normal(0, sd, 3)
                rough = pose.centre + self.rng.normal(0, 0.03 * shape.height, 3)
                decimals, fine = (3, 5) if self.plan.laboratory else (2, 4)
                rows.append([f"K{k + 1:02d}{name[1:]}", *(round(float(v), decimals) for v in rough), *(f"{v:.{fine}f}" for v in point), sd])
                if not self.plan.laboratory:
                    break
        header = "point_id,unit_easting,unit_northing,unit_height,easting,northing,height,sd"
        write_csv(self.folder / f"check_{label}.csv", header, rows)

    def _write_truth(self) -> None:
        truth = self.folder / "truth"
        write_csv(
            truth / "units.csv",
            "unit_id,epoch,E,N,H,qw,qx,qy,qz,height,visible_area_fraction,n_points,legs_visible,broken,status," + ",".join(COLUMNS),
            self.units_rows,
        )
        write_csv(truth / "feature_points.csv", "unit_id,epoch,feature,E,N,H,facing", self.feature_rows)
        write_csv(truth / "displacements.csv", "unit_id,epoch_from,epoch_to,de,dn,dh,d_3d,rotation_deg,moved", self.move_rows)

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
            label = label_of(time)
            lines += ["", "[[epoch]]", f'label = "{label}"', f"time = {time:%Y-%m-%dT%H:%M:%SZ}", f'tiles = "tiles/{label}/*.laz"']
            lines += [f'{kind} = "{kind}_{label}.csv"' for kind in (*(("control", "targets") if self.controlled else ()), "check")]
            if plan.instrument in SENSOR_FILES:
                kind = SENSOR_FILES[plan.instrument]
                lines += [f'# {kind} = "{kind}_{label}.csv"  # with the next two, points are weighted along and across their beams']
                lines += [f"# range_sd = {plan.noise or self.instrument.noise}", f"# angle_sd = {ANGLE_SD}"]
        (self.folder / "survey.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")


def _times(plan: SimulationPlan) -> tuple[datetime, ...]:
    """Epochs half a year apart, a day apart in the laboratory."""
    gap = timedelta(days=1) if plan.laboratory else timedelta(days=183)
    start = datetime(plan.first_day.year, plan.first_day.month, plan.first_day.day, 2, 30, tzinfo=UTC)
    return tuple(start + k * (gap + timedelta(minutes=67)) for k in range(plan.epochs))


def label_of(time: datetime) -> str:
    """Label of an epoch, its day."""
    return f"{time:%Y-%m-%d}"
