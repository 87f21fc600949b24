//! Where a parameter is among the points and faces of one direction.

use super::direction::Direction;
use super::search::Node;
use crate::exact::Rational;

/// Where a parameter is among the points and faces of one direction.
pub(super) struct Spot {
    /// The face of the control net, and the nearest point of it.
    pub(super) face: usize,
    pub(super) point: usize,
    /// The face of the level, and how many the level has.
    pub(super) of_level: Option<[u128; 2]>,
}

impl Spot {
    pub(super) fn of(
        direction: &Direction,
        place: &Node,
        which: usize,
        level: u32,
    ) -> Option<Spot> {
        let phase = &direction.exact.phases[place.phases[which]];
        let node = place.number[which];
        // The middle of a segment that the node is an end of: it is on one face only.
        let left = node.min(phase.nodes.len() - 2);
        let middle = (&phase.nodes[left] + &phase.nodes[left + 1]) / Rational::from(2);
        let arity = Rational::from(direction.arity);
        let index = Rational::from(place.index[which]);
        let unit = arity.pow(place.levels[which].cast_signed());
        let at = |node: &Rational| (&index + node) / &unit;
        let (inside, at) = (at(&middle), at(&phase.nodes[node]));
        let face = face(direction, (&inside - &direction.shift).floor().to_i128()?)?;
        let half = Rational::new(1, 2);
        let nearest = (at - &direction.shift + half).floor().to_i128()?;
        let point = cut(direction, nearest, direction.count)?;
        let of_level = Spot::of_level(direction, &inside, level);
        Some(Spot { face, point, of_level })
    }

    fn of_level(direction: &Direction, inside: &Rational, level: u32) -> Option<[u128; 2]> {
        let unit = i128::try_from(direction.arity).ok()?.checked_pow(level)?;
        let index = (inside * Rational::from(unit) - &direction.shift).floor().to_i128()?;
        let cells = i128::try_from(direction.cells()).ok()?.checked_mul(unit)?;
        let size = i128::try_from(direction.window.size()).ok()?;
        let (index, count) = if direction.closed {
            (index.rem_euclid(cells), cells)
        } else {
            // Cell 0 of the level has the points from −(unit − 1)·first on before it.
            let first = -i128::from(direction.window.first) * (unit - 1);
            let count = cells + size - 2;
            ((index - first).clamp(0, count - 1), count)
        };
        Some([u128::try_from(index).ok()?, u128::try_from(count).ok()?])
    }
}

/// An index from 0 on, below a count.
fn cut(direction: &Direction, index: i128, count: usize) -> Option<usize> {
    let count = i128::try_from(count).ok()?;
    let index = if direction.closed { index.rem_euclid(count) } else { index.clamp(0, count - 1) };
    usize::try_from(index).ok()
}

/// The face after the point of this index.
pub(super) fn face(direction: &Direction, index: i128) -> Option<usize> {
    cut(direction, index, direction.count - usize::from(!direction.closed))
}
