//! Reports: pages and documents.

mod depth_pictures;
mod document;
mod explained;
mod figures;
mod html;
mod latex;
mod latex_table;
mod pictures;
mod smoothness;
mod witnesses;

use std::sync::LazyLock;
use subcert::audit::{PaperAudit, audit_all};
use subcert::claim::{Paper, embedded_papers};

static PAPERS: LazyLock<Vec<Paper>> =
    LazyLock::new(|| embedded_papers().expect("the embedded papers"));

/// The audits of the embedded papers, once for all tests of pages.
static AUDITS: LazyLock<Vec<PaperAudit<'static>>> =
    LazyLock::new(|| audit_all(&PAPERS, &|| {}).expect("their audits"));
