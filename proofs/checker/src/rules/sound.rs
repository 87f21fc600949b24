//! Rule `sound`: what a table promises, at a level or for a tolerance, as it is kept.

use super::place;
use crate::certificate::Line;
use crate::convolution::classes;
use crate::evaluate::Scope;
use crate::functions::{displaced, gather, greatest};
use crate::reject::{Checked, Reason};
use crate::scheme::{Scheme, formula};
use crate::table::Table;
use crate::value::{Stop, Value};
use std::rc::Rc;

/// The most levels of a bound.
const MAX_LEVEL: i64 = 10_000;

/// The most levels whose constants are computed.
const MAX_BLOCK: i64 = 12;

/// Checks `ROW COLUMN M c VALUE`.
pub fn check<'a>(table: &'a Table<'a>, line: Line<'_>, said: &str) -> Checked<()> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let (at, said) = place(table, line, said)?;
    let (constants, said) = said
        .rsplit_once(' ')
        .ok_or_else(|| line.reject(Reason::Malformed("ROW COLUMN M c VALUE")))?;
    let said = table.paper.closed(line, said)?;
    let promised = Promised::new(table, line, at)?;
    let level = match promised.level {
        Some(level) => level,
        None => said.integer(MAX_LEVEL).map_err(stopped)?,
    };
    let bound = promised.bound(line, level, constants)?;
    let Some(tolerance) = promised.tolerance else {
        let same = bound.plus(-1, &said).map_err(stopped)?.is_zero();
        return if same { Ok(()) } else { Err(line.reject(Reason::Value)) };
    };
    let above = bound.plus(-1, &tolerance).and_then(|above| above.sign(None)).map_err(stopped)?;
    if above > 0 { Err(line.reject(Reason::TooLarge)) } else { Ok(()) }
}

/// What a table promises at a cell.
pub struct Promised<'t> {
    /// The table.
    pub table: &'t Table<'t>,
    /// The scope of the cell, with all assumptions.
    pub scope: Scope<'t>,
    /// The factors of its scheme; none of a ring.
    pub schemes: Vec<Rc<Scheme>>,
    /// The offset at which it is compared with its limit, if not its own.
    pub offset: Option<i64>,
    /// β.
    pub spread: Value,
    /// The level, if the printed number is a bound.
    pub level: Option<i64>,
    /// The tolerance, if it is a depth.
    pub tolerance: Option<Value>,
}

impl<'t> Promised<'t> {
    /// The promise at a cell.
    pub fn new(table: &'t Table<'t>, line: Line<'_>, at: (usize, usize)) -> Checked<Promised<'t>> {
        let stopped = |stop| line.reject(Reason::Stopped(stop));
        let promise = table.claim.get("promise").ok_or(line.reject(Reason::NoPromise))?;
        let (assumed, _) = table.needed(at);
        // The promise may need parameters that the value does not.
        let assumed = assumed.into_iter().chain(table.unstated.keys().cloned()).collect();
        let (scope, schemes) = table.scope(at, &table.as_printed, &assumed).map_err(stopped)?;
        let of = |key: &str| promise.text(key).map(|text| scope.value(&formula(text)?)).transpose();
        let integer =
            |key| of(key).and_then(|value| value.map(|v| v.integer(MAX_LEVEL)).transpose());
        let spread = of("spread").map_err(stopped)?.ok_or(line.reject(Reason::NoPromise))?;
        let (offset, level) =
            (integer("offset").map_err(stopped)?, integer("level").map_err(stopped)?);
        let tolerance = of("tolerance").map_err(stopped)?.filter(|_| level.is_none());
        Ok(Promised { table, scope, schemes, offset, spread, level, tolerance })
    }

    /// The bound at a level that the constants `M c` give.
    pub fn bound(&self, line: Line<'_>, level: i64, constants: &str) -> Checked<Value> {
        let stopped = |stop| line.reject(Reason::Stopped(stop));
        let numbers = constants.split_whitespace().map(|text| {
            let value = self.table.paper.closed(line, text)?.integer(MAX_LEVEL);
            value.map_err(stopped)
        });
        let [most, block] = numbers.collect::<Checked<Vec<i64>>>()?[..] else {
            return Err(line.reject(Reason::Malformed("ROW COLUMN M c VALUE")));
        };
        if block < 1 || block > most || most > MAX_BLOCK {
            return Err(line.reject(Reason::Malformed("1 ≤ c ≤ M ≤ 12")));
        }
        if level < 0 {
            return Err(line.reject(Reason::Malformed("a level")));
        }
        if self.schemes.is_empty() {
            return Err(line.reject(Reason::NoPromise));
        }
        let bound = self.of_block(level, most, block).map_err(stopped)?;
        let bound = bound.ok_or(line.reject(Reason::NoContraction))?;
        bound.times(&self.spread).map_err(stopped)
    }

    /// The bound at a level for β = 1; `None` if the block does not contract.
    fn of_block(&self, level: i64, most: i64, block: i64) -> Result<Option<Value>, Stop> {
        let place = |value: i64| usize::try_from(value).unwrap_or(0);
        let key = self.schemes.iter().map(|scheme| Rc::as_ptr(scheme) as usize).collect();
        let mut known = self.table.bounds.borrow_mut();
        let upper = known.entry((key, most)).or_default();
        if upper.is_empty() {
            let constants = (0..=most).map(|c| self.constant(&Value::int(c)));
            upper.extend(constants.collect::<Result<Vec<Value>, Stop>>()?);
        }
        let rest = Value::int(1).plus(-1, &upper[place(block)])?;
        if rest.sign(None)? <= 0 {
            return Ok(None);
        }
        while upper.len() < place(level + block) {
            let mut least: Option<Value> = None;
            for j in 1..=place(most) {
                let next = upper[j].times(&upper[upper.len() - j])?;
                self.scope.library.spend(next.cost(&next))?;
                least = Some(match least {
                    Some(least) if next.plus(-1, &least)?.sign(None)? >= 0 => least,
                    _ => next,
                });
            }
            upper.extend(least);
        }
        let mut sum = Value::int(0);
        for next in &upper[place(level)..place(level + block)] {
            sum = sum.plus(1, next)?;
        }
        self.factor()?.times(&sum)?.over(&rest).map(Some)
    }

    /// T_c, or the larger of the T_cΛ_c of one factor and the other.
    fn constant(&self, c: &Value) -> Result<Value, Stop> {
        let of = |scheme: &Scheme, of| {
            greatest(&self.scope, &classes(&self.scope, scheme, of, false, c)?)
        };
        match &self.schemes[..] {
            [first, second, ..] => {
                let one = of(first, "b")?.times(&of(second, "a")?)?;
                one.max(&of(second, "b")?.times(&of(first, "a")?)?, None)
            }
            one => of(&one[0], "b"),
        }
    }

    /// σ, or of two factors the greatest ς_αλ_β + ς_β.
    fn factor(&self) -> Result<Value, Stop> {
        let moved = |scheme: &Scheme| {
            let offset = self.offset.unwrap_or(scheme.offset);
            let moved = |alpha| gather(&self.scope, &displaced(scheme, alpha, offset)?, 0);
            (0..scheme.arity()).map(moved).collect::<Result<Vec<Value>, Stop>>()
        };
        let [first, second, ..] = &self.schemes[..] else {
            return greatest(&self.scope, &moved(&self.schemes[0])?);
        };
        let mut sums = Vec::new();
        for (row, beta) in second.mask.iter().zip(moved(second)?) {
            let norm = gather(&self.scope, row, 0)?;
            for alpha in &moved(first)? {
                sums.push(alpha.times(&norm)?.plus(1, &beta)?);
            }
        }
        greatest(&self.scope, &sums)
    }
}
