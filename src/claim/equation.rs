//! Equations between formulas.

use super::table::{Axis, LocatedReference};
use crate::formula::LocatedFormula;

/// An equation, or a list of equations with indices.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `(3.20)`.
    pub locus: String,
    /// What it says.
    pub title: String,
    /// What is claimed.
    pub body: EquationBody,
    /// What a reader should know.
    pub note: Option<String>,
}

/// What an equation claims.
#[derive(Clone, Debug)]
pub enum EquationBody {
    /// left = right, for every value of the indices and as polynomials in the
    /// symbols.
    Identity(Box<Identity>),
    /// Something it needs is absent from the paper: what.
    NotCheckable(String),
}

/// Two sides that are claimed to be equal.
#[derive(Clone, Debug)]
pub struct Identity {
    /// The scheme its functions are about.
    pub scheme: Option<LocatedReference>,
    /// The names that stay symbolic.
    pub symbols: Vec<String>,
    /// The indices, the first one slowest.
    pub indices: Vec<Axis>,
    /// The left side: one formula for each combination of indices, in order.
    pub left: Vec<LocatedFormula>,
    /// The right side, one formula in the indices.
    pub right: LocatedFormula,
}
