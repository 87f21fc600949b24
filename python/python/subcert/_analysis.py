"""Smoothness, spectra and joint spectral radii."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _native
from ._answer import Answer, Table
from ._errors import SubcertError
from ._html import facts
from ._numbers import (
    IRRATIONAL,
    Algebraic,
    Array,
    ExactField,
    ExactNumber,
    Rows,
    coprime,
    exact,
    listed,
    pair,
)


@dataclass(frozen=True, eq=False)
class Real(ExactField):
    """A real number: exactly as text, as a fraction if it is one, and the nearest float. Comparisons and arithmetic
    are exact.

    >>> from subcert import Scheme
    >>> value = Scheme("catmull-clark").spectrum(5).subdominant
    >>> float(value), value.fraction, f"{value:.3f}"
    (0.5499883545182972, None, '0.550')
    >>> value > Fraction(1, 2), (value - value).fraction
    (True, Fraction(0, 1))
    """

    text: str
    fraction: Optional[Fraction]
    value: float

    def as_fraction(self) -> Optional[Fraction]:
        """The fraction.

        >>> Real("1/2", Fraction(1, 2), 0.5).as_fraction()
        Fraction(1, 2)
        """
        return self.fraction

    def _compare(self, other: Any) -> int:
        if isinstance(other, Algebraic):
            return Algebraic(_native.real_as_algebraic(self.text))._compare(other)
        if isinstance(other, Real) and self.text == other.text:
            return 0
        return _native.compare_reals(self.text, _formula(other))

    def _plus(self, other: Any) -> Any:
        return _real(_native.real(f"({self.text}) + ({_formula(other)})"))

    def _times(self, other: Any) -> Any:
        return _real(_native.real(f"({self.text}) * ({_formula(other)})"))

    def _reciprocal(self) -> Any:
        return _real(_native.real(f"1 / ({self.text})"))

    def __float__(self) -> float:
        """The nearest float.

        >>> float(Real("1/2", Fraction(1, 2), 0.5))
        0.5
        """
        return self.value

    def __str__(self) -> str:
        return self.text if len(self.text) <= 60 else repr(self.value)


def _formula(value: Any) -> str:
    if isinstance(value, Algebraic):
        raise SubcertError(IRRATIONAL, remedy="take float() of both")
    return value.text if isinstance(value, Real) else str(value)


@dataclass(frozen=True, eq=False)
class Exponent(ExactNumber):
    """A Hölder exponent: a formula where it is known exactly, and two numbers around it.

    >>> from subcert import Scheme
    >>> found = Scheme("six-point", w=Fraction(3, 256)).smoothness().hoelder
    >>> found.formula, round(float(found), 6), found.attained
    ('6 - log_2(9)', 2.830075, True)
    """

    formula: Optional[str]
    low: Fraction
    high: Fraction
    #: Whether it is attained; None where that is open.
    attained: Optional[bool]

    def __float__(self) -> float:
        """The middle of the two numbers around it.

        >>> float(Exponent("2", Fraction(2), Fraction(2), False))
        2.0
        """
        return float((self.low + self.high) / 2)

    def as_fraction(self) -> Optional[Fraction]:
        """The exponent, where the two numbers around it are one.

        >>> Exponent("2", Fraction(2), Fraction(2), False).as_fraction()
        Fraction(2, 1)
        """
        return self.low if self.low == self.high else None

    def _order(self, other: Any) -> Any:
        if isinstance(other, Exponent):
            low, high = other.low, other.high
            if self.formula is not None and self.formula == other.formula:
                return 0
        elif isinstance(other, float) and not math.isfinite(other):
            return super()._order(other)
        elif isinstance(other, str):
            return None
        else:
            try:
                low = high = exact(other)
            except SubcertError:
                return None
        if self.low > high or self.high < low:
            return 1 if self.low > high else -1
        if self.low == self.high == low == high:
            return 0
        raise SubcertError(
            f"this exponent is between {float(self.low)!r} and {float(self.high)!r}: the comparison is open",
            remedy="compare low and high",
        )

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Exponent):
            mine = self.formula, self.low, self.high, self.attained
            return mine == (other.formula, other.low, other.high, other.attained)
        return super().__eq__(other)

    def __hash__(self) -> int:
        rational = self.as_fraction()
        return hash((self.formula, self.low, self.high)) if rational is None else hash(rational)


@dataclass(frozen=True)
class Smoothness(Answer):
    """How smooth the limits of a scheme for curves are; None stands for what is not shown.

    >>> from subcert import Scheme
    >>> found = Scheme("four-point", w=Fraction(1, 16)).smoothness()
    >>> found.continuity, found.continuity_fails, found.hoelder.formula
    (1, 2, '2')
    """

    arity: int
    #: The order of the sum rules.
    sum_rules: int
    #: The degree up to which polynomials are reproduced.
    reproduction: int
    natural_shift: Optional[Fraction]
    #: Whether the shifts of the basic limit function are linearly independent.
    independent: Optional[bool]
    #: The greatest m for which the limits are proven to be C^m.
    continuity: Optional[int]
    #: The least m for which it is proven that not all limits are C^m; 0 says that the scheme diverges.
    continuity_fails: Optional[int]
    hoelder: Optional[Exponent]

    def _repr_html_(self) -> str:
        known = smoothness_rows(self.continuity, self.continuity_fails, self.hoelder, self.sum_rules)
        more = [("reproduces degree", self.reproduction), ("natural shift", self.natural_shift)]
        return facts("Smoothness", known + more)


@dataclass(frozen=True)
class VertexSmoothness(Answer):
    """Whether surfaces are C¹ at a vertex or on a face, of generic data.

    >>> from subcert import Scheme
    >>> Scheme("loop").smoothness(5).continuous
    True
    """

    valence: int
    #: True where C¹ is proved, False where it is refuted, None where neither is shown.
    continuous: Optional[bool]
    #: Why, in words.
    reason: str

    def _repr_html_(self) -> str:
        said = {True: "proved", False: "refuted", None: "open"}[self.continuous]
        return facts("Smoothness", [("valence", self.valence), ("C^1", said), ("as", self.reason)])


@dataclass(frozen=True)
class Eigenvalue:
    """An eigenvalue, of the Fourier blocks that have it; a pair x ± iy where ``imaginary`` is y.

    >>> from subcert import Scheme
    >>> first = Scheme("doo-sabin").spectrum(5).eigenvalues[1]
    >>> first.real.fraction, first.multiplicity, first.blocks
    (Fraction(1, 2), 2, [1, 4])
    """

    real: Real
    imaginary: Optional[Real]
    multiplicity: int
    blocks: List[int]


@dataclass(frozen=True)
class ComplexEigenvalues:
    """Complex eigenvalues that are not computed, of these Fourier blocks, each as often as it has one.

    The greatest of their absolute values is at least ``lower`` and at most ``upper``.

    >>> from subcert import Scheme
    >>> found = Scheme("kobbelt").spectrum(5)
    >>> found.complex[0].blocks, float(found.complex[0].upper)
    ([2, 2, 3, 3], 0.198672)
    """

    blocks: List[int]
    lower: Fraction
    upper: Fraction


@dataclass(frozen=True)
class Spectrum(Table):
    """The eigenvalues of rules around a vertex or on a face, and stencils: pairs of a point and a weight.

    >>> from subcert import Scheme
    >>> found = Scheme("loop").spectrum(6)
    >>> found.subdominant.fraction, found.curvature
    (Fraction(1, 2), 'bounded')
    >>> found.limit[0][0], found.limit[0][1].fraction
    ('vertex', Fraction(1, 2))
    """

    valence: int
    #: All eigenvalues, in descending order of the absolute value, but for those of ``complex``.
    eigenvalues: List[Eigenvalue]
    #: Complex eigenvalues that are not computed; they are below λ.
    complex: List[ComplexEigenvalues]
    #: Whether 1 is simple, and all others are below 1 in absolute value.
    simple_one: bool
    #: The double eigenvalue λ of the blocks 1 and n − 1, if it exceeds all later ones; None without one.
    subdominant: Optional[Real]
    #: The greatest absolute value after λ.
    next: Optional[Real]
    #: ``bounded``, ``vanishing`` or ``unbounded``.
    curvature: Optional[str]
    limit: Optional[List[Tuple[str, Real]]]
    #: Two stencils of tangents, whose cross product is a normal.
    tangents: Optional[List[List[Tuple[str, Real]]]]
    #: What is to be told of the numbers, such as that they are those of two steps.
    notes: List[str]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each eigenvalue.

        >>> from subcert import Scheme
        >>> Scheme("loop").spectrum(6).rows()[0]["multiplicity"]
        1
        """
        return _rows(self.eigenvalues)

    def _caption(self) -> str:
        return f"Eigenvalues, valence {self.valence}"


@dataclass(frozen=True)
class Across:
    """What goes from a vertex between two sharp edges into the sector: the greatest eigenvalue of block 1.

    >>> from subcert import Scheme
    >>> across = Scheme("loop").sector(4).across
    >>> across.eigenvalue.text, across.comparison, across.second_above
    ('3/8 + 1/4*cos(pi/4)', 'above', False)
    """

    eigenvalue: Real
    #: ``below``, ``equal`` or ``above``: compared with 1/2, the eigenvalue along sharp edges.
    comparison: str
    #: Whether block 2 has an eigenvalue above 1/2, too: on a crease, normals of generic data then have no limit.
    second_above: bool
    #: The weights in the tangent; None where 1/2 has a Jordan block.
    tangent: Optional[List[Tuple[str, Real]]]


@dataclass(frozen=True)
class Sector(Table):
    """The eigenvalues and stencils at a vertex on a crease, at a corner or at the boundary, between two sharp edges.

    >>> from subcert import Scheme
    >>> found = Scheme("catmull-clark").sector(2)
    >>> [(point, str(weight)) for point, weight in found.limit if weight.fraction]
    [('vertex', '2/3'), ('edge[0]', '1/6'), ('edge[2]', '1/6')]
    """

    faces: int
    corner: bool
    #: All eigenvalues, in descending order of the absolute value; block 0 is the vertex with the sharp edges.
    eigenvalues: List[Eigenvalue]
    limit: List[Tuple[str, Real]]
    #: The weights in the tangent along a crease, or at a corner in those along both sharp edges.
    along: List[List[Tuple[str, Real]]]
    #: None for one face at a corner.
    across: Optional[Across]

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each eigenvalue.

        >>> from subcert import Scheme
        >>> Scheme("loop").sector(4).rows()[0]["value"]
        1.0
        """
        return _rows(self.eigenvalues)

    def _caption(self) -> str:
        return f"Eigenvalues, {self.faces} faces {'at a corner' if self.corner else 'on a crease'}"


@dataclass(frozen=True)
class JointRadius(Answer):
    """A joint spectral radius: at least ``root`` to the power 1/``degree``, which is that of a product.

    >>> found = jsr([[[1, 1], [0, 1]], [[1, 0], [1, 1]]])
    >>> found.exact, found.product, found.root.minpoly, round(float(found), 6)
    (True, [0, 1], [1, -3, 1], 1.618034)
    """

    #: The factors of the product, counted from 0.
    product: List[int]
    root: Algebraic
    degree: int
    #: Whether the radius is that root, by an extremal hull.
    exact: bool
    #: Two numbers that the radius is between.
    interval: Tuple[Fraction, Fraction]

    def __float__(self) -> float:
        """The middle of the interval.

        >>> float(jsr([[["1/2"]]]))
        0.5
        """
        return float(sum(self.interval) / 2)

    def _repr_html_(self) -> str:
        low, high = map(float, self.interval)
        product = " ".join(f"M_{i}" for i in self.product)
        rows = [("from", low), ("to", high), ("exact", self.exact), ("product", product)]
        return facts("Joint spectral radius", rows)


def jsr(matrices: Union[Sequence[Rows], Array]) -> JointRadius:
    """The joint spectral radius of square matrices: lists, or numpy arrays, of exact numbers.

    >>> found = jsr([[[1, 1], [0, 1]], [[0.5, 0], [0, 0.5]]])
    >>> found.interval[0]
    Fraction(1, 1)
    """
    rows = [[list(listed(row)) for row in listed(matrix)] for matrix in listed(matrices)]
    product, root, degree, exact, (low, high) = _native.jsr(rows)
    interval = coprime(*low), coprime(*high)
    return JointRadius(product, Algebraic(root), degree, exact, interval)


def of_curve(native: Any) -> Smoothness:
    arity, sum_rules, reproduction, shift, independent, continuity, fails, exponent = (
        _native.smoothness(native)
    )
    hoelder = exponent_of(exponent)
    return Smoothness(
        arity, sum_rules, reproduction, pair(shift), independent, continuity, fails, hoelder
    )


def smoothness_rows(
    continuity: Optional[int], fails: Optional[int], exponent: Optional[Exponent], sum_rules: int
) -> List[Tuple[str, Any]]:
    return [
        ("limits are", None if continuity is None else f"C^{continuity}"),
        ("not all are", None if fails is None else f"C^{fails}"),
        ("Hölder exponent", exponent and (exponent.formula or float(exponent))),
        ("sum rules", sum_rules),
    ]


def exponent_of(found: Any) -> Optional[Exponent]:
    if found is None:
        return None
    formula, low, high, attained = found
    return Exponent(formula, coprime(*low), coprime(*high), attained)


def of_vertex(text: str, valence: Optional[int]) -> VertexSmoothness:
    order, verdict, reason = _native.vertex_smoothness(text, valence)
    return VertexSmoothness(order, {"proved": True, "refuted": False}.get(verdict), reason)


def spectrum(text: str, valence: Optional[int]) -> Spectrum:
    order, eigenvalues, others, simple, subdominant, following, curvature, limit, tangents, notes = (
        _native.spectrum(text, valence)
    )

    return Spectrum(
        order,
        _eigenvalues(eigenvalues),
        [ComplexEigenvalues(blocks, Fraction(*low), Fraction(*high)) for blocks, low, high in others],
        simple,
        subdominant and _real(subdominant),
        following and _real(following),
        curvature,
        None if limit is None else _stencil(limit),
        None if tangents is None else [_stencil(one) for one in tangents],
        notes,
    )


def sector(text: str, faces: int, corner: bool) -> Sector:
    eigenvalues, limit, along, across = _native.sector(text, faces, corner)
    found = None
    if across is not None:
        value, comparison, second, tangent = across
        stencil = None if tangent is None else _stencil(tangent)
        found = Across(_real(value), comparison, second, stencil)
    tangents = [_stencil(one) for one in along]
    return Sector(faces, corner, _eigenvalues(eigenvalues), _stencil(limit), tangents, found)


def _rows(eigenvalues: List[Eigenvalue]) -> List[Dict[str, Any]]:
    return [
        {
            "value": x.real.value,
            "imaginary": x.imaginary and x.imaginary.value,
            "exact": str(x.real),
            "multiplicity": x.multiplicity,
            "blocks": x.blocks,
        }
        for x in eigenvalues
    ]


def _eigenvalues(found: Any) -> List[Eigenvalue]:
    return [Eigenvalue(_real(x), y and _real(y), count, blocks) for x, y, count, blocks in found]


def _stencil(weights: Any) -> List[Tuple[str, Real]]:
    return [(point, _real(weight)) for point, weight in weights]


def _real(value: Any) -> Real:
    text, fraction, nearest = value
    return Real(text, pair(fraction), nearest)
