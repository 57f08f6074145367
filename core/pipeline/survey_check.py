"""Every input of a survey looked at before hours of work: against the format, the cloud, the other inputs, the other epochs, and sense."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.crs import LOCAL
from ..data.occupancy import Occupancy, common_height_shift, level_for, merged, share_that_differs
from ..data.places_by_second import PlacesBySecond
from ..data.plausibility import (
    FAR_CONTROL,
    Place,
    check_near,
    check_scale,
    check_sds,
    check_station_ids,
    check_times,
    height_systems,
    said_of_shift,
)
from ..data.point_tables import read_targets
from ..data.strip_numbers import by_strips
from ..data.survey import Epoch, LayerFile, Survey
from ..data.thinned_clouds import is_large, patch_radius
from ..data.tiles import TileInfo, inspect_tile, stray_place, without_strays
from ..data.trajectory import read_stations, read_trajectory
from ..deformation.validation import read_check
from ..registration.stable_areas import read_areas
from ..registration.surveyed_epochs import control_of, register_to_control, surveyed_control
from .input_findings import Finding, Verdict, refused, said_of_tiles, warned

MOST_DROPPED = 0.5
"""Share of noise and withheld points above which an epoch is worth a warning."""
LEAST_POINTS_PER_UNIT = 30.0
"""Points on the square of a unit's height below which hardly a unit can be found."""
SAME_POINTS = 0.01
"""Share of points that two copies of a tile may differ by, cell by cell: rounding moves some over a border."""
SHIFT_HEIGHTS = 0.5
"""Common difference of height between two clouds, in unit heights, that no settlement explains."""
SENSOR_REACH, SENSOR_HEIGHT = 5000.0, 8000.0
"""Metres within which a sensor was that measured a tile."""
APART = 1000.0
"""Metres between the clouds of two epochs of what cannot be one site."""
MOST_LOOKS = 4
"""Tiles looked through at once: each holds a chunk of points."""
FIRST_SCANS = 1990
"""Year before which nobody scanned a breakwater."""


@dataclass(frozen=True, kw_only=True)
class SurveyCheck:
    """Findings in the order of the inputs, and the tiles of every epoch that go into a run."""

    findings: tuple[Finding, ...]
    tiles: dict[str, tuple[TileInfo, ...]]


def check_survey(survey: Survey, feedback: Feedback) -> SurveyCheck:
    """Look at every input; what is wrong with one does not hide what is wrong with others.

    Raises
    ------
    Cancelled
        The user ended it.
    """
    height = max(unit.type.height for unit in survey.units)
    findings: list[Finding] = []
    tiles: dict[str, tuple[TileInfo, ...]] = {}
    total = sum(len(epoch.tiles) for epoch in survey.epochs)
    done = 0
    for epoch in survey.epochs:
        unreadable = [finding for finding in _readable(epoch) if finding.verdict == "refused"]
        findings += unreadable
        seen = []
        for finding in _looks(epoch, survey.crs, height, feedback):
            done += 1
            feedback.progress(done / total, f"checked {finding.name}")
            seen.append(finding)
        findings += seen
        own = [finding.tile for finding in seen if finding.tile is not None and finding.verdict != "refused"]
        kept, said = _cloud_of(epoch, own, survey.crs, feedback)
        findings += said
        if not kept and not any(finding.verdict == "refused" for finding in (*seen, *said)):
            findings.append(refused(epoch, "tiles", _no_points(epoch, own)))
        if not kept:
            continue
        tiles[epoch.label], said = _strips_of(epoch, kept)
        findings += said
        place = _place(kept, survey.crs, height)
        findings += _dropped(epoch, own)
        findings += _thinned(epoch, kept)
        findings += _density(epoch, kept, height)
        findings += _tables(epoch, survey, place, kept, {finding.what for finding in unreadable})
    findings += _whole(survey, tiles, height)
    return SurveyCheck(findings=tuple(findings), tiles=tiles)


def _looks(epoch: Epoch, survey_crs: str, height: float, feedback: Feedback) -> Iterator[Finding]:
    """Verdicts on the tiles of an epoch one after the other; some are looked through at once, as decompression lets other threads go on."""
    with ThreadPoolExecutor(min(MOST_LOOKS, os.cpu_count() or 1)) as pool:
        patch = patch_radius(height) if is_large(epoch.tiles) else 0.0
        looks = [pool.submit(_look_at, path, epoch, survey_crs, level_for(height), patch, feedback) for path in epoch.tiles]
        try:
            for look in looks:
                feedback.check()
                yield look.result()
        finally:
            pool.shutdown(cancel_futures=True)


def _look_at(path: Path, epoch: Epoch, survey_crs: str, level: int, patch: float, feedback: Feedback) -> Finding:
    """Verdict on one tile by itself."""
    try:
        stated = {"tiles_crs": epoch.tiles_crs, "undeclared_crs": epoch.undeclared_crs}
        tile = inspect_tile(path, survey_crs, **stated, level=level, patch=patch, is_cancelled=feedback.is_cancelled)
        if epoch.trajectory is not None and not tile.has_time and tile.used:
            raise InputError(
                f"has no GPS time by which trajectory {epoch.trajectory.name} could be read",
                source=path,
                remedy="Export the tiles with GPS time, or take trajectory, range_sd and angle_sd out of survey.toml.",
            )
    except InputError as error:
        return refused(epoch, "tile", error, path.name, path)
    said = [*tile.remarks, *([tile.note] if tile.note else [])]
    verdict: Verdict = "warning" if tile.unread else "note" if said else "ok"
    if not tile.used:
        why = "holds no points" if not tile.points else f"holds {tile.points} points, all classed as noise or withheld,"
        said.append(f"{path.name}: {why} and is left out")
        verdict = "warning"
    return Finding(verdict=verdict, what="tile", name=path.name, epoch=epoch.label, message="; ".join(said), tile=tile, path=path)


def _cloud_of(epoch: Epoch, own: Sequence[TileInfo], survey_crs: str, feedback: Feedback) -> tuple[tuple[TileInfo, ...], list[Finding]]:
    """Tiles that go into the epoch's cloud: those with points, each cloud once, without points far from all others."""
    findings = []
    kept: list[TileInfo] = []
    for tile in sorted((tile for tile in own if tile.used), key=lambda tile: (tile.copc, tile.path)):
        twin = next((other for other in kept if _same_points(tile, other)), None)
        if twin is None:
            kept.append(tile)
        else:
            said = f"{tile.path.name}: holds the same points as {twin.path.name} and is left out"
            findings.append(warned(epoch, tile.path, said))
    kept.sort(key=lambda tile: tile.path)
    try:
        clean = without_strays(kept, survey_crs, feedback.is_cancelled)
    except InputError as error:
        return (), [*findings, refused(epoch, "tiles", error)]
    for before, after in zip(kept, clean, strict=True):
        if after.strays:
            number = f"{after.strays} point{'s lie' if after.strays > 1 else ' lies'}"
            where = stray_place(before, after) if after.used else "all of the tile's"
            said = f"{after.path.name}: {number} far from all others ({where}), left out"
            findings.append(warned(epoch, after.path, said))
    return tuple(tile for tile in clean if tile.used), findings


def _same_points(one: TileInfo, other: TileInfo) -> bool:
    if one.used != other.used or one.cells is None or other.cells is None:
        return False
    slack = one.resolution + other.resolution
    apart = np.abs(np.subtract([one.low, one.high], [other.low, other.high])).max()
    return bool(apart <= slack and share_that_differs(one.cells, other.cells) <= SAME_POINTS)


def _no_points(epoch: Epoch, own: Sequence[TileInfo]) -> InputError:
    points = sum(tile.points for tile in own)
    if points:
        return InputError(
            f"epoch {epoch.label}: all {points} points are classed as noise (7, 18) or withheld",
            source=own[0].path.parent,
            remedy="Mend their classification: noise is left out of everything.",
        )
    return InputError(f"epoch {epoch.label}: no tile holds points", source=epoch.tiles[0].parent, remedy="Check the tiles of the epoch.")


def _dropped(epoch: Epoch, own: Sequence[TileInfo]) -> list[Finding]:
    points, dropped = sum(tile.points for tile in own), sum(tile.dropped for tile in own)
    if not dropped:
        return []
    share = dropped / points
    said = f"{epoch.label}: {dropped} of {points} points ({100 * share:.2g} %) are classed as noise (7, 18) or withheld and left out"
    verdict: Verdict = "warning" if share > MOST_DROPPED else "note"
    return [said_of_tiles(epoch, own, verdict, said)]


def _thinned(epoch: Epoch, tiles: Sequence[TileInfo]) -> list[Finding]:
    """Say what was thinned."""
    dense = [tile for tile in tiles if tile.thinned]
    if not dense:
        return []
    points, means = sum(tile.used for tile in dense), sum(tile.means for tile in dense)
    said = (
        f"{epoch.label}: {points} points of {len(dense)} of {len(tiles)} tiles are taken as {means} means of small patches: closer points "
        "are too much alike to say more"
    )
    return [said_of_tiles(epoch, dense, "note", said)]


def _strips_of(epoch: Epoch, tiles: tuple[TileInfo, ...]) -> tuple[tuple[TileInfo, ...], list[Finding]]:
    """The tiles with what their point source IDs are taken for; with a table of stations they number these."""
    taken, said = (tiles, "") if epoch.stations is not None else by_strips(epoch.label, tiles)
    # nothing else needs these, and tiles go along with every job
    taken = tuple(replace(tile, by_second=PlacesBySecond.empty()) for tile in taken)
    return taken, [said_of_tiles(epoch, tiles, "note" if taken[0].strip_starts else "warning", said)] if said else []


def _density(epoch: Epoch, tiles: Sequence[TileInfo], height: float) -> list[Finding]:
    """Warn of clouds too thin to show a unit, going by the ground that cells cover."""
    cells = merged([tile.cells for tile in tiles if tile.cells is not None])
    columns = len(np.unique(cells.cells[:, :2], axis=0))
    on_unit = cells.points / (columns * cells.size**2) * height**2
    if on_unit >= LEAST_POINTS_PER_UNIT:
        return []
    said = (
        f"{epoch.label}: about {on_unit:.2g} points on the square of a unit's height ({height:g} m): hardly a unit can be found. "
        "Is the height in metres, as the tiles are?"
    )
    return [said_of_tiles(epoch, tiles, "warning", said)]


def _readable(epoch: Epoch) -> Iterator[Finding]:
    """Whether each of the epoch's tables can be read at all, which takes no look at tiles."""
    readers: list[tuple[str, Path | None, Callable[[Path], object]]] = [
        ("targets", epoch.targets, read_targets),
        ("control", epoch.control, partial(control_of, epoch)),
        ("check", epoch.check, read_check),
        ("trajectory", epoch.trajectory, read_trajectory),
        ("stations", epoch.stations, read_stations),
    ]
    for what, path, read in readers:
        if path is not None:
            yield _tried(epoch, what, path.name, partial(read, path))


def _tables(epoch: Epoch, survey: Survey, place: Place, tiles: Sequence[TileInfo], unreadable: set[str]) -> Iterator[Finding]:
    """Verdict on each of the epoch's tables that can be read, against its cloud."""
    checks: list[tuple[str, Path | None, Callable[[], object]]] = [
        ("targets", epoch.targets, lambda: _check_targets(epoch, place)),
        ("control", epoch.control, lambda: _check_control(epoch, survey, place)),
        ("check", epoch.check, lambda: _check_check(epoch, survey, place)),
        ("trajectory", epoch.trajectory, lambda: _check_trajectory(epoch, place, tiles)),
        ("stations", epoch.stations, lambda: _check_stations(epoch, place, tiles)),
    ]
    useless = set(unreadable)
    for what, path, check in checks:
        if path is not None and what not in unreadable:
            found = _tried(epoch, what, path.name, check)
            useless |= {what} if found.error is not None else set()
            yield found
    if epoch.targets is not None and not useless & {"targets", "control"}:
        found = _tried(epoch, "targets", epoch.targets.name, lambda: _check_registration(epoch, survey, place))
        if found.verdict != "ok":
            yield found


def _tried(epoch: Epoch | None, what: str, name: str, check: Callable[[], object]) -> Finding:
    """Verdict of a check that raises what cannot be used and returns a sentence on what can, but should be looked at."""
    try:
        said = check()
    except InputError as error:
        return refused(epoch, what, error, name)
    label = "" if epoch is None else epoch.label
    if isinstance(said, str) and said:
        return Finding(verdict="warning", what=what, name=name, epoch=label, message=said)
    return Finding(verdict="ok", what=what, name=name, epoch=label)


def _in_survey_crs(survey: Survey, place: Place) -> bool:
    """Whether a cloud lies in the CRS of the survey: one near the zero point may be in the frame of its scanner."""
    return survey.crs != LOCAL and min(np.abs(place.low[:2])) > FAR_CONTROL


def _check_control(epoch: Epoch, survey: Survey, place: Place) -> str:
    if epoch.control is None:
        return ""
    points = surveyed_control(epoch, epoch.control, survey.crs)
    said = check_sds(points.sds, points.ids, source=epoch.control)
    if _in_survey_crs(survey, place):
        check_near(points.coordinates, points.ids, place, source=epoch.control, what="control points", reach=FAR_CONTROL, each=False)
    return said


def _check_targets(epoch: Epoch, place: Place) -> str:
    if epoch.targets is None:
        return ""
    points = read_targets(epoch.targets)
    said = check_sds(points.sds, points.ids, source=epoch.targets)
    check_near(points.coordinates, points.ids, place, source=epoch.targets, what="targets")
    return said


def _check_registration(epoch: Epoch, survey: Survey, place: Place) -> str:
    transformation = register_to_control([epoch], survey.crs)[epoch.label].transformation
    if epoch.control is None or not _in_survey_crs(survey, place):
        return ""
    middle = np.add(place.low, place.high)[None] / 2
    return said_of_shift((transformation.apply(middle) - middle)[0], source=epoch.control)


def _check_check(epoch: Epoch, survey: Survey, place: Place) -> None:
    if epoch.check is None:
        return
    points = read_check(epoch.check)
    if not points:
        return
    names = [point.point_id for point in points]
    check_sds(np.array([[point.sd] for point in points]), names, source=epoch.check)
    if epoch.control is not None:
        surveyed = surveyed_control(epoch, epoch.control, survey.crs).coordinates
        low, high = surveyed.min(axis=0), surveyed.max(axis=0)
        place = replace(place, low=(low[0], low[1], low[2]), high=(high[0], high[1], high[2]))
    positions = np.array([point.position for point in points])
    check_near(positions, names, place, source=epoch.check, what="check points", reach=APART)


def _check_trajectory(epoch: Epoch, place: Place, tiles: Sequence[TileInfo]) -> str:
    if epoch.trajectory is None:
        return ""
    trajectory = read_trajectory(epoch.trajectory)
    _check_sensor(trajectory.positions, place, epoch.trajectory, "positions of the trajectory")
    if float(trajectory.positions[:, 2].max()) < place.low[2]:
        return f"{epoch.trajectory.name}: runs below all points of the epoch: are its heights in another system?"
    # points of a station need no trajectory
    times = [(tile.path.name, *tile.times) for tile in tiles]
    return "" if epoch.stations is not None else check_times(trajectory.times, times, source=epoch.trajectory)


def _check_stations(epoch: Epoch, place: Place, tiles: Sequence[TileInfo]) -> str:
    if epoch.stations is None:
        return ""
    stations = read_stations(epoch.stations)
    _check_sensor(np.array(list(stations.values())), place, epoch.stations, "stations")
    if epoch.trajectory is not None:
        return ""
    return check_station_ids(list(stations), sorted({number for tile in tiles for number in tile.sources}), source=epoch.stations)


def _check_sensor(positions: FloatArray, place: Place, source: Path, what: str) -> None:
    names = [f"position {k + 1}" for k in range(len(positions))]
    check_near(positions, names, place, source=source, what=what, reach=SENSOR_REACH, height_reach=SENSOR_HEIGHT, each=False)


def _whole(survey: Survey, tiles: dict[str, tuple[TileInfo, ...]], height: float) -> Iterator[Finding]:
    """What can be seen only of all epochs together."""
    if not tiles:
        return
    everything = [tile for own in tiles.values() for tile in own]
    place = _place(everything, survey.crs, height)
    if survey.stable_areas is not None:
        areas = survey.stable_areas
        yield _tried(None, "stable areas", areas.path.name, lambda: _check_areas(survey, areas))
    scale = _tried(None, "survey", "crs", lambda: check_scale(survey.crs, place, source=survey.path))
    if scale.verdict != "ok":
        yield scale
    said = height_systems([(label, tile.heights) for label, own in tiles.items() for tile in own])
    if said:
        yield Finding(verdict="warning", what="survey", name="heights", message=said)
    clouds = {label: merged([tile.cells for tile in own if tile.cells is not None]) for label, own in tiles.items()}
    for epoch in survey.epochs:
        yield from _moment(epoch)
    for one, other in pairwise(epoch for epoch in survey.epochs if epoch.label in tiles):
        yield from _copies(one, other, tiles)
    alone = [epoch for epoch in survey.epochs if epoch.label in tiles and epoch.control is None]
    for one, other in pairwise(alone):
        yield from _between(one, other, clouds, _place(tiles[one.label], survey.crs, height), tiles[other.label])
    for number, unit in enumerate(survey.units):
        if unit.area is not None:
            ring = np.array([(e, n, place.low[2]) for e, n in unit.area])
            if (ring[:, :2].max(axis=0) < place.low[:2]).any() or (ring[:, :2].min(axis=0) > place.high[:2]).any():
                name = f"area of unit {number + 1}"
                check = partial(check_near, ring, (), place, source=survey.path, what=name, reach=0.0, each=False)
                found = _tried(None, "survey", name, check)
                yield replace(found, verdict="warning", error=None, message=f"{found.message} No unit of that type is looked for.")


def _moment(epoch: Epoch) -> Iterator[Finding]:
    """A time at which no tile was measured: before there were scanners, or in the future."""
    ahead = epoch.time > datetime.now(UTC) + timedelta(days=1)
    if ahead or epoch.time.year < FIRST_SCANS:
        said = f"{epoch.label}: its time, {epoch.time:%Y-%m-%d}, lies {'in the future' if ahead else 'before clouds were measured'}"
        yield Finding(verdict="warning", what="epoch", name="time", epoch=epoch.label, message=said)


def _copies(one: Epoch, other: Epoch, tiles: dict[str, tuple[TileInfo, ...]]) -> Iterator[Finding]:
    """Tiles of an epoch that are those of the one before: what they show has not moved."""
    before: dict[int, list[TileInfo]] = {}
    for tile in tiles[one.label]:
        before.setdefault(tile.used, []).append(tile)
    for tile in tiles[other.label]:
        twin = next((old for old in before.get(tile.used, ()) if _same_points(tile, old)), None)
        if twin is not None:
            said = f"{tile.path.name}: holds the same points in epoch {other.label} as {twin.path.name} in epoch {one.label}"
            yield warned(other, tile.path, said)


def _check_areas(survey: Survey, areas: LayerFile) -> None:
    read_areas(areas.path, survey.crs, areas.layer)


def _between(one: Epoch, other: Epoch, clouds: dict[str, Occupancy], place: Place, later: Sequence[TileInfo]) -> Iterator[Finding]:
    """What two clouds that are compared as they stand say of each other."""
    there = _place(later, place.crs, place.unit_height)
    gap = np.maximum(np.maximum(np.subtract(place.low[:2], there.high[:2]), np.subtract(there.low[:2], place.high[:2])), 0.0)
    apart = float(np.hypot(*gap))
    if apart > APART:
        problem = f"the tiles of epoch {other.label} lie {apart / 1000:.1f} km from those of epoch {one.label}"
        remedy = "Are they in another CRS or zone, or are easting and northing exchanged? One survey is of one site."
        yield refused(other, "tiles", InputError(problem, source=later[0].path.parent, remedy=remedy))
        return
    shift = common_height_shift(clouds[one.label], clouds[other.label])
    if shift is None:
        said = f"the clouds of {one.label} and {other.label} have hardly a place in common: no unit can be compared between them"
        yield Finding(verdict="warning", what="tiles", name="overlap", epoch=other.label, message=said)
    elif abs(shift) > SHIFT_HEIGHTS * place.unit_height:
        said = (
            f"the cloud of {other.label} as a whole lies {abs(shift):.1f} m {'higher' if shift > 0 else 'lower'} than that of {one.label}: "
            "are heights in another height system, or in feet?"
        )
        yield Finding(verdict="warning", what="tiles", name="heights", epoch=other.label, message=said)


def _place(tiles: Sequence[TileInfo], crs: str, height: float) -> Place:
    low, high = np.min([tile.low for tile in tiles], axis=0), np.max([tile.high for tile in tiles], axis=0)
    return Place((float(low[0]), float(low[1]), float(low[2])), (float(high[0]), float(high[1]), float(high[2])), crs, height)
