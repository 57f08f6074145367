"""Piles of armour units: settled by rigid-body physics on a rubble slope before a crown wall, and changed between epochs.

Site frame: x along the wall, y seaward from the landward edge of the deck, z up from the mean water level, metres. MuJoCo (extra
``simulation``) settles the pile; later movements are kinematic and free of overlap, as after a storm that left no unit floating
far from its support.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..model.pose import Pose
from ..model.tetrapod import distance_to_surface, sample_surface
from ..model.unit_types import UnitType

CONTACT_TOLERANCE = 0.004
"""Depth as a fraction of H to which two units may touch: soft contacts of the physics, not an overlap of solids."""
OBLIQUITY = 0.25
"""Standard deviation of the slopes of a face of fracture across its leg."""


@dataclass(frozen=True, kw_only=True)
class Site:
    """Cross-section of the structure in the site frame; every length in metres.

    Attributes
    ----------
    half_length
        Half the length of the wall, along x.
    deck, deck_width
        Height of the deck above water and its width.
    parapet
        Height of the crown wall above the deck; 0 for a quay without parapet.
    wall
        y of the seaward face of the wall.
    bench, bench_end
        Height of the rock bench before the wall and y of its seaward edge.
    slope
        Fall of the rubble slope per metre.
    bed
        Height of the sea bed (negative).
    """

    half_length: float
    deck: float
    deck_width: float
    parapet: float
    wall: float
    bench: float
    bench_end: float
    slope: float
    bed: float

    @property
    def across(self) -> tuple[float, float]:
        """y of the wall and of the toe, where the rubble slope meets the sea bed."""
        return self.wall, self.bench_end + (self.bench - self.bed) / self.slope

    @classmethod
    def of_height(cls, height: float, units: int, *, parapet: bool) -> Site:
        """Breakwater in proportion to a unit height, long enough for a number of units."""
        h = height / 2.3
        half = (1.5 + 5.6 * max(units, 1) / 75) * h
        return cls(
            half_length=half + 2.0 * h,
            deck=6.8 * h,
            deck_width=7.0 * h,
            parapet=0.8 * h if parapet else 0.0,
            wall=7.0 * h,
            bench=3.6 * h,
            bench_end=9.8 * h,
            slope=0.66,
            bed=-1.6 * h,
        )

    @property
    def toe(self) -> float:
        """y where the rubble slope meets the sea bed."""
        return self.bench_end + (self.bench - self.bed) / self.slope

    def rock(self, y: FloatArray) -> FloatArray:
        """Height of the mean rock surface at seaward distances y."""
        return np.maximum(np.minimum(self.bench, self.bench - (y - self.bench_end) * self.slope), self.bed)


@dataclass(frozen=True)
class PiledUnit:
    """One unit of a pile in one epoch.

    Attributes
    ----------
    number
        Number that stays with the physical unit, from 1.
    pose
        Pose in the site frame.
    scale
        Own height over nominal height.
    broken_leg, broken_length
        Leg 0..3 whose end is broken off, with the remaining length in metres; -1 and 0 for a whole unit.
    status
        ``stable``, ``moved``, ``new`` or ``relocated`` with respect to the epoch before.
    """

    number: int
    pose: Pose
    scale: float
    broken_leg: int = -1
    broken_length: float = 0.0
    status: str = "stable"

    def slope_of_break(self) -> FloatArray:
        """(3,) slopes of the face of fracture: at a place (3,) across the axis it lies by its product with these farther out."""
        return np.random.default_rng(self.number).normal(0, OBLIQUITY, 3)

    def shape(self, unit: UnitType) -> UnitType:
        """The unit's own geometry: the nominal one in its own size."""
        return UnitType(
            unit.name, unit.height * self.scale, unit.radius * self.scale, unit.gradient, unit.leg_length * self.scale, unit.opening
        )


@dataclass(frozen=True)
class Changes:
    """How many units change between two epochs."""

    moved: int = 0
    removed: int = 0
    new: int = 0
    relocated: int = 0


def settle(
    unit: UnitType, site: Site, count: int, rng: np.random.Generator, *, broken: int = 0, size_sd: float = 0.003
) -> tuple[PiledUnit, ...]:
    """Drop ``count`` units in layers on the slope and let them come to rest; their sizes differ by ``size_sd``, relative.

    Raises
    ------
    InputError
        MuJoCo is not installed.
    """
    if count == 0:
        return ()
    h = unit.height
    near, far = site.wall + 0.7 * h, site.toe
    columns = max(1, int(2 * (site.half_length - 0.9 * h) / (1.28 * h)))
    rows = max(1, round((far - near) / (1.28 * h)))
    starts: list[FloatArray] = []
    layer = 0
    while len(starts) < count:
        x = (np.arange(columns) - (columns - 1) / 2) * 1.28 * h
        y = near + (np.arange(rows) + 0.5) * (far - near) / rows
        grid = np.array([(a, b) for a in x for b in y]) + rng.uniform(-0.1 * h, 0.1 * h, (rows * columns, 2))
        # the upper layers of a real pile are narrower than its foot
        grid = grid[rng.permutation(len(grid))] * [1 - 0.06 * layer, 1]
        level = site.rock(grid[:, 1]) + h * (0.8 + 1.35 * layer)
        starts += list(np.column_stack([grid, level]))
        layer += 1
    poses = _simulate_fall(unit, site, np.array(starts[:count]), Rotation.random(count, random_state=rng))
    scales = 1 + rng.normal(0, size_sd, count)
    top = np.argsort([-p.centre[2] for p in poses])
    broken_units = set(rng.choice(top[: max(1, count // 2, broken)], broken, replace=False).tolist())
    units = []
    for k, pose in enumerate(poses):
        leg, length = -1, 0.0
        if k in broken_units:
            leg, length = int(rng.integers(0, 4)), unit.leg_length * float(rng.uniform(0.62, 0.85))
        units.append(PiledUnit(k + 1, pose, float(scales[k]), leg, length))
    return tuple(units)


def settle_models(unit: UnitType, count: int, rng: np.random.Generator) -> tuple[PiledUnit, ...]:
    """Models set by hand on a table (plane z = 0), most on three legs, the last leaning on the others."""
    if count == 0:
        return ()
    h = unit.height
    big = UnitType.tetrapod(1.0, radius=unit.radius / h, gradient=unit.gradient, leg_length=unit.leg_length / h, opening=unit.opening)
    starts, turns = [], []
    upright = max(1, count - 1)
    for k in range(upright):
        starts.append([(k - (upright - 1) / 2) * 1.45 + rng.uniform(-0.1, 0.1), rng.uniform(0.9, 1.4), 0.42])
        turns.append(Rotation.from_euler("z", rng.uniform(0, 360), degrees=True))
    if count > 1:
        host = np.array(starts[int(rng.integers(0, upright))])
        starts.append((host + np.array([0.62, rng.uniform(-0.3, 0.5), 1.0])).tolist())
        turns.append(Rotation.random(random_state=rng))
    table = Site(half_length=4.0, deck=0.0, deck_width=1.0, parapet=0.0, wall=-3.0, bench=0.0, bench_end=100.0, slope=0.5, bed=-1.0)
    poses = _simulate_fall(big, table, np.array(starts[:count]), Rotation.concatenate(turns[:count]))
    scales = 1 + rng.normal(0, 0.003, count)
    return tuple(PiledUnit(k + 1, Pose(p.centre * h, p.rotation), float(scales[k])) for k, p in enumerate(poses))


def change(
    units: tuple[PiledUnit, ...],
    unit: UnitType,
    site: Site,
    changes: Changes,
    rng: np.random.Generator,
    *,
    next_number: int,
    planar: bool = False,
) -> tuple[tuple[PiledUnit, ...], tuple[int, ...]]:
    """Next epoch of a pile.

    Parameters
    ----------
    planar
        Move along the ground and turn about the vertical only (models on a table).

    Returns
    -------
    units, removed
        Units of the new epoch, and the numbers of those taken away. Fewer changes than asked for are made where the pile leaves no
        room for them without overlap.
    """
    samples = sample_surface(unit, 1500, np.random.default_rng(1))[0]
    now = {u.number: replace(u, status="stable") for u in units}
    exposed = sorted(now, key=lambda k: -_freedom(now[k], now, unit))
    gone = tuple(int(k) for k in rng.permutation(exposed[: max(changes.removed, len(exposed) // 3)])[: changes.removed])
    for k in gone:
        del now[k]
    candidates = [k for k in rng.permutation(exposed).tolist() if k in now]
    moved = 0
    for k in candidates:
        if moved >= changes.moved:
            break
        others = [u for n, u in now.items() if n != k]
        pose = _moved_pose(now[k], others, unit, site, samples, rng, planar=planar, wide=moved % 3 == 2)
        if pose is not None:
            now[k] = replace(now[k], pose=pose, status="moved")
            moved += 1
    for k in [n for n in exposed if n in now and now[n].status == "stable"][: changes.relocated]:
        others = [u for n, u in now.items() if n != k]
        pose = _lowered_pose(now[k].shape(unit), others, unit, site, samples, rng, away_from=now[k].pose.centre)
        if pose is not None:
            now[k] = replace(now[k], pose=pose, status="relocated")
    for _ in range(changes.new):
        fresh = PiledUnit(next_number, Pose(np.zeros(3), np.eye(3)), 1 + float(rng.normal(0, 0.003)), status="new")
        pose = _lowered_pose(fresh.shape(unit), list(now.values()), unit, site, samples, rng)
        if pose is not None:
            now[next_number] = replace(fresh, pose=pose)
            next_number += 1
    return tuple(now.values()), gone


def deepest_overlap(shape: UnitType, pose: Pose, others: list[PiledUnit], unit: UnitType, samples: FloatArray) -> float:
    """Greatest depth in metres of a unit's surface inside other units, or of theirs inside it (0 when free)."""
    reach = 1.35 * unit.height
    own = pose.to_frame(samples * (shape.height / unit.height))
    deepest = 0.0
    for other in others:
        if np.linalg.norm(other.pose.centre - pose.centre) > reach:
            continue
        theirs = other.shape(unit)
        deepest = max(deepest, -float(distance_to_surface(other.pose.to_body(own), theirs).min()))
        surface = other.pose.to_frame(samples * other.scale)
        deepest = max(deepest, -float(distance_to_surface(pose.to_body(surface), shape).min()))
    return deepest


def _freedom(unit: PiledUnit, pile: dict[int, PiledUnit], kind: UnitType) -> float:
    """Height by which a unit stands above its neighbours: large for units on top."""
    centres = np.array([u.pose.centre for u in pile.values()])
    near = np.linalg.norm(centres[:, :2] - unit.pose.centre[:2], axis=1) < 1.2 * kind.height
    return float(unit.pose.centre[2] - centres[near, 2].mean())


def _in_ground(pose: Pose, samples: FloatArray, site: Site) -> float:
    """Greatest depth of a surface below the rock or behind the wall's face."""
    surface = pose.to_frame(samples)
    wall = np.where(surface[:, 2] < site.deck + site.parapet, site.wall - surface[:, 1], 0.0)
    return float(max(np.max(site.rock(surface[:, 1]) - surface[:, 2]), np.max(wall)))


def _moved_pose(
    mover: PiledUnit,
    others: list[PiledUnit],
    unit: UnitType,
    site: Site,
    samples: FloatArray,
    rng: np.random.Generator,
    *,
    planar: bool,
    wide: bool,
) -> Pose | None:
    """A free pose near the old one, 0.02 m (full scale) to half a height away; None where the unit is wedged."""
    h = unit.height
    shape = mover.shape(unit)
    before = max(deepest_overlap(shape, mover.pose, others, unit, samples), _in_ground(mover.pose, samples, site))
    allowed = max(CONTACT_TOLERANCE * h, before + 0.001 * h)
    smallest = 0.009 * h * float(rng.uniform(1, 1.7))
    for attempt in range(60):
        shrink = 0.93**attempt
        length = float(np.clip((0.5 if wide else 0.14) * h * rng.uniform(0.25, 1) * shrink, smallest, 0.5 * h))
        if planar:
            direction = np.append(rng.normal(size=2), 0.0)
            turn = Rotation.from_rotvec([0, 0, rng.normal(0, np.radians(4.0))])
        else:
            direction = rng.normal(size=3) + np.array([0, 0.5, 0.35])
            limit = np.radians(50.0 if wide else 6.0) * shrink
            axis = rng.normal(size=3)
            turn = Rotation.from_rotvec(axis / np.linalg.norm(axis) * rng.uniform(0.05, 1) * limit)
        centre = mover.pose.centre + direction / np.linalg.norm(direction) * length
        pose = Pose(centre, turn.as_matrix() @ mover.pose.rotation)
        if deepest_overlap(shape, pose, others, unit, samples) <= allowed and _in_ground(pose, samples * mover.scale, site) <= allowed:
            return pose
    return None


def _lowered_pose(
    shape: UnitType,
    others: list[PiledUnit],
    unit: UnitType,
    site: Site,
    samples: FloatArray,
    rng: np.random.Generator,
    *,
    away_from: FloatArray | None = None,
) -> Pose | None:
    """A unit lowered by crane at a random place of the pile until it touches."""
    h = unit.height
    scaled = samples * (shape.height / h)
    for _ in range(150):
        y = rng.uniform(site.wall + 0.8 * h, site.bench_end + site.bench / site.slope)
        x = rng.uniform(-1, 1) * (site.half_length - 1.2 * h)
        if away_from is not None and np.hypot(x - away_from[0], y - away_from[1]) < 1.2 * h:
            continue
        rotation = Rotation.random(random_state=rng).as_matrix()
        high, low = site.deck + 4 * h, float(site.rock(np.array(y)))
        for _ in range(14):
            middle = (high + low) / 2
            pose = Pose(np.array([x, y, middle]), rotation)
            free = deepest_overlap(shape, pose, others, unit, samples) <= 0 and _in_ground(pose, scaled, site) <= 0
            high, low = (middle, low) if free else (high, middle)
        pose = Pose(np.array([x, y, high]), rotation)
        # a unit that hangs on one point high above the pile is not a likely place
        near = cKDTree(np.vstack([o.pose.centre for o in others])).query_ball_point(pose.centre, 0.95 * h)
        if high < site.deck + 0.4 * h and len(near) >= 2:
            return pose
    return None


def _simulate_fall(unit: UnitType, site: Site, starts: FloatArray, turns: Rotation) -> list[Pose]:
    """Poses at rest of units released at ``starts`` ((n, 3)) with attitudes ``turns``."""
    try:
        import mujoco
    except ImportError as missing:
        raise InputError(
            "settling a pile needs MuJoCo, which is not installed", remedy="Install the extra: pip install 'tetratrack[simulation]'"
        ) from missing
    model: Any = mujoco.MjModel.from_xml_string(_scene_xml(unit, site, starts, turns))
    data: Any = mujoco.MjData(model)
    step = float(model.opt.timestep)
    pause = round(0.25 / step)
    seconds = 12.0 * np.sqrt(unit.height / 2.3) + 4.0 * np.sqrt(np.ptp(starts[:, 2]) / 10 + 0.1)
    for _ in range(round(2.5 * seconds / (pause * step))):
        mujoco.mj_step(model, data, nstep=pause)
        if data.time > 2.0 and np.max(np.linalg.norm(data.qvel.reshape(-1, 6)[:, :3], axis=1)) < 0.004 * unit.height:
            break
    states = np.array(data.qpos).reshape(-1, 7)
    return [Pose(s[:3], Rotation.from_quat(s[[4, 5, 6, 3]]).as_matrix()) for s in states]


def _scene_xml(unit: UnitType, site: Site, starts: FloatArray, turns: Rotation) -> str:
    """MuJoCo model: four convex frusta a unit, and the wall, bench, slope and bed as boxes."""
    azimuth = np.arange(24) * (2 * np.pi / 24)
    # the polygon lies half inside, half outside the circle
    widen = 1 / np.sqrt(np.cos(np.pi / 24))
    meshes, geoms = [], []
    for k, axis in enumerate(unit.leg_directions):
        help_axis = np.array([1.0, 0, 0]) if abs(axis[2]) > 0.9 else np.array([0, 0, 1.0])
        first = np.cross(help_axis, axis)
        first /= np.linalg.norm(first)
        second = np.cross(axis, first)
        ring = np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * second
        corners = np.vstack([ring * unit.radius * widen, ring * unit.end_radius * widen + axis * unit.leg_length])
        meshes.append(f'<mesh name="leg{k}" vertex="{_numbers(corners)}"/>')
        # a mesh geom is placed at its own centre of mass unless told where the mesh's frame is
        geoms.append(f'<geom type="mesh" mesh="leg{k}" density="2350"/>')
    bodies = []
    for start, turn in zip(starts, turns.as_quat()[:, [3, 0, 1, 2]], strict=True):
        bodies.append(f'<body pos="{_numbers(start)}" quat="{_numbers(turn)}"><freejoint/>{"".join(geoms)}</body>')
    mass = unit.mass() * 1000
    run = site.toe - site.bench_end
    slant = float(np.hypot(run, site.bench - site.bed))
    angle = float(np.degrees(np.arctan(site.slope)))
    wide, deep = 4 * site.half_length + 4 * unit.height, 2 * unit.height
    foot = np.array([0, site.bench_end + run / 2, (site.bench + site.bed) / 2])
    inward = np.array([0, -np.sin(np.radians(angle)), -np.cos(np.radians(angle))])
    boxes = [
        (np.array([0, site.wall - 5 * unit.height, 0]), [wide, 5 * unit.height, 40 * unit.height], 0.0),
        (np.array([0, (site.wall + site.bench_end) / 2, site.bench - deep]), [wide, (site.bench_end - site.wall) / 2, deep], 0.0),
        (foot + inward * deep, [wide, slant / 2, deep], -angle),
        (np.array([0, site.bench_end + run, site.bed - deep]), [wide, run * 2, deep], 0.0),
    ]
    # the armour beyond the modelled length and the toe berm hold the pile together
    side = site.half_length - 0.45 * unit.height
    boxes += [(np.array([sign * (side + deep), 0, 0]), [deep, 40 * unit.height, 40 * unit.height], 0.0) for sign in (-1, 1)]
    boxes.append((np.array([0, site.toe + 0.6 * unit.height + deep, site.bed - deep + 1.15 * unit.height]), [wide, deep, deep], 0.0))
    ground = "".join(f'<geom type="box" pos="{_numbers(p)}" size="{_numbers(s)}" euler="{a:.6f} 0 0"/>' for p, s, a in boxes)
    return f"""<mujoco>
  <compiler angle="degree" inertiafromgeom="true"/>
  <option timestep="0.005" integrator="implicitfast" iterations="30" density="{0.12 * mass / unit.height**3:.3f}" cone="pyramidal"/>
  <size memory="512M"/>
  <default><geom friction="0.75 0.02 0.001" solref="0.012 1" solimp="0.95 0.99 0.002"/></default>
  <asset>{"".join(meshes)}</asset>
  <worldbody>{ground}{"".join(bodies)}</worldbody>
</mujoco>"""


def _numbers(values: Any) -> str:
    return " ".join(f"{v:.9g}" for v in np.ravel(values))
