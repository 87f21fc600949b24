//! What is common to the depths of meshes, nets and solids.

use super::kind::Kind;
use super::promise::{APriori, Formula};
use crate::cli::arguments::{DepthArguments, FindingFormat};
use crate::cli::console::interrupt::{Interrupt, reason};
use crate::cli::console::output::Failure;
use crate::cli::console::progress::Progress;
use std::sync::Arc;
use subcert::exact::Rational;
use subcert::patch::MeshWork;

/// A mesh, a net or a solid whose depth is asked for, and what is promised before any search.
pub(super) struct Subject<'a> {
    pub(super) scheme: String,
    /// The name of the file.
    pub(super) name: String,
    /// What is to be told of the file.
    pub(super) notes: Vec<String>,
    pub(super) kind: Kind,
    pub(super) arguments: &'a DepthArguments,
    pub(super) tolerance: Rational,
    pub(super) guaranteed: APriori,
    /// The number of levels by the formula of a paper, if there is one for the scheme.
    pub(super) promised: Option<Formula>,
}

impl Subject<'_> {
    /// The levels that are promised to be enough, in words.
    pub(super) fn promises(&self) -> Vec<(u32, String)> {
        let by_formula = self.promised.as_ref().and_then(|formula| formula.level);
        let by_formula = by_formula.map(|level| (level, "by formula".to_owned()));
        by_formula.into_iter().chain([(self.guaranteed.level, "a priori".to_owned())]).collect()
    }
}

/// The result of a search that shows its progress, and that Ctrl-C and the end of the time stop; and why it was stopped.
pub(super) fn searched<T>(
    work: &Arc<MeshWork>,
    arguments: &DepthArguments,
    search: impl FnOnce() -> Result<T, Failure>,
) -> Result<(T, Option<String>), Failure> {
    let _interrupt = Interrupt::stops_work(work);
    let wanted = arguments.output.format != FindingFormat::Json;
    let _progress = Progress::of_pieces(Arc::clone(work), wanted);
    let found = search()?;
    Ok((found, work.is_stopped().then(reason)))
}
