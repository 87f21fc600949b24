"""Tables for notebooks."""

from __future__ import annotations

import html
from typing import Any, Iterable, Sequence, Tuple


def _text(value: Any) -> str:
    return "" if value is None else html.escape(str(value))


def table(caption: str, heads: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table in HTML.

    >>> table("a < b", ["x"], [[None]])
    '<table><caption>a &lt; b</caption><thead><tr><th>x</th></tr></thead><tbody><tr><td></td></tr></tbody></table>'
    """
    head = "".join(f"<th>{_text(x)}</th>" for x in heads)
    body = "".join(
        "<tr>" + "".join(f"<td>{_text(x)}</td>" for x in row) + "</tr>" for row in rows
    )
    return (
        f"<table><caption>{_text(caption)}</caption>"
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    )


def facts(caption: str, rows: Iterable[Tuple[str, Any]]) -> str:
    """Names with values in HTML.

    >>> facts("c", [("x", 1)])
    '<table><caption>c</caption><tbody><tr><th>x</th><td>1</td></tr></tbody></table>'
    """
    body = "".join(
        f"<tr><th>{_text(name)}</th><td>{_text(value)}</td></tr>"
        for name, value in rows
        if value is not None
    )
    return f"<table><caption>{_text(caption)}</caption><tbody>{body}</tbody></table>"
