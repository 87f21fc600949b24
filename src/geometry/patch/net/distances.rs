//! The distances of nets.

use super::super::number::Vector as _;
use super::super::place::{FarPlace, Place, Verdict};
use super::cell::{Cell, bound};
use super::constants::{MAX_LATER, UP};
use super::direction::Direction;
use super::model::Model;
use super::search::{Node, Search};
use super::spot::Spot;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::Point;
use crate::net::{Net, NetError, NetScheme};
use crate::patch::distance::depth::{Distances, distances_of};
use crate::patch::distance::judge::{Exactly, Judge as _, Rounded};
use crate::patch::distance::surface::{Ball, PieceSearch, Surface};

/// n^k is at most 2^this for all levels k.
const MAX_BITS: f64 = 90.0;

/// How many levels after that of the net pieces are divided.
const EXTRA_LEVELS: u32 = 30;

/// The distances of a net from its limit surface:
///
/// D_k = sup |P^∞ − P^k|, k = 0, 1, …,
///
/// over the part of the surface that the net determines, Euclidean. P^k is bilinear between the points
/// x^k_{i,j} at their natural parameters ((i + s)/n^k, (j + t)/m^k), and P^∞ is the limit at the
/// same parameters. Distances are in the unit of the coordinates. Faces and vertices are those of the net, row by row.
///
/// Source: `proofs/THEOREMS.md`, 98 and 99.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, NetScheme};
/// use subcert::patch::NetDistances;
///
/// // x²/2 + y²/2 is a sixth of both second differences below its bicubic spline.
/// let square = |k: i64| Rational::new(k * k, 2);
/// let point = |k: i64| [(k % 5).into(), (k / 5).into(), square(k % 5) + square(k / 5)];
/// let net = Net::new((0..25).map(point).collect(), 5, Closed::default())?;
/// let distances = NetDistances::new(net, &NetScheme::parse("bicubic")?)?;
/// let depth = distances.depth(&Rational::new(1, 3))?;
/// assert_eq!((depth.level, depth.too_few), (0, None));
/// let depth = distances.depth(&Rational::new(1, 100))?;
/// assert_eq!((depth.level, depth.too_few), (3, Some(2)));
/// # Ok::<(), subcert::net::NetError>(())
/// ```
pub type NetDistances = Distances<Model>;

impl Distances<Model> {
    /// The pieces of a net.
    ///
    /// # Errors
    /// When the net has too few points for a piece, or a curve is not shown to converge or is beyond the
    /// caps.
    pub fn new(net: Net, scheme: &NetScheme) -> Result<NetDistances, NetError> {
        Ok(Distances::of(Model::new(net, scheme)?))
    }

    /// The natural parameters of the cells that are compared, in each direction; `None` for a closed one.
    #[must_use]
    pub fn ranges(&self) -> [Option<[Rational; 2]>; 2] {
        self.model.directions.each_ref().map(|direction| {
            let first = direction.window.first_cell(false);
            let last = first + i64::try_from(direction.cells()).unwrap_or(i64::MAX);
            (!direction.closed).then(|| [first, last].map(Rational::from))
        })
    }
}

impl Model {
    fn search_by<'a, J>(&'a self, judge: &'a J, level: u32, steps: u64) -> Search<'a, J> {
        let deepest = self.most_levels()[1].min(level + EXTRA_LEVELS);
        Search { directions: &self.directions, judge, level, deepest, steps }
    }
}

distances_of!(Model, NetError);

/// The roots are the cells of level 0.
impl Surface for Model {
    type Error = NetError;
    type Cell = Cell<f64>;
    type At = Node;
    const FIRST: u32 = 0;
    const STEPS: u64 = 1_000_000;

    fn root_count(&self) -> usize {
        self.directions.iter().map(Direction::cells).product()
    }

    fn face_count(&self) -> usize {
        self.net.faces().iter().product()
    }

    fn frame(&self) -> (&Point<Rational>, &Rational) {
        (&self.net.points()[0], &self.scale)
    }

    fn most_levels(&self) -> [u32; 2] {
        let arity = self.directions.iter().map(|direction| direction.arity).max().unwrap_or(2);
        let digits = f64::from(u32::try_from(arity).unwrap_or(u32::MAX)).log2();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // From 15 to 90.
        let all = (MAX_BITS / digits) as u32;
        // Pieces have some levels more than nets.
        [all.saturating_sub(2).max(1), all].map(|levels| levels.min(MAX_LATER))
    }

    fn bounds(&self, level: u32) -> impl Iterator<Item = f64> {
        self.sizes.iter().map(move |sizes| bound(&self.directions, *sizes, level))
    }

    fn rounded_judge(&self, tolerance: &Rational) -> Rounded {
        Rounded::with_unit(&(tolerance / &self.scale), self.unit)
    }

    fn root(&self, root: usize, _: u32) -> Cell<f64> {
        self.rounded_cell(root)
    }

    fn search<'a>(
        &'a self,
        judge: &'a Rounded,
        level: u32,
        steps: u64,
    ) -> impl PieceSearch<Cell<f64>, Place<Node, Point<f64>>> {
        self.search_by(judge, level, steps)
    }

    fn examine_exactly(
        &self,
        root: usize,
        level: u32,
        tolerance: &Rational,
        steps: &mut u64,
    ) -> Option<Verdict<FarPlace>> {
        let judge = Exactly::<Rational>::new(&(tolerance / &self.scale));
        let mut search = self.search_by(&judge, level, *steps);
        let verdict = search.examine(self.exact_cell(root));
        *steps = search.steps;
        let origin = &self.net.points()[0];
        Some(verdict.map(|place| {
            let points = [&place.polygon, &place.limit]
                .map(|point| [0, 1, 2].map(|c| nearest(&(&point[c] * &self.scale + &origin[c]))));
            self.numbered(root, level, &place, points)
        }))
    }

    fn numbered<V>(
        &self,
        _: usize,
        level: u32,
        place: &Place<Node, V>,
        [on_mesh, on_limit]: [Point<f64>; 2],
    ) -> FarPlace {
        let [u, v] = &self.directions;
        let [up, along] =
            [(u, 0), (v, 1)].map(|(direction, which)| Spot::of(direction, &place.at, which, level));
        let pair = up.zip(along);
        let faces = self.net.faces()[1];
        let face = pair.as_ref().map_or(0, |(up, along)| up.face * faces + along.face);
        let vertex = pair.as_ref().map(|(up, along)| up.point * self.net.columns() + along.point);
        let level_face = pair.filter(|_| level > 0).and_then(|(up, along)| {
            let ([i, _], [j, count]) = (up.of_level?, along.of_level?);
            i.checked_mul(count)?.checked_add(j)
        });
        FarPlace { face, vertex, level_face, on_mesh, on_limit }
    }

    /// A piece that belongs to several faces is divided, so that most parts belong to one.
    fn on_faces(&self, root: usize, level: u32) -> Vec<(Vec<usize>, Cell<f64>)> {
        let whole = self.directions.iter().all(|direction| direction.exact.start == 0);
        let cell = self.rounded_cell(root);
        let cell = if level == 0 { cell.begun(&self.directions) } else { cell };
        let cells = if whole { vec![cell] } else { cell.parts(&self.directions, [true; 2]) };
        cells.into_iter().map(|cell| (self.faces_of(&cell), cell)).collect()
    }

    fn ball(&self, cell: &Cell<f64>, judge: &Rounded, level: u32) -> Ball {
        // The first corner is a point of the net; other points have combinations whose coefficients sum to 1.
        let (points, first, norm) = match &cell.base {
            Some(base) => (&base.points, 0, None),
            None => {
                (&cell.points, cell.points.len() / 2, Some(self.polygon_norm(level - cell.level())))
            }
        };
        let centre = points[first];
        let radius = judge.greatest(points.iter().map(|x| x.minus(&centre)), cell.level());
        let radius = norm.map_or(radius, |norm| radius * norm * UP);
        Ball { centre, radius, level: cell.level(), on_mesh: cell.base.is_some() }
    }

    fn finer(&self, cell: Cell<f64>, level: u32) -> Vec<Cell<f64>> {
        if cell.level() == level && cell.base.is_none() {
            return vec![cell.begun(&self.directions)];
        }
        cell.parts(&self.directions, [true; 2])
    }
}
