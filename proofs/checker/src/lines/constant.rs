//! The rule `constant`: T_c or Λ_c of a scheme with too many residue classes for the functions
//! of formulas.

use crate::claims::Paper;
use crate::numbers::{Q, Value, int, read_rational};
use crate::schemes::{Operator, PLACES, Sequence};
use crate::text::{Block, Checked, Reason, compare, require, words};
use num_traits::Signed;

/// The words of the line.
const EXPECTED: &str = "SCHEME FUNCTION ORDER C CLASS VALUE";

/// The most levels.
const MAX_LEVELS: u32 = 256;

/// Checks `SCHEME FUNCTION ORDER C CLASS VALUE` and `powers …`, and makes the constant known.
pub fn check<'a>(paper: &'a Paper<'a>, said: &str, block: &mut Block<'_>) -> Checked<()> {
    let malformed = || Reason::Malformed(EXPECTED);
    let [reference, function, order, c, class, value] = words(said, EXPECTED)?;
    let schemes = paper.library.resolve(reference, &paper.library.closed())?;
    let [scheme] = &schemes[..] else { return Err(malformed().into()) };
    let rules = match function {
        "contraction" => &scheme.difference,
        "norm" => &scheme.mask,
        _ => return Err(malformed().into()),
    };
    let forward = order == "forward";
    require(forward || order == "adjoint", malformed())?;
    let levels = c.parse().ok().filter(|c| (1..=MAX_LEVELS).contains(c)).ok_or(malformed())?;
    let class = class.parse().map_err(|_| malformed())?;
    let exact = read_rational(value).ok_or(malformed())?;
    // The sequence that is read forwards belongs to the reversed rules.
    let mut rational = Value::rationals(rules).ok_or(Reason::Malformed("rational masks"))?;
    if forward {
        for rule in &mut rational {
            rule.reverse();
        }
    }
    let operator = Operator::new(paper.library.meter, &rational)?;
    let sum = operator.of_class(levels, &class)?;
    compare(sum == exact, &exact, &sum, Reason::Class)?;
    let said = block.after("powers")?;
    let all = said.strip_prefix("all ");
    // The numbers are rounded upwards, so that they are short.
    let number = |text: &str| {
        let number = read_rational(text).filter(|number| !number.is_negative())?;
        Some((number * int(1 << PLACES)).ceil() / int(1 << PLACES))
    };
    let numbers: Option<Vec<Q>> = all.unwrap_or(said).split_whitespace().map(number).collect();
    let numbers = numbers.ok_or(Reason::Malformed("powers all NUMBER, or powers NUMBER…"))?;
    let expected = all.map_or(levels as usize - 1, |_| 1);
    require(numbers.len() == expected, Reason::Malformed("one number, or C − 1"))?;
    let tau = |m: u32| match (m, all) {
        (0, _) => int(1),
        (_, Some(_)) => numbers[0].clone(),
        (_, None) => numbers[m as usize - 1].clone(),
    };
    match all {
        Some(_) => operator.all_at_most(&numbers[0])?,
        None => (1..levels).try_for_each(|m| operator.at_most(m, &tau(m), tau))?,
    }
    let limit = &exact / operator.factor.abs().pow(levels.cast_signed());
    operator.at_most(levels, &limit, tau)?;
    paper.library.products.show(Sequence { rules, forward }, levels, exact.into());
    Ok(())
}
