//! The eigenvalues of a ring, by Fourier blocks.

use super::blocks::{Blocks, part};
use super::circulant::Circulant;
use super::error::SpectrumError;
use super::moduli::{ComplexEigenvalues, Pairs};
use super::polynomial::Polynomial;
use super::roots::{Root, roots};
use super::{MAX_COMPONENT, MAX_WORK};
use crate::exact::{Adjugate, RealCyclotomic, RealExpression};
use std::cmp::Ordering;

/// An eigenvalue of a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenvalue {
    /// The real part.
    pub real: RealExpression,
    /// The positive imaginary part y of a pair of complex eigenvalues x ± iy; `None` of a real one.
    pub imaginary: Option<RealExpression>,
    /// The absolute value.
    pub modulus: RealExpression,
    /// The algebraic multiplicity; of each of a pair.
    pub multiplicity: usize,
    /// The Fourier blocks that have it, in ascending order, each as often as it has it.
    pub blocks: Vec<usize>,
}

impl Eigenvalue {
    /// A root of the characteristic polynomials of these blocks.
    pub(super) fn of(root: &Root, of: &[usize]) -> Eigenvalue {
        let Root { real, imaginary, modulus, multiplicity, .. } = root.clone();
        let mut blocks: Vec<usize> =
            of.iter().flat_map(|k| std::iter::repeat_n(*k, multiplicity)).collect();
        blocks.sort_unstable();
        let multiplicity = blocks.len();
        Eigenvalue { real, imaginary, modulus, multiplicity, blocks }
    }
}

/// All eigenvalues: those that are computed, in descending order of the absolute value, and then of the value, and how large the
/// others are.
pub(super) fn eigenvalues(
    blocks: &Blocks,
    cosines: &[RealCyclotomic],
) -> Result<(Vec<Eigenvalue>, Vec<ComplexEigenvalues>), SpectrumError> {
    let (mut found, mut others): (Vec<Eigenvalue>, Vec<ComplexEigenvalues>) = Default::default();
    let mut add = |(roots, pairs): &(Vec<Root>, Vec<Pairs>), of: &[usize]| {
        found.extend(roots.iter().map(|root| Eigenvalue::of(root, of)));
        others.extend(pairs.iter().map(|Pairs { count, greatest }| {
            let blocks = of.iter().flat_map(|k| std::iter::repeat_n(*k, *count)).collect();
            ComplexEigenvalues { blocks, greatest: greatest.clone() }
        }));
    };
    for component in blocks.still_components() {
        check(component.len(), 1)?;
        let polynomial = Adjugate::of(&part(&blocks.still, &component)).characteristic;
        add(&all_roots(0, polynomial)?, &[0]);
    }
    let n = blocks.order;
    for component in blocks.turning_components() {
        let characteristic = turning_characteristic(blocks, &component)?;
        let mut known: Vec<(Polynomial, _)> = Vec::new();
        for k in 1..=n / 2 {
            let polynomial = at_block(&characteristic, k, cosines);
            let both = if 2 * k == n { vec![k] } else { vec![k, n - k] };
            if let Some((_, roots)) = known.iter().find(|(one, _)| *one == polynomial) {
                add(roots, &both);
                continue;
            }
            let roots = all_roots(k, polynomial.clone())?;
            add(&roots, &both);
            known.push((polynomial, roots));
        }
    }
    others.sort_by(|a, b| b.greatest[1].cmp(&a.greatest[1]));
    Ok((merged(found), others))
}

/// The roots of the characteristic polynomial of block k, if all are computed.
pub(super) fn block_roots(k: usize, polynomial: Polynomial) -> Result<Vec<Root>, SpectrumError> {
    let (roots, others) = all_roots(k, polynomial)?;
    match others.first() {
        None => Ok(roots),
        Some(pairs) => Err(SpectrumError::Complex { block: k, count: pairs.count }),
    }
}

/// Those that are computed.
pub(super) fn known_roots(k: usize, polynomial: Polynomial) -> Result<Vec<Root>, SpectrumError> {
    all_roots(k, polynomial).map(|(roots, _)| roots)
}

fn all_roots(k: usize, polynomial: Polynomial) -> Result<(Vec<Root>, Vec<Pairs>), SpectrumError> {
    roots(polynomial).map_err(|complex| SpectrumError::Multiple { block: k, degree: complex.0 })
}

/// The coefficients of det(x − M̂_k) for all k, of the cycles of a component.
pub(super) fn turning_characteristic(
    blocks: &Blocks,
    component: &[usize],
) -> Result<Vec<Circulant>, SpectrumError> {
    check(component.len(), blocks.order)?;
    let characteristic = Adjugate::of(&part(blocks.turning(), component)).characteristic;
    if characteristic.iter().all(Circulant::is_even) {
        Ok(characteristic)
    } else {
        Err(SpectrumError::NoReflection { block: 1 })
    }
}

/// The polynomial with the coefficients Σ_d a_d cos(2πkd/n).
pub(super) fn at_block(
    characteristic: &[Circulant],
    k: usize,
    cosines: &[RealCyclotomic],
) -> Polynomial {
    characteristic.iter().map(|coefficient| coefficient.real_part(k, cosines)).collect()
}

/// Checks that the polynomials of a component are not too much work.
pub(super) fn check(orbits: usize, points: usize) -> Result<(), SpectrumError> {
    let work = orbits.saturating_pow(3).saturating_mul(points);
    if orbits > MAX_COMPONENT || work > MAX_WORK {
        return Err(SpectrumError::TooLarge { orbits, points });
    }
    Ok(())
}

/// The same eigenvalues, each once.
pub(super) fn merged(mut found: Vec<Eigenvalue>) -> Vec<Eigenvalue> {
    found.sort_by(order);
    let mut merged: Vec<Eigenvalue> = Vec::new();
    for next in found {
        match merged.last_mut().filter(|last| order(last, &next) == Ordering::Equal) {
            Some(last) => {
                last.multiplicity += next.multiplicity;
                last.blocks.extend(next.blocks);
                last.blocks.sort_unstable();
            }
            None => merged.push(next),
        }
    }
    merged
}

/// Descending, by the modulus and then by the real part. A real number and a pair of complex ones with
/// both in common do not exist.
fn order(a: &Eigenvalue, b: &Eigenvalue) -> Ordering {
    b.modulus.cmp(&a.modulus).then_with(|| b.real.cmp(&a.real))
}
