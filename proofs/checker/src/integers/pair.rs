//! Numbers x + yω with functions x and y, where ω is a root of ω² = 2cω − 1, and polynomials of matrices of them.

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions};
use super::polynomial::Polynomial;
use crate::numbers::{Q, count, int};
use crate::text::Stop;

/// x + yω.
#[derive(Clone, Debug, Default)]
pub struct Pair {
    /// x.
    pub real: Function,
    /// y.
    pub turned: Function,
}

impl From<Function> for Pair {
    fn from(real: Function) -> Pair {
        Pair { real, turned: Function::default() }
    }
}

/// A matrix.
pub type Matrix = Vec<Vec<Pair>>;

/// Arithmetic with one ω.
pub struct Turns<'m> {
    pub functions: &'m Functions<'m>,
    /// 2c.
    twice: Function,
}

impl<'m> Turns<'m> {
    /// The ω with this cosine.
    pub fn new(functions: &'m Functions<'m>, cosine: &Polynomial) -> Turns<'m> {
        Turns { functions, twice: cosine.scaled(&int(2)).into() }
    }

    /// one + other.
    pub fn sum(&self, one: &Pair, other: &Pair) -> Result<Pair, Stop> {
        let real = self.functions.sum(&one.real, 1, &other.real)?;
        let turned = self.functions.sum(&one.turned, 1, &other.turned)?;
        Ok(Pair { real, turned })
    }

    /// one · factor.
    pub fn scaled(&self, one: &Pair, factor: &Function) -> Result<Pair, Stop> {
        let real = self.functions.product(&one.real, factor)?;
        let turned = self.functions.product(&one.turned, factor)?;
        Ok(Pair { real, turned })
    }

    /// one · other.
    pub fn product(&self, one: &Pair, other: &Pair) -> Result<Pair, Stop> {
        let of = self.functions;
        // yy'ω² = yy'(2cω − 1).
        let square = of.product(&one.turned, &other.turned)?;
        let real = of.sum(&of.product(&one.real, &other.real)?, -1, &square)?;
        let turned = of.sum(
            &of.product(&one.real, &other.turned)?,
            1,
            &of.product(&one.turned, &other.real)?,
        )?;
        Ok(Pair { real, turned: of.sum(&turned, 1, &of.product(&square, &self.twice)?)? })
    }

    /// ω^d.
    pub fn power(&self, d: i64) -> Result<Pair, Stop> {
        // 1/ω = 2c − ω.
        let base = if d < 0 {
            Pair { real: self.twice.clone(), turned: Function::int(-1) }
        } else {
            Pair { real: Function::default(), turned: Function::int(1) }
        };
        let one = Pair::from(Function::int(1));
        (0..d.unsigned_abs()).try_fold(one, |power, _| self.product(&power, &base))
    }

    /// The coefficients of det(x − M), from the constant one on, and matrices N_k of adj(x − M) = Σ x^k N_k (Faddeev and
    /// LeVerrier).
    pub fn characteristic(&self, matrix: &Matrix) -> Result<(Vec<Pair>, Vec<Matrix>), Stop> {
        let size = matrix.len();
        let (mut coefficients, mut adjugates) = (vec![Pair::from(Function::int(1))], Vec::new());
        let mut product: Matrix = vec![vec![Pair::default(); size]; size];
        for k in 1..=size {
            // N_1 = 1, N_{k+1} = MN_k + c_k.
            if let Some(c) = coefficients.last() {
                for (i, row) in product.iter_mut().enumerate() {
                    if let Some(entry) = row.get_mut(i) {
                        *entry = self.sum(entry, c)?;
                    }
                }
            }
            let next = self.matrices(matrix, &product)?;
            adjugates.push(std::mem::replace(&mut product, next));
            let mut trace = Pair::default();
            for (i, row) in product.iter().enumerate() {
                if let Some(entry) = row.get(i) {
                    trace = self.sum(&trace, entry)?;
                }
            }
            let share = Function::from(Polynomial::from(-(int(1) / Q::from(count(k)))));
            coefficients.push(self.scaled(&trace, &share)?);
        }
        coefficients.reverse();
        adjugates.reverse();
        Ok((coefficients, adjugates))
    }

    fn matrices(&self, left: &Matrix, right: &Matrix) -> Result<Matrix, Stop> {
        let mut product = Vec::new();
        for row in left {
            let mut sums = vec![Pair::default(); row.len()];
            for (entry, other) in row.iter().zip(right) {
                for (sum, x) in sums.iter_mut().zip(other) {
                    self.functions.meter().spend(1)?;
                    *sum = self.sum(sum, &self.product(entry, x)?)?;
                }
            }
            product.push(sums);
        }
        Ok(product)
    }

    /// Σ x^k N_k.
    pub fn adjugate(&self, adjugates: &[Matrix], x: &Function) -> Result<Matrix, Stop> {
        let mut sum: Option<Matrix> = None;
        for matrix in adjugates.iter().rev() {
            let Some(known) = sum.take() else {
                sum = Some(matrix.clone());
                continue;
            };
            let mut next = Vec::new();
            for (row, others) in known.iter().zip(matrix) {
                let mut entries = Vec::new();
                for (entry, other) in row.iter().zip(others) {
                    entries.push(self.sum(&self.scaled(entry, x)?, other)?);
                }
                next.push(entries);
            }
            sum = Some(next);
        }
        Ok(sum.unwrap_or_default())
    }
}
