"""Exact numbers."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from functools import total_ordering
from operator import index
from typing import Any, List, Optional, Tuple, Union

from . import _native
from ._errors import SubcertError

#: What is read as an exact number: an int, a Fraction, a Decimal, text such as "3/256" or "0.1", or a float,
#: which is the dyadic number that it is.
Number = Union[int, Fraction, Decimal, str, float]


def exact(value: Any) -> Fraction:
    """The fraction that a number is. A float is taken for the number that it is.

    >>> exact("0.1"), exact(0.5)
    (Fraction(1, 10), Fraction(1, 2))
    >>> exact(0.1)
    Fraction(3602879701896397, 36028797018963968)
    """
    try:
        finite = not isinstance(value, float) or math.isfinite(value)
        if finite and not isinstance(value, bool):
            return Fraction(value)
    except (TypeError, ValueError, ZeroDivisionError):
        pass
    raise SubcertError(f"{value!r} is no number", remedy="give a finite number")


#: The greatest count that the native part takes.
_MOST = 2**32 - 1


def count(value: Any, name: str, least: int = 0) -> int:
    """A count that is given as the argument of this name.

    >>> count(3, "levels")
    3
    """
    number = index(value)
    if number < least:
        raise SubcertError(f"{name} is {number}", remedy=f"give an int from {least} on")
    if number > _MOST:
        raise SubcertError(f"{name} is {number}", remedy=f"give an int up to {_MOST}")
    return number


if hasattr(Fraction, "_from_coprime_ints"):  # from Python 3.12 on
    coprime = Fraction._from_coprime_ints
else:

    def coprime(numerator: int, denominator: int) -> Fraction:
        """The fraction of two integers without a common factor, which is not looked for once more."""
        return Fraction(numerator, denominator, _normalize=False)  # type: ignore[call-arg]


def pair(value: Optional[Tuple[int, int]]) -> Optional[Fraction]:
    return None if value is None else coprime(*value)


@total_ordering
class Algebraic:
    """A real algebraic number, exactly. Numbers compare with each other and with fractions. They are
    equal where their values are, and can be copied and pickled.

    >>> from subcert import Scheme
    >>> end = Scheme("four-point").range("w", levels=2)[-1].high
    >>> end.minpoly, float(end)
    ([-3, 4, 16], 0.32569390943299864)
    >>> end < Fraction(1, 3)
    True
    """

    __slots__ = ("_number",)

    def __init__(self, number: Any) -> None:
        self._number = number

    @property
    def minpoly(self) -> List[int]:
        """The coefficients of the minimal polynomial, from the constant one on."""
        return self._number.minpoly

    def interval(self, digits: int = 20) -> Tuple[Fraction, Fraction]:
        """Two fractions that the number is between, at most 10^-digits apart.

        >>> from subcert import Scheme
        >>> low, high = Scheme("four-point").range("w", levels=2)[-1].high.interval(6)
        >>> high - low <= Fraction(1, 10**6)
        True
        """
        low, high = self._number.interval(count(digits, "digits"))
        return coprime(*low), coprime(*high)

    def as_fraction(self) -> Optional[Fraction]:
        """The number as a fraction; None if it is irrational.

        >>> from subcert import Scheme
        >>> Scheme("four-point").range("w", levels=1)[0].high.as_fraction()
        Fraction(1, 4)
        """
        return pair(self._number.as_fraction())

    def __float__(self) -> float:
        """The nearest float."""
        return float(self._number)

    def _compare(self, other: Any) -> int:
        if isinstance(other, Algebraic):
            return self._number.compare(other._number)
        return self._number.compare(exact(other))

    # A text is no number here: it would have another hash.

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            return NotImplemented
        try:
            return self._compare(other) == 0
        except SubcertError:
            return NotImplemented

    def __lt__(self, other: Any) -> bool:
        if isinstance(other, str):
            return NotImplemented
        return self._compare(other) < 0

    def __hash__(self) -> int:
        rational = self.as_fraction()
        return hash(float(self)) if rational is None else hash(rational)

    def __repr__(self) -> str:
        rational = self.as_fraction()
        if rational is not None:
            text = str(rational) if rational.denominator.bit_length() < 200 else f"near {float(rational)!r}"
            return f"Algebraic({text})"
        try:
            text = str(self.minpoly)
        except (SubcertError, ValueError):
            # It is too large to factor, or to print.
            text = ""
        near = f"near {float(self)!r}"
        return f"Algebraic(minpoly={text}, {near})" if 0 < len(text) <= 60 else f"Algebraic({near})"

    def __reduce__(self) -> Tuple[Any, ...]:
        return _algebraic, self._number.parts()


def _algebraic(coefficients: List[int], low: Tuple[int, int], high: Tuple[int, int]) -> Algebraic:
    """The root of a polynomial that is between two fractions.

    >>> float(_algebraic([-2, 0, 1], (1, 1), (2, 1)))
    1.4142135623730951
    """
    return Algebraic(_native._Algebraic.of_parts(coefficients, low, high))
