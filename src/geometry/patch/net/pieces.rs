//! Nets for the distance of sets (`proofs/THEOREMS.md`, 166).

use super::super::geometric::{Hull, MeshPart, Patch, Pieces, Sets, Unit, Units};
use super::super::number::squared;
use super::super::place::Verdict;
use super::cell::Cell;
use super::constants::UP;
use super::direction::{Direction, Weights};
use super::model::Model;
use super::points::tensor;
use super::search::Search;
use crate::mesh::Point;
use crate::patch::distance::judge::{Judge as _, Rounded};
use crate::patch::distance::surface::{PieceSearch as _, Surface as _};

/// How many pieces are looked at for the distance of a unit at equal parameters.
const UNIT_STEPS: u64 = 2_000;

/// The pieces of a net: all of them from level 0 on, or those of some cells of the level of the net.
pub(super) struct NetPieces<'a> {
    pub(super) model: &'a Model,
    pub(super) judge: Rounded,
    /// The level of the net that the limit is compared with.
    pub(super) level: u32,
    /// The cells of that level which are units.
    pub(super) cells: Vec<Cell<f64>>,
}

impl NetPieces<'_> {
    fn directions(&self) -> &[Direction; 2] {
        &self.model.directions
    }

    /// How far lengths may be off, at all levels of pieces.
    pub(super) fn off(&self) -> f64 {
        4.0 * self.judge.slack(self.level + 40)
    }

    fn search(&self) -> Search<'_, Rounded> {
        let (directions, judge, level) = (self.directions(), &self.judge, self.level);
        Search { directions, judge, level, deepest: level + 20, steps: UNIT_STEPS }
    }
}

impl Pieces for NetPieces<'_> {
    type Piece = Cell<f64>;

    /// In the hull of the Bézier coefficients where the limit is a polynomial; else near that of its corners, by 99 (c).
    fn hull(&self, piece: &Cell<f64>) -> Hull {
        let directions = self.directions();
        let [u, v] = directions.each_ref().map(f64::rules);
        let width = directions[1].window.size();
        // As units see it, those of the level are the first.
        let level = piece.level() - if self.cells.is_empty() { 0 } else { self.level };
        if let (Some(first), Some(second)) = (&u.bezier, &v.bezier) {
            let points = tensor([first, second], &piece.points, width);
            let (rows, columns) = (first.len(), second.len());
            let last = rows * columns - 1;
            let corners = [0, columns - 1, last, last + 1 - columns];
            let limits = corners.map(|i| points[i]).to_vec();
            return Hull { points, extra: 0.0, limits, level };
        }
        let ends = [&u.phases[0].limits[..], &v.phases[0].limits[..]];
        let points = tensor(ends, &piece.points, width);
        let limits = [0, 1, 3, 2].map(|i| points[i]).to_vec();
        let [a, b] = piece.sizes(directions, &self.judge);
        let [u, v] = directions.each_ref().map(|direction| &direction.constants);
        let extra = (u.chord * a * v.limit + u.limit * v.chord * b) * UP;
        Hull { points, extra, limits, level }
    }

    fn parts(&self, piece: &Cell<f64>) -> Vec<Cell<f64>> {
        piece.parts(self.directions(), [true; 2])
    }
}

/// The mesh on a cell of its level: a grid of points, row by row, and how many columns there are.
fn grid(cell: &Cell<f64>, directions: &[Direction; 2]) -> (Vec<Point<f64>>, usize) {
    let base = cell.clone().begun(directions).base;
    let columns = f64::rules(&directions[1]);
    let columns = columns.phases[columns.start].nodes.len();
    (base.map(|base| base.points).unwrap_or_default(), columns)
}

fn patches(grid: &[Point<f64>], columns: usize) -> Vec<Patch> {
    let corners = (0..grid.len().saturating_sub(columns)).filter(|i| (i + 1) % columns != 0);
    let patch = |i: usize| {
        Patch::between(&[grid[i], grid[i + 1], grid[i + columns + 1], grid[i + columns]], true)
    };
    corners.flat_map(patch).collect()
}

/// A cell of the level as a unit; the number of a corner is that of a point of the grid of all cells.
pub(super) fn unit(
    cell: &Cell<f64>,
    directions: &[Direction; 2],
    mut number: impl FnMut([i128; 2]) -> usize,
) -> Unit {
    let (grid, columns) = grid(cell, directions);
    let rows = grid.len() / columns;
    let (right, bottom) = (columns - 1, rows - 1);
    let around = (0..columns).map(|j| [0, j]);
    let around = around.chain((1..rows).map(|i| [i, right]));
    let around = around.chain((0..right).rev().map(|j| [bottom, j]));
    let around = around.chain((1..bottom).rev().map(|i| [i, 0]));
    let around: Vec<[usize; 2]> = around.collect();
    let steps = [bottom as i128, right as i128];
    let at = |[i, j]: [usize; 2]| {
        [cell.index[0] * steps[0] + i as i128, cell.index[1] * steps[1] + j as i128]
    };
    let corners = around.iter().map(|place| number(at(*place))).collect();
    let base = around.iter().map(|[i, j]| grid[i * columns + j]).collect();
    Unit { patches: patches(&grid, columns), base, corners }
}

impl Units for NetPieces<'_> {
    fn piece(&self, number: usize) -> Cell<f64> {
        self.cells[number].clone()
    }

    fn is_near_by_parameter(&self, number: usize, _: &Unit) -> bool {
        matches!(self.search().examine(self.piece(number)), Verdict::Within)
    }

    fn moved(&self, number: usize, _: &Unit) -> f64 {
        let (mut best, mut place) = (0.0, None);
        let upper = self.search().measure(self.piece(number), 0.2, &mut best, &mut place);
        upper.max(best)
    }

    fn tolerance(&self) -> f64 {
        self.judge.tolerance()
    }
}

impl Sets for NetPieces<'_> {
    fn count(&self) -> usize {
        self.model.root_count()
    }

    fn root(&self, number: usize, _: bool) -> Cell<f64> {
        self.model.rounded_cell(number)
    }

    fn mesh_part(&self, _: usize, piece: &Cell<f64>) -> MeshPart {
        let directions = self.directions();
        let later = self.level - piece.level();
        if later == 0 {
            let (grid, columns) = grid(piece, directions);
            return MeshPart::Patches(patches(&grid, columns));
        }
        // Combinations of the points, whose coefficients sum to 1 and their absolute values to at most this.
        let norm = self.model.polygon_norm(later);
        if norm <= 1.0 {
            return MeshPart::Within(piece.points.clone(), 0.0);
        }
        let centre = piece.points[piece.points.len() / 2];
        let square = piece.points.iter().map(|x| squared(x, &centre)).fold(0.0, f64::max);
        let radius = square.sqrt() * norm * UP;
        MeshPart::Within(vec![centre], radius)
    }

    fn slack(&self) -> f64 {
        self.off()
    }
}
