"""Compares T_c of masks on Z^2 with linear programs of SciPy (HiGHS, f64) and with the network simplex algorithm of networkx (integers).

    python3 -m venv target/peers/venv
    target/peers/venv/bin/pip install scipy networkx
    cargo build --release
    target/peers/venv/bin/python benches/peers/transport.py

The peers build the functionals of c steps themselves, and solve one problem for each of them that is not the same as another up to a translation
and the sign. A line has the scheme, c, the number of problems, our value, the seconds of the whole of `subcert constants`, and those of the peers.
"""

import json
import subprocess
import time
from fractions import Fraction
from math import lcm
from pathlib import Path

import networkx
import numpy
from scipy.optimize import linprog
from scipy.sparse import coo_array

PROGRAM = Path(__file__).resolve().parents[2] / "target/release/subcert"
TRIANGLES = [(1, 0), (0, 1), (1, 1)]
CASES = [
    ("courant", 3),
    ("loop-regular", 3),
    ("butterfly-regular:w=1/16", 3),
    ("butterfly-regular:w=1/16", 4),
    ("four-point-tensor:w=1/16", 3),
]


def facts(scheme):
    """The mask and the edges, as `subcert oracle` and `subcert scheme` have them."""
    oracle = json.loads(run("oracle", scheme, "--level", "0", "-c", "1"))
    groups = {group["quantity"]: group for group in oracle["groups"]}
    first = [int(one["exact"]) for one in groups["mask-first"]["values"]]
    mask = {
        tuple(i + at for i, at in zip(one["index"], first)): Fraction(one["exact"])
        for one in groups["mask"]["values"]
        if one["exact"] != "0"
    }
    constants = json.loads(run("constants", scheme, "-c", "1", "--format", "json"))
    return mask, [tuple(edge) for edge in constants["edges"]]


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, check=True, text=True).stdout


def functionals(mask, edges, count):
    """The differences after so many steps, for the dilation matrix 2I."""
    steps = {(0, 0): Fraction(1)}
    for _ in range(count):
        following = {}
        for (x, y), value in steps.items():
            for (i, j), c in mask.items():
                place = (2 * x + i, 2 * y + j)
                following[place] = following.get(place, 0) + c * value
        steps = following
    n = 2**count
    seen = set()
    for a in range(n):
        for b in range(n):
            for u, v in edges:
                found = {}
                for (x, y), value in steps.items():
                    for (p, q), sign in (((a + u, b + v), 1), ((a, b), -1)):
                        if (p - x) % n == 0 and (q - y) % n == 0:
                            place = ((p - x) // n, (q - y) // n)
                            found[place] = found.get(place, 0) + sign * value
                found = {place: value for place, value in sorted(found.items()) if value}
                if not found:
                    continue
                (x, y), lead = next(iter(found.items()))
                sign = 1 if lead > 0 else -1
                seen.add(tuple(((p - x, q - y), value * sign) for (p, q), value in found.items()))
    return [dict(one) for one in seen]


def box(functional, edges):
    """The points of the least box, and the edges in it."""
    xs, ys = zip(*functional)
    points = [(x, y) for x in range(min(xs), max(xs) + 1) for y in range(min(ys), max(ys) + 1)]
    places = {point: i for i, point in enumerate(points)}
    inside = [
        (places[p], places[(p[0] + u, p[1] + v)])
        for p in points
        for u, v in edges
        if (p[0] + u, p[1] + v) in places
    ]
    return points, places, inside


def by_scipy(functional, edges):
    points, places, inside = box(functional, edges)
    cost = numpy.zeros(len(points))
    for place, value in functional.items():
        cost[places[place]] = -float(value)
    count = len(inside)
    rows = numpy.arange(2 * count).repeat(2)
    ends = numpy.array(inside).reshape(-1)
    columns = numpy.concatenate([ends, ends])
    signs = numpy.tile([1.0, -1.0], count)
    matrix = coo_array((numpy.concatenate([signs, -signs]), (rows, columns)), shape=(2 * count, len(points)))
    bounds = [(0, 0)] + [(None, None)] * (len(points) - 1)
    return -linprog(cost, matrix.tocsr(), numpy.ones(2 * count), bounds=bounds).fun


def by_networkx(functional, edges):
    points, places, inside = box(functional, edges)
    scale = lcm(*(value.denominator for value in functional.values()))
    graph = networkx.DiGraph()
    for point in points:
        graph.add_node(places[point], demand=int(functional.get(point, 0) * scale))
    for one, other in inside:
        graph.add_edge(one, other, weight=1)
        graph.add_edge(other, one, weight=1)
    return Fraction(networkx.network_simplex(graph)[0], scale)


def timed(run):
    start = time.perf_counter()
    value = run()
    return value, time.perf_counter() - start


def main():
    print("| scheme | c | problems | T_c | subcert | SciPy | networkx |\n|---|--:|--:|--:|--:|--:|--:|")
    for scheme, count in CASES:
        mask, edges = facts(scheme)
        command = ["constants", scheme, "-c", str(count), "--format", "json"]
        text, ours = timed(lambda: run(*command))
        value = Fraction(json.loads(text)["levels"][count - 1]["contraction"]["exact"])
        problems = functionals(mask, edges, count)
        floats, scipy = timed(lambda: max(by_scipy(one, edges) for one in problems))
        exact, simplex = timed(lambda: max(by_networkx(one, edges) for one in problems))
        assert exact == value and abs(floats - float(value)) < 1e-9, (scheme, value, exact, floats)
        print(f"| {scheme} | {count} | {len(problems)} | {value} | {ours:.2f} s | {scipy:.1f} s | {simplex:.1f} s |")


if __name__ == "__main__":
    main()
