//! Whether a comparison is true of numbers.

use super::states::{Comparison, Rest, Side, Sign};
use crate::formulas::{Expr, Head, Scope};
use crate::numbers::{Decimal, Number, Q, Value, rounding};
use crate::reals::{Pair, pair};
use crate::schemes::Library;
use crate::text::Stop;
use num_traits::{Signed as _, Zero as _};
use std::cmp::Ordering;

/// Whether a comparison is false, and left − right. On a piece of the scope, it is a comparison of polynomials.
pub fn judged(comparison: &Comparison, scope: &Scope<'_>) -> Result<(bool, Value), Stop> {
    let piece = scope.piece.as_ref();
    let left = scope.value(&comparison.left.expr)?;
    match &comparison.rest {
        Rest::Sign(sign, right) => {
            let printed = (&comparison.left.printed, &right.printed);
            let right = scope.value(&right.expr)?;
            let difference = left.minus(&right)?;
            let holds = match (sign, piece) {
                (Sign::Equal, _) => difference.is_zero_on(piece)?,
                (Sign::Near, _) => near(printed, (&left, &right))?,
                (_, None) => fits(*sign, left.number()?.compare(right.number()?)?),
                (_, Some(_)) => fits(*sign, difference.sign(piece)?.cmp(&0)),
            };
            Ok((!holds, difference))
        }
        Rest::Member(members) => {
            let members = members.iter().map(|member| scope.value(member));
            let members = members.collect::<Result<Vec<Value>, Stop>>()?;
            if piece.is_none() {
                for value in members.iter().chain([&left]) {
                    value.number()?;
                }
            }
            let off = members.iter().map(|member| left.minus(member));
            let off = off.collect::<Result<Vec<Value>, Stop>>()?;
            let mut equal = off.iter().map(|off| off.is_zero_on(piece));
            let any = equal.try_fold(false, |any, equal| Ok::<_, Stop>(any || equal?))?;
            Ok((!any, off.into_iter().next().unwrap_or(left)))
        }
        Rest::Is(one) => {
            if piece.is_none() {
                left.number()?;
            }
            let less = left.minus(&Value::int(1))?;
            let zero = left.is_zero_on(piece)?;
            if !zero && !less.is_zero_on(piece)? {
                return Err(Stop::Wrong("a formula without a sign is 0 or 1".into()));
            }
            Ok((zero == *one, if *one { less } else { left }))
        }
    }
}

/// What is known of a comparison of real numbers.
pub struct Judged {
    /// Whether it is false; `None` if bounds do not decide it.
    pub fails: Option<bool>,
    /// Bounds of left − right.
    pub difference: [Q; 2],
    /// left − right, if it is known to be a number of a field Q(2cos(2π/n)).
    pub number: Option<Number>,
}

/// The same of real numbers of any kind.
pub fn judged_reals(
    library: &Library<'_>,
    comparison: &Comparison,
    scope: &Scope<'_>,
) -> Result<Judged, Stop> {
    let left = &comparison.left;
    let compared = |right: &Expr| pair(library, scope, (&left.expr, right));
    match &comparison.rest {
        Rest::Sign(sign, right) => {
            let pair = compared(&right.expr)?;
            let holds = match sign {
                Sign::Near => near_reals(left, right, &pair)?,
                _ => ordered(*sign, &pair),
            };
            Ok(Judged {
                fails: holds.map(|holds| !holds),
                difference: pair.difference,
                number: pair.number,
            })
        }
        Rest::Member(members) => {
            let pairs = members.iter().map(compared).collect::<Result<Vec<Pair>, Stop>>()?;
            let any = pairs.iter().any(|pair| pair.order == Some(Ordering::Equal));
            let open = pairs.iter().any(|pair| pair.order.is_none());
            let first = pairs.into_iter().next();
            let first = first.ok_or_else(|| Stop::Wrong("a set has no members".into()))?;
            let fails = (any || !open).then_some(!any);
            Ok(Judged { fails, difference: first.difference, number: first.number })
        }
        Rest::Is(one) => {
            let [zero, unit] = [0, 1].map(|value| Expr::Number(Value::int(value)));
            let (zero, unit) = (compared(&zero)?, compared(&unit)?);
            let is = match (zero.order, unit.order) {
                (Some(Ordering::Equal), _) => false,
                (_, Some(Ordering::Equal)) => true,
                (None, _) | (_, None) => return Err(Stop::Undecided("whether a number is 0 or 1")),
                _ => return Err(Stop::Wrong("a formula without a sign is 0 or 1".into())),
            };
            let off = if *one { unit } else { zero };
            Ok(Judged { fails: Some(is != *one), difference: off.difference, number: off.number })
        }
    }
}

/// Notes that left − right is this number, if it is. It may be one of a field although a root of a polynomial does not show which.
pub fn found_as(
    library: &Library<'_>,
    comparison: &Comparison,
    scope: &Scope<'_>,
    said: &Value,
    found: &mut Judged,
) -> Result<(), Stop> {
    let right = match &comparison.rest {
        Rest::Sign(_, right) => right.expr.clone(),
        Rest::Member(members) => match members.first() {
            Some(first) => first.clone(),
            None => return Ok(()),
        },
        Rest::Is(one) => Expr::Number(Value::int(i64::from(*one))),
    };
    let sides = vec![comparison.left.expr.clone(), right];
    let difference = Expr::Of(Head::Chain(vec!['-']), sides);
    match pair(library, scope, (&difference, &Expr::Number(said.clone())))?.order {
        Some(Ordering::Equal) => found.number = Some(said.number()?.clone()),
        Some(_) => {}
        None => return Err(Stop::Undecided("whether a difference is a number")),
    }
    Ok(())
}

/// Whether a pair fits a sign that is not ≈. Bounds that meet at one end decide ≤ and ≥.
fn ordered(sign: Sign, pair: &Pair) -> Option<bool> {
    if let Some(order) = pair.order {
        return Some(fits(sign, order));
    }
    let [low, high] = &pair.difference;
    match sign {
        Sign::AtMost if !high.is_positive() => Some(true),
        Sign::Greater if !high.is_positive() => Some(false),
        Sign::AtLeast if !low.is_negative() => Some(true),
        Sign::Less if !low.is_negative() => Some(false),
        _ => None,
    }
}

/// Whether a printed side is what the other one may be rounded to: both bounds, or neither on one side of it.
fn near_reals(left: &Side, right: &Side, pair: &Pair) -> Result<Option<bool>, Stop> {
    let (decimal, value) =
        printed_side((&left.printed, &right.printed), (&pair.left, &pair.right))?;
    let [low, high] = value.ends();
    let is_near = |end: &Q| is_near(decimal, &Value::from(end.clone()));
    let (below, above) = (is_near(&low)?, is_near(&high)?);
    let apart = low > decimal.value || high < decimal.value;
    Ok((below == above && (below || apart)).then_some(below))
}

/// The printed side, and the value of the other one. The right one counts if both are printed, but for a fraction beside a decimal.
fn printed_side<'p, T>(
    printed: (&'p Option<Decimal>, &'p Option<Decimal>),
    (left, right): (&'p T, &'p T),
) -> Result<(&'p Decimal, &'p T), Stop> {
    match printed {
        (Some(one), Some(other)) if other.unit.is_zero() && !one.unit.is_zero() => Ok((one, right)),
        (_, Some(other)) => Ok((other, left)),
        (Some(one), None) => Ok((one, right)),
        (None, None) => Err(Stop::Wrong("no side of ≈ is a printed number".into())),
    }
}

fn is_near(decimal: &Decimal, value: &Value) -> Result<bool, Stop> {
    let found = rounding(decimal, value)?;
    // Of a value that is cut some digit is left: 0 is no 0.857.
    Ok(found != "neither" && !(found == "cut" && decimal.value.is_zero()))
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

/// Whether a printed side is what the other one may be rounded to.
fn near(
    printed: (&Option<Decimal>, &Option<Decimal>),
    values: (&Value, &Value),
) -> Result<bool, Stop> {
    let (decimal, value) = printed_side(printed, values)?;
    value.number()?;
    is_near(decimal, value)
}
