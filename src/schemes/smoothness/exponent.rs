//! Continuity and the Hölder exponent.

use super::coefficient::Coefficient;
use super::contraction::derived;
use super::formula::{ExponentFormula, log_of};
use super::independence::independent;
use super::reproduction::reproduction_degree;
use super::symbol::Symbol;
use super::transition::transition_matrices;
use crate::exact::{Enclosed as _, Rational, RealAlgebraic};
use crate::joint::{
    Hull, JointRadius, MatrixSet, MatrixSetError, extremal_rate, joint_radius_until, jordan_block,
};
use crate::limit::{NaturalShift, natural_shift};
use crate::scheme::Mask;
use crate::stop::Stop;
use std::cmp::Ordering;

/// The longest product in which a Jordan block is looked for.
const JORDAN_FACTORS: usize = 2;

/// The most rows of matrices over a field, times its degree.
const MAX_FIELD_WORK: usize = 96;

/// Why the smoothness of a scheme is not computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SmoothnessError {
    /// The matrices of the differences are too large.
    #[error("the rules are too long for a proof of smoothness: {0}")]
    TooLong(#[from] MatrixSetError),
    /// The field of the coefficients is of too large a degree for matrices of this size.
    #[error(
        "matrices of {size} rows over a field of degree {degree}: the product of both can be at most \
         {MAX_FIELD_WORK}; take coefficients of a smaller field"
    )]
    Field {
        /// The number of rows.
        size: usize,
        /// The degree over the rationals.
        degree: usize,
    },
}

/// What is proven of the limits of a scheme.
#[derive(Clone, Debug)]
pub struct Smoothness<F = Rational> {
    /// The symbol.
    pub symbol: Symbol<F>,
    /// The order K of the sum rules. Polynomials up to degree K − 1 are generated.
    pub sum_rules: usize,
    /// The degree up to which polynomials are reproduced at the natural shift.
    pub reproduction: usize,
    /// The natural shift.
    pub shift: NaturalShift<F>,
    /// The radius that decides on convergence.
    pub differences: Differences<F>,
    /// The radius that decides on the smoothness of the limits, where that is another: the shifts of the
    /// basic limit function are linearly dependent.
    pub reduced: Option<Differences<F>>,
    /// The largest m for which the limits are proven to be C^m; `None` where convergence is not proven.
    pub continuity: Option<usize>,
    /// The least m for which it is proven that not all limits are C^m; 0 where the scheme diverges.
    pub continuity_fails: Option<usize>,
    /// The Hölder exponent; `None` where convergence is not proven.
    pub hoelder: Option<Hoelder>,
}

/// The scheme n^K·B of the differences of the order K of the sum rules, A = σ^K B.
#[derive(Clone, Debug)]
pub struct Differences<F = Rational> {
    /// A.
    pub symbol: Symbol<F>,
    /// K.
    pub order: usize,
    /// The matrices of n^K·B.
    pub matrices: MatrixSet<F>,
    /// Their joint spectral radius ϱ.
    pub radius: JointRadius,
}

/// The critical Hölder exponent K − log_n ϱ: the supremum of the m + α, 0 < α ≤ 1, such that all limits
/// have derivatives of order m with the Hölder exponent α.
#[derive(Clone, Debug)]
pub struct Hoelder {
    /// A number that is not above it.
    pub lower: Rational,
    /// A number that is not below it.
    pub upper: Rational,
    /// The exponent itself.
    pub formula: Option<ExponentFormula>,
    /// Whether the supremum is attained; `None` where that is open.
    pub attained: Option<bool>,
}

impl<F: Coefficient> Differences<F> {
    fn of(symbol: &Symbol<F>, stop: &Stop) -> Result<Differences<F>, SmoothnessError> {
        let (order, _) = symbol.sum_rules();
        let matrices = scaled_matrices(symbol, order)?;
        let generator = symbol.coefficients().iter().find_map(Coefficient::generator);
        let degree = generator.and_then(|(_, minimal)| minimal.degree()).unwrap_or(1);
        let size = matrices.size();
        if degree > 1 && size * degree > MAX_FIELD_WORK {
            return Err(SmoothnessError::Field { size, degree });
        }
        let radius = joint_radius_until(&matrices, stop);
        let mut found = Differences { symbol: symbol.clone(), order, matrices, radius };
        if let Some(set) = F::rational(&found.matrices) {
            let goals: Vec<Rational> = (0..order).rev().map(|m| found.limit(m)).collect();
            found.radius = found.radius.clone().toward(set, &goals, stop);
        }
        Ok(found)
    }

    /// Whether ϱ < n^{K − m}; `None` where the bounds do not tell.
    #[must_use]
    pub fn is_below(&self, m: usize) -> Option<bool> {
        self.radius.is_below(&self.limit(m))
    }

    /// n^{K − m}: the limits are C^m if ϱ is below it.
    ///
    /// # Panics
    /// Never: orders are small.
    #[must_use]
    pub fn limit(&self, m: usize) -> Rational {
        Rational::from(self.symbol.arity()).pow(difference(self.order, m))
    }
}

fn difference(a: usize, b: usize) -> i32 {
    let small = |x| i32::try_from(x).expect("a small order");
    small(a) - small(b)
}

/// The matrices of n^k·A/σ^k.
fn scaled_matrices<F: Coefficient>(
    symbol: &Symbol<F>,
    k: usize,
) -> Result<MatrixSet<F>, MatrixSetError> {
    let factor = Rational::from(symbol.arity()).pow(difference(k, 0));
    transition_matrices(&symbol.difference(k, &factor).expect("sum rules of this order"))
}

impl<F: Coefficient> Smoothness<F> {
    /// What can be proven of the limits of this mask.
    ///
    /// # Errors
    /// When the rules are too long.
    ///
    /// # Panics
    /// Never.
    pub fn of(mask: &Mask<F>) -> Result<Smoothness<F>, SmoothnessError> {
        Smoothness::until(mask, &Stop::default())
    }

    /// The same, with what is proven until the search is stopped.
    ///
    /// # Errors
    /// When the rules are too long.
    ///
    /// # Panics
    /// Never.
    pub fn until(mask: &Mask<F>, stop: &Stop) -> Result<Smoothness<F>, SmoothnessError> {
        let symbol = Symbol::of(mask);
        let differences = Differences::of(&symbol, stop)?;
        // Where the hull leaves a question open, a contraction may answer it.
        let contracts = |m: usize| stop.run(|| derived(&symbol, m)).ok().flatten().map(|_| true);
        let converges = differences.is_below(0).or_else(|| contracts(0));
        let reduced = match (converges, independent(&symbol)) {
            (Some(true), reduced) if reduced != symbol => Some(Differences::of(&reduced, stop)?),
            _ => None,
        };
        let deciding = reduced.as_ref().unwrap_or(&differences);
        let (mut continuity, mut continuity_fails) = (None, None);
        let mut hoelder = None;
        match converges {
            Some(true) => {
                // ϱ ≥ 1, so that the limits are C^m only for m < K.
                let proven = |m: usize| deciding.is_below(m).or_else(|| contracts(m));
                let below = |m: &usize| proven(*m) == Some(true);
                let fails = |m: &usize| deciding.is_below(*m) == Some(false);
                continuity = (1..=deciding.order).take_while(below).last().or(Some(0));
                continuity_fails = (1..=deciding.order).find(fails).or(Some(deciding.order));
                let mut exponent = Hoelder::of(deciding, stop)?;
                // C^m implies the exponent m.
                let least = Rational::from(continuity.unwrap_or(0));
                exponent.lower = exponent.lower.max(least);
                hoelder = Some(exponent);
            }
            Some(false) => continuity_fails = Some(0),
            None => {}
        }
        Ok(Smoothness {
            sum_rules: differences.order,
            reproduction: reproduction_degree(mask),
            shift: natural_shift(mask),
            symbol,
            differences,
            reduced,
            continuity,
            continuity_fails,
            hoelder,
        })
    }

    /// The radius that decides on the smoothness of the limits.
    #[must_use]
    pub fn deciding(&self) -> &Differences<F> {
        self.reduced.as_ref().unwrap_or(&self.differences)
    }
}

impl Hoelder {
    fn of<F: Coefficient>(
        differences: &Differences<F>,
        stop: &Stop,
    ) -> Result<Hoelder, SmoothnessError> {
        let Differences { symbol, order, radius, .. } = differences;
        let n = symbol.arity();
        // A search that is stopped may know no eigenvalue; ϱ ≥ 1 holds all the same.
        let one = RealAlgebraic::from(Rational::one());
        let known = radius.root.cmp_rational(&Rational::zero()) == Ordering::Greater;
        let root = if known { &radius.root } else { &one };
        let formula = ExponentFormula::new(*order, n, root, radius.degree);
        let upper = formula.enclosure(1).upper().clone();
        if radius.exact {
            let lower = formula.enclosure(1).lower().clone();
            let attained = stop.run(|| attained(differences, &formula)).unwrap_or(Ok(None))?;
            return Ok(Hoelder { lower, upper, formula: Some(formula), attained });
        }
        let bound = radius.hull.as_ref().map(|hull| hull.bound.clone());
        let lower = match bound {
            Some(bound) => Rational::from(*order) - log_of(&bound, n, 1).upper(),
            None => Rational::from(*order),
        };
        Ok(Hoelder { lower, upper, formula: None, attained: None })
    }
}

/// Whether the exponent s is attained: whether the powers of n^s S_k are bounded, k = ⌈s⌉, where S_k
/// refines the differences of order k. `proofs/THEOREMS.md`, 110.
fn attained<F: Coefficient>(
    differences: &Differences<F>,
    formula: &ExponentFormula,
) -> Result<Option<bool>, SmoothnessError> {
    let Differences { symbol, order, .. } = differences;
    let k = (1..=*order).find(|&k| formula.cmp_integer(k) != Ordering::Greater);
    let Some(k) = k else { return Ok(None) };
    // With an extremal hull all products of matrices of the order K are bounded; between k and K there
    // are only smaller factors n^{−k}, …, n^{−K+1}, unless s = k < K.
    if formula.cmp_integer(k) != Ordering::Equal || k == *order {
        return Ok(differences.radius.bounded.then_some(true));
    }
    let set = scaled_matrices(symbol, k)?;
    let one = Rational::one();
    if Hull::norm(&set).bound == one {
        return Ok(Some(true));
    }
    if jordan_block(&set, &one, JORDAN_FACTORS).is_some() {
        return Ok(Some(false));
    }
    let bounded = extremal_rate(&set).is_some_and(|(root, _)| root.as_rational() == Some(&one));
    Ok(bounded.then_some(true))
}
