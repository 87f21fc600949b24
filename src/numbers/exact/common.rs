//! Rationals as integers over one common denominator.

use super::{Integer, Rational};

/// The least common denominator of `values`.
pub fn common_denominator<'a>(values: impl IntoIterator<Item = &'a Rational>) -> Integer {
    values.into_iter().fold(Integer::one(), |lcm, value| lcm.lcm(&value.denominator()))
}

/// Rows of rationals, written as integers over one common denominator q.
///
/// Loops that only add and multiply work on the numerators: an operation on integers
/// takes about a thirtieth of the time of one on fractions, which are reduced each time.
///
/// ```
/// use subcert::exact::{CommonDenominator, Integer, Rational};
///
/// let rows = vec![vec![Rational::new(1, 2), Rational::new(-1, 3)]];
/// let common = CommonDenominator::of(&rows);
/// assert_eq!(common.denominator, Integer::from(6));
/// assert_eq!(common.numerators, vec![vec![Integer::from(3), Integer::from(-2)]]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommonDenominator {
    /// The least q > 0.
    pub denominator: Integer,
    /// q·x for every x, row by row.
    pub numerators: Vec<Vec<Integer>>,
}

impl CommonDenominator {
    /// The rows over their least common denominator.
    #[must_use]
    pub fn of(rows: &[Vec<Rational>]) -> CommonDenominator {
        let denominator = common_denominator(rows.iter().flatten());
        let scale =
            |value: &Rational| value.numerator() * denominator.div_floor(&value.denominator());
        let numerators = rows.iter().map(|row| row.iter().map(scale).collect()).collect();
        CommonDenominator { denominator, numerators }
    }
}
