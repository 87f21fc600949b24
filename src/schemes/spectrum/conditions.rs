//! What the literature asks of the eigenvalues.

use super::blocks::Blocks;
use super::eigenvalues::Eigenvalue;
use super::error::SpectrumError;
use super::jordan::{Chain, chains};
use super::moduli::ComplexEigenvalues;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar};
use std::cmp::Ordering;

/// How the greatest modulus μ of the eigenvalues after 1 and λ compares with λ².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curvature {
    /// μ < λ²: the curvature tends to 0.
    Vanishing,
    /// μ = λ² without a Jordan block: the curvature is bounded and in general not 0.
    Bounded,
    /// μ = λ² with a Jordan block of size s ≥ 2: the curvature is unbounded in general, and grows like the power s − 1 of the
    /// number of steps.
    Growing,
    /// μ > λ²: the curvature is unbounded in general.
    Unbounded,
}

impl Curvature {
    /// By a modulus, the size of the greatest Jordan block of its eigenvalues, and λ²; `None` where the size decides and is not
    /// known.
    #[must_use]
    pub fn of(
        modulus: &RealExpression,
        size: Option<usize>,
        square: &RealExpression,
    ) -> Option<Curvature> {
        Some(match (modulus.cmp(square), size) {
            (Ordering::Less, _) => Curvature::Vanishing,
            (Ordering::Equal, Some(1)) => Curvature::Bounded,
            (Ordering::Equal, Some(_)) => Curvature::Growing,
            (Ordering::Equal, None) => return None,
            (Ordering::Greater, _) => Curvature::Unbounded,
        })
    }

    /// Whether the curvature of the surface of generic data is unbounded.
    #[must_use]
    pub fn is_unbounded(self) -> bool {
        matches!(self, Curvature::Growing | Curvature::Unbounded)
    }

    /// `vanishing`, `bounded`, `growing` or `unbounded`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Curvature::Vanishing => "vanishing",
            Curvature::Bounded => "bounded",
            Curvature::Growing => "growing",
            Curvature::Unbounded => "unbounded",
        }
    }
}

/// The conditions on the eigenvalues 1 > λ > |μ| ≥ … of a ring. They are necessary for normal continuity
/// with bounded curvature; they say nothing of the characteristic map, which must be regular and
/// injective as well (Reif 1995; Peters and Reif 2008).
#[derive(Clone, Debug, PartialEq)]
pub struct Conditions {
    /// Whether 1 is a simple eigenvalue, and the moduli of all others are below 1. Then the points of the
    /// ring tend to one point, which the limit stencil gives.
    pub simple_one: bool,
    /// λ, where it is the only eigenvalue of its modulus after 1, positive, double, and one of block 1 and
    /// one of block n − 1.
    pub subdominant: Option<RealExpression>,
    /// The greatest modulus after λ, with its eigenvalues in the list; `None` without λ, where nothing
    /// follows, or where it is not known, since it may be one of complex eigenvalues that are not computed.
    pub next: Option<RealExpression>,
    /// How μ compares with λ²; `None` also where that depends on a Jordan block that is not decided.
    pub curvature: Option<Curvature>,
    /// The Jordan blocks of the eigenvalues of the modulus μ, and of those of the modulus λ²; without such a λ, those of the
    /// greatest modulus after 1.
    pub chains: Vec<Chain>,
}

/// Eigenvalues that are not computed: the greatest of their moduli is at most this.
struct Others<'a> {
    most: RealExpression,
    largest: &'a ComplexEigenvalues,
}

impl Others<'_> {
    fn of(all: &[ComplexEigenvalues]) -> Option<Others<'_>> {
        let largest = all.iter().max_by(|a, b| a.greatest[1].cmp(&b.greatest[1]))?;
        Some(Others { most: RealExpression::from(largest.greatest[1].clone()), largest })
    }

    /// Whether all of them are known to be below a modulus.
    fn are_below(&self, modulus: &RealExpression) -> bool {
        self.most < *modulus
    }

    fn undecided(&self) -> SpectrumError {
        let blocks = &self.largest.blocks;
        SpectrumError::Complex { block: blocks.first().copied().unwrap_or(0), count: blocks.len() }
    }
}

impl Conditions {
    /// Of all eigenvalues of a ring: those that are computed, in descending order of the moduli, and the others.
    pub(super) fn of(
        blocks: &Blocks,
        (eigenvalues, others): (&[Eigenvalue], &[ComplexEigenvalues]),
        cosines: &[RealCyclotomic],
    ) -> Result<Conditions, SpectrumError> {
        let n = blocks.order;
        let one = RealExpression::from(Rational::one());
        let first = eigenvalues.first();
        let simple_one = first.is_some_and(|first| {
            first.imaginary.is_none() && first.real == one && first.multiplicity == 1
        }) && eigenvalues.get(1).is_none_or(|next| next.modulus < one);
        // The modulus that no other eigenvalue exceeds.
        let others = Others::of(others);
        if let Some(others) = others.as_ref().filter(|_| simple_one) {
            match eigenvalues.get(1) {
                Some(second) if others.are_below(&second.modulus) => {}
                _ => return Err(others.undecided()),
            }
        }
        let mut conditions = Conditions {
            simple_one,
            subdominant: None,
            next: None,
            curvature: None,
            chains: vec![],
        };
        let [_, second, rest @ ..] = eigenvalues else { return Ok(conditions) };
        let alone = rest.first().is_none_or(|next| next.modulus < second.modulus);
        let right = second.imaginary.is_none()
            && second.real.sign() > 0
            && second.blocks == [1, n - 1]
            && alone;
        if !simple_one || !right {
            if simple_one {
                conditions.chains = chains(blocks, eigenvalues, &second.modulus, cosines)?;
            }
            return Ok(conditions);
        }
        conditions.subdominant = Some(second.real.clone());
        if let Some(next) = rest.first() {
            let square = second.real.times(&second.real);
            let below = |modulus| others.as_ref().is_none_or(|others| others.are_below(modulus));
            if !below(&next.modulus) {
                conditions.curvature = match next.modulus.cmp(&square) {
                    Ordering::Greater => Some(Curvature::Unbounded),
                    Ordering::Less if below(&square) => Some(Curvature::Vanishing),
                    _ => None,
                };
                return Ok(conditions);
            }
            conditions.next = Some(next.modulus.clone());
            conditions.chains = chains(blocks, eigenvalues, &next.modulus, cosines)?;
            if next.modulus != square && below(&square) {
                conditions.chains.extend(chains(blocks, eigenvalues, &square, cosines)?);
            }
            let size = conditions.longest(|_| true, &next.modulus);
            conditions.curvature = Curvature::of(&next.modulus, size, &square);
        }
        Ok(conditions)
    }

    /// The size of the greatest Jordan block of the eigenvalues of one of the moduli of [`chains`](Self::chains), of some Fourier blocks; `None` where it
    /// is not decided.
    pub fn longest(&self, of: impl Fn(usize) -> bool, modulus: &RealExpression) -> Option<usize> {
        let own = self.chains.iter().filter(|one| of(one.block) && one.modulus == *modulus);
        own.map(|one| one.size).try_fold(1, |most, size| Some(most.max(size?)))
    }
}
