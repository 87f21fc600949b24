//! Refinement of whole nets.

use super::error::NetError;
use super::grid::Net;
use super::scheme::NetScheme;
use crate::exact::{CommonDenominator, Integer, Rational};
use crate::limit::{Window, natural_shift, rule_at};
use crate::mesh::MAX_POINTS;
use crate::scheme::{Mask, Rules};

/// The most levels of refinement.
pub const MAX_NET_LEVEL: u32 = 24;

/// The net of a later level:
/// x'_{ni+α, mj+β} = Σ_{r,s} a_{α,r} b_{β,s} x_{i+o+r, j+p+s}.
///
/// In a closed direction indices are taken modulo its size. In an open one the net of the next level
/// has the points that some piece of the surface depends on, with all whose points the net has.
///
/// # Errors
/// When an open direction has too few points for a piece of the surface, too many points would arise,
/// or the level is above [`MAX_NET_LEVEL`].
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, NetScheme, refine_net};
///
/// let point = |k: i64| [k % 4, k / 4, 0].map(Rational::from);
/// let net = Net::new((0..16).map(point).collect(), 4, Closed::default())?;
/// let refined = refine_net(&net, &NetScheme::parse("bicubic")?, 1)?;
/// // From the middle of the first two points to that of the last two.
/// assert_eq!(refined.sizes(), [5, 5]);
/// assert_eq!(refined.points()[0], [Rational::new(1, 2), Rational::new(1, 2), Rational::zero()]);
/// # Ok::<(), subcert::net::NetError>(())
/// ```
pub fn refine_net(net: &Net, scheme: &NetScheme, level: u32) -> Result<Net, NetError> {
    if level > MAX_NET_LEVEL {
        return Err(NetError::Level { level, most: MAX_NET_LEVEL });
    }
    let closed = net.closed().both();
    let mut lines = Vec::with_capacity(2);
    let directions = scheme.masks().iter().zip(net.sizes()).zip(closed);
    for (direction, ((mask, size), closed)) in directions.enumerate() {
        lines.push(Line::new(mask, direction, size, closed)?);
    }
    let mut sizes = net.sizes();
    for _ in 0..level {
        sizes = [0, 1].map(|direction| lines[direction].next(sizes[direction]));
        let points = sizes[0].saturating_mul(sizes[1]);
        if points > MAX_POINTS {
            return Err(NetError::TooManyPoints(points));
        }
    }
    let coordinates: Vec<Vec<Rational>> =
        (0..3).map(|c| net.points().iter().map(|point| point[c].clone()).collect()).collect();
    let refined = coordinates.iter().map(|values| refined(values, net.sizes(), &lines, level));
    let [x, y, z]: [Vec<Rational>; 3] = refined.collect::<Vec<_>>().try_into().unwrap_or_default();
    let points = x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect();
    Net::new(points, sizes[1], net.closed())
}

/// One coordinate of the points, refined.
fn refined(values: &[Rational], sizes: [usize; 2], lines: &[Line], level: u32) -> Vec<Rational> {
    let CommonDenominator { mut numerators, mut denominator } =
        CommonDenominator::of(&[values.to_vec()]);
    let (mut grid, mut columns) = (numerators.pop().unwrap_or_default(), sizes[1]);
    for _ in 0..level {
        for line in lines.iter().rev() {
            // Along the rows of the grid, which is then turned.
            let rows = grid.len() / columns;
            let along: Vec<Vec<Integer>> =
                grid.chunks(columns).map(|row| line.refine(row)).collect();
            columns = rows;
            let length = along.first().map_or(0, Vec::len);
            grid = (0..length).flat_map(|j| along.iter().map(move |row| row[j].clone())).collect();
            denominator *= &line.rules.denominator;
        }
    }
    grid.into_iter().map(|value| Rational::new(value, denominator.clone())).collect()
}

/// How the points of one direction are refined.
struct Line {
    window: Window,
    closed: bool,
    arity: usize,
    /// The rules of points of the next level, each with the index of the first point and the
    /// numerators: of an open line all in the windows of the parts of cell 0, of a closed one those
    /// with the numbers 0, …, n − 1.
    parts: Vec<(i64, Vec<Integer>)>,
    rules: CommonDenominator,
}

impl Line {
    fn new(mask: &Mask, direction: usize, count: usize, closed: bool) -> Result<Line, NetError> {
        let window = Window::of(mask, &natural_shift(mask).shift)?;
        if window.cells(count, closed) == 0 {
            return Err(NetError::TooFew { direction, found: count, needed: window.size() });
        }
        let rules = CommonDenominator::of(mask.rules().rows());
        let arity = mask.arity();
        let part = |row: i64| part(mask.rules(), &rules, row);
        let own = i64::try_from(arity).unwrap_or(i64::MAX);
        let rows = if closed { 0..own } else { window.first..window.last + own };
        let parts = rows.map(part).collect();
        Ok(Line { window, closed, arity, parts, rules })
    }

    /// How many points the next level has.
    fn next(&self, count: usize) -> usize {
        let parts = self.arity.saturating_mul(self.window.cells(count, self.closed));
        if self.closed { parts } else { parts.saturating_add(self.window.size() - 1) }
    }

    /// The points of the next level, times the common denominator of the rules.
    fn refine(&self, points: &[Integer]) -> Vec<Integer> {
        let count = i64::try_from(points.len()).unwrap_or(i64::MAX);
        let at = |index: i64| {
            let index = if self.closed { index.rem_euclid(count) } else { index };
            &points[usize::try_from(index).unwrap_or(usize::MAX)]
        };
        let combination = |cell: i64, (first, row): &(i64, Vec<Integer>)| {
            (cell + first..).zip(row).fold(Integer::zero(), |mut sum, (index, entry)| {
                if entry.sign() != 0 {
                    sum += &(entry * at(index));
                }
                sum
            })
        };
        let first = self.window.first_cell(self.closed);
        let cells = self.window.cells(points.len(), self.closed);
        let mut refined = Vec::with_capacity(self.next(points.len()));
        // Of each cell the first n points; those after them are of the next cell, but for the last one
        // of an open line.
        for cell in (first..).take(cells) {
            let own = self.parts.iter().take(self.arity);
            refined.extend(own.map(|part| combination(cell, part)));
        }
        if let (false, Some(last)) = (self.closed, i64::try_from(cells).ok()) {
            let rest = self.parts.iter().skip(self.arity);
            refined.extend(rest.map(|part| combination(first + last - 1, part)));
        }
        refined
    }
}

/// Row `row` of the operator, for cell 0.
fn part(rules: &Rules, common: &CommonDenominator, row: i64) -> (i64, Vec<Integer>) {
    let arity = i64::try_from(rules.arity()).unwrap_or(i64::MAX);
    let first = rule_at(rules, row).next().map_or(0, |(index, _)| index);
    let rule = usize::try_from(row.rem_euclid(arity)).unwrap_or(0);
    (first, common.numerators[rule].clone())
}
