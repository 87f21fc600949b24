//! How far later levels are from a level, by differences of its points.

use super::corners::corners;
use super::levels::{Levels, Place};
use super::quotients::{Order, sums};
use crate::exact::{Rational, Real as _, only_solution};
use crate::float::upper;
use crate::lattice::{Between, Functional, Steps, sum_rules, weights};
use crate::scheme::LatticeMask;

/// The most digits of so many steps as are taken in one.
const MAX_DIGITS: usize = 256;

/// |P^∞ − P^{n+j}| ≤ Σ_i w_i max |D_i p^n|, D_i the differences of one order, and w = (κ_0 + … + κ_{c−1})(I − N)^{−1}N^q, q = ⌊j/c⌋.
///
/// Here κ_r bounds |P^{n+r+1} − P^{n+r}| by differences of level n, and N bounds those of level n + c; all are sums of moduli of quotients. The maxima
/// are those over the points that all depend on. `proofs/THEOREMS.md`, 153.
#[derive(Clone, Debug)]
pub(super) struct Tail {
    pub(super) order: Order,
    /// c.
    steps: u32,
    /// N, row by row.
    matrix: Vec<Vec<Rational>>,
    /// w for q = 0.
    weights: Vec<Rational>,
}

impl Tail {
    /// The least bound that is found; `None` where differences are not shown to contract.
    pub(super) fn of(mask: &LatticeMask, levels: &Levels, between: Between) -> Option<Tail> {
        let moved = displacements(mask, levels, between);
        let orders = [Order::Second, Order::First];
        let most = sum_rules(mask);
        let mut allowed = orders.into_iter().filter(|order| most >= 2 || *order == Order::First);
        allowed.find_map(|order| Tail::by(mask, levels, &moved, order))
    }

    fn by(
        mask: &LatticeMask,
        levels: &Levels,
        moved: &[Vec<Functional<Rational>>],
        order: Order,
    ) -> Option<Tail> {
        let total = |tail: &Tail| tail.weights.iter().cloned().sum::<Rational>();
        let count = order.all().len();
        let mut kappa = vec![Rational::zero(); count];
        let mut steps = Steps::none(mask);
        let mut best: Option<Tail> = None;
        loop {
            // κ of the levels up to here, and N of one more.
            if steps.count().is_multiple_of(levels.stride) {
                for moved in moved {
                    let Some(bound) = greatest(&steps, moved, order) else { return best };
                    for (sum, more) in kappa.iter_mut().zip(&bound) {
                        *sum += more;
                    }
                }
            }
            let digits = mask.dilation().class_count().pow(steps.count() + 1);
            if digits > MAX_DIGITS {
                return best;
            }
            steps = steps.next();
            if !steps.count().is_multiple_of(levels.steps) {
                continue;
            }
            let row = |powers: &[usize; 2]| greatest(&steps, &[Order::functional(*powers)], order);
            let matrix: Option<Vec<Vec<Rational>>> = order.all().iter().map(row).collect();
            let Some(matrix) = matrix else { return best };
            let Some(weights) = summed(&matrix, &kappa) else { continue };
            let tail = Tail { order, steps: steps.count(), matrix, weights };
            if best.as_ref().is_none_or(|best| total(&tail) < total(best)) {
                best = Some(tail);
            }
        }
    }

    /// The weights of a bound that holds for the levels from n + j on, rounded upwards.
    pub(super) fn after(&self, j: u32) -> Vec<f64> {
        let columns = 0..self.weights.len();
        let step = |weights: Vec<Rational>, _: u32| -> Vec<Rational> {
            let entry = |i: usize| {
                weights.iter().zip(&self.matrix).map(|(w, row)| w * &row[i]).sum::<Rational>()
            };
            columns.clone().map(entry).collect()
        };
        (0..j / self.steps).fold(self.weights.clone(), step).iter().map(upper).collect()
    }

    /// The same bound by the length of the longest edge: second differences are at most twice as long.
    pub(super) fn of_edges(&self, j: u32) -> f64 {
        let factor = if self.order == Order::Second { 2.0 } else { 1.0 };
        self.after(j).into_iter().fold(0.0, |sum: f64, weight| (sum + weight * factor).next_up())
    }

    /// A bound of the factor by which differences shrink in one level, to f64.
    pub(super) fn ratio(&self) -> f64 {
        let rows = self.matrix.iter().map(|row| row.iter().cloned().sum::<Rational>());
        upper(&Rational::maximum(rows)).powf(1.0 / f64::from(self.steps))
    }
}

/// κ(I − N)^{−1}, if the powers of N tend to 0: if x = (1, …, 1) + xN has a positive solution, as then xN < x.
fn summed(matrix: &[Vec<Rational>], kappa: &[Rational]) -> Option<Vec<Rational>> {
    let solved = |right: &[Rational]| {
        let row = |(i, right): (usize, &Rational)| -> Vec<Rational> {
            let entry =
                |(j, row): (usize, &Vec<Rational>)| Rational::from(i64::from(i == j)) - &row[i];
            matrix.iter().enumerate().map(entry).chain([right.clone()]).collect()
        };
        only_solution(right.iter().enumerate().map(row).collect::<Vec<Vec<Rational>>>())
    };
    let ones = vec![Rational::one(); kappa.len()];
    let positive = |x: &Rational| x.sign() > 0;
    solved(&ones).filter(|all| all.iter().all(positive))?;
    solved(kappa)
}

/// For functionals of data of a later level, at all places, the greatest sums.
fn greatest(
    steps: &Steps<'_, Rational>,
    functionals: &[Functional<Rational>],
    order: Order,
) -> Option<Vec<Rational>> {
    let rows = steps.rows();
    let mut most = vec![Rational::zero(); order.all().len()];
    for (digit, _) in &rows {
        for functional in functionals {
            let found = sums(&steps.pulled(&rows, functional, *digit), order)?;
            for (most, found) in most.iter_mut().zip(found) {
                if found > *most {
                    *most = found;
                }
            }
        }
    }
    Some(most)
}

/// P^{j+1} − P^j at the corners of their pieces in all kinds of squares of level 0, for the levels j until squares are divided.
fn displacements(
    mask: &LatticeMask,
    levels: &Levels,
    between: Between,
) -> Vec<Vec<Functional<Rational>>> {
    let mut all = Vec::new();
    let mut steps = Steps::none(mask);
    for count in 0..levels.stride {
        let next = steps.next();
        let (rows, next_rows) = (steps.rows(), next.rows());
        let (coarse, fine) = (levels.forth(count), levels.forth(count + 1));
        let mut found = Vec::new();
        for low in levels.offsets().0 {
            for corner in corners(&low, &[&coarse, &fine], between) {
                let mut functional =
                    steps.pulled(&rows, &negative(&coarse.at(&corner), between), [0; 3]);
                let moved = weights(&fine.at(&corner), between).into_iter().collect();
                for (at, c) in next.pulled(&next_rows, &moved, [0; 3]) {
                    *functional.entry(at).or_insert_with(Rational::zero) += &c;
                }
                functional.retain(|_, c| !c.is_zero());
                if !found.contains(&functional) {
                    found.push(functional);
                }
            }
        }
        all.push(found);
        steps = next;
    }
    all
}

/// Minus the net at a place.
fn negative(place: &Place, between: Between) -> Functional<Rational> {
    weights(place, between).into_iter().map(|(at, weight)| (at, -weight)).collect()
}
