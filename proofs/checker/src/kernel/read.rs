//! The form of a file of theorems of Coq. A text that differs from it in one character is rejected, so
//! that no line of such a file can change what another one means.

#![warn(clippy::arithmetic_side_effects)]

use super::statement::{Argument, Object, STATEMENTS, Theorem};
use crate::numbers::Q;
use crate::text::{Checked, Cursor, Parsed, Reason, Rejection, require};
use num_bigint::BigInt;
use num_traits::Zero;
use std::collections::BTreeMap;

/// The most bytes of a file.
const MAX_BYTES: usize = 1 << 20;

/// What every file imports. Nothing else is in scope.
const HEAD: &str = "From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.
";

/// A file of theorems.
pub struct Theorems {
    /// The key of the paper.
    pub key: String,
    /// The kind of the claim, `table` or `theorem`.
    pub kind: String,
    /// The id of the claim.
    pub id: String,
    /// The values of parameters that the paper does not state.
    pub assumed: Vec<(String, Q)>,
    /// The theorems, in their order.
    pub statements: Vec<Theorem>,
}

/// Reads a file.
pub fn read(text: &str) -> Checked<Theorems> {
    require(text.len() <= MAX_BYTES, Reason::LongLine)?;
    let mut c = Cursor::new(text);
    let read = file(&mut c);
    read.map_err(|what| Rejection { line: c.line(), reason: Reason::Form(c.expected(what)) })
}

fn file(c: &mut Cursor) -> Parsed<Theorems> {
    c.expect("(** ")?;
    let key = id(c)?;
    c.expect(", ")?;
    let kind = if c.eat("table ") { "table" } else { "theorem" };
    if kind == "theorem" {
        c.expect("theorem ")?;
    }
    let id = id(c)?;
    c.expect(" (written by `subcert prove --coq`) *)\n")?;
    let mut assumed = Vec::new();
    if c.eat("(* Not stated: ") {
        loop {
            let name = word(c)?;
            c.expect(" = ")?;
            if assumed.iter().any(|(known, _)| *known == name) {
                return Err("another name");
            }
            assumed.push((name, fraction(c)?));
            if !c.eat(", ") {
                break;
            }
        }
        c.expect(" *)\n")?;
    }
    c.expect("\n")?;
    c.expect_text(HEAD, "the imports, as proofs/format/coq.md says them")?;
    let (mut objects, mut theorems) = (BTreeMap::new(), Vec::new());
    while c.peek().is_some() {
        c.expect("\n")?;
        if c.eat("Definition ") {
            let (name, object) = definition(c)?;
            if objects.insert(name, object).is_some() {
                return Err("a name that is not defined yet");
            }
        } else {
            theorems.push(theorem(c, &objects, theorems.len())?);
        }
    }
    if theorems.is_empty() {
        return Err("a theorem");
    }
    let kind = kind.to_owned();
    Ok(Theorems { key, kind, id, assumed, statements: theorems })
}

/// `NAME :=\n  OBJECT.\n`
fn definition(c: &mut Cursor) -> Parsed<(String, Object)> {
    let kind = ["scheme", "difference", "ring"].into_iter().find(|kind| c.eat(kind));
    let kind = kind.ok_or("scheme_1, difference_1 or ring_1")?;
    c.expect("_")?;
    let name = format!("{kind}_{}", natural(c)?);
    c.expect(" :=\n  ")?;
    c.expect(if kind == "ring" { "Ring " } else { "Scheme " })?;
    let over = positive(c)?;
    c.expect(" ")?;
    let object = if kind == "ring" {
        let rows = rows(c, &over)?;
        c.expect("\n    ")?;
        let edges = list(c, |c| {
            c.expect("(")?;
            let a = index(c)?;
            c.expect(", ")?;
            let b = index(c)?;
            c.expect(")")?;
            Ok([a, b])
        })?;
        c.expect("%nat")?;
        Object::Ring(rows, edges)
    } else {
        let offset = i64::try_from(&signed(c)?).map_err(|_| "a smaller offset")?;
        c.expect(" ")?;
        Object::Mask(offset, rows(c, &over)?)
    };
    c.expect(".\n")?;
    Ok((name, object))
}

/// `[[1; 2]; [3; 4]]%Z` over a denominator.
fn rows(c: &mut Cursor, over: &BigInt) -> Parsed<Vec<Vec<Q>>> {
    let rows = list(c, |c| list(c, |c| Ok(Q::new(integer(c)?, over.clone()))))?;
    c.expect("%Z")?;
    Ok(rows)
}

/// Two comments, the statement, and its proof, which is one lemma and one computation.
fn theorem(c: &mut Cursor, objects: &BTreeMap<String, Object>, before: usize) -> Parsed<Theorem> {
    let line = c.line();
    let (place, about) = (comment(c)?, comment(c)?);
    c.expect("Theorem finding_")?;
    if natural(c)? != BigInt::from(before) + 1 {
        return Err("the next number");
    }
    c.expect(" :\n  ")?;
    let said = word(c)?;
    let known = STATEMENTS.iter().find(|(name, _)| *name == said);
    let (statement, kinds) = known.ok_or("a statement of Definitions.v")?;
    let mut arguments = Vec::new();
    for kind in kinds.split(' ') {
        c.expect(" ")?;
        arguments.push(argument(c, objects, kind)?);
    }
    c.expect(".\nProof. apply ")?;
    let several = c.eat("(");
    c.expect_text(statement, "the lemma of the statement")?;
    c.expect("_by")?;
    let mut last = [None; 2];
    if several {
        while !c.eat(")") {
            if !c.eat("\n  ") {
                c.expect(" ")?;
            }
            last = [last[1], evidence(c)?];
        }
    }
    c.expect(". vm_cast_no_check (eq_refl true). Qed.\n")?;
    Ok(Theorem { line, place, about, statement: said, arguments, evidence: last })
}

fn argument(c: &mut Cursor, objects: &BTreeMap<String, Object>, kind: &str) -> Parsed<Argument> {
    let named = |c: &mut Cursor, kind: &str| {
        let name = word(c)?;
        let object = objects.get(&name).filter(|_| name.starts_with(kind));
        object.cloned().ok_or("a mask or ring that is defined above")
    };
    Ok(match kind {
        "level" => {
            let level = u32::try_from(&natural(c)?).map_err(|_| "a smaller number of levels")?;
            Argument::Level(level)
        }
        "number" => Argument::Number(number(c)?),
        "reversed" if c.eat("(backwards ") => {
            let mask = named(c, "scheme_")?;
            c.expect(")")?;
            Argument::Backwards(mask)
        }
        "difference" => Argument::Object(named(c, "difference_")?),
        "ring" => Argument::Object(named(c, "ring_")?),
        _ => Argument::Object(named(c, "scheme_")?),
    })
}

/// An argument of a lemma, which cannot change the statement: numbers, lists of numbers, and names. Gives a natural
/// number.
fn evidence(c: &mut Cursor) -> Parsed<Option<i64>> {
    if c.is_at("[") {
        list(c, integer)?;
        c.expect("%Z")?;
    } else if c.is_at("(") {
        c.expect("(")?;
        integer(c)?;
        if c.eat(" # ") {
            positive(c)?;
        }
        c.expect(")")?;
    } else if c.peek().is_some_and(|next| next.is_ascii_digit()) {
        return Ok(i64::try_from(&natural(c)?).ok());
    } else {
        word(c)?;
    }
    Ok(None)
}

/// `(* TEXT *)` in one line. What would open or close a comment or a string is not in the text.
fn comment(c: &mut Cursor) -> Parsed<String> {
    c.expect("(* ")?;
    let line = c.take(|next| next != '\n' && next != '"');
    let text = line.strip_suffix(" *)").ok_or("the end of the comment in its line")?;
    if text.contains("(*") || text.contains("*)") {
        return Err("one comment in a line");
    }
    c.expect("\n")?;
    Ok(text.to_owned())
}

fn word(c: &mut Cursor) -> Parsed<String> {
    let text = c.take(|next| next.is_ascii_alphanumeric() || next == '_');
    if text.is_empty() { Err("a name") } else { Ok(text) }
}

/// The key of a paper or the id of a claim.
fn id(c: &mut Cursor) -> Parsed<String> {
    let text = c.take(|next| next.is_ascii_alphanumeric() || "_-.".contains(next));
    if text.is_empty() { Err("an id") } else { Ok(text) }
}

fn natural(c: &mut Cursor) -> Parsed<BigInt> {
    let digits = c.take(|next| next.is_ascii_digit());
    let plain = digits == "0" || !digits.starts_with('0');
    digits.parse().ok().filter(|_| plain).ok_or("a number without leading zeros")
}

fn positive(c: &mut Cursor) -> Parsed<BigInt> {
    let number = natural(c)?;
    if number.is_zero() { Err("a positive number") } else { Ok(number) }
}

fn index(c: &mut Cursor) -> Parsed<usize> {
    usize::try_from(&natural(c)?).map_err(|_| "an index")
}

fn integer(c: &mut Cursor) -> Parsed<BigInt> {
    if c.eat("-") { Ok(-positive(c)?) } else { natural(c) }
}

/// `3` or `(-3)`.
fn signed(c: &mut Cursor) -> Parsed<BigInt> {
    if !c.eat("(") {
        return natural(c);
    }
    let number = integer(c)?;
    c.expect(")")?;
    Ok(number)
}

/// `3` or `(-3 # 4)`.
fn number(c: &mut Cursor) -> Parsed<Q> {
    if !c.eat("(") {
        return natural(c).map(Q::from_integer);
    }
    let top = integer(c)?;
    c.expect(" # ")?;
    let bottom = positive(c)?;
    c.expect(")")?;
    Ok(Q::new(top, bottom))
}

/// `3` or `-3/4`.
fn fraction(c: &mut Cursor) -> Parsed<Q> {
    let top = integer(c)?;
    let bottom = if c.eat("/") { positive(c)? } else { BigInt::from(1) };
    Ok(Q::new(top, bottom))
}

/// `[a; b; …]`, with one element or more.
fn list<T>(c: &mut Cursor, element: impl Fn(&mut Cursor) -> Parsed<T>) -> Parsed<Vec<T>> {
    c.expect("[")?;
    let mut elements = vec![element(c)?];
    while c.eat("; ") {
        elements.push(element(c)?);
    }
    c.expect("]")?;
    Ok(elements)
}
