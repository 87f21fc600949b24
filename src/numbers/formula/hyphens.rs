//! Names with hyphens, which read as differences.

use super::ast::{Expr, Node, Operator};

/// The parts of `a - b - 4`, or of `a`, of which the first is a name and the others are names or whole numbers: a name with
/// hyphens, such as `four-point` or `daubechies-4`, reads as a difference.
///
/// ```
/// use subcert::formula::{differences, parse};
///
/// let parts = |text| differences(&parse(text).unwrap()).map(|parts| parts.join("-"));
/// assert_eq!(parts("daubechies-4").as_deref(), Some("daubechies-4"));
/// assert_eq!((parts("4-point"), parts("a+b")), (None, None));
/// ```
#[must_use]
pub fn differences(expr: &Expr) -> Option<Vec<String>> {
    match &expr.node {
        Node::Name(name) => Some(vec![name.clone()]),
        Node::Chain(first, rest) => {
            let Node::Name(first) = &first.node else { return None };
            let mut parts = vec![first.clone()];
            for (operator, operand) in rest {
                let part = match &operand.node {
                    Node::Name(name) => name.clone(),
                    Node::Number(number) if number.is_integer() => number.to_string(),
                    _ => return None,
                };
                parts.push((*operator == Operator::Subtract).then_some(part)?);
            }
            Some(parts)
        }
        _ => None,
    }
}
