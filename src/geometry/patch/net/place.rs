//! Places where a net is far from its limit.

use super::super::far::FarPlace;
use super::cell::Cell;
use super::direction::Direction;
use super::model::Model;
use super::search::Place;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::Point;

/// Where a parameter is among the points and faces of one direction.
struct Spot {
    /// The face of the control net, and the nearest point of it.
    face: usize,
    point: usize,
    /// The face of the level, and how many the level has.
    of_level: Option<[u128; 2]>,
}

impl Spot {
    fn of<S>(direction: &Direction, place: &Place<S>, which: usize, level: u32) -> Option<Spot> {
        let phase = &direction.exact.phases[place.phases[which]];
        let node = place.nodes[which];
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
fn face(direction: &Direction, index: i128) -> Option<usize> {
    cut(direction, index, direction.count - usize::from(!direction.closed))
}

/// A place in the numbers of the control net, with these points.
fn far_place<S>(
    model: &Model,
    level: u32,
    place: &Place<S>,
    [on_mesh, on_limit]: [Point<f64>; 2],
) -> FarPlace {
    let [u, v] = &model.directions;
    let [up, along] =
        [(u, 0), (v, 1)].map(|(direction, which)| Spot::of(direction, place, which, level));
    let pair = up.zip(along);
    let faces = model.net.faces()[1];
    let face = pair.as_ref().map_or(0, |(up, along)| up.face * faces + along.face);
    let vertex = pair.as_ref().map(|(up, along)| up.point * model.net.columns() + along.point);
    let level_face = pair.filter(|_| level > 0).and_then(|(up, along)| {
        let ([i, _], [j, count]) = (up.of_level?, along.of_level?);
        i.checked_mul(count)?.checked_add(j)
    });
    FarPlace { face, vertex, level_face, on_mesh, on_limit }
}

impl Model {
    /// A place in f64, as the net is in the file.
    pub(super) fn rounded_place(&self, level: u32, place: &Place<f64>) -> FarPlace {
        let scale = nearest(&self.scale);
        let origin = self.net.points()[0].each_ref().map(nearest);
        let points = [&place.polygon, &place.limit]
            .map(|point| [0, 1, 2].map(|c| point[c] * scale + origin[c]));
        far_place(self, level, place, points)
    }

    /// An exact place, rounded.
    pub(super) fn exact_place(&self, level: u32, place: &Place<Rational>) -> FarPlace {
        let origin = &self.net.points()[0];
        let points = [&place.polygon, &place.limit]
            .map(|point| [0, 1, 2].map(|c| nearest(&(&point[c] * &self.scale + &origin[c]))));
        far_place(self, level, place, points)
    }

    /// The faces of the control net that a cell has parts of.
    pub(super) fn faces_of(&self, cell: &Cell<f64>) -> Vec<usize> {
        let range = |direction: &Direction, which: usize| -> Vec<usize> {
            let unit = Rational::from(direction.arity).pow(cell.levels[which].cast_signed());
            let at = |index: i128| Rational::from(index) / &unit - &direction.shift;
            let index = cell.index[which];
            let (first, last) = (at(index).floor(), at(index + 1).ceil());
            let (first, last) = (first.to_i128().unwrap_or(0), last.to_i128().unwrap_or(0));
            (first..last).filter_map(|index| face(direction, index)).collect()
        };
        let [u, v] = &self.directions;
        let (up, along) = (range(u, 0), range(v, 1));
        let columns = self.net.faces()[1];
        up.iter().flat_map(|i| along.iter().map(move |j| i * columns + j)).collect()
    }

    /// The face of the control net of a place.
    pub(super) fn face(&self, place: &Place<f64>) -> usize {
        far_place(self, 0, place, [[0.0; 3]; 2]).face
    }
}
