"""Until when a row of an epoch is the latest: what lets a map in time show each epoch until the next one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from itertools import pairwise
from typing import Any

from .schema import LAYERS

Row = Mapping[str, Any]


def with_epoch_ends(tables: Mapping[str, Sequence[Row]]) -> dict[str, Sequence[Row]]:
    """Tables of a result with ``epoch_until`` filled in wherever a layer has it: the time of the next epoch, None in the last one.

    Tables without their epochs stay as they are: nothing is known of what follows.
    """
    times = {str(row["label"]): row.get("time") for row in tables.get("epochs", ())}
    known = sorted((_moment(time), label) for label, time in times.items() if time is not None)
    until = {label: times[following] for (_, label), (_, following) in pairwise(known)}
    if not known:
        return dict(tables)
    return {
        name: [{**row, "epoch_until": until.get(str(row.get("epoch")))} for row in rows] if "epoch_until" in LAYERS[name].names else rows
        for name, rows in tables.items()
    }


def _moment(time: str | datetime) -> datetime:
    return datetime.fromisoformat(time) if isinstance(time, str) else time
