//! Left eigenvectors: the stencils of limits and tangents.

use super::blocks::{Blocks, part};
use super::circulant::Circulant;
use super::eigenvalues::{at_block, check, known_roots, turning_characteristic};
use super::error::SpectrumError;
use super::extension::Extension;
use crate::exact::{Adjugate, Rational, RealCyclotomic, RealExpression, Scalar, only_solution};
use std::collections::BTreeMap;

/// A weight for each point of a ring.
pub type Stencil<W> = Vec<W>;

/// The left eigenvector of the eigenvalue 1 whose weights sum to 1, if this eigenvalue is simple.
///
/// It is constant on each cycle: w_{(a,i)} = u_a/n_a for a cycle of n_a points (n or 1) and a left
/// eigenvector u of block 0 with Σ_a u_a = 1. The columns of M̂_0 − 1 sum to 0, so that any one of the
/// equations Σ_a u_a (M̂_0 − 1)_{a,b} = 0 follows from the others, and the condition on the sum takes its
/// place.
pub(super) fn limit(blocks: &Blocks) -> Option<Stencil<RealCyclotomic>> {
    let count = blocks.cycles.len();
    let one = RealCyclotomic::from(1);
    let mut rows: Vec<Vec<RealCyclotomic>> = (0..count)
        .map(|b| {
            let entry = |a: usize| {
                let entry = &blocks.still[a][b];
                if a == b { entry.minus(&one) } else { entry.clone() }
            };
            (0..count).map(entry).chain([RealCyclotomic::zero()]).collect()
        })
        .collect();
    rows[count - 1] = vec![one; count + 1];
    let sums = only_solution(rows)?;
    let share = |cycle: usize| Rational::new(1, blocks.cycles[cycle].points.len());
    let weights: Vec<RealCyclotomic> =
        sums.iter().enumerate().map(|(cycle, sum)| sum.times(&share(cycle).into())).collect();
    Some(by_point(blocks, |cycle, _| weights[cycle].clone()))
}

/// The weights w_{(a,i)} for all points of all cycles.
fn by_point<W: Clone>(blocks: &Blocks, weight: impl Fn(usize, usize) -> W) -> Stencil<W> {
    let mut placed = BTreeMap::new();
    for (a, cycle) in blocks.cycles.iter().enumerate() {
        for (i, &point) in cycle.points.iter().enumerate() {
            placed.insert(point, weight(a, i));
        }
    }
    placed.into_values().collect()
}

/// The two stencils of the tangents: the real and the negative imaginary part of the left eigenvector
///
/// w_{(a,j)} = û_a ω^{−j},  û M̂_1 = λ û,
///
/// of a real simple eigenvalue λ of block 1. û is a row of adj(λ − M̂_1), divided by its entry at the
/// first cycle r for which this is not 0; so the weights there are cos(2πj/n) and sin(2πj/n). `None`
/// where λ is no such eigenvalue.
pub(super) fn tangents(
    blocks: &Blocks,
    eigenvalue: &RealExpression,
    cosines: &[RealCyclotomic],
) -> Result<Option<[Stencil<RealExpression>; 2]>, SpectrumError> {
    for component in blocks.turning_components() {
        let polynomial = at_block(&turning_characteristic(blocks, &component)?, 1, cosines);
        let roots = known_roots(1, polynomial)?;
        let found = roots.iter().find(|root| root.imaginary.is_none() && root.real == *eigenvalue);
        if let Some(extension) = found.and_then(|root| root.extension.as_ref()) {
            return eigenvector(blocks, &component, extension, cosines);
        }
    }
    Ok(None)
}

/// Numbers κ_d of K(λ), where equal numbers share one entry: Σ_d κ_d ω^d.
type Turned = Vec<(Vec<RealCyclotomic>, Vec<usize>)>;

fn eigenvector(
    blocks: &Blocks,
    component: &[usize],
    extension: &Extension,
    cosines: &[RealCyclotomic],
) -> Result<Option<[Stencil<RealExpression>; 2]>, SpectrumError> {
    // The eigenvector is 0 on the cycles on which those of the component do not depend.
    let sources = blocks.turning_sources(component);
    check(sources.len(), blocks.order)?;
    let adjugate = Adjugate::of(&part(blocks.turning(), &sources)).adjugate;
    let row = |r: usize| (0..sources.len()).filter(|a| component.contains(&sources[*a])).nth(r);
    let scaled = (0..component.len()).filter_map(row).find_map(|r| {
        let entries: Vec<&Circulant> = adjugate.iter().map(|matrix| &matrix[r][r]).collect();
        if !entries.iter().all(|entry| entry.is_even()) {
            return None;
        }
        let value: Vec<RealCyclotomic> =
            entries.iter().map(|entry| entry.real_part(1, cosines)).collect();
        Some((r, extension.inverse(&extension.reduced(&value))?))
    });
    let Some((r, scale)) = scaled else { return Ok(None) };
    let turned: BTreeMap<usize, Turned> = sources
        .iter()
        .enumerate()
        .map(|(a, &source)| {
            let powers: Vec<&Circulant> = adjugate.iter().map(|matrix| &matrix[r][a]).collect();
            (blocks.full()[source], normalized(&powers, extension, &scale))
        })
        .collect();
    let n = blocks.order;
    let factors: BTreeMap<usize, Vec<RealExpression>> = turned
        .iter()
        .map(|(a, turned)| (*a, turned.iter().map(|(k, _)| extension.express(k)).collect()))
        .collect();
    let stencil = |table: &[RealCyclotomic]| {
        by_point(blocks, |a, j| {
            let Some(turned) = turned.get(&a) else { return RealExpression::zero() };
            let terms = turned.iter().zip(&factors[&a]).map(|((_, shifts), factor)| {
                let at = shifts.iter().map(|d| &table[(j + n - d) % n]);
                factor.times_apart(&RealExpression::from(RealCyclotomic::total(at)))
            });
            terms.fold(RealExpression::zero(), |sum, term| sum.plus(&term))
        })
    };
    Ok(Some([stencil(cosines), stencil(&sines(n))]))
}

/// scale·Σ_i λ^i p_i, for polynomials p_i in the rotation.
fn normalized(powers: &[&Circulant], extension: &Extension, scale: &[RealCyclotomic]) -> Turned {
    let mut coefficients: BTreeMap<usize, Vec<RealCyclotomic>> = BTreeMap::new();
    for (i, power) in powers.iter().enumerate() {
        for (d, value) in power.terms() {
            let zeros = || vec![RealCyclotomic::zero(); powers.len()];
            coefficients.entry(d).or_insert_with(zeros)[i] = value.clone();
        }
    }
    let mut turned = Turned::new();
    for (d, coefficients) in coefficients {
        let value = extension.product(&extension.reduced(&coefficients), scale);
        if value.iter().all(|c| c.sign() == 0) {
            continue;
        }
        match turned.iter_mut().find(|(known, _)| *known == value) {
            Some((_, shifts)) => shifts.push(d),
            None => turned.push((value, vec![d])),
        }
    }
    turned
}

/// sin(2πj/n) = cos(2π(j/n − 1/4)) for j = 0, …, n−1.
fn sines(n: usize) -> Vec<RealCyclotomic> {
    let turn = |j: usize| Rational::new(j, n) - Rational::new(1, 4);
    let sine = |j| RealCyclotomic::cosine(&turn(j));
    (0..n).map(|j| sine(j).expect("four times as many points as a ring may have")).collect()
}
