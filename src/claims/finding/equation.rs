//! The finding about an equation.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::Equation;
use crate::evaluation::Limits;
use crate::exact::{
    IntervalSet, Polynomial, Rational, RealAlgebraic, Rounding, Scalar as _, format::short,
};
use crate::formula::{RealValue, Value as _};
use crate::verdict::Word;
use std::fmt;
use std::sync::Arc;

/// The finding about an equation.
#[derive(Clone, Debug)]
pub struct EquationFinding<'a> {
    /// `key:equation`.
    pub id: String,
    /// The equation.
    pub equation: &'a Equation,
    /// The verdict.
    pub verdict: EquationVerdict,
    /// The limits that values rest on, each with the name of a scheme, if its parameters are rational.
    pub limits: Vec<(Option<String>, Arc<Limits>)>,
}

impl EquationFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let cap =
            if let EquationVerdict::BeyondCap(cap) = &self.verdict { Some(cap) } else { None };
        Judgement { word: Some(self.verdict.word()), cap, harm: Harm::Formula }
    }
}

/// The verdict of an equation.
#[derive(Clone, Debug, PartialEq)]
pub enum EquationVerdict {
    /// The claim is true in all cases.
    Holds {
        /// The number of combinations of the indices, times that of the comparisons.
        cases: usize,
    },
    /// The claim is true for all integers from one on.
    Proved,
    /// It is not decided for all integers from one on, and true in these cases.
    Tried {
        /// The number of combinations of the indices that were tried, times that of the comparisons.
        cases: usize,
    },
    /// They differ somewhere.
    Fails {
        /// The number of combinations of the indices, times that of the comparisons; 1 of a claim about all integers from one on.
        cases: usize,
        /// The cases in which the sides differ.
        failures: Vec<Failure>,
        /// Changes of one symbol after which the equation holds in all cases.
        mends: Vec<String>,
    },
    /// Bounds of values leave some cases open, and none is false.
    Undecided {
        /// The number of combinations of the indices, times that of the comparisons.
        cases: usize,
        /// The cases that are open.
        open: Vec<Failure>,
    },
    /// It is about real values of an index, or about all other real numbers, too.
    Reals(OnReals),
    /// The equation needs something that is absent, as the claim says.
    NotCheckable,
    /// A value is beyond a cap.
    BeyondCap(Cap),
}

impl EquationVerdict {
    /// The word for it.
    #[must_use]
    pub fn word(&self) -> Word {
        match self {
            EquationVerdict::Holds { .. } | EquationVerdict::Proved => Word::Holds,
            EquationVerdict::Tried { .. } | EquationVerdict::Undecided { .. } => Word::Open,
            EquationVerdict::Reals(found) if found.holds() => Word::Holds,
            EquationVerdict::Reals(_) | EquationVerdict::Fails { .. } => Word::Fails,
            EquationVerdict::NotCheckable | EquationVerdict::BeyondCap(_) => Word::NotCheckable,
        }
    }

    /// Whether it fails only since the decimals that are printed are rounded or cut.
    #[must_use]
    pub fn is_rounded(&self) -> bool {
        let EquationVerdict::Fails { failures, .. } = self else { return false };
        failures.iter().all(|failure| failure.rounding.is_some())
    }
}

/// For which real numbers a relation is true.
#[derive(Clone, Debug, PartialEq)]
pub struct OnReals {
    /// The name of the index.
    pub name: String,
    /// Its place among the indices.
    pub place: usize,
    /// What is known for each combination of the other indices.
    pub cases: Vec<RealCase>,
}

impl OnReals {
    /// Whether what the relation states is true.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.cases.iter().all(|case| case.counterexample.is_none())
    }
}

/// For which real numbers a relation is true, in one combination of the other indices.
#[derive(Clone, Debug, PartialEq)]
pub struct RealCase {
    /// The other indices in words; empty where there are none.
    pub at: String,
    /// The values of the other indices.
    pub indices: Vec<Rational>,
    /// Where it is true: of all real numbers if it is claimed for no others, and else of those for which it is claimed. `None` if this is not known
    /// everywhere, but one number shows that the claim is false.
    pub truth: Option<IntervalSet>,
    /// A number that shows that the claim is false.
    pub counterexample: Option<Counterexample>,
}

/// A number for which a relation is false, or true though it is said to be false there.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample {
    /// The number.
    pub value: RealAlgebraic,
    /// The comparison that is false there, from 0 on; `None` if all are true.
    pub fails: Option<usize>,
}

/// The value of a side.
#[derive(Clone, Debug, PartialEq)]
pub enum SideValue {
    /// A polynomial in the symbols, without any a number of a field Q(2cos(2π/n)).
    Polynomial(Polynomial),
    /// Another real number.
    Real(RealValue),
}

impl SideValue {
    /// The value as a real number, if it has no symbols in it.
    #[must_use]
    pub fn real(&self) -> Option<RealValue> {
        match self {
            SideValue::Polynomial(value) => {
                value.number().and_then(|number| RealValue::of_number(&number))
            }
            SideValue::Real(value) => Some(value.clone()),
        }
    }

    /// left − right; `None` between a polynomial in symbols and a real number.
    fn minus(&self, right: &SideValue) -> Option<SideValue> {
        if let (SideValue::Polynomial(left), SideValue::Polynomial(other)) = (self, right) {
            if left.meets(other).is_ok() {
                return Some(SideValue::Polynomial(left - other));
            }
            // No field within the caps has both numbers.
            let bounds = &self.real()?.interval() - &right.real()?.interval();
            return Some(SideValue::Real(RealValue::Enclosed(bounds)));
        }
        Some(SideValue::Real(self.real()?.minus(&right.real()?)))
    }
}

/// The significant digits of real numbers in print.
const DIGITS: u32 = 10;

/// The most terms of a number that are printed.
const MAX_COSINES: usize = 12;

impl fmt::Display for SideValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // √1001 is a sum of 360 cosines.
            SideValue::Polynomial(value) => match value.number() {
                Some(number) if number.term_count() > MAX_COSINES => {
                    f.write_str(&short(&number, DIGITS))
                }
                _ => value.fmt(f),
            },
            SideValue::Real(RealValue::Exact(value)) => f.write_str(&short(value, DIGITS)),
            SideValue::Real(RealValue::Enclosed(bounds)) => {
                let [low, high] = [bounds.lower(), bounds.upper()].map(|end| short(end, DIGITS));
                if low == high { f.write_str(&low) } else { write!(f, "{low} to {high}") }
            }
        }
    }
}

/// A case in which the two sides differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The indices in words; empty when there are none.
    pub at: String,
    /// The values of the indices.
    pub indices: Vec<Rational>,
    /// The left side.
    pub left: SideValue,
    /// The right side.
    pub right: SideValue,
    /// Where one side is one decimal and the other side a number: how the decimal came from it.
    pub rounding: Option<Rounding>,
}

impl Failure {
    /// left − right.
    #[must_use]
    pub fn difference(&self) -> SideValue {
        let difference = self.left.minus(&self.right);
        difference.unwrap_or_else(|| SideValue::Polynomial(Polynomial::default()))
    }
}
