//! Ctrl-C, and the end of the time, while something is computed: what was found is printed.

use std::cell::Cell;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard, Once, PoisonError};
use std::time::{Duration, Instant};
use subcert::bound::Budget;
use subcert::cores::THREADS;
use subcert::patch::MeshWork;
use subcert::stop::{Stop, Stopped, Watch, watch};

/// Ends one search soon.
type End = Box<dyn Fn() + Send>;

/// The searches that end with what they have found.
static SEARCHES: Mutex<Vec<End>> = Mutex::new(Vec::new());
static WRITING: Mutex<()> = Mutex::new(());
static HANDLER: Once = Once::new();

/// After how many seconds the time was over; 0 until then.
static OVER: AtomicU32 = AtomicU32::new(0);

/// The least time for an answer from what was found, in seconds.
const LEAST_REST: u32 = 10;

/// Does the work of a command, for at most so many seconds. Then searches end as on Ctrl-C, and have half as long again
/// for their answer; all other work is given up. Where it goes on nevertheless, `leave` ends the program.
///
/// # Errors
/// When it was given up.
pub(crate) fn within<T>(
    seconds: Option<u32>,
    leave: impl FnOnce() + Send + 'static,
    work: impl FnOnce() -> T,
) -> Result<T, Stopped> {
    let Some(seconds) = seconds else { return Ok(work()) };
    if !THREADS {
        let _watch = watch_within(seconds, leave);
        return Ok(work());
    }
    let stop = Stop::default();
    let late = stop.clone();
    let (sender, receiver) = channel::<()>();
    let over = move |seconds: u32| {
        let time = Duration::from_secs(seconds.into());
        receiver.recv_timeout(time) == Err(RecvTimeoutError::Timeout)
    };
    std::thread::spawn(move || {
        if over(seconds) && (!end_searches(seconds) || over((seconds / 2).max(LEAST_REST))) {
            late.stop();
            if over(LEAST_REST) {
                // No file is left half-written.
                let _writing = writing();
                leave();
            }
        }
    });
    let found = stop.run(work);
    // This wakes the thread that waits.
    drop(sender);
    found
}

/// The same where the thread that works must look at the time itself: nothing is given up there, the program ends.
fn watch_within(seconds: u32, leave: impl FnOnce() + 'static) -> Watch {
    let in_seconds = |seconds: u32| Instant::now() + Duration::from_secs(seconds.into());
    let (end, leave) = (Cell::new(in_seconds(seconds)), Cell::new(Some(leave)));
    watch(move || {
        // What is being written is written to its end.
        if Instant::now() < end.get() || WRITING.try_lock().is_err() {
            return;
        }
        if end_searches(seconds) {
            end.set(in_seconds((seconds / 2).max(LEAST_REST)));
        } else if let Some(leave) = leave.take() {
            leave();
        }
    })
}

/// While this lives, results are written, and nothing else ends the program.
pub(crate) fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the searches at the end of the time, and says whether there are any.
fn end_searches(seconds: u32) -> bool {
    let mut searches = searches();
    OVER.store(seconds, Ordering::Relaxed);
    searches.drain(..).map(|end| end()).count() > 0
}

/// Why a search has ended early that was stopped.
pub(crate) fn reason() -> String {
    match OVER.load(Ordering::Relaxed) {
        0 => "the search was stopped".to_owned(),
        seconds => format!("the search was stopped after {}", in_seconds(seconds)),
    }
}

/// Whether the searches of the [`Interrupt`] that lives were stopped.
pub(crate) fn were_stopped() -> bool {
    searches().is_empty()
}

/// A number of seconds, and how to ask for another.
pub(crate) fn in_seconds(seconds: u32) -> String {
    let plural = if seconds == 1 { "" } else { "s" };
    format!("{seconds} second{plural} (--seconds N allows for N)")
}

/// While this lives, an interrupt and the end of the time end some searches; at any other time, and at the second
/// interrupt, these end the program.
pub(crate) struct Interrupt(());

impl Interrupt {
    /// Takes all steps from these budgets.
    pub(crate) fn stops(budgets: &[Budget]) -> Interrupt {
        let end = |budget: &Budget| -> End {
            let budget = budget.clone();
            Box::new(move || budget.stop())
        };
        Interrupt::with(budgets.iter().map(end).collect())
    }

    /// Stops this work.
    pub(crate) fn stops_work(work: &Arc<MeshWork>) -> Interrupt {
        let own = Arc::clone(work);
        Interrupt::with(vec![Box::new(move || own.stop())])
    }

    /// Stops a search for bounds.
    pub(crate) fn stops_search(stop: &Stop) -> Interrupt {
        let own = stop.clone();
        Interrupt::with(vec![Box::new(move || own.stop())])
    }

    fn with(ends: Vec<End>) -> Interrupt {
        let mut searches = searches();
        *searches = ends;
        if OVER.load(Ordering::Relaxed) > 0 {
            searches.drain(..).for_each(|end| end());
        }
        drop(searches);
        HANDLER.call_once(handle);
        Interrupt(())
    }
}

/// Where no handler can be set, an interrupt ends the program as usual.
fn handle() {
    #[cfg(not(target_family = "wasm"))]
    let _ = ctrlc::set_handler(|| {
        let ends = std::mem::take(&mut *searches());
        if ends.is_empty() {
            std::process::exit(130);
        }
        for end in &ends {
            end();
        }
    });
}

impl Drop for Interrupt {
    fn drop(&mut self) {
        searches().clear();
    }
}

fn searches() -> MutexGuard<'static, Vec<End>> {
    SEARCHES.lock().unwrap_or_else(PoisonError::into_inner)
}
