"""Polygon meshes, as arrays of vertices and faces."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, List, Optional, Sequence, Tuple

from . import _native
from ._errors import SubcertError
from ._numbers import Number, exact

Point = Tuple[float, float, float]


@dataclass(frozen=True)
class MeshDepth:
    """How many levels a mesh needs; see ``Depth``. Distances are between mesh and limit surface at
    the same parameters."""

    level: int
    too_few: Optional[int]
    distance: Tuple[float, float]
    #: The face of the control mesh where the lower bound is attained, and the points there.
    worst_face: Optional[int]
    on_mesh: Optional[Point]
    on_limit: Optional[Point]
    #: Some point of the limit is at least so far from every point of the mesh.
    hausdorff_lower: float


@dataclass(frozen=True)
class RefinedMesh:
    """A refined mesh: each coordinate is the float nearest to the exact one."""

    vertices: Any
    faces: List[List[int]]


@dataclass(frozen=True)
class LimitPoint:
    """Where the limit surface has a vertex; ``exact`` is None where it is irrational."""

    point: Point
    exact: Optional[Tuple[Fraction, Fraction, Fraction]]


def mesh_depth(
    scheme: str, vertices: Any, faces: Sequence[Sequence[int]], tolerance: Number
) -> MeshDepth:
    """How many levels bring a mesh within a tolerance of its limit surface. Schemes are
    "catmull-clark", "doo-sabin", "loop" and "loop-warren". Floats are the numbers that they are.

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> found = mesh_depth("catmull-clark", cube, faces, "1/100")
    >>> found.level, found.too_few
    (4, 3)
    """
    found = _native.mesh_depth(scheme, _vertices(vertices), _faces(faces), tolerance)
    level, too_few, distance, worst, apart = found
    face, on_mesh, on_limit = worst if worst is not None else (None, None, None)
    place = [None if point is None else tuple(point) for point in (on_mesh, on_limit)]
    return MeshDepth(level, too_few, tuple(distance), face, place[0], place[1], apart)


def refine_mesh(
    scheme: str, vertices: Any, faces: Sequence[Sequence[int]], levels: int = 1
) -> RefinedMesh:
    """The mesh after some levels, computed exactly and rounded once."""
    points, refined = _native.mesh_refine(scheme, _vertices(vertices), _faces(faces), levels)
    if hasattr(vertices, "dtype"):
        import numpy

        points = numpy.asarray(points)
    else:
        points = [tuple(point) for point in points]
    return RefinedMesh(points, refined)


def limit_points(
    scheme: str, vertices: Any, faces: Sequence[Sequence[int]]
) -> List[Optional[LimitPoint]]:
    """Where the limit surface has each vertex; None where it does not reach it."""
    found = _native.mesh_limit(scheme, _vertices(vertices), _faces(faces))
    return [None if limit is None else _limit(*limit) for limit in found]


def _limit(point: Any, fractions: Any) -> LimitPoint:
    exactly = None if fractions is None else tuple(Fraction(*x) for x in fractions)
    return LimitPoint(tuple(point), exactly)


def _vertices(vertices: Any) -> List[List[Any]]:
    rows = vertices.tolist() if hasattr(vertices, "tolist") else list(vertices)
    if not rows:
        raise SubcertError("there are no vertices")
    for i, row in enumerate(rows):
        if not isinstance(row, (list, tuple)) or len(row) != 3:
            raise SubcertError(f"vertex {i} is {row!r}", remedy="a vertex has three coordinates")
    return [[exact(x) if isinstance(x, float) else x for x in row] for row in rows]


def _faces(faces: Any) -> List[List[int]]:
    rows = faces.tolist() if hasattr(faces, "tolist") else faces
    lists = [list(face) for face in rows]
    for i, face in enumerate(lists):
        for vertex in face:
            if not isinstance(vertex, int) or isinstance(vertex, bool) or vertex < 0:
                raise SubcertError(
                    f"face {i} has the vertex {vertex!r}", remedy="vertices are counted from 0"
                )
    return lists
