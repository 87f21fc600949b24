//! Equations and other relations between formulas.

use super::table::LocatedReference;
use crate::exact::{IntervalSet, Rational};
use crate::formula::{LocatedFormula, Node};
use std::cmp::Ordering;

/// An equation or another relation, or a list of them with indices.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Whether it is given as a relation, with one text for both sides and the sign between them.
    pub is_relation: bool,
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
    /// `equation` or `relation`.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        if self.is_relation { "relation" } else { "equation" }
    }

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
    /// Comparisons that hold for every value of the indices, and as polynomials in the
    /// symbols.
    Identity(Box<Identity>),
    /// The equation needs something that is absent from the paper; the text says what.
    NotCheckable(String),
}

/// What an equation or another relation claims.
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
    /// What is compared: of an equation one pair of sides, of `a < b <= c` two.
    pub comparisons: Vec<Comparison>,
    /// The text of a relation.
    pub states: Option<Vec<String>>,
    /// Whether it is claimed to be false for all other real numbers than the values of its only index.
    pub only: bool,
}

impl Identity {
    /// The comparison of an equation, or the first one.
    ///
    /// # Panics
    /// Never: a claim compares something.
    #[must_use]
    pub fn first(&self) -> &Comparison {
        self.comparisons.first().expect("a claim compares something")
    }

    /// The index that has real values, if there is one, and its place among the indices.
    #[must_use]
    pub fn real_index(&self) -> Option<(usize, &str, &IntervalSet)> {
        self.indices.iter().enumerate().find_map(|(place, index)| match index {
            Index::Real { name, values, .. } => Some((place, name.as_str(), values)),
            _ => None,
        })
    }

    /// Whether an index runs over all integers from some one on.
    #[must_use]
    pub fn is_for_all(&self) -> bool {
        self.indices.iter().any(|index| matches!(index, Index::All { .. }))
    }
}

/// Two sides and how they are claimed to be related.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The left side.
    pub left: Left,
    /// The relation.
    pub sign: Sign,
    /// The right side, one formula in the indices; several where the left side is claimed to be one of them.
    pub rights: Vec<LocatedFormula>,
}

impl Comparison {
    /// left = right.
    #[must_use]
    pub fn equal(left: Left, right: LocatedFormula) -> Comparison {
        Comparison { left, sign: Sign::Equal, rights: vec![right] }
    }

    /// The right side, or the first one.
    ///
    /// # Panics
    /// Never: there is one.
    #[must_use]
    pub fn right(&self) -> &LocatedFormula {
        self.rights.first().expect("a comparison has a right side")
    }

    /// All formulas of both sides.
    pub fn formulas(&self) -> impl Iterator<Item = &LocatedFormula> {
        self.left.formulas().iter().chain(&self.rights)
    }
}

/// A relation between two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// They are equal.
    Equal,
    /// They are not.
    Unequal,
    /// The left side is less than the right one.
    Less,
    /// It is not greater.
    AtMost,
    /// It is greater.
    Greater,
    /// It is not less.
    AtLeast,
    /// One side is a printed number, and the other side rounded or cut to its digits.
    Near,
    /// The left side is one of those on the right.
    OneOf,
    /// A formula stands alone; it is 1, and the right side is 1.
    True,
    /// A formula stands behind `not`; it is 0, and the right side is 0.
    False,
}

impl Sign {
    /// Whether this is one of <, ≤, > and ≥.
    #[must_use]
    pub fn is_order(self) -> bool {
        matches!(self, Sign::Less | Sign::AtMost | Sign::Greater | Sign::AtLeast)
    }

    /// Whether this is true of two numbers in this order. Of `in`, the second one is the only member.
    #[must_use]
    pub fn fits(self, order: Ordering) -> bool {
        match self {
            Sign::Equal | Sign::True | Sign::False | Sign::Near | Sign::OneOf => order.is_eq(),
            Sign::Unequal => order.is_ne(),
            Sign::Less => order.is_lt(),
            Sign::AtMost => order.is_le(),
            Sign::Greater => order.is_gt(),
            Sign::AtLeast => order.is_ge(),
        }
    }

    /// The sign in print.
    #[must_use]
    pub fn mark(self) -> &'static str {
        match self {
            Sign::Equal | Sign::True | Sign::False => "=",
            Sign::Unequal => "≠",
            Sign::Less => "<",
            Sign::AtMost => "≤",
            Sign::Greater => ">",
            Sign::AtLeast => "≥",
            Sign::Near => "≈",
            Sign::OneOf => "∈",
        }
    }
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
    /// All of its formulas.
    #[must_use]
    pub fn formulas(&self) -> &[LocatedFormula] {
        match self {
            Left::One(formula) => std::slice::from_ref(formula),
            Left::Each(formulas) => formulas,
        }
    }

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
    /// Several indices with rows of values: `(n, v) = (3, 0.41), (4, 0.5)`.
    Together {
        /// Their names in formulas.
        names: Vec<String>,
        /// The rows, each with a value for each name and with what is printed.
        rows: Vec<Vec<(Rational, String)>>,
    },
    /// Real numbers: all, or those that inequalities with the name describe.
    Real {
        /// Its name in formulas.
        name: String,
        /// Its values.
        values: IntervalSet,
        /// The text of the index.
        text: String,
    },
    /// All integers from one on.
    All {
        /// Its name in formulas.
        name: String,
        /// The first value.
        from: i64,
    },
}

impl Index {
    /// Its name in formulas, or the names of several.
    #[must_use]
    pub fn names(&self) -> &[String] {
        match self {
            Index::Listed { name, .. }
            | Index::Range { name, .. }
            | Index::Real { name, .. }
            | Index::All { name, .. } => std::slice::from_ref(name),
            Index::Together { names, .. } => names,
        }
    }
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
