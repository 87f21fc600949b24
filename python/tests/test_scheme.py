"""Schemes against naive code, numpy and hand-derived values."""

import itertools
import random
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest

import subcert
from subcert import Scheme, SubcertError, exact


def differences(mask):
    """The difference mask: rule α gives the difference of points α and α + 1 of the next level."""
    n, width = len(mask), len(mask[0])
    rows = []
    for alpha in range(n):
        this = mask[alpha] + [Fraction(0)]
        following = [Fraction(0)] + mask[0] if alpha == n - 1 else mask[alpha + 1] + [Fraction(0)]
        if alpha < n - 1:
            this, following = mask[alpha] + [Fraction(0)], mask[alpha + 1] + [Fraction(0)]
        # Coefficients of points as sums of differences: minus the partial sums.
        step = [b - a for a, b in zip(this, following)]
        partial = list(itertools.accumulate(step))
        assert partial[-1] == 0
        rows.append([-x for x in partial[:-1]])
    assert all(len(row) == width for row in rows)
    return rows


def random_mask(generator):
    n, width = generator.choice([2, 3]), generator.choice([2, 3, 4])
    rows = []
    for _ in range(n):
        row = [Fraction(generator.randint(-8, 12), 16) for _ in range(width - 1)]
        rows.append(row + [1 - sum(row)])
    return rows


def naive_contraction(mask, c):
    """The greatest Σ|coefficient| of a difference of level c, from unit differences."""
    rows, n = differences(mask), len(mask)
    size = 4 * len(mask[0]) + 4
    # Coefficients of the difference i of each level over those of level 0, far from the ends.
    points = {i: {i: Fraction(1)} for i in range(size)}
    for _ in range(c):
        refined = {}
        for i in points:
            for alpha, row in enumerate(rows):
                total = {}
                for j, coefficient in enumerate(row):
                    if i + j not in points:
                        total = None
                        break
                    for k, x in points[i + j].items():
                        total[k] = total.get(k, 0) + coefficient * x
                if total is not None:
                    refined[n * i + alpha] = total
        points = refined
    return max(sum(abs(x) for x in total.values()) for total in points.values())


def test_contraction_of_random_masks():
    generator = random.Random(7)
    for _ in range(60):
        mask = random_mask(generator)
        scheme = Scheme(mask=mask)
        for c in (1, 2):
            assert scheme.contraction(c) == naive_contraction(mask, c), mask


def test_numbers_of_all_kinds():
    masks = [
        [["3/4", "1/4"], ["1/4", "3/4"]],
        [[Fraction(3, 4), Fraction(1, 4)], [Decimal("0.25"), "0.75"]],
        [[exact(0.75), exact(numpy.float64(0.25))], ["0.25", "0.75"]],
        [[0.75, 0.25], [numpy.float32(0.25), numpy.float64(0.75)]],
        numpy.array([[0.75, 0.25], [0.25, 0.75]]),
        numpy.array([[0.75, 0.25], [0.25, 0.75]], dtype=numpy.float32),
    ]
    assert {Scheme(mask=mask).contraction(3) for mask in masks} == {Fraction(1, 8)}
    # More digits than Python reads from text.
    tiny = Fraction(1, 10**5000)
    scheme = Scheme(mask=[[1 - tiny, tiny], [tiny, 1 - tiny]])
    assert scheme.masks[0][0][1] == tiny


@pytest.mark.parametrize(
    "wrong, words",
    [
        (lambda: Scheme("chaikn"), "chaikin"),
        (lambda: Scheme("six-point").contraction(1), "`w`"),
        (lambda: Scheme(mask=[1, 3, 3, 1]), "write 1/4*[1, 3, 3, 1]"),
        (lambda: Scheme(mask=["3/4", "1/4"]), "add up to 1"),
        (lambda: Scheme(mask=7), "a int is no mask"),
        (lambda: Scheme("chaikin").refine("polygon.csv"), "read a file first"),
        (lambda: Scheme("chaikin").depth(1, polygon="polygon.csv"), "no list of points"),
        (lambda: Scheme(mask=[[0.1, 0.9], [1, 0]]), 'write "0.1" for 1/10'),
        (lambda: Scheme(mask=[[float("inf"), 0.9], [1, 0]]), "inf is no number"),
        (lambda: Scheme("six-point", w=float("nan")), "nan is no number"),
        (lambda: Scheme(mask=[[1, 1], [1, 0]]), "sum"),
        (lambda: Scheme(mask=[[1, object()], [1, 0]]), "object"),
        (lambda: Scheme(mask=[[True, 0], [1, 0]]), "bool"),
        (lambda: Scheme(), "name or a mask"),
        (lambda: Scheme("chaikin").contraction(0), "from 1 on"),
        (lambda: Scheme("chaikin").depth("-1", spread=1), "positive"),
        (lambda: Scheme("chaikin").depth("1/10", spread=1, polygon=[0, 1]), "spread or a polygon"),
        (lambda: Scheme("chaikin").refine([(1, 2), (3,)]), "coordinates"),
        (lambda: Scheme("chaikin").refine([]), "no points"),
        (lambda: Scheme("chaikin").refine([0, 1, 2], 200), "level"),
        (lambda: exact(float("nan")), "no number"),
    ],
)
def test_errors_say_what_is_wrong(wrong, words):
    with pytest.raises(SubcertError) as caught:
        scheme = wrong()
        scheme.contraction(1)
    assert words in str(caught.value)


def test_floats_are_the_dyadic_numbers_that_they_are():
    w = 0.01
    assert Scheme("six-point", w=w).contraction(1) == Scheme("six-point", w=Fraction(w)).contraction(1)
    assert Scheme("six-point", w=w).contraction(1) != Scheme("six-point", w="0.01").contraction(1)
    # Chaikin's distance is 1/8 of the spread at level 0 and falls by 4: at level 2 it is 1/128.
    found = Scheme("chaikin").depth(0.0078125)
    assert found == Scheme("chaikin").depth("1/128", spread=1)
    assert found == Scheme("chaikin").depth(numpy.float64(0.0078125), spread=numpy.int64(1))
    # Integers of numpy, in lists and in arrays.
    assert Scheme(mask=numpy.array([[1, 0], [0, 1]])).norm(1) == 1


def chaikin(points, levels):
    for _ in range(levels):
        following = numpy.roll(points, -1, axis=0)
        pairs = [0.75 * points + 0.25 * following, 0.25 * points + 0.75 * following]
        points = numpy.stack(pairs, axis=1).reshape(-1, *points.shape[1:])
    return points


def test_refinement_against_numpy(subcert_oracle):
    generator = numpy.random.default_rng(5)
    points = generator.normal(size=(7, 2))
    found = Scheme("chaikin").refine(points, 3)
    assert isinstance(found.points, numpy.ndarray) and found.points.shape == (56, 2)
    assert numpy.abs(found.points - chaikin(points, 3)).max() < 1e-14
    assert 0 <= found.error < 1e-15
    subcert_oracle.assert_refines(chaikin, Scheme("chaikin"), points, 3, ulps=64)

    def wrong(points, levels):
        return chaikin(points, levels) + 1e-9

    with pytest.raises(AssertionError, match="units in the last place|ulps"):
        subcert_oracle.assert_refines(wrong, Scheme("chaikin"), points, 3, ulps=64)


def test_depth_is_what_sampling_says():
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    found = Scheme("chaikin").depth("1/4", polygon=square)
    assert found.distance[0] <= found.distance[1] <= Fraction(1, 4)
    assert found.too_few == found.level - 1
    assert Scheme("chaikin").depth("1/4", polygon=numpy.array(square)) == found
    # Papers count points at i/n^k.
    assert Scheme("chaikin").depth("1/4", polygon=square, natural=False).level >= found.level


def test_ranges_are_sets_of_algebraic_numbers():
    [interval] = Scheme("four-point").range("w", levels=1)
    assert (interval.low, interval.high) == (Fraction(-1, 4), Fraction(1, 4))
    union = Scheme("four-point").range("w", levels=3)
    end = union[-1].high
    low, high = end.interval(40)
    assert low <= high and high - low <= Fraction(1, 10**40)
    values = [sum(a * x**i for i, a in enumerate(end.minpoly)) for x in (low, high)]
    assert values[0] * values[1] <= 0
    assert float(low) <= float(end) <= float(high)
    assert Fraction(1, 16) in union[-1] and end not in union[-1]
    with pytest.raises(SubcertError):
        Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]).range("w")


def test_floats_are_within_their_bounds():
    quantities = Scheme("six-point", w="0.01").certify(levels=2)
    assert {x.name for x in quantities} >= {"T_1", "T_2"}
    for quantity in quantities:
        assert quantity.bound is None or quantity.error <= Fraction(quantity.bound)


def test_catalogue():
    assert "chaikin" in subcert.schemes()
    surface = Scheme("chaikin x four-point:w=1/16")
    assert surface.contraction(1) == Fraction(5, 8) * 1
    assert len(surface.masks) == 2
