//! How much work several questions may take together.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Steps that several questions may take together: products of words of 64 bits, roughly. Clones
/// share what is left.
///
/// One distance takes at most an eighth of all; a depth at most three quarters, and half for one
/// level.
///
/// What a question answers depends on the steps that those before it have taken, and on
/// nothing else: not on the time.
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
}

impl Budget {
    /// So many steps.
    #[must_use]
    pub fn new(steps: u64) -> Budget {
        Budget { total: steps, left: Arc::new(AtomicU64::new(steps)) }
    }

    /// As many steps as the other caps allow.
    #[must_use]
    pub fn unlimited() -> Budget {
        Budget::new(u64::MAX)
    }

    /// All steps.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Those that are left.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.left.load(Ordering::Relaxed)
    }

    /// Leaves no steps to any clone: what is being computed ends as at its cap.
    pub fn stop(&self) {
        self.left.store(0, Ordering::Relaxed);
    }

    /// Takes so many steps; none if they are not left.
    pub(crate) fn take(&self, steps: u64) -> bool {
        let left = self.left();
        let enough = steps <= left;
        if enough {
            self.left.store(left - steps, Ordering::Relaxed);
        }
        enough
    }

    /// Takes what a search takes, which is at most so much, and what is left.
    pub(crate) fn spend<T>(&self, most: u64, search: impl FnOnce(&mut u64) -> T) -> T {
        let most = most.min(self.left());
        let mut work = most;
        let found = search(&mut work);
        self.take(most - work);
        found
    }

    /// The cap on cells, where there is one, and that on steps, in words.
    pub(crate) fn caps(&self, cells: u32, of: &str) -> String {
        let cells = (cells < u32::MAX).then(|| format!("{cells} cells for {of}"));
        let steps = (self.total < u64::MAX).then(|| format!("{} steps in all", self.total));
        cells.into_iter().chain(steps).collect::<Vec<_>>().join(", ")
    }

    /// What a question about one distance may take of it.
    pub(crate) fn share(&self) -> Share<'_> {
        Share { budget: self, left: Cell::new(self.total / 8), rest: 0 }
    }

    /// What one level of a depth may take of it. A quarter of all remains for what is then asked
    /// about the depth.
    pub(crate) fn share_of_depth(&self) -> Share<'_> {
        Share { budget: self, left: Cell::new(self.total / 2), rest: self.total / 4 }
    }
}

/// What one question may take of a budget.
#[derive(Debug)]
pub(crate) struct Share<'b> {
    budget: &'b Budget,
    left: Cell<u64>,
    /// What must remain of the budget.
    rest: u64,
}

impl Share<'_> {
    /// Takes so many steps; if they are not left, takes none, now or later.
    pub(crate) fn take(&self, steps: u64) -> bool {
        let (all, left) = (self.budget.left(), self.left());
        let enough = steps <= left;
        if enough {
            self.budget.left.store(all - steps, Ordering::Relaxed);
        }
        self.left.set(if enough { left - steps } else { 0 });
        enough
    }

    /// Whether there are steps left.
    pub(crate) fn goes_on(&self) -> bool {
        self.left() > 0
    }

    fn left(&self) -> u64 {
        self.left.get().min(self.budget.left().saturating_sub(self.rest))
    }
}
