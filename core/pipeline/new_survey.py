"""From folders of tiles to a survey.toml: epochs, CRS, tables, and the size of the units from the cloud itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from itertools import pairwise
from pathlib import Path

import numpy as np

from ..common.atomic_files import replace_durably, temporary_beside
from ..common.errors import CrsError, InputError, OutputError
from ..common.feedback import Feedback
from ..data.crs import LOCAL, check_survey_crs
from ..data.folder_epochs import FoundEpoch, find_tiles, group_epochs
from ..data.looks_at_ground import FoundTile, share_in_common
from ..data.plausibility import Place, check_scale
from ..data.recognised_tables import FoundTable, Role, assign, find_tables, recognise
from ..data.survey import Survey
from ..data.survey_draft import FIRST_LINE, DraftEpoch, DraftUnit, SurveyDraft, draft_text, is_as_drafted
from ..data.survey_reader import read_survey
from ..data.tiles import TileInfo
from .drafted_units import counted, draft_units
from .given_survey import Given, stated_survey

LEAST_OVERLAP = 0.05
"""Share of the smaller extent that two epochs must have in common to be compared."""
PLAIN_NAMES = ("tiles", "las", "laz", "pointclouds", "point_clouds", "clouds", "data")
"""Folders called so are named after what holds them."""
ASSUMED_SD = 0.005
"""Metres; what a total station gives for a target on a wall, where the file states nothing."""


@dataclass(frozen=True, kw_only=True)
class GivenEpoch:
    """An epoch as the row of a table states it; label and time are found where they are empty.

    Attributes
    ----------
    files
        Tables of points by the key of survey.toml: control, targets, check.
    """

    label: str
    time: datetime | None
    tiles: tuple[Path, ...]
    files: dict[str, Path]


def draft_survey(folders: Sequence[Path], given: Given, feedback: Feedback, *, size: bool = True) -> SurveyDraft:
    """Draft of a survey from its folders: what the files say with its reasons, what they leave open as questions.

    Parameters
    ----------
    size
        Whether the size of the units is estimated where it is not given: that takes a minute.

    Raises
    ------
    InputError
        No tiles, a tile that cannot be read, or a CRS given that cannot be used.
    """
    if given.crs is not None:
        check_survey_crs(given.crs, where="--crs")
    if not folders:
        raise InputError("no folder is given", remedy="Give the folder that holds your tiles.")
    found = find_tiles(folders, feedback.part(0, 0.1).progress)
    epochs = group_epochs(found)
    for epoch in epochs:
        feedback.info(f"epoch {epoch.label}: {counted(len(epoch.tiles), 'tile')}, {epoch.time:%Y-%m-%d %H:%M} UTC ({epoch.reason})")
    local = _crs(found, given.crs)[0] == LOCAL
    tables, notes = recognise(find_tables(folders), _whole_extent(epochs), local=local)
    labels = [epoch.label for epoch in epochs]
    mine = [assign(tables, epoch.label, epoch.tiles[0].path.parent, others=labels) for epoch in epochs]
    return _draft(found, epochs, mine, replace(given, name=given.name or _name(folders)), notes, feedback.part(0.1, 1), size=size)


def draft_of_rows(rows: Sequence[GivenEpoch], given: Given, feedback: Feedback, *, size: bool = True) -> SurveyDraft:
    """Draft of a survey from epochs that somebody stated or corrected, with the rest as :func:`draft_survey` finds it.

    Raises
    ------
    InputError
        As for :func:`draft_survey`; or no row, or a file of two epochs.
    """
    if given.crs is not None:
        check_survey_crs(given.crs, where="--crs")
    if not rows:
        raise InputError("no epoch is given", remedy="Give the tiles of at least one.")
    found, epochs = [], []
    for row in rows:
        members = find_tiles(row.tiles)
        group = group_epochs(members)[0]
        infos = tuple(sorted((member.info for member in members), key=lambda info: info.path))
        reason = group.reason if row.time is None else "given"
        epochs.append(FoundEpoch(row.label or group.label, row.time or group.time, infos, reason, group.notes))
        found += members
    paths = [member.info.path for member in found]
    if len(set(paths)) < len(paths):
        twice = next(path for k, path in enumerate(paths) if path in paths[:k])
        raise InputError("is a tile of two epochs", source=twice, remedy="Leave it to one of them.")
    extent, local = _whole_extent(epochs), _crs(found, given.crs)[0] == LOCAL
    known, notes = recognise({path for row in rows for path in row.files.values()}, extent, local=local)
    by_path = {table.path: table for table in known}
    mine = [
        {table.role: table for role, path in row.files.items() if (table := by_path.get(path)) is not None and table.role == role}
        for row in rows
    ]
    name = given.name or _name([rows[0].tiles[0].parent])
    draft = _draft(found, epochs, mine, replace(given, name=name), notes, feedback, size=size)
    # a file that a user chose is used as it is, whether its columns are known again or not
    stated = [replace(epoch, values={**row.files, **epoch.values}) for epoch, row in zip(draft.epochs, rows, strict=True)]
    return replace(draft, epochs=tuple(stated))


def _draft(
    found: Sequence[FoundTile],
    epochs: Sequence[FoundEpoch],
    tables: Sequence[Mapping[Role, FoundTable]],
    given: Given,
    notes: Sequence[str],
    feedback: Feedback,
    *,
    size: bool,
) -> SurveyDraft:
    """The draft, given its epochs and the tables of points of each."""
    crs, crs_reason, crs_questions, tiles_crs = _crs(found, given.crs)
    crs_questions += _scale_question(found, crs)
    crs_questions += [question for epoch in epochs for question in epoch.questions]
    crs_questions += [question for own in tables for question in _targets_question(own)]
    warnings = [f"{epoch.label}: {note}" for epoch in epochs for note in epoch.notes]
    warnings += [*_epoch_warnings(epochs), *notes]
    drafts = tuple(_epoch(epoch, mine, tiles_crs) for epoch, mine in zip(epochs, tables, strict=True))
    if size or given.height is not None:
        units, unit_questions, unit_warnings = draft_units(epochs, crs, tiles_crs, given.height, feedback)
    else:
        units, unit_questions, unit_warnings = (DraftUnit(height=None, reasons={"height": "not estimated yet"}),), [], []
    return SurveyDraft(
        name=given.name or "",
        crs=crs,
        crs_reason=crs_reason,
        units=units,
        epochs=drafts,
        questions=(*crs_questions, *unit_questions),
        warnings=(*warnings, *unit_warnings),
    )


def _name(places: Sequence[Path]) -> str:
    first = places[0].resolve()
    folder = first.parent if first.is_file() else first
    return folder.parent.name if folder.name.lower() in PLAIN_NAMES else folder.name


def _crs(tiles: Sequence[FoundTile], given: str | None) -> tuple[str, str, list[str], str | None]:
    """CRS of the survey, its reason, what must be asked, and the CRS of tiles that declare none."""
    declared = [tile.info.crs for tile in tiles]
    known = sorted({crs for crs in declared if crs}, key=declared.count, reverse=True)
    tiles_crs = given if "" in declared and given not in (None, LOCAL) else None
    if given is not None:
        return given, "given", [], tiles_crs
    without = [tile.info.path.name for tile in tiles if not tile.info.crs]
    if not known:
        question = "the tiles declare no CRS: give it with --crs, for example --crs EPSG:32652, or --crs LOCAL for a frame in metres"
        return "", question, [question], None
    crs = known[0]
    try:
        check_survey_crs(crs)
    except CrsError as error:
        question = f"the tiles are in a CRS that cannot serve ({error.problem}): reproject them, or give another with --crs"
        return "", question, [question], None
    questions = []
    if len(known) > 1 and LOCAL in known:
        questions.append(f"some tiles are in a local frame, others in {next(c for c in known if c != LOCAL)}: keep one kind in a survey")
    if without:
        questions.append(f"{counted(len(without), 'tile')} ({without[0]}, …) declare no CRS: if they are in {crs}, give --crs {crs}")
    others = f"; {len(known) - 1} other in the tiles, transformed" if len(known) > 1 else ""
    short = crs if len(crs) < 40 else "user-defined"
    return crs, f"from the tiles' headers ({short}){others}", questions, None


def _scale_question(tiles: Sequence[FoundTile], crs: str) -> list[str]:
    """What to ask where a metre of the grid is none on the ground; tiles that are to be transformed are looked at before a run."""
    own = [tile.info for tile in tiles if tile.info.crs in ("", crs)]
    if not crs or crs == LOCAL or not own:
        return []
    try:
        check_scale(crs, Place(own[0].low, own[0].high, crs, 1.0), source=own[0].path)
    except CrsError as error:
        return [f"{error.problem}: {error.remedy}"]
    return []


def _targets_question(tables: Mapping[Role, FoundTable]) -> list[str]:
    """What to ask of targets that a run refuses: no key of survey.toml turns them, as ``control_unit`` and ``control_axes`` do control."""
    targets = tables.get("targets")
    if targets is None or not targets.changes:
        return []
    return [f"{targets.path.name} holds targets otherwise than the tiles ({', '.join(targets.changes)}): write them as x,y,z in metres"]


def _epoch_warnings(epochs: Sequence[FoundEpoch]) -> list[str]:
    """What a first look at several epochs, or at one, should say."""
    out = []
    if len(epochs) == 1:
        out.append("one epoch: units and feature points are found, displacements need a second one")
    for earlier, later in pairwise(epochs):
        if share_in_common(earlier.extent, later.extent) < LEAST_OVERLAP:
            out.append(
                f"epochs {earlier.label} and {later.label} do not overlap: no unit is seen in both "
                "(other site, other CRS, or swapped easting and northing?)"
            )
        apart = np.median([t.low[2] for t in later.tiles]) - np.median([t.low[2] for t in earlier.tiles])
        if abs(apart) > 5:
            out.append(
                f"epochs {earlier.label} and {later.label} lie {abs(apart):.1f} m apart in height: "
                "ellipsoidal heights beside levelled ones?"
            )
    for epoch in epochs:
        out += _tile_warnings(epoch)
    return out


def _tile_warnings(epoch: FoundEpoch) -> list[str]:
    out = []
    names = {tile.crs for tile in epoch.tiles}
    if len(names) > 1:
        out.append(f"{epoch.label}: tiles in several CRS: {', '.join(sorted(n[:30] or 'none' for n in names))}")
    shared = [
        (a.path.name, b.path.name)
        for k, a in enumerate(epoch.tiles)
        for b in epoch.tiles[:k]
        if a.crs == b.crs and share_in_common(_flat(a), _flat(b)) > 0.5
    ]
    if shared:
        out.append(
            f"{epoch.label}: {counted(len(shared), 'pair')} of tiles cover the same ground, such as {shared[0][1]} and {shared[0][0]}"
        )
    return out


def _flat(tile: TileInfo) -> tuple[float, float, float, float]:
    return tile.low[0], tile.low[1], tile.high[0], tile.high[1]


def _whole_extent(epochs: Sequence[FoundEpoch]) -> tuple[float, float, float, float]:
    extents = np.array([epoch.extent for epoch in epochs])
    west, south, east, north = (float(x) for x in (*extents[:, :2].min(axis=0), *extents[:, 2:].max(axis=0)))
    return west, south, east, north


def _epoch(found: FoundEpoch, mine: Mapping[Role, FoundTable], tiles_crs: str | None) -> DraftEpoch:
    values: dict[str, Path | str | float] = {}
    reasons = {"time": found.reason}
    comments = []
    if tiles_crs is not None and any(not tile.crs for tile in found.tiles):
        values["undeclared_crs"] = tiles_crs
    control, targets = mine.get("control"), mine.get("targets")
    if control is not None and targets is not None:
        common = len(control.points & targets.points)
        values |= {"control": control.path, "targets": targets.path}
        reasons |= {"control": control.reason, "targets": f"{targets.reason}; {counted(common, 'name')} in common with the control"}
        if control.unit != "m":
            values["control_unit"] = control.unit
        if control.swapped:
            values["control_axes"] = "ne"
        if not control.sds:
            factor = {"m": 1.0, "ft": 0.3048, "us-ft": 1200 / 3937}[control.unit]
            values["control_sd"] = ASSUMED_SD / factor
            reasons["control_sd"] = "assumed: the file states no standard deviations"
    elif control is not None or targets is not None:
        one, other = ("control", "targets") if control is not None else ("targets", "control")
        path = (control or targets).path  # type: ignore[union-attr]
        comments.append(f"{path.name} looks like {one}; it is used together with {other}, which were not found")
    check = mine.get("check")
    if check is not None and not check.changes:
        values["check"], reasons["check"] = check.path, check.reason
    elif check is not None:
        changes = ", ".join(check.changes)
        comments.append(f"{check.path.name} looks like check points ({changes}): write it in metres, easting first, to use it")
    for role in ("trajectory", "stations"):
        if role in mine:
            comments.append(f"{mine[role].path.name} looks like {role}: add {role}, range_sd and angle_sd (from the data sheet) to use it")
    return DraftEpoch(
        label=found.label,
        time=found.time,
        tiles=tuple(tile.path for tile in found.tiles),
        values=values,
        reasons=reasons,
        comments=tuple(comments),
        points=sum(tile.points for tile in found.tiles),
        density=float(np.median([tile.density for tile in found.tiles])),
        crs=", ".join(sorted({tile.crs for tile in found.tiles if tile.crs})),
        footprint=tuple(_flat(tile) for tile in found.tiles),
    )


def write_draft(draft: SurveyDraft, path: Path) -> None:
    """Write a draft as a survey.toml; one that a draft wrote earlier is replaced, any other file and a corrected draft are not.

    Raises
    ------
    OutputError
        The file is somebody's own or was corrected since it was drafted, or cannot be written.
    """
    check_draft(path)
    with temporary_beside(path) as temporary:
        temporary.write_text(draft_text(draft, path.absolute().parent), encoding="utf-8")
        replace_durably(temporary, path)


def check_draft(path: Path) -> None:
    """Find out before a minute is spent whether a draft can be written.

    Raises
    ------
    OutputError
        As for :func:`write_draft`.
    """
    if path.is_file():
        text = path.read_text(encoding="utf-8", errors="replace")
        if not text.startswith(FIRST_LINE):
            raise OutputError(
                "is there already, and not written by tetratrack init", source=path, remedy="Move it away, or give another name."
            )
        if not is_as_drafted(text):
            raise OutputError(
                "was corrected since it was drafted, and a new draft would lose that",
                source=path,
                remedy=f"Run it as it is (tetratrack run {path}), or move it away for a new draft.",
            )
    with temporary_beside(path):
        pass


def survey_of_tiles(places: Sequence[Path], given: Given, target: Path, feedback: Feedback) -> Survey:
    """The survey of folders and tiles: a folder's own survey.toml, or a draft that needs no asking, written to ``target``.

    Raises
    ------
    InputError
        The files leave something open.
    """
    own = places[0] / "survey.toml"
    # a draft of the same command made before is drafted anew; what a person wrote or corrected counts
    drafted = own.is_file() and own.absolute() == target.absolute() and is_as_drafted(own.read_text(encoding="utf-8", errors="replace"))
    if len(places) == 1 and own.is_file() and not drafted:
        feedback.info(f"taking {own}")
        return stated_survey(own, given)
    stated = next((place for place in places if place.suffix.lower() == ".toml"), None)
    if stated is not None:
        raise InputError("is a survey among other inputs", source=stated, remedy="Give the survey file alone, or tiles and folders.")
    check_draft(target)
    draft = draft_survey(places, given, feedback)
    need_no_asking(draft, places[0])
    for warning in draft.warnings:
        feedback.warning(warning)
    write_draft(draft, target)
    feedback.info(f"{target}: all that was found, with its reasons; correct it and run it where something is wrong")
    return read_survey(target)


def need_no_asking(draft: SurveyDraft, folder: Path) -> None:
    """Refuse to run a draft that leaves something open.

    Raises
    ------
    InputError
        The first question.
    """
    if draft.questions:
        raise InputError(
            draft.questions[0],
            source=folder,
            remedy=f"Or write the file with: tetratrack init {folder} > survey.toml, correct it and run it.",
        )
