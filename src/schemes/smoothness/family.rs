//! What all symbols of a family have in common: products of powers whose exponents grow with an integer t.
//!
//! `proofs/THEOREMS.md`, 144.

use super::independence::cyclotomic;
use super::symbol::over_sigma;
use crate::exact::{Rational, RationalPolynomial};
use crate::scheme::{MAX_ARITY, SymbolPower, SymbolPowers};

/// The greatest order of a cumulant that is looked at.
const MAX_ORDER: usize = 64;

/// The greatest |α| and |β| of an exponent αt + β.
const MAX_EXPONENT: u32 = 1_000;

/// The symbols Π f(z)^{e(t)} for all integers t from `first` on: masks of one arity.
///
/// Values are polynomials in t; they are `None` where they are none, or are not shown to be right for all t.
///
/// ```
/// use std::collections::BTreeMap;
/// use subcert::diagnostic::SourceText;
/// use subcert::exact::Polynomial;
/// use subcert::scheme::read_scheme;
/// use subcert::smoothness::SymbolFamily;
///
/// let text = "name = 'spline'\nparameters.k = {}\nsymbol = '(1+z)^(k+1)/2^k'\n";
/// let scheme = read_scheme(&SourceText::new("spline.toml", text.to_owned()))?;
/// let k = BTreeMap::from([("k".to_owned(), Polynomial::variable("n"))]);
/// let family = SymbolFamily::of(&scheme.powers(&k, ("n", 1)).expect("powers"), 1).expect("masks");
/// assert_eq!(family.sum_rules().expect("linear").describe("n"), "1 + n");
/// assert_eq!(family.reproduction().expect("constant").describe("n"), "1");
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
#[derive(Clone, Debug)]
pub struct SymbolFamily {
    arity: usize,
    first: i64,
    factors: Vec<SymbolPower>,
}

/// The polynomials in z over those in t; the coefficients from the constant term upwards.
pub(super) type Coefficients = Vec<RationalPolynomial>;

impl SymbolFamily {
    /// The family of these powers; `None` where they are not shown to be masks of one arity.
    #[must_use]
    pub fn of(powers: &SymbolPowers, first: i64) -> Option<SymbolFamily> {
        let mut family = SymbolFamily { arity: 2, first, factors: powers.factors.clone() };
        // Π f(1)^α, and Π f(1)^β.
        let [mut ratio, mut value] = [Rational::one(), Rational::one()];
        for factor in &family.factors {
            let [first, last] = [factor.coefficients.first()?, factor.coefficients.last()?];
            let alone = factor.coefficients.len() == 1;
            let fits = if alone {
                first.as_constant().is_some()
            } else {
                family.is_at_most(&zero(), &factor.exponent)
            };
            if !fits || !family.is_never_zero(first) || !family.is_never_zero(last) {
                return None;
            }
            let one = sum(&factor.coefficients).as_constant().filter(|one| !one.is_zero())?;
            let [start, slope] = line(&factor.exponent)?;
            ratio *= one.pow(slope);
            value *= one.pow(start);
        }
        let arity = integer(&value).and_then(|n| usize::try_from(n).ok());
        family.arity = arity.filter(|n| (2..=MAX_ARITY).contains(n))?;
        let stated = powers.arity.as_ref().is_none_or(|stated| *stated == value);
        (stated && ratio == Rational::one()).then_some(())?;
        // Every rule has the sum 1.
        let one = RationalPolynomial::constant(Rational::one());
        family.is_at_most(&one, &family.sum_rules()?).then_some(family)
    }

    /// The arity n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// The least t.
    #[must_use]
    pub fn first(&self) -> i64 {
        self.first
    }

    /// The ends of the support of φ.
    #[must_use]
    pub fn support(&self) -> [RationalPolynomial; 2] {
        let over = RationalPolynomial::constant(Rational::from(self.arity - 1).recip());
        let end = |last: bool| {
            let power = |factor: &SymbolPower| {
                let more = if last { factor.coefficients.len() - 1 } else { 0 };
                let place = Rational::from(factor.lowest) + Rational::from(more);
                RationalPolynomial::constant(place)
            };
            self.total(self.factors.iter().map(power)).times(&over)
        };
        [end(false), end(true)]
    }

    /// The order of the sum rules.
    #[must_use]
    pub fn sum_rules(&self) -> Option<RationalPolynomial> {
        let divisors = (2..=self.arity).filter(|d| self.arity.is_multiple_of(*d));
        let orders = divisors.map(|d| {
            let monic = cyclotomic(d);
            let monic = monic.coefficients().iter().map(|c| Rational::from(c.clone()));
            let monic: Vec<Rational> = monic.collect();
            let of = |factor: &SymbolPower| self.multiplicity(&factor.coefficients, &monic);
            let found: Option<Vec<usize>> = self.factors.iter().map(of).collect();
            Some(self.total(found?.into_iter().map(constant)))
        });
        self.least(&orders.collect::<Option<Vec<RationalPolynomial>>>()?)
    }

    /// The degree of the polynomials that are reproduced at natural parameters.
    #[must_use]
    pub fn reproduction(&self) -> Option<RationalPolynomial> {
        let generation = self.sum_rules()?.minus(&constant(1));
        let mut known: Vec<Cumulants> = self.factors.iter().map(Cumulants::new).collect();
        for order in 1..=MAX_ORDER {
            let total = self.total(known.iter_mut().map(Cumulants::next));
            if order > 1 && !total.is_zero() {
                self.is_never_zero(&total).then_some(())?;
                return self.least(&[generation, constant(order - 1)]);
            }
        }
        None
    }

    /// Whether all symbols are shown to be symmetric: each factor is.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.factors
            .iter()
            .all(|factor| factor.coefficients.iter().eq(factor.coefficients.iter().rev()))
    }

    /// By how much the order of continuity grows with each t; `None` where not only factors σ(z) are added.
    #[must_use]
    pub fn added(&self) -> Option<i64> {
        let mut added = 0_i64;
        for factor in &self.factors {
            let all = factor.coefficients.iter().map(RationalPolynomial::as_constant);
            let mut rest = all.collect::<Option<Vec<Rational>>>()?;
            let [_, slope] = line(&factor.exponent)?;
            let mut order = 0_i64;
            while let Some(next) = over_sigma(&rest, self.arity) {
                (order, rest) = (order + 1, next);
            }
            if slope != 0 && rest.len() > 1 {
                return None;
            }
            added = added.checked_add(order.checked_mul(i64::from(slope))?)?;
        }
        Some(added)
    }

    /// Σ_f e_f(t)·(the value of f).
    fn total(&self, values: impl Iterator<Item = RationalPolynomial>) -> RationalPolynomial {
        let terms = self.factors.iter().zip(values);
        terms.fold(zero(), |sum, (factor, value)| sum.plus(&factor.exponent.times(&value)))
    }

    /// The one of these linear polynomials that is not greater than another at any t.
    fn least(&self, all: &[RationalPolynomial]) -> Option<RationalPolynomial> {
        all.iter().find(|one| all.iter().all(|other| self.is_at_most(one, other))).cloned()
    }

    /// Whether this is so at all t; both are linear.
    fn is_at_most(&self, less: &RationalPolynomial, more: &RationalPolynomial) -> bool {
        more.minus(less).is_nonnegative_line_from(self.first)
    }

    fn is_never_zero(&self, polynomial: &RationalPolynomial) -> bool {
        polynomial.is_never_zero_from(self.first)
    }

    /// How often a monic polynomial divides this one, at each t.
    fn multiplicity(
        &self,
        coefficients: &[RationalPolynomial],
        monic: &[Rational],
    ) -> Option<usize> {
        let (mut count, mut rest) = (0, coefficients.to_vec());
        loop {
            let (quotient, remainder) = divided(&rest, monic);
            if remainder.iter().any(|c| !c.is_zero()) {
                return remainder.iter().any(|c| self.is_never_zero(c)).then_some(count);
            }
            (count, rest) = (count + 1, quotient);
        }
    }
}

/// The moments and the cumulants of the weights of a factor, up to the order that was asked for.
struct Cumulants<'a> {
    factor: &'a SymbolPower,
    moments: Vec<RationalPolynomial>,
    known: Vec<RationalPolynomial>,
}

impl<'a> Cumulants<'a> {
    fn new(factor: &'a SymbolPower) -> Cumulants<'a> {
        Cumulants { factor, moments: vec![constant(1)], known: vec![zero()] }
    }

    /// κ_j of the next order j: m_j = Σ_{i=1}^{j} binomial(j−1, i−1) κ_i m_{j−i}.
    fn next(&mut self) -> RationalPolynomial {
        let order = self.known.len();
        let total = sum(&self.factor.coefficients).as_constant();
        let over = total.map_or_else(Rational::one, |total| total.recip());
        let mut moment = zero();
        for (k, c) in (self.factor.lowest..).zip(&self.factor.coefficients) {
            let power = (0..order).fold(over.clone(), |power, _| power * Rational::from(k));
            moment = moment.plus(&c.times(&RationalPolynomial::constant(power)));
        }
        self.moments.push(moment.clone());
        let mut binomial = Rational::one();
        for i in 1..order {
            let term = self.known[i].times(&self.moments[order - i]);
            moment = moment.minus(&term.times(&RationalPolynomial::constant(binomial.clone())));
            binomial = binomial * Rational::from(order - i) / Rational::from(i);
        }
        self.known.push(moment.clone());
        moment
    }
}

/// The quotient and the remainder on division by a monic polynomial.
pub(super) fn divided(
    dividend: &[RationalPolynomial],
    monic: &[Rational],
) -> (Coefficients, Coefficients) {
    let degree = monic.len() - 1;
    let mut rest = dividend.to_vec();
    let mut quotient = Vec::new();
    for top in (degree..rest.len()).rev() {
        let lead = rest[top].clone();
        for (i, c) in monic.iter().enumerate() {
            let term = lead.times(&RationalPolynomial::constant(c.clone()));
            let place = &mut rest[top - degree + i];
            *place = place.minus(&term);
        }
        quotient.insert(0, lead);
    }
    rest.truncate(degree);
    (quotient, rest)
}

/// α and β of αt + β as small integers, β first.
fn line(exponent: &RationalPolynomial) -> Option<[i32; 2]> {
    let all = exponent.coefficients();
    let small = |place: usize| {
        let value = all.get(place).map_or(Some(0), integer)?;
        i32::try_from(value).ok().filter(|value| value.unsigned_abs() <= MAX_EXPONENT)
    };
    Some([small(0)?, small(1)?])
}

fn integer(value: &Rational) -> Option<i64> {
    value.is_integer().then(|| value.numerator().to_i64()).flatten()
}

fn sum(all: &[RationalPolynomial]) -> RationalPolynomial {
    all.iter().fold(zero(), |sum, c| sum.plus(c))
}

fn zero() -> RationalPolynomial {
    constant(0)
}

fn constant(value: usize) -> RationalPolynomial {
    RationalPolynomial::constant(Rational::from(value))
}
