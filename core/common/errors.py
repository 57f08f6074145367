"""Errors a user can act on: every one says what is wrong, where, and what to do about it."""

from __future__ import annotations

from pathlib import Path


class TetratrackError(Exception):
    """Root of all errors raised on purpose by tetratrack.

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
        return (_rebuilt, (self.__class__, self.problem, self.source, self.where, self.remedy))


class InputError(TetratrackError):
    """Input that cannot be used."""


class CrsError(InputError):
    """A coordinate reference system is missing, unusable or different from the survey's."""


class OutputError(TetratrackError):
    """Output cannot be written: folder missing, read-only, locked or disk full."""


class NoSolutionError(TetratrackError):
    """Points that are sound as such determine no solution: too few of them lie near the surface that is fitted."""


class Cancelled(TetratrackError):
    """The user ended the run; nothing is left half written."""


def _rebuilt(cls: type[TetratrackError], problem: str, source: str | Path | None, where: str, remedy: str) -> TetratrackError:
    return cls(problem, source=source, where=where, remedy=remedy)
