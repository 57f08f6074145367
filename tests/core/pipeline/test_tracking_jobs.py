"""Questions of tracking as jobs: the same answers as asked here, in their order, and never one question's answer for another's."""

from __future__ import annotations

import pickle
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from tetratrack.core.data.tiles import inspect_tile, read_points
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.pipeline.array_files import save_arrays
from tetratrack.core.pipeline.blocks import plan_blocks
from tetratrack.core.pipeline.job_runner import JobRunner
from tetratrack.core.pipeline.tracking_jobs import FiledPoints, HeldClouds, LastFile, PointsAround, QuestionJob, answered_by
from tetratrack.core.registration.transformation import Transformation

TILES = sorted((Path(__file__).resolve().parents[2] / "data" / "tiny" / "tiles" / "2024-04-09").glob("*.laz"))
CRS = "EPSG:32650"


@dataclass(frozen=True, eq=False)
class Sum:
    cloud: UnitCloud
    factor: float

    def answer(self) -> dict[str, np.ndarray]:
        return {"sum": self.factor * self.cloud.read()[0].sum(axis=0)}


def filed(folder: Path, last: LastFile) -> list[UnitCloud]:
    """Clouds of two units in one file."""
    points = np.random.default_rng(1).normal(size=(7, 3))
    arrays = {"points": points, "sources": np.arange(7, dtype=np.uint16), "offsets": np.array([0, 3, 7]), "origin": np.array([10.0, 0, 0])}
    save_arrays(folder / "block.npz", arrays)
    still = Transformation.identity(np.zeros(3))
    common = {"file": folder / "block.npz", "transformation": still, "origin": np.array([9.0, 0, 0]), "last": last, "held": HeldClouds()}
    return [UnitCloud(np.arange(7, dtype=np.uint16), FiledPoints(place=k, **common)) for k in (0, 1)]


def test_a_copy_reads_the_same_points_and_carries_none(tmp_path: Path) -> None:
    last = LastFile()
    first, second = filed(tmp_path, last)
    before = len(pickle.dumps(first))
    points, sources = second.read()
    assert len(pickle.dumps(first)) == before
    assert sources.tolist() == [3, 4, 5, 6]
    again, _ = pickle.loads(pickle.dumps(second)).read()  # noqa: S301
    assert np.array_equal(again, points)
    assert points == pytest.approx(np.random.default_rng(1).normal(size=(7, 3))[3:] + np.array([1.0, 0, 0]))


def test_a_question_is_named_after_everything_it_holds(tmp_path: Path) -> None:
    first, second = filed(tmp_path, LastFile())
    names = [QuestionJob(question).name for question in (Sum(first, 1.0), Sum(first, 2.0), Sum(second, 1.0))]
    assert len(set(names)) == 3
    assert QuestionJob(Sum(filed(tmp_path, LastFile())[0], 1.0)).name == names[0]


def test_answers_come_in_the_order_of_the_questions(tmp_path: Path) -> None:
    clouds = filed(tmp_path, LastFile())
    questions = [Sum(cloud, factor) for factor in (2.0, 1.0) for cloud in clouds]
    with JobRunner(tmp_path) as runner:
        answers = [answer["sum"] for answer in answered_by(runner, questions)]
    assert answers == [pytest.approx(question.answer()["sum"]) for question in questions]


def test_points_around_places_are_those_of_the_whole_cloud() -> None:
    tiles = [inspect_tile(path, CRS) for path in TILES]
    whole = read_points(tiles, CRS)
    blocks = plan_blocks("a", tiles, 0.1)
    assert len(blocks) > 1
    places = whole.xyz[:: len(whole) // 3] + whole.origin
    around = PointsAround(
        blocks=blocks, survey_crs=CRS, transformation=Transformation.identity(whole.origin), origin=whole.origin, places=places, reach=0.4,
        checksums=(),
    )  # fmt: skip
    points, sources = pickle.loads(pickle.dumps(around))()  # noqa: S301
    near = (np.linalg.norm(whole.xyz[:, None] - (places - whole.origin), axis=2) < 0.4).any(axis=1)
    assert len(sources) == len(points) == near.sum() > 50
    assert np.sort(points, axis=0) == pytest.approx(np.sort(whole.xyz[near], axis=0))
