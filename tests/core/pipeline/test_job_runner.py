"""Blocks and jobs: independent of tiling, finished work kept, workers that die replaced."""

from __future__ import annotations

import gc
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numba
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tetratrack.core.adjustment.adjustment_records import AdjustmentOptions
from tetratrack.core.adjustment.gauss_helmert import adjust
from tetratrack.core.common.errors import Cancelled, InputError, NoSolutionError, OutputError, TetratrackError
from tetratrack.core.common.feedback import Feedback
from tetratrack.core.common.garbage_collection import THRESHOLDS
from tetratrack.core.common.lifeline import PARENT_WATCH
from tetratrack.core.data.tiles import TileInfo, Window
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import sample_surface
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.pipeline.array_files import load_arrays, loaded_arrays, save_arrays
from tetratrack.core.pipeline.block_jobs import LEG_COLUMNS, FitJob, adjusted_nearby
from tetratrack.core.pipeline.blocks import plan_blocks
from tetratrack.core.pipeline.epoch_units import owners
from tetratrack.core.pipeline.gap_table import look_into_tiles
from tetratrack.core.pipeline.job_runner import JobRunner, job_key
from tetratrack.core.pipeline.local_processes import LocalProcesses, processes_for
from tetratrack.core.pipeline.run_options import RunOptions, job_runner
from tetratrack.scripts.console import LINEAR_ALGEBRA


def _tile(name: str, low: tuple[float, float], high: tuple[float, float], points: int = 1000) -> TileInfo:
    return TileInfo(
        path=Path(name),
        points=points,
        low=(*low, 0.0),
        high=(*high, 5.0),
        version="1.4",
        point_format=6,
        compressed=True,
        copc=False,
        crs="",
        has_time=True,
        size=1,
        note="",
    )


@dataclass(frozen=True)
class Square:
    """Squares a number; ``trouble`` names what goes wrong the first time."""

    number: float
    folder: str = ""
    trouble: str = ""

    @property
    def name(self) -> str:
        return f"square-{self.number:g}.npz"

    def run(self) -> dict:
        mark = Path(self.folder) / f"tried-{self.number:g}"
        first = not mark.exists()
        if self.folder:
            mark.touch()
        if self.trouble == "refuse":
            raise InputError("is wrong", source="tile.laz", where="line 1", remedy="Mend it.")
        if self.trouble == "die" and first:
            os.kill(os.getpid(), signal.SIGKILL)
        if self.trouble == "always die":
            os.kill(os.getpid(), signal.SIGKILL)
        return {"square": np.array(self.number**2)}


@dataclass(frozen=True)
class Threshold:
    """How many containers are made before a process collects garbage."""

    number: int

    @property
    def name(self) -> str:
        return f"threshold-{self.number}.npz"

    def run(self) -> dict:
        return {"threshold": np.array(gc.get_threshold())}


def _squares(paths: list[Path]) -> list[float]:
    return [float(load_arrays(path)["square"]) for path in paths]


def test_blocks_cover_every_point_once_whatever_the_tiling() -> None:
    whole = [_tile("whole", (0, 0), (200, 30), 4000)]
    halves = [_tile("left", (0, 0), (99.9, 30), 2500), _tile("right", (100, 2), (200, 30), 1500)]
    cores = [{b.core for b in plan_blocks("a", tiles, 2.0)} for tiles in (whole, halves)]
    assert cores[0] == cores[1]
    assert len(cores[0]) == 4
    rng = np.random.default_rng(0)
    points = np.vstack([rng.uniform((0, 0), (200, 30), (500, 2)), [[0, 0], [200, 30], [50, 30]]])
    inside = sum(core.contains(points).astype(int) for core in cores[0])
    assert (inside == 1).all()
    for block in plan_blocks("a", halves, 2.0):
        names = {tile.path.name for tile in block.tiles}
        assert ("left" in names) == (block.core.west - 5 < 99.9)


def test_blocks_are_smaller_where_points_are_many() -> None:
    few = plan_blocks("a", [_tile("t", (0, 0), (40, 40), 10_000)], 2.0)
    many = plan_blocks("a", [_tile("t", (0, 0), (40, 40), 30_000_000)], 2.0)
    assert len(few) == 1
    assert len(many) >= 10


def test_keys_depend_on_everything_but_order() -> None:
    key = job_key("a", {"x": 1}, ["s1", "s2"])
    assert key == job_key("a", {"x": 1}, ["s2", "s1"])
    assert len({key, job_key("b", {"x": 1}, ["s1", "s2"]), job_key("a", {"x": 2}, ["s1", "s2"]), job_key("a", {"x": 1}, ["s1"])}) == 4


@pytest.mark.parametrize("workers", [1, 2])
def test_results_come_in_the_order_of_the_jobs_and_are_kept(tmp_path: Path, workers: int) -> None:
    jobs = [Square(n, str(tmp_path)) for n in (3, 1, 2)]
    seen: list[tuple[int, int]] = []
    with JobRunner(tmp_path, workers) as runner:
        assert _squares(runner.run(jobs, lambda done, total: seen.append((done, total)))) == [9, 1, 4]
        assert seen == [(0, 3), (1, 3), (2, 3), (3, 3)]
        for mark in tmp_path.glob("tried-*"):
            mark.unlink()
        (tmp_path / "square-2.npz").write_bytes(b"power was lost here")
        assert _squares(runner.run(jobs)) == [9, 1, 4]
    assert [p.name for p in tmp_path.glob("tried-*")] == ["tried-2"]


def test_processes_serve_all_calls_and_end_with_the_runner(tmp_path: Path) -> None:
    with JobRunner(tmp_path, 2) as runner:
        runner.run([Square(1), Square(2)])
        first = {child.pid for child in multiprocessing.active_children()}
        runner.run([Square(3), Square(4), Square(5)])
        assert {child.pid for child in multiprocessing.active_children()} == first
    assert not first & {child.pid for child in multiprocessing.active_children()}


def test_processes_collect_seldom_for_garbage_collection(tmp_path: Path) -> None:
    with JobRunner(tmp_path, 2) as runner:
        paths = runner.run([Threshold(1), Threshold(2)])
    assert [tuple(load_arrays(path)["threshold"]) for path in paths] == [THRESHOLDS] * 2


def test_work_beside_gaps_is_done(tmp_path: Path) -> None:
    done: list[int] = []
    with JobRunner(tmp_path, 1) as runner:
        seen = look_into_tiles([], None, [], (UnitType.tetrapod(1.0),), {}, [], {}, runner, beside=lambda: done.append(1))
    assert (seen, done) == ({}, [1])


def test_processes_that_were_started_before_do_the_jobs(tmp_path: Path) -> None:
    with LocalProcesses(2) as processes:
        processes.start(2)
        started = {child.pid for child in multiprocessing.active_children()}
        with JobRunner(tmp_path, 2, processes=processes) as runner:
            assert _squares(runner.run([Square(1), Square(2), Square(3)])) == [1, 4, 9]
            assert {child.pid for child in multiprocessing.active_children()} == started
    assert not started & {child.pid for child in multiprocessing.active_children()}


def test_processes_that_were_started_end_with_an_error(tmp_path: Path) -> None:
    started: list[int | None] = []

    def start_and_fail() -> None:
        with LocalProcesses(2) as processes:
            processes.start(2)
            started.extend(child.pid for child in multiprocessing.active_children())
            raise InputError("is wrong", source=tmp_path)

    with pytest.raises(InputError, match="is wrong"):
        start_and_fail()
    assert len(started) >= 2
    assert not set(started) & {child.pid for child in multiprocessing.active_children()}


def test_processes_can_start_before_libraries_are_loaded() -> None:
    code = (
        "import sys, tetratrack.core.pipeline.given_survey, tetratrack.core.pipeline.local_processes\n"
        "print(*(name for name in ('numba', 'scipy', 'laspy') if name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True).stdout.strip() == ""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="processes are copied on Linux alone")
@pytest.mark.parametrize(
    ("before", "copied"),
    [
        ("", True),
        ("import numba", False),
        ("threading.Thread(target=threading.Event().wait, daemon=True).start()", False),
        (f"threading.Thread(target=threading.Event().wait, name='{PARENT_WATCH}', daemon=True).start()", True),
    ],
)
def test_processes_are_copies_of_one_that_has_done_nothing_yet(before: str, copied: bool) -> None:
    """Copies know what their parent knew and nothing of how it takes signals, have threads of their own number, and are replaced."""
    code = f"""
import os, signal, sys, threading, types
from tetratrack.core.pipeline.local_processes import LocalProcesses
{before}
sys.modules["known_here"] = types.ModuleType("known_here")
if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: None)
    with LocalProcesses(2, forked=True) as processes:
        processes.start(2)
        questions = ["'known_here' in __import__('sys').modules", "'numba' in __import__('sys').modules",
            "__import__('signal').getsignal(15) == __import__('signal').SIG_DFL", "__import__('numba').get_num_threads()"]
        print(*(answer.result() for answer in processes.submitted([(eval, question) for question in questions])))
        processes.kill()
        print(processes.submitted([(eval, questions[0])])[0].result(), os.cpu_count())
"""
    said = _said_by(code).split()
    assert said[:3] == [str(copied), "True", "True"]
    assert said[3] == str(max(1, int(said[5]) // 2))
    assert said[4] == "False"


def _said_by(code: str, **environment: str) -> str:
    """What a fresh process prints."""
    own = os.environ | dict.fromkeys(LINEAR_ALGEBRA, "1") | environment
    return subprocess.run([sys.executable, "-c", code], env=own, capture_output=True, encoding="utf-8", check=True).stdout.strip()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="processes are copied on Linux alone")
def test_copies_are_made_where_few_of_them_would_be_idle() -> None:
    """An executor makes all its copies at the first call: 24 for two epochs. Without /proc nothing tells whether copies can be made."""
    code = """
import os
from types import SimpleNamespace
from tetratrack.core.pipeline import local_processes
idle, opened = SimpleNamespace(submit=lambda *_: None, shutdown=lambda **_: None), []
local_processes.LocalProcesses._opened = lambda self, method, first_act: opened.append(method) or idle
local_processes.import_module, local_processes._load_libraries = (lambda _: None), (lambda: None)
def start(count):
    with local_processes.LocalProcesses(count, forked=True) as processes:
        processes.start(2)
def no_such_folder(folder):
    raise FileNotFoundError(folder)
start(4)
start(24)
os.listdir = no_such_folder
start(4)
print(*opened)
"""
    assert _said_by(code) == "fork spawn spawn"


def test_a_copy_keeps_the_folder_of_compiled_code(tmp_path: Path) -> None:
    """Where its parent had refused the one that the environment names, because others can write to it, a copy used it."""
    code = """
import numba, os
from tetratrack.core.pipeline import local_processes
local_processes.start_as_worker = lambda *_: None
numba.config.CACHE_DIR, os.environ["NUMBA_NUM_THREADS"] = "", "1"
local_processes._start_as_copy(0, True)
print(repr(numba.config.CACHE_DIR))
"""
    assert _said_by(code, NUMBA_CACHE_DIR=str(tmp_path)) == "''"


@pytest.mark.parametrize(("workers", "scheduler", "count"), [(3, None, 3), (0, None, os.cpu_count()), (3, "tcp://host:8786", 1)])
def test_a_run_has_as_many_processes_as_it_may_use(workers: int, scheduler: str | None, count: int) -> None:
    assert processes_for(workers, scheduler).count == count


def test_one_process_or_one_job_starts_none() -> None:
    before = set(multiprocessing.active_children())
    for count, jobs in ((1, 2), (2, 1)):
        with LocalProcesses(count) as processes:
            processes.start(jobs)
            assert set(multiprocessing.active_children()) <= before


@pytest.mark.parametrize("workers", [1, 2])
def test_an_error_of_a_job_arrives_whole(tmp_path: Path, workers: int) -> None:
    with pytest.raises(InputError, match=r"tile.laz, line 1: is wrong. Mend it.") as caught, JobRunner(tmp_path, workers) as runner:
        runner.run([Square(1), Square(2, trouble="refuse")])
    assert caught.value.where == "line 1"


def test_a_worker_that_is_killed_is_replaced(tmp_path: Path) -> None:
    jobs = [Square(1, str(tmp_path)), Square(2, str(tmp_path), "die"), Square(3, str(tmp_path))]
    with JobRunner(tmp_path, 2) as runner:
        assert _squares(runner.run(jobs)) == [1, 4, 9]


def test_a_job_that_always_kills_its_worker_ends_the_run(tmp_path: Path) -> None:
    with pytest.raises(TetratrackError, match="ended from outside 3 times"), JobRunner(tmp_path, 2) as runner:
        runner.run([Square(1), Square(2, trouble="always die")])


@pytest.mark.parametrize("workers", [1, 2])
def test_cancel(tmp_path: Path, workers: int) -> None:
    with pytest.raises(Cancelled), JobRunner(tmp_path, workers, is_cancelled=lambda: True) as runner:
        runner.run([Square(n) for n in range(5)])


def test_environment_of_workers_is_put_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMP_NUM_THREADS", "7")
    monkeypatch.delenv("MKL_NUM_THREADS", raising=False)
    with JobRunner(tmp_path, 2) as runner:
        runner.run([Square(1), Square(2)])
    assert os.environ["OMP_NUM_THREADS"] == "7"
    assert "MKL_NUM_THREADS" not in os.environ


def test_arrays_that_cannot_be_saved(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="cannot be written"):
        save_arrays(tmp_path / "none" / "a.npz", {"x": np.zeros(3)})
    assert load_arrays(tmp_path / "none.npz") is None


def test_arrays_of_points_are_not_read_where_only_the_table_is_wanted(tmp_path: Path) -> None:
    path = tmp_path / "a.npz"
    save_arrays(path, {"poses": np.arange(3.0), "points": np.full((1000, 3), 7.0)})
    content = bytearray(path.read_bytes())
    content[content.index(np.full(1, 7.0).tobytes()) + 100] ^= 255
    path.write_bytes(content)
    assert load_arrays(path) is None
    table = loaded_arrays(path, without=["points"])
    assert list(table) == ["poses"]
    assert table["poses"].tolist() == [0, 1, 2]
    with pytest.raises(InputError, match="vanished"):
        loaded_arrays(tmp_path / "none.npz")


def _found(places: list[tuple[float, float]], scores: list[float]) -> dict:
    poses = np.zeros((len(places), 12))
    poses[:, :2] = np.reshape(places, (-1, 2))
    return {"poses": poses, "origin": np.array([1000.0, 2000.0, 0.0]), "type": np.zeros(len(places), int), "score": np.array(scores)}


def test_a_unit_on_the_edge_of_two_blocks_is_kept_once() -> None:
    left = (Window(1000, 2000, 1010, 2010), _found([(5, 5), (9.9, 5), (10.2, 8)], [0.9, 0.8, 0.7]))
    right = (Window(1010, 2000, 1020, 2010), _found([(10.1, 5.1), (15, 5)], [0.95, 0.9]))
    # 9.9 and 10.1 are one unit, each in its own block: the better one stays; the unit at 10.2 was found by the left block alone
    kept = owners([left, right], [2.0])
    assert [k.tolist() for k in kept] == [[0, 2], [0, 1]]
    assert [k.tolist() for k in owners([], [2.0])] == []
    empty = (Window(0, 0, 1, 1), _found([], []))
    assert [k.tolist() for k in owners([empty], [2.0])] == [[]]


def test_an_adjustment_that_leaves_the_unit_is_made_anew_with_its_end_disc():
    unit = UnitType.tetrapod(2.7)
    rng = np.random.default_rng(7)
    pose = Pose(np.zeros(3), Rotation.random(random_state=7).as_matrix())
    points, normals, leg = sample_surface(unit, 20000, rng)
    # the upper side of the end of one leg
    seen = (leg == 0) & (points @ unit.leg_directions[0] > 0.42 * unit.height) & ((normals @ pose.rotation.T)[:, 2] > 0.2)
    cloud = pose.to_frame(points[seen][:200]) + rng.normal(0, 0.015, (200, 3))
    options = AdjustmentOptions(radius_sd=0.01 * unit.radius, gradient_sd=0.01)
    with pytest.raises(NoSolutionError, match="too few points"):
        adjust(cloud, unit, pose, options=options)
    result = adjusted_nearby(cloud, unit, pose, options, None)
    assert np.linalg.norm(result.pose.centre) < 0.1 * unit.height
    elsewhere = Pose(np.array([0.0, 0.0, 4.0]), pose.rotation)
    with pytest.raises(NoSolutionError, match="near"):
        adjusted_nearby(cloud, unit, elsewhere, options, None)


def _save_segmented(path: Path, pose: Pose, cloud: np.ndarray) -> None:
    """Result of the segmentation of one unit of which the sides of one leg are seen."""
    one = {name: np.ones(1) for name in ("score", "coverage", "misfit", "supported")}
    one |= {name: np.zeros((1, 4)) for name in LEG_COLUMNS}
    one |= {"twist_open": np.zeros(1, dtype=np.bool_)}
    whole = {"type": np.zeros(1, dtype=np.int64), "legs_visible": np.ones(1, dtype=np.int64), "status": np.array(["found"], dtype="U9")}
    save_arrays(
        path,
        one
        | whole
        | {
            "poses": np.concatenate([pose.centre, pose.rotation.ravel()])[None],
            "origin": np.zeros(3),
            "points": cloud,
            "sources": np.where(cloud[:, 0] < np.median(cloud[:, 0]), 7, 3).astype(np.uint16),
            "offsets": np.array([0, len(cloud)]),
        },
    )


def test_points_that_chance_puts_on_hidden_legs_do_not_settle_a_twist(tmp_path: Path) -> None:
    unit = UnitType.tetrapod(2.3)
    rng = np.random.default_rng(3)
    pose = Pose(np.array([1.0, 2.0, 0.5]), Rotation.random(random_state=3).as_matrix())
    points, _, leg = sample_surface(unit, 8000, rng)
    axial = points @ unit.leg_directions[1]
    shown = (leg == 1) & (axial > 0.25 * unit.height)
    stray = np.flatnonzero(leg == 2)[:5]
    cloud = pose.to_frame(points[np.append(np.flatnonzero(shown), stray)])
    cloud += rng.normal(0, 0.004, cloud.shape)
    _save_segmented(tmp_path / "segment.npz", pose, cloud)
    fitted = FitJob(tmp_path / "segment.npz", (0,), (unit,), ((0.0, 0.0),)).run()
    kept = pose.to_body(fitted["points"])
    assert fitted["legs_visible"].tolist() == [1]
    assert not fitted["determined"][0]
    assert 0.7 * shown.sum() < len(kept) <= shown.sum()
    assert (np.argmax(kept @ unit.leg_directions.T, axis=1) == 1).all()
    assert fitted["offsets"].tolist() == [0, len(kept)]
    assert len(fitted["sources"]) == len(kept)
    assert fitted["source_ids"].tolist() == [3, 7]
    assert fitted["source_offsets"].tolist() == [0, 2]


def test_the_end_of_another_leg_is_kept_with_the_only_leg_whose_sides_are_seen(tmp_path: Path) -> None:
    unit = UnitType.tetrapod(2.3)
    rng = np.random.default_rng(4)
    pose = Pose(np.array([1.0, 2.0, 0.5]), Rotation.random(random_state=4).as_matrix())
    points, normals, leg = sample_surface(unit, 8000, rng)
    along = points @ unit.leg_directions.T
    end = (leg == 2) & (np.sum(normals * unit.leg_directions[2], axis=1) > 0.99)
    shown = (leg == 1) & (along[:, 1] > 0.25 * unit.height) & (along[:, 1] < 0.5 * unit.height)
    cloud = pose.to_frame(points[shown | end])
    _save_segmented(tmp_path / "segment.npz", pose, cloud + rng.normal(0, 0.004, cloud.shape))
    fitted = FitJob(tmp_path / "segment.npz", (0,), (unit,), ((0.0, 0.0),)).run()
    kept = np.argmax(pose.to_body(fitted["points"]) @ unit.leg_directions.T, axis=1)
    assert fitted["legs_visible"].tolist() == [1]
    assert fitted["discs"][0].tolist() == [False, False, True, False]
    # but for its rim
    assert np.count_nonzero(kept == 2) > 0.5 * end.sum()
    assert np.linalg.norm(fitted["poses"][0, :3] + fitted["origin"] - pose.centre) < 0.005


@dataclass(frozen=True)
class Waiting:
    """Ends once a file is there that somebody else writes."""

    number: int
    mark: str

    @property
    def name(self) -> str:
        return f"waiting-{self.number}.npz"

    def run(self) -> dict:
        until = time.monotonic() + 60
        while not Path(self.mark).exists():
            if time.monotonic() > until:
                raise InputError("nobody wrote it", source=Path(self.mark))
            time.sleep(0.01)
        return {"number": np.array(self.number)}


def test_the_caller_works_beside_busy_processes(tmp_path):
    mark = tmp_path / "mark"
    with JobRunner(tmp_path, workers=2) as runner:
        assert len(runner.run([Waiting(k, str(mark)) for k in range(2)], beside=mark.touch)) == 2


def test_the_callers_work_is_not_repeated_with_jobs_that_are_tried_again(tmp_path):
    done: list[int] = []
    with JobRunner(tmp_path, workers=2) as runner:
        runner.run([Square(1), Square(2, str(tmp_path), "die")], beside=lambda: done.append(1))
    assert done == [1]


def test_the_callers_work_comes_first_where_jobs_run_here(tmp_path):
    mark = tmp_path / "mark"
    with JobRunner(tmp_path, workers=1) as runner:
        runner.run([Waiting(0, str(mark))], beside=mark.touch)
        mark.unlink()
        # where everything is done as well
        runner.run([Waiting(0, str(mark))], beside=mark.touch)
        assert mark.exists()


def test_the_callers_work_uses_no_more_cores_than_workers(tmp_path):
    threads: list[int] = []
    with JobRunner(tmp_path, workers=1) as runner:
        runner.run([], beside=lambda: threads.append(numba.get_num_threads()))
    assert threads == [1]


def test_a_fault_of_the_callers_work_ends_the_processes(tmp_path):
    def fault() -> None:
        raise InputError("wrong size", source=tmp_path)

    before = set(multiprocessing.active_children())
    with JobRunner(tmp_path, workers=2) as runner:
        with pytest.raises(InputError, match="wrong size"):
            runner.run([Waiting(k, str(tmp_path / "never")) for k in range(2)], beside=fault)
        assert set(multiprocessing.active_children()) <= before


@pytest.mark.parametrize(("resume", "keep_points", "kept"), [(False, True, True), (False, False, False), (True, True, False)])
def test_points_are_kept_for_those_who_ask_and_vanish_with_the_run(tmp_path: Path, resume: bool, keep_points: bool, kept: bool) -> None:
    options = RunOptions(workers=1, resume=resume)
    with job_runner(tmp_path / "result.gpkg", options, Feedback(), keep_points=keep_points) as runner:
        folder = runner.clouds.folder
        assert (folder is not None) == kept
        assert folder is None or folder.is_dir()
    assert folder is None or not folder.exists()
