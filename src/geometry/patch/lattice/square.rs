//! Unit squares of the indices of a level.

use super::levels::{Levels, Place, Sides};
use super::points::Index;
use crate::exact::Rational;

/// The square low + [0, 1]² of a level.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Square {
    pub(super) level: u32,
    /// The square of level 0, of the image of which it is a part, or which its image meets.
    pub(super) root: Index,
    /// `low`, but for the place where squares of its level begin.
    at: Index,
}

/// How squares of a level consist of those of the next one.
#[derive(Clone, Debug)]
pub(super) struct Squares<'l> {
    levels: &'l Levels,
    /// Where squares of the first levels that have any begin, up to integers; then the last ones of them come again.
    offsets: Vec<Place>,
    /// The first of those that come again.
    again: usize,
}

impl<'l> Squares<'l> {
    pub(super) fn new(levels: &'l Levels) -> Squares<'l> {
        let (offsets, again) = levels.offsets();
        Squares { levels, offsets, again }
    }

    /// Where squares of a level begin, up to integers.
    fn offset(&self, level: u32) -> &Place {
        let (level, count) = ((level / self.levels.stride) as usize, self.offsets.len());
        let at =
            if level < count { level } else { self.again + (level - count) % (count - self.again) };
        &self.offsets[at]
    }

    /// A square of level 0.
    pub(super) fn root(at: Index) -> Square {
        Square { level: 0, root: at, at }
    }

    /// Its lower corner.
    pub(super) fn low(&self, square: &Square) -> Place {
        let offset = self.offset(square.level);
        [0, 1].map(|i| Rational::from(square.at[i]) + &offset[i])
    }

    /// The squares of the next level at which there are any that meet it, as far as they meet the image of the one of level 0.
    pub(super) fn parts(&self, square: &Square) -> Vec<Square> {
        let Square { level, root, .. } = *square;
        let low = self.low(square);
        let stride = self.levels.stride;
        let image = self.levels.forth(stride).hull(&around(&low));
        let offset = self.offset(level + stride);
        let range = |i: usize| {
            let [low, high] = [0, 1].map(|end| &image[i][end] - &offset[i]);
            low.floor().to_i64().zip(high.ceil().to_i64()).map_or(0..0, |(low, high)| low..high)
        };
        let all = range(0).flat_map(|i| range(1).map(move |j| [i, j]));
        let all = all.map(|at| Square { level: level + stride, root, at });
        if self.levels.nested {
            return all.collect();
        }
        let (parent, root) = (around(&low), root_box(root));
        all.filter(|part| self.meet(part, &parent, 1) && self.meet(part, &root, level + 1))
            .collect()
    }

    /// Whether a square and the image of a box, so many levels before, have common inner points: no line in the direction of a side of either is between
    /// them.
    fn meet(&self, square: &Square, sides: &Sides, count: u32) -> bool {
        let own = around(&self.low(square));
        let image = self.levels.forth(count).hull(sides);
        let preimage = self.levels.back(count).hull(&own);
        let overlap = |a: &Sides, b: &Sides| (0..2).all(|i| a[i][0] < b[i][1] && b[i][0] < a[i][1]);
        overlap(&own, &image) && overlap(&preimage, sides)
    }
}

/// The square with this lower corner as a box.
pub(super) fn around(low: &Place) -> Sides {
    low.each_ref().map(|x| [x.clone(), x + &Rational::one()])
}

/// A square of level 0 as a box.
fn root_box(at: Index) -> Sides {
    at.map(|x| [Rational::from(x), Rational::from(x + 1)])
}
