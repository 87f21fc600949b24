//! One claim as JSON.

use super::SCHEMA;
use super::audit::AuditReport;
use super::claim::Claim;
use crate::audit::PaperAudit;
use crate::claim::Target;
use crate::report::json::tables::reading::Reading;
use crate::report::json::tables::working::Working;
use crate::report::json::theorems::by_hand::ByHand;
use crate::report::papers::explain::table_of;
use crate::report::tables::eye::Eye;
use crate::report::told::Background;
use serde::Serialize;

/// What `subcert explain` finds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Explained<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The id that was asked about.
    pub id: &'a str,
    /// The claim of this id; of a table, its cells.
    pub claims: Vec<Claim<'a>>,
    /// The readings of the table, the best first; null where the id is not that of a table or of
    /// a cell.
    pub readings: Option<Vec<Reading<'a>>>,
    /// The computation behind the data that refute a theorem; null for any other claim.
    pub by_hand: Option<ByHand<'a>>,
    /// The values from which a cell is computed; null for any other claim.
    pub working: Option<Working>,
    /// For a cell that breaks its promise with a control polygon: whether that breaks it as a set of points too; else null.
    pub as_sets: Option<AsSets>,
}

/// A control polygon of numbers as a set of points, with neighbours β apart along a second coordinate.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AsSets {
    /// The level of the promise.
    pub level: u32,
    /// The promised bound.
    pub most: String,
    /// Whether its Hausdorff distance from its limit is more than that; null where that is not decided.
    pub broken: Option<bool>,
}

impl AsSets {
    fn of(eye: &Eye) -> AsSets {
        let Eye { level, most, broken, .. } = eye;
        AsSets { level: *level, most: most.to_string(), broken: *broken }
    }
}

impl<'a> Explained<'a> {
    /// The JSON form of the claim or table of this id.
    #[must_use]
    pub fn of(
        audits: &'a [PaperAudit<'_>],
        id: &'a str,
        background: Background<'a>,
    ) -> Explained<'a> {
        let Background { readings, by_hand, working, eye } = background;
        let table = table_of(audits, id);
        let claims = AuditReport::of(audits).papers.into_iter().flat_map(|paper| paper.claims);
        let own = Target::of(id).within();
        let findings = audits.iter().flat_map(|audit| &audit.smoothness);
        let cells = findings.filter(|finding| finding.claim.is_cell_of(&own));
        let cells: Vec<&str> = cells.map(|finding| &finding.id[..]).collect();
        let named = |claim: &Claim<'_>| {
            claim.id == id
                || cells.contains(&claim.id)
                || claim.id.strip_prefix(id).is_some_and(|rest| rest.starts_with(':'))
        };
        Explained {
            schema: SCHEMA,
            id,
            claims: claims.filter(named).collect(),
            readings: table.map(|(finding, at)| Reading::all(finding, readings, at)),
            by_hand: by_hand.map(ByHand::of),
            working: working.map(Working::of),
            as_sets: eye.map(AsSets::of),
        }
    }
}
