//! The greatest values of the limits of all data from 0 to 1, and of a step.

use crate::exact::{CommonDenominator, Enclosure, Integer, Rational};
use crate::limit::error::LimitError;
use crate::limit::value::Limit;
use std::collections::BinaryHeap;

/// The most cells that are divided.
const MAX_CELLS: usize = 6_000;

/// The most cells of the level at which Σ|φ(x − k)| is bounded.
const MAX_FIRST: usize = 4_096;

/// The bounds are no farther apart than this, if so many cells are enough.
const WIDTH: (i64, i64) = (1, 1_000_000);

/// Bounds of the greatest value of Σ_k max(0, φ(x − k)), that of the limits of all data from 0 to 1; `None` beyond the caps.
///
/// # Errors
/// When a value of the limit is not computed.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::{Limit, greatest_of_bounded};
/// use subcert::scheme::parse_scheme;
///
/// let limit = Limit::new(parse_scheme("four-point:w=1/16")?.masks()[0])?;
/// let bounds = greatest_of_bounded(&limit)?.expect("few cells");
/// // At 1/2 it is 9/8; the greatest value is there.
/// assert_eq!(*bounds.lower(), Rational::new(9, 8));
/// assert!(bounds.width() < Rational::new(1, 100_000));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn greatest_of_bounded(limit: &Limit) -> Result<Option<Enclosure>, LimitError> {
    let search = Search::new(limit)?;
    let one = Rational::one();
    if search.is_non_negative() {
        return Ok(Some(Enclosure::exact(one)));
    }
    let Some(norm) = search.norm() else { return Ok(None) };
    // Σ max(0, r) of the row in the middle, and half of what the others are away from it: the sums of all rows are 1.
    let half = &norm / Rational::from(2);
    let above = |rows: &[Vec<Integer>]| {
        let [positive, away] = spread(rows);
        Rational::from(positive) + &half * Rational::from(away)
    };
    let value = |row: &[Rational]| {
        row.iter().filter(|x| x.sign() > 0).fold(Rational::zero(), |sum, x| sum + x)
    };
    Ok(search.greatest(vec![search.unit()], &one, &above, &value))
}

/// Bounds of the greatest value of Σ_{k ≥ 0} φ(x − k), the limit of the data 0 before 0 and 1 from 0 on; `None` beyond the caps.
///
/// # Errors
/// When a value of the limit is not computed.
pub fn greatest_of_step(limit: &Limit) -> Result<Option<Enclosure>, LimitError> {
    let search = Search::new(limit)?;
    let one = Rational::one();
    if search.is_non_negative() {
        return Ok(Some(Enclosure::exact(one)));
    }
    let Some(norm) = search.norm() else { return Ok(None) };
    // All values are within ½M(h − l) of the middle (h + l)/2 of the data in the window.
    let half = Rational::new(1, 2);
    let above = |rows: &[Vec<Integer>]| {
        let values = || rows.iter().map(|row| &row[0]);
        let Some((high, low)) = values().max().zip(values().min()) else { return one.clone() };
        (Rational::from(high + low) + &norm * Rational::from(high - low)) * &half
    };
    let value = |row: &[Rational]| row[0].clone();
    let reach = search.first.abs().max(search.first + search.size()) + 1;
    let step = |i: i64| {
        let row =
            |p: i64| vec![if search.first + p + i < 0 { Integer::zero() } else { Integer::one() }];
        (0..search.size()).map(row).collect()
    };
    Ok(search.greatest((-reach..=reach).map(step).collect(), &one, &above, &value))
}

/// Rows for the points first + i, …, first + i + w − 1 of a level, of which the limit on the cell i depends.
struct Cell {
    above: Rational,
    rows: Vec<Vec<Integer>>,
    /// What the rows are multiples of: 1 over this.
    denominator: Integer,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.above == other.above
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> std::cmp::Ordering {
        self.above.cmp(&other.above)
    }
}

/// A branch and bound over cells. With φ(x) ≠ 0 for s < x < e only, the limit at x in the cell i of level j is Σ_p φ(n^j x − p) d_p over the
/// points p from ⌊i − e⌋ + 1 to ⌈i + 1 − s⌉ − 1. The cell ni + r of the next level has the points Σ_p a_{q + r − np} d_p, with p counted from i
/// and q from ni + r.
struct Search {
    arity: i64,
    /// The mask as integers over one denominator, and the first power.
    mask: Vec<Integer>,
    lowest: i64,
    denominator: Integer,
    /// The first place of the window, from i.
    first: i64,
    /// φ(−p) for its places p.
    values: Vec<Rational>,
}

impl Search {
    fn new(limit: &Limit) -> Result<Search, LimitError> {
        let mask = limit.mask();
        let arity = i64::try_from(mask.arity()).expect("the arity is capped");
        let width = i64::try_from(mask.width()).expect("masks are capped");
        let mut row = Vec::new();
        for j in (0..mask.width()).rev() {
            row.extend(mask.rules().rows().iter().map(|rule| rule[j].clone()));
        }
        let lowest = -arity * (mask.offset() + width - 1);
        let CommonDenominator { mut numerators, denominator } = CommonDenominator::of(&[row]);
        let mask = numerators.pop().unwrap_or_default();
        let ends = [lowest, lowest + i64::try_from(mask.len()).expect("masks are capped") - 1];
        let ends = ends.map(|power| Rational::new(power, arity - 1));
        let whole = |x: Integer| x.to_i64().expect("offsets are capped");
        let first = whole((-&ends[1]).floor()) + 1;
        let last = whole((Rational::one() - &ends[0]).ceil()) - 1;
        let at_zero = limit.at(&Rational::zero())?;
        // φ(−p) is the weight of the point p in the limit at 0.
        let values = (first..=last).map(|p| at_zero.coefficient(p)).collect();
        Ok(Search { arity, mask, lowest, denominator, first, values })
    }

    fn size(&self) -> i64 {
        i64::try_from(self.values.len()).expect("masks are capped")
    }

    fn is_non_negative(&self) -> bool {
        self.mask.iter().all(|a| a.sign() >= 0)
    }

    /// The points of the window themselves.
    fn unit(&self) -> Vec<Vec<Integer>> {
        let row = |p| {
            let entry = |q| if p == q { Integer::one() } else { Integer::zero() };
            (0..self.size()).map(entry).collect()
        };
        (0..self.size()).map(row).collect()
    }

    /// The rows of part r of a cell, times the denominator of the mask.
    fn part(&self, rows: &[Vec<Integer>], r: i64) -> Vec<Vec<Integer>> {
        let row = |q: i64| {
            let mut sum = vec![Integer::zero(); rows[0].len()];
            for (p, row) in (self.first..).zip(rows) {
                let place = q + r - self.arity * p - self.lowest;
                let Some(a) = usize::try_from(place).ok().and_then(|k| self.mask.get(k)) else {
                    continue;
                };
                if !a.is_zero() {
                    for (sum, x) in sum.iter_mut().zip(row) {
                        sum.add_product(a, x);
                    }
                }
            }
            sum
        };
        (self.first..self.first + self.size()).map(row).collect()
    }

    /// A number that Σ_k |φ(x − k)| does not exceed; `None` if none is found.
    ///
    /// On a cell with the rows d_p and one of them, d, it is at most Σ|d| + M·max_p Σ|d_p − d|, M the number that is looked for.
    fn norm(&self) -> Option<Rational> {
        let (mut cells, mut denominator) = (vec![self.unit()], Integer::one());
        let half = Rational::new(1, 2);
        while cells.len() <= MAX_FIRST / self.arity.unsigned_abs() as usize {
            cells = cells
                .iter()
                .flat_map(|rows| (0..self.arity).map(move |r| self.part(rows, r)))
                .collect();
            denominator = &denominator * &self.denominator;
            let over = |x: Option<Integer>| Some(Rational::new(x?, denominator.clone()));
            let away = over(cells.iter().map(|rows| spread(rows)[1].clone()).max())?;
            if away <= half {
                let size = over(cells.iter().map(|rows| magnitude(middle(rows))).max())?;
                return Some(size / (Rational::one() - away));
            }
        }
        None
    }

    /// Bounds of the greatest value, which is `least` at least. `above` bounds the values on a cell with these rows, and `value` is that at a
    /// point with this row.
    fn greatest(
        &self,
        cells: Vec<Vec<Vec<Integer>>>,
        least: &Rational,
        above: &dyn Fn(&[Vec<Integer>]) -> Rational,
        value: &dyn Fn(&[Rational]) -> Rational,
    ) -> Option<Enclosure> {
        let width = Rational::new(WIDTH.0, WIDTH.1);
        let mut lower = least.clone();
        let mut open = BinaryHeap::new();
        let add = |rows: Vec<Vec<Integer>>, denominator: Integer, lower: &mut Rational| {
            let unit = Rational::new(Integer::one(), denominator.clone());
            let mut start = vec![Rational::zero(); rows[0].len()];
            for (weight, row) in self.values.iter().zip(&rows) {
                for (sum, x) in start.iter_mut().zip(row) {
                    *sum += &(weight * Rational::from(x.clone()));
                }
            }
            let start: Vec<Rational> = start.into_iter().map(|x| x * &unit).collect();
            *lower = lower.clone().max(value(&start));
            Cell { above: above(&rows) * unit, rows, denominator }
        };
        for rows in cells {
            let cell = add(rows, Integer::one(), &mut lower);
            open.push(cell);
        }
        for _ in 0..MAX_CELLS {
            let cell = open.pop()?;
            if &cell.above - &lower <= width {
                return Some(Enclosure::new(lower.clone(), cell.above.max(lower)));
            }
            let denominator = &cell.denominator * &self.denominator;
            for r in 0..self.arity {
                let part = add(self.part(&cell.rows, r), denominator.clone(), &mut lower);
                if part.above > lower {
                    open.push(part);
                }
            }
            if open.is_empty() {
                return Some(Enclosure::exact(lower));
            }
        }
        let most = open.pop()?.above;
        Some(Enclosure::new(lower.clone(), most.max(lower)))
    }
}

fn middle(rows: &[Vec<Integer>]) -> &[Integer] {
    &rows[rows.len() / 2]
}

/// Σ|x|.
fn magnitude(row: &[Integer]) -> Integer {
    row.iter().fold(Integer::zero(), |sum, x| sum + x.abs())
}

/// Σ max(0, x) of the row in the middle, and the greatest Σ|x − y| of another from it.
fn spread(rows: &[Vec<Integer>]) -> [Integer; 2] {
    let middle = middle(rows);
    let positive = middle.iter().filter(|x| x.sign() > 0);
    let positive = positive.fold(Integer::zero(), |sum, x| sum + x.clone());
    let away = rows
        .iter()
        .map(|row| row.iter().zip(middle).fold(Integer::zero(), |sum, (x, y)| sum + (x - y).abs()));
    [positive, away.max().unwrap_or_else(Integer::zero)]
}
