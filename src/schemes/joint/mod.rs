//! The joint spectral radius of matrices M_1, …, M_n: the limit of max ‖M_{w_1}⋯M_{w_l}‖^{1/l}
//! over all words w of length l → ∞.
//!
//! From below: ϱ ≥ |λ|^{1/l} for an eigenvalue λ of one product of l factors. From above: if the
//! absolutely convex hull of rows that span the space contains each of their images by each M_i, divided
//! by u, then ϱ ≤ u. The rows are found in f64 and verified exactly. The entries are rational, or of one real
//! field Q(α). `proofs/THEOREMS.md`, 103 to 105.
//!
//! ```
//! use subcert::exact::{Rational, format::short};
//! use subcert::joint::{MatrixSet, joint_radius};
//!
//! let matrix = |rows: [[i64; 2]; 2]| rows.map(|row| row.map(Rational::from).to_vec()).to_vec();
//! let pair = MatrixSet::new(vec![matrix([[-1, -1], [-4, 0]]), matrix([[3, 3], [-2, 1]])])?;
//! let radius = joint_radius(&pair);
//! assert_eq!((radius.product.len(), radius.exact), (2, true));
//! assert_eq!(short(&radius.root, 8), "15.345903");
//! # Ok::<(), subcert::joint::MatrixSetError>(())
//! ```

mod balance;
mod convert;
mod entry;
mod extremal;
mod goal;
mod hull;
mod interval;
mod invariant;
mod lower;
mod matrix_set;
mod product;
mod proposal;
mod radius;
mod reduction;
mod roots;
mod single;
mod verify;

pub use entry::Entry;
pub use goal::joint_radius_below;
pub use hull::Hull;
pub use interval::{
    BalancedHull, Closing, contracts, expanding_product, expands, hull_when_balanced,
};
pub use lower::MAX_ROWS;
pub use matrix_set::{MAX_MATRICES, MAX_SIZE, MatrixSet, MatrixSetError};
pub use product::{Eigenvalue, JordanBlock, LeadingEigenvalue, jordan_block};
pub use radius::{
    JointRadius, MAX_FACTORS, extremal_rate, joint_radius, joint_radius_until, radius_of_blocks,
};
pub use reduction::Reduction;
pub(crate) use roots::enclosed_root;
