//! What one sees of a mask on Z^d: symmetries, the support, interpolating or not.

use super::polynomials::mean;
use crate::exact::{Rational, Scalar};
use crate::scheme::{Dilation, LatticeMask, Point, apply, determinant, sum};

/// The matrices G with entries −1, 0 and 1 and a determinant of ±1 for which a(m_1 + G(γ − m_1)) = a(γ) for all γ, with the mean m_1 of the
/// places; the unit matrix among them.
///
/// # Panics
/// Never: there are two or three dimensions.
#[must_use]
pub fn symmetries(mask: &LatticeMask) -> Vec<[Point; 3]> {
    let d = mask.dimension();
    let mean = mean(mask);
    let candidates = 3_usize.pow(u32::try_from(d * d).expect("at most 9"));
    let matrix = |number: usize| {
        let entry = |place: usize| {
            let digit = number / 3_usize.pow(u32::try_from(place).expect("at most 9")) % 3;
            i64::try_from(digit).expect("0 to 2") - 1
        };
        let mut rows = [[0, 0, 0], [0, 0, 0], [0, 0, 1]];
        (0..d).for_each(|i| (0..d).for_each(|j| rows[i][j] = entry(i * d + j)));
        rows
    };
    (0..candidates).map(matrix).filter(|rows| is_symmetry(mask, &mean, rows)).collect()
}

fn is_symmetry(mask: &LatticeMask, mean: &[Rational], rows: &[Point; 3]) -> bool {
    if determinant(rows).abs() != 1 {
        return false;
    }
    // γ goes to Gγ + t, t = m_1 − Gm_1.
    let d = mask.dimension();
    let mut shift = [0; 3];
    for i in 0..d {
        let image = (0..d).map(|j| &mean[j] * &Rational::from(rows[i][j])).sum::<Rational>();
        let component = &mean[i] - image;
        match component.numerator().to_i64().filter(|_| component.is_integer()) {
            Some(whole) => shift[i] = whole,
            None => return false,
        }
    }
    mask.coefficients()
        .iter()
        .all(|(place, c)| mask.coefficients().get(&sum(apply(rows, *place), shift)) == Some(c))
}

/// Whether one class has a single coefficient: it is 1, and all points are kept.
#[must_use]
pub fn is_interpolating<S: Scalar + PartialEq>(mask: &LatticeMask<S>) -> bool {
    let mut counts = vec![0_usize; mask.dilation().class_count()];
    for place in mask.coefficients().keys() {
        counts[mask.dilation().split(*place).0] += 1;
    }
    counts.contains(&1)
}

/// The most steps after which a power of M is looked for that is a multiple of I.
const MAX_STEPS: u32 = 24;

/// The least box that has the convex hull of Σ_{j≥1} M^{−j} supp a, which contains the support of φ, the point x^k_α belonging to M^{−k}α. It is
/// known where some power of M is a multiple of I, or M is diagonal.
///
/// # Panics
/// Never: a mask has coefficients.
#[must_use]
pub fn support(mask: &LatticeMask) -> Option<Vec<[Rational; 2]>> {
    let dilation = mask.dilation();
    let d = mask.dimension();
    let places: Vec<Vec<Rational>> = mask
        .coefficients()
        .keys()
        .map(|place| place[..d].iter().map(|x| Rational::from(*x)).collect())
        .collect();
    let (period, factors) = period(dilation)?;
    let mut sums = vec![[Rational::zero(), Rational::zero()]; d];
    let mut images = places;
    for _ in 0..period {
        images = images.iter().map(|x| dilation.inverse_times(x)).collect();
        for (axis, [low, high]) in sums.iter_mut().enumerate() {
            let of = images.iter().map(|x| &x[axis]);
            *low += of.clone().min().expect("a mask has coefficients");
            *high += of.max().expect("a mask has coefficients");
        }
    }
    // Each further period is 1/c of the one before, c > 0.
    let scaled = |([low, high], c): ([Rational; 2], Rational)| {
        let scale = (Rational::one() - c.recip()).recip();
        [low * &scale, high * &scale]
    };
    Some(sums.into_iter().zip(factors).map(scaled).collect())
}

/// The least number of steps after which M multiplies each coordinate by a positive number, with these numbers.
fn period(dilation: &Dilation) -> Option<(u32, Vec<Rational>)> {
    let d = dilation.dimension();
    let unit =
        |j: usize| -> Vec<Rational> { (0..d).map(|i| Rational::from(i64::from(i == j))).collect() };
    let mut columns: Vec<Vec<Rational>> = (0..d).map(unit).collect();
    for step in 1..=MAX_STEPS {
        columns = columns.iter().map(|x| dilation.inverse_times(x)).collect();
        let diagonal = (0..d).all(|j| {
            let column = &columns[j];
            (0..d).all(|i| if i == j { column[i].sign() > 0 } else { column[i].is_zero() })
        });
        if diagonal {
            return Some((step, (0..d).map(|j| columns[j][j].recip()).collect()));
        }
    }
    None
}

/// Whether M is known to be isotropic, with all eigenvalues of one modulus and a basis of eigenvectors: some power of M is a multiple of I, or M is a 2×2 matrix with conjugate
/// eigenvalues.
#[must_use]
pub fn is_isotropic(dilation: &Dilation) -> bool {
    let powers =
        period(dilation).is_some_and(|(_, factors)| factors.iter().all(|c| *c == factors[0]));
    powers
        || (dilation.dimension() == 2 && {
            let trace: i64 = dilation.rows().enumerate().map(|(i, row)| row[i]).sum();
            trace * trace < 4 * dilation.determinant()
        })
}
