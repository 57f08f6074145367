"""Text tables as offices and instruments write them: separators, decimal commas, and the many names of the same column."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass

SYNONYMS: dict[str, tuple[str, ...]] = {
    "point_id": (
        *("id", "point", "pointid", "point id", "point_name", "point name", "name", "pt", "no", "nr", "target", "punkt"),
        *("点名", "点号", "점번호"),
    ),
    "easting": ("e", "east", "x", "rechts", "rechtswert", "est", "este", "ostwert", "x_east"),
    "northing": ("n", "north", "y", "hoch", "hochwert", "nord", "norte", "nordwert", "y_north"),
    "height": ("h", "z", "elevation", "elev", "altitude", "alt", "hoehe", "höhe", "level", "标高", "標高", "高程", "표고"),
    "x": ("e", "east", "easting"),
    "y": ("n", "north", "northing"),
    "z": ("h", "height", "elevation", "elev"),
    "sd_e": ("se", "sigma_e", "std_e", "sde", "s_e", "sd_x", "std_x", "sigma_x"),
    "sd_n": ("sn", "sigma_n", "std_n", "sdn", "s_n", "sd_y", "std_y", "sigma_y"),
    "sd_h": ("sh", "sigma_h", "std_h", "sdh", "s_h", "sd_z", "std_z", "sigma_z"),
    "unit_id": ("unit", "block", "block_id", "blockid", "block id", "id", "name", "no", "nr", "number"),
    "unit_easting": ("unit_e", "unit_x"),
    "unit_northing": ("unit_n", "unit_y"),
    "unit_height": ("unit_h", "unit_z"),
    "gps_time": ("time", "gpstime", "gps time", "t"),
    "point_source_id": ("station", "source_id", "pointsourceid"),
}
"""Other names of a column, in lower case, the plainest first; what a file calls by the right name is never read under another."""

UNIT_NAMES = {
    **dict.fromkeys(("m", "metre", "meter", "metres", "meters"), "m"),
    **dict.fromkeys(("ft", "feet", "foot"), "ft"),
    **dict.fromkeys(("us-ft", "ftus", "usft", "ussurveyfoot", "ussurveyfeet"), "us-ft"),
}
"""Units of length as headers write them, in lower case without spaces, by their names in survey.toml."""

_UNIT = re.compile(r"\s*[\[(]\s*([^\])]*?)\s*[\])]\s*$")


class TableError(ValueError):
    """A text cannot be split into lines and fields; ``line`` tells where."""

    def __init__(self, problem: str, line: int) -> None:
        self.line = line
        super().__init__(problem)


@dataclass(frozen=True)
class TextTable:
    """A table split into fields.

    Attributes
    ----------
    names
        Columns in lower case, without units.
    units
        Unit written after each name, as in ``height [ft]``; empty where there is none.
    rows
        Number of the line and its fields, empty lines left out; numbers with points as decimal signs.
    separator
        Between fields.
    decimal_commas
        Numbers were written with commas.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: tuple[tuple[int, tuple[str, ...]], ...]
    separator: str
    decimal_commas: bool


def decoded(data: bytes, errors: str = "strict") -> str:
    """Text of a table: UTF-8, or UTF-16 as spreadsheets write their Unicode text; ``errors`` as for :meth:`bytes.decode`.

    Raises
    ------
    TableError
        It is a spreadsheet itself, or in another encoding.
    """
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0")):
        raise TableError("it is a spreadsheet or archive, not text", 1)
    try:
        if data.startswith((b"\xff\xfe", b"\xfe\xff")):
            return data.decode("utf-16", errors)
        text = data.decode("utf-8-sig", errors)
    except UnicodeDecodeError as error:
        raise TableError(f"its text is not UTF-8 ({error.reason})", data.count(b"\n", 0, error.start) + 1) from None
    if text[:2000].count("\0") > len(text[:2000]) // 4:
        raise TableError("its text is not UTF-8, or it is no text at all", 1)
    return text


def split_table(text: str) -> TextTable:
    """Split a table with a header line; the separator is what the header holds, decimal commas need another one than the comma.

    Raises
    ------
    TableError
        The text is no table.
    """
    lines = text.splitlines()
    # a line that tells spreadsheets the separator
    first = 1 if lines and re.fullmatch(r'"?sep=."?[,;\t]*', lines[0], re.IGNORECASE) else 0
    lines = lines[first:]
    header = lines[0] if lines else ""
    separator = max((",", ";", "\t"), key=header.count) if any(s in header for s in ",;\t") else ","
    reader = csv.reader(lines, skipinitialspace=True, delimiter=separator)
    try:
        parsed = list(reader) or [[]]
    except csv.Error as error:
        raise TableError(str(error), reader.line_num + first) from None
    heads = [_UNIT.sub("", name).strip().lower() for name in parsed[0]]
    units = [match[1].lower() if (match := _UNIT.search(name)) else "" for name in parsed[0]]
    rows = [(k, tuple(fields)) for k, fields in enumerate(parsed[1:], start=2 + first) if any(field.strip() for field in fields)]
    commas = separator != "," and any(re.fullmatch(r"\s*[-+]?\d+,\d+\s*", field) for _, fields in rows for field in fields)
    if commas:
        rows = [(k, tuple(re.sub(r"^(\s*[-+]?\d+),(\d+\s*)$", r"\1.\2", field) for field in fields)) for k, fields in rows]
    return TextTable(tuple(heads), tuple(units), tuple(rows), separator, commas)


def columns_of(names: Sequence[str], wanted: Sequence[str]) -> dict[str, int]:
    """Index of each wanted column that is there, by its own name or else by another that no other wanted column bears."""
    found = {name: names.index(name) for name in wanted if name in names}
    taken = set(found.values())
    for name in wanted:
        if name in found:
            continue
        for other in SYNONYMS.get(name, ()):
            if other in names and names.index(other) not in taken:
                found[name] = names.index(other)
                taken.add(found[name])
                break
    return found
