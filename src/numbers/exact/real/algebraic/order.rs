//! Equality and order of real algebraic numbers.

use super::number::{Form, RealAlgebraic, Root};
use crate::exact::{IntegerPolynomial, Rational, SturmSequence};
use std::cmp::Ordering;

/// The number of halvings of two intervals before the gcd of the polynomials is computed.
const GCD_AFTER: u32 = 8;

impl RealAlgebraic {
    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        match self.cmp_rational(&Rational::zero()) {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        }
    }

    /// How this number compares with `other`, by at most one evaluation of the
    /// polynomial.
    #[must_use]
    pub fn cmp_rational(&self, other: &Rational) -> Ordering {
        match &self.0 {
            Form::Rational(value) => value.cmp(other),
            Form::Irrational(root) if *other <= root.lower => Ordering::Greater,
            Form::Irrational(root) if *other >= root.upper => Ordering::Less,
            // f(other) = 0 would make the root rational.
            Form::Irrational(root) if root.polynomial.sign_at(other) == root.sign => {
                Ordering::Greater
            }
            Form::Irrational(_) => Ordering::Less,
        }
    }
}

impl RealAlgebraic {
    /// The sign of a polynomial at this number: −1, 0 or 1.
    ///
    /// ```
    /// use subcert::exact::{IntegerPolynomial, RealAlgebraic};
    ///
    /// // At √2: x² − 2, x² − x and x − 2.
    /// let root = &RealAlgebraic::roots_of(&IntegerPolynomial::from([-2, 0, 1]))[1];
    /// let sign = |p: IntegerPolynomial| root.sign_of(&p);
    /// assert_eq!([sign([-2, 0, 1].into()), sign([0, -1, 1].into()), sign([-2, 1].into())], [0, 1, -1]);
    /// ```
    #[must_use]
    pub fn sign_of(&self, p: &IntegerPolynomial) -> i8 {
        let root = match &self.0 {
            Form::Rational(value) => return p.sign_at(value),
            Form::Irrational(root) => root,
        };
        if p.degree().unwrap_or(0) == 0 {
            return p.leading().sign();
        }
        // A common divisor has no other root than this one in the interval, and that is simple.
        let common = p.gcd(&root.polynomial);
        if common.sign_at(&root.lower) == -common.sign_at(&root.upper) {
            return 0;
        }
        let (sequence, mut root) = (SturmSequence::new(p), root.clone());
        while sequence.count_roots(&root.lower, &root.upper) > 0 {
            root.halve();
        }
        p.sign_at(&root.upper)
    }
}

impl Root {
    /// Whether this and `other` are the same number. A common root lies in the
    /// intersection of the two intervals and is a root of the gcd g of the two
    /// polynomials. The intersection holds at most one root of each polynomial, and
    /// neither of its ends is a root of g. So g has a root there if and only if g has
    /// opposite signs at the two ends.
    fn equals(&self, other: &Root) -> bool {
        let (lower, upper) = ((&self.lower).max(&other.lower), (&self.upper).min(&other.upper));
        if lower >= upper {
            return false;
        }
        if self.polynomial == other.polynomial {
            return self.polynomial.sign_at(lower) == -self.polynomial.sign_at(upper);
        }
        let gcd = self.polynomial.gcd(&other.polynomial);
        gcd.sign_at(lower) == -gcd.sign_at(upper)
    }
}

impl Ord for RealAlgebraic {
    fn cmp(&self, other: &RealAlgebraic) -> Ordering {
        match (&self.0, &other.0) {
            (_, Form::Rational(value)) => self.cmp_rational(value),
            (Form::Rational(value), _) => other.cmp_rational(value).reverse(),
            (Form::Irrational(a), Form::Irrational(b)) => {
                let (mut a, mut b) = (a.clone(), b.clone());
                for halvings in 0_u32.. {
                    if a.upper <= b.lower {
                        return Ordering::Less;
                    }
                    if b.upper <= a.lower {
                        return Ordering::Greater;
                    }
                    // The intervals of most pairs are disjoint after few halvings; the
                    // gcd decides the rest.
                    let same = halvings == 0 && a.polynomial == b.polynomial;
                    if (same || halvings == GCD_AFTER) && a.equals(&b) {
                        return Ordering::Equal;
                    }
                    a.halve();
                    b.halve();
                }
                unreachable!("two different numbers are apart after finitely many halvings")
            }
        }
    }
}

impl PartialOrd for RealAlgebraic {
    fn partial_cmp(&self, other: &RealAlgebraic) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for RealAlgebraic {
    fn eq(&self, other: &RealAlgebraic) -> bool {
        match (&self.0, &other.0) {
            (Form::Rational(a), Form::Rational(b)) => a == b,
            (Form::Irrational(a), Form::Irrational(b)) => a.equals(b),
            _ => false,
        }
    }
}

impl Eq for RealAlgebraic {}
