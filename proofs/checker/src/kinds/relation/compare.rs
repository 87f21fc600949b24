//! Whether a comparison is true of numbers.

use super::states::{Comparison, Rest, Sign};
use crate::formulas::Scope;
use crate::numbers::{Decimal, Value, rounding};
use crate::text::Stop;
use num_traits::Zero as _;
use std::cmp::Ordering;

/// Whether a comparison is false, and left − right.
pub fn judged(comparison: &Comparison, scope: &Scope<'_>) -> Result<(bool, Value), Stop> {
    let left = scope.value(&comparison.left.expr)?;
    match &comparison.rest {
        Rest::Sign(sign, right) => {
            let printed = (&comparison.left.printed, &right.printed);
            let right = scope.value(&right.expr)?;
            let difference = left.minus(&right)?;
            let holds = match sign {
                Sign::Equal => difference.is_zero(),
                Sign::Near => near(printed, (&left, &right))?,
                _ => fits(*sign, left.number()?.compare(right.number()?)?),
            };
            Ok((!holds, difference))
        }
        Rest::Member(members) => {
            let members = members.iter().map(|member| scope.value(member));
            let members = members.collect::<Result<Vec<Value>, Stop>>()?;
            for value in members.iter().chain([&left]) {
                value.number()?;
            }
            let off = members.iter().map(|member| left.minus(member));
            let off = off.collect::<Result<Vec<Value>, Stop>>()?;
            Ok((off.iter().all(|off| !off.is_zero()), off.into_iter().next().unwrap_or(left)))
        }
        Rest::Is(one) => {
            let is = left.number()?.integer();
            if !matches!(is, Some(0 | 1)) {
                return Err(Stop::Wrong("a formula without a sign is 0 or 1".into()));
            }
            let difference = if *one { left.minus(&Value::int(1))? } else { left };
            Ok((!difference.is_zero(), difference))
        }
    }
}

/// Whether this order of two sides fits a sign that is not ≈.
pub fn fits(sign: Sign, order: Ordering) -> bool {
    match sign {
        Sign::Equal => order.is_eq(),
        Sign::Less => order.is_lt(),
        Sign::AtMost => order.is_le(),
        Sign::Greater => order.is_gt(),
        Sign::AtLeast => order.is_ge(),
        Sign::Unequal | Sign::Near => order.is_ne(),
    }
}

/// Whether a printed side is what the other one may be rounded to. The right one counts if both are printed.
fn near(
    printed: (&Option<Decimal>, &Option<Decimal>),
    (left, right): (&Value, &Value),
) -> Result<bool, Stop> {
    let (decimal, value) = match printed {
        (_, Some(right)) => (right, left),
        (Some(left), None) => (left, right),
        (None, None) => {
            return Err(Stop::Wrong("no side of ≈ is a printed number".into()));
        }
    };
    value.number()?;
    let found = rounding(decimal, value)?;
    // Of a value that is cut some digit is left: 0 is no 0.857.
    Ok(found != "neither" && !(found == "cut" && decimal.value.is_zero()))
}
