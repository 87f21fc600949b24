//! Luck: how many cells readings of unrelated values would explain.

use super::dependence::dependent;
use crate::kinds::table::claim::{Cells, Read, Table};
use crate::numbers::{Q, Value, telling_part};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::collections::BTreeMap;

/// Wrong depths are often a level or two off.
const DEPTHS: i64 = 4;

/// The most digits of a number that count.
const MAX_DIGITS: usize = 18;

/// The binary logarithm of the greatest number x of the bound.
const MAX_DOUBLINGS: usize = 128;

/// A reading is luck if a thousandth of the tables of unrelated values, or more, have one as good.
const RARE: u64 = 1_000;

/// How many times as rare as another cell that tells something a cell may be that it depends on.
const MOST_TIMES: u64 = 10;

/// The telling numbers of cells: of each, one of how many values at least becomes it, and how many cells it has.
pub struct Evidence {
    numbers: Vec<(u64, usize)>,
    /// The number of cells that tell nothing.
    silent: usize,
}

/// The evidence of the same cells for readings that bring no constant, and for others.
pub struct BothEvidence {
    by_choices: Evidence,
    /// Where it is another one.
    with_constants: Option<Evidence>,
}

impl BothEvidence {
    /// The evidence of cells with these values as printed; without values, and for depths, it is the same for all readings.
    pub fn new(
        table: &Table<'_>,
        cells: &Cells,
        as_printed: Option<&[Option<Value>]>,
    ) -> Result<BothEvidence, Stop> {
        let values = as_printed.filter(|_| table.tolerance.is_none());
        let with_constants = values.map(|values| Evidence::new(table, cells, Some(values)));
        let by_choices = Evidence::new(table, cells, None)?;
        Ok(BothEvidence { by_choices, with_constants: with_constants.transpose()? })
    }

    /// That for readings which bring constants, or not.
    pub fn of(&self, constants: bool) -> &Evidence {
        self.with_constants.as_ref().filter(|_| constants).unwrap_or(&self.by_choices)
    }
}

impl Read {
    /// Whether a constant of this reading may fit by luck: it has a difference that is no choice, or another parameter.
    pub fn brings_constants(&self) -> bool {
        let choice = |difference: &String| !difference.contains(['@', '#']);
        !self.parameters.is_empty() || !self.differences.iter().all(choice)
    }
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
    /// column. `as_printed` are the values of the cells as printed, where cells may depend on each other by these.
    pub fn new(
        table: &Table<'_>,
        cells: &Cells,
        as_printed: Option<&[Option<Value>]>,
    ) -> Result<Evidence, Stop> {
        let is_depth = table.tolerance.is_some();
        let (mut telling, mut values, mut rarities) = (Cells::new(), Vec::new(), Vec::new());
        let mut same = BTreeMap::<(String, Option<usize>, Option<usize>), Vec<usize>>::new();
        for (at, (place, decimal)) in cells.iter().enumerate() {
            let (rarity, number) = if is_depth {
                (rarity_of_depth(&decimal.value), decimal.value.to_string())
            } else {
                let part = telling_part(decimal).to_string();
                (rarity(&part).unwrap_or(1), part)
            };
            if rarity == 1 {
                continue;
            }
            let lines = [(Some(place.0), None), (None, Some(place.1))];
            for (row, column) in if is_depth { &lines[..] } else { &[(None, None)] } {
                same.entry((number.clone(), *row, *column)).or_default().push(telling.len());
            }
            telling.push((*place, decimal.clone()));
            values.push(as_printed.and_then(|values| values[at].clone()));
            rarities.push(rarity);
        }
        let mut sets: Vec<Vec<usize>> = same.into_values().collect();
        let dependent = dependent(table, &telling, &values)?;
        // Of what depends on each other, the least rare cells tell nothing.
        let mut told = vec![true; telling.len()];
        for class in united(telling.len(), &dependent) {
            let most = class.iter().map(|at| rarities[*at]).max().unwrap_or(1);
            for at in class {
                told[at] = rarities[at] >= most / MOST_TIMES;
            }
        }
        sets.extend(dependent);
        let mut numbers = Vec::new();
        for class in united(telling.len(), &sets) {
            let told = class.iter().filter(|at| told[**at]).map(|at| rarities[*at]);
            if let Some(least) = told.clone().min() {
                numbers.push((least, told.count()));
            }
        }
        let telling: usize = numbers.iter().map(|(_, size)| *size).sum();
        Ok(Evidence { numbers, silent: cells.len() - telling })
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

/// The numbers below `count`, in classes: those in one set, and what such sets join, are one.
fn united(count: usize, sets: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut of: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (set, numbers) in sets.iter().enumerate() {
        for number in numbers {
            of[*number].push(set);
        }
    }
    let (mut seen, mut used) = (vec![false; count], vec![false; sets.len()]);
    let mut classes = Vec::new();
    for start in 0..count {
        let (mut class, mut next) = (Vec::new(), vec![start]);
        while let Some(number) = next.pop() {
            if std::mem::replace(&mut seen[number], true) {
                continue;
            }
            class.push(number);
            for set in &of[number] {
                if !std::mem::replace(&mut used[*set], true) {
                    next.extend(&sets[*set]);
                }
            }
        }
        if !class.is_empty() {
            classes.push(class);
        }
    }
    classes
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
