"""Schemes for curves and tensor product surfaces."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from fractions import Fraction
from os import PathLike
from typing import (
    TYPE_CHECKING,
    Any,
    Dict,
    Generic,
    Iterable,
    List,
    Optional,
    Sequence,
    SupportsIndex,
    Tuple,
    TypeVar,
    Union,
    overload,
)

from . import _native
from ._analysis import Sector, Smoothness, Spectrum, VertexSmoothness, of_curve, of_vertex, sector, spectrum
from ._answer import Answer, Table, shown
from ._errors import SubcertError
from ._html import facts, table
from ._numbers import (
    Algebraic,
    Frame,
    Number,
    Numbers,
    Rows,
    coprime,
    count,
    decimal,
    exact,
    listed,
    pair,
)

if TYPE_CHECKING:
    import numpy

    NDArray = numpy.ndarray[Any, numpy.dtype[Any]]


@dataclass(frozen=True)
class Constants(Table):
    """The constants of a scheme; ``contraction[c - 1]`` is T_c, and ``norm[c - 1]`` is Λ_c.

    >>> Scheme("chaikin").constants(2).contraction
    [Fraction(1, 2), Fraction(1, 4)]
    """

    contraction: List[Fraction]
    norm: List[Fraction]
    displacement: Fraction
    #: For each direction the s with which point i of level k is at (i + s)/n^k; None where lines are
    #: not kept.
    natural_shifts: List[Optional[Fraction]]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each c.

        >>> Scheme("chaikin").constants(1).rows()
        [{'c': 1, 'contraction': Fraction(1, 2), 'norm': Fraction(1, 1)}]
        """
        pairs = enumerate(zip(self.contraction, self.norm), 1)
        return [{"c": c, "contraction": t, "norm": norm} for c, (t, norm) in pairs]

    def _caption(self) -> str:
        return f"Constants; σ = {shown(self.displacement)}"

    def _heads(self) -> List[str]:
        return ["c", "T_c", "Λ_c"]


@dataclass(frozen=True)
class Depth(Answer):
    """How many levels a tolerance needs.

    ``level`` is enough, ``too_few`` is not (None where even level 0 may be enough), and the distance
    at ``level`` lies between the two numbers of ``distance``.

    >>> found = Scheme("chaikin").depth("1/100")
    >>> found.level, found.too_few
    (3, 2)
    """

    level: int
    too_few: Optional[int]
    distance: Tuple[Fraction, Fraction]
    #: A parameter at which the lower end is the distance.
    parameter: Optional[Fraction]

    def _repr_html_(self) -> str:
        low, high = map(decimal, self.distance)
        return facts(
            "Depth",
            [
                ("levels", self.level),
                ("too few", self.too_few),
                ("distance from", low),
                ("to", high),
                ("at the parameter", self.parameter),
            ],
        )


@dataclass(frozen=True)
class GeometricDepth(Answer):
    """How many levels a tolerance needs by the Hausdorff distance of a polygon and its limit curve.

    ``level`` is enough, ``too_few`` is not: ``point``, of the set ``of`` ("polygon" or "limit"), at the natural ``parameter``,
    is at least ``distance`` from all of the other set.

    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> found = Scheme("chaikin").geometric_depth("1/2", square)
    >>> found.level, found.too_few, found.of, found.point
    (1, 0, 'polygon', (0.0, 0.0))
    """

    level: int
    too_few: Optional[int]
    of: Optional[str]
    parameter: Optional[Fraction]
    point: Optional[Tuple[float, ...]]
    distance: Optional[float]

    def _repr_html_(self) -> str:
        return facts(
            "Depth, as sets of points",
            [
                ("levels", self.level),
                ("too few", self.too_few),
                ("far is a point of the", self.of),
                ("at the parameter", self.parameter),
                ("point", self.point),
                ("distance at least", self.distance),
            ],
        )


@dataclass(frozen=True)
class Interval(Answer):
    """An interval; None stands for an end at infinity. The ends do not belong to it, unless it says so.

    >>> [interval] = Scheme("four-point").range("w", levels=1)
    >>> 0.125 in interval, "1/4" in interval
    (True, False)
    """

    low: Optional[Algebraic]
    high: Optional[Algebraic]
    low_included: bool = False
    high_included: bool = False

    def __contains__(self, value: Any) -> bool:
        value = value if isinstance(value, Algebraic) else exact(value)
        above = self.low is None or self.low < value or self.low_included and self.low == value
        below = self.high is None or self.high > value or self.high_included and self.high == value
        return above and below

    def __str__(self) -> str:
        """As text, with ends that are rounded where they are irrational or long."""
        low, high = self._ends(lambda end: shown(end).partition(" = ")[0])
        return f"{'[' if self.low_included else '('}{low}, {high}{']' if self.high_included else ')'}"

    def _ends(self, text: Any) -> Tuple[str, str]:
        low = "-∞" if self.low is None else text(self.low)
        return low, "∞" if self.high is None else text(self.high)

    def _cells(self) -> List[str]:
        return [str(self), *self._ends(lambda end: shown(float(end)))]


class Intervals(List[Interval], Table):
    """Intervals, as a list that is a table too.

    >>> found = Scheme("four-point").range("w", levels=1)
    >>> print(found)
    Intervals
    interval     from   to
    (-1/4, 1/4)  -0.25  0.25
    >>> 0.125 in found[0]
    True
    """

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each interval.

        >>> Scheme("four-point").range("w", levels=1).rows()[0]["high"]
        Algebraic(1/4)
        """
        return [row for interval in self for row in interval.rows()]

    def _heads(self) -> List[str]:
        return ["interval", "from", "to"]

    def _cells(self) -> List[List[str]]:
        return [interval._cells() for interval in self]


@dataclass(frozen=True)
class SmoothRange(Table):
    """Where in a parameter all limits are C^m, and where not.

    >>> found = Scheme("four-point").range("w", smoothness=1)
    >>> "1/16" in found, "1/2" in found
    (True, False)
    """

    #: There all limits are C^m.
    inside: List[Interval]
    #: There not all limits are C^m, or the scheme diverges.
    outside: List[Interval]
    #: Whether finitely many values outside may be exceptions.
    but_finitely_many: bool
    #: The length of what is in neither; None where that is unbounded.
    gap: Optional[Fraction]

    def __contains__(self, value: Any) -> bool:
        """Whether it is proven that all limits are C^m at this value."""
        return any(value in interval for interval in self.inside)

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each interval; ``limits`` says whether it is inside or outside.

        >>> Scheme("four-point").range("w", smoothness=1).rows()[0]["limits"]
        'inside'
        """
        return [{"limits": name, **row} for name, one in self._sets() for row in one.rows()]

    def _sets(self) -> List[Tuple[str, Interval]]:
        return [("inside", x) for x in self.inside] + [("outside", x) for x in self.outside]

    def _caption(self) -> str:
        return "Where the limits are smooth"

    def _heads(self) -> List[str]:
        return ["limits", "interval", "from", "to"]

    def _cells(self) -> List[List[str]]:
        return [[name, *interval._cells()] for name, interval in self._sets()]


@dataclass(frozen=True)
class Quantity(Answer):
    """A constant in floating point beside its exact value.

    ``bound`` is a proven bound of the error, None where none is computed in advance.

    >>> first = Scheme("six-point", w="3/256").certify(1)[0]
    >>> first.value == float(first.exact) or first.error > 0
    True
    """

    name: str
    value: float
    exact: Fraction
    bound: Optional[float]

    @property
    def error(self) -> Fraction:
        """How far the float is from the exact value."""
        return abs(Fraction(self.value) - self.exact)


class Quantities(List[Quantity], Table):
    """Constants in floating point, as a list that is a table too.

    >>> Scheme("chaikin").certify(1).rows()[0]["name"]
    'b[0][0]'
    """

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each constant, with the error of the float.

        >>> Scheme("chaikin").certify(1).rows()[0]["error"]
        Fraction(0, 1)
        """
        return [{**row, "error": one.error} for one in self for row in one.rows()]

    def _heads(self) -> List[str]:
        return ["name", "value", "exact", "bound", "error"]


P = TypeVar("P")


@dataclass(frozen=True, repr=False)
class Refined(Answer, Generic[P]):
    """Points of a refined polygon.

    ``exact`` has the points as fractions (tuples of them where points have several coordinates),
    ``points`` the nearest floats: a numpy array if one was given, else a list; ``error`` bounds how
    far any float is from its exact value.

    >>> found = Scheme("chaikin").refine([0.0, 4.0])
    >>> found.points, found.error
    ([1.0, 3.0, 3.0, 1.0], 0.0)
    >>> Scheme("chaikin").refine([0, 4, 8])
    Refined(6 points: 1, 3, 5, …, error=0.0)
    """

    #: They are not compared: ``exact`` has them too.
    points: P = field(compare=False)
    exact: List[Any]
    error: float

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each point.

        >>> Scheme("chaikin").refine([0, 4]).rows()[0]
        {'point': 1.0, 'exact': Fraction(1, 1)}
        """
        points: Any = self.points
        return [{"point": point, "exact": exact} for point, exact in zip(points, self.exact)]

    def _first(self, many: int) -> List[str]:
        """The first points as text, and a sign that there are more."""
        points: Any = self.points
        rows = [listed(point) for point in points[:many]]
        texts = [f"({', '.join(map(shown, row))})" if isinstance(row, (list, tuple)) else shown(float(row)) for row in rows]
        return texts + ["…"] * (len(self.exact) > many)

    def _repr_html_(self) -> str:
        caption = f"{len(self.exact)} points, error at most {shown(self.error)}"
        return table(caption, ["", "point"], enumerate(self._first(12)))

    def __repr__(self) -> str:
        return f"Refined({len(self.exact)} points: {', '.join(self._first(3))}, error={self.error!r})"


@dataclass(frozen=True)
class LimitStencil(Table):
    """The limit at a parameter as a combination of control points.

    >>> print(Scheme("[1, 4, 6, 4, 1]/8").limit_stencils()[0])
    The limit at 0
    index  weight
    -1     1/6 = 0.166667
    0      2/3 = 0.666667
    1      1/6 = 0.166667
    """

    at: Fraction
    #: The weight of each control point, by its index.
    weights: Dict[int, Fraction]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each control point.

        >>> Scheme("four-point").limit_stencils()[0].rows()
        [{'index': 0, 'weight': Fraction(1, 1)}]
        """
        return [{"index": i, "weight": weight} for i, weight in self.weights.items()]

    def _caption(self) -> str:
        return f"The limit at {shown(self.at)}"


class Scheme:
    """A subdivision scheme: one of the catalogue with its parameters, or a mask.

    A mask has one row of coefficients for each rule; ``offset`` is the index of the first point that
    a rule takes, and 0 if it is left out: ``depth()`` does not depend on it, but σ and ``depth(natural=False)`` do, which
    needs 3 levels for the cubic B-spline with the offset -1, and 8 with 0. A mask without rows, ``Scheme([Fraction(1, 4), …])``, is the symbol, as on the command
    line: its sum is the arity, and it has an offset of its own. Numbers are ints, Fractions, Decimals, text such as
    "3/256", or floats, which are the numbers that they are: 0.375 is 3/8, but 0.1 is not 1/10. numpy arrays and tables
    of pandas are taken too. A parameter without a value has its default, if the catalogue has one: w = 1/16 of
    "four-point".

    Schemes are equal where they are named alike, or are masks, also as text, and their masks and offsets are the same.
    They can be copied and
    pickled: a copy has its masks with it, and asks for a file only where a parameter is open, or for
    rules around a vertex.

    >>> Scheme("six-point", w=Fraction(3, 256)).contraction(1)
    Fraction(89, 128)
    >>> Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]).contraction(2)
    Fraction(1, 4)
    >>> Scheme([0.25, 0.75, 0.75, 0.25]) == Scheme("[1, 3, 3, 1]/4") == Scheme("z^-1*(1 + z)^3/4")
    True
    >>> Scheme("chaikin").depth("1/100", spread=1).level
    3
    """

    def __init__(
        self,
        name: Union[str, PathLike[str], Numbers, Rows, None] = None,
        *,
        mask: Union[Numbers, Rows, Iterable[Any], None] = None,
        offset: Optional[int] = None,
        **parameters: Number,
    ) -> None:
        if (name is None) == (mask is None):
            raise SubcertError(
                "a scheme is a name or a mask", remedy='write Scheme("chaikin") or Scheme(mask=[...])'
            )
        self._text: Optional[str] = None
        self._known: Any = None
        self._key: Any = None
        given = name if mask is None else mask
        if isinstance(given, (str, PathLike)):
            if offset is not None:
                remedy = "an offset belongs to a mask of rules"
                raise SubcertError(f"{str(given)!r} has an offset of its own", remedy=remedy)
            self._text = _text(str(given), parameters)
        elif parameters:
            raise SubcertError("a mask has no parameters")
        else:
            self._known = _of_mask(given, offset)

    @property
    def _native(self) -> Any:
        # Where a parameter is left open, as for `range`, there is no mask.
        if self._known is None:
            self._known = _native._Native.named(self._text or "")
        return self._known

    def _given(self) -> Any:
        """The masks as pairs of ints; None where the name has none."""
        try:
            return self._native.masks
        except SubcertError:
            return None

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (type(self), self._text, self._given())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Scheme):
            return NotImplemented
        return self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def _identity(self) -> Any:
        if self._key is None:
            masks = [
                (tuple(map(tuple, rows)), offset) for rows, offset in self._given() or ()
            ]
            # A mask as text is that mask.
            text = None if masks and self._text is not None and _is_mask(self._text) else self._text
            self._key = text, tuple(masks)
        return self._key

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
        return coprime(*self._native.contraction(count(c, "c", 1)))

    def norm(self, c: int = 1) -> Fraction:
        """Λ_c: by how much c levels can enlarge the greatest value.

        >>> Scheme("four-point", w="1/16").norm(1)
        Fraction(5, 4)
        """
        return coprime(*self._native.norm(count(c, "c", 1)))

    def constants(self, levels: int = 4) -> Constants:
        """The constants for c = 1, …, levels.

        >>> Scheme("chaikin").constants(1).displacement
        Fraction(1, 4)
        """
        each = range(1, count(levels, "levels") + 1)
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
        polygon: Union[Numbers, Rows, None] = None,
        closed: bool = True,
        natural: bool = True,
    ) -> Depth:
        """How many levels bring the polygon within a tolerance of the limit curve.

        With ``polygon``, a list of numbers or of points: for this polygon, where the distance is the
        greatest of all coordinates. Without: for every polygon whose neighbouring points
        differ by at most ``spread``, which is 1 if it is left out. ``natural=False`` compares at the parameters i/n^k, as papers do.

        >>> Scheme("chaikin").depth("1/4", polygon=[(0, 0), (4, 0), (4, 4), (0, 4)])
        Depth(level=1, too_few=0, distance=(Fraction(1, 8), Fraction(1, 8)), parameter=Fraction(1, 4))
        """
        if spread is not None and polygon is not None:
            raise SubcertError(
                "a polygon has a spread of its own", remedy="give either a spread or a polygon"
            )
        if polygon is None:
            found = self._native.depth(tolerance, 1 if spread is None else spread, natural)
        else:
            coordinates, _, _ = _coordinates(polygon)
            found = self._native.polygon_depth(tolerance, coordinates, closed, natural)
        level, too_few, (low, high, parameter) = found
        return Depth(level, too_few, (coprime(*low), coprime(*high)), pair(parameter))

    def geometric_depth(
        self, tolerance: Number, polygon: Rows, *, closed: bool = True
    ) -> GeometricDepth:
        """The least level whose polygon is within a tolerance of the limit curve as a set of points.

        ``polygon`` is a list of points of two coordinates or more.

        >>> Scheme("four-point").geometric_depth("1/10", [(0, 0), (4, 0), (4, 4), (0, 4)]).level
        2
        """
        coordinates, _, _ = _coordinates(polygon)
        level, too_few, place = self._native.geometric_depth(tolerance, coordinates, closed)
        if place is None:
            return GeometricDepth(level, too_few, None, None, None, None)
        of, parameter, point, distance = place
        return GeometricDepth(level, too_few, of, coprime(*parameter), tuple(point), distance)

    @overload
    def smoothness(self, valence: None = None) -> Smoothness: ...

    @overload
    def smoothness(self, valence: SupportsIndex) -> VertexSmoothness: ...

    def smoothness(self, valence: Optional[SupportsIndex] = None) -> Any:
        """How smooth the limits are: of curves, or of surfaces at a vertex or on a face. Checkers of types take the
        answer without a valence for that of a curve; where the name has the valence, as in ``Scheme("loop", N=5)``, it is
        a ``VertexSmoothness`` too.

        >>> Scheme("chaikin").smoothness().continuity
        1
        >>> Scheme("catmull-clark").smoothness(valence=3).continuous
        True
        """
        if self._text is not None and (valence is not None or _native.is_ring(self._text)):
            return of_vertex(self._text, _valence(valence))
        if valence is not None:
            raise SubcertError(
                "a mask has no valence", remedy="leave it out: valences are those of vertices and faces"
            )
        return of_curve(self._native)

    def spectrum(self, valence: Optional[int] = None) -> Spectrum:
        """The eigenvalues and stencils of rules around a vertex or on a face.

        >>> Scheme("doo-sabin", n=7).spectrum().subdominant.fraction
        Fraction(1, 2)
        """
        if self._text is None:
            raise SubcertError(
                "a mask has no spectrum of a vertex",
                remedy='name rules around a vertex or on a face, such as "loop"',
            )
        return spectrum(self._text, _valence(valence))

    def sector(self, faces: int, corner: bool = False) -> Sector:
        """The eigenvalues and stencils at a vertex with this many faces between two sharp edges, or at the boundary.

        >>> Scheme("loop").sector(3).across.eigenvalue.fraction
        Fraction(1, 2)
        """
        if self._text is None:
            raise SubcertError("a mask has no sectors", remedy='name "catmull-clark" or "loop"')
        return sector(self._text, count(faces, "faces", 1), corner)

    @overload
    def range(self, parameter: Optional[str] = None, levels: int = 4) -> Intervals: ...

    @overload
    def range(
        self, parameter: Optional[str] = None, levels: int = 4, *, smoothness: int
    ) -> SmoothRange: ...

    def range(
        self,
        parameter: Optional[str] = None,
        levels: int = 4,
        *,
        smoothness: Optional[int] = None,
    ) -> Union[Intervals, SmoothRange]:
        """Where in a parameter, which is left open, T_c < 1 for some c up to levels: differences
        shrink there, and the scheme converges. With ``smoothness``, where all limits are C^m.

        >>> [interval] = Scheme("four-point").range(levels=1)
        >>> interval.low.as_fraction(), interval.high.as_fraction()
        (Fraction(-1, 4), Fraction(1, 4))
        >>> found = Scheme("ternary-four-point").range("mu", smoothness=2)
        >>> [(float(x.low), float(x.high)) for x in found.inside]
        [(0.06666666666666667, 0.1111111111111111)]
        """
        if self._text is None:
            raise SubcertError(
                "the range of a parameter needs a scheme of the catalogue or of a file",
                remedy="write the mask with its parameter in a scheme file",
            )
        parameter = parameter or self._parameter()
        levels = count(levels, "levels", 1)
        if smoothness is not None:
            inside, outside, exceptions, gap = _native.smooth_range(
                self._text, parameter, count(smoothness, "smoothness"), levels
            )
            return SmoothRange(
                [_interval(one) for one in inside],
                [_interval(one) for one in outside],
                exceptions,
                pair(gap),
            )
        _, union = _native.parameter_range(self._text, parameter, levels)
        return Intervals(_interval((ends, False, False)) for ends in union)

    def _parameter(self) -> str:
        names = _native.open_names(self._text or "")
        if len(names) == 1:
            return names[0]
        raise SubcertError(
            f"{len(names)} parameters are left open" + "".join(f", `{x}`" for x in names),
            remedy='name one, as in Scheme("four-point").range("w")',
        )

    def certify(self, levels: int = 4) -> Quantities:
        """All constants in floating point, beside their exact values and proven bounds.

        >>> all(x.bound is None or x.error <= x.bound for x in Scheme("chaikin").certify(2))
        True
        """
        quantities = self._native.certify(count(levels, "levels"))
        return Quantities(Quantity(name, value, coprime(*p), bound) for name, value, p, bound in quantities)

    def limit_stencils(self) -> List[LimitStencil]:
        """The limit as a combination of control points, exactly: at the parameter 0, where its weights are values of the
        basic limit function, and at the natural shift, where point 0 tends to.

        >>> [(x.at, x.weights) for x in Scheme("chaikin").limit_stencils()]
        [(Fraction(0, 1), {0: Fraction(1, 2), 1: Fraction(1, 2)}), (Fraction(-1, 2), {-1: Fraction(1, 8), 0: Fraction(3, 4), 1: Fraction(1, 8)})]
        """
        return [
            LimitStencil(coprime(*at), {i: coprime(*weight) for i, weight in weights})
            for at, weights in self._native.limit_stencils()
        ]

    @overload
    def refine(self, points: NDArray, levels: int = 1, *, closed: bool = True) -> Refined[NDArray]: ...

    @overload
    def refine(  # type: ignore[overload-overlap]
        self, points: Sequence[Sequence[Number]], levels: int = 1, *, closed: bool = True
    ) -> Refined[List[Tuple[float, ...]]]: ...

    @overload
    def refine(
        self, points: Sequence[Number], levels: int = 1, *, closed: bool = True
    ) -> Refined[List[float]]: ...

    @overload
    def refine(self, points: Frame, levels: int = 1, *, closed: bool = True) -> Refined[NDArray]: ...

    def refine(self, points: Any, levels: int = 1, *, closed: bool = True) -> Refined[Any]:
        """The polygon after some levels: numbers, points as tuples, or a numpy array of either.

        Floats of an array are taken for the numbers that they are.

        >>> Scheme("chaikin").refine([0, 4, 4, 0]).exact
        [Fraction(1, 1), Fraction(3, 1), Fraction(4, 1), Fraction(4, 1), Fraction(3, 1), Fraction(1, 1), Fraction(0, 1), Fraction(0, 1)]
        """
        coordinates, tuples, array = _coordinates(points)
        native = self._native.refine(coordinates, count(levels, "levels"), closed)
        columns = [[coprime(*x) for x in column] for column in native]
        floats = [[_native.nearest(x) for x in column] for column in columns]
        pairs = (p for column, other in zip(columns, floats) for p in zip(column, other))
        error = max((abs(x - Fraction(y)) for x, y in pairs), default=Fraction(0))
        bound = _above(error)
        shaped = [list(zip(*values)) if tuples else values[0] for values in (columns, floats)]
        return Refined(array(shaped[1]) if array else shaped[1], shaped[0], bound)

    def _repr_html_(self) -> str:
        if self._text is not None:
            return facts("Scheme", [("name", self._text)])
        rows = [[str(x) for x in row] for row in self.masks[0]]
        heads = [str(j + self.offsets[0]) for j in range(max(map(len, rows)))]
        return table("Mask: one rule in a row", heads, rows)

    def __repr__(self) -> str:
        if self._text is not None:
            return f"Scheme({self._text!r})"
        [(given, offset)] = self._native.masks
        if sum(x.bit_length() for row in given for pair in row for x in pair) > 400:
            return f"Scheme(mask of {len(given)} rules with {max(map(len, given))} coefficients, offset={offset})"
        rows = [[str(x) for x in row] for row in self.masks[0]]
        return f"Scheme(mask={rows}, offset={offset})"


def _rebuilt(kind: Any, text: Optional[str], masks: Any) -> Scheme:
    """A scheme from what ``__reduce__`` gives."""
    scheme = kind.__new__(kind)
    scheme._text, scheme._key = text, None
    scheme._known = None if masks is None else _native._Native.of_masks(masks)
    return scheme


def _valence(valence: Optional[SupportsIndex]) -> Optional[int]:
    return None if valence is None else count(valence, "valence", 1)


def schemes() -> List[str]:
    """The names of the catalogue.

    >>> "chaikin" in schemes()
    True
    """
    return _native.scheme_names()


def _interval(placed: Any) -> Interval:
    (low, high), low_included, high_included = placed
    return Interval(low and Algebraic(low), high and Algebraic(high), low_included, high_included)


def _above(value: Fraction) -> float:
    """A float that is not below the value."""
    import math

    nearest = float(value)
    return nearest if Fraction(nearest) >= value else math.nextafter(nearest, math.inf)


_MASKS = (
    'write the rules of a mask as Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]), or its symbol as text, '
    'Scheme("[1, 3, 3, 1]/4") or Scheme("z^-1*(1 + z)^3/4")'
)


def _of_mask(given: Any, offset: Optional[int]) -> Any:
    """The native scheme of a mask: rules, or the symbol."""
    mask = listed(given)
    if not isinstance(mask, Iterable):
        raise SubcertError(f"a {type(mask).__name__} is no mask", remedy=_MASKS)
    rows = [listed(row) for row in mask]
    flat = [isinstance(row, str) or not isinstance(row, Iterable) for row in rows]
    if any(flat) and not all(flat):
        raise SubcertError("some of the rules of the mask are lists, and some are numbers", remedy=_MASKS)
    symbol = bool(rows) and all(flat)
    if symbol and offset is not None:
        remedy = "a mask of rules has an offset: one list for each rule"
        raise SubcertError("a symbol has an offset of its own", remedy=remedy)
    rows = [rows] if symbol else [list(row) for row in rows]
    try:
        if symbol:
            numbers = [exact(x) for x in rows[0]]
            return _native._Native.named(f"[{', '.join(map(str, numbers))}]")
        return _native._Native.of_mask(rows, 0 if offset is None else offset)
    except SubcertError as error:
        hint = error.remedy or _of_floats(rows, symbol, hasattr(given, "astype"))
        # There is no text for a place to be in.
        raise SubcertError(error.message.replace(" (SCHEME:1:1)", ""), error.place, hint) from None


def _of_floats(rows: List[List[Any]], symbol: bool, array: bool) -> Optional[str]:
    """What is meant by floats with a wrong sum, which has a remedy where decimals or simple fractions have a right one."""
    if not any(isinstance(x, float) for row in rows for x in row):
        return None

    def sums(number: Any) -> bool:
        """Whether the sums are right with other numbers near the floats, and the numbers are near."""
        near = [[number(x) if isinstance(x, float) else exact(x) for x in row] for row in rows]
        same = all(abs(x - exact(y)) < Fraction(1, 10**6) for row, old in zip(near, rows) for x, y in zip(row, old))
        totals = map(sum, near)
        return same and all(x.denominator == 1 and x > 1 if symbol else x == 1 for x in totals)

    if sums(exact):
        return None
    if sums(lambda x: Fraction(str(x))):
        text = "mask.astype(str)" if array else "[[str(x) for x in row] for row in mask]"
        return f'a float is the number that it is: write "0.1" for 1/10, as {text} does'
    if sums(lambda x: Fraction(x).limit_denominator(1000)):
        return 'a float is the number that it is: write "1/3", or take Fraction(x).limit_denominator(1000) for each x'
    return None


def _is_mask(text: str) -> bool:
    """Whether a name is a mask as text, and not a file or a product.

    >>> _is_mask("[1, 3, 3, 1]/4"), _is_mask("(1 + z)^3/4"), _is_mask("chaikin"), _is_mask("[1].toml")
    (True, True, False, False)
    """
    # The variable of a symbol is a word; a value of a parameter is behind the colon.
    symbol = re.search(r"\bz\b", text.partition(":")[0])
    return ("[" in text or "{" in text or symbol is not None) and ".toml" not in text and " x " not in text


def _text(name: str, parameters: Dict[str, Number]) -> str:
    values = []
    for key, value in parameters.items():
        values.append(f"{key}={value if isinstance(value, str) else exact(value)}")
    return name if not values else f"{name}:{','.join(values)}"


def _coordinates(points: Any) -> Tuple[List[List[Any]], bool, Any]:
    """One list for each coordinate, whether points are tuples, and what makes an array of a list."""
    array = None
    if isinstance(points, (str, PathLike)):
        raise SubcertError(
            f"{str(points)!r} is text, and no list of points",
            remedy='read a file first: numpy.loadtxt("polygon.csv", delimiter=",")',
        )
    if hasattr(points, "shape"):
        import numpy

        array = numpy.asarray
        if len(points.shape) not in (1, 2):
            raise SubcertError(
                f"an array with {len(points.shape)} axes is no polygon",
                remedy="give one number or one row of coordinates for each point",
            )
    points = [listed(x) for x in listed(points)]
    if not points:
        raise SubcertError("there are no points")
    tuples = isinstance(points[0], (tuple, list))
    if not tuples:
        return [points], False, array
    if len({len(point) for point in points}) != 1 or not len(points[0]):
        raise SubcertError("all points need the same number of coordinates")
    return [list(column) for column in zip(*points)], True, array
