//! Laws: affine maps, renumbering, levels one after another.

use super::{Mesh, examples, octahedron, points};
use proptest::prelude::*;
use subcert::exact::{RealCyclotomic, Scalar};
use subcert::mesh::{LimitPoint, MeshScheme, Point, PolygonMesh, limit_points, refine_mesh};

fn refined(mesh: &Mesh, scheme: MeshScheme, level: u32) -> Mesh {
    refine_mesh(mesh, scheme, level).expect("a mesh within the caps")
}

fn limits(mesh: &Mesh, scheme: MeshScheme) -> Vec<Option<LimitPoint>> {
    limit_points(mesh, scheme).expect("a mesh within the caps")
}

#[test]
fn levels_add_up() {
    for scheme in MeshScheme::ALL {
        for mesh in examples(scheme) {
            assert_eq!(refined(&mesh, scheme, 0), mesh);
            assert_eq!(refined(&refined(&mesh, scheme, 1), scheme, 1), refined(&mesh, scheme, 2));
        }
    }
}

/// The rows and the offset of an affine map, as images of the axes and of the origin.
fn image(map: &[Point<RealCyclotomic>], point: &Point<RealCyclotomic>) -> Point<RealCyclotomic> {
    std::array::from_fn(|i| {
        (0..3).fold(map[3][i].clone(), |sum, j| sum.plus(&map[j][i].times(&point[j])))
    })
}

fn mapped(mesh: &Mesh, map: &[Point<RealCyclotomic>]) -> Mesh {
    mesh.with_points(mesh.points().iter().map(|point| image(map, point)).collect())
}

proptest! {
    #![proptest_config(crate::common::cases(4))]

    #[test]
    fn affine_maps_commute_with_refinement_and_limits(map in points(4)) {
        for scheme in MeshScheme::ALL {
            for mesh in examples(scheme) {
                let moved = mapped(&mesh, &map);
                let expected = mapped(&refined(&mesh, scheme, 1), &map);
                prop_assert_eq!(&refined(&moved, scheme, 1), &expected);
                let positions = |limits: Vec<Option<LimitPoint>>| -> Vec<_> {
                    limits.into_iter().map(|limit| limit.map(|limit| limit.position)).collect()
                };
                let found = positions(limits(&moved, scheme));
                let expected = positions(limits(&mesh, scheme));
                let expected: Vec<_> =
                    expected.iter().map(|point| point.as_ref().map(|p| image(&map, p))).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }

    /// Numbering points and faces otherwise changes nothing but numbers.
    #[test]
    fn numbers_do_not_matter(order in Just((0..6).collect::<Vec<usize>>()).prop_shuffle()) {
        let mesh = octahedron();
        let mut points = mesh.points().to_vec();
        for (old, new) in order.iter().enumerate() {
            points[*new] = mesh.points()[old].clone();
        }
        let mut faces: Vec<Vec<usize>> =
            mesh.faces().iter().map(|face| face.iter().map(|v| order[*v]).collect()).collect();
        faces.reverse();
        for face in &mut faces {
            face.rotate_left(1);
        }
        let other = PolygonMesh::new(points, faces).expect("a surface");
        for scheme in MeshScheme::ALL {
            let sorted = |mesh: &Mesh| {
                let mut points = refined(mesh, scheme, 2).points().to_vec();
                points.sort();
                points
            };
            prop_assert!(sorted(&mesh) == sorted(&other));
        }
    }
}
