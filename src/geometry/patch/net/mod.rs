//! How far a tensor net is from its limit surface (`proofs/THEOREMS.md`, 98 and 99).
//!
//! A piece is a cell of the parameters, from i to i + 1 and from j to j + 1 at its level. The points
//! of a window determine the net and its limit there. A piece of arities n and m has n·m parts.

mod apart;
mod apriori;
mod cell;
mod constants;
mod depth;
mod direction;
mod formula;
mod judge;
mod measure;
mod model;
mod pieces;
mod place;
mod points;
mod polynomial;
mod rules;
mod scaled;
mod search;
mod sets;

pub use apriori::{NetAPriori, net_a_priori};
pub use depth::NetDistances;
pub use formula::{NET_FORMULA_PAPER, net_formula_level};
