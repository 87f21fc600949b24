//! The rule `attained`: a constant and the residue class that attains it.

#![warn(clippy::arithmetic_side_effects)]

use super::claim::{Read, Table};
use crate::formulas::parse;
use crate::functions::sums::of_constant;
use crate::text::{Checked, MAX_LINE, Reason, Text, compare, require};

/// Checks `ROW COLUMN CLASS VALUE FORMULA`. `read` is a reading as printed, and not the table's
/// own, since this records which choices are consulted, and its record must not change.
pub fn check(table: &Table<'_>, read: &Read, said: &str) -> Checked<()> {
    let (at, said) = table.place(said)?;
    let mut words = said.splitn(3, ' ');
    let (Some(class), Some(value), Some(formula)) = (words.next(), words.next(), words.next())
    else {
        return Err(Reason::Malformed("ROW COLUMN CLASS VALUE FORMULA").into());
    };
    let class: usize = class.parse().map_err(|_| Reason::Malformed("a residue class"))?;
    let value = table.paper.number(value)?;
    let formula = parse(formula, MAX_LINE).map_err(Reason::NoValue)?;
    let (scope, _) = table.scope(at, read, &table.needed(at).0)?;
    let sums = of_constant(table.paper.library, &scope, &formula)?;
    let sum = class.checked_sub(sums.first).and_then(|class| sums.units.get(class));
    let none = || Reason::Class(Text(value.to_string()), Text("undefined".to_owned()));
    let sum = sum.ok_or_else(none)?.times(&sums.scale)?;
    compare(sum.equals(&value)?, &value, &sum, Reason::Class)?;
    require(sums.greatest(None)?.equals(&value)?, Reason::NotLargest)
}
