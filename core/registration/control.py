"""Registration of an epoch's cloud to survey control: weighted rigid or similarity transformation, disturbed targets excluded.

Model per target: X = X0 + t + m R (x - x0), with x measured in the cloud and X surveyed. x0 and X0 are reduction points (the
weighted centroids), so that nothing runs on seven-digit coordinates and translation and rotation are nearly uncorrelated.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import FloatArray
from ..common.errors import InputError
from ..data.point_tables import SurveyedPoints
from .disturbed_targets import MIN_TARGETS, outlier_tests, spread_enough, used_targets
from .transformation import Transformation
from .weighted_transformation import WeightedFit, closed_form, weighted_fit

SNOOPING_LEVEL = 0.01
"""Probability of excluding any good target of an epoch."""
DISTURBED = "disturbed target excluded"
"""How the note on excluded targets begins."""
AXES_TOLERANCE = 30.0
"""Misfit of half of the targets, in stated standard deviations, that no measurement explains."""
SCALE_TOLERANCE = 0.002
"""Difference of scale that projection, height and instrument together can bring."""
LEVEL_TOLERANCE = 5.0
"""Tilt in degrees between a cloud's vertical and control that a levelled instrument never has."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ControlResidual:
    """Residual of one target after the transformation, and the verdict on it.

    Attributes
    ----------
    position
        (3,) surveyed coordinates, metres.
    residual
        (3,) transformed cloud less surveyed coordinate, metres; of an excluded point the error it would have brought.
    sds
        (3,) stated standard deviations of the residual, metres.
    surveyed_sds
        (3,) those of the surveyed coordinates alone, metres.
    w_max
        Largest of the three residuals over their standard deviations.
    p_value
        Of the point's outlier test, not yet shared among the points.
    """

    point_id: str
    position: FloatArray
    residual: FloatArray
    sds: FloatArray
    surveyed_sds: FloatArray
    w_max: float
    p_value: float
    used: bool
    outlier: bool


@dataclass(frozen=True, eq=False, kw_only=True)
class Registration:
    """Result of :func:`register`.

    Attributes
    ----------
    sigma0
        Standard deviation of unit weight; the covariance is scaled by its square where it exceeds 1 (nobody states how well the
        targets were measured in the cloud).
    redundancy
        Coordinates less parameters.
    exclusion_effect
        Shift in metres that keeping the excluded targets would bring at ``reference`` (largest over the reference points); 0 without
        exclusions.
    notes
        Statements for the user.
    reference
        Label of the epoch whose registered cloud this one was tied to; its error is part of the covariance. None for targets.
    tied_by
        What tied it: stable areas, or units that both epochs show.
    """

    transformation: Transformation
    residuals: tuple[ControlResidual, ...]
    sigma0: float
    redundancy: int
    exclusion_effect: float
    notes: tuple[str, ...]
    reference: str | None = None
    tied_by: Literal["stable areas", "units"] = "stable areas"

    @classmethod
    def own_frame(cls, origin: ArrayLike) -> Registration:
        """The cloud's own frame is the datum that other epochs are tied to."""
        return cls(
            transformation=Transformation.identity(origin),
            residuals=(),
            sigma0=1.0,
            redundancy=0,
            exclusion_effect=0.0,
            notes=("no control, its cloud's own frame is the datum",),
        )

    @property
    def datum(self) -> str:
        """What the frame hangs on: control, stable areas, units, or cloud (its own frame), as field ``datum`` of the result says it."""
        if self.reference is not None:
            return self.tied_by
        return "control" if self.residuals else "cloud"

    @property
    def excluded(self) -> tuple[str, ...]:
        """Names of the disturbed targets."""
        return tuple(r.point_id for r in self.residuals if r.outlier)


def register(
    control: SurveyedPoints,
    targets: SurveyedPoints,
    *,
    similarity: bool = False,
    level: float = SNOOPING_LEVEL,
    reference: ArrayLike | None = None,
    others: Sequence[Registration] = (),
) -> Registration:
    """Estimate the transformation of a cloud to survey control.

    Parameters
    ----------
    control, targets
        The same targets as surveyed and as measured in the cloud; they are matched by name.
    similarity
        Estimate a scale as well.
    level
        Probability of excluding any good target.
    reference
        (n, 3) points of the cloud (the units' centres) at which the effect of excluded targets is stated; None for the targets.
    others
        Registrations of the survey's other epochs. Their targets were measured alike, so that their residuals tell too how large one may
        be: with eight targets in each of two epochs a disturbed target is missed half as often.

    Raises
    ------
    InputError
        Fewer than three common targets, targets on one line, or coordinates whose columns or axes are exchanged.
    """
    names, unmatched = _common_names(control, targets)
    rows = ({name: k for k, name in enumerate(points.ids)} for points in (control, targets))
    pick_control, pick_target = ([row[name] for name in names] for row in rows)
    surveyed, measured = control.coordinates[pick_control], targets.coordinates[pick_target]
    variances = control.sds[pick_control] ** 2 + targets.sds[pick_target] ** 2
    if not (variances > 0).all():
        variances = np.where(variances > 0, variances, np.max(variances) or 1.0)
    noise = float(math.sqrt(np.median(variances)))
    _check_spread(measured, noise, targets)
    _check_axes(surveyed, measured, noise, control, targets)
    pool = sum(r.sigma0**2 * r.redundancy for r in others), sum(r.redundancy for r in others)

    @cache  # both searches for the targets to use end, as a rule, with the same ones
    def tests(used: bytes) -> tuple[FloatArray, FloatArray]:
        return outlier_tests(surveyed, measured, variances, np.frombuffer(used, dtype=np.bool_), similarity, pool)

    used = used_targets(surveyed, measured, variances, similarity, level, lambda used: tests(used.tobytes())[1])
    fit = weighted_fit(surveyed, measured, variances, used, similarity)
    everything = weighted_fit(surveyed, measured, variances, np.ones(len(names), dtype=bool), similarity)
    residuals = fit.transformation.apply(measured) - surveyed
    residual_rows = tuple(
        ControlResidual(
            point_id=name,
            position=surveyed[k],
            residual=residuals[k],
            sds=np.sqrt(variances[k]),
            surveyed_sds=control.sds[pick_control[k]],
            w_max=float(np.max(np.abs(statistic))),
            p_value=float(p_value),
            used=bool(used[k]),
            outlier=not used[k],
        )
        for k, (name, statistic, p_value) in enumerate(zip(names, *tests(used.tobytes()), strict=True))
    )
    effect, where = 0.0, measured if reference is None else np.asarray(reference, dtype=np.float64).reshape(-1, 3)
    if not used.all():
        shift = everything.transformation.apply(where) - fit.transformation.apply(where)
        effect = float(np.max(np.linalg.norm(shift, axis=1)))
    excluded = [name for name, kept in zip(names, used) if not kept]
    notes = tuple(_notes(fit, unmatched, excluded, effect, "the targets" if reference is None else "the units"))
    # an a posteriori factor below 1 is not trusted: the stated deviations are the least a surveyor vouches for
    factor = max(1.0, fit.sigma0) ** 2 if fit.redundancy > 0 else 1.0
    return Registration(
        transformation=replace(fit.transformation, covariance=fit.transformation.covariance * factor),
        residuals=residual_rows,
        sigma0=fit.sigma0,
        redundancy=fit.redundancy,
        exclusion_effect=effect,
        notes=notes,
    )


def _common_names(control: SurveyedPoints, targets: SurveyedPoints) -> tuple[list[str], list[str]]:
    """Names of the targets in both files, in the order of control, and of those in one file only."""
    measured = set(targets.ids)
    names = [name for name in control.ids if name in measured]
    unmatched = sorted(set(control.ids) ^ set(targets.ids))
    if len(names) < MIN_TARGETS:
        raise InputError(
            f"shares {len(names)} targets with {_name(control.source)}; a transformation needs {MIN_TARGETS}",
            source=targets.source,
            where=f"unmatched: {', '.join(unmatched[:8])}" if unmatched else "",
            remedy="Use the same point_id in both files and measure at least three targets, better five, that are not on one line.",
        )
    return names, unmatched


def _notes(fit: WeightedFit, unmatched: Sequence[str], excluded: Sequence[str], effect: float, where_shifted: str) -> list[str]:
    """What a surveyor should know of a registration, one sentence each."""
    notes = [f"target {name} is in one file only" for name in unmatched]
    if excluded:
        out = ", ".join(excluded)
        notes.append(f"{DISTURBED}: {out}; keeping it would shift the cloud by up to {1000 * effect:.1f} mm at {where_shifted}")
    tilt = math.degrees(math.acos(float(np.clip(fit.transformation.rotation[2, 2], -1, 1))))
    if tilt > LEVEL_TOLERANCE:
        notes.append(
            f"vertical of the cloud is turned by {tilt:.1f} degrees against control: check the sign of heights unless it was not levelled"
        )
    if fit.redundancy < 3:
        notes.append(f"redundancy of the registration is {fit.redundancy}: a disturbed target cannot be told")
    return notes


def _check_spread(measured: FloatArray, noise: float, targets: SurveyedPoints) -> None:
    if not spread_enough(measured, noise):
        raise InputError(
            f"{len(measured)} common targets lie on one line: the rotation about it is not determined",
            source=targets.source,
            remedy="Add a target off that line (another height or another row on the deck).",
        )


def _check_axes(surveyed: FloatArray, measured: FloatArray, noise: float, control: SurveyedPoints, targets: SurveyedPoints) -> None:
    """Refuse exchanged columns: found as the order of columns with which the network fits upright."""
    axes = ("easting", "northing", "height")
    size = float(np.sqrt(np.mean(np.sum((surveyed - surveyed.mean(axis=0)) ** 2, axis=1))))
    tolerance = AXES_TOLERANCE * noise + SCALE_TOLERANCE * size
    given, *others = itertools.permutations(range(3))
    given_misfit, given_tilt, _ = _fit_of_columns(surveyed, measured, given)
    if given_misfit <= tolerance and given_tilt < 45:
        return
    found = [_fit_of_columns(surveyed, measured, order) for order in others]
    upright = [f for f in found if f[0] <= tolerance and f[1] < 45]
    if upright:
        order = min(upright)[2]
        columns = ", ".join(f"{axes[k]} holds {axes[order.index(k)]}" for k in range(3) if order[k] != k)
        raise InputError(
            f"columns or axes are exchanged: {columns}",
            source=control.source,
            remedy=f"Put easting, northing and height in their columns (here or in {_name(targets.source)}).",
        )
    if given_misfit <= tolerance:
        raise InputError(
            f"fits the targets only with the vertical turned by {given_tilt:.0f} degrees",
            source=control.source,
            remedy="Check the order of the columns, the sign of heights, and that the cloud's z points up.",
        )
    raise InputError(
        f"does not fit {_name(targets.source)}: half of the targets are off by more than {given_misfit:.3g} m",
        source=control.source,
        remedy="Check that point_ids name the same targets, that units and CRS agree (control_crs, control_unit), and the epoch.",
    )


def _fit_of_columns(surveyed: FloatArray, measured: FloatArray, order: tuple[int, ...]) -> tuple[float, float, tuple[int, ...]]:
    """Median misfit in metres and tilt in degrees of points whose surveyed columns are taken in some order, and this order."""
    moved = surveyed[:, order]
    x, y = measured - np.median(measured, axis=0), moved - np.median(moved, axis=0)
    rotation, _ = closed_form(x, y, np.ones(len(x)), False)
    misfit = (x - x.mean(axis=0)) @ rotation.T - (y - y.mean(axis=0))
    tilt = math.degrees(math.acos(float(np.clip(rotation[2, 2], -1, 1))))
    return float(np.median(np.linalg.norm(misfit, axis=1))), tilt, order


def _name(source: Path | None) -> str:
    return "the other file" if source is None else source.name
