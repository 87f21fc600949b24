//! The claims that are open since a value is beyond a cap.

use crate::finding::PaperAudit;

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
        let beyond = self.findings().filter_map(|finding| {
            let (claim, cap) = (finding.claim(), finding.cap()?.to_string());
            Some(BeyondCap { id: claim.id(), locus: claim.locus(), cap })
        });
        beyond.collect()
    }
}
