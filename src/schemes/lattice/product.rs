//! Masks on Z^d that are products: of masks of curves, and of the factors of box splines.

use crate::exact::Rational;
use crate::scheme::{LatticeMask, Mask, Point, Rules, difference, sum};
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

/// The most coefficients of a mask of which the directions are looked for.
const MAX_COEFFICIENTS: usize = 1 << 10;

/// The directions ξ of the box spline that a mask refines, if it is found to be that of one: A = m Π_ξ (1 − z^{Mξ})/(c(1 − z^η)) up to a power of z, where
/// each Mξ is a multiple cη of a direction η, each of which is met once, up to signs. `proofs/THEOREMS.md`, 152.
///
/// ```
/// use subcert::lattice::directions;
/// use subcert::scheme::parse_lattice;
///
/// let mask = parse_lattice("(1+x)*(1+y)/2:dilation=[[1,1],[1,-1]]")?;
/// assert_eq!(directions(&mask).map(|found| found.len()), Some(4));
/// assert!(directions(&parse_lattice("1+(x+1/x+y+1/y)/4:dilation=[[1,1],[1,-1]]")?).is_none());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn directions(mask: &LatticeMask) -> Option<Vec<Point>> {
    let positive = mask.coefficients().values().all(|c| c.sign() > 0);
    if !positive || mask.coefficients().len() > MAX_COEFFICIENTS {
        return None;
    }
    let dilation = mask.dilation();
    let most = i64::try_from(dilation.class_count()).ok()?;
    // ξ with Mξ = cη, for the least c from 2 on.
    let before =
        |eta: Point| (2..=most).find_map(|c| Some((c, dilation.divided(eta.map(|x| c * x))?)));
    let mut rest = mask.coefficients().clone();
    let (mut etas, mut chains) = (Vec::new(), Vec::new());
    while rest.len() > 1 {
        let first = *rest.first_key_value()?.0;
        // No terms cancel: a factor has its next term among the places.
        let mut candidates = rest.keys().skip(1).map(|place| difference(*place, first));
        let (eta, xi, next) = candidates.find_map(|eta| {
            let (c, xi) = before(eta)?;
            Some((eta, xi, quotient(&rest, eta, c)?))
        })?;
        etas.push(eta);
        // ξ, M^{−1}ξ, … as long as they are integer.
        let chain = std::iter::successors(Some(xi), |xi| dilation.divided(*xi));
        chains.push(chain.collect::<Vec<Point>>());
        rest = next;
    }
    for end in chains.iter().filter_map(|chain| chain.last()) {
        let opposite = difference([0; 3], *end);
        let at = etas.iter().position(|eta| eta == end || *eta == opposite)?;
        etas.swap_remove(at);
    }
    Some(chains.concat())
}

/// The least number of directions without which the others lie in one line or plane through 0.
#[must_use]
pub fn least_cut(directions: &[Point], dimension: usize) -> usize {
    let cross = |a: Point, b: Point| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let normals: Vec<Point> = if dimension == 2 {
        directions.iter().map(|a| [-a[1], a[0], 0]).collect()
    } else {
        let pairs = directions.iter().flat_map(|a| directions.iter().map(move |b| (*a, *b)));
        pairs.map(|(a, b)| cross(a, b)).collect()
    };
    let within = |normal: &Point| {
        let dot = |a: &Point| (0..3).map(|i| a[i] * normal[i]).sum::<i64>();
        directions.iter().filter(|a| dot(a) == 0).count()
    };
    let most = normals.iter().filter(|normal| **normal != [0; 3]).map(within).max();
    directions.len() - most.unwrap_or(directions.len())
}

/// The quotient by (1 + z^η + … + z^{(n−1)η})/n, if there is one.
fn quotient(
    dividend: &BTreeMap<Point, Rational>,
    eta: Point,
    n: i64,
) -> Option<BTreeMap<Point, Rational>> {
    let (mut rest, mut quotient) = (dividend.clone(), BTreeMap::new());
    while let Some((place, c)) = rest.first_key_value().map(|(place, c)| (*place, c.clone())) {
        let mut at = place;
        for _ in 0..n {
            let left = rest.get(&at)? - &c;
            if left.is_zero() {
                rest.remove(&at);
            } else {
                rest.insert(at, left);
            }
            at = sum(at, eta);
        }
        quotient.insert(place, c * Rational::from(n));
    }
    Some(quotient)
}
