//! An end to work from another thread.

use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::panicking;

/// Ends work that runs in another thread, whatever it is at; clones end the same work. The arithmetic of large and
/// rational numbers looks at it, and so do long loops without it: the work is over in a fraction of a second.
///
/// The stack is unwound, without a message, as by a panic. What the work has not returned is lost, and caches stay as
/// they are. A program that is compiled with `panic = "abort"` cannot do this. Work that is part of other work ends with
/// that too.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::stop::{Stop, Stopped};
///
/// let stop = Stop::default();
/// let other = stop.clone();
/// let work = std::thread::spawn(move || {
///     other.run(|| {
///         let mut sum = Rational::zero();
///         loop {
///             sum = &sum + &Rational::new(1, 2);
///         }
///     })
/// });
/// stop.stop();
/// let found: Result<(), Stopped> = work.join().unwrap();
/// assert_eq!(found, Err(Stopped));
/// assert_eq!(Stop::default().run(|| 2), Ok(2));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

/// The work was stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

/// Whether any work was ever stopped, or is watched: until then nobody looks further.
static ANY: AtomicBool = AtomicBool::new(false);

/// What is called every now and then.
type Pulse = Rc<dyn Fn()>;

thread_local! {
    /// What ends the work of this thread, the innermost last.
    static CURRENT: RefCell<Vec<Stop>> = const { RefCell::new(Vec::new()) };

    /// What watches the work of this thread, with a number of its own, and how often it was looked at.
    static WATCHING: RefCell<Vec<(u64, Pulse)>> = const { RefCell::new(Vec::new()) };
    static LOOKS: Cell<u32> = const { Cell::new(0) };
}

/// After so many looks whether work goes on, what watches it is called.
const PULSE: u32 = 1 << 12;

/// While this lives, the work of this thread is watched.
#[derive(Debug)]
pub struct Watch(u64);

/// Calls something every now and then while this thread works: progress, or the end of the time, where there is no other
/// thread that could see to it.
///
/// ```
/// use std::cell::Cell;
/// use std::rc::Rc;
/// use subcert::stop::{check, watch};
///
/// let calls = Rc::new(Cell::new(0));
/// let count = Rc::clone(&calls);
/// let watching = watch(move || count.set(count.get() + 1));
/// (0..100_000).for_each(|_| check());
/// assert!(calls.get() > 0);
/// drop(watching);
/// let before = calls.get();
/// (0..100_000).for_each(|_| check());
/// assert_eq!(calls.get(), before);
/// ```
pub fn watch(pulse: impl Fn() + 'static) -> Watch {
    ANY.store(true, Ordering::Relaxed);
    WATCHING.with_borrow_mut(|all| {
        let own = all.last().map_or(0, |(last, _)| last + 1);
        all.push((own, Rc::new(pulse)));
        Watch(own)
    })
}

impl Drop for Watch {
    fn drop(&mut self) {
        WATCHING.with_borrow_mut(|all| all.retain(|(own, _)| *own != self.0));
    }
}

impl Stop {
    /// Ends the work, now or as soon as it begins.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
        ANY.store(true, Ordering::Relaxed);
    }

    /// Whether [`stop`](Stop::stop) was called.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Does work that this ends.
    ///
    /// ```
    /// use subcert::stop::{Stop, Stopped, check};
    ///
    /// // Work of which other work is a part ends both.
    /// let whole = Stop::default();
    /// whole.stop();
    /// let found: Result<Result<(), Stopped>, Stopped> = whole.run(|| Stop::default().run(|| loop { check() }));
    /// assert_eq!(found, Err(Stopped));
    /// ```
    ///
    /// # Errors
    /// When it was stopped.
    ///
    /// # Panics
    /// When the work does.
    pub fn run<T>(&self, work: impl FnOnce() -> T) -> Result<T, Stopped> {
        CURRENT.with_borrow_mut(|all| all.push(self.clone()));
        let found = catch_unwind(AssertUnwindSafe(work));
        CURRENT.with_borrow_mut(Vec::pop);
        match found {
            Ok(value) => Ok(value),
            Err(payload) if payload.is::<Stopped>() && self.is_stopped() => Err(Stopped),
            Err(payload) => resume_unwind(payload),
        }
    }
}

/// Work for another thread, which ends with that of this one. Who joins that thread resumes its panic.
///
/// ```
/// use subcert::stop::{Stop, Stopped, check, inherited};
///
/// let stop = Stop::default();
/// stop.stop();
/// let found = stop.run(|| {
///     let work = inherited(|| loop { check() });
///     let Err(payload) = std::thread::spawn(work).join();
///     std::panic::resume_unwind(payload)
/// });
/// assert_eq!(found, Err(Stopped));
/// ```
pub fn inherited<T>(work: impl FnOnce() -> T) -> impl FnOnce() -> T {
    let current = CURRENT.with_borrow(Clone::clone);
    move || {
        CURRENT.set(current);
        work()
    }
}

/// Ends the work of this thread if it was stopped. A long loop without other arithmetic than that of words calls this.
///
/// # Panics
/// In stopped work, whose [`Stop::run`] then returns.
#[inline]
pub fn check() {
    if ANY.load(Ordering::Relaxed) {
        end_if_stopped();
    }
}

#[cold]
fn end_if_stopped() {
    let looks = LOOKS.get().wrapping_add(1);
    LOOKS.set(looks);
    if looks.is_multiple_of(PULSE) {
        WATCHING.with_borrow(Clone::clone).iter().for_each(|(_, pulse)| pulse());
    }
    let stopped = CURRENT.with_borrow(|all| all.iter().any(Stop::is_stopped));
    // What is dropped meanwhile may compute.
    if stopped && !panicking() {
        resume_unwind(Box::new(Stopped));
    }
}
