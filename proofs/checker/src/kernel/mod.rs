//! Theorems of Coq: whether they are about the masks, numbers and places of a claim file. Whether they are
//! true, Coq checks (FORMAT.md, Theorems of Coq).

mod cell;
mod read;
mod theorem;

use crate::decimal::{Q, int};
use crate::functional::Rules;
use crate::library::Library;
use crate::local_rules::LocalRules;
use crate::paper::Paper;
use crate::reject::{At, Checked, Reason, Rejection, compare, require};
use crate::scheme::Scheme;
use crate::shape::misfit;
use crate::value::Value;
use crate::witness::Points;
use read::{Argument, Object, Theorem};
use std::rc::Rc;

/// A file of theorems that agrees with the claim file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Agreement {
    /// `table` or `theorem`.
    pub kind: String,
    /// The id of the claim.
    pub id: String,
    /// The number of theorems.
    pub theorems: usize,
    /// The values of parameters that certificates recover and that the theorems use.
    pub recovered: Vec<(String, Q)>,
}

/// A value of a parameter that a valid certificate of a table recovers.
pub struct Given {
    /// The id of the table.
    pub table: String,
    /// The name of the parameter.
    pub name: String,
    /// The value.
    pub value: Q,
}

/// Compares a file of theorems with the claim file.
pub fn agree<'a>(
    paper: &'a Paper<'a>,
    key: &str,
    recovered: &[Given],
    text: &str,
) -> Checked<Agreement> {
    paper.library.restart();
    let file = read::read(text)?;
    let agreement = || -> Checked<Agreement> {
        compare(file.key == key, &file.key, key, Reason::Stated)?;
        let mut claims = paper.file.list(&file.kind).iter();
        let claim = claims.find(|claim| claim.text("id") == Some(&file.id));
        let claim = claim.ok_or(Reason::NoSuchClaim)?;
        if let Some(path) = misfit(claim, &file.kind) {
            return Err(Reason::Field(path).into());
        }
        once(&file.statements)?;
        let recovered = match &file.kind[..] {
            "table" => cell::agree(paper, claim, recovered, &file)?,
            _ => theorem::agree(paper, claim, &file).map(|()| Vec::new())?,
        };
        Ok(Agreement {
            kind: file.kind.clone(),
            id: file.id.clone(),
            theorems: file.statements.len(),
            recovered,
        })
    };
    // What is wrong with all theorems stands in the first lines.
    agreement().at(1)
}

/// Checks that no two theorems say the same of the same place, whatever their second comments call it: they are one
/// finding, and so are sufficient depths of one cell, whatever their levels. The names of theorems are their numbers, in order.
fn once(theorems: &[Theorem]) -> Checked<()> {
    for (number, theorem) in theorems.iter().enumerate() {
        let same = |earlier: &&Theorem| {
            (&earlier.place, &earlier.statement) == (&theorem.place, &theorem.statement)
                && (theorem.statement == "sufficient_depth"
                    || earlier.arguments == theorem.arguments)
        };
        if let Some(earlier) = theorems[..number].iter().find(same) {
            return Err(Rejection {
                line: theorem.line,
                reason: Reason::TwiceStated(earlier.line),
            });
        }
    }
    Ok(())
}

/// A text of the claim file as comments of Coq hold it: in one line, and without what would end a comment.
fn comment(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}

/// The mask of a scheme at an offset, or its difference mask; `None` if it is not rational.
fn mask(offset: i64, rules: &[Vec<Value>]) -> Option<Object> {
    Some(Object::Mask(offset, Value::rationals(rules)?))
}

/// The masks of schemes, at an offset or at their own, with which a statement begins.
fn masks<'s>(
    schemes: impl IntoIterator<Item = &'s Scheme>,
    offset: Option<i64>,
) -> Checked<Vec<Argument>> {
    let of =
        |scheme: &Scheme| mask(offset.unwrap_or(scheme.offset), &scheme.mask).map(Argument::Object);
    let masks: Option<Vec<Argument>> = schemes.into_iter().map(of).collect();
    masks.ok_or(Reason::Malformed("rational masks").into())
}

/// The masks, and then the shifts of their points, with which a statement about polygons or nets begins.
fn placed(
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
fn parameters<'t>(about: &'t str, word: &str) -> Option<(Points, &'t str)> {
    let rest = about.strip_prefix(word)?;
    Some(match rest.strip_prefix(" at natural parameters ") {
        Some(rest) => (Points::Natural, rest),
        None => (Points::Indexed, rest.strip_prefix(' ')?),
    })
}

/// A rational number.
fn rational(value: &Value) -> Checked<Q> {
    value.rational().ok_or(Reason::Malformed("rational numbers").into())
}

/// Weights for the points of a ring, with its edges.
fn ring(ring: &LocalRules<'_>, weights: &[Vec<Value>]) -> Checked<Argument> {
    let weights = Value::rationals(weights).ok_or(Reason::Malformed("rational numbers"))?;
    Ok(Argument::Object(Object::Ring(weights, ring.edges.clone())))
}

/// Checks that a theorem is this statement, and that its arguments begin with these.
fn stated(theorem: &Theorem, statement: &str, arguments: &[Argument]) -> Checked<()> {
    compare(theorem.statement == statement, &theorem.statement, statement, Reason::Stated)?;
    let enough = theorem.arguments.len() >= arguments.len();
    require(enough, Reason::Malformed("the arguments of the statement"))?;
    for (said, found) in theorem.arguments.iter().zip(arguments) {
        compare(said == found, said, found, Reason::Stated)?;
    }
    Ok(())
}
