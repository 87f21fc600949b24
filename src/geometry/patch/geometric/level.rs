//! One level: whether its mesh, or the parts of it that belong to some faces, are within the tolerance.

use super::super::place::Verdict;
use super::super::threads::{in_threads, in_threads_until, threads};
use super::cover::FarPoint;
use super::levels::{Levels, MeshNearness, check};
use super::patch::FaceSurface;
use super::place::GeometricPlace;
use super::scene::Scene;
use super::sets::MeshSets;
use super::sweep::{far_distance, first_far, sweep};
use super::units::MeshUnits;
use super::whole::Whole;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::{
    MeshError, MeshScheme, PolygonMesh, Stencils, groups, step_with, weighted_valences,
};
use crate::patch::distance::judge::Rounded;
use crate::patch::distance::surface::{PieceSearch as _, Surface as _, TooMuch as _};
use crate::patch::mesh::distances::MeshDistances;
use crate::patch::mesh::levels::Source;
use crate::patch::mesh::search::Search;
use crate::patch::shapes::library::Shapes;
use crate::patch::shapes::scheme::PieceScheme;

/// How many pieces are looked at by parameter in one piece of level 1 before its face is looked at closely.
const FILTER_STEPS: u64 = 2_000;

/// About how many faces of a level are made at once.
const GROUP: usize = 16_384;

/// The search on a mesh.
pub(super) struct Geometry<'a> {
    pub(super) distances: &'a MeshDistances,
    pub(super) scheme: MeshScheme,
    pub(super) surface: FaceSurface,
    pub(super) tolerance: Rational,
    /// The control mesh as the model has it.
    pub(super) control: PolygonMesh<f64>,
    pub(super) stencils: Stencils<f64>,
    /// What each thread knows of shapes; there is one at least.
    shapes: Vec<Shapes>,
}

impl<'a> Geometry<'a> {
    pub(super) fn new(
        distances: &'a MeshDistances,
        surface: FaceSurface,
        tolerance: &Rational,
    ) -> Result<Geometry<'a>, MeshError> {
        let model = &distances.model;
        let Source::Surface { mesh, scheme, stencils, .. } = &model.source else {
            let reason = "the distance of a solid is that at equal parameters";
            return Err(MeshError::too_much(reason.to_owned()));
        };
        check::<MeshError>(tolerance, mesh.points(), "mesh")?;
        let control = mesh.with_points(model.control());
        let mut valences = weighted_valences(mesh.connectivity(), *scheme);
        let next = step_with(&control, *scheme, &stencils.map(nearest))?;
        valences.extend(weighted_valences(next.connectivity(), *scheme));
        // Later levels have regular vertices and faces, whatever the first ones have.
        valences.insert(if scheme.is_triangular() { 6 } else { 4 });
        let stencils = Stencils::new(*scheme, valences).map(nearest);
        let shapes = vec![Shapes::new(PieceScheme::Surface(*scheme))];
        let (scheme, tolerance) = (*scheme, tolerance.clone());
        Ok(Geometry { distances, scheme, surface, tolerance, control, stencils, shapes })
    }

    /// Whether the mesh of every level is that of 91, so that equal parameters bound the distance of the sets.
    fn is_plain_everywhere(&self) -> bool {
        let quadrilaterals = || self.control.faces().iter().all(|face| face.len() == 4);
        let fours = || {
            let connectivity = self.control.connectivity();
            let stars = (0..connectivity.point_count()).map(|v| connectivity.star(v));
            quadrilaterals() && stars.into_iter().all(|star| star.boundary || star.valence() == 4)
        };
        match self.scheme {
            MeshScheme::Loop | MeshScheme::LoopWarren => true,
            MeshScheme::CatmullClark | MeshScheme::Bajaj => self.surface == FaceSurface::Bilinear,
            MeshScheme::DooSabin => self.surface == FaceSurface::Bilinear && fours(),
        }
    }

    fn judge(&self) -> Rounded {
        self.distances.model.rounded_judge(&self.tolerance)
    }

    /// The faces, of those that are asked for, which the distance at equal parameters does not show to be near, the
    /// farthest first.
    fn waiting(&self, level: u32, wanted: &[bool]) -> Vec<usize> {
        let model = &self.distances.model;
        let judge = self.judge();
        let mut best = vec![-1.0_f64; self.count()];
        let bounds: Vec<f64> = match level {
            0 => vec![0.0; model.roots.all.len()],
            _ => model.bounds(level).collect(),
        };
        let roots: Vec<usize> =
            (0..model.roots.all.len()).filter(|&i| wanted[model.roots.all[i].face]).collect();
        let work = self.distances.work();
        let far = in_threads(&roots, |&number| {
            let root = &model.roots.all[number];
            if work.is_stopped() {
                return true;
            }
            // A fan is not the mesh that is compared at equal parameters.
            if !self.is_plain(root.face, root.shape, level) {
                return true;
            }
            let mut search = Search::new(&model.shapes, &judge, level, FILTER_STEPS);
            !matches!(search.examine(model.rounded_cell(root, level)), Verdict::Within)
        });
        for (&number, far) in roots.iter().zip(far) {
            let face = model.roots.all[number].face;
            if far {
                best[face] = best[face].max(bounds[number]);
            }
        }
        let mut waiting: Vec<usize> = (0..best.len()).filter(|&face| best[face] >= 0.0).collect();
        waiting.sort_by(|&left, &right| best[right].total_cmp(&best[left]));
        waiting
    }

    /// Whether the mesh of a level on a piece of level 1 is that of 91.
    fn is_plain(&self, face: usize, shape: usize, level: u32) -> bool {
        if self.scheme.is_triangular() {
            return true;
        }
        let quadrilateral = self.surface.is_bilinear(self.control.faces()[face].len());
        match (self.scheme, level) {
            (_, 0) => quadrilateral,
            (MeshScheme::DooSabin, _) => {
                self.surface == FaceSurface::Bilinear
                    && self.distances.model.shapes.get(shape).is_regular()
            }
            _ => self.surface == FaceSurface::Bilinear,
        }
    }

    /// The points of the units of the faces that are farthest by parameter, for a level that is far from
    /// sufficient.
    fn first_points(
        &self,
        shapes: &mut Shapes,
        level: u32,
        waiting: &[usize],
        whole: &Whole<MeshSets>,
    ) -> Result<Vec<(usize, MeshNearness)>, MeshError> {
        let size = (2_048 >> (2 * level).min(20)).clamp(1, 64).min(waiting.len());
        let group = &waiting[..size];
        if group.is_empty() {
            return Ok(Vec::new());
        }
        let this = self.place_maker(level);
        let Some((scene, owners)) = self.scene(shapes, level, group)? else {
            return Ok(Vec::new());
        };
        let own: Vec<usize> =
            (0..scene.units.len()).filter(|&unit| owners[unit].is_some()).collect();
        let far = first_far(&scene, &own, whole).and_then(|far| {
            let owner = owners[far.unit]?;
            let face = group[owner.0];
            Some((face, MeshNearness::Far(this.place(whole, &scene, face, owner.1, &far))))
        });
        Ok(far.into_iter().collect())
    }

    /// Some faces, in halves where they are too many at once. Where `all` is false, what comes after a half with a face
    /// that is far is left out.
    fn group(
        &self,
        shapes: &mut Shapes,
        level: u32,
        group: &[usize],
        whole: &Whole<MeshSets>,
        all: bool,
    ) -> Result<Vec<(usize, MeshNearness)>, MeshError> {
        let this = self.place_maker(level);
        let work = self.distances.work();
        let open = || group.iter().map(|&face| (face, MeshNearness::Open)).collect();
        if work.is_stopped() {
            return Ok(open());
        }
        let Some((scene, owners)) = self.scene(shapes, level, group)? else {
            if group.len() == 1 {
                return Ok(open());
            }
            let (first, second) = group.split_at(group.len() / 2);
            let mut known = self.group(shapes, level, first, whole, all)?;
            if all || !has_far(&known) {
                known.extend(self.group(shapes, level, second, whole, all)?);
            }
            return Ok(known);
        };
        let tolerance = nearest(&(&this.tolerance / &this.scale));
        let own: Vec<usize> =
            (0..scene.units.len()).filter(|&unit| owners[unit].is_some()).collect();
        let found = sweep(&scene, &own, whole, tolerance, &work, all);
        for _ in group {
            work.step();
        }
        let mut known: Vec<MeshNearness> = vec![MeshNearness::Near; group.len()];
        for (&unit, nearness) in own.iter().zip(&found) {
            let Some((owner, number)) = owners[unit] else { continue };
            let place = |far: &_| this.place(whole, &scene, group[owner], number, far);
            known[owner].add(nearness, place);
        }
        Ok(group.iter().copied().zip(known).collect())
    }

    /// What is known of the faces that wait, with what each thread knows of shapes.
    fn known(
        &self,
        shapes: &mut Vec<Shapes>,
        level: u32,
        waiting: &[usize],
        all: bool,
    ) -> Result<Vec<(usize, MeshNearness)>, MeshError> {
        let sets = MeshSets::new(&self.distances.model, &self.judge(), self.surface, level);
        let whole = Whole::new(sets);
        if !all {
            let first = self.first_points(&mut shapes[0], level, waiting, &whole)?;
            if !first.is_empty() {
                return Ok(first);
            }
        }
        let size = (GROUP >> (2 * level).min(20)).max(1);
        let groups = groups(self.control.connectivity(), waiting, size);
        let count = threads(groups.len(), 1);
        shapes.resize_with(shapes.len().max(count), || {
            Shapes::new(PieceScheme::Surface(self.scheme))
        });
        let found = in_threads_until(
            &mut shapes[..count],
            &groups,
            |shapes, group| self.group(shapes, level, group, &whole, all),
            |found| found.as_ref().map_or(true, |known| !all && has_far(known)),
        );
        let found = found.into_iter().collect::<Result<Vec<_>, MeshError>>()?;
        Ok(found.into_iter().flatten().collect())
    }

    fn place_maker(&self, level: u32) -> Places<'a> {
        let scale = self.distances.model.scale.clone();
        Places {
            distances: self.distances,
            scheme: self.scheme,
            level,
            tolerance: self.tolerance.clone(),
            scale,
        }
    }
}

impl Levels for Geometry<'_> {
    type Error = MeshError;

    fn count(&self) -> usize {
        self.control.faces().len()
    }

    fn examine(
        &mut self,
        level: u32,
        wanted: &[bool],
        all: bool,
    ) -> Result<Vec<(usize, MeshNearness)>, MeshError> {
        let waiting = self.waiting(level, wanted);
        self.distances.work().begin(level, waiting.len());
        let mut shapes = std::mem::take(&mut self.shapes);
        let known = self.known(&mut shapes, level, &waiting, all);
        self.shapes = shapes;
        known
    }

    fn is_stopped(&self) -> bool {
        self.distances.work.is_stopped()
    }

    fn parametric(&self) -> Result<Option<u32>, MeshError> {
        let plain = self.is_plain_everywhere();
        plain.then(|| self.distances.parametric_level(&self.tolerance)).transpose()
    }
}

/// Whether a face is far.
fn has_far(known: &[(usize, MeshNearness)]) -> bool {
    known.iter().any(|(_, known)| matches!(known, MeshNearness::Far(_)))
}

/// Says where a point is.
struct Places<'a> {
    distances: &'a MeshDistances,
    scheme: MeshScheme,
    level: u32,
    tolerance: Rational,
    scale: Rational,
}

impl Places<'_> {
    fn place(
        &self,
        whole: &Whole<MeshSets>,
        scene: &Scene<MeshUnits>,
        face: usize,
        number: usize,
        far: &FarPoint,
    ) -> GeometricPlace {
        let model = &self.distances.model;
        // A power of two.
        let scale = nearest(&self.scale);
        let lower = far_distance(whole, far, &(&self.tolerance / &self.scale));
        let Source::Surface { mesh, .. } = &model.source else { unreachable!("a surface") };
        let doo_sabin = self.scheme == MeshScheme::DooSabin;
        let first = (self.level > 0).then(|| model.source.first_part(face)).flatten();
        let level_face =
            first.map(|first| ((first as u128) << (2 * (self.level - 1))) + number as u128);
        let part = match self.level {
            0 => Some(scene.pieces.root(far.unit).part),
            _ if doo_sabin => None,
            level => Some(number >> (2 * (level - 1))),
        };
        let vertex = part.and_then(|part| mesh.faces()[face].get(part).copied());
        GeometricPlace {
            face,
            parameters: None,
            vertex,
            level_face,
            from: far.from,
            point: model.as_given(&far.point),
            other: model.as_given(&far.other),
            distance: lower * scale,
        }
    }
}
