//! Nets: files, refinement, limit points.
//!
//! A net is a grid of points of space, open or closed in each of its two directions. A tensor
//! product refines it by one curve scheme from row to row, and by another one along the rows; so does a mask on Z². All
//! numbers are exact.
//!
//! | item | what it is |
//! |---|---|
//! | [`Net`] | the points, and which directions are closed |
//! | [`read_net`], [`NetFormat`], [`Closed`] | CSV and JSON files, with the place of every error |
//! | [`NetScheme`] | two masks, by name |
//! | [`NetRules`] | the same, or a mask on Z² |
//! | [`refine_net`] | the net of a later level |
//! | [`net_limits`], [`net_of_limits`] | where the points go |
//! | [`refine_lattice_net`], [`lattice_net_limits`] | the same with a mask on Z² |
//! | [`to_csv`] | a net as text; [`Net::mesh`] makes a polygon mesh of it |

mod error;
mod grid;
mod lattice;
mod limit;
mod read;
mod refine;
mod rules;
mod scheme;
mod write;

pub use error::NetError;
pub use grid::{Closed, Net};
pub use lattice::{lattice_net_limits, refine_lattice_net};
pub use limit::{net_limits, net_of_limits};
pub use read::{NetFormat, read_net};
pub use refine::{MAX_NET_LEVEL, refine_net};
pub use rules::NetRules;
pub use scheme::NetScheme;
pub use write::to_csv;
