"""Audits of papers."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from os import PathLike, fsdecode
from typing import Any, Dict, Iterator, List, Optional, Union

from . import _native
from ._answer import Table, frame, shown


@dataclass(frozen=True)
class Finding:
    """What an audit finds of one claim: a cell of a table, an equation, a range, a theorem.

    >>> first = audit("khan2019-newton").findings[0]
    >>> first.id, first.printed, first.exact
    ('khan2019-newton:table-1:1:1', '0.002500', Fraction(1, 400))
    """

    #: The paper's key, the claim's id, and for a cell its row and column.
    id: str
    #: Where in the paper it is.
    locus: str
    kind: str
    printed: Optional[str]
    verdict: str
    #: The exact value as a fraction; None where it is irrational or there is none.
    exact: Optional[Fraction]
    #: The exact value as a formula or fraction, and as a decimal.
    exact_text: Optional[str]
    decimal: Optional[str]
    #: In which choices the reading under which the printed value comes out differs from the paper; what
    #: it gives stands in ``data``.
    reading: Optional[str]
    note: Optional[str]
    #: All that the program says, as `subcert audit --format json` does.
    data: Dict[str, Any] = field(repr=False, compare=False, default_factory=dict)

    @classmethod
    def _of(cls, claim: Dict[str, Any]) -> "Finding":
        exact_text = claim.get("exact")
        try:
            exact = None if exact_text is None else Fraction(exact_text)
        except ValueError:
            exact = None
        reading = claim.get("reading")
        return cls(
            id=claim["id"],
            locus=claim["locus"],
            kind=claim["kind"],
            printed=claim.get("printed"),
            verdict=claim["verdict"],
            exact=exact,
            exact_text=exact_text,
            decimal=claim.get("decimal"),
            reading=reading["differs"] if isinstance(reading, dict) else reading,
            note=claim.get("note"),
            data=claim,
        )


@dataclass(frozen=True, repr=False)
class Audit(Table):
    """The findings of one paper.

    >>> found = audit("khan2019-newton")
    >>> found.key, len(found) == len(list(found))
    ('khan2019-newton', True)
    """

    key: str
    findings: List[Finding]
    #: How many claims have each verdict.
    summary: Dict[str, int]
    data: Dict[str, Any] = field(repr=False, compare=False, default_factory=dict)

    def __iter__(self) -> Iterator[Finding]:
        return iter(self.findings)

    def __len__(self) -> int:
        return len(self.findings)

    def to_pandas(self) -> Any:
        """The findings as a pandas DataFrame, a row for each claim.

        >>> audit("khan2019-newton").to_pandas().verdict.iloc[0]
        'confirmed'
        """
        return frame(self.rows()).set_index("id")

    def rows(self) -> List[Dict[str, Any]]:
        """A row for each claim.

        >>> audit("khan2019-newton").rows()[0]["verdict"]
        'confirmed'
        """
        return [{k: v for k, v in asdict(x).items() if k != "data"} for x in self.findings]

    def _counts(self) -> str:
        return ", ".join(f"{count} {name}" for name, count in self.summary.items() if count)

    def _caption(self) -> str:
        return f"{self.key}: {self._counts()}"

    def _heads(self) -> List[str]:
        return ["where", "printed", "exact", "verdict", "reading"]

    def _cells(self) -> List[List[str]]:
        each = ((x.locus, x.printed, x.decimal, x.verdict, x.reading) for x in self.findings)
        return [list(map(shown, row)) for row in each]

    def __repr__(self) -> str:
        return f"Audit({self.key!r}, {len(self)} findings: {self._counts()})"


def papers() -> List[str]:
    """The keys of the papers that come with the module.

    >>> "khan2019-newton" in papers()
    True
    """
    return _native.paper_keys()


def audit(path: Union[str, PathLike[str]]) -> Audit:
    """Audits the claims of a file, or of a paper that comes with the module.

    >>> found = audit("khan2019-newton")
    >>> found.summary["confirmed"]
    6
    >>> found.findings[0].verdict, found.findings[0].exact
    ('confirmed', Fraction(1, 400))
    """
    [paper] = json.loads(_native.audit_json([fsdecode(path)]))["papers"]
    findings = [Finding._of(claim) for claim in paper["claims"]]
    return Audit(paper["key"], findings, paper["summary"], paper)
