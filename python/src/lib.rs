//! The native part of the Python module `subcert`.
//!
//! It takes and gives Python's integers, fractions and floats. The classes that people see are written in
//! Python, in `python/subcert`.

mod algebraic;
mod analysis;
mod audit;
mod check;
mod error;
mod facts;
mod geometry;
mod lattice;
mod mesh;
mod net;
mod number;
mod real;
mod run;
mod scheme;
mod solid;
mod tags;

use pyo3::prelude::*;

/// What the Python part builds on.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::algebraic::Algebraic;
    #[pymodule_export]
    use crate::analysis::{
        is_ring, jsr, open_names, sector, smooth_range, smoothness, spectrum, version,
        vertex_smoothness,
    };
    #[pymodule_export]
    use crate::audit::{audit_json, paper_keys};
    #[pymodule_export]
    use crate::check::{check_within_ulps, nearest};
    #[pymodule_export]
    use crate::facts::{facts_json, plot_svg};
    #[pymodule_export]
    use crate::lattice::{
        lattice_constants, lattice_depth, lattice_displacement, lattice_parts, lattice_smoothness,
        lattice_values,
    };
    #[pymodule_export]
    use crate::mesh::{mesh_depth, mesh_geometric_depth, mesh_limit, mesh_refine};
    #[pymodule_export]
    use crate::net::{net_depth, net_geometric_depth, net_limit, net_refine};
    #[pymodule_export]
    use crate::number::exact;
    #[pymodule_export]
    use crate::real::{compare_reals, real, real_as_algebraic};
    #[pymodule_export]
    use crate::scheme::{Native, parameter_range, scheme_names};
    #[pymodule_export]
    use crate::solid::{solid_depth, solid_geometric_depth, solid_limit, solid_refine};
}
