//! Equations between formulas.

use super::table::LocatedReference;
use crate::exact::Rational;
use crate::formula::{LocatedFormula, Node};

/// An equation, or a list of equations with indices.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `(3.20)`.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// The claimed identity, or why it cannot be checked.
    pub body: EquationBody,
    /// A note for the reader.
    pub note: Option<String>,
}

impl Equation {
    /// What it needs and the paper lacks.
    #[must_use]
    pub fn absent(&self) -> Option<&str> {
        match &self.body {
            EquationBody::NotCheckable(absent) => Some(absent),
            EquationBody::Identity(_) => None,
        }
    }
}

/// The claim of an equation.
#[derive(Clone, Debug, PartialEq)]
pub enum EquationBody {
    /// left = right, for every value of the indices and as polynomials in the
    /// symbols.
    Identity(Box<Identity>),
    /// The equation needs something that is absent from the paper; the text says what.
    NotCheckable(String),
}

/// Two sides that are claimed to be equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Identity {
    /// The scheme its functions are about.
    pub scheme: Option<LocatedReference>,
    /// The names that stay symbolic, alone or as families `q[i]`.
    pub symbols: Vec<String>,
    /// The hypotheses of the paper: members of families that formulas give.
    pub hypotheses: Vec<Hypothesis>,
    /// The indices, the first one slowest.
    pub indices: Vec<Index>,
    /// The left side.
    pub left: Left,
    /// The right side, one formula in the indices.
    pub right: LocatedFormula,
}

/// The left side of an identity.
#[derive(Clone, Debug, PartialEq)]
pub enum Left {
    /// One formula in the indices.
    One(LocatedFormula),
    /// One formula for each combination of indices, in order.
    Each(Vec<LocatedFormula>),
}

impl Left {
    /// The left side in one case, counted from 0 in the order of the combinations.
    ///
    /// # Panics
    /// When every case has a formula of its own, and there are at most `case` of them.
    #[must_use]
    pub fn formula(&self, case: usize) -> &LocatedFormula {
        match self {
            Left::One(formula) => formula,
            Left::Each(formulas) => &formulas[case],
        }
    }
}

/// An index of an identity.
#[derive(Clone, Debug, PartialEq)]
pub enum Index {
    /// Its values, listed.
    Listed {
        /// Its name in formulas.
        name: String,
        /// Its label in the paper.
        label: String,
        /// The values, each with what is printed.
        values: Vec<(Rational, String)>,
    },
    /// All integers from one value to another; both formulas may use the indices before this one.
    Range {
        /// Its name in formulas.
        name: String,
        /// Its label in the paper.
        label: String,
        /// The first value.
        from: Box<LocatedFormula>,
        /// The last value.
        to: Box<LocatedFormula>,
    },
}

/// `a[0, m] = 1 - sum(…)`: a member of a family that a formula gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Hypothesis {
    /// The member.
    pub member: LocatedFormula,
    /// Its value.
    pub value: LocatedFormula,
}

impl Hypothesis {
    /// The name of the family: `a`.
    #[must_use]
    pub fn family(&self) -> Option<&str> {
        match &self.member.expr.node {
            Node::Indexed { name, .. } => Some(name),
            _ => None,
        }
    }
}
