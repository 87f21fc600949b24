//! Prints a formula as text that parses to the same formula.

use super::ast::{Expr, Node, Operator};
use super::root::ROOT;
use std::fmt;

/// The binding strength of a node, from 1 for sums to 5 for names and positive integers.
fn precedence(expr: &Expr) -> u8 {
    match &expr.node {
        Node::Chain(_, rest) => match rest.first() {
            Some((Operator::Add | Operator::Subtract, _)) => 1,
            _ => 2,
        },
        Node::Negate(_) => 3,
        Node::Power(..) => 4,
        Node::Number(number) if !number.is_integer() => 2,
        Node::Number(number) if number.sign() < 0 => 3,
        _ => 5,
    }
}

/// An expression, printed in parentheses when its precedence is below the given one.
struct AtLeast<'a>(&'a Expr, u8);

impl fmt::Display for AtLeast<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let AtLeast(expr, least) = self;
        if precedence(expr) < *least { write!(f, "({expr})") } else { write!(f, "{expr}") }
    }
}

fn list(f: &mut fmt::Formatter<'_>, parts: &[Expr]) -> fmt::Result {
    for (i, part) in parts.iter().enumerate() {
        let comma = if i > 0 { ", " } else { "" };
        write!(f, "{comma}{part}")?;
    }
    Ok(())
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.node {
            Node::Number(number) => write!(f, "{number}"),
            Node::Name(name) => f.write_str(name),
            Node::Indexed { name, indices } => {
                write!(f, "{name}[")?;
                list(f, indices)?;
                f.write_str("]")
            }
            Node::Negate(operand) => write!(f, "-{}", AtLeast(operand, 3)),
            Node::Power(base, exponent) => {
                write!(f, "{}^{}", AtLeast(base, 5), AtLeast(exponent, 3))
            }
            Node::Chain(first, rest) => {
                let level = precedence(self);
                write!(f, "{}", AtLeast(first, level))?;
                for (operator, operand) in rest {
                    let sign = match operator {
                        Operator::Add => " + ",
                        Operator::Subtract => " - ",
                        Operator::Multiply => "*",
                        Operator::Divide => "/",
                    };
                    write!(f, "{sign}{}", AtLeast(operand, level + 1))?;
                }
                Ok(())
            }
            Node::Call { function, arguments, .. } if function == ROOT && !arguments.is_empty() => {
                let (number, coefficients) = arguments.split_last().expect("an argument");
                f.write_str("root([")?;
                list(f, coefficients)?;
                write!(f, "], {number})")
            }
            Node::Call { function, arguments, options } => {
                write!(f, "{function}(")?;
                list(f, arguments)?;
                for (i, option) in options.iter().enumerate() {
                    let comma = if i > 0 || !arguments.is_empty() { ", " } else { "" };
                    write!(f, "{comma}{} = {}", option.name, option.word)?;
                }
                f.write_str(")")
            }
            Node::Fold { fold, index, from, to, body } => {
                write!(f, "{}({index} = {from}..{to}, {body})", fold.name())
            }
        }
    }
}
