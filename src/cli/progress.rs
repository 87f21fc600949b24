//! How far a long audit is, on a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal as _;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// How long an audit takes before a bar is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar on the standard error, when that is a terminal; it is gone when this is
/// dropped.
pub(super) struct Progress {
    bar: ProgressBar,
    /// Dropped at the end, which wakes the thread that shows the bar.
    waiting: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    pub(super) fn new(tables: usize, wanted: bool) -> Progress {
        let bar =
            ProgressBar::with_draw_target(u64::try_from(tables).ok(), ProgressDrawTarget::hidden());
        let waiting = (wanted && std::io::stderr().is_terminal()).then(|| {
            if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos} of {len} tables") {
                bar.set_style(style);
            }
            let (sender, receiver) = channel::<()>();
            let shown = bar.clone();
            let thread = std::thread::spawn(move || {
                if receiver.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                    shown.set_draw_target(ProgressDrawTarget::stderr());
                    shown.tick();
                    // Until the other end is dropped.
                    let _ = receiver.recv();
                }
            });
            (sender, thread)
        });
        Progress { bar, waiting }
    }

    /// One table more.
    pub(super) fn step(&self) {
        self.bar.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.waiting.take() {
            drop(sender);
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}
