"""Which epoch pair and datum of a result are told of."""

from __future__ import annotations

from pathlib import Path

from ..common.errors import InputError
from ..results.geopackage_reader import EpochPair, epoch_pairs
from ..results.result_access import reading
from ..results.unit_rows import datums


def choose_pair(result: Path, pair: EpochPair | None, datum: str | None) -> tuple[EpochPair, str]:
    """The pair and datum asked for, or the last consecutive pair and its default datum.

    Raises
    ------
    InputError
        The result has no displacements, or none of that pair or datum.
    """
    pairs = epoch_pairs(result)
    if not pairs:
        raise InputError("holds no displacements", source=result, remedy="A survey of two epochs or more is needed.")
    with reading(result) as connection:
        statement = "SELECT epoch_from, epoch_to FROM displacements ORDER BY time_to DESC LIMIT 1"
        last = connection.execute(statement).fetchone()
    chosen = pair or (EpochPair(last["epoch_from"], last["epoch_to"]) if last else pairs[0])
    if chosen not in pairs:
        raise InputError(f"has no epoch pair {chosen}", source=result, remedy=f"It has {', '.join(str(p) for p in pairs)}.")
    available = datums(result, chosen)
    if datum is not None and datum not in available:
        raise InputError(f"has no datum {datum} for {chosen}", source=result, remedy=f"It has {', '.join(available)}.")
    return chosen, datum or available[0]
