//! Items in groups, by numbers of the groups.

/// Items, group by group; in each group in the order in which they came.
pub(crate) struct Grouped<T> {
    /// Where the groups begin, and the end of the last one.
    begins: Vec<usize>,
    items: Vec<T>,
}

impl<T: Copy + Default> Grouped<T> {
    /// Those of `count` groups, from items with the numbers of their groups.
    ///
    /// # Panics
    /// When there is no group of a number.
    pub(crate) fn new(count: usize, items: impl Iterator<Item = (usize, T)> + Clone) -> Grouped<T> {
        let mut begins = vec![0; count + 1];
        for (group, _) in items.clone() {
            begins[group + 1] += 1;
        }
        for group in 0..count {
            begins[group + 1] += begins[group];
        }
        let (mut next, mut sorted) = (begins.clone(), vec![T::default(); begins[count]]);
        for (group, item) in items {
            sorted[next[group]] = item;
            next[group] += 1;
        }
        Grouped { begins, items: sorted }
    }
}

impl<T> Grouped<T> {
    /// The items of a group.
    pub(crate) fn of(&self, group: usize) -> &[T] {
        &self.items[self.begins[group]..self.begins[group + 1]]
    }

    /// The groups, one after the other.
    pub(crate) fn each_mut(&mut self, mut each: impl FnMut(&mut [T])) {
        for ends in self.begins.windows(2) {
            each(&mut self.items[ends[0]..ends[1]]);
        }
    }

    /// How many items there are.
    pub(crate) fn len(&self) -> usize {
        self.items.len()
    }
}
