"""Figures of performance kept from commit to commit, so that a slowdown is seen: one JSON object a line in ``record.jsonl``.

Only ratios to a floor or peer of the same run are kept: they say the same on a slow and on a fast machine.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path

RECORD = Path(__file__).with_name("record.jsonl")
SLOWER = 0.10
"""Growth of a ratio that is called a slowdown: repetitions on a quiet machine differ by half of it."""


@dataclass(frozen=True)
class Figures:
    """Ratios that one benchmark measured of one case.

    Attributes
    ----------
    date, commit
        Day (ISO 8601, UTC) and abbreviated commit; ``+`` behind it where files were changed since.
    benchmark, case
        Script, and what it was given.
    ratios
        By name, to the floor or peer of the same run; larger is slower.
    """

    date: str
    commit: str
    benchmark: str
    case: str
    ratios: dict[str, float]


def read_record(path: Path = RECORD) -> list[Figures]:
    """All figures, in the order they were taken; none where there is no record yet."""
    if not path.is_file():
        return []
    return [Figures(**json.loads(line)) for line in path.read_text(encoding="utf-8").splitlines() if line]


def add_to_record(benchmark: str, case: str, ratios: Mapping[str, float], path: Path = RECORD) -> list[str]:
    """Append figures and hold them against the last ones of the same case: a sentence a ratio; none for the first ones."""
    before = [figures for figures in read_record(path) if (figures.benchmark, figures.case) == (benchmark, case)]
    now = Figures(
        datetime.now(UTC).date().isoformat(), _commit(), benchmark, case, {name: round(value, 3) for name, value in ratios.items()}
    )
    with path.open("a", encoding="utf-8") as stream:
        stream.write(json.dumps(asdict(now)) + "\n")
    return comparison(before[-1], now) if before else []


def comparison(before: Figures, now: Figures) -> list[str]:
    """How each ratio changed since."""
    told = []
    for name, value in now.ratios.items():
        old = before.ratios.get(name)
        if old:
            change = value / old - 1
            word = "SLOWER" if change > SLOWER else "faster" if change < -SLOWER else "as before"
            told.append(f"{now.case}, {name}: {value:.2f} against {old:.2f} ({before.commit}, {before.date}): {change:+.0%}, {word}")
    return told


def _commit() -> str:
    def git(*arguments: str) -> str:
        return subprocess.run(["git", "-C", str(RECORD.parent), *arguments], capture_output=True, text=True, check=True).stdout.strip()

    return git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "--untracked-files=no", "--", ":!*.jsonl") else "")
