//! The least level whose net is within a tolerance of the limit surface as a set of points.

use super::super::geometric::{
    FaceDepth, GeometricDepth, Levels, MAX_LEVEL, MeshNearness, Scene, Whole, check, distances,
    first_far, sweep,
};
use super::super::threads::in_threads;
use super::cell::{Cell, bound};
use super::direction::Direction;
use super::distances::NetDistances;
use super::pieces::{NetPieces, unit};
use crate::exact::Rational;
use crate::float::nearest;
use crate::net::NetError;
use crate::patch::distance::judge::Judge as _;
use crate::patch::distance::surface::Surface as _;
use std::collections::{BTreeSet, HashMap};

/// How many cells of a level are looked at together.
const CHUNK: usize = 1_024;

/// How many cells around them there are.
const AROUND: i128 = 4;

/// The most cells of a level that simple bounds leave open.
const MAX_CELLS: usize = 1 << 20;

/// How many cells are tried first.
const FIRST: usize = 400;

type Index = [i128; 2];

/// A cell of the level of which simple bounds do not show that it is near.
struct Own {
    index: Index,
    root: usize,
    bound: f64,
}

/// The search on a net; its faces are the cells of level 0.
pub(super) struct NetLevels<'a> {
    pub(super) distances: &'a NetDistances,
    pub(super) tolerance: Rational,
}

impl NetDistances {
    /// The least level k with H_k ≤ ε, where
    ///
    /// H_k = max(sup_{p ∈ S} d(p, N_k), sup_{q ∈ N_k} d(q, S))
    ///
    /// is the Hausdorff distance of the net N_k of level k, bilinear between its points, from the limit surface S, d the
    /// Euclidean distance of a point from a set. Both are taken where the given points determine the limit. Faces and
    /// vertices in the result are those of the net, row by row.
    ///
    /// Source: `proofs/THEOREMS.md`, 160 to 163 and 166.
    ///
    /// # Errors
    /// When the tolerance is not positive, or too small.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::net::{Closed, Net, NetScheme};
    /// use subcert::patch::NetDistances;
    ///
    /// // On a paraboloid the net is a sixth of both second differences above its bicubic spline.
    /// let square = |k: i64| Rational::from(k * k);
    /// let point = |k: i64| [(k % 6).into(), (k / 6).into(), square(k % 6) + square(k / 6)];
    /// let net = Net::new((0..36).map(point).collect(), 6, Closed::default())?;
    /// let distances = NetDistances::new(net, &NetScheme::parse("bicubic")?)?;
    /// let tolerance = Rational::new(1, 10);
    /// // The paraboloid is steep: across it, it is nearer than at equal parameters.
    /// assert_eq!(distances.depth(&tolerance)?.level, 2);
    /// assert_eq!(distances.geometric_depth(&tolerance)?.level, Some(2));
    /// # Ok::<(), subcert::net::NetError>(())
    /// ```
    pub fn geometric_depth(&self, tolerance: &Rational) -> Result<GeometricDepth, NetError> {
        NetLevels::new(self, tolerance)?.depth()
    }

    /// Whether the distance H_k of [`geometric_depth`](Self::geometric_depth) is at most ε at a level k; `None` where that
    /// is open.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn is_within(&self, level: u32, tolerance: &Rational) -> Result<Option<bool>, NetError> {
        NetLevels::new(self, tolerance)?.is_within(level)
    }

    /// What each face of the net needs: its part of the net of a level, and its part of the limit, are within the
    /// tolerance of the whole other set. Parts are those of all cells of the parameters that the face has a share of.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn geometric_faces(&self, tolerance: &Rational) -> Result<Vec<FaceDepth>, NetError> {
        let none = FaceDepth { level: 0, is_least: true, too_far: None };
        let cells = NetLevels::new(self, tolerance)?.faces()?;
        Ok(self.of_faces(&cells, &none, |face, cell| {
            if cell.level > face.level || (cell.level == face.level && cell.is_least) {
                face.clone_from(cell);
            }
        }))
    }

    /// For each face of the net a lower and an upper bound of the distance of its parts, as
    /// [`geometric_faces`](Self::geometric_faces) has them, at a level: with upper bounds ε, ε/2, ε/4 or ε/8, or infinite
    /// where ε is none.
    ///
    /// # Errors
    /// As [`geometric_depth`](Self::geometric_depth).
    pub fn geometric_distances(
        &self,
        level: u32,
        tolerance: &Rational,
    ) -> Result<Vec<[f64; 2]>, NetError> {
        let cells = distances(level, tolerance, |tolerance| NetLevels::new(self, tolerance))?;
        Ok(self.of_faces(&cells, &[0.0; 2], |face, cell| {
            *face = [face[0].max(cell[0]), face[1].max(cell[1])];
        }))
    }

    /// From the cells of level 0 to the faces of the net, of which each may have parts of several cells.
    fn of_faces<T: Clone>(&self, cells: &[T], none: &T, merge: impl Fn(&mut T, &T)) -> Vec<T> {
        let [rows, columns] = self.model.net.faces();
        let mut faces = vec![none.clone(); rows * columns];
        for (root, cell) in cells.iter().enumerate() {
            for face in self.model.faces_of(&self.model.rounded_cell(root)) {
                merge(&mut faces[face], cell);
            }
        }
        faces
    }
}

impl<'a> NetLevels<'a> {
    fn new(distances: &'a NetDistances, tolerance: &Rational) -> Result<NetLevels<'a>, NetError> {
        check::<NetError>(tolerance, distances.model.net.points(), "net")?;
        Ok(NetLevels { distances, tolerance: tolerance.clone() })
    }

    pub(super) fn directions(&self) -> &'a [Direction; 2] {
        &self.distances.model.directions
    }

    pub(super) fn pieces(&self, level: u32, cells: Vec<Cell<f64>>) -> NetPieces<'a> {
        let model = &self.distances.model;
        NetPieces { model, judge: model.rounded_judge(&self.tolerance), level, cells }
    }

    /// The cells of a level in a root that simple bounds leave open, up to a cap.
    fn own(&self, root: usize, pieces: &NetPieces) -> Vec<Own> {
        let directions = self.directions();
        let tolerance = pieces.judge.tolerance();
        let mut own = Vec::new();
        let mut stack = vec![self.distances.model.rounded_cell(root)];
        while let Some(cell) = stack.pop() {
            let sizes = cell.sizes(directions, &pieces.judge);
            let bound = bound(directions, sizes, pieces.level - cell.level());
            if bound <= tolerance {
                continue;
            }
            if cell.level() < pieces.level {
                stack.extend(cell.parts(directions, [true; 2]));
                continue;
            }
            own.push(Own { index: cell.index, root, bound });
            if own.len() > MAX_CELLS {
                break;
            }
        }
        own
    }

    /// The first cell of a level in a direction, and how many there are.
    fn range(&self, which: usize, level: u32) -> [i128; 2] {
        let direction = &self.directions()[which];
        let unit = (direction.arity as i128).pow(level);
        let first = i128::from(direction.window.first_cell(direction.closed));
        [first * unit, direction.cells() as i128 * unit]
    }

    /// The cells around some cells of a level, and these, by their indices; a closed net has no end.
    fn around(&self, level: u32, own: &[&Own]) -> BTreeSet<Index> {
        let ranges = [self.range(0, level), self.range(1, level)];
        let at = |which: usize, index: i128| {
            let [first, count] = ranges[which];
            if self.directions()[which].closed {
                return Some(first + (index - first).rem_euclid(count));
            }
            (first..first + count).contains(&index).then_some(index)
        };
        let mut all = BTreeSet::new();
        for Own { index: [i, j], .. } in own {
            for a in (i - AROUND..=i + AROUND).filter_map(|a| at(0, a)) {
                all.extend((j - AROUND..=j + AROUND).filter_map(|b| at(1, b)).map(|b| [a, b]));
            }
        }
        all
    }

    /// The cells of a level with these indices, in some order.
    fn cells(&self, level: u32, wanted: BTreeSet<Index>) -> Vec<Cell<f64>> {
        let directions = self.directions();
        let arities = directions.each_ref().map(|direction| direction.arity as i128);
        let mut by_level = vec![wanted];
        for _ in 0..level {
            let last = &by_level[by_level.len() - 1];
            let up = |[i, j]: &Index| [i.div_euclid(arities[0]), j.div_euclid(arities[1])];
            by_level.push(last.iter().map(up).collect());
        }
        let [first, columns] = [0, 1].map(|which| self.range(which, 0));
        let root = |[i, j]: &Index| {
            usize::try_from((i - first[0]) * columns[1] + (j - columns[0])).unwrap_or(0)
        };
        let model = &self.distances.model;
        let roots = by_level.pop().unwrap_or_default();
        let mut cells: Vec<Cell<f64>> =
            roots.iter().map(|index| model.rounded_cell(root(index))).collect();
        while let Some(wanted) = by_level.pop() {
            let parts = cells.iter().flat_map(|cell| cell.parts(directions, [true; 2]));
            cells = parts.filter(|part| wanted.contains(&part.index)).collect();
        }
        cells
    }

    /// Some cells of a level with what is around them, for each unit which of them it is, and the units that are any.
    fn scene(
        &self,
        level: u32,
        own: &[&Own],
    ) -> (Scene<NetPieces<'a>>, Vec<Option<usize>>, Vec<usize>) {
        let directions = self.directions();
        let cells = self.cells(level, self.around(level, own));
        let numbers: HashMap<Index, usize> =
            own.iter().enumerate().map(|(i, own)| (own.index, i)).collect();
        let owners: Vec<Option<usize>> =
            cells.iter().map(|cell| numbers.get(&cell.index).copied()).collect();
        let own_units = (0..owners.len()).filter(|unit| owners[*unit].is_some()).collect();
        let ends = [0, 1].map(|which| {
            let rules = &directions[which].rounded;
            let steps = rules.phases[rules.start].nodes.len() as i128 - 1;
            let [first, count] = self.range(which, level);
            directions[which].closed.then_some([first * steps, count * steps])
        });
        let mut corners: HashMap<Index, usize> = HashMap::new();
        let mut number = |index: Index| {
            let key = [0, 1].map(|which| match ends[which] {
                None => index[which],
                Some([first, count]) => first + (index[which] - first).rem_euclid(count),
            });
            let next = corners.len();
            *corners.entry(key).or_insert(next)
        };
        let units = cells.iter().map(|cell| unit(cell, directions, &mut number)).collect();
        let pieces = self.pieces(level, cells);
        let slack = pieces.off();
        (Scene::new(pieces, units, slack), owners, own_units)
    }
}

impl Levels for NetLevels<'_> {
    type Error = NetError;

    fn count(&self) -> usize {
        self.distances.model.root_count()
    }

    fn examine(
        &mut self,
        level: u32,
        wanted: &[bool],
        all: bool,
    ) -> Result<Vec<(usize, MeshNearness)>, NetError> {
        let work = self.distances.work();
        let whole = Whole::new(self.pieces(level, Vec::new()));
        let limit = whole.sets.judge.tolerance();
        let most = self.distances.model.most_levels()[0].min(MAX_LEVEL);
        let waiting = self.distances.model.above(level, limit);
        let mut roots: Vec<usize> =
            waiting.into_iter().map(|(_, root)| root).filter(|root| wanted[*root]).collect();
        if level > most {
            return Ok(roots.into_iter().map(|root| (root, MeshNearness::Open)).collect());
        }
        roots.sort_unstable();
        work.begin(level, roots.len());
        let mut own: Vec<Own> = Vec::new();
        let mut complete = true;
        for some in roots.chunks(64) {
            let found = in_threads(some, |&root| self.own(root, &whole.sets));
            own.extend(found.into_iter().flatten());
            if own.len() > MAX_CELLS || work.is_stopped() {
                complete = false;
                break;
            }
        }
        if !all && !work.is_stopped() {
            let mut first: Vec<&Own> = own.iter().collect();
            first.sort_by(|left, right| right.bound.total_cmp(&left.bound));
            first.truncate(FIRST);
            let (scene, owners, own_units) = self.scene(level, &first);
            if let Some(far) = first_far(&scene, &own_units, &whole) {
                let root = owners[far.unit].map_or(0, |i| first[i].root);
                return Ok(vec![(root, MeshNearness::Far(self.place(&scene, &whole, &far)))]);
            }
        }
        if !complete {
            return Ok(roots.into_iter().map(|root| (root, MeshNearness::Open)).collect());
        }
        let tolerance = nearest(&(&self.tolerance / &self.distances.model.scale));
        let mut known: HashMap<usize, MeshNearness> = HashMap::new();
        let own: Vec<&Own> = own.iter().collect();
        let mut last = None;
        for chunk in own.chunks(CHUNK) {
            let (scene, owners, own_units) = self.scene(level, chunk);
            let found = sweep(&scene, &own_units, &whole, tolerance, &work, all);
            for (unit, nearness) in own_units.iter().zip(&found) {
                let root = owners[*unit].map_or(0, |i| chunk[i].root);
                let entry = known.entry(root).or_insert(MeshNearness::Near);
                entry.add(nearness, |far| self.place(&scene, &whole, far));
            }
            for root in chunk.iter().map(|own| own.root) {
                if last != Some(root) {
                    work.step();
                    last = Some(root);
                }
            }
            if !all && known.values().any(|known| matches!(known, MeshNearness::Far(_))) {
                break;
            }
        }
        let mut known: Vec<(usize, MeshNearness)> = known.into_iter().collect();
        known.sort_by_key(|(root, _)| *root);
        Ok(known)
    }

    fn is_stopped(&self) -> bool {
        self.distances.work.is_stopped()
    }

    /// A net is bilinear at equal parameters too.
    fn parametric(&self) -> Result<Option<u32>, NetError> {
        self.distances.parametric_level(&self.tolerance).map(Some)
    }
}
