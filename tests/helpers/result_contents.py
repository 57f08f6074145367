"""What a result holds, as values that can be compared."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from tetratrack.core.results.geopackage_reader import read_layer_rows

COMPUTED = ("units", "gaps", "feature_points", "displacements", "displacements_other", "control_residuals", "check_residuals", "epochs")


def contents(path: Path, *, without_inputs: bool = False) -> dict[str, list[dict[str, Any]]]:
    """All rows of the computed layers; optionally without the names and checksums of input files."""
    layers = {}
    for name in COMPUTED:
        rows = read_layer_rows(path, name)
        for row in rows:
            row["geom"] = None if row.get("geom") is None else np.asarray(row["geom"]).tolist()
            if without_inputs and name == "epochs":
                row["tiles"] = None
                row["settings"] = json.loads(row["settings"]) | {"inputs": None}
        layers[name] = rows
    return layers
