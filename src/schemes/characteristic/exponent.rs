//! The Hölder exponent of the first derivatives.

use crate::exact::{Enclosed, Enclosure, Rational, natural_logarithm};
use crate::spectrum::{Curvature, Spectrum};

/// The surface is C^{1,α} at the vertex for the α of the interval, by the eigenvalues; more smoothness is not
/// asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Exponent {
    /// min(1, ln μ/ln λ − 1), enclosed; μ is the greatest modulus after λ.
    pub value: Enclosure,
    /// How μ compares with λ².
    pub curvature: Curvature,
    /// The blocks with eigenvalues of the modulus μ, ascending.
    pub blocks: Vec<usize>,
}

/// The exponent of a C¹ surface; `None` where no eigenvalue follows.
pub(super) fn exponent(spectrum: &Spectrum) -> Option<Exponent> {
    let conditions = &spectrum.conditions;
    let (value, next) = (conditions.subdominant.as_ref()?, conditions.next.as_ref()?);
    let curvature = conditions.curvature?;
    let with_modulus = spectrum.eigenvalues.iter().filter(|one| one.modulus == *next);
    let mut blocks: Vec<usize> = with_modulus.flat_map(|one| one.blocks.clone()).collect();
    blocks.sort_unstable();
    blocks.dedup();
    let one = Rational::one();
    let value = if curvature == Curvature::Unbounded {
        // ln μ/ln λ, both negative.
        let [low, high] = [next, value].map(|number| {
            let ends = number.enclosure(1);
            let lower = natural_logarithm(ends.lower(), 96).lower().clone();
            let upper = natural_logarithm(ends.upper(), 96).upper().clone();
            Enclosure::new(-&upper, -&lower)
        });
        Enclosure::new(low.lower() / high.upper() - &one, low.upper() / high.lower() - &one)
    } else {
        Enclosure::exact(one)
    };
    Some(Exponent { value, curvature, blocks })
}
