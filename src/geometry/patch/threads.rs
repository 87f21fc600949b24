//! Work on many items in all cores, with results that do not depend on how many there are.

/// The most items of a round.
const MAX_ROUND: usize = 16_384;

/// The values of all items, in their order.
pub(super) fn in_threads<T: Sync, R: Send>(items: &[T], value: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let count = cores.min(items.len().div_ceil(8));
    if count <= 1 {
        return items.iter().map(value).collect();
    }
    let run = |first: usize| items.iter().skip(first).step_by(count).map(&value).collect();
    let run = &run;
    let shares: Vec<Vec<R>> = std::thread::scope(|scope| {
        let handles: Vec<_> = (0..count).map(|first| scope.spawn(move || run(first))).collect();
        handles.into_iter().map(|handle| handle.join().expect("it does not panic")).collect()
    });
    let mut shares: Vec<_> = shares.into_iter().map(Vec::into_iter).collect();
    (0..items.len()).filter_map(|i| shares[i % count].next()).collect()
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
