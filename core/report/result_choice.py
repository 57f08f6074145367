"""Which epoch pair and datum of a result are told of."""

from __future__ import annotations

from pathlib import Path

from ..common.errors import InputError
from ..results.geopackage_reader import EpochPair, epoch_pairs, latest_pair
from ..results.unit_rows import datums, read_epochs


def choose_pair(result: Path, pair: EpochPair | None, datum: str | None) -> tuple[EpochPair, str]:
    """The pair and datum asked for, or the last consecutive pair and its default datum.

    Raises
    ------
    InputError
        The result compares no epochs, or not those, or not in that datum.
    """
    pairs = epoch_pairs(result)
    if not pairs:
        raise InputError("compares no epochs", source=result, remedy="A survey of two epochs or more is needed.")
    chosen = pair or latest_pair(pairs, [epoch.label for epoch in read_epochs(result)])
    if chosen not in pairs:
        raise InputError(f"has no epoch pair {chosen}", source=result, remedy=f"It has {', '.join(str(p) for p in pairs)}.")
    available = datums(result, chosen)
    if datum is not None and datum not in available:
        raise InputError(f"has no datum {datum} for {chosen}", source=result, remedy=f"It has {', '.join(available)}.")
    return chosen, datum or available[0]
