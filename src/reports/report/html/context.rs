//! What all sections of a page are made from.

use crate::audit::PaperAudit;
use crate::certificate::certificate_lines;
use crate::report::json::Certificate;
use std::collections::BTreeMap;

/// An audit, and what certifies it.
pub(crate) struct Context<'p, 'a> {
    pub(crate) audit: &'p PaperAudit<'a>,
    /// The claim file of a paper that is not embedded.
    pub(crate) file: Option<&'p str>,
    /// Whether all of a finding stands on the page beside its section.
    pub(crate) is_whole: bool,
    /// For each claim the lines of its certificate, or why there are none.
    pub(crate) certificate: BTreeMap<String, Result<String, String>>,
    /// What the checker has found of the certificates, by the ids of the claims.
    pub(crate) checked: Option<&'p BTreeMap<String, Certificate>>,
}

impl<'p, 'a> Context<'p, 'a> {
    pub(crate) fn new(audit: &'p PaperAudit<'a>, file: Option<&'p str>) -> Context<'p, 'a> {
        let claims = certificate_lines(audit).into_iter();
        let certificate = claims.map(|claim| (claim.id, claim.lines)).collect();
        Context { audit, file, is_whole: false, certificate, checked: None }
    }
}
