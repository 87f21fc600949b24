"""Schemes for curves and tensor product surfaces."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _native
from ._errors import SubcertError
from ._numbers import Algebraic, Number, coprime, exact, pair


@dataclass(frozen=True)
class Constants:
    """The constants of a scheme; ``contraction[c - 1]`` is T_c, and ``norm[c - 1]`` is Λ_c."""

    contraction: List[Fraction]
    norm: List[Fraction]
    displacement: Fraction
    #: For each direction the s with which point i of level k is at (i + s)/n^k; None where lines are
    #: not kept.
    natural_shifts: List[Optional[Fraction]]


@dataclass(frozen=True)
class Depth:
    """How many levels a tolerance needs.

    ``level`` is enough, ``too_few`` is not (None where even level 0 may be enough), and the distance
    at ``level`` lies between the two numbers of ``distance``.
    """

    level: int
    too_few: Optional[int]
    distance: Tuple[Fraction, Fraction]
    #: A parameter at which the lower end is the distance.
    parameter: Optional[Fraction]


@dataclass(frozen=True)
class Interval:
    """An open interval; None stands for an end at infinity."""

    low: Optional[Algebraic]
    high: Optional[Algebraic]

    def __contains__(self, value: Any) -> bool:
        return (self.low is None or self.low < value) and (self.high is None or self.high > value)


@dataclass(frozen=True)
class Quantity:
    """A constant in floating point beside its exact value.

    ``bound`` is a proven bound of the error, None where none is computed in advance.
    """

    name: str
    value: float
    exact: Fraction
    bound: Optional[float]

    @property
    def error(self) -> Fraction:
        """How far the float is from the exact value."""
        return abs(Fraction(self.value) - self.exact)


@dataclass(frozen=True)
class Refined:
    """Points of a refined polygon.

    ``exact`` has the points as fractions (tuples of them where points have several coordinates),
    ``points`` the nearest floats: a numpy array if one was given, else a list; ``error`` bounds how
    far any float is from its exact value.
    """

    points: Any
    exact: List[Any]
    error: float


class Scheme:
    """A subdivision scheme: one of the catalogue with its parameters, or a mask.

    A mask has one row of coefficients for each rule; ``offset`` is the index of the first point that
    a rule takes. Numbers are ints, Fractions, Decimals, or text such as "3/256"; floats are refused,
    as 0.1 is not 1/10 as a float: ``subcert.exact(0.1)`` is the number that it is.

    >>> Scheme("six-point", w=Fraction(3, 256)).contraction(1)
    Fraction(89, 128)
    >>> Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]).contraction(2)
    Fraction(1, 4)
    >>> Scheme("chaikin").depth("1/100", spread=1).level
    3
    """

    def __init__(
        self,
        name: Optional[str] = None,
        *,
        mask: Optional[Sequence[Sequence[Number]]] = None,
        offset: int = 0,
        **parameters: Number,
    ) -> None:
        if (name is None) == (mask is None):
            raise SubcertError(
                "a scheme is a name or a mask", remedy='write Scheme("chaikin") or Scheme(mask=[...])'
            )
        self._text: Optional[str] = None
        self._known: Any = None
        if mask is not None:
            if parameters:
                raise SubcertError("a mask has no parameters")
            self._known = _native._Native.of_mask([list(row) for row in mask], offset)
        else:
            self._text = _text(str(name), parameters)

    @property
    def _native(self) -> Any:
        # Where a parameter is left open, as for `range`, there is no mask.
        if self._known is None:
            self._known = _native._Native.named(self._text)
        return self._known

    @property
    def masks(self) -> List[List[List[Fraction]]]:
        """The coefficients for each direction, rule by rule."""
        return [[[coprime(*x) for x in row] for row in rows] for rows, _ in self._native.masks]

    @property
    def offsets(self) -> List[int]:
        """The offset for each direction."""
        return [offset for _, offset in self._native.masks]

    def contraction(self, c: int = 1) -> Fraction:
        """T_c: by how much c levels shrink differences at least. Of a tensor product, the greater
        T_c·Λ_c of its two directions.

        >>> Scheme("four-point", w="1/16").contraction(2)
        Fraction(21, 64)
        """
        return coprime(*self._native.contraction(c))

    def norm(self, c: int = 1) -> Fraction:
        """Λ_c: by how much c levels can enlarge the greatest value."""
        return coprime(*self._native.norm(c))

    def constants(self, levels: int = 4) -> Constants:
        """The constants for c = 1, …, levels."""
        each = range(1, levels + 1)
        return Constants(
            [self.contraction(c) for c in each],
            [self.norm(c) for c in each],
            coprime(*self._native.displacement()),
            [pair(shift) for shift in self._native.natural_shifts()],
        )

    def depth(
        self,
        tolerance: Number,
        *,
        spread: Optional[Number] = None,
        polygon: Any = None,
        closed: bool = True,
        natural: bool = True,
    ) -> Depth:
        """How many levels bring the polygon within a tolerance of the limit curve.

        With ``polygon``, a list of numbers or of points: for this polygon, where the distance is the
        greatest of all coordinates. With ``spread``: for every polygon whose neighbouring points
        differ by at most that. ``natural=False`` compares at the parameters i/n^k, as papers do.

        >>> Scheme("chaikin").depth("1/4", polygon=[(0, 0), (4, 0), (4, 4), (0, 4)])
        Depth(level=1, too_few=0, distance=(Fraction(1, 8), Fraction(1, 8)), parameter=Fraction(1, 4))
        """
        if (spread is None) == (polygon is None):
            raise SubcertError("give either a spread or a polygon")
        if polygon is None:
            found = self._native.depth(tolerance, spread, natural)
        else:
            coordinates, _, _ = _coordinates(polygon)
            found = self._native.polygon_depth(tolerance, coordinates, closed, natural)
        level, too_few, (low, high, parameter) = found
        return Depth(level, too_few, (coprime(*low), coprime(*high)), pair(parameter))

    def range(self, parameter: str, levels: int = 4) -> List[Interval]:
        """Where in a parameter, which is left open, T_c < 1 for some c up to levels: differences
        shrink there, and the scheme converges.

        >>> [interval] = Scheme("four-point").range("w", levels=1)
        >>> interval.low.as_fraction(), interval.high.as_fraction()
        (Fraction(-1, 4), Fraction(1, 4))
        """
        if self._text is None:
            raise SubcertError(
                "the range of a parameter needs a scheme of the catalogue or of a file",
                remedy="write the mask with its parameter in a scheme file",
            )
        _, union = _native.parameter_range(self._text, parameter, levels)
        return [Interval(*(end and Algebraic(end) for end in ends)) for ends in union]

    def certify(self, levels: int = 4) -> List[Quantity]:
        """All constants in floating point, beside their exact values and proven bounds."""
        quantities = self._native.certify(levels)
        return [Quantity(name, value, coprime(*p), bound) for name, value, p, bound in quantities]

    def refine(self, points: Any, levels: int = 1, *, closed: bool = True) -> Refined:
        """The polygon after some levels: numbers, points as tuples, or a numpy array of either.

        Floats of an array are taken for the numbers that they are.

        >>> Scheme("chaikin").refine([0, 4, 4, 0]).exact
        [Fraction(1, 1), Fraction(3, 1), Fraction(4, 1), Fraction(4, 1), Fraction(3, 1), Fraction(1, 1), Fraction(0, 1), Fraction(0, 1)]
        """
        coordinates, tuples, array = _coordinates(points)
        native = self._native.refine(coordinates, levels, closed)
        columns = [[coprime(*x) for x in column] for column in native]
        floats = [[_native.nearest(x) for x in column] for column in columns]
        pairs = (p for column, other in zip(columns, floats) for p in zip(column, other))
        error = max((abs(x - Fraction(y)) for x, y in pairs), default=Fraction(0))
        bound = _above(error)
        shaped = [list(zip(*values)) if tuples else values[0] for values in (columns, floats)]
        return Refined(array(shaped[1]) if array else shaped[1], shaped[0], bound)

    def __repr__(self) -> str:
        if self._text is not None:
            return f"Scheme({self._text!r})"
        rows = [[str(x) for x in row] for row in self.masks[0]]
        return f"Scheme(mask={rows}, offset={self.offsets[0]})"


def schemes() -> List[str]:
    """The names of the catalogue."""
    return _native.scheme_names()


def _above(value: Fraction) -> float:
    """A float that is not below the value."""
    import math

    nearest = float(value)
    return nearest if Fraction(nearest) >= value else math.nextafter(nearest, math.inf)


def _text(name: str, parameters: Dict[str, Number]) -> str:
    values = []
    for key, value in parameters.items():
        if isinstance(value, float):
            raise SubcertError(
                f"the float {value} is no exact number",
                remedy=f'write Fraction(...) or "{value}" for what is meant, or '
                f"subcert.exact({value}) for the number that the float is",
            )
        values.append(f"{key}={value if isinstance(value, str) else exact(value)}")
    return name if not values else f"{name}:{','.join(values)}"


def _coordinates(points: Any) -> Tuple[List[List[Any]], bool, Any]:
    """One list for each coordinate, whether points are tuples, and what makes an array of a list."""
    array = None
    if hasattr(points, "dtype") and hasattr(points, "tolist"):
        import numpy

        array = numpy.asarray
        if points.ndim not in (1, 2):
            raise SubcertError(
                f"an array with {points.ndim} axes is no polygon",
                remedy="give one number or one row of coordinates for each point",
            )
        if points.dtype.kind == "f":
            points = [
                [exact(x) for x in row] if isinstance(row, list) else exact(row)
                for row in points.tolist()
            ]
        else:
            points = points.tolist()
    points = list(points)
    if not points:
        raise SubcertError("there are no points")
    tuples = isinstance(points[0], (tuple, list))
    if not tuples:
        return [points], False, array
    if len({len(point) for point in points}) != 1 or not len(points[0]):
        raise SubcertError("all points need the same number of coordinates")
    return [list(column) for column in zip(*points)], True, array
