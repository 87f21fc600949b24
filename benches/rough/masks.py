"""Writes masks.txt: 100 random masks of which some power contracts, five for each arity 2 to 5 and width 2 to 6.

A line is `q: row; row; …`, with the coefficients times q. The list follows from SEED alone; it was not
selected by how long anything takes.
"""

import random
from fractions import Fraction
from itertools import product
from pathlib import Path

SEED = 20260
OF_EACH = 5
# T_c is computed for c = 1, 2, … up to this many rows.
MOST_ROWS = 4096


def random_mask(source, arity, width, symmetric):
    """Linear interpolation, and noise of random size in every coefficient; the rules sum to 1."""
    q = source.choice([8, 10, 16, 24, 27, 32, 50, 60, 64, 81, 100, 125, 128, 256, 625])
    noise = source.uniform(0.1, 0.8) * q

    def row(a):
        entries = [source.randint(-round(noise), round(noise)) for _ in range(width)]
        middle, part = (width - 2) // 2, q * a // arity
        entries[middle] += q - part
        entries[middle + 1] += part
        # What is missing to q goes to any place.
        entries[source.randrange(width)] += q - sum(entries)
        return entries

    rows = [row(a) for a in range(arity)]
    if symmetric:
        # Rule n − 1 − α is rule α read from the right; a rule in the middle is its own mirror image.
        rows = [rows[a] if 2 * a < arity else rows[arity - 1 - a][::-1] for a in range(arity)]
        if arity % 2:
            middle = [x + y for x, y in zip(rows[arity // 2], rows[arity // 2][::-1])]
            rows, q = [[2 * x for x in one] for one in rows], 2 * q
            rows[arity // 2] = middle
    return q, rows


def difference(rows):
    """q times the rules of the differences: with S the sums, b_α = S(α) − S(α + 1), and one level on."""
    arity, width = len(rows), len(rows[0])
    # x'_{i+1} − x'_i = Σ_j c_j x_j = Σ_j (−Σ_{l≤j} c_l)(x_{j+1} − x_j), for Σ c_j = 0.
    rules = []
    for a in range(arity):
        this = rows[a] + [0]
        following = rows[a + 1] + [0] if a + 1 < arity else [0] + rows[0]
        change = [y - x for x, y in zip(this, following)]
        sums = [-sum(change[: j + 1]) for j in range(width)]
        rules.append(sums)
    return rules


def contracts(q, rows):
    """Whether some T_c is below 1 that has at most MOST_ROWS rows."""
    rules = difference(rows)
    arity, level, c = len(rules), [{0: 1}], 0
    while len(level) * arity <= MOST_ROWS:
        finer = []
        for row, digit in product(level, range(arity)):
            image = {}
            for at, x in row.items():
                carry, rule = divmod(digit + at, arity)
                for j, y in enumerate(rules[rule]):
                    image[carry + j] = image.get(carry + j, 0) + x * y
            finer.append(image)
        level, c = finer, c + 1
        if Fraction(max(sum(map(abs, row.values())) for row in level), q**c) < 1:
            return True
    return False


def main():
    source = random.Random(SEED)
    lines = []
    for arity, width, number in product(range(2, 6), range(2, 7), range(OF_EACH)):
        while True:
            q, rows = random_mask(source, arity, width, symmetric=number == 0)
            if contracts(q, rows):
                break
        lines.append(f"{q}: " + "; ".join(" ".join(map(str, row)) for row in rows) + "\n")
    (Path(__file__).parent / "masks.txt").write_text("".join(lines))


if __name__ == "__main__":
    main()
