"""Why no unit is found in a cloud: what a first look at its points tells, and what to try."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..common.arrays import FloatArray
from ..common.feedback import Feedback
from ..data.survey import Survey
from ..model.unit_types import UnitType
from ..segmentation.unit_size import GREATEST_HEIGHT, LEAST_EVIDENCE, STEP, point_spacing, try_size
from .cloud_sample import sample_points
from .epoch_plans import EpochPlan

FEWEST_POINTS = 1000
"""Fewer points than this hold no unit that could be told from rubble."""

FEW_POINTS_SPACING = 0.2
"""Metres between points from which even large units hold too few of them."""
FEET = 0.3048


def warn_of_empty(survey: Survey, plans: Sequence[EpochPlan], feedback: Feedback) -> None:
    """Say of epochs in which no unit was found what the likely reason is."""
    for plan in plans:
        points, _ = sample_points(plan.tiles, survey.crs, is_cancelled=feedback.is_cancelled)
        feedback.warning(f"{plan.epoch.label}: no unit was found: {why_no_units(points)}")


def why_no_units(points: FloatArray) -> str:
    """The likely reason with what to try, as the end of a sentence.

    Parameters
    ----------
    points
        (n, 3) reduced frame, in what is taken for metres.
    """
    if len(points) < FEWEST_POINTS:
        return f"there are {len(points)} points, and a unit alone needs some hundred: give the tiles that hold the armour"
    spacing = point_spacing(points)
    extent = np.ptp(np.quantile(points, [0.02, 0.98], axis=0), axis=0)
    if extent[:2].max() < 0.02:
        return f"the cloud is {1000 * extent[:2].max():.3g} mm wide: are its coordinates in kilometres, or in degrees? Give tiles in metres"
    scaled = _other_unit(points)
    if scaled:
        return scaled
    if extent[2] > 1.5 * extent[:2].min() and extent[:2].min() > 0:
        axis = "xy"[int(np.argmin(extent[:2]))]
        return f"the cloud is higher ({extent[2]:.1f} m) than it is wide: heights seem to stand in {axis}; export it with z upward"
    if spacing > FEW_POINTS_SPACING:
        return f"points are {spacing:.2f} m apart, and a unit needs a point at least every {FEW_POINTS_SPACING:g} m: give denser tiles"
    if extent[2] < 0.5:
        return f"the cloud is flat ({extent[2]:.2f} m): do the tiles hold the armour, and not the crest or a filtered ground surface?"
    return (
        f"points are {spacing:.3g} m apart over {extent[0]:.0f} by {extent[1]:.0f} m, which would do for units from {12 * spacing:.2g} m. "
        "Do the tiles hold the armour (not classified or filtered away), and are its units tetrapods? If so, give --height"
    )


def _other_unit(points: FloatArray) -> str:
    """What to say where units are found far larger than any that is built: the coordinates are no metres."""
    height = GREATEST_HEIGHT * STEP
    extent = float(np.ptp(points[:, :2], axis=0).max())
    while height < min(5.5 / FEET, extent):
        trial = try_size(points, UnitType.tetrapod(height), windows=1)
        if trial.evidence > LEAST_EVIDENCE:
            return (
                f"but units {height:.1f} long in the coordinates' unit were, which no one builds in metres: "
                f"in feet they are about {height * FEET:.1f} m. Reproject the tiles to metres"
            )
        height *= STEP
    return ""
