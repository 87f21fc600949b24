//! Matrices modulo a prime, and characteristic polynomials by way of them.

use crate::exact::{CommonDenominator, Integer, IntegerPolynomial, Rational};
use crate::stop::check;

/// A prime p, 2^30 < p < 2^31, of arithmetic modulo p.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Modulus(u64);

/// A matrix modulo a prime, row by row.
pub type Residues = Vec<Vec<u64>>;

impl Modulus {
    /// The greatest such prime.
    ///
    /// ```
    /// use subcert::exact::{Modulus, Rational};
    ///
    /// let p = Modulus::greatest();
    /// assert_eq!(p.prime(), (1 << 31) - 1);
    /// let half = p.residue(&Rational::new(1, 2)).expect("p is odd");
    /// assert_eq!(2 * half % p.prime(), 1);
    /// ```
    #[must_use]
    pub fn greatest() -> Modulus {
        Modulus((1 << 31) - 1)
    }

    /// p.
    #[must_use]
    pub fn prime(self) -> u64 {
        self.0
    }

    /// The primes from this one downwards.
    pub(super) fn downwards(self) -> impl Iterator<Item = Modulus> {
        (1 << 30..=self.0).rev().filter(|n| is_prime(*n)).map(Modulus)
    }

    /// A rational number modulo p; `None` if p divides its denominator.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn residue(self, x: &Rational) -> Option<u64> {
        let p = u32::try_from(self.0).expect("below 2^31");
        let denominator = u64::from(x.denominator().residue(p));
        let numerator = u64::from(x.numerator().residue(p));
        (denominator != 0).then(|| numerator * self.inverse(denominator) % self.0)
    }

    /// A matrix modulo p; `None` if p divides a denominator.
    #[must_use]
    pub fn residues(self, rows: &[Vec<Rational>]) -> Option<Residues> {
        rows.iter().map(|row| row.iter().map(|x| self.residue(x)).collect()).collect()
    }

    /// a^{−1}, of a ≠ 0.
    fn inverse(self, a: u64) -> u64 {
        let (mut result, mut base, mut exponent) = (1, a, self.0 - 2);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * base % self.0;
            }
            base = base * base % self.0;
            exponent >>= 1;
        }
        result
    }

    /// The number x + tm that is r modulo p, for the inverse of m modulo p.
    pub(super) fn lifted(self, x: &Integer, r: u64, (m, inverse): (&Integer, u64)) -> Integer {
        let prime = u32::try_from(self.0).expect("below 2^31");
        let step = (r + self.0 - u64::from(x.residue(prime))) % self.0 * inverse % self.0;
        x + &(m * &Integer::from(step))
    }

    /// The inverse of an integer.
    pub(super) fn inverse_of(self, m: &Integer) -> u64 {
        self.inverse(m.residue(u32::try_from(self.0).expect("below 2^31")).into())
    }

    /// x − c·y, entry by entry.
    fn subtract(self, x: &mut [u64], c: u64, y: &[u64]) {
        let c = self.0 - c;
        for (x, y) in x.iter_mut().zip(y) {
            *x = (*x + c * y) % self.0;
        }
    }

    /// xM.
    #[must_use]
    pub fn row_times(self, x: &[u64], matrix: &[Vec<u64>]) -> Vec<u64> {
        let mut sum = vec![0; matrix.first().map_or(0, Vec::len)];
        for (x, row) in x.iter().zip(matrix).filter(|(x, _)| **x != 0) {
            for (sum, entry) in sum.iter_mut().zip(row) {
                *sum = (*sum + x * entry) % self.0;
            }
        }
        sum
    }

    /// AB.
    #[must_use]
    pub fn product(self, a: &[Vec<u64>], b: &[Vec<u64>]) -> Residues {
        a.iter().map(|row| self.row_times(row, b)).collect()
    }

    /// A + cB.
    #[must_use]
    pub fn combination(self, a: &[Vec<u64>], c: u64, b: &[Vec<u64>]) -> Residues {
        let row = |(a, b): (&Vec<u64>, &Vec<u64>)| {
            a.iter().zip(b).map(|(x, y)| (x + c * y) % self.0).collect()
        };
        a.iter().zip(b).map(row).collect()
    }

    /// f(X) of a polynomial and a square matrix.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn value(self, f: &IntegerPolynomial, x: &[Vec<u64>]) -> Residues {
        let p = u32::try_from(self.0).expect("below 2^31");
        let mut value = vec![vec![0; x.len()]; x.len()];
        for c in f.coefficients().iter().rev() {
            value = self.product(&value, x);
            for (i, row) in value.iter_mut().enumerate() {
                row[i] = (row[i] + u64::from(c.residue(p))) % self.0;
            }
        }
        value
    }

    /// A basis of the rows v with vM = 0.
    #[must_use]
    pub fn null_rows(self, matrix: &[Vec<u64>]) -> Residues {
        // The rows of (M | I), where those of M become 0.
        let size = matrix.len();
        let unit = |i: usize| (0..size).map(move |j| u64::from(i == j));
        let mut rows: Residues = matrix
            .iter()
            .enumerate()
            .map(|(i, row)| row.iter().copied().chain(unit(i)).collect())
            .collect();
        let columns = matrix.first().map_or(0, Vec::len);
        let mut done = 0;
        for column in 0..columns {
            let Some(pivot) = (done..size).find(|&i| rows[i][column] != 0) else { continue };
            rows.swap(done, pivot);
            let inverse = self.inverse(rows[done][column]);
            let top: Vec<u64> = rows[done].iter().map(|x| x * inverse % self.0).collect();
            for row in &mut rows[done + 1..] {
                let factor = row[column];
                if factor != 0 {
                    self.subtract(row, factor, &top);
                }
            }
            done += 1;
        }
        rows.split_off(done).into_iter().map(|row| row[columns..].to_vec()).collect()
    }

    /// The reduced echelon form without rows of zeros, and the column of each pivot.
    #[must_use]
    pub fn echelon(self, mut rows: Residues) -> (Residues, Vec<usize>) {
        let columns = rows.first().map_or(0, Vec::len);
        let mut pivots = Vec::new();
        for column in 0..columns {
            let done = pivots.len();
            let Some(pivot) = (done..rows.len()).find(|&i| rows[i][column] != 0) else { continue };
            rows.swap(done, pivot);
            let inverse = self.inverse(rows[done][column]);
            let top: Vec<u64> = rows[done].iter().map(|x| x * inverse % self.0).collect();
            for (i, row) in rows.iter_mut().enumerate() {
                let factor = row[column];
                if i != done && factor != 0 {
                    self.subtract(row, factor, &top);
                }
            }
            rows[done] = top;
            pivots.push(column);
        }
        rows.truncate(pivots.len());
        (rows, pivots)
    }

    /// The number of dimensions of the least space with this row that all of these matrices take to itself.
    #[must_use]
    pub fn orbit(self, row: &[u64], matrices: &[Residues]) -> usize {
        let mut basis: Vec<(usize, Vec<u64>)> = Vec::new();
        let mut waiting = vec![row.to_vec()];
        while let Some(mut row) = waiting.pop() {
            for (pivot, known) in &basis {
                let factor = row[*pivot];
                if factor != 0 {
                    self.subtract(&mut row, factor, known);
                }
            }
            let Some(pivot) = row.iter().position(|x| *x != 0) else { continue };
            let inverse = self.inverse(row[pivot]);
            for x in &mut row {
                *x = *x * inverse % self.0;
            }
            waiting.extend(matrices.iter().map(|matrix| self.row_times(&row, matrix)));
            basis.push((pivot, row));
        }
        basis.len()
    }

    /// det(xI − M) modulo p, from the constant term upwards: M is brought to Hessenberg form, and the polynomials of its leading parts follow from each
    /// other (Cohen 1993, 2.2.9).
    fn characteristic(self, mut m: Residues) -> Vec<u64> {
        let (n, p) = (m.len(), self.0);
        for k in 1..n.saturating_sub(1) {
            let Some(pivot) = (k..n).find(|&i| m[i][k - 1] != 0) else { continue };
            m.swap(k, pivot);
            for row in &mut m {
                row.swap(k, pivot);
            }
            let inverse = self.inverse(m[k][k - 1]);
            for i in k + 1..n {
                let factor = m[i][k - 1] * inverse % p;
                if factor != 0 {
                    // The steps before have changed this row too.
                    let top = m[k].clone();
                    self.subtract(&mut m[i], factor, &top);
                    for row in &mut m {
                        row[k] = (row[k] + factor * row[i]) % p;
                    }
                }
            }
        }
        let mut all: Vec<Vec<u64>> = vec![vec![1]];
        for k in 0..n {
            // (x − h_kk) of the one before, less the others times products of the entries below the diagonal.
            let mut next = vec![0; k + 2];
            for (i, c) in all[k].iter().enumerate() {
                next[i + 1] = (next[i + 1] + c) % p;
                next[i] = (next[i] + (p - m[k][k]) * c) % p;
            }
            let mut below = 1;
            for i in (0..k).rev() {
                below = below * m[i + 1][i] % p;
                let factor = below * m[i][k] % p;
                if factor != 0 {
                    let (start, rest) = (all[i].clone(), &mut next[..=i]);
                    self.subtract(rest, factor, &start);
                }
            }
            all.push(next);
        }
        all.pop().expect("one for each part")
    }
}

/// Whether an odd number from 2^30 to 2^31 is prime.
fn is_prime(n: u64) -> bool {
    n % 2 == 1 && (3..).step_by(2).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d))
}

/// det(xI − M) times a positive integer, for a square matrix M.
///
/// It is computed modulo primes whose product is more than twice any coefficient of det(xI − qM), q the least common denominator: with row sums of at most R,
/// these are at most (1 + R)^d.
///
/// # Panics
/// When M is not square.
///
/// ```
/// use subcert::exact::{Rational, characteristic_polynomial};
///
/// let rows = [[1, 1], [1, 0]].map(|row| row.map(Rational::from).to_vec());
/// assert_eq!(characteristic_polynomial(&rows).to_string(), "x^2 - x - 1");
/// ```
#[must_use]
pub fn characteristic_polynomial(rows: &[Vec<Rational>]) -> IntegerPolynomial {
    let size = rows.len();
    assert!(rows.iter().all(|row| row.len() == size), "a square matrix");
    let CommonDenominator { numerators, denominator } = CommonDenominator::of(rows);
    let sum = |row: &Vec<Integer>| row.iter().fold(Integer::one(), |sum, x| sum + x.abs());
    let most = numerators.iter().map(sum).max().unwrap_or_else(Integer::one);
    let bound = most.pow(u32::try_from(size).expect("it fits in memory")) * Integer::from(4);
    let mut modulus = Integer::one();
    let mut found = vec![Integer::zero(); size + 1];
    for p in Modulus::greatest().downwards() {
        check();
        let prime = u32::try_from(p.0).expect("below 2^31");
        let reduce = |row: &Vec<Integer>| row.iter().map(|x| x.residue(prime).into()).collect();
        let residues = p.characteristic(numerators.iter().map(reduce).collect());
        let before = (&modulus, p.inverse_of(&modulus));
        for (x, r) in found.iter_mut().zip(residues) {
            *x = p.lifted(x, r, before);
        }
        modulus *= &Integer::from(p.0);
        if modulus > bound {
            break;
        }
    }
    let half = modulus.div_floor(&Integer::from(2));
    let signed = found.into_iter().map(|x| if x > half { x - &modulus } else { x });
    // det(xI − M) = q^{−d} det(qxI − qM).
    let mut scale = Integer::one();
    let coefficients = signed.map(|c| {
        let c = c * &scale;
        scale = &scale * &denominator;
        c
    });
    IntegerPolynomial::new(coefficients.collect()).primitive()
}
