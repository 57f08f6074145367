"""Registration of every epoch's cloud: to survey control, or on stable areas to an epoch that has it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.crs import LOCAL
from ..data.survey import Survey
from ..registration.control import Registration
from ..registration.stable_areas import REACH_HEIGHTS, VOXEL_HEIGHTS, read_areas, read_stable_points, register_on_areas
from ..registration.survey_frame import grid_scale
from ..registration.surveyed_epochs import register_to_control
from .epoch_plans import EpochPlan

if TYPE_CHECKING:
    import shapely


def register_epochs(survey: Survey, plans: Sequence[EpochPlan], feedback: Feedback) -> dict[str, Registration]:
    """Registration of every epoch that has control, by label; with stable areas also of the others, to the reference epoch.

    Raises
    ------
    InputError
        Control, targets or stable areas cannot be used.
    """
    feedback.check()
    found = register_to_control(survey.epochs, survey.crs)
    if survey.crs != LOCAL:
        for label, registration in found.items():
            scale = grid_scale(survey.crs, registration.transformation.origin_to)
            feedback.info(f"{label}: scale factor grid over ground is {scale:.6f}; ground distances are not applied to coordinates")
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
        feedback.info(f"{survey.stable_areas.path.name} is not used: every epoch has control")
        return {}
    import shapely

    areas = read_areas(survey.stable_areas.path, survey.crs, survey.stable_areas.layer)
    height = max(unit.type.height for unit in survey.units)
    root = next(plan for plan in plans if plan.epoch is survey.reference)
    label = root.epoch.label
    origin = np.floor(np.array([*shapely.bounds(areas)[:2], root.tiles[0].low[2]]))
    found = {} if label in registered else {label: Registration.own_frame(origin)}
    known = {**registered, **found}[label].transformation

    def points(plan: EpochPlan, inside: shapely.Geometry) -> FloatArray:
        return read_stable_points(plan.tiles, survey.crs, inside, origin, VOXEL_HEIGHTS * height, feedback.is_cancelled)

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
            raise InputError(
                error.problem, source=survey.stable_areas.path, where=f"epoch {plan.epoch.label}", remedy=error.remedy
            ) from error
        relative = tied.transformation
        total = relative.covariance + known.covariance_at(relative.origin_to)
        found[plan.epoch.label] = replace(tied, transformation=replace(relative, covariance=total), reference=label)
    return found
