#!/usr/bin/env python3
"""Compares `subcert spectrum` and `subcert table` with numpy and with other readers of numbers.

    python3 benches/spectra.py [PROGRAM] [LAST]

For n = 3, ..., LAST (100) and each scheme, the matrix of the rules is built here from what the papers say, on
the ring and, where the program takes it, on two rings. All eigenvalues are compared with numpy's, and the
stencils with the rows that they must be: w M = w and w M = lambda w. Then tables are read back by the
parsers of Python and C.
"""

import json
import math
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target" / "release" / "subcert")
LAST = int(sys.argv[2]) if len(sys.argv) > 2 else 100
# Eigenvalues of matrices that are not normal are less exact than the rounding of the entries.
TOLERANCE = 1e-7


class Net:
    """Rows of weights by the names of the points."""

    def __init__(self, n: int, orbits: dict[str, int]):
        self.n, self.index = n, {}
        for name, count in orbits.items():
            for i in range(count):
                self.index[(name, i)] = len(self.index)
        self.matrix = np.zeros((len(self.index), len(self.index)))

    def row(self, name: str, i: int, terms):
        for weight, old, j in terms:
            j = j % self.n if (old, 1) in self.index else 0
            self.matrix[self.index[(name, i)], self.index[(old, j)]] += weight


def catmull_clark(n: int, wide: bool) -> np.ndarray:
    names = ["edge", "face"] + (["outer", "left", "right", "corner"] if wide else [])
    net = Net(n, {"vertex": 1} | {name: n for name in names})
    ring = range(n)
    net.row("vertex", 0, [(1 - 7 / (4 * n), "vertex", 0)]
            + [(3 / (2 * n * n), "edge", i) for i in ring] + [(1 / (4 * n * n), "face", i) for i in ring])
    point = {"vertex": lambda i: ("vertex", 0)}

    def edge_rule(a, b, wings):
        return [(3 / 8, *a), (3 / 8, *b)] + [(1 / 16, *wing) for wing in wings]

    def vertex_rule(v, edges, faces):
        return [(9 / 16, *v)] + [(3 / 32, *e) for e in edges] + [(1 / 64, *f) for f in faces]

    v = ("vertex", 0)
    for i in ring:
        e, f, o, l, r = (lambda name: lambda k: (name, k))("edge"), *(
            (lambda name: lambda k: (name, k))(name) for name in ("face", "outer", "left", "right"))
        net.row("edge", i, edge_rule(v, e(i), [e(i - 1), f(i - 1), e(i + 1), f(i)]))
        net.row("face", i, [(1 / 4, *p) for p in (v, e(i), f(i), e(i + 1))])
        if wide:
            net.row("outer", i, vertex_rule(e(i), [v, f(i), o(i), f(i - 1)], [e(i + 1), l(i), r(i - 1), e(i - 1)]))
            net.row("left", i, edge_rule(e(i), f(i), [v, e(i + 1), o(i), l(i)]))
            net.row("right", i, edge_rule(e(i + 1), f(i), [v, e(i), o(i + 1), r(i)]))
            net.row("corner", i, vertex_rule(
                f(i), [e(i), e(i + 1), l(i), r(i)], [v, o(i), o(i + 1), ("corner", i)]))
    return net.matrix


def doo_sabin(n: int, wide: bool) -> np.ndarray:
    net = Net(n, {name: n for name in ["face"] + (["left", "right", "corner"] if wide else [])})
    for i in range(n):
        net.row("face", i, [((3 + 2 * math.cos(2 * math.pi * (j - i) / n)) / (4 * n) + (i == j) / 4, "face", j)
                            for j in range(n)])

        def quad(a, b, c, d):
            return [(9 / 16, *a), (3 / 16, *b), (1 / 16, *c), (3 / 16, *d)]

        if wide:
            p, q, l, r = ("face", i), ("face", i + 1), ("left", i), ("right", i)
            net.row("left", i, quad(p, q, r, l))
            net.row("right", i, quad(q, p, l, r))
            net.row("corner", i, quad(p, l, ("corner", i), ("right", i - 1)))
    return net.matrix


def loop_with(beta):
    def loop(n: int, wide: bool) -> np.ndarray:
        net = Net(n, {"vertex": 1} | {name: n for name in ["edge"] + (["corner", "outer"] if wide else [])})
        b, v = beta(n), ("vertex", 0)
        net.row("vertex", 0, [(1 - n * b, *v)] + [(b, "edge", i) for i in range(n)])
        for i in range(n):
            e, c = lambda k: ("edge", k), lambda k: ("corner", k)
            net.row("edge", i, [(3 / 8, *v), (3 / 8, *e(i)), (1 / 8, *e(i - 1)), (1 / 8, *e(i + 1))])
            if wide:
                net.row("corner", i, [(3 / 8, *e(i)), (3 / 8, *e(i + 1)), (1 / 8, *v), (1 / 8, *c(i))])
                around = [v, e(i - 1), e(i + 1), c(i - 1), c(i), ("outer", i)]
                net.row("outer", i, [(10 / 16, *e(i))] + [(1 / 16, *p) for p in around])
        return net.matrix

    return loop


def sqrt3(n: int, wide: bool) -> np.ndarray:
    """Two steps, as a product of two matrices: first the points that one step gives, then their refinement."""
    alpha = lambda k: (4 - 2 * math.cos(2 * math.pi / k)) / 9
    old = {"vertex": 1, "edge": n} | ({"corner": n, "outer": n} if wide else {})
    middle = {"vertex": 1, "face": n} | ({"edge": n, "far": n} if wide else {})

    def matrix(rows, to, of):
        places = lambda orbits: {p: k for k, p in enumerate((a, i) for a, c in orbits.items() for i in range(c))}
        a, b = places(to), places(of)
        found = np.zeros((len(a), len(b)))
        for (name, i), terms in rows.items():
            for weight, point, j in terms:
                found[a[(name, i)], b[(point, j % of[point])]] += weight
        return found

    third = lambda *points: [(1 / 3, *p) for p in points]

    def smooth(centre, around):
        a = alpha(len(around))
        return [(1 - a, *centre)] + [(a / len(around), *p) for p in around]

    v, first, second = ("vertex", 0), {}, {}
    first[v] = smooth(v, [("edge", i) for i in range(n)])
    second[v] = smooth(v, [("face", i) for i in range(n)])
    for i in range(n):
        e, c, o = (lambda k: ("edge", k)), (lambda k: ("corner", k)), ("outer", i)
        f = lambda k: ("face", k)
        first[("face", i)] = third(v, e(i), e(i + 1))
        second[("edge", i)] = third(v, f(i - 1), f(i))
        if wide:
            first[("edge", i)] = smooth(e(i), [v, e(i + 1), c(i), o, c(i - 1), e(i - 1)])
            first[("far", i)] = third(e(i), e(i + 1), c(i))
            second[("corner", i)] = smooth(f(i), [v, f(i + 1), e(i + 1), ("far", i), e(i), f(i - 1)])
            second[("outer", i)] = third(e(i), f(i - 1), f(i))
    return matrix(second, old, middle) @ matrix(first, middle, old)


LOOP = loop_with(lambda n: (5 / 8 - (3 / 8 + math.cos(2 * math.pi / n) / 4) ** 2) / n)
WARREN = loop_with(lambda n: 3 / 16 if n == 3 else 3 / (8 * n))
SCHEMES = {"catmull-clark": catmull_clark, "doo-sabin": doo_sabin, "loop": LOOP, "loop-warren": WARREN, "sqrt3": sqrt3}


def spectrum(scheme: str, n: int) -> dict:
    command = [PROGRAM, "spectrum", scheme, "--valence", str(n), "--format", "json"]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def weights(stencil: list) -> np.ndarray:
    return np.array([float(weight["decimal"]) for weight in stencil])


def compare(scheme: str, n: int) -> float:
    found = spectrum(scheme, n)
    wide = found["neighbourhood"] != found["orbits"]
    expected = np.sort(np.linalg.eigvals(SCHEMES[scheme](n, wide)).real)[::-1]
    mine = [float(one["decimal"]) for one in found["eigenvalues"] for _ in range(one["multiplicity"])]
    mine = np.sort(np.array(mine))[::-1]
    assert len(mine) == len(expected), f"{scheme} {n}: {len(mine)} eigenvalues, not {len(expected)}"
    off = np.abs(mine - expected).max()
    assert off < TOLERANCE, f"{scheme} {n}: eigenvalues are {off} apart"
    ring = SCHEMES[scheme](n, False)
    limit = weights(found["limit"])
    assert abs(limit.sum() - 1) < 1e-13 and np.abs(limit @ ring - limit).max() < 1e-13, f"{scheme} {n}: limit"
    value = float(found["conditions"]["subdominant"]["decimal"])
    for stencil in found["tangents"]:
        tangent = weights(stencil)
        assert np.abs(tangent).max() > 0.5, f"{scheme} {n}: tangent"
        assert np.abs(tangent @ ring - value * tangent).max() < 1e-13, f"{scheme} {n}: tangent"
    if scheme == "catmull-clark":
        c = math.cos(2 * math.pi / n)
        assert abs(value - (c + 5 + math.sqrt((c + 9) * (c + 1))) / 16) < 1e-15
    return off


def single(value: float) -> float:
    return struct.unpack("f", struct.pack("f", value))[0]


def table(scheme: str, language: str, real: str) -> str:
    command = [PROGRAM, "table", scheme, "--valences", "3..12", "--format", language, "--type", real]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def flat(value):
    return [x for row in value for x in flat(row)] if isinstance(value, list) else [value]


def read_back(scheme: str) -> int:
    """The numbers of all languages are those of Python's table, as their own parsers read them."""
    count = 0
    for real in ("f32", "f64"):
        names = {}
        exec(table(scheme, "python", real), names)  # a table of this program
        numbers = [x for name in ("weights", "subdominant", "limit", "tangent_1", "tangent_2") for x in flat(names[name])]
        if real == "f32":
            assert all(single(x) == x for x in numbers), "a number of the f32 table is no f32"
        data = json.loads(table(scheme, "json", real))
        assert flat([data[name] for name in ("weights", "subdominant", "limit", "tangent_1", "tangent_2")]) == numbers
        if shutil.which("cc"):
            assert by_c(scheme, table(scheme, "c", real)) == numbers, f"{scheme} {real}: C reads other numbers"
        count += len(numbers)
    return count


def by_c(scheme: str, source: str) -> list[float]:
    name = scheme.replace("-", "_")
    kind = "float" if f"float {name}_limit" in source else "double"
    show = "".join(
        f"    for (size_t i = 0; i < sizeof {name}_{array} / sizeof({kind}); i++) "
        f'printf("%a\\n", (double)((const {kind} *){name}_{array})[i]);\n'
        for array in ("weights", "subdominant", "limit", "tangent_1", "tangent_2"))
    program = f"#include <stdio.h>\n{source}\nint main(void) {{\n{show}    return 0;\n}}\n"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "table.c"
        path.write_text(program)
        subprocess.run(["cc", "-std=c99", "-o", path.with_suffix(""), path], check=True)
        lines = subprocess.run([path.with_suffix("")], capture_output=True, text=True, check=True).stdout.split()
    return [float.fromhex(line) for line in lines]


def main() -> int:
    for scheme in SCHEMES:
        off = max(compare(scheme, n) for n in range(3, LAST + 1))
        print(f"{scheme}: eigenvalues for n = 3, ..., {LAST} within {off:.1e} of numpy's, stencils within 1e-13")
        print(f"{scheme}: {read_back(scheme)} numbers of tables read back")
    return 0


if __name__ == "__main__":
    sys.exit(main())
