//! Control polygons, refined exactly, and their limits.

use crate::decimal::Q;
use crate::linear::solve;
use crate::reject::Stop;
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The most points of a polygon.
const MAX_POINTS: i64 = 100_000;

/// The largest window of a limit.
const MAX_WINDOW: i64 = 200;

/// x_i, i = first, first + 1, …; constant beyond both ends.
#[derive(Clone)]
pub struct Polygon {
    /// The index of the first point.
    pub first: i64,
    /// The points, at least one.
    pub points: Vec<Q>,
}

/// A mask of rational numbers with its offset.
pub struct Rules {
    /// a_{α,j}.
    pub mask: Vec<Vec<Q>>,
    /// o.
    pub offset: i64,
}

impl Polygon {
    /// x_i.
    fn at(&self, i: i64) -> &Q {
        let last = self.points.len() - 1;
        &self.points[usize::try_from(i - self.first).unwrap_or(0).min(last)]
    }

    /// Δ_i.
    pub fn difference(&self, i: i64) -> Q {
        self.at(i + 1) - self.at(i)
    }

    /// max|Δ|.
    pub fn spread(&self) -> Q {
        let pairs = self.points.windows(2).map(|pair| (&pair[1] - &pair[0]).abs());
        pairs.max().unwrap_or_else(Q::zero)
    }

    /// The value at u of the piecewise linear function with the value x_i at i.
    pub fn interpolate(&self, u: &Q) -> Result<Q, Stop> {
        let i = u.floor();
        let index = index(&i)?;
        Ok(self.at(index) + (u - i) * self.difference(index))
    }

    /// x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}.
    pub fn refined(&self, rules: &Rules) -> Result<Polygon, Stop> {
        let (arity, width) = (size(&rules.mask), size(&rules.mask[0]));
        // Left of the first i all points that matter are x_first, right of the last x_last.
        let from = self.first - rules.offset - width;
        let to = self.first + size(&self.points) - rules.offset;
        if (to - from + 1) * arity > MAX_POINTS || self.first.abs() > 1 << 40 {
            return Err(Stop::Capped("the points of a polygon"));
        }
        let point = |i: i64, row: &Vec<Q>| {
            (i + rules.offset..).zip(row).map(|(at, weight)| weight * self.at(at)).sum()
        };
        let points = (from..=to).flat_map(|i| rules.mask.iter().map(move |row| point(i, row)));
        Ok(Polygon { first: from * arity, points: points.collect() })
    }
}

/// An integer as an index.
fn index(value: &Q) -> Result<i64, Stop> {
    let index = value.to_integer().to_i64().filter(|index| index.abs() <= 1 << 40);
    index.ok_or(Stop::Capped("the parameters of a polygon"))
}

fn size<T>(list: &[T]) -> i64 {
    i64::try_from(list.len()).unwrap_or(i64::MAX)
}

/// The limit at 0 as weights w of x_l, x_{l+1}, …: l and w (THEOREMS.md, 3); `None` if the
/// equations wA = w, Σw = 1 do not have exactly one solution.
pub fn limit_at_zero(rules: &Rules) -> Result<Option<(i64, Vec<Q>)>, Stop> {
    let (arity, width) = (size(&rules.mask), size(&rules.mask[0]));
    // i − ⌊i/n⌋ does not fall, and is o from l on, and o + N − 1 up to h.
    let reach = |i: i64| i - i.div_euclid(arity);
    let bound = 2 * (rules.offset.abs() + width) + 2;
    let l = (-bound..=bound).find(|&i| reach(i) == rules.offset);
    let h = (-bound..=bound).rev().find(|&i| reach(i) == rules.offset + width - 1);
    let (Some(l), Some(h)) = (l, h) else { return Ok(None) };
    if h - l >= MAX_WINDOW {
        return Err(Stop::Capped("the window of a limit"));
    }
    let place = |i: i64| usize::try_from(i - l).unwrap_or(0);
    let count = place(h) + 1;
    let mut equations = vec![vec![Q::zero(); count + 1]; count];
    for i in l..=h {
        let row = &rules.mask[usize::try_from(i.rem_euclid(arity)).unwrap_or(0)];
        for (column, weight) in (i.div_euclid(arity) + rules.offset..).zip(row) {
            equations[place(column)][place(i)] += weight;
        }
        equations[place(i)][place(i)] -= Q::one();
    }
    // The rows of A sum to 1, so that the first equation follows from the others.
    equations[0] = vec![Q::one(); count + 1];
    Ok(solve(equations).map(|weights| (l, weights)))
}

impl Polygon {
    /// P^∞(t) of this polygon, for a scheme that converges and t·n^m an integer, by m steps.
    pub fn limit(&self, rules: &Rules, t: &Q) -> Result<Option<Q>, Stop> {
        let Some((l, weights)) = limit_at_zero(rules)? else { return Ok(None) };
        let arity = Q::from_integer(BigInt::from(rules.mask.len()));
        let (mut polygon, mut at) = (self.clone(), t.clone());
        while !at.is_integer() {
            (polygon, at) = (polygon.refined(rules)?, at * &arity);
        }
        let at = index(&at)?;
        let terms = (at + l..).zip(&weights).map(|(i, weight)| weight * polygon.at(i));
        Ok(Some(terms.sum()))
    }
}
