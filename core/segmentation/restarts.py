"""Poses in doubt, begun anew from poses around them: in noise the few elements of a unit that hardly shows hold it in several places."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from ..common.arrays import BoolArray, FloatArray, IntArray
from .pose_evidence import evidence
from .pose_refinement import refine
from .scene import Evidence, Scene
from .twist import log_likelihood

STARTS, START_SD, START_TURN = 24, 0.04, np.radians(6.0)
"""Of a pose: how many, and standard deviations of their shifts, as a share of the height, and of their turns about each axis, radians."""

MARGIN = 6.0
"""Log-likelihood by which another place must beat the one that was found: each of six unknowns fitted to chance gains some. What gains
less is rock as often as a unit."""


def begun_anew(
    poses: FloatArray, found: Evidence, doubted: BoolArray, scene: Scene, owner: IntArray, contested: BoolArray, seed: int
) -> tuple[FloatArray, Evidence]:
    """Poses (k, 12) with those in doubt where their elements are likeliest, of all places that a refinement ends in; and the evidence.

    Parameters
    ----------
    found
        The evidence for each, from the elements that are its own or nobody's.
    doubted
        (k,) which are asked.
    owner, contested
        (m,) pose that each element was assigned to, -1 for none, and whether it may as well be another one's.
    seed
        Of the random starts.
    """
    rng, height = np.random.default_rng(seed), scene.unit.height
    poses, table = poses.copy(), found.table.copy()
    for k in np.flatnonzero(doubted):
        shifted = poses[k, :3] + rng.normal(0.0, START_SD * height, (STARTS, 3))
        turned = Rotation.from_rotvec(rng.normal(0.0, START_TURN, (STARTS, 3))).as_matrix() @ poses[k, 3:].reshape(3, 3)
        own = (owner == k) | (owner < 0)
        refined = refine(np.column_stack([shifted, turned.reshape(-1, 9)]), scene, own & ~contested, most=1500, sweeps=20)
        judged = Evidence.joined([found[int(k)], evidence(refined, scene, own)])
        likely = log_likelihood(judged, scene.tolerance)
        likeliest = int(np.argmax(likely))
        if likely[likeliest] > likely[0] + MARGIN:
            poses[k], table[k] = refined[likeliest - 1], judged.table[likeliest]
    return poses, Evidence(table)
