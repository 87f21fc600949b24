//! Norms of powers by branch and bound: few rows are visited, and the value is exact.
//!
//! A word of digits leads from E^0 to a row of E^c, the coarse digit first. What is known of
//! all rows below a node — their coefficients in those of the node sum to 1, have a known
//! first moment, and their absolute values sum to at most ‖E^m‖ — bounds their sums, and a
//! node whose bound is not above the best row found is not split.
//!
//! Source: `proofs/THEOREMS.md`, 60 to 64.
//!
//! | file | subject |
//! |---|---|
//! | `number`, `wide` | the integers that a search runs on |
//! | `scaled`, `tree` | the operator, and the rows of its powers |
//! | `estimate`, `reach`, `uniform` | bounds of the rows below a node |
//! | `problem` | what a search works on, and what it finds |
//! | `descent` | nodes, their parts and their bounds |
//! | `search` | the order in which nodes are split |
//! | `search_tree`, `cover` | a tree that shows what was found |
//! | `dispatch` | the width of the integers |
//! | `growth` | ‖E^m‖ for every m |
//! | `power`, `joint` | one operator, and two with one row |

mod cover;
mod descent;
mod dispatch;
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
