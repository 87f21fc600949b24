//! Constants, and the residue classes that attain them.

use super::block::{Block, closed};
use crate::audit::{AttainedConstant, Powers, SearchedConstant};
use crate::bound::{Operator, Order};

/// The line of a constant whose residue classes can all be computed.
pub(super) fn attained(constant: &AttainedConstant) -> String {
    let AttainedConstant { row, column, formula, class, value } = constant;
    format!("attained {} {} {class} {} {formula}", row + 1, column + 1, closed(value))
}

/// The lines of a constant with more classes, and of the bounds that exclude most of them.
pub(super) fn searched(block: &mut Block, constant: &SearchedConstant) {
    let SearchedConstant { scheme, operator, order, levels, class, value, powers } = constant;
    let function = match operator {
        Operator::Difference => "contraction",
        Operator::Scheme => "norm",
    };
    let order = match order {
        Order::Adjoint => "adjoint",
        Order::Forward => "forward",
    };
    block.line(format!("constant {scheme} {function} {order} {levels} {class} {value}"));
    block.line(match powers {
        Powers::All(bound) => format!("powers all {bound}"),
        Powers::Each(bounds) => {
            let bounds: Vec<String> = bounds.iter().map(ToString::to_string).collect();
            format!("powers {}", bounds.join(" "))
        }
    });
}
