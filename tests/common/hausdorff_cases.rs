//! Closed meshes with tolerances, for their Hausdorff depth.

use super::hausdorff::{Plain, Rule};

/// A mesh, its scheme and tolerances p/q.
pub struct Case {
    pub name: String,
    pub rule: Rule,
    pub points: Vec<[i64; 3]>,
    pub faces: Vec<Vec<usize>>,
    pub tolerances: Vec<(i64, i64)>,
    /// How many levels the dense samples need to have for the limit.
    pub dense: u32,
}

impl Case {
    pub fn plain(&self) -> Plain {
        let small = |x: i64| f64::from(i32::try_from(x).expect("small"));
        let points = self.points.iter().map(|point| point.map(small)).collect();
        Plain { points, faces: self.faces.clone() }
    }
}

fn signed(n: usize) -> i64 {
    i64::try_from(n).expect("small")
}

type Shape = (Vec<[i64; 3]>, Vec<Vec<usize>>);

fn cube() -> Shape {
    let corner = |k: i64| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| 2 * bit - 1);
    let faces =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    ((0..8).map(corner).collect(), faces.map(|face| face.to_vec()).to_vec())
}

fn tetrahedron() -> Shape {
    let points = vec![[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
    (points, vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]])
}

/// A point of a circle of radius 10, on integers.
fn circle(i: usize, n: usize) -> [i64; 2] {
    let real = |x: usize| f64::from(u32::try_from(x).expect("few points"));
    let angle = 2.0 * std::f64::consts::PI * real(i) / real(n);
    // The integer from -10 to 10 that is nearest.
    let whole = |x: f64| (-10..=10).find(|&k| (f64::from(k) - x).abs() <= 0.5).expect("at most 10");
    [10.0 * angle.cos(), 10.0 * angle.sin()].map(|x| i64::from(whole(x)))
}

/// Triangles from two poles to a ring of n points.
fn bipyramid(n: usize) -> Shape {
    let ring = (0..n).map(|i| {
        let [x, y] = circle(i, n);
        [x, y, signed(i * i % 3)]
    });
    let points = ring.chain([[1, 0, 9], [0, 2, -7]]).collect();
    let faces = (0..n).flat_map(|i| [vec![i, (i + 1) % n, n], vec![(i + 1) % n, i, n + 1]]);
    (points, faces.collect())
}

/// Quadrilaterals from two poles to a ring of 2n points.
fn trapezohedron(n: usize) -> Shape {
    let ring = (0..2 * n).map(|i| {
        let [x, y] = circle(i, 2 * n);
        [x, y, if i % 2 == 0 { 2 } else { -3 }]
    });
    let points = ring.chain([[0, 1, 9], [1, 0, -8]]).collect();
    let m = 2 * n;
    let faces = (0..n).flat_map(|i| {
        let at = |j: usize| (2 * i + j) % m;
        [vec![m, at(0), at(1), at(2)], vec![m + 1, at(3), at(2), at(1)]]
    });
    (points, faces.collect())
}

/// Two polygons with squares between them.
fn prism(n: usize) -> Shape {
    let points = (0..2 * n).map(|k| {
        let [x, y] = circle(k % n, n);
        [x, y, signed(k * k % 3) + if k < n { 0 } else { 11 }]
    });
    let sides = (0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]);
    let faces = sides.chain([(0..n).rev().collect(), (n..2 * n).collect()]).collect();
    (points.collect(), faces)
}

/// All cases. Tolerances are from a tenth to a thousandth of the size.
pub fn cases() -> Vec<Case> {
    use Rule::{CatmullClark, DooSabin, Loop};
    let small = [(1, 7), (1, 30), (1, 100), (1, 450)];
    let large = [(7, 10), (21, 100), (7, 100), (1, 40)];
    let case = |name: &str, rule, shape: Shape, tolerances: &[(i64, i64)], dense| Case {
        name: name.to_owned(),
        rule,
        points: shape.0,
        faces: shape.1,
        tolerances: tolerances.to_vec(),
        dense,
    };
    vec![
        case("cube", CatmullClark, cube(), &small, 7),
        case("cube", DooSabin, cube(), &small, 7),
        case("tetrahedron", CatmullClark, tetrahedron(), &small, 7),
        case("tetrahedron", Loop, tetrahedron(), &small, 7),
        case("prism of 5", CatmullClark, prism(5), &large, 7),
        case("prism of 5", DooSabin, prism(5), &large, 7),
        case("bipyramid of 8", Loop, bipyramid(8), &large, 7),
        case("bipyramid of 12", Loop, bipyramid(12), &large, 7),
        case("bipyramid of 5", DooSabin, bipyramid(5), &large, 7),
        case("trapezohedron of 7", CatmullClark, trapezohedron(7), &large, 7),
        case("trapezohedron of 7", DooSabin, trapezohedron(7), &large, 7),
        case("trapezohedron of 9", CatmullClark, trapezohedron(9), &large, 7),
    ]
}
