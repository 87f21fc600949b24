//! What is chosen at random.

/// Numbers, one after the other; 0 when there are no more. Choice 0 is the simplest everywhere, so
/// that a paper that fails shrinks to a small one.
pub struct Choices(std::vec::IntoIter<usize>);

impl Choices {
    pub fn new(numbers: Vec<usize>) -> Choices {
        Choices(numbers.into_iter())
    }

    pub fn below(&mut self, count: usize) -> usize {
        self.0.next().unwrap_or(0) % count
    }

    pub fn of<T: Clone>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())].clone()
    }

    /// True once in so many times.
    pub fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == count - 1
    }
}
