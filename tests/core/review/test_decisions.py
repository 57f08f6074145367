"""Decisions in the result file without QGIS: the store, several processes, undo, rows typed by hand, and the point index."""

from __future__ import annotations

import multiprocessing
import os
import sqlite3
from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from synthetic_result import GRADIENT, HEIGHT, LEG_LENGTH, LEGS, RADIUS, run_again, write_points, write_result
from tetratrack.core.common.errors import InputError, OutputError
from tetratrack.core.model.outline import PlacedShape, end_discs, reach, rotation_of_quaternion, section, silhouette
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import relate
from tetratrack.core.model.unit_types import UnitType
from tetratrack.core.results import result_access
from tetratrack.core.results.geopackage_reader import EpochPair, decode_geometry, encode_line, encode_point, epoch_pairs, read_layer_rows
from tetratrack.core.results.result_access import reading
from tetratrack.core.results.unit_rows import EpochInfo, check_comparisons, read_details, read_epochs, read_unit_rows, series, unit_sizes
from tetratrack.core.results.unit_sizes import shape_of, size_of, unit_of
from tetratrack.core.review.basis import Basis, bases
from tetratrack.core.review.decisions import confirm, decide, prepare, read_history, read_reviews, undo
from tetratrack.core.review.point_index import PointIndex, index_folder, write_index
from tetratrack.plugin.review_store import ReviewStore

PAIR = EpochPair("2023-04-09", "2024-04-09")


@pytest.fixture
def result(tmp_path: Path) -> Path:
    path = tmp_path / "result.gpkg"
    write_result(path, 40)
    return path


def _decide_many(path: str, who: str, units: list[str]) -> None:
    for unit in units:
        decide(Path(path), [unit], PAIR, "accepted", comment=who, reviewer=who)


def test_processes_writing_at_once_lose_nothing(result: Path) -> None:
    units = [f"U{k:05d}" for k in range(1, 31)]
    context = multiprocessing.get_context("spawn")
    writers = [context.Process(target=_decide_many, args=(str(result), who, units)) for who in ("A", "B", "C")]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join(120)
        assert writer.exitcode == 0
    events = read_history(result)
    assert len(events) == 90
    for who in ("A", "B", "C"):
        assert [event.unit_id for event in events if event.reviewer == who] == units
    assert len(read_reviews(result)) == 30


def test_a_crash_in_the_middle_of_a_decision_leaves_the_file_as_it_was(result: Path) -> None:
    decide(result, ["U00001"], PAIR, "accepted", comment="", reviewer="A")

    class Broken(Exception):
        pass

    def units() -> object:
        yield "U00002"
        raise Broken

    with pytest.raises(Broken):
        decide(result, units(), PAIR, "rejected", comment="", reviewer="A")  # type: ignore[arg-type]
    assert [unit for unit, _ in read_reviews(result)] == ["U00001"]
    assert len(read_history(result)) == 1


def test_undo_of_an_older_act_keeps_what_others_did_since(result: Path) -> None:
    (first,) = decide(result, ["U00001"], PAIR, "rejected", comment="", reviewer="A")
    decide(result, ["U00001"], PAIR, "accepted", comment="seen on site", reviewer="B")
    undo(result, [first], reviewer="A")
    assert read_reviews(result)["U00001", PAIR].reviewer == "B"
    with pytest.raises(InputError, match="not yours to undo, or is undone"):
        undo(result, [first], reviewer="A")


def test_nobody_undoes_or_confirms_the_wrong_act(result: Path) -> None:
    (number,) = decide(result, ["U00001"], PAIR, "rejected", comment="", reviewer="Anna")
    with pytest.raises(InputError, match="not yours"):
        undo(result, [number], reviewer="Ben")
    with pytest.raises(InputError, match="second reviewer"):
        confirm(result, "U00001", PAIR, reviewer="ANNA")
    with pytest.raises(InputError, match="no decision"):
        confirm(result, "U00002", PAIR, reviewer="Ben")
    confirm(result, "U00001", PAIR, reviewer="Ben")
    assert read_reviews(result)["U00001", PAIR].confirmed_by == "Ben"
    decide(result, ["U00001"], PAIR, "accepted", comment="", reviewer="Anna")
    assert read_reviews(result)["U00001", PAIR].confirmed_by == "", "a new decision has to be confirmed anew"


def test_a_row_typed_into_reviews_by_hand_is_kept_in_the_history(result: Path) -> None:
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute(
            "INSERT INTO reviews (unit_id, epoch_from, epoch_to, decision, comment, reviewer) "
            "VALUES (?, ?, ?, 'inspect', 'by hand', 'Carl')",
            ("U00003", PAIR.epoch_from, PAIR.epoch_to),
        )
    (number,) = decide(result, ["U00003"], PAIR, "accepted", comment="", reviewer="A")
    undo(result, [number], reviewer="A")
    review = read_reviews(result)["U00003", PAIR]
    assert (review.decision, review.comment, review.reviewer) == ("inspect", "by hand", "Carl")


def test_read_only_file_takes_no_decision(result: Path) -> None:
    result.chmod(0o444)
    with pytest.raises(OutputError, match="read-only"):
        decide(result, ["U00001"], PAIR, "accepted", comment="", reviewer="A")
    store = ReviewStore(result)
    assert not store.writable
    assert len(store.rows) > 30


def test_file_that_is_no_result_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        ReviewStore(tmp_path / "none.gpkg")
    other = tmp_path / "other.gpkg"
    with closing(sqlite3.connect(other)) as connection, connection:
        connection.execute("CREATE TABLE cats (name TEXT)")
    with pytest.raises(InputError, match="has no layer units"):
        ReviewStore(other)


def test_store_steps_in_order_and_skips_decided_units(result: Path) -> None:
    store = ReviewStore(result)
    store.sort("unit_id", False)
    told: list[str] = []
    store.observe(told.append)
    assert store.step(1) == "U00001"
    store.decide("accepted", reviewer="A")
    store.step(1)
    store.step(-1, undecided=True)
    assert store.current == "U00002", "nothing undecided lies before"
    assert told == ["selection", "reviews", "selection"]
    store.set_filter(undecided=True)
    assert store.place_of("U00001") is None
    assert store.statistics().decided == 1


def test_area_is_even_odd(result: Path) -> None:
    store = ReviewStore(result)
    places = np.array([row.place for row in store.rows if row.place is not None])
    low, high = places.min(axis=0)[:2] - 1, places.max(axis=0)[:2] + 1
    outer = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    hole = np.mean(outer, axis=0) + (outer - np.mean(outer, axis=0)) * 0.5
    store.set_filter(area=(outer, hole))
    shown = {store.shown(k).unit_id for k in range(len(store.order))}
    inside = {
        row.unit_id
        for row in store.rows
        if row.place is not None and not ((row.place[:2] > hole.min(axis=0)) & (row.place[:2] < hole.max(axis=0))).all()
    }
    assert shown == inside
    assert 0 < len(shown) < len(store.rows)


def test_series_and_checks_follow_from_the_rows(result: Path) -> None:
    units = {row.unit_id: row for row in read_unit_rows(result, PAIR, "stable")}
    moved = next(row for row in units.values() if row.kind == "moved")
    details = read_details(result, moved.unit_id, unit_sizes(read_epochs(result)))
    line = series(details, read_epochs(result), "stable")
    assert [point.epoch for point in line] == ["2023-04-09", "2024-04-09", "2025-04-09"]
    assert line[1].d_3d == pytest.approx(moved.d_3d)
    assert line[1].sd == pytest.approx(moved.sd_3d)
    residuals = {(r["point_id"], r["epoch"]): np.array([r["de"], r["dn"], r["dh"]]) for r in read_layer_rows(result, "check_residuals")}
    check = check_comparisons(read_details(result, "U00001"), PAIR)[0]
    features = read_details(result, "U00001").features
    fitted = features[PAIR.epoch_to]["f123"][0] - features[PAIR.epoch_from]["f123"][0]
    surveyed = fitted - (residuals["K1", PAIR.epoch_to] - residuals["K1", PAIR.epoch_from])
    assert check.measured == pytest.approx(np.linalg.norm(surveyed))
    assert check.difference == pytest.approx(np.linalg.norm(fitted) - np.linalg.norm(surveyed))


def test_pairs_are_consecutive_first(result: Path) -> None:
    assert [str(pair) for pair in epoch_pairs(result)] == ["2023-04-09 → 2024-04-09", "2024-04-09 → 2025-04-09", "2023-04-09 → 2025-04-09"]


def test_geometry_survives_the_geopackage_binary() -> None:
    point = np.array([236500.123456, 4285150.654321, -3.25])
    np.testing.assert_array_equal(decode_geometry(encode_point(5186, point)), point)
    line = np.array([point, point + 0.01])
    np.testing.assert_array_equal(decode_geometry(encode_line(5186, line)), line)
    assert decode_geometry(None) is None


def test_outlines_lie_on_the_surface_of_the_solid() -> None:
    unit = UnitType.tetrapod(HEIGHT, radius=RADIUS, gradient=GRADIENT, leg_length=LEG_LENGTH)
    quaternion = np.array([0.3, -0.4, 0.1, 0.8]) / np.linalg.norm([0.3, -0.4, 0.1, 0.8])
    rotation = rotation_of_quaternion(quaternion)
    np.testing.assert_allclose(rotation, Pose.from_quaternion(np.zeros(3), quaternion).rotation, atol=1e-12)
    shape = PlacedShape(centre=np.zeros(3), rotation=rotation, radius=RADIUS, gradient=GRADIENT, leg_length=LEG_LENGTH, legs=LEGS)
    rng = np.random.default_rng(0)
    directions = rng.normal(size=(500, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    surface = directions * reach(directions, shape)[:, None]
    np.testing.assert_allclose(relate(surface @ rotation, unit).distance, 0, atol=1e-5)
    right, up = np.array([1.0, 0, 0]), np.array([0, 0, 1.0])
    curve = section(shape, right, up) @ np.vstack([right, up])
    np.testing.assert_allclose(relate(curve @ rotation, unit).distance, 0, atol=1e-5)
    outline = silhouette(shape, right, up)
    flat = surface @ np.vstack([right, up]).T
    angle = np.arctan2(outline[:-1, 1], outline[:-1, 0])
    order = np.argsort(angle)
    bound = np.interp(np.arctan2(flat[:, 1], flat[:, 0]), angle[order], np.linalg.norm(outline[:-1], axis=1)[order], period=2 * np.pi)
    assert np.all(np.linalg.norm(flat, axis=1) <= bound + 0.02 * HEIGHT)
    for disc in end_discs(shape, right, up):
        assert np.linalg.norm(disc, axis=1).max() <= np.hypot(LEG_LENGTH, unit.end_radius) + 1e-9


def test_every_type_of_unit_keeps_its_own_size() -> None:
    def info(settings: dict[str, Any]) -> EpochInfo:
        return EpochInfo(label="a", time=None, points=None, sigma0=None, software="", settings=settings, transformation={}, tiles="")

    def row(name: str, height: float) -> dict[str, Any]:
        pose = {"geom": np.zeros(3), "qx": 0.0, "qy": 0.0, "qz": 0.0, "qw": 1.0}
        return {"unit_type": name, "height": height, "r0": 0.26 * height, "gradient": 0.17} | pose

    types = [UnitType.tetrapod(2.3, leg_length=1.5, name="tetrapod"), UnitType.tetrapod(1.6, leg_length=1.1, name="tetrapod")]
    types += [UnitType.tetrapod(3.0, opening="paper", name="tetrapod 20 t")]
    sizes = unit_sizes([info({}), info({"leg_length": 1.5, "unit": ["1", "2", "3"], "unit_types": [asdict(t) for t in types]})])
    for kind in types:
        shape, unit = shape_of(row(kind.name, kind.height), sizes), unit_of(row(kind.name, kind.height), sizes)
        assert (shape.leg_length, unit.leg_length, unit.opening, unit.height) == (kind.leg_length,) * 2 + (kind.opening, kind.height)
        np.testing.assert_allclose(shape.legs, kind.leg_directions, atol=1e-12)
    # of a type that is not recorded, and in results of earlier versions with several types, the proportions are standard
    earlier = unit_sizes([info({"leg_length": 1.5, "unit": ["1", "2"]})])
    for known in (sizes, earlier):
        assert size_of(row("tetrapod 8 t", 2.0), known).leg_length == pytest.approx(0.644 * 2.0)
    assert size_of(row("tetrapod", 2.3), unit_sizes([info({"leg_length": 1.5, "unit": ["1"]})])).leg_length == 1.5


def test_point_index_gives_exactly_the_points_of_a_cube(tmp_path: Path) -> None:
    rng = np.random.default_rng(2)
    corner = np.array([612_000.0, 3_456_000.0, 0.0])
    # coordinates on a millimetre grid and faces between grid values: no point lies on a face
    centres = np.round(rng.uniform([0, 0, 0], [60, 40, 6], (30, 3)), 3) + corner
    clouds = [np.round(rng.uniform([0, 0, -2], [60, 40, 8], (20_000, 3)), 3) + corner for _ in range(3)]
    tiles = [("a", "1", clouds[0]), ("a", "2", clouds[1]), ("b", "1", clouds[2])]
    folder = index_folder(tmp_path / "r.gpkg")
    write_index(folder, tiles, centres, 3.0)
    index = PointIndex(folder)
    assert index.epochs == ("a", "b")
    for centre in centres:
        for epoch, cloud in (("a", np.vstack(clouds[:2])), ("b", clouds[2])):
            found = np.round(index.read(epoch, centre, 2.5005) - corner, 3)
            inside = np.round(cloud[np.all(np.abs(cloud - centre) <= 2.5005, axis=1)] - corner, 3)
            assert len(inside) > 20
            np.testing.assert_allclose(found[np.lexsort(found.T)], inside[np.lexsort(inside.T)], atol=1e-6)
    assert index.read("none", centres[0], 2.0).shape == (0, 3)
    assert index.read("b", centres[0] + 1000, 2.0).shape == (0, 3)


def test_point_index_of_a_long_coast_keeps_all_points(tmp_path: Path) -> None:
    """Tiles, and the sensor and its points, 300 km apart: more than 32 bits hold about one origin."""
    rng = np.random.default_rng(5)
    centres = np.array([[500_000.0, 4_000_000.0, 0.0], [500_200.0, 4_300_000.0, 5.0]])
    clouds = [np.round(rng.uniform(-2, 2, (500, 3)), 3) + centre for centre in centres]
    sensor = centres[0] + np.array([150.0, -150_000.0, 600.0])
    tiles = [("a", "1", np.hstack([clouds[0], np.tile(sensor, (500, 1))])), ("b", "1", clouds[1])]
    folder = tmp_path / "r.points"
    assert write_index(folder, tiles, centres, 2.5, noise={"a": (0.02, 1e-4)}) == 1000
    index = PointIndex(folder)
    for label, cloud, centre in zip(("a", "b"), clouds, centres, strict=True):
        found = index.read(label, centre, 3.0)
        np.testing.assert_allclose(found[np.lexsort(found.round(3).T)], cloud[np.lexsort(cloud.T)], atol=1e-4)
    np.testing.assert_allclose(index.read_with_sensors("a", centres[0], 3.0)[1], np.tile(sensor, (500, 1)), atol=1e-4)
    farther = np.array([0, 200_000.0, 0])
    both = np.vstack([clouds[0], clouds[1] + farther])
    with pytest.raises(InputError, match=r"tile 7\.laz: points.* 250 km from the middle"):
        write_index(folder, [("a", "tile 7.laz", both)], np.vstack([centres, centres + farther]), 2.5)
    assert PointIndex(folder).epochs == ("a", "b"), "the index that was there stays"


def test_missing_or_foreign_index_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no point index"):
        PointIndex(tmp_path)
    for content in ("[]", "{", '{"version": 3}'):
        (tmp_path / "index.json").write_text(content, encoding="utf-8")
        with pytest.raises(InputError, match="is no point index"):
            PointIndex(tmp_path)
    (tmp_path / "index.json").write_text('{"version": 2, "origin": [0, 0, 0], "cell": 1.0, "epochs": {}}', encoding="utf-8")
    with pytest.raises(InputError, match="of version 2, not 3"):
        PointIndex(tmp_path)


def test_an_index_built_anew_is_taken_up_and_no_file_stays_open(tmp_path: Path) -> None:
    folder, place = tmp_path / "r.points", np.array([100.0, 200.0, 3.0])
    for tiles in (1, 2):
        clouds = [("a", str(k), place + np.random.default_rng(k).uniform(-1, 1, (50, 3))) for k in range(tiles)]
        write_index(folder, clouds, place[None], 2.0)
        if tiles == 1:
            index = PointIndex(folder)
        assert len(index.read("a", place, 1.5)) == 50 * tiles
    maps = Path("/proc/self/maps")
    if maps.is_file():
        assert str(folder) not in maps.read_text()
    assert [p.name for p in tmp_path.iterdir()] == ["r.points"]


def test_an_index_that_cannot_take_its_place_leaves_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder, place = tmp_path / "r.points", np.array([100.0, 200.0, 3.0])
    write_index(folder, [("a", "1", place[None])], place[None], 2.0)
    rename = os.replace

    def locked(source: Path, target: Path) -> None:
        if target == folder and not str(source).endswith(".old"):
            raise PermissionError(13, "Access is denied")
        rename(source, target)

    monkeypatch.setattr(os, "replace", locked)
    with pytest.raises(OutputError, match="Access is denied"):
        write_index(folder, [("b", "1", place[None])], place[None], 2.0)
    monkeypatch.undo()
    assert PointIndex(folder).epochs == ("a",)
    assert [p.name for p in tmp_path.iterdir()] == ["r.points"]


def test_index_is_replaced_whole(tmp_path: Path) -> None:
    path = tmp_path / "result.gpkg"
    units = write_result(path, 12)
    write_points(path, units)
    before = PointIndex(index_folder(path)).read("2023-04-09", units[0].centres[0], 1.5)

    def broken() -> object:
        yield "2023-04-09", "1", before
        raise OSError(28, "No space left on device")

    with pytest.raises(OutputError, match="No space left"):
        write_index(index_folder(path), broken(), before[:1], 1.5)  # type: ignore[arg-type]
    after = PointIndex(index_folder(path)).read("2023-04-09", units[0].centres[0], 1.5)
    np.testing.assert_array_equal(before, after)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["result.gpkg", "result.points"]


def test_refresh_takes_in_what_another_process_wrote_and_is_quiet_otherwise(result: Path) -> None:
    store = ReviewStore(result)
    store.refresh()
    told: list[str] = []
    store.observe(told.append)
    assert not store.refresh()
    decide(result, ["U00004"], PAIR, "inspect", comment="", reviewer="B")
    assert store.refresh()
    assert store.reviews["U00004", PAIR].reviewer == "B"
    assert not store.refresh()
    assert told == ["reviews"]


MOVE_EAST = "UPDATE displacements SET de = de + ? WHERE unit_id = ?"


def _add_east(result: Path, unit: str, by: float) -> None:
    """Change displacements of a unit as another program would."""
    with closing(sqlite3.connect(result)) as connection, connection:
        connection.execute(MOVE_EAST, (by, unit))


def test_what_a_run_replaced_is_taken_in(result: Path) -> None:
    store = ReviewStore(result)
    store.refresh()
    unit = store.shown(0).unit_id
    before = store.row(unit)
    store.select([unit])
    told: list[str] = []
    store.observe(told.append)
    run_again(result, MOVE_EAST, 0.5, unit)
    assert store.refresh() == "run"
    assert store.row(unit).vector[0] == pytest.approx(before.vector[0] + 0.5)
    assert (store.selected, told) == ((unit,), ["rows"])
    store.decide("accepted", reviewer="A")
    assert not store.refresh()


def test_epochs_that_a_run_added_or_left_out_can_be_compared_or_not(result: Path) -> None:
    write_result(result.with_name("more.gpkg"), 40, 4)
    store = ReviewStore(result.with_name("more.gpkg"))
    gone = store.pair
    run_again(store.path, "DELETE FROM velocities", other=result)
    assert store.refresh() == "run"
    assert gone not in store.pairs
    assert store.pair in store.pairs
    assert [info.label for info in store.epochs] == ["2023-04-09", "2024-04-09", "2025-04-09"]


def test_nobody_decides_on_numbers_that_are_not_shown(result: Path) -> None:
    store = ReviewStore(result)
    store.set_pair(PAIR)
    unit, other = (store.shown(k).unit_id for k in range(2))
    decide(result, [other], PAIR, "accepted", comment="", reviewer="B")
    old = store.row(unit).vector[0]
    _add_east(result, unit, 0.5)
    store.select([other, unit])
    with pytest.raises(InputError, match=f"unit {unit}: now has other numbers"):
        store.decide("accepted", reviewer="A")
    assert [event.reviewer for event in read_history(result)] == ["B"], "all or nothing"
    assert store.row(unit).vector[0] == pytest.approx(old + 0.5), "what the file holds is shown"
    store.decide("accepted", reviewer="A")
    assert read_history(result, unit)[-1].basis.displacements["stable"][0] == pytest.approx(old + 0.5)


def test_nobody_confirms_numbers_that_are_not_shown(result: Path) -> None:
    store = ReviewStore(result)
    store.set_pair(PAIR)
    unit = store.shown(0).unit_id
    _add_east(result, unit, 0.5)
    decide(result, [unit], PAIR, "accepted", comment="", reviewer="B")
    store.select([unit])
    with pytest.raises(InputError, match="now has other numbers"):
        store.confirm(reviewer="A")
    store.confirm(reviewer="A")
    assert read_reviews(result)[unit, PAIR].confirmed_by == "A"


def test_what_could_not_be_read_is_read_at_the_next_look(result: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = ReviewStore(result)
    store.refresh()
    unit = store.rows[0].unit_id
    decide(result, [unit], store.pair, "rejected", comment="", reviewer="B")
    monkeypatch.setattr(result_access, "BUSY_SECONDS", 0.05)
    with closing(sqlite3.connect(result, isolation_level=None)) as held:
        held.execute("BEGIN EXCLUSIVE")
        with pytest.raises(OutputError, match="being written by another program"):
            store.refresh()
        held.execute("ROLLBACK")
    assert store.refresh() == "decisions"
    assert store.review(unit).reviewer == "B"


def test_the_numbers_of_one_pair_cost_no_look_at_the_others(tmp_path: Path) -> None:
    path = tmp_path / "long.gpkg"
    write_result(path, 40, 6)
    prepare(path)
    pairs = epoch_pairs(path)

    def looked_up(wanted: list[EpochPair]) -> tuple[dict[tuple[str, EpochPair], Basis], int]:
        steps = []
        with reading(path) as connection:
            connection.set_progress_handler(lambda: steps.append(1), 100)
            return bases(connection, wanted), len(steps)

    (every, all_steps), (found, steps) = looked_up(pairs), looked_up(pairs[:1])
    assert found == {key: basis for key, basis in every.items() if key[1] == pairs[0]}
    assert any(basis.displacements for basis in found.values())
    assert steps < all_steps / 3
