"""Joint adjustment: offsets of strips are found, displacements gain, covariances are honest."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from synthetic_units import ALL_DISCS, UNIT, grid_poses, seen_from_above
from tetratrack.core.adjustment.shape_effects import LEG_CELLS
from tetratrack.core.common.kernels import threads_of_kernels
from tetratrack.core.deformation import cast_surfaces, strip_offsets
from tetratrack.core.deformation.joint_records import JointAdjustment, UnitSighting
from tetratrack.core.deformation.streamed_median import StreamedMedian
from tetratrack.core.deformation.strip_observations import Body, kept_share, observations
from tetratrack.core.deformation.strip_offsets import adjust_jointly
from tetratrack.core.deformation.unit_clouds import UnitCloud
from tetratrack.core.model.mould import AXIAL_CELLS, AZIMUTH_CELLS
from tetratrack.core.model.pose import Pose
from tetratrack.core.model.tetrapod import TIP_RATIO, leg_frame, relate, sample_surface
from tetratrack.core.simulation.castings import Casting


def two_epochs(seed: int, spread: float, count: int = 600, noise: float = 0.012) -> tuple[list[UnitSighting], list[np.ndarray]]:
    """Sightings of unmoved units from three strips, each unit seen by two of them as where strips overlap, and the true offsets."""
    rng = np.random.default_rng(seed)
    poses = grid_poses(rng)
    roughness = rng.normal(0, 6, (6, 3))
    offsets = [rng.normal(0, spread, (3, 3)) for _ in range(2)]
    offsets = [o - o.mean(axis=0) for o in offsets]
    sightings = []
    for unit, pose in enumerate(poses):
        for epoch in range(2):
            pair = [unit % 3, (unit + 1 + epoch) % 3] if (unit + 1 + epoch) % 3 != unit % 3 else [unit % 3, (unit + 2) % 3]
            cloud = seen_from_above(pose, rng, count, noise, offsets[epoch][pair], roughness)
            start = pose.perturbed(rng.normal(0, 0.01, 3), rng.normal(0, 0.005, 3))
            sources = np.array(pair)[cloud.sources] + 1
            sightings.append(
                UnitSighting(unit=unit, epoch=epoch, pose=start, cloud=UnitCloud.held(cloud.points, sources), discs=ALL_DISCS, shape=UNIT)
            )
    return sightings, offsets


def displacements(joint: JointAdjustment) -> tuple[np.ndarray, np.ndarray]:
    """Displacements of the centres and their covariances."""
    difference = np.hstack([-np.eye(3), np.zeros((3, 3)), np.eye(3), np.zeros((3, 3))])
    vectors = np.array([joint.poses[b].centre - joint.poses[a].centre for a, b in joint.order.values()])
    return vectors, np.array([difference @ joint.covariances[unit] @ difference.T for unit in joint.order])


def test_offsets_are_found_within_their_deviations() -> None:
    scores = []
    for seed in range(6):
        sightings, offsets = two_epochs(seed, spread=0.012)
        joint = adjust_jointly(sightings)
        for (epoch, source), found in joint.offsets.items():
            error = found - offsets[epoch][source - 1]
            assert np.abs(error).max() < 0.003
            scores += (error / joint.offset_sds[epoch, source]).tolist()
    assert np.sqrt(np.mean(np.square(scores))) < 2


def test_displacements_gain_from_offsets() -> None:
    with_offsets, without = [], []
    for seed in range(3):
        sightings, _ = two_epochs(seed, spread=0.012)
        with_offsets.append(displacements(adjust_jointly(sightings))[0])
        without.append(displacements(adjust_jointly(sightings, offset_sd=0.0))[0])
    assert np.sqrt(np.mean(np.square(with_offsets))) < 0.5 * np.sqrt(np.mean(np.square(without)))


def test_covariances_of_displacements_are_honest() -> None:
    """Roughness that both epochs share does not pass into displacements, and is not counted as noise that averages out."""
    forms = []
    for seed in range(10, 16):
        joint = adjust_jointly(two_epochs(seed, spread=0.008)[0])
        vectors, covariances = displacements(joint)
        forms += [float(v @ np.linalg.solve(c, v)) / 3 for v, c in zip(vectors, covariances, strict=True)]
    assert 0.6 < np.mean(forms) < 1.5


def castings(seed: int, count: int) -> tuple[list[Pose], JointAdjustment]:
    """Sixteen castings seen from above once, from two strips and with little noise, and their joint adjustment."""
    rng = np.random.default_rng(seed)
    poses, sightings = grid_poses(rng), []
    for unit, pose in enumerate(poses):
        cloud = seen_from_above(pose, rng, count, 0.002)
        body = pose.to_body(cloud.points)
        relation = relate(body, UNIT)
        lifted = body + Casting.drawn(UNIT.height, rng).deviation(body, UNIT)[:, None] * relation.normal
        start = pose.perturbed(rng.normal(0, 0.003, 3), rng.normal(0, 0.003, 3))
        held = UnitCloud.held(pose.to_frame(lifted), rng.integers(1, 3, len(lifted)))
        sightings.append(UnitSighting(unit=unit, epoch=0, pose=start, cloud=held, discs=ALL_DISCS, shape=UNIT))
    return poses, adjust_jointly(sightings)


def test_the_density_of_a_cloud_does_not_make_a_casting_surer_than_its_shape_allows() -> None:
    """Legs that lean make slopes within cells, of which a dense cloud has many points: they tell of the casting as well as of its pose.

    What noise alone would leave shrinks with the number of points.
    """
    sds, forms, noises = [], [], []
    for count in (1000, 16000):
        poses, joint = castings(3, count)
        turns = [Rotation.from_matrix(found.rotation @ true.rotation.T).as_rotvec() for found, true in zip(joint.poses, poses, strict=True)]
        spreads = [joint.covariances[unit][3:, 3:] for unit in range(len(poses))]
        sds.append(np.median([np.sqrt(np.trace(c)) for c in spreads]))
        forms.append(np.median([t @ np.linalg.solve(c, t) / 3 for t, c in zip(turns, spreads, strict=True)]))
        parts = [joint.noise_covariances[unit] for unit in range(len(poses))]
        noises.append(np.median([np.trace(part[:3, :3]) for part in parts]))
        assert all(np.linalg.eigvalsh(joint.covariances[k] - part).min() > -1e-12 for k, part in enumerate(parts))
    assert sds[1] > 0.8 * sds[0]
    assert max(forms) < 2.0
    assert noises[1] == pytest.approx(noises[0] / 16, rel=0.2)


def test_the_end_of_a_short_leg_is_seen_where_it_is() -> None:
    """All of an end disc 20 mm below the nominal one is of the disc, not only the points that noise lifts up to it."""
    body = sample_surface(UNIT, 60000, np.random.default_rng(4))[0]
    lean = body @ UNIT.leg_directions.T
    # nearer to the axis than any point of a side
    inner = np.linalg.norm(body, axis=1) ** 2 - lean.max(axis=1) ** 2 < (0.8 * UNIT.end_radius) ** 2
    short = body[inner] - 0.02 * UNIT.leg_directions[lean.argmax(axis=1)[inner]]
    across = np.stack(leg_frame(UNIT))
    unit = Body(np.zeros(3), np.eye(3), UNIT.leg_directions, across, ALL_DISCS, UNIT.radius, UNIT.gradient, UNIT.leg_length)
    strips = np.zeros(len(short), dtype=np.int64)
    seen = observations(short, strips, np.zeros((1, 3)), unit, margin=0.005, tip=TIP_RATIO * UNIT.leg_length)
    assert (np.bincount(lean.argmax(axis=1)[inner]) > 500).all()
    assert (seen.patches % LEG_CELLS >= AXIAL_CELLS * AZIMUTH_CELLS).all()
    assert np.allclose(seen.residuals, -0.02, atol=1e-9)


def test_patches_of_few_points_among_full_ones_are_left_out() -> None:
    """Where a shadow begins little is seen of the unit itself; where all patches hold few none is thin."""
    body = sample_surface(UNIT, 60000, np.random.default_rng(5), end_discs=False)[0]
    upper = body[body[:, 2] > 0.1]
    across = np.stack(leg_frame(UNIT))
    unit = Body(np.zeros(3), np.eye(3), UNIT.leg_directions, across, ALL_DISCS, UNIT.radius, UNIT.gradient, UNIT.leg_length)

    def patches(points: np.ndarray) -> np.ndarray:
        strips = np.zeros(len(points), dtype=np.int64)
        return observations(points, strips, np.zeros((1, 3)), unit, margin=0.005, tip=TIP_RATIO * UNIT.leg_length).patches

    full = patches(upper)
    chosen = np.unique(full[full >= 0], return_counts=True)
    rich = chosen[0][chosen[1] > np.median(chosen[1])][:3]
    hidden = np.isin(full, rich)
    few = hidden & (np.arange(len(full)) % 40 == 0)
    kept = patches(upper[~hidden | few])
    assert not np.isin(kept, rich).any()
    assert len(np.unique(kept[kept >= 0])) >= 0.9 * (len(chosen[0]) - 3)
    sparse = patches(upper[::400])
    assert np.count_nonzero(sparse >= 0) > 0.9 * np.count_nonzero(full >= 0) / 400


def test_noise_is_estimated_by_epoch() -> None:
    joint = adjust_jointly(two_epochs(1, spread=0.0, noise=0.01)[0])
    assert joint.noise == pytest.approx([0.01, 0.01], rel=0.1)


def test_moved_unit_keeps_its_motion() -> None:
    sightings, _ = two_epochs(2, spread=0.01)
    moved = sightings[5]
    shift = np.array([0.05, -0.02, 0.01])
    points, sources = moved.cloud.read()
    cloud = UnitCloud.held(points + shift, sources)
    sightings[5] = UnitSighting(
        unit=moved.unit, epoch=moved.epoch, pose=moved.pose.shifted(shift), cloud=cloud, discs=moved.discs, shape=moved.shape
    )
    vectors, _ = displacements(adjust_jointly(sightings))
    assert np.allclose(vectors[2], shift, atol=0.006)
    assert np.linalg.norm(np.delete(vectors, 2, axis=0), axis=1).max() < 0.01


def test_one_epoch_and_nothing() -> None:
    sightings = [s for s in two_epochs(3, spread=0.01)[0] if s.epoch == 0]
    joint = adjust_jointly(sightings)
    assert len(joint.poses) == 16
    assert joint.covariances[0].shape == (6, 6)
    assert adjust_jointly([]).poses == ()


def test_poses_of_an_undetermined_unit_do_not_spoil_the_rest() -> None:
    """A unit of which only a patch of one leg is seen has a large covariance, not a wrong small one."""
    sightings, _ = two_epochs(4, spread=0.01)
    first = sightings[0]
    points, sources = first.cloud.read()
    along = first.pose.to_body(points) @ UNIT.leg_directions.T
    leg = int(np.argmax(np.bincount(np.argmax(along, axis=1))))
    near = (np.argmax(along, axis=1) == leg) & (along[:, leg] < 1.2)
    sightings[0] = UnitSighting(
        unit=0, epoch=0, pose=first.pose, cloud=UnitCloud.held(points[near], sources[near]), discs=np.zeros(4, dtype=np.bool_), shape=UNIT
    )
    joint = adjust_jointly(sightings)
    assert np.sqrt(np.diag(joint.covariances[0]))[:6].max() > 10 * np.sqrt(np.diag(joint.covariances[1]))[:6].max()
    vectors, _ = displacements(joint)
    assert np.linalg.norm(vectors[1:], axis=1).max() < 0.01


def test_memory_does_not_grow_with_the_points_of_more_units(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(strip_offsets, "StreamedMedian", partial(StreamedMedian, most_held=1000))
    count = 4000
    some = [s for s in two_epochs(5, spread=0.01, count=count)[0] if s.epoch == 0]

    def peak(units: int) -> int:
        """Bytes needed for units whose points are made anew whenever they are read."""
        sightings = []
        for unit in range(units):
            own = some[unit % len(some)]
            points, sources = own.cloud.read()
            read = lambda points=points, sources=sources: (points.copy(), sources)  # noqa: E731
            sightings.append(
                UnitSighting(unit=unit, epoch=0, pose=own.pose, cloud=UnitCloud(np.unique(sources), read), discs=own.discs, shape=own.shape)
            )
        tracemalloc.start()
        # with more threads the peak hangs on how many units they happen to be at
        with threads_of_kernels(1):
            adjust_jointly(sightings)
        try:
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    # the surface is learned from the same number of units in both
    monkeypatch.setattr(cast_surfaces, "SAMPLE_UNITS", 8)
    peak(2)
    few, many = peak(16), peak(64)
    assert (many - few) / 48 < 0.1 * count * 3 * 8


def test_medians_of_what_does_not_fit_into_memory_give_the_same_adjustment(monkeypatch: pytest.MonkeyPatch) -> None:
    sightings, _ = two_epochs(6, spread=0.01)
    whole = adjust_jointly(sightings)
    monkeypatch.setattr(strip_offsets, "StreamedMedian", partial(StreamedMedian, most_held=100))
    parts = adjust_jointly(sightings)
    assert parts.noise.tolist() == whole.noise.tolist()
    assert parts.surface_sd == whole.surface_sd
    assert all(np.array_equal(a.centre, b.centre) for a, b in zip(whole.poses, parts.poses, strict=True))


def drifting(seed: int, drift: float) -> tuple[list[UnitSighting], np.ndarray]:
    """Resting units along 40 m from two strips in two epochs; the second strip of the later one drifts by ``drift`` metres on the way."""
    rng = np.random.default_rng(seed)
    step, count = 1.3 * UNIT.height, 24
    places = [np.array([0.5 * k * step, (k % 2) * step, 0.0]) for k in range(count)]
    sightings = []
    for unit, place in enumerate(places):
        pose = grid_poses(rng, side=1)[0].shifted(place)
        for epoch in range(2):
            along = place[0] / places[-1][0] - 0.5
            offsets = np.array([[0.0, 0, 0], [drift * along, -drift * along, drift * along]]) * epoch
            cloud = seen_from_above(pose, rng, 500, 0.01, offsets)
            start = pose.perturbed(rng.normal(0, 0.005, 3), rng.normal(0, 0.003, 3))
            sightings.append(
                UnitSighting(
                    unit=unit, epoch=epoch, pose=start, cloud=UnitCloud.held(cloud.points, cloud.sources + 1), discs=ALL_DISCS, shape=UNIT
                )
            )
    return sightings, np.array(places)


def test_a_strip_that_drifts_is_straightened() -> None:
    """What both strips do alike belongs to the frame; half the drift of one is common, half tells it from the other."""
    sightings, places = drifting(1, 0.05)
    joint = adjust_jointly(sightings)
    assert joint.drifts is not None
    along = places[:, 0] / places[-1, 0] - 0.5
    found = np.array([joint.offsets_of(unit, 1, np.array([1, 2])) for unit in joint.order])
    apart = (found[:, 1] - found[:, 0]) - 0.05 * along[:, None] * np.array([1.0, -1.0, 1.0])
    assert np.sqrt(np.mean((apart - apart.mean(axis=0)) ** 2)) < 0.003
    vectors, covariances = displacements(joint)
    common = 0.025 * along[:, None] * np.array([1.0, -1.0, 1.0])
    error = vectors - common
    error -= error.mean(axis=0)
    assert np.sqrt(np.mean(error**2)) < 0.002
    assert np.mean(error**2 / np.einsum("nii->ni", covariances)) < 2.5


def test_points_are_looked_at_once_for_a_noise_that_is_about_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many they are: once for each step and each estimate of the noise, and once more for the first estimate alone."""
    monkeypatch.setattr(strip_offsets, "StreamedMedian", partial(StreamedMedian, most_held=2000))
    sightings, _ = two_epochs(6, spread=0.001)
    times = []
    read = sightings[0].cloud.read
    sightings[0] = replace(sightings[0], cloud=UnitCloud(sightings[0].cloud.ids, lambda: (times.append(1), read())[1]))
    adjust_jointly(sightings)
    assert len(times) <= strip_offsets.MAX_ITERATIONS + 4 + 1


def test_stiff_strips_stay_stiff() -> None:
    assert adjust_jointly(drifting(2, 0.0)[0]).drifts is None


@pytest.mark.parametrize("limit", [3.0, 4.685, 8.0])
def test_weighted_means_keep_as_much_of_a_departure_as_is_said(limit: float) -> None:
    points = np.random.default_rng(5).normal(0.1, 1.0, 2_000_000)
    weights = np.clip(1 - (points / limit) ** 2, 0, None) ** 2
    assert np.sum(weights * points) / np.sum(weights) / 0.1 == pytest.approx(kept_share(limit), abs=0.02)
