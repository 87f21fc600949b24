"""Polygon meshes, as arrays of vertices and faces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional, Tuple

from . import _native
from ._errors import SubcertError
from ._geometry import (
    Cells,
    Faces,
    LimitPoint,
    MeshDepth,
    Named,
    Points,
    SurfaceDepth,
    as_given,
    depth_of,
    indices,
    limit_of,
    name_of,
    points_of,
    rows_of,
    surface_depth_of,
)
from ._numbers import Number, count
from ._tags import Tags
from ._tags import found as tags_of
from ._tags import given as given_tags


@dataclass(frozen=True, eq=False, repr=False)
class RefinedMesh(Cells):
    """A refined mesh: each coordinate is the float nearest to the exact one.

    >>> found = refine_mesh("loop", [(0, 0, 0), (4, 0, 0), (0, 4, 0)], [[0, 1, 2]])
    >>> found, found.faces[0]
    (RefinedMesh(6 vertices, 4 faces), [0, 3, 5])
    """

    vertices: Any
    faces: List[List[int]]
    #: What is sharp at this level.
    tags: Tags


def mesh_depth(
    scheme: Named,
    vertices: Points,
    faces: Faces,
    tolerance: Number,
    *,
    tags: Optional[Tags] = None,
) -> MeshDepth:
    """How many levels bring a mesh within a tolerance of its limit surface. Schemes for meshes are
    "catmull-clark", "doo-sabin", "loop" and "loop-warren", and no others of the catalogue; a ``Scheme`` with such a
    name is one too. Floats are the numbers that they are. ``tags`` say what is sharp.

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> found = mesh_depth("catmull-clark", cube, faces, "1/100")
    >>> found.level, found.too_few
    (4, 3)
    """
    return depth_of(_native.mesh_depth(name_of(scheme), *_mesh(vertices, faces, tags), tolerance))


def mesh_geometric_depth(
    scheme: Named,
    vertices: Points,
    faces: Faces,
    tolerance: Number,
    *,
    faces_are: str = "bilinear",
    tags: Optional[Tags] = None,
) -> SurfaceDepth:
    """How many levels bring a mesh within a tolerance of its limit surface, as sets of points. Triangles are flat, and
    faces with more than four vertices are fans from their centroids; so are quadrilaterals with ``faces_are="fan"``.

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> found = mesh_geometric_depth("doo-sabin", cube, faces, "1/10")
    >>> found.level, found.too_few, found.of
    (2, 1, 'limit')
    """
    mesh = _mesh(vertices, faces, tags)
    return surface_depth_of(_native.mesh_geometric_depth(name_of(scheme), *mesh, tolerance, faces_are))


def refine_mesh(
    scheme: Named,
    vertices: Points,
    faces: Faces,
    levels: int = 1,
    *,
    tags: Optional[Tags] = None,
) -> RefinedMesh:
    """The mesh after some levels, computed exactly and rounded once.

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> found = refine_mesh("catmull-clark", cube, faces)
    >>> len(found.vertices), len(found.faces)
    (26, 24)
    """
    mesh = _mesh(vertices, faces, tags)
    points, refined, sharp = _native.mesh_refine(name_of(scheme), *mesh, count(levels, "levels"))
    return RefinedMesh(as_given(points, vertices, (len(points),)), refined, tags_of(sharp))


def limit_points(
    scheme: Named,
    vertices: Points,
    faces: Faces,
    *,
    tags: Optional[Tags] = None,
) -> List[Optional[LimitPoint]]:
    """Where the limit surface has each vertex; None where it does not reach it.

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> limit_points("catmull-clark", cube, faces)[0].exact
    (Fraction(-1, 2), Fraction(-1, 2), Fraction(-1, 2))
    """
    found = _native.mesh_limit(name_of(scheme), *_mesh(vertices, faces, tags))
    return [limit_of(limit) for limit in found]


def _mesh(vertices: Any, faces: Any, tags: Optional[Tags]) -> Tuple[Any, Any, Any]:
    return _vertices(vertices), _faces(faces), given_tags(tags)


def _vertices(vertices: Any) -> List[List[Any]]:
    rows = rows_of(vertices)
    if not rows:
        raise SubcertError("there are no vertices")
    return points_of(rows, "vertex")


def _faces(faces: Any) -> List[List[int]]:
    return indices(faces, "face", "vertex")
