"""What a report says of the frames: how much each epoch bends, how well targets hold it, and what stretches did together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ..results.geopackage_reader import EpochPair, Row, read_layer_rows, table_names

TOLD_HEIGHTS = 0.01
"""Common motion over H that an owner wants to know of: where less than this cannot be told, the page says so."""


@dataclass(frozen=True, kw_only=True)
class BentEpoch:
    """One epoch's frame, lengths in metres: ``bend`` and ``largest`` of the error along the structure, ``sd`` of it; targets used."""

    label: str
    bend: float
    largest: float
    sd: float
    correlation_length: float
    used: int
    targets: int


@dataclass(frozen=True, kw_only=True)
class FramesPage:
    """Rows of ``frame_errors`` and ``stretches`` as the page shows them.

    Attributes
    ----------
    epochs
        Of the pair, those whose frame bends.
    bends
        Rows of ``frame_errors`` of the pair.
    stretches
        Rows of ``stretches`` of the pair in datum ``control``; in datum ``stable`` where not both epochs have control. None where both
        show few units.
    datum
        Of the stretches.
    untold
        Stretches of which a common motion of 0.01 H could not be told.
    drifting
        Whether strips drift in one of the epochs.
    aligned
        Labels of epochs that only their units tie to the other.
    """

    epochs: tuple[BentEpoch, ...]
    bends: tuple[Row, ...]
    stretches: tuple[Row, ...]
    datum: str
    untold: int
    drifting: bool
    aligned: tuple[str, ...]

    @property
    def moved(self) -> list[Row]:
        """Stretches whose common motion is significant."""
        return [row for row in self.stretches if row["significant"]]


def frames_page(result: Path, pair: EpochPair, control: Sequence[Row], height: float) -> FramesPage | None:
    """Read what a result says of its frames; None for results of versions that say nothing."""
    if "stretches" not in table_names(result):
        return None
    stretches = [
        row for row in read_layer_rows(result, "stretches") if (row["epoch_from"], row["epoch_to"]) == (pair.epoch_from, pair.epoch_to)
    ]
    labels = (pair.epoch_from, pair.epoch_to)
    bends = [row for row in read_layer_rows(result, "frame_errors") if row["epoch"] in labels]
    datum = "control" if {row["epoch"] for row in control} >= set(labels) else "stable"
    own = sorted((row for row in stretches if row["datum"] == datum), key=lambda row: float(row["along_from"]))
    return FramesPage(
        epochs=tuple(e for label in labels if (e := _bent(label, bends, control)) is not None),
        bends=tuple(bends),
        stretches=tuple(own),
        datum=datum,
        untold=sum(row["detectable"] > TOLD_HEIGHTS * height for row in own),
        drifting=any(row["known_by"] == "strips" for row in bends),
        aligned=tuple(row["label"] for row in read_layer_rows(result, "epochs") if row["label"] in labels and row.get("datum") == "units"),
    )


def _bent(label: str, bends: Sequence[Row], control: Sequence[Row]) -> BentEpoch | None:
    own = [row for row in bends if row["epoch"] == label and row["known_by"] == "targets"]
    if not own:
        return None
    targets = [row for row in control if row["epoch"] == label]
    return BentEpoch(
        label=label,
        bend=math.sqrt(sum(row["d_3d"] ** 2 for row in own) / len(own)),
        largest=max(row["d_3d"] for row in own),
        sd=math.sqrt(sum(row["sd_e"] ** 2 + row["sd_n"] ** 2 + row["sd_h"] ** 2 for row in own) / len(own)),
        correlation_length=float(own[0]["correlation_length"]),
        used=sum(bool(row["used"]) for row in targets),
        targets=len(targets),
    )
