"""How far apart the targets of a long structure stand, and what can be seen against them: the model of ``plan --coast`` before a run."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..data.point_tables import read_targets
from ..data.survey import Epoch, Survey
from ..data.tiles import TileInfo
from ..registration.shift_samples import axis_of
from ..registration.surveyed_epochs import surveyed_control
from ..registration.target_spacing import BentSurvey, stations_for
from .input_findings import Finding

LONG_STRUCTURE = 60.0
"""Length in metres from which flights bend noticeably between targets."""
STATION_REACH = 10.0
"""Targets nearer to each other than this along the structure, metres, are one station."""


def check_spacing(survey: Survey, epoch: Epoch, tiles: Sequence[TileInfo]) -> list[Finding]:
    """What the targets of an epoch hold of a bend: nothing to be said of short structures, or of tables that cannot be read."""
    if not tiles or survey.frame == "rigid":
        return []
    corners = np.array([(x, y) for tile in tiles for x in (tile.low[0], tile.high[0]) for y in (tile.low[1], tile.high[1])])
    axis = np.array(axis_of(corners)[0])
    low, high = float((corners @ axis).min()), float((corners @ axis).max())
    if high - low < LONG_STRUCTURE:
        return []
    try:
        places, sd = _targets(epoch, survey.crs)
    except InputError:
        return []
    limit = float(survey.sections["displacement"]["watch"])
    along = np.sort(places[:, :2] @ axis) if len(places) else np.zeros(0)
    message, enough = _said(along, sd, (low, high), limit)
    return [Finding(verdict="ok" if enough else "note", what="targets", name="spacing of targets", epoch=epoch.label, message=message)]


def _targets(epoch: Epoch, survey_crs: str) -> tuple[FloatArray, float]:
    """(k, 3) targets in the cloud that are surveyed too, and their typical standard deviation, metres."""
    if epoch.control is None or epoch.targets is None:
        return np.zeros((0, 3)), BentSurvey.target_sd
    control, targets = surveyed_control(epoch, epoch.control, survey_crs), read_targets(epoch.targets)
    common = [k for k, name in enumerate(targets.ids) if name in set(control.ids)]
    stated = float(np.median(np.hypot(np.median(control.sds), np.median(targets.sds[common])))) if common else BentSurvey.target_sd
    return targets.coordinates[common], max(stated, BentSurvey.target_sd)


def _said(along: FloatArray, sd: float, ends: tuple[float, float], limit: float) -> tuple[str, bool]:
    """The message, and whether the targets keep the detection limit (m) everywhere between the ``ends`` of the structure."""
    length = ends[1] - ends[0]
    starts = np.flatnonzero(np.diff(along, prepend=-np.inf) > STATION_REACH)
    groups = np.split(along, starts[1:]) if len(along) else []
    usual = BentSurvey(target_sd=sd, targets=max(1, round(len(along) / max(len(groups), 1))))
    text = f"the usual bend of a flight ({100 * usual.bend:.0f} cm over {usual.correlation_length:.0f} m)"
    try:
        needed, spacing = stations_for(usual, limit, length)
        wanted = f"for {100 * limit:g} cm everywhere {needed} stations are needed, {spacing:.0f} m apart"
    except InputError:
        needed, spacing, wanted = 0, 0.0, f"{100 * limit:g} cm cannot be reached with targets of {1000 * sd:.0f} mm"
    if not groups:
        return f"no targets on {length:.0f} m: with {text} the motion of a whole stretch cannot be seen; {wanted}", False
    middles = np.array([group.mean() for group in groups])
    # beyond the last station an end is as far from targets as the middle of a gap twice as long
    gap = max(float(np.diff(middles).max(initial=0.0)), 2 * (middles[0] - ends[0]), 2 * (ends[1] - middles[-1]))
    seen = usual.detectable(gap)
    return (
        f"{len(along)} targets at {len(groups)} stations on {length:.0f} m, {gap:.0f} m apart at most: with {text} the motion of a whole "
        f"stretch is seen against them from {100 * seen:.1f} cm; {wanted}",
        seen <= limit,
    )
