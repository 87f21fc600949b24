"""Audits of papers."""

from __future__ import annotations

import html
import json
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Union

from . import _native
from ._answer import frame


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
    #: The reading under which the printed value comes out, where it is not the printed one.
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
            reading=reading if reading is None or isinstance(reading, str) else json.dumps(reading),
            note=claim.get("note"),
            data=claim,
        )


@dataclass(frozen=True)
class Audit:
    """The findings of one paper.

    >>> found = audit("khan2022-doo-sabin")
    >>> found.key, len(found) == len(list(found))
    ('khan2022-doo-sabin', True)
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

    def _repr_html_(self) -> str:
        def cell(value: Any) -> str:
            return f"<td>{'' if value is None else html.escape(str(value))}</td>"

        counts = ", ".join(f"{count} {name}" for name, count in self.summary.items() if count)
        rows = "".join(
            "<tr>" + "".join(map(cell, (x.locus, x.printed, x.decimal, x.verdict, x.reading))) + "</tr>"
            for x in self.findings
        )
        heads = "".join(f"<th>{x}</th>" for x in ("where", "printed", "exact", "verdict", "reading"))
        return (
            f"<table><caption>{html.escape(self.key)}: {html.escape(counts)}</caption>"
            f"<thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>"
        )


def papers() -> List[str]:
    """The keys of the papers that come with the module.

    >>> "khan2019-newton" in papers()
    True
    """
    return _native.paper_keys()


def audit(path: Union[str, Path]) -> Audit:
    """Audits the claims of a file, or of a paper that comes with the module.

    >>> found = audit("khan2019-newton")
    >>> found.summary["confirmed"]
    6
    >>> found.findings[0].verdict, found.findings[0].exact
    ('confirmed', Fraction(1, 400))
    """
    [paper] = json.loads(_native.audit_json([str(path)]))["papers"]
    findings = [Finding._of(claim) for claim in paper["claims"]]
    return Audit(paper["key"], findings, paper["summary"], paper)
