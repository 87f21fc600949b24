//! The mesh of a level around some faces, without the parts that equal parameters show to be near.

use super::level::Geometry;
use super::patch::FaceSurface;
use super::scene::Scene;
use super::units::{MeshUnits, Stage};
use crate::mesh::{MeshError, MeshScheme, PolygonMesh, cut, grown, step_with};
use crate::patch::mesh::roots::Root;
use crate::patch::shapes::library::Shapes;
use crate::patch::threads::in_threads;

/// With more faces than this, a mesh on the way to a level is trimmed.
const TRIMMED: usize = 2_048;

/// The most faces of a mesh that is refined once more.
const LARGEST: usize = 100_000;

/// The number of a face in a group, and of a face of a level among those of that face.
type Owner = Option<(usize, usize)>;

/// A scene with the owners of its units.
type Owned<'s> = (Scene<MeshUnits<'s>>, Vec<Owner>);

impl Geometry<'_> {
    /// The mesh of the level around some faces, as a scene, and for each unit the number, in the group, of its
    /// face, with the number of its face of the level among those of that face; `None` where that would be
    /// too large. Units of which equal parameters show that they are near are left out on the way.
    pub(super) fn scene<'s>(
        &self,
        shapes: &'s mut Shapes,
        level: u32,
        group: &[usize],
    ) -> Result<Option<Owned<'s>>, MeshError> {
        let doo_sabin = self.scheme == MeshScheme::DooSabin;
        let steps = match level {
            0 => 4,
            1 => 3,
            _ => 2,
        } + u32::from(doo_sabin);
        let faces = grown(self.control.connectivity(), group, steps);
        let (mut mesh, _) = cut(&self.control, &faces)?;
        // Of faces; for Doo–Sabin, from level 1 on, of vertices.
        let mut owners: Vec<Owner> =
            (0..faces.len()).map(|i| (i < group.len()).then_some((i, 0))).collect();
        for step in 0..level {
            if step > 0 && mesh.faces().len() > TRIMMED {
                (mesh, owners) = self.trimmed(shapes, mesh, owners, step, level)?;
            }
            if mesh.faces().len() > LARGEST || self.distances.work.is_stopped() {
                return Ok(None);
            }
            let next = step_with(&mesh, self.scheme, &self.stencils)?;
            let corners = mesh.faces().iter().enumerate();
            owners = if doo_sabin {
                let of = |(face, vertices): (usize, &Vec<usize>)| -> Vec<Owner> {
                    let owner =
                        |&vertex: &usize| if step == 0 { owners[face] } else { owners[vertex] };
                    vertices.iter().map(owner).collect()
                };
                corners.flat_map(of).collect()
            } else {
                let triangles = self.scheme.is_triangular();
                let of = |(face, vertices): (usize, &Vec<usize>)| -> Vec<Owner> {
                    let parts = if triangles { 4 } else { vertices.len() };
                    let owner = owners[face];
                    (0..parts).map(|i| owner.map(|(owner, n)| (owner, n * parts + i))).collect()
                };
                corners.flat_map(of).collect()
            };
            mesh = next;
        }
        let by_vertex = doo_sabin && level > 0;
        let vertices: Vec<Vec<usize>> = if by_vertex { mesh.faces().to_vec() } else { Vec::new() };
        let model = &self.distances.model;
        let judge = model.rounded_judge_after(&self.tolerance, level);
        let stage = Stage::new(mesh, self.scheme, &self.stencils, shapes)?;
        let scene = stage.scene(self.scheme, self.surface, shapes, judge);
        let of = |root: &Root| {
            if by_vertex { owners[vertices[root.face][root.part]] } else { owners[root.face] }
        };
        let owners = (0..scene.units.len()).map(|unit| of(scene.pieces.root(unit))).collect();
        Ok(Some((scene, owners)))
    }

    /// The part of a mesh of level `step` that has the units which equal parameters do not show to be near at
    /// `level`, with what is around it.
    fn trimmed(
        &self,
        shapes: &mut Shapes,
        mesh: PolygonMesh<f64>,
        owners: Vec<Owner>,
        step: u32,
        level: u32,
    ) -> Result<(PolygonMesh<f64>, Vec<Owner>), MeshError> {
        if self.surface != FaceSurface::Bilinear {
            return Ok((mesh, owners));
        }
        let doo_sabin = self.scheme == MeshScheme::DooSabin;
        let judge = self.distances.model.rounded_judge_after(&self.tolerance, step);
        let stage = Stage::new(mesh.clone(), self.scheme, &self.stencils, shapes)?;
        let scene = stage.scene(self.scheme, self.surface, shapes, judge);
        let at = |root: &Root| {
            if doo_sabin { mesh.faces()[root.face][root.part] } else { root.face }
        };
        let numbers: Vec<usize> = (0..scene.units.len()).collect();
        let far = in_threads(&numbers, |&number| {
            owners[at(scene.pieces.root(number))].is_some()
                && !scene.pieces.is_near_later(number, level - step, doo_sabin)
        });
        let mut kept = vec![false; owners.len()];
        let mut faces = vec![false; mesh.faces().len()];
        for (&number, _) in numbers.iter().zip(far).filter(|(_, far)| *far) {
            let root = scene.pieces.root(number);
            kept[at(root)] = true;
            faces[root.face] = true;
        }
        let chosen: Vec<usize> = (0..faces.len()).filter(|&face| faces[face]).collect();
        if chosen.is_empty() {
            // Any face will do: none is owned.
            let (mesh, _) = cut(&mesh, &grown(mesh.connectivity(), &[0], 1))?;
            let count = if doo_sabin { mesh.points().len() } else { mesh.faces().len() };
            return Ok((mesh, vec![None; count]));
        }
        let chosen = grown(mesh.connectivity(), &chosen, 3);
        let (mesh, origins) = cut(&mesh, &chosen)?;
        let owner = |old: &usize| owners[*old].filter(|_| kept[*old]);
        let owners = if doo_sabin { &origins } else { &chosen }.iter().map(owner).collect();
        Ok((mesh, owners))
    }
}
