"""Dates in the names of folders and files, in the forms people use: 2024-04-09, 20240409, 09.04.2024, 9 Apr 2024, 240409, 2024-04, 2019."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, date, datetime
from functools import cache

FIRST_YEAR = 1990
"""Point clouds of breakwaters are not older."""

DAY, MONTH, YEAR = 0, 1, 2

_MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_MONTH_NAME = "(?P<name>" + "|".join(_MONTHS) + ")[a-z]*"
_FULL_YEAR = r"(?P<year>(?:19|20)\d\d)"
_BETWEEN = r"[-_./ ]?"
_APART = r"[-_./ ]"

_DAY_FIRST = (rf"(?P<day>\d\d?)(?P<gap>{_APART})(?P<month>\d\d?)(?P=gap){_FULL_YEAR}", rf"(?P<day>\d\d)(?P<month>\d\d){_FULL_YEAR}")
"""Day and month before the year, where either may come first."""

_FORMS: tuple[tuple[str, int], ...] = (
    (rf"{_FULL_YEAR}\s*[年년]\s*(?P<month>\d\d?)\s*[月월]\s*(?P<day>\d\d?)\s*[日일]", DAY),
    (rf"{_FULL_YEAR}(?P<gap>{_BETWEEN})(?P<month>\d\d)(?P=gap)(?P<day>\d\d)", DAY),
    (rf"{_FULL_YEAR}(?P<gap>{_APART})(?P<month>\d\d?)(?P=gap)(?P<day>\d\d?)", DAY),
    # with the time of day in the same number, as drones name their files
    (rf"{_FULL_YEAR}(?P<month>\d\d)(?P<day>\d\d)\d{{4}}(?:\d\d)?", DAY),
    *((form, DAY) for form in _DAY_FIRST),
    (rf"(?P<day>\d\d?){_BETWEEN}{_MONTH_NAME}{_BETWEEN}{_FULL_YEAR}", DAY),
    (rf"{_FULL_YEAR}{_BETWEEN}{_MONTH_NAME}{_BETWEEN}(?P<day>\d\d?)", DAY),
    (rf"{_MONTH_NAME}{_BETWEEN}(?P<day>\d\d?),?{_BETWEEN}{_FULL_YEAR}", DAY),
    (r"(?P<short>\d\d)(?P<month>\d\d)(?P<day>\d\d)", DAY),
    (rf"{_FULL_YEAR}\s*[年년]\s*(?P<month>\d\d?)\s*[月월]", MONTH),
    (rf"{_FULL_YEAR}{_BETWEEN}(?P<month>\d\d)", MONTH),
    (rf"{_FULL_YEAR}{_BETWEEN}{_MONTH_NAME}", MONTH),
    (rf"{_MONTH_NAME}{_BETWEEN}{_FULL_YEAR}", MONTH),
    (rf"{_FULL_YEAR}[年년]?", YEAR),
)
"""Patterns in the order in which they are believed, and how exact the date is."""


@dataclass(frozen=True)
class NamedDate:
    """A date read from a name.

    Attributes
    ----------
    day
        The day; the first of the month or year where the name says no more.
    exactness
        ``DAY``, ``MONTH`` or ``YEAR``.
    swapped
        The other reading of a date such as 05.04.2024, month first; None where there is but one.
    short
        Six digits, which may as well be a coordinate.
    """

    day: date
    exactness: int
    swapped: date | None = None
    short: bool = False

    @property
    def label(self) -> str:
        """The date as ISO 8601 writes it, as exact as it is known."""
        return self.day.isoformat()[: (10, 7, 4)[self.exactness]]

    def holds(self, other: date) -> bool:
        """Whether a day lies inside what the name says."""
        return other.isoformat().startswith(self.label)


def date_in_name(name: str, *, years_alone: bool = True) -> NamedDate | None:
    """Date that a file's or folder's name holds, or None; ``years_alone`` also takes a bare year, which in file names is mostly none."""
    for form, exactness in _FORMS:
        if exactness == YEAR and not years_alone:
            continue
        for match in _pattern(form).finditer(name):
            found = _date(match.groupdict(), exactness, form in _DAY_FIRST)
            if found is not None:
                return found
    return None


def has_coordinates(name: str) -> bool:
    """Whether a name holds what can only be a coordinate: six digits that are no date, or five and more beside a date of six digits.

    A time of day behind that date is none, nor is a number that begins with a zero.
    """
    found = date_in_name(name, years_alone=False)
    numbers = re.findall(r"\d+", name)
    if found is None:
        return any(len(number) == 6 and number[0] != "0" for number in numbers)
    if not found.short:
        return False
    k = next(k for k, number in enumerate(numbers) if len(number) == 6 and date_in_name(number) == found)
    behind = numbers[k + 1 :]
    if behind and re.fullmatch(r"([01]\d|2[0-3])[0-5]\d[0-5]\d", behind[0]):
        del behind[0]
    return any(len(number) > 4 and number[0] != "0" for number in (*numbers[:k], *behind))


@cache
def _pattern(form: str) -> re.Pattern[str]:
    # never a part of a longer number: tiles are often named after their coordinates
    return re.compile(rf"(?<!\d){form}(?!\d)", re.IGNORECASE)


def _date(parts: dict[str, str | None], exactness: int, swappable: bool) -> NamedDate | None:
    year = int(parts.get("year") or 2000 + int(parts.get("short") or 0))
    name = parts.get("name")
    month = _MONTHS.index(name.lower()) + 1 if name else int(parts.get("month") or 1)
    number = int(parts.get("day") or 1)
    day = _valid(year, month, number)
    # 04/15/2024 can only be month first
    other = _valid(year, number, month) if swappable else None
    if day is None:
        day, other = other, None
    if day is None:
        return None
    return NamedDate(day, exactness, other if other != day else None, parts.get("short") is not None)


def _valid(year: int, month: int, day: int) -> date | None:
    try:
        found = date(year, month, day)
    except ValueError:
        return None
    return found if FIRST_YEAR <= year <= datetime.now(UTC).year + 1 else None
