//! The real roots of a polynomial.

use crate::exact::polynomials::descartes::{Place, isolated};
use crate::exact::{
    Enclosed, Integer, IntegerPolynomial, Rational, RealAlgebraic, RealCyclotomic, SturmSequence,
    common_denominator,
};
use std::sync::Arc;

/// A polynomial of degree d with fewer than (d + 1)/4 terms has a short Sturm sequence.
const SPARSE: usize = 4;

/// A power of 2 above all roots in absolute value. Cauchy: every root is below 1 + max |c_i/c_d|.
fn bound(polynomial: &IntegerPolynomial) -> Rational {
    let largest = polynomial.coefficients().iter().map(Integer::abs).max();
    let ratio = Rational::new(largest.unwrap_or_else(Integer::zero), polynomial.leading().abs());
    let bits = u32::try_from(ratio.ceil().bits()).expect("a number that fits in memory");
    Rational::from(Integer::one().shifted_left(bits + 1))
}

/// The roots of a square-free polynomial in the open interval (low, high).
fn inside(
    polynomial: &Arc<IntegerPolynomial>,
    low: &Rational,
    high: &Rational,
) -> impl Iterator<Item = RealAlgebraic> {
    let denominator = common_denominator([low, high]);
    let scale = Rational::from(denominator.clone());
    let [start, end] = [low, high].map(|end| (end * &scale).numerator());
    let places = isolated(&polynomial.on(&start, &end, &denominator));
    let length = &end - &start;
    let at = move |numerator: &Integer, level: u32| {
        let places = start.shifted_left(level) + &length * numerator;
        Rational::new(places, denominator.shifted_left(level))
    };
    let polynomial = Arc::clone(polynomial);
    places.into_iter().map(move |place| match place {
        Place::Point { numerator, level } => RealAlgebraic::from(at(&numerator, level)),
        Place::Between { numerator, level, sign, touches } => {
            let ends = [at(&numerator, level), at(&(numerator + Integer::one()), level)];
            RealAlgebraic::between(&polynomial, ends, sign, touches)
        }
    })
}

impl RealAlgebraic {
    /// The distinct real roots of `polynomial`, in increasing order.
    ///
    /// # Panics
    /// When `polynomial` is 0.
    #[must_use]
    pub fn roots_of(polynomial: &IntegerPolynomial) -> Vec<RealAlgebraic> {
        RealAlgebraic::roots_between(polynomial, None, None)
    }

    /// The distinct real roots of `polynomial` from `low` to `high`, both included, in increasing order. `None` means
    /// no bound on that side.
    ///
    /// They are isolated by Descartes' rule of signs, and where most coefficients are 0, by Sturm's theorem.
    ///
    /// # Panics
    /// When `polynomial` is 0.
    ///
    /// ```
    /// use subcert::exact::{IntegerPolynomial, Rational, RealAlgebraic};
    ///
    /// // (x² − 2)(x − 3)
    /// let polynomial = IntegerPolynomial::from([6, -2, -3, 1]);
    /// let (low, high) = (Some(Rational::zero()), Some(Rational::from(3)));
    /// assert_eq!(RealAlgebraic::roots_between(&polynomial, low, high).len(), 2);
    /// ```
    #[must_use]
    pub fn roots_between(
        polynomial: &IntegerPolynomial,
        low: Option<Rational>,
        high: Option<Rational>,
    ) -> Vec<RealAlgebraic> {
        assert!(!polynomial.is_zero(), "every number is a root of 0");
        let polynomial = polynomial.square_free();
        if let [constant, factor] = polynomial.coefficients() {
            let root = Rational::new(-constant, factor.clone());
            let inside = low.is_none_or(|low| low <= root) && high.is_none_or(|high| root <= high);
            return if inside { vec![RealAlgebraic::from(root)] } else { Vec::new() };
        }
        let ends = match (low, high) {
            (Some(low), Some(high)) => vec![low, high],
            (None, None) => {
                // On each side of 0 the numbers are shorter.
                let bound = bound(&polynomial);
                vec![-&bound, Rational::zero(), bound]
            }
            (low, high) => {
                let bound = bound(&polynomial);
                vec![low.unwrap_or_else(|| -&bound), high.unwrap_or(bound)]
            }
        };
        let (low, high) = (&ends[0], &ends[ends.len() - 1]);
        let root_at = |end: &Rational| {
            (polynomial.sign_at(end) == 0).then(|| RealAlgebraic::from(end.clone()))
        };
        let mut roots: Vec<RealAlgebraic> = root_at(low).into_iter().collect();
        if low >= high {
            return roots;
        }
        let terms = polynomial.coefficients().iter().filter(|c| !c.is_zero()).count();
        if terms * SPARSE < polynomial.coefficients().len() {
            roots.extend(SturmSequence::of_square_free(polynomial).roots_between(low, high));
            return roots;
        }
        let shared = Arc::new(polynomial.clone());
        for pair in ends.windows(2) {
            roots.extend(inside(&shared, &pair[0], &pair[1]));
            roots.extend(root_at(&pair[1]));
        }
        roots
    }

    /// The greatest conductor of a number whose minimal polynomial is computed.
    pub const MAX_CONDUCTOR: u32 = 60;

    /// This number as a root of its minimal polynomial; `None` where its conductor is above
    /// [`RealAlgebraic::MAX_CONDUCTOR`].
    ///
    /// ```
    /// use subcert::exact::{Rational, RealAlgebraic, RealCyclotomic};
    ///
    /// // cos(2π/5) = (√5 − 1)/4
    /// let cosine = RealCyclotomic::cosine(&Rational::new(1, 5))?;
    /// let root = RealAlgebraic::of_cyclotomic(&cosine).expect("a small conductor");
    /// assert_eq!(root.polynomial().to_string(), "4x^2 + 2x - 1");
    /// assert!(root > RealAlgebraic::from(Rational::new(3, 10)));
    /// # Ok::<(), subcert::exact::CosineError>(())
    /// ```
    #[must_use]
    pub fn of_cyclotomic(number: &RealCyclotomic) -> Option<RealAlgebraic> {
        if let Some(rational) = number.as_rational() {
            return Some(RealAlgebraic::from(rational.clone()));
        }
        if number.conductor() > RealAlgebraic::MAX_CONDUCTOR {
            return None;
        }
        let mut roots = RealAlgebraic::roots_of(&number.minimal_polynomial());
        // The conjugates are apart from this number, so that one of them is left at some level.
        for level in 0.. {
            let near = number.enclosure(level);
            roots.retain(|root| {
                let other = root.enclosure(level);
                other.lower() <= near.upper() && near.lower() <= other.upper()
            });
            if roots.len() <= 1 {
                break;
            }
        }
        roots.pop()
    }
}

impl SturmSequence {
    /// The roots of this square-free polynomial in (low, high], in increasing order.
    fn roots_between(&self, low: &Rational, high: &Rational) -> Vec<RealAlgebraic> {
        let polynomial = Arc::new(self.polynomial().clone());
        let mut roots = Vec::new();
        // Bisection. The left half is on top of the stack.
        let mut stack = vec![(low.clone(), high.clone())];
        while let Some((lower, upper)) = stack.pop() {
            match self.count_roots(&lower, &upper) {
                0 => {}
                1 => roots.push(RealAlgebraic::isolated(&polynomial, lower, upper)),
                _ => {
                    let middle = (&lower + &upper) / Rational::from(2);
                    stack.push((middle.clone(), upper));
                    stack.push((lower, middle));
                }
            }
        }
        roots
    }
}
