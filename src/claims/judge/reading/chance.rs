//! How likely a reading explains a table by luck.

use crate::claim::Printed;
use crate::exact::{Integer, Rational};
use crate::finding::{Explanation, Values};
use crate::judge::reading::dependence::{self, Known};
use crate::judge::reading::space::{PrintedCells, ReadingSpace};
use std::collections::BTreeMap;

/// A reading is reported if luck gives as good a reading in at most one of this many tables of
/// unrelated numbers.
const MOST_LUCK: i64 = 1_000;

/// The number of values that a wrong reading of a depth is thought to give with the same
/// likelihood: it is often a level or two off.
const LIKELY_DEPTHS: i64 = 4;

/// The most digits of a number that count.
const MOST_DIGITS: usize = 18;

/// How many times as rare as another cell that tells something a cell may be that a constant connects with it.
const MOST_TIMES: u64 = 10;

/// The greatest binary logarithm of the number x of [`Evidence::chance`].
const MOST_DOUBLINGS: u32 = 128;

/// The smallest chance that is told is 2^−4096.
const LEAST_CHANCE: i64 = -4_096;

/// The one in how many unrelated values, at most, that becomes this printed number. For a depth of k levels it is 4
/// or, if that is less, k. For another number this is 2M with the integer M that `Decimal::telling_part` gives: by
/// Benford's law, log_10(1 + 1/M) ≤ 1/(2M) of all values begin with the digits M, and simple values are likely. If it is 1,
/// the number tells nothing; this holds for one that is printed as 0.
pub(crate) fn one_in(printed: &Printed, is_depth: bool) -> u64 {
    if is_depth {
        let depth = printed.decimal.value().floor().to_i64();
        return depth.unwrap_or(LIKELY_DEPTHS).clamp(1, LIKELY_DEPTHS).unsigned_abs();
    }
    rarity(&printed.decimal.telling_part())
}

/// The same for a number that is no depth, with this telling part.
fn rarity(part: &Integer) -> u64 {
    let digits = part.to_string();
    // It has digits alone, of which those that count fit into the type.
    let first = digits[..digits.len().min(MOST_DIGITS)].parse::<u64>();
    first.map_or(1, |digits| (2 * digits).max(1))
}

/// What cells tell of a reading that explains so many of them.
pub(crate) struct Evidence {
    /// Of each class of printed numbers that tell something, the one in how many values, at least, that becomes one of
    /// them, and in how many cells they stand.
    numbers: Vec<(u64, usize)>,
    /// How many cells tell nothing.
    silent: usize,
}

impl Evidence {
    /// The evidence of the printed cells that `counts` holds for, in a table of depths or of other
    /// values. Cells that a constant connects with the values `as_printed` are one number.
    pub(crate) fn new(
        printed: &PrintedCells<'_>,
        is_depth: bool,
        as_printed: Option<&Values>,
        counts: impl Fn(usize, usize) -> bool,
    ) -> Evidence {
        let places = printed.iter().enumerate().flat_map(|(row, cells)| {
            cells.iter().enumerate().map(move |(column, cell)| (*cell, (row, column)))
        });
        let places = places.filter(|(_, (row, column))| counts(*row, *column));
        let value = |(row, column): (usize, usize)| as_printed?[row][column].as_ref();
        Evidence::of(places.filter_map(|(printed, place)| {
            Some((Known { place, printed: printed?, value: value(place) }, is_depth))
        }))
    }

    /// The evidence of these cells, each with whether it is a depth.
    ///
    /// Printed numbers with the same telling part are one number, wherever they stand and however they are written. So
    /// are equal depths in one row or column, other numbers that a constant connects with the printed text
    /// ([`dependence::connected`]), and those that are connected in this way.
    pub(crate) fn of<'p>(cells: impl IntoIterator<Item = (Known<'p>, bool)>) -> Evidence {
        let (mut all, mut known, mut silent) = (Vec::new(), Vec::new(), 0);
        for (cell, is_depth) in cells {
            let decimal = &cell.printed.decimal;
            let (one_in, number) = if is_depth {
                (one_in(cell.printed, true), decimal.value().to_string())
            } else {
                let part = decimal.telling_part();
                (rarity(&part), part.to_string())
            };
            if one_in == 1 {
                silent += 1;
                continue;
            }
            all.push((one_in, number, is_depth));
            known.push(cell);
        }
        let (mut classes, mut connected) = (Classes::new(all.len()), Classes::new(all.len()));
        for set in dependence::connected(&known) {
            for at in &set {
                connected.join(set[0], *at);
            }
        }
        let mut rarest = vec![0; all.len()];
        for (at, (one_in, ..)) in all.iter().enumerate() {
            let most = &mut rarest[connected.root(at)];
            *most = (*most).max(*one_in);
        }
        let mut first = BTreeMap::new();
        for (at, (_, number, is_depth)) in all.iter().enumerate() {
            let (row, column) = known[at].place;
            classes.join(at, connected.root(at));
            let lines = [(Some(row), None), (None, Some(column))];
            for line in if *is_depth { &lines[..] } else { &[(None, None)] } {
                classes.join(at, *first.entry((number, *line)).or_insert(at));
            }
        }
        let mut numbers: Vec<(u64, usize)> = vec![(u64::MAX, 0); all.len()];
        for (at, (one_in, ..)) in all.iter().enumerate() {
            // Of what a constant connects, the least rare cells tell nothing.
            if *one_in < rarest[connected.root(at)] / MOST_TIMES {
                silent += 1;
                continue;
            }
            let (least, cells) = &mut numbers[classes.root(at)];
            (*least, *cells) = ((*least).min(*one_in), *cells + 1);
        }
        numbers.retain(|(_, cells)| *cells > 0);
        Evidence { numbers, silent }
    }

    /// How many cells these are.
    pub(crate) fn cells(&self) -> usize {
        self.silent + self.numbers.iter().map(|(_, cells)| cells).sum::<usize>()
    }

    /// Whether a reading that explains `m` of these cells explains two printed numbers that tell
    /// something, whichever cells they are.
    pub(crate) fn are_several(&self, m: usize) -> bool {
        let most = self.numbers.iter().map(|(_, cells)| *cells).max();
        m.saturating_sub(self.silent) > most.unwrap_or(0)
    }

    /// Whether `m` of these cells may be all that a reading explains: they have two printed numbers that tell
    /// something, or there are no two. One number of several is no explanation, whatever its odds are.
    pub(crate) fn are_enough(&self, m: usize) -> bool {
        self.numbers.len() < 2 || self.are_several(m)
    }

    /// An upper bound of how many readings of unrelated values explain `m` of these cells:
    /// candidates · min Π (1 − p_i + p_i·x^(s_i)) / x^j over x = 1, 2, 4, …, 2^128, where the
    /// candidates are the readings, each with every value of a recovered parameter that is as plain
    /// as its own; s_i cells have the i-th printed number, p_i is how likely an unrelated value
    /// becomes it, and j is m less the number of cells that tell nothing (`proofs/THEOREMS.md`, 51).
    ///
    /// It is rounded up to 1/N, with an integer N of two digits that are not 0, or to an integer.
    pub(crate) fn chance(&self, m: usize, candidates: &Integer) -> Rational {
        let told = (m.saturating_sub(self.silent) as u64).cast_signed();
        let at = |doublings: u32| {
            let factors = self.numbers.iter().map(|(one_in, cells)| {
                let power = u64::from(doublings) * *cells as u64;
                Rough::power_plus(power, one_in - 1)
            });
            let product = factors.fold(Rough::ONE, |all, factor| all.times(factor, true));
            product.halved(told * i64::from(doublings))
        };
        let least = (0..=MOST_DOUBLINGS).map(at).min().unwrap_or(Rough::ONE);
        let all = self.numbers.iter().map(|(one_in, _)| Rough::from(*one_in));
        let all = all.fold(Rough::ONE, |all, factor| all.times(factor, false));
        least.over(all).times(Rough::at_least(candidates), true).plain()
    }
}

/// The evidence of the same cells for readings of both kinds.
pub(crate) struct BothEvidence {
    /// For those that bring no constant.
    by_choices: Evidence,
    /// For those that may hit a constant by luck, and with it all cells that it connects with the printed text; `None`
    /// where it connects none.
    with_constants: Option<Evidence>,
}

impl BothEvidence {
    /// The evidence of the printed cells of these readings that `counts` holds for. No constant connects depths, and
    /// recovered values are such constants themselves: the printed text is a reading like the others there.
    pub(crate) fn new(
        space: &ReadingSpace<'_>,
        counts: impl Fn(usize, usize) -> bool,
    ) -> BothEvidence {
        let (printed, is_depth) = (space.printed, space.is_depth());
        let of = |values: Option<&Values>| Evidence::new(printed, is_depth, values, &counts);
        let connects = space.assume.is_empty() && !is_depth;
        let with_constants = connects.then(|| of(Some(&space.as_printed)));
        BothEvidence { by_choices: of(None), with_constants }
    }

    /// How many cells these are.
    pub(crate) fn cells(&self) -> usize {
        self.by_choices.cells()
    }

    /// The evidence for a reading.
    pub(crate) fn of(&self, reading: Option<&Explanation>) -> &Evidence {
        let constants = reading.is_some_and(Explanation::brings_constants);
        self.with_constants.as_ref().filter(|_| constants).unwrap_or(&self.by_choices)
    }
}

/// Classes of cells: for each cell an earlier one of its class, or itself.
struct Classes(Vec<usize>);

impl Classes {
    /// Each cell has its own class.
    fn new(cells: usize) -> Classes {
        Classes((0..cells).collect())
    }

    /// Makes the classes of two cells one.
    fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.root(one), self.root(other));
        self.0[one.max(other)] = one.min(other);
    }

    /// The first cell of the class of a cell. The links to it become shorter.
    fn root(&mut self, mut at: usize) -> usize {
        while self.0[at] != at {
            self.0[at] = self.0[self.0[at]];
            at = self.0[at];
        }
        at
    }
}

/// Whether a chance is so small that a reading is reported.
pub(crate) fn is_small(chance: &Rational) -> bool {
    *chance <= Rational::new(1, MOST_LUCK)
}

/// A positive number m·2^e with 2^63 ≤ m < 2^64, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Rough {
    exponent: i64,
    mantissa: u64,
}

impl Rough {
    const ONE: Rough = Rough { exponent: -63, mantissa: 1 << 63 };

    /// The number m·2^e, rounded up or down.
    fn new(mantissa: u128, exponent: i64, up: bool) -> Rough {
        let excess = 64 - i64::from(mantissa.leading_zeros());
        let (high, low) = match u32::try_from(excess) {
            Ok(excess) => (mantissa >> excess, mantissa & ((1 << excess) - 1)),
            Err(_) => (mantissa << excess.unsigned_abs(), 0),
        };
        let exponent = exponent + excess;
        match u64::try_from(high + u128::from(up && low > 0)) {
            Ok(mantissa) => Rough { exponent, mantissa },
            Err(_) => Rough { exponent: exponent + 1, mantissa: 1 << 63 },
        }
    }

    /// 2^power plus a number, rounded up.
    fn power_plus(power: u64, more: u64) -> Rough {
        if power < 127 {
            return Rough::new((1 << power) + u128::from(more), 0, true);
        }
        let places = u32::try_from(power - 63).unwrap_or(u32::MAX);
        let more = more.checked_shr(places).unwrap_or(0);
        Rough::new((1 << 63) + u128::from(more) + 1, power.cast_signed() - 63, true)
    }

    /// A number that is no less than a positive integer.
    fn at_least(integer: &Integer) -> Rough {
        let excess = u32::try_from(integer.bits().saturating_sub(64)).unwrap_or(u32::MAX);
        let high = integer.shifted_right(excess).to_i128().unwrap_or(1);
        Rough::new(high.unsigned_abs() + u128::from(excess > 0), i64::from(excess), true)
    }

    fn times(self, other: Rough, up: bool) -> Rough {
        let product = u128::from(self.mantissa) * u128::from(other.mantissa);
        Rough::new(product, self.exponent + other.exponent, up)
    }

    /// The quotient, rounded up.
    fn over(self, other: Rough) -> Rough {
        let quotient = (u128::from(self.mantissa) << 64) / u128::from(other.mantissa) + 1;
        Rough::new(quotient, self.exponent - 64 - other.exponent, true)
    }

    /// This number over a power of two.
    fn halved(self, times: i64) -> Rough {
        Rough { exponent: self.exponent - times, ..self }
    }

    /// As a reciprocal of an integer with two digits that are not 0, or as an integer, rounded up.
    fn plain(self) -> Rational {
        let exponent = self.exponent.max(LEAST_CHANCE);
        let size = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
        let (mantissa, power) = (
            Rational::from(Integer::from_words(&[self.mantissa])),
            Integer::one().shifted_left(size),
        );
        if exponent > 0 {
            return mantissa * Rational::from(power);
        }
        let value = mantissa / Rational::from(power);
        if value >= Rational::one() {
            return Rational::from(value.ceil());
        }
        let often = value.recip().floor().to_string();
        let zeros = u32::try_from(often.len().saturating_sub(2)).unwrap_or(0);
        let unit = Integer::power_of_ten(zeros);
        let first = value.recip().floor().div_floor(&unit);
        Rational::new(Integer::one(), first * unit)
    }
}

impl From<u64> for Rough {
    fn from(number: u64) -> Rough {
        Rough::new(number.into(), 0, false)
    }
}
