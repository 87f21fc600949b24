"""Tensor nets, as arrays of rows, columns and coordinates."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple, Union

from . import _native
from ._errors import SubcertError
from ._geometry import (
    LimitPoint,
    MeshDepth,
    Named,
    SurfaceDepth,
    as_given,
    depth_of,
    limit_of,
    name_of,
    points_of,
    rows_of,
    surface_depth_of,
)
from ._numbers import Array, Number, Rows, count, listed

#: Rows of points.
Net = Union[Sequence[Rows], Array]


def net_depth(
    scheme: Named, points: Net, tolerance: Number, *, closed: str = "none"
) -> MeshDepth:
    """How many levels bring a net within a tolerance of its limit surface. Schemes are tensor products such
    as "chaikin x four-point:w=1/16"; ``closed`` says in which directions the net is closed: "none", "u"
    (the last row is followed by the first), "v" (so within each row) or "uv". Faces are counted row by row.

    >>> roof = [[(i, j, abs(j - 2)) for j in range(5)] for i in range(4)]
    >>> found = net_depth("b-spline:degree=3 x b-spline:degree=3", roof, "1/20")
    >>> found.level, found.too_few
    (2, 1)
    """
    return depth_of(_native.net_depth(name_of(scheme), _given(points, closed), tolerance))


def net_geometric_depth(
    scheme: Named, points: Net, tolerance: Number, *, closed: str = "none"
) -> SurfaceDepth:
    """How many levels bring a net, bilinear between its points, within a tolerance of its limit surface as a set of points.

    >>> roof = [[(i, j, abs(j - 2)) for j in range(5)] for i in range(4)]
    >>> found = net_geometric_depth("b-spline:degree=3 x b-spline:degree=3", roof, "1/20")
    >>> found.level, found.too_few
    (2, 1)
    """
    return surface_depth_of(_native.net_geometric_depth(name_of(scheme), _given(points, closed), tolerance))


def refine_net(scheme: Named, points: Net, levels: int = 1, *, closed: str = "none") -> Any:
    """The net after some levels, computed exactly and rounded once: rows of points, an array where
    ``points`` is one.

    >>> plane = [[(4 * i, 4 * j, 0) for j in range(3)] for i in range(3)]
    >>> refine_net("chaikin x chaikin", plane)[0]
    [(1.0, 1.0, 0.0), (1.0, 3.0, 0.0), (1.0, 5.0, 0.0), (1.0, 7.0, 0.0)]
    """
    refined, columns = _native.net_refine(
        name_of(scheme), _given(points, closed), count(levels, "levels")
    )
    rows = len(refined) // columns if columns else 0
    return as_given(refined, points, (rows, columns))


def limit_net(
    scheme: Named, points: Net, *, closed: str = "none"
) -> List[List[Optional[LimitPoint]]]:
    """Where each point of the net tends to, row by row; None where the limit does not reach it.

    >>> plane = [[(4 * i, 4 * j, 0) for j in range(3)] for i in range(3)]
    >>> limit_net("b-spline:degree=3 x b-spline:degree=3", plane)[1][1].exact
    (Fraction(4, 1), Fraction(4, 1), Fraction(0, 1))
    """
    given = _given(points, closed)
    limits = [limit_of(limit) for limit in _native.net_limit(name_of(scheme), given)]
    columns = given[1]
    return [limits[i : i + columns] for i in range(0, len(limits), columns)]


def _given(points: Any, closed: str) -> Tuple[List[List[Any]], int, str]:
    rows: Sequence[Any] = rows_of(points)
    rows = [listed(row) for row in rows]
    for i, row in enumerate(rows):
        if not isinstance(row, (list, tuple)):
            raise SubcertError(f"row {i} is {row!r}", remedy="a net is a list of rows of points")
        if len(row) != len(rows[0]):
            raise SubcertError(
                f"row {i} has {len(row)} points, and row 0 has {len(rows[0])}",
                remedy="all rows of a net have the same length",
            )
    if not rows or not rows[0]:
        raise SubcertError("there are no points")
    flat = [point for row in rows for point in row]
    return points_of(flat, "point"), len(rows[0]), closed
