//! Regular meshes against curves, whose distances another part of the program computes exactly.

use super::{depth, distances, grid};
use crate::common::r;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::limit::{
    Comparison, ControlPolygon, Distances, Limit, Parametrisation, Spreads, SurfaceDistances,
};
use subcert::mesh::MeshScheme;
use subcert::patch::MeshDistances;
use subcert::scheme::parse_scheme;

/// The heights of a polygon that is straight at its ends.
const HEIGHTS: [i64; 14] = [0, 0, 0, 0, 0, 3, -1, 4, 1, -5, 0, 0, 0, 0];

/// A cylinder over the polygon is as far from its limit as the polygon is.
#[test]
fn a_cylinder_is_as_far_away_as_its_curve() {
    for (scheme, curve) in
        [(MeshScheme::CatmullClark, "b-spline:degree=3"), (MeshScheme::DooSabin, "chaikin")]
    {
        let mesh = grid(6, HEIGHTS.len(), false, |_, j| Rational::from(HEIGHTS[j]));
        let mask = parse_scheme(curve).expect("a catalogue entry");
        let limit = Limit::new(mask.masks()[0]).expect("it converges");
        let distances = Distances::placed(&limit, Parametrisation::Natural).expect("it converges");
        let heights: Vec<Rational> = HEIGHTS.map(Rational::from).to_vec();
        let polygon = ControlPolygon::open(&heights);
        for tolerance in [r(2, 1), r(1, 3), r(1, 20), r(1, 300)] {
            let found = depth(&mesh, scheme, &tolerance);
            let expected = distances
                .depth_of_points(std::slice::from_ref(&polygon), &tolerance)
                .expect("within the caps");
            assert_eq!(found.level, expected.upper, "{curve} {tolerance}: {found:?}");
            assert_eq!(found.too_few, found.level.checked_sub(1), "{curve} {tolerance}");
            let distance = distances
                .of_polygon(&polygon, found.level, &r(1, 100_000))
                .expect("within the caps")
                .enclosure;
            let [lower, upper] = [distance.lower(), distance.upper()].map(nearest);
            assert!(found.distance[0] <= upper * (1.0 + 1e-9), "{curve}: {found:?} {upper}");
            assert!(found.distance[1] >= lower * (1.0 - 1e-9), "{curve}: {found:?} {lower}");
        }
    }
}

/// The constant 1/3 for second differences of at most 1 is attained: x²/2 + y²/2 has second differences
/// of 1 in both directions, and its bicubic spline is 1/6 + 1/6 above the vertices.
#[test]
fn a_third_of_the_second_differences() {
    let square = |i: usize| Rational::from(i * i) / Rational::from(2);
    let mesh = grid(9, 9, false, |i, j| square(i) + square(j));
    let distances = MeshDistances::new(mesh, MeshScheme::CatmullClark).expect("a mesh");
    for (level, expected) in [(0, r(1, 3)), (1, r(1, 12)), (2, r(1, 48))] {
        // The face in the middle, far from the boundary.
        let [lower, upper] = distances.faces(level)[27];
        let expected = nearest(&expected);
        assert!((lower - expected).abs() < 1e-9, "{lower} {expected}");
        assert!(upper >= expected && upper < 1.06 * expected, "{upper} {expected}");
    }
}

/// The top of a bump: the limit point under it is nearer to the slopes than to the top. Against many
/// points of the slopes.
#[test]
fn the_distance_from_the_whole_mesh() {
    let height = |i: usize, j: usize| Rational::from(if (i, j) == (3, 3) { 3 } else { 0 });
    let mesh = grid(7, 7, false, height);
    let found = distances(&mesh, MeshScheme::CatmullClark).depth(&r(2, 1)).expect("a depth");
    assert_eq!(found.level, 0);
    // The limit of the top is at 3·16/36, and the bilinear slopes are 3(1 − s)(1 − t) high.
    let distance = |i: i32, j: i32| {
        let (s, t) = (f64::from(i) / 512.0, f64::from(j) / 512.0);
        let height = 3.0 * (1.0 - s) * (1.0 - t) - 4.0 / 3.0;
        (s * s + t * t + height * height).sqrt()
    };
    let nearest =
        (0..=512).flat_map(|i| (0..=512).map(move |j| distance(i, j))).fold(9.0, f64::min);
    assert!(found.apart >= 0.98 * nearest, "{found:?} {nearest}");
    assert!(found.apart <= 0.7 * found.distance[0], "{found:?}");
}

/// A net that is farthest from its tensor product surface, as heights of a mesh: the mesh is as far away as
/// the part of the program for tensor products says, and not farther than it says of all nets.
#[test]
fn valence_four_is_the_tensor_product() {
    const SCALE: i64 = 1000;
    let budget = subcert::bound::Budget::new(10_000_000);
    for (scheme, curve) in
        [(MeshScheme::CatmullClark, "b-spline:degree=3"), (MeshScheme::DooSabin, "chaikin")]
    {
        let mask = parse_scheme(curve).expect("a catalogue entry");
        let limit = Limit::new(mask.masks()[0]).expect("it converges");
        let natural = Parametrisation::Natural;
        let surface =
            SurfaceDistances::placed(&limit, &limit, natural, &budget).expect("it converges");
        let spreads = Spreads::new(&r(1, 1), &r(1, 1)).expect("they are positive");
        for level in 0..3 {
            let (constant, _) =
                surface.constant(level, &r(1, 10_000), &spreads).expect("within the caps");
            let threshold = constant.lower() * r(99, 100);
            let Ok(Comparison::Exceeds(witness)) = surface.compare(level, &threshold, &spreads)
            else {
                panic!("{curve}: no net at level {level}");
            };
            let (rows, columns) = (witness.net.len(), witness.net[0].len());
            let mesh = grid(rows + 8, columns + 8, false, |i, j| {
                let at = |i: usize, count: usize| i.saturating_sub(4).min(count - 1);
                let height = witness.net[at(i, rows)][at(j, columns)];
                Rational::from(SCALE) * Rational::from(height) * &witness.unit
            });
            let distances = MeshDistances::new(mesh, scheme).expect("a mesh");
            let faces = distances.faces(level);
            let [lower, upper] = [0, 1].map(|end| {
                faces.iter().map(|face| face[end]).fold(0.0, f64::max)
                    / nearest(&Rational::from(SCALE))
            });
            assert!(upper >= nearest(&witness.distance) * (1.0 - 1e-9), "{curve} {level}: {upper}");
            assert!(lower <= nearest(constant.upper()) * (1.0 + 1e-9), "{curve} {level}: {lower}");
            assert!(upper <= 1.06 * lower, "{curve} {level}: {lower} {upper}");
        }
    }
}
