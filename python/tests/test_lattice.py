"""Masks on Z^d against products of schemes of curves, and what is refused."""

from fractions import Fraction

import pytest

import subcert
from subcert import Lattice, Scheme, SubcertError


def test_products_have_the_numbers_of_their_factors():
    curve, product = Scheme("four-point", w="1/16"), Lattice("four-point:w=1/16 x four-point:w=1/16")
    assert product.norm(2) == curve.norm(2) ** 2
    assert product.contraction(1) <= curve.contraction(1) * curve.norm(1)
    assert product.smoothness().continuity == curve.smoothness().continuity
    assert sum(product.values().values()) == 1
    # The same coefficients at other places.
    named, typed = Lattice("chaikin x chaikin"), Lattice("(1+x)^3*(1+y)^3/16")
    assert sorted(named.coefficients.values()) == sorted(typed.coefficients.values())


def test_depths_are_between_bounds():
    few, enough = Lattice("loop-regular").depth("1/100", 2, natural=False)
    assert 0 < few <= enough
    with pytest.raises(SubcertError):
        Lattice("loop-regular").depth(0)
    with pytest.raises(SubcertError):
        Lattice("loop-regular").contraction(0)


def test_nets_take_masks():
    net = [[(i, j, i * i - i * j + j * j) for j in range(7)] for i in range(7)]
    found = subcert.net_depth("loop-regular", net, "1/100")
    assert (found.level, found.too_few) == (3, 2)
    refined = subcert.refine_net("loop-regular", net)
    assert len(refined) == 11 and len(refined[0]) == 11
    limits = subcert.limit_net("loop-regular", net)
    assert limits[2][2].exact[2] == Fraction(9, 2)
    with pytest.raises(SubcertError, match="net_depth"):
        subcert.net_geometric_depth("loop-regular", net, "1/100")


def test_what_is_no_lattice_is_refused():
    with pytest.raises(SubcertError):
        Lattice("chaikin")
    with pytest.raises(SubcertError, match="Lattice"):
        Scheme("loop-regular").contraction(1)
    with pytest.raises(SubcertError, match="converge"):
        Lattice("butterfly-regular", w=4).values()
