//! Ctrl-C, and an end of the time, while something is computed: what was found is printed.

use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, Once};
use std::time::Duration;
use subcert::bound::Budget;
use subcert::patch::MeshWork;

/// Ends one search soon.
type Stop = Box<dyn Fn() + Send>;

static STOPS: Mutex<Vec<Stop>> = Mutex::new(Vec::new());
static HANDLER: Once = Once::new();

/// While this lives, an interrupt ends some searches; at any other time, and at the second interrupt, it ends the
/// program.
pub(crate) struct Interrupt {
    /// Dropped at the end, which wakes the thread that waits for the end of the time.
    _timer: Option<Sender<()>>,
}

impl Interrupt {
    /// Takes all steps from these budgets.
    pub(crate) fn stops(budgets: &[Budget]) -> Interrupt {
        let stop = |budget: &Budget| -> Stop {
            let budget = budget.clone();
            Box::new(move || budget.stop())
        };
        Interrupt::with(budgets.iter().map(stop).collect(), None)
    }

    /// Stops this work, at the latest after so many seconds.
    pub(crate) fn stops_work(work: &Arc<MeshWork>, seconds: Option<u32>) -> Interrupt {
        let (own, late) = (Arc::clone(work), Arc::clone(work));
        let timer = seconds.map(|seconds| {
            let (sender, receiver) = channel::<()>();
            let time = Duration::from_secs(seconds.into());
            std::thread::spawn(move || {
                if receiver.recv_timeout(time) == Err(RecvTimeoutError::Timeout) {
                    late.stop();
                }
            });
            sender
        });
        Interrupt::with(vec![Box::new(move || own.stop())], timer)
    }

    fn with(stops: Vec<Stop>, timer: Option<Sender<()>>) -> Interrupt {
        set(stops);
        HANDLER.call_once(|| {
            // Where no handler can be set, an interrupt ends the program as usual.
            let _ = ctrlc::set_handler(|| {
                let stops = set(Vec::new());
                if stops.is_empty() {
                    std::process::exit(130);
                }
                for stop in &stops {
                    stop();
                }
            });
        });
        Interrupt { _timer: timer }
    }
}

impl Drop for Interrupt {
    fn drop(&mut self) {
        set(Vec::new());
    }
}

/// The ends before.
fn set(stops: Vec<Stop>) -> Vec<Stop> {
    let mut stopped = STOPS.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    std::mem::replace(&mut *stopped, stops)
}
