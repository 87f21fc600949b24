//! Rows of powers, and bounds of combinations of them, as they are defined.

use crate::common::r;
use std::collections::BTreeMap;
use subcert::exact::{Integer, Rational};
use subcert::scheme::Rules;

pub(super) type Row = BTreeMap<Integer, Rational>;

/// Row i of E^m, from the definition.
pub(super) fn power_row(rules: &Rules, factor: &Rational, levels: u32, index: &Integer) -> Row {
    let n = Integer::from(rules.arity());
    let mut row: Row = BTreeMap::from([(index.clone(), Rational::one())]);
    for _ in 0..levels {
        let mut coarse = Row::new();
        for (fine, x) in row {
            let (base, rule) = fine.div_rem_floor(&n);
            let rule = usize::try_from(rule.to_i64().unwrap()).unwrap();
            for (j, y) in (rules.offset()..).zip(&rules.rows()[rule]).filter(|(_, y)| !y.is_zero())
            {
                let entry = coarse.entry(&base + Integer::from(j)).or_insert_with(Rational::zero);
                *entry += &(&x * y / factor);
            }
        }
        row = coarse;
    }
    row
}

pub(super) fn size(row: &Row) -> Rational {
    row.values().map(Rational::abs).sum()
}

pub(super) fn moment(row: &Row) -> Rational {
    row.iter().map(|(p, x)| Rational::from(p.clone()) * x).sum()
}

/// Σ c·row.
fn combined(terms: &[(Rational, &Row)]) -> Row {
    let mut sum = Row::new();
    for (c, row) in terms {
        for (index, x) in *row {
            *sum.entry(index.clone()).or_insert_with(Rational::zero) += &(c * x);
        }
    }
    sum
}

/// What is known of rows λ of E^m: their moments are from u to v, that of row t within 2r of the
/// point that divides the interval as t does 0, …, n^m − 1; and ‖λ‖ ≤ τ.
pub(super) struct KnownLimits {
    pub(super) moments: [Rational; 2],
    pub(super) radius: Rational,
    pub(super) tau: Rational,
}

/// Theorem 62 as it stands at u and at v, and ε of Theorem 65, for the line through each two
/// neighbours.
fn lines(rows: &[Row], first: i64, known: &KnownLimits) -> Vec<([Rational; 2], Rational)> {
    let KnownLimits { moments: [u, v], tau, .. } = known;
    let bound = |a: usize| {
        let at = |w: &Rational| {
            let t = w - Rational::from(first + i64::try_from(a).unwrap());
            combined(&[(Rational::one() - &t, &rows[a]), (t, &rows[a + 1])])
        };
        let position = |p: usize| Rational::from(first + i64::try_from(p).unwrap());
        let off: Vec<Row> = (0..rows.len())
            .map(|p| combined(&[(r(1, 1), &rows[p]), (r(-1, 1), &at(&position(p)))]))
            .collect();
        let (low, high) = (at(u), at(v));
        let value = |row: &Row, k: &Integer| row.get(k).cloned().unwrap_or_else(Rational::zero);
        let sign = |k: &Integer| {
            let radius = off.iter().map(|row| value(row, k).abs()).max().unwrap() * tau;
            let ends = [value(&low, k), value(&high, k)];
            [1, -1].into_iter().find(|&s| ends.iter().all(|x| x * Rational::from(s) >= radius))
        };
        let rest = |row: &Row| {
            let (mut signed, mut others) = (Rational::zero(), Rational::zero());
            for (k, x) in row {
                match sign(k) {
                    Some(s) => signed += &(x * Rational::from(s)),
                    None => others += &x.abs(),
                }
            }
            signed.abs() + others
        };
        let deviation = tau * off.iter().map(rest).max().unwrap();
        let step = combined(&[(r(1, 1), &rows[a + 1]), (r(-1, 1), &rows[a])]);
        ([low, high].map(|end| size(&end) + &deviation), size(&step))
    };
    (0..rows.len() - 1).map(bound).collect()
}

pub(super) fn line_bound(rows: &[Row], first: i64, known: &KnownLimits) -> Rational {
    lines(rows, first, known).into_iter().map(|([a, b], _)| a.max(b)).min().unwrap()
}

/// The greatest product of the values of two lines at one point from 0 to 1.
fn greatest_product([a, b]: &[Rational; 2], [c, d]: &[Rational; 2]) -> Rational {
    let (ends, bend) = ((a * c).max(b * d), (b - a) * (c - d));
    if bend.sign() <= 0 {
        return ends;
    }
    // ac + s(bd − ac) + s(1 − s)·bend.
    let slope = b * d - a * c;
    let top = (&slope + &bend) / (Rational::from(2) * &bend);
    if top.sign() <= 0 || top >= r(1, 1) {
        return ends;
    }
    ends.max(a * c + &top * slope + &top * (r(1, 1) - &top) * bend)
}

/// Theorem 65, with the lines of each that give the least.
pub(super) fn product_bound(rows: &[Vec<Row>], first: i64, known: &[KnownLimits]) -> Rational {
    let strayed: Vec<Vec<[Rational; 2]>> = rows
        .iter()
        .zip(known)
        .map(|(rows, known)| {
            let stray = r(2, 1) * &known.radius;
            let lines = lines(rows, first, known).into_iter();
            lines.map(|(ends, step)| ends.map(|end| end + &stray * &step)).collect()
        })
        .collect();
    let pairs = strayed[0].iter().flat_map(|x| strayed[1].iter().map(move |y| (x, y)));
    pairs.map(|(x, y)| greatest_product(x, y)).min().unwrap()
}
