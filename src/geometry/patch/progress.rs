//! How far a search has come, and an end to it, for whoever waits for it.

use crate::stop::check;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize, Ordering};

/// The level that is looked at, and how many of its pieces have been; shared between threads.
#[derive(Debug, Default)]
pub struct MeshWork {
    level: AtomicU32,
    done: AtomicUsize,
    total: AtomicUsize,
    stopped: AtomicBool,
}

impl MeshWork {
    /// The level.
    #[must_use]
    pub fn level(&self) -> u32 {
        self.level.load(Ordering::Relaxed)
    }

    /// How many pieces have been looked at, and how many there are.
    #[must_use]
    pub fn pieces(&self) -> (usize, usize) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }

    /// Ends the search soon. What is not decided by then stays open, and distances that are not measured have
    /// wider bounds: the result holds, and says less.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether it was stopped.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        check();
        self.stopped.load(Ordering::Relaxed)
    }

    pub(super) fn begin(&self, level: u32, total: usize) {
        self.level.store(level, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    pub(super) fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}
