//! Systems of linear equations, determinants and interpolation.

use crate::exact::{CommonDenominator, Integer, Rational};

/// The only solution x of Σ_j m_{i,j} x_j = y_i, where row i of `rows` is
/// m_{i,0}, …, m_{i,n−1}, y_i; `None` when there is none or more than one.
///
/// Fraction-free elimination (Bareiss 1968): all intermediate numbers are minors of the
/// system, so they are about as short as the numbers of the solution.
///
/// # Panics
/// When there are not n rows of n + 1 numbers each.
///
/// ```
/// use subcert::exact::{Rational, solve};
///
/// let row = |entries: [i64; 3]| entries.map(Rational::from).to_vec();
/// let solution = solve(&[row([2, 1, 1]), row([1, 3, 0])]);
/// assert_eq!(solution, Some(vec![Rational::new(3, 5), Rational::new(-1, 5)]));
/// assert_eq!(solve(&[row([1, 2, 3]), row([2, 4, 6])]), None);
/// ```
#[must_use]
pub fn solve(rows: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let count = rows.len();
    assert!(rows.iter().all(|row| row.len() == count + 1), "{count} rows of {count} + 1 numbers");
    let mut rows = CommonDenominator::of(rows).numerators;
    eliminate(&mut rows)?;
    let mut solution = vec![Rational::zero(); count];
    for (at, row) in rows.iter().enumerate().rev() {
        let known = (at + 1..count).map(|j| Rational::from(row[j].clone()) * &solution[j]);
        let rest = Rational::from(row[count].clone()) - known.sum::<Rational>();
        solution[at] = rest / Rational::from(row[at].clone());
    }
    Some(solution)
}

/// The determinant of a square matrix, by the same elimination.
///
/// # Panics
/// When the matrix is not square.
///
/// ```
/// use subcert::exact::{Rational, determinant};
///
/// let rows = [[1, 2], [3, 4]].map(|row| row.map(Rational::from).to_vec());
/// assert_eq!(determinant(&rows), Rational::from(-2));
/// ```
#[must_use]
pub fn determinant(rows: &[Vec<Rational>]) -> Rational {
    let count = rows.len();
    assert!(rows.iter().all(|row| row.len() == count), "a square matrix");
    let CommonDenominator { numerators: mut rows, denominator } = CommonDenominator::of(rows);
    let Some(sign) = eliminate(&mut rows) else { return Rational::zero() };
    let last = rows.last().map_or_else(Integer::one, |row| row[count - 1].clone());
    let count = u32::try_from(count).expect("it fits in memory");
    Rational::new(last * sign, denominator.pow(count))
}

/// Elimination without fractions, of n rows with at least n columns: entry (i, i) becomes the leading minor of size i + 1 of
/// the rows in their new order. The sign of that order; `None` where the first n columns are dependent.
fn eliminate(rows: &mut [Vec<Integer>]) -> Option<Integer> {
    let (mut previous, mut sign) = (Integer::one(), Integer::one());
    for step in 0..rows.len() {
        let pivot = (step..rows.len()).find(|&row| !rows[row][step].is_zero())?;
        if pivot != step {
            rows.swap(step, pivot);
            sign = -sign;
        }
        let (above, below) = rows.split_at_mut(step + 1);
        let top = &above[step];
        for row in below {
            for column in step + 1..top.len() {
                let minor = &row[column] * &top[step] - &row[step] * &top[column];
                row[column] = minor.div_floor(&previous);
            }
        }
        previous = top[step].clone();
    }
    Some(sign)
}

/// The coefficients of the polynomial of degree below m with the values y_0, …, y_{m−1} at 0, …, m − 1, by
/// Newton's divided differences.
///
/// ```
/// use subcert::exact::{Rational, interpolated};
///
/// let squares = [0, 1, 4].map(Rational::from);
/// assert_eq!(interpolated(&squares), [0, 0, 1].map(Rational::from));
/// ```
#[must_use]
pub fn interpolated(values: &[Rational]) -> Vec<Rational> {
    let count = values.len();
    let mut differences = values.to_vec();
    for order in 1..count {
        for i in (order..count).rev() {
            differences[i] = (&differences[i] - &differences[i - 1]) / Rational::from(order);
        }
    }
    let mut coefficients: Vec<Rational> = Vec::with_capacity(count);
    for (place, difference) in differences.iter().enumerate().rev() {
        // p becomes p·(x − place) + difference.
        coefficients.insert(0, Rational::zero());
        for i in 1..coefficients.len() {
            let lower = &coefficients[i] * Rational::from(place);
            coefficients[i - 1] -= &lower;
        }
        coefficients[0] += difference;
    }
    coefficients.truncate(count);
    coefficients
}
