//! The greatest values of the limits of all data from 0 to 1, and of a step. `proofs/THEOREMS.md`, 139.

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
/// // At 1/2 it is 9/8, and elsewhere a little more.
/// assert!(*bounds.lower() > Rational::new(9, 8));
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
    // The remainders of all rows sum to 0, so that their positive parts are half of them.
    let half = &norm / Rational::from(2);
    let value = |row: &[Rational]| {
        row.iter().filter(|x| x.sign() > 0).fold(Rational::zero(), |sum, x| sum + x)
    };
    Ok(search.greatest(vec![search.unit()], (&one, &half), &value))
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
    let value = |row: &[Rational]| row[0].clone();
    let reach = search.first.abs().max(search.first + search.size()) + 1;
    let step = |i: i64| {
        let row =
            |p: i64| vec![if search.first + p + i < 0 { Integer::zero() } else { Integer::one() }];
        (0..search.size()).map(row).collect()
    };
    Ok(search.greatest((-reach..=reach).map(step).collect(), (&one, &norm), &value))
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
    /// Σ_p p φ(y − p) − y, where it does not depend on y: if there are two sum rules.
    shift: Option<Rational>,
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
        let values: Vec<Rational> = (first..=last).map(|p| at_zero.coefficient(p)).collect();
        let shift = keeps_lines(limit).then(|| {
            let terms = (first..).zip(&values).map(|(p, value)| Rational::from(p) * value);
            terms.fold(Rational::zero(), |sum, term| sum + term)
        });
        Ok(Search { arity, mask, lowest, denominator, first, values, shift })
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
        let arity = usize::try_from(self.arity).unwrap_or(MAX_FIRST);
        while cells.len() <= MAX_FIRST / arity {
            cells = cells
                .iter()
                .flat_map(|rows| (0..self.arity).map(move |r| self.part(rows, r)))
                .collect();
            denominator = &denominator * &self.denominator;
            let over = |x: Option<Integer>| Some(Rational::new(x?, denominator.clone()));
            let away = over(cells.iter().map(|rows| spread(rows)).max())?;
            if away <= half {
                let size = over(cells.iter().map(|rows| magnitude(middle(rows))).max())?;
                return Some(size / (Rational::one() - away));
            }
        }
        None
    }

    /// A number that the values on a cell do not exceed, times the denominator of its rows: the greater of those of the line through two rows
    /// at both ends, and `factor` times what the rows are away from the line. Without lines, the same of one row.
    fn above(
        &self,
        rows: &[Vec<Integer>],
        factor: &Rational,
        value: &dyn Fn(&[Rational]) -> Rational,
    ) -> Rational {
        let place = (rows.len() - 1) / 2;
        let (row, next) = (&rows[place], rows.get(place + 1));
        let lines = self.shift.as_ref().zip(next);
        let slope: Vec<Integer> = match lines {
            Some((_, next)) => next.iter().zip(row).map(|(y, x)| y - x).collect(),
            None => vec![Integer::zero(); row.len()],
        };
        let away = (0..).zip(rows).map(|(p, other): (i64, _)| {
            let steps = Integer::from(p - i64::try_from(place).unwrap_or(0));
            let on_line = row.iter().zip(&slope).map(|(x, d)| x + &(d * &steps));
            other.iter().zip(on_line).fold(Integer::zero(), |sum, (x, y)| sum + (x - &y).abs())
        });
        let away = away.max().unwrap_or_else(Integer::zero);
        let ends = match lines {
            // From the place of the row to y + shift, y = 0 and 1.
            Some((shift, _)) => {
                let start = shift - Rational::from(self.first + i64::try_from(place).unwrap_or(0));
                vec![start.clone(), start + Rational::one()]
            }
            None => vec![Rational::zero()],
        };
        let ends = ends.iter().map(|t| {
            let point = row.iter().zip(&slope);
            let point =
                point.map(|(x, d)| Rational::from(x.clone()) + t * Rational::from(d.clone()));
            value(&point.collect::<Vec<Rational>>())
        });
        ends.fold(None, |best: Option<Rational>, end| {
            Some(best.map_or(end.clone(), |best| best.max(end)))
        })
        .unwrap_or_else(Rational::zero)
            + factor * Rational::from(away)
    }

    /// Bounds of the greatest value, which is `least` at least. `value` is that at a point with this row, and `factor` times what rows are away
    /// from a line bounds what their limit is away.
    fn greatest(
        &self,
        cells: Vec<Vec<Vec<Integer>>>,
        (least, factor): (&Rational, &Rational),
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
            Cell { above: self.above(&rows, factor, value) * unit, rows, denominator }
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

/// Whether the limits of lines are lines: whether Σ_j j a_{α,j} − α/n is the same number for all rules.
fn keeps_lines(limit: &Limit) -> bool {
    let mask = limit.mask();
    let moment = |(alpha, row): (usize, &Vec<Rational>)| {
        let terms = (0..).zip(row).map(|(j, a): (i64, _)| Rational::from(j) * a);
        terms.fold(-Rational::new(alpha, mask.arity()), |sum, term| sum + term)
    };
    let mut moments = mask.rules().rows().iter().enumerate().map(moment);
    let first = moments.next();
    moments.all(|one| Some(one) == first)
}

fn middle(rows: &[Vec<Integer>]) -> &[Integer] {
    &rows[rows.len() / 2]
}

/// Σ|x|.
fn magnitude(row: &[Integer]) -> Integer {
    row.iter().fold(Integer::zero(), |sum, x| sum + x.abs())
}

/// The greatest Σ|x − y| of a row from that in the middle.
fn spread(rows: &[Vec<Integer>]) -> Integer {
    let middle = middle(rows);
    let away = rows
        .iter()
        .map(|row| row.iter().zip(middle).fold(Integer::zero(), |sum, (x, y)| sum + (x - y).abs()));
    away.max().unwrap_or_else(Integer::zero)
}
