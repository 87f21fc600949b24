//! ‖w‖_*, and the flows and heights that prove it.
//!
//! | file | subject |
//! |---|---|
//! | `network` | flows of least cost, by shortest paths |
//! | `forest` | the same by rounded numbers first, proved along a forest |
//! | `norm` | the norm, by whichever of the two is quicker |

mod forest;
mod network;
mod norm;

pub use network::Transport;
pub use norm::{transport, transport_at_costs};
