//! The claims that are open since a value is beyond a cap.

use crate::finding::{EquationVerdict, FunctionVerdict, Known, PaperAudit};
use std::fmt::Display;

/// A claim other than a table or a theorem of which a value is beyond a cap.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BeyondCap<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where it stands.
    pub locus: &'a str,
    /// The cap.
    pub cap: String,
}

impl<'a> PaperAudit<'a> {
    /// The equations, closed forms, ranges and claims about smoothness of which a value is beyond a cap.
    #[must_use]
    pub fn beyond_caps(&self) -> Vec<BeyondCap<'a>> {
        let one = |id: &'a String, locus: &'a String, cap: &dyn Display| {
            Some(BeyondCap { id, locus, cap: cap.to_string() })
        };
        let equations = self.equations.iter().filter_map(|finding| match &finding.verdict {
            EquationVerdict::BeyondCap(cap) => {
                one(&finding.equation.id, &finding.equation.locus, cap)
            }
            _ => None,
        });
        let functions = self.functions.iter().filter_map(|finding| match &finding.verdict {
            FunctionVerdict::BeyondCap(cap) => one(&finding.claim.id, &finding.claim.locus, cap),
            _ => None,
        });
        let ranges = self.ranges.iter().filter_map(|finding| {
            one(&finding.claim.id, &finding.claim.locus, finding.found.as_ref().err()?)
        });
        let smoothness = self.smoothness.iter().filter_map(|finding| match &finding.known {
            Known::BeyondCap(cap) => one(&finding.claim.id, &finding.claim.locus, cap),
            _ => None,
        });
        equations.chain(functions).chain(ranges).chain(smoothness).collect()
    }
}
