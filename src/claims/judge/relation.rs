//! Whether two values are related as a sign says.

use crate::claim::{Comparison, Sign};
use crate::diagnostic::Diagnostic;
use crate::exact::{Decimal, Polynomial, Rational, RealCyclotomic, Rounding, parse_printed};
use crate::formula::{LocatedFormula, Value as _};

/// Whether the values of the sides are related as the comparison says.
///
/// # Errors
/// When the sign is that of numbers and a side has symbols in it, a formula that states something by itself is neither 0 nor
/// 1, or neither side of `≈` is a printed number.
pub(crate) fn holds(
    comparison: &Comparison,
    printed: &LocatedFormula,
    left: &Polynomial,
    rights: &[Polynomial],
) -> Result<bool, Diagnostic> {
    let number = |formula: &LocatedFormula, value: &Polynomial| {
        value.number().ok_or_else(|| {
            let message =
                format!("{} is stated of numbers, and this is {value}", comparison.sign.mark());
            Diagnostic::new(&formula.source, formula.span.clone(), message).with_help(
                "only `=` compares polynomials in symbols; give the symbols values by `for`",
            )
        })
    };
    let sides = || -> Result<(RealCyclotomic, RealCyclotomic), Diagnostic> {
        Ok((number(printed, left)?, number(comparison.right(), &rights[0])?))
    };
    Ok(match comparison.sign {
        Sign::Equal => *left == rights[0],
        Sign::Unequal => sides().map(|(left, right)| left != right)?,
        Sign::Less => sides().map(|(left, right)| left < right)?,
        Sign::AtMost => sides().map(|(left, right)| left <= right)?,
        Sign::Greater => sides().map(|(left, right)| left > right)?,
        Sign::AtLeast => sides().map(|(left, right)| left >= right)?,
        Sign::OneOf => {
            let left = number(printed, left)?;
            let mut equal = false;
            for (formula, right) in comparison.rights.iter().zip(rights) {
                equal |= number(formula, right)? == left;
            }
            equal
        }
        Sign::Near => {
            let (left, right) = sides()?;
            let (decimal, exact) = match (decimal(comparison.right()), decimal(printed)) {
                (Some(decimal), _) => (decimal, left),
                (None, Some(decimal)) => (decimal, right),
                (None, None) => {
                    let message = "one side of `~` is a printed number, such as 0.742";
                    return Err(Diagnostic::new(&printed.source, printed.span.clone(), message)
                        .with_help("write `=` between formulas"));
                }
            };
            match decimal.rounding_of(&exact) {
                Rounding::Exact | Rounding::Nearest | Rounding::Up => true,
                // Of a value that is cut some digit is left: 0 is no 0.857.
                Rounding::Cut => decimal.significant_digits() > 0,
                Rounding::Neither => false,
            }
        }
        Sign::True | Sign::False => {
            let value = number(printed, left)?;
            let [zero, one] = [Rational::zero(), Rational::one()].map(RealCyclotomic::from);
            if value != zero && value != one {
                let message =
                    format!("this states nothing by itself: it is {value}, and neither 0 nor 1");
                return Err(Diagnostic::new(&printed.source, printed.span.clone(), message)
                    .with_help("compare it with something: `= 3`, `< 1/2`, `in {1, 2}`"));
            }
            (value == one) == (comparison.sign == Sign::True)
        }
    })
}

/// The printed number that a formula is, if it is one.
fn decimal(formula: &LocatedFormula) -> Option<Decimal> {
    parse_printed(&formula.text).ok()
}
