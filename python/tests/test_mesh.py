"""Meshes as arrays."""

from fractions import Fraction

import numpy
import pytest

from subcert import SubcertError, Tags, limit_points, mesh_depth, mesh_geometric_depth, refine_mesh

CUBE = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]


def test_cube():
    # The corners tend to half their distance from the centre.
    limits = limit_points("catmull-clark", CUBE, FACES)
    half = Fraction(1, 2)
    assert limits[0].exact == (-half, -half, -half)
    refined = refine_mesh("catmull-clark", numpy.array(CUBE, dtype=float), FACES, 2)
    assert refined.vertices.shape == (98, 3) and len(refined.faces) == 96
    found = mesh_depth("catmull-clark", CUBE, FACES, "1/100")
    assert found.too_few == found.level - 1
    assert found.distance[0] <= found.distance[1] <= 0.01
    assert mesh_depth("catmull-clark", numpy.array(CUBE), numpy.array(FACES), "1/100") == found
    # As sets of points it needs no more levels.
    sets = mesh_geometric_depth("catmull-clark", numpy.array(CUBE), FACES, "1/100")
    assert sets.level <= found.level and sets.too_few == sets.level - 1
    assert sets.of in ("mesh", "limit") and sets.distance >= 0.01
    fan = mesh_geometric_depth("catmull-clark", CUBE, FACES, "1/100", faces_are="fan")
    assert fan.level <= found.level
    with pytest.raises(SubcertError, match="fan"):
        mesh_geometric_depth("catmull-clark", CUBE, FACES, "1/100", faces_are="flat")


def test_tags():
    ring = [(4, 5), (5, 7), (7, 6), (6, 4)]
    creased = Tags(creases={ends: float("10") for ends in ring})
    # (1, 4, 1)/6 along the crease.
    limits = limit_points("catmull-clark", CUBE, FACES, tags=creased)
    assert limits[4].exact == (Fraction(-2, 3), Fraction(-2, 3), 1)
    refined = refine_mesh("catmull-clark", CUBE, FACES, 2, tags=creased)
    assert len(refined.tags.creases) == 16 and set(refined.tags.creases.values()) == {10}
    again = refine_mesh("catmull-clark", refined.vertices, refined.faces, tags=refined.tags)
    assert len(again.vertices) == 386
    fallen = refine_mesh("catmull-clark", CUBE, FACES, tags=Tags(creases={(0, 1): "1/2"}, holes=[3]))
    assert fallen.tags.creases == {} and len(fallen.tags.holes) == 4
    for tags in (creased, Tags(creases={(0, 1): 10, (1, 3): "5/2"}, corners={6: 10}, holes=[0])):
        found = mesh_depth("catmull-clark", CUBE, FACES, "1/50", tags=tags)
        sets = mesh_geometric_depth("catmull-clark", CUBE, FACES, "1/50", tags=tags)
        assert sets.too_few is not None and sets.too_few < sets.level <= found.level
    for tags, words in [
        (Tags(creases={(0, 7): 1}), "0 and 7"),
        (Tags(corners={9: 1}), "9"),
        (Tags(holes=[-1]), "-1"),
        (Tags(creases={(0, 1): -1}), "0 or more"),
        (Tags(creases={(0, 1): float("nan")}), "nan"),
        (Tags(boundary="smooth"), "corner"),
        (Tags(creasing="none"), "chaikin"),
    ]:
        with pytest.raises(SubcertError) as caught:
            refine_mesh("catmull-clark", CUBE, FACES, tags=tags)
        assert words in str(caught.value)
    with pytest.raises(SubcertError, match="doo-sabin"):
        mesh_depth("doo-sabin", CUBE, FACES, 1, tags=creased)


def test_wrong_meshes():
    for vertices, faces, words in [
        (CUBE, [[0, 1, 9]], "9"),
        (CUBE[:3], [[0, 1, -1]], "-1"),
        ([(0, 0)], [[0, 1, 2]], "three coordinates"),
        ([], [], "no vertices"),
        ("cube.obj", FACES, "no list of points"),
        ([(0, 0, float("inf"))] * 3, [[0, 1, 2]], "inf"),
    ]:
        with pytest.raises(SubcertError) as caught:
            mesh_depth("loop", vertices, faces, "1/10")
        assert words in str(caught.value)
    with pytest.raises(SubcertError, match="catmull-clark"):
        mesh_depth("catmul-clark", CUBE, FACES, 1)
