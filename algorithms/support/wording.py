"""Messages of the engine in the user's terms: the files made for the engine are never named, rows and tables are."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial

from .translation import tr

MOST_FIELDS = 6
"""Names of fields that a message holds."""


def few(names: Sequence[str]) -> str:
    """Names for a message, the first of many."""
    return ", ".join(names[:MOST_FIELDS]) + (", …" if len(names) > MOST_FIELDS else "")


@dataclass(frozen=True)
class Wording:
    """Puts what the user gave in place of the files made for one run of the engine.

    Attributes
    ----------
    survey
        Path of the survey.toml made from parameters; empty when the user wrote one.
    sections
        First line of each of its sections, and what the user calls it, in the order of lines.
    tables
        What the user calls the table behind each CSV file made from a layer or table.
    """

    survey: str = ""
    sections: tuple[tuple[int, str], ...] = ()
    tables: dict[str, str] = field(default_factory=dict)

    def __call__(self, message: str) -> str:
        """The message with the names the user knows."""
        for path, name in self.tables.items():
            message = re.sub(rf"{re.escape(path)}(?:, line (\d+))?", partial(_table_place, name), message)
        if self.survey:
            place = rf"{re.escape(self.survey)}(?:, line (\d+))?(?:, column \d+)?(?:, section \w+)?"
            message = re.sub(place, lambda found: self._section(found[1]), message)
        return message

    def _section(self, line: str | None) -> str:
        if line is None:
            return tr("The epochs and the unit given")
        return next((name for first, name in reversed(self.sections) if first <= int(line)), self.sections[0][1])


def _table_place(name: str, found: re.Match[str]) -> str:
    line = found[1]
    if line is None:
        return name
    # the first line of the file holds the names of the fields
    return (
        tr("{table}, row {row}").format(table=name, row=int(line) - 1) if int(line) > 1 else tr("{table}, field names").format(table=name)
    )
