//! Places where a mesh is far from its limit.

use super::model::Model;
use super::roots::Root;
use super::search::Place;
use crate::exact::RealCyclotomic;
use crate::float::nearest;
use crate::mesh::{MeshScheme, Point};

/// Where a mesh is far from its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct FarPlace {
    /// The face of the control mesh.
    pub face: usize,
    /// The vertex of that face whose part it is on; `None` for the middle triangle of a triangle.
    pub vertex: Option<usize>,
    /// The face of the level; `None` at level 0, where it is that of the control mesh, and for Doo and
    /// Sabin.
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
        let faces = model.control.faces();
        let first = match model.scheme {
            MeshScheme::CatmullClark => {
                faces[..root.face].iter().map(Vec::len).sum::<usize>() + root.part
            }
            _ => 4 * root.face + root.part,
        };
        let level_face = (level > 0 && model.scheme != MeshScheme::DooSabin).then(|| {
            // The path of the piece of that level, which the place may be a part of.
            let path = place.path >> (2 * (place.level.max(level) - level));
            ((first as u128) << (2 * (level - 1))) + path
        });
        let vertex = faces[root.face].get(root.part).copied();
        FarPlace { face: root.face, vertex, level_face, on_mesh, on_limit }
    }
}
