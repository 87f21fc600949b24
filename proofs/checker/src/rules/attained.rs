//! Rule `attained`: a constant, and the residue class that attains it.

use super::place;
use crate::certificate::{Line, MAX_LINE};
use crate::formula::parse;
use crate::functions::sums_of;
use crate::reject::{Checked, Reason};
use crate::table::Table;

/// Checks `ROW COLUMN CLASS VALUE FORMULA`.
pub fn check(table: &Table<'_>, line: Line<'_>, said: &str) -> Checked<()> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let (at, said) = place(table, line, said)?;
    let malformed = || line.reject(Reason::Malformed("ROW COLUMN CLASS VALUE FORMULA"));
    let (class, said) = said.split_once(' ').ok_or_else(malformed)?;
    let (value, formula) = said.split_once(' ').ok_or_else(malformed)?;
    let class: usize = class.parse().map_err(|_| malformed())?;
    let value = table.paper.closed(line, value)?;
    let formula = parse(formula, MAX_LINE).map_err(|why| line.reject(Reason::NoValue(why)))?;
    let (assumed, _) = table.needed(at);
    let (scope, _) = table.scope(at, &table.as_printed, &assumed).map_err(stopped)?;
    let (first, sums) = sums_of(&scope, &formula).map_err(stopped)?;
    let sum = class.checked_sub(first).and_then(|class| sums.get(class));
    let sum = sum.ok_or(line.reject(Reason::Class))?;
    if !sum.plus(-1, &value).map_err(stopped)?.is_zero() {
        return Err(line.reject(Reason::Class));
    }
    for sum in &sums {
        let above = sum.plus(-1, &value).and_then(|above| above.sign(None));
        if above.map_err(stopped)? > 0 {
            return Err(line.reject(Reason::NotLargest));
        }
    }
    Ok(())
}
