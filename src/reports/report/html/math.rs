//! Formulas as MathML, which browsers typeset by themselves.

use super::names::name;
use crate::exact::Rational;
use crate::formula::{Expr, Fold, Node, Operator, OptionWord};
use maud::{Markup, html};

/// A formula; its text stands in it for programs that do not show MathML.
pub(crate) fn formula(expr: &Expr) -> Markup {
    html! { math alttext=(expr) { (inner(expr)) } }
}

/// How tightly what is shown binds.
fn binds(expr: &Expr) -> u8 {
    match &expr.node {
        Node::Chain(_, rest) if rest.iter().any(|(operator, _)| is_sum(*operator)) => 1,
        Node::Fold { .. } | Node::Negate(_) => 1,
        Node::Number(number) if number.sign() < 0 => 1,
        Node::Chain(..) => 2,
        // A fraction with a bar is one thing, but for an exponent above it.
        Node::Number(number) if !number.is_integer() => 3,
        Node::Power(..) => 4,
        _ => 5,
    }
}

fn is_sum(operator: Operator) -> bool {
    matches!(operator, Operator::Add | Operator::Subtract)
}

/// In parentheses, unless it binds as tightly as `least`.
fn at_least(expr: &Expr, least: u8) -> Markup {
    if binds(expr) < least { bracketed("(", &inner(expr), ")", is_tall(expr)) } else { inner(expr) }
}

/// Between fences, which grow with what is tall.
pub(super) fn bracketed(open: &str, contents: &Markup, close: &str, tall: bool) -> Markup {
    let fence = |sign: &str| html! { mo stretchy=(tall) { (sign) } };
    html! { mrow { (fence(open)) (contents) (fence(close)) } }
}

/// Whether a bar of a fraction or the limits of a sum stand in it.
fn is_tall(expr: &Expr) -> bool {
    let own = match &expr.node {
        Node::Number(value) => !value.is_integer(),
        Node::Chain(_, rest) => rest.iter().any(|(operator, _)| *operator == Operator::Divide),
        Node::Fold { .. } => true,
        Node::Call { function, .. } => function == "binomial",
        _ => false,
    };
    own || expr.parts().into_iter().any(is_tall)
}

/// What stands in a `math` element; one element.
pub(super) fn inner(expr: &Expr) -> Markup {
    match &expr.node {
        Node::Number(value) => number(value),
        Node::Name(text) => name(text),
        Node::Indexed { name: family, indices } => {
            html! { msub { (name(family)) mrow { (list(indices)) } } }
        }
        Node::Negate(operand) => html! { mrow { mo { "−" } (at_least(operand, 2)) } },
        Node::Power(base, exponent) => html! { msup { (at_least(base, 5)) (inner(exponent)) } },
        Node::Chain(first, rest) if rest.iter().any(|(operator, _)| is_sum(*operator)) => {
            sum(first, rest)
        }
        Node::Chain(first, rest) => product(first, rest),
        Node::Call { function, arguments, options } => call(function, arguments, options),
        Node::Fold { fold, index, from, to, body } => folded(*fold, index, [from, to, body]),
    }
}

fn number(value: &Rational) -> Markup {
    let size = value.abs();
    let shown = if size.is_integer() {
        html! { mn { (size) } }
    } else {
        html! { mfrac { mn { (size.numerator()) } mn { (size.denominator()) } } }
    };
    if value.sign() < 0 {
        html! { mrow { mo { "−" } (shown) } }
    } else {
        shown
    }
}

fn list(parts: &[Expr]) -> Markup {
    html! {
        @for (place, part) in parts.iter().enumerate() {
            @if place > 0 { mo separator="true" { "," } }
            (inner(part))
        }
    }
}

fn sum(first: &Expr, rest: &[(Operator, Expr)]) -> Markup {
    // What is summed over an index ends where the sign stands.
    let folded = matches!(first.node, Node::Fold { .. });
    html! {
        mrow {
            (at_least(first, if folded { 2 } else { 0 }))
            @for (operator, operand) in rest {
                mo { @if *operator == Operator::Add { "+" } @else { "−" } }
                (at_least(operand, 2))
            }
        }
    }
}

/// Factors side by side, and what divides below a bar.
fn product(first: &Expr, rest: &[(Operator, Expr)]) -> Markup {
    // Of one factor, the form without parentheses too: a bar takes their place.
    let mut factors = vec![at_least(first, 2)];
    let mut alone = Some(inner(first));
    for (operator, operand) in rest {
        if *operator == Operator::Divide {
            let above =
                alone.unwrap_or_else(|| html! { mrow { @for factor in &factors { (factor) } } });
            let bar = html! { mfrac { (above) (inner(operand)) } };
            factors = vec![bar.clone()];
            alone = Some(bar);
            continue;
        }
        // A point where juxtaposition would read as another number or name.
        let point = matches!(operand.node, Node::Number(_) | Node::Call { .. });
        let sign = if point { "·" } else { "\u{2062}" };
        factors.push(html! { mo { (sign) } });
        factors.push(at_least(operand, 2));
        alone = None;
    }
    if let [one] = &factors[..] {
        return one.clone();
    }
    html! { mrow { @for factor in &factors { (factor) } } }
}

fn call(function: &str, arguments: &[Expr], options: &[OptionWord]) -> Markup {
    let fences = match function {
        "abs" => Some(("|", "|")),
        "floor" => Some(("⌊", "⌋")),
        "ceil" => Some(("⌈", "⌉")),
        _ => None,
    };
    if let (Some((open, close)), [argument], []) = (fences, arguments, options) {
        return bracketed(open, &inner(argument), close, is_tall(argument));
    }
    if let ("binomial", [above, below], []) = (function, arguments, options) {
        let pair = html! { mfrac linethickness="0" { (inner(above)) (inner(below)) } };
        return bracketed("(", &pair, ")", true);
    }
    let contents = html! {
        (list(arguments))
        @for (place, option) in options.iter().enumerate() {
            @if place > 0 || !arguments.is_empty() { mo separator="true" { "," } }
            mtext { (option.name) " = " (option.word) }
        }
    };
    html! { mrow { (name(function)) mo { "\u{2061}" } (bracketed("(", &contents, ")", arguments.iter().any(is_tall))) } }
}

fn folded(fold: Fold, index: &str, [from, to, body]: [&Expr; 3]) -> Markup {
    match fold {
        Fold::Sum | Fold::Product => html! {
            mrow {
                munderover {
                    mo { @if fold == Fold::Sum { "∑" } @else { "∏" } }
                    mrow { (name(index)) mo { "=" } (inner(from)) }
                    mrow { (inner(to)) }
                }
                (at_least(body, 2))
            }
        },
        Fold::Max | Fold::Min => html! {
            mrow {
                munder {
                    mo { @if fold == Fold::Max { "max" } @else { "min" } }
                    mrow { (name(index)) mo { "=" } (inner(from)) mo { "…" } (inner(to)) }
                }
                (at_least(body, 2))
            }
        },
    }
}
