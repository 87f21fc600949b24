//! Rule `constant`: T_c or Λ_c of a scheme, where there are too many residue classes for the
//! functions of formulas.

use crate::certificate::Block;
use crate::convolution::Large;
use crate::decimal::{Q, read_rational};
use crate::paper::Paper;
use crate::powers::Operator;
use crate::reject::{Checked, Reason, require};
use crate::value::Value;
use num_traits::Signed;

/// The most levels.
const MAX_LEVELS: u32 = 256;

/// Checks `SCHEME FUNCTION ORDER C CLASS VALUE` and `powers …`, and makes the constant known.
pub fn check<'a>(paper: &'a Paper<'a>, said: &str, block: &mut Block<'_>) -> Checked<()> {
    let malformed = || Reason::Malformed("SCHEME FUNCTION ORDER C CLASS VALUE");
    let words: Vec<&str> = said.split_whitespace().collect();
    let [reference, function, order, c, class, value] = words[..] else {
        return Err(malformed().into());
    };
    let schemes = paper.library.resolve(reference, &paper.nothing())?;
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
    // Read forwards, the sequence is that of the rules turned round.
    let rational = |rule: &Vec<Value>| {
        let mut rule: Vec<Q> = rule.iter().map(Value::rational).collect::<Option<_>>()?;
        if forward {
            rule.reverse();
        }
        Some(rule)
    };
    let rational = rules.iter().map(rational).collect::<Option<Vec<Vec<Q>>>>();
    let rational = rational.ok_or(Reason::Malformed("rational masks"))?;
    let operator = Operator::new(paper.library, &rational)?;
    require(operator.of_class(levels, &class)? == exact, Reason::Class)?;
    let powers = block.after("powers")?;
    let number = |text: &str| read_rational(text).filter(|number| !number.is_negative());
    let numbers: Option<Vec<Q>> = match powers.strip_prefix("all ") {
        Some(tau) => number(tau).map(|tau| vec![tau]),
        None => powers.split_whitespace().map(number).collect(),
    };
    let numbers = numbers.ok_or(Reason::Malformed("powers all NUMBER, or powers NUMBER…"))?;
    if powers.starts_with("all ") {
        operator.all_at_most(&numbers[0])?;
    } else {
        require(numbers.len() + 1 == levels as usize, Reason::Malformed("c − 1 numbers"))?;
    }
    let tau = |m: u32| match m.checked_sub(1) {
        None => crate::decimal::int(1),
        Some(at) => numbers.get(at as usize).unwrap_or(&numbers[0]).clone(),
    };
    if !powers.starts_with("all ") {
        for m in 1..levels {
            operator.at_most(m, &tau(m), tau)?;
        }
    }
    let limit = &exact / operator.factor.abs().pow(levels.cast_signed());
    operator.at_most(levels, &limit, tau)?;
    let key: Large = (rules.clone(), forward, levels);
    paper.library.large.borrow_mut().insert(key, exact.into());
    Ok(())
}
