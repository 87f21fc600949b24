//! Readings: the ways in which a table may have been computed, other than by the printed
//! definition.
//!
//! A reading is a point of a declared family: the product of the
//! [choices](crate::evaluation::FAMILY) that a table's formula depends on, and of the alternatives
//! that the claim file gives for definitions, with at most
//! [`MAX_DIFFERENCES`](crate::finding::MAX_DIFFERENCES) of them other than printed. Where these
//! leave cells unexplained, the family has a second part: readings that also take one quantity from
//! another place of the paper ([`Copied`](crate::evaluation::Copied)). A reading explains a cell
//! when the cell's exact value under the reading rounds to the printed number. It is reported when
//! it explains more cells than the printed definition, and so many that luck is unlikely.

pub(crate) mod chance;
mod consistent;
mod copied;
mod degree;
pub(crate) mod dependence;
mod explain;
mod form;
mod line;
mod needs;
mod parameter;
pub(crate) mod plain;
pub(crate) mod recover;
mod scale;
pub(crate) mod search;
mod solve;
pub(crate) mod space;
mod spread;
pub(crate) mod tried;
