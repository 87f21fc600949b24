//! Pieces of the limit, divided when they are needed, with the hulls that they are in.

use super::pieces::{Hull, Pieces};
use crate::mesh::Point;
use std::ops::Range;

/// A piece of the limit.
pub(super) struct Node<P> {
    piece: P,
    pub(super) hull: Hull,
    pub(super) centre: Point<f64>,
    pub(super) radius: f64,
    parts: Option<Range<usize>>,
}

/// Trees of pieces.
pub(super) struct Nodes<'a, P: Pieces> {
    pieces: &'a P,
    all: Vec<Node<P::Piece>>,
}

impl<'a, P: Pieces> Nodes<'a, P> {
    pub(super) fn new(pieces: &'a P) -> Self {
        Nodes { pieces, all: Vec::new() }
    }

    /// The number of a new piece.
    pub(super) fn add(&mut self, piece: P::Piece) -> usize {
        let hull = self.pieces.hull(&piece);
        let (centre, radius) = hull.ball();
        self.all.push(Node { piece, hull, centre, radius, parts: None });
        self.all.len() - 1
    }

    pub(super) fn get(&self, node: usize) -> &Node<P::Piece> {
        &self.all[node]
    }

    /// The numbers of the parts of a piece, which are made when they are first asked for.
    pub(super) fn parts(&mut self, node: usize) -> Range<usize> {
        if let Some(parts) = &self.all[node].parts {
            return parts.clone();
        }
        let first = self.all.len();
        for part in self.pieces.parts(&self.all[node].piece) {
            self.add(part);
        }
        let parts = first..self.all.len();
        self.all[node].parts = Some(parts.clone());
        parts
    }
}
