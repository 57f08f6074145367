"""Compare two results layer by layer, to the last bit: what a change of the code that should change nothing is held against.

    .venv/bin/python scripts/dev/compare_results.py BEFORE.gpkg AFTER.gpkg [--tolerance 0] [--leave-out epochs]

Rows are compared in the order of their names, not of the file; what tells who wrote the file and when (software, code, times of writing)
is left out. With a tolerance, numbers may differ by it. Exit code 1 where anything differs.
"""

from __future__ import annotations

import argparse
import json
import math
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

WRITTEN = {"fid", "software", "code", "written_at", "last_change", "checksums"}
"""Fields and keys that differ between two runs of the same code."""
NAMES = ("unit_id", "point_id", "epoch", "label", "epoch_from", "epoch_to", "datum", "feature", "kind", "source_id", "strip")


def layers_of(path: Path) -> dict[str, list[dict[str, Any]]]:
    """Rows of all feature and attribute tables of a GeoPackage by layer, values as stored."""
    with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as connection:
        connection.row_factory = sqlite3.Row
        tables = [row[0] for row in connection.execute("SELECT table_name FROM gpkg_contents ORDER BY table_name")]
        # names come from the file's own catalogue
        return {name: [dict(row) for row in connection.execute(f'SELECT * FROM "{name}"')] for name in tables}  # noqa: S608  # nosec B608


def differences(before: Path, after: Path, *, tolerance: float = 0.0, leave_out: tuple[str, ...] = ()) -> Iterator[str]:
    """One sentence for each layer, row or field that differs."""
    old, new = layers_of(before), layers_of(after)
    for layer in sorted({*old, *new} - {"layer_styles", *leave_out}):
        if layer not in old or layer not in new:
            yield f"{layer}: only in {before if layer in old else after}"
            continue
        left, right = _by_name(old[layer]), _by_name(new[layer])
        for key in sorted(left.keys() ^ right.keys()):
            yield f"{layer} {' '.join(key)}: only in {before if key in left else after}"
        for key in sorted(left.keys() & right.keys()):
            a, b = left[key], right[key]
            for field in sorted(({*a, *b}) - WRITTEN):
                if not _equal(_value(a.get(field)), _value(b.get(field)), tolerance):
                    yield f"{layer} {' '.join(key)}: {field} {_short(a.get(field))} -> {_short(b.get(field))}"


def _by_name(rows: list[dict[str, Any]]) -> dict[tuple[str, ...], dict[str, Any]]:
    found: dict[tuple[str, ...], dict[str, Any]] = {}
    for row in rows:
        base = tuple(str(row[name]) for name in NAMES if row.get(name) is not None)
        number = 0
        while (*base, str(number)) in found:
            number += 1
        found[*base, str(number)] = row
    return found


def _value(value: Any) -> Any:
    """JSON texts as what they hold, less what differs between two runs of the same code."""
    if isinstance(value, str) and value[:1] in ("{", "["):
        try:
            return _without(json.loads(value))
        except ValueError:
            return value
    return value


def _without(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without(inner) for key, inner in value.items() if key not in WRITTEN}
    return value


def _equal(a: Any, b: Any, tolerance: float) -> bool:
    if isinstance(a, float) and isinstance(b, float):
        return a == b or (math.isnan(a) and math.isnan(b)) or abs(a - b) <= tolerance
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_equal(a[key], b[key], tolerance) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(_equal(x, y, tolerance) for x, y in zip(a, b, strict=True))
    return bool(a == b)


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def main() -> int:
    """Print the differences and how many there are."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=Path)
    parser.add_argument("after", type=Path)
    parser.add_argument("--tolerance", type=float, default=0.0, help="how much numbers may differ by (default 0: to the last bit)")
    parser.add_argument("--leave-out", nargs="*", default=[], help="layers that are not compared")
    parser.add_argument("--most", type=int, default=40, help="differences printed (default 40)")
    options = parser.parse_args()
    found = list(differences(options.before, options.after, tolerance=options.tolerance, leave_out=tuple(options.leave_out)))
    for sentence in found[: options.most]:
        print(sentence)
    counts = {layer: len(rows) for layer, rows in layers_of(options.after).items()}
    print(f"{len(found)} differences in {sum(counts.values())} rows of {len(counts)} layers")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
