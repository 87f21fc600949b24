//! Places where a mesh is far from its limit.

use super::levels::Source;
use super::model::Model;
use super::roots::Root;
use super::search::Place;
use crate::exact::RealCyclotomic;
use crate::float::nearest;
use crate::mesh::{MeshScheme, Point};

/// Where a mesh is far from its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct FarPlace {
    /// The face of the control mesh; of a solid, the cell.
    pub face: usize,
    /// The vertex of that face whose part it is on; `None` for the middle triangle of a triangle.
    pub vertex: Option<usize>,
    /// The face of the level; `None` at level 0, where it is that of the control mesh, and for Doo and
    /// Sabin, and of a solid.
    pub level_face: Option<u128>,
    /// The point of the mesh of the level, to f64.
    pub on_mesh: Point<f64>,
    /// The point of the limit surface at the same parameter, to f64.
    pub on_limit: Point<f64>,
}

impl FarPlace {
    /// A place in f64, as the mesh is in the file.
    pub(super) fn rounded(
        model: &Model,
        root: &Root,
        level: u32,
        place: &Place<Point<f64>>,
    ) -> FarPlace {
        let [on_mesh, on_limit] = [&place.polygon, &place.limit].map(|point| model.place(point));
        FarPlace::of(model, root, level, place, [on_mesh, on_limit])
    }

    /// An exact place, rounded.
    pub(super) fn exact(
        model: &Model,
        root: &Root,
        level: u32,
        place: &Place<Point<RealCyclotomic>>,
    ) -> FarPlace {
        let points = [&place.polygon, &place.limit].map(|point| point.each_ref().map(nearest));
        FarPlace::of(model, root, level, place, points)
    }

    fn of<V>(
        model: &Model,
        root: &Root,
        level: u32,
        place: &Place<V>,
        [on_mesh, on_limit]: [Point<f64>; 2],
    ) -> FarPlace {
        let first = match &model.source {
            Source::Surface { scheme: MeshScheme::DooSabin, .. } | Source::Solid(_) => None,
            Source::Surface { mesh, scheme, .. } if scheme.is_bicubic() => {
                let before = &mesh.faces()[..root.face];
                Some(before.iter().map(Vec::len).sum::<usize>() + root.part)
            }
            Source::Surface { .. } => Some(4 * root.face + root.part),
        };
        let level_face = first.filter(|_| level > 0).map(|first| {
            // The path of the piece of that level, which the place may be a part of.
            let path = place.path >> (2 * (place.level.max(level) - level));
            ((first as u128) << (2 * (level - 1))) + path
        });
        let vertex = model.source.vertex(root);
        FarPlace { face: root.face, vertex, level_face, on_mesh, on_limit }
    }
}
