//! A piece with its points: how far the polygons are from the limit on it.

use crate::patch::distance::judge::{Judge, Points};
use crate::patch::hexes::{AcrossPart, Layers};
use crate::patch::number::{Row, combinations};
use crate::patch::shapes::library::Shapes;
use crate::patch::shapes::scheme::PieceScheme;
use crate::patch::shapes::shape::{Part, Shape, UP, quarter};

/// A piece of a level with its points.
#[derive(Clone)]
pub(crate) struct LevelPiece<V> {
    pub(crate) shape: usize,
    /// The level, from 1 on.
    pub(crate) level: u32,
    pub(crate) points: Vec<V>,
    /// The polygon that the limit is compared with, at the corners of the piece, where that polygon
    /// is of this level or an earlier one and linear or bilinear on the piece.
    pub(crate) base: Option<Vec<V>>,
    /// The parts of parts that led here from the piece of level 1: two binary digits for each, the
    /// last one lowest. Of a solid it is not kept.
    pub(crate) path: u128,
}

/// What is known of the distance on a piece.
pub(super) struct Estimate<V> {
    pub(super) upper: f64,
    pub(super) lower: f64,
    /// Whether all is within the tolerance.
    pub(super) within: bool,
    /// The limit at the corner with the greatest lower bound, and the point of the polygon there.
    pub(super) limit: V,
    pub(super) polygon: V,
    /// Whether the distance at that corner is beyond the tolerance.
    pub(super) beyond: bool,
}

impl<V: Points> LevelPiece<V> {
    fn shape<'a>(&self, shapes: &'a Shapes) -> &'a Shape {
        shapes.get(self.shape)
    }

    /// The work for this piece: 1 for a regular one, more the more points there are.
    pub(crate) fn work(&self) -> u64 {
        self.points.len() as u64 / 16 + 1
    }

    /// The points that the mesh of its level, or that of the polygon, is in the hull of.
    pub(super) fn of_mesh(&self) -> &[V] {
        self.base.as_ref().unwrap_or(&self.points)
    }

    fn path_of(&self, shape: &Shape, part: usize) -> u128 {
        if shape.scheme == PieceScheme::Solid { 0 } else { self.path << 2 | part as u128 }
    }

    /// One part, of a piece that has no polygon to be compared with yet.
    pub(crate) fn part(&self, shapes: &Shapes, part: usize) -> LevelPiece<V> {
        let shape = self.shape(shapes);
        let Part { shape: next, points } = &shape.parts[part];
        let refined = &V::rules(shape).refined;
        let points = points.iter().map(|&point| V::combination(&refined[point], &self.points));
        let path = self.path_of(shape, part);
        LevelPiece {
            shape: *next,
            level: self.level + 1,
            points: points.collect(),
            base: None,
            path,
        }
    }

    /// The parts. `begin`: the polygon that the limit is compared with is that of this level.
    pub(crate) fn parts(&self, shapes: &Shapes, begin: bool) -> Vec<LevelPiece<V>> {
        let shape = self.shape(shapes);
        let rules = V::rules(shape);
        let refined = combinations(&rules.refined, &self.points);
        let part = |(i, part): (usize, &Part)| {
            let points = part.points.iter().map(|&point| refined[point].clone()).collect();
            let base = match &self.base {
                Some(base) => Some(combinations(&rules.split[i], base)),
                None if begin => Some(combinations(&rules.base[i], &self.points)),
                None => None,
            };
            let path = self.path_of(shape, i);
            LevelPiece { shape: part.shape, level: self.level + 1, points, base, path }
        };
        shape.parts.iter().enumerate().map(part).collect()
    }

    /// This piece with its own polygon to be compared with; `None` where that is so on its parts only.
    pub(crate) fn begun(&self, shapes: &Shapes) -> Option<LevelPiece<V>> {
        let own = V::rules(self.shape(shapes)).own.as_ref()?;
        Some(LevelPiece { base: Some(combinations(own, &self.points)), ..self.clone() })
    }

    /// What bounds of this piece are multiples of: of a regular piece the bound of 92, else N, or what 102
    /// has in its place.
    pub(super) fn size(&self, shapes: &Shapes, judge: &impl Judge<V>) -> f64 {
        let shape = self.shape(shapes);
        match shape.surroundings.layers() {
            _ if shape.is_regular() => self.bend(shapes, judge),
            Some(layers) => self.layered(layers, shape.convergence.bound(0), judge),
            None => self.spread(judge),
        }
    }

    /// What 102 has in the place of N.
    fn layered(&self, layers: &Layers, growth: f64, judge: &impl Judge<V>) -> f64 {
        let [within, bends] = self.within_layers(layers, judge);
        (within + bends / (6.0 * growth)) * UP
    }

    /// The greatest distance of the points from those of column 0 in the same layer, and the greatest
    /// second difference across the layers.
    fn within_layers(&self, layers: &Layers, judge: &impl Judge<V>) -> [f64; 2] {
        let at = |layer: &Vec<u32>, column: usize| &self.points[layer[column] as usize];
        let across = |layer| (1..layers[0].len()).map(move |column| (layer, column));
        let within = layers.iter().flat_map(across);
        let within = within.map(|(layer, column)| at(layer, column).minus(at(layer, 0)));
        let bends = (0..layers[0].len()).flat_map(|column| {
            layers.windows(3).map(move |three| {
                let [low, middle, high] = [0, 1, 2].map(|i| at(&three[i], column));
                low.minus(middle).minus(&middle.minus(high))
            })
        });
        [judge.greatest(within, self.level), judge.greatest(bends, self.level)]
    }

    /// The parts of the section of a piece that is the same in each layer, where it is the section that
    /// keeps bounds from being sharp.
    pub(super) fn parts_across(
        &self,
        shapes: &Shapes,
        judge: &impl Judge<V>,
    ) -> Option<Vec<LevelPiece<V>>> {
        let shape = self.shape(shapes);
        let (base, layers) = (self.base.as_ref()?, shape.surroundings.layers()?);
        let across = V::rules(shape).across.as_ref()?;
        let [within, bends] = self.within_layers(layers, judge);
        if shape.convergence.bound(0) * within < bends / 6.0 {
            return None;
        }
        let part = |part: &AcrossPart<V::Weight>| LevelPiece {
            shape: shape.parts[part.part].shape,
            level: self.level + 1,
            points: combinations(&part.points, &self.points),
            base: Some(combinations(&part.base, base)),
            path: 0,
        };
        Some(across.parts.iter().map(part).collect())
    }

    /// N: the greatest distance of the points from the first one.
    fn spread(&self, judge: &impl Judge<V>) -> f64 {
        let first = &self.points[0];
        judge.greatest(self.points[1..].iter().map(|x| x.minus(first)), self.level)
    }

    /// The bound of 92 for a regular piece.
    fn bend(&self, shapes: &Shapes, judge: &impl Judge<V>) -> f64 {
        let shape = self.shape(shapes);
        let Some((_, bends)) = &V::rules(shape).regular else { return f64::INFINITY };
        let worst = |rows: &Vec<Row<V::Weight>>| {
            judge.greatest(rows.iter().map(|row| V::combination(row, &self.points)), self.level)
        };
        let straight = bends.directions.iter().map(worst).sum();
        let across = if bends.across.is_empty() { 0.0 } else { worst(&bends.across) };
        shape.scheme.bend_bound(straight, across) * UP
    }

    /// The same, sharper where second differences of two directions cancel; not for triangles and solids.
    pub(super) fn sharp_bound(
        &self,
        shapes: &Shapes,
        judge: &impl Judge<V>,
        later: u32,
        factors: &[V::Weight],
    ) -> Option<f64> {
        let shape = self.shape(shapes);
        let (_, bends) = V::rules(shape).regular.as_ref()?;
        let [first, second] = &bends.directions[..] else { return None };
        let [first, second] = [first, second].map(|rows| combinations(rows, &self.points));
        let unit = if shape.scheme.is_cubic() { 6.0 } else { 8.0 };
        let pairs = first.iter().flat_map(|left| second.iter().map(move |right| (left, right)));
        let sums = pairs.flat_map(|(left, right)| {
            [
                left.plus_times(right, &factors[0]),
                left.plus_times(right, &factors[1]),
                right.plus_times(left, &factors[1]),
            ]
        });
        let worst = judge.greatest(sums, self.level);
        Some(worst / unit * quarter(later) * UP)
    }

    /// What is known of the distance from the polygon that is to be compared with.
    pub(super) fn known(&self, shapes: &Shapes, judge: &impl Judge<V>) -> Option<Estimate<V>> {
        let base = self.base.as_ref()?;
        let shape = self.shape(shapes);
        let rules = V::rules(shape);
        let mut known: Option<Estimate<V>> = None;
        let mut at_corner = |limit: V, polygon: V| {
            let error = limit.minus(&polygon);
            let lower = judge.below(&error, self.level);
            let beyond = judge.within(&error, self.level) == Some(false);
            let better =
                known.as_ref().is_none_or(|known| (beyond, lower) > (known.beyond, known.lower));
            if better {
                let (upper, within) = (0.0, true);
                known = Some(Estimate { upper, lower, within, limit, polygon, beyond });
            }
        };
        let (mut upper, mut within) = (0.0_f64, true);
        if let Some((bezier, _)) = &rules.regular {
            for (row, plain) in bezier {
                let (limit, polygon) =
                    (V::combination(row, &self.points), V::combination(plain, base));
                let error = limit.minus(&polygon);
                upper = upper.max(judge.above(&error, self.level));
                within = within && judge.within(&error, self.level) == Some(true);
                if plain.len() == 1 {
                    at_corner(limit, polygon);
                }
            }
        } else {
            for (i, row) in rules.limits.iter().enumerate() {
                at_corner(V::combination(row, &self.points), base[i].clone());
            }
            let (nodes, size) = match (&rules.across, shape.surroundings.layers()) {
                (Some(across), Some(layers)) => {
                    (&across.nodes, self.within_layers(layers, judge)[0])
                }
                _ => (&rules.nodes, self.spread(judge)),
            };
            let errors = nodes.iter().map(|(row, plain)| {
                V::combination(row, &self.points).minus(&V::combination(plain, base))
            });
            upper = judge.greatest(errors, self.level);
            upper = (upper + shape.convergence.bound(0) * size) * UP;
            within = upper <= judge.tolerance();
        }
        let mut known = known?;
        (known.upper, known.within) = (upper, within);
        Some(known)
    }
}
