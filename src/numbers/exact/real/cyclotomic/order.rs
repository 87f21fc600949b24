//! Sign, order and enclosures, under the embedding into the reals in which 2cos(2π/n) has
//! this value, the greatest of its conjugates.

use super::field::Field;
use super::number::{Element, Form, RealCyclotomic};
use crate::exact::{Enclosed, Enclosure, Integer, Rational};
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

impl Element {
    /// (s, e) with |s − 2^bits·q·self| ≤ e: each term 2cos(2πk/n) is within 2^−bits of
    /// its fixed-point value, so e = Σ_{k≥1} |a_k|.
    fn fixed(&self, level: u32) -> (Integer, Integer) {
        let table = self.field.table(level);
        let (mut sum, mut error) =
            (self.numerators[0].shifted_left(Field::bits(level)), Integer::zero());
        for (k, numerator) in self.terms().filter(|(k, _)| *k > 0) {
            sum.add_product(numerator, &table[k]);
            error += &numerator.abs();
        }
        (sum, error)
    }

    /// [`fixed`](Self::fixed) of level 0 in machine words; `None` unless Σ |a_k| < 2^61.
    /// No table entry exceeds 2^65, so no sum exceeds 2^126.
    fn fixed_words(&self) -> Option<(i128, i128)> {
        let table = self.field.words();
        let first = i128::from(self.numerators[0].to_i64()?);
        let (mut sum, mut error) = (first << Field::bits(0), 0);
        let mut size = first.abs();
        let terms = self.numerators[1..].iter().zip(&table[1..]);
        for (numerator, cosine) in terms.filter(|(numerator, _)| !numerator.is_zero()) {
            let numerator = i128::from(numerator.to_i64()?);
            sum = numerator.wrapping_mul(*cosine).wrapping_add(sum);
            error += numerator.abs();
        }
        size += error;
        (size < 1 << 61).then_some((sum, error))
    }

    /// The sign, if the precision of this level decides it.
    fn sign_at(&self, level: u32) -> Option<i8> {
        if level == 0
            && let Some((sum, error)) = self.fixed_words()
        {
            return (sum.abs() > error).then_some(if sum < 0 { -1 } else { 1 });
        }
        let (sum, error) = self.fixed(level);
        (sum.abs() > error).then(|| sum.sign())
    }
}

impl RealCyclotomic {
    /// −1, 0 or 1; 0 only for the number 0.
    #[must_use]
    pub fn sign(&self) -> i8 {
        self.sign_with_refinements().0
    }

    /// The sign, and how often the number of binary digits of the cosines, 64 at first,
    /// had to be doubled to find it: 0 times for a rational number. The search ends at
    /// the first enclosure that excludes 0. Such an enclosure exists, because 0 is stored
    /// as a rational.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn sign_with_refinements(&self) -> (i8, u32) {
        match &self.0 {
            Form::Rational(value) => (value.sign(), 0),
            Form::Irrational(element) => (0..)
                .find_map(|level| Some((element.sign_at(level)?, level)))
                .expect("a number other than 0"),
        }
    }

    /// Integers of about 50 bits near 2^s·x for the numbers x, with one s for all. The
    /// numbers must have denominator 1. `None` when all are rational, or when the
    /// coefficients do not fit in machine words.
    pub(super) fn rounded(values: &[RealCyclotomic]) -> Option<Vec<i64>> {
        let fixed = |value: &RealCyclotomic| match &value.0 {
            Form::Rational(value) => Some(i128::from(value.floor().to_i64()?) << Field::bits(0)),
            Form::Irrational(element) => element.fixed_words().map(|(sum, _)| sum),
        };
        if values.iter().all(|value| value.as_rational().is_some()) {
            return None;
        }
        let fixed: Vec<i128> = values.iter().map(fixed).collect::<Option<_>>()?;
        let most = fixed.iter().map(|value| value.unsigned_abs()).max()?;
        let excess = (u128::BITS - most.leading_zeros()).saturating_sub(50);
        fixed.into_iter().map(|value| i64::try_from(value >> excess).ok()).collect()
    }

    /// (s, e, q) with |s − 2^64·q·self| ≤ e.
    fn fixed(&self) -> (Integer, Integer, Integer) {
        match &self.0 {
            Form::Rational(value) => {
                let scaled = value.numerator().shifted_left(Field::bits(0));
                (scaled, Integer::zero(), value.denominator())
            }
            Form::Irrational(element) => {
                let (sum, error) = element.fixed(0);
                (sum, error, element.denominator.clone())
            }
        }
    }

    /// The order of two irrational numbers with the same denominator, if their level-0
    /// enclosures fit in machine words and decide it.
    fn compare_words(&self, other: &RealCyclotomic) -> Option<Ordering> {
        let (Form::Irrational(a), Form::Irrational(b)) = (&self.0, &other.0) else { return None };
        if a.denominator != b.denominator {
            return None;
        }
        let ((s, e), (t, f)) = (a.fixed_words()?, b.fixed_words()?);
        (s.abs_diff(t) > (e + f).unsigned_abs()).then(|| s.cmp(&t))
    }

    /// ⌊self⌋.
    #[must_use]
    pub fn floor(&self) -> Integer {
        self.step(Rational::floor)
    }
}

impl Enclosed for RealCyclotomic {
    /// Computed from the cosines to 64·2^level binary digits.
    fn enclosure(&self, level: u32) -> Enclosure {
        match &self.0 {
            Form::Rational(value) => Enclosure::exact(value.clone()),
            Form::Irrational(element) => {
                let (sum, error) = element.fixed(level);
                let scale = element.denominator.shifted_left(Field::bits(level));
                Enclosure::new(
                    Rational::new(&sum - &error, scale.clone()),
                    Rational::new(sum + error, scale),
                )
            }
        }
    }
}

impl Ord for RealCyclotomic {
    /// Compares the enclosures of level 0. If they overlap, the sign of the difference
    /// decides.
    ///
    /// # Panics
    /// When the enclosures overlap and the numbers have no common field within the cap.
    fn cmp(&self, other: &RealCyclotomic) -> Ordering {
        if let (Form::Rational(a), Form::Rational(b)) = (&self.0, &other.0) {
            return a.cmp(b);
        }
        if matches!(&other.0, Form::Rational(value) if value.is_zero()) {
            return self.sign().cmp(&0);
        }
        if let Some(order) = self.compare_words(other) {
            return order;
        }
        let (a, e, p) = self.fixed();
        let (b, f, q) = other.fixed();
        let (off, error) = (a * &q - b * &p, e * q + f * p);
        if off.abs() > error {
            return off.sign().cmp(&0);
        }
        if let (Form::Irrational(a), Form::Irrational(b)) = (&self.0, &other.0)
            && a.field.conductor() == b.field.conductor()
            && self == other
        {
            return Ordering::Equal;
        }
        (self - other).sign().cmp(&0)
    }
}

impl PartialOrd for RealCyclotomic {
    fn partial_cmp(&self, other: &RealCyclotomic) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for RealCyclotomic {
    /// Compares the coefficients, if both numbers are stored in the same field; otherwise
    /// as [`Ord::cmp`].
    fn eq(&self, other: &RealCyclotomic) -> bool {
        match (&self.0, &other.0) {
            (Form::Rational(a), Form::Rational(b)) => a == b,
            (Form::Irrational(a), Form::Irrational(b)) => {
                if a.field.conductor() == b.field.conductor() {
                    return a.denominator == b.denominator && a.numerators == b.numerators;
                }
                self.cmp(other) == Ordering::Equal
            }
            _ => false,
        }
    }
}

impl Eq for RealCyclotomic {}

impl Hash for RealCyclotomic {
    /// Hashes ⌊2^64·self⌋, which does not depend on the field in which the number is
    /// stored.
    fn hash<H: Hasher>(&self, state: &mut H) {
        let scale = Rational::from(Integer::one().shifted_left(64));
        self.step(|value| (value * &scale).floor()).hash(state);
    }
}
