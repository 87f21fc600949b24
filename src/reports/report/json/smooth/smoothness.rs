//! What is known of limits, as JSON.

use super::exponent::HoelderForm;
use super::vertex::{VertexForm, VerticesForm};
use crate::audit::{
    KnownLimits, Limits, RangeAtValence, RangeOfLimits, RegionOfLimits, SmoothSets, Witness,
};
use crate::exact::Rational;
use crate::report::json::exact::decimal;
use crate::report::json::lattice::LatticeSmoothnessForm;
use serde::Serialize;

/// The fields that only claims about smoothness have.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SmoothnessDetails {
    /// What is proved of the limits; null for a range without a value that refutes it.
    pub limits: Option<LimitsForm>,
    /// What is proved of the limits of a mask on Z^d; only of such a mask.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lattice: Option<LatticeSmoothnessForm>,
    /// What is proved for all values of the parameter; null unless the claim is a range.
    pub parameter: Option<RangeForm>,
    /// What is known of surfaces at a vertex or on a face; only of rules there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertices: Option<VerticesForm>,
    /// What is proved of rules there for all values of a parameter, at each valence; only of a range of rules.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub valences: Option<Vec<RangeAtValenceForm>>,
    /// What is proved for the values of two parameters; only of a claim about two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<RegionForm>,
}

/// What is proved of the limits of a mask.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LimitsForm {
    /// The greatest m for which they are C^m; null where convergence is not proved.
    pub continuity: Option<usize>,
    /// The least m for which not all of them are C^m, as far as that is proved.
    pub continuity_fails: Option<usize>,
    /// The Hölder exponent; null where convergence is not proved.
    pub hoelder: Option<HoelderForm>,
}

/// What is proved at one valence for all values of a parameter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RangeAtValenceForm {
    /// The valence.
    pub valence: usize,
    /// Where surfaces are C^1.
    pub inside: String,
    /// Where they are not.
    pub outside: String,
    /// The values of which the claim speaks and that are in neither set.
    pub undecided: String,
    /// A value that refutes the claim.
    pub refuted_at: Option<String>,
    /// What is known at that value.
    pub vertex: Option<VertexForm>,
}

/// What is proved for all values of a parameter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RangeForm {
    /// Where the limits are C^m.
    pub inside: Option<String>,
    /// Where not all of them are.
    pub outside: Option<String>,
    /// Whether finitely many values outside may be exceptions.
    pub but_finitely_many: bool,
    /// The values of which the claim speaks and that are in neither set.
    pub undecided: String,
    /// A value that refutes the claim.
    pub refuted_at: Option<String>,
    /// That value as a decimal.
    pub refuted_at_decimal: Option<String>,
}

/// What is proved for the values of two parameters.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RegionForm {
    /// The number of levels in which differences contract in the whole region.
    pub levels: Option<u32>,
    /// The corners of the polygon, counterclockwise.
    pub corners: Vec<[String; 2]>,
    /// A point that refutes the claim.
    pub refuted_at: Option<[String; 2]>,
    /// How many points were tried.
    pub tried: usize,
}

impl RegionForm {
    fn of(found: &RegionOfLimits) -> RegionForm {
        let texts = |point: &[Rational; 2]| point.each_ref().map(ToString::to_string);
        RegionForm {
            levels: found.proof.as_ref().map(|proof| proof.levels),
            corners: found.corners.iter().map(texts).collect(),
            refuted_at: found.witness.as_ref().map(|witness| texts(&witness.at)),
            tried: found.tried,
        }
    }
}

impl SmoothnessDetails {
    pub(crate) fn of(known: &KnownLimits) -> SmoothnessDetails {
        match known {
            KnownLimits::Limits(limits) => {
                SmoothnessDetails { limits: Some(LimitsForm::of(limits)), ..Default::default() }
            }
            KnownLimits::Lattice(limits) => SmoothnessDetails {
                lattice: Some(LatticeSmoothnessForm::of(&limits.smoothness)),
                ..Default::default()
            },
            KnownLimits::Range(range) => {
                let parameter = Some(RangeForm::of(range));
                SmoothnessDetails { parameter, ..SmoothnessDetails::at(range.witness.as_ref()) }
            }
            KnownLimits::Region(found) => {
                let region = Some(RegionForm::of(found));
                SmoothnessDetails { region, ..SmoothnessDetails::at(found.witness.as_ref()) }
            }
            KnownLimits::Vertices(found) => {
                SmoothnessDetails { vertices: Some(VerticesForm::of(found)), ..Default::default() }
            }
            KnownLimits::VertexRanges(found) => {
                let valences = Some(found.iter().map(RangeAtValenceForm::of).collect());
                SmoothnessDetails { valences, ..Default::default() }
            }
            KnownLimits::Absent | KnownLimits::Capped(_) | KnownLimits::BeyondCap(_) => {
                SmoothnessDetails::default()
            }
        }
    }

    /// What is known at a value that refutes a range.
    fn at<P>(witness: Option<&Witness<P>>) -> SmoothnessDetails {
        witness.map(|witness| SmoothnessDetails::of(&witness.limits)).unwrap_or_default()
    }

    /// The exponent as a formula.
    pub(crate) fn exact(&self) -> Option<&String> {
        let of_curve = self.limits.as_ref().and_then(|limits| limits.hoelder.as_ref());
        let of_lattice = self.lattice.as_ref().and_then(|limits| limits.hoelder.as_ref());
        of_curve.or(of_lattice)?.exact.as_ref()
    }
}

impl RangeAtValenceForm {
    fn of(found: &RangeAtValence) -> RangeAtValenceForm {
        let RangeAtValence { range, undecided, witness } = found;
        RangeAtValenceForm {
            valence: range.order,
            inside: range.inside.to_string(),
            outside: range.outside.to_string(),
            undecided: undecided.to_string(),
            refuted_at: witness.as_ref().map(|witness| witness.at.to_string()),
            vertex: witness.as_ref().map(|witness| VertexForm::of(&witness.vertex)),
        }
    }
}

impl LimitsForm {
    fn of(limits: &Limits) -> LimitsForm {
        let smoothness = &limits.smoothness;
        LimitsForm {
            continuity: smoothness.continuity,
            continuity_fails: smoothness.continuity_fails,
            hoelder: smoothness.hoelder.as_ref().map(HoelderForm::of),
        }
    }
}

impl RangeForm {
    fn of(range: &RangeOfLimits) -> RangeForm {
        let sets = range.sets.as_ref();
        let at = range.witness.as_ref().map(|witness| &witness.at);
        RangeForm {
            inside: sets.map(|sets| sets.inside().to_string()),
            outside: sets.map(|sets| sets.outside().to_string()),
            but_finitely_many: sets.is_some_and(SmoothSets::but_finitely_many),
            undecided: range.undecided.to_string(),
            refuted_at: at.map(ToString::to_string),
            refuted_at_decimal: at.map(decimal),
        }
    }
}
