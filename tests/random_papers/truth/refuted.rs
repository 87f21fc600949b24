//! Witnesses, recomputed.

use super::{names, shift, supposed};
use crate::random_papers::draft::{Bound, Draft, Instance, Shape};
use crate::random_papers::naive::{Curve, LocalRules, Net, Q, Row, int};
use crate::random_papers::program::Block;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The data of a block, and the place where they are looked at.
#[derive(Debug)]
pub struct Witness {
    pub level: u32,
    first: [i64; 2],
    /// The points of a polygon are one row, and those of a ring too.
    rows: Vec<Vec<i64>>,
    place: Vec<String>,
    /// Whether the points of a level are at their natural parameters.
    natural: bool,
}

/// How many levels later than a witness its limit is approached, at most.
const MAX_LATER: u32 = 24;

fn integers(text: &str) -> Option<Vec<i64>> {
    text.split_whitespace().map(|word| word.parse().ok()).collect()
}

impl Witness {
    pub fn read(block: &Block, natural: bool) -> Option<Witness> {
        let level = block.after("level")?.parse().ok()?;
        let place = block.after("at")?.split_whitespace().map(str::to_owned).collect();
        let all = |word: &str| -> Option<Vec<Vec<i64>>> {
            let lines = block.lines();
            lines.iter().filter_map(|line| line.strip_prefix(word)).map(integers).collect()
        };
        let (first, rows) = match &all("polygon ")?[..] {
            [polygon] => ([polygon[0], 0], vec![polygon[1..].to_vec()]),
            [one, other] => {
                let row = |x: &i64| other[1..].iter().map(|y| x + y).collect();
                ([one[0], other[0]], one[1..].iter().map(row).collect())
            }
            _ => match all("net ")?.first() {
                Some(first) => ([first[0], first[1]], all("row ")?),
                None => ([0, 0], all("ring ")?),
            },
        };
        Some(Witness { level, first, rows, place, natural })
    }

    /// The polygons of a block, at no place.
    fn read_polygons(block: &Block) -> Option<Witness> {
        let level = block.after("level")?.parse().ok()?;
        let polygons = shift::polygons(block)?;
        let points: Vec<Vec<i64>> = polygons.iter().map(|row| row[1..].to_vec()).collect();
        Some(Witness::of_polygons(level, &points, Vec::new()))
    }

    /// Polygons, one for each index: of a net their sums.
    pub fn of_polygons(level: u32, polygons: &[Vec<i64>], place: Vec<String>) -> Witness {
        let rows = match polygons {
            [one, other] => one.iter().map(|x| other.iter().map(|y| x + y).collect()).collect(),
            one => one.to_vec(),
        };
        Witness { level, first: [0, 0], rows, place, natural: false }
    }

    /// The spreads, along each index.
    pub fn spreads(&self, shape: &Shape) -> Vec<Q> {
        let greatest = |pairs: Vec<(i64, i64)>| {
            int(pairs.into_iter().map(|(a, b)| (a - b).abs()).max().unwrap_or(0))
        };
        let along = self.rows.iter().flat_map(|row| row.windows(2).map(|two| (two[0], two[1])));
        match shape {
            Shape::Curve(_) => vec![greatest(along.collect())],
            Shape::Net(_) => {
                let down = self.rows.windows(2);
                let down = down.flat_map(|two| two[0].iter().copied().zip(two[1].iter().copied()));
                vec![greatest(down.collect()), greatest(along.collect())]
            }
            Shape::LocalRules(ring, _) => vec![int(ring.spread(&self.rows[0]))],
        }
    }

    /// The quantity, and how far from it the exact one may be.
    pub fn value(&self, bound: &Bound, shape: &Shape, much: &Q) -> Result<(Q, Q), String> {
        match shape {
            Shape::Curve(curve) => self.of_masks(bound, &[curve.with_offset(bound.offset)], much),
            Shape::Net(Net(pair)) => {
                let pair = pair.each_ref().map(|curve| curve.with_offset(bound.offset));
                self.of_masks(bound, &pair, much)
            }
            Shape::LocalRules(ring, earlier) => self.of_ring(bound, ring, earlier.as_ref(), much),
        }
    }

    fn of_masks(&self, bound: &Bound, curves: &[Curve], much: &Q) -> Result<(Q, Q), String> {
        let difference = bound.quantity == "difference";
        let axis = (difference && curves.len() == 2).then(|| self.place.last().cloned()).flatten();
        let step = bound.quantity == "step";
        let place = |at: usize| -> Result<(i64, u32), String> {
            let text = self.place.get(at).ok_or("the place is short: ")?;
            let t: Q = text.parse().map_err(|_| "the place is no number: ")?;
            let arity = Q::from_integer(curves[at].arity().into());
            let finer = (0..40).find(|m| (&t * num_traits::pow(arity.clone(), *m)).is_integer());
            let finer = finer.ok_or("the place is not n-adic: ")?;
            let i = (t * num_traits::pow(arity, finer)).to_integer().to_i64();
            Ok((i.ok_or("the place is far away: ")?, u32::try_from(finer).expect("small")))
        };
        // The functionals of the data at a later level, and at the level of the witness.
        let rows = |later: u32| -> Result<[Vec<Row>; 2], String> {
            let (mut new, mut old) = (Vec::new(), Vec::new());
            for (at, curve) in curves.iter().enumerate() {
                let (i, finer) = place(at)?;
                let shift = if self.natural { curve.natural_shift() } else { Some(Q::zero()) };
                let shift = shift.ok_or("lines are not kept: ")?;
                let n = int(curve.arity());
                let own = axis.as_ref().is_none_or(|axis| *axis == (at + 1).to_string());
                let level = self.level;
                new.push(match bound.quantity {
                    "difference" => curve.row(level, i + i64::from(own)),
                    "step" => curve.row(level + 1, i),
                    _ => curve.at(later, i, finer),
                });
                old.push(match bound.quantity {
                    "difference" => curve.row(level, i),
                    "step" => curve.between(level, &((int(i) + &shift) / n - &shift)),
                    _ => {
                        let t = int(i) / num_traits::pow(n.clone(), finer as usize);
                        curve.between(level, &(t * num_traits::pow(n, level as usize) - shift))
                    }
                });
            }
            Ok([new, old])
        };
        let of = |rows: &[Row]| match rows {
            [one] => Curve::of(one, self.first[0], &self.rows[0]),
            [one, other] => Net::of(&[one.clone(), other.clone()], self.first, &self.rows),
            _ => Q::zero(),
        };
        let apart = |later: u32| -> Result<Q, String> {
            let [new, old] = rows(later)?;
            Ok((of(&new) - of(&old)).abs())
        };
        if difference || step {
            return Ok((apart(0)?, Q::zero()));
        }
        let spread = if let [_, _] = curves {
            self.spreads(&Shape::Net(Net([curves[0].clone(), curves[1].clone()])))
        } else {
            self.spreads(&Shape::Curve(curves[0].clone()))
        };
        let spread = spread.into_iter().max().unwrap_or_default();
        let remainder = |later: u32| match curves {
            [one] => one.remainder(later),
            [one, other] => Net([one.clone(), other.clone()]).remainder(later),
            _ => None,
        };
        let mut later = self.level;
        loop {
            let rest = remainder(later).ok_or("no limit is near: ")? * &spread;
            if rest < *much || later == self.level + MAX_LATER {
                return Ok((apart(later)?, rest));
            }
            later += 2;
        }
    }

    fn of_ring(
        &self,
        bound: &Bound,
        ring: &LocalRules,
        earlier: Option<&LocalRules>,
        much: &Q,
    ) -> Result<(Q, Q), String> {
        let points = &self.rows[0];
        if points.len() != ring.names.len() {
            return Err("the ring has other points: ".to_owned());
        }
        let places: Option<Vec<usize>> = self.place.iter().map(|name| ring.place(name)).collect();
        let earlier = match earlier {
            None => None,
            Some(earlier) => {
                Some(earlier.ordered_as(ring).ok_or("the interpolant has other points: ")?)
            }
        };
        let value = match (bound.quantity, &places.unwrap_or_default()[..]) {
            ("difference", &[a, b])
                if ring.edges.contains(&(a, b)) || ring.edges.contains(&(b, a)) =>
            {
                let rows = ring.rows(self.level);
                LocalRules::of(&LocalRules::less(&rows[a], &rows[b]), points)
            }
            ("step", &[a]) => LocalRules::of(&ring.steps(self.level, earlier.as_ref())[a], points),
            ("distance", &[a]) => {
                let own =
                    |row: &[Q]| row[a].is_one() && row.iter().filter(|x| !x.is_zero()).count() == 1;
                if earlier.is_some_and(|earlier| !own(&earlier.weights[a])) {
                    return Err("the interpolant does not keep the point: ".to_owned());
                }
                let spread = int(ring.spread(points));
                let heights = ring.heights();
                let mut later = self.level;
                loop {
                    let rest =
                        ring.remainder(later, &heights).ok_or("no limit is near: ")? * &spread;
                    if rest < *much || later == self.level + 4 * MAX_LATER {
                        let limit = LocalRules::of(&ring.rows(later)[a], points);
                        let value = LocalRules::of(&ring.rows(self.level)[a], points) - limit;
                        return Ok((value.abs(), rest));
                    }
                    later += 4;
                }
            }
            _ => return Err("the place is none: ".to_owned()),
        };
        Ok((value.abs(), Q::zero()))
    }
}

/// The sides of the witness are those of the bound, and the first one is larger; also with the points
/// at their natural parameters, if the block says so.
pub fn violates(draft: &Draft, bound: &Bound, block: &Block) -> Result<(), String> {
    block.parts().iter().try_for_each(|(place, part)| one_violates(draft, bound, part, place))
}

fn one_violates(draft: &Draft, bound: &Bound, block: &Block, place: &str) -> Result<(), String> {
    let everywhere = place == "in-every-shift";
    let witness = if everywhere {
        Witness::read_polygons(block)
    } else {
        Witness::read(block, place == "naturally")
    };
    let witness = witness.ok_or("its witness is not read: ")?;
    let lets: Vec<(&str, Q)> = block
        .lines()
        .iter()
        .filter_map(|line| line.strip_prefix("let ")?.split_once(' '))
        .map(|(name, value)| (name, value.parse().expect("a value")))
        .collect();
    let reference = block.after("scheme").unwrap_or_default();
    let fits = |instance: &&Instance| {
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        words(&instance.reference) == words(reference)
            && instance.values.len() == lets.len()
            && instance.values.iter().all(|(name, value)| lets.contains(&(name, value.clone())))
    };
    let instance =
        bound.instances.iter().find(fits).ok_or("it is about none of its instances: ")?;
    if !supposed(draft, bound, instance) {
        return Err("what is supposed does not hold: ".to_owned());
    }
    let said: Vec<Q> = block
        .after("sides")
        .unwrap_or_default()
        .split_whitespace()
        .map(|text| text.parse().map_err(|_| format!("a side is no number: {text}")))
        .collect::<Result<_, String>>()?;
    let [left, right] = &said[..] else { return Err("there are no two sides: ".to_owned()) };
    if left <= right || right.is_negative() || witness.level < bound.from {
        return Err(format!("the sides are {left} and {right}: "));
    }
    let spreads = witness.spreads(&instance.shape);
    let level = int(witness.level.into());
    if bound.quantity == "depth" {
        let tolerance: Q =
            block.after("tolerance").and_then(|text| text.parse().ok()).unwrap_or_default();
        let by = names(draft, instance, &spreads, ("epsilon", tolerance.clone())).value(&bound.by);
        if tolerance != *right || by.as_ref().is_none_or(|by| *by > level) {
            return Err(format!("its level is not deep enough: {by:?}"));
        }
    } else {
        let by = names(draft, instance, &spreads, ("k", level)).value(&bound.by);
        if by.as_ref() != Some(right) {
            let by = by.map_or("nothing".to_owned(), |by| by.to_string());
            return Err(format!("the bound is another one: {by}, not {right}"));
        }
    }
    if everywhere {
        let polygons = shift::polygons(block).ok_or("there are no polygons: ")?;
        return shift::apart(bound, &instance.shape, witness.level, &polygons, block, left);
    }
    let (value, rest) = witness.value(bound, &instance.shape, &((left - right) / int(2)))?;
    if (&value - left).abs() > rest {
        return Err(format!("the quantity is another one: {value} up to {rest}, not {left}"));
    }
    if rest < (left - right) / int(2) && value - rest <= *right {
        return Err("the bound is not violated: ".to_owned());
    }
    Ok(())
}
