//! Readings: what a table was computed by, when not by the printed definition.
//!
//! A reading is a point of a declared family: the product of the [choices](FAMILY)
//! that a table's formula depends on, and of the alternatives that the claim file
//! gives for definitions, with at most [`MAX_DIFFERENCES`] of them other than
//! printed. It explains a cell when its exact value becomes the printed number; it
//! is reported when it explains more cells than the printed definition, and so many
//! that luck is unlikely.

mod chance;
mod choice;
mod choices;
mod consistent;
mod explain;
mod line;
mod needs;
mod parameter;
mod scale;
mod search;
mod settings;
mod sibling;
mod solve;
mod space;
mod spread;
mod tried;

pub use choice::{Choice, Effect, Way};
pub use choices::FAMILY;
pub(super) use choices::{DEPTH_ROUNDING, HEADER};
pub use line::{Line, LineReading};
pub use needs::Need;
pub use scale::Solved;
pub use search::{CellKind, Difference, Explanation, MAX_DIFFERENCES, Search};
pub(super) use search::{readings, scale, search};
pub(super) use settings::{Restricted, Settings, choices_of};
pub(super) use sibling::{Sibling, siblings};
pub(super) use tried::remaining;
