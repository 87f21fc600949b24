//! Pieces of the limit, divided when they are needed, with the hulls that they are in.

use super::super::cell::Cell;
use super::super::judge::Points as _;
use super::super::number::combinations;
use super::super::shapes::Shapes;
use super::patch::ball;
use crate::mesh::Point;
use std::ops::Range;

/// A piece of the limit.
pub(super) struct Node {
    cell: Cell<Point<f64>>,
    /// The piece is in the hull of these: the Bézier coefficients of a regular piece (93), the points of its
    /// neighbourhood of another.
    pub(super) hull: Vec<Point<f64>>,
    /// Limit points: those at the corners.
    pub(super) limits: Vec<Point<f64>>,
    pub(super) centre: Point<f64>,
    pub(super) radius: f64,
    /// The level, from 1 on.
    pub(super) level: u32,
    parts: Option<Range<usize>>,
}

impl Node {
    fn new(cell: Cell<Point<f64>>, shapes: &Shapes) -> Node {
        let rules = Point::<f64>::rules(shapes.get(cell.shape));
        let (hull, limits) = if let Some((bezier, _)) = &rules.regular {
            let hull: Vec<Point<f64>> =
                combinations(bezier.iter().map(|(row, _)| row), &cell.points);
            let at_corner = bezier.iter().map(|(_, plain)| plain.len() == 1);
            let limits = hull.iter().zip(at_corner).filter(|(_, corner)| *corner);
            let mut limits: Vec<Point<f64>> = limits.map(|(point, _)| *point).collect();
            if limits.len() == 4 {
                // Row by row in `Bezier`, in turn here.
                limits.swap(1, 2);
                limits.swap(2, 3);
            }
            (hull, limits)
        } else {
            (cell.points.clone(), combinations(&rules.limits, &cell.points))
        };
        let (centre, radius) = ball(&hull);
        let level = cell.level;
        Node { cell, hull, limits, centre, radius, level, parts: None }
    }
}

/// Trees of pieces.
pub(super) struct Nodes<'a> {
    shapes: &'a Shapes,
    all: Vec<Node>,
}

impl<'a> Nodes<'a> {
    pub(super) fn new(shapes: &'a Shapes) -> Nodes<'a> {
        Nodes { shapes, all: Vec::new() }
    }

    /// The number of a new piece.
    pub(super) fn add(&mut self, cell: Cell<Point<f64>>) -> usize {
        self.all.push(Node::new(cell, self.shapes));
        self.all.len() - 1
    }

    pub(super) fn get(&self, node: usize) -> &Node {
        &self.all[node]
    }

    /// The numbers of the parts of a piece, which are made when they are first asked for.
    pub(super) fn parts(&mut self, node: usize) -> Range<usize> {
        if let Some(parts) = &self.all[node].parts {
            return parts.clone();
        }
        let first = self.all.len();
        let cells = self.all[node].cell.parts(self.shapes, false);
        let shapes = self.shapes;
        self.all.extend(cells.into_iter().map(|cell| Node::new(cell, shapes)));
        let parts = first..self.all.len();
        self.all[node].parts = Some(parts.clone());
        parts
    }
}
