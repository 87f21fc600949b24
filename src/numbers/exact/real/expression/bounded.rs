//! Signs that are looked for with a bounded number of digits.

use super::node::{Operation, RealExpression};
use super::rounded::power_of_half;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use std::cmp::Ordering;

impl RealExpression {
    /// The sign, as −1, 0 or 1, unless enclosures of some `bits` binary digits leave it open. [`RealExpression::sign`]
    /// always decides, and may take very long for a 0 that is written in many roots.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealExpression, Scalar};
    ///
    /// let root = |n: i64| RealExpression::from(Rational::from(n)).sqrt().expect("a positive number");
    /// let zero = root(2).times(&root(3)).minus(&root(6));
    /// assert_eq!(zero.sign_within(10_000), Some(0));
    /// assert_eq!(root(3).minus(&root(2)).sign_within(64), Some(1));
    /// ```
    #[must_use]
    pub fn sign_within(&self, bits: u64) -> Option<i8> {
        if let Operation::Number(value) = &self.0.operation {
            return Some(value.sign());
        }
        let levels = (0..).take_while(|level| 64_u64 << level <= bits.max(64));
        let separation = self.separation();
        let least = (separation <= bits).then(|| power_of_half(separation));
        let mut near = levels.map(|level| self.approximation(level));
        near.find_map(|near| {
            let is_zero = || least.as_ref().is_some_and(|least| near.width() < *least);
            near.sign().or_else(|| is_zero().then_some(0))
        })
    }

    /// How this number compares with a rational one, as far as `bits` binary digits tell.
    ///
    /// ```
    /// use std::cmp::Ordering;
    /// use subcert::exact::{Rational, RealExpression};
    ///
    /// let root = RealExpression::from(Rational::from(2)).sqrt()?;
    /// assert_eq!(root.compare_within(&Rational::new(3, 2), 64), Some(Ordering::Less));
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    #[must_use]
    pub fn compare_within(&self, other: &Rational, bits: u64) -> Option<Ordering> {
        if let Some(value) = self.as_number().and_then(RealCyclotomic::as_rational) {
            return Some(value.cmp(other));
        }
        for level in [0, 1] {
            let near = self.approximation(level);
            if near.upper() < other {
                return Some(Ordering::Less);
            }
            if other < near.lower() {
                return Some(Ordering::Greater);
            }
        }
        let difference = self.minus(&RealExpression::from(other.clone()));
        difference.sign_within(bits).map(|sign| sign.cmp(&0))
    }

    /// An enclosure of some 64·2^`level` binary digits, which does not become a point where the number is
    /// rational and this would have to be found out.
    #[must_use]
    pub fn near(&self, level: u32) -> crate::exact::Enclosure {
        self.approximation(level)
    }
}
