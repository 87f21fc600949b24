//! The refined points of a control polygon or net, in whole multiples of a small unit with bounds of their errors.

use super::direction::Direction;
use super::point::{Point, bend, length, square};
use super::ratio::{Ratio, capped, less};
use crate::numbers::{Meter, Q, capped as within, int};
use crate::text::DepthChecked as Checked;
use num_integer::Integer as _;
use num_traits::ToPrimitive as _;
use std::collections::HashMap;
use std::rc::Rc;

/// The tolerance is two to the power of this units.
const UNITS: u32 = 36;

/// The greatest coordinate in units.
const MAX_COORDINATE: i64 = (1 << 58) - 1;

/// The most points that are kept; the others are computed anew.
const MAX_KEPT: usize = 1 << 20;

/// The tolerance in units.
pub const TOLERANCE: i128 = 1 << UNITS;

/// A cell of a level in each direction: the parameters from i to i + 1 over n^level.
pub type Cell = [i64; 2];

const LARGE: &str = "how large points are in units of the tolerance";

/// The polygons or nets of all levels.
pub struct Net<'a> {
    pub directions: &'a [Direction],
    shifts: Vec<Ratio>,
    /// The natural parameters that are looked at, in each direction.
    pub ranges: Vec<[Ratio; 2]>,
    meter: &'a Meter,
    dimensions: usize,
    control: Vec<Point>,
    known: HashMap<(u32, [i64; 2]), Point>,
    /// Bounds of the errors of a coordinate, by level.
    errors: Vec<i128>,
    /// C of both directions, and K, over 2^20, rounded upwards.
    distances: Vec<i128>,
    sums: Vec<i128>,
}

fn upwards(x: &Q) -> Checked<i128> {
    let scaled = (x * int(1 << 20)).ceil();
    scaled
        .to_i64()
        .filter(|x| *x < 1 << 40)
        .map_or_else(|| capped("constants of the scheme"), |x| Ok(x.into()))
}

impl<'a> Net<'a> {
    pub fn new(
        directions: &'a [Direction],
        points: &[Vec<Q>],
        tolerance: &Q,
        meter: &'a Meter,
    ) -> Checked<Net<'a>> {
        // Fractions are not reduced, as that takes longer than all of this.
        let coordinate = |(x, origin): (&Q, &Q)| {
            let top = x.numer() * origin.denom() - origin.numer() * x.denom();
            let top = (top << (UNITS + 1)) * tolerance.denom();
            let over = x.denom() * origin.denom() * tolerance.numer();
            let units = (top + &over).div_floor(&(over << 1_u32));
            within(&units, MAX_COORDINATE).map_or_else(|| capped(LARGE), |x| Ok(x.into()))
        };
        let control = points
            .iter()
            .map(|point| point.iter().zip(&points[0]).map(coordinate).collect::<Checked<Point>>())
            .collect::<Checked<Vec<Point>>>()?;
        let ranges = directions.iter().map(|direction| {
            if let Some([from, to]) = &direction.range {
                return Ok([Ratio::of(from)?, Ratio::of(to)?]);
            }
            let whole = |x: i64| Ratio { top: x.into(), bottom: 1 };
            Ok([whole(0), whole(direction.count)])
        });
        let ranges = ranges.collect::<Checked<Vec<[Ratio; 2]>>>()?;
        // Products of two parameters of points have room then.
        let small = |shift: &Q| match Ratio::of(shift)? {
            shift if shift.bottom < 1 << 16 => Ok(shift),
            _ => capped("the natural shift"),
        };
        let of = |of: fn(&Direction) -> &Q| {
            directions.iter().map(|it| upwards(of(it))).collect::<Checked<Vec<i128>>>()
        };
        Ok(Net {
            directions,
            shifts: directions.iter().map(|it| small(&it.shift)).collect::<Checked<_>>()?,
            ranges,
            meter,
            dimensions: points[0].len(),
            control,
            known: HashMap::new(),
            errors: vec![1],
            distances: of(|it| &it.distance)?,
            sums: of(|it| &it.sum)?,
        })
    }

    pub fn count(&self) -> usize {
        self.directions.len()
    }

    /// n^level.
    pub fn unit(&self, which: usize, level: u32) -> Checked<i128> {
        let unit = self.directions[which].arity.checked_pow(level).filter(|unit| *unit < 1 << 42);
        unit.map_or_else(|| capped("the levels of cells"), |unit| Ok(unit.into()))
    }

    /// How far a value of the polygon of a level is at most from what is computed, in the Euclidean norm.
    pub fn slack(&mut self, level: u32) -> Checked<i128> {
        while self.errors.len() <= level as usize {
            let mut error = int(1) * Q::from_integer(self.errors[self.errors.len() - 1].into());
            // As `refined` does it: along the second direction first.
            for direction in self.directions.iter().rev() {
                error = (error * &direction.greatest).ceil() + int(1);
            }
            let error = error.to_i64().filter(|x| *x < 1 << 30);
            let Some(error) = error else { return capped("how errors grow") };
            self.errors.push(error.into());
        }
        // A value is between points, in each direction.
        let dimensions = i128::try_from(self.dimensions).unwrap_or(i128::MAX);
        Ok((self.errors[level as usize] + 2) * dimensions)
    }

    /// Points of the level before with coefficients, over one denominator, and rounded.
    fn combined(&self, terms: &[(i128, Point)], over: i128) -> Checked<Point> {
        self.meter.spend(terms.len() as u64)?;
        let coordinate = |c: usize| {
            let sum: i128 = terms.iter().map(|(factor, point)| factor * point[c]).sum();
            let x = (2 * sum + over).div_euclid(2 * over);
            within(x, MAX_COORDINATE).map_or_else(|| capped(LARGE), |x| Ok(x.into()))
        };
        (0..self.dimensions).map(coordinate).collect()
    }

    /// The control point of an index, in all directions; beyond the ends of an open direction lines go on.
    fn control(&self, index: [i64; 2]) -> Checked<Point> {
        let place = |which: usize| -> Vec<(i64, i128)> {
            let Some(Direction { count, range, .. }) = self.directions.get(which) else {
                return vec![(0, 1)];
            };
            let (i, last) = (index[which], count - 1);
            match i {
                _ if range.is_none() => vec![(i.rem_euclid(*count), 1)],
                _ if last == 0 => vec![(0, 1)],
                ..0 => vec![(0, i128::from(1 - i)), (1, i128::from(i))],
                _ if i > last => {
                    let by = i128::from(i - last);
                    vec![(last, 1 + by), (last - 1, -by)]
                }
                _ => vec![(i, 1)],
            }
        };
        let columns = self.directions.get(1).map_or(1, |it| it.count);
        let (rows, along) = (place(0), place(1));
        let terms =
            rows.iter().flat_map(|(i, x)| along.iter().map(move |(j, y)| (i * columns + j, x * y)));
        let terms: Vec<(i128, Point)> = terms
            .map(|(at, x)| (x, Rc::clone(&self.control[usize::try_from(at).unwrap_or(0)])))
            .collect();
        self.combined(&terms, 1)
    }

    /// The point of a level.
    pub fn point(&mut self, level: u32, index: [i64; 2]) -> Checked<Point> {
        let mut index = index;
        for (which, (index, direction)) in index.iter_mut().zip(self.directions).enumerate() {
            if direction.range.is_none() {
                let all = i128::from(direction.count) * self.unit(which, level)?;
                *index = i64::try_from(i128::from(*index).rem_euclid(all)).unwrap_or(0);
            }
        }
        self.meter.spend(1)?;
        if let Some(point) = self.known.get(&(level, index)) {
            return Ok(Rc::clone(point));
        }
        let point = if level == 0 { self.control(index)? } else { self.refined(level, index)? };
        if self.known.len() >= MAX_KEPT {
            self.known.clear();
        }
        self.known.insert((level, index), Rc::clone(&point));
        Ok(point)
    }

    fn refined(&mut self, level: u32, index: [i64; 2]) -> Checked<Point> {
        let directions = self.directions;
        let rule = |which: usize| {
            let direction = &directions[which];
            let alpha = usize::try_from(index[which].rem_euclid(direction.arity)).unwrap_or(0);
            (index[which].div_euclid(direction.arity), &direction.rules[alpha], direction.over)
        };
        let (row, up, over) = rule(0);
        let mut terms = Vec::with_capacity(up.len());
        for (i, x) in up {
            let point = if directions.len() == 1 {
                self.point(level - 1, [row + i, 0])?
            } else {
                let (column, along, over) = rule(1);
                let mut terms = Vec::with_capacity(along.len());
                for (j, y) in along {
                    terms.push((*y, self.point(level - 1, [row + i, column + j])?));
                }
                self.combined(&terms, over)?
            };
            terms.push((*x, point));
        }
        self.combined(&terms, over)
    }

    /// The value of the polygon of a level, linear between its points in each direction, at natural parameters.
    pub fn at(&mut self, level: u32, parameters: &[Ratio]) -> Checked<Point> {
        let mut places = [(0_i64, 0_i128, 1_i128); 2];
        for which in 0..self.count() {
            let unit = self.unit(which, level)?;
            let u = parameters[which].times_plus(unit, -1, self.shifts[which])?;
            let low = u.floor();
            places[which] = (low, u.top - i128::from(low) * u.bottom, u.bottom);
        }
        let [(i, s, of), (j, t, over)] = places;
        let mut sides = Vec::with_capacity(2);
        for (row, weight) in [(i, of - s), (i + 1, s)] {
            if weight == 0 {
                continue;
            }
            let first = self.point(level, [row, j])?;
            let side = if t == 0 {
                first
            } else {
                let second = self.point(level, [row, j + 1])?;
                self.combined(&[(over - t, first), (t, second)], over)?
            };
            sides.push((weight, side));
        }
        self.combined(&sides, of)
    }

    /// The parameters of a cell that are looked at, in one direction, cut at those between which a polygon of `net`
    /// is linear; empty where there are none.
    pub fn nodes(&self, which: usize, level: u32, index: i64, net: u32) -> Checked<Vec<Ratio>> {
        let unit = self.unit(which, level)?;
        let [from, to] = self.ranges[which];
        let low = Ratio { top: index.into(), bottom: unit };
        let high = Ratio { top: i128::from(index) + 1, bottom: unit };
        let (low, high) =
            (if less(low, from) { from } else { low }, if less(to, high) { to } else { high });
        if !less(low, high) {
            return Ok(Vec::new());
        }
        let mut all = vec![low];
        // Point i of the net is at (i + s)/n^net.
        let (shift, fine) = (self.shifts[which], self.unit(which, net)?);
        let mut i = i128::from(low.times_plus(fine, -1, shift)?.floor()) + 1;
        loop {
            // (i + s)/n^net
            let whole = Ratio { top: i, bottom: 1 }.times_plus(1, 1, shift)?;
            let node = Ratio { top: whole.top, bottom: fine * whole.bottom };
            if !less(node, high) {
                break;
            }
            if less(low, node) {
                all.push(node);
            }
            i += 1;
        }
        all.push(high);
        Ok(all)
    }

    /// The nodes of some nets on a cell, in both directions.
    fn grid(&self, level: u32, cell: Cell, nets: &[u32]) -> Checked<Vec<[Ratio; 2]>> {
        let mut nodes = [(); 2].map(|()| vec![Ratio { top: 0, bottom: 1 }]);
        for which in 0..self.count() {
            let of = nets.iter().map(|net| self.nodes(which, level, cell[which], *net));
            nodes[which] = of.collect::<Checked<Vec<_>>>()?.concat();
            nodes[which].sort_by(|x, y| less(*y, *x).cmp(&less(*x, *y)));
            nodes[which].dedup();
        }
        let [rows, columns] = &nodes;
        Ok(rows.iter().flat_map(|row| columns.iter().map(|column| [*row, *column])).collect())
    }

    /// The greatest distance of the polygon of a level from that of `net` at equal parameters, on a cell of the level:
    /// the difference is linear, in each direction, between the nodes of both.
    pub fn apart(&mut self, level: u32, cell: Cell, net: u32) -> Checked<i128> {
        let mut greatest = 0;
        for at in self.grid(level, cell, &[level, net])? {
            let [own, other] = [level, net].map(|net| self.at(net, &at));
            greatest = greatest.max(square(&own?, &other?));
        }
        Ok(length(greatest))
    }

    /// All values of the polygon of `net` on a cell are in the hull of these.
    pub fn hull(&mut self, level: u32, cell: Cell, net: u32) -> Checked<Vec<Point>> {
        self.grid(level, cell, &[net])?.into_iter().map(|at| self.at(net, &at)).collect()
    }

    /// How far the limit, and all later polygons, are at most from the polygon of the level on a cell (167).
    pub fn radius(&mut self, level: u32, cell: Cell) -> Checked<i128> {
        let windows: Vec<[i64; 2]> = self
            .directions
            .iter()
            .zip(cell)
            .map(|(it, i)| [i + it.window[0], i + it.window[1]])
            .collect();
        let slack = 2 * self.slack(level)?;
        let mut all = 0;
        for which in 0..self.count() {
            let other = windows.get(1 - which).copied().filter(|_| self.count() == 2);
            let mut greatest = 0;
            for across in other.map_or(0..=0, |[first, last]| first..=last) {
                let mut points = Vec::new();
                for i in windows[which][0]..=windows[which][1] {
                    let index = if which == 0 { [i, across] } else { [across, i] };
                    points.push(self.point(level, index)?);
                }
                greatest = greatest.max(bend(&points) + slack);
            }
            let mut radius = greatest * self.distances[which] / (1 << 20) + 1;
            if self.count() == 2 {
                radius = radius * self.sums[1 - which] / (1 << 20) + 1;
            }
            all += radius;
        }
        Ok(all)
    }
}
