//! Witnesses: control data, and a place where a quantity of theirs is looked at.

use crate::certificate::{Block, Line};
use crate::convolution::classes;
use crate::decimal::{Q, int, read_rational};
use crate::evaluate::Scope;
use crate::functional::{Functional, Rules, product};
use crate::functions::greatest;
use crate::paper::Paper;
use crate::reject::{Checked, Reason};
use crate::ring::Ring;
use crate::scheme::{Library, Scheme};
use crate::value::{Stop, Value};
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::rc::Rc;

/// The most residue classes of a constant that shows convergence.
const MAX_CLASSES: usize = 1 << 12;

/// What control data are refined by.
pub enum Setting<'a> {
    /// One mask, or one for each index of a net.
    Masks(Vec<Rules<'a>>),
    /// A ring, and what makes of the points of one level those that the next is compared with.
    Ring(Ring<'a>, Option<Ring<'a>>),
}

impl<'a> Setting<'a> {
    /// The masks of a scheme, at this offset or at their own; `None` if they are not rational.
    pub fn masks(
        library: &'a Library<'a>,
        schemes: &[Rc<Scheme>],
        offset: Option<i64>,
    ) -> Option<Setting<'a>> {
        let rules =
            |scheme: &Rc<Scheme>| Rules::new(library, scheme, offset.unwrap_or(scheme.offset));
        schemes.iter().map(rules).collect::<Option<Vec<Rules>>>().map(Setting::Masks)
    }
}

/// Whether T_c < 1 for some n^c ≤ 4096.
pub fn converges(scope: &Scope<'_>, scheme: &Scheme) -> Result<bool, Stop> {
    for c in 1.. {
        if scheme.arity().saturating_pow(c) > MAX_CLASSES {
            break;
        }
        let sums = classes(scope, scheme, "b", false, &Value::int(c.into()))?;
        let above = greatest(scope, &sums)?.plus(-1, &Value::int(1))?.sign(None)?;
        if above < 0 {
            return Ok(true);
        }
    }
    Ok(false)
}

/// x_i, i = first, first + 1, …; constant beyond both ends.
struct Polygon {
    first: i64,
    points: Vec<BigInt>,
}

impl Polygon {
    fn at(&self, i: i64) -> &BigInt {
        &self.points[place(i, self.first, self.points.len())]
    }

    fn spread(&self) -> BigInt {
        spread(self.points.windows(2).map(|pair| [&pair[0], &pair[1]]))
    }
}

/// The place of an index in a list that begins with the index `first`; the nearest one there is.
fn place(i: i64, first: i64, count: usize) -> usize {
    usize::try_from(i - first).unwrap_or(0).min(count - 1)
}

fn spread<'x>(pairs: impl Iterator<Item = [&'x BigInt; 2]>) -> BigInt {
    pairs.map(|[a, b]| (b - a).abs()).max().unwrap_or_default()
}

/// Integers.
enum Control {
    /// A polygon; or two, a and b, for the net x_{i,j} = a_i + b_j.
    Polygons(Vec<Polygon>),
    /// A net, row by row, and the indices of its first point; every other point is where the
    /// nearest one of these is.
    Net([i64; 2], Vec<Vec<BigInt>>),
    /// A ring, and the weights of its limit.
    Ring(Vec<BigInt>, Vec<Value>),
}

/// Control data with a place.
pub struct Witness<'l> {
    /// The line of the place.
    pub line: Line<'l>,
    control: Control,
    place: Vec<&'l str>,
}

fn integers(text: &str) -> Option<Vec<BigInt>> {
    let integer = |word| read_rational(word).filter(Q::is_integer).map(|value| value.to_integer());
    text.split_whitespace().map(integer).collect()
}

fn index(value: &BigInt) -> Option<i64> {
    value.to_i64().filter(|index| index.abs() <= 1_000_000)
}

impl<'l> Witness<'l> {
    /// Reads `polygon …`, `net …` with its rows or `ring …`, and `at …`.
    pub fn read(paper: &Paper<'_>, block: &mut Block<'l>) -> Checked<Witness<'l>> {
        let control = if let Some((line, said)) = block.optional("ring") {
            let malformed = || line.reject(Reason::Malformed("ring INTEGER…"));
            let points = integers(said).ok_or_else(malformed)?;
            let mut weights = Vec::new();
            if let Some((line, said)) = block.optional("weights") {
                for word in said.split_whitespace() {
                    weights.push(paper.closed(line, word)?);
                }
            }
            Control::Ring(points, weights)
        } else if let Some((line, said)) = block.optional("net") {
            let malformed = || line.reject(Reason::Malformed("net FIRST FIRST, and its rows"));
            let first: Option<Vec<i64>> =
                integers(said).and_then(|first| first.iter().map(index).collect());
            let first: Option<[i64; 2]> = first.and_then(|first| first.try_into().ok());
            let (first, mut rows) = (first.ok_or_else(malformed)?, Vec::<Vec<BigInt>>::new());
            while let Some((_, said)) = block.optional("row") {
                rows.push(integers(said).ok_or_else(malformed)?);
            }
            let width = rows.first().map_or(0, Vec::len);
            if width == 0 || rows.iter().any(|row| row.len() != width) {
                return Err(malformed());
            }
            Control::Net(first, rows)
        } else {
            let mut polygons = vec![polygon(block.take("polygon")?)?];
            while let Some(next) = block.optional("polygon") {
                polygons.push(polygon(next)?);
            }
            Control::Polygons(polygons)
        };
        let (line, said) = block.take("at")?;
        Ok(Witness { line, control, place: said.split_whitespace().collect() })
    }

    /// The largest differences of neighbouring points: along each index, or along the edges.
    pub fn spreads(&self, setting: &Setting<'_>) -> Checked<Vec<Q>> {
        let spreads = match (&self.control, setting) {
            (Control::Polygons(polygons), Setting::Masks(rules))
                if polygons.len() == rules.len() =>
            {
                polygons.iter().map(Polygon::spread).collect()
            }
            (Control::Net(_, rows), Setting::Masks(rules)) if rules.len() == 2 => {
                let down = rows.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
                let along = rows.iter().flat_map(|row| row.windows(2));
                vec![
                    spread(down.map(|(a, b)| [a, b])),
                    spread(along.map(|pair| [&pair[0], &pair[1]])),
                ]
            }
            (Control::Ring(points, _), Setting::Ring(ring, _))
                if points.len() == ring.names.len() =>
            {
                vec![spread(ring.edges.iter().map(|&[a, b]| [&points[a], &points[b]]))]
            }
            _ => return Err(self.line.reject(Reason::Malformed("data of such a scheme"))),
        };
        Ok(spreads.into_iter().map(Q::from_integer).collect())
    }

    /// The value of a quantity at a level, at the place. Of `distance`, the scheme is one that
    /// converges.
    pub fn value(&self, setting: &Setting<'_>, quantity: &str, level: u32) -> Checked<Value> {
        let value = match (&self.control, setting) {
            (Control::Ring(points, weights), Setting::Ring(ring, earlier)) => {
                self.of_ring((points, weights), (ring, earlier.as_ref()), quantity, level)?
            }
            (_, Setting::Masks(rules)) => {
                let [f, g] = self.functionals(rules, quantity, level)?;
                Value::from(self.of(&f) - self.of(&g))
            }
            _ => return Err(self.line.reject(Reason::Malformed("data of such a scheme"))),
        };
        value.abs(None).map_err(|stop| self.line.reject(Reason::Stopped(stop)))
    }

    /// A product of functionals, one for each index, of the data.
    fn of(&self, functionals: &[Functional]) -> Q {
        let x = |i: i64, j: i64| match &self.control {
            Control::Polygons(polygons) => {
                polygons.iter().zip([i, j]).map(|(polygon, i)| polygon.at(i)).sum()
            }
            Control::Net(first, rows) => {
                let row = &rows[place(i, first[0], rows.len())];
                row[place(j, first[1], row.len())].clone()
            }
            Control::Ring(..) => BigInt::zero(),
        };
        match functionals {
            [f, g] => product(f, g, x),
            [f] => product(f, &Functional::unit(), x),
            _ => Q::zero(),
        }
    }

    /// The products of functionals of which a quantity is the difference.
    fn functionals(
        &self,
        rules: &[Rules<'_>],
        quantity: &str,
        level: u32,
    ) -> Checked<[Vec<Functional>; 2]> {
        let stopped = |stop| self.line.reject(Reason::Stopped(stop));
        let expected = |what| self.line.reject(Reason::Malformed(what));
        let numbers: Option<Vec<Q>> = self.place.iter().map(|word| read_rational(word)).collect();
        let numbers = numbers.unwrap_or_default();
        if quantity == "difference" {
            // Of a net, the last number says along which index.
            let (axis, at) = match (rules.len(), &numbers[..]) {
                (1, at) => (0, at),
                (_, [at @ .., axis]) => (usize::from(!axis.is_one()), at),
                (_, []) => (0, &[][..]),
            };
            let proper = at.len() == rules.len() && numbers.iter().all(Q::is_integer);
            let along = numbers.get(2).is_none_or(|along| [int(1), int(2)].contains(along));
            if !proper || !along {
                return Err(expected("indices, and of a net 1 or 2"));
            }
            let side = |step: i64| {
                let point = |(k, (rules, i)): (usize, (&Rules<'_>, &Q))| {
                    let i = if k == axis { i + int(step) } else { i.clone() };
                    rules.at(level, &i)
                };
                rules.iter().zip(at).enumerate().map(point).collect::<Result<Vec<_>, Stop>>()
            };
            return Ok([side(1).map_err(stopped)?, side(0).map_err(stopped)?]);
        }
        if numbers.len() != rules.len() {
            return Err(expected("a number for each index"));
        }
        let [mut new, mut old] = [Vec::new(), Vec::new()];
        for (rules, at) in rules.iter().zip(&numbers) {
            let (after, before) = if quantity == "step" {
                if !at.is_integer() {
                    return Err(expected("an index of a point"));
                }
                (rules.at(level + 1, at), rules.at(level, &(at / int(rules.arity()))))
            } else {
                let limit = rules.limit(at).map_err(stopped)?;
                let limit = limit.ok_or_else(|| expected("an n-adic number"));
                (Ok(limit?), rules.polygon(level, at))
            };
            new.push(after.map_err(stopped)?);
            old.push(before.map_err(stopped)?);
        }
        Ok([new, old])
    }

    /// The same of a ring, by refining it.
    fn of_ring(
        &self,
        (points, weights): (&[BigInt], &[Value]),
        (ring, earlier): (&Ring<'_>, Option<&Ring<'_>>),
        quantity: &str,
        level: u32,
    ) -> Checked<Value> {
        let stopped = |stop| self.line.reject(Reason::Stopped(stop));
        let named = |name: &str| ring.names.iter().position(|known| known == name);
        let place: Option<Vec<usize>> = self.place.iter().map(|name| named(name)).collect();
        let place = place.unwrap_or_default();
        let control: Vec<Value> =
            points.iter().map(|x| Value::from(Q::from_integer(x.clone()))).collect();
        let mut refined = control.clone();
        for _ in 0..level {
            refined = ring.refined(&refined).map_err(stopped)?;
        }
        let off = match (quantity, &place[..]) {
            ("difference", &[a, b]) if ring.has_edge(a, b) => refined[a].plus(-1, &refined[b]),
            ("step", &[a]) => {
                let next = ring.refined(&refined).map_err(stopped)?;
                let old = earlier.map_or(Ok(refined.clone()), |earlier| earlier.refined(&refined));
                next[a].plus(-1, &old.map_err(stopped)?[a])
            }
            ("distance", &[a]) => {
                // Around a vertex only what the interpolant keeps has its limit there.
                let keeps = |earlier: &Ring<'_>| earlier.keeps(a);
                if !earlier.map_or(Ok(true), keeps).map_err(stopped)? {
                    return Err(self.line.reject(Reason::NoLimit));
                }
                if !ring.is_limit(weights).map_err(stopped)? {
                    return Err(self.line.reject(Reason::Weights));
                }
                weights.iter().zip(&control).try_fold(refined[a].clone(), |off, (weight, x)| {
                    off.plus(-1, &weight.times(x)?)
                })
            }
            _ => return Err(self.line.reject(Reason::Malformed("a point, or an edge"))),
        };
        off.map_err(stopped)
    }
}

fn polygon((line, said): (Line<'_>, &str)) -> Checked<Polygon> {
    let numbers = integers(said).filter(|numbers| numbers.len() > 1);
    let read = numbers.and_then(|numbers| {
        Some(Polygon { first: index(&numbers[0])?, points: numbers[1..].to_vec() })
    });
    read.ok_or_else(|| line.reject(Reason::Malformed("polygon FIRST INTEGER…")))
}
