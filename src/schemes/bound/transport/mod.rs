//! The norm ‖w‖_*, and the flows and heights that prove its value.
//!
//! | file | subject |
//! |---|---|
//! | `network` | flows of least cost, by shortest paths |
//! | `forest` | flows of least cost, from rounded numbers and proved along a forest |
//! | `norm` | the norm, by `forest` if possible, otherwise by `network` |

mod forest;
mod network;
mod norm;

pub use network::Transport;
pub use norm::{transport, transport_at_costs};
