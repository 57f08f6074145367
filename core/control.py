"""Registration of an epoch's cloud to survey control: weighted rigid or similarity transformation with data snooping.

Model per target: X = X0 + t + m R (x - x0), with x measured in the cloud and X surveyed. x0 and X0 are reduction points (the
weighted centroids), so that nothing runs on seven-digit coordinates and translation and rotation are nearly uncorrelated.
Outliers are tested a point (three coordinates) at a time with the externally studentised statistic, whose distribution F(3, r - 3)
holds for small redundancy too (Foerstner and Wrobel, 2016, Photogrammetric Computer Vision, 4.6.4), the level shared among the
points after Bonferroni (Pope, 1976; Baarda, 1968 for the notion of snooping).
"""

from __future__ import annotations

import csv
import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation
from scipy.special import fdtrc

from .errors import CrsError, InputError
from .pose import Pose

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
LengthUnit = Literal["m", "ft", "us-ft"]

METRES_PER: dict[LengthUnit, float] = {"m": 1.0, "ft": 0.3048, "us-ft": 1200 / 3937}
SNOOPING_LEVEL = 0.01
"""Probability of excluding any good target of an epoch."""
MIN_TARGETS = 3
LEAST_SPREAD = 0.1
"""Least spread of chosen targets across their main direction, over that of all targets."""
AXES_TOLERANCE = 30.0
"""Misfit of half of the targets, in stated standard deviations, that no measurement explains."""
SCALE_TOLERANCE = 0.002
"""Difference of scale that projection, height and instrument together can bring."""
LEVEL_TOLERANCE = 5.0
"""Tilt in degrees between a cloud's vertical and control that a levelled instrument never has."""
CONTROL_COLUMNS = ("point_id", "easting", "northing", "height", "sd_e", "sd_n", "sd_h")
TARGET_COLUMNS = ("point_id", "x", "y", "z")


@dataclass(frozen=True, eq=False)
class SurveyedPoints:
    """Named points of one file.

    Attributes
    ----------
    ids
        Names, unique.
    coordinates
        (n, 3) metres.
    sds
        (n, 3) standard deviations, metres; zero where the file states none.
    source
        File the points come from; None for points made in memory.
    """

    ids: tuple[str, ...]
    coordinates: FloatArray
    sds: FloatArray
    source: Path | None = None


@dataclass(frozen=True, eq=False)
class Transformation:
    """X = origin_to + translation + scale * rotation @ (x - origin_from), cloud to control frame.

    Attributes
    ----------
    origin_from, origin_to
        (3,) reduction points in the cloud and in the control frame, metres.
    translation
        (3,) metres.
    rotation
        (3, 3).
    scale
        1 for a rigid transformation.
    covariance
        (7, 7) of t_e, t_n, t_h (m), w_e, w_n, w_h (rad, rotation vector about the control frame's axes at ``origin_to``) and scale;
        zero rows for what was held fixed.
    """

    origin_from: FloatArray
    origin_to: FloatArray
    translation: FloatArray
    rotation: FloatArray
    scale: float
    covariance: FloatArray

    @classmethod
    def identity(cls, origin: ArrayLike) -> Transformation:
        """The cloud's own frame is kept, without uncertainty."""
        point = np.array(origin, dtype=np.float64)
        return cls(point, point.copy(), np.zeros(3), np.eye(3), 1.0, np.zeros((7, 7)))

    def apply(self, points: ArrayLike) -> FloatArray:
        """(n, 3) cloud coordinates to the control frame."""
        reduced = np.asarray(points, dtype=np.float64) - self.origin_from
        return np.asarray(self.scale * reduced @ self.rotation.T + (self.origin_to + self.translation))

    def invert(self, points: ArrayLike) -> FloatArray:
        """(n, 3) coordinates of the control frame to the cloud."""
        reduced = np.asarray(points, dtype=np.float64) - (self.origin_to + self.translation)
        return np.asarray(reduced @ self.rotation / self.scale + self.origin_from)

    def apply_pose(self, pose: Pose) -> Pose:
        """Pose in the cloud to the control frame."""
        return Pose(self.apply(pose.centre[None])[0], self.rotation @ pose.rotation)

    def jacobian(self, points: ArrayLike) -> FloatArray:
        """(n, 3, 7) derivatives of (n, 3) transformed points with respect to the seven parameters."""
        arm = np.asarray(points, dtype=np.float64).reshape(-1, 3) - self.origin_to
        return rigid_jacobian(arm)

    def covariance_at(self, origin: ArrayLike) -> FloatArray:
        """(7, 7) covariance of the same parameters with shifts referring to (3,) ``origin`` of the control frame."""
        carry = np.eye(7)
        carry[:3] = self.jacobian(origin)[0]
        return np.asarray(carry @ self.covariance @ carry.T)

    def pose_covariance(self, pose: Pose) -> FloatArray:
        """(6, 6) covariance of e, n, h and rotation vector that the registration brings into a pose of the control frame."""
        effect = np.zeros((6, 7))
        effect[:3] = self.jacobian(pose.centre)[0]
        effect[3:, 3:6] = np.eye(3)
        return np.asarray(effect @ self.covariance @ effect.T)

    def with_offset(self, variance: float) -> Transformation:
        """The same with the variance of a common offset along each axis (square metres) added to its covariance."""
        return replace(self, covariance=self.covariance + np.diag([variance] * 3 + [0.0] * 4))

    def with_shift(self, shift: ArrayLike, turn: ArrayLike, covariance: FloatArray) -> Transformation:
        """The transformation followed by a small motion (shift in m, rotation vector in rad, about ``origin_to``)."""
        matrix = Rotation.from_rotvec(np.asarray(turn, dtype=np.float64)).as_matrix()
        translation = matrix @ self.translation + np.asarray(shift, dtype=np.float64)
        return replace(self, translation=translation, rotation=matrix @ self.rotation, covariance=covariance)

    @classmethod
    def from_record(cls, record: Mapping[str, Any]) -> Transformation:
        """Inverse of :meth:`as_record`; see :func:`transformation_of` for records that may be incomplete."""
        return cls(
            np.array(record["origin_from"], dtype=np.float64),
            np.array(record["origin_to"], dtype=np.float64),
            np.array(record["translation_m"], dtype=np.float64),
            Rotation.from_rotvec(record["rotation_vector_rad"]).as_matrix(),
            float(record["scale"]),
            np.array(record["covariance"], dtype=np.float64),
        )

    def as_record(self) -> dict[str, Any]:
        """Plain numbers for the run record and the layer ``epochs``."""
        return {
            "model": "X = origin_to + translation + scale * R(rotation_vector) (x - origin_from)",
            "origin_from": self.origin_from.tolist(),
            "origin_to": self.origin_to.tolist(),
            "translation_m": self.translation.tolist(),
            "rotation_vector_rad": Rotation.from_matrix(self.rotation).as_rotvec().tolist(),
            "scale": self.scale,
            "covariance": self.covariance.tolist(),
        }


def transformation_of(record: Mapping[str, Any]) -> Transformation | None:
    """Transformation from the record in layer ``epochs``; None where the cloud's own frame was kept.

    Raises
    ------
    InputError
        The record is incomplete.
    """
    if not record:
        return None
    try:
        return Transformation.from_record(record)
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"layer epochs holds a transformation without {error}", remedy="Run tetratrack again.") from error


def mean_offset_variance(offsets: ArrayLike) -> float:
    """Variance per axis (square metres) of the mean of (k, 3) offsets of strips or stations; 0 for less than two."""
    own = np.asarray(offsets, dtype=np.float64).reshape(-1, 3)
    if len(own) < 2:
        return 0.0
    return float(np.mean(np.sum(own**2, axis=0) / (len(own) - 1) / len(own)))


@dataclass(frozen=True, eq=False)
class ControlResidual:
    """Residual of one target after the transformation, and the verdict on it.

    Attributes
    ----------
    position
        (3,) surveyed coordinates, metres.
    residual
        (3,) transformed cloud less surveyed coordinate, metres; of an excluded point the error it would have brought.
    w_max
        Largest of the three residuals over their standard deviations.
    p_value
        Of the point's outlier test, not yet shared among the points.
    """

    point_id: str
    position: FloatArray
    residual: FloatArray
    w_max: float
    p_value: float
    used: bool
    outlier: bool


@dataclass(frozen=True, eq=False)
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
        Label of the epoch whose registered cloud this one was tied to on stable areas; its error is part of the covariance. None for
        targets.
    """

    transformation: Transformation
    residuals: tuple[ControlResidual, ...]
    sigma0: float
    redundancy: int
    exclusion_effect: float
    notes: tuple[str, ...]
    reference: str | None = None

    @classmethod
    def own_frame(cls, origin: ArrayLike) -> Registration:
        """The cloud's own frame is the datum that other epochs are tied to."""
        return cls(Transformation.identity(origin), (), 1.0, 0, 0.0, ("no control, its cloud's own frame is the datum",))

    @property
    def excluded(self) -> tuple[str, ...]:
        """Names of the disturbed targets."""
        return tuple(r.point_id for r in self.residuals if r.outlier)


def rigid_jacobian(arms: FloatArray) -> FloatArray:
    """(n, 3, 7) derivative of points at (n, 3) ``arms`` from the reduction point by shift, rotation vector and scale."""
    jacobian = np.zeros((len(arms), 3, 7))
    jacobian[:, [0, 1, 2], [0, 1, 2]] = 1
    x, y, z = arms.T
    jacobian[:, 0, 4], jacobian[:, 0, 5] = z, -y
    jacobian[:, 1, 3], jacobian[:, 1, 5] = -z, x
    jacobian[:, 2, 3], jacobian[:, 2, 4] = y, -x
    jacobian[:, :, 6] = arms
    return jacobian


def read_control(path: str | Path) -> SurveyedPoints:
    """Read surveyed targets: ``point_id,easting,northing,height,sd_e,sd_n,sd_h``.

    Raises
    ------
    InputError
        File, header, line or field that cannot be used.
    """
    rows = read_point_table(path, CONTROL_COLUMNS, positive=("sd_e", "sd_n", "sd_h"))
    return _points(rows, ("easting", "northing", "height"), ("sd_e", "sd_n", "sd_h"), Path(path))


def read_targets(path: str | Path) -> SurveyedPoints:
    """Read targets as measured in the cloud: ``point_id,x,y,z`` and optionally ``sd`` in metres."""
    rows = read_point_table(path, TARGET_COLUMNS, positive=("sd",))
    sds = ("sd", "sd", "sd") if rows and "sd" in rows[0] else ()
    return _points(rows, ("x", "y", "z"), sds, Path(path))


def read_point_table(
    path: str | Path,
    columns: Sequence[str],
    *,
    positive: Iterable[str] = (),
    text: Iterable[str] = ("point_id",),
    unique: bool = True,
    may_be_empty: bool = False,
) -> list[dict[str, Any]]:
    """Read a CSV of points: numbers as float, ``text`` columns as str; the key ``line`` tells where a row stands.

    Further columns are kept if they hold numbers. The first of ``text`` is the name and must be unique unless ``unique`` is False. No
    points at all are an error unless they ``may_be_empty``.

    Raises
    ------
    InputError
        With the line and field at fault.
    """
    source, text, positive = Path(path), tuple(text), tuple(positive)
    try:
        lines = source.read_text(encoding="utf-8-sig").splitlines()
    except FileNotFoundError:
        raise InputError("does not exist", source=source, remedy="Correct the path in survey.toml.") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"cannot be read ({error})", source=source, remedy="Save it as UTF-8 text with commas.") from None
    header, *body = list(csv.reader(lines, skipinitialspace=True)) or [[]]
    names = [name.strip().lower() for name in header]
    missing = [name for name in columns if name not in names]
    if missing:
        hint = " (columns are separated by ';' or tabs: use commas)" if len(names) == 1 and (";" in names[0] or "\t" in names[0]) else ""
        found = ", ".join(names) if any(names) else "nothing"
        raise InputError(
            f"has no column {', '.join(missing)}{hint}; found {found}",
            source=source,
            where="line 1",
            remedy=f"The header must be {','.join(columns)}.",
        )
    repeated = {name for name in columns if names.count(name) > 1}
    if repeated:
        raise InputError(f"has column {', '.join(sorted(repeated))} twice", source=source, where="line 1", remedy="Name every column once.")
    rows: list[dict[str, Any]] = []
    seen: dict[str, int] = {}
    for number, fields in enumerate(body, start=2):
        if not any(field.strip() for field in fields):
            continue
        if len(fields) != len(names):
            raise InputError(
                f"has {len(fields)} fields, the header {len(names)}",
                source=source,
                where=f"line {number}",
                remedy="Use a point as decimal sign and one comma between fields.",
            )
        row: dict[str, Any] = {"line": number}
        for name, field in zip(names, fields):
            if name in text:
                row[name] = field.strip()
            elif name in columns or field.strip():
                value = _number(field, name, name in columns or name in positive, source, number)
                if name in positive and value is not None and value <= 0:
                    raise InputError(
                        f"standard deviation {field.strip()} is not positive",
                        source=source,
                        where=f"line {number}, field {name}",
                        remedy="Give the standard deviation of the coordinate in metres.",
                    )
                if value is not None:
                    row[name] = value
        key = str(row[text[0]])
        if not key:
            raise InputError("has an empty name", source=source, where=f"line {number}, field {text[0]}", remedy="Name every point.")
        if unique and key in seen:
            raise InputError(
                f"names point {key!r} again (first in line {seen[key]})",
                source=source,
                where=f"line {number}, field {text[0]}",
                remedy="Every point of an epoch needs a name of its own: rename or remove one.",
            )
        seen.setdefault(key, number)
        rows.append(row)
    if not (rows or may_be_empty):
        raise InputError("holds no points", source=source, remedy="Write one line for each point under the header.")
    return rows


def to_survey_frame(points: SurveyedPoints, crs: str | None, survey_crs: str, unit: LengthUnit = "m") -> SurveyedPoints:
    """Control from another CRS, height system or length unit to the survey's.

    Parameters
    ----------
    points
        Coordinates as in the file: easting, northing, height whatever the axis order of the CRS's definition.
    crs
        CRS of the file ("EPSG:5179", compound "EPSG:5186+5193"); None for the survey's own.
    survey_crs
        CRS of the results, or "LOCAL".
    unit
        Length unit of the file's numbers where ``crs`` does not state one of its own: for a CRS defined in feet the
        horizontal numbers are its feet, and ``unit`` is that of heights unless the CRS is compound.

    Raises
    ------
    CrsError
        A CRS that cannot be used, or a transformation whose grid is not installed: refused, since without it PROJ would fall back
        to a less accurate one or leave heights as they are.
    """
    import pyproj
    from pyproj.exceptions import CRSError, ProjError

    factor = METRES_PER[unit]
    if crs is None or crs == survey_crs:
        return replace(points, coordinates=points.coordinates * factor, sds=points.sds * factor)
    if survey_crs == "LOCAL":
        raise CrsError(f"is in {crs}, the survey in a local frame", source=points.source, remedy="Give control in the local frame.")
    try:
        source, target = pyproj.CRS.from_user_input(crs), pyproj.CRS.from_user_input(survey_crs)
    except CRSError as error:
        raise CrsError(f"CRS {crs!r} is not known ({error})", source=points.source, remedy="Use a code such as EPSG:32652.") from None
    horizontal = source.sub_crs_list[0] if source.is_compound else source
    if not horizontal.is_projected:
        raise CrsError(f"CRS {crs} is not projected", source=points.source, remedy="Give control as easting, northing, height.")
    to_metre = horizontal.axis_info[0].unit_conversion_factor
    if source.is_compound != target.is_compound and source.is_compound:
        raise CrsError(
            f"heights are in {source.sub_crs_list[1].name}, the survey's CRS {survey_crs} has no height system",
            source=points.source,
            remedy="Give the survey's crs its height system too, or drop it from control_crs if both are equal.",
        )
    group = pyproj.transformer.TransformerGroup(source, target, always_xy=True)
    if group.unavailable_operations and not group.best_available:
        grids = ", ".join(sorted({g.short_name for o in group.unavailable_operations for g in o.grids if not g.available}))
        raise CrsError(
            f"transformation from {crs} to {survey_crs} needs the grid {grids}, which is not installed",
            source=points.source,
            remedy=f"Install it (projsync --file {grids.split(',')[0]}) or give control in {survey_crs}.",
        )
    if source.is_compound and source.sub_crs_list[1] != target.sub_crs_list[1] and not _changes_heights(group):
        raise CrsError(
            f"no transformation is known between heights {source.sub_crs_list[1].name} and {target.sub_crs_list[1].name}",
            source=points.source,
            remedy="Give control heights in the survey's height system.",
        )
    horizontal_factor = factor if math.isclose(to_metre, 1.0) else 1.0
    height_factor = 1.0 if source.is_compound and horizontal_factor != factor else factor
    given = points.coordinates * [horizontal_factor, horizontal_factor, height_factor]
    try:
        transformer = pyproj.Transformer.from_crs(source, target, always_xy=True, only_best=True)
        moved = np.column_stack(transformer.transform(given[:, 0], given[:, 1], given[:, 2], errcheck=True))
    except ProjError as error:
        raise CrsError(
            f"cannot be transformed from {crs} to {survey_crs} ({error})", source=points.source, remedy=f"Give control in {survey_crs}."
        ) from None
    if not np.isfinite(moved).all():
        raise CrsError(
            f"lies outside the area of {crs} or {survey_crs}", source=points.source, remedy="Check control_crs and the axis order."
        )
    horizontal_sd = horizontal_factor * to_metre
    vertical_sd = source.sub_crs_list[1].axis_info[0].unit_conversion_factor if source.is_compound else height_factor
    return replace(points, coordinates=moved, sds=points.sds * [horizontal_sd, horizontal_sd, vertical_sd])


def grid_scale(crs: str, position: ArrayLike) -> float:
    """Grid distance over ground distance at (3,) easting, northing, height: scale of the projection times the reduction to the ellipsoid.

    Total-station distances are on the ground; in a network of 100 m a scale of 0.9996 is 4 cm.
    """
    import pyproj

    definition = pyproj.CRS.from_user_input(crs)
    horizontal = definition.sub_crs_list[0] if definition.is_compound else definition
    easting, northing, height = np.asarray(position, dtype=np.float64)
    back = pyproj.Transformer.from_crs(horizontal, horizontal.geodetic_crs, always_xy=True)
    longitude, latitude = back.transform(easting, northing)
    factors = pyproj.Proj(horizontal).get_factors(longitude, latitude)
    mean_radius = 6_371_000.0
    return float(math.sqrt(factors.areal_scale) * (1 - height / mean_radius))


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
    names = [name for name in control.ids if name in set(targets.ids)]
    unmatched = sorted(set(control.ids) ^ set(targets.ids))
    if len(names) < MIN_TARGETS:
        raise InputError(
            f"shares {len(names)} targets with {_name(control.source)}; a transformation needs {MIN_TARGETS}",
            source=targets.source,
            where=f"unmatched: {', '.join(unmatched[:8])}" if unmatched else "",
            remedy="Use the same point_id in both files and measure at least three targets, better five, that are not on one line.",
        )
    pick_control = [control.ids.index(name) for name in names]
    pick_target = [targets.ids.index(name) for name in names]
    surveyed, measured = control.coordinates[pick_control], targets.coordinates[pick_target]
    variances = control.sds[pick_control] ** 2 + targets.sds[pick_target] ** 2
    if not (variances > 0).all():
        variances = np.where(variances > 0, variances, np.max(variances) or 1.0)
    noise = float(math.sqrt(np.median(variances)))
    _check_spread(measured, noise, targets)
    _check_axes(surveyed, measured, noise, control, targets)
    pool = sum(r.sigma0**2 * r.redundancy for r in others), sum(r.redundancy for r in others)
    used = _snoop(surveyed, measured, variances, similarity, level, pool)
    fit = _fit(surveyed, measured, variances, used, similarity)
    everything = _fit(surveyed, measured, variances, np.ones(len(names), dtype=bool), similarity)
    residuals = fit.transformation.apply(measured) - surveyed
    residual_rows = []
    for k, name in enumerate(names):
        statistic, p_value = _outlier_test(surveyed, measured, variances, used, similarity, k, pool)
        residual_rows.append(
            ControlResidual(name, surveyed[k], residuals[k], float(np.max(np.abs(statistic))), p_value, bool(used[k]), not used[k])
        )
    effect = 0.0
    if not used.all():
        where = measured if reference is None else np.asarray(reference, dtype=np.float64).reshape(-1, 3)
        shift = everything.transformation.apply(where) - fit.transformation.apply(where)
        effect = float(np.max(np.linalg.norm(shift, axis=1)))
    notes = [f"target {name} is in one file only" for name in unmatched]
    if not used.all():
        out = ", ".join(n for n, u in zip(names, used) if not u)
        where_shifted = "the targets" if reference is None else "the units"
        notes.append(
            f"disturbed target excluded: {out}; keeping it would shift the cloud by up to {1000 * effect:.1f} mm at {where_shifted}"
        )
    tilt = math.degrees(math.acos(float(np.clip(fit.transformation.rotation[2, 2], -1, 1))))
    if tilt > LEVEL_TOLERANCE:
        notes.append(
            f"vertical of the cloud is turned by {tilt:.1f} degrees against control: check the sign of heights unless it was not levelled"
        )
    if fit.redundancy < 3:
        notes.append(f"redundancy of the registration is {fit.redundancy}: a disturbed target cannot be told")
    # an a posteriori factor below 1 is not trusted: the stated deviations are the least a surveyor vouches for
    factor = max(1.0, fit.sigma0) ** 2 if fit.redundancy > 0 else 1.0
    transformation = replace(fit.transformation, covariance=fit.transformation.covariance * factor)
    return Registration(transformation, tuple(residual_rows), fit.sigma0, fit.redundancy, effect, tuple(notes))


@dataclass(frozen=True, eq=False)
class _Fit:
    transformation: Transformation
    sigma0: float
    redundancy: int
    square_sum: float
    residuals: FloatArray
    rows: FloatArray


def _fit(surveyed: FloatArray, measured: FloatArray, variances: FloatArray, used: BoolArray, similarity: bool) -> _Fit:
    """Weighted least squares over the used points; closed-form start, then Gauss-Newton with the full weights."""
    weights = np.where(used[:, None], 1 / variances, 0.0)
    mean_weight = weights.mean(axis=1)
    origin_from = np.average(measured, axis=0, weights=mean_weight)
    origin_to = np.average(surveyed, axis=0, weights=mean_weight)
    x, y = measured - origin_from, surveyed - origin_to
    rotation, scale = _closed_form(x[used], y[used], mean_weight[used], similarity)
    free = 7 if similarity else 6
    translation = np.zeros(3)
    cofactor = np.zeros((7, 7))
    for _ in range(10):
        turned = scale * x @ rotation.T
        misfit = y - turned - translation
        rows = rigid_jacobian(turned)[:, :, :free]
        rows = rows.copy()
        if similarity:
            rows[:, :, 6] /= scale
        normal = np.einsum("nia,ni,nib->ab", rows, weights, rows)
        change = np.linalg.solve(normal, np.einsum("nia,ni,ni->a", rows, weights, misfit))
        translation = translation + change[:3]
        rotation = Rotation.from_rotvec(change[3:6]).as_matrix() @ rotation
        if similarity:
            scale += change[6]
        if np.linalg.norm(change[:3]) < 1e-9 and np.linalg.norm(change[3:6]) < 1e-12:
            break
    cofactor[:free, :free] = np.linalg.inv(normal)
    residuals = scale * x @ rotation.T + translation - y
    redundancy = 3 * int(used.sum()) - free
    square_sum = float(np.sum(weights * residuals**2))
    sigma0 = math.sqrt(square_sum / redundancy) if redundancy > 0 else 1.0
    transformation = Transformation(origin_from, origin_to, translation, rotation, float(scale), cofactor)
    return _Fit(transformation, sigma0, redundancy, square_sum, residuals, rows)


def _closed_form(x: FloatArray, y: FloatArray, weights: FloatArray, similarity: bool) -> tuple[FloatArray, float]:
    """Rotation and scale of reduced points (Umeyama, 1991, IEEE PAMI 13(4))."""
    x, y = x - np.average(x, axis=0, weights=weights), y - np.average(y, axis=0, weights=weights)
    u, s, vt = np.linalg.svd((y * weights[:, None]).T @ x)
    sign = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    rotation = u @ np.diag(sign) @ vt
    scale = float(np.sum(s * sign) / np.sum(weights * np.sum(x**2, axis=1))) if similarity else 1.0
    return rotation, scale


def _outlier_test(
    surveyed: FloatArray,
    measured: FloatArray,
    variances: FloatArray,
    used: BoolArray,
    similarity: bool,
    point: int,
    pool: tuple[float, int],
) -> tuple[FloatArray, float]:
    """Prediction of one point from the other used ones: normalised residuals (3,) and p-value of all three together.

    ``pool`` is the weighted square sum of the residuals of other epochs and its redundancy.
    """
    others = used.copy()
    others[point] = False
    if others.sum() < MIN_TARGETS or not _spread_enough(measured[others], float(math.sqrt(np.median(variances))), measured):
        return np.zeros(3), 1.0
    fit = _fit(surveyed, measured, variances, others, similarity)
    moved = fit.transformation.apply(measured[point][None])
    gap = (moved - surveyed[point])[0]
    jacobian = fit.transformation.jacobian(moved)[0]
    cofactor = np.diag(variances[point]) + jacobian @ fit.transformation.covariance @ jacobian.T
    redundancy = fit.redundancy + pool[1]
    if fit.redundancy < 1:
        return np.zeros(3), 1.0
    # a sample variance below the stated one is luck as a rule; without this floor a lucky handful would condemn good targets
    unit_variance = max((fit.square_sum + pool[0]) / redundancy, 1.0)
    statistic = float(gap @ np.linalg.solve(cofactor, gap)) / 3 / unit_variance
    return gap / np.sqrt(np.diag(cofactor) * unit_variance), float(fdtrc(3, redundancy, statistic))


def _snoop(
    surveyed: FloatArray, measured: FloatArray, variances: FloatArray, similarity: bool, level: float, pool: tuple[float, int]
) -> BoolArray:
    """Points to use: from all points and from a robust start, the worst point out and any good one back in until nothing changes.

    Several disturbed targets can hide each other from the first; the second begins with the points that agree best, which makes the
    noise look too small and good targets too far off. So the second counts only where its variance is significantly less.
    """
    count = len(surveyed)
    if count <= MIN_TARGETS + 1:
        return np.ones(count, dtype=bool)
    from_all, robust = (
        _settled(surveyed, measured, variances, similarity, level, pool, start)
        for start in (np.ones(count, dtype=bool), _robust_start(surveyed, measured, variances))
    )
    fits = [_fit(surveyed, measured, variances, used, similarity) for used in (from_all, robust)]
    ratio = fits[0].sigma0 ** 2 / max(fits[1].sigma0 ** 2, 1.0)
    smaller = fdtrc(fits[0].redundancy, fits[1].redundancy, ratio) < level
    return robust if smaller else from_all


def _settled(
    surveyed: FloatArray,
    measured: FloatArray,
    variances: FloatArray,
    similarity: bool,
    level: float,
    pool: tuple[float, int],
    used: BoolArray,
) -> BoolArray:
    count = len(surveyed)
    critical = level / count
    for _ in range(2 * count):
        p = np.array([_outlier_test(surveyed, measured, variances, used, similarity, k, pool)[1] for k in range(count)])
        back = np.where(~used, p, 0.0)
        worst = np.where(used, p, 2.0)
        if back.max() >= critical:
            used[int(np.argmax(back))] = True
        elif worst.min() < critical and used.sum() > MIN_TARGETS + 1:
            used[int(np.argmin(worst))] = False
        else:
            break
    return used


def _robust_start(surveyed: FloatArray, measured: FloatArray, variances: FloatArray) -> BoolArray:
    """Half of the points, and at least four, that agree best with a transformation through some three of them (least median of squares)."""
    count = len(surveyed)
    triples = list(itertools.combinations(range(count), 3))
    if len(triples) > 400:
        rng = np.random.default_rng(0)
        triples = [tuple(t) for t in np.array(triples)[rng.choice(len(triples), 400, replace=False)]]
    keep = max(MIN_TARGETS + 1, count // 2 + 1)
    best, chosen = math.inf, np.arange(keep)
    noise = float(math.sqrt(np.median(variances)))
    for triple in triples:
        index = list(triple)
        if not _spread_enough(measured[index], noise, measured):
            continue
        rotation, _ = _closed_form(measured[index], surveyed[index], np.ones(3), False)
        moved = (measured - measured[index].mean(axis=0)) @ rotation.T + surveyed[index].mean(axis=0)
        squares = np.sum((moved - surveyed) ** 2 / variances, axis=1)
        order = np.argsort(squares)[:keep]
        if squares[order[-1]] < best and _spread_enough(measured[order], noise, measured):
            best, chosen = float(squares[order[-1]]), order
    used = np.zeros(count, dtype=bool)
    used[chosen] = True
    return used


def _spread_enough(points: FloatArray, noise: float, network: FloatArray | None = None) -> bool:
    """Whether points lie so far off one line that the rotation about it is determined (better than about 10 degrees).

    Of points chosen from a ``network`` more is asked: targets in one row agree with each other whatever the rotation about the row, and
    would condemn all others. Noise alone, often understated, must not pass for a spread.
    """
    values = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    least = max(5 * noise, 1e-3 * values[0])
    if network is not None:
        whole = np.linalg.svd(network - network.mean(axis=0), compute_uv=False)[1]
        least = max(least, LEAST_SPREAD * whole * math.sqrt(len(points) / len(network)))
    return bool(values[1] > least)


def _check_spread(measured: FloatArray, noise: float, targets: SurveyedPoints) -> None:
    if not _spread_enough(measured, noise):
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
    found: list[tuple[float, float, tuple[int, ...]]] = []
    for order in itertools.permutations(range(3)):
        moved = surveyed[:, order]
        x, y = measured - np.median(measured, axis=0), moved - np.median(moved, axis=0)
        rotation, _ = _closed_form(x, y, np.ones(len(x)), False)
        misfit = (x - x.mean(axis=0)) @ rotation.T - (y - y.mean(axis=0))
        tilt = math.degrees(math.acos(float(np.clip(rotation[2, 2], -1, 1))))
        found.append((float(np.median(np.linalg.norm(misfit, axis=1))), tilt, order))
    given_misfit, given_tilt, _ = found[0]
    if given_misfit <= tolerance and given_tilt < 45:
        return
    upright = [f for f in found[1:] if f[0] <= tolerance and f[1] < 45]
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


def _changes_heights(group: Any) -> bool:
    return any("ballpark vertical" not in t.description.lower() for t in group.transformers)


def _points(rows: list[dict[str, Any]], axes: Sequence[str], sds: Sequence[str], source: Path) -> SurveyedPoints:
    coordinates = np.array([[row[a] for a in axes] for row in rows], dtype=np.float64)
    deviations = np.array([[row[s] for s in sds] for row in rows], dtype=np.float64) if sds else np.zeros_like(coordinates)
    return SurveyedPoints(tuple(str(row["point_id"]) for row in rows), coordinates, deviations, source)


def _number(field: str, name: str, required: bool, source: Path, line: int) -> float | None:
    try:
        value = float(field)
    except ValueError:
        if not required:
            return None
        raise InputError(
            f"{field.strip()!r} is not a number", source=source, where=f"line {line}, field {name}", remedy="Use a point as decimal sign."
        ) from None
    if not math.isfinite(value):
        raise InputError(
            f"{field.strip()} is not finite", source=source, where=f"line {line}, field {name}", remedy="Give a number or drop the line."
        )
    return value


def _name(source: Path | None) -> str:
    return "the other file" if source is None else source.name
