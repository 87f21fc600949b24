"""What is sharp in a polygon mesh."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, List, Mapping, Optional, Sequence, SupportsIndex, Tuple

from ._geometry import indices
from ._numbers import Number, coprime, exact


@dataclass(frozen=True)
class Tags:
    """Creases, corners, holes and boundary of a mesh, for "catmull-clark", "loop" and "loop-warren".

    ``creases`` has the sharpness of edges by their ends, and ``corners`` that of vertices: 0 is smooth, and from 10 on
    it is infinite. ``holes`` are faces. ``boundary`` is "edge", "corner" or "none", and ``creasing`` "uniform" or "chaikin".

    >>> cube = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    >>> faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
    >>> sharp = Tags(creases={(4, 5): 10, (5, 7): "3/2"}, corners={0: 10})
    >>> from subcert import limit_points, refine_mesh
    >>> limit_points("catmull-clark", cube, faces, tags=sharp)[0].point
    (-1.0, -1.0, -1.0)
    >>> sorted(refine_mesh("catmull-clark", cube, faces, tags=sharp).tags.creases.values())
    [Fraction(1, 2), Fraction(1, 2), Fraction(10, 1), Fraction(10, 1)]
    """

    creases: Mapping[Tuple[SupportsIndex, SupportsIndex], Number] = field(default_factory=dict)
    corners: Mapping[SupportsIndex, Number] = field(default_factory=dict)
    holes: Sequence[SupportsIndex] = ()
    boundary: str = "edge"
    creasing: str = "uniform"


def given(tags: Optional[Tags]) -> Tuple[List[Any], List[Any], List[int], str, str]:
    """Tags for the native part."""
    tags = Tags() if tags is None else tags
    edges = indices(tags.creases.keys(), "crease", "vertex")
    [vertices] = indices([tags.corners.keys()], "the list of corners,", "vertex")
    [holes] = indices([tags.holes], "the list of holes,", "face")
    sharpness = [exact(value) for value in tags.creases.values()]
    corners = list(zip(vertices, map(exact, tags.corners.values())))
    return list(zip(edges, sharpness)), corners, holes, tags.boundary, tags.creasing


def found(tags: Any) -> Tags:
    """Tags from the native part."""
    edges, corners, holes, boundary, creasing = tags
    creases = {tuple(ends): coprime(*value) for ends, value in edges}
    return Tags(creases, {v: coprime(*value) for v, value in corners}, holes, boundary, creasing)
