//! Work that is spread over all cores.

use crate::stop::inherited;
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicIsize, AtomicUsize, Ordering};
use std::thread::{self, ScopedJoinHandle, available_parallelism};

/// Whether there are threads. WebAssembly has none.
pub const THREADS: bool = !cfg!(target_family = "wasm");

/// How many cores there are, at least 1.
#[must_use]
pub fn cores() -> usize {
    static CORES: OnceLock<usize> = OnceLock::new();
    *CORES.get_or_init(|| available_parallelism().map_or(1, NonZero::get))
}

/// The results of these tasks, in their order. The first one is done in this thread, and each other one in a thread of its own, or, where there are none,
/// after it. All end with the work of this thread.
///
/// ```
/// use subcert::cores::together;
///
/// assert_eq!(together([1, 2, 3].map(|x| move || x * x)), [1, 4, 9]);
/// ```
///
/// # Panics
/// When a task does.
pub fn together<T: Send>(tasks: impl IntoIterator<Item = impl FnOnce() -> T + Send>) -> Vec<T> {
    let mut tasks = tasks.into_iter();
    if !THREADS {
        return tasks.map(|task| task()).collect();
    }
    thread::scope(|scope| {
        let first = tasks.next();
        let others: Vec<_> = tasks.map(|task| scope.spawn(inherited(task))).collect();
        let first = first.map(|task| task());
        let join = |other: ScopedJoinHandle<'_, T>| {
            other.join().unwrap_or_else(|panic| resume_unwind(panic))
        };
        first.into_iter().chain(others.into_iter().map(join)).collect()
    })
}

/// The cores that have nothing to do.
fn idle() -> &'static AtomicIsize {
    static IDLE: OnceLock<AtomicIsize> = OnceLock::new();
    let others = || cores() - 1;
    IDLE.get_or_init(|| AtomicIsize::new(isize::try_from(others()).unwrap_or(0)))
}

/// Takes an idle core, if there is one.
fn taken() -> bool {
    idle().fetch_update(Ordering::AcqRel, Ordering::Acquire, |n| (n > 0).then_some(n - 1)).is_ok()
}

/// A core that is taken; when this is dropped, it is idle.
struct Core;

impl Drop for Core {
    fn drop(&mut self) {
        idle().fetch_add(1, Ordering::AcqRel);
    }
}

/// The results of all jobs, in the order of the jobs, whichever thread does them. A job may call
/// this itself: all calls together share the cores, and a call whose own jobs are done leaves its
/// core to the others.
///
/// ```
/// use subcert::audit::on_all_cores;
///
/// assert_eq!(on_all_cores(&[1, 2, 3], |x| x * x), [1, 4, 9]);
/// ```
///
/// # Panics
/// When a job does.
pub fn map<J: Sync, T: Send>(jobs: &[J], run: impl Fn(&J) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let mut done = thread::scope(|scope| {
        let run = &run;
        let next = &next;
        let job = move || {
            let place = next.fetch_add(1, Ordering::Relaxed);
            jobs.get(place).map(|job| (place, run(job)))
        };
        let helper = move || {
            let _core = Core;
            std::iter::from_fn(job).collect::<Vec<(usize, T)>>()
        };
        let (mut done, mut helpers) = (Vec::new(), Vec::new());
        loop {
            // A core may have become idle since the last job.
            while next.load(Ordering::Relaxed) + 1 < jobs.len() && taken() {
                helpers.push(scope.spawn(inherited(helper)));
            }
            let Some(one) = job() else { break };
            done.push(one);
        }
        if !helpers.is_empty() {
            idle().fetch_add(1, Ordering::AcqRel);
        }
        let waits = !helpers.is_empty();
        let others: Vec<_> = helpers.into_iter().map(ScopedJoinHandle::join).collect();
        if waits {
            idle().fetch_sub(1, Ordering::AcqRel);
        }
        for others in others {
            done.extend(others.unwrap_or_else(|panic| resume_unwind(panic)));
        }
        done
    });
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}
