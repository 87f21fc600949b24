//! The operator of a search, scaled so that its rows sum to 1 if possible.

use crate::exact::{CommonDenominator, Integer, Rational};
use crate::scheme::Rules;

/// The number of binary digits after the point to which factors of bounds are rounded.
pub(super) const PLACES: u32 = 24;

/// R = sE, where the rows of E are integers over one common denominator q. The offset is
/// the one with the smallest window; of windows of equal size, the one that is centred
/// best at 0.
///
/// The window is a set of positions p. The rows i + p of E^l determine the rows ni + β + p
/// of E^{l+1}, β = 0, …, n − 1, for all p in the window.
#[derive(Clone, Debug)]
pub(super) struct Scaled {
    pub(super) arity: usize,
    pub(super) offset: i64,
    /// The number of columns of R before the first nonzero one.
    pub(super) skipped: usize,
    /// The window is first, …, first + size − 1; it contains 0.
    pub(super) first: i64,
    pub(super) size: usize,
    /// s: the common sum of the rows of R, if they have the same sum and it is not 0;
    /// otherwise 1.
    pub(super) factor: Rational,
    /// q. It is a multiple of n if the rows of E sum to 1.
    pub(super) denominator: Integer,
    /// Bounds m levels below a node are multiples of 1/(fraction·q^m). The fraction is
    /// 2^[`PLACES`], or 2q times this if the rows of E sum to 1. Then the midpoints of the
    /// intervals of the moments are multiples too.
    pub(super) fraction: Integer,
    /// qE.
    pub(super) rows: Vec<Vec<Integer>>,
    /// If the rows of E sum to 1: the midpoint and half the width of the least interval
    /// that contains f_β = Σ_j (o + j) E_{β,j} − β/n for β = 0, …, n − 1.
    pub(super) shift: Option<[Rational; 2]>,
    /// The offset of R, without its skipped columns, minus `offset`.
    pub(super) moved: Integer,
}

impl Scaled {
    /// Operators of the same arity, width and offset, in one window.
    pub(super) fn of<const K: usize>(rules: [&Rules; K]) -> [Scaled; K] {
        let (arity, width) = (rules[0].arity(), rules[0].width());
        let used =
            |j: usize| rules.iter().any(|rules| rules.rows().iter().any(|row| !row[j].is_zero()));
        let start = (0..width).find(|&j| used(j)).unwrap_or(0);
        let end = (start..width).rev().find(|&j| used(j)).unwrap_or(start);
        let (offset, first, size) = centred(arity, end - start + 1);
        rules.map(|rules| {
            let rows: Vec<Vec<Rational>> =
                rules.rows().iter().map(|row| row[start..=end].to_vec()).collect();
            let moved =
                Integer::from(rules.offset()) + Integer::from(start) - Integer::from(offset);
            Scaled { skipped: start, ..Scaled::at(rows, [offset, first], size, moved) }
        })
    }

    fn at(
        mut rows: Vec<Vec<Rational>>,
        [offset, first]: [i64; 2],
        size: usize,
        moved: Integer,
    ) -> Scaled {
        let arity = rows.len();
        let sum: Rational = rows[0].iter().sum();
        let affine = !sum.is_zero() && rows.iter().all(|row| row.iter().sum::<Rational>() == sum);
        let factor = if affine { sum } else { Rational::one() };
        for entry in rows.iter_mut().flatten() {
            *entry = &*entry / &factor;
        }
        let shift = affine.then(|| {
            let at = |(beta, row): (usize, &Vec<Rational>)| {
                let moment: Rational =
                    (offset..).zip(row).map(|(p, x)| x * Rational::from(p)).sum();
                moment - Rational::new(beta, arity)
            };
            let shifts: Vec<Rational> = rows.iter().enumerate().map(at).collect();
            let least = shifts.iter().min().expect("at least two rules");
            let greatest = shifts.iter().max().expect("at least two rules");
            let half = Rational::new(1, 2);
            [(least + greatest) * &half, (greatest - least) * half]
        });
        let common = CommonDenominator::of(&rows);
        let (mut denominator, mut rows) = (common.denominator, common.numerators);
        let mut fraction = Integer::one().shifted_left(PLACES);
        if affine {
            let all = denominator.lcm(&Integer::from(arity));
            let more = all.div_floor(&denominator);
            for entry in rows.iter_mut().flatten() {
                *entry = &*entry * &more;
            }
            fraction = fraction.shifted_left(1) * &all;
            denominator = all;
        }
        let skipped = 0;
        Scaled {
            arity,
            offset,
            skipped,
            first,
            size,
            factor,
            denominator,
            fraction,
            rows,
            shift,
            moved,
        }
    }

    /// The largest absolute row sum of qE, or 1 if that is greater.
    pub(super) fn largest(&self) -> Integer {
        let sums = self.rows.iter().map(|row| row.iter().map(Integer::abs).sum::<Integer>());
        sums.max().map_or_else(Integer::one, |largest| largest.max(Integer::one()))
    }
}

/// The offset with the smallest window, and among these the one whose window is centred
/// best at 0, as (offset, first position, size).
fn centred(arity: usize, width: usize) -> (i64, i64, usize) {
    let small = |n: usize| i64::try_from(n).expect("arity and width are capped");
    let (arity, width) = (small(arity), small(width));
    let window = |offset: i64| {
        let (mut first, mut last) = (0_i64, 0_i64);
        loop {
            let from = first.min(first.div_euclid(arity) + offset);
            let to = last.max((arity - 1 + last).div_euclid(arity) + offset + width - 1);
            if (from, to) == (first, last) {
                return (first, last);
            }
            (first, last) = (from, to);
        }
    };
    let windows = (-width..=0).map(|offset| (offset, window(offset)));
    let key =
        |&(offset, (first, last)): &(i64, (i64, i64))| (last - first, (first + last).abs(), offset);
    let (offset, (first, last)) = windows.min_by_key(key).expect("at least one offset");
    (offset, first, usize::try_from(last - first + 1).expect("the window holds 0"))
}
