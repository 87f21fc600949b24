//! A net as the search sees it: its pieces, in f64 and exactly.

use super::super::threads::in_threads;
use super::cell::Cell;
use super::direction::Direction;
use crate::patch::distance::surface::Surface as _;

use super::rules::norm;
use super::scaled::scaled;
use super::spot::face;
use crate::exact::Rational;
use crate::mesh::Point;
use crate::net::{Net, NetError, NetScheme};

/// A net as pieces: the cells of level 0.
pub struct Model {
    pub(super) net: Net,
    pub(super) directions: [Direction; 2],
    /// In f64: moved so that the first point is the origin, and divided by the scale.
    rounded: Net<f64>,
    /// A power of two.
    pub(super) scale: Rational,
    /// What a length is off by, for each level.
    pub(super) unit: f64,
    /// The greatest differences of the cells, in both directions.
    pub(super) sizes: Vec<[f64; 2]>,
}

impl Model {
    pub(super) fn new(net: Net, scheme: &NetScheme) -> Result<Model, NetError> {
        let [u, v] = scheme.masks();
        let (sizes, closed) = (net.sizes(), net.closed());
        let first = Direction::new(u, 0, sizes[0], closed.u)?;
        let second = if u == v && sizes[0] == sizes[1] && closed.u == closed.v {
            first.clone()
        } else {
            Direction::new(v, 1, sizes[1], closed.v)?
        };
        let directions = [first, second];
        let (rounded, scale) = scaled(&net)?;
        let size = rounded.points().iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        let unit = unit(&directions) * size;
        let mut model = Model { net, directions, rounded, scale, unit, sizes: Vec::new() };
        let judge = model.rounded_judge(&Rational::one());
        let roots: Vec<usize> = (0..model.root_count()).collect();
        model.sizes =
            in_threads(&roots, |&root| model.rounded_cell(root).sizes(&model.directions, &judge));
        Ok(model)
    }

    /// The greatest Σ|coefficients| of the points of the net so many levels after a cell, over the points of the cell.
    pub(super) fn polygon_norm(&self, later: u32) -> f64 {
        self.directions.iter().map(|direction| direction.constants.polygon_at(later)).product()
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

    fn cell<S: Clone>(&self, root: usize, point: impl Fn(i64, i64) -> Point<S>) -> Cell<S> {
        let [u, v] = &self.directions;
        let columns = v.cells();
        let [i, j] = [(root / columns, u), (root % columns, v)].map(|(at, direction)| {
            let first = direction.window.first_cell(direction.closed);
            i64::try_from(at).unwrap_or(i64::MAX).saturating_add(first)
        });
        let rows = u.window.first..=u.window.last;
        let points = rows.flat_map(|p| (v.window.first..=v.window.last).map(move |q| (p, q)));
        let points = points.map(|(p, q)| point(i + p, j + q)).collect();
        Cell { levels: [0; 2], index: [i.into(), j.into()], points, base: None }
    }

    /// A piece in f64.
    pub(super) fn rounded_cell(&self, root: usize) -> Cell<f64> {
        self.cell(root, |i, j| self.rounded.at(i, j).copied().unwrap_or([f64::NAN; 3]))
    }

    /// The same exactly.
    pub(super) fn exact_cell(&self, root: usize) -> Cell<Rational> {
        let origin = &self.net.points()[0];
        self.cell(root, |i, j| {
            let point = self.net.at(i, j).unwrap_or(origin);
            [0, 1, 2].map(|c| (&point[c] - &origin[c]) / &self.scale)
        })
    }
}

/// What lengths are off by, for each level and in units of the greatest coordinate: `proofs/THEOREMS.md`, 99 (e).
fn unit(directions: &[Direction; 2]) -> f64 {
    let of = |of: fn(&Direction) -> f64| directions.iter().map(of).product::<f64>();
    let terms: usize = directions.iter().map(|direction| direction.window.size()).sum();
    let terms = f64::from(u32::try_from(terms + 8).unwrap_or(u32::MAX));
    let powers = of(|direction| direction.constants.polygon);
    let values = of(|direction| {
        let bezier = direction.rounded.bezier.as_deref().unwrap_or_default();
        direction.constants.limit.max(norm(bezier, |x| x.abs()))
    });
    let refinement = of(|direction| direction.constants.refinement);
    16.0 * terms * refinement * powers * powers * (values + 2.0) * (f64::EPSILON / 2.0)
}
