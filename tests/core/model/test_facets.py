"""Faces and outlines of a unit against its exact surface and against the shadow of a fine mesh."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from scipy.spatial.transform import Rotation
from tetratrack.core.model.facets import facets, plan_outline
from tetratrack.core.model.outline import PlacedShape
from tetratrack.core.model.tetrapod import mesh, relate
from tetratrack.core.model.unit_types import UnitType

UNIT = UnitType.tetrapod(2.3)


def _shape(unit: UnitType = UNIT, rotation: np.ndarray | None = None, centre: tuple[float, float, float] = (0, 0, 0)) -> PlacedShape:
    turn = np.eye(3) if rotation is None else rotation
    return PlacedShape(
        centre=np.array(centre, dtype=float),
        rotation=turn,
        radius=unit.radius,
        gradient=unit.gradient,
        leg_length=unit.leg_length,
        legs=unit.leg_directions,
    )


@pytest.mark.parametrize("opening", ["tetrahedral", "paper"])
def test_every_corner_lies_on_the_surface_and_every_face_looks_outwards(opening: str) -> None:
    unit = UnitType.tetrapod(2.3, opening=opening)
    body = facets(_shape(unit))
    corners = np.vstack([body.root.reshape(-1, 3), body.rim.reshape(-1, 3)])
    assert np.abs(relate(corners, unit).distance).max() < 1e-12
    faces = body.lateral
    normals = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
    assert np.all(np.sum(normals * body.normals.reshape(-1, 3), axis=1) > 0)
    # four corners of a face lie in one plane
    heights = np.einsum("ki,ki->k", faces[:, 3] - faces[:, 0], normals / np.linalg.norm(normals, axis=1)[:, None])
    assert np.abs(heights).max() < 1e-12


def test_the_faces_close_and_their_volume_tends_to_the_unit_s() -> None:
    volumes = []
    for sides in (12, 24, 48):
        corners, lateral, ends = facets(_shape(), sides).welded()
        triangles = np.vstack(
            [lateral[:, [0, 1, 2]], lateral[:, [0, 2, 3]], *(np.column_stack([np.full(sides - 2, e[0]), e[1:-1], e[2:]]) for e in ends)]
        )
        edges = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        # each edge is met once in each direction
        there = {tuple(edge) for edge in edges.tolist()}
        assert len(there) == len(edges)
        assert there == {(b, a) for a, b in there}
        a, b, c = corners[triangles].transpose(1, 0, 2)
        volumes.append(float(np.einsum("ki,ki->", a, np.cross(b, c)) / 6))
    short = UNIT.volume - np.array(volumes)
    assert short[0] / UNIT.volume < 0.05
    assert np.all(short[:-1] / short[1:] > 3.5)


def test_the_outline_is_the_shadow_of_the_unit() -> None:
    corners, triangles = mesh(UNIT, 96, 12)
    for turn in Rotation.random(6, random_state=3):
        shape = _shape(rotation=turn.as_matrix(), centre=(500_000.0, 3_500_000.0, 2.0))
        outline = shapely.Polygon(plan_outline(shape) - shape.centre[:2])
        assert outline.is_valid
        assert outline.exterior.is_ccw
        shadow = shapely.union_all([shapely.Polygon(t) for t in (corners @ turn.as_matrix().T)[triangles][:, :, :2]])
        assert outline.symmetric_difference(shadow).area / shadow.area < 0.003
        assert outline.exterior.hausdorff_distance(shapely.Polygon(shadow.exterior).exterior) < 0.012


def test_the_outline_of_a_unit_with_a_level_leg() -> None:
    level = Rotation.from_euler("y", np.arcsin(1 / 3) - np.pi / 2).as_matrix()
    outline = plan_outline(_shape(rotation=level))
    assert np.isfinite(outline).all()
    assert shapely.Polygon(outline).is_valid
