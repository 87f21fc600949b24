//! A bar on the standard error, if that is a terminal, or lines for the page that is served.

use super::line::{are_read, line};
pub(super) use indicatif::ProgressBar as Counts;
use indicatif::{ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal as _;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// How long a command takes before a bar is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// How often a bar is drawn again while its count stands still.
const PERIOD: Duration = Duration::from_millis(200);

/// A bar, which is removed when this is dropped.
pub(super) struct Bar {
    bar: Counts,
    /// Dropped at the end, which wakes the thread that shows the bar.
    waiting: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Bar {
    pub(super) fn new(
        length: u64,
        template: &'static str,
        wanted: bool,
        update: impl Fn(&Counts) + Send + 'static,
    ) -> Bar {
        let bar = Counts::with_draw_target(Some(length), ProgressDrawTarget::hidden());
        let lines = are_read();
        let waiting = (wanted && (lines || std::io::stderr().is_terminal())).then(|| {
            if let Ok(style) = ProgressStyle::with_template(template) {
                bar.set_style(style);
            }
            let (sender, receiver) = channel::<()>();
            let shown = bar.clone();
            let thread = std::thread::spawn(move || {
                let mut wait = PATIENCE;
                // The loop ends when the sender is dropped.
                while receiver.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                    if wait == PATIENCE && !lines {
                        shown.set_draw_target(ProgressDrawTarget::stderr());
                    }
                    update(&shown);
                    if lines {
                        let length = shown.length().unwrap_or_default();
                        eprintln!("{}", line(template, shown.position(), length, &shown.message()));
                    } else {
                        shown.tick();
                    }
                    wait = PERIOD;
                }
            });
            (sender, thread)
        });
        Bar { bar, waiting }
    }

    pub(super) fn inc(&self, by: u64) {
        self.bar.inc(by);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.waiting.take() {
            drop(sender);
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}
