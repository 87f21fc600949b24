//! Work beside Python: other threads run meanwhile, Ctrl-C ends it, and a panic becomes an exception.

use crate::error::with_remedy;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;
use subcert::stop::Stop;

/// How often signals are looked at.
const TICK: Duration = Duration::from_millis(50);

/// The stack of a thread that works.
const STACK: usize = 64 << 20;

fn panicked() -> PyErr {
    with_remedy(
        "an error in subcert itself",
        "please report it, with the call and what stands on the standard error",
    )
}

/// Work of some microseconds: a thread would cost more.
pub(crate) fn at_once<T>(work: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(panicked()))
}

/// Work in a thread of its own. On Ctrl-C it is stopped, and the thread is left behind: it ends soon.
/// It must not touch Python, which may have ended by then.
///
/// # Errors
/// That of the work, of Ctrl-C, or of a panic.
pub(crate) fn aside<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> PyResult<T> + Send + 'static,
) -> PyResult<T> {
    let (sender, mut receiver) = mpsc::channel();
    let stop = Stop::default();
    let own = stop.clone();
    let guarded = move || {
        // Nobody may be waiting any more.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(|| own.run(work))));
    };
    thread::Builder::new().stack_size(STACK).spawn(guarded).map_err(PyErr::from)?;
    loop {
        let (back, answer) = py.detach(move || {
            let answer = receiver.recv_timeout(TICK);
            (receiver, answer)
        });
        receiver = back;
        match answer {
            // It is stopped only where nobody waits.
            Ok(Ok(Ok(answer))) => return answer,
            Ok(_) | Err(RecvTimeoutError::Disconnected) => return Err(panicked()),
            Err(RecvTimeoutError::Timeout) => py.check_signals().inspect_err(|_| stop.stop())?,
        }
    }
}
