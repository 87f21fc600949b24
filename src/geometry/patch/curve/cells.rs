//! Pieces of a curve and of its polygons, each near a chord (`proofs/THEOREMS.md`, 164).

use super::points::{Number, RefinedPoints};
use crate::exact::Rational;
use crate::float::{nearest, upper};
use crate::limit::{Distances, Limit, LimitError, determined, natural_shift};
use std::collections::HashMap;
use std::ops::Range;

/// How many cells are split for the distance constant C_0; an upper bound of it is enough.
const CONSTANT_CELLS: u32 = 4_096;

/// How many factors T_c are bounded one by one.
const FACTORS: usize = 64;

/// The level and the number of a cell: it has the parameters from (i + s)/n^m to (i + 1 + s)/n^m, s the natural shift.
pub(super) type Name = (u32, i64);

/// What the scheme says of all cells.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub(super) arity: i64,
    pub(super) shift: Rational,
    /// An upper bound of C_0.
    constant: f64,
    /// Upper bounds of T_0, T_1, …, and last of all that follow.
    factors: Vec<f64>,
    /// The points x_{i + first}, …, x_{i + last} determine the curve and all later polygons on cell i.
    first: i64,
    last: i64,
    /// The cells of the next level that have a part of cell i are ni + `parts.0`, …, ni + `parts.1`.
    parts: (i64, i64),
    /// ⌊s⌋ and ⌈s⌉.
    pub(super) shift_between: [i64; 2],
    /// For an open polygon the parameters between which it determines the limit.
    pub(super) range: Option<[Rational; 2]>,
    /// The cells of level 0.
    pub(super) roots: Range<i64>,
    /// The whole numbers from i + s to i + 1 + s are i + `whole.0`, …, i + `whole.1`.
    whole: (i64, i64),
}

impl Shape {
    /// What it says of a closed polygon of so many points, or of an open one.
    pub(super) fn new(limit: &Limit, count: usize, closed: bool) -> Result<Shape, LimitError> {
        let mask = limit.mask();
        let natural = natural_shift(mask);
        if !natural.keeps_lines {
            let reason =
                "the scheme does not take lines to lines, and its curves are too rough for it"
                    .to_owned();
            return Err(LimitError::Sets { reason });
        }
        let (n, s) = (Rational::from(mask.arity()), natural.shift);
        let distances = Distances::shifted(limit, &s)?.with_cells(CONSTANT_CELLS);
        let range = if closed { None } else { Some(determined(mask, &s, count)?) };
        let roots = match &range {
            None => 0..i64::try_from(count).unwrap_or(i64::MAX),
            Some(range) => {
                let [start, end] = range.each_ref().map(|end| end - &s);
                index(&start)..-index(&-end)
            }
        };
        let constant = match distances.constant(0, &Rational::new(1, 1_000)) {
            Ok(distance) => distance.enclosure.upper().clone(),
            Err(LimitError::TooFine { reached, .. }) => reached.upper().clone(),
            Err(error) => return Err(error),
        };
        // Row α has coefficients other than 0 for the points from i + f_α to i + l_α alone.
        let offset = mask.offset();
        let (mut before, mut after) = (Rational::zero(), Rational::zero());
        for (alpha, row) in mask.rules().rows().iter().enumerate() {
            let part = Rational::from(alpha) / &n;
            let used = || (offset..).zip(row).filter(|(_, entry)| !entry.is_zero()).map(|(j, _)| j);
            if let (Some(f), Some(l)) = (used().min(), used().max()) {
                before = before.min(Rational::from(f) - &part);
                after = after.max(Rational::from(l) - &part);
            }
        }
        let one = Rational::one();
        let sum = &n / (&n - &one);
        let least = (&s + &before * &sum).min(Rational::from(-1));
        let most = (&one + &s + &after * &sum).max(Rational::from(2));
        let moved = (&n - &one) * &s;
        let parts = (index(&(&moved - &one)) + 1, -index(&-(&n + &moved)) - 1);
        let known = limit.contraction();
        let mut factors: Vec<f64> = known.iter().map(upper).collect();
        while factors.len() < FACTORS {
            let c = factors.len();
            let product = |i: usize| factors[i] * factors[c - i] * (1.0 + 1e-15);
            let least = (1..c).map(product).fold(f64::INFINITY, f64::min);
            factors.push(least);
        }
        // T_{a + b} ≤ T_aT_b, and some T_c is less than 1: all that follow are less than one before.
        let greatest = factors.iter().copied().fold(1.0, f64::max);
        factors.push(greatest);
        Ok(Shape {
            arity: i64::try_from(mask.arity()).unwrap_or(i64::MAX),
            constant: upper(&constant),
            factors,
            first: -index(&-least),
            last: index(&most),
            parts,
            range,
            roots,
            shift_between: [index(&s), -index(&-&s)],
            whole: (-index(&-&s), index(&(&one + &s))),
            shift: s,
        })
    }

    /// A bound of the norms of all powers of the scheme: 1 + 2C_0(1 + T_k).
    pub(super) fn growth(&self) -> f64 {
        let greatest = self.factors.iter().copied().fold(1.0, f64::max);
        (1.0 + 2.0 * self.constant * (1.0 + greatest)) * (1.0 + 1e-15)
    }

    /// A cell of the level before that has a part of cell i.
    pub(super) fn parent(&self, i: i64) -> i64 {
        (i - self.parts.0).div_euclid(self.arity)
    }

    /// About where a share of cell 0 is among the parameters of a later level, with `scale` of them for each cell.
    pub(super) fn place(&self, share: f64, scale: i64) -> i64 {
        #[expect(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            reason = "about where it is"
        )]
        let place = ((nearest(&self.shift) + share) * scale as f64).floor() as i64;
        place
    }

    fn factor(&self, levels: u32) -> f64 {
        self.factors[(levels as usize).min(self.factors.len() - 1)]
    }
}

/// A piece of the curve and of the polygons.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// The ends of the chord, which is the polygon of the level of the cell.
    pub(super) ends: [Number; 2],
    /// How far the curve is at most from the chord, at equal parameters.
    pub(super) radius: f64,
    /// The part of the chord and the cell that is looked at: all but at the ends of an open polygon.
    pub(super) part: [f64; 2],
}

impl Cell {
    /// Where on the whole chord a share of the part that is looked at is.
    pub(super) fn place(&self, share: f64) -> f64 {
        self.part[0] + share * (self.part[1] - self.part[0])
    }
}

/// All cells of a polygon.
pub(super) struct Cells {
    pub(super) shape: Shape,
    pub(super) points: RefinedPoints,
    clips: Vec<[(i64, f64); 2]>,
    known: HashMap<Name, Cell>,
    /// A bound of rounding in distances.
    rounding: f64,
}

impl Cells {
    /// `size` bounds the absolute coordinates of the control points.
    pub(super) fn new(shape: Shape, points: RefinedPoints, size: f64) -> Cells {
        let dimensions = f64::from(u32::try_from(points.dimensions).unwrap_or(u32::MAX));
        let rounding = 1e-13 * size * dimensions.sqrt();
        let known = HashMap::new();
        let mut cells = Cells { shape, points, clips: Vec::new(), known, rounding };
        if let Some(range) = &cells.shape.range {
            cells.clips = clips(&cells.shape, range, |level| cells.is_numbered(level));
        }
        cells
    }

    /// Forgets all cells and points.
    pub(super) fn forget(&mut self) {
        self.known.clear();
        self.points.forget();
    }

    /// How far distances that were computed may be off.
    pub(super) fn slack(&self) -> f64 {
        4.0 * self.points.slack() + self.rounding
    }

    /// i, or the number of the same cell of a closed polygon in its first turn.
    pub(super) fn named(&self, (level, i): Name) -> Name {
        (level, self.points.wrapped(level, i))
    }

    pub(super) fn cell(&mut self, name: Name) -> Cell {
        let (level, i) = self.named(name);
        if let Some(cell) = self.known.get(&(level, i)) {
            return *cell;
        }
        let ends = [self.points.at(level, i), self.points.at(level, i + 1)];
        let radius = self.shape.constant * self.bend((level, i));
        let cell = Cell { ends, radius, part: self.part((level, i)) };
        self.known.insert((level, i), cell);
        cell
    }

    /// Whether there is such a cell in the range.
    pub(super) fn has(&self, (level, i): Name) -> bool {
        self.clips.get(level as usize).is_none_or(|[begin, end]| (begin.0..=end.0).contains(&i))
    }

    /// The radius of a cell that was asked for before.
    pub(super) fn known_radius(&self, name: Name) -> f64 {
        self.known.get(&self.named(name)).map_or(0.0, |cell| cell.radius)
    }

    /// max |Δ_j − b| over the differences that matter on the cell, with b in their middle: b may be chosen, as lines are kept.
    fn bend(&mut self, (level, i): Name) -> f64 {
        let (first, last) = (i + self.shape.first, i + self.shape.last);
        let numbers: Vec<Number> = (first..=last).map(|j| self.points.at(level, j)).collect();
        let mut square = 0.0_f64;
        let mut differences = Vec::with_capacity(numbers.len());
        for pair in numbers.windows(2) {
            let (x, y) = (self.points.point(pair[0]), self.points.point(pair[1]));
            differences.push(x.iter().zip(y).map(|(x, y)| y - x).collect::<Vec<f64>>());
        }
        let middle: Vec<f64> = (0..self.points.dimensions)
            .map(|j| {
                let of = || differences.iter().map(|difference| difference[j]);
                let (low, high) =
                    (of().fold(f64::INFINITY, f64::min), of().fold(f64::NEG_INFINITY, f64::max));
                0.5 * (low + high)
            })
            .collect();
        for difference in &differences {
            let off = difference.iter().zip(&middle).map(|(x, b)| (x - b) * (x - b));
            square = square.max(off.sum());
        }
        square.sqrt() + 2.0 * self.slack()
    }

    /// How far the polygon of level k is at most from the chord of a cell of level m ≤ k, at equal parameters.
    pub(super) fn polygon_radius(&self, cell: &Cell, levels: u32) -> f64 {
        if levels == 0 { 0.0 } else { cell.radius * (1.0 + self.shape.factor(levels)) }
    }

    /// How far the curve is at most from the polygon so many levels after that of the cell.
    pub(super) fn later_radius(&self, cell: &Cell, levels: u32) -> f64 {
        cell.radius * self.shape.factor(levels)
    }

    /// The cells of the next level that have a part of this one.
    pub(super) fn parts(&self, (level, i): Name) -> impl Iterator<Item = Name> + use<> {
        let Shape { arity, parts: (first, last), .. } = self.shape;
        let (low, high) = (arity * i + first, arity * i + last);
        let (low, high) = match self.clips.get(level as usize + 1) {
            None => (low, high),
            Some([begin, end]) => (low.max(begin.0), high.min(end.0)),
        };
        (low..=high).map(move |j| (level + 1, j))
    }

    /// The part of a cell that is in the range of the parameters.
    fn part(&self, (level, i): Name) -> [f64; 2] {
        let Some([begin, end]) = self.clips.get(level as usize) else { return [0.0, 1.0] };
        [if i == begin.0 { begin.1 } else { 0.0 }, if i == end.0 { end.1 } else { 1.0 }]
    }

    /// Whether the curve is looked at, at the parameter i/n^m.
    pub(super) fn has_limit(&self, (level, i): Name) -> bool {
        let Some([low, high]) = &self.shape.range else { return true };
        let at = Rational::from(i) / Rational::from(self.shape.arity.pow(level));
        *low <= at && at <= *high
    }

    /// The parameters i/n^m on a cell of level m at which the curve is looked at, as numbers i.
    pub(super) fn limits(&self, (level, i): Name) -> impl Iterator<Item = Name> + use<'_> {
        let (first, last) = self.shape.whole;
        (i + first..=i + last).map(move |j| (level, j)).filter(|name| self.has_limit(*name))
    }

    /// Whether cells of this level have numbers.
    pub(super) fn is_numbered(&self, level: u32) -> bool {
        let count =
            self.shape.arity.checked_pow(level).and_then(|n| n.checked_mul(self.points.count));
        count.is_some_and(|count| count < 1 << 50)
    }
}

/// For each level that has numbers the first and the last cell of the range, and where in them it begins and ends.
fn clips(
    shape: &Shape,
    range: &[Rational; 2],
    numbered: impl Fn(u32) -> bool,
) -> Vec<[(i64, f64); 2]> {
    let clip = |level: u32| {
        let scale = Rational::from(shape.arity.pow(level));
        let [low, high] = range.each_ref().map(|end| end * &scale - &shape.shift);
        let (first, last) = (index(&low), -index(&-&high) - 1);
        [
            (first, nearest(&(low - Rational::from(first)))),
            (last, nearest(&(high - Rational::from(last)))),
        ]
    };
    (0..64).take_while(|level| numbered(*level)).map(clip).collect()
}

/// ⌊x⌋.
fn index(x: &Rational) -> i64 {
    x.floor().to_i64().unwrap_or(0)
}
