"""Numbers of numpy and pandas are taken everywhere, and exact numbers behave as numbers."""

import math
from decimal import Decimal
from fractions import Fraction

import numpy
import pandas
import pytest

import subcert
from subcert import Scheme, SubcertError, Tags, exact

CHAIKIN = [[0.75, 0.25], [0.25, 0.75]]
CUBE = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]

EIGHTH = [
    numpy.float16(0.125),
    numpy.float32(0.125),
    numpy.float64(0.125),
    numpy.longdouble(1) / 8,
    numpy.array(0.125),
    numpy.array(0.125, dtype=numpy.float32),
    Decimal("0.125"),
    "1/8",
    Fraction(1, 8),
]


@pytest.mark.parametrize("eighth", EIGHTH, ids=lambda x: type(x).__name__)
def test_every_number_everywhere(eighth):
    assert exact(eighth) == Fraction(1, 8)
    assert Scheme("four-point", w=eighth) == Scheme("four-point", w="1/8")
    assert Scheme("chaikin").depth(eighth, spread=eighth) == Scheme("chaikin").depth("1/8", spread="1/8")
    assert Scheme(mask=[[eighth, "7/8"], ["7/8", eighth]]) == Scheme(mask=[["1/8", "7/8"], ["7/8", "1/8"]])
    assert Scheme("chaikin").refine([eighth, 1]).exact == Scheme("chaikin").refine(["1/8", 1]).exact
    assert subcert.jsr([[[eighth]]]).interval[0] == Fraction(1, 8)
    assert eighth in Scheme("four-point").range("w", levels=1)[0]
    # All floats of numpy are floats beyond the precision of Python's too.
    tiny = numpy.longdouble(1) + numpy.finfo(numpy.longdouble).eps
    assert exact(tiny) - 1 == Fraction(*numpy.finfo(numpy.longdouble).eps.as_integer_ratio())


@pytest.mark.parametrize(
    "wrong, words",
    [
        (math.nan, "nan is no number; give a finite number"),
        (numpy.float32("inf"), "inf is no number; give a finite number"),
        (Decimal("NaN"), "NaN is no number; give a finite number"),
        (1j, "a complex is no number"),
        (numpy.complex64(1), "a complex is no number"),
        (numpy.clongdouble(1), "is no number"),
        (True, "a bool is no number"),
        (numpy.bool_(True), "a bool is no number"),
        (None, "a NoneType is no number"),
        (numpy.array([1, 2]), "a ndarray is no number"),
        ("a", "a"),
    ],
)
def test_what_is_no_number(wrong, words):
    with pytest.raises(SubcertError) as caught:
        exact(wrong)
    assert words in str(caught.value)


def test_indices_of_numpy():
    tags = Tags(creases={(numpy.int64(0), numpy.uint8(1)): numpy.float32(2)}, corners={numpy.int32(3): 10}, holes=numpy.array([2]))
    faces = [numpy.array(face, dtype=numpy.uint16) for face in FACES]
    found = subcert.refine_mesh("catmull-clark", numpy.array(CUBE, dtype=numpy.float32), faces, 1, tags=tags)
    assert found == subcert.refine_mesh("catmull-clark", CUBE, FACES, 1, tags=Tags({(0, 1): 2}, {3: 10}, [2]))
    for wrong in [[0.0, 1, 2]], [[True, 1, 2]], [[-1, 1, 2]], [["0", 1, 2]]:
        with pytest.raises(SubcertError, match="indices are ints"):
            subcert.refine_mesh("loop", CUBE, wrong)
    with pytest.raises(SubcertError, match="face 0 is 0; a face is a list"):
        subcert.refine_mesh("loop", CUBE, numpy.array(FACES).ravel())


def test_tables_of_pandas():
    frame = pandas.DataFrame({"x": [0, 4, 4, 0], "y": [0, 0, 4, 4]})
    points = frame.to_numpy().tolist()
    scheme = Scheme("chaikin")
    assert scheme.depth("1/10", polygon=frame) == scheme.depth("1/10", polygon=points)
    assert scheme.refine(frame, 2).exact == scheme.refine([tuple(p) for p in points], 2).exact
    assert scheme.refine(frame.x).exact == scheme.refine([0, 4, 4, 0]).exact
    assert scheme.geometric_depth("1/4", frame) == scheme.geometric_depth("1/4", points)
    assert Scheme(mask=pandas.DataFrame(CHAIKIN)) == Scheme(mask=CHAIKIN)
    assert Scheme(pandas.Series([0.25, 0.75, 0.75, 0.25])) == Scheme("[1, 3, 3, 1]/4")
    cube = pandas.DataFrame(CUBE, columns=list("xyz"))
    limits = subcert.limit_points("catmull-clark", cube, pandas.DataFrame(FACES))
    assert limits == subcert.limit_points("catmull-clark", CUBE, FACES)


def test_flat_masks():
    named = Scheme("[1, 3, 3, 1]/4")
    quarters = [Fraction(1, 4), Fraction(3, 4), Fraction(3, 4), Fraction(1, 4)]
    for flat in (quarters, [0.25, 0.75, 0.75, 0.25], ["1/4", "3/4", ".75", "0.25"], numpy.array([1, 3, 3, 1]) / 4, iter(quarters)):
        assert Scheme(mask=flat) == named
    assert Scheme(quarters).offsets == named.offsets and hash(Scheme(quarters)) == hash(named)
    assert Scheme(iter([iter(row) for row in CHAIKIN])) == Scheme(mask=CHAIKIN)
    # Its sum is the arity.
    assert len(Scheme([1, 1, 1]).masks[0]) == 3
    rules = Scheme("[1, 4, 6, 4, 1]/8")
    assert Scheme(mask=rules.masks[0], offset=rules.offsets[0]) == rules
    assert Scheme(mask=rules.masks[0], offset=rules.offsets[0] + 1) != rules
    assert rules.depth("1/100", natural=False).level == 3
    for wrong, words in [
        (lambda: Scheme([1, 3, 3, 1]), "write 1/4*[1, 3, 3, 1] for the arity 2"),
        (lambda: Scheme([[1, 0], 1]), "some are numbers"),
        (lambda: Scheme([0.5, 1, 0.5], offset=1), "offset of its own"),
        (lambda: Scheme("chaikin", offset=1), "offset of its own"),
        (lambda: Scheme(7), "a int is no mask"),
        (lambda: Scheme([0.5, 1, 0.5], w=1), "no parameters"),
    ]:
        with pytest.raises(SubcertError) as caught:
            wrong()
        assert words in str(caught.value)


@pytest.mark.parametrize(
    "mask, remedy",
    [
        (numpy.array([[0.7, 0.2, 0.1], [0.1, 0.2, 0.7]]), "mask.astype(str)"),
        ([[0.7, 0.2, 0.1], [0.1, 0.2, 0.7]], "str(x) for x in row"),
        ([[1 / 3, 2 / 3], [2 / 3, 1 / 3]], "limit_denominator"),
        ([0.5, 1.0, 0.75], None),
        ([[0.5, 0.5]], None),
        ([[0.7, 0.2], [0.1, 0.2]], None),
    ],
)
def test_floats_in_masks(mask, remedy):
    with pytest.raises(SubcertError) as caught:
        Scheme(mask=mask)
    assert remedy in caught.value.remedy if remedy else "float" not in (caught.value.remedy or "")
    if remedy == "mask.astype(str)":
        assert Scheme(mask=mask.astype(str)).contraction() == Fraction(6, 5)


def test_limit_stencils():
    zero, moved = Scheme(mask=CHAIKIN, offset=0).limit_stencils()
    assert zero.at == 0 and moved.at == Scheme(mask=CHAIKIN).smoothness().natural_shift
    for stencil in zero, moved:
        assert sum(stencil.weights.values()) == 1
    # Values of the quadratic B-spline at half integers and at integers.
    assert sorted(zero.weights.values()) == [Fraction(1, 2)] * 2
    assert sorted(moved.weights.values()) == [Fraction(1, 8), Fraction(1, 8), Fraction(3, 4)]
    # The facts have them too, of schemes as of names.
    for scheme in Scheme("chaikin"), Scheme("chaikin").masks[0]:
        scheme = scheme if isinstance(scheme, Scheme) else Scheme(mask=scheme)
        facts = subcert.scheme(scheme).curve["stencils"]
        weights = [{x["index"]: Fraction(x["exact"]) for x in one["weights"]} for one in facts]
        assert weights == [one.weights for one in scheme.limit_stencils()]
    with pytest.raises(SubcertError):
        Scheme("four-point", w=1).limit_stencils()


def test_real_numbers_are_numbers():
    value = Scheme("catmull-clark").spectrum(5).subdominant
    near = float(value)
    assert f"{value:.3f}" == f"{near:.3f}" and round(value, 3) == round(near, 3) and round(value) == 1
    assert value > 0.5 and value < 1 and value >= Fraction(1, 2) and not value == near and value != near
    assert value < math.inf and not value < math.nan and value != math.nan
    # The float is the nearest one, and no more than that.
    assert (value > near) != (value < near)
    double = value + value
    assert double == 2 * value == value * 2 and double / 2 == value and double - value == value
    assert (value - value).fraction == 0 and (value / value).fraction == 1 and (1 / value) * value == 1
    assert (value + 1) - 1 == value and 1 - value == -(value - 1) and abs(-value) == value
    assert hash(value) == hash(double / 2) and len({value, double / 2}) == 1
    assert sum([value, value]) == double and math.isclose(value, near)
    weight = Scheme("loop").spectrum(6).limit[0][1]
    assert weight == Fraction(1, 2) == weight and exact(weight) == Fraction(1, 2)
    assert hash(weight) == hash(Fraction(1, 2))
    with pytest.raises(SubcertError, match="is irrational"):
        exact(value)
    with pytest.raises(TypeError):
        value < "1"
    with pytest.raises(TypeError):
        value + "1"
    with pytest.raises(ZeroDivisionError):
        value / 0
    # Every eigenvalue and weight can be read again.
    for name in ("catmull-clark", "doo-sabin", "loop"):
        found = Scheme(name).spectrum(7)
        for x in [x.real for x in found.eigenvalues] + [w for _, w in found.tangents[0]]:
            assert (x + 0) == x and float(x + 0) == float(x)


def test_algebraic_numbers_are_numbers():
    end = Scheme("four-point").range("w", levels=2)[-1].high
    assert end.minpoly == [-3, 4, 16] and f"{end:.3f}" == "0.326" and round(end, 2) == 0.33
    for factor, shift in [(Fraction(3, 7), 2), (-2, Fraction(1, 3)), (1, 0)]:
        moved = factor * end + shift
        assert (moved - shift) / factor == end and math.isclose(moved, factor * float(end) + float(shift))
    # 16x^2 + 4x - 3 = 0: 1/x = (16x + 4)/3.
    assert 1 / end == (16 * end + 4) / 3
    assert end * 0 == 0 and -end < 0 < end and abs(-end) == end
    with pytest.raises(SubcertError, match="two irrational numbers"):
        end * (end + 1)
    # Beside a real number: √13, as 8x + 1.
    root = subcert._analysis._real(subcert._native.real("sqrt(13)"))
    assert root == 8 * end + 1 == root and not root < 8 * end + 1
    assert root < 8 * end + Fraction(1001, 1000)
    with pytest.raises(SubcertError, match="two irrational numbers"):
        root + end


def test_exponents_are_numbers():
    found = Scheme("six-point", w="3/256").smoothness().hoelder
    assert f"{found:.3f}" == "2.830" and round(found, 3) == 2.830 and 2 < found < 3 and found != 3
    other = Scheme("four-point", w="1/16").smoothness().hoelder
    assert other == 2 and other < found and found == found and len({found, found}) == 1
    with pytest.raises(SubcertError, match="the comparison is open"):
        found < (found.low + found.high) / 2


def test_huge_numbers_are_shown():
    huge = Scheme(mask=[[10**400, 1 - 10**400], ["1/2", "1/2"]])
    assert "e+400" in str(huge.constants(2)) and "e+400" in huge.constants(2)._repr_html_()
    tiny = subcert.Depth(1, 0, (Fraction(1, 10**400), Fraction(1, 10**399)), None)
    assert "1e-400" in tiny._repr_html_() and "1e-399" in tiny._repr_html_()
    assert len(huge.constants(2).to_pandas()) == 2


def test_meshes_as_answers():
    found = subcert.refine_mesh("catmull-clark", numpy.array(CUBE, dtype=float), FACES, 2)
    same = subcert.refine_mesh("catmull-clark", CUBE, FACES, 2)
    assert found == same and not found != same and found != subcert.refine_mesh("catmull-clark", CUBE, FACES)
    assert repr(found) == "RefinedMesh(98 vertices, 96 faces)"
    assert list(found.to_pandas().columns) == ["x", "y", "z"] and len(found.to_pandas()) == 98
    assert "<td>98</td>" in found._repr_html_()
    cell = [[0, 1, 3, 2, 4, 5, 7, 6]]
    solid = subcert.refine_solid(numpy.array(CUBE), cell)
    assert solid == subcert.refine_solid(CUBE, cell) and repr(solid) == "RefinedSolid(27 points, 8 cells)"
    # The scheme may be an object with such a name.
    assert subcert.refine_mesh(Scheme("catmull-clark"), CUBE, FACES, 2) == same
    net = [[(i, j, 0) for j in range(4)] for i in range(4)]
    assert subcert.refine_net(Scheme("chaikin x chaikin"), net) == subcert.refine_net("chaikin x chaikin", net)
    for wrong in Scheme(mask=CHAIKIN), 7:
        with pytest.raises(SubcertError, match="no rules for meshes"):
            subcert.refine_mesh(wrong, CUBE, FACES)


def test_short_forms():
    found = subcert.audit("khan2019-newton")
    assert repr(found).startswith("Audit('khan2019-newton', ") and len(repr(found)) < 200
    assert str(found).count("\n") == len(found) + 1
    frame = found.to_pandas()
    reading = frame.reading.dropna()
    assert len(reading) and not reading.str.startswith("{").any()
    assert not any(x is None for column in frame for x in frame[column])
    refined = Scheme("chaikin").refine(numpy.array(CUBE), 3)
    assert repr(refined).startswith("Refined(64 points: (") and len(repr(refined)) < 200
    assert refined._repr_html_().count("<tr>") == 14
