//! The embedded papers, with what is dear to compute of them: once for all tests.

use std::sync::LazyLock;
use subcert::audit::{PaperAudit, audit_all};
use subcert::certificate::{Certificate, certificate};
use subcert::claim::{Paper, embedded_papers};
use subcert::report::html::audit_page;

pub static PAPERS: LazyLock<Vec<Paper>> =
    LazyLock::new(|| embedded_papers().unwrap_or_else(|error| panic!("{error}")));

/// Their audits, in the same order.
pub static AUDITS: LazyLock<Vec<PaperAudit<'static>>> =
    LazyLock::new(|| audit_all(&PAPERS, &|| {}).unwrap_or_else(|error| panic!("{error}")));

/// Their certificates, in the same order.
pub static CERTIFICATES: LazyLock<Vec<Certificate>> =
    LazyLock::new(|| AUDITS.iter().map(certificate).collect());

/// Their pages, in the same order.
pub static PAGES: LazyLock<Vec<String>> = LazyLock::new(|| {
    AUDITS.iter().map(|audit| audit_page(audit, None, None).expect("a page")).collect()
});

/// The audit of a paper.
pub fn audit_of(key: &str) -> &'static PaperAudit<'static> {
    AUDITS.iter().find(|audit| audit.paper.key == key).expect("an embedded paper")
}
