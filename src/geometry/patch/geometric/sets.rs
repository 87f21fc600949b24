//! A polygon mesh of a level, and its limit, as a whole.

use super::super::number::mean;
use super::patch::{FaceSurface, Patch};
use super::pieces::{Hull, MeshPart, Pieces, Sets};
use super::units::hull;
use crate::mesh::Point;
use crate::patch::distance::judge::{Points as _, Rounded};
use crate::patch::mesh::model::Model;
use crate::patch::mesh::piece::LevelPiece;
use crate::patch::mesh::roots::Root;

/// The roots are the pieces of level 1.
pub(super) struct MeshSets<'a> {
    model: &'a Model,
    surface: FaceSurface,
    level: u32,
    slack: f64,
}

impl<'a> MeshSets<'a> {
    pub(super) fn new(
        model: &'a Model,
        judge: &Rounded,
        surface: FaceSurface,
        level: u32,
    ) -> MeshSets<'a> {
        MeshSets { model, surface, level, slack: 4.0 * judge.slack(level + 40) }
    }

    /// The mesh of the level on a piece of that level.
    fn patches(&self, root: &Root, cell: &LevelPiece<Point<f64>>) -> Vec<Patch> {
        let shapes = &self.model.shapes;
        if let Some(base) = &cell.base {
            return Patch::between(base, self.surface.is_bilinear(self.model.face_size(root)));
        }
        if let Some(LevelPiece { base: Some(own), .. }) = cell.begun(shapes) {
            if own.len() == 3 || self.surface.is_bilinear(own.len()) {
                return Patch::between(&own, true);
            }
            let centre = mean(&own);
            let n = own.len();
            return (0..n).map(|i| Patch::triangle(own[i], own[(i + 1) % n], centre)).collect();
        }
        let rules = Point::<f64>::rules(shapes.get(cell.shape));
        let parts = cell.parts(shapes, true).into_iter().zip(&rules.base);
        parts
            .flat_map(|(part, rows)| {
                // The third corner is the centroid of the face.
                let bilinear = self.surface.is_bilinear(rows[2].len());
                Patch::between(&part.base.unwrap_or_default(), bilinear)
            })
            .collect()
    }
}

impl Pieces for MeshSets<'_> {
    type Piece = LevelPiece<Point<f64>>;

    fn hull(&self, piece: &Self::Piece) -> Hull {
        hull(piece, &self.model.shapes)
    }

    fn parts(&self, piece: &Self::Piece) -> Vec<Self::Piece> {
        piece.parts(&self.model.shapes, false)
    }
}

impl Sets for MeshSets<'_> {
    fn count(&self) -> usize {
        self.model.roots.all.len()
    }

    fn root(&self, number: usize, of_mesh: bool) -> Self::Piece {
        let level = if of_mesh { self.level } else { 1 };
        self.model.rounded_cell(&self.model.roots.all[number], level)
    }

    fn mesh_part(&self, number: usize, piece: &Self::Piece) -> MeshPart {
        if piece.base.is_none() && piece.level < self.level {
            return MeshPart::Within(piece.points.clone(), 0.0);
        }
        MeshPart::Patches(self.patches(&self.model.roots.all[number], piece))
    }

    fn slack(&self) -> f64 {
        self.slack
    }
}
