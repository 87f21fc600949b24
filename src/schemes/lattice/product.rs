//! Masks on Z^d that are tensor products of masks of curves.

use crate::exact::Rational;
use crate::scheme::{LatticeMask, Mask, Rules};
use std::collections::BTreeMap;

/// The factors of a mask a(α) = a_1(α_1)⋯a_d(α_d), if M is diagonal with arities on the diagonal, and the mask is such a product.
///
/// ```
/// use subcert::lattice::factors;
/// use subcert::scheme::parse_lattice;
///
/// let bicubic = parse_lattice("(1+x)^4*(1+y)^4/64")?;
/// let axes = factors(&bicubic).expect("a product");
/// assert_eq!((axes.len(), axes[0].arity()), (2, 2));
/// assert!(factors(&parse_lattice("(1+x)*(1+y)*(1+x*y)/2")?).is_none());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn factors(mask: &LatticeMask) -> Option<Vec<Mask>> {
    let arities = mask.dilation().diagonal().filter(|all| all.iter().all(|n| *n > 1))?;
    // The sums over all other axes are multiples of the factors.
    let sums = |(axis, n): (usize, &i64)| {
        let mut sums: BTreeMap<i64, Rational> = BTreeMap::new();
        for (place, c) in mask.coefficients() {
            *sums.entry(place[axis]).or_insert_with(Rational::zero) += c;
        }
        let others = Rational::from(mask.dilation().class_count()) / Rational::from(*n);
        for sum in sums.values_mut() {
            *sum = &*sum / &others;
        }
        sums.retain(|_, sum| !sum.is_zero());
        sums
    };
    let all: Vec<BTreeMap<i64, Rational>> = arities.iter().enumerate().map(sums).collect();
    let product = |place: &[i64; 3]| {
        let factors = all.iter().enumerate();
        factors
            .map(|(axis, sums)| sums.get(&place[axis]))
            .try_fold(Rational::one(), |product, c| Some(product * c?))
    };
    let equal = mask.coefficients().iter().all(|(place, c)| product(place).as_ref() == Some(c));
    let count: usize = all.iter().map(BTreeMap::len).product();
    if !equal || count != mask.coefficients().len() {
        return None;
    }
    let curve = |(sums, n): (&BTreeMap<i64, Rational>, &i64)| {
        let (low, high) = (*sums.first_key_value()?.0, *sums.last_key_value()?.0);
        let coefficient = |k: i64| sums.get(&k).cloned().unwrap_or_else(Rational::zero);
        let (rows, offset) = Rules::rows_of_symbol(*n, (low, high), coefficient);
        Mask::new(rows, offset).ok()
    };
    all.iter().zip(&arities).map(curve).collect()
}
