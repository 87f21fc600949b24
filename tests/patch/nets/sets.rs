//! The distance of nets from their limits as sets of points, against dense samples.

use super::distances;
use crate::common::hausdorff::{P, of_triangles};
use crate::common::r;
use crate::net::{bumpy, heights, scheme};
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::net::{Closed, Net};
use subcert::patch::SetKind;

/// A net in f64 with a parameter for each row and each column, refined by the definition: point i of the next level is
/// Σ_j a_{i − 2j} x_j, where a closed net has no end and an open one has the points that are known.
#[derive(Clone)]
struct Naive {
    rows: Vec<f64>,
    columns: Vec<f64>,
    points: Vec<Vec<P>>,
    closed: bool,
}

/// One direction of one step: for each point of the next level the combination.
fn combinations(mask: &[f64], count: usize, closed: bool) -> Vec<Vec<(i64, f64)>> {
    let count = i64::try_from(count).expect("few");
    let terms = |i: i64| -> Vec<(i64, f64)> {
        let at = |k: usize| i - i64::try_from(k).expect("few");
        let even = (0..mask.len()).filter(|k| at(*k).rem_euclid(2) == 0);
        even.map(|k| (at(k).div_euclid(2), mask[k])).collect()
    };
    let all = if closed { 0..2 * count } else { 0..2 * count + 20 };
    let known =
        |terms: &Vec<(i64, f64)>| closed || terms.iter().all(|(j, _)| (0..count).contains(j));
    all.map(terms).filter(known).collect()
}

impl Naive {
    fn new(net: &Net) -> Naive {
        let (rows, columns) = (net.rows(), net.columns());
        let points: Vec<P> = net.points().iter().map(|x| x.each_ref().map(nearest)).collect();
        Naive {
            rows: (0_u32..).take(rows).map(f64::from).collect(),
            columns: (0_u32..).take(columns).map(f64::from).collect(),
            points: points.chunks(columns).map(<[P]>::to_vec).collect(),
            closed: net.closed().u,
        }
    }

    fn refined(&self, mask: &[f64]) -> Naive {
        let sum = |terms: &Vec<(i64, f64)>, value: &dyn Fn(usize, f64) -> P| {
            terms.iter().fold([0.0; 3], |sum, (j, weight)| {
                let own = value(usize::try_from(*j).expect("known"), *weight);
                [0, 1, 2].map(|c| sum[c] + own[c])
            })
        };
        let wrapped = |terms: Vec<Vec<(i64, f64)>>, count: usize| -> Vec<Vec<(i64, f64)>> {
            let count = i64::try_from(count).expect("few");
            let wrap = |(j, w): (i64, f64)| (if self.closed { j.rem_euclid(count) } else { j }, w);
            terms.into_iter().map(|row| row.into_iter().map(wrap).collect()).collect()
        };
        let up = combinations(mask, self.rows.len(), self.closed);
        let along = combinations(mask, self.columns.len(), self.closed);
        let parameter = |terms: &Vec<(i64, f64)>, own: &[f64]| {
            let first = own[0];
            let step = own[1] - own[0];
            // Beyond the end of a closed net parameters go on.
            #[expect(clippy::cast_precision_loss, reason = "few")]
            terms.iter().map(|(j, weight)| weight * (first + step * *j as f64)).sum::<f64>()
        };
        let rows = up.iter().map(|terms| parameter(terms, &self.rows)).collect();
        let columns = along.iter().map(|terms| parameter(terms, &self.columns)).collect();
        let (up, along) = (wrapped(up, self.rows.len()), wrapped(along, self.columns.len()));
        let half: Vec<Vec<P>> = up
            .iter()
            .map(|terms| {
                let at = |j: usize| sum(terms, &|i, weight| self.points[i][j].map(|x| weight * x));
                (0..self.columns.len()).map(at).collect()
            })
            .collect();
        let points = half
            .iter()
            .map(|row| {
                let at = |terms| sum(terms, &|j, weight| row[j].map(|x| weight * x));
                along.iter().map(at).collect()
            })
            .collect();
        Naive { rows, columns, points, closed: self.closed }
    }

    /// The bilinear value at parameters.
    fn at(&self, u: f64, v: f64) -> P {
        let place = |own: &[f64], x: f64, closed: bool| {
            let count = own.len();
            let at = (x - own[0]) / (own[1] - own[0]);
            let low = at.floor();
            #[expect(clippy::cast_possible_truncation, reason = "few")]
            let first = low as i64;
            let index = |i: i64| {
                let last = i64::try_from(count).expect("few") - 1;
                let i = if closed { i.rem_euclid(last + 1) } else { i.clamp(0, last) };
                usize::try_from(i).expect("not negative")
            };
            (index(first), index(first + 1), at - low)
        };
        let (i, up, s) = place(&self.rows, u, self.closed);
        let (j, right, t) = place(&self.columns, v, self.closed);
        let point = |i: usize, j: usize| self.points[i][j];
        [0, 1, 2].map(|c| {
            (1.0 - s) * ((1.0 - t) * point(i, j)[c] + t * point(i, right)[c])
                + s * ((1.0 - t) * point(up, j)[c] + t * point(up, right)[c])
        })
    }

    /// Triangles over a range of parameters.
    fn triangles(&self, range: [[f64; 2]; 2], pieces: u32) -> Vec<[P; 3]> {
        let share =
            |[low, high]: [f64; 2], i: u32| low + (high - low) * f64::from(i) / f64::from(pieces);
        let grid: Vec<Vec<P>> = (0..=pieces)
            .map(|i| {
                (0..=pieces).map(|j| self.at(share(range[0], i), share(range[1], j))).collect()
            })
            .collect();
        let mut all = Vec::new();
        for (row, next) in grid.iter().zip(&grid[1..]) {
            for j in 1..row.len() {
                all.push([row[j - 1], row[j], next[j]]);
                all.push([row[j - 1], next[j], next[j - 1]]);
            }
        }
        all
    }
}

/// H_0, …, H_{levels − 1}, with the net of level `dense` in place of the limit.
fn sampled(net: &Net, mask: &[f64], levels: u32, dense: u32, pieces: u32) -> Vec<f64> {
    let mut nets = vec![Naive::new(net)];
    for _ in 0..dense {
        nets.push(nets[nets.len() - 1].refined(mask));
    }
    let limit = &nets[nets.len() - 1];
    let range = |own: &[f64], count: usize| {
        let end = if net.closed().u {
            own[0] + f64::from(u32::try_from(count).expect("few"))
        } else {
            own[own.len() - 1]
        };
        [own[0], end]
    };
    let range = [range(&limit.rows, net.rows()), range(&limit.columns, net.columns())];
    let fine = limit.triangles(range, pieces);
    let level = |k: u32| of_triangles(nets[k as usize].triangles(range, pieces), fine.clone());
    (0..levels).map(level).collect()
}

const CUBIC: [f64; 5] = [0.125, 0.5, 0.75, 0.5, 0.125];
const CHAIKIN: [f64; 4] = [0.25, 0.75, 0.75, 0.25];
const FOUR_POINT: [f64; 7] = [-0.0625, 0.0, 0.5625, 1.0, 0.5625, 0.0, -0.0625];
const TORUS: Closed = Closed { u: true, v: true };

/// The certified levels are those of samples, at tolerances between distances that were sampled.
fn agrees(net: &Net, name: &str, mask: &[f64]) {
    let sampled = sampled(net, mask, 3, 5, 32);
    let distances = distances(net, &scheme(name));
    let parts = |x: f64| {
        #[expect(clippy::cast_possible_truncation, reason = "few")]
        let parts = (x * 4096.0) as i64;
        r(parts, 4096)
    };
    for pair in sampled.windows(2) {
        let tolerance = parts((pair[0] * pair[1]).sqrt());
        let depth = distances.geometric_depth(&tolerance).expect("few levels");
        let level = sampled.iter().position(|x| *x <= nearest(&tolerance)).expect("one");
        let found = depth.level.expect("a level");
        assert_eq!(found as usize, level, "{name}, {tolerance}: {sampled:?}, {depth:?}");
        assert_eq!(depth.too_few, Some(found - 1), "{name}, {tolerance}: {sampled:?}");
        let place = depth.beyond.expect("a level is too few");
        let greatest = sampled[level - 1] * 1.05 + 1e-2;
        assert!(
            place.distance >= nearest(&tolerance) * (1.0 - 1e-12) && place.distance <= greatest,
            "{name}, {sampled:?}: {place:?}"
        );
        let parametric = distances.depth(&tolerance).expect("a depth");
        assert!(found <= parametric.level);
    }
}

#[test]
fn the_least_level_is_that_of_dense_samples() {
    agrees(&bumpy(6, 6, Closed::default()), "bicubic", &CUBIC);
    agrees(&bumpy(5, 5, TORUS), "bicubic", &CUBIC);
    agrees(&bumpy(5, 6, TORUS), "chaikin", &CHAIKIN);
    agrees(&bumpy(5, 5, Closed::default()), "chaikin", &CHAIKIN);
    agrees(&bumpy(7, 7, Closed::default()), "four-point:w=1/16", &FOUR_POINT);
}

/// A net in a plane is its limit as a set, but for the edge of what its points determine.
#[test]
fn what_moves_along_itself_is_not_far() {
    let slanted = heights(8, 8, |i, j| Rational::from(i + 2 * j));
    let square = |x: &Rational| x * x;
    let own = |[x, y, _]: &[Rational; 3]| {
        let (x, y) = (square(x), square(y));
        let z = &x + &(&y * &Rational::from(2));
        [x, y, z]
    };
    let net = Net::new(slanted.points().iter().map(own).collect(), 8, Closed::default());
    let distances = distances(&net.expect("a net"), &scheme("bicubic"));
    // The edge moves by a third along both squares: √((1/3)²·(1 + 1 + 9)) at the corner.
    let tolerance = r(111, 100);
    assert_eq!(distances.geometric_depth(&tolerance).expect("few").level, Some(0));
    let depth = distances.geometric_depth(&r(9, 10)).expect("few");
    assert_eq!((depth.level, depth.too_few), (Some(1), Some(0)));
    assert_eq!(depth.beyond.expect("far").from, SetKind::Mesh, "its edge is outside");
}

#[test]
fn each_face_has_its_own_level() {
    // Flat but for one corner.
    let net = heights(9, 9, |i, j| if i + j >= 14 { r(1, 1) } else { r(0, 1) });
    let distances = distances(&net, &scheme("bicubic"));
    let tolerance = r(1, 20);
    let all = distances.geometric_depth(&tolerance).expect("few");
    let faces = distances.geometric_faces(&tolerance).expect("few");
    assert_eq!(faces.len(), 64);
    assert_eq!(faces.iter().map(|face| face.level).max(), all.level);
    assert_eq!(faces[0].level, 0);
    let bounds =
        distances.geometric_distances(all.level.expect("a level"), &tolerance).expect("few");
    for [low, high] in bounds {
        assert!(low <= high && high <= 0.05 + 1e-12, "{low} {high}");
    }
}
