//! Exponents in closed form.

use crate::exact::{Enclosed, Enclosure, Rational, RealAlgebraic, SturmSequence, format::short};
use crate::exact::{Integer, IntegerPolynomial, LogSum, LogTerm, natural_logarithm};
use std::cmp::Ordering;
use std::fmt;

/// whole − log_n(root)/degree.
#[derive(Clone, Debug)]
pub struct ExponentFormula {
    /// The rational part.
    pub whole: Rational,
    /// n, the arity of the scheme.
    pub arity: usize,
    /// A positive number from 1 to below n if it is rational; 1 where the exponent is rational.
    pub root: RealAlgebraic,
    /// The degree.
    pub degree: usize,
}

impl ExponentFormula {
    /// order − log_n(root)/degree, with powers of n taken out of a rational root.
    pub(crate) fn new(
        order: usize,
        arity: usize,
        root: &RealAlgebraic,
        degree: usize,
    ) -> ExponentFormula {
        let mut whole = Rational::from(order);
        let mut root = root.clone();
        if let Some(value) = root.as_rational() {
            let (n, step) =
                (Rational::from(arity), Rational::new(1, Rational::from(degree).numerator()));
            let mut value = value.clone();
            while value.is_integer() && (&value / &n).is_integer() {
                value /= &n;
                whole -= &step;
            }
            while !value.is_integer() && value.denominator().gcd(&n.numerator()) != 1.into() {
                value *= &n;
                whole += &step;
            }
            // A power of the root may be a power of n: log_4(2) = 1/2.
            if let Some(logarithm) = rational_logarithm(&value, arity) {
                whole -= &(&step * &logarithm);
                value = Rational::one();
            }
            root = RealAlgebraic::from(value);
        }
        ExponentFormula { whole, arity, root, degree }
    }

    /// The exponent, where it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        (self.root.as_rational() == Some(&Rational::one())).then_some(&self.whole)
    }

    /// How the exponent compares with k.
    ///
    /// # Panics
    /// Never: the order and the degree are small.
    #[must_use]
    pub fn cmp_integer(&self, k: usize) -> Ordering {
        // whole − k against log_n(root)/degree: n^{(whole − k)·degree} against root, where whole·degree is
        // an integer.
        if let Some(value) = self.as_rational() {
            return value.cmp(&Rational::from(k));
        }
        let exponent = (&self.whole - Rational::from(k)) * Rational::from(self.degree);
        let exponent = exponent.numerator().to_i64().and_then(|e| i32::try_from(e).ok());
        let power = Rational::from(self.arity).pow(exponent.expect("a small exponent"));
        self.root.cmp_rational(&power).reverse()
    }
}

/// The greatest common denominator of the exponents of powers that are compared.
const MAX_ROOT: i64 = 64;

/// The greatest exponent of these powers.
const MAX_POWER: i64 = 4_096;

impl ExponentFormula {
    /// Whether the exponent is this number; `None` where a logarithm is to a base that is no power of a
    /// root of n with a small exponent, or where the powers are beyond a cap.
    ///
    /// whole − log_n(ρ)/d = a + Σ c_i log_n(x_i) holds if and only if ρ^L is the rational number n^{Ld(whole − a)} Π
    /// x_i^{−Ldc_i}, with L ≥ 1 for which these exponents are integers.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn equals(&self, value: &LogSum) -> Option<bool> {
        let degree = Rational::from(self.degree);
        let first = (&self.whole - &value.rational) * &degree;
        let mut powers = vec![(Rational::from(self.arity), first)];
        for LogTerm { factor, base, of } in &value.terms {
            let base = rational_logarithm(&Rational::from(*base), self.arity)?;
            powers.push((of.clone(), -(factor * &degree / base)));
        }
        let small = |x: &Integer, cap: i64| x.within(cap).and_then(|x| i32::try_from(x).ok());
        let one = Integer::one();
        let denominator = powers.iter().fold(one, |lcm, (_, e)| lcm.lcm(&e.denominator()));
        let root = u32::try_from(small(&denominator, MAX_ROOT)?).ok()?;
        let scale = Rational::from(denominator);
        let mut power = Rational::one();
        for (of, exponent) in powers {
            let exponent = small(&(exponent * &scale).numerator(), MAX_POWER)?;
            power *= &of.pow(exponent);
        }
        // The positive root of q·x^L − p.
        let mut coefficients = vec![Integer::zero(); root as usize + 1];
        coefficients[0] = -power.numerator();
        coefficients[root as usize] = power.denominator();
        let roots = RealAlgebraic::roots_of(&IntegerPolynomial::new(coefficients));
        Some(roots.last() == Some(&self.root))
    }
}

impl Enclosed for ExponentFormula {
    fn enclosure(&self, level: u32) -> Enclosure {
        if let Some(value) = self.as_rational() {
            return Enclosure::exact(value.clone());
        }
        let log = log_of(&self.root, self.arity, level);
        let degree = Enclosure::exact(Rational::new(1, Rational::from(self.degree).numerator()));
        &Enclosure::exact(self.whole.clone()) - &(&log * &degree)
    }
}

/// log_n(x) = i/j for an integer x ≥ 1, if it is of this form with j ≤ 6, below which n = 64 has its roots.
fn rational_logarithm(x: &Rational, n: usize) -> Option<Rational> {
    let n = Rational::from(n);
    (1..=6_i32).find_map(|j| {
        let power = x.pow(j);
        let i = (0..=j).find(|&i| n.pow(i) == power)?;
        Some(Rational::new(i64::from(i), i64::from(j)))
    })
}

/// An enclosure of log_n of a positive number.
pub(crate) fn log_of(x: &impl Enclosed, arity: usize, level: u32) -> Enclosure {
    let bits = 64 << level;
    let x = x.enclosure(level);
    let ln = |x: &Rational| natural_logarithm(x, bits);
    let top = Enclosure::new(ln(x.lower()).lower().clone(), ln(x.upper()).upper().clone());
    let base = ln(&Rational::from(arity));
    &top * &Enclosure::new(base.upper().recip(), base.lower().recip())
}

impl fmt::Display for ExponentFormula {
    /// `2`, `6 - log_2(9)`, `2 - 1/2*log_2(x), x = 2.73205080757 the root of x^2 - 2x - 2 from 2 to 3`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(value) = self.as_rational() {
            return value.fmt(f);
        }
        let factor = if self.degree == 1 { String::new() } else { format!("1/{}*", self.degree) };
        let ExponentFormula { whole, arity, root, .. } = self;
        if let Some(root) = root.as_rational() {
            return write!(f, "{whole} - {factor}log_{arity}({root})");
        }
        let polynomial = root.minimal_polynomial().unwrap_or_else(|| root.polynomial());
        let (low, high) = isolating(root, &polynomial);
        let near = short(root, 12);
        // A root such as 4.0000000000000001 is printed as 4, and is no fraction.
        let cut = near.chars().filter(char::is_ascii_digit).count() < 12;
        let equals = if cut { '≈' } else { '=' };
        write!(
            f,
            "{whole} - {factor}log_{arity}(x), x {equals} {near} the root of {polynomial} from {low} to {high}"
        )
    }
}

/// Short rationals around a root, with no other root of the polynomial between them.
fn isolating(root: &RealAlgebraic, polynomial: &IntegerPolynomial) -> (Rational, Rational) {
    let sturm = SturmSequence::new(polynomial);
    for places in 0.. {
        let unit = Rational::power_of_ten(-places);
        let low = Rational::from(root.step(|x| (x / &unit).floor())) * &unit;
        let high = &low + &unit;
        if sturm.count_roots(&low, &high) == 1 {
            return (low, high);
        }
    }
    unreachable!("roots are apart")
}
