//! Witnesses: control data, and the place at which a quantity is evaluated.

use super::functional::{Functional, Rules, product};
use super::polygon::{Polygon, index, integers, place, spread};
use super::setting::Setting;
use crate::claims::Paper;
use crate::numbers::{Q, Value, int, read_rational};
use crate::schemes::LocalRules;
use crate::text::{Block, Checked, Reason, Stop, compare, require, words};
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// Control data. All are integers.
enum Control {
    /// A polygon, or the polygons a and b of the net x_{i,j} = a_i + b_j.
    Polygons(Vec<Polygon>),
    /// The indices of the first point of a net, and the rows of the net. Every other point equals
    /// the nearest one of these.
    Net([i64; 2], Vec<Vec<BigInt>>),
    /// A ring, and the weights of its limit.
    LocalRules(Vec<BigInt>, Vec<Value>),
}

/// The parameters of the points of a level.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Points {
    /// x^k_i at i/n^k.
    Indexed,
    /// x^k_i at (i + s)/n^k, where the masks take lines to lines.
    Natural,
}

/// Control data and a place.
pub struct Witness<'l> {
    control: Control,
    place: Vec<&'l str>,
}

fn malformed<T>(expected: &'static str) -> Checked<T> {
    Err(Reason::Malformed(expected).into())
}

impl<'l> Witness<'l> {
    /// Reads `polygon …`, `net …` with its rows or `ring …`, and `at …`.
    pub fn read(paper: &Paper<'_>, block: &mut Block<'l>) -> Checked<Witness<'l>> {
        let control = if let Some(said) = block.maybe("ring") {
            let points = integers(said).ok_or(Reason::Malformed("ring INTEGER…"))?;
            let weights = paper.numbers(block.maybe("weights").unwrap_or_default())?;
            Control::LocalRules(points, weights)
        } else if let Some(said) = block.maybe("net") {
            let first: Option<Vec<i64>> =
                integers(said).unwrap_or_default().iter().map(index).collect();
            let Some(&[i, j]) = first.as_deref() else { return malformed("net FIRST FIRST") };
            let mut rows = Vec::<Vec<BigInt>>::new();
            while let Some(said) = block.maybe("row") {
                let row = integers(said).filter(|row| !row.is_empty());
                let row = row.ok_or(Reason::Malformed("row INTEGER…"))?;
                let even = rows.first().is_none_or(|first| first.len() == row.len());
                require(even, Reason::Malformed("rows of equal length"))?;
                rows.push(row);
            }
            require(!rows.is_empty(), Reason::Malformed("the rows of a net"))?;
            Control::Net([i, j], rows)
        } else {
            let mut polygons = vec![Polygon::read(block.after("polygon")?)?];
            while let Some(said) = block.maybe("polygon") {
                polygons.push(Polygon::read(said)?);
            }
            Control::Polygons(polygons)
        };
        Ok(Witness { control, place: block.after("at")?.split_whitespace().collect() })
    }

    /// The largest differences of neighbouring points along each index, or along the edges.
    pub fn spreads(&self, setting: &Setting<'_>) -> Checked<Vec<Q>> {
        let spreads = match (&self.control, setting) {
            (Control::Polygons(polygons), Setting::Masks(rules, _))
                if polygons.len() == rules.len() =>
            {
                polygons.iter().map(Polygon::spread).collect()
            }
            (Control::Net(_, rows), Setting::Masks(rules, _)) if rules.len() == 2 => {
                let down = rows.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
                let along = rows.iter().flat_map(|row| row.windows(2));
                vec![
                    spread(down.map(|(a, b)| [a, b])),
                    spread(along.map(|pair| [&pair[0], &pair[1]])),
                ]
            }
            (Control::LocalRules(points, _), Setting::LocalRules(ring, _))
                if points.len() == ring.names.len() =>
            {
                vec![spread(ring.edges.iter().map(|&[a, b]| [&points[a], &points[b]]))]
            }
            _ => return malformed("data of such a scheme"),
        };
        Ok(spreads.into_iter().map(Q::from_integer).collect())
    }

    /// The value of a quantity of the data at a level and at the place.
    pub fn value(
        &self,
        setting: &Setting<'_>,
        quantity: &str,
        (level, at): (u32, Points),
    ) -> Checked<Value> {
        let off = match (&self.control, setting) {
            (Control::LocalRules(points, weights), Setting::LocalRules(ring, earlier)) => {
                require(at == Points::Indexed, Reason::Malformed("masks"))?;
                self.of_ring((points, weights), (ring, earlier.as_deref()), quantity, level)?
            }
            (_, Setting::Masks(rules, converge)) => {
                require(quantity != "distance" || *converge, Reason::NoLimit)?;
                let [f, g] = self.functionals(rules, quantity, (level, at))?;
                Value::from(self.of(&f) - self.of(&g))
            }
            _ => return malformed("data of such a scheme"),
        };
        Ok(off.abs(None)?)
    }

    /// The value of a product of functionals, one for each index.
    fn of(&self, functionals: &[Functional]) -> Q {
        let x = |i: i64, j: i64| match &self.control {
            Control::Polygons(polygons) => {
                polygons.iter().zip([i, j]).map(|(polygon, i)| polygon.at(i)).sum()
            }
            Control::Net(first, rows) => {
                let row = &rows[place(i, first[0], rows.len())];
                row[place(j, first[1], row.len())].clone()
            }
            Control::LocalRules(..) => BigInt::zero(),
        };
        match functionals {
            [f, g] => product(f, g, x),
            [f] => product(f, &Functional::unit(), x),
            _ => Q::zero(),
        }
    }

    /// Two products of functionals. The quantity is the absolute value of their difference.
    fn functionals(
        &self,
        rules: &[Rules<'_>],
        quantity: &str,
        (level, points): (u32, Points),
    ) -> Checked<[Vec<Functional>; 2]> {
        let numbers: Option<Vec<Q>> = self.place.iter().map(|word| read_rational(word)).collect();
        let numbers = numbers.unwrap_or_default();
        let whole = quantity == "distance" || numbers.iter().all(Q::is_integer);
        // For a difference of a net, the last number names the index along which it is taken.
        let along = quantity == "difference" && rules.len() == 2;
        let (places, axis) = numbers.split_at(rules.len().min(numbers.len()));
        if !whole || places.len() != rules.len() || axis.len() != usize::from(along) {
            return malformed("a place");
        }
        let one = int(1);
        let axis = axis.first().unwrap_or(&one);
        require([int(1), int(2)].contains(axis), Reason::Malformed("1 or 2, for an index"))?;
        let [mut new, mut old] = [Vec::new(), Vec::new()];
        for (rules, (place, at)) in rules.iter().zip([int(1), int(2)].iter().zip(&numbers)) {
            let arity = int(rules.arity());
            let shift = match points {
                Points::Indexed => Q::zero(),
                Points::Natural => rules.natural_shift().ok_or(Reason::NoLines)?,
            };
            let (after, before) = match quantity {
                "difference" if place == axis => {
                    (rules.at(level, &(at + Q::one()))?, rules.at(level, at)?)
                }
                "difference" => (rules.at(level, at)?, rules.at(level, at)?),
                "step" => {
                    let before = (at + &shift) / arity - &shift;
                    let next = level.checked_add(1).ok_or(Stop::Capped("the level"))?;
                    (rules.at(next, at)?, rules.at(level, &before)?)
                }
                "distance" => {
                    let limit = rules.limit(at)?.ok_or(Reason::Malformed("an n-adic number"))?;
                    (limit, rules.polygon(level, at, &shift)?)
                }
                _ => return malformed("a theorem about a bound"),
            };
            new.push(after);
            old.push(before);
        }
        Ok([new, old])
    }

    /// The value of a quantity of a ring. The ring is refined for it.
    fn of_ring(
        &self,
        (points, weights): (&[BigInt], &[Value]),
        (ring, earlier): (&LocalRules<'_>, Option<&LocalRules<'_>>),
        quantity: &str,
        level: u32,
    ) -> Checked<Value> {
        let named = |name: &&str| ring.names.iter().position(|known| known == name);
        let place: Option<Vec<usize>> = self.place.iter().map(named).collect();
        let integer = |x: &BigInt| Value::from(Q::from_integer(x.clone()));
        let control: Vec<Value> = points.iter().map(integer).collect();
        let refined = (0..level).try_fold(control.clone(), |points, _| ring.refined(&points))?;
        let off = match (quantity, &place.unwrap_or_default()[..]) {
            ("difference", &[a, b]) if ring.has_edge(a, b) => refined[a].minus(&refined[b]),
            ("step", &[a]) => {
                let old = match earlier {
                    Some(earlier) => earlier.refined(&refined)?,
                    None => refined.clone(),
                };
                ring.refined(&refined)?[a].minus(&old[a])
            }
            ("distance", &[a]) => {
                // Only the points that the interpolant keeps have the limit of the ring.
                let kept = earlier.is_none_or(|earlier| earlier.keeps(a));
                require(kept && ring.contracts()?, Reason::NoLimit)?;
                require(ring.is_limit(weights)?, Reason::Weights)?;
                weights
                    .iter()
                    .zip(&control)
                    .try_fold(refined[a].clone(), |off, (weight, x)| off.minus(&weight.times(x)?))
            }
            _ => return malformed("a point, or an edge"),
        };
        Ok(off?)
    }
}

/// Checks that these are the two sides, and that the first one is larger.
pub fn violated(paper: &Paper<'_>, said: &str, left: &Value, right: &Value) -> Checked<()> {
    let said: [&str; 2] = words(said, "two sides")?;
    for (said, side) in said.into_iter().zip([left, right]) {
        let said = paper.number(said)?;
        compare(said.equals(side)?, &said, side, Reason::Value)?;
    }
    compare(left.compare(right)?.is_gt(), left, right, Reason::NotViolated)
}
