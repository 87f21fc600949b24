#!/usr/bin/env python3
"""What calls from Python cost, beside python-flint code for the same constants.

In an environment with the module and python-flint:

    pip install ./python python-flint
    python benches/python.py

Each figure is the least of five runs; the last line is the ratio of two times of one run.
"""

import random
import time
from fractions import Fraction

from flint import fmpq

from subcert import Scheme

COUNT = 10_000


def least(work, count=5):
    times = []
    for _ in range(count):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


def masks(generator):
    for _ in range(COUNT):
        rows = []
        for _ in range(2):
            row = [Fraction(generator.randint(-8, 12), 16) for _ in range(3)]
            rows.append(row + [1 - sum(row)])
        yield rows


def flint_contraction(mask):
    """T_1: the greatest sum of the absolute values of a row of the difference mask."""
    following = [mask[1] + [fmpq(0)], [fmpq(0)] + mask[0]]
    greatest = fmpq(0)
    for this, after in zip(mask, following):
        total = partial = fmpq(0)
        for x, y in zip(this + [fmpq(0)], after):
            partial += x - y
            total += abs(partial)
        greatest = max(greatest, total)
    return greatest


def main():
    rows = list(masks(random.Random(3)))
    ours = [Scheme(mask=mask) for mask in rows]
    theirs = [[[fmpq(x.numerator, x.denominator) for x in row] for row in mask] for mask in rows]
    assert all(
        a.contraction(1) == Fraction(int(b.p), int(b.q))
        for a, b in zip(ours, map(flint_contraction, theirs))
    )
    # New schemes, so that nothing is remembered.
    fresh = [[Scheme(mask=mask) for mask in rows] for _ in range(5)]
    constants = least(lambda: [scheme.contraction(1) for scheme in fresh.pop()])
    flint = least(lambda: [flint_contraction(mask) for mask in theirs])
    scheme = ours[0]
    call = least(lambda: [scheme.contraction(1) for _ in range(COUNT)]) / COUNT
    made = least(lambda: [Scheme(mask=mask) for mask in rows]) / COUNT
    print(f"a call whose answer is known: {1e6 * call:.1f} µs")
    print(f"a scheme from a mask of eight fractions: {1e6 * made:.1f} µs")
    print(f"{COUNT} contraction constants: {constants:.3f} s, python-flint {flint:.3f} s")
    print(f"ratio: {constants / flint:.2f}")


if __name__ == "__main__":
    main()
