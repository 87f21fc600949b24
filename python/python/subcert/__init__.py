"""Exact constants of subdivision schemes, audits of papers, and reference values for tests.

>>> from fractions import Fraction
>>> import subcert
>>> scheme = subcert.Scheme("six-point", w=Fraction(3, 256))
>>> scheme.contraction(1)
Fraction(89, 128)
"""

from ._audit import Audit, Finding, audit, papers
from ._errors import SubcertError
from ._mesh import LimitPoint, MeshDepth, RefinedMesh, limit_points, mesh_depth, refine_mesh
from ._numbers import Algebraic, exact
from ._scheme import Constants, Depth, Interval, Quantity, Refined, Scheme, schemes

__all__ = [
    "Algebraic",
    "Audit",
    "Constants",
    "Depth",
    "Finding",
    "Interval",
    "LimitPoint",
    "MeshDepth",
    "Quantity",
    "Refined",
    "RefinedMesh",
    "Scheme",
    "SubcertError",
    "audit",
    "exact",
    "limit_points",
    "mesh_depth",
    "papers",
    "refine_mesh",
    "schemes",
]
