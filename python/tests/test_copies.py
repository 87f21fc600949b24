"""Schemes and answers can be copied and pickled, compare, and are tables."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from dataclasses import FrozenInstanceError
from fractions import Fraction
from multiprocessing import get_context

import numpy
import pandas
import pytest

import subcert
from subcert import Algebraic, Scheme, SubcertError, jsr

CHAIKIN = [["3/4", "1/4"], ["1/4", "3/4"]]


def copies(value):
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        yield pickle.loads(pickle.dumps(value, protocol))
    yield copy.copy(value)
    yield copy.deepcopy(value)


@pytest.mark.parametrize(
    "new",
    [
        lambda: Scheme("chaikin"),
        lambda: Scheme("six-point", w=Fraction(3, 256)),
        lambda: Scheme(mask=CHAIKIN, offset=-1),
        lambda: Scheme(mask=[[1 - Fraction(1, 10**5000), Fraction(1, 10**5000)], [0, 1]]),
        lambda: Scheme("chaikin x four-point:w=1/16"),
        lambda: Scheme("[1, 3, 3, 1]/4"),
    ],
)
def test_schemes_before_and_after_use(new):
    used = new()
    wanted = used.contraction(2), used.masks, used.offsets
    for scheme in (new(), used):
        for other in copies(scheme):
            assert other == scheme == used and hash(other) == hash(used)
            assert (other.contraction(2), other.masks, other.offsets) == wanted
            assert repr(other) == repr(scheme) and len(repr(other)) < 200


def test_schemes_without_masks():
    for other in copies(Scheme("six-point")):
        assert other == Scheme("six-point") and other.range("w", levels=1)
    for other in copies(Scheme("loop")):
        assert other.spectrum(6) == Scheme("loop").spectrum(6)
    for other in copies(Scheme("chiakin")):
        with pytest.raises(SubcertError, match="chaikin"):
            other.contraction()


def test_which_schemes_are_equal():
    exact = Scheme(mask=CHAIKIN)
    assert exact == Scheme(mask=numpy.array([[0.75, 0.25], [0.25, 0.75]]))
    assert Scheme("four-point", w="1/16") == Scheme("four-point:w=1/16")
    different = [exact, Scheme(mask=CHAIKIN, offset=1), Scheme(mask=[["1/4", "3/4"], ["3/4", "1/4"]])]
    different += [Scheme("chaikin"), Scheme("four-point"), Scheme("four-point", w="1/16"), Scheme("loop")]
    assert len(set(different)) == len(different)
    assert exact != CHAIKIN and exact is not None


def test_a_file_travels_with_its_mask(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text('name = "own"\nmask = [["3/4", "1/4"], ["1/4", "3/4"]]\n')
    sent = pickle.dumps(Scheme(path))
    path.unlink()
    assert pickle.loads(sent).contraction(1) == Fraction(1, 2)


def ends():
    union = Scheme("four-point").range("w", levels=3)
    return [end for interval in union for end in (interval.low, interval.high)]


def test_algebraic_numbers():
    numbers = ends() + [jsr([[[1, 1], [0, 1]], [[1, 0], [1, 1]]]).root]
    assert any(number.as_fraction() is None for number in numbers)
    for number in numbers:
        float(number), number.minpoly
        for other in copies(number):
            assert type(other) is Algebraic and other is not number
            assert other == number and hash(other) == hash(number) and not other < number
            assert other.minpoly == number.minpoly and float(other) == float(number)
            assert other.interval(50)[0] <= number.interval(50)[1]
            assert len(repr(other)) < 120
    # A number and a fraction of the same value are one key; a text is no number.
    quarter = Scheme("four-point").range("w", levels=1)[0].high
    assert quarter == Fraction(1, 4) == 0.25 and len({quarter, Fraction(1, 4), 0.25}) == 1
    assert quarter != "1/4" and quarter != numpy.nan
    with pytest.raises(TypeError):
        quarter > "1/4"
    # Roots of different polynomials: √2 of x² − 2 and of (x² − 2)(x² − 3).
    one = subcert._numbers._algebraic([-2, 0, 1], (1, 1), (2, 1))
    two = subcert._numbers._algebraic([6, 0, -5, 0, 1], (1, 1), (3, 2))
    assert one == two and hash(one) == hash(two)
    for wrong in [0], [], [-2, 0, 1], [3, 0, 1]:
        with pytest.raises(SubcertError):
            subcert._numbers._algebraic(wrong, (-2, 1), (2, 1))
    with pytest.raises(SubcertError, match="denominator 0"):
        subcert._numbers._algebraic([-2, 0, 1], (1, 0), (2, 1))


def answers():
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    scheme = Scheme("chaikin")
    return [
        scheme.constants(2),
        scheme.depth("1/10"),
        scheme.geometric_depth("1/10", square),
        scheme.refine(square, 2),
        scheme.refine(numpy.array(square), 2),
        scheme.smoothness(),
        scheme.certify(2),
        Scheme("loop").smoothness(5),
        Scheme("loop").spectrum(5),
        Scheme("loop").sector(5),
        Scheme("four-point").range("w", levels=3),
        Scheme("four-point").range("w", smoothness=1),
        jsr([[[1, 1], [0, 1]]]),
    ]


def test_answers_are_copied_and_are_tables():
    for answer in answers():
        for other in copies(answer):
            assert type(other) is type(answer) and other == answer
        rows = answer.rows()
        assert rows and len({tuple(row) for row in rows}) == 1
        frame = answer.to_pandas()
        assert list(frame.columns) == list(rows[0]) and len(frame) == len(rows)
        assert len(pandas.DataFrame(rows)) == len(rows)
        assert answer._repr_html_().startswith("<table><caption>")
        assert len(repr(answer)) < 4000


def test_ranges_as_text():
    found = Scheme("ternary-four-point").range("mu", smoothness=2)
    text = str(found).splitlines()
    assert text[0] == "Where the limits are smooth"
    assert text[1].split() == ["limits", "interval", "from", "to"]
    assert text[2].split()[:2] == ["inside", "(1/15,"]
    assert any(line.split()[-1] == "∞" for line in text)
    assert len(text) == 2 + len(found.inside) + len(found.outside)
    assert str(found.inside[0]).startswith("(1/15, ")
    # An end that belongs to an interval, as a number of either kind.
    end = found.outside[0].high
    assert found.outside[0].high_included and end in found.outside[0] and end.as_fraction() in found.outside[0]
    none = subcert.Intervals()
    assert str(none).splitlines()[0] == "Intervals" and none._repr_html_()


def task(scheme):
    return scheme, Scheme("four-point").range("w", levels=2), scheme.constants(2)


def test_processes_bring_results_back():
    schemes = [Scheme("chaikin"), Scheme(mask=CHAIKIN), Scheme("six-point", w="3/256")]
    schemes[1].contraction(1)
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        assert list(pool.map(task, schemes)) == [task(scheme) for scheme in schemes]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: Scheme("chaikin").contraction(-1), "c is -1; give an int from 1 on"),
        (lambda: Scheme("chaikin").norm(-2), "c is -2; give an int from 1 on"),
        (lambda: Scheme("chaikin").contraction(2**40), "c is 1099511627776; give an int up to"),
        (lambda: Scheme("chaikin").constants(-1), "levels is -1; give an int from 0 on"),
        (lambda: Scheme("chaikin").certify(-1), "levels is -1"),
        (lambda: Scheme("chaikin").refine([0, 1], -1), "levels is -1"),
        (lambda: Scheme("four-point").range(levels=0), "levels is 0; give an int from 1 on"),
        (lambda: Scheme("four-point").range(smoothness=-1), "smoothness is -1"),
        (lambda: Scheme("loop").spectrum(-3), "valence is -3"),
        (lambda: Scheme("loop").smoothness(0), "valence is 0"),
        (lambda: Scheme("loop").sector(0), "faces is 0"),
        (lambda: ends()[0].interval(-1), "digits is -1"),
        (lambda: subcert.refine_mesh("loop", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]], -1), "levels is -1"),
        (lambda: subcert.net_depth("bicubic", [[(i, j, 0) for j in range(5)] for i in range(2)], 1), 'closed="u"'),
        (lambda: Scheme("loop", N=5).contraction(), "spectrum, smoothness and sector"),
        (
            lambda: subcert.net_geometric_depth(
                "bicubic", [[(i, j, i * j % 3) for j in range(5)] for i in range(5)], "1e-60"
            ),
            "compare at equal parameters",
        ),
    ],
)
def test_errors_speak_of_arguments(call, words):
    with pytest.raises(SubcertError) as caught:
        call()
    assert words in str(caught.value) and "--" not in str(caught.value)


def test_a_count_is_an_int():
    with pytest.raises(TypeError):
        Scheme("chaikin").contraction(1.5)
    assert Scheme("chaikin").contraction(numpy.int64(2)) == Fraction(1, 4)


def test_answers_do_not_change():
    with pytest.raises(FrozenInstanceError):
        Scheme("chaikin").depth("1/10").level = 0
