"""What results of the step ``register`` say of an epoch: its transformation, what ties it, and its targets."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..common.arrays import FloatArray
from ..deformation.target_shifts import TargetShifts
from ..registration.transformation import Transformation, transformation_of
from ..results.geopackage_reader import read_layer_rows

SD_FIELDS = ("sd_e", "sd_n", "sd_h")


@dataclass(frozen=True, eq=False, kw_only=True)
class RegisteredEpoch:
    """One epoch of the layer ``epochs``.

    Attributes
    ----------
    transformation
        Of its cloud to control; None where the cloud's own frame was kept.
    redundancy
        Of the registration.
    datum
        What its frame hangs on: control, stable areas, units, or cloud.
    reference
        Label of the epoch that it was tied to on stable areas; None without.
    bent
        Its frame bends, so that the transformation alone does not bring the cloud to control.
    targets
        Rows of ``control_residuals``; none where the frame bends.
    """

    transformation: Transformation | None
    redundancy: int
    datum: str
    reference: str | None
    bent: bool
    targets: Sequence[Mapping[str, Any]]

    def applied(self) -> RegisteredEpoch:
        """The same for units that it brought to control already: nothing moves, what it does not know stays."""
        known = self.transformation
        if known is None:
            return self
        here = Transformation.identity(known.origin_to)
        return replace(self, transformation=replace(here, covariance=known.covariance))

    def target_shifts(self, origin: FloatArray) -> TargetShifts | None:
        """Its targets less the reduction point ``origin`` (3,); None where there are none or their deviations are not stated."""
        rows = self.targets
        if not rows or any(row.get(name) is None for row in rows for name in SD_FIELDS):
            return None
        variances = np.array([[row[name] for name in SD_FIELDS] for row in rows], dtype=np.float64) ** 2
        return TargetShifts(
            ids=tuple(str(row["point_id"]) for row in rows),
            positions=np.array([row["geom"] for row in rows], dtype=np.float64) - origin,
            residuals=np.array([[row["ve"], row["vn"], row["vh"]] for row in rows], dtype=np.float64),
            variances=variances,
            # the layer does not tell them apart
            surveyed_variances=np.zeros_like(variances),
        )


def read_registered(paths: Sequence[Path]) -> dict[str, RegisteredEpoch]:
    """Epochs of several GeoPackages by label; later files count where two hold one epoch."""
    found = {}
    for path in paths:
        targets = list(read_layer_rows(path, "control_residuals"))
        for row in read_layer_rows(path, "epochs"):
            settings = json.loads(row.get("settings") or "{}")
            # residuals of a whole run are those against its bent frames already
            bent = bool(settings.get("frame", {}).get("bends"))
            label = str(row["label"])
            found[label] = RegisteredEpoch(
                transformation=transformation_of(json.loads(row.get("transformation") or "{}")),
                redundancy=int(settings.get("redundancy") or 0),
                datum=str(row.get("datum") or "cloud"),
                reference=str(row["reference_epoch"]) if row.get("reference_epoch") else None,
                bent=bent,
                targets=() if bent else tuple(target for target in targets if target["epoch"] == label),
            )
    return found
