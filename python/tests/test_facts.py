"""The facts of schemes against what the other functions compute, and their display."""

from fractions import Fraction

import pytest

import subcert
from subcert import Scheme, SubcertError


@pytest.mark.parametrize(
    "name, parameters",
    [("chaikin", {}), ("six-point", {"w": Fraction(3, 256)}), ("ternary-four-point", {"mu": "1/11"})],
)
def test_facts_of_masks(name, parameters):
    found, curve = Scheme(name, **parameters), subcert.scheme(name, **parameters).curve
    constants = found.constants(3)
    assert [Fraction(x["exact"]) for x in curve["contraction"][:3]] == constants.contraction
    assert [Fraction(x["exact"]) for x in curve["norm"][:3]] == constants.norm
    assert Fraction(curve["displacement"]["exact"]) == constants.displacement
    smooth = found.smoothness()
    assert (curve["continuity"], curve["sum_rules"]) == (smooth.continuity, smooth.sum_rules)
    assert curve["hoelder"]["exact"] == smooth.hoelder.formula
    assert curve["depth_natural"]["upper"] == found.depth("1/100").level
    # The values of the basic limit function at the integers sum to 1.
    assert sum(Fraction(x["exact"]) for x in curve["values"]) == 1


def test_the_family_is_the_range():
    ranges = subcert.scheme("four-point", w="1/16").ranges
    assert ranges["parameter"] == "w"
    [inside] = ranges["orders"][1]["inside"]
    low, high = (float(inside[end]["decimal"]) for end in ("low", "high"))
    # The greatest w is the root of 32w^3 + 4w - 1, just above what is proved.
    assert low == 0 and 0.19 < high and 32 * high**3 + 4 * high - 1 < 0
    assert subcert.scheme("b-spline", degree=3).ranges is None


def test_irrational_masks_and_surfaces():
    curve = subcert.scheme("daubechies-4").curve
    # 2 - log_2(1 + √3), known since 1992.
    assert curve["continuity"] == 0 and curve["hoelder"]["lower"].startswith("0.55001")
    found = subcert.scheme("loop")
    assert found.curve is None and found.ranges is None
    for row in found.valences:
        assert row["vertex"]["verdict"] == "proved"
    assert [row["valence"] for row in subcert.scheme("loop", N=7).valences] == [7]


def test_masks_of_several_variables():
    mask = subcert.scheme("1+(x+1/x+y+1/y)/4:dilation=[[1,1],[1,-1]]")
    assert mask.curve is None and mask.lattice["arity"] == 2
    # 4 - 2 log_2(1 + √5).
    assert mask.lattice["hoelder"]["lower"].startswith("0.61151617")
    net = subcert.scheme("four-point x four-point")
    assert net.lattice["contraction"][0]["exact"] == "49/64"
    assert "[-3, 3] × [-3, 3]" in net._repr_html_() and "T_c" in net._repr_html_()


def test_what_is_refused():
    for bad in ("no such scheme", "chaikin x", "", "four-point:w=", "(1+x)*(1+y)/3"):
        with pytest.raises(SubcertError):
            subcert.scheme(bad)
    with pytest.raises(SubcertError):
        subcert.scheme("four-point", v=1)
    with pytest.raises(TypeError):
        subcert.scheme()


def test_every_name_of_the_catalogue_is_listed_and_shown():
    names = subcert.schemes()
    assert len(names) >= 60 and len(set(names)) == len(names)
    for name, parameters in [("chaikin", {}), ("haar", {}), ("daubechies-4", {}), ("loop", {"N": 4}), ("four-point", {})]:
        shown = subcert.scheme(name, **parameters)._repr_html_()
        assert shown.startswith(f"<table><caption>{name}") and shown.count("<table>") == shown.count("</table>")
    assert "diverges" in subcert.scheme("haar")._repr_html_()
    assert "The family, in w" in subcert.scheme("four-point")._repr_html_()
