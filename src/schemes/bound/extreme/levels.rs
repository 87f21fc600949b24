//! The rows of each level that are continued.

use super::select::{Group, NEAR, Selection};
use super::step::{Steps, TINY, length, lengths, upward};

/// The most rows of a level that are continued.
const MOST: usize = 4096;

/// A level is given up that has more rows than this, of which nearly none are dropped: then the rows are on a
/// smooth curve, and all are extreme.
const FEW: usize = 256;

/// τ, as a part of the longest row.
const UNIT: f64 = 1.0 / 1024.0;

/// τ is at least this many times the error of a row, so that errors do not hide that a row is inside.
const ABOVE_ERROR: f64 = 4_194_304.0;

/// Where a row comes from: the row of the level before, and the digit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Origin {
    pub(super) parent: u32,
    pub(super) digit: u32,
}

/// What is known of one level m. All lengths are times 2^exponent.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// The groups of rows that are continued, each as one.
    pub(super) groups: Vec<Vec<Origin>>,
    /// The places of those that may have the longest row.
    pub(super) longest: Vec<usize>,
    /// Whether the longest row of all is proven to be among them.
    pub(super) proven: bool,
    exponent: i64,
    /// A bound of Σ|error| that this level adds to a row.
    rounding: f64,
    /// τ.
    unit: f64,
    /// An upper bound of the norm.
    norm: f64,
}

/// Levels 1, 2, …, and the rows of the last one in f64.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    steps: Steps,
    done: Vec<Level>,
    rows: Vec<Vec<f64>>,
    exponent: i64,
    /// Whether a level met a cap, or has lengths that f64 cannot hold.
    over: bool,
}

/// 2^e, or a power of two above it where f64 has none.
fn power_of_two(e: i64) -> f64 {
    2.0_f64.powi(i32::try_from(e.max(-1000)).unwrap_or(i32::MAX))
}

/// ⌊log_2 x⌋ of a positive normal number.
fn binary_exponent(x: f64) -> i64 {
    i64::try_from(x.to_bits() >> 52).expect("12 bits") - 1023
}

impl Levels {
    pub(super) fn new(steps: Steps) -> Levels {
        let mut first = vec![0.0; steps.size];
        first[0] = 1.0;
        Levels { steps, done: Vec::new(), rows: vec![first], exponent: 0, over: false }
    }

    /// The levels 1, 2, ….
    pub(super) fn done(&self) -> &[Level] {
        &self.done
    }

    /// Adds a level; `None` when a cap is met or the work does not suffice.
    pub(super) fn advance(&mut self, work: &mut u64) -> Option<()> {
        if self.over {
            return None;
        }
        let steps = &self.steps;
        *work = work.checked_sub(steps.work() * self.rows.len() as u64)?;
        let longest = self.rows.iter().map(|row| lengths(row)[1]).fold(0.0, f64::max);
        let of =
            |parent: u32| (0_u32..).take(steps.arity()).map(move |digit| Origin { parent, digit });
        let origins: Vec<Origin> = (0..).zip(&self.rows).flat_map(|(at, _)| of(at)).collect();
        let image = |origin: &Origin| {
            steps.image(&self.rows[origin.parent as usize], origin.digit as usize)
        };
        let mut images: Vec<Vec<f64>> = origins.iter().map(image).collect();
        let greatest = images.iter().map(|row| length(row)).fold(0.0, f64::max);
        if !(greatest > 1e-200 && greatest < 1e200) {
            self.over = true;
            return None;
        }
        // Products with a power of two are exact.
        let shift = -binary_exponent(greatest);
        let scale = power_of_two(shift);
        images.iter_mut().flatten().for_each(|x| *x *= scale);
        let exponent = self.exponent + shift;
        let rounding = upward(steps.error(longest) * scale, 1);
        let error = upward(self.sum(exponent, |level| level.rounding) + rounding, 1);
        let unit = UNIT.max(ABOVE_ERROR * error);
        let selection = Selection { unit, error, most: MOST };
        let kept = selection.keep(&images, work);
        let useful = |kept: &Vec<Group>| kept.len() <= FEW || 10 * kept.len() <= 9 * images.len();
        let Some(kept) = kept.filter(useful) else {
            self.over = true;
            return None;
        };
        // The other rows of a group are continued as its first row.
        let moved = if kept.iter().any(|group| group.len() > 1) { NEAR } else { 0.0 };
        let error = upward(error + moved, 1);
        let known: Vec<[f64; 2]> = kept.iter().map(|group| lengths(&images[group[0]])).collect();
        let least = known.iter().map(|known| known[0]).fold(0.0, f64::max) - error;
        let most = known.iter().map(|known| known[1]).fold(0.0, f64::max) + error;
        let hidden = self.greatest(exponent, |level| level.unit).max(unit);
        let longest = (0..kept.len()).filter(|&i| known[i][1] + 2.0 * error >= least);
        self.done.push(Level {
            longest: longest.collect(),
            proven: hidden < least * (1.0 - 1e-12),
            exponent,
            rounding: upward(rounding + moved, 1),
            unit,
            norm: upward(most.max(hidden), 4),
            groups: kept.iter().map(|group| group.iter().map(|&i| origins[i]).collect()).collect(),
        });
        self.rows = kept.into_iter().map(|group| std::mem::take(&mut images[group[0]])).collect();
        self.exponent = exponent;
        Some(())
    }

    /// For each level k so far its number times ‖R^{m−k}‖, where m is the level after the last one, at the
    /// scale of m; rounded up.
    fn products<'a>(
        &'a self,
        exponent: i64,
        number: impl Fn(&Level) -> f64 + 'a,
    ) -> impl Iterator<Item = f64> + 'a {
        // Level k = 1 meets the norm of m − 1 levels, the last one so far.
        self.done.iter().zip(self.done.iter().rev()).map(move |(level, rest)| {
            let scale = power_of_two(exponent - level.exponent - rest.exponent);
            upward(number(level) * rest.norm * scale, 4)
        })
    }

    fn sum(&self, exponent: i64, number: impl Fn(&Level) -> f64) -> f64 {
        upward(self.products(exponent, number).sum(), self.done.len())
    }

    fn greatest(&self, exponent: i64, number: impl Fn(&Level) -> f64) -> f64 {
        self.products(exponent, number).fold(TINY, f64::max)
    }
}
