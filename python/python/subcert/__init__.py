"""Exact constants of subdivision schemes, audits of papers, and reference values for tests.

>>> from fractions import Fraction
>>> import subcert
>>> six = subcert.Scheme("six-point", w=Fraction(3, 256))
>>> six.contraction(1)
Fraction(89, 128)
>>> subcert.scheme("six-point", w=Fraction(3, 256)).curve["continuity"]
2

This page has every name; ``help(subcert.Scheme)`` has curves, their constants, depths and smoothness, spectra and ranges,
``help(subcert.refine_mesh)`` meshes, ``help(subcert.audit)`` papers, and ``docs/python.md`` an overview.
"""

from . import _native
from ._analysis import (
    Across,
    ComplexEigenvalues,
    Eigenvalue,
    Exponent,
    JointRadius,
    Real,
    Sector,
    Smoothness,
    Spectrum,
    VertexSmoothness,
    jsr,
)
from ._audit import Audit, Finding, audit, papers
from ._errors import SubcertError
from ._facts import Facts, Plot, plot, scheme
from ._geometry import LimitPoint, MeshDepth, SurfaceDepth
from ._lattice import Lattice, LatticeSmoothness
from ._mesh import RefinedMesh, limit_points, mesh_depth, mesh_geometric_depth, refine_mesh
from ._net import limit_net, net_depth, net_geometric_depth, refine_net
from ._numbers import Algebraic, exact
from ._scheme import (
    Constants,
    Depth,
    GeometricDepth,
    Interval,
    Intervals,
    LimitStencil,
    Quantities,
    Quantity,
    Refined,
    Scheme,
    SmoothRange,
    schemes,
)
from ._solid import (
    RefinedSolid,
    refine_solid,
    solid_depth,
    solid_geometric_depth,
    solid_limit_points,
)
from ._tags import Tags

#: The version of the program.
__version__: str = _native.version()

__all__ = [
    "Across",
    "Algebraic",
    "Audit",
    "ComplexEigenvalues",
    "Constants",
    "Depth",
    "Eigenvalue",
    "Exponent",
    "Facts",
    "Finding",
    "GeometricDepth",
    "Interval",
    "Intervals",
    "JointRadius",
    "Lattice",
    "LatticeSmoothness",
    "LimitPoint",
    "LimitStencil",
    "MeshDepth",
    "Plot",
    "Quantities",
    "Quantity",
    "Real",
    "Refined",
    "RefinedMesh",
    "RefinedSolid",
    "Scheme",
    "Sector",
    "SmoothRange",
    "Smoothness",
    "Spectrum",
    "SubcertError",
    "SurfaceDepth",
    "Tags",
    "VertexSmoothness",
    "audit",
    "exact",
    "jsr",
    "limit_net",
    "limit_points",
    "mesh_depth",
    "mesh_geometric_depth",
    "net_depth",
    "net_geometric_depth",
    "papers",
    "plot",
    "refine_mesh",
    "refine_net",
    "refine_solid",
    "scheme",
    "schemes",
    "solid_depth",
    "solid_geometric_depth",
    "solid_limit_points",
]
