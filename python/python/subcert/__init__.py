"""Exact constants of subdivision schemes, audits of papers, and reference values for tests.

>>> from fractions import Fraction
>>> import subcert
>>> scheme = subcert.Scheme("six-point", w=Fraction(3, 256))
>>> scheme.contraction(1)
Fraction(89, 128)
"""

from ._audit import Audit, Finding, audit, papers
from ._errors import SubcertError
from ._geometry import LimitPoint, MeshDepth
from ._mesh import RefinedMesh, limit_points, mesh_depth, refine_mesh
from ._net import limit_net, net_depth, refine_net
from ._numbers import Algebraic, exact
from ._scheme import Constants, Depth, Interval, Quantity, Refined, Scheme, schemes
from ._solid import RefinedSolid, refine_solid, solid_depth, solid_limit_points

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
    "RefinedSolid",
    "Scheme",
    "SubcertError",
    "audit",
    "exact",
    "limit_net",
    "limit_points",
    "mesh_depth",
    "net_depth",
    "papers",
    "refine_mesh",
    "refine_net",
    "refine_solid",
    "schemes",
    "solid_depth",
    "solid_limit_points",
]
