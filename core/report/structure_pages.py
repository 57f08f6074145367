"""Pages of the report on the structure: placement, cross-sections and crest, and what was built against what was designed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..armour.comparisons import Clouds, Design, DesignComparison, Profiles, compare_design, profiles
from ..armour.placement import Placement, UnitPlacement, placement_of_units, summary
from ..armour.placement_rows import COUNTED
from ..common.arrays import FloatArray
from ..model.outline import PlacedShape
from ..model.unit_types import UnitType
from ..results.geopackage_reader import EpochPair, read_layer_rows
from ..results.unit_rows import UnitRow
from ..results.unit_sizes import UnitSize
from .damage import nominal_diameter_of
from .figures import Translate
from .movement_bands import Band, damage_state, movement_bands
from .structure_figures import crest_chart, design_map, section_figures, structure_words


@dataclass(frozen=True, eq=False, kw_only=True)
class StructurePages:
    """What the pages on the structure show.

    Attributes
    ----------
    placement
        Of the later epoch; None where it cannot be stated.
    bands, state
        Movement bands and the word for the damage; () and '' where no unit can be judged.
    profiles
        Sections of the pair's epochs; None where there is no unit with a pose.
    design
        Later epoch against its design; None where none was given.
    figures
        Pictures by name, those of sections as a list.
    words
        Translated words for states and verdicts.
    """

    placement: Placement | None
    bands: tuple[Band, ...]
    state: str
    profiles: Profiles | None
    design: DesignComparison | None
    figures: Mapping[str, Any]
    words: Mapping[str, str]

    @property
    def notes(self) -> tuple[str, ...]:
        """What whoever asked for the report is to be told of them."""
        plan = None if self.design is None else self.design.plan
        return () if plan is None or not plan.doubt else (plan.doubt,)

    @property
    def reaches(self) -> list[tuple[float, list[Mapping[str, Any]]]]:
        """Rows of the crest by chainage."""
        found: dict[float, list[Mapping[str, Any]]] = {}
        for row in self.profiles.crest if self.profiles else ():
            found.setdefault(float(row["along"]), []).append(row)
        return sorted(found.items())


@dataclass(frozen=True, eq=False, kw_only=True)
class StructureOptions:
    """What the pages are asked for: design files and tolerances, distance of the sections (m), movement bands, axis (n, 2)."""

    design: Design | None = None
    step: float | None = None
    bands: str = "usace"
    axis: FloatArray | None = None


def structure_pages(
    result: Path,
    pair: EpochPair,
    shapes: tuple[Mapping[str, PlacedShape], Mapping[str, PlacedShape]],
    rows: Sequence[UnitRow],
    rejected: frozenset[str],
    sizes: Sequence[UnitSize],
    options: StructureOptions,
    translate: Translate,
    *,
    clouds: Clouds,
    shown: frozenset[str],
) -> StructurePages:
    """Compute and draw the pages.

    Parameters
    ----------
    shapes
        By unit in the earlier and in the later epoch.
    rows
        Units of the pair without the rejected ones.
    rejected
        Names of these.
    clouds
        Points to show in the sections.
    shown
        Sections of the report; what takes long is made for those alone that show it.
    """
    early, late = ({row.unit_id: found[row.unit_id] for row in rows if row.unit_id in found} for found in shapes)
    counted = {(row["epoch"], row["unit_id"]) for row in read_layer_rows(result, "units") if row["status"] in COUNTED}
    first, last = (
        {name: shape for name, shape in found.items() if (epoch, name) in counted}
        for epoch, found in ((pair.epoch_from, early), (pair.epoch_to, late))
    )
    symmetries = UnitType.tetrapod(1.0, opening=sizes[0].opening if sizes else "tetrahedral").symmetries
    heights = {row.height for row in rows if row.height is not None}
    before = after = None
    # figures over Dn mean nothing where types of several sizes lie side by side
    if len(heights) == 1:
        before, after = (placement_of_units(list(found.values()), min(heights), symmetries) for found in (first, last))
    judged = [row for row in rows if row.is_judged]
    diameter = nominal_diameter_of(judged)
    design = compare_design(result, options.design, pair.epoch_to, excluded=rejected) if options.design is not None and late else None
    profile = options.design.profile if options.design else ""
    found = None
    if (early or late) and "profiles" in shown:
        found = profiles(result, clouds=clouds, axis=options.axis, step=options.step, profile=profile, excluded=rejected)
    figures: dict[str, Any] = {}
    if found is not None:
        figures["sections"] = section_figures(found, pair, translate)
        figures["crest"] = crest_chart(found, pair, translate)
    if design is not None and "design" in shown:
        figures["design"] = design_map(design, late, translate)
    return StructurePages(
        placement=None if after is None else summary(after, symmetries),
        bands=movement_bands(judged, options.bands, diameter) if judged else (),
        state=damage_state(judged, _layers(before, list(first)), diameter) if judged else "",
        profiles=found,
        design=design,
        figures=figures,
        words=structure_words(translate),
    )


def _layers(found: UnitPlacement | None, names: Sequence[str]) -> dict[str, int]:
    return {} if found is None else dict(zip(names, found.layer.tolist(), strict=True))
