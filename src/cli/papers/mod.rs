//! What papers and programs claim: `subcert audit`, `explain`, `errata`, `coverage`, `prove` and `new`.

mod audit;
mod audit_output;
mod certified;
mod claim_files;
mod coverage;
mod errata;
mod explain;
pub(super) mod judged;
mod listing;
mod new;
pub(super) mod pages;
mod projects;
mod prove;

pub(super) use audit::audit;
pub(super) use coverage::coverage;
pub(super) use errata::errata;
pub(super) use explain::explain;
pub(super) use new::new;
pub(super) use prove::prove;
#[cfg(feature = "schema")]
pub(super) use {
    audit::Audit,
    coverage::Coverage,
    errata::Errata,
    explain::Explanation,
    listing::Listing,
    projects::{Projects, Shipped},
};
