"""Assertions for the tests of other programs.

>>> from fractions import Fraction
>>> assert_within_ulps(0.3, Fraction(3, 10))
"""

from __future__ import annotations

from typing import Any, List

from . import _native
from ._errors import SubcertError
from ._scheme import Scheme

__all__ = ["OracleValues", "assert_within_ulps"]


def assert_within_ulps(actual: Any, exact: Any, ulps: float = 1.0) -> None:
    """Asserts that floats are within so many units in the last place of exact values.

    ``actual`` is a float or any nested lists or array of floats, ``exact`` an exact number, or such
    numbers in the same shape. The message names the first value that is too far and the worst one, in
    decimals and hexadecimals.

    >>> try:
    ...     assert_within_ulps([0.1 + 0.2], ["3/10"], ulps=0.5)
    ... except AssertionError as error:
    ...     print("0x1.3333333333334p-2" in str(error))
    True
    """
    values, numbers = _flat(actual), _flat(exact)
    wrong = _native.check_within_ulps([float(value) for value in values], numbers, ulps)
    if wrong is not None:
        raise AssertionError(wrong)


def _flat(values: Any) -> List[Any]:
    if hasattr(values, "dtype") and hasattr(values, "tolist"):
        values = values.tolist()
    if not isinstance(values, (list, tuple)):
        return [values]
    return [x for value in values for x in _flat(value)]


class OracleValues:
    """Exact reference values for a refinement of one's own; the pytest fixture ``subcert_oracle``."""

    def polygon(self, scheme: Scheme, points: Any, levels: int, *, closed: bool = True) -> List[Any]:
        """The exact points of a level.

        >>> OracleValues().polygon(Scheme("chaikin"), [0, 4, 4, 0], 1)[:3]
        [Fraction(1, 1), Fraction(3, 1), Fraction(4, 1)]
        """
        return scheme.refine(points, levels, closed=closed).exact

    def assert_refines(
        self,
        refine: Any,
        scheme: Scheme,
        points: Any,
        levels: int,
        *,
        closed: bool = True,
        ulps: float = 4.0,
    ) -> None:
        """Asserts that ``refine(points, levels)`` gives the points of a level, in floats."""
        if levels < 0:
            raise SubcertError("the level is negative")
        exact = self.polygon(scheme, points, levels, closed=closed)
        assert_within_ulps(refine(points, levels), exact, ulps)
