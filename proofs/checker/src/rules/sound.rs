//! Rule `sound`: what a table promises, at a level or for a tolerance, as it is kept.

use super::place;
use crate::convolution::classes;
use crate::displacement::{displaced, gather};
use crate::evaluate::Scope;
use crate::functions::greatest;
use crate::reject::{Checked, Reason, Stop, require};
use crate::scheme::{Scheme, formula, total};
use crate::table::Table;
use crate::value::Value;
use std::rc::Rc;

/// The most levels of a bound.
const MAX_LEVEL: i64 = 10_000;

/// The most levels whose constants are computed.
const MAX_BLOCK: i64 = 12;

/// Checks `ROW COLUMN M c VALUE`.
pub fn check(table: &Table<'_>, said: &str) -> Checked<()> {
    let (at, said) = place(table, said)?;
    let [most, block, said] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(Reason::Malformed("ROW COLUMN M c VALUE").into());
    };
    let most = table.paper.number(most)?.integer(MAX_LEVEL)?;
    let block = table.paper.number(block)?.integer(MAX_LEVEL)?;
    let said = table.paper.number(said)?;
    let proper = 1 <= block && block <= most && most <= MAX_BLOCK;
    require(proper, Reason::Malformed("1 ≤ c ≤ M ≤ 12"))?;
    let promise = table.claim.get("promise").ok_or(Reason::NoPromise)?;
    // The promise may need parameters that the value does not.
    let assumed = table.unstated.keys().cloned().collect();
    let (scope, schemes) = table.scope(at, &table.as_printed, &assumed)?;
    require(!schemes.is_empty(), Reason::NoPromise)?;
    let of = |key: &str| promise.text(key).map(|text| scope.value(&formula(text)?)).transpose();
    let spread = of("spread")?.ok_or(Reason::NoPromise)?;
    let offset = of("offset")?.map(|offset| offset.integer(10_000)).transpose()?;
    let (level, tolerance) = match of("level")? {
        Some(level) => (level.integer(MAX_LEVEL)?, None),
        None => (said.integer(MAX_LEVEL)?, of("tolerance")?),
    };
    require(level >= 0, Reason::Malformed("a level"))?;
    let sound = Sound { table, scope: &scope, schemes: &schemes, offset };
    let bound = sound.bound(level, most, block)?.ok_or(Reason::NoContraction)?.times(&spread)?;
    match tolerance {
        None => require(bound.equals(&said)?, Reason::Value),
        Some(tolerance) => require(bound.compare(&tolerance)?.is_le(), Reason::TooLarge),
    }
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
        let rest = Value::int(1).minus(&upper[place(block)])?;
        if rest.sign(None)? <= 0 {
            return Ok(None);
        }
        while upper.len() < place(level + block) {
            let mut least = upper[1].times(&upper[upper.len() - 1])?;
            for j in 2..=place(most) {
                let next = upper[j].times(&upper[upper.len() - j])?;
                self.scope.library.spend(next.cost(&next))?;
                least = if next.compare(&least)?.is_lt() { next } else { least };
            }
            upper.push(least);
        }
        let sum = total(&upper[place(level)..place(level + block)])?;
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
