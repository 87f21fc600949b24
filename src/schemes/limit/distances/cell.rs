//! Cells, the intervals between neighbouring points of a level, and their splits.

use super::fraction::Fraction;
use super::middles::{Middles, window};
use crate::exact::{Integer, Rational, common_denominator};
use crate::limit::error::LimitError;
use crate::limit::functional::{Functional, rule_at};
use crate::limit::row::magnitude;
use crate::limit::value::Limit;

/// The cost of a product of short numbers, in products of words.
const OVERHEAD: u64 = 8;

/// A row of a matrix without its zeros, as pairs of column and entry.
type Sparse = Vec<(usize, Integer)>;

/// The interval of parameters from (i + φ)/n^M to (i + 1 + φ)/n^M, with the data that determine P^∞
/// and P^k on it. At level M = k its ends are the parameters of points: φ is the fractional part
/// {s} of the shift s. For M > k, φ = {n^{M−k}s}; for M < k, φ = {s}/n^{k−M}.
///
/// All values are linear functions of the differences Δ^0 in the window of the root, a
/// cell of level 0. For all polygons, each of these differences has its own column. For a
/// single polygon, there is one column with their values. So a functional of the
/// differences is a row, and its norm, or its absolute value, is the sum of the absolute
/// entries.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// M.
    pub(super) level: u32,
    /// i.
    pub(super) index: Integer,
    /// The number of its [`Phase`], for M ≥ k.
    phase: usize,
    /// The differences Δ^M in the window, times `scale`.
    rows: Vec<Vec<Integer>>,
    scale: Integer,
    /// P^∞ − P^k at both ends, times `scale` and the scale of the [`Splitting`]; present
    /// for M ≥ k.
    ends: Option<[Vec<Integer>; 2]>,
}

impl Cell {
    /// The cell of level 0 with this index, and the differences in its window.
    pub(super) fn root(index: Integer, rows: Vec<Vec<Integer>>, scale: Integer) -> Cell {
        Cell { level: 0, index, phase: 0, rows, scale, ends: None }
    }
}

/// The sizes of Δ = Δ^M and ∇Δ in the window of a cell, from which bounds are computed.
pub(super) struct Sizes<'c> {
    /// max|Δ|, times `scale`.
    pub(super) spread: Integer,
    /// |Δ_i| for the cell of index i, times `scale`.
    pub(super) own: Integer,
    /// max|∇Δ|, where `(∇Δ)_i = Δ_{i+1} − Δ_i`, times `scale`.
    pub(super) turn: Integer,
    pub(super) scale: &'c Integer,
}

/// The split of a cell into n parts, in integers: Δ^{M+1} = DΔ^M, and P^∞ at a new end
/// differs from the chord between its values at the old ends by a functional of Δ^M.
#[derive(Clone, Debug)]
pub(super) struct Splitting {
    /// n.
    pub(super) arity: usize,
    /// The window of cell i holds the differences with the indices i + first, …, i +
    /// first + size − 1. They determine P^∞ − P^k on the cell, and the differences in the
    /// windows of its parts.
    pub(super) first: i64,
    pub(super) size: usize,
    /// q, a multiple of n: the factor from the scale of a cell to the scale of its parts.
    base: Integer,
    /// For each part α the rows of qD, for cells of levels below k.
    coarse: Vec<Vec<Sparse>>,
    /// The phases of cells of levels from k on.
    phases: Vec<Phase>,
    /// s: the factor from the scale of a cell to the scale of its ends.
    scale: Integer,
    /// s times P^∞ − P^0 at φ and at φ + 1, where φ is the fractional part of the shift.
    ends: [Sparse; 2],
    /// The number of products for each column of a cell when it is split.
    products: usize,
}

/// The split of a cell from i + φ to i + 1 + φ, in units of its level.
#[derive(Clone, Debug)]
struct Phase {
    /// φ.
    part: Rational,
    /// ⌊nφ⌋: the index of part α of cell i is ni + ⌊nφ⌋ + α.
    carry: i64,
    /// The number of the phase of the parts, which have {nφ}.
    next: usize,
    /// For each part α the rows of qD.
    differences: Vec<Vec<Sparse>>,
    /// sq times the distance of P^∞ from its chord at φ + α/n, for α = 1, …, n − 1.
    middles: Vec<Sparse>,
}

impl Splitting {
    /// The splitting for a shift, and for the [`middles`](super::middles::middles) of this shift.
    pub(super) fn new(
        limit: &Limit,
        shift: &Rational,
        middles: &[Middles],
    ) -> Result<Splitting, LimitError> {
        let difference = limit.difference();
        // The left end of a cell of level k.
        let node = shift.fract();
        let at_node = limit.error_from(0, &node, shift)?;
        let ends = [at_node.shifted(0), at_node.shifted(1)];
        let all = || middles.iter().flat_map(|phase| &phase.functionals);
        let carry = middles.iter().map(|phase| phase.carry).max().unwrap_or(0);
        let (first, last) = window(difference, all().chain(&ends), carry)?;
        let size = usize::try_from(last - first + 1).expect("the window holds 0");
        let denominator = |functionals: &[Functional]| {
            common_denominator(functionals.iter().flat_map(|f| f.terms().map(|(_, c)| c)))
        };
        let arity = difference.arity();
        let entries = difference.rows().iter().flatten();
        let base = common_denominator(entries).lcm(&Integer::from(arity));
        let scale = denominator(&all().cloned().collect::<Vec<_>>()).lcm(&denominator(&ends));
        let sparse = |terms: &mut dyn Iterator<Item = (i64, &Rational)>, scale: &Integer| {
            let entry = |(i, c): (i64, &Rational)| {
                let column = usize::try_from(i - first).expect("the window is closed");
                (column, (c * Rational::from(scale.clone())).numerator())
            };
            terms.filter(|(_, c)| !c.is_zero()).map(entry).collect::<Sparse>()
        };
        let parts = |carry: i64| {
            let part = |alpha: i64| {
                let row = |l: i64| sparse(&mut rule_at(difference, carry + alpha + l), &base);
                (first..=last).map(row).collect()
            };
            let parts = 0..i64::try_from(arity).expect("the arity is capped");
            parts.map(part).collect::<Vec<Vec<Sparse>>>()
        };
        let middle_scale = &scale * &base;
        let coarse = parts(0);
        let phase = |own: &Middles| {
            let next = middles.iter().position(|other| other.part == own.next);
            Phase {
                part: own.part.clone(),
                carry: own.carry,
                next: next.expect("the parts repeat"),
                differences: parts(own.carry),
                middles: own
                    .functionals
                    .iter()
                    .map(|f| sparse(&mut f.terms(), &middle_scale))
                    .collect(),
            }
        };
        let phases: Vec<Phase> = middles.iter().map(phase).collect();
        let entries = |phase: &Phase| -> usize {
            phase.differences.iter().flatten().chain(&phase.middles).map(Vec::len).sum()
        };
        let entries = phases.iter().map(entries).max().expect("there is a phase");
        Ok(Splitting {
            arity,
            first,
            size,
            // Besides the products, each entry of a row is read a few times.
            products: entries + 2 * arity * size,
            coarse,
            phases,
            ends: ends.each_ref().map(|end| sparse(&mut end.terms(), &scale)),
            base,
            scale,
        })
    }

    /// The cell, with P^∞ − P^k at its ends added if its level is k = `level`.
    pub(super) fn with_ends(&self, mut cell: Cell, level: u32) -> Cell {
        if cell.level == level {
            cell.ends = Some(self.ends.each_ref().map(|end| combine(end, &cell.rows)));
        }
        cell
    }

    /// The parameter of the left (`end` = 0) or right (`end` = 1) end of a cell of level
    /// k or later.
    pub(crate) fn parameter(&self, cell: &Cell, end: i64) -> Rational {
        let points = Integer::from(self.arity).pow(cell.level);
        let at = Rational::from(&cell.index + Integer::from(end)) + &self.phases[cell.phase].part;
        at / Rational::from(points)
    }

    /// Whether φ is not 0 for the cells of level k and before.
    pub(super) fn is_shifted(&self) -> bool {
        !self.phases[0].part.is_zero()
    }

    /// Whether a part of a cell is between these parameters, or may be, of a level below k.
    pub(super) fn meets(&self, cell: &Cell, range: &[Rational; 2]) -> bool {
        let [start, end] = self.in_units(cell, range);
        let part = &self.phases[cell.phase].part;
        let low = if cell.ends.is_some() { end - part } else { end };
        let index = Rational::from(cell.index.clone());
        index < low && index + Rational::one() + part > start
    }

    /// Whether the left (`end` = 0) or right (`end` = 1) end of a cell is between these parameters.
    pub(super) fn has_end(&self, cell: &Cell, end: i64, range: &[Rational; 2]) -> bool {
        let [start, last] = self.in_units(cell, range);
        let at = Rational::from(&cell.index + Integer::from(end)) + &self.phases[cell.phase].part;
        start <= at && at <= last
    }

    /// The ends of the range in units of the level of a cell.
    fn in_units(&self, cell: &Cell, range: &[Rational; 2]) -> [Rational; 2] {
        let unit = Rational::from(Integer::from(self.arity).pow(cell.level));
        range.each_ref().map(|end| end * &unit)
    }

    /// The factor from the denominators of [`sizes`](Splitting::sizes) to those of
    /// [`distances`](Splitting::distances).
    pub(super) fn end_scale(&self) -> &Integer {
        &self.scale
    }

    /// The cost in steps of bounding `count` cells of level 0 like `root`.
    pub(super) fn cost_of_roots(&self, root: &Cell, count: usize) -> u64 {
        (2 * self.size * root.rows[0].len() * count) as u64 * (root.scale.bits() / 64 + OVERHEAD)
    }

    /// The cost in steps of splitting this cell.
    pub(super) fn cost(&self, cell: &Cell) -> u64 {
        let columns = cell.rows[0].len();
        (self.products * columns) as u64 * (cell.scale.bits() / 64 + OVERHEAD)
    }

    /// |P^∞ − P^k| at both ends; `None` for a cell of a level below k.
    pub(crate) fn distances(&self, cell: &Cell) -> Option<[Fraction; 2]> {
        let scale = &cell.scale * &self.scale;
        let ends = cell.ends.as_ref()?;
        Some(ends.each_ref().map(|end| Fraction { p: magnitude(end), q: scale.clone() }))
    }

    /// The sizes of the differences in the window.
    pub(super) fn sizes<'c>(&self, cell: &'c Cell) -> Sizes<'c> {
        let own = usize::try_from(-self.first).expect("the window holds Δ_0");
        let turn = |pair: &[Vec<Integer>]| -> Integer {
            let steps = pair[1].iter().zip(&pair[0]);
            steps.fold(Integer::zero(), |mut sum, (next, this)| {
                if next < this {
                    sum += this;
                    sum -= next;
                } else {
                    sum += next;
                    sum -= this;
                }
                sum
            })
        };
        let spread = cell.rows.iter().map(|row| magnitude(row)).max();
        Sizes {
            spread: spread.expect("the window holds Δ_0"),
            own: magnitude(&cell.rows[own]),
            turn: cell.rows.windows(2).map(turn).max().unwrap_or_else(Integer::zero),
            scale: &cell.scale,
        }
    }

    /// The n parts of a cell, for the distance from P^k with k = `level`.
    pub(super) fn split(&self, cell: &Cell, level: u32) -> Vec<Cell> {
        let nodes = cell.ends.as_ref().map(|ends| self.nodes(cell, ends));
        let phase = &self.phases[cell.phase];
        let (differences, carry, next) = if cell.level < level {
            (&self.coarse, 0, 0)
        } else {
            (&phase.differences, phase.carry, phase.next)
        };
        let part = |alpha: usize| {
            let rows = differences[alpha].iter().map(|row| combine(row, &cell.rows));
            let first = &cell.index * Integer::from(self.arity) + Integer::from(carry);
            let part = Cell {
                level: cell.level + 1,
                index: first + Integer::from(alpha),
                phase: next,
                rows: rows.collect(),
                scale: &cell.scale * &self.base,
                ends: nodes.as_ref().map(|nodes| [nodes[alpha].clone(), nodes[alpha + 1].clone()]),
            };
            self.with_ends(part, level)
        };
        (0..self.arity).map(part).collect()
    }

    /// P^∞ − P^k at the fractions α/n of a cell, α = 0, …, n.
    fn nodes(&self, cell: &Cell, [left, right]: &[Vec<Integer>; 2]) -> Vec<Vec<Integer>> {
        let nth = self.base.div_floor(&Integer::from(self.arity));
        let node = |alpha: usize| {
            let (near, far) =
                (&nth * Integer::from(self.arity - alpha), &nth * Integer::from(alpha));
            let mut node: Vec<Integer> =
                left.iter().zip(right).map(|(x, y)| x * &near + y * &far).collect();
            if (1..self.arity).contains(&alpha) {
                let middles = &self.phases[cell.phase].middles;
                add_combination(&mut node, &middles[alpha - 1], &cell.rows);
            }
            node
        };
        (0..=self.arity).map(node).collect()
    }
}

/// Σ c·row over the terms of `sparse`.
fn combine(sparse: &Sparse, rows: &[Vec<Integer>]) -> Vec<Integer> {
    let mut sum = vec![Integer::zero(); rows[0].len()];
    add_combination(&mut sum, sparse, rows);
    sum
}

fn add_combination(sum: &mut [Integer], sparse: &Sparse, rows: &[Vec<Integer>]) {
    for (at, coefficient) in sparse {
        for (total, entry) in sum.iter_mut().zip(&rows[*at]) {
            total.add_product(coefficient, entry);
        }
    }
}
