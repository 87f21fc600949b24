//! Where a net is far from its limit surface as a set of points.

use super::cell::Cell;
use super::pieces::NetPieces;
use super::search::Node;
use super::sets::NetLevels;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::Point;
use crate::patch::distance::surface::Surface as _;
use crate::patch::geometric::{
    FarPoint, GeometricPlace, Pieces as _, Scene, SetKind, Whole, far_distance,
};
use crate::patch::number::squared;
use crate::patch::place::{FarPlace, Place};

/// How many levels deeper the parameters of a far point are looked for.
const NEAR_LEVELS: u32 = 10;

impl NetLevels<'_> {
    /// Natural parameters in a cell of a level near which the net, or the limit, has a point.
    fn parameters(&self, cell: &Cell<f64>, point: &Point<f64>, from: SetKind) -> [Rational; 2] {
        let directions = self.directions();
        let pieces = self.pieces(cell.level(), Vec::new());
        let at = |cell: &Cell<f64>, which: usize, share: &Rational| {
            let unit = Rational::from(directions[which].arity).pow(cell.level().cast_signed());
            (Rational::from(cell.index[which]) + share) / unit
        };
        let mut best: Option<(f64, [Rational; 2])> = None;
        let mut offer = |square: f64, parameters: [Rational; 2]| {
            if best.as_ref().is_none_or(|(least, _)| square < *least) {
                best = Some((square, parameters));
            }
        };
        match from {
            SetKind::Limit => {
                // Those parts whose corners are nearest, level by level.
                let mut cells = vec![cell.clone()];
                for _ in 0..NEAR_LEVELS {
                    let mut parts: Vec<(f64, Cell<f64>)> = Vec::new();
                    for part in cells.iter().flat_map(|cell| cell.parts(directions, [true; 2])) {
                        let corners = [[0, 0], [0, 1], [1, 1], [1, 0]];
                        let mut least = f64::INFINITY;
                        for (corner, limit) in corners.into_iter().zip(&pieces.hull(&part).limits) {
                            let (square, shares) =
                                (squared(limit, point), corner.map(Rational::from));
                            least = least.min(square);
                            offer(square, [0, 1].map(|which| at(&part, which, &shares[which])));
                        }
                        parts.push((least, part));
                    }
                    parts.sort_by(|left, right| left.0.total_cmp(&right.0));
                    cells = parts.into_iter().take(4).map(|(_, part)| part).collect();
                }
            }
            SetKind::Mesh => {
                let base = cell.clone().begun(directions).base;
                let Some(base) = base else {
                    return [0, 1].map(|which| at(cell, which, &Rational::zero()));
                };
                let nodes =
                    [0, 1].map(|which| &directions[which].exact.phases[base.phases[which]].nodes);
                let columns = nodes[1].len();
                let shares = [0, 1, 2, 3, 4].map(|i| Rational::new(i, 4));
                for (i, j) in (1..nodes[0].len()).flat_map(|i| (1..columns).map(move |j| (i, j))) {
                    let corner =
                        |a: usize, b: usize| &base.points[(i - 1 + a) * columns + j - 1 + b];
                    for (u, v) in shares.iter().flat_map(|u| shares.iter().map(move |v| (u, v))) {
                        let (s, t) = (nearest(u), nearest(v));
                        let x = [0, 1, 2].map(|c| {
                            (1.0 - s) * ((1.0 - t) * corner(0, 0)[c] + t * corner(0, 1)[c])
                                + s * ((1.0 - t) * corner(1, 0)[c] + t * corner(1, 1)[c])
                        });
                        let share = |which: usize, end: usize, part: &Rational| {
                            let (low, high) = (&nodes[which][end - 1], &nodes[which][end]);
                            at(cell, which, &(low + &(part * &(high - low))))
                        };
                        offer(squared(&x, point), [share(0, i, u), share(1, j, v)]);
                    }
                }
            }
        }
        best.map_or_else(|| [0, 1].map(|which| at(cell, which, &Rational::zero())), |(_, at)| at)
    }

    /// Where a far point of a scene is.
    pub(super) fn place(
        &self,
        scene: &Scene<NetPieces>,
        whole: &Whole<NetPieces>,
        far: &FarPoint,
    ) -> GeometricPlace {
        let model = &self.distances.model;
        let (level, cell) = (scene.pieces.level, &scene.pieces.cells[far.unit]);
        let distance = far_distance(whole, far, &(&self.tolerance / &model.scale));
        let (phases, grid) = match cell.clone().begun(self.directions()).base {
            Some(base) => (base.phases, base.points),
            None => ([0; 2], Vec::new()),
        };
        let square = |i: usize| squared(&grid[i], &far.point);
        let nearest_node =
            (0..grid.len()).min_by(|i, j| square(*i).total_cmp(&square(*j))).unwrap_or(0);
        let columns = self.directions()[1].rounded.phases[phases[1]].nodes.len();
        let parameters = self.parameters(cell, &far.point, far.from);
        let (polygon, limit) = match far.from {
            SetKind::Mesh => (far.point, far.other),
            SetKind::Limit => (far.other, far.point),
        };
        let number = [nearest_node / columns, nearest_node % columns];
        let at = Node { levels: cell.levels, index: cell.index, phases, number };
        let place = Place { level: cell.level(), at, limit, polygon };
        let FarPlace { face, vertex, level_face, on_mesh, on_limit } =
            model.far_place(0, level, &place);
        let (point, other) = match far.from {
            SetKind::Mesh => (on_mesh, on_limit),
            SetKind::Limit => (on_limit, on_mesh),
        };
        // The scale is a power of two.
        let distance = distance * nearest(&model.scale);
        GeometricPlace {
            face,
            parameters: Some(parameters),
            vertex,
            level_face,
            from: far.from,
            point,
            other,
            distance,
        }
    }
}
