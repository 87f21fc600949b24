//! Every constant of a scheme in f64, with its true error and a proven bound on it.

use super::apriori::Tracked;
use super::depth::{Bound, DepthDecision};
use super::error::{CertifyError, MAX_CERTIFIED_LEVEL};
use super::pipeline::Outcome;
use super::quantity::Quantity;
use crate::exact::Rational;
use crate::scheme::{Mask, Scheme};
use std::collections::BTreeMap;

/// The cap on the number n^c·(N+2)·N of steps of a walk over exact values with error
/// bounds. For greater c, the f64 constants are compared with their exact values, but
/// have no a priori bound.
pub const MAX_TRACKED_STEPS: u64 = 20_000;

/// The options of [`certify`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CertifyOptions {
    /// The greatest block length c of T_c and Λ_c; 4 by default.
    pub max_block: u32,
    /// The levels k of the error bounds σβ C^k/(1 − C); 1, 5, 10 by default.
    pub levels: Vec<u32>,
    /// β > 0, the largest difference of the control polygon; 1 by default.
    pub spread: Rational,
    /// The tolerances ε > 0 of the depths; 10^−2, 10^−4, 10^−8 by default.
    pub tolerances: Vec<Rational>,
}

impl Default for CertifyOptions {
    fn default() -> CertifyOptions {
        CertifyOptions {
            max_block: 4,
            levels: vec![1, 5, 10],
            spread: Rational::one(),
            tolerances: [-2, -4, -8].map(Rational::power_of_ten).to_vec(),
        }
    }
}

/// The constants of a scheme in f64, compared with the exact constants.
#[derive(Clone, Debug, PartialEq)]
pub struct Certification {
    /// All quantities.
    pub quantities: Vec<Quantity>,
    /// All depths, in the order of the block lengths and then of the tolerances.
    pub depths: Vec<DepthDecision>,
    /// The greatest c with a priori bounds.
    pub tracked_block: u32,
}

impl Certification {
    /// The quantity of this name.
    #[must_use]
    pub fn quantity(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }
}

/// Computes the constants of `scheme` in f64, exactly, and with a proven bound on
/// the error: the difference mask, T_c and Λ_c for c = 1, …, `max_block`, the
/// constants of the tensor product, σ at the offset of the mask and at 0, the factor
/// of a surface, the error bounds σβ C^k/(1 − C) for every exact C < 1, and depths.
/// Here C = T_c for a curve, and for a tensor product the greater of the T_cΛ_c
/// along the two directions, with the factor of a surface in place of σ.
///
/// An f64 result that is NaN, infinite or on the wrong side of 1 is a finding, not an
/// error: it is part of the result.
///
/// # Errors
/// When there are too many residue classes, or the norms take more than
/// [`MAX_STEPS`](super::MAX_STEPS) steps, a tolerance or the spread is not positive, or a level is
/// too high.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::float::{CertifyOptions, certify};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("quinary-three-point")?;
/// let found = certify(&scheme, &CertifyOptions { max_block: 2, ..Default::default() })?;
/// let t = found.quantity("T_2").unwrap();
/// assert_eq!(t.exact, Rational::new(169, 625));
/// assert_eq!(t.encloses(), Some(true));
/// assert!(t.bound.unwrap() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn certify(scheme: &Scheme, options: &CertifyOptions) -> Result<Certification, CertifyError> {
    check(options)?;
    let CertifyOptions { max_block, levels, spread, tolerances } = options;
    let tracked_block = tracked_block(scheme, *max_block);
    // The f64 path comes first, as it may exceed a cap.
    let mut float = Outcome::<f64>::constants(scheme, *max_block)?;
    let mut ideal = Outcome::<Rational>::constants(scheme, *max_block)?;
    let mut tracked = Outcome::<Tracked>::constants(scheme, tracked_block)?;
    // The exact values decide which bounds exist, so that all three lists have the same
    // entries.
    let contracts: Vec<bool> = ideal.ratios.iter().map(|ratio| *ratio < Rational::one()).collect();
    ideal.add_bounds(spread, levels, &contracts);
    float.add_bounds(spread, levels, &contracts);
    tracked.add_bounds(spread, levels, &contracts);
    let bounds: BTreeMap<String, f64> =
        tracked.named.into_iter().map(|(name, tracked)| (name, tracked.error())).collect();
    let mut depths = Vec::new();
    for (at, block) in (0..ideal.ratios.len()).zip(1..) {
        let bound = Bound {
            block,
            spread,
            float: (float.factor, float.ratios[at]),
            exact: (&ideal.factor, &ideal.ratios[at]),
        };
        depths.extend(tolerances.iter().map(|tolerance| bound.decide(tolerance)));
    }
    let quantities = ideal.named.into_iter().zip(float.named).map(|((name, exact), (_, value))| {
        let bound = bounds.get(&name).copied();
        Quantity::new(name, value, exact, bound)
    });
    Ok(Certification { quantities: quantities.collect(), depths, tracked_block })
}

fn check(options: &CertifyOptions) -> Result<(), CertifyError> {
    let tolerances = options.tolerances.iter().map(|tolerance| ("a tolerance", tolerance));
    for (what, value) in tolerances.chain([("the spread", &options.spread)]) {
        if value.sign() <= 0 {
            return Err(CertifyError::NotPositive { what, value: value.clone() });
        }
    }
    match options.levels.iter().find(|&&level| level > MAX_CERTIFIED_LEVEL) {
        Some(&level) => Err(CertifyError::Level(level)),
        None => Ok(()),
    }
}

/// The greatest c up to `max_block` whose walks stay within [`MAX_TRACKED_STEPS`].
fn tracked_block(scheme: &Scheme, max_block: u32) -> u32 {
    let fits = |mask: &Mask, c: u32| {
        let (arity, width) = (mask.arity() as u64, mask.width() as u64);
        let steps = arity.checked_pow(c).map(|classes| classes.saturating_mul((width + 2) * width));
        steps.is_some_and(|steps| steps <= MAX_TRACKED_STEPS)
    };
    let fits_all = |c: &u32| scheme.masks().iter().all(|mask| fits(mask, *c));
    (1..=max_block).take_while(fits_all).last().unwrap_or(0)
}
