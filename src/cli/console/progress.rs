//! The progress of a long command.

use super::bar::{Bar, Counts};
use super::line::are_read;
use super::terminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use subcert::bound::Budget;
use subcert::patch::MeshWork;

/// What is shown until this is dropped.
pub(crate) struct Progress(Bar);

impl Progress {
    /// The progress of an audit of so many tables and claims about smoothness.
    pub(crate) fn of_claims(claims: usize, wanted: bool) -> Progress {
        let claims = u64::try_from(claims).unwrap_or(u64::MAX);
        let template = "{bar:40} {pos} of {len} tables and claims about smoothness, {elapsed}";
        Progress::new(claims, template, wanted, |_| {})
    }

    /// The progress of an audit of so many tables of constants.
    pub(crate) fn of_tables(tables: usize, wanted: bool) -> Progress {
        let tables = u64::try_from(tables).unwrap_or(u64::MAX);
        Progress::new(tables, "{bar:40} {pos} of {len} tables, {elapsed}", wanted, |_| {})
    }

    /// The progress of the facts of so many schemes.
    pub(crate) fn of_schemes(schemes: usize, wanted: bool) -> Progress {
        let schemes = u64::try_from(schemes).unwrap_or(u64::MAX);
        Progress::new(schemes, "{bar:40} {pos} of {len} schemes, {elapsed}", wanted, |_| {})
    }

    /// The progress of the spectra of so many rings.
    pub(crate) fn of_spectra(done: Arc<AtomicU64>, rings: usize, wanted: bool) -> Progress {
        let rings = u64::try_from(rings).unwrap_or(u64::MAX);
        let template = "{bar:40} {pos} of {len} spectra, {elapsed}";
        Progress::new(rings, template, wanted, move |bar| {
            bar.set_position(done.load(Ordering::Relaxed));
        })
    }

    /// The progress of searches: the steps that are spent of their budgets.
    pub(crate) fn of_steps(budgets: &[Budget], wanted: bool) -> Progress {
        let (total, budgets) = (budgets.iter().map(Budget::total).sum(), budgets.to_vec());
        let template =
            "{bar:40} {percent} % of the {len} steps that the search may take, {elapsed}";
        Progress::new(total, template, wanted, move |bar| {
            bar.set_position(budgets.iter().map(|budget| budget.total() - budget.left()).sum());
        })
    }

    /// The progress of the depth of a mesh: the pieces of the level that is looked at.
    pub(crate) fn of_pieces(work: Arc<MeshWork>, wanted: bool) -> Progress {
        let template = "{bar:40} {pos} of {len} pieces of level {msg}, {elapsed}";
        Progress::new(1, template, wanted, move |bar| {
            let (done, total) = work.pieces();
            bar.set_message(work.level().to_string());
            bar.set_length(u64::try_from(total).unwrap_or(u64::MAX));
            bar.set_position(u64::try_from(done).unwrap_or(u64::MAX));
        })
    }

    /// The progress of work on a mesh, whose length is not known: what is done.
    pub(crate) fn of_mesh(what: String) -> Progress {
        Progress::new(1, "{spinner} {msg}, {elapsed}", true, move |bar| {
            bar.set_message(what.clone());
        })
    }

    /// Of a search whose length is not known.
    pub(crate) fn of_search(wanted: bool) -> Progress {
        Progress::new(1, "{spinner} searching for products and hulls, {elapsed}", wanted, |_| {})
    }

    /// The progress of a map: the boxes that have been looked at.
    pub(crate) fn of_boxes(done: Arc<AtomicUsize>, most: usize, wanted: bool) -> Progress {
        let most = u64::try_from(most).unwrap_or(u64::MAX);
        let template = "{bar:40} {pos} of at most {len} boxes, {elapsed}";
        Progress::new(most, template, wanted, move |bar| {
            bar.set_position(u64::try_from(done.load(Ordering::Relaxed)).unwrap_or(u64::MAX));
        })
    }

    fn new(
        length: u64,
        template: &'static str,
        wanted: bool,
        update: impl Fn(&Counts) + Send + 'static,
    ) -> Progress {
        // A page asks for JSON, and shows the progress all the same.
        let shown = (wanted || are_read()) && !terminal::is_quiet();
        Progress(Bar::new(length, template, shown, update))
    }

    /// Counts one more claim.
    pub(crate) fn step(&self) {
        self.0.inc(1);
    }
}
