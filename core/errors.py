"""Errors a user can act on: every one says what is wrong, where, and what to do about it."""

from __future__ import annotations

from pathlib import Path


class TetratrackError(Exception):
    """Root of all errors raised on purpose by tetratrack."""


class InputError(TetratrackError):
    """Input that cannot be used, with the place and the remedy.

    Parameters
    ----------
    problem
        What is wrong, as a clause that can follow the file's name ("has no CRS").
    source
        File or folder the problem is in; None where there is no file.
    where
        Line, field or key inside the source ("line 7, field height"); may be empty.
    remedy
        What the user can do ("declare crs in [survey] or write the LAS header's CRS").
    """

    def __init__(self, problem: str, *, source: str | Path | None = None, where: str = "", remedy: str = "") -> None:
        self.problem, self.source, self.where, self.remedy = problem, source, where, remedy
        place = f"{source}" if source is not None else ""
        if where:
            place = f"{place}, {where}" if place else where
        sentence = f"{place}: {problem}" if place else problem
        super().__init__(f"{sentence.rstrip('.')}. {remedy}".strip() if remedy else sentence)

    def __reduce__(self) -> tuple[object, ...]:
        """Keep the parts when the error crosses a process border."""
        return (_input_error, (self.__class__, self.problem, self.source, self.where, self.remedy))


class CrsError(InputError):
    """A coordinate reference system is missing, unusable or different from the survey's."""


class OutputError(InputError):
    """Output cannot be written: folder missing, read-only, locked or disk full."""


class Cancelled(TetratrackError):
    """The user ended the run; nothing is left half written."""


def _input_error(cls: type[InputError], problem: str, source: str | None, where: str, remedy: str) -> InputError:
    return cls(problem, source=source, where=where, remedy=remedy)
