"""All facts of a scheme at once."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from os import PathLike
from typing import Any, Dict, List, Optional, Union

from . import _html, _native
from ._errors import SubcertError
from ._numbers import Number
from ._scheme import Scheme, _text


@dataclass(frozen=True)
class Facts:
    """All that is known of a scheme, as ``subcert scheme --format json`` has it; None is what is open.

    ``curve`` has the facts of a mask, ``lattice`` those of a mask on Z^d or of a tensor product, ``valences``
    those of rules around a vertex or on a face, one for each valence, and ``ranges`` where in the only
    parameter of a family the limits are C^m. Exact numbers are texts, beside decimals.

    >>> found = scheme("four-point", w="1/16")
    >>> found.curve["continuity"], found.curve["hoelder"]["exact"], found.curve["contraction"][0]["exact"]
    (1, '2', '5/8')
    >>> [order["smoothness"] for order in found.ranges["orders"]]
    [0, 1]
    >>> scheme("(1+x)*(1+y)*(1+x*y)/2").lattice["hoelder"]["exact"]
    '1'
    """

    #: The scheme as it was given.
    scheme: str
    curve: Optional[Dict[str, Any]] = field(repr=False)
    lattice: Optional[Dict[str, Any]] = field(repr=False)
    valences: Optional[List[Dict[str, Any]]] = field(repr=False)
    ranges: Optional[Dict[str, Any]] = field(repr=False)
    #: All that the program says.
    data: Dict[str, Any] = field(repr=False, compare=False)

    def _repr_html_(self) -> str:
        parts = []
        if self.curve is not None:
            parts = _curve(self.scheme, self.curve)
        if self.lattice is not None:
            parts = _lattice(self.scheme, self.lattice)
        if self.valences is not None:
            parts.append(_surface(self.scheme, self.valences))
        if self.ranges is not None:
            parts.append(_family(self.ranges))
        return "".join(parts)


def scheme(name: Union[str, PathLike[str], Scheme], **parameters: Number) -> Facts:
    """All facts of a scheme of the catalogue, a file, or a mask as text, also on Z^d; or of a ``Scheme``.

    >>> scheme("chaikin").curve["stencils"][0]["weights"][0]["exact"]
    '1/2'
    >>> [row["valence"] for row in scheme("loop").valences]
    [3, 4, 5, 6, 7, 8, 9, 10, 11, 12]
    >>> scheme(Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]])).curve["continuity"]
    1
    """
    found = name if isinstance(name, Scheme) else Scheme(name)
    if found._text is None:
        if parameters:
            raise SubcertError("a mask has no parameters")
        data = json.loads(found._native.facts_json(repr(found)))
    else:
        data = json.loads(_native.facts_json(_text(found._text, parameters)))
    curve, lattice, valences = (data.get(kind) for kind in ("curve", "lattice", "valences"))
    return Facts(data["scheme"], curve, lattice, valences, data["ranges"], data)


@dataclass(frozen=True)
class Plot:
    """Pictures of a scheme as one SVG file, which a notebook shows.

    >>> plot("chaikin").svg[:4]
    '<svg'
    """

    #: The scheme as it was given.
    scheme: str
    svg: str = field(repr=False)

    def save(self, path: str) -> None:
        """Writes the file.

        >>> import os, tempfile
        >>> folder = tempfile.TemporaryDirectory()
        >>> plot("chaikin").save(os.path.join(folder.name, "chaikin.svg"))
        >>> os.listdir(folder.name)
        ['chaikin.svg']
        """
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)

    def _repr_svg_(self) -> str:
        return self.svg


def plot(name: Union[str, PathLike[str], Scheme], **parameters: Number) -> Plot:
    """What ``subcert plot`` draws of a scheme of the catalogue, a file, or a mask as text.

    >>> "φ″ is not drawn" in plot("four-point", w="1/16").svg
    True
    """
    named = name if isinstance(name, Scheme) else Scheme(name)
    if named._text is None:
        remedy = 'give its symbol as text, as in plot("[1, 3, 3, 1]/4")'
        raise SubcertError("a mask without a name is not drawn", remedy=remedy)
    text = _text(named._text, parameters)
    return Plot(text, _native.plot_svg(text))


def _shown(exact: Optional[Dict[str, str]]) -> Optional[str]:
    """The exact value where it is short, and else its decimal.

    >>> _shown({"exact": "1/2", "decimal": "0.5"}), _shown(None)
    ('1/2', None)
    """
    if exact is None:
        return None
    return exact["exact"] if len(exact["exact"]) <= 24 else exact["decimal"]


def _between(low: Any, high: Any) -> str:
    """Two bounds of a value.

    >>> _between(3, 3), _between(3, 4)
    ('3', '3 to 4')
    """
    return str(low) if low == high else f"{low} to {high}"


def _orders(curve: Dict[str, Any]) -> str:
    """C^m in words.

    >>> _orders({"continuity": 1, "continuity_fails": 2})
    'C^1, not C^2'
    >>> _orders({"continuity": None, "continuity_fails": 0})
    'diverges'
    """
    proved, fails = curve["continuity"], curve["continuity_fails"]
    if fails == 0:
        return "diverges"
    said = "open" if proved is None else f"C^{proved}"
    return said if fails is None else f"{said}, not C^{fails}"


def _exponent(found: Dict[str, Any]) -> Any:
    """The Hölder exponent.

    >>> _exponent({"hoelder": {"lower": "1.5", "upper": "2", "exact": None}})
    '1.5 to 2'
    """
    hoelder = found["hoelder"]
    return hoelder and (hoelder["exact"] or _between(hoelder["lower"], hoelder["upper"]))


def _constants(found: Dict[str, Any]) -> str:
    rows = zip(range(1, 9), map(_shown, found["contraction"]), map(_shown, found["norm"]))
    return _html.table("Constants", ["c", "T_c", "Λ_c"], rows)


def _lattice(name: str, mask: Dict[str, Any]) -> List[str]:
    support = mask["support"] and " × ".join(
        f"[{low}, {high}]" for low, high in (map(_shown, ends) for ends in mask["support"])
    )
    known = _html.facts(
        name,
        [
            ("dilation matrix", mask["dilation"]),
            ("rules", mask["arity"]),
            ("kind", mask["kind"]),
            ("interpolating", "yes" if mask["interpolating"] else "no"),
            ("support in", support),
            ("sum rules", mask["sum_rules"]),
            ("reproduces degree", mask["reproduction"]),
            ("limits", _orders(mask)),
            ("Hölder exponent", _exponent(mask)),
            ("σ", _shown(mask["displacement"])),
            ("open", ", ".join(one["fact"] for one in mask["open"]) or None),
        ],
    )
    return [known, _constants(mask)]


def _curve(name: str, curve: Dict[str, Any]) -> List[str]:
    low, high = map(_shown, curve["support"])
    depth = curve["depth_natural"]
    known = _html.facts(
        name,
        [
            ("arity", curve["arity"]),
            ("points", curve["points"]),
            ("kind", curve["kind"]),
            ("interpolating", "yes" if curve["interpolating"] else "no"),
            ("support", f"{low} to {high}"),
            ("sum rules", curve["sum_rules"]),
            ("reproduces degree", curve["reproduction"]),
            ("limits", _orders(curve)),
            ("Hölder exponent", _exponent(curve)),
            ("σ", _shown(curve["displacement"])),
            ("depth for 1/100, natural", depth and _between(depth["lower"], depth["upper"])),
            ("open", ", ".join(one["fact"] for one in curve["open"]) or None),
        ],
    )
    return [known, _constants(curve)]


def _surface(name: str, valences: List[Dict[str, Any]]) -> str:
    rows = []
    for one in valences:
        vertex = one["vertex"] or {}
        lead = _shown(vertex.get("subdominant"))
        verdict, curvature = vertex.get("verdict", "open"), vertex.get("curvature")
        rows.append([one["valence"], verdict, lead, _shown(one["next"]), curvature])
    return _html.table(name, ["valence", "C^1", "λ", "μ", "curvature"], rows)


def _family(ranges: Dict[str, Any]) -> str:
    def ends(intervals: List[Dict[str, Any]]) -> str:
        return " or ".join(
            f"{_shown(x['low']) or '−∞'} to {_shown(x['high']) or '∞'}" for x in intervals
        )

    def order(x: Dict[str, Any]) -> str:
        at = "" if x["valence"] is None else f", n = {x['valence']}"
        return f"C^{x['smoothness']}{at}"

    rows = [(order(x), ends(x["inside"]), ends(x["outside"])) for x in ranges["orders"]]
    return _html.table(f"The family, in {ranges['parameter']}", ["", "all limits", "not all"], rows)
