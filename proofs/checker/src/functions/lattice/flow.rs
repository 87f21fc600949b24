//! The least cost of flows along edges.

#![warn(clippy::arithmetic_side_effects)]

use super::distances::Distances;
use crate::numbers::Meter;
use crate::schemes::{Vector, plus};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};

/// The most pairs of a source and a sink.
const MAX_PAIRS: usize = 1 << 22;

/// A functional of data, by ascending places. No weight is 0.
pub(super) type Functional = Vec<(Vector, BigInt)>;

/// The least Σ|flow| of flows along edges that carry a functional f of sum 0 out of each point.
///
/// It is the least cost of transports from the points x with positive weights to the points y with negative ones, for the distances in
/// all of Z^d as costs. A transport is a flow along shortest ways, wherever they lead. No flow costs less: by duality there are
/// prices p(x) and p(y) with p(y) − p(x) at most the distance of x and y, and −Σ f p the least cost. Let q be at each point of Z^d the least of
/// the p(x) + its distance from x. Then q(x) ≤ p(x) and q(y) ≥ p(y), so that −Σ f q is at least the least cost. q changes by at
/// most 1 along an edge, also if it is cut where it is beyond its values at the x and y. So each flow costs at least |Σ f q|.
pub(super) fn cost(
    meter: &Meter,
    distances: &mut Distances<'_>,
    functional: &Functional,
) -> Result<BigInt, Stop> {
    let (sources, sinks): (Vec<_>, Vec<_>) =
        functional.iter().partition(|(_, weight)| weight.is_positive());
    if sources.len().saturating_mul(sinks.len()) > MAX_PAIRS {
        return Err(Stop::Capped("the points of a functional"));
    }
    let mut costs = Vec::with_capacity(sources.len());
    for (from, _) in &sources {
        meter.spend((sinks.len() as u64 / 8).saturating_add(1))?;
        let to = sinks.iter().map(|(to, _)| distances.of(plus(*to, -1, *from)?));
        costs.push(to.collect::<Result<Vec<i64>, Stop>>()?);
    }
    let amounts = |points: &[&(_, BigInt)]| points.iter().map(|(_, it)| it.abs()).collect();
    let flow = sources.iter().map(|_| vec![BigInt::zero(); sinks.len()]).collect();
    let prices = [vec![0; sources.len()], vec![0; sinks.len()]];
    let mut plan = Plan { costs, rest: [amounts(&sources), amounts(&sinks)], flow, prices };
    while plan.rest[0].iter().any(BigInt::is_positive) {
        let size = sources.len().saturating_add(sinks.len()) as u64;
        meter.spend((size.saturating_mul(size) / 64).saturating_add(1))?;
        plan.improve()?;
    }
    let pairs = plan.costs.iter().flatten().zip(plan.flow.iter().flatten());
    Ok(pairs.map(|(cost, amount)| amount * cost).sum())
}

/// A transport from sources to sinks. The points are those of two sides: the sources, and the sinks.
struct Plan {
    /// The costs from each source to each sink.
    costs: Vec<Vec<i64>>,
    /// What is left at the points.
    rest: [Vec<BigInt>; 2],
    /// What is carried.
    flow: Vec<Vec<BigInt>>,
    /// Prices of the points: a cost is at least the price of the sink less that of the source, and equal to it where something is carried.
    prices: [Vec<i64>; 2],
}

/// A point: its side, and its number there.
type Point = (usize, usize);

/// A point that is reached: what the way costs beyond the prices, the point before it, and whether no way is shorter.
#[derive(Clone, Copy)]
struct Reached {
    cost: i64,
    before: Option<Point>,
    settled: bool,
}

/// What is reached on each side.
type Ways = [Vec<Option<Reached>>; 2];

impl Plan {
    /// Carries something more, along a shortest way from a source with a rest to a sink with a rest; it leads forwards from sources to sinks,
    /// and back where something is carried. The way begins or ends where nothing is left then, or something is carried back entirely.
    /// The prices are raised by what the ways cost, up to the cost of this one, so that they fit the new transport (Edmonds and Karp).
    fn improve(&mut self) -> Result<(), Stop> {
        let (reached, last) = self.shortest()?;
        let cost = |(side, i): Point| reached[side][i].map_or(i64::MAX, |found| found.cost);
        let most = cost(last);
        let (mut way, mut at) = (vec![last], last);
        while let Some(before) = reached[at.0][at.1].and_then(|found| found.before) {
            way.push(before);
            at = before;
        }
        // From the sink to the source, steps from sinks to sources are forwards.
        let mut amount = (&self.rest[1][last.1]).min(&self.rest[0][at.1]).clone();
        for pair in way.windows(2) {
            if let [(0, source), (_, sink)] = *pair {
                amount = amount.min(self.flow[source][sink].clone());
            }
        }
        self.rest[1][last.1] -= &amount;
        self.rest[0][at.1] -= &amount;
        for pair in way.windows(2) {
            match *pair {
                [(0, source), (_, sink)] => self.flow[source][sink] -= &amount,
                [(_, sink), (_, source)] => self.flow[source][sink] += &amount,
                _ => {}
            }
        }
        for (side, prices) in self.prices.iter_mut().enumerate() {
            for (i, price) in prices.iter_mut().enumerate() {
                *price = price.saturating_add(cost((side, i)).min(most));
            }
        }
        Ok(())
    }

    /// The ways of least cost from the sources with a rest, up to the first sink with one (Dijkstra).
    fn shortest(&self) -> Result<(Ways, Point), Stop> {
        let start = |rest: &BigInt| {
            rest.is_positive().then_some(Reached { cost: 0, before: None, settled: false })
        };
        let sources: Vec<Option<Reached>> = self.rest[0].iter().map(start).collect();
        let mut reached = [sources, vec![None; self.rest[1].len()]];
        loop {
            let mut best: Option<(i64, Point)> = None;
            for (side, points) in reached.iter().enumerate() {
                for (i, found) in points.iter().enumerate() {
                    if let Some(Reached { cost, settled: false, .. }) = found
                        && best.is_none_or(|(least, _)| *cost < least)
                    {
                        best = Some((*cost, (side, i)));
                    }
                }
            }
            let Some((least, at @ (side, i))) = best else {
                return Err(Stop::Wrong("the weights of a functional do not sum to 0".to_owned()));
            };
            if side == 1 && self.rest[1][i].is_positive() {
                return Ok((reached, at));
            }
            if let Some(found) = &mut reached[side][i] {
                found.settled = true;
            }
            for (j, known) in reached[1_usize.saturating_sub(side)].iter_mut().enumerate() {
                let (source, sink) = if side == 0 { (i, j) } else { (j, i) };
                let step = self.costs[source][sink]
                    .saturating_add(self.prices[0][source])
                    .saturating_sub(self.prices[1][sink]);
                // Where something is carried, the way back costs nothing beyond the prices.
                let open = side == 0 || self.flow[source][sink].is_positive();
                let cost = least.saturating_add(if side == 0 { step } else { 0 });
                if open && known.is_none_or(|known| cost < known.cost) {
                    *known = Some(Reached { cost, before: Some(at), settled: false });
                }
            }
        }
    }
}
