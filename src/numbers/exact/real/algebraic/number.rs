//! Real algebraic numbers: a polynomial, and an interval that isolates one root.

use crate::exact::{Enclosed, Enclosure, Integer, IntegerPolynomial, Rational};
use std::fmt;
use std::sync::Arc;

/// A real root of an integer polynomial: a rational number, or the one root of a
/// square-free polynomial in an open interval. The polynomial need not be irreducible,
/// but a rational root is always stored as a rational number.
///
/// Comparison is exact, also between roots of different polynomials.
///
/// ```
/// use subcert::exact::{IntegerPolynomial, Rational, RealAlgebraic, format::fixed};
///
/// // (x² − 2)(2x − 3)
/// let roots = RealAlgebraic::roots_of(&IntegerPolynomial::from([6, -4, -3, 2]));
/// let decimals: Vec<String> = roots.iter().map(|root| fixed(root, 8)).collect();
/// assert_eq!(decimals, ["-1.41421356", "1.41421356", "1.50000000"]);
/// assert_eq!(roots[2], RealAlgebraic::from(Rational::new(3, 2)));
///
/// let four = IntegerPolynomial::from([-4, 0, 0, 0, 1]);
/// assert_eq!(RealAlgebraic::roots_of(&four)[1], roots[1]);
/// ```
#[derive(Clone, Debug)]
pub struct RealAlgebraic(pub(super) Form);

#[derive(Clone, Debug)]
pub(super) enum Form {
    Rational(Rational),
    Irrational(Root),
}

/// The only root of f in (lower, upper). It is simple, and f(lower)·f(upper) < 0.
#[derive(Clone, Debug)]
pub(super) struct Root {
    /// Primitive and square-free.
    pub(super) polynomial: Arc<IntegerPolynomial>,
    pub(super) lower: Rational,
    pub(super) upper: Rational,
    /// The sign of f(lower).
    pub(super) sign: i8,
}

impl From<Rational> for RealAlgebraic {
    fn from(value: Rational) -> RealAlgebraic {
        RealAlgebraic(Form::Rational(value))
    }
}

impl RealAlgebraic {
    /// The root of the square-free `polynomial` in (lower, upper]. This interval must
    /// hold exactly one root.
    pub(crate) fn isolated(
        polynomial: &Arc<IntegerPolynomial>,
        lower: Rational,
        upper: Rational,
    ) -> RealAlgebraic {
        if polynomial.sign_at(&upper) == 0 {
            return RealAlgebraic::from(upper);
        }
        let sign = -polynomial.sign_at(&upper);
        RealAlgebraic::between(polynomial, [lower, upper], sign, true)
    }

    /// The only root of the square-free `polynomial` in an open interval; `sign` is that of the polynomial just to the
    /// right of its lower end. With `touches`, an end may be another root.
    pub(crate) fn between(
        polynomial: &Arc<IntegerPolynomial>,
        [lower, upper]: [Rational; 2],
        sign: i8,
        touches: bool,
    ) -> RealAlgebraic {
        let mut root = Root { polynomial: Arc::clone(polynomial), lower, upper, sign };
        // Just to the right of its lower end the polynomial keeps its sign, also where that is another root.
        let vanishes = |end: &Rational| polynomial.sign_at(end) == 0;
        while touches && (vanishes(&root.lower) || vanishes(&root.upper)) {
            if let Some(value) = root.halve() {
                return RealAlgebraic::from(value);
            }
        }
        root.normal()
    }

    /// This, if it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.0 {
            Form::Rational(value) => Some(value),
            Form::Irrational(_) => None,
        }
    }

    /// A primitive square-free polynomial with this number as a root: qx − p for a
    /// rational number p/q. For an irrational number it need not be the minimal
    /// polynomial.
    #[must_use]
    pub fn polynomial(&self) -> IntegerPolynomial {
        match &self.0 {
            Form::Rational(value) => {
                IntegerPolynomial::from([-value.numerator(), value.denominator()])
            }
            Form::Irrational(root) => (*root.polynomial).clone(),
        }
    }

    /// The minimal polynomial over Q: primitive and irreducible. `None` when
    /// [`IntegerPolynomial::irreducible_factors`] gives up.
    ///
    /// ```
    /// use subcert::exact::{IntegerPolynomial, RealAlgebraic};
    ///
    /// // (x² − 2)(x² − 3)
    /// let roots = RealAlgebraic::roots_of(&IntegerPolynomial::from([6, 0, -5, 0, 1]));
    /// assert_eq!(roots[0].minimal_polynomial(), Some(IntegerPolynomial::from([-3, 0, 1])));
    /// ```
    #[must_use]
    pub fn minimal_polynomial(&self) -> Option<IntegerPolynomial> {
        let Form::Irrational(root) = &self.0 else { return Some(self.polynomial()) };
        let factors = root.polynomial.irreducible_factors();
        // The one root in the interval is simple, so that just one factor changes sign.
        let changes = |f: &IntegerPolynomial| f.sign_at(&root.lower) != f.sign_at(&root.upper);
        factors?.into_iter().find(changes)
    }

    /// Rationals a ≤ self ≤ b. They are equal only for a rational number.
    #[must_use]
    pub fn bounds(&self) -> (Rational, Rational) {
        match &self.0 {
            Form::Rational(value) => (value.clone(), value.clone()),
            Form::Irrational(root) => (root.lower.clone(), root.upper.clone()),
        }
    }

    /// A rational number strictly between this number and the greater number `other`.
    ///
    /// # Panics
    /// When this is not less than `other`.
    #[must_use]
    pub fn rational_below(&self, other: &RealAlgebraic) -> Rational {
        let (mut a, mut b) = (self.clone(), other.clone());
        loop {
            let (low, high) = (a.bounds().1, b.bounds().0);
            // Where the intervals of two irrational numbers touch, their common end lies
            // between them.
            let touching = low == high && (a.is_irrational() && b.is_irrational());
            if low < high || touching {
                return (low + high) / Rational::from(2);
            }
            assert!(a.is_irrational() || b.is_irrational(), "{self} is not less than {other}");
            a.halve();
            b.halve();
        }
    }

    /// For points p_1 < … < p_n, n + 1 rational numbers: one below p_1, one between each
    /// two neighbours, and one above p_n.
    ///
    /// # Panics
    /// When the points do not increase.
    #[must_use]
    pub fn rationals_between(points: &[RealAlgebraic]) -> Vec<Rational> {
        let (Some(first), Some(last)) = (points.first(), points.last()) else {
            return vec![Rational::zero()];
        };
        let (one, between) = (Rational::one(), points.windows(2));
        let between = between.map(|pair| pair[0].rational_below(&pair[1]));
        let outer = [first.bounds().0 - &one, last.bounds().1 + one];
        let [before, after] = outer;
        std::iter::once(before).chain(between).chain([after]).collect()
    }

    /// Whether this is irrational.
    fn is_irrational(&self) -> bool {
        matches!(self.0, Form::Irrational(_))
    }

    /// Halves the interval of an irrational number.
    fn halve(&mut self) {
        if let Form::Irrational(root) = &mut self.0 {
            // The middle is never the root, which is not rational.
            root.halve();
        }
    }

    /// The number of binary digits of the polynomial and the interval.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Form::Rational(value) => value.bits(),
            Form::Irrational(root) => {
                let polynomial = root.polynomial.coefficients().iter().map(Integer::bits);
                polynomial.sum::<u64>() + root.lower.bits() + root.upper.bits()
            }
        }
    }
}

impl Root {
    /// Halves the interval. Returns the root if the root is the midpoint.
    pub(super) fn halve(&mut self) -> Option<Rational> {
        let middle = (&self.lower + &self.upper) / Rational::from(2);
        match self.polynomial.sign_at(&middle) {
            0 => return Some(middle),
            sign if sign == self.sign => self.lower = middle,
            _ => self.upper = middle,
        }
        None
    }

    fn width(&self) -> Rational {
        &self.upper - &self.lower
    }

    /// This root as a number, which is stored as a rational if it is one. The denominator
    /// of a rational root divides the leading coefficient l. So l times the root is the
    /// only integer in an interval shorter than 1.
    fn normal(mut self) -> RealAlgebraic {
        let leading = Rational::from(self.polynomial.leading());
        while self.width() * &leading >= Rational::one() {
            if let Some(value) = self.halve() {
                return RealAlgebraic::from(value);
            }
        }
        let candidate = Rational::from((&self.upper * &leading).floor()) / leading;
        if candidate > self.lower && self.polynomial.sign_at(&candidate) == 0 {
            return RealAlgebraic::from(candidate);
        }
        RealAlgebraic(Form::Irrational(self))
    }
}

impl Enclosed for RealAlgebraic {
    /// An interval no wider than 2^(−64·2^level), by bisection.
    fn enclosure(&self, level: u32) -> Enclosure {
        let mut root = match &self.0 {
            Form::Rational(value) => return Enclosure::exact(value.clone()),
            Form::Irrational(root) => root.clone(),
        };
        let bits = 64_u32.checked_shl(level).expect("a precision that fits in memory");
        let width = Rational::new(1, Integer::one().shifted_left(bits));
        while root.width() > width {
            // The middle is never the root, which is not rational.
            root.halve();
        }
        Enclosure::new(root.lower, root.upper)
    }
}

impl fmt::Display for RealAlgebraic {
    /// p/q for a rational number; otherwise the polynomial and the interval:
    /// `root of x^2 - 2 in (1, 3/2)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Rational(value) => value.fmt(f),
            Form::Irrational(Root { polynomial, lower, upper, .. }) => {
                f.pad(&format!("root of {polynomial} in ({lower}, {upper})"))
            }
        }
    }
}
