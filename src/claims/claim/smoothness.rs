//! Claims about the smoothness of the limits of a scheme.

use super::domain::Domain;
use super::equation::Comparison;
use super::regularity::RegularityCell;
use super::table::LocatedReference;
use crate::exact::{Decimal, LogSum};
use crate::formula::LocatedFormula;
use std::collections::BTreeMap;

/// A claim about the limits of a scheme: of curves, or at a vertex or on a face.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothnessClaim {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `Theorem 3`.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// Its kind.
    pub kind: SmoothnessKind,
    /// What it says of which scheme.
    pub body: SmoothnessBody,
    /// Values that it states itself for parameters; they hide those of the paper.
    pub given: BTreeMap<String, LocatedFormula>,
    /// The cell of a printed table that it is.
    pub cell: Option<RegularityCell>,
    /// A note for the reader.
    pub note: Option<String>,
}

impl SmoothnessClaim {
    /// Whether it is a cell of the table of this id.
    #[must_use]
    pub fn is_cell_of(&self, table: &str) -> bool {
        self.cell.as_ref().is_some_and(|cell| cell.table.id == table)
    }

    /// What it needs and the paper lacks.
    #[must_use]
    pub fn absent(&self) -> Option<&str> {
        match &self.body {
            SmoothnessBody::NotCheckable(absent) => Some(absent),
            SmoothnessBody::Statement(..) => None,
        }
    }

    /// The region that it states, if it is about one.
    #[must_use]
    pub fn region(&self) -> Option<&SmoothRegionStatement> {
        match &self.body {
            SmoothnessBody::Statement(_, statement) => match &**statement {
                SmoothnessStatement::Region(region) => Some(region),
                _ => None,
            },
            SmoothnessBody::NotCheckable(_) => None,
        }
    }

    /// The range that it states, if it is about one.
    #[must_use]
    pub fn range(&self) -> Option<&SmoothRangeStatement> {
        match &self.body {
            SmoothnessBody::Statement(_, statement) => match &**statement {
                SmoothnessStatement::Range(range) => Some(range),
                _ => None,
            },
            SmoothnessBody::NotCheckable(_) => None,
        }
    }
}

/// What a claim about smoothness says, or why nothing can be checked.
#[derive(Clone, Debug, PartialEq)]
pub enum SmoothnessBody {
    /// A statement about the limits of a scheme, whose parameters may depend on the variable of a range.
    Statement(LocatedReference, Box<SmoothnessStatement>),
    /// The paper lacks something that the claim would need; the text says what.
    NotCheckable(String),
}

/// The kinds of claims about smoothness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SmoothnessKind {
    /// The limits are C^m, or not all of them are.
    Continuity,
    /// The Hölder exponent.
    Exponent,
    /// The values of a parameter for which the limits are C^m.
    Range,
}

impl SmoothnessKind {
    /// The name of its table in a claim file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            SmoothnessKind::Continuity => "smoothness",
            SmoothnessKind::Exponent => "exponent",
            SmoothnessKind::Range => "range",
        }
    }
}

/// A statement about the limits of a scheme.
#[derive(Clone, Debug, PartialEq)]
pub enum SmoothnessStatement {
    /// One of the two, or both.
    Continuity {
        /// All limits are C^m for this m.
        continuous: Option<usize>,
        /// Not all limits are C^m for this m; 0 says that the scheme diverges for some data.
        not_continuous: Option<usize>,
        /// Of rules around a vertex or on a face: the valences of which it speaks. The limits are surfaces of
        /// generic data at the vertex or on the face, in Reif's sense.
        valences: Option<PrintedValences>,
    },
    /// A statement about the Hölder exponent.
    Exponent {
        /// What it says of the exponent.
        exponent: ExponentStatement,
        /// Whether the exponent is attained, where the paper says so.
        attained: Option<bool>,
    },
    /// The values of a parameter for which the limits are C^m.
    Range(Box<SmoothRangeStatement>),
    /// The values of two parameters for which the limits are C^m.
    Region(Box<SmoothRegionStatement>),
}

/// The valences that a claim is about: `5`, `3..50`, or `all` from 3 on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintedValences {
    /// As the claim file has them.
    pub text: String,
    /// The first.
    pub first: usize,
    /// The last; `None` where they go on for ever.
    pub last: Option<usize>,
}

/// A statement about the Hölder exponent.
#[derive(Clone, Debug, PartialEq)]
pub enum ExponentStatement {
    /// It is this number.
    Value(PrintedExponent),
    /// It is this decimal, rounded.
    Decimal {
        /// The decimal as printed.
        text: String,
        /// Its value and its unit.
        decimal: Decimal,
    },
    /// It is not below the first number, and not above the second; one of them, or both.
    Bounds {
        /// The lower bound.
        at_least: Option<PrintedExponent>,
        /// The upper bound.
        at_most: Option<PrintedExponent>,
    },
}

/// A number such as `6 - log_2(9)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintedExponent {
    /// The formula as the claim file has it.
    pub text: String,
    /// Its value.
    pub value: LogSum,
}

/// All limits are C^m for the values of two parameters that satisfy inequalities.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothRegionStatement {
    /// The names of the parameters in formulas.
    pub variables: [String; 2],
    /// m.
    pub m: usize,
    /// The texts of the inequalities.
    pub texts: Vec<String>,
    /// The comparisons that they state.
    pub inequalities: Vec<Comparison>,
    /// Whether the paper says that the limits are C^m for no other values.
    pub only: bool,
}

/// All limits are C^m for the values of a parameter in an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothRangeStatement {
    /// The parameter's name in formulas.
    pub variable: String,
    /// m.
    pub m: usize,
    /// The interval.
    pub domain: Domain,
    /// Whether the paper says that the limits are C^m for no other values.
    pub only: bool,
    /// Of rules around a vertex or on a face: the valences of which it speaks.
    pub valences: Option<PrintedValences>,
}
