//! Sturm sequences: how many real roots a polynomial has.

use crate::exact::{IntegerPolynomial, Rational};

/// The Sturm sequence of a polynomial f: f, f′, and then always the negative remainder of
/// the two preceding members, up to positive factors.
///
/// The number of distinct real roots of f in (a, b] is the number of sign changes of the
/// sequence at a minus the number at b, for a < b and f(a) ≠ 0 (Sturm 1829).
///
/// ```
/// use subcert::exact::{IntegerPolynomial, Rational, SturmSequence};
///
/// let sturm = SturmSequence::new(&IntegerPolynomial::from([-2, 0, 1]));
/// assert_eq!(sturm.count_real_roots(), 2);
/// assert_eq!(sturm.count_roots(&Rational::from(1), &Rational::from(2)), 1);
/// ```
#[derive(Clone, Debug)]
pub struct SturmSequence {
    sequence: Vec<IntegerPolynomial>,
}

impl SturmSequence {
    /// The sequence of the square-free part of `polynomial`.
    ///
    /// # Panics
    /// When `polynomial` is 0.
    #[must_use]
    pub fn new(polynomial: &IntegerPolynomial) -> SturmSequence {
        assert!(!polynomial.is_zero(), "every number is a root of 0");
        SturmSequence::of_square_free(polynomial.square_free())
    }

    /// The sequence of a square-free polynomial.
    pub(crate) fn of_square_free(polynomial: IntegerPolynomial) -> SturmSequence {
        let derivative = polynomial.derivative();
        let mut sequence = vec![polynomial, derivative];
        while let [.., a, b] = &sequence[..]
            && !b.is_zero()
        {
            let next = -&a.remainder(b);
            sequence.push(next);
        }
        sequence.pop();
        SturmSequence { sequence }
    }

    /// The square-free part of f.
    pub(crate) fn polynomial(&self) -> &IntegerPolynomial {
        &self.sequence[0]
    }

    /// The number of distinct roots in (lower, upper]; 0 when this interval is empty.
    #[must_use]
    pub fn count_roots(&self, lower: &Rational, upper: &Rational) -> usize {
        if lower >= upper {
            return 0;
        }
        // The number of sign changes falls by 1 at each root of f, and is taken here to
        // the right of both ends. So a root at `upper` is counted, and a root at `lower`
        // is not.
        self.changes_right_of(lower) - self.changes_right_of(upper)
    }

    /// The number of distinct real roots.
    #[must_use]
    pub fn count_real_roots(&self) -> usize {
        let at = |infinity: i8| {
            changes(self.sequence.iter().map(|p| {
                let odd = p.degree().unwrap_or(0) % 2 == 1;
                if odd { infinity * p.leading().sign() } else { p.leading().sign() }
            }))
        };
        at(-1) - at(1)
    }

    /// The number of sign changes just to the right of x. Zeros can be left out: where f
    /// vanishes, f has the sign of f′ just to the right; where another member vanishes,
    /// its two neighbours in the sequence have opposite signs.
    fn changes_right_of(&self, x: &Rational) -> usize {
        changes(self.sequence.iter().map(|p| p.sign_at(x)))
    }
}

/// The number of sign changes, zeros left out.
pub(crate) fn changes(signs: impl Iterator<Item = i8>) -> usize {
    let (mut count, mut last) = (0, 0);
    for sign in signs.filter(|&sign| sign != 0) {
        count += usize::from(sign == -last);
        last = sign;
    }
    count
}
