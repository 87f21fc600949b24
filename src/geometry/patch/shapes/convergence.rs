//! How fast pieces of a shape tend to the limit, whatever their points are
//! (`proofs/THEOREMS.md`, 94).

use super::regular::Bends;
use super::scheme::PieceScheme;
use super::shape::{Convergence, Shape};
use crate::patch::number::{Row, Vector, combinations};

/// What is added to a norm of a functional for the rounding of its coefficients, and for each of them.
const ROUNDING: (f64, f64) = (1e-10, 1e-13);

/// What a bound is multiplied by for the rounding of sums and products of bounds.
const INFLATION: f64 = 1.0 + 1e-9;

/// The most coefficients of a matrix for which its higher powers are computed.
const MANY: usize = 10_000;

/// The points of a part of a solid are followed until N of them is at most this part of the first one, or
/// there are so many parts.
const NEAR: f64 = 0.001;
const MOST_STATES: usize = 64;

/// The greatest levels that bounds are computed for.
pub(crate) const LAST: usize = 80;

/// Those of a shape, the parts of which have theirs.
pub(super) fn convergence(shapes: &[Shape], shape: usize) -> Convergence {
    let parts = shapes[shape].parts.iter().enumerate();
    let repeats: Vec<usize> =
        parts.filter(|(_, part)| part.shape == shape).map(|(part, _)| part).collect();
    let (mut bounds, mut others) = match repeats[..] {
        _ if shapes[shape].is_regular() => (regular(&shapes[shape]), Vec::new()),
        [] => (by_parts(shapes, shape), Vec::new()),
        _ => repeated(shapes, shape, &repeats),
    };
    if shapes[shape].surroundings.layers().is_some() {
        let first = bounds.first().copied().unwrap_or(0.0);
        for (bound, least) in bounds.iter_mut().zip(falling(first)) {
            *bound = bound.max(least);
        }
    }
    fall(&mut bounds);
    fall(&mut others);
    let repeated = match repeats[..] {
        [part] if !others.is_empty() => Some((part, others)),
        _ => None,
    };
    Convergence { bounds, repeated }
}

/// Makes bounds hold from each level on.
fn fall(bounds: &mut [f64]) {
    let mut worst = 0.0_f64;
    for bound in bounds.iter_mut().rev() {
        worst = worst.max(*bound * INFLATION);
        *bound = worst;
    }
}

/// Rows as functionals of the points of a shape; of one that is the same in each layer, functionals of
/// columns, for points that are.
fn unit(shape: &Shape) -> Vec<Vec<f64>> {
    let vector = |i: usize, count: usize| -> Vec<f64> {
        (0..count).map(|j| f64::from(u8::from(i == j))).collect()
    };
    let Some(layers) = shape.surroundings.layers() else {
        return (0..shape.points).map(|i| vector(i, shape.points)).collect();
    };
    let mut all = vec![Vec::new(); shape.points];
    for layer in layers {
        for (column, &point) in layer.iter().enumerate() {
            all[point as usize] = vector(column, layer.len());
        }
    }
    all
}

/// Σ |f_b| without the first point: the greatest value, for N = 1, of a functional that sums to 0.
fn norm(functional: &[f64]) -> f64 {
    let (once, each) = ROUNDING;
    functional.iter().skip(1).map(|x| x.abs() + each).sum::<f64>() + once
}

fn greatest(norms: impl IntoIterator<Item = f64>) -> f64 {
    norms.into_iter().fold(0.0, f64::max)
}

/// N of points that are functionals, for N = 1; of a shape that is the same in each layer, what 102 has in
/// its place.
fn spread(shape: &Shape, points: &[Vec<f64>]) -> f64 {
    let Some(layers) = shape.surroundings.layers().filter(|_| !shape.is_regular()) else {
        return greatest(points.iter().map(|point| norm(&point.minus(&points[0]))));
    };
    let at = |layer: &Vec<u32>, column: usize| &points[layer[column] as usize];
    let columns = || 0..layers[0].len();
    let within = layers.iter().flat_map(|layer| {
        columns().map(move |column| norm(&at(layer, column).minus(at(layer, 0))))
    });
    let bends = columns().flat_map(|column| {
        layers.windows(3).map(move |three| {
            let [low, middle, high] = [0, 1, 2].map(|i| at(&three[i], column));
            norm(&low.minus(middle).minus(&middle.minus(high)))
        })
    });
    // While its own bounds are being found, data are the same in each layer.
    let growth = if shape.convergence.is_known() { shape.convergence.bound(0) } else { 1.0 };
    greatest(within) + greatest(bends) / (6.0 * growth)
}

/// The bound of 92 for a regular piece at level 0, for N = 1; that of level i is 4^−i of it.
fn bend(bends: &Bends<f64>, points: &[Vec<f64>], scheme: PieceScheme) -> f64 {
    let worst = |rows: &Vec<Row<f64>>| {
        greatest(rows.iter().map(|row| norm(&Vector::combination(row, points))))
    };
    let sum: f64 = bends.directions.iter().map(worst).sum();
    scheme.bend_bound(sum, worst(&bends.across))
}

fn regular(shape: &Shape) -> Vec<f64> {
    let points = unit(shape);
    let Some((_, bends)) = &shape.rules.regular else { return Vec::new() };
    let first = bend(bends, &points, shape.scheme);
    falling(first)
}

/// A bound that falls to a quarter at each level.
fn falling(first: f64) -> Vec<f64> {
    std::iter::successors(Some(first), |bound| Some(bound / 4.0)).take(LAST + 1).collect()
}

/// The parts of a piece, as functionals: the points of each, and the polygon at its corners.
fn divided(
    shape: &Shape,
    points: &[Vec<f64>],
    base: Option<&Vec<Vec<f64>>>,
) -> Vec<[Vec<Vec<f64>>; 2]> {
    let refined = combinations(&shape.rules.refined, points);
    let parts = shape.parts.iter().enumerate().map(|(i, part)| {
        let own = part.points.iter().map(|&point| refined[point].clone()).collect();
        let base = match base {
            Some(base) => combinations(&shape.rules.split[i], base),
            None => combinations(&shape.rules.base[i], points),
        };
        [own, base]
    });
    parts.collect()
}

/// The distance of the limit from the polygon with these corners on a piece, for N = 1: without that
/// from its own polygon if the piece is not regular. For a regular piece of a solid, which has many
/// Bézier coefficients, it is the sum of those of both from its own polygon.
fn error(shape: &Shape, points: &[Vec<f64>], base: &[Vec<f64>]) -> f64 {
    let (rows, own) = match &shape.rules.regular {
        Some((_, bends)) if shape.scheme == PieceScheme::Solid => {
            (&shape.rules.nodes, bend(bends, points, shape.scheme))
        }
        Some((bezier, _)) => (bezier, 0.0),
        None => (&shape.rules.nodes, 0.0),
    };
    own + greatest(rows.iter().map(|(row, plain)| {
        let polygon = Vec::<f64>::combination(plain, base);
        norm(&Vec::<f64>::combination(row, points).minus(&polygon))
    }))
}

/// What a part of a shape of this kind with these points adds to the bound of its own level, and to those of all
/// later ones.
fn of_part(
    part: &Shape,
    points: &[Vec<f64>],
    base: &[Vec<f64>],
    scheme: PieceScheme,
) -> (f64, Vec<f64>) {
    let spread = spread(part, points);
    let tail = if part.is_regular() { 0.0 } else { part.convergence.bound(0) * spread };
    let later = match &part.rules.regular {
        Some((_, bends)) => falling(bend(bends, points, scheme)),
        None => (0_u32..).take(LAST).map(|i| part.convergence.bound(i) * spread).collect(),
    };
    (error(part, points, base) + tail, later)
}

/// The bounds of a shape whose parts have theirs.
fn by_parts(shapes: &[Shape], shape: usize) -> Vec<f64> {
    let own = &shapes[shape];
    let mut bounds = vec![0.0_f64; LAST + 1];
    for (part, [points, base]) in own.parts.iter().zip(divided(own, &unit(own), None)) {
        let (now, later) = of_part(&shapes[part.shape], &points, &base, own.scheme);
        for (bound, now) in bounds.iter_mut().zip([now].into_iter().chain(later)) {
            *bound = bound.max(now);
        }
    }
    bounds
}

/// How many levels a part of the same shape is followed: while that is not too much work, and for solids
/// until points come nearer.
fn followed(shape: &Shape, level: usize, spread: f64, states: usize) -> bool {
    match shape.scheme {
        PieceScheme::Surface(_) => level < if shape.points * shape.points > MANY { 6 } else { 12 },
        PieceScheme::Solid if spread < NEAR || states >= MOST_STATES => level < 2,
        PieceScheme::Solid => level < 12,
    }
}

/// The bounds of a shape of which some parts have the same shape, and those of its other parts.
fn repeated(shapes: &[Shape], shape: usize, again: &[usize]) -> (Vec<f64>, Vec<f64>) {
    let own = &shapes[shape];
    let mut states = vec![(unit(own), None)];
    // A_0, A_1, …: N of the repeated parts; R_1, R_2, …: bounds of the other parts.
    let mut spreads = vec![1.0];
    let mut others: Vec<Vec<f64>> = Vec::new();
    let mut first = 0.0_f64;
    while followed(own, others.len(), spreads[others.len()], states.len()) {
        let mut bounds = vec![0.0_f64; LAST + 1];
        let mut next = Vec::with_capacity(states.len() * again.len());
        for (points, base) in states {
            for (i, [points, base]) in divided(own, &points, base.as_ref()).into_iter().enumerate()
            {
                if again.contains(&i) {
                    // What is the same in each layer stays so: both halves of a layer are one.
                    if own.surroundings.layers().is_none() || again[0] == i {
                        next.push((points, Some(base)));
                    }
                    continue;
                }
                let part = &shapes[own.parts[i].shape];
                let (now, later) = of_part(part, &points, &base, own.scheme);
                first = first.max(now);
                for (bound, later) in bounds.iter_mut().zip(later) {
                    *bound = bound.max(later);
                }
            }
        }
        others.push(bounds);
        spreads.push(greatest(next.iter().map(|(points, _)| spread(own, points))));
        states = next;
    }
    let levels = others.len();
    let ratio = spreads[levels];
    let nodes = greatest(states.iter().map(|(points, base)| {
        base.as_ref().map_or(f64::INFINITY, |base| error(own, points, base))
    }));
    // D ≤ max(first, nodes + ratio·D) for N = 1.
    let zeroth = if ratio < 1.0 { first.max(nodes / (1.0 - ratio)) } else { f64::INFINITY };
    for i in levels + 1..=LAST {
        spreads.push(spreads[i - levels] * ratio);
    }
    let mut bounds = Vec::with_capacity(LAST + 1);
    for i in 0..=LAST {
        let mut bound = zeroth * spreads[i];
        for j in 1..=i {
            // Split off at level j, i − j levels before.
            let block = (j - 1) / levels;
            let other = others[(j - 1) % levels][i - j] * spreads[block * levels];
            bound = bound.max(other);
        }
        bounds.push(bound);
    }
    (bounds, others.swap_remove(0))
}
