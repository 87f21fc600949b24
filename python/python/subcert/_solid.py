"""Solids of hexahedra, as arrays of points and cells."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List

from . import _native
from ._errors import SubcertError
from ._geometry import (
    Cells,
    Faces,
    LimitPoint,
    MeshDepth,
    Points,
    SurfaceDepth,
    as_given,
    depth_of,
    indices,
    limit_of,
    points_of,
    rows_of,
    surface_depth_of,
)
from ._numbers import Number, count


@dataclass(frozen=True, eq=False, repr=False)
class RefinedSolid(Cells):
    """A refined solid: each coordinate is the float nearest to the exact one.

    >>> cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    >>> len(refine_solid(cube, [[0, 1, 3, 2, 4, 5, 7, 6]]).points)
    27
    """

    points: Any
    cells: List[List[int]]


def solid_depth(points: Points, cells: Faces, tolerance: Number) -> MeshDepth:
    """How many levels of the scheme of Bajaj and others bring a solid within a tolerance of its limit. A
    cell has eight points in the order of VTK: around a face, then around the opposite one.
    ``worst_face`` is a cell.

    >>> cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    >>> found = solid_depth(cube, [[0, 1, 3, 2, 4, 5, 7, 6]], "1/100")
    >>> found.distance[1] <= 1 / 100
    True
    """
    return depth_of(_native.solid_depth(_points(points), _cells(cells), tolerance))


def solid_geometric_depth(
    points: Points, cells: Faces, tolerance: Number
) -> SurfaceDepth:
    """How many levels bring the boundary of a solid, bilinear between its points, within a tolerance of the boundary of
    its limit as a set of points. ``face`` is a cell.

    >>> cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    >>> found = solid_geometric_depth(cube, [[0, 1, 3, 2, 4, 5, 7, 6]], "1/100")
    >>> found.level, found.too_few, found.face
    (3, 2, 0)
    """
    return surface_depth_of(
        _native.solid_geometric_depth(_points(points), _cells(cells), tolerance)
    )


def refine_solid(points: Points, cells: Faces, levels: int = 1) -> RefinedSolid:
    """The solid after some levels, computed exactly and rounded once.

    >>> cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    >>> len(refine_solid(cube, [[0, 1, 3, 2, 4, 5, 7, 6]], 2).cells)
    64
    """
    refined, hexahedra = _native.solid_refine(
        _points(points), _cells(cells), count(levels, "levels")
    )
    return RefinedSolid(as_given(refined, points, (len(refined),)), [list(cell) for cell in hexahedra])


def solid_limit_points(points: Points, cells: Faces) -> List[LimitPoint]:
    """Where each point of the solid tends to.

    >>> cube = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    >>> solid_limit_points(cube, [[0, 1, 3, 2, 4, 5, 7, 6]])[0].exact
    (Fraction(2, 9), Fraction(2, 9), Fraction(2, 9))
    """
    found = _native.solid_limit(_points(points), _cells(cells))
    return [limit for limit in map(limit_of, found) if limit is not None]


def _points(points: Any) -> List[List[Any]]:
    rows = rows_of(points)
    if not rows:
        raise SubcertError("there are no points")
    return points_of(rows, "point")


def _cells(cells: Any) -> List[List[int]]:
    lists = indices(cells, "cell", "point")
    for i, cell in enumerate(lists):
        if len(cell) != 8:
            raise SubcertError(f"cell {i} has {len(cell)} points", remedy="a hexahedron has eight")
    return lists
