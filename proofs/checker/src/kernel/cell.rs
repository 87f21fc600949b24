//! Theorems about the cells of a table: constants, sound bounds and depths, and promises that are not kept.

use super::read::Theorems;
use super::stated::{comment, mask, parameters, placed, rational, stated};
use super::statement::{Argument, Theorem};
use crate::claims::{Paper, printed};
use crate::data::Points;
use crate::kinds::table::claim::{Place, Read, Table};
use crate::kinds::table::sound::{Promised, level as promised_level};
use crate::numbers::{Q, Value, int};
use crate::schemes::{Constant, LocalRules};
use crate::text::{At, Checked, Reason, Toml, compare, require};
use num_traits::Signed;

/// A value of a parameter that a valid certificate of a table recovers.
pub struct Given {
    /// The id of the table.
    pub table: String,
    /// The name of the parameter.
    pub name: String,
    /// The value.
    pub value: Q,
}

/// Compares theorems with a table, and gives the values of its parameters that certificates recover.
pub fn agree<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    recovered: &[Given],
    file: &Theorems,
) -> Checked<Vec<(String, Q)>> {
    let mut table = Table::new(paper, claim)?;
    let mut used = Vec::new();
    // A value that the file does not name is not assumed, so that no theorem hides one.
    table.assumed.retain(|name, _| file.assumed.iter().any(|(named, _)| named == name));
    for (name, value) in &file.assumed {
        require(table.unstated.contains(name), Reason::Recovered(name.clone()))?;
        let number = Value::from(value.clone());
        if let Some(known) = table.assumed.get(name) {
            compare(known.equals(&number)?, value, known, Reason::Stated)?;
            continue;
        }
        let own = |given: &&Given| given.table == file.id && given.name == *name;
        let known = recovered.iter().find(own).ok_or(Reason::NoValueGiven(name.clone()))?;
        compare(known.value == *value, value, &known.value, Reason::Stated)?;
        table.assumed.insert(name.clone(), number);
        used.push((name.clone(), value.clone()));
    }
    for theorem in &file.statements {
        one(&table, theorem).at(theorem.line)?;
    }
    Ok(used)
}

fn one(table: &Table<'_>, theorem: &Theorem) -> Checked<()> {
    let at = place(table, &theorem.place)?;
    match (&theorem.statement[..], &theorem.about[..]) {
        ("contraction_constant" | "backwards_constant" | "scheme_norm", _) => {
            constant(table, at, theorem)
        }
        ("bounds_distance", "This bound holds.") => {
            let promised = Promised::new(table, at)?;
            let level = promised.level.ok_or(Reason::NoPromise)?;
            let mut expected = curve(&promised, Points::Indexed)?;
            expected.push(Argument::Level(promised_level(level)?));
            // The sound bound by the constants that prove it.
            let bound = promised.for_unit(level, theorem.evidence)?;
            expected.push(Argument::Number(rational(&bound)?));
            stated(theorem, "bounds_distance", &expected)
        }
        ("sufficient_depth", "This depth suffices.") => {
            let promised = Promised::new(table, at)?;
            let tolerance = promised.tolerance.as_ref().ok_or(Reason::NoPromise)?;
            let mut expected = curve(&promised, Points::Indexed)?;
            expected.push(Argument::Number(rational(&promised.spread)?));
            expected.push(Argument::Number(rational(tolerance)?));
            stated(theorem, "sufficient_depth", &expected)?;
            // It is the least level whose sound bound, by the constants that prove it, is at most the tolerance.
            let level = match theorem.arguments.last() {
                Some(Argument::Level(level)) => i64::from(*level),
                _ => return Err(Reason::Malformed("a level").into()),
            };
            let suffices = |level: i64| -> Checked<bool> {
                let bound = promised.for_unit(level, theorem.evidence)?.times(&promised.spread)?;
                Ok(bound.compare(tolerance)?.is_le())
            };
            let least = suffices(level)? && (level == 0 || !suffices(level - 1)?);
            require(least, Reason::NotLeast(level))
        }
        _ => broken(table, at, theorem),
    }
}

/// The cell that a comment `row R, column C: …` names. The rest of it is what the paper prints there.
fn place(table: &Table<'_>, said: &str) -> Checked<Place> {
    let malformed = || Reason::Malformed("row R, column C: LOCUS, HEADERS prints NUMBER");
    let (numbers, text) = said.split_once(": ").ok_or_else(malformed)?;
    let numbers = numbers.strip_prefix("row ").and_then(|it| it.split_once(", column "));
    let (row, column) = numbers.ok_or_else(malformed)?;
    let (at, _) = table.place(&format!("{row} {column}"))?;
    // A place has one spelling, so that two comments of one cell are the same text.
    require(format!("{}, {}", at.0 + 1, at.1 + 1) == format!("{row}, {column}"), malformed())?;
    let mut headers = Vec::new();
    for (key, index) in [("rows", at.0), ("columns", at.1)] {
        let Some(axis) = table.claim.get(key) else { continue };
        let (entries, plain) = match axis.list("schemes") {
            [] => (axis.list("values"), axis.text("name")),
            schemes => (schemes, Some("scheme")),
        };
        let label = axis.text("label").or(plain).unwrap_or_default();
        let entry = entries.get(index).ok_or(Reason::Cell)?;
        let header = printed(entry).map(|(text, _)| text).or_else(|| entry.text("scheme"));
        headers.push(format!("{label} = {}", header.unwrap_or_default()));
    }
    let number = table.printed(at).map_or("nothing", |(text, _)| text);
    let locus = table.claim.text("locus").unwrap_or_default();
    let expected = comment(&format!("{locus}, {} prints {number}", headers.join(", ")));
    compare(text == expected, text, &expected, Reason::Stated)?;
    Ok(at)
}

/// The cell rests on this constant, or its value is this constant.
fn constant(table: &Table<'_>, at: Place, theorem: &Theorem) -> Checked<()> {
    // A new reading knows no value, so that every constant is asked for once more.
    let read = Read::default();
    let (scope, _) = table.scope(at, &read, &table.unstated)?;
    let (value, asked) = table.paper.library.trace(|| scope.value(&table.value));
    let (last, arguments) = theorem.arguments.split_last().ok_or(Reason::NotAsked)?;
    let is_this = |constant: &Constant| {
        let scheme = &constant.scheme;
        let own = mask(scheme.offset, &scheme.mask)?;
        // For one level the order says nothing.
        let backwards = constant.forward && constant.level > 1;
        let level = Argument::Level(constant.level);
        let of = match (constant.norm, backwards) {
            (true, true) => ("scheme_norm", vec![Argument::Backwards(own), level]),
            (true, false) => ("scheme_norm", vec![Argument::Object(own), level]),
            (false, true) => {
                let difference = Argument::Object(mask(scheme.offset, &scheme.difference)?);
                ("backwards_constant", vec![Argument::Object(own), difference, level])
            }
            (false, false) => ("contraction_constant", vec![Argument::Object(own), level]),
        };
        Some(of == (&theorem.statement[..], arguments.to_vec()))
    };
    require(asked.iter().any(|constant| is_this(constant) == Some(true)), Reason::NotAsked)?;
    match &theorem.about[..] {
        "It is this constant." => {
            let value = Argument::Number(rational(&value?)?);
            compare(*last == value, last, &value, Reason::Stated)
        }
        "It rests on this constant." => Ok(()),
        _ => Err(Reason::Malformed("It is, or it rests on, this constant.").into()),
    }
}

/// The mask of a curve, and the shift of its points.
fn curve(promised: &Promised<'_>, points: Points) -> Checked<Vec<Argument>> {
    require(promised.schemes.len() == 1, Reason::Single)?;
    placed(promised.paper.library, &promised.schemes, promised.offset, points)
}

/// Data of spread 1 exceed the promise of a cell, divided by the spread that it is for.
fn broken(table: &Table<'_>, at: Place, theorem: &Theorem) -> Checked<()> {
    let promised = Promised::new(table, at)?;
    let (_, decimal) = table.printed(at).ok_or(Reason::NoPromise)?;
    let malformed = Reason::Malformed("a promise that is broken");
    let (points, said) = parameters(&theorem.about, "Broken").ok_or(malformed)?;
    let ring = table.claim.get("promise").and_then(|promise| promise.text("ring"));
    let (statement, mut expected) = match (ring, &promised.schemes[..]) {
        (Some(ring), _) => {
            require(points == Points::Indexed, Reason::Malformed("masks"))?;
            let ring = LocalRules::new(table.paper.library, ring, &promised.scope)?;
            ("exceeds_ring_distance", vec![super::stated::ring(&ring, &ring.weights)?])
        }
        (None, [_]) => ("exceeds_distance", curve(&promised, points)?),
        (None, schemes) => {
            ("exceeds_net_distance", placed(table.paper.library, schemes, promised.offset, points)?)
        }
    };
    let Some(&Argument::Level(level)) = theorem.arguments.get(expected.len()) else {
        return Err(Reason::Malformed("a promise that is broken").into());
    };
    let (least, most) = promised.stated(decimal.value.into())?;
    // A depth is promised for all later levels too.
    let later = promised.tolerance.is_some() && i64::from(level) > least;
    require(later || i64::from(level) == least, Reason::Level)?;
    let (most, spread) = (rational(&most)?, rational(&promised.spread)?);
    require(spread.is_positive(), Reason::NegativeSpread)?;
    let about = format!("at level {level}: {most} for points of spread {spread}");
    compare(said == about, said, &about, Reason::Stated)?;
    expected.extend([Argument::Level(level), Argument::Number(int(1))]);
    expected.push(Argument::Number(most / spread));
    stated(theorem, statement, &expected)
}
