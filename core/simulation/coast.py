"""Coasts of any length: stretches of one length side by side, each with its own changes, surfaces and noise on one of a few settled piles.

What costs time is settling; a settled pile is used for every third stretch, its units with relief, growth and movements of their own.
Lines of flight and the errors of a trajectory run through all stretches. Tripods see the neighbours of their stretch too, so that
stations overlap along the wall. Points are written as they are measured, so that memory does not grow with the coast.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import FloatArray
from .armour_pile import PiledUnit, change, settle
from .bent_frames import FrameOfEpoch
from .castings import SIZE_SD
from .survey_files import write_las
from .survey_plan import STRETCH_NUMBERS, SimulationPlan
from .survey_simulation import Simulation, label_of
from .virtual_scanner import Returns
from .virtual_scene import Scene

PILES = 3
"""Piles that are settled."""
STATIONS = 8
"""Numbers of lines or stations that one stretch may take."""
LINE_SECONDS = 50.0
"""Time in which a line passes a stretch, or a station is scanned."""
SLIDING = np.array([0.0, math.sqrt(0.5), -math.sqrt(0.5)])
"""Direction of a slide: seaward and down."""
CHECKED = 2
"""Check points of a stretch."""
SENSOR_PLACES = 450
"""Places of the instrument that are kept of one line over one stretch."""
TARGETS = 5
"""Targets of a station: three on the crown wall, two on the landward edge of the deck."""

Pile = tuple[PiledUnit, ...]


class CoastSimulation(Simulation):
    """One run for a plan with a ``length``."""

    def __init__(self, plan: SimulationPlan, folder: Path) -> None:
        super().__init__(plan, folder)
        if self.site is None:
            raise ValueError("a laboratory has no coast")
        self.stretch = self.site
        self.core = self.site.half_length
        self.count = max(1, math.ceil(plan.length / (2 * self.core) - 1e-9))
        # as far as an instrument sees from its stretch
        self.seen = replace(self.site, half_length=(3 if plan.instrument == "tls" else 1) * self.core)
        self.checked: list[Pile] = [()] * self.count

    def run(self, report: Callable[[float, str], None]) -> None:
        """Settle, survey and write; ``report`` is told the share done and what is being done."""
        plan = self.plan
        now = self._settled(report)
        (self.folder / "truth").mkdir()
        targets = self.targets()
        for epoch, time in enumerate(self.times):
            before = now
            gone: list[tuple[int, ...]] = [()] * self.count
            if epoch:
                changed = [self._changed(k, before[k], epoch) for k in range(self.count)]
                now, gone = [pile for pile, _ in changed], [numbers for _, numbers in changed]
            if self.controlled:
                self.write_control(targets, time, disturbed=epoch == 1)
            else:
                self._misplace()
            for k, done in enumerate(self._surveyed(epoch, now, gone)):
                report((epoch + k / (self.count + 1)) / plan.epochs, f"surveying epoch {label_of(time)}, {done}")
            for k in range(self.count if epoch else 0):
                self._record_moves(before[k], now[k], epoch)
            self._write_checks(
                [u for pile in self.checked for u in pile], tuple(u for k in range(self.count) for u in self._on_coast(k, now[k])), time
            )
        self._write_truth()
        self._write_toml()

    def _settled(self, report: Callable[[float, str], None]) -> list[Pile]:
        """Piles of all stretches, each in its stretch's own frame."""
        plan = self.plan
        piles = []
        for k in range(min(PILES, self.count)):
            report(0.0, f"settling {plan.units} units, pile {k + 1}")
            rng = np.random.default_rng([plan.seed, 1, k])
            size_sd = SIZE_SD if plan.castings else 0.003
            piles.append(settle(self.unit, self.stretch, plan.units, rng, broken=plan.broken_units, size_sd=size_sd))
        return [tuple(replace(u, number=STRETCH_NUMBERS * k + u.number) for u in piles[k % len(piles)]) for k in range(self.count)]

    def _changed(self, k: int, pile: Pile, epoch: int) -> tuple[Pile, tuple[int, ...]]:
        """A stretch's units in the next epoch, and the numbers of those gone."""
        rng = np.random.default_rng([self.plan.seed, 2, epoch, k])
        number = 1 + max(u.number for u in pile)
        changed, gone = change(pile, self.unit, self.stretch, self._changes(len(pile)), rng, next_number=number)
        if epoch == 1 and k == self.count // 2 and self.plan.slide > 0:
            changed = tuple(
                replace(u, pose=u.pose.shifted(self.plan.slide * SLIDING), status="moved" if u.status == "stable" else u.status)
                for u in changed
            )
        return changed, gone

    def _surveyed(self, epoch: int, now: Sequence[Pile], gone: Sequence[tuple[int, ...]]) -> Iterator[str]:
        """Scan stretch after stretch; units are recorded once their neighbours are scanned, points written once no one adds to them."""
        time = self.times[epoch]
        tiles = _Tiles(self, time)
        window: list[Returns] = []
        for k in range(self.count + 1):
            last = k == self.count
            if not last:
                window = [*window[-2:], self._scan(k, epoch, now)]
                tiles.add(window[-1])
            else:
                window = window[-2:]
            if k:
                seen = self._record_units(self._on_coast(k - 1, now[k - 1]), gone[k - 1], Returns.joined(window), time)
                if epoch == 0:
                    self.checked[k - 1] = tuple(sorted(now[k - 1], key=lambda u: -seen[u.number])[:CHECKED])
            tiles.write(math.inf if last else self._middle(k) + self.core - self.seen.half_length)
            yield f"stretch {min(k + 1, self.count)} of {self.count}"
        tiles.finish()

    def _scan(self, k: int, epoch: int, now: Sequence[Pile]) -> Returns:
        """Points of one stretch's instruments in the frame of the coast."""
        plan, reach = self.plan, round(self.seen.half_length / self.core) // 2
        near = range(max(k - reach, 0), min(k + reach + 1, self.count))
        units = tuple(_shifted(u, self._middle(m) - self._middle(k)) for m in near for u in now[m])
        scene = Scene(units, self.unit, self.seen, self._surfaces(), plan.seed, core=self.core, along=self._middle(k), epoch=epoch)
        lines = plan.instrument == "uav"
        # lines run through all stretches, tripods stand anew in each
        views = np.random.default_rng([plan.seed, 3, epoch, *(() if lines else (k,))])
        rng = np.random.default_rng([plan.seed, 4, epoch, k])
        cloud = self._scanned(scene, rng, 0.0 if lines else self.instrument.offset, epoch, views)
        place = np.array([self._middle(k), 0.0, 0.0])
        points = cloud.points + place
        sensor = cloud.sensor + place
        if plan.instrument == "photogrammetry":
            return replace(cloud, points=points, sensor=sensor)
        within = cloud.time - LINE_SECONDS * cloud.source
        if lines:
            offsets = np.random.default_rng([plan.seed, 5, epoch]).uniform(-1, 1, (STATIONS, 3)) * self.instrument.offset
            started = LINE_SECONDS * (cloud.source * self.count + k)
            return replace(cloud, points=points + offsets[cloud.source], time=np.asarray(started + within), sensor=sensor)
        source = STATIONS * k + cloud.source
        return replace(cloud, points=points, source=source, time=np.asarray(LINE_SECONDS * source + within), sensor=sensor)

    def _middle(self, k: int) -> float:
        """Where a stretch's middle lies along the coast, metres."""
        return (2 * k + 1 - self.count) * self.core

    def _on_coast(self, k: int, pile: Pile) -> Pile:
        return tuple(_shifted(u, self._middle(k)) for u in pile)

    def unit_name(self, number: int) -> str:
        """Name of a unit in ``truth/``: number in its stretch, and stretch."""
        return f"U{number % STRETCH_NUMBERS:03d}_{number // STRETCH_NUMBERS:03d}"

    def targets(self) -> FloatArray:
        """Stations of five targets, the first and the last near the ends of the coast."""
        every = self.plan.targets_every
        if every <= 0:
            return np.zeros((0, 3))
        h = self.plan.height / 2.3
        low = -self.count * self.core + 5 * h
        stations = np.arange(low, -low + 1e-6, every)
        places = []
        for middle in stations:
            along = middle + np.array([-3.5, 0.0, 3.5, -2.0, 2.5]) * h + self.rng.uniform(-0.4, 0.4, TARGETS) * h
            front, back = self.stretch.wall - 0.25 * h, 0.8 * h
            across = np.array([front, front, front, back, back])
            level = self.stretch.deck + np.array([self.stretch.parapet] * 3 + [0.0] * 2)
            places.append(np.column_stack([along, across, level]))
        return np.vstack(places)

    def _bent(self, time: datetime) -> FrameOfEpoch:
        length = self.count * self.core
        return FrameOfEpoch(self.plan.frame, self.times.index(time), length, self.plan.seed, across=self.stretch.across)


class _Tiles:
    """Tiles of one epoch along the coast, written from one end to the other."""

    def __init__(self, coast: CoastSimulation, time: datetime) -> None:
        self.coast, self.time, self.label = coast, time, label_of(time)
        self.waiting: list[Returns] = []
        self.sensors: list[Returns] = []
        self.labels: dict[str, NDArray[np.int32]] = {}
        self.folder = coast.folder / "tiles" / self.label
        self.folder.mkdir(parents=True)

    def add(self, cloud: Returns) -> None:
        """Points that are to be written."""
        self.waiting.append(cloud)
        for source in np.unique(cloud.source):
            own = np.flatnonzero(cloud.source == source)
            own = own[np.argsort(cloud.time[own], kind="stable")]
            self.sensors.append(cloud.chosen(own[np.unique(np.linspace(0, len(own) - 1, SENSOR_PLACES).astype(np.int64))]))

    def write(self, limit: float) -> None:
        """Write what lies before ``limit`` along the coast, metres, as one tile."""
        cloud = Returns.joined(self.waiting)
        before = cloud.points[:, 0] < limit
        self.waiting = [cloud.chosen(~before)]
        if not before.any():
            return
        coast, cloud = self.coast, cloud.chosen(before)
        name = f"{coast.plan.name}_{self.label.replace('-', '')}_{len(self.labels):03d}"
        path, points = self.folder / f"{name}.laz", coast.registered(cloud, self.time)
        write_las(path, points, cloud, coast.plan, self.time, coast.instrument.generator)
        self.labels[name] = cloud.labels.astype(np.int32)

    def finish(self) -> None:
        """Write labels of points, and where the instruments were."""
        np.savez_compressed(self.coast.folder / "truth" / f"labels_{self.label}.npz", **self.labels)  # type: ignore[arg-type]
        self.coast.write_sensors(Returns.joined(self.sensors), self.time)


def _shifted(unit: PiledUnit, along: float) -> PiledUnit:
    return replace(unit, pose=unit.pose.shifted(np.array([along, 0.0, 0.0])))
