//! Whether two values are related as a sign says.

use crate::claim::{Comparison, Sign};
use crate::diagnostic::Diagnostic;
use crate::exact::{
    Decimal, Polynomial, Rational, RealCyclotomic, Rounding, Scalar as _, parse_printed,
};
use crate::finding::SideValue;
use crate::formula::{LocatedFormula, RealValue, Value as _};
use std::cmp::Ordering;

/// Whether the values of the sides are related as the comparison says.
///
/// # Errors
/// When the sign is that of numbers and a side has symbols in it, a formula that states something by itself is neither 0 nor
/// 1, or neither side of `≈` is a printed number.
pub(crate) fn holds(
    comparison: &Comparison,
    (printed, texts): Left<'_>,
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
            let (decimal, exact) = printed_side(comparison, (printed, texts), (&left, &right))?;
            is_near(&decimal, decimal.rounding_of(exact))
        }
        Sign::True | Sign::False => {
            let value = number(printed, left)?;
            let [zero, one] = [Rational::zero(), Rational::one()].map(RealCyclotomic::from);
            if value != zero && value != one {
                return Err(states_nothing(printed, &value));
            }
            (value == one) == (comparison.sign == Sign::True)
        }
    })
}

/// The error of a formula that states nothing by itself.
pub(crate) fn states_nothing(
    formula: &LocatedFormula,
    value: &dyn std::fmt::Display,
) -> Diagnostic {
    let message = format!("this states nothing by itself: it is {value}, and neither 0 nor 1");
    Diagnostic::new(&formula.source, formula.span.clone(), message)
        .with_help("compare it with something: `= 3`, `< 1/2`, `in {1, 2}`")
}

/// A left side, and what is printed for the indices of the case.
pub(crate) type Left<'a> = (&'a LocatedFormula, &'a [(String, String)]);

/// The printed number that a formula is, or that it names as an index, if it is one.
fn decimal(formula: &LocatedFormula, texts: &[(String, String)]) -> Option<Decimal> {
    let named = texts.iter().find(|(name, _)| *name == formula.text.trim());
    parse_printed(named.map_or(&formula.text, |(_, text)| text)).ok()
}

/// Whether the sides are related as the comparison says; `None` where bounds of their values do not decide it.
///
/// # Errors
/// As [`holds`].
pub(crate) fn decided(
    comparison: &Comparison,
    (printed, texts): Left<'_>,
    left: &SideValue,
    rights: &[SideValue],
) -> Result<Option<bool>, Diagnostic> {
    let polynomial = |side: &SideValue| match side {
        SideValue::Polynomial(value) => Some(value.clone()),
        SideValue::Real(_) => None,
    };
    let polynomials: Option<Vec<Polynomial>> = rights.iter().map(polynomial).collect();
    if let (Some(left), Some(rights)) = (polynomial(left), polynomials) {
        return holds(comparison, (printed, texts), &left, &rights).map(Some);
    }
    let number = |formula: &LocatedFormula, side: &SideValue| {
        side.real().ok_or_else(|| {
            let message = format!("a real number is compared with {side}, which has symbols in it");
            Diagnostic::new(&formula.source, formula.span.clone(), message)
        })
    };
    let left = number(printed, left)?;
    let rights = comparison.rights.iter().zip(rights).map(|(text, side)| number(text, side));
    let rights = rights.collect::<Result<Vec<RealValue>, Diagnostic>>()?;
    let right = &rights[0];
    let whole = |n: i64| RealValue::from_rational(&Rational::from(n));
    let equal = |right: &RealValue| left.compare(right).map(Ordering::is_eq);
    Ok(match comparison.sign {
        Sign::True | Sign::False
            if [0, 1].iter().all(|n| left.compare(&whole(*n)).is_some_and(Ordering::is_ne)) =>
        {
            return Err(states_nothing(printed, &left));
        }
        Sign::Equal | Sign::True | Sign::False => equal(right),
        Sign::Unequal => equal(right).map(|equal| !equal),
        Sign::AtMost => left.is_at_most(right),
        Sign::AtLeast => right.is_at_most(&left),
        Sign::Less => right.is_at_most(&left).map(|at_least| !at_least),
        Sign::Greater => left.is_at_most(right).map(|at_most| !at_most),
        Sign::OneOf => {
            let found: Vec<Option<bool>> = rights.iter().map(equal).collect();
            let open = found.contains(&None);
            let any = found.contains(&Some(true));
            (any || !open).then_some(any)
        }
        Sign::Near => {
            let (decimal, value) = printed_side(comparison, (printed, texts), (&left, right))?;
            near(&decimal, value)
        }
    })
}

/// Whether a printed number is a rounding of a value; `None` where its bounds do not decide it.
fn near(decimal: &Decimal, value: &RealValue) -> Option<bool> {
    if let Some(value) = value.as_rational() {
        return Some(is_near(decimal, decimal.rounding_of(&value)));
    }
    let bounds = value.interval();
    let [low, high] =
        [bounds.lower(), bounds.upper()].map(|end| is_near(decimal, decimal.rounding_of(end)));
    let shown = decimal.value();
    // The numbers that may be rounded to this one are an interval. Both bounds may be outside of it, on different sides.
    let apart = *bounds.lower() > shown || *bounds.upper() < shown;
    (low == high && (low || apart)).then_some(low)
}

/// Whether a decimal counts as a rounding.
fn is_near(decimal: &Decimal, rounding: Rounding) -> bool {
    match rounding {
        Rounding::Exact | Rounding::Nearest | Rounding::Up => true,
        // Of a value that is cut some digit is left: 0 is no 0.857.
        Rounding::Cut => decimal.significant_digits() > 0,
        Rounding::Neither => false,
    }
}

/// The printed number of `≈`, and the value of the other side. The right one counts if both are printed.
///
/// # Errors
/// When neither side is a printed number.
fn printed_side<'v, T>(
    comparison: &Comparison,
    (printed, texts): Left<'_>,
    (left, right): (&'v T, &'v T),
) -> Result<(Decimal, &'v T), Diagnostic> {
    let fraction = |formula: &LocatedFormula| formula.text.contains(['/', '⁄', '∕']);
    let both = (decimal(comparison.right(), texts), decimal(printed, texts));
    // 2/3 beside 0.67 is the value.
    let both = match both {
        (Some(_), Some(left)) if fraction(comparison.right()) && !fraction(printed) => {
            (None, Some(left))
        }
        both => both,
    };
    match both {
        (Some(decimal), _) => Ok((decimal, left)),
        (None, Some(decimal)) => Ok((decimal, right)),
        (None, None) => {
            let message = "one side of `~` is a printed number, such as 0.742";
            Err(Diagnostic::new(&printed.source, printed.span.clone(), message)
                .with_help("write `=` between formulas"))
        }
    }
}
