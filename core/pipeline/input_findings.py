"""What there is to say of each input of a survey: in order, done something about, to be looked at, or refused."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from ..common.errors import InputError
from ..common.feedback import Feedback
from ..data.survey import Epoch
from ..data.tiles import TileInfo

Verdict = Literal["ok", "note", "warning", "refused"]


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What there is to say of one input.

    Attributes
    ----------
    verdict
        ``ok``; ``note`` for what was done about it; ``warning`` for what the user should look at; ``refused`` ends a run.
    epoch
        Label, empty for what belongs to the survey.
    what, name
        Kind of input ("tile", "control"), and its name.
    message
        One sentence, empty where all is well.
    error
        What a run ends with.
    tile
        What is known of a tile.
    path
        The file of a tile, as others may have its name.
    """

    verdict: Verdict
    what: str
    name: str
    epoch: str = ""
    message: str = ""
    error: InputError | None = None
    tile: TileInfo | None = None
    path: Path | None = None


def report(findings: Sequence[Finding], feedback: Feedback) -> None:
    """Tell what was found, and end with the first input that cannot be used.

    Raises
    ------
    InputError
        That of the first refused input; it says how many more there are.
    """
    for finding in findings:
        if finding.message and finding.verdict == "note":
            feedback.info(finding.message)
        elif finding.message and finding.verdict == "warning":
            feedback.warning(finding.message)
    error = first_error(findings)
    if error is not None:
        raise error


def first_error(findings: Sequence[Finding]) -> InputError | None:
    """What a run ends with: the first refused input, and how many more there are; None where all can be used."""
    errors = [finding.error for finding in findings if finding.error is not None]
    if len(errors) < 2:
        return errors[0] if errors else None
    first = errors[0]
    more = "1 more input is refused" if len(errors) == 2 else f"{len(errors) - 1} more inputs are refused"
    remedy = f"{first.remedy} {more}; all are listed by: tetratrack inspect".strip()
    return type(first)(first.problem, source=first.source, where=first.where, remedy=remedy)


def warned(epoch: Epoch, path: Path, said: str) -> Finding:
    """A warning of a tile."""
    return Finding(verdict="warning", what="tile", name=path.name, epoch=epoch.label, message=said, path=path)


def said_of_tiles(epoch: Epoch, tiles: Sequence[TileInfo], verdict: Verdict, said: str) -> Finding:
    """What there is to say of several tiles of an epoch."""
    return Finding(verdict=verdict, what="tiles", name=f"{len(tiles)} tiles", epoch=epoch.label, message=said)


def refused(epoch: Epoch | None, what: str, error: InputError, name: str = "", path: Path | None = None) -> Finding:
    """An input that cannot be used; ``path`` is the file of a tile."""
    label = "" if epoch is None else epoch.label
    return Finding(verdict="refused", what=what, name=name or what, epoch=label, message=str(error), error=error, path=path)
