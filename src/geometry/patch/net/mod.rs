//! How far a tensor net is from its limit surface (`proofs/THEOREMS.md`, 98 and 99).
//!
//! A piece is a cell of the parameters, from i to i + 1 and from j to j + 1 at its level. The points
//! of a window determine the net and its limit there. A piece of arities n and m has n·m parts.

mod apriori;
mod cell;
mod constants;
mod direction;
mod distances;
mod formula;
mod model;
mod pieces;
mod points;
mod polynomial;
mod rules;
mod scaled;
mod search;
mod set_places;
mod sets;
mod spot;

pub use apriori::{NetAPriori, net_a_priori};
pub use distances::NetDistances;
pub use formula::{NET_FORMULA_PAPER, net_formula_level};
