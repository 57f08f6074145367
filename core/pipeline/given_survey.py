"""The survey that a run is given: a file, or folders of tiles. A file is read without the libraries that drafts need, so that processes can
start early."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.survey import Survey
from ..data.survey_keys import check_number
from ..data.survey_reader import read_survey


@dataclass(frozen=True, kw_only=True)
class Given:
    """What the user says instead of the files; None where nothing.

    Raises
    ------
    InputError
        No unit has such a height.
    """

    height: float | None = None
    crs: str | None = None
    name: str | None = None

    def __post_init__(self) -> None:
        if self.height is not None:
            check_number("unit", "height", self.height)


def given_survey(places: Sequence[Path], given: Given, output: Path, feedback: Feedback) -> Survey:
    """The survey that a file describes, or that folders and tiles make; the draft of these is written beside the output.

    Raises
    ------
    InputError
        The file is wrong, or the tiles leave something open.
    """
    first = places[0]
    if len(places) > 1 or first.is_dir() or first.suffix.lower() != ".toml":
        from ..data.folder_epochs import CLOUDS
        from ..results.geopackage_writer import check_output
        from .new_survey import survey_of_tiles

        if len(places) > 1 or first.is_dir() or first.suffix.lower() in CLOUDS:
            check_output(output)
            return survey_of_tiles(places, given, output.with_suffix(".toml"), feedback.part(0, 0.05))
    return stated_survey(first, given)


def stated_survey(path: Path, given: Given) -> Survey:
    """The survey of a file, which says all itself.

    Raises
    ------
    InputError
        The file is wrong, or something is given that it says.
    """
    if given.height is not None or given.crs is not None:
        raise InputError("--crs and --height are for folders without a survey.toml", source=path, remedy="Write them into the file.")
    return read_survey(path)
