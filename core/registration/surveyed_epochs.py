"""Epochs with surveyed control: what their files say in the survey's frame, and the transformations of their clouds to it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ..data.crs import counts_in_metres
from ..data.point_tables import SurveyedPoints, read_control, read_targets
from ..data.survey import Epoch
from .control import Registration, register
from .survey_frame import to_survey_frame


def control_of(epoch: Epoch, path: Path) -> SurveyedPoints:
    """Control of an epoch as its file states it, read as the epoch's keys say.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used.
    """
    # a CRS of its own may count in feet, whatever the unit of heights is
    unit = None if epoch.control_crs is not None and not counts_in_metres(epoch.control_crs) else epoch.control_unit
    return read_control(path, axes=epoch.control_axes, sd=epoch.control_sd, unit=unit)


def surveyed_control(epoch: Epoch, path: Path, survey_crs: str) -> SurveyedPoints:
    """Control of an epoch in the CRS of the survey, metres.

    Raises
    ------
    InputError
        The file, or its CRS, cannot be used.
    """
    return to_survey_frame(control_of(epoch, path), epoch.control_crs, survey_crs, epoch.control_unit)


def register_to_control(epochs: Iterable[Epoch], survey_crs: str) -> dict[str, Registration]:
    """Registration of every epoch that has control and targets, by label; each judged by the residuals of all.

    Raises
    ------
    InputError
        Control or targets of one cannot be used.
    """
    pairs = {
        epoch.label: (surveyed_control(epoch, epoch.control, survey_crs), read_targets(epoch.targets))
        for epoch in epochs
        if epoch.control is not None and epoch.targets is not None
    }
    alone = {label: register(*points) for label, points in pairs.items()}
    if len(alone) < 2:
        return alone
    return {label: register(*points, others=[alone[k] for k in pairs if k != label]) for label, points in pairs.items()}
