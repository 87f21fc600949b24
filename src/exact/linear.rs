//! Systems of linear equations.

use super::{CommonDenominator, Integer, Rational};

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
    let mut previous = Integer::one();
    for step in 0..count {
        let pivot = (step..count).find(|&row| !rows[row][step].is_zero())?;
        rows.swap(step, pivot);
        let (above, below) = rows.split_at_mut(step + 1);
        let top = &above[step];
        for row in below {
            for column in step + 1..=count {
                let minor = &row[column] * &top[step] - &row[step] * &top[column];
                row[column] = minor.div_floor(&previous);
            }
        }
        previous = top[step].clone();
    }
    let mut solution = vec![Rational::zero(); count];
    for (at, row) in rows.iter().enumerate().rev() {
        let known = (at + 1..count).map(|j| Rational::from(row[j].clone()) * &solution[j]);
        let rest = Rational::from(row[count].clone()) - known.sum::<Rational>();
        solution[at] = rest / Rational::from(row[at].clone());
    }
    Some(solution)
}
