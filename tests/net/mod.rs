//! Tensor nets: files, refinement and limits.

mod lattice;
mod laws;
mod limit;
mod naive;
mod read;
mod write;

use crate::common::{int, r};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::net::{Closed, Net, NetScheme};

pub const CLOSED: [Closed; 4] = [
    Closed { u: false, v: false },
    Closed { u: true, v: false },
    Closed { u: false, v: true },
    Closed { u: true, v: true },
];

pub fn scheme(name: &str) -> NetScheme {
    NetScheme::parse(name).expect("a scheme")
}

/// A net of small integers.
pub fn bumpy(rows: usize, columns: usize, closed: Closed) -> Net {
    let point = |k: usize| {
        let (i, j) = (int(k / columns), int(k % columns));
        [3 * j + i % 2, 2 * i - (j * j) % 3, (7 * i * i + 5 * i * j + 3 * j * j * j + int(k)) % 11]
            .map(Rational::from)
    };
    Net::new((0..rows * columns).map(point).collect(), columns, closed).expect("a net")
}

/// A net of heights over its indices.
pub fn heights(rows: usize, columns: usize, height: impl Fn(usize, usize) -> Rational) -> Net {
    let point = |k: usize| {
        let (i, j) = (k / columns, k % columns);
        [Rational::from(j), Rational::from(i), height(i, j)]
    };
    let points = (0..rows * columns).map(point).collect();
    Net::new(points, columns, Closed::default()).expect("a net")
}

/// Nets of small rational points.
pub fn nets(rows: usize, columns: usize) -> impl Strategy<Value = Net> {
    let coordinate = || (-20_i64..20, 1_i64..5).prop_map(|(p, q)| r(p, q));
    let point = (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| [x, y, z]);
    let points = prop::collection::vec(point, rows * columns);
    (points, 0_usize..4)
        .prop_map(move |(points, closed)| Net::new(points, columns, CLOSED[closed]).expect("a net"))
}
