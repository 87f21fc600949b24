//! Exact values of the basic limit function and of its derivatives.

use crate::exact::{Rational, null_rows};
use crate::smoothness::coefficient::Coefficient;
use crate::smoothness::contraction::derived;
use crate::smoothness::exponent::Smoothness;
use crate::smoothness::symbol::Symbol;

/// The most values of one function.
const MAX_VALUES: usize = 20_000;

/// The most values of one function over a field of irrational numbers.
const MAX_FIELD_VALUES: usize = 1_000;

/// The most whole numbers in a support: the values there are the solution of as many equations, exactly.
const MAX_INTEGERS: usize = 40;

/// Why a function has no values here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BasicError {
    /// The scheme diverges.
    #[error("the scheme diverges: it has no continuous limit")]
    Diverges,
    /// It is open whether the scheme converges.
    #[error("it is open whether the scheme converges")]
    Open,
    /// The derivative does not exist, or is not continuous.
    #[error("not all limits are C^{0}")]
    Fails(usize),
    /// It is open whether the derivative is continuous.
    #[error("it is open whether the limits are C^{0}")]
    OpenOrder(usize),
    /// Shifts of the basic limit function are linearly dependent, and the derived scheme is not shown to converge.
    #[error("the limits are C^{0}, but the derived scheme of this order is not shown to converge")]
    Derived(usize),
    /// Too many values.
    #[error("there are more than {0} values")]
    TooMany(usize),
    /// The support is too wide.
    #[error("the support has more than {0} whole numbers: take a scheme with fewer coefficients")]
    Wide(usize),
}

/// The values φ^{(m)}(j/n^k) of a derivative of the basic limit function φ, j = first, first + 1, …; all others are 0.
///
/// φ(t) = Σ_s a_s φ(nt − s), and the limit of x is P^∞(t) = Σ_i x_i φ(t − i). With A = σ^m B, the scheme of D = n^m B
/// refines the divided differences of order m. If it converges, φ^{(m)}(t) = Σ_i (−1)^i C(m, i) φ_D(t − i).
///
/// The φ_D(i) are the solution of v_i = Σ_s d_s v_{ni − s}, Σ v_i = 1, which is unique as the scheme of D converges; finer
/// values follow from the equation of φ_D.
///
/// Source: Dyn and Levin 2002, Acta Numerica 11, 73-144, section 4, for derived schemes; Daubechies and Lagarias 1991 for
/// the values at integers.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{BasicValues, Smoothness};
///
/// let scheme = parse_scheme("b-spline:degree=3")?;
/// let smoothness = Smoothness::of(scheme.masks()[0])?;
/// let spline = BasicValues::of(&smoothness, 0, 0)?;
/// assert_eq!(spline.at(0), Rational::new(2, 3));
/// let slope = BasicValues::of(&smoothness, 1, 1)?;
/// assert_eq!(slope.at(1), Rational::new(-5, 8));
/// assert!(BasicValues::of(&smoothness, 3, 0).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BasicValues<F = Rational> {
    /// m.
    pub order: usize,
    /// n.
    pub arity: usize,
    /// k.
    pub level: u32,
    /// The first j.
    pub first: i64,
    /// The values, from one end of the support to the other.
    pub values: Vec<F>,
}

impl<F: Coefficient> BasicValues<F> {
    /// The values of φ^{(m)} at all multiples of 1/n^k in the support of φ.
    ///
    /// # Errors
    /// Where the smoothness of the limits does not show that φ^{(m)} exists and is continuous, or beyond a cap: 20 000 values, 1 000 over
    /// irrational numbers, and 40 whole numbers in the support.
    ///
    /// # Panics
    /// Never: differences of an order below that of the sum rules exist.
    pub fn of(
        smoothness: &Smoothness<F>,
        m: usize,
        level: u32,
    ) -> Result<BasicValues<F>, BasicError> {
        let (least, fails) = (smoothness.continuity, smoothness.continuity_fails);
        match (least, fails) {
            (_, Some(0)) => return Err(BasicError::Diverges),
            (None, _) => return Err(BasicError::Open),
            (Some(least), Some(fails)) if m > least && m >= fails => {
                return Err(BasicError::Fails(m));
            }
            (Some(least), _) if m > least => return Err(BasicError::OpenOrder(m)),
            _ => {}
        }
        let symbol = &smoothness.symbol;
        let (low, high) = ends(symbol, 1);
        if usize::try_from(high - low).is_ok_and(|count| count >= MAX_INTEGERS) {
            return Err(BasicError::Wide(MAX_INTEGERS));
        }
        // Without dependent shifts, C^m is shown by the derived scheme itself.
        let own = smoothness.reduced.is_none()
            || m == 0
            || smoothness.differences.is_below(m) == Some(true)
            || derived(symbol, m).is_some();
        if !own {
            return Err(BasicError::Derived(m));
        }
        let n = Rational::from(symbol.arity());
        let factor = (0..m).fold(Rational::one(), |power, _| power * &n);
        let refined = symbol.difference(m, &factor).expect("sum rules of a higher order");
        let rational = symbol.coefficients().iter().all(|c| c.generator().is_none());
        let most = if rational { MAX_VALUES } else { MAX_FIELD_VALUES };
        let steps = i64::try_from(symbol.arity())
            .ok()
            .and_then(|n| n.checked_pow(level))
            .ok_or(BasicError::TooMany(most))?;
        let (low, high) = ends(symbol, steps);
        if usize::try_from(high - low).is_ok_and(|count| count >= most) {
            return Err(BasicError::TooMany(most));
        }
        let mut found = at_integers(&refined).ok_or(BasicError::Derived(m))?;
        let mut scale = 1;
        for _ in 0..level {
            found = finer(&refined, &found, scale);
            scale *= i64::try_from(symbol.arity()).unwrap_or(i64::MAX);
        }
        for _ in 0..m {
            found = found.less_moved(scale);
        }
        let values = (low..=high).map(|j| found.at(j)).collect();
        Ok(BasicValues { order: m, arity: symbol.arity(), level, first: low, values })
    }

    /// How many multiples of 1/n^k the support of φ has; `None` beyond 64 bits. Nothing is solved.
    #[must_use]
    pub fn count(smoothness: &Smoothness<F>, level: u32) -> Option<usize> {
        let steps = i64::try_from(smoothness.symbol.arity()).ok()?.checked_pow(level)?;
        let (low, high) = ends(&smoothness.symbol, steps);
        usize::try_from(high - low + 1).ok()
    }

    /// φ^{(m)}(j/n^k).
    #[must_use]
    pub fn at(&self, j: i64) -> F {
        let place = j.checked_sub(self.first).and_then(|place| usize::try_from(place).ok());
        place.and_then(|place| self.values.get(place)).cloned().unwrap_or_else(F::zero)
    }
}

/// A piece of a sequence; beyond it all values are 0.
struct Piece<F> {
    first: i64,
    values: Vec<F>,
}

impl<F: Coefficient> Piece<F> {
    fn at(&self, j: i64) -> F {
        let place = usize::try_from(j - self.first).ok();
        place.and_then(|place| self.values.get(place)).cloned().unwrap_or_else(F::zero)
    }

    fn last(&self) -> i64 {
        self.first + length(&self.values) - 1
    }

    /// v_j − v_{j − by}.
    fn less_moved(&self, by: i64) -> Piece<F> {
        let value = |j| self.at(j).minus(&self.at(j - by));
        Piece { first: self.first, values: (self.first..=self.last() + by).map(value).collect() }
    }
}

fn length<T>(values: &[T]) -> i64 {
    i64::try_from(values.len()).expect("it fits in memory")
}

/// The first and the last j with j/steps in the support.
fn ends<F: Coefficient>(symbol: &Symbol<F>, steps: i64) -> (i64, i64) {
    let (low, high) = symbol.powers();
    let below = i64::try_from(symbol.arity() - 1).expect("a small arity");
    (-(-low * steps).div_euclid(below), (high * steps).div_euclid(below))
}

/// The values at the integers; `None` where they are not determined.
fn at_integers<F: Coefficient>(symbol: &Symbol<F>) -> Option<Piece<F>> {
    let (first, last) = ends(symbol, 1);
    let n = i64::try_from(symbol.arity()).ok()?;
    let d = Piece { first: symbol.powers().0, values: symbol.coefficients().to_vec() };
    let one = F::from_rational(&Rational::one());
    // Column i holds the equation of v_i.
    let row = |j: i64| -> Vec<F> {
        let entry = |i: i64| {
            let entry = d.at(n * i - j);
            if i == j { entry.minus(&one) } else { entry }
        };
        (first..=last).map(entry).collect()
    };
    let matrix: Vec<Vec<F>> = (first..=last).map(row).collect();
    let mut solutions = null_rows(&matrix);
    let (Some(values), true) = (solutions.pop(), solutions.is_empty()) else { return None };
    let sum = F::total(&values);
    let values = values.iter().map(|value| value.over(&sum)).collect();
    (sum != F::zero()).then_some(Piece { first, values })
}

/// The values at multiples of 1/(n·steps) from those at multiples of 1/steps.
fn finer<F: Coefficient>(symbol: &Symbol<F>, found: &Piece<F>, steps: i64) -> Piece<F> {
    let n = i64::try_from(symbol.arity()).expect("a small arity");
    let (first, last) = ends(symbol, n * steps);
    let lowest = symbol.powers().0;
    let zero = F::zero();
    let value = |j: i64| {
        let terms = (lowest..).zip(symbol.coefficients());
        terms.fold(F::zero(), |mut sum, (s, d)| {
            let value = found.at(j - s * steps);
            if value != zero {
                sum.accumulate(&d.times(&value));
            }
            sum
        })
    };
    Piece { first, values: (first..=last).map(value).collect() }
}
