"""Report of a reviewed result: HTML or PDF, one template per section, in the languages of the interface."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any
from xml.etree import ElementTree  # nosec B405 - reads the catalogues this package ships, nothing from outside

import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined, UndefinedError, select_autoescape

from ..common.arrays import FloatArray
from ..common.atomic_files import write_whole
from ..common.errors import InputError, OutputError
from ..common.output_files import check_own
from ..common.software import software_version
from ..model.outline import SPM_PACKING, PlacedShape
from ..results.class_colours import CLASS_COLOURS
from ..results.field_checks import foreign_contents
from ..results.geopackage_reader import EpochPair, Row, crs_of, read_layer_rows
from ..results.result_access import CHANGED
from ..results.schema import FEATURES
from ..results.unit_rows import (
    EpochInfo,
    UnitDetails,
    UnitRow,
    check_comparisons,
    read_details,
    read_epochs,
    read_unit_rows,
    series,
    shift_to_datum,
    unit_sizes,
)
from ..results.unit_sizes import UnitSize, shape_of
from ..review.corrections import UnitEdit, placeholders, read_edits
from ..review.decisions import Review, read_reviews
from ..review.point_index import PointIndex, index_folder, index_of
from . import figures
from .block_figures import block_view, detail_maps
from .castings_page import CastingsPage, castings_page
from .damage import Damage, damage
from .explorer import explorer_data, page_script
from .fonts import drawable_words, is_drawable
from .frames_page import FramesPage, frames_page
from .mould_figures import mould_charts
from .number_formats import number_formats
from .result_choice import choose_pair
from .structure_pages import StructureOptions, StructurePages, structure_pages

Translate = Callable[[str], str]

TEMPLATES = Path(__file__).parent / "templates"
CATALOGUES = Path(__file__).resolve().parents[2] / "i18n"
HTML_MARK, PDF_MARK = '<meta name="generator" content="tetratrack">', "% tetratrack report\n"
"""What reports are known by; in PDF a comment after the end, since everything before it is compressed."""
SECTIONS = (
    "summary",
    "explorer",
    "map",
    "blocks",
    "placement",
    "profiles",
    "design",
    "displacements",
    "damage",
    "worst",
    "quality",
    "check",
    "control",
    "frames",
    "castings",
    "decisions",
    "method",
)
"""Sections in their order, each the template ``section_<name>.html``."""
WORST = 8


@dataclass(frozen=True, kw_only=True)
class ReportOptions:
    """What a report shows.

    Attributes
    ----------
    pair, datum
        Epoch pair and datum; the last consecutive pair and its default datum unless given.
    language
        Language as QGIS names it (``ja``, ``fr``, ...); English where it is not shipped.
    axis
        (n, 2) easting, northing of the structure's axis for sections; the centreline of the units by default.
    width, section
        Length of the structure looked at (for N_od) and of a section along it, metres.
    worst
        Number of units shown one by one.
    structure
        Design, sections and movement bands; its axis is ``axis``.
    sections
        Sections in their order.
    """

    pair: EpochPair | None = None
    datum: str | None = None
    language: str = "en"
    axis: FloatArray | None = None
    width: float | None = None
    section: float | None = None
    worst: int = WORST
    structure: StructureOptions = field(default_factory=StructureOptions)
    sections: tuple[str, ...] = SECTIONS


@dataclass(frozen=True, eq=False, kw_only=True)
class CheckLine:
    """One check point as in the paper's Table 1: displacements and errors in metres, None where there is no pick."""

    point_id: str
    unit_id: str
    feature: str
    manual: float | None
    fitted: float
    surveyed: float

    @property
    def manual_error(self) -> float | None:
        """Displacement picked by hand less surveyed."""
        return None if self.manual is None else self.manual - self.surveyed

    @property
    def fitted_error(self) -> float:
        """Displacement of the fit less surveyed."""
        return self.fitted - self.surveyed


@dataclass(frozen=True, eq=False)
class WorstUnit:
    """A unit shown on its own, with its views and series as data URIs (empty where there is nothing to draw)."""

    row: UnitRow
    review: Review | None
    views: str
    series: str


@dataclass(frozen=True, eq=False, kw_only=True)
class ReportData:
    """Everything the sections need, lengths in metres."""

    name: str
    crs: str
    pair: EpochPair
    datum: str
    epochs: tuple[EpochInfo, ...]
    rows: tuple[UnitRow, ...]
    rejected: frozenset[str]
    reviews: Mapping[str, Review]
    edits: tuple[UnitEdit, ...]
    missing: int
    damage: Damage | None
    control: tuple[Row, ...]
    test: Row | None
    checks: tuple[CheckLine, ...]
    worst: tuple[WorstUnit, ...]
    frames: FramesPage | None
    castings: CastingsPage
    counts: Mapping[str, int]
    figures: Mapping[str, str]
    details: tuple[str, ...]
    structure: StructurePages
    explorer: Mapping[str, Any]
    settings: Mapping[str, Any]
    written: datetime
    software: str
    notes: tuple[str, ...] = ()

    @property
    def qualities(self) -> dict[str, Row]:
        """Summary of :func:`tetratrack.core.pipeline.epoch_quality.summarise_epoch` by epoch, of those that state it."""
        return {epoch.label: epoch.settings["quality"] for epoch in self.epochs if "quality" in epoch.settings}

    @property
    def kept(self) -> list[UnitRow]:
        """Rows without the rejected units."""
        return [row for row in self.rows if row.unit_id not in self.rejected]

    @property
    def significant(self) -> int:
        """Units judged whose displacement is significant."""
        return sum(row.significant and row.is_judged for row in self.kept)

    @property
    def undecided(self) -> int:
        """Units that no reviewer has decided on."""
        return sum(row.unit_id not in self.reviews for row in self.rows)

    @property
    def completeness(self) -> float | None:
        """Units found in the later epoch over those and the placeholders; None where nobody looked for missing ones."""
        found = sum(row.d_3d is not None or row.kind == "new" for row in self.kept)
        return found / (found + self.missing) if self.missing else None


def write_report(result: Path, output: Path, options: ReportOptions | None = None) -> ReportData:
    """Write the report of a result to ``output``, HTML or PDF by its ending.

    Raises
    ------
    InputError
        The result cannot be read, has no displacements, or the ending is another.
    OutputError
        The file cannot be written, is another one than an earlier report, or PDF needs a library that is missing.
    """
    chosen = options or ReportOptions()
    kind = output.suffix.lower()
    if kind not in (".html", ".pdf"):
        raise InputError(f"cannot be written as {kind or 'a file without ending'}", source=output, remedy="End the name in .html or .pdf.")
    if not output.parent.is_dir():
        raise OutputError("cannot be written (its folder does not exist)", source=output, remedy="Choose a folder that exists.")
    check_own(output, (HTML_MARK if kind == ".html" else PDF_MARK,))
    translate = translator(chosen.language)
    with foreign_contents(result):
        data = collect(result, chosen, drawable_words(translate))
        # paper shows what a script would have to draw as pictures
        page = render(data, chosen, translate, interactive=kind == ".html")
    write_whole(output, page.encode("utf-8") if kind == ".html" else _pdf(page, output))
    return data


def collect(result: Path, options: ReportOptions, translate: Translate) -> ReportData:
    """Read a result and draw the figures."""
    pair, datum = choose_pair(result, options.pair, options.datum)
    rows = read_unit_rows(result, pair, datum)
    reviews = {unit: review for (unit, found), review in read_reviews(result).items() if found == pair}
    rejected = frozenset(unit for unit, review in reviews.items() if review.decision == "rejected")
    epochs = read_epochs(result)
    settings = epochs[-1].settings if epochs else {}
    sizes = unit_sizes(epochs)
    early, late = _shapes_of(result, pair, sizes)
    shapes = late | early
    control = tuple(row for row in read_layer_rows(result, "control_residuals") if row["epoch"] in (pair.epoch_from, pair.epoch_to))
    judged = [row for row in rows if row.unit_id not in rejected and row.is_judged]
    harm = damage(rows, excluded=rejected, axis=options.axis, width=options.width, section=options.section) if judged else None
    frames = frames_page(result, pair, control, max((size.height or 0.0 for size in sizes), default=0.0) or 1.0)
    castings = castings_page(epochs, rows, rejected, early | late, harm)
    key = (pair.epoch_from, pair.epoch_to)
    kept = [row for row in rows if row.unit_id not in rejected]
    words = {"inspect": translate("inspect on site")}
    decisions = {unit: words.get(review.decision) or translate(review.decision) for unit, review in reviews.items()}
    points = _Points(result)
    drawn = _pictures(frozenset(options.sections), rows, (early, late), control, rejected, harm, translate)
    drawn |= figures.frame_charts(frames.bends, frames.stretches, translate) if frames is not None and "frames" in options.sections else {}
    drawn |= mould_charts(castings.moulds, translate) if "castings" in options.sections else {}
    worst = []
    for moved in _most_moved(kept, options.worst) if "worst" in options.sections else ():
        details = read_details(result, moved.unit_id, sizes)
        drawn_series = _series(details, moved, epochs, datum, translate)
        drawn_views = _views(details, moved, pair, datum, points, translate)
        worst.append(WorstUnit(moved, reviews.get(moved.unit_id), drawn_views, drawn_series))
    structure = structure_pages(
        result, pair, (early, late), kept, rejected, sizes, replace(options.structure, axis=options.axis), translate,
        clouds=points.clouds, shown=frozenset(options.sections),
    )  # fmt: skip
    frame = crs_of(result)
    return ReportData(
        name=str(settings.get("survey") or result.stem),
        crs=frame.name if frame.definition != "undefined" else "",
        pair=pair,
        datum=datum,
        epochs=epochs,
        rows=tuple(rows),
        rejected=rejected,
        reviews=reviews,
        edits=tuple(read_edits(result)),
        missing=len(placeholders(result, pair.epoch_to)),
        damage=harm,
        control=control,
        test=next((row for row in read_layer_rows(result, "epoch_pairs") if (row["epoch_from"], row["epoch_to"]) == key), None),
        checks=tuple(_check_lines(result, pair)),
        worst=tuple(worst),
        frames=frames,
        castings=castings,
        counts={kind: sum(row.kind == kind for row in rows if row.unit_id not in rejected) for kind in CLASS_COLOURS},
        figures=drawn,
        details=tuple(detail_maps(kept, shapes, translate)) if "map" in options.sections else (),
        structure=structure,
        explorer=explorer_data(kept, (early, late), control, decisions, pair, translate),
        settings=settings,
        written=datetime.now(UTC),
        software=f"tetratrack {software_version()}",
        notes=(*points.notes, *structure.notes),
    )


def _pictures(
    shown: frozenset[str],
    rows: Sequence[UnitRow],
    ends: tuple[Mapping[str, PlacedShape], Mapping[str, PlacedShape]],
    control: Sequence[Row],
    rejected: frozenset[str],
    harm: Damage | None,
    translate: Translate,
) -> dict[str, str]:
    """Pictures of all units by name, those of the sections ``shown``; ``ends`` are shapes in the earlier and in the later epoch."""
    early, late = ends
    shapes = {**late, **early}
    kept = [row for row in rows if row.unit_id not in rejected]
    judged = [row for row in kept if row.is_judged]
    drawn = {}
    if "map" in shown:
        drawn["overview"] = figures.overview_map(rows, shapes, control, rejected, translate)
    if "blocks" in shown:
        drawn["blocks"] = block_view(kept, late or early, translate)
    if harm is None or all(row.d_3d is None for row in judged):
        return drawn
    if "displacements" in shown:
        drawn["displacements"] = figures.displacement_map(rows, shapes, rejected, translate)
        drawn["histogram"] = figures.histogram(judged, [(c.name, c.limit) for c in harm.classes], translate)
    if "damage" in shown and len(harm.sections) > 1:
        tenth = harm.classes.index(harm.displaced(0.10))
        shares = [s.counts[tenth] / s.units for s in harm.sections]
        first = harm.sections[0]
        drawn["sections"] = figures.section_chart([s.start for s in harm.sections], shares, first.stop - first.start, translate)
    return drawn


def said_of_fonts(data: ReportData, language: str) -> str:
    """A sentence where no font of this machine has the letters of the figures; empty where all can be drawn."""
    words = [translator(language)(word) for word in ("3D displacement (cm)", "units", "easting (m)")]
    if all(is_drawable(text) for text in (*words, data.pair.epoch_from, data.pair.epoch_to)):
        return ""
    return (
        "no font of this machine has all letters of the figures: their words are English, names of epochs in Latin letters; "
        "install one to change that, for example the package fonts-noto-cjk"
    )


def _shapes_of(result: Path, pair: EpochPair, sizes: Sequence[UnitSize]) -> tuple[dict[str, PlacedShape], dict[str, PlacedShape]]:
    """Shapes by unit in the earlier and in the later epoch of a pair."""
    found: dict[str, dict[str, PlacedShape]] = {pair.epoch_from: {}, pair.epoch_to: {}}
    for row in read_layer_rows(result, "units"):
        shape = shape_of(row, sizes) if row["epoch"] in found else None
        if shape is not None:
            found[row["epoch"]][row["unit_id"]] = shape
    return found[pair.epoch_from], found[pair.epoch_to]


def render(data: ReportData, options: ReportOptions, translate: Translate, *, interactive: bool = True) -> str:
    """HTML page of the report; every text from the result is escaped. Without ``interactive`` it holds no script."""
    unknown = [name for name in options.sections if name not in SECTIONS]
    if unknown:
        raise InputError(f"there is no section {unknown[0]!r}", remedy=f"Sections are: {', '.join(SECTIONS)}.")
    environment = Environment(
        loader=FileSystemLoader(TEMPLATES),
        autoescape=select_autoescape(default=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(number_formats(data.explorer["height"]))
    language = language_of(options.language) or "en"
    shown = {"d": data, "sections": options.sections, "_": translate, "language": language, "design_packing": SPM_PACKING}
    shown |= page_script(data.explorer if interactive else None)
    try:
        return environment.get_template("report.html").render(**shown)
    except UndefinedError as error:
        raise InputError(f"the settings of an epoch lack a value ({error.message})", where="layer epochs", remedy=CHANGED) from error


def translator(language: str) -> Translate:
    """Function that translates the report's texts; English stays where a text or the language is not shipped."""
    known = language_of(language)
    if known is None:
        return lambda text: text
    catalogue: dict[str, str] = {}
    root = ElementTree.parse(CATALOGUES / f"tetratrack_{known}.ts").getroot()  # noqa: S314  # nosec B314 - a file of this package
    for message in root.iter("message"):
        source, translation = message.findtext("source"), message.findtext("translation")
        # texts with forms for numbers are the windows'
        if source and translation and message.get("numerus") is None:
            catalogue[source] = translation
    return lambda text: catalogue.get(text, text)


def language_of(locale: str) -> str | None:
    """Shipped catalogue for a locale such as ``pt_BR``; None for English and languages not shipped."""
    name = locale.replace("_", "-")
    if name.lower() in ("zh", "zh-cn", "zh-sg") or name.lower().startswith("zh-hans"):
        name = "zh-Hans"
    for candidate in (name, name.split("-")[0]):
        if candidate and (CATALOGUES / f"tetratrack_{candidate}.ts").is_file():
            return candidate
    return None


def _pdf(page: str, output: Path) -> bytes:
    try:
        from weasyprint import HTML
        from weasyprint.urls import URLFetcher
    except (ImportError, OSError) as error:
        raise OutputError(
            "PDF needs the library weasyprint", source=output, remedy="Install tetratrack[pdf], or end the name in .html."
        ) from error
    # a report holds all it shows: nothing is fetched from a disk or a network while it is printed
    return bytes(HTML(string=page, url_fetcher=URLFetcher(allowed_protocols=["data"])).write_pdf()) + PDF_MARK.encode("ascii")


def _check_lines(result: Path, pair: EpochPair) -> list[CheckLine]:
    lines = []
    picks = read_layer_rows(result, "manual_picks")
    for unit in sorted({str(row["unit_id"]) for row in read_layer_rows(result, "check_residuals") if row["unit_id"]}):
        details = read_details(result, unit)
        for check in check_comparisons(details, pair):
            manual = _picked(picks, unit, check.feature, pair)
            lines.append(
                CheckLine(
                    point_id=check.point_id,
                    unit_id=unit,
                    feature=check.feature,
                    manual=manual,
                    fitted=check.fitted,
                    surveyed=check.measured,
                )
            )
    return lines


def _picked(picks: Sequence[Row], unit: str, feature: str, pair: EpochPair) -> float | None:
    """Displacement by hand-picked points, the mean of all pickers in each epoch."""
    ends = []
    for epoch in (pair.epoch_from, pair.epoch_to):
        found = [row["geom"] for row in picks if (row["unit_id"], row["feature"], row["epoch"]) == (unit, feature, epoch)]
        if not found:
            return None
        ends.append(np.mean(found, axis=0))
    return float(np.linalg.norm(ends[1] - ends[0]))


def _most_moved(rows: Sequence[UnitRow], count: int) -> list[UnitRow]:
    """Units that moved significantly, the largest displacements first."""
    moved = [row for row in rows if row.d_3d is not None and row.significant]
    return sorted(moved, key=lambda row: (-(row.d_3d or 0.0), row.unit_id))[:count]


class _Points:
    """Points around units for the views, and of sections; an index that cannot be used counts as none, and that is noted once."""

    def __init__(self, result: Path) -> None:
        self.notes: list[str] = []
        self._index: PointIndex | None = None
        if (index_folder(result) / "index.json").exists():
            try:
                self._index = index_of(result)
            except InputError as error:
                self._give_up(error)

    def around(self, epoch: str, middle: FloatArray, half: float) -> FloatArray:
        """(n, 3) points of an epoch in a cube."""
        if self._index is not None:
            try:
                return self._index.read(epoch, middle, half)
            except InputError as error:
                self._give_up(error)
        return np.empty((0, 3))

    def clouds(self, epoch: str) -> Iterator[FloatArray]:
        """Points (n, 3) of an epoch in parts."""
        if self._index is not None:
            try:
                yield from self._index.clouds(epoch)
            except InputError as error:
                self._give_up(error)

    def _give_up(self, error: InputError) -> None:
        self._index = None
        self.notes.append(f"units are drawn without points: {error}")


def _series(details: UnitDetails, row: UnitRow, epochs: Sequence[EpochInfo], datum: str, translate: Translate) -> str:
    lines = {name: points for name in FEATURES if len(points := series(details, epochs, datum, name)) > 1}
    return figures.unit_series(lines, row.detection_limit, translate) if lines else ""


def _views(details: UnitDetails, row: UnitRow, pair: EpochPair, datum: str, points: _Points, translate: Translate) -> str:
    labels = (pair.epoch_from, pair.epoch_to)
    shift = shift_to_datum(row, details, pair)
    later = details.shapes.get(labels[1])
    shapes = (details.shapes.get(labels[0]), None if later is None else replace(later, centre=later.centre + shift))
    known = [shape for shape in shapes if shape is not None]
    if not known:
        return ""
    middle = np.mean([shape.centre for shape in known], axis=0)
    half = 1.15 * known[0].leg_length + max(float(np.linalg.norm(shape.centre - middle)) for shape in known)
    clouds = (points.around(labels[0], middle, half), points.around(labels[1], middle - shift, half) + shift)
    reference = translate("stable units and control") if datum == "stable" else translate("control points alone")
    return figures.unit_views(shapes, clouds, labels, reference, translate)
