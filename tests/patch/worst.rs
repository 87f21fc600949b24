//! Points that are chosen to be as far from their limits as the shape of a mesh allows, against what is
//! guaranteed without a search.

use super::naive::differences;
use super::{Mesh, examples, grid};
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, Point};
use subcert::patch::MeshDistances;

fn greatest(bounds: &[f64]) -> f64 {
    bounds.iter().copied().fold(0.0, f64::max)
}

/// The heights of the vertices of a mesh.
type Heights = Vec<f64>;

fn with_heights(mesh: &Mesh, heights: &[i64]) -> Mesh {
    let point = |height: &i64| -> Point<Rational> {
        [Rational::zero(), Rational::zero(), Rational::from(*height)]
    };
    mesh.with_points(heights.iter().map(point).collect())
}

/// The distances at sampled parameters as functionals of the heights, from unit vectors.
fn functionals(mesh: &Mesh, scheme: MeshScheme, level: u32) -> Vec<Heights> {
    let count = mesh.points().len();
    let mut functionals: Vec<Heights> = Vec::new();
    for first in (0..count).step_by(3) {
        let unit = |point: usize| -> Point<Rational> {
            [0, 1, 2].map(|i| Rational::from(i64::from(point == first + i)))
        };
        let units = mesh.with_points((0..count).map(unit).collect());
        let differences = differences(&units, scheme, level, 2);
        functionals.resize(differences.len(), vec![0.0; count]);
        for (functional, difference) in functionals.iter_mut().zip(differences) {
            for (value, known) in functional[first..].iter_mut().zip(difference) {
                *value = known;
            }
        }
    }
    functionals
}

/// The greatest quotient that is found of a distance and of what is guaranteed: from heights of ±1 that
/// make the distance at some parameter as great as heights up to 1 can, by changes of single heights.
fn worst_quotient(mesh: &Mesh, scheme: MeshScheme) -> f64 {
    let mut functionals = functionals(mesh, scheme, 1);
    let norm = |functional: &Heights| functional.iter().map(|x| x.abs()).sum::<f64>();
    functionals.sort_by(|left, right| norm(right).total_cmp(&norm(left)));
    let quotient = |functional: &Heights, heights: &[i64]| {
        let distances = MeshDistances::new(with_heights(mesh, heights), scheme).expect("a mesh");
        let real = |height: i64| f64::from(i32::try_from(height).expect("small"));
        let terms = functional.iter().zip(heights).map(|(x, &height)| x * real(height));
        let distance = terms.sum::<f64>();
        if distance > 1e-9 { distance / greatest(&distances.guaranteed(1)) } else { 0.0 }
    };
    let functional = &functionals[0];
    let mut heights: Vec<i64> = functional.iter().map(|x| if *x > 0.0 { 1 } else { -1 }).collect();
    let mut best = quotient(functional, &heights);
    for i in 0..heights.len() {
        for height in [-1, 0, 1] {
            let known = std::mem::replace(&mut heights[i], height);
            let changed = quotient(functional, &heights);
            if changed > best {
                best = changed;
            } else {
                heights[i] = known;
            }
        }
    }
    best
}

/// Around irregular vertices and faces what is guaranteed without a search is from 4 to 20 times too much
/// for the worst points that are found.
#[test]
fn what_is_guaranteed_holds_for_the_worst_points() {
    for scheme in MeshScheme::ALL {
        for (i, mesh) in
            examples(scheme).iter().enumerate().filter(|(_, mesh)| mesh.points().len() < 16)
        {
            let worst = worst_quotient(mesh, scheme);
            assert!(worst > 0.05 && worst <= 1.0 + 1e-9, "{scheme:?}, example {i}: {worst}");
        }
    }
}

/// By hand, for second differences of 2: (1/2 + 1/2)/6 at the vertices of level 1 of Catmull–Clark,
/// (1/2 + 1/2)/8 at the faces of Doo–Sabin, three times (1/2)/12 for Loop; and (1/4)/6 at its edges on
/// a saddle.
#[test]
fn paraboloids_attain_the_bounds_of_regular_pieces() {
    type Height = fn(i64, i64) -> i64;
    let cases: [(MeshScheme, Height, f64); 4] = [
        (MeshScheme::CatmullClark, |i, j| i * i + j * j, 1.0 / 6.0),
        (MeshScheme::DooSabin, |i, j| i * i + j * j, 1.0 / 8.0),
        (MeshScheme::Loop, |i, j| i * i - i * j + j * j, 1.0 / 8.0),
        (MeshScheme::Loop, |i, j| i * j, 1.0 / 24.0),
    ];
    for (scheme, shape, expected) in cases {
        let height = |i: usize, j: usize| {
            let [i, j] = [i, j].map(|k| i64::try_from(k).expect("small"));
            Rational::from(shape(i, j))
        };
        let mesh = grid(8, 8, scheme == MeshScheme::Loop, height);
        let distances = MeshDistances::new(mesh.clone(), scheme).expect("a mesh");
        // In the middle.
        let inner = mesh.faces().len() / 2;
        let [guaranteed, lower] = [distances.guaranteed(1)[inner], distances.faces(1)[inner][0]];
        assert!(
            guaranteed >= expected && guaranteed < expected * (1.0 + 1e-9),
            "{scheme:?}: {guaranteed}"
        );
        assert!(lower <= expected && lower > expected * (1.0 - 1e-9), "{scheme:?}: {lower}");
    }
}
