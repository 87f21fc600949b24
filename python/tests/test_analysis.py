"""Smoothness, spectra and radii against values that are known."""

import math
from fractions import Fraction

import numpy
import pytest

import subcert
from subcert import Scheme, SubcertError, jsr


def test_smoothness_of_b_splines():
    # The limits of the B-spline of degree d are C^{d-1} and not C^d, with the exponent d.
    for degree in range(1, 6):
        found = Scheme("b-spline", degree=degree).smoothness()
        assert (found.continuity, found.continuity_fails) == (degree - 1, degree)
        assert found.hoelder.formula == str(degree) and found.sum_rules == degree + 1
        assert float(found.hoelder) == degree
    # A mask, and a scheme that diverges.
    assert Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]).smoothness().continuity == 1
    found = Scheme("four-point", w=1).smoothness()
    assert (found.continuity, found.continuity_fails, found.hoelder) == (None, 0, None)


def test_surfaces_at_a_vertex():
    for name in ("catmull-clark", "doo-sabin", "loop"):
        assert Scheme(name).smoothness(5).continuous is True
    found = Scheme("doo-sabin", n=5).smoothness()
    assert (found.valence, found.continuous) == (5, True)


def test_spectrum_of_catmull_clark():
    for valence in (3, 4, 5, 7):
        found = Scheme("catmull-clark").spectrum(valence)
        # The known formula of the subdominant eigenvalue.
        c = math.cos(2 * math.pi / valence)
        known = (c + 5 + math.sqrt((c + 9) * (c + 1))) / 16
        assert float(found.subdominant) == pytest.approx(known, abs=1e-14)
        assert found.eigenvalues[0].real.fraction == 1 and found.simple_one
        # The weights of the limit: n/(n + 5) at the vertex, and 1 in all.
        assert found.limit[0][1].fraction == Fraction(valence, valence + 5)
        assert sum(weight.fraction for _, weight in found.limit) == 1


def test_spectra_with_complex_eigenvalues():
    for valence in (3, 4, 5, 7):
        found = Scheme("kobbelt").spectrum(valence)
        # 1 + 6n points, each with an eigenvalue.
        counted = sum(one.multiplicity * (1 if one.imaginary is None else 2) for one in found.eigenvalues)
        assert counted + sum(len(one.blocks) for one in found.complex) <= 1 + 6 * valence
        assert found.simple_one and 0.4 < float(found.subdominant) < 0.6
        assert all(0 < one.lower <= one.upper < Fraction(1, 3) for one in found.complex)
    assert Scheme("kobbelt").spectrum(5).complex and not Scheme("loop").spectrum(5).complex
    found = Scheme("kobbelt").smoothness(5)
    assert found.continuous is None and "polynomials" in found.reason


def test_notes_of_schemes_of_several_steps():
    assert "2 steps" in Scheme("sqrt3").spectrum(5).notes[0]
    assert Scheme("loop").spectrum(5).notes == []


def test_sectors():
    for faces in range(2, 9):
        found = Scheme("catmull-clark").sector(faces)
        c = math.cos(math.pi / faces)
        known = (c + 5 + math.sqrt((c + 9) * (c + 1))) / 16
        assert float(found.across.eigenvalue) == pytest.approx(known, abs=1e-14)
        assert found.across.comparison == ("equal" if faces == 2 else "above")
        assert found.across.second_above == (faces > 4)
        assert sum(float(weight) for _, weight in found.across.tangent) == pytest.approx(0, abs=1e-12)
    corner = Scheme("loop").sector(1, corner=True)
    assert corner.across is None and len(corner.along) == 2
    assert Scheme("loop").sector(3, corner=True).across.tangent is None


def test_radius_is_between_its_bounds():
    first, second = numpy.array([[1, 1], [0, 1]]), numpy.array([[1, 0], [1, 1]])
    found = jsr([first, second])
    assert found.exact and found == jsr([first.tolist(), second.tolist()])
    golden = (1 + math.sqrt(5)) / 2
    low, high = found.interval
    assert low <= golden <= high and high - low < Fraction(1, 10**13)
    assert float(jsr(numpy.array([first, second]) / 2)) == pytest.approx(golden / 2)
    # Of one matrix it is the spectral radius.
    matrix = numpy.array([[0.5, -0.25], [0.75, 0.125]])
    radius = max(abs(numpy.linalg.eigvals(matrix)))
    low, high = jsr([matrix]).interval
    assert low - Fraction(1, 10**12) <= radius <= high
    assert jsr([[[0, 1], [0, 0]]]).interval == (0, 0)


def test_ranges_of_smoothness():
    found = Scheme("four-point").range("w", smoothness=1)
    assert "1/16" in found and 0.0625 in found and -1 not in found
    assert any(1 in interval for interval in found.outside)
    # What is inside is smooth where single values are asked.
    [interval] = found.inside
    middle = (interval.low.interval()[0] + interval.high.interval()[1]) / 2
    assert Scheme("four-point", w=middle).smoothness().continuity == 1
    assert Scheme("four-point").range(smoothness=1) == found


@pytest.mark.parametrize(
    "wrong, words",
    [
        (lambda: jsr([]), "matri"),
        (lambda: jsr([[[1, 2]]]), "square"),
        (lambda: jsr([[[1, 2], [3]]]), "square"),
        (lambda: jsr([[[object()]]]), "object"),
        (lambda: jsr([[[float("nan")]]]), "nan is no number"),
        (lambda: Scheme("chaikin").spectrum(5), "is not a ring"),
        (lambda: Scheme("loop").spectrum(), "spectrum(valence=5)"),
        (lambda: Scheme("doo-sabin").sector(3), "not for `doo-sabin`"),
        (lambda: Scheme("loop").sector(65), "from 1 to 64"),
        (lambda: Scheme(mask=[[1], [1]]).sector(3), "no sectors"),
        (lambda: Scheme("loop").smoothness(), "spectrum(valence=5)"),
        (lambda: Scheme("chaikin x chaikin").smoothness(), "tensor product"),
        (lambda: Scheme("loop").smoothness(2), ""),
        (lambda: Scheme("loop").smoothness(10**6), ""),
        (lambda: Scheme(mask=[[1], [1]]).smoothness(3), "no valence"),
        (lambda: Scheme(mask=[[1], [1]]).spectrum(3), "no spectrum"),
        (lambda: Scheme("chaikin").range(), "0 parameters"),
        (lambda: Scheme("four-point").range("v", smoothness=1), "v"),
        (lambda: Scheme("four-point").range("w", smoothness=9), ""),
    ],
)
def test_errors(wrong, words):
    with pytest.raises(SubcertError) as caught:
        wrong()
    assert words in str(caught.value)


def test_notebooks_get_tables():
    for value in (
        Scheme("chaikin"),
        Scheme(mask=[["3/4", "1/4"], ["1/4", "3/4"]]),
        Scheme("chaikin").smoothness(),
        Scheme("loop").smoothness(5),
        Scheme("loop").spectrum(5),
        Scheme("loop").sector(5),
        Scheme("four-point").range("w", smoothness=1),
        Scheme("chaikin").constants(2),
        Scheme("chaikin").depth("1/10"),
        jsr([[[1, 1], [0, 1]]]),
    ):
        shown = value._repr_html_()
        assert shown.startswith("<table><caption>") and shown.endswith("</table>")
    assert "6 - log_2(9)" in Scheme("six-point", w="3/256").smoothness()._repr_html_()


def test_version():
    assert subcert.__version__.count(".") == 2
