//! Bounds of conjugates, which separate a number from 0.

use crate::exact::Integer;

/// That a number x is U/L, where U and L are algebraic integers of one field: no conjugate of U exceeds
/// 2^`numerator`, and none of L exceeds that of `denominator`.
///
/// If x ≠ 0 and the field has degree D, then |x| ≥ 2^{−(D−1)·numerator − denominator}: the norm of U is
/// an integer other than 0, so that |U| is at least 1 over the product of its other D − 1 conjugates.
#[derive(Clone, Debug)]
pub(super) struct Size {
    numerator: u64,
    denominator: Denominator,
}

/// A bound of the conjugates of L.
#[derive(Clone, Debug)]
enum Denominator {
    /// L itself, a positive integer.
    Integer(Integer),
    /// 2 to this power is a bound.
    Bits(u64),
}

impl Denominator {
    fn bits(&self) -> u64 {
        match self {
            Denominator::Integer(value) => bits(value),
            Denominator::Bits(bits) => *bits,
        }
    }

    fn times(&self, other: &Denominator) -> Denominator {
        match (self, other) {
            (Denominator::Integer(a), Denominator::Integer(b)) => Denominator::Integer(a * b),
            _ => Denominator::Bits(self.bits().saturating_add(other.bits())),
        }
    }
}

/// The least b with |value| ≤ 2^b; 0 for 0.
fn bits(value: &Integer) -> u64 {
    let size = value.abs();
    if size.is_zero() { 0 } else { (size - Integer::one()).bits() }
}

impl Size {
    /// That of U/q, where no conjugate of U exceeds `bound` and q > 0 is an integer.
    pub(super) fn of(bound: &Integer, q: Integer) -> Size {
        Size { numerator: bits(bound), denominator: Denominator::Integer(q) }
    }

    /// That of a sum or a difference.
    pub(super) fn plus(&self, other: &Size) -> Size {
        let ([a, b], denominator) = match (&self.denominator, &other.denominator) {
            (Denominator::Integer(p), Denominator::Integer(q)) => {
                let lcm = p.lcm(q);
                let factors = [p, q].map(|one| bits(&lcm.div_floor(one)));
                (factors, Denominator::Integer(lcm))
            }
            (p, q) => ([q.bits(), p.bits()], p.times(q)),
        };
        let terms = [self.numerator.saturating_add(a), other.numerator.saturating_add(b)];
        Size { numerator: terms[0].max(terms[1]).saturating_add(1), denominator }
    }

    /// That of a product.
    pub(super) fn times(&self, other: &Size) -> Size {
        let numerator = self.numerator.saturating_add(other.numerator);
        Size { numerator, denominator: self.denominator.times(&other.denominator) }
    }

    /// That of a quotient.
    pub(super) fn over(&self, other: &Size) -> Size {
        let inverse = Size {
            numerator: other.denominator.bits(),
            denominator: Denominator::Bits(other.numerator),
        };
        self.times(&inverse)
    }

    /// That of √(U/L) = √(UL)/L.
    pub(super) fn square_root(&self) -> Size {
        let square = self.numerator.saturating_add(self.denominator.bits());
        Size { numerator: square.div_ceil(2), denominator: self.denominator.clone() }
    }

    /// That of a root of Σ_{k≤d} c_k x^k. With a common denominator q of the coefficients, a_k = q c_k
    /// are algebraic integers, and y = a_d x is a root of y^d + Σ_{k<d} a_k a_d^{d−1−k} y^k. So y is an
    /// algebraic integer, of absolute value at most the greater of 1 and Σ_{k<d} |a_k a_d^{d−1−k}|, and
    /// so are its conjugates. `bounds` are those of the conjugates of a_0, …, a_d.
    pub(super) fn root(bounds: &[Integer]) -> Size {
        let degree = bounds.len() - 1;
        let leading = bits(&bounds[degree]);
        let power = |k: usize| leading.saturating_mul((degree - 1 - k) as u64);
        let terms = bounds[..degree].iter().enumerate();
        let largest = terms.map(|(k, bound)| bits(bound).saturating_add(power(k))).max();
        let count = u64::from(usize::BITS - degree.leading_zeros());
        Size {
            numerator: largest.unwrap_or(0).saturating_add(count),
            denominator: Denominator::Bits(leading),
        }
    }

    /// b such that a number of this size in a field of degree at most `degree` is 0 or at least 2^−b
    /// in absolute value.
    pub(super) fn separation(&self, degree: u64) -> u64 {
        let others = degree.saturating_sub(1).saturating_mul(self.numerator);
        others.saturating_add(self.denominator.bits())
    }

    /// b such that the denominator of a rational number of this size is at most 2^b: it divides the
    /// norm of L.
    pub(super) fn denominator_bits(&self, degree: u64) -> u64 {
        match &self.denominator {
            Denominator::Integer(value) => bits(value),
            Denominator::Bits(bits) => bits.saturating_mul(degree),
        }
    }
}
