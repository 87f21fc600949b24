//! Work on many items in all cores, with results that do not depend on how many there are.

use crate::cores::{cores, together};
use crate::stop::check;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The most items of a round.
const MAX_ROUND: usize = 16_384;

/// How many threads there are for so many items, with `least` of them for each at least.
pub(super) fn threads(items: usize, least: usize) -> usize {
    cores().min(items.div_ceil(least)).max(1)
}

/// The values of all items, in their order.
pub(super) fn in_threads<T: Sync, R: Send>(items: &[T], value: impl Fn(&T) -> R + Sync) -> Vec<R> {
    in_threads_until(
        &mut vec![(); threads(items.len(), 8)],
        items,
        |(), item| value(item),
        |_| false,
    )
}

/// The values of the items, in their order, up to the first that is the last one. Each thread has one of the states.
pub(super) fn in_threads_until<S: Send, T: Sync, R: Send>(
    states: &mut [S],
    items: &[T],
    value: impl Fn(&mut S, &T) -> R + Sync,
    is_last: impl Fn(&R) -> bool + Sync,
) -> Vec<R> {
    let (next, last) = (AtomicUsize::new(0), AtomicUsize::new(usize::MAX));
    let run = |state: &mut S| {
        let mut own = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            check();
            // What is before the last one is done in any case.
            let Some(item) = items.get(i).filter(|_| i <= last.load(Ordering::Relaxed)) else {
                return own;
            };
            let value = value(state, item);
            if is_last(&value) {
                last.fetch_min(i, Ordering::Relaxed);
            }
            own.push((i, value));
        }
    };
    let mut all = match states {
        [] => Vec::new(),
        [state] => run(state),
        _ => together(states.iter_mut().map(|state| || run(state))).into_iter().flatten().collect(),
    };
    all.sort_unstable_by_key(|(i, _)| *i);
    let last = last.into_inner();
    all.into_iter().filter(|(i, _)| *i <= last).map(|(_, value)| value).collect()
}

/// Hands the items to `round` in parts of growing size, while it returns true.
pub(super) fn in_rounds<T>(items: &[T], mut round: impl FnMut(&[T]) -> bool) {
    let (mut rest, mut size) = (items, 1);
    while !rest.is_empty() {
        let (now, later) = rest.split_at(size.min(rest.len()));
        if !round(now) {
            break;
        }
        (rest, size) = (later, (4 * size).min(MAX_ROUND));
    }
}
