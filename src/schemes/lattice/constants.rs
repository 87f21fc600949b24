//! How fast differences contract: T_c, and the norms Λ_c.

use super::norm::{Edges, Norm, NormError};
use super::powers::{Functional, Steps};
use crate::cap::Cap;
use crate::exact::{Rational, Real as _};
use crate::scheme::{LatticeMask, Point, difference};
use std::collections::BTreeSet;

/// The most functionals of one constant.
pub const MAX_FUNCTIONALS: usize = 1 << 14;

/// The most differences of the last of the constants of a depth.
const MAX_DIFFERENCES: usize = 1 << 12;

/// The most coefficients of several steps.
const MAX_COEFFICIENTS: usize = 1 << 18;

/// T_c = max { |(S^c p)_{α+u} − (S^c p)_α| : |p_{β+u} − p_β| ≤ 1 for all β and edges u }, with what proves it.
#[derive(Clone, Debug)]
pub struct Contraction {
    /// c.
    pub count: u32,
    /// T_c.
    pub value: Rational,
    /// α, one of the digits of M^c.
    pub place: Point,
    /// u.
    pub edge: Point,
    /// The difference as a functional of the data.
    pub functional: Functional<Rational>,
    /// Its norm.
    pub norm: Norm<Rational>,
}

/// The constants of a mask on Z^d, one after the other.
#[derive(Clone, Debug)]
pub struct LatticeConstants<'m> {
    steps: Steps<'m, Rational>,
    edges: Edges,
    classes: usize,
}

impl<'m> LatticeConstants<'m> {
    /// Those of this mask, from c = 0 on.
    #[must_use]
    pub fn new(mask: &'m LatticeMask) -> LatticeConstants<'m> {
        LatticeConstants {
            steps: Steps::none(mask),
            edges: Edges::new(mask.edges(), mask.dimension()),
            classes: mask.dilation().class_count(),
        }
    }

    /// How many differences there are after one step more.
    #[must_use]
    pub fn next_count(&self) -> usize {
        let classes = self.classes.saturating_pow(self.steps.count() + 1);
        classes.saturating_mul(self.steps.mask().edges().len())
    }

    /// One step more.
    ///
    /// # Errors
    /// When there are too many functionals or coefficients.
    pub fn advance(&mut self) -> Result<(), Cap> {
        let functionals = self.classes.saturating_pow(self.steps.count() + 1);
        if functionals.saturating_mul(self.edges.all().len()) > MAX_FUNCTIONALS {
            return Err(Cap::new(
                "the number of differences of one constant",
                MAX_FUNCTIONALS as u64,
            ));
        }
        let next = self.steps.next();
        if next.coefficients().len() > MAX_COEFFICIENTS {
            return Err(Cap::new("the number of coefficients", MAX_COEFFICIENTS as u64));
        }
        self.steps = next;
        Ok(())
    }

    /// T_0 = 1, T_1, T_2, … as far as one of them is a maximum of up to 2^12 differences; T_1 in any case, if it can be computed.
    ///
    /// # Errors
    /// When a difference has too many places.
    pub fn up_to_cap(mask: &'m LatticeMask) -> Result<Vec<Rational>, NormError> {
        let (mut constants, mut all) = (LatticeConstants::new(mask), vec![Rational::one()]);
        while all.len() == 1 || constants.next_count() <= MAX_DIFFERENCES {
            if constants.advance().is_err() {
                break;
            }
            all.push(constants.contraction()?.value);
        }
        Ok(all)
    }

    /// The steps up to here.
    #[must_use]
    pub fn steps(&self) -> &Steps<'m, Rational> {
        &self.steps
    }

    /// Λ_c = max_α Σ_β |a_c(α − M^cβ)|.
    #[must_use]
    pub fn norm(&self) -> Rational {
        let rows = self.steps.rows();
        let sums = rows.iter().map(|(_, row)| row.values().map(Rational::abs).sum::<Rational>());
        Rational::maximum(sums)
    }

    /// T_c.
    ///
    /// Differences that are the same but for a shift and the sign have one norm.
    ///
    /// # Errors
    /// When a difference has too many places.
    ///
    /// # Panics
    /// Never: a mask has edges.
    pub fn contraction(&self) -> Result<Contraction, NormError> {
        let mut seen = BTreeSet::new();
        let mut best: Option<Contraction> = None;
        for (place, edge, functional) in self.steps.differences() {
            if !seen.insert(normalised(&functional)) {
                continue;
            }
            let norm = self.edges.norm(&functional)?;
            if best.as_ref().is_none_or(|best| norm.value > best.value) {
                let value = norm.value.clone();
                let count = self.steps.count();
                best = Some(Contraction { count, value, place, edge, functional, norm });
            }
        }
        Ok(best.expect("a mask has edges"))
    }
}

/// A functional up to a shift and the sign.
pub(super) fn normalised(functional: &Functional<Rational>) -> Vec<(Point, Rational)> {
    let Some((first, lead)) = functional.first_key_value() else { return Vec::new() };
    let sign = if lead.sign() < 0 { -Rational::one() } else { Rational::one() };
    functional.iter().map(|(place, c)| (difference(*place, *first), c * &sign)).collect()
}
