"""What a result was computed from: checksums of all inputs, settings, versions and seed. Nothing in it depends on the machine or
the moment, so that equal inputs give equal records."""

from __future__ import annotations

import json
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from ..common.errors import InputError
from ..common.feedback import Feedback
from ..common.software import code_fingerprint, software_version
from ..data.folder_epochs import CLOUDS
from ..data.las_files import checksum
from ..data.survey import Epoch, Survey
from .schema import FORMAT_VERSION
from .unit_rows import EpochInfo, read_epochs

GIVE = "Give the survey.toml this result was computed from."

LIBRARIES = ("numpy", "scipy", "numba", "open3d", "laspy", "lazrs", "pyproj")
"""Libraries whose version can change a result."""


@dataclass(frozen=True)
class RunRecord:
    """Inputs of one run.

    Attributes
    ----------
    checksums
        SHA-256 by file: survey.toml, tiles, CSV files and the layer of stable areas.
    seed
        Of the random draws.
    settings
        Everything else that was chosen, as JSON values.
    """

    checksums: Mapping[Path, str]
    seed: int
    settings: Mapping[str, Any]

    def of_epoch(self, epoch: Epoch, extra: Mapping[str, Any]) -> str:
        """JSON for ``epochs.settings``: the run's settings, one epoch's inputs and ``extra`` values."""
        record = {
            "software": f"tetratrack {software_version()}",
            "code": code_fingerprint(),
            "format": FORMAT_VERSION,
            "libraries": library_versions(),
            "seed": self.seed,
            **self.settings,
            **extra,
            **({"range_sd": epoch.range_sd, "angle_sd": epoch.angle_sd} if epoch.range_sd is not None else {}),
            "inputs": [{"name": path.name, "sha256": self.checksums[path]} for path in epoch.files],
        }
        return json.dumps(record, sort_keys=True)


def record_run(survey: Survey, seed: int, settings: Mapping[str, Any]) -> RunRecord:
    """Checksum all inputs of a survey; its types of unit are kept in the settings as ``unit_types``.

    Raises
    ------
    InputError
        A file cannot be read.
    """
    files = [survey.path, *survey.moulds, *([] if survey.stable_areas is None else [survey.stable_areas.path])]
    for epoch in survey.epochs:
        files += epoch.files
    files = list(dict.fromkeys(files))
    # reading is what takes the time, and hashing releases the interpreter's lock
    with ThreadPoolExecutor(4) as pool:
        sums = list(pool.map(checksum, files))
    checksums = dict(zip(files, sums, strict=True))
    settings = {**settings, "unit_types": [asdict(unit.type) for unit in survey.units]}
    if survey.stable_areas is not None:
        named = survey.stable_areas
        areas = {"name": named.path.name, "sha256": checksums[named.path]} | ({"layer": named.layer} if named.layer else {})
        settings = {**settings, "stable_areas": areas}
    if survey.moulds:
        settings = {**settings, "moulds": [{"name": path.name, "sha256": checksums[path]} for path in survey.moulds]}
    return RunRecord(checksums, seed, settings)


def epochs_of(survey: Survey, path: Path, feedback: Feedback) -> dict[str, EpochInfo]:
    """Epochs of a result by label, all of the survey's among them, from the same tiles.

    A tile of a known name that was written anew since, as with more dimensions, is taken with a warning. Results of earlier versions that
    do not record their inputs are taken by their labels.

    Raises
    ------
    InputError
        Survey and result do not belong together.
    """
    infos = {info.label: info for info in read_epochs(path)}
    missing = [epoch.label for epoch in survey.epochs if epoch.label not in infos]
    if missing:
        raise InputError(f"has no epoch {missing[0]}", source=path, remedy=GIVE)
    for epoch in survey.epochs:
        used = {record["sha256"]: record["name"] for record in infos[epoch.label].settings.get("inputs", [])}
        if used:
            for tile in _changed_tiles(epoch, used, path):
                feedback.warning(f"{tile} was written anew since {path.name} was computed: units are looked for where they were then")
    return infos


def _changed_tiles(epoch: Epoch, used: Mapping[str, str], path: Path) -> list[Path]:
    """Tiles whose content is not that of the tile of their name in a result; ``used`` holds its inputs' names by checksum."""
    with ThreadPoolExecutor(4) as pool:
        sums = dict(zip(epoch.tiles, pool.map(checksum, epoch.tiles), strict=True))
    known = set(sums.values())
    # a tile is often packed or unpacked without its name changing otherwise
    absent = {Path(name).stem: name for found, name in used.items() if found not in known and Path(name).suffix.lower() in CLOUDS}
    changed = []
    for tile in (tile for tile, found in sums.items() if found not in used):
        if absent.pop(tile.stem, None) is None:
            raise InputError(f"was not computed from {tile}", source=path, where=f"epoch {epoch.label}", remedy=GIVE)
        changed.append(tile)
    if absent:
        name = next(iter(absent.values()))
        raise InputError(
            f"was computed from {name} too, which the survey does not have", source=path, where=f"epoch {epoch.label}", remedy=GIVE
        )
    return changed


def library_versions() -> dict[str, str]:
    """Installed version by library, of those that can change a result."""
    versions = {}
    for name in LIBRARIES:
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            versions[name] = "absent"
    return versions
