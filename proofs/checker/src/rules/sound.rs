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
pub fn check(table: &Table<'_>, line: Line<'_>, said: &str) -> Checked<()> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let (at, said) = place(table, line, said)?;
    let [most, block, said] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(line.reject(Reason::Malformed("ROW COLUMN M c VALUE")));
    };
    let integer = |text: &str| paper_integer(table, line, text);
    let (most, block, said) = (integer(most)?, integer(block)?, table.paper.closed(line, said)?);
    if block < 1 || block > most || most > MAX_BLOCK {
        return Err(line.reject(Reason::Malformed("1 ≤ c ≤ M ≤ 12")));
    }
    let promise = table.claim.get("promise").ok_or(line.reject(Reason::NoPromise))?;
    let (assumed, _) = table.needed(at);
    // The promise may need parameters that the value does not.
    let assumed = assumed.into_iter().chain(table.unstated.keys().cloned()).collect();
    let (scope, schemes) = table.scope(at, &table.as_printed, &assumed).map_err(stopped)?;
    if schemes.is_empty() {
        return Err(line.reject(Reason::NoPromise));
    }
    let of = |key: &str| promise.text(key).map(|text| scope.value(&formula(text)?)).transpose();
    let spread = of("spread").map_err(stopped)?.ok_or(line.reject(Reason::NoPromise))?;
    let offset = of("offset").and_then(|offset| offset.map(|o| o.integer(10_000)).transpose());
    let offset = offset.map_err(stopped)?;
    let sound = Sound { table, scope: &scope, schemes: &schemes, offset };
    let (level, tolerance) = match of("level").map_err(stopped)? {
        Some(level) => (level.integer(MAX_LEVEL).map_err(stopped)?, None),
        None => (said.integer(MAX_LEVEL).map_err(stopped)?, of("tolerance").map_err(stopped)?),
    };
    if level < 0 {
        return Err(line.reject(Reason::Malformed("a level")));
    }
    let bound = sound.bound(level, most, block).map_err(stopped)?;
    let bound = bound.ok_or(line.reject(Reason::NoContraction))?;
    let bound = bound.times(&spread).map_err(stopped)?;
    let Some(tolerance) = tolerance else {
        let same = bound.plus(-1, &said).map_err(stopped)?.is_zero();
        return if same { Ok(()) } else { Err(line.reject(Reason::Value)) };
    };
    let above = bound.plus(-1, &tolerance).and_then(|above| above.sign(None)).map_err(stopped)?;
    if above > 0 { Err(line.reject(Reason::TooLarge)) } else { Ok(()) }
}

fn paper_integer(table: &Table<'_>, line: Line<'_>, text: &str) -> Checked<i64> {
    let value = table.paper.closed(line, text)?.integer(MAX_LEVEL);
    value.map_err(|stop| line.reject(Reason::Stopped(stop)))
}

struct Sound<'s> {
    table: &'s Table<'s>,
    scope: &'s Scope<'s>,
    schemes: &'s [Rc<Scheme>],
    offset: Option<i64>,
}

impl Sound<'_> {
    /// The bound at a level for β = 1; `None` if the block does not contract.
    fn bound(&self, level: i64, most: i64, block: i64) -> Result<Option<Value>, Stop> {
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
        let of =
            |scheme: &Scheme, of| greatest(self.scope, &classes(self.scope, scheme, of, false, c)?);
        match self.schemes {
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
            let moved = |alpha| gather(self.scope, &displaced(scheme, alpha, offset)?, 0);
            (0..scheme.arity()).map(moved).collect::<Result<Vec<Value>, Stop>>()
        };
        let [first, second, ..] = self.schemes else {
            return greatest(self.scope, &moved(&self.schemes[0])?);
        };
        let mut sums = Vec::new();
        for (row, beta) in second.mask.iter().zip(moved(second)?) {
            let norm = gather(self.scope, row, 0)?;
            for alpha in &moved(first)? {
                sums.push(alpha.times(&norm)?.plus(1, &beta)?);
            }
        }
        greatest(self.scope, &sums)
    }
}
