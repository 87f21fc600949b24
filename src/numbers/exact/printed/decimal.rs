//! A decimal or a fraction as printed, and how it relates to an exact value.

use crate::exact::{Enclosed, Integer, Rational, Real, RealAlgebraic};

/// A printed decimal: `mantissa` · 10^`exponent`, where `exponent` is the place of its
/// last printed digit. `0.0310` and `0.031` are equal in value but differ as decimals:
/// the first is printed to one digit more. A printed fraction `mantissa`/q is one too: nobody rounds to it, so that one
/// unit of its last place is 0.
///
/// ```
/// use subcert::exact::{Rational, Rounding, parse_decimal};
///
/// let printed = parse_decimal("0.667")?;
/// assert_eq!(printed.rounding_of(&Rational::new(2, 3)), Rounding::Nearest);
/// assert_eq!(parse_decimal("0.666")?.rounding_of(&Rational::new(2, 3)), Rounding::Cut);
/// // Nobody rounds 1/16 away from zero to 1.
/// assert_eq!(parse_decimal("1")?.rounding_of(&Rational::new(1, 16)), Rounding::Neither);
/// # Ok::<(), subcert::exact::NumberError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Decimal {
    mantissa: Integer,
    exponent: i32,
    /// The denominator of a fraction.
    over: Option<Integer>,
}

/// How a printed decimal came from an exact value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// The decimal is the exact value.
    Exact,
    /// The nearest decimal of its length; of two equally near ones, either.
    Nearest,
    /// Not the nearest; cut towards zero.
    Cut,
    /// Not the nearest; rounded away from zero, and not to one unit of the last place.
    Up,
    /// None of these.
    Neither,
}

impl Decimal {
    /// `mantissa` · 10^`exponent`, printed to the place 10^`exponent`.
    #[must_use]
    pub fn new(mantissa: Integer, exponent: i32) -> Decimal {
        Decimal { mantissa, exponent, over: None }
    }

    /// The fraction `numerator`/`denominator`; `None` where the denominator is 0.
    #[must_use]
    pub fn fraction(numerator: Integer, denominator: Integer) -> Option<Decimal> {
        let over = Some(denominator).filter(|denominator| !denominator.is_zero());
        over.map(|over| Decimal { mantissa: numerator, exponent: 0, over: Some(over) })
    }

    /// Whether it is a fraction, which is exact.
    #[must_use]
    pub fn is_fraction(&self) -> bool {
        self.over.is_some()
    }

    /// All printed digits, read as one integer; those of a fraction's numerator.
    #[must_use]
    pub fn mantissa(&self) -> &Integer {
        &self.mantissa
    }

    /// The place of the last printed digit, as an exponent of ten; 0 of a fraction.
    #[must_use]
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The exact value of the printed digits.
    #[must_use]
    pub fn value(&self) -> Rational {
        match &self.over {
            Some(over) => Rational::new(self.mantissa.clone(), over.clone()),
            None => Rational::from(self.mantissa.clone()) * self.unit(),
        }
    }

    /// The same number with all digits before the point: `1e1` as `10`.
    #[must_use]
    pub fn whole(self) -> Decimal {
        if self.is_fraction() || self.exponent <= 0 {
            return self;
        }
        Decimal::new(self.value().numerator().clone(), 0)
    }

    /// One unit in the last printed place; 0 of a fraction.
    #[must_use]
    pub fn unit(&self) -> Rational {
        if self.is_fraction() { Rational::zero() } else { Rational::power_of_ten(self.exponent) }
    }

    /// Whether it is one unit of its last place, or its negative.
    #[must_use]
    pub fn is_one_unit(&self) -> bool {
        !self.is_fraction() && self.mantissa.abs() == Integer::one()
    }

    /// The number of digits from the first that is not 0 to the last printed
    /// one; 0 when all are 0.
    #[must_use]
    pub fn significant_digits(&self) -> usize {
        if self.mantissa.is_zero() { 0 } else { self.mantissa.abs().to_string().len() }
    }

    /// The digits as one integer that is not negative; of a fraction those of its numerator in lowest terms.
    fn integer(&self) -> Integer {
        if self.is_fraction() { self.value().numerator().abs() } else { self.mantissa.abs() }
    }

    /// The digits without zeros at both ends, those of a fraction's numerator in lowest terms; none where all are 0.
    #[must_use]
    pub fn telling_digits(&self) -> String {
        self.integer().to_string().trim_matches('0').to_owned()
    }

    /// An integer that numbers have in common which differ by the sign or a power of ten, however they are written: with
    /// the absolute value p/q in lowest terms, the digits of the decimal that it is, without zeros at both ends and without
    /// factors 5; if it is none, p without factors 2 and 5. That of 0 is 0.
    ///
    /// It is small for simple values: m for the odd numbers m times powers of 2, and 1 for 1/3.
    ///
    /// ```
    /// use subcert::exact::{Integer, parse_decimal, parse_printed};
    ///
    /// let part = |text| Ok::<_, subcert::exact::NumberError>(parse_printed(text)?.telling_part());
    /// assert_eq!(part("0.0266")?, Integer::from(266));
    /// for three in ["0.375", "3/8", "-600/1600", "3000", "3/7"] {
    ///     assert_eq!(part(three)?, Integer::from(3));
    /// }
    /// # Ok::<(), subcert::exact::NumberError>(())
    /// ```
    #[must_use]
    pub fn telling_part(&self) -> Integer {
        let mut part = self.integer();
        if let Some(over) = &self.over {
            let value = Rational::new(self.mantissa.clone(), over.clone());
            let (rest, fives) = without(value.denominator(), 5);
            let (rest, twos) = without(rest, 2);
            if rest != Integer::one() {
                return without(without(part, 2).0, 5).0;
            }
            // Both are the numbers of digits behind the point if the other one is not more.
            part = part.shifted_left(fives.saturating_sub(twos));
        }
        without(without(part, 10).0, 5).0
    }

    /// The closed interval of the values that round to this decimal: half a
    /// unit in the last place to either side.
    #[must_use]
    pub fn interval(&self) -> (Rational, Rational) {
        let half = self.unit() / Rational::from(2);
        let value = self.value();
        (&value - &half, value + half)
    }

    /// How this decimal came from the value `exact`, in exact arithmetic.
    #[must_use]
    pub fn rounding_of<R: Real + PartialOrd>(&self, exact: &R) -> Rounding {
        let (shown, place) = (self.value(), self.unit());
        if self.is_fraction() {
            let equal = R::from_rational(&shown) == *exact;
            return if equal { Rounding::Exact } else { Rounding::Neither };
        }
        // Most decimals are far from `exact`, and comparing is quicker than subtracting.
        let above = |bound: Rational| *exact >= R::from_rational(&bound);
        if above(&shown + &place) || !above(&shown - &place) {
            return Rounding::Neither;
        }
        let value = R::from_rational(&shown);
        let off = value.minus(exact).magnitude();
        if off == R::zero() {
            return Rounding::Exact;
        }
        let unit = R::from_rational(&place);
        if off.plus(&off) <= unit {
            return Rounding::Nearest;
        }
        if off >= unit {
            return Rounding::Neither;
        }
        if value.magnitude() < exact.magnitude() {
            return Rounding::Cut;
        }
        // Nobody rounds a value below half a unit away from zero to one unit: 1/16 is no 1.
        if self.is_one_unit() { Rounding::Neither } else { Rounding::Up }
    }

    /// How this decimal came from the real algebraic number `exact`, in exact arithmetic.
    #[must_use]
    pub fn rounding_of_algebraic(&self, exact: &RealAlgebraic) -> Rounding {
        if let Some(exact) = exact.as_rational() {
            return self.rounding_of(exact);
        }
        if self.is_fraction() {
            return Rounding::Neither;
        }
        // The answer depends only on where the irrational number lies among these
        // rational marks.
        let half = self.unit() / Rational::from(2);
        let marks: Vec<Rational> =
            (-3..=3).map(|i| self.value() + &half * Rational::from(i)).collect();
        let place = exact.step(|x| marks.partition_point(|mark| mark < x));
        let next = marks.get(place).unwrap_or(&marks[marks.len() - 1]);
        self.rounding_of(&(next - half / Rational::from(2)))
    }
}

/// This integer without all its factors `factor`, and how many these are; 0 has none.
fn without(mut integer: Integer, factor: i64) -> (Integer, u32) {
    let (factor, mut count) = (Integer::from(factor), 0);
    while !integer.is_zero() {
        let (quotient, remainder) = integer.div_rem_floor(&factor);
        if !remainder.is_zero() {
            break;
        }
        (integer, count) = (quotient, count + 1);
    }
    (integer, count)
}
