"""What all answers have in common: rows for pandas, and tables for terminals and notebooks."""

from __future__ import annotations

from dataclasses import fields
from fractions import Fraction
from typing import Any, Dict, List, Sequence

from . import _html
from ._errors import SubcertError
from ._numbers import Algebraic, decimal


def shown(value: Any) -> str:
    """A value in a cell: exactly where that is short, and else as a float.

    >>> shown(Fraction(3, 4)), shown(Fraction(1, 10**30)), shown(None), shown([1, 4])
    ('3/4 = 0.75', '1e-30', '', '1 4')
    """
    if value is None:
        return ""
    if isinstance(value, Algebraic):
        exact = value.as_fraction()
        return shown(float(value) if exact is None else exact)
    if isinstance(value, Fraction):
        text = str(value) if value.numerator.bit_length() + value.denominator.bit_length() < 80 else ""
        if value.denominator == 1 and text:
            return text
        near = decimal(value)
        return f"{text} = {near}" if text else near
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple)):
        return " ".join(map(shown, value))
    return str(value)


class Answer:
    """An answer: its rows are dicts, which pandas and csv take. It has one row, unless it is a table."""

    def rows(self) -> List[Dict[str, Any]]:
        """The values by their names.

        >>> from subcert import Scheme
        >>> Scheme("chaikin").depth("1/100").rows()[0]["level"]
        3
        """
        return [{one.name: getattr(self, one.name) for one in fields(self) if one.repr}]  # type: ignore[arg-type]

    def to_pandas(self) -> Any:
        """The rows as a pandas DataFrame.

        >>> from subcert import Scheme
        >>> Scheme("chaikin").constants(2).to_pandas().contraction.tolist()
        [Fraction(1, 2), Fraction(1, 4)]
        """
        return frame(self.rows())

    def _repr_html_(self) -> str:
        rows = self.rows()[0].items()
        return _html.facts(type(self).__name__, [(n, None if x is None else shown(x)) for n, x in rows])


class Table(Answer):
    """An answer of several rows."""

    def _caption(self) -> str:
        return type(self).__name__

    def _heads(self) -> Sequence[str]:
        """The names of the columns, also where there is no row."""
        return list(self.rows()[0]) if self.rows() else []

    def _cells(self) -> List[List[str]]:
        return [[shown(x) for x in row.values()] for row in self.rows()]

    def __str__(self) -> str:
        lines = [list(self._heads()), *self._cells()]
        widths = [max(map(len, column)) for column in zip(*lines)]
        pad = ("  ".join(x.ljust(width) for x, width in zip(line, widths)).rstrip() for line in lines)
        return "\n".join([self._caption(), *pad])

    def _repr_html_(self) -> str:
        return _html.table(self._caption(), self._heads(), self._cells())


def frame(rows: List[Dict[str, Any]]) -> Any:
    """A DataFrame of these rows; what is missing is NaN."""
    try:
        import pandas
    except ImportError:
        raise SubcertError(
            "pandas is not installed", remedy="pip install pandas, or take rows()"
        ) from None
    found = pandas.DataFrame(rows)
    for name in found:
        if found[name].dtype == object and found[name].isna().any():
            found[name] = found[name].where(found[name].notna(), float("nan"))
    return found
