//! Witnesses: control data, and a place where a quantity of theirs is looked at.

use crate::certificate::Block;
use crate::convolution::classes;
use crate::decimal::{Q, int, read_rational};
use crate::evaluate::Scope;
use crate::functional::{Functional, Rules, product};
use crate::functions::greatest;
use crate::paper::Paper;
use crate::reject::{Checked, Reason, Rejection, Stop, require};
use crate::ring::Ring;
use crate::scheme::{Library, Scheme};
use crate::value::Value;
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

/// Whether T_c < 1 for some n^c ≤ 4096, for each of these schemes.
pub fn converge(scope: &Scope<'_>, schemes: &[Rc<Scheme>]) -> Result<bool, Stop> {
    for scheme in schemes {
        let blocks = (1..).take_while(|c| scheme.arity().saturating_pow(*c) <= MAX_CLASSES);
        let constant =
            |c: u32| greatest(scope, &classes(scope, scheme, "b", false, &Value::int(c.into()))?);
        let mut contracts = blocks.map(|c| Ok(constant(c)?.compare(&Value::int(1))?.is_lt()));
        // Up to the first block that contracts, or a cap.
        if !contracts.find(|found| *found != Ok(false)).unwrap_or(Ok(false))? {
            return Ok(false);
        }
    }
    Ok(true)
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
    pub line: usize,
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
        let control = if let Some(said) = block.maybe("ring") {
            let points = integers(said).ok_or(Reason::Malformed("ring INTEGER…"))?;
            let weights = block.maybe("weights").unwrap_or_default().split_whitespace();
            let weights = weights.map(|word| paper.number(word));
            Control::Ring(points, weights.collect::<Checked<_>>()?)
        } else if let Some(said) = block.maybe("net") {
            let line = block.at;
            let first = integers(said).and_then(|first| first.iter().map(index).collect());
            let first = first.and_then(|first: Vec<i64>| first.try_into().ok());
            let mut rows: Vec<Option<Vec<BigInt>>> = Vec::new();
            while let Some(said) = block.maybe("row") {
                rows.push(integers(said));
            }
            let rows: Option<Vec<Vec<BigInt>>> = rows.into_iter().collect();
            let proper = |rows: &Vec<Vec<BigInt>>| {
                rows.first().is_some_and(|first| !first.is_empty())
                    && rows.iter().all(|row| row.len() == rows[0].len())
            };
            let malformed = Reason::Malformed("net FIRST FIRST, and its rows");
            let net = first.zip(rows.filter(proper)).map(|(first, rows)| Control::Net(first, rows));
            net.ok_or(Rejection::from(malformed).at(line))?
        } else {
            let mut polygons = vec![polygon(block.after("polygon")?)?];
            while let Some(next) = block.maybe("polygon") {
                polygons.push(polygon(next)?);
            }
            Control::Polygons(polygons)
        };
        let place = block.after("at")?.split_whitespace().collect();
        Ok(Witness { line: block.at, control, place })
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
            _ => return Err(self.reject(Reason::Malformed("data of such a scheme"))),
        };
        Ok(spreads.into_iter().map(Q::from_integer).collect())
    }

    /// A rejection at the line of the place.
    fn reject(&self, reason: Reason) -> Rejection {
        Rejection::from(reason).at(self.line)
    }

    /// The value of a quantity at a level, at the place. Of `distance`, the scheme is one that
    /// converges.
    pub fn value(&self, setting: &Setting<'_>, quantity: &str, level: u32) -> Checked<Value> {
        let value = match (&self.control, setting) {
            (Control::Ring(points, weights), Setting::Ring(ring, earlier)) => {
                self.of_ring((points, weights), (ring, earlier.as_ref()), quantity, level)
            }
            (_, Setting::Masks(rules)) => self
                .functionals(rules, quantity, level)
                .map(|[f, g]| Value::from(self.of(&f) - self.of(&g))),
            _ => Err(Reason::Malformed("data of such a scheme").into()),
        };
        let value = value.and_then(|value| Ok(value.abs(None)?));
        value.map_err(|rejection| rejection.at(self.line))
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
            require(proper && along, Reason::Malformed("indices, and of a net 1 or 2"))?;
            let side = |step: i64| {
                let point = |(k, (rules, i)): (usize, (&Rules<'_>, &Q))| {
                    let i = if k == axis { i + int(step) } else { i.clone() };
                    rules.at(level, &i)
                };
                rules.iter().zip(at).enumerate().map(point).collect::<Result<Vec<_>, Stop>>()
            };
            return Ok([side(1)?, side(0)?]);
        }
        require(numbers.len() == rules.len(), Reason::Malformed("a number for each index"))?;
        let [mut new, mut old] = [Vec::new(), Vec::new()];
        for (rules, at) in rules.iter().zip(&numbers) {
            if quantity == "step" {
                require(at.is_integer(), Reason::Malformed("an index of a point"))?;
                new.push(rules.at(level + 1, at)?);
                old.push(rules.at(level, &(at / int(rules.arity())))?);
            } else {
                new.push(rules.limit(at)?.ok_or(Reason::Malformed("an n-adic number"))?);
                old.push(rules.polygon(level, at)?);
            }
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
        let named = |name: &str| ring.names.iter().position(|known| known == name);
        let place: Option<Vec<usize>> = self.place.iter().map(|name| named(name)).collect();
        let place = place.unwrap_or_default();
        let control: Vec<Value> =
            points.iter().map(|x| Value::from(Q::from_integer(x.clone()))).collect();
        let refine = |points: Vec<Value>, _| ring.refined(&points);
        let refined = (0..level).try_fold(control.clone(), refine)?;
        match (quantity, &place[..]) {
            ("difference", &[a, b]) if ring.has_edge(a, b) => Ok(refined[a].minus(&refined[b])?),
            ("step", &[a]) => {
                let next = ring.refined(&refined)?;
                let old = earlier.map(|earlier| earlier.refined(&refined)).transpose()?;
                Ok(next[a].minus(&old.unwrap_or(refined)[a])?)
            }
            ("distance", &[a]) => {
                // Around a vertex only what the interpolant keeps has its limit there.
                require(earlier.is_none_or(|earlier| earlier.keeps(a)), Reason::NoLimit)?;
                require(ring.is_limit(weights)?, Reason::Weights)?;
                let mut terms = weights.iter().zip(&control);
                let less = |off: Value, (weight, x): (&Value, &Value)| off.minus(&weight.times(x)?);
                Ok(terms.try_fold(refined[a].clone(), less)?)
            }
            _ => Err(Reason::Malformed("a point, or an edge").into()),
        }
    }
}

fn polygon(said: &str) -> Checked<Polygon> {
    let numbers = integers(said).filter(|numbers| numbers.len() > 1);
    let read = numbers.and_then(|numbers| {
        Some(Polygon { first: index(&numbers[0])?, points: numbers[1..].to_vec() })
    });
    Ok(read.ok_or(Reason::Malformed("polygon FIRST INTEGER…"))?)
}
