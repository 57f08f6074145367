"""What dense matching of images makes of narrow hollows: it bridges them.

A matcher weighs how alike the images are against how smooth the depth map is. A jump of depth costs about the same however deep it is
(the penalty P2 of semi-global matching: Hirschmüller, 2008), so that a gap of few pixels, dark and seen by few images, does not pay for the
two jumps at its rims, and its depths come from the rims. In clouds of armour the surface then runs across the gaps between units, outside
of all of them, and fills the roots of their legs.

Here the depth map of an image follows no hollow that is narrower than a paraboloid of a given radius: it is closed with that paraboloid
from the side of the camera (grey-scale morphology: Serra, 1982). The closing leaves what is convex or wider hollow as it is, and is the
same for a surface that is tilted against the view, as adding a plane only shifts a paraboloid. Its skirts behind edges lie elsewhere in
every image, so that they go where points are kept that several images agree on, while gaps are bridged alike in all of them.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import distance_transform_edt, map_coordinates

from ..common.arrays import FloatArray, IntArray
from .virtual_scene import Scene, unit_vectors

STEEPEST = 2.5
"""Slope of a surface against the view up to which the paraboloid rolls on it: beyond, images see it too obliquely to match."""
FARTHEST = 1e4
"""Depth of a pixel that meets nothing, metres."""


class MatchedView:
    """A scene as the depth map of one image shows it, with the same ``cast`` as the scene for rays from the camera."""

    def __init__(self, scene: Scene, camera: FloatArray, aims: FloatArray, radius: float, pixel: float) -> None:
        """See a scene from a (3,) camera, in the directions of (n, 3) places that it takes in.

        ``radius`` is that of the narrowest hollow that is followed, ``pixel`` the size of a pixel at the middle of what is seen, metres.
        """
        self.scene, self.unit, self.site = scene, scene.unit, scene.site
        forward = unit_vectors((aims.mean(axis=0) - camera)[None])[0]
        right = unit_vectors(np.cross(forward, [0.0, 1.0, 0.0])[None])[0]
        self._axes = np.array([right, np.cross(right, forward), forward])
        distance = float(np.linalg.norm(aims.mean(axis=0) - camera))
        self._step = pixel / distance
        seen = self._on_image(unit_vectors(aims - camera))
        self._first = seen.min(axis=0)
        across, down = (np.arange(low, high + 2 * self._step, self._step) for low, high in zip(self._first, seen.max(axis=0), strict=True))
        image = np.stack(np.meshgrid(across, down, indexing="ij"), axis=-1)
        rays = unit_vectors(np.concatenate([image, np.ones((*image.shape[:2], 1))], axis=-1).reshape(-1, 3) @ self._axes)
        reach, label, _ = scene.cast(np.broadcast_to(camera, rays.shape), rays)
        depth = np.minimum(reach * (rays @ forward), FARTHEST).reshape(image.shape[:2])
        # beams that pass beside the rim of a unit leave no holes in an image
        beside = (np.isinf(reach) & (label > 0)).reshape(image.shape[:2])
        if not beside.all():
            depth = depth[tuple(distance_transform_edt(beside, return_distances=False, return_indices=True))]
        self._filled = depth + closed(-depth, radius, pixel)

    def cast(self, origins: FloatArray, directions: FloatArray) -> tuple[FloatArray, IntArray, FloatArray]:
        """First hits of (n, 3) rays from the camera as the image shows them: (n,) range, (n,) label, (n,) cosine of incidence."""
        distance, label, cosine = self.scene.cast(origins, directions)
        place = (self._on_image(directions) - self._first) / self._step
        filled = map_coordinates(self._filled, place.T, order=1, mode="nearest")
        return distance - np.maximum(filled, 0.0) / (directions @ self._axes[2]), label, cosine

    def _on_image(self, directions: FloatArray) -> FloatArray:
        """(n, 2) places of (n, 3) directions on an image at unit distance."""
        own = directions @ self._axes.T
        return np.asarray(own[:, :2] / own[:, 2:])


def closed(height: FloatArray, radius: float, spacing: float) -> FloatArray:
    """(n, m) heights over a grid of a given spacing, closed from above with a paraboloid of a radius of curvature; metres."""
    count = max(1, round(STEEPEST * radius / spacing))
    drop: FloatArray = np.asarray((np.arange(count + 1) * spacing) ** 2 / (2 * radius), dtype=np.float64)
    above = height
    for axis in (0, 1):
        above = _dilated(above, drop, axis)
    below = -above
    for axis in (0, 1):
        below = _dilated(below, drop, axis)
    return -below


def _dilated(height: FloatArray, drop: FloatArray, axis: int) -> FloatArray:
    """Heights dilated along one axis with a profile that drops by so much with every step: the paraboloid is the sum of two of them."""
    moved = np.moveaxis(height, axis, 0)
    result = moved.copy()
    for step, fall in enumerate(drop[1 : len(moved)], start=1):
        np.maximum(result[step:], moved[:-step] - fall, out=result[step:])
        np.maximum(result[:-step], moved[step:] - fall, out=result[:-step])
    return np.moveaxis(result, 0, axis)
