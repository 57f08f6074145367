"""Text in tables for spreadsheets, which take a cell that begins like a formula for one and run it."""

from __future__ import annotations

import re
from typing import Any

from .errors import InputError

_FORMULA = re.compile(r"\s*[=+\-@\uff1d\uff0b\uff0d\uff20]|[\t\r\n\0]")
"""Start of a cell that some spreadsheet runs: full-width signs too, and blanks before the sign, which some take away."""
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def spreadsheet_safe(value: Any) -> Any:
    """A text that a spreadsheet would run as a formula with an apostrophe before it; numbers, also as text, and all else as they are."""
    if isinstance(value, str) and _FORMULA.match(value) and not _NUMBER.fullmatch(value):
        return f"'{value}"
    return value


SEPARATORS = {"comma": (",", "."), "semicolon": (";", ","), "tab": ("\t", ".")}
"""Signs between fields and in decimals by name; where a spreadsheet parts fields by semicolons, it expects a comma in decimals."""

SPREADSHEET_ENCODING = "utf-8-sig"
"""The mark at the beginning tells a spreadsheet that the file is UTF-8; without it letters of other scripts come out garbled."""


def signs(separator: str) -> tuple[str, str]:
    """Sign between fields, and decimal sign.

    Raises
    ------
    InputError
        There is no separator of that name.
    """
    if separator not in SEPARATORS:
        raise InputError(f"unknown separator {separator!r}", remedy=f"Choose one of {', '.join(SEPARATORS)}.")
    return SEPARATORS[separator]
