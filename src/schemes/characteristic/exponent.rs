//! The Hölder exponent of the first derivatives.

use crate::exact::{Enclosed, Enclosure, Rational, RealExpression, Scalar as _, natural_logarithm};
use crate::spectrum::{ComplexEigenvalues, Curvature, Eigenvalue, Spectrum};

/// The surface is C^{1,α} at the vertex for the α of the interval, by the eigenvalues; more smoothness is not
/// asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Exponent {
    /// min(1, ln μ/ln λ − 1), enclosed; μ is the greatest modulus after λ.
    pub value: Enclosure,
    /// Whether the first derivatives have the exponent `value` itself, and not all smaller ones only: where no Jordan block
    /// decides. `None` where that is not decided.
    pub attained: Option<bool>,
    /// How μ compares with λ².
    pub curvature: Curvature,
    /// The blocks with eigenvalues of the modulus μ, ascending.
    pub blocks: Vec<usize>,
    /// The greatest eigenvalue but 1 of block 0, of shapes as a cup (elliptic), and that of the blocks 2 and n − 2, n ≥ 4, of
    /// shapes as a saddle (hyperbolic), by their moduli; and how each compares with λ².
    pub shapes: [Option<(RealExpression, Curvature)>; 2],
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
    let shape = |block: usize| {
        let own = |one: &&Eigenvalue| one.blocks.contains(&block);
        let found = spectrum.eigenvalues[1..].iter().find(own)?;
        let hides = |one: &ComplexEigenvalues| {
            one.blocks.contains(&block)
                && RealExpression::from(one.greatest[1].clone()) >= found.modulus
        };
        if spectrum.complex.iter().any(hides) {
            return None;
        }
        let square = value.times(value);
        let size = conditions.longest(|k| k == block, &found.modulus);
        Some((found.modulus.clone(), Curvature::of(&found.modulus, size, &square)?))
    };
    let shapes = [shape(0), if spectrum.order > 3 { shape(2) } else { None }];
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
    let attained = match curvature {
        Curvature::Vanishing => Some(true),
        _ => conditions.longest(|_| true, next).map(|size| size == 1),
    };
    Some(Exponent { value, attained, curvature, blocks, shapes })
}
