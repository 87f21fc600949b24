//! The spectrum of a ring.

use super::blocks::{Blocks, cosines};
use super::conditions::Conditions;
use super::eigenvalues::{Eigenvalue, eigenvalues};
use super::error::SpectrumError;
use super::moduli::ComplexEigenvalues;
use super::stencil::{Stencil, limit, tangents};
use crate::exact::{RealCyclotomic, RealExpression};
use crate::scheme::LocalRules;

/// The eigenvalues of a ring and the stencils of its dominant left eigenvectors.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::scheme::parse_local_rules;
/// use subcert::spectrum::{Curvature, Spectrum};
///
/// let ring = parse_local_rules("doo-sabin:n=7")?;
/// let spectrum = Spectrum::of(&ring)?;
/// let found: Vec<(String, usize)> = spectrum.eigenvalues.iter()
///     .map(|one| (one.real.to_string(), one.multiplicity))
///     .collect();
/// assert_eq!(found, [("1".to_owned(), 1), ("1/2".to_owned(), 2), ("1/4".to_owned(), 4)]);
/// assert_eq!(spectrum.limit, Some(vec![RealCyclotomic::from(Rational::new(1, 7)); 7]));
/// // The points of the face alone: one eigenvalue 1/4 in each block.
/// assert_eq!(spectrum.conditions.curvature, Some(Curvature::Bounded));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The order n of the rotation: the valence.
    pub order: usize,
    /// All eigenvalues in descending order of the absolute value, but for those of `complex`.
    pub eigenvalues: Vec<Eigenvalue>,
    /// Complex eigenvalues that are not computed; only [`Spectrum::known`] gives any.
    pub complex: Vec<ComplexEigenvalues>,
    /// The conditions on them.
    pub conditions: Conditions,
    /// The weights of the points of the ring in their limit; `None` where 1 is no simple eigenvalue.
    pub limit: Option<Stencil<RealCyclotomic>>,
    /// The weights of the points in two tangents at the limit, of which the cross product of the first and
    /// the second is a normal. `None` without a subdominant eigenvalue as
    /// [`Conditions::subdominant`] asks for.
    pub tangents: Option<[Stencil<RealExpression>; 2]>,
}

impl Spectrum {
    /// The spectrum of a ring.
    ///
    /// # Errors
    /// When the ring has no rotation of order 3 or more, no reflection, or eigenvalues beyond reach; see
    /// [`SpectrumError`].
    ///
    /// # Panics
    /// Never.
    pub fn of(ring: &LocalRules) -> Result<Spectrum, SpectrumError> {
        Spectrum::within(ring, None)
    }

    /// The stencils of a ring, and the eigenvalues of a wider ring of which it is the inner part: the new
    /// points of the ring depend only on old points of the ring.
    ///
    /// # Errors
    /// As [`Spectrum::of`].
    ///
    /// # Panics
    /// Never.
    pub fn within(
        ring: &LocalRules,
        wider: Option<&LocalRules>,
    ) -> Result<Spectrum, SpectrumError> {
        let found = Spectrum::known(ring, wider)?;
        match found.complex.first() {
            None => Ok(found),
            Some(ComplexEigenvalues { blocks, .. }) => {
                let block = blocks.first().copied().unwrap_or(0);
                let count = blocks.iter().filter(|k| **k == block).count();
                Err(SpectrumError::Complex { block, count })
            }
        }
    }

    /// The same, also where complex eigenvalues are not computed but are known to be so small, or so large, that they leave
    /// [`Conditions::simple_one`] and [`Conditions::subdominant`] decided.
    ///
    /// # Errors
    /// As [`Spectrum::of`].
    ///
    /// # Panics
    /// Never.
    ///
    /// ```
    /// use subcert::exact::{Rational, format::short};
    /// use subcert::scheme::parse_local_rules;
    /// use subcert::spectrum::Spectrum;
    ///
    /// let ring = parse_local_rules("kobbelt:N=5")?;
    /// assert!(Spectrum::of(&ring).is_err());
    /// let spectrum = Spectrum::known(&ring, None)?;
    /// let subdominant = spectrum.conditions.subdominant.unwrap();
    /// assert!(spectrum.complex.iter().all(|one| one.greatest[1] < Rational::new(1, 3)));
    /// assert_eq!(short(&subdominant, 6), "0.537944");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn known(ring: &LocalRules, wider: Option<&LocalRules>) -> Result<Spectrum, SpectrumError> {
        let inner = Blocks::new(ring)?;
        let order = inner.order;
        let cosines = cosines(order);
        let outer = wider.map(Blocks::new).transpose()?;
        let all = outer.as_ref().unwrap_or(&inner);
        let (eigenvalues, complex) = eigenvalues(all, &cosines)?;
        let conditions = Conditions::of(all, (&eigenvalues, &complex), &cosines)?;
        let limit = if conditions.simple_one { limit(&inner) } else { None };
        let tangents = match &conditions.subdominant {
            Some(eigenvalue) => tangents(&inner, eigenvalue, &cosines)?,
            None => None,
        };
        Ok(Spectrum { order, eigenvalues, complex, conditions, limit, tangents })
    }
}
