//! Luck: how many cells readings of unrelated values would explain.

use crate::kinds::table::claim::{Cells, Place, Table};
use crate::numbers::{Q, telling_part};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::collections::{BTreeMap, BTreeSet};

/// Wrong depths are often a level or two off.
const DEPTHS: i64 = 4;

/// The most digits of a number that count.
const MAX_DIGITS: usize = 18;

/// The binary logarithm of the greatest number x of the bound.
const MAX_DOUBLINGS: usize = 128;

/// A reading is luck if a thousandth of the tables of unrelated values, or more, have one as good.
const RARE: u64 = 1_000;

/// The telling numbers of cells: of each, one of how many values becomes it, and how many cells it has.
pub struct Evidence {
    numbers: Vec<(u64, usize)>,
    /// The number of cells that tell nothing.
    silent: usize,
}

/// One of how many unrelated values is a depth of so many levels.
fn rarity_of_depth(value: &Q) -> u64 {
    value.floor().to_i64().unwrap_or(DEPTHS).clamp(1, DEPTHS).unsigned_abs()
}

/// One of how many unrelated values becomes a number with these digits of its telling part.
fn rarity(digits: &str) -> Option<u64> {
    let first: u64 = digits.get(..MAX_DIGITS).unwrap_or(digits).parse().ok()?;
    Some(first.checked_mul(2)?.max(1))
}

impl Evidence {
    /// The evidence of cells. Those with the same telling part are one number; equal depths are if they are in one row or
    /// column, or joined by such pairs.
    pub fn new(table: &Table<'_>, cells: &Cells) -> Evidence {
        let is_depth = table.tolerance.is_some();
        let (mut places, mut silent) = (BTreeMap::<String, (u64, Vec<Place>)>::new(), 0);
        for (place, decimal) in cells {
            let (rarity, number) = if is_depth {
                (rarity_of_depth(&decimal.value), decimal.value.to_string())
            } else {
                let part = telling_part(decimal).to_string();
                (rarity(&part).unwrap_or(1), part)
            };
            if rarity == 1 {
                silent += 1;
            } else {
                places.entry(number).or_insert((rarity, Vec::new())).1.push(*place);
            }
        }
        let mut numbers = Vec::new();
        for (rarity, places) in places.into_values() {
            let sizes = if is_depth { joined(&places) } else { vec![places.len()] };
            numbers.extend(sizes.into_iter().map(|size| (rarity, size)));
        }
        Evidence { numbers, silent }
    }

    /// Whether m of these cells have two telling numbers, whichever cells they are.
    pub fn are_several(&self, m: usize) -> bool {
        let most = self.numbers.iter().map(|(_, size)| *size).max().unwrap_or(0);
        m > self.silent.saturating_add(most)
    }

    /// Whether m of these cells are enough: they have two telling numbers, or all cells have no two.
    pub fn are_enough(&self, m: usize) -> bool {
        self.numbers.len() < 2 || self.are_several(m)
    }

    /// Whether m of these cells may be luck for F readings: at every x = 1, 2, 4, …, 2^128,
    /// 1000·F·Π (N_i − 1 + x^{s_i}) > x^j·Π N_i, where s_i cells have the i-th number, of a rarity N_i,
    /// and j is m less the cells that tell nothing.
    pub fn is_luck(&self, table: &Table<'_>, m: usize, readings: &Q) -> Result<bool, Stop> {
        let told = m.saturating_sub(self.silent);
        table.paper.library.meter.spend((MAX_DOUBLINGS * (self.numbers.len() + 1)) as u64)?;
        let [below, above] = [false, true].map(|up| {
            let factors = self.numbers.iter().map(|number| Near::of(&number.0.into(), up));
            factors.fold(Near::ONE, |all, factor| all.times(factor, up))
        });
        let most = [false, true]
            .map(|up| Near::of(&readings.to_integer(), up).times(Near::of(&RARE.into(), up), up));
        let mut undecided = false;
        for doublings in 0..=MAX_DOUBLINGS {
            let [low, high] = [false, true].map(|up| {
                let factors = self.numbers.iter();
                let factors = factors.map(|(n, size)| Near::shifted(n - 1, doublings * size, up));
                factors.fold(most[usize::from(up)], |all, factor| all.times(factor, up))
            });
            let power = ((doublings * told) as u64).cast_signed();
            if high <= below.doubled(power) {
                return Ok(false);
            }
            undecided |= low <= above.doubled(power);
        }
        if undecided { Err(Stop::Undecided("whether a reading is luck")) } else { Ok(true) }
    }
}

/// The sizes of the sets of places that rows and columns join.
fn joined(places: &[Place]) -> Vec<usize> {
    let (mut rows, mut columns) = (BTreeMap::new(), BTreeMap::new());
    for &(row, column) in places {
        rows.entry(row).or_insert_with(Vec::new).push((row, column));
        columns.entry(column).or_insert_with(Vec::new).push((row, column));
    }
    let mut left: BTreeSet<Place> = places.iter().copied().collect();
    let mut sizes = Vec::new();
    while let Some(start) = left.pop_first() {
        let (mut size, mut next) = (1, vec![start]);
        while let Some((row, column)) = next.pop() {
            let near = [rows.remove(&row), columns.remove(&column)];
            for place in near.into_iter().flatten().flatten().filter(|place| left.remove(place)) {
                size += 1;
                next.push(place);
            }
        }
        sizes.push(size);
    }
    sizes
}

/// A positive number mantissa·2^exponent, with a mantissa from 2^63 to 2^64 once it is rounded.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Near {
    exponent: i64,
    mantissa: u128,
}

impl Near {
    const ONE: Near = Near { exponent: -63, mantissa: 1 << 63 };

    /// This number times a power of two.
    fn doubled(self, times: i64) -> Near {
        Near { exponent: self.exponent + times, ..self }
    }

    /// The nearest number with 64 binary digits from below, or from above.
    fn rounded(self, up: bool) -> Near {
        let Near { exponent, mantissa } = self;
        let bits = 128 - mantissa.leading_zeros();
        if bits <= 64 {
            let places = 64 - bits;
            return Near { exponent: exponent - i64::from(places), mantissa: mantissa << places };
        }
        let places = bits - 64;
        let (cut, exponent) = (mantissa >> places, exponent + i64::from(places));
        if up && cut << places != mantissa {
            return Near { exponent, mantissa: cut + 1 }.rounded(up);
        }
        Near { exponent, mantissa: cut }
    }

    fn times(self, other: Near, up: bool) -> Near {
        let mantissa = self.mantissa * other.mantissa;
        Near { exponent: self.exponent + other.exponent, mantissa }.rounded(up)
    }

    /// A positive integer.
    fn of(integer: &BigInt, up: bool) -> Near {
        let integer = integer.magnitude();
        let places = integer.bits().saturating_sub(100);
        let cut = integer >> places;
        let more = up && &cut << places != *integer;
        let mantissa = cut.to_u128().unwrap_or(0) + u128::from(more);
        Near { exponent: places.cast_signed(), mantissa }.rounded(up)
    }

    /// 2^power + more.
    fn shifted(more: u64, power: usize, up: bool) -> Near {
        let Some(places) = power.checked_sub(100) else {
            return Near { exponent: 0, mantissa: (1 << power) + u128::from(more) }.rounded(up);
        };
        let part = u32::try_from(places).ok().and_then(|places| more.checked_shr(places));
        let part = u128::from(part.unwrap_or(0)) + u128::from(up);
        Near { exponent: (places as u64).cast_signed(), mantissa: (1 << 100) + part }.rounded(up)
    }
}
