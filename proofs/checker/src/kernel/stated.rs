//! What theorems of Coq hold of a claim file: its comments, masks, shifts and rings.

use super::statement::{Argument, Object, Theorem};
use crate::data::{Points, Rules};
use crate::numbers::{Q, Value, int};
use crate::schemes::{Library, LocalRules, Scheme};
use crate::text::{Checked, Reason, compare, require};
use std::rc::Rc;

/// A text of the claim file as comments of Coq hold it: in one line, and without what would end a comment.
pub(super) fn comment(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}

/// The mask of a scheme at an offset, or its difference mask; `None` if it is not rational.
pub(super) fn mask(offset: i64, rules: &[Vec<Value>]) -> Option<Object> {
    Some(Object::Mask(offset, Value::rationals(rules)?))
}

/// The masks of schemes, at an offset or at their own, with which a statement begins.
pub(super) fn masks<'s>(
    schemes: impl IntoIterator<Item = &'s Scheme>,
    offset: Option<i64>,
) -> Checked<Vec<Argument>> {
    let of =
        |scheme: &Scheme| mask(offset.unwrap_or(scheme.offset), &scheme.mask).map(Argument::Object);
    let masks: Option<Vec<Argument>> = schemes.into_iter().map(of).collect();
    masks.ok_or(Reason::Malformed("rational masks").into())
}

/// The masks, and then the shifts of their points, with which a statement about polygons or nets begins.
pub(super) fn placed(
    library: &Library<'_>,
    schemes: &[Rc<Scheme>],
    offset: Option<i64>,
    points: Points,
) -> Checked<Vec<Argument>> {
    let mut arguments = masks(schemes.iter().map(|scheme| &**scheme), offset)?;
    for scheme in schemes {
        let shift = match points {
            Points::Indexed => int(0),
            Points::Natural => {
                let rules = Rules::new(library.meter, scheme, offset.unwrap_or(scheme.offset))?;
                let rules = rules.ok_or(Reason::Malformed("rational masks"))?;
                rules.natural_shift().ok_or(Reason::NoLines)?
            }
        };
        arguments.push(Argument::Number(shift));
    }
    Ok(arguments)
}

/// The parameters of the points that a comment names: `WORD …`, or `WORD at natural parameters …`; and the rest of it.
pub(super) fn parameters<'t>(about: &'t str, word: &str) -> Option<(Points, &'t str)> {
    let rest = about.strip_prefix(word)?;
    Some(match rest.strip_prefix(" at natural parameters ") {
        Some(rest) => (Points::Natural, rest),
        None => (Points::Indexed, rest.strip_prefix(' ')?),
    })
}

/// A rational number.
pub(super) fn rational(value: &Value) -> Checked<Q> {
    value.rational().ok_or(Reason::Malformed("rational numbers").into())
}

/// Weights for the points of a ring, with its edges.
pub(super) fn ring(ring: &LocalRules<'_>, weights: &[Vec<Value>]) -> Checked<Argument> {
    let weights = Value::rationals(weights).ok_or(Reason::Malformed("rational numbers"))?;
    Ok(Argument::Object(Object::Ring(weights, ring.edges.clone())))
}

/// Checks that a theorem is this statement, and that its arguments begin with these.
pub(super) fn stated(theorem: &Theorem, statement: &str, arguments: &[Argument]) -> Checked<()> {
    compare(theorem.statement == statement, &theorem.statement, statement, Reason::Stated)?;
    let enough = theorem.arguments.len() >= arguments.len();
    require(enough, Reason::Malformed("the arguments of the statement"))?;
    for (said, found) in theorem.arguments.iter().zip(arguments) {
        compare(said == found, said, found, Reason::Stated)?;
    }
    Ok(())
}
