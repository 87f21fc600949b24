//! Expressions as formulas: `5/16 + 1/16*cos(2*pi/5) + 1/16*sqrt(...)`.

use super::node::{Generator, Operation, RealExpression};
use crate::exact::RealCyclotomic;
use std::fmt;

/// How tightly a text binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// A text without parentheses around it.
struct Text {
    text: String,
    binding: Binding,
}

impl Text {
    fn of_number(value: &RealCyclotomic) -> Text {
        let text = value.to_string();
        let binding = match (value.as_rational(), value.term_count()) {
            (Some(value), _) if value.is_integer() && value.sign() >= 0 => Binding::Atom,
            (_, 1) => Binding::Product,
            _ => Binding::Sum,
        };
        Text { text, binding }
    }

    /// The text as an operand that must bind at least so tightly.
    fn at_least(self, binding: Binding) -> String {
        let negative = self.text.starts_with('-') && binding > Binding::Sum;
        if self.binding < binding || negative { format!("({})", self.text) } else { self.text }
    }

    /// `first` + `second`, where a minus of the second becomes a difference.
    fn sum(first: &Text, second: &Text) -> Text {
        let text = match second.text.strip_prefix('-') {
            Some(rest) => format!("{} - {rest}", first.text),
            None => format!("{} + {}", first.text, second.text),
        };
        Text { text, binding: Binding::Sum }
    }
}

impl RealExpression {
    fn written(&self) -> Text {
        match &self.0.operation {
            Operation::Number(value) => Text::of_number(value),
            Operation::Sum(a, b) => Text::sum(&a.written(), &b.written()),
            Operation::Difference(a, b) => {
                let b = b.written().at_least(Binding::Product);
                let text = match a.written().text {
                    a if a == "0" => format!("-{b}"),
                    a => format!("{a} - {b}"),
                };
                Text { text, binding: Binding::Sum }
            }
            Operation::Product(a, b) => {
                let a = a.written();
                let b = b.written().at_least(Binding::Product);
                let text = match (a.binding, &a.text[..]) {
                    (_, "-1") => format!("-{b}"),
                    (Binding::Sum, text) => format!("({text})*{b}"),
                    (_, text) => format!("{text}*{b}"),
                };
                Text { text, binding: Binding::Product }
            }
            Operation::Quotient(a, b) => {
                let a = a.written().at_least(Binding::Product);
                let b = b.written().at_least(Binding::Atom);
                Text { text: format!("{a}/{b}"), binding: Binding::Product }
            }
            Operation::Root(generator) => {
                let text = match &**generator {
                    Generator::Square(radicand) => format!("sqrt({})", radicand.written().text),
                    Generator::Isolated(root) => {
                        let coefficients = root.given.iter().map(ToString::to_string);
                        let list = coefficients.collect::<Vec<String>>().join(", ");
                        format!("root([{list}], {})", root.index)
                    }
                };
                Text { text, binding: Binding::Atom }
            }
        }
    }
}

impl fmt::Display for RealExpression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.written().text)
    }
}

impl fmt::Debug for RealExpression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
