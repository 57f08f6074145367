"""Tables of points of an epoch: their keys in survey.toml, their columns, and what is assumed where a column is missing."""

from __future__ import annotations

from collections.abc import Sequence

from .inputs import CHECK_COLUMNS, CONTROL_COLUMNS, TARGET_COLUMNS

TARGET_SD, CHECK_SD = "0.003", "0.003"
"""Standard deviation in metres assumed for surveyed points of a layer without such fields: that of a total station."""
FILE_COLUMNS: tuple[tuple[str, Sequence[str], dict[str, str]], ...] = (
    ("control", CONTROL_COLUMNS, dict.fromkeys(("sd_e", "sd_n", "sd_h"), TARGET_SD)),
    ("targets", TARGET_COLUMNS, {}),
    ("check", CHECK_COLUMNS, {"sd": CHECK_SD}),
)
