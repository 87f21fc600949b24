//! A net as the search sees it: its pieces, in f64 and exactly.

use super::super::judge::Rounded;
use super::super::threads::in_threads;
use super::cell::{Cell, bound};
use super::constants::MAX_LATER;
use super::direction::Direction;
use super::judge::Exactly;
use super::rules::norm;
use super::scaled::scaled;
use crate::exact::Rational;
use crate::mesh::Point;
use crate::net::{Net, NetError, NetScheme};

/// n^k is at most 2^this for all levels k.
const MAX_BITS: f64 = 90.0;

/// A net as pieces: the cells of level 0.
pub(super) struct Model {
    pub(super) net: Net,
    pub(super) directions: [Direction; 2],
    /// In f64: moved so that the first point is the origin, and divided by the scale.
    rounded: Net<f64>,
    /// A power of two.
    pub(super) scale: Rational,
    /// What a length is off by, for each level.
    unit: f64,
    /// The greatest differences of the cells, in both directions.
    sizes: Vec<[f64; 2]>,
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
        let roots: Vec<usize> = (0..model.roots()).collect();
        model.sizes =
            in_threads(&roots, |&root| model.rounded_cell(root).sizes(&model.directions, &judge));
        Ok(model)
    }

    /// How many pieces there are.
    pub(super) fn roots(&self) -> usize {
        self.directions[0].cells() * self.directions[1].cells()
    }

    /// The highest level at which nets are compared with their limit, and the highest one of pieces.
    pub(super) fn most_levels(&self, most: u32) -> [u32; 2] {
        let arity = self.directions.iter().map(|direction| direction.arity).max().unwrap_or(2);
        let digits = f64::from(u32::try_from(arity).unwrap_or(u32::MAX)).log2();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // From 15 to 90.
        let all = (MAX_BITS / digits) as u32;
        // Pieces have some levels more than nets.
        let levels = most.min(all.saturating_sub(2).max(1)).min(MAX_LATER);
        [levels, all.min(MAX_LATER)]
    }

    /// The pieces with a greater bound than this for a level, the greatest first.
    pub(super) fn above(&self, level: u32, threshold: f64) -> Vec<(f64, usize)> {
        let bounds = self.sizes.iter().map(|sizes| bound(&self.directions, *sizes, level));
        let mut above: Vec<(f64, usize)> =
            bounds.zip(0..).filter(|(bound, _)| *bound > threshold).collect();
        above.sort_by(|left, right| right.0.total_cmp(&left.0));
        above
    }

    /// Whether the bounds of all pieces for a level, and all later ones, are within a threshold.
    pub(super) fn surely(&self, level: u32, threshold: f64) -> bool {
        self.sizes.iter().all(|sizes| bound(&self.directions, *sizes, level) <= threshold)
    }

    /// Lengths in f64.
    pub(super) fn rounded_judge(&self, tolerance: &Rational) -> Rounded {
        Rounded::with_unit(&(tolerance / &self.scale), self.unit)
    }

    /// Exact lengths.
    pub(super) fn exact_judge(&self, tolerance: &Rational) -> Exactly {
        Exactly::new(&(tolerance / &self.scale))
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
