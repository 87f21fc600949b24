//! Schemes whose limits are polynomials on each cell.

use crate::exact::{Rational, solve};
use crate::limit::{Functional, Limit, LimitError, Window};

/// The greatest degree that is looked for.
const MAX_DEGREE: usize = 8;

/// The Bézier coefficients of the limit on the cell from 0 to 1, each as a row over the window, if the limit is a
/// polynomial there whose degree is below the size of the window.
///
/// The candidate F interpolates the limit at d + 1 parameters. It is the limit if on each part
/// of the cell it is F of the refined points: then so it is on the parts of parts, which tend to points.
/// `proofs/THEOREMS.md`, 99 (d).
pub(super) fn bezier(
    limit: &Limit,
    window: Window,
) -> Result<Option<Vec<Vec<Rational>>>, LimitError> {
    let degree = window.size() - 1;
    if degree == 0 || degree > MAX_DEGREE {
        return Ok(None);
    }
    let at =
        |t: &Rational| -> Result<Vec<Rational>, LimitError> { Ok(over(&limit.at(t)?, window)) };
    let parameters: Vec<Rational> = (0..=degree).map(|j| Rational::new(j, degree)).collect();
    let values = parameters.iter().map(at).collect::<Result<Vec<_>, LimitError>>()?;
    let bernstein: Vec<Vec<Rational>> =
        parameters.iter().map(|t| bernstein_values(degree, t)).collect();
    let mut coefficients = vec![Vec::with_capacity(window.size()); degree + 1];
    for column in 0..window.size() {
        let equation = |(row, value): (&Vec<Rational>, &Vec<Rational>)| {
            row.iter().chain([&value[column]]).cloned().collect()
        };
        let equations: Vec<Vec<Rational>> = bernstein.iter().zip(&values).map(equation).collect();
        let Some(solution) = solve(&equations) else { return Ok(None) };
        for (row, x) in coefficients.iter_mut().zip(solution) {
            row.push(x);
        }
    }
    let candidate = |t: &Rational| -> Functional {
        let weights = bernstein_values(degree, t);
        (window.first..)
            .zip(0..window.size())
            .map(|(index, column)| {
                let terms = weights.iter().zip(&coefficients).map(|(b, row)| b * &row[column]);
                (index, terms.sum())
            })
            .collect()
    };
    let arity = limit.mask().arity();
    for part in 0..arity {
        for u in &parameters {
            let t = (Rational::from(part) + u) / Rational::from(arity);
            let shift = i64::try_from(part).unwrap_or(i64::MAX);
            if candidate(u).shifted(shift).after(limit.mask().rules()) != candidate(&t) {
                return Ok(None);
            }
        }
    }
    Ok(Some(coefficients))
}

/// The coefficients of a functional over a window.
pub(super) fn over(functional: &Functional, window: Window) -> Vec<Rational> {
    (window.first..=window.last).map(|i| functional.coefficient(i)).collect()
}

/// The Bernstein polynomials of a degree at t.
fn bernstein_values(degree: usize, t: &Rational) -> Vec<Rational> {
    let power = |x: &Rational, k: usize| (0..k).fold(Rational::one(), |product, _| product * x);
    let mut binomial = Rational::one();
    let rest = Rational::one() - t;
    let mut values = Vec::with_capacity(degree + 1);
    for i in 0..=degree {
        values.push(&binomial * power(t, i) * power(&rest, degree - i));
        binomial = binomial * Rational::from(degree - i) / Rational::from(i + 1);
    }
    values
}
