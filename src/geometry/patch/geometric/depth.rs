//! The least level whose mesh is within a tolerance of the limit surface as a set of points.

use super::super::depth::MeshDistances;
use super::level::{Geometry, Known};
use super::patch::FaceSurface;
use super::place::GeometricPlace;
use crate::exact::Rational;
use crate::float::upper;
use crate::mesh::MeshError;

/// The highest level that is looked at as a set of points.
pub(super) const MAX_LEVEL: u32 = 14;

/// How many levels a mesh, or a control polygon, needs as a set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricDepth<P = GeometricPlace> {
    /// The least level that was found to be sufficient.
    pub level: u32,
    /// The greatest level that is certainly not sufficient, with all levels below it; `None` where even
    /// level 0 may be.
    pub too_few: Option<u32>,
    /// A point that shows that `too_few` is not sufficient.
    pub beyond: Option<P>,
}

/// What one face of the control mesh needs.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceDepth {
    /// The least level that was found to be sufficient for its part of the mesh and its part of the limit.
    pub level: u32,
    /// Whether all levels below certainly are not.
    pub is_least: bool,
    /// The last distance that was found to be too great, and its level: a lower bound.
    pub too_far: Option<(u32, f64)>,
}

impl MeshDistances {
    /// The least level k with H_k ≤ ε, where
    ///
    /// H_k = max(sup_{p ∈ S} d(p, M_k), sup_{q ∈ M_k} d(q, S))
    ///
    /// is the Hausdorff distance of the mesh M_k of level k from the limit surface S, d the Euclidean distance of a
    /// point from a set. `surface` says what a face with four vertices or more is. A Doo–Sabin surface with
    /// boundary is compared with the quarters of faces at inner vertices.
    ///
    /// Source: `proofs/THEOREMS.md`, 160 to 163.
    ///
    /// # Errors
    /// When the tolerance is not positive, needs too many levels or too large meshes, or this is a solid.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::mesh::{MeshScheme, PolygonMesh};
    /// use subcert::patch::{FaceSurface, MeshDistances};
    ///
    /// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
    /// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
    /// let mesh = PolygonMesh::new(points.to_vec(), faces)?;
    /// let distances = MeshDistances::new(mesh, MeshScheme::Loop)?;
    /// let tolerance = Rational::new(1, 20);
    /// let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear)?;
    /// assert!(depth.level <= distances.depth(&tolerance)?.level);
    /// assert_eq!(depth.too_few, Some(depth.level - 1));
    /// # Ok::<(), subcert::mesh::MeshError>(())
    /// ```
    pub fn geometric_depth(
        &self,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<GeometricDepth, MeshError> {
        let mut geometry = Geometry::new(self, surface, tolerance)?;
        let wanted = vec![true; geometry.face_count()];
        let (mut too_few, mut beyond, mut certain) = (None, None, true);
        // A level that equal parameters show to be sufficient, found when it is needed.
        let mut sure: Option<u32> = None;
        for level in 0..=MAX_LEVEL {
            if sure.is_some_and(|sure| sure <= level) {
                return Ok(GeometricDepth { level, too_few, beyond });
            }
            let found = geometry.examine(level, &wanted, false)?;
            let far = found.iter().find_map(|(_, known)| match known {
                Known::Far(place) => Some(place.clone()),
                _ => None,
            });
            let open = found.iter().any(|(_, known)| matches!(known, Known::Open));
            match far {
                Some(place) if certain => (too_few, beyond) = (Some(level), Some(place)),
                Some(_) => {}
                None if open => {
                    certain = false;
                    if sure.is_none() && geometry.is_plain_everywhere() {
                        let parametric = self.parametric_level(tolerance)?;
                        if parametric <= level {
                            return Ok(GeometricDepth { level, too_few, beyond });
                        }
                        sure = Some(parametric);
                    }
                }
                None => return Ok(GeometricDepth { level, too_few, beyond }),
            }
        }
        if let Some(level) = sure {
            return Ok(GeometricDepth { level, too_few, beyond });
        }
        if geometry.is_plain_everywhere() {
            let level = self.parametric_level(tolerance)?;
            return Ok(GeometricDepth { level, too_few, beyond });
        }
        Err(too_many())
    }

    /// For each face of the control mesh a lower and an upper bound of the distance, at a level, of its part of the mesh
    /// and its part of the limit from the whole other set: with upper bounds ε, ε/2, ε/4 or ε/8, or infinite
    /// where ε is none.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn geometric_distances(
        &self,
        level: u32,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<Vec<[f64; 2]>, MeshError> {
        let mut bounds = Vec::new();
        let mut wanted = Vec::new();
        for halved in 0..4 {
            let tolerance = tolerance * &Rational::new(1, 1_i64 << halved);
            let mut geometry = Geometry::new(self, surface, &tolerance)?;
            if halved == 0 {
                bounds = vec![[0.0, f64::INFINITY]; geometry.face_count()];
                wanted = vec![true; geometry.face_count()];
            }
            let mut near = wanted.clone();
            for (face, known) in geometry.examine(level, &wanted, true)? {
                match known {
                    Known::Near => continue,
                    Known::Open => {}
                    Known::Far(place) => bounds[face][0] = bounds[face][0].max(place.distance),
                }
                near[face] = false;
            }
            for (bounds, _) in bounds.iter_mut().zip(&near).filter(|(_, near)| **near) {
                bounds[1] = upper(&tolerance);
            }
            wanted = near;
        }
        Ok(bounds)
    }

    /// What each face of the control mesh needs: its part of the mesh of a level, and its part of the limit, are
    /// within the tolerance of the whole other set.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn geometric_faces(
        &self,
        tolerance: &Rational,
        surface: FaceSurface,
    ) -> Result<Vec<FaceDepth>, MeshError> {
        let mut geometry = Geometry::new(self, surface, tolerance)?;
        let none = FaceDepth { level: 0, is_least: true, too_far: None };
        let mut faces = vec![none; geometry.face_count()];
        let mut wanted = vec![true; faces.len()];
        for level in 0..=MAX_LEVEL {
            let mut next = vec![false; faces.len()];
            for (face, known) in geometry.examine(level, &wanted, true)? {
                match known {
                    Known::Near => continue,
                    Known::Open => faces[face].is_least = false,
                    Known::Far(place) => faces[face].too_far = Some((level, place.distance)),
                }
                faces[face].level = level + 1;
                next[face] = true;
            }
            if !next.contains(&true) {
                return Ok(faces);
            }
            wanted = next;
        }
        Err(too_many())
    }
}

fn too_many() -> MeshError {
    let reason = format!(
        "the tolerance needs more than {MAX_LEVEL} levels as a distance of sets, or is too near to call; \
         take a greater one, or --distance parametric"
    );
    MeshError::TooMuch { reason }
}
