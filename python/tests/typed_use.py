"""How people use the module, for checkers of types; it runs too."""

from fractions import Fraction
from typing import Any, List, Tuple

import numpy
from typing_extensions import assert_type

from subcert import (
    Intervals,
    Refined,
    Scheme,
    SmoothRange,
    Smoothness,
    Tags,
    VertexSmoothness,
    exact,
    jsr,
    limit_points,
    mesh_depth,
    refine_mesh,
    scheme,
)

rules = numpy.array([[0.75, 0.25], [0.25, 0.75]])
square = numpy.array([(0, 0), (4, 0), (4, 4), (0, 4)])
triangle = numpy.array([(0, 0, 0), (4, 0, 0), (0, 4, 0)])
faces = numpy.array([[0, 1, 2]])

chaikin = Scheme(mask=rules)
Scheme([0.25, 0.75, 0.75, 0.25])
Scheme(mask=[[Fraction(3, 4), "1/4"], numpy.array([0.25, 0.75])])
assert_type(chaikin.contraction(1), Fraction)
assert_type(chaikin.smoothness(), Smoothness)
assert_type(Scheme("loop").smoothness(valence=5), VertexSmoothness)
assert_type(Scheme("four-point").range("w"), Intervals)
assert_type(Scheme("four-point").range("w", smoothness=1), SmoothRange)
assert_type(chaikin.refine([0, 4, 4, 0]), Refined[List[float]])
assert_type(chaikin.refine([(0, 0), (4, 0)]).points, List[Tuple[float, ...]])
assert_type(chaikin.refine(square).points, "numpy.ndarray[Any, numpy.dtype[Any]]")
chaikin.depth(numpy.float32(0.125), polygon=square)
chaikin.geometric_depth("1/4", square)
assert_type(exact(numpy.float64(0.5)) + 1, Fraction)
refine_mesh(Scheme("loop"), triangle, faces, 1, tags=Tags(creases={(numpy.int64(0), numpy.int64(1)): 2}))
limit_points("loop", [(0, 0, 0), (4, 0, 0), (0, 4, 0)], [[0, 1, 2]])
assert_type(mesh_depth("loop", triangle, faces, 0.5).level, int)
assert_type(scheme(chaikin).scheme, str)
jsr(numpy.eye(2, dtype=numpy.float32)[None])
