"""Masks on Z^d with a dilation matrix."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from os import PathLike, fspath
from typing import Dict, List, Optional, Tuple, Union

from . import _native
from ._analysis import Exponent, exponent_of, smoothness_rows
from ._answer import Answer
from ._html import facts
from ._numbers import Number, coprime, count
from ._scheme import _text

#: A place of Z^d.
Place = Tuple[int, ...]


@dataclass(frozen=True)
class LatticeSmoothness(Answer):
    """How smooth the limits of a mask on Z^d are; None stands for what is not shown.

    >>> found = Lattice("loop-regular").smoothness()
    >>> found.sum_rules, found.continuity, found.continuity_fails, found.hoelder.formula
    (4, 2, 3, '3')
    """

    #: The order of the sum rules.
    sum_rules: int
    #: All polynomials of a degree below are sums of shifts of the basic limit function, and not all of this degree.
    accuracy: Optional[int]
    #: Whether the scheme converges for all data.
    converges: Optional[bool]
    #: The greatest m for which the limits are proven to be C^m.
    continuity: Optional[int]
    #: The least m for which it is proven that not all limits are C^m.
    continuity_fails: Optional[int]
    hoelder: Optional[Exponent]
    #: Why something is open.
    open: Optional[str]

    def _repr_html_(self) -> str:
        rows = smoothness_rows(self.continuity, self.continuity_fails, self.hoelder, self.sum_rules)
        return facts("Smoothness", rows)


class Lattice:
    """A mask on Z^d: (Sp)_α = Σ_β a(α − Mβ) p_β. It is named as on the command line: an entry of the catalogue, a
    symbol, a list of lists, a box spline, or a product of schemes of curves.

    >>> courant = Lattice("(1+x)*(1+y)*(1+x*y)/2")
    >>> courant.dilation, courant.coefficients[1, 1]
    (((2, 0), (0, 2)), Fraction(1, 1))
    >>> butterfly = Lattice("butterfly-regular", w="1/16")
    >>> butterfly.contraction(1), butterfly.norm(1)
    (Fraction(3, 4), Fraction(3, 2))
    """

    #: M, row by row.
    dilation: Tuple[Place, ...]
    #: The coefficients a(α) that are not 0.
    coefficients: Dict[Place, Fraction]
    #: The edges along which data are compared.
    edges: Tuple[Place, ...]
    #: τ: the point α of level k is at M^-k (α + τ), if it is at its natural place.
    natural_shift: Tuple[Fraction, ...]

    def __init__(self, name: Union[str, PathLike[str]], **parameters: Number) -> None:
        self._text = _text(fspath(name), parameters)
        rows, coefficients, edges, shift = _native.lattice_parts(self._text)
        self.dilation = tuple(map(tuple, rows))
        self.coefficients = _places(coefficients)
        self.edges = tuple(map(tuple, edges))
        self.natural_shift = tuple(coprime(*x) for x in shift)

    def __repr__(self) -> str:
        return f"Lattice({self._text!r})"

    def contraction(self, c: int = 1) -> Fraction:
        """T_c: the greatest difference along an edge after c levels, of data that differ by at most 1 along edges.

        >>> Lattice("loop-regular").contraction(2)
        Fraction(1, 4)
        """
        return coprime(*_native.lattice_constants(self._text, count(c, "c"))[0])

    def norm(self, c: int = 1) -> Fraction:
        """Λ_c: the greatest sum of absolute values of the rules of c levels.

        >>> Lattice("loop-regular").norm()
        Fraction(1, 1)
        """
        return coprime(*_native.lattice_constants(self._text, count(c, "c"))[1])

    def displacement(self, *, natural: bool = True) -> Optional[Fraction]:
        """σ: how far one level moves nets that differ by at most 1 along edges; None where it is not defined.

        >>> Lattice("loop-regular").displacement()
        Fraction(3, 8)
        """
        found = _native.lattice_displacement(self._text, natural)
        return None if found is None else coprime(*found)

    def depth(
        self, tolerance: Number, spread: Number = 1, *, natural: bool = True
    ) -> Tuple[int, Optional[int]]:
        """The number of levels that a tolerance needs, for all nets that differ by at most the spread along edges: fewer
        than the first are too few for some net, and the second is enough for all; None where no such number is known.

        >>> Lattice("loop-regular").depth("1/100")
        (3, 3)
        """
        return _native.lattice_depth(self._text, tolerance, spread, natural)

    def values(self, level: int = 0) -> Dict[Place, Fraction]:
        """The basic limit function at M^-k α, by α, where it is not 0; at integers these are the weights of the limit.

        >>> Lattice("loop-regular").values()[0, 0]
        Fraction(1, 2)
        """
        return _places(_native.lattice_values(self._text, count(level, "level")))

    def smoothness(self) -> LatticeSmoothness:
        """How smooth the limits are.

        >>> Lattice("butterfly-regular", w="1/16").smoothness().continuity
        1
        """
        sum_rules, accuracy, converges, continuity, fails, hoelder, rest = (
            _native.lattice_smoothness(self._text)
        )
        return LatticeSmoothness(
            sum_rules, accuracy, converges, continuity, fails, exponent_of(hoelder), rest
        )


def _places(found: List[Tuple[List[int], Tuple[int, int]]]) -> Dict[Place, Fraction]:
    return {tuple(place): coprime(*value) for place, value in found}
