"""Exact numbers."""

from __future__ import annotations

import math
from decimal import Context, Decimal
from fractions import Fraction
from operator import index
from typing import Any, Callable, List, Optional, Protocol, Sequence, SupportsIndex, Tuple, Union

from . import _native
from ._errors import SubcertError


class Ratio(Protocol):
    """What knows the fraction that it is: floats of numpy, and numbers of this module that are rational."""

    def as_integer_ratio(self) -> Tuple[int, int]: ...


class Array(Protocol):
    """Arrays of numpy, and tables of pandas."""

    @property
    def shape(self) -> Any: ...


class Frame(Protocol):
    """Tables of pandas."""

    def to_numpy(self) -> Any: ...


#: What is read as an exact number: an int, a Fraction, a Decimal, text such as "3/256" or "0.1", or a float,
#: which is the dyadic number that it is; numpy's numbers too.
Number = Union[int, Fraction, Decimal, str, float, SupportsIndex, Ratio]

#: Numbers, such as a rule of a mask or a point, and rows of them.
Numbers = Union[Sequence[Number], Array]
Rows = Union[Sequence[Numbers], Array]


def exact(value: Any) -> Fraction:
    """The fraction that a number is. A float is taken for the number that it is.

    >>> exact("0.1"), exact(0.5)
    (Fraction(1, 10), Fraction(1, 2))
    >>> exact(0.1)
    Fraction(3602879701896397, 36028797018963968)
    """
    return coprime(*_native.exact(value))


def decimal(value: Fraction, digits: int = 6) -> str:
    """The first digits of a fraction, also where it is beyond floats.

    >>> decimal(Fraction(1, 3)), decimal(Fraction(10**400, 3))
    ('0.333333', '3.33333e+399')
    """
    try:
        near = float(value)
        if math.isfinite(near) and (near or not value):
            return f"{near:.{digits}g}"
    except OverflowError:
        pass
    context = Context(prec=digits, Emax=10**9, Emin=-(10**9))
    return f"{context.divide(Decimal(value.numerator), Decimal(value.denominator)):.{digits}g}"


def listed(given: Any) -> Any:
    """Lists of what is in an array or in a table of pandas; other things as they are.

    >>> listed([1, 2]), listed((1, 2))
    ([1, 2], (1, 2))
    """
    if hasattr(given, "to_numpy"):
        given = given.to_numpy()
    if getattr(given, "shape", ()) and hasattr(given, "tolist"):
        return given.tolist()
    return given


#: The greatest count that the native part takes.
_MOST = 2**32 - 1


def count(value: Any, name: str, least: int = 0) -> int:
    """A count that is given as the argument of this name.

    >>> count(3, "levels")
    3
    """
    try:
        number = index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; give an int from {least} on") from None
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


def _is_nan(value: Any) -> bool:
    return isinstance(value, float) and math.isnan(value)


IRRATIONAL = "this is not computed of two irrational numbers, of which one is a root of a polynomial"

#: Numbers of digits that are tried one after the other.
_DIGITS = (20, 100, 1_000, 10_000)


class ExactNumber:
    """What exact numbers have in common: they compare by their values, and are rounded and formatted as the
    float nearest to them."""

    __slots__ = ()

    def as_fraction(self) -> Optional[Fraction]:
        raise NotImplementedError

    def _compare(self, other: Any) -> int:
        """-1, 0 or 1, where the nearest floats are the same."""
        raise NotImplementedError

    def as_integer_ratio(self) -> Tuple[int, int]:
        """Numerator and denominator, as a float has them; an error where the number is irrational."""
        rational = self.as_fraction()
        if rational is None:
            raise SubcertError(f"{self} is irrational", remedy="take its float()")
        return rational.numerator, rational.denominator

    def __float__(self) -> float:
        raise NotImplementedError

    def __format__(self, spec: str) -> str:
        return format(float(self), spec) if spec else str(self)

    def __round__(self, digits: Optional[int] = None) -> Any:
        return round(float(self), digits)

    def _order(self, other: Any) -> Any:
        """-1, 0 or 1; None beside what is no number."""
        if not isinstance(other, ExactNumber):
            # A text is no number here: it would have another hash.
            if isinstance(other, str) or _is_nan(other):
                return None
            if isinstance(other, float) and math.isinf(other):
                return -1 if other > 0 else 1
            try:
                other = exact(other)
            except SubcertError:
                return None
        try:
            # To round keeps the order.
            mine, theirs = float(self), float(other)
            if mine != theirs:
                return -1 if mine < theirs else 1
        except OverflowError:
            pass
        rational = self.as_fraction()
        if rational is not None and isinstance(other, Fraction):
            return (rational > other) - (rational < other)
        return self._compare(other)

    def _ordered(self, other: Any, holds: Callable[[int], bool]) -> bool:
        order = self._order(other)
        if order is None:
            return False if _is_nan(other) else NotImplemented
        return holds(order)

    def __eq__(self, other: object) -> bool:
        order = self._order(other)
        return NotImplemented if order is None else order == 0

    def __lt__(self, other: Any) -> bool:
        return self._ordered(other, lambda order: order < 0)

    def __le__(self, other: Any) -> bool:
        return self._ordered(other, lambda order: order <= 0)

    def __gt__(self, other: Any) -> bool:
        return self._ordered(other, lambda order: order > 0)

    def __ge__(self, other: Any) -> bool:
        return self._ordered(other, lambda order: order >= 0)

    def __hash__(self) -> int:
        rational = self.as_fraction()
        return hash(float(self)) if rational is None else hash(rational)


class ExactField(ExactNumber):
    """Arithmetic, which stays exact."""

    __slots__ = ()

    def _plus(self, other: Any) -> Any:
        raise NotImplementedError

    def _times(self, other: Any) -> Any:
        raise NotImplementedError

    def _reciprocal(self) -> Any:
        raise NotImplementedError

    def _with(self, other: Any, compute: Callable[[Any], Any]) -> Any:
        if isinstance(other, str):
            return NotImplemented
        rational = other.as_fraction() if isinstance(other, ExactField) else None
        if rational is not None:
            other = rational
        elif not isinstance(other, ExactField):
            try:
                other = exact(other)
            except SubcertError:
                return NotImplemented
        return compute(other)

    def __add__(self, other: Any) -> Any:
        return self._with(other, self._plus)

    __radd__ = __add__

    def __mul__(self, other: Any) -> Any:
        return self._with(other, self._times)

    __rmul__ = __mul__

    def __neg__(self) -> Any:
        return self._times(Fraction(-1))

    def __pos__(self) -> Any:
        return self

    def __abs__(self) -> Any:
        return -self if self < 0 else self

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda y: self._plus(-y))

    def __rsub__(self, other: Any) -> Any:
        return self._with(other, lambda y: (-self)._plus(y))

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, lambda y: self._times(_reciprocal(y)))

    def __rtruediv__(self, other: Any) -> Any:
        return self._with(other, lambda y: _reciprocal(self)._times(y))


def _reciprocal(value: Any) -> Any:
    """1/value.

    >>> _reciprocal(Fraction(2))
    Fraction(1, 2)
    """
    if value == 0:
        raise ZeroDivisionError("division by zero")
    return 1 / value if isinstance(value, Fraction) else value._reciprocal()


class Algebraic(ExactField):
    """A real algebraic number, exactly. Numbers compare with each other and with fractions. They are
    equal where their values are, and can be copied and pickled. Sums, products and quotients with rational numbers
    are exact; of two irrational numbers they are not computed.

    >>> from subcert import Scheme
    >>> end = Scheme("four-point").range("w", levels=2)[-1].high
    >>> end.minpoly, float(end)
    ([-3, 4, 16], 0.32569390943299864)
    >>> end < Fraction(1, 3), f"{end:.4f}", round(end, 2)
    (True, '0.3257', 0.33)
    >>> (2 * end + 1).minpoly
    [-1, -6, 4]
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
        if isinstance(other, Fraction):
            return self._number.compare(other)
        return -other._compare(self)

    def _plus(self, other: Any) -> Any:
        if isinstance(other, Fraction):
            return self._affine(Fraction(1), other)
        return other._plus(self._rational())

    def _times(self, other: Any) -> Any:
        if isinstance(other, Fraction):
            return self._affine(other, Fraction(0)) if other else _algebraic([0, 1], (0, 1), (0, 1))
        return other._times(self._rational())

    def _rational(self) -> Fraction:
        """The number, beside an irrational one."""
        rational = self.as_fraction()
        if rational is None:
            raise SubcertError(IRRATIONAL, remedy="take float() of both")
        return rational

    def _affine(self, factor: Fraction, shift: Fraction) -> "Algebraic":
        """factor·x + shift, a root of p((y − shift)/factor), where x is one of p."""
        coefficients, low, high = self._number.parts()
        found: List[Fraction] = []
        for coefficient in reversed(coefficients):
            # Horner's rule: times (y − shift)/factor.
            moved = [Fraction(0), *found]
            found = [(a - shift * b) / factor for a, b in zip(moved, [*found, Fraction(0)])] or [Fraction(0)]
            found[0] += coefficient
        scale = math.lcm(*(x.denominator for x in found))
        ends = sorted(factor * coprime(*end) + shift for end in (low, high))
        return _algebraic([int(x * scale) for x in found], *(end.as_integer_ratio() for end in ends))

    def _reciprocal(self) -> "Algebraic":
        coefficients, _, _ = self._number.parts()
        low, high = next(ends for ends in map(self.interval, _DIGITS) if ends[0] > 0 or ends[1] < 0)
        return _algebraic(coefficients[::-1], (1 / high).as_integer_ratio(), (1 / low).as_integer_ratio())

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
