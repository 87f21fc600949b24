//! The linear maps of one direction: refinement, limits, the polygon.

use super::super::number::{Row, index};
use super::polynomial::{bezier, over};
use crate::exact::{Rational, Scalar};
use crate::limit::{Limit, LimitError, Window};
use crate::net::NetError;
use crate::scheme::Mask;

/// The most phases: parts of a cell at which a node of the polygon can be.
const MAX_PHASES: usize = 80;

/// The maps of one direction, over the points of a window.
#[derive(Clone, Debug)]
pub(crate) struct Rules<S> {
    /// The points of the next level in the windows of all parts.
    pub(super) refined: Vec<Row<S>>,
    /// Phase 0 has no node of the polygon inside the cell.
    pub(super) phases: Vec<Phase<S>>,
    /// The phase of the cells of the level of the polygon.
    pub(super) start: usize,
    /// The polygon of the level of the cell, at the nodes of that phase.
    pub(super) polygon: Vec<Row<S>>,
    /// The Bézier coefficients of the limit, where it is a polynomial.
    pub(super) bezier: Option<Vec<Row<S>>>,
    /// The Bézier coefficients of a linear function with these values at 0 and 1.
    pub(super) raised: Vec<Row<S>>,
    /// The q-th differences.
    pub(super) differences: Vec<Row<S>>,
}

/// The cells with a node of the polygon at a part of them, or with none.
#[derive(Clone, Debug)]
pub(super) struct Phase<S> {
    /// 0, 1 and the node between them, in order.
    pub(super) nodes: Vec<Rational>,
    /// The limit at these.
    pub(super) limits: Vec<Row<S>>,
    /// For each part its phase, and the polygon at its nodes by that at these.
    pub(super) parts: Vec<(usize, Vec<Row<S>>)>,
}

impl<S> Rules<S> {
    /// The same in another arithmetic.
    pub(super) fn map<T>(&self, map: impl Fn(&S) -> T + Copy) -> Rules<T> {
        let row = |row: &Row<S>| row.iter().map(|(at, x)| (*at, map(x))).collect::<Row<T>>();
        let rows = |rows: &Vec<Row<S>>| rows.iter().map(row).collect::<Vec<Row<T>>>();
        let phase = |phase: &Phase<S>| Phase {
            nodes: phase.nodes.clone(),
            limits: rows(&phase.limits),
            parts: phase.parts.iter().map(|(next, values)| (*next, rows(values))).collect(),
        };
        Rules {
            refined: rows(&self.refined),
            phases: self.phases.iter().map(phase).collect(),
            start: self.start,
            polygon: rows(&self.polygon),
            bezier: self.bezier.as_ref().map(rows),
            raised: rows(&self.raised),
            differences: rows(&self.differences),
        }
    }
}

impl Rules<Rational> {
    pub(super) fn of(
        limit: &Limit,
        shift: &Rational,
        window: Window,
        order: usize,
    ) -> Result<Rules<Rational>, NetError> {
        let mask = limit.mask();
        let rows = window.first..window.last + i64::try_from(mask.arity()).unwrap_or(i64::MAX);
        let refined = rows.map(|row| refined_row(mask, row, window)).collect();
        let (phases, start) = phases(limit, shift, window)?;
        let polygon =
            phases[start].nodes.iter().map(|t| on_polygon(&(t - shift), window)).collect();
        let bezier = bezier(limit, window)?;
        let bezier: Option<Vec<Row<Rational>>> =
            bezier.map(|rows| rows.into_iter().map(sparse).collect());
        let degree = bezier.as_ref().map_or(1, |rows| rows.len() - 1);
        let raise = |i: usize| {
            let t = Rational::new(i, degree);
            sparse(vec![Rational::one() - &t, t])
        };
        let raised = (0..=degree).map(raise).collect();
        let pattern: &[i64] = if order == 2 { &[1, -2, 1] } else { &[-1, 1] };
        let difference = |at: usize| {
            (at..).zip(pattern).map(|(at, x)| (index(at), Rational::from(*x))).collect()
        };
        let differences = (0..(window.size() + 1).saturating_sub(pattern.len())).map(difference);
        let differences = differences.collect();
        Ok(Rules { refined, phases, start, polygon, bezier, raised, differences })
    }
}

/// Without zeros.
fn sparse(row: Vec<Rational>) -> Row<Rational> {
    (0..).zip(row).filter(|(_, x)| !x.is_zero()).collect()
}

/// Point `row` of the next level.
fn refined_row(mask: &Mask, row: i64, window: Window) -> Row<Rational> {
    let point = crate::limit::Functional::point(row);
    sparse(over(&point.after(mask.rules()), window))
}

/// The value at index u of the polygon of the points.
fn on_polygon(u: &Rational, window: Window) -> Row<Rational> {
    let part = u.fract();
    let first = u.floor().to_i64().unwrap_or(i64::MAX).saturating_sub(window.first);
    let first = usize::try_from(first).unwrap_or(usize::MAX);
    let pair = [(first, Rational::one() - &part), (first.saturating_add(1), part)];
    pair.into_iter().filter(|(_, x)| !x.is_zero()).map(|(at, x)| (index(at), x)).collect()
}

/// All phases, and the one that cells of the level of the polygon have.
fn phases(
    limit: &Limit,
    shift: &Rational,
    window: Window,
) -> Result<(Vec<Phase<Rational>>, usize), NetError> {
    let (zero, one) = (Rational::zero(), Rational::one());
    let mut all = vec![vec![zero.clone(), one.clone()]];
    let node = shift.fract();
    if !node.is_zero() {
        all.push(vec![zero, node, one]);
    }
    let start = all.len() - 1;
    let arity = limit.mask().arity();
    let mut phases = Vec::new();
    while phases.len() < all.len() {
        if all.len() > MAX_PHASES {
            return Err(NetError::TooMuch(format!(
                "the points of this scheme are at the parameters (i + {shift})/{arity}^k, whose digits \
                 repeat too late: at most {MAX_PHASES} are worked on"
            )));
        }
        let nodes = all[phases.len()].clone();
        let mut parts = Vec::with_capacity(arity);
        for part in 0..arity {
            let ends = [part, part + 1].map(|x| Rational::new(x, arity));
            let inside = nodes.iter().filter(|x| ends[0] < **x && **x < ends[1]);
            let at: Vec<Rational> =
                ends[..1].iter().chain(inside).chain(&ends[1..]).cloned().collect();
            let own = |x: &Rational| x * Rational::from(arity) - Rational::from(part);
            let own: Vec<Rational> = at.iter().map(own).collect();
            let next = all.iter().position(|known| *known == own).unwrap_or_else(|| {
                all.push(own);
                all.len() - 1
            });
            parts.push((next, at.iter().map(|x| between(&nodes, x)).collect()));
        }
        let limits = nodes.iter().map(|t| Ok(sparse(over(&limit.at(t)?, window))));
        let limits = limits.collect::<Result<_, LimitError>>()?;
        phases.push(Phase { nodes, limits, parts });
    }
    Ok((phases, start))
}

/// The value at x of the linear interpolant at these nodes.
fn between(nodes: &[Rational], x: &Rational) -> Row<Rational> {
    let right = nodes.iter().position(|node| node >= x).unwrap_or(nodes.len() - 1).max(1);
    let (from, to) = (&nodes[right - 1], &nodes[right]);
    let part = (x - from) / (to - from);
    let pair = [(right - 1, Rational::one() - &part), (right, part)];
    pair.into_iter().filter(|(_, x)| !x.is_zero()).map(|(at, x)| (index(at), x)).collect()
}

/// The greatest Σ|weights| of these rows.
pub(super) fn norm<S: Scalar>(rows: &[Row<S>], size: impl Fn(&S) -> f64) -> f64 {
    rows.iter().map(|row| row.iter().map(|(_, x)| size(x)).sum::<f64>()).fold(0.0, f64::max)
}
