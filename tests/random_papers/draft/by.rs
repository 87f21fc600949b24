//! Bounds that are true, or false by little or late.

use super::shape::{Instance, Shape};
use crate::random_papers::choices::Choices;
use crate::random_papers::formula::{Tree, call, name, number, of, times};
use crate::random_papers::naive::{Curve, LocalRules, Net, Q};
use num_traits::{One, Zero};

/// The greatest value of a quantity at a level, at least, and of the differences after one level.
fn greatest(instance: &Instance, quantity: &str, level: u32, offset: Option<i64>) -> (Q, Q) {
    let of_curve = |curve: &Curve| {
        let curve = curve.with_offset(offset);
        let value = match quantity {
            "difference" => curve.greatest_difference(level),
            "step" => curve.greatest_step(level),
            _ => curve.farthest(level, level + 3),
        };
        (value, curve.greatest_difference(1))
    };
    match &instance.shape {
        Shape::Curve(curve) => of_curve(curve),
        Shape::Net(Net(pair)) => {
            let [one, other] = pair;
            // Differences along one index fall by T_c of it, and grow by Λ_c of the other.
            let fall = |level| {
                let along = one.greatest_difference(level) * other.norm(level);
                along.max(other.greatest_difference(level) * one.norm(level))
            };
            let value = match quantity {
                "difference" => fall(level),
                _ => of_curve(one).0 + of_curve(other).0,
            };
            (value, fall(1))
        }
        Shape::LocalRules(ring, earlier) => {
            let heights = ring.heights();
            let rows = if quantity == "difference" {
                ring.differences(level)
            } else {
                ring.steps(level, earlier.as_ref())
            };
            (
                LocalRules::greatest(&rows, &heights),
                LocalRules::greatest(&ring.differences(1), &heights),
            )
        }
    }
}

pub fn depth(choices: &mut Choices) -> Tree {
    let epsilon = name("epsilon");
    let choice = [
        of('-', number(4, 1), call("floor", &[times(epsilon.clone(), number(20, 1))])),
        call("floor", &[of('/', number(1, 4), epsilon.clone())]),
        number(2, 1),
        of('+', number(1, 1), call("kronecker", &[epsilon, number(1, 4)])),
    ];
    choices.of(&choice)
}

/// A bound that is true, or false by little, at the first level.
pub fn by(
    choices: &mut Choices,
    instance: &Instance,
    quantity: &str,
    from: u32,
    offset: Option<i64>,
) -> Tree {
    let ring = matches!(instance.shape, Shape::LocalRules(..));
    let spread = match &instance.shape {
        Shape::Net(_) if choices.once_in(2) => choices.of(&[
            name("beta_1"),
            name("beta_2"),
            name("beta_3"),
            of('/', of('+', name("beta_1"), name("beta_2")), number(2, 1)),
        ]),
        _ => name("beta"),
    };
    let (value, fall) = greatest(instance, quantity, from, offset);
    // Now and then one that is true for long, and false in the end.
    let late = choices.once_in(4);
    let factors = [(1, 1), (9, 10), (11, 10), (4, 1), (50, 1), (1000, 1)];
    let factors = factors.map(|(p, q): (i64, i64)| Q::new(p.into(), q.into()));
    let mut value = value * choices.of(&factors[if late { 4..6 } else { 0..6 }]);
    if value.is_zero() && choices.once_in(2) {
        value = Q::one();
    }
    let level = name("k");
    let after =
        if from == 0 { level.clone() } else { of('-', level.clone(), number(from.into(), 1)) };
    let less = Tree::Number(&fall * choices.of(&factors[..2]) * Q::new(4.into(), 5.into()));
    let fall = Tree::Number(fall);
    let named = if ring { fall.clone() } else { choices.of(&[name("T"), name("rate")]) };
    let ratios =
        [fall.clone(), fall, named, less.clone(), number(1, 2), number(3, 4), number(1, 1)];
    let ratio = if late { less } else { choices.of(&ratios) };
    let plain = || {
        times(
            times(Tree::Number(value.clone()), spread.clone()),
            of('^', ratio.clone(), after.clone()),
        )
    };
    let half = call("floor", &[of('/', after.clone(), number(2, 1))]);
    match choices.below(if ring { 7 } else { 11 }) {
        0 | 1 => plain(),
        _ if late => plain(),
        4 if quantity == "distance" => plain(),
        2 => times(spread.clone(), of('^', ratio.clone(), after.clone())),
        3 => times(
            times(Tree::Number(value.clone()), spread.clone()),
            of('^', times(ratio.clone(), ratio.clone()), half),
        ),
        4 => of(
            '-',
            plain(),
            times(
                spread.clone(),
                of('/', call("kronecker", &[level, number(i64::from(from) + 4, 1)]), number(2, 1)),
            ),
        ),
        5 => Tree::Minus(Box::new(times(of('-', number(0, 1), plain()), number(1, 1)))),
        6 => of(
            '/',
            plain(),
            of('^', number(choices.of(&[1, 2]), 1), call("abs", &[of('-', level, number(5, 1))])),
        ),
        7 => choices.of(&[name("bound"), name("series")]),
        8 => times(times(Tree::Number(value), spread), name("power")),
        9 => {
            let ends = Box::new([number(0, 1), choices.of(&[number(2, 1), level]), name("term")]);
            times(times(Tree::Number(value), spread), Tree::Sum("h".to_owned(), ends))
        }
        _ => times(times(name("mixed"), spread), of('^', name("rate"), after)),
    }
}
