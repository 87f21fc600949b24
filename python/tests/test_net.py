"""Nets and solids as arrays."""

from fractions import Fraction

import numpy
import pytest

from subcert import (
    SubcertError,
    limit_net,
    mesh_depth,
    net_depth,
    net_geometric_depth,
    refine_net,
    refine_solid,
    solid_depth,
    solid_geometric_depth,
    solid_limit_points,
)

ROOF = [[(i, j, abs(j - 2)) for j in range(5)] for i in range(4)]
CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CELL = [[0, 1, 3, 2, 4, 5, 7, 6]]
CUBIC = "b-spline:degree=3 x b-spline:degree=3"


def chaikin(points):
    """Chaikin's scheme along the first axis, open."""
    here, after = points[:-1], points[1:]
    refined = numpy.empty((2 * len(here), *points.shape[1:]))
    refined[0::2] = 0.75 * here + 0.25 * after
    refined[1::2] = 0.25 * here + 0.75 * after
    return refined


def test_refined_nets():
    points = numpy.array(ROOF, dtype=float)
    refined = refine_net("chaikin x chaikin", points)
    expected = chaikin(chaikin(points).swapaxes(0, 1)).swapaxes(0, 1)
    assert refined.shape == (6, 8, 3)
    assert numpy.array_equal(refined, expected)
    closed = refine_net("chaikin x chaikin", points, closed="uv")
    assert closed.shape == (8, 10, 3)
    # As lists, the same.
    assert numpy.array_equal(numpy.array(refine_net("chaikin x chaikin", ROOF)), refined)


def test_depths_of_nets():
    found = net_depth(CUBIC, ROOF, "1/20")
    assert found.too_few == found.level - 1
    assert found.distance[0] <= found.distance[1] <= 0.05
    assert net_depth(CUBIC, numpy.array(ROOF), "1/20") == found
    sets = net_geometric_depth(CUBIC, numpy.array(ROOF), "1/20")
    assert sets.level <= found.level and sets.distance >= 0.05
    # Uniform cubic B-splines: the limit of a point is (1, 4, 1)/6 in each direction.
    limits = limit_net(CUBIC, ROOF)
    assert limits[0][0] is None
    assert limits[1][2].exact == (1, 2, Fraction(1, 3))


def test_solids():
    refined = refine_solid(numpy.array(CUBE), CELL, 2)
    assert refined.points.shape == (125, 3) and len(refined.cells) == 64
    found = solid_depth(CUBE, CELL, "1/100")
    assert found.distance[1] <= 0.01 and found.too_few == found.level - 1
    sets = solid_geometric_depth(numpy.array(CUBE), CELL, "1/100")
    assert sets.level <= found.level and sets.distance >= 0.01 and sets.face == 0
    # The corners are as far from the centre as in Catmull-Clark's limit of the same cube.
    limits = solid_limit_points(CUBE, CELL)
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    assert len(limits) == 8 and all(limit.exact is not None for limit in limits)
    centre = Fraction(1, 2)
    assert len({abs(x - centre) for limit in limits for x in limit.exact}) == 1
    assert mesh_depth("catmull-clark", CUBE, faces, "1/100").level >= 1


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: net_depth(CUBIC, ROOF, "1/20", closed="w"), "none"),
        (lambda: net_depth(CUBIC, [[(0, 0, 0)], []], 1), "row 1 has 0 points"),
        (lambda: net_depth(CUBIC, [(0, 0, 0)], 1), "three coordinates"),
        (lambda: net_depth(CUBIC, [], 1), "no points"),
        (lambda: net_depth(CUBIC, ROOF, 0), "positive"),
        (lambda: refine_net(CUBIC, ROOF, 60), "level"),
        (lambda: solid_depth(CUBE, [[0, 1, 2]], 1), "eight"),
        (lambda: solid_depth(CUBE, [[0, 1, 3, 2, 4, 5, 7, 9]], 1), "9"),
        (lambda: solid_depth(CUBE, [[0, 1, 3, 2, 4, 5, 7, -1]], 1), "counted from 0"),
        (lambda: solid_limit_points([], []), "no points"),
    ],
)
def test_wrong_input(call, words):
    with pytest.raises(SubcertError) as caught:
        call()
    assert words in str(caught.value)
