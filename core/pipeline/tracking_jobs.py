"""What tracking asks of points, as jobs: points of units from the blocks' files, points around places from the tiles."""

from __future__ import annotations

import hashlib
import pickle  # nosec B403 - only written, to be hashed: nothing is read back
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from ..common.arrays import FloatArray
from ..common.software import code_fingerprint
from ..data.window_around import WindowAround
from ..deformation.questions import Answer, Question
from ..deformation.unit_clouds import ReadCloud
from ..registration.transformation import Transformation
from .array_files import Arrays, loaded_arrays
from .block_clouds import NOT_KEPT, BlockClouds
from .blocks import Block
from .job_runner import JobRunner, job_key

HELD_POINTS = 1_000_000
"""Points of units that are kept for the next look at them, some 25 MB: a joint adjustment looks a dozen times."""
QUESTION_PACKAGES = ("deformation", "registration")
"""Packages of ``core`` that decide an answer beside those of all jobs."""


class _EmptyWhenCopied:
    """What a process holds between calls; a copy for another process begins with nothing."""

    def __reduce__(self) -> tuple[type[Self], tuple[()]]:
        return type(self), ()


class LastFile(_EmptyWhenCopied):
    """Arrays of the file that was asked for last."""

    def __init__(self) -> None:
        self._held: dict[Path, Mapping[str, NDArray[Any]]] = {}

    def arrays(self, path: Path) -> Mapping[str, NDArray[Any]]:
        """Arrays of a file.

        Raises
        ------
        InputError
            It is gone.
        """
        if path not in self._held:
            self._held.clear()
            self._held[path] = loaded_arrays(path)
        return self._held[path]


class HeldClouds(_EmptyWhenCopied):
    """Clouds of units that stay in memory, as many as it may take."""

    def __init__(self) -> None:
        self._left = HELD_POINTS
        self._held: dict[tuple[Path, int], ReadCloud] = {}

    def read(self, key: tuple[Path, int], anew: Callable[[], ReadCloud]) -> ReadCloud:
        """The cloud of a unit by file and place, read ``anew`` where it is not held."""
        if key in self._held:
            return self._held[key]
        cloud = anew()
        if len(cloud[0]) <= self._left:
            self._left -= len(cloud[0])
            self._held[key] = cloud
        return cloud


@dataclass(frozen=True, eq=False, kw_only=True)
class FiledPoints:
    """Points of a unit in the file of its block, to be called for.

    Attributes
    ----------
    file, place
        Result of a block's job, and which of its units.
    transformation
        From the epoch's cloud to the control frame.
    origin
        (3,) reduction point there.
    last
        Shared by units that are asked for one after the other.
    held
        Shared by all units.
    """

    file: Path
    place: int
    transformation: Transformation
    origin: FloatArray
    last: LastFile
    held: HeldClouds

    def __call__(self) -> ReadCloud:
        """(n, 3) points, control frame less the origin, and (n,) sources."""
        return self.held.read((self.file, self.place), self._read)

    def _read(self) -> ReadCloud:
        arrays = self.last.arrays(self.file)
        own = slice(*arrays["offsets"][self.place : self.place + 2])
        return self.transformation.apply(arrays["points"][own] + arrays["origin"]) - self.origin, arrays["sources"][own]


@dataclass(frozen=True, eq=False, kw_only=True)
class PointsAround:
    """Points of an epoch's cloud around places, to be called for.

    Attributes
    ----------
    blocks
        Those that hold such points.
    survey_crs
        As in survey.toml.
    transformation
        From the epoch's cloud to the control frame.
    origin
        (3,) reduction point there.
    places, reach
        (k, 3) in the frame of the cloud, absolute, and distance from them, metres.
    checksums
        Of the blocks' tiles.
    clouds
        Where points of blocks are kept.
    """

    blocks: tuple[Block, ...]
    survey_crs: str
    transformation: Transformation
    origin: FloatArray
    places: FloatArray
    reach: float
    checksums: tuple[str, ...]
    clouds: BlockClouds = NOT_KEPT

    def __call__(self) -> ReadCloud:
        """(n, 3) points, control frame less the origin, and (n,) sources."""
        tree = cKDTree(self.places - self.origin)
        parts: list[FloatArray] = []
        sources: list[NDArray[np.integer[Any]]] = [np.empty(0, dtype=np.uint16)]
        for block in self.blocks:
            window = WindowAround.of(block.core, self.places, self.reach)
            xyz, own = self.clouds.points(block, self.survey_crs, window, self.origin)
            near = np.isfinite(tree.query(xyz, distance_upper_bound=self.reach)[0])
            parts.append(self.transformation.apply(xyz[near] + self.origin) - self.origin)
            sources.append(own[near])
        return np.concatenate(parts) if parts else np.empty((0, 3)), np.concatenate(sources)


@dataclass(frozen=True, eq=False)
class QuestionJob:
    """A question of tracking's as a job, named after everything the question holds."""

    question: Question
    name: str = field(init=False)

    def __post_init__(self) -> None:
        content = hashlib.sha256(pickle.dumps(self.question)).hexdigest()
        key = job_key(type(self.question).__name__, {"code": code_fingerprint(QUESTION_PACKAGES)}, [content])
        object.__setattr__(self, "name", f"track-{key}.npz")

    def run(self) -> Arrays:
        """The answer."""
        return self.question.answer()


def answered_by(runner: JobRunner, questions: Sequence[Question], beside: Callable[[], None] = lambda: None) -> Iterator[Answer]:
    """Answers in the order of the questions, one read at a time; ``beside`` is the caller's own work, as in :meth:`.JobRunner.run`."""
    return (loaded_arrays(path) for path in runner.run([QuestionJob(question) for question in questions], beside=beside))
