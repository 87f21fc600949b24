//! Tolerances as a share of the size of a mesh.

use crate::exact::{Integer, Rational};
use crate::float::{exact as from_f64, nearest};

/// A share of the diagonal of the box around some points, as a tolerance: the diagonal is a root, and the result is
/// less than it times the share, by less than 2^−100 of that.
///
/// # Panics
/// When the points have not the same number of coordinates.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::patch::relative_tolerance;
///
/// let points = [[0, 0, 0], [3, 4, 0]].map(|p| p.map(Rational::from));
/// assert_eq!(relative_tolerance(&points, &Rational::new(1, 5)), Some(Rational::from(1)));
/// assert_eq!(relative_tolerance(&points[..1], &Rational::from(1)), None);
/// // Smaller squares than f64 has.
/// let tiny = Rational::power_of_ten(-200);
/// let points = points.map(|point| point.map(|x| &x * &tiny));
/// let found = relative_tolerance(&points, &Rational::new(1, 5)).unwrap();
/// assert!(found <= tiny && &found * &Rational::new(101, 100) > tiny);
/// ```
#[must_use]
pub fn relative_tolerance<P: AsRef<[Rational]>>(
    points: &[P],
    share: &Rational,
) -> Option<Rational> {
    let mut square = Rational::zero();
    for i in 0..points.first()?.as_ref().len() {
        let coordinates = || points.iter().map(|point| &point.as_ref()[i]);
        let width = coordinates().max()? - coordinates().min()?;
        square = &square + &(&width * &width);
    }
    square = &square * &(share * share);
    if square.sign() <= 0 {
        return None;
    }
    // Near 1, so that f64 holds it: 4^e times the square.
    let bits = |x: &Integer| i32::try_from(x.bits()).ok();
    let e = (bits(&square.denominator())? - bits(&square.numerator())?) / 2;
    let scale = Rational::from(2).pow(e);
    let square = &square * &(&scale * &scale);
    // Newton's iterates are above the root, and the square over them below it.
    let mut root = from_f64(nearest(&square).sqrt())?;
    let half = Rational::new(1, 2);
    for _ in 0..2 {
        root = &(&root + &(&square / &root)) * &half;
    }
    Some(&(&square / &root) / &scale)
}
