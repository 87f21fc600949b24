//! Laws: similarities, numbering, later levels.

use super::{Mesh, depth, examples};
use crate::common::r;
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, Point, PolygonMesh};
use subcert::patch::{a_priori, formula_level};

/// A turn by a Pythagorean angle, a stretch by 5, and a move far away.
fn similar(point: &Point<Rational>) -> Point<Rational> {
    let [x, y, z] = point;
    let times = |factor: i64, x: &Rational| Rational::from(factor) * x;
    [
        times(3, y) + times(4, z) + Rational::from(1_000_000_000_007_i64),
        times(5, x) - Rational::from(3),
        times(4, y) - times(3, z),
    ]
}

#[test]
fn similarities_multiply_distances() {
    for scheme in MeshScheme::ALL {
        for mesh in examples(scheme) {
            let image = mesh.with_points(mesh.points().iter().map(similar).collect());
            let here = depth(&mesh, scheme, &r(1, 7));
            let there = depth(&image, scheme, &r(5, 7));
            assert_eq!((here.level, here.too_few), (there.level, there.too_few), "{scheme:?}");
            for (x, y) in here.distance.iter().zip(there.distance) {
                assert!((5.0 * x - y).abs() <= 3e-3 * y.abs(), "{scheme:?} {x} {y}");
            }
        }
    }
}

/// Numbering points and faces otherwise changes nothing but numbers.
#[test]
fn numbers_do_not_matter() {
    for scheme in MeshScheme::ALL {
        for mesh in examples(scheme) {
            let count = mesh.points().len();
            let new = |v: usize| count - 1 - v;
            let mut points = mesh.points().to_vec();
            points.reverse();
            let turned = |face: &Vec<usize>| {
                let mut face: Vec<usize> = face.iter().map(|&v| new(v)).collect();
                face.rotate_left(1);
                face
            };
            let faces = mesh.faces().iter().rev().map(turned).collect();
            let other = PolygonMesh::new(points, faces).expect("the same surface");
            let [here, there] = [&mesh, &other].map(|mesh| depth(mesh, scheme, &r(1, 9)));
            assert_eq!((here.level, here.too_few), (there.level, there.too_few), "{scheme:?}");
        }
    }
}

/// What the mesh needs is never more than what its edges and valences guarantee, and smaller
/// tolerances need more levels.
#[test]
fn bounds_and_tolerances_are_in_order() {
    for scheme in MeshScheme::ALL {
        for mesh in examples(scheme) {
            let mut before = 0;
            for q in [1, 4, 16, 64, 1024] {
                let tolerance = r(1, q);
                let found = depth(&mesh, scheme, &tolerance);
                let guaranteed = a_priori(&mesh, scheme, &tolerance).expect("a mesh with rules");
                assert!(
                    found.level <= guaranteed.level,
                    "{scheme:?} {q}: {found:?} {guaranteed:?}"
                );
                assert!(before <= found.level, "{scheme:?} {q}");
                assert!(found.too_few.is_none_or(|few| few < found.level));
                before = found.level;
            }
        }
    }
}

/// A deep level is decided without the mesh of that level, which nobody could store.
#[test]
fn deep_levels() {
    for scheme in MeshScheme::ALL {
        let mesh: Mesh = examples(scheme).swap_remove(0);
        let tolerance = Rational::new(1, 1_000_000_000);
        let found = depth(&mesh, scheme, &tolerance);
        assert!(found.level >= 10, "{scheme:?} {found:?}");
        assert_eq!(found.too_few, Some(found.level - 1), "{scheme:?} {found:?}");
    }
}

/// A plane net is its own limit, to rounding; that is found at once, however many faces there are.
#[test]
fn a_plane() {
    let mesh = super::grid(60, 60, false, |i, j| Rational::from(2 * i) + Rational::from(3 * j));
    let found = depth(&mesh, MeshScheme::DooSabin, &Rational::new(1, 1_000_000));
    assert_eq!((found.level, found.too_few), (0, None));
    assert!(found.distance[0] <= 1e-12 && found.distance[1] <= 1e-9, "{found:?}");
    // Below what f64 can tell from 0, exact numbers decide.
    let small = super::grid(9, 9, false, |i, j| Rational::from(2 * i) + Rational::from(3 * j));
    let found = depth(&small, MeshScheme::DooSabin, &Rational::new(1, 10).pow(20));
    assert_eq!((found.level, found.too_few), (0, None));
    assert!(found.exact_pieces > 0, "{found:?}");
}

/// Squares have G = 1/2, H = 3/4 and b = 23/16, and triangles, of the vertices, GH = 1/4: 23/16 · 2/(5/8) = 4.6
/// times (3/8)^k is at most 1/100 from k = 7 on.
#[test]
fn the_formula_of_the_paper_by_hand() {
    assert_eq!(formula_level(&super::cube(), 2.0, &r(1, 100)), Some(7));
    assert_eq!(formula_level(&super::cube(), 2.0, &r(47, 10)), Some(0));
}
