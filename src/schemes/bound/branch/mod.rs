//! Norms of powers by branch and bound: few rows are visited, and the value is exact.
//!
//! A word of c digits, the coarsest first, leads from E^0 to a row of E^c; its prefixes are
//! the nodes of a tree. The rows m levels below a node are combinations of the rows of the
//! node. The coefficients of each combination sum to 1, have a first moment in a known
//! interval, and have absolute values that sum to at most ‖E^m‖. This bounds the norms of
//! all rows below the node. A node is not split if its bound is not above the best row
//! found.
//!
//! Source: `proofs/THEOREMS.md`, 60 to 64.
//!
//! | file | subject |
//! |---|---|
//! | `number`, `wide` | the integers that a search runs on |
//! | `scaled`, `tree` | the operator, and the rows of its powers |
//! | `estimate`, `reach`, `uniform`, `entries` | bounds of the rows below a node |
//! | `problem` | the input and the result of a search |
//! | `descent` | nodes, their parts and their bounds |
//! | `search` | the order in which nodes are split |
//! | `search_tree`, `cover` | a tree that proves the result |
//! | `dispatch` | the width of the integers |
//! | `growth` | ‖E^m‖ for every m |
//! | `power`, `joint` | one operator, and two operators with a common row index |

mod cover;
mod descent;
mod dispatch;
mod entries;
mod estimate;
mod growth;
mod joint;
mod number;
mod power;
mod problem;
mod reach;
mod scaled;
mod search;
mod search_tree;
mod searched;
mod tree;
mod uniform;
mod wide;

pub use joint::JointSearch;
pub use power::PowerSearch;
pub use search_tree::{Closed, Leaf, SearchTree, SearchedOperator};
pub use searched::Searched;
pub use uniform::UniformBound;
