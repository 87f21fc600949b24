//! Lines of progress on the standard error, where no thread can show a bar.

use super::line::line;
use std::cell::Cell;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use subcert::stop::{Watch, watch};

/// How long a command takes before there are lines.
const PATIENCE: Duration = Duration::from_secs(1);

/// How much later the next line is.
const PERIOD: Duration = Duration::from_millis(200);

/// The numbers of a line.
#[derive(Default)]
pub(super) struct Counts {
    position: AtomicU64,
    length: AtomicU64,
    message: Mutex<String>,
}

impl Counts {
    pub(super) fn set_position(&self, position: u64) {
        self.position.store(position, Ordering::Relaxed);
    }

    pub(super) fn set_length(&self, length: u64) {
        self.length.store(length, Ordering::Relaxed);
    }

    pub(super) fn set_message(&self, message: String) {
        *self.message.lock().unwrap_or_else(PoisonError::into_inner) = message;
    }

    fn line(&self, template: &str) -> String {
        let [position, length] = [&self.position, &self.length].map(|n| n.load(Ordering::Relaxed));
        let message = self.message.lock().unwrap_or_else(PoisonError::into_inner);
        line(template, position, length, &message)
    }
}

/// Lines until this is dropped.
pub(super) struct Bar {
    counts: Arc<Counts>,
    /// Ends the lines.
    _watch: Option<Watch>,
}

impl Bar {
    pub(super) fn new(
        length: u64,
        template: &'static str,
        wanted: bool,
        update: impl Fn(&Counts) + 'static,
    ) -> Bar {
        let counts = Arc::new(Counts::default());
        counts.set_length(length);
        let (shown, next) = (Arc::clone(&counts), Cell::new(Instant::now() + PATIENCE));
        let pulse = move || {
            let now = Instant::now();
            if now >= next.get() {
                next.set(now + PERIOD);
                update(&shown);
                eprintln!("{}", shown.line(template));
            }
        };
        Bar { counts, _watch: wanted.then(|| watch(pulse)) }
    }

    pub(super) fn inc(&self, by: u64) {
        self.counts.position.fetch_add(by, Ordering::Relaxed);
    }
}
