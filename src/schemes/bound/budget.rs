//! A common cap on the work of several computations.

use crate::stop::check;
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// A number of steps that several computations may take together. A step is roughly a product of
/// two 64-bit words. Clones share the remaining steps.
///
/// The computation of one distance takes at most an eighth of all steps. The computation of a
/// depth takes at most three quarters, and at most half for one level.
///
/// The answer of a computation depends only on its input and on the steps taken before,
/// never on time.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::bound::Budget;
/// use subcert::limit::{Comparison, Distances, Limit};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("four-point")?;
/// let distances = Distances::new(&Limit::new(scheme.masks()[0])?)?;
/// let budget = Budget::new(100_000);
/// let hasty = distances.clone().with_budget(budget.clone());
/// let tight = Rational::new(47, 1000);
/// assert!(matches!(hasty.compare(2, &tight)?, Comparison::Undecided(_)));
/// assert!(matches!(distances.compare(2, &tight)?, Comparison::Within));
/// assert!(budget.left() < budget.total());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Budget {
    total: u64,
    left: Arc<AtomicU64>,
    stopped: Arc<AtomicBool>,
}

impl Budget {
    /// A budget of `steps` steps.
    #[must_use]
    pub fn new(steps: u64) -> Budget {
        let (left, stopped) = (Arc::new(AtomicU64::new(steps)), Arc::default());
        Budget { total: steps, left, stopped }
    }

    /// A budget that never runs out: only the other caps apply.
    #[must_use]
    pub fn unlimited() -> Budget {
        Budget::new(u64::MAX)
    }

    /// The number of steps in all.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.total
    }

    /// The number of remaining steps.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.left.load(Ordering::Relaxed)
    }

    /// Takes all steps that remain, from any thread. What is being computed with this budget or its
    /// clones ends as at its cap.
    ///
    /// ```
    /// use subcert::bound::Budget;
    ///
    /// let budget = Budget::new(1_000);
    /// let clone = budget.clone();
    /// std::thread::spawn(move || clone.stop()).join().unwrap();
    /// assert_eq!(budget.left(), 0);
    /// ```
    pub fn stop(&self) {
        self.left.store(0, Ordering::Relaxed);
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether [`stop`](Budget::stop) was called. Searches that run look at it now and then.
    pub(crate) fn is_stopped(&self) -> bool {
        check();
        self.stopped.load(Ordering::Relaxed)
    }

    /// Takes `steps` steps and returns `true`; takes none and returns `false` if fewer
    /// remain.
    ///
    /// ```
    /// let budget = subcert::bound::Budget::new(3);
    /// assert!(budget.take(2) && !budget.take(2) && budget.take(1));
    /// ```
    #[must_use]
    pub fn take(&self, steps: u64) -> bool {
        check();
        // In one step, so that a stop in another thread is not lost.
        let take = |left: u64| left.checked_sub(steps);
        self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, take).is_ok()
    }

    /// Runs a search that may use up to `most` steps, and at most the remaining ones, and
    /// takes the steps it used.
    pub(crate) fn spend<T>(&self, most: u64, search: impl FnOnce(&mut u64) -> T) -> T {
        let most = most.min(self.left());
        let mut work = most;
        let found = search(&mut work);
        let _ = self.take(most - work);
        found
    }

    /// A text that states the cap on cells, if there is one, and the cap on steps.
    pub(crate) fn caps(&self, cells: u32, of: &str) -> String {
        let cells = (cells < u32::MAX).then(|| format!("{cells} cells for {of}"));
        let steps = (self.total < u64::MAX).then(|| format!("{} steps in all", self.total));
        cells.into_iter().chain(steps).collect::<Vec<_>>().join(", ")
    }

    /// The share of one distance.
    pub(crate) fn share(&self) -> Share<'_> {
        Share { budget: self, left: Cell::new(self.total / 8), rest: 0 }
    }

    /// The share of one level of a depth. A quarter of all steps remains for later computations
    /// about the depth.
    pub(crate) fn share_of_depth(&self) -> Share<'_> {
        Share { budget: self, left: Cell::new(self.total / 2), rest: self.total / 4 }
    }
}

/// The part of a budget that one computation may take.
#[derive(Debug)]
pub(crate) struct Share<'b> {
    budget: &'b Budget,
    left: Cell<u64>,
    /// The number of steps of the budget that must remain.
    rest: u64,
}

impl Share<'_> {
    /// Takes `steps` steps and returns `true`. If fewer remain, takes none, and every
    /// later call fails too.
    pub(crate) fn take(&self, steps: u64) -> bool {
        let left = self.left();
        let enough = steps <= left && self.budget.take(steps);
        self.left.set(if enough { left - steps } else { 0 });
        enough
    }

    /// Whether steps remain.
    pub(crate) fn goes_on(&self) -> bool {
        self.left() > 0
    }

    fn left(&self) -> u64 {
        self.left.get().min(self.budget.left().saturating_sub(self.rest))
    }
}
