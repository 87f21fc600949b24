//! What the literature asks of the eigenvalues.

use super::eigenvalues::Eigenvalue;
use crate::exact::{Rational, RealExpression, Scalar};
use std::cmp::Ordering;

/// How the greatest modulus μ of the eigenvalues after 1 and λ compares with λ².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curvature {
    /// μ < λ²: the curvature tends to 0.
    Vanishing,
    /// μ = λ²: the curvature is bounded and in general not 0.
    Bounded,
    /// μ > λ²: the curvature is unbounded in general.
    Unbounded,
}

impl Curvature {
    /// By a modulus and λ².
    #[must_use]
    pub fn of(modulus: &RealExpression, square: &RealExpression) -> Curvature {
        match modulus.cmp(square) {
            Ordering::Less => Curvature::Vanishing,
            Ordering::Equal => Curvature::Bounded,
            Ordering::Greater => Curvature::Unbounded,
        }
    }

    /// `vanishing`, `bounded` or `unbounded`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Curvature::Vanishing => "vanishing",
            Curvature::Bounded => "bounded",
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
    /// The greatest modulus after λ, with its eigenvalues in the list; `None` without λ, or where nothing
    /// follows.
    pub next: Option<RealExpression>,
    /// How μ compares with λ².
    pub curvature: Option<Curvature>,
}

impl Conditions {
    /// Of all eigenvalues of a ring with a rotation of order n, in descending order of the moduli.
    pub(super) fn of(eigenvalues: &[Eigenvalue], n: usize) -> Conditions {
        let one = RealExpression::from(Rational::one());
        let first = eigenvalues.first();
        let simple_one = first.is_some_and(|first| {
            first.imaginary.is_none() && first.real == one && first.multiplicity == 1
        }) && eigenvalues.get(1).is_none_or(|next| next.modulus < one);
        let mut conditions =
            Conditions { simple_one, subdominant: None, next: None, curvature: None };
        let [_, second, rest @ ..] = eigenvalues else { return conditions };
        let alone = rest.first().is_none_or(|next| next.modulus < second.modulus);
        let right = second.imaginary.is_none()
            && second.real.sign() > 0
            && second.blocks == [1, n - 1]
            && alone;
        if !simple_one || !right {
            return conditions;
        }
        conditions.subdominant = Some(second.real.clone());
        if let Some(next) = rest.first() {
            let square = second.real.times(&second.real);
            conditions.curvature = Some(Curvature::of(&next.modulus, &square));
            conditions.next = Some(next.modulus.clone());
        }
        conditions
    }
}
