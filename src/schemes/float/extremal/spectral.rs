//! Spectral radii in f64.

use super::{Rows, norm, product};

/// How often a matrix is squared: ‖M^{2^k}‖^{1/2^k} differs from the radius by a factor C^{1/2^k}.
const SQUARINGS: i32 = 44;

/// The spectral radius of a matrix, if it is not below `least`; 0 where it is below.
///
/// ‖M^{2^k}‖^{1/2^k} is an upper bound for each k. The search ends as soon as it is below `least`.
#[must_use]
pub fn spectral_radius(matrix: &Rows, least: f64) -> f64 {
    let mut power = matrix.clone();
    // The logarithm of what has been divided off, over 2^k.
    let mut logarithm = 0.0;
    let mut weight = 1.0;
    for _ in 0..SQUARINGS {
        let size = norm(&power);
        if !(size > 0.0 && size.is_finite()) {
            return 0.0;
        }
        logarithm += weight * size.ln();
        if logarithm.exp() < least {
            return 0.0;
        }
        power.iter_mut().flatten().for_each(|x| *x /= size);
        power = product(&power, &power);
        weight /= 2.0;
    }
    logarithm.exp()
}
