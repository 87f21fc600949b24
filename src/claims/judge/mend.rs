//! The search for a change of one symbol that mends a failing identity.

use crate::claim::{Left, Sign};
use crate::exact::Rational;
use crate::formula::{Expr, LocatedFormula, Node, Operator};
use crate::judge::cases::Case;
use crate::judge::comparison::Sides;

/// The most changes that are reported; if there are more, the identity says too little.
const MAX_MENDS: usize = 3;

/// The most changed formulas that are tried.
const MAX_TRIES: usize = 2_000;

/// The most comparisons of both sides in one case, over all changed formulas.
const MAX_COMPARISONS: usize = 50_000;

/// The most steps of formulas in all comparisons of changed formulas.
const MAX_WORK: u64 = 20_000_000;

/// Changes of one symbol in the right side, or in the left side if that is one formula, with which
/// the identity holds in all cases: another sign, or an integer changed by 1. Empty if there is
/// none or more than three, if a cap is reached, or if there are no symbols: between plain numbers,
/// a change that fits is luck. `failing` are the indices of the cases that fail. They are compared
/// first, since nearly every change fails there too.
pub(crate) fn search(comparison: &Sides<'_>, cases: &[Case], failing: &[usize]) -> Vec<String> {
    let identity = comparison.identity;
    let [equation] = &identity.comparisons[..] else { return Vec::new() };
    if identity.symbols.is_empty() || equation.sign != Sign::Equal {
        return Vec::new();
    }
    let mut sides = vec![equation.right()];
    if let Left::One(left) = &equation.left {
        sides.push(left);
    }
    let order: Vec<usize> = failing.iter().copied().chain(0..cases.len()).collect();
    let mut left = MAX_COMPARISONS;
    let most = comparison.spent.get() + MAX_WORK;
    let mut mends = Vec::new();
    for side in sides {
        for changed in variants(&side.expr).into_iter().take(MAX_TRIES) {
            let holds = order.iter().all(|&i| {
                left = left.saturating_sub(1);
                if comparison.spent.get() > most {
                    left = 0;
                }
                left > 0 && holds(comparison, i, &cases[i], side, &changed)
            });
            if left == 0 {
                return Vec::new();
            }
            if holds {
                mends.push(changed.to_string());
            }
            if mends.len() > MAX_MENDS {
                return Vec::new();
            }
        }
    }
    mends
}

/// Whether the identity holds in the `i`-th case with `changed` in place of `side`.
fn holds(
    comparison: &Sides<'_>,
    i: usize,
    case: &Case,
    side: &LocatedFormula,
    changed: &Expr,
) -> bool {
    let value = |formula: &LocatedFormula| {
        let expr = if std::ptr::eq(formula, side) { changed } else { &formula.expr };
        comparison.value(formula, expr, case).ok()
    };
    let equation = comparison.identity.first();
    match (value(equation.left.formula(i)), value(equation.right())) {
        (Some(left), Some(right)) => left == right,
        _ => false,
    }
}

/// The formula with one symbol changed, in every way.
fn variants(expr: &Expr) -> Vec<Expr> {
    let same = |node: Node| Expr { node, span: expr.span.clone() };
    let boxed = |part: &Expr, build: &dyn Fn(Box<Expr>) -> Node| -> Vec<Expr> {
        variants(part).into_iter().map(|changed| same(build(Box::new(changed)))).collect()
    };
    match &expr.node {
        Node::Number(number) if number.is_integer() => [1, -1]
            .map(|step| same(Node::Number(number + Rational::from(step))))
            .into_iter()
            .filter(|changed| !matches!(&changed.node, Node::Number(n) if n.sign() < 0))
            .collect(),
        Node::Number(_) | Node::Name(_) => Vec::new(),
        Node::Negate(operand) => {
            let mut all = boxed(operand, &Node::Negate);
            all.push((**operand).clone());
            all
        }
        Node::Power(base, exponent) => {
            let mut all = boxed(base, &|base| Node::Power(base, exponent.clone()));
            all.extend(boxed(exponent, &|exponent| Node::Power(base.clone(), exponent)));
            all
        }
        Node::Indexed { name, indices } => replaced(indices)
            .map(|indices| same(Node::Indexed { name: name.clone(), indices }))
            .collect(),
        Node::Call { function, arguments, options } => replaced(arguments)
            .map(|arguments| {
                let (function, options) = (function.clone(), options.clone());
                same(Node::Call { function, arguments, options })
            })
            .collect(),
        Node::Fold { fold, index, from, to, body } => {
            let sum = |from, to, body| {
                let (fold, index) = (*fold, index.clone());
                Node::Fold { fold, index, from, to, body }
            };
            let mut all = boxed(from, &|from| sum(from, to.clone(), body.clone()));
            all.extend(boxed(to, &|to| sum(from.clone(), to, body.clone())));
            all.extend(boxed(body, &|body| sum(from.clone(), to.clone(), body)));
            all
        }
        Node::Chain(first, rest) => {
            let mut all = boxed(first, &|first| Node::Chain(first, rest.clone()));
            for (i, (operator, operand)) in rest.iter().enumerate() {
                let with = |operator: Operator, operand: Expr| {
                    let mut rest = rest.clone();
                    rest[i] = (operator, operand);
                    same(Node::Chain(first.clone(), rest))
                };
                match operator {
                    Operator::Add => all.push(with(Operator::Subtract, operand.clone())),
                    Operator::Subtract => all.push(with(Operator::Add, operand.clone())),
                    Operator::Multiply | Operator::Divide => {}
                }
                all.extend(variants(operand).into_iter().map(|changed| with(*operator, changed)));
            }
            all
        }
    }
}

/// The list with one expression changed, in every way.
fn replaced(list: &[Expr]) -> impl Iterator<Item = Vec<Expr>> {
    list.iter().enumerate().flat_map(move |(i, part)| {
        variants(part).into_iter().map(move |changed| {
            let mut list = list.to_vec();
            list[i] = changed;
            list
        })
    })
}
