//! Rules that depend on one parameter, and the rows of their powers.

use super::power::{Order, oriented};
use super::walk::walk_rows;
use crate::cap::Cap;
use crate::exact::{
    Integer, IntegerPolynomial, PiecewisePolynomial, Polynomial, Rational, RationalPolynomial,
};
use crate::scheme::Rules;
use std::collections::{BTreeMap, BTreeSet};

/// The cap on the work n^c·N·(cd)² for one norm as a function of a parameter, for masks
/// of degree d in the parameter.
pub const MAX_RANGE_WORK: u64 = 1 << 19;

/// Why the range of a parameter is not computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RangeError {
    /// A coefficient that is not a rational polynomial in the parameter.
    #[error(
        "the coefficient {coefficient} of rule {rule} is not a polynomial in `{parameter}` with \
         rational coefficients; only such masks have their ranges computed"
    )]
    NotPolynomial {
        /// The coefficient.
        coefficient: String,
        /// Its rule, counted from 0.
        rule: usize,
        /// The parameter.
        parameter: String,
    },
    /// The work is beyond [`MAX_RANGE_WORK`].
    #[error(
        "{arity}^{levels} residue classes with rules of {width} coefficients and degree {degree} \
         in the parameter are too many: their number, times {width}*{degree}^2, may be at most \
         {MAX_RANGE_WORK}; take a smaller number of levels"
    )]
    Work {
        /// n.
        arity: usize,
        /// c.
        levels: u32,
        /// N.
        width: usize,
        /// cd.
        degree: usize,
    },
}

impl RangeError {
    /// The cap that the work is beyond.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            RangeError::NotPolynomial { .. } => None,
            RangeError::Work { arity, levels, .. } => {
                let what = format!("the work for {arity}^{levels} row sums that are functions");
                Some(Cap::new(what, MAX_RANGE_WORK))
            }
        }
    }
}

/// The rules with their coefficients as polynomials in `parameter`.
///
/// # Errors
/// When a coefficient is not a rational polynomial in the parameter.
pub fn polynomial_rules(
    rules: &Rules<Polynomial>,
    parameter: &str,
) -> Result<Rules<RationalPolynomial>, RangeError> {
    for (rule, row) in rules.rows().iter().enumerate() {
        if let Some(coefficient) = row.iter().find(|entry| entry.in_variable(parameter).is_none()) {
            let (coefficient, parameter) = (coefficient.to_string(), parameter.to_owned());
            return Err(RangeError::NotPolynomial { coefficient, rule, parameter });
        }
    }
    let zero = || RationalPolynomial::constant(Rational::zero());
    Ok(rules.map(|entry| entry.in_variable(parameter).unwrap_or_else(zero)))
}

/// An error if the work for the c-th power is above the cap.
pub(super) fn check(rules: &Rules<RationalPolynomial>, levels: u32) -> Result<(), RangeError> {
    let (arity, width) = (rules.arity(), rules.width());
    let degrees = rules.rows().iter().flatten().filter_map(RationalPolynomial::degree);
    let degree = degrees.max().unwrap_or(0).max(1) * levels as usize;
    let work = (arity as u64)
        .checked_pow(levels)
        .and_then(|classes| classes.checked_mul(width as u64)?.checked_mul(degree as u64))
        .and_then(|work| work.checked_mul(degree as u64));
    match work.filter(|&work| work <= MAX_RANGE_WORK) {
        Some(_) => Ok(()),
        None => Err(RangeError::Work { arity, levels, width, degree }),
    }
}

/// The absolute sum of a row of Rᶜ, as the terms of Σ_j |p_j|/q. Polynomials that are
/// constant multiples of each other form one term.
pub(super) struct Row {
    pub(super) terms: Vec<IntegerPolynomial>,
    /// q.
    pub(super) denominator: Integer,
}

impl Row {
    /// The absolute sum as a function of the parameter; with a window, only on this
    /// interval.
    pub(super) fn function(&self, window: Option<&(Rational, Rational)>) -> PiecewisePolynomial {
        let over = |term: &IntegerPolynomial| RationalPolynomial::over(term, &self.denominator);
        let terms: Vec<RationalPolynomial> = self.terms.iter().map(over).collect();
        match window {
            None => PiecewisePolynomial::sum_of_magnitudes(&terms),
            Some((low, high)) => PiecewisePolynomial::sum_of_magnitudes_on(&terms, low, high),
        }
    }

    fn degree(&self) -> usize {
        self.terms.iter().filter_map(IntegerPolynomial::degree).sum()
    }
}

/// Primitive polynomials with their positive factors.
type Terms = BTreeMap<Vec<Integer>, Integer>;

/// The rows of the c-th powers of K operators of the same arity and width, in the order
/// of the sum of the degrees of their terms. Rows with the same terms, which symmetric
/// rules have, occur once.
pub(super) fn distinct_rows<const K: usize>(
    rules: [&Rules<RationalPolynomial>; K],
    levels: u32,
    order: Order,
) -> Result<Vec<[Row; K]>, RangeError> {
    for rules in rules {
        check(rules, levels)?;
    }
    let denominators = rules.map(denominator);
    let mut scales = denominators.iter().map(|q| RationalPolynomial::constant(q.clone().into()));
    let operators = rules.map(|rules| {
        let scale = scales.next().expect("one for each operator");
        let integers = |entry: &RationalPolynomial| entry.times(&scale).numerator().clone();
        let oriented = oriented(rules, order);
        oriented.rows().iter().map(|row| row.iter().map(integers).collect()).collect()
    });
    let mut distinct: BTreeSet<[Terms; K]> = BTreeSet::new();
    walk_rows(&operators, 0, levels, &mut |rows: &[Vec<IntegerPolynomial>; K], _| {
        distinct.insert(rows.each_ref().map(|row| terms(row)));
    });
    let row = |terms: Terms, denominator: &Integer| {
        let term = |(coefficients, factor): (Vec<Integer>, Integer)| {
            &IntegerPolynomial::new(coefficients) * &IntegerPolynomial::new(vec![factor])
        };
        let terms = terms.into_iter().map(term).collect();
        Row { terms, denominator: denominator.pow(levels) }
    };
    let mut rows: Vec<[Row; K]> = distinct
        .into_iter()
        .map(|rows| {
            let mut denominators = denominators.iter();
            rows.map(|terms| row(terms, denominators.next().expect("one for each operator")))
        })
        .collect();
    rows.sort_by_key(|rows| rows.iter().map(Row::degree).sum::<usize>());
    Ok(rows)
}

fn terms(row: &[IntegerPolynomial]) -> Terms {
    let mut terms = Terms::new();
    for entry in row.iter().filter(|entry| !entry.is_zero()) {
        let factor = terms.entry(entry.primitive().coefficients().to_vec());
        *factor.or_insert_with(Integer::zero) += &entry.content();
    }
    terms
}

/// The least common denominator of all coefficients.
fn denominator(rules: &Rules<RationalPolynomial>) -> Integer {
    rules.rows().iter().flatten().fold(Integer::one(), |lcm, entry| {
        entry.coefficients().iter().fold(lcm, |lcm, c| lcm.lcm(&c.denominator()))
    })
}
