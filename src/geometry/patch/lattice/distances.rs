//! The distances of nets from the limits of masks on Z².

use super::levels::{Levels, Place};
use super::points::{Index, Points, integers, length};
use super::search::{Answer, Search, Spot};
use super::tail::Tail;
use crate::exact::Rational;
use crate::float::{exact, nearest, upper};
use crate::lattice::{Between, natural_shift, values_at_integers};
use crate::mesh::Point;
use crate::net::{Net, NetError};
use crate::patch::distance::depth::MeshDepth;
use crate::patch::distance::descent::{LevelResult, descend};
use crate::patch::distance::surface::positive;
use crate::patch::mesh::apriori::APriori;
use crate::patch::place::FarPlace;
use crate::patch::progress::MeshWork;
use crate::patch::range::scale;
use crate::scheme::LatticeMask;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The most levels.
const MAX_LEVEL: u32 = 40;

/// The most squares for the depth, for the distance there, and for that of one face.
const MOST: [usize; 3] = [1 << 17, 1 << 14, 1 << 8];

/// Of the squares that are left, one level may take half, and so many at least.
const LEAST: usize = 1 << 9;

/// The distances of a net from the limit of a mask on Z²:
///
/// D_k = sup |P^∞ − P^k|, k = 0, 1, …,
///
/// over the faces of the net whose piece of the limit it determines, Euclidean: of an open net those with all points around them that this depends on, or, if no small power of M has one entry other than 0 in each row, that the
/// bounds depend on, which are more. The point α of level k stands at M^{−k}(α + τ) − τ, τ the natural shift, and P^k is
/// linear on triangles between them or linear in each coordinate, as [`Between`] says. Rows have the first index. All is computed exactly.
///
/// Source: `proofs/THEOREMS.md`, 153.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net};
/// use subcert::patch::LatticeNetDistances;
/// use subcert::scheme::parse_lattice;
///
/// // Heights i² + j² − ij on a triangular net.
/// let height = |i: i64, j: i64| i * i + j * j - i * j;
/// let point = |k: i64| [k % 6, k / 6, height(k % 6, k / 6)].map(Rational::from);
/// let net = Net::new((0..36).map(point).collect(), 6, Closed::default())?;
/// let loop_mask = parse_lattice("(1+x)^2*(1+y)^2*(1+x*y)^2/16:edges=[[1,0],[0,1],[1,1]]")?;
/// let distances = LatticeNetDistances::new(&net, &loop_mask)?;
/// let depth = distances.depth(&Rational::new(1, 100))?;
/// assert_eq!((depth.level, depth.too_few), (3, Some(2)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct LatticeNetDistances {
    /// The net, without its first point and by the unit.
    net: Net,
    origin: Point<Rational>,
    unit: Rational,
    mask: LatticeMask,
    between: Between,
    levels: Levels,
    tail: Tail,
    /// The natural shift, and the values of φ at integers.
    shift: Place,
    values: Vec<(Index, Rational)>,
    faces: BTreeSet<Index>,
    work: Arc<MeshWork>,
}

impl LatticeNetDistances {
    /// Those of a net.
    ///
    /// # Errors
    /// When the mask is not one in the plane, its differences are not shown to contract, the net determines no piece of the limit, or its coordinates
    /// are too large.
    pub fn new(net: &Net, mask: &LatticeMask) -> Result<LatticeNetDistances, NetError> {
        if mask.dimension() != 2 {
            let text = "this mask has three variables, and a net has two directions: take a mask in the plane";
            return Err(NetError::TooMuch(text.to_owned()));
        }
        let shown = || {
            let between = Between::of(mask)?;
            let levels = Levels::of(mask)?;
            let tail = Tail::of(mask, &levels, between)?;
            Some((between, levels, tail))
        };
        let (between, levels, tail) = shown().ok_or_else(|| {
            let text = "differences of points are not shown to contract with this mask, so that no distance from a limit is known";
            NetError::TooMuch(text.to_owned())
        })?;
        let faces = determined(net, &levels)?;
        let (unit, origin) = (scale::<NetError>(net.points())?, net.points()[0].clone());
        let inverse = unit.recip();
        let scaled =
            |point: &Point<Rational>| [0, 1, 2].map(|c| (&point[c] - &origin[c]) * &inverse);
        let points = net.points().iter().map(scaled).collect();
        let net = Net::new(points, net.columns(), net.closed())?;
        let [u, v] = [0, 1].map(|i| natural_shift(mask)[i].clone());
        let values = values_at_integers(mask).ok().flatten().unwrap_or_default();
        let values = values.into_iter().map(|(at, value)| ([at[0], at[1]], value)).collect();
        let (mask, shift, work) = (mask.clone(), [u, v], Arc::default());
        Ok(LatticeNetDistances {
            net,
            origin,
            unit,
            mask,
            between,
            levels,
            tail,
            shift,
            values,
            faces,
            work,
        })
    }

    /// How far the search has come.
    #[must_use]
    pub fn work(&self) -> Arc<MeshWork> {
        Arc::clone(&self.work)
    }

    /// How many faces are compared.
    #[must_use]
    pub fn compared(&self) -> usize {
        self.faces.len()
    }

    /// The level that the longest edge guarantees: first differences are as long, and second ones twice as long at most.
    ///
    /// # Errors
    /// When the tolerance is not positive, or no level up to a cap is guaranteed.
    pub fn a_priori(&self, tolerance: &Rational) -> Result<APriori, NetError> {
        positive::<NetError>(tolerance)?;
        let [rows, columns] = self.net.sizes().map(|n| i64::try_from(n).unwrap_or(i64::MAX));
        let mut longest = 0.0_f64;
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            let Some(point) = self.net.at(i, j) else { continue };
            for end in [self.net.at(i + 1, j), self.net.at(i, j + 1)].into_iter().flatten() {
                longest = longest.max(length(&[0, 1, 2].map(|c| &end[c] - &point[c])));
            }
        }
        let level = sure(
            |level| (longest * self.tail.of_edges(level)).next_up(),
            &(tolerance / &self.unit),
        )?;
        let longest = exact(longest).unwrap_or_else(Rational::zero) * &self.unit;
        Ok(APriori { level, longest_edge: upper(&longest), ratio: self.tail.ratio() })
    }

    /// The depth for a tolerance.
    ///
    /// # Errors
    /// When the tolerance is not positive, or may need more levels than are looked at.
    pub fn depth(&self, tolerance: &Rational) -> Result<MeshDepth, NetError> {
        positive::<NetError>(tolerance)?;
        let scaled = tolerance / &self.unit;
        let mut search = self.search();
        let bound = |level: u32| -> f64 {
            self.faces.iter().map(|face| search.bound(*face, level)).fold(0.0, f64::max)
        };
        let sure = sure(bound, &scaled)?;
        let (mut left, mut looked) = (MOST[0], 0);
        let descent = descend(sure, |level, _| {
            let share = (left / 2).max(LEAST);
            let mut still = share;
            let found = search.examine(level, &scaled, &mut still);
            left = left.saturating_sub(share - still);
            looked += share - still;
            let (beyond, open) = match found {
                Answer::Within => (None, false),
                Answer::Beyond(spot) => (Some(self.far(&mut search, &spot)), false),
                Answer::Open => (None, true),
            };
            LevelResult { beyond, open, exact_pieces: 0 }
        });
        let level = descent.level;
        let (distance, worst) = search.greatest(level, &mut self.faces.iter().copied(), MOST[1]);
        let [least, most] = distance.map(|x| x * nearest(&self.unit));
        let worst = worst.map(|spot| self.far(&mut search, &spot));
        let (too_few, beyond) = descent.beyond.unzip();
        let exact_pieces = looked;
        let distance = [least, most.min(upper(tolerance))];
        Ok(MeshDepth { level, too_few, beyond, distance, worst, apart: 0.0, exact_pieces })
    }

    /// A lower and an upper bound of the distance at a level.
    #[must_use]
    pub fn distance(&self, level: u32) -> [f64; 2] {
        let mut faces = self.faces.iter().copied();
        self.search().greatest(level, &mut faces, MOST[1]).0.map(|x| x * nearest(&self.unit))
    }

    /// The same for each face of the net; both are 0 where there is no limit.
    #[must_use]
    pub fn faces(&self, level: u32) -> Vec<[f64; 2]> {
        let [rows, columns] = self.net.faces().map(|n| i64::try_from(n).unwrap_or(0));
        let mut search = self.search();
        let all = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
        let of = |face: Index| {
            if !self.faces.contains(&face) {
                return [0.0; 2];
            }
            search.greatest(level, &mut std::iter::once(face), MOST[2]).0
        };
        all.map(of).map(|bounds| bounds.map(|x| x * nearest(&self.unit))).collect()
    }

    fn search(&self) -> Search<'_> {
        let points = Points::new(&self.net, &self.mask, self.between, self.tail.order);
        let limit = (&self.shift, &self.values[..]);
        let bounds = (&self.levels, &self.tail);
        Search::new(points, bounds, limit, self.between, &self.faces, &self.work)
    }

    /// A place in the numbers of the net.
    fn far(&self, search: &mut Search<'_>, spot: &Spot) -> FarPlace {
        let limit = search.limit(spot);
        let f64s = |point: &Point<Rational>| {
            [0, 1, 2].map(|c| nearest(&(&point[c] * &self.unit + &self.origin[c])))
        };
        let half = Rational::new(1, 2);
        let sizes = self.net.sizes();
        let index = |i: usize| {
            let near = (&spot.place[i] + &half).floor().to_i64().unwrap_or(0);
            let size = i64::try_from(sizes[i]).unwrap_or(i64::MAX);
            usize::try_from(near.rem_euclid(size)).unwrap_or(0)
        };
        let face = spot.face.map(|x| usize::try_from(x).unwrap_or(0));
        FarPlace {
            face: face[0] * self.net.faces()[1] + face[1],
            vertex: Some(index(0) * self.net.columns() + index(1)),
            level_face: None,
            on_mesh: f64s(&spot.on_net),
            on_limit: f64s(&limit),
        }
    }
}

/// The least level with a bound that is within the tolerance.
fn sure(mut bound: impl FnMut(u32) -> f64, tolerance: &Rational) -> Result<u32, NetError> {
    let within = |level: &u32| exact(bound(*level)).is_some_and(|bound| bound <= *tolerance);
    (0..=MAX_LEVEL).find(within).ok_or_else(|| {
        NetError::TooMuch(format!(
            "the tolerance may need more than {MAX_LEVEL} levels, and so many are not looked at; take a greater one"
        ))
    })
}

/// The faces whose piece of the limit is determined: with all points at the integers in the open box around them.
fn determined(net: &Net, levels: &Levels) -> Result<BTreeSet<Index>, NetError> {
    let (closed, faces) = (net.closed().both(), net.faces());
    let mut ranges = Vec::new();
    for direction in [0, 1] {
        let [low, high] = &levels.window[direction];
        let wide = [low.clone(), high + &Rational::one()];
        let [first, last] = integers(&wide).unwrap_or([0, i64::MAX]);
        let count = i64::try_from(faces[direction]).unwrap_or(i64::MAX);
        let found = net.sizes()[direction];
        let size = i64::try_from(found).unwrap_or(i64::MAX);
        let range = if closed[direction] {
            0..count
        } else {
            (-first).max(0)..size.saturating_sub(last).min(count)
        };
        if range.is_empty() {
            let needed = usize::try_from(last - first + 1).unwrap_or(usize::MAX);
            if levels.nested {
                return Err(NetError::TooFew { direction, found, needed });
            }
            let what = if direction == 0 { "rows" } else { "points in a row" };
            return Err(NetError::TooMuch(format!(
                "the bounds for this dilation matrix need {needed} {what} around a face, and the net has {found}: add \
                 some, or close the net"
            )));
        }
        ranges.push(range);
    }
    let [rows, columns] = [ranges[0].clone(), ranges[1].clone()];
    Ok(rows.flat_map(|i| columns.clone().map(move |j| [i, j])).collect())
}
