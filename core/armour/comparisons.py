"""A result against its design, and cut into profiles: read, computed and written as one GeoPackage beside it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..common.axis import Axis, parse_axis
from ..common.centreline import ARM_HEIGHTS, centreline
from ..common.errors import InputError
from ..common.output_files import check_ending, check_targets
from ..results.comparison_layers import PLAN_LAYERS, PROFILE_LAYERS, SECTION_LAYERS
from ..results.field_checks import foreign_contents
from ..results.frame_heights import FrameHeights
from ..results.geopackage_reader import EpochPair, crs_of, read_layer_rows
from ..results.geopackage_writer import check_beside, write_beside
from ..results.schema import Layer
from ..results.unit_rows import read_epochs, read_unit_rows
from ..review.point_index import index_folder, index_of
from .as_built import AsBuilt, of_height, read_as_built
from .crest import CrestErrors, crest_rows
from .design_files import read_design_lines, read_plan, split_source
from .design_surface import DesignSurface, Reference, compare_with_profile, design_surface
from .placement_plan import PlanComparison, Tolerance, compare_with_plan
from .sections import CutPlane, cut_planes, section_rows, settlement_rows

SLAB = 0.15
"""Points nearer than this to a section belong to it, metres, of units of usual size (:func:`.as_built.of_height`)."""
UNJUDGED = Tolerance()
DEFAULT_STEP_HEIGHTS = 4.0
"""Distance of sections unless another is asked for, heights H."""
Clouds = Callable[[str], Iterable[FloatArray]]
"""Points (n, 3) of an epoch in parts, control frame; none of an epoch that has none."""


def no_clouds(epoch: str) -> Iterable[FloatArray]:
    """No points of any epoch."""
    return ()


@dataclass(frozen=True, kw_only=True)
class Design:
    """What a result is held against.

    Attributes
    ----------
    plan, profile
        Files (see :mod:`.design_files`), '' for none.
    tolerance
        Of places and turns in the plan.
    profile_tolerance
        Metres off the profile; None does not judge.
    reference
        What is judged against the profile.
    axis
        (n, 2) of the structure; the centreline of its units by default.
    """

    plan: str = ""
    profile: str = ""
    tolerance: Tolerance = UNJUDGED
    profile_tolerance: float | None = None
    reference: Reference = "outer"
    axis: FloatArray | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class DesignComparison:
    """Units of one epoch against the plan and the profile; None and [] where none was given."""

    epoch: str
    plan: PlanComparison | None
    profile: list[dict[str, Any]]

    @property
    def profile_summary(self) -> dict[str, float]:
        """Units under the profile, those outside the tolerance, and mean and root mean square of the distances, metres."""
        centre, outer = (np.array([row[name] for row in self.profile]) for name in ("off_centre", "off_outer"))
        found: dict[str, float] = {"units": len(self.profile), "outside": sum(row["verdict"] == "outside" for row in self.profile)}
        for name, values in (("centre", centre), ("outer", outer)):
            found |= {f"{name}_mean": float(values.mean()), f"{name}_rms": float(np.sqrt(np.mean(values**2)))}
        return found

    @property
    def counts(self) -> dict[str, int]:
        """Units compared, missing and outside, by what they were compared with."""
        found: dict[str, int] = {}
        if self.plan is not None:
            missing = sum(row["kind"] == "missing" for row in self.plan.unmatched)
            found |= {"placed": len(self.plan.deviations), "missing": missing, "outside": self.plan.count("outside")}
        if self.profile:
            found |= {"on_profile": len(self.profile), "off_profile": sum(row["verdict"] == "outside" for row in self.profile)}
        return found


@dataclass(frozen=True, eq=False, kw_only=True)
class Profiles:
    """Rows of ``sections``, ``crest`` and ``settlement``, the planes of the sections and the epochs."""

    planes: list[CutPlane]
    epochs: tuple[str, ...]
    sections: list[dict[str, Any]]
    crest: list[dict[str, Any]]
    settlement: list[dict[str, Any]]

    @property
    def has_points(self) -> bool:
        """Whether sections show points beside blocks."""
        return any(row["kind"] == "points" for row in self.sections)


def design_of(
    *,
    plan: str,
    profile: str,
    reference: str,
    axis: str,
    tolerance: float | None = None,
    turn_tolerance: float | None = None,
    profile_tolerance: float | None = None,
) -> Design:
    """Design from the texts and numbers of options.

    Raises
    ------
    InputError
        The reference is another word, or the axis no list of places.
    """
    if reference not in ("outer", "centre"):
        raise InputError(f"{reference!r} cannot be compared with a profile", remedy="Choose outer or centre.")
    return Design(
        plan=plan,
        profile=profile,
        tolerance=Tolerance(place=tolerance, turn=turn_tolerance),
        profile_tolerance=profile_tolerance,
        reference="centre" if reference == "centre" else "outer",
        axis=parse_axis(axis) if axis else None,
    )


def compare_design(result: Path, design: Design, epoch: str | None = None, *, excluded: Collection[str] = frozenset()) -> DesignComparison:
    """Units of one epoch, by default the latest, against a placement plan and a design profile; ``excluded`` ones are left out.

    Raises
    ------
    InputError
        Nothing was given to compare with, a file cannot be used, or no unit lies between the lines of the profile.
    """
    if not design.plan and not design.profile:
        raise InputError("there is nothing to compare with", remedy="Give a placement plan, a design profile, or both.")
    model = read_as_built(result, epoch).without(excluded)
    plan = None
    if design.plan:
        plan = compare_with_plan(model, read_plan(design.plan, model.crs), design.tolerance)
        if not plan.deviations:
            remedy = "Check that the plan is in the CRS of the survey, and its heights are those of centres."
            raise InputError("has no place within one height of a unit", source=split_source(design.plan)[0], remedy=remedy)
    rows = []
    if design.profile:
        axis = _axis(design.axis, [model])
        surface = _surface(design.profile, model, axis)
        rows = compare_with_profile(model, surface, axis, design.profile_tolerance, design.reference)
        if not rows:
            remedy = "Check its CRS; a single line is a cross-section along the whole structure, several are its edges."
            raise InputError("covers no unit", source=split_source(design.profile)[0], remedy=remedy)
    return DesignComparison(epoch=model.epoch, plan=plan, profile=rows)


def write_design_comparison(result: Path, output: Path, design: Design, epoch: str | None = None) -> DesignComparison:
    """Write :func:`compare_design` as a GeoPackage.

    Raises
    ------
    InputError
        As :func:`compare_design`.
    OutputError
        The file cannot be written, or holds anything else than an earlier comparison of this kind.
    """
    _check(output, result, [design.plan, design.profile], (*PLAN_LAYERS, *PROFILE_LAYERS))
    found = compare_design(result, design, epoch)
    tables: dict[str, Sequence[Mapping[str, Any]]] = {}
    layers: list[Layer] = []
    if found.plan is not None:
        layers += PLAN_LAYERS
        tables |= {"plan_deviations": found.plan.deviations, "plan_unmatched": found.plan.unmatched}
    if design.profile:
        layers += PROFILE_LAYERS
        tables["profile_deviations"] = found.profile
    write_beside(output, crs_of(result), {layer.name: layer for layer in layers}, tables)
    return found


def profiles(
    result: Path,
    *,
    clouds: Clouds = no_clouds,
    axis: FloatArray | None = None,
    step: float | None = None,
    profile: str = "",
    excluded: Collection[str] = frozenset(),
) -> Profiles:
    """Cross-sections of all epochs, the crest of each reach and settlement along the structure.

    Parameters
    ----------
    clouds
        Points to show in the sections.
    axis
        (n, 2) of the structure; the centreline of its units by default.
    step
        Distance of the sections, metres; four heights H by default.
    profile
        Design profile to draw into the sections, '' for none.
    excluded
        Units that are left out, by name.

    Raises
    ------
    InputError
        A file cannot be used, or the step is not positive.
    """
    if step is not None and not step > 0:
        raise InputError(f"the distance of sections is {step} m", remedy="Give metres above zero.")
    models = [model for model in (model.without(excluded) for model in _models(result)) if model.units]
    line = _axis(axis, models)
    places = np.array([unit.shape.centre for model in models for unit in model.units])
    height = float(models[-1].units[0].row["height"])
    distance = DEFAULT_STEP_HEIGHTS * height if step is None else step
    planes = cut_planes(line, places, distance)
    surface = _surface(profile, models[-1], line) if profile else None
    epochs = tuple(model.epoch for model in models)
    slab = of_height(SLAB, min(model.height for model in models))
    return Profiles(
        planes=planes,
        epochs=epochs,
        sections=section_rows(models, line, planes, _by_section(clouds, epochs, planes, slab), surface),
        crest=crest_rows(models, line, planes, _crest_errors(result, epochs)),
        settlement=settlement_rows(read_layer_rows(result, "stretches"), line, float(places[:, 2].max())),
    )


def write_profiles(result: Path, output: Path, *, axis: FloatArray | None = None, step: float | None = None, profile: str = "") -> Profiles:
    """Write :func:`profiles` as a GeoPackage, with the points of the index beside the result where there is one.

    Raises
    ------
    InputError
        As :func:`profiles`, or the index is damaged or of an earlier state of the result.
    OutputError
        The file cannot be written, or holds anything else than an earlier comparison of this kind.
    """
    _check(output, result, [profile], SECTION_LAYERS)
    clouds = index_of(result).clouds if (index_folder(result) / "index.json").is_file() else no_clouds
    found = profiles(result, clouds=clouds, axis=axis, step=step, profile=profile)
    tables = {"sections": found.sections, "crest": found.crest, "settlement": found.settlement}
    write_beside(output, crs_of(result), {layer.name: layer for layer in SECTION_LAYERS}, tables)
    return found


def _check(output: Path, result: Path, sources: Sequence[str], layers: Sequence[Layer]) -> None:
    check_ending(output, (".gpkg",))
    check_targets([(output, "the comparison")], [result, *(split_source(source)[0] for source in sources if source)])
    check_beside(output, layers)


def _models(result: Path) -> list[AsBuilt]:
    latest = read_as_built(result)
    have = {row["epoch"] for row in read_layer_rows(result, "units") if row["geom"] is not None and row["qw"] is not None}
    rows = read_layer_rows(result, "epochs")
    labels = [str(row["label"]) for row in sorted(rows, key=lambda row: str(row["time"])) if row["label"] in have]
    return [latest if label == latest.epoch else read_as_built(result, label) for label in labels]


def _crest_errors(result: Path, epochs: Sequence[str]) -> CrestErrors:
    """What is known of the errors of heights and of their changes from one of the ``epochs`` to the next."""
    bends = read_layer_rows(result, "frame_errors")
    with foreign_contents(result):
        frames = {info.label: FrameHeights.read(info, bends) for info in read_epochs(result)}
    changes = {}
    for pair in pairwise(epochs):
        moved = read_unit_rows(result, EpochPair(*pair), "control")
        changes[pair] = {row.unit_id: float(row.sd[2]) ** 2 for row in moved if row.sd is not None}
    return CrestErrors(frames, changes)


def _axis(given: FloatArray | None, models: Sequence[AsBuilt]) -> Axis:
    if given is not None:
        return Axis(given)
    units = models[-1].units
    return centreline(np.array([unit.shape.centre for unit in units]), ARM_HEIGHTS * float(units[0].row["height"]))


def _surface(source: str, model: AsBuilt, axis: Axis) -> DesignSurface:
    return design_surface(read_design_lines(source, model.crs), axis, model.height, split_source(source)[0])


def _by_section(clouds: Clouds, epochs: Sequence[str], planes: Sequence[CutPlane], slab: float) -> dict[str, list[FloatArray]]:
    """Points of each epoch within ``slab`` metres of each section; epochs without points are left out."""
    found: dict[str, list[FloatArray]] = {}
    for epoch in epochs:
        parts = [[points[np.abs((points[:, :2] - p.place) @ p.heading) <= slab] for p in planes] for points in clouds(epoch)]
        if parts:
            found[epoch] = [np.vstack(own) for own in zip(*parts, strict=True)]
    return found
