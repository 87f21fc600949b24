//! Whether all of one set is near the other: each piece is in a ball around a point of the other set (THEOREMS.md, 167).

use super::net::{Cell, Net, TOLERANCE};
use super::point::{Point, length, square};
use super::ratio::{Ratio, less};
use crate::numbers::Meter;
use crate::text::{DepthChecked as Checked, Stop};

/// How many levels beyond that of the polygon cells are divided.
const MORE_LEVELS: u32 = 14;

/// How many levels beyond that of the polygon equal parameters are compared.
const MORE_BY_PARAMETER: u32 = 4;

/// How many levels beyond that of a piece points of the limit are taken from.
const MORE_DIGITS: u32 = 4;

/// How many halvings of a step a search for a near point takes.
const HALVINGS: u32 = 7;

/// One of the two sets.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Set {
    Limit,
    Polygon,
}

/// A piece that is to be in a ball.
struct Piece {
    of: Set,
    level: u32,
    cell: Cell,
    /// Parameters at which the other set was near what this is a part of.
    hint: Vec<Ratio>,
}

/// The cells of level 0.
pub fn roots(net: &Net) -> Vec<Cell> {
    let range = |which: usize| match net.ranges.get(which) {
        None => 0..1,
        Some([from, to]) => {
            let floor = |x: &Ratio| x.top.div_euclid(x.bottom);
            let last = -(-to.top).div_euclid(to.bottom);
            let cut = |x: i128| i64::try_from(x).unwrap_or(0);
            cut(floor(from))..cut(last)
        }
    };
    range(0).flat_map(|i| range(1).map(move |j| [i, j])).collect()
}

/// The parts of a cell.
pub fn parts(net: &Net, cell: Cell) -> Vec<Cell> {
    let of = |which: usize| match net.directions.get(which) {
        None => 0..1,
        Some(direction) => cell[which] * direction.arity..(cell[which] + 1) * direction.arity,
    };
    of(0).flat_map(|i| of(1).map(move |j| [i, j])).collect()
}

/// Whether a cell has something of the range.
pub fn is_inside(net: &Net, level: u32, cell: Cell) -> Checked<bool> {
    for (which, index) in cell.into_iter().enumerate().take(net.count()) {
        if net.nodes(which, level, index, 0)?.is_empty() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Checks that the limit and the polygon of a level are within the tolerance as sets.
pub fn check(net: &mut Net, level: u32, meter: &Meter) -> Checked<()> {
    let mut stack: Vec<(u32, Cell)> = roots(net).into_iter().map(|cell| (0, cell)).collect();
    while let Some((own, cell)) = stack.pop() {
        meter.spend(8)?;
        if !is_inside(net, own, cell)? {
            continue;
        }
        // At equal parameters: the limit, and before its own level the polygon, are so near to the polygon of this level.
        let slack = net.slack(own)? + net.slack(level)?;
        let radius = net.radius(own, cell)?;
        let apart = if own <= level { 0 } else { net.apart(own, cell, level)? };
        let factor = if own < level { 2 } else { 1 };
        if apart + factor * radius + slack <= TOLERANCE {
            continue;
        }
        if own < level || own < level + MORE_BY_PARAMETER && apart <= TOLERANCE + radius {
            stack.extend(parts(net, cell).into_iter().map(|cell| (own + 1, cell)));
            continue;
        }
        for of in [Set::Limit, Set::Polygon] {
            cover(net, level, Piece { of, level: own, cell, hint: Vec::new() }, meter)?;
        }
    }
    Ok(())
}

/// Checks that a piece is near the other set.
fn cover(net: &mut Net, level: u32, piece: Piece, meter: &Meter) -> Checked<()> {
    let mut stack = vec![piece];
    while let Some(Piece { of, level: own, cell, hint }) = stack.pop() {
        meter.spend(8)?;
        if !is_inside(net, own, cell)? {
            continue;
        }
        let (hull, radius) = match of {
            Set::Limit => (net.hull(own, cell, own)?, net.radius(own, cell)? + net.slack(own)?),
            Set::Polygon => (net.hull(own, cell, level)?, net.slack(level)?),
        };
        let mut middle = Vec::with_capacity(2);
        for (which, index) in cell.into_iter().enumerate().take(net.count()) {
            let nodes = net.nodes(which, own, index, 0)?;
            let sum = nodes[0].times_plus(1, 1, nodes[nodes.len() - 1])?;
            middle.push(Ratio { top: sum.top, bottom: 2 * sum.bottom });
        }
        let mut near = Near { net, of, level, own, hull: &hull };
        let mut starts = vec![middle];
        if !hint.is_empty() {
            starts.push(hint);
        }
        let (best, distance, more) = near.search(starts)?;
        if distance.is_some_and(|distance| distance + radius + more <= TOLERANCE) {
            continue;
        }
        if own >= level + MORE_LEVELS {
            return Err(Stop::Undecided("whether this level is enough").into());
        }
        let next = parts(net, cell);
        stack.extend(next.into_iter().map(|cell| Piece {
            of,
            level: own + 1,
            cell,
            hint: best.clone(),
        }));
    }
    Ok(())
}

/// The search for a point of the other set that is near all of a hull.
struct Near<'n, 'a, 'h> {
    net: &'n mut Net<'a>,
    of: Set,
    level: u32,
    own: u32,
    hull: &'h [Point],
}

impl Near<'_, '_, '_> {
    /// The level whose polygon is taken for the other set.
    fn other(&self) -> u32 {
        if self.of == Set::Limit { self.level } else { self.own + MORE_DIGITS }
    }

    /// The square of the greatest distance of a point of the hull from the other set at parameters.
    fn square(&mut self, at: &[Ratio]) -> Checked<i128> {
        let point = self.net.at(self.other(), at)?;
        Ok(self.hull.iter().map(|x| square(x, &point)).max().unwrap_or(0))
    }

    /// Parameters in the range that are near in a step along one direction.
    fn moved(&self, at: &[Ratio], which: usize, step: Ratio) -> Checked<Vec<Ratio>> {
        let mut at = at.to_vec();
        let new = at[which].times_plus(1, 1, step)?;
        let [from, to] = self.net.ranges[which];
        at[which] = match () {
            () if self.net.directions[which].range.is_none() => new,
            () if less(new, from) => from,
            () if less(to, new) => to,
            () => new,
        };
        Ok(at)
    }

    /// The best parameters that were found, the distance there, and how far the point may be off.
    fn search(&mut self, starts: Vec<Vec<Ratio>>) -> Checked<(Vec<Ratio>, Option<i128>, i128)> {
        let mut best: Option<(i128, Vec<Ratio>)> = None;
        for start in starts {
            let square = self.square(&start)?;
            if best.as_ref().is_none_or(|(least, _)| square < *least) {
                best = Some((square, start));
            }
        }
        let Some((mut least, mut at)) = best else { return Ok((Vec::new(), None, 0)) };
        let mut halved = 0;
        while halved < HALVINGS {
            let mut better = false;
            for which in 0..self.net.count() {
                for sign in [1, -1] {
                    let bottom = self.net.unit(which, self.level)? << halved;
                    let new = self.moved(&at, which, Ratio { top: sign, bottom })?;
                    let square = self.square(&new)?;
                    if square < least {
                        (least, at, better) = (square, new, true);
                    }
                }
            }
            if !better {
                halved += 1;
            }
        }
        let other = self.other();
        let mut more = self.net.slack(other)?;
        if self.of == Set::Polygon {
            let cell = cell(self.net, &at, other)?;
            more += self.net.radius(other, cell)?;
        }
        Ok((at, Some(length(least)), more))
    }
}

/// The cell of a level that has these parameters.
pub fn cell(net: &Net, at: &[Ratio], level: u32) -> Checked<Cell> {
    let mut cell = [0; 2];
    for (which, Ratio { top, bottom }) in at.iter().enumerate() {
        let index = (top * net.unit(which, level)?).div_euclid(*bottom);
        cell[which] = i64::try_from(index).unwrap_or(0);
    }
    Ok(cell)
}
