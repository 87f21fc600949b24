//! Functionals as sums of differences.

use crate::exact::{CommonDenominator, Rational};
use crate::lattice::Functional;

/// Which differences a functional is a sum of: first ones along the axes, or second ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    First,
    Second,
}

/// The most times that all sums are made less.
const MOST: usize = 24;

/// Numbers are below this, so that sums of all of them are machine integers.
const MAX_NUMERATOR: i128 = 1 << 90;

impl Order {
    /// The differences as exponents of (x − 1)(y − 1).
    pub(super) fn all(self) -> &'static [[usize; 2]] {
        match self {
            Order::First => &[[1, 0], [0, 1]],
            Order::Second => &[[2, 0], [1, 1], [0, 2]],
        }
    }

    /// A difference as a functional: the coefficients of its power of (x − 1)(y − 1).
    pub(super) fn functional([first, second]: [usize; 2]) -> Functional<Rational> {
        let powers: [&[i64]; 3] = [&[1], &[-1, 1], &[1, -2, 1]];
        let [x, y] = [powers[first], powers[second]];
        let entries = (0..)
            .zip(x)
            .flat_map(|(i, a)| (0..).zip(y).map(move |(j, b)| ([i, j, 0], Rational::from(a * b))));
        entries.collect()
    }
}

/// Numbers c with |F(p)| ≤ Σ c_i max |D_i p| over translates of the differences D_i of this order, whose places are in the least box around those
/// of F; `None` if F does not vanish on the polynomials of lower degree, or has too large numbers.
///
/// F(x, y) = Σ F_α (x, y)^α is divided: each row leaves a remainder in two columns next to each other (in one for first differences), and these are divided by
/// powers of y − 1. The moduli of the coefficients of the quotients sum to c_i. As (x − 1)·D and (y − 1)·D′ are the same for two differences next to each other,
/// coefficients may be moved between these, which is done as long as it makes sums less.
pub(super) fn sums(functional: &Functional<Rational>, order: Order) -> Option<Vec<Rational>> {
    let mut quotients = Quotients::of(functional, order)?;
    for _ in 0..MOST {
        if !quotients.lessened() {
            break;
        }
    }
    let scale = Rational::new(1, quotients.denominator);
    let sum = |all: &Vec<i128>| Rational::from(all.iter().map(|c| c.abs()).sum::<i128>());
    Some(quotients.all.iter().map(|all| sum(all) * &scale).collect())
}

/// The coefficients of the differences of each kind that begin at the places of a box, row by row, times the denominator.
struct Quotients {
    order: Order,
    /// The columns and the rows of the box.
    sides: [usize; 2],
    all: Vec<Vec<i128>>,
    denominator: i128,
}

impl Quotients {
    fn of(functional: &Functional<Rational>, order: Order) -> Option<Quotients> {
        let ends = |axis: usize| -> Option<(i64, usize)> {
            let low = functional.keys().map(|at| at[axis]).min()?;
            let high = functional.keys().map(|at| at[axis]).max()?;
            Some((low, usize::try_from(high - low).ok()? + 1))
        };
        let count = order.all().len();
        let Some(((left, width), (low, height))) = ends(0).zip(ends(1)) else {
            let sides = [0, 0];
            return Some(Quotients { order, sides, all: vec![Vec::new(); count], denominator: 1 });
        };
        let common = CommonDenominator::of(&[functional.values().cloned().collect()]);
        let mut rows = vec![vec![0_i128; width]; height];
        for (at, numerator) in functional.keys().zip(&common.numerators[0]) {
            let column = usize::try_from(at[0] - left).ok()?;
            let numerator = i128::from(numerator.to_i64()?);
            rows[usize::try_from(at[1] - low).ok()?][column] = numerator;
        }
        let denominator = i128::from(common.denominator.to_i64()?);
        let mut found = Quotients { order, sides: [width, height], all: Vec::new(), denominator };
        found.all = vec![vec![0; width * height]; count];
        found.divide(rows)?;
        let small = |c: &i128| c.abs() < MAX_NUMERATOR;
        found.all.iter().flatten().all(small).then_some(found)
    }

    /// Divides with the remainders in the middle column, and in the next one.
    fn divide(&mut self, rows: Vec<Vec<i128>>) -> Option<()> {
        let [width, height] = self.sides;
        let column = (width.saturating_sub(1)) / 2;
        let (mut values, mut slopes) = (vec![0; height], vec![0; height]);
        for (j, mut row) in rows.into_iter().enumerate() {
            let value: i128 = row.iter().sum();
            let moment = |(i, c): (usize, &i128)| Some(i128::try_from(i).ok()? * c);
            let total: i128 = row.iter().enumerate().map(moment).sum::<Option<i128>>()?;
            values[j] = value;
            row[column] -= value;
            if self.order == Order::Second {
                let slope = total - value * i128::try_from(column).ok()?;
                slopes[j] = slope;
                if slope != 0 {
                    row[column] += slope;
                    *row.get_mut(column + 1)? -= slope;
                }
                row = divided(&row)?;
            }
            self.all[0][j * width..][..width].copy_from_slice(&divided(&row)?);
        }
        let mut put = |number: usize, quotient: Vec<i128>| {
            for (j, c) in quotient.into_iter().enumerate() {
                self.all[number][j * width + column] = c;
            }
        };
        if self.order == Order::Second {
            put(1, divided(&slopes)?);
            put(2, divided(&divided(&values)?)?);
        } else {
            put(1, divided(&values)?);
        }
        Some(())
    }

    /// Moves coefficients once at all places; whether the sums are less.
    fn lessened(&mut self) -> bool {
        let [width, height] = self.sides;
        let kinds = self.order.all();
        let mut less = false;
        for first in 1..kinds.len() {
            // (y − 1)·D_{first−1} is (x − 1)·D_first, both with all their places in the box.
            let [a, b] = kinds[first - 1];
            for j in 0..height.saturating_sub(b + 1) {
                for i in 0..width.saturating_sub(a) {
                    let at = j * width + i;
                    let touched = [
                        (first - 1, at + width, 1),
                        (first - 1, at, -1),
                        (first, at + 1, -1),
                        (first, at, 1),
                    ];
                    less |= self.moved(touched);
                }
            }
        }
        less
    }

    /// Adds the multiple of a relation with which the moduli sum to least: one of four with which a coefficient is 0.
    fn moved(&mut self, touched: [(usize, usize, i128); 4]) -> bool {
        let now = touched.map(|(kind, at, sign)| self.all[kind][at] * sign);
        let total = |by: i128| now.iter().map(|c| (c + by).abs()).sum::<i128>();
        let best = now.into_iter().map(|c| -c).min_by_key(|by| total(*by)).unwrap_or(0);
        if total(best) >= total(0) {
            return false;
        }
        for (kind, at, sign) in touched {
            self.all[kind][at] += sign * best;
        }
        true
    }
}

/// The quotient by x − 1, if there is no remainder.
fn divided(polynomial: &[i128]) -> Option<Vec<i128>> {
    let mut carried = 0_i128;
    let mut quotient = Vec::with_capacity(polynomial.len());
    for c in polynomial {
        carried = carried.checked_sub(*c)?;
        quotient.push(carried);
    }
    (carried == 0).then_some(quotient)
}
