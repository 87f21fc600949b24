//! A refutation as one checks it with paper and pencil.

use crate::audit::{
    ByHand, Control, HandConstant, LeftOut, Place, Refutation, TheoremFinding, Violation,
};
use crate::claim::{Quantity, Statement};
use crate::exact::Rational;
use crate::limit::{Combination, LimitWeights};
use crate::report::words::data::{control, value_name};
use crate::report::words::numbers::exact;
use crate::scheme::Mask;

/// The scheme, the data, the refined points, the limit, and both sides, in the order in which one
/// checks them.
pub(crate) fn facts(
    finding: &TheoremFinding<'_>,
    refutation: &Refutation,
    hand: &ByHand,
    fact: &mut impl FnMut(&str, String),
) {
    let violation = &refutation.violation;
    for mask in hand.refiner.masks() {
        fact("mask", rules(mask));
    }
    for constant in &hand.constants {
        fact(&constant.name, value_of(constant));
    }
    let beyond = match violation.attained.control {
        Control::Polygon(_) => ", constant beyond",
        Control::Net { .. } | Control::Points(_) => "",
    };
    fact("control data", format!("{}{beyond}", control(&violation.attained.control)));
    for (level, points) in &hand.refined {
        let point = |(i, point): &(i64, Rational)| format!("x_{i} = {point}");
        let points: Vec<String> = points.iter().map(point).collect();
        fact(&format!("points of level {level}"), points.join(", "));
    }
    if let (Some(weights), Some(_)) = (&hand.weights, &hand.sides) {
        fact("limit at 0", limit(weights, hand.contraction.as_ref()));
    }
    if !refutation.limit.is_empty() {
        let weights = refutation.limit.iter().map(ToString::to_string).collect::<Vec<_>>();
        fact("weights of the limit", format!("{}, in the order of the points", weights.join(", ")));
    }
    let value = exact(&violation.attained.value);
    match &hand.sides {
        Some(sides) => {
            for (name, side) in names(violation).iter().zip(sides) {
                fact(name, combination(side));
            }
            let [first, second] = sides.each_ref().map(|side| parenthesised(&side.value));
            fact(&value_name(violation), format!("|{first} − {second}| = {value}"));
        }
        None => fact(&value_name(violation), value),
    }
    if let Some(left_out) = hand.left_out {
        fact("left out here", words(left_out).to_owned());
    }
    let bound = exact(&violation.bound);
    let with = if hand.bound == violation.bound.to_string() {
        bound
    } else if matches!(finding.theorem.statement, Statement::Depth(_)) {
        format!("{bound}, from level {} on", hand.bound)
    } else {
        format!("{} = {bound}", hand.bound)
    };
    fact("claimed at most", with);
    fact("but", format!("{} > {}", violation.attained.value, violation.bound));
}

/// `α = 0: 1/4, 3/4; α = 1: …; offset 0`.
fn rules(mask: &Mask) -> String {
    let row = |(alpha, row): (usize, &Vec<Rational>)| format!("α = {alpha}: {}", list(row));
    let mut lines: Vec<String> = mask.rules().rows().iter().enumerate().map(row).collect();
    let (n, o) = (mask.arity(), mask.offset());
    let (sign, size) = if o < 0 { ('−', o.unsigned_abs()) } else { ('+', o.unsigned_abs()) };
    let shift = if o == 0 { String::new() } else { format!("{sign}{size}") };
    lines.push(format!("x'_{{{n}i+α}} = Σ_j a_{{α,j}} x_{{i{shift}+j}}, offset {o}"));
    lines.join("\n")
}

fn list(numbers: &[Rational]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<String>>().join(", ")
}

/// The value of a constant, and the cell that prints it. Its definition stands with the statement.
fn value_of(HandConstant { value, cell, .. }: &HandConstant) -> String {
    let printed = cell.as_ref().map(|cell| {
        format!("; the paper prints {} in {} ({}), confirmed", cell.printed, cell.locus, cell.id)
    });
    format!("{}{}", exact(value), printed.unwrap_or_default())
}

/// The weights, and what shows that they are those of the limit.
fn limit(weights: &LimitWeights, contraction: Option<&(u32, Rational)>) -> String {
    let LimitWeights { weights, rules } = weights;
    let letters = weights.iter().map(|(p, weight)| (*p, weight.clone())).collect::<Vec<_>>();
    let mut lines = vec![format!("{} for all points x, since", sum(&letters, ""))];
    for ((p, _), rule) in weights.iter().zip(rules) {
        lines.push(format!("x'_{p} = {}", sum(rule, "")));
    }
    let refined = sum(&letters, "'");
    lines.push(format!("{refined} is the same number, and these weights sum to 1"));
    if let Some((c, norm)) = contraction {
        lines.push(format!("the points converge: T_{c} = {norm} < 1"));
    }
    lines.join("\n")
}

/// `1/6 x_-1 + 2/3 x_0`, with a mark behind each x, such as the prime of x'.
fn sum(terms: &[(i64, Rational)], mark: &str) -> String {
    let term = |(place, (i, coefficient)): (usize, &(i64, Rational))| {
        let (sign, size) = (coefficient.sign(), coefficient.abs());
        let joint = match (place == 0, sign < 0) {
            (true, true) => "−",
            (true, false) => "",
            (false, true) => " − ",
            (false, false) => " + ",
        };
        let factor = if size == Rational::one() { String::new() } else { format!("{size} ") };
        format!("{joint}{factor}x{mark}_{i}")
    };
    terms.iter().enumerate().map(term).collect()
}

/// `1/6 x_-1 + 2/3 x_0 of level 1 = 1/6·0 + 2/3·1 = 2/3`.
fn combination(side: &Combination) -> String {
    let terms: Vec<(i64, Rational)> =
        side.terms.iter().map(|(i, coefficient, _)| (*i, coefficient.clone())).collect();
    let numbers = side.terms.iter().map(|(_, coefficient, point)| {
        format!("{}·{}", parenthesised(coefficient), parenthesised(point))
    });
    let numbers: Vec<String> = numbers.collect();
    let single = terms.len() == 1 && side.terms[0].1 == Rational::one();
    let put_in = if single { String::new() } else { format!("{} = ", numbers.join(" + ")) };
    format!("{} of level {} = {put_in}{}", sum(&terms, ""), side.level, side.value)
}

fn parenthesised(number: &Rational) -> String {
    if number.sign() < 0 { format!("({number})") } else { number.to_string() }
}

/// The names of the two values whose difference is bounded.
fn names(violation: &Violation) -> [String; 2] {
    let k = violation.level;
    match (&violation.attained.place, violation.quantity) {
        (Place::Parameter(t), Quantity::Distance) => [format!("P^∞({t})"), format!("P^{k}({t})")],
        (Place::Point(i), _) => {
            [format!("x_{i} of level {}", k + 1), format!("P^{k} at its place")]
        }
        (Place::Difference(i), _) => {
            [format!("x_{} of level {k}", i + 1), format!("x_{i} of level {k}")]
        }
        _ => ["first value".to_owned(), "second value".to_owned()],
    }
}

fn words(left_out: LeftOut) -> &'static str {
    match left_out {
        LeftOut::Net => "the refined points of the net, and the weights of its limit",
        LeftOut::Ring => {
            "the refined points of the ring: they are those of its weights at the data"
        }
        LeftOut::Points => "the refined points and the weights of the limit: they are many",
    }
}
