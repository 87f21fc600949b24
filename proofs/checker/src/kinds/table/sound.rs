//! The rule `sound`: a sound bound, beside the one that a table promises.

use super::claim::{Bounds, Place, Table};
use crate::claims::Paper;
use crate::data::{gather, moved};
use crate::formulas::{Scope, formula};
use crate::numbers::Value;
use crate::schemes::{MAX_OFFSET, Scheme};
use crate::text::{Checked, Reason, Stop, compare, require, words};
use std::cell::RefCell;
use std::rc::Rc;

/// The greatest level of a bound.
pub const MAX_LEVEL: u32 = 10_000;

/// The most levels whose constants are computed.
const MAX_BLOCK: i64 = 12;

/// The level of a bound. It has a cap.
pub fn level(level: i64) -> Checked<u32> {
    require(level >= 0, Reason::Malformed("a level"))?;
    let level = u32::try_from(level).ok().filter(|level| *level <= MAX_LEVEL);
    Ok(level.ok_or(Stop::Capped("the level of a promise"))?)
}

/// Checks `ROW COLUMN M c VALUE`.
pub fn check<'a>(table: &'a Table<'a>, said: &str) -> Checked<()> {
    let (at, said) = table.place(said)?;
    let said = said.rsplit_once(' ').ok_or(Reason::Malformed("ROW COLUMN M c VALUE"))?;
    let (constants, said) = (said.0, table.paper.number(said.1)?);
    let promised = Promised::new(table, at)?;
    let level = promised.level.map_or_else(|| said.integer(i64::MAX), Ok)?;
    let bound = promised.bound(level, constants)?;
    match promised.tolerance {
        None => compare(bound.equals(&said)?, &said, &bound, Reason::Value),
        Some(most) => compare(bound.compare(&most)?.is_le(), &bound, &most, Reason::TooLarge),
    }
}

/// The promise of a table at a cell, or the claim of a theorem.
pub struct Promised<'t> {
    /// The paper.
    pub paper: &'t Paper<'t>,
    /// The bounds that are known.
    pub bounds: &'t RefCell<Bounds>,
    /// The scope. That of a cell has all assumptions.
    pub scope: Scope<'t>,
    /// The factors of the scheme. A ring has none.
    pub schemes: Vec<Rc<Scheme>>,
    /// The offset at which polygons are compared with the limit, if it is not the scheme's own.
    pub offset: Option<i64>,
    /// The spread β.
    pub spread: Value,
    /// The level, if the printed number is a bound.
    pub level: Option<i64>,
    /// The tolerance, if it is a depth.
    pub tolerance: Option<Value>,
}

impl<'t> Promised<'t> {
    /// The promise at a cell.
    pub fn new(table: &'t Table<'t>, at: Place) -> Checked<Promised<'t>> {
        let promise = table.claim.get("promise").ok_or(Reason::NoPromise)?;
        // The promise may need parameters that the value does not.
        let (scope, schemes) = table.scope(at, &table.as_printed, &table.unstated)?;
        let of = |key: &str| promise.text(key).map(|text| scope.value(&formula(text)?)).transpose();
        let integer = |key, most| of(key)?.map(|value: Value| value.integer(most)).transpose();
        let (offset, level) = (integer("offset", MAX_OFFSET)?, integer("level", i64::MAX)?);
        let spread = of("spread")?;
        let spread = spread.ok_or(Reason::NoPromise)?;
        require(spread.sign(None)? >= 0, Reason::NegativeSpread)?;
        let tolerance = of("tolerance")?.filter(|_| level.is_none());
        let Table { paper, bounds, .. } = table;
        Ok(Promised { paper, bounds, scope, schemes, offset, spread, level, tolerance })
    }

    /// The level, and the most that is promised for it, where this number is printed.
    pub fn stated(&self, printed: Value) -> Checked<(i64, Value)> {
        Ok(match &self.tolerance {
            Some(tolerance) => (printed.integer(i64::MAX)?, tolerance.clone()),
            None => (self.level.ok_or(Reason::NoPromise)?, printed),
        })
    }

    /// The bound at a level that the constants `M c` give.
    pub fn bound(&self, level: i64, constants: &str) -> Checked<Value> {
        let constants = words(constants, "M c")?.map(|word| word.parse().ok());
        Ok(self.for_unit(level, constants)?.times(&self.spread)?)
    }

    /// The same for β = 1, by M and c.
    pub fn for_unit(&self, level: i64, [most, block]: [Option<i64>; 2]) -> Checked<Value> {
        let proper =
            |(most, block): &(i64, i64)| 1 <= *block && block <= most && *most <= MAX_BLOCK;
        let numbers = most.zip(block).filter(proper);
        let (most, block) = numbers.ok_or(Reason::Malformed("1 ≤ c ≤ M ≤ 12"))?;
        let level = i64::from(self::level(level)?);
        require(!self.schemes.is_empty(), Reason::NoPromise)?;
        Ok(self.of_block(level, most, block)?.ok_or(Reason::NoContraction)?)
    }

    /// The bound at a level for β = 1; `None` if the block does not contract.
    fn of_block(&self, level: i64, most: i64, block: i64) -> Result<Option<Value>, Stop> {
        let place = |value: i64| usize::try_from(value).unwrap_or(0);
        let key = self.schemes.iter().map(|scheme| Rc::as_ptr(scheme) as usize).collect();
        let mut known = self.bounds.borrow_mut();
        // The U_m·d^m are integers for this d. Integers are quicker to multiply and to compare.
        let upper = known.entry((key, most)).or_default();
        let rules = self.schemes.iter().flat_map(|s| s.mask.iter().chain(&s.difference));
        let d = Value::denominator(rules.flatten())?;
        let d = if self.schemes.len() > 1 { d.times(&d)? } else { d };
        if upper.is_empty() {
            let constant = |c| self.constant(&Value::int(c))?.times(&d.power(c)?);
            upper.extend((0..=most).map(constant).collect::<Result<Vec<Value>, Stop>>()?);
        }
        // rest = (1 − U_c)·d^c
        let rest = d.power(block)?.minus(&upper[place(block)])?;
        if rest.sign(None)? <= 0 {
            return Ok(None);
        }
        let end = level.checked_add(block).ok_or(Stop::Capped("the level of a promise"))?;
        while upper.len() < place(end) {
            let product = |j: usize| {
                let next = upper[j].times(&upper[upper.len() - j])?;
                self.scope.spend(next.cost(&next))?;
                Ok::<Value, Stop>(next)
            };
            let mut least = product(1)?;
            for j in 2..=place(most) {
                let next = product(j)?;
                least = if next.compare(&least)?.is_lt() { next } else { least };
            }
            upper.push(least);
        }
        let later = &upper[place(level)..place(end)];
        let sum = later.iter().try_fold(Value::int(0), |sum, u| sum.times(&d)?.plus(1, u))?;
        // The sum is Σ_m U_m·d^(level + block − 1).
        let sum = sum.times(&d)?.over(&d.power(level)?)?;
        self.factor()?.times(&sum)?.over(&rest).map(Some)
    }

    /// T_c, or for two factors the larger of the products of T_c of one and Λ_c of the other.
    pub fn constant(&self, c: &Value) -> Result<Value, Stop> {
        let of = |rules| self.paper.library.products.greatest(rules, c);
        match &self.schemes[..] {
            [first, second, ..] => {
                let one = of(&first.difference)?.times(&of(&second.mask)?)?;
                one.max(&of(&second.difference)?.times(&of(&first.mask)?)?, None)
            }
            one => of(&one[0].difference),
        }
    }

    /// σ, or for two factors the greatest ς_αλ_β + ς_β.
    pub fn factor(&self) -> Result<Value, Stop> {
        let moved = |scheme: &Scheme| {
            let offset = self.offset.unwrap_or(scheme.offset);
            moved(self.paper.library.meter, None, (scheme, offset), 0)
        };
        let [first, second, ..] = &self.schemes[..] else {
            return Value::greatest(&moved(&self.schemes[0])?, None);
        };
        let mut sums = Vec::new();
        for (row, beta) in second.mask.iter().zip(moved(second)?) {
            let norm = gather(None, row, 0)?;
            for alpha in &moved(first)? {
                sums.push(alpha.times(&norm)?.plus(1, &beta)?);
            }
        }
        Value::greatest(&sums, None)
    }
}
