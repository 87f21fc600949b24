//! Characteristic maps in f64, by refining nets until they are eigenvectors: the signs of the areas of small cells, and winding
//! numbers. Nothing here is shared with the program.

use std::collections::BTreeMap;
use std::f64::consts::PI;

/// A complex number.
type C = (f64, f64);

fn times((a, b): C, (c, d): C) -> C {
    (a * c - b * d, a * d + b * c)
}

fn unit(turns: f64) -> C {
    ((2.0 * PI * turns).cos(), (2.0 * PI * turns).sin())
}

fn real(x: i32) -> f64 {
    f64::from(x)
}

/// Where the control points are.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Quadrilaterals around a vertex.
    Vertex,
    /// Quadrilaterals around a face, with the weights of its points by their distance.
    Face,
    /// Triangles around a vertex.
    Triangles,
}

/// The net of block k of n sectors, in sector 0.
pub struct Net {
    kind: Kind,
    n: i32,
    k: i32,
    /// The weights of the points of a face, or, if there are any, of the edge points in an edge point, by their distance.
    weights: Vec<f64>,
    points: BTreeMap<(i32, i32), C>,
    size: i32,
}

impl Net {
    pub fn new(kind: Kind, n: i32, k: i32, weights: &[f64]) -> Net {
        let mut points = BTreeMap::new();
        let (omega, size) = (unit(real(k) / real(n)), 8);
        let shift = if kind == Kind::Face { 0.5 } else { 0.0 };
        for a in 0..=size {
            for b in 0..=size {
                let (x, y) = (real(a) + shift, real(b) + shift);
                let along = times((y, 0.0), omega);
                points.insert((a, b), (x + along.0, along.1));
            }
        }
        let mut net = Net { kind, n, k, weights: weights.to_vec(), points, size };
        for _ in 0..60 {
            net = net.refined(8);
            let first = net.at(if kind == Kind::Face { (0, 0) } else { (1, 0) });
            let size = first.0.hypot(first.1);
            for point in net.points.values_mut() {
                *point = (point.0 / size, point.1 / size);
            }
        }
        net
    }

    /// A place in sector 0, and the turns from there.
    fn at(&self, place: (i32, i32)) -> C {
        let ((mut a, mut b), mut turns) = (place, 0);
        let home = |a: i32, b: i32| match self.kind {
            Kind::Face => a >= 0 && b >= 0,
            _ => (a > 0 && b >= 0) || (a == 0 && b == 0),
        };
        while !home(a, b) {
            // One sector back, or on where the place is before sector 0.
            let before = b < 0;
            (a, b) = match (self.kind, before) {
                (Kind::Vertex, false) => (b, -a),
                (Kind::Face, false) => (b, -1 - a),
                (Kind::Triangles, false) => (a + b, -a),
                (Kind::Vertex, true) => (-b, a),
                (Kind::Face, true) => (-1 - b, a),
                (Kind::Triangles, true) => (-b, a + b),
            };
            turns += if before { -1 } else { 1 };
        }
        times(self.points[&(a, b)], unit(real(self.k * turns) / real(self.n)))
    }

    fn combined(&self, terms: &[((i32, i32), f64)]) -> C {
        let sum = |sum: C, (place, weight): &((i32, i32), f64)| {
            let point = self.at(*place);
            (sum.0 + weight * point.0, sum.1 + weight * point.1)
        };
        terms.iter().fold((0.0, 0.0), sum)
    }

    /// The sum of a point in all sectors by the weights.
    fn around(&self, place: (i32, i32)) -> C {
        let mut sum = (0.0, 0.0);
        for (d, weight) in (0..).zip(&self.weights) {
            let turned = times(self.at(place), unit(real(d * self.k) / real(self.n)));
            sum = (sum.0 + weight * turned.0, sum.1 + weight * turned.1);
        }
        sum
    }

    /// The next level up to so many places.
    pub fn refined(&self, size: i32) -> Net {
        let mut points = BTreeMap::new();
        for a in 0..=size {
            for b in 0..=size {
                let point = match (a, b, self.kind) {
                    // Sums over all sectors vanish but for k = 0.
                    (0, 0, Kind::Vertex | Kind::Triangles) => (0.0, 0.0),
                    (0, 0, Kind::Face) => self.around((0, 0)),
                    (0, _, Kind::Vertex | Kind::Triangles) => continue,
                    (1, 0, Kind::Triangles) if !self.weights.is_empty() => self.around((1, 0)),
                    _ if self.kind == Kind::Triangles => self.combined(&triangles(a, b)),
                    _ => self.combined(&squares(self.kind, a, b)),
                };
                points.insert((a, b), point);
            }
        }
        let weights = self.weights.clone();
        let mut net = Net { kind: self.kind, n: self.n, k: self.k, weights, points, size };
        if self.kind != Kind::Face {
            for b in 1..=size {
                let point = times(net.points[&(b, 0)], unit(real(self.k) / real(self.n)));
                net.points.insert((0, b), point);
            }
        }
        net
    }

    /// The signs of the areas of the cells of the ring between two levels, some levels later: the numbers of positive and of
    /// negative ones.
    pub fn areas(&self) -> (usize, usize) {
        let mut net = self.refined(8);
        let (mut low, mut high) = (1, 2);
        for _ in 0..4 {
            // A net of s places knows 2s − 4 of the next level.
            net = net.refined(2 * net.size - 5);
            (low, high) = (2 * low, 2 * high);
        }
        let (mut positive, mut negative) = (0, 0);
        for a in 0..high {
            for b in 0..high {
                let inside = match self.kind {
                    Kind::Triangles => a + b < high && a + b >= low,
                    _ => a >= low || b >= low,
                };
                if !inside {
                    continue;
                }
                let [p, q, r] = [net.at((a, b)), net.at((a + 1, b)), net.at((a, b + 1))];
                let area = (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
                if area > 0.0 {
                    positive += 1;
                } else {
                    negative += 1;
                }
            }
        }
        (positive, negative)
    }

    /// How often the outer curve of the ring winds around 0.
    pub fn winding(&self) -> f64 {
        let mut net = self.refined(8);
        let mut far = 2;
        for _ in 0..3 {
            net = net.refined(2 * net.size - 5);
            far *= 2;
        }
        let mut places: Vec<(i32, i32)> = Vec::new();
        if self.kind == Kind::Triangles {
            places.extend((0..=far).map(|i| (far - i, i)));
        } else {
            places.extend((0..=far).map(|b| (far, b)));
            places.extend((0..=far).rev().map(|a| (a, far)));
        }
        let mut points: Vec<C> = places.into_iter().map(|place| net.at(place)).collect();
        let omega = unit(real(self.k) / real(self.n));
        points.push(times(points[0], omega));
        let turned = |pair: &[C]| {
            let (p, q) = (pair[0], pair[1]);
            (p.0 * q.1 - p.1 * q.0).atan2(p.0 * q.0 + p.1 * q.1)
        };
        points.windows(2).map(turned).sum::<f64>() * real(self.n) / (2.0 * PI)
    }
}

/// The rules of B-splines, of degree 3 or 2.
fn squares(kind: Kind, a: i32, b: i32) -> Vec<((i32, i32), f64)> {
    let line = |x: i32| {
        let half = x.div_euclid(2);
        match (kind, x.rem_euclid(2)) {
            (Kind::Vertex, 0) => vec![(half - 1, 0.125), (half, 0.75), (half + 1, 0.125)],
            (Kind::Vertex, _) => vec![(half, 0.5), (half + 1, 0.5)],
            (_, 0) => vec![(half, 0.75), (half - 1, 0.25)],
            _ => vec![(half, 0.75), (half + 1, 0.25)],
        }
    };
    let mut terms = Vec::new();
    for (i, u) in line(a) {
        terms.extend(line(b).into_iter().map(|(j, v)| ((i, j), u * v)));
    }
    terms
}

/// The rules of Loop away from the vertex.
fn triangles(a: i32, b: i32) -> Vec<((i32, i32), f64)> {
    let (x, y) = (a.div_euclid(2), b.div_euclid(2));
    match (a.rem_euclid(2), b.rem_euclid(2)) {
        (0, 0) => {
            let around = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
            let six = around.map(|(u, v)| ((x + u, y + v), 0.0625));
            std::iter::once(((x, y), 0.625)).chain(six).collect()
        }
        (1, 0) => {
            vec![((x, y), 0.375), ((x + 1, y), 0.375), ((x, y + 1), 0.125), ((x + 1, y - 1), 0.125)]
        }
        (0, _) => {
            vec![((x, y), 0.375), ((x, y + 1), 0.375), ((x + 1, y), 0.125), ((x - 1, y + 1), 0.125)]
        }
        _ => {
            vec![((x + 1, y), 0.375), ((x, y + 1), 0.375), ((x, y), 0.125), ((x + 1, y + 1), 0.125)]
        }
    }
}
