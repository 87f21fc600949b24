//! The facts of a mask on Z^d, as JSON.

use super::exact::Exact;
use super::open::OpenForm;
use super::smooth::exponent::HoelderForm;
use crate::exact::Rational;
use crate::facts::{LatticeFacts, PointPlacement};
use crate::lattice::LatticeSmoothness;
use crate::scheme::Point;
use serde::Serialize;

/// The facts of a mask on Z^d.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LatticeForm {
    /// The dilation matrix M, row by row.
    pub dilation: Vec<Vec<i64>>,
    /// The edges along which data are compared.
    pub edges: Vec<Vec<i64>>,
    /// The number of rules, |det M|.
    pub arity: usize,
    /// The number of coefficients other than 0.
    pub coefficients: usize,
    /// `primal` or `dual`, by the natural shift; null where the scheme is neither.
    pub kind: Option<&'static str>,
    /// Whether all points of the data are kept.
    pub interpolating: bool,
    /// The box of the support of the basic limit function, axis by axis, when x^k_α belongs to M^{−k}α; null where no power of M is diagonal.
    pub support: Option<Vec<[Exact; 2]>>,
    /// The number of symmetries of the mask with entries −1, 0 and 1.
    pub symmetries: usize,
    /// The order K of the sum rules.
    pub sum_rules: u32,
    /// The degree up to which polynomials are generated.
    pub generation: u32,
    /// The degree up to which polynomials are reproduced at the natural shift.
    pub reproduction: u32,
    /// The natural shift τ: x^k_α belongs to M^{−k}(α + τ).
    pub natural_shift: Vec<Exact>,
    /// What is proven of the limits; its fields stand here.
    #[serde(flatten)]
    pub smoothness: LatticeSmoothnessForm,
    /// The basic limit function at the integers where it is not 0: the limit of data p at α is Σ_β φ(α − β)p_β. Null where convergence is not proven.
    pub values: Option<Vec<ValueForm>>,
    /// σ with x^k_α at M^{−k}α; null in three dimensions where M is not diagonal.
    pub displacement: Option<Exact>,
    /// σ with x^k_α at its natural place; null in the same cases.
    pub displacement_natural: Option<Exact>,
    /// T_1, T_2, …, as far as they are found.
    pub contraction: Vec<Exact>,
    /// Λ_1, Λ_2, …
    pub norm: Vec<Exact>,
    /// What is open, and why.
    pub open: Vec<OpenForm>,
}

/// A value of a function on a lattice.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ValueForm {
    /// The place.
    pub place: Vec<i64>,
    /// The value there.
    pub value: Exact,
}

/// What is proven of the limits of a mask on Z^d.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LatticeSmoothnessForm {
    /// The order of the accuracy: polynomials of degree below it are sums of shifts of the basic limit function. Null where that is open.
    pub accuracy: Option<u32>,
    /// Whether the scheme converges for all data; null where that is open.
    pub converges: Option<bool>,
    /// The largest m for which the limits are proven to be C^m; null where convergence is not proven.
    pub continuity: Option<u32>,
    /// The least m for which it is proven that not all limits are C^m, 0 of a divergent scheme; null where there is none.
    pub continuity_fails: Option<u32>,
    /// The Hölder exponent; null where it is open.
    pub hoelder: Option<HoelderForm>,
}

impl LatticeSmoothnessForm {
    /// The form of what is proven.
    #[must_use]
    pub fn of(found: &LatticeSmoothness) -> LatticeSmoothnessForm {
        LatticeSmoothnessForm {
            accuracy: found.accuracy,
            converges: found.converges,
            continuity: found.continuity,
            continuity_fails: found.continuity_fails,
            hoelder: found.hoelder.as_ref().map(HoelderForm::of),
        }
    }
}

impl LatticeForm {
    pub(super) fn of(facts: &LatticeFacts) -> LatticeForm {
        let d = facts.mask.dimension();
        let LatticeSmoothness { continuity, continuity_fails, .. } = &facts.smoothness;
        let decided = continuity.zip(*continuity_fails).is_some_and(|(m, fails)| m + 1 == fails);
        let fact = if decided { "Hölder exponent" } else { "limits" };
        let reason = |reason: &String| OpenForm { fact, reason: reason.clone() };
        LatticeForm {
            dilation: facts.mask.dilation().rows().map(<[i64]>::to_vec).collect(),
            edges: vectors(facts.mask.edges(), d),
            arity: facts.mask.dilation().class_count(),
            coefficients: facts.mask.coefficients().len(),
            kind: facts.kind.map(PointPlacement::name),
            interpolating: facts.interpolating,
            support: facts.support.as_ref().map(|axes| {
                axes.iter().map(|[low, high]| [Exact::of(low), Exact::of(high)]).collect()
            }),
            symmetries: facts.symmetries,
            sum_rules: facts.sum_rules,
            generation: facts.sum_rules.saturating_sub(1),
            reproduction: facts.reproduction,
            natural_shift: facts.shift.iter().map(Exact::of).collect(),
            smoothness: LatticeSmoothnessForm::of(&facts.smoothness),
            values: facts.values.as_ref().map(|values| {
                let form = |(place, value): (&Point, &Rational)| ValueForm {
                    place: place[..d].to_vec(),
                    value: Exact::of(value),
                };
                values.iter().map(form).collect()
            }),
            displacement: facts.displacement.as_ref().map(|[indexed, _]| Exact::of(indexed)),
            displacement_natural: facts
                .displacement
                .as_ref()
                .map(|[_, natural]| Exact::of(natural)),
            contraction: facts.contraction.iter().map(Exact::of).collect(),
            norm: facts.norm.iter().map(Exact::of).collect(),
            open: facts.smoothness.open.iter().map(reason).collect(),
        }
    }
}

/// Points in d coordinates.
#[must_use]
pub fn vectors(points: &[Point], dimension: usize) -> Vec<Vec<i64>> {
    points.iter().map(|point| point[..dimension].to_vec()).collect()
}
