"""Report of a reviewed result: HTML or PDF, one template per section, in the languages of the interface."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any
from xml.etree import ElementTree  # nosec B405 - reads the catalogues this package ships, nothing from outside

import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape
from numpy.typing import ArrayLike, NDArray

from . import report_figures as figures
from .alarms import choose_pair, write_whole
from .damage import Damage, damage
from .displacement_rows import (
    EpochInfo,
    UnitDetails,
    UnitRow,
    UnitSize,
    check_comparisons,
    read_details,
    read_epochs,
    read_unit_rows,
    series,
    shape_of,
    unit_sizes,
)
from .errors import InputError, OutputError
from .outline import PlacedShape
from .result_tables import EpochPair, Row, connect, read_layer_rows, srs_of
from .reviews import Review, read_reviews
from .run_record import software_version
from .schema import FEATURES
from .unit_edits import UnitEdit, placeholders, read_edits
from .unit_points import PointIndex, index_folder

FloatArray = NDArray[np.float64]
Translate = Callable[[str], str]

TEMPLATES = Path(__file__).parent / "templates"
CATALOGUES = Path(__file__).resolve().parents[1] / "i18n"
SECTIONS = ("summary", "map", "displacements", "damage", "worst", "quality", "check", "control", "decisions", "method")
"""Sections in their order, each the template ``section_<name>.html``."""
WORST = 8


@dataclass(frozen=True)
class ReportOptions:
    """What a report shows.

    Attributes
    ----------
    pair, datum
        Epoch pair and datum; the last consecutive pair and its default datum unless given.
    language
        Language as QGIS names it (``ja``, ``fr``, ...); English where it is not shipped.
    axis
        (n, 2) easting, northing of the structure's axis for sections; the longest direction of the units by default.
    width, section
        Length of the structure looked at (for N_od) and of a section along it, metres.
    worst
        Number of units shown one by one.
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
    sections: tuple[str, ...] = SECTIONS


@dataclass(frozen=True, eq=False)
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


@dataclass(frozen=True, eq=False)
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
    counts: Mapping[str, int]
    figures: Mapping[str, str]
    settings: Mapping[str, Any]
    written: datetime
    software: str

    @property
    def qualities(self) -> dict[str, Row]:
        """Summary of :func:`tetratrack.core.quality.summarise_epoch` by epoch, of those that state it."""
        return {epoch.label: epoch.settings["quality"] for epoch in self.epochs if "quality" in epoch.settings}

    @property
    def kept(self) -> list[UnitRow]:
        """Rows without the rejected units."""
        return [row for row in self.rows if row.unit_id not in self.rejected]

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
        The file cannot be written, or PDF needs a library that is missing.
    """
    chosen = options or ReportOptions()
    kind = output.suffix.lower()
    if kind not in (".html", ".pdf"):
        raise InputError(f"cannot be written as {kind or 'a file without ending'}", source=output, remedy="End the name in .html or .pdf.")
    if not output.parent.is_dir():
        raise OutputError("cannot be written (its folder does not exist)", source=output, remedy="Choose a folder that exists.")
    translate = translator(chosen.language)
    data = collect(result, chosen, translate)
    page = render(data, chosen, translate)
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
    shapes: dict[str, PlacedShape] = {}
    for row in read_layer_rows(result, "units"):
        shape = shape_of(row, sizes)
        if shape is not None and (row["epoch"] == pair.epoch_from or row["unit_id"] not in shapes):
            shapes[row["unit_id"]] = shape
    control = tuple(row for row in read_layer_rows(result, "control_residuals") if row["epoch"] in (pair.epoch_from, pair.epoch_to))
    judged = [row for row in rows if row.unit_id not in rejected and (row.d_3d is not None or row.kind == "lost")]
    harm = damage(rows, excluded=rejected, axis=options.axis, width=options.width, section=options.section) if judged else None
    drawn = {"overview": figures.overview_map(rows, shapes, control, rejected, translate)}
    if harm is not None and any(row.d_3d is not None for row in judged):
        drawn["displacements"] = figures.displacement_map(rows, shapes, rejected, translate)
        drawn["histogram"] = figures.histogram(rows, rejected, [(c.name, c.limit) for c in harm.classes], translate)
        if len(harm.sections) > 1:
            tenth = next(k for k, c in enumerate(harm.classes) if math.isclose(c.limit, 0.10))
            shares = [s.counts[tenth] / s.units for s in harm.sections]
            first = harm.sections[0]
            drawn["sections"] = figures.section_chart([s.start for s in harm.sections], shares, first.stop - first.start, translate)
    key = (pair.epoch_from, pair.epoch_to)
    return ReportData(
        str(settings.get("survey") or result.stem),
        _crs_name(result),
        pair,
        datum,
        epochs,
        tuple(rows),
        rejected,
        reviews,
        tuple(read_edits(result)),
        len(placeholders(result, pair.epoch_to)),
        harm,
        control,
        next((row for row in read_layer_rows(result, "epoch_pairs") if (row["epoch_from"], row["epoch_to"]) == key), None),
        tuple(_check_lines(result, pair)),
        tuple(_worst(result, rows, rejected, reviews, pair, datum, epochs, sizes, options.worst, translate)),
        {kind: sum(row.kind == kind for row in rows if row.unit_id not in rejected) for kind in figures.CLASS_COLOURS},
        drawn,
        settings,
        datetime.now(UTC),
        f"tetratrack {software_version()}",
    )


def render(data: ReportData, options: ReportOptions, translate: Translate) -> str:
    """HTML page of the report; every text from the result is escaped."""
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
    environment.filters.update(cm=_cm, signed_cm=_signed_cm, percent=_percent, mm=_mm, degrees=_degrees, p=_p, day=_day, places=_places)
    language = language_of(options.language) or "en"
    return environment.get_template("report.html").render(d=data, sections=options.sections, _=translate, language=language)


def translator(language: str) -> Translate:
    """Function that translates the report's texts; English stays where a text or the language is not shipped."""
    known = language_of(language)
    if known is None:
        return lambda text: text
    catalogue: dict[str, str] = {}
    root = ElementTree.parse(CATALOGUES / f"tetratrack_{known}.ts").getroot()  # noqa: S314  # nosec B314 - a file of this package
    for message in root.iter("message"):
        source, translation = message.findtext("source"), message.findtext("translation")
        if source and translation:
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


def parse_axis(text: str) -> FloatArray:
    """(n, 2) corners of an axis written as ``e,n e,n ...``.

    Raises
    ------
    InputError
        It is not a list of two or more pairs of numbers.
    """
    try:
        axis = np.array([[float(value) for value in pair.split(",")] for pair in text.replace(";", " ").split()])
    except ValueError:
        axis = np.empty((0, 0))
    if axis.ndim != 2 or axis.shape[1:] != (2,) or len(axis) < 2 or not np.all(np.isfinite(axis)):
        raise InputError(f"the axis {text!r} is not a list of places", remedy="Write it as easting,northing easting,northing ...")
    return axis


def _pdf(page: str, output: Path) -> bytes:
    try:
        from weasyprint import HTML
        from weasyprint.urls import URLFetcher
    except (ImportError, OSError) as error:
        raise OutputError(
            "PDF needs the library weasyprint", source=output, remedy="Install tetratrack[pdf], or end the name in .html."
        ) from error
    # a report holds all it shows: nothing is fetched from a disk or a network while it is printed
    return bytes(HTML(string=page, url_fetcher=URLFetcher(allowed_protocols=["data"])).write_pdf())


def _check_lines(result: Path, pair: EpochPair) -> list[CheckLine]:
    lines = []
    picks = read_layer_rows(result, "manual_picks")
    for unit in sorted({str(row["unit_id"]) for row in read_layer_rows(result, "check_residuals") if row["unit_id"]}):
        details = read_details(result, unit)
        for check in check_comparisons(details, pair):
            manual = _picked(picks, unit, check.feature, pair)
            lines.append(CheckLine(check.point_id, unit, check.feature, manual, check.fitted, check.measured))
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


def _worst(
    result: Path,
    rows: Sequence[UnitRow],
    rejected: frozenset[str],
    reviews: Mapping[str, Review],
    pair: EpochPair,
    datum: str,
    epochs: Sequence[EpochInfo],
    sizes: Sequence[UnitSize],
    count: int,
    translate: Translate,
) -> list[WorstUnit]:
    moved = [row for row in rows if row.d_3d is not None and row.significant and row.unit_id not in rejected]
    moved.sort(key=lambda row: (-(row.d_3d or 0.0), row.unit_id))
    folder = index_folder(result)
    index = PointIndex(folder) if (folder / "index.json").is_file() else None
    found = []
    for row in moved[:count]:
        details = read_details(result, row.unit_id, sizes)
        lines = {name: points for name in FEATURES if len(points := series(details, epochs, datum, name)) > 1}
        drawn = figures.unit_series(lines, row.detection_limit, translate) if lines else ""
        found.append(WorstUnit(row, reviews.get(row.unit_id), _views(details, pair, index, translate), drawn))
    return found


def _views(details: UnitDetails, pair: EpochPair, index: PointIndex | None, translate: Translate) -> str:
    labels = (pair.epoch_from, pair.epoch_to)
    shapes = (details.shapes.get(labels[0]), details.shapes.get(labels[1]))
    known = [shape for shape in shapes if shape is not None]
    if not known:
        return ""
    middle = np.mean([shape.centre for shape in known], axis=0)
    half = 1.15 * known[0].leg_length + max(float(np.linalg.norm(shape.centre - middle)) for shape in known)
    none = np.empty((0, 3))
    points = (none, none) if index is None else (index.read(labels[0], middle, half), index.read(labels[1], middle, half))
    return figures.unit_views(shapes, points, labels, translate)


def _crs_name(result: Path) -> str:
    with closing(connect(result)) as connection:
        row = connection.execute("SELECT srs_name FROM gpkg_spatial_ref_sys WHERE srs_id = ?", (srs_of(connection),)).fetchone()
    return str(row["srs_name"]) if row else ""


def _cm(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f}"


def _mm(value: float | None) -> str:
    return "–" if value is None else f"{1000 * value:.1f}"


def _signed_cm(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:+.2f}"


def _percent(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f} %"


def _degrees(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f}°"


def _p(value: float | None) -> str:
    return "–" if value is None else ("< 0.001" if value < 0.001 else f"{value:.3f}")


def _day(value: datetime | None) -> str:
    return "–" if value is None else value.strftime("%Y-%m-%d %H:%M UTC")


def _places(values: ArrayLike | None) -> str:
    return "–" if values is None else ", ".join(f"{value:.2f}" for value in np.asarray(values, dtype=np.float64))
