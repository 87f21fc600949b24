//! The facts of a scheme, as JSON.

use super::SCHEMA;
use super::exact::Exact;
use super::lattice::LatticeForm;
use super::open::OpenForm;
use super::sets::{Interval, Number as RootNumber};
use crate::exact::{Rational, RealAlgebraic};
use crate::facts::{
    CurveFacts, FamilyFacts, ParameterFacts, PointPlacement, SchemeFacts, ValenceFacts,
};
use crate::limit::{Functional, TwoSidedDepth};
use crate::report::json::smooth::exponent::HoelderForm;
use crate::report::json::smooth::vertex::VertexForm;
use crate::scheme::notes;
use crate::smoothness::{Coefficient, SpecialValue, SpecialValues};
use serde::Serialize;

/// What `subcert scheme` writes: the facts of one scheme.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Facts<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The facts; their fields stand here.
    #[serde(flatten)]
    pub found: &'a FactsForm,
    /// Where in the parameter of its family the limits are C^m, m = 0, 1, …; of masks that are
    /// polynomial in the only parameter, and C^1 of rules around a vertex or on a face with one weight.
    pub ranges: Option<Ranges>,
}

/// Where in a parameter the limits are C^m.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Ranges {
    /// The parameter.
    pub parameter: String,
    /// The sets for m = 0, 1, …, or for each valence.
    pub orders: Vec<Order>,
    /// Why there are no more.
    pub end: String,
    /// The values at which more holds; none of rules around a vertex or on a face.
    pub special: Vec<SpecialForm>,
}

/// Where the limits are C^m. What is in neither set is open.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Order {
    /// m.
    pub smoothness: usize,
    /// Of rules around a vertex or on a face, the valence; null of masks.
    pub valence: Option<usize>,
    /// There they are.
    pub inside: Vec<Interval>,
    /// There not all of them are, but for finitely many values at most where that is said.
    pub outside: Vec<Interval>,
    /// Whether finitely many values outside may be exceptions.
    pub but_finitely_many: bool,
}

/// The facts of a scheme. One of `curve`, `lattice` and `valences` is there.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FactsForm {
    /// The scheme as it was given.
    pub scheme: String,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The facts of a mask.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub curve: Option<CurveForm>,
    /// The facts of a mask on Z^d.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lattice: Option<LatticeForm>,
    /// The facts of rules around a vertex or on a face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub valences: Option<Vec<ValenceForm>>,
}

/// The facts of a mask.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CurveForm {
    /// The arity n.
    pub arity: usize,
    /// How many points a rule takes, from the first to the last.
    pub points: usize,
    /// `primal` or `dual`; null where the scheme is neither, or has no centre and keeps no lines.
    pub kind: Option<&'static str>,
    /// Whether all points of the data are kept.
    pub interpolating: bool,
    /// The ends of the support of the basic limit function, when x^k_i belongs to i/n^k.
    pub support: [Exact; 2],
    /// Its length.
    pub support_length: Exact,
    /// The centre of the basic limit function; null where the mask is not symmetric.
    pub centre: Option<Exact>,
    /// The order of the sum rules.
    pub sum_rules: usize,
    /// The degree up to which polynomials are generated.
    pub generation: usize,
    /// The degree up to which polynomials are reproduced at the natural shift.
    pub reproduction: usize,
    /// The natural shift s: x^k_i belongs to (i + s)/n^k. Null where lines are not kept.
    pub natural_shift: Option<Exact>,
    /// The largest m for which the limits are proven to be C^m; null where convergence is not proven.
    pub continuity: Option<usize>,
    /// The least m for which it is proven that not all limits are C^m, 0 of a divergent scheme; null where there is
    /// none.
    pub continuity_fails: Option<usize>,
    /// The Hölder exponent; null where convergence is not proven.
    pub hoelder: Option<HoelderForm>,
    /// T_1, T_2, …, as far as they are found, up to T_8.
    pub contraction: Vec<Exact>,
    /// Λ_1, Λ_2, …, as far as they are found, up to Λ_8.
    pub norm: Vec<Exact>,
    /// σ at the scheme's offset.
    pub displacement: Exact,
    /// The best offset, and σ there; null of irrational masks.
    pub best_offset: Option<OffsetForm>,
    /// The depth of polygons with differences up to 1 for the tolerance 1/100, with x^k_i at i/n^k.
    pub depth_indexed: Option<DepthForm>,
    /// The same with x^k_i at its natural parameter.
    pub depth_natural: Option<DepthForm>,
    /// The values of the basic limit function at the integers where it is not 0; null where they are open.
    pub values: Option<Vec<WeightForm>>,
    /// The stencils of the limit at 0 and, where that is another place, at the natural shift; null where they are open.
    pub stencils: Option<Vec<StencilForm>>,
    /// What is open, and why.
    pub open: Vec<OpenForm>,
}

/// An offset and its σ.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OffsetForm {
    /// The offset.
    pub offset: i64,
    /// σ.
    pub displacement: Exact,
}

/// A depth from both sides.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DepthForm {
    /// Fewer levels are too few.
    pub lower: u32,
    /// So many are enough, and all later ones.
    pub upper: u32,
}

/// A number with an index.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WeightForm {
    /// The index of a point, or the parameter of a value.
    pub index: i64,
    /// The number; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
}

/// The limit at a parameter as a combination of points.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StencilForm {
    /// The parameter, when x^0_i belongs to i.
    pub parameter: Exact,
    /// The weights of the points.
    pub weights: Vec<WeightForm>,
}

/// The facts at a valence.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ValenceForm {
    /// The valence.
    pub valence: usize,
    /// What is known; null where there are no eigenvalues.
    pub vertex: Option<VertexForm>,
    /// μ, the greatest modulus after λ; null where it is not known.
    pub next: Option<Exact>,
    /// Why there are no eigenvalues; null where there are.
    pub open: Option<String>,
}

/// A value of the parameter at which the sum rules are of a higher order than at most values, or the support is shorter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpecialForm {
    /// The value.
    pub value: RootNumber,
    /// The order of the sum rules there.
    pub sum_rules: usize,
    /// The ends of the support of the basic limit function there.
    pub support: [Exact; 2],
    /// The largest m for which the limits are proven to be C^m there; null where that is not examined, or open.
    pub continuity: Option<usize>,
    /// The least m for which it is proven that not all limits are C^m there; null where that is not examined, or open.
    pub continuity_fails: Option<usize>,
    /// The value itself.
    #[serde(skip)]
    pub place: RealAlgebraic,
}

impl SpecialForm {
    /// The forms of all special values.
    #[must_use]
    pub fn all(values: &SpecialValues, parameter: &str) -> Vec<SpecialForm> {
        let special = |one: &SpecialValue| {
            let found = one.smoothness.as_ref();
            let (low, high) = &one.support;
            SpecialForm {
                value: RootNumber::of(&one.value, parameter),
                sum_rules: one.sum_rules,
                support: [Exact::of(low), Exact::of(high)],
                continuity: found.and_then(|found| found.continuity),
                continuity_fails: found.and_then(|found| found.continuity_fails),
                place: one.value.clone(),
            }
        };
        values.values.iter().map(special).collect()
    }
}

impl<'a> Facts<'a> {
    /// The form of what is known of a scheme, and of its family.
    #[must_use]
    pub fn of(found: &'a FactsForm, family: Option<&FamilyFacts>) -> Facts<'a> {
        Facts { schema: SCHEMA, found, ranges: family.map(Ranges::of) }
    }
}

impl Ranges {
    fn of(family: &FamilyFacts) -> Ranges {
        let FamilyFacts { parameter, ranges, end, special } = family;
        let order = |range: &ParameterFacts| Order {
            smoothness: range.m,
            valence: range.valence,
            inside: Interval::all(&range.inside, parameter),
            outside: Interval::all(&range.outside, parameter),
            but_finitely_many: range.but_finitely_many,
        };
        Ranges {
            parameter: parameter.clone(),
            orders: ranges.iter().map(order).collect(),
            end: end.clone(),
            special: special
                .as_ref()
                .map_or_else(Vec::new, |values| SpecialForm::all(values, parameter)),
        }
    }
}

impl FactsForm {
    /// The form of what is known.
    #[must_use]
    pub fn of(scheme: &str, facts: &SchemeFacts) -> FactsForm {
        let (mut curve, mut lattice, mut valences) = (None, None, None);
        match facts {
            SchemeFacts::Rational(facts) => curve = Some(CurveForm::of(facts)),
            SchemeFacts::Algebraic(facts) => curve = Some(CurveForm::of(facts)),
            SchemeFacts::Lattice(facts) => lattice = Some(LatticeForm::of(facts)),
            SchemeFacts::Surface(all) => {
                valences = Some(all.iter().map(ValenceForm::of).collect());
            }
        }
        FactsForm { scheme: scheme.to_owned(), notes: notes(scheme), curve, lattice, valences }
    }
}

impl CurveForm {
    fn of<F: Coefficient>(facts: &CurveFacts<F>) -> CurveForm {
        let (low, high) = facts.symbol.support();
        let smoothness = facts.smoothness.as_ref().ok();
        let best = facts.best_offset.as_ref();
        let limit = facts.limit.as_ref().ok();
        let open = |(fact, reason)| OpenForm { fact, reason };
        CurveForm {
            arity: facts.symbol.arity(),
            points: facts.points,
            kind: facts.kind.map(PointPlacement::name),
            interpolating: facts.interpolating,
            support: [Exact::of(&low), Exact::of(&high)],
            support_length: Exact::of(&(&high - &low)),
            centre: facts.centre.as_ref().map(Exact::of),
            sum_rules: facts.sum_rules,
            generation: facts.sum_rules.saturating_sub(1),
            reproduction: facts.reproduction,
            natural_shift: facts.shift.keeps_lines.then(|| Exact::of(&facts.shift.shift)),
            continuity: smoothness.and_then(|found| found.continuity),
            continuity_fails: smoothness.and_then(|found| found.continuity_fails),
            hoelder: smoothness.and_then(|found| found.hoelder.as_ref()).map(HoelderForm::of),
            contraction: facts.columns.contraction.iter().map(Exact::of).collect(),
            norm: facts.columns.norm.iter().map(Exact::of).collect(),
            displacement: Exact::of(&facts.displacement),
            best_offset: best.map(|(offset, least)| OffsetForm {
                offset: *offset,
                displacement: Exact::of(least),
            }),
            depth_indexed: facts.depths.indexed.as_ref().ok().copied().map(DepthForm::of),
            depth_natural: facts.depths.natural.as_ref().ok().copied().map(DepthForm::of),
            values: limit.map(|limit| {
                let value =
                    |(index, value): &_| WeightForm { index: *index, value: Exact::of(value) };
                limit.values().iter().map(value).collect()
            }),
            stencils: limit.map(|limit| {
                let zero = StencilForm::of(&Rational::zero(), &limit.at_zero);
                let moved = limit.at_shift.as_ref();
                let moved = moved.map(|(place, stencil)| StencilForm::of(place, stencil));
                std::iter::once(zero).chain(moved).collect()
            }),
            open: facts.open().into_iter().map(open).collect(),
        }
    }
}

impl StencilForm {
    fn of(parameter: &Rational, stencil: &Functional) -> StencilForm {
        let weight = |(index, value): (i64, &_)| WeightForm { index, value: Exact::of(value) };
        StencilForm {
            parameter: Exact::of(parameter),
            weights: stencil.terms().map(weight).collect(),
        }
    }
}

impl DepthForm {
    fn of(depth: TwoSidedDepth) -> DepthForm {
        DepthForm { lower: depth.lower, upper: depth.upper }
    }
}

impl ValenceForm {
    fn of((valence, facts): &ValenceFacts) -> ValenceForm {
        let vertex = facts.as_ref().ok();
        ValenceForm {
            valence: *valence,
            vertex: vertex.map(VertexForm::of),
            next: vertex.and_then(|vertex| vertex.spectrum.conditions.next.as_ref()).map(Exact::of),
            open: facts.as_ref().err().map(ToString::to_string),
        }
    }
}
