"""What meshes, nets and solids have in common."""

from __future__ import annotations

import os
from dataclasses import dataclass, fields
from fractions import Fraction
from operator import index
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from . import _html
from ._answer import Answer
from ._errors import SubcertError
from ._numbers import Array, Rows, coprime, listed

if TYPE_CHECKING:
    from ._scheme import Scheme

Point = Tuple[float, float, float]

#: A scheme for meshes or nets.
Named = Union[str, "Scheme"]

#: Points, row by row; faces or cells by the indices of their points.
Points = Rows
Faces = Union[Sequence[Union[Sequence[int], Array]], Array]


class Cells(Answer):
    """Points, and faces or cells."""

    def _sizes(self) -> List[Tuple[str, int]]:
        names = [one.name for one in fields(self)][:2]  # type: ignore[arg-type]
        return [(name, len(getattr(self, name))) for name in names]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each point.

        >>> from subcert import refine_mesh
        >>> refine_mesh("loop", [(0, 0, 0), (4, 0, 0), (0, 4, 0)], [[0, 1, 2]]).rows()[0]
        {'x': 0.5, 'y': 0.5, 'z': 0.0}
        """
        points = getattr(self, self._sizes()[0][0])
        return [dict(zip("xyz", map(float, point))) for point in points]

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        pairs = [(getattr(self, x.name), getattr(other, x.name)) for x in fields(self)]  # type: ignore[arg-type]
        return all(_plain(mine) == _plain(theirs) for mine, theirs in pairs)

    def __repr__(self) -> str:
        sizes = ", ".join(f"{size} {name}" for name, size in self._sizes())
        return f"{type(self).__name__}({sizes})"

    def _repr_html_(self) -> str:
        return _html.facts(type(self).__name__, self._sizes())


@dataclass(frozen=True)
class MeshDepth(Answer):
    """How many levels a mesh needs; see ``Depth``. Distances are between mesh and limit surface at
    the same parameters.

    >>> from subcert import net_depth
    >>> roof = [[(i, j, abs(j - 2)) for j in range(5)] for i in range(4)]
    >>> net_depth("b-spline:degree=3 x b-spline:degree=3", roof, 0.05).level
    2
    """

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
class SurfaceDepth(Answer):
    """How many levels a tolerance needs by the Hausdorff distance of a mesh or a net and its limit surface.

    ``level`` is enough, ``too_few`` is not: ``point``, of the set ``of`` ("mesh" or "limit"), on ``face`` of the control mesh,
    is at least ``distance`` from all of the other set.

    >>> from subcert import net_geometric_depth
    >>> roof = [[(i, j, abs(j - 2)) for j in range(5)] for i in range(4)]
    >>> net_geometric_depth("b-spline:degree=3 x b-spline:degree=3", roof, 0.05).level
    2
    """

    level: int
    too_few: Optional[int]
    of: Optional[str]
    face: Optional[int]
    point: Optional[Point]
    distance: Optional[float]


@dataclass(frozen=True)
class LimitPoint(Answer):
    """Where the limit surface has a vertex; ``exact`` is None where it is irrational.

    >>> from subcert import limit_points
    >>> found = limit_points("loop", [(0, 0, 0), (4, 0, 0), (0, 4, 0)], [[0, 1, 2]])
    >>> found[0].exact
    (Fraction(2, 3), Fraction(2, 3), Fraction(0, 1))
    """

    point: Point
    exact: Optional[Tuple[Fraction, Fraction, Fraction]]


def _plain(value: Any) -> Any:
    """Rows as lists, whether they come from an array or not."""
    value = listed(value)
    return [list(row) for row in value] if isinstance(value, list) else value


def depth_of(found: Any) -> MeshDepth:
    level, too_few, distance, worst, apart = found
    face, on_mesh, on_limit = worst if worst is not None else (None, None, None)
    place = [None if point is None else tuple(point) for point in (on_mesh, on_limit)]
    return MeshDepth(level, too_few, tuple(distance), face, place[0], place[1], apart)


def surface_depth_of(found: Any) -> SurfaceDepth:
    level, too_few, place = found
    of, face, point, distance = place if place is not None else (None, None, None, None)
    return SurfaceDepth(level, too_few, of, face, None if point is None else tuple(point), distance)


def limit_of(found: Any) -> Optional[LimitPoint]:
    if found is None:
        return None
    point, fractions = found
    exactly = None if fractions is None else tuple(coprime(*x) for x in fractions)
    return LimitPoint(tuple(point), exactly)


def rows_of(given: Any) -> List[Any]:
    """Points, or rows of points, as a list."""
    if isinstance(given, (str, os.PathLike)):
        remedy = "the command line reads files of meshes, nets and solids"
        raise SubcertError(f"{given!r} is no list of points", remedy=remedy)
    return list(listed(given))


def points_of(rows: Sequence[Any], name: str) -> List[List[Any]]:
    """Points for the native part; `name` says what they are called in messages."""
    rows = [listed(row) for row in rows]
    for i, row in enumerate(rows):
        if not isinstance(row, (list, tuple)) or len(row) != 3:
            raise SubcertError(f"{name} {i} is {row!r}", remedy=f"a {name} has three coordinates")
    return [list(row) for row in rows]


def name_of(scheme: Any) -> str:
    """The name of a scheme, which may be a ``Scheme``.

    >>> from subcert import Scheme
    >>> name_of(Scheme("loop")), name_of("loop")
    ('loop', 'loop')
    """
    name = scheme if isinstance(scheme, str) else getattr(scheme, "_text", None)
    if name is None:
        kind = "a scheme without a name" if hasattr(scheme, "_text") else f"a {type(scheme).__name__}"
        raise SubcertError(f"{kind} has no rules for meshes and nets", remedy='name one, such as "loop"')
    return name


def as_given(points: List[Any], given: Any, shape: Tuple[int, ...]) -> Any:
    """Points as an array where an array was given; else as tuples, in rows where `shape` has two numbers."""
    if hasattr(given, "dtype"):
        import numpy

        return numpy.asarray(points, dtype=float).reshape(*shape, 3)
    tuples = [tuple(point) for point in points]
    if len(shape) == 1:
        return tuples
    return [tuples[i * shape[1] : (i + 1) * shape[1]] for i in range(shape[0])]


def indices(rows: Any, name: str, member: str) -> List[List[int]]:
    """Faces or cells for the native part."""
    lists: List[List[int]] = []
    for i, row in enumerate(listed(rows)):
        row = listed(row)
        if not isinstance(row, Iterable) or isinstance(row, str):
            remedy = f"a {name} is a list of indices"
            raise SubcertError(f"{name} {i} is {row!r}", remedy=remedy)
        lists.append([])
        for given in row:
            if not hasattr(given, "__index__") or isinstance(given, bool) or given < 0:
                remedy = "indices are ints, counted from 0"
                raise SubcertError(f"{name} {i} has the {member} {given!r}", remedy=remedy)
            lists[-1].append(index(given))
    return lists
