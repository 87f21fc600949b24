//! Whole meshes against the rules of the catalogue, and against tensor products.

use super::{Mesh, cube, grid, octahedron, points, prism, star_mesh};
use crate::common::{mask, ring};
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::mesh::{MAX_MESH_LEVEL, MeshError, MeshScheme, PolygonMesh, refine_mesh};
use subcert::oracle::{Boundary, refine_grid};

/// The points that the ring of the catalogue gives, by the number of each in the refined mesh.
fn agrees_with_ring(scheme: MeshScheme, n: usize, points: &[[RealCyclotomic; 3]]) {
    let parameter = if scheme == MeshScheme::DooSabin { "n" } else { "N" };
    let rules = ring(&format!("{}:{parameter}={n}", scheme.name()));
    let points = &points[..rules.point_count()];
    let mesh = star_mesh(scheme, n, points);
    let refined = refine_mesh(&mesh, scheme, 1).expect("a mesh within the caps");
    let edge = |i: usize| {
        let edges = mesh.connectivity().edges();
        let found = edges.iter().position(|edge| edge.ends.contains(&0) && edge.ends.contains(&i));
        mesh.points().len() + found.expect("an edge of the vertex")
    };
    let (count, edges) = (mesh.points().len(), mesh.connectivity().edges().len());
    let number = |point: usize| match scheme {
        MeshScheme::DooSabin => point,
        _ if point == 0 => 0,
        _ if point <= n => edge(point),
        _ => count + edges + point - 1 - n,
    };
    for x in 0..3 {
        let control: Vec<RealCyclotomic> = points.iter().map(|point| point[x].clone()).collect();
        for (point, value) in rules.refine(&control).iter().enumerate() {
            assert_eq!(*value, refined.points()[number(point)][x], "{scheme:?} {n}: {point}");
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(4))]

    #[test]
    fn vertices_and_faces_follow_the_catalogue(points in points(21)) {
        for scheme in MeshScheme::ALL {
            for n in 3..=9 {
                agrees_with_ring(scheme, n, &points);
            }
        }
    }
}

/// The points of a tensor product of B-splines, from an open grid.
fn tensor(degree: u32, rows: usize, columns: usize, level: u32) -> Vec<[RealCyclotomic; 3]> {
    let control = grid(rows, columns, false);
    let mask = mask(&format!("b-spline:degree={degree}"));
    let coordinate = |x: usize| -> Vec<Rational> {
        let values = control
            .points()
            .iter()
            .map(|point| point[x].as_rational().expect("a rational point").clone());
        let values: Vec<Rational> = values.collect();
        refine_grid([mask.rules(), mask.rules()], &values, columns, level, Boundary::Open)
            .expect("a grid that is large enough")
            .0
    };
    let [x, y, z] = [coordinate(0), coordinate(1), coordinate(2)];
    x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x.into(), y.into(), z.into()]).collect()
}

#[test]
fn regular_regions_are_tensor_products_of_b_splines() {
    for level in 1..=3 {
        let refined =
            refine_mesh(&grid(6, 5, false), MeshScheme::CatmullClark, level).expect("small");
        let expected = tensor(3, 6, 5, level);
        assert!(expected.len() >= 12);
        assert!(expected.iter().all(|point| refined.points().contains(point)), "{level}");
        let refined = refine_mesh(&grid(4, 5, false), MeshScheme::DooSabin, level).expect("small");
        let (mut found, mut expected) = (refined.points().to_vec(), tensor(2, 4, 5, level));
        found.sort();
        expected.sort();
        assert!(found == expected, "Doo–Sabin, level {level}");
    }
}

#[test]
fn boundaries_are_cubic_b_splines() {
    let (mesh, rules) = (grid(4, 5, false), mask("b-spline:degree=3"));
    let ring: Vec<usize> = vec![0, 1, 2, 3, 4, 9, 14, 19, 18, 17, 16, 15, 10, 5];
    for scheme in [MeshScheme::CatmullClark, MeshScheme::LoopWarren] {
        let mesh = if scheme == MeshScheme::CatmullClark { mesh.clone() } else { grid(4, 5, true) };
        let refined = refine_mesh(&mesh, scheme, 1).expect("small");
        for x in 0..3 {
            let boundary: Vec<Rational> = ring
                .iter()
                .map(|&v| mesh.points()[v][x].as_rational().expect("rational").clone())
                .collect();
            for (v, value) in crate::common::refine(rules.rules(), &boundary).iter().enumerate() {
                // The rule 2i is that of a vertex.
                if v % 2 == 0 {
                    assert_eq!(refined.points()[ring[v / 2]][x], value.clone().into(), "{v}");
                }
            }
        }
    }
}

fn counts(mesh: &Mesh) -> [usize; 3] {
    let connectivity = mesh.connectivity();
    [mesh.points().len(), connectivity.edges().len(), mesh.faces().len()]
}

#[test]
fn numbers_of_points_edges_and_faces() {
    let counted = |mesh: &Mesh, scheme| counts(&refine_mesh(mesh, scheme, 1).expect("small"));
    assert_eq!(counted(&cube(), MeshScheme::CatmullClark), [26, 48, 24]);
    assert_eq!(counted(&cube(), MeshScheme::DooSabin), [24, 48, 26]);
    assert_eq!(counted(&octahedron(), MeshScheme::Loop), [18, 48, 32]);
    assert_eq!(counted(&grid(2, 2, false), MeshScheme::DooSabin), [4, 4, 1]);
}

#[test]
fn what_no_rules_are_for_is_refused() {
    let refused = |mesh: &Mesh, scheme, level| {
        refine_mesh(mesh, scheme, level).map(|_| ()).expect_err("refused")
    };
    let error = refused(&cube(), MeshScheme::Loop, 1);
    assert_eq!(error.face(), Some(0));
    assert!(
        error.to_string().contains("a face of 4 vertices: `loop` refines triangles"),
        "{error}"
    );
    let error = refused(&cube(), MeshScheme::CatmullClark, MAX_MESH_LEVEL + 1);
    assert!(error.to_string().contains("at most 24"), "{error}");
    let error = refused(&cube(), MeshScheme::CatmullClark, 20);
    assert!(matches!(error, MeshError::TooManyPoints { .. }), "{error}");
    let pillow =
        PolygonMesh::new(cube().points()[..4].to_vec(), vec![vec![0, 1, 2, 3], vec![3, 2, 1, 0]]);
    let error = refused(&pillow.expect("a surface"), MeshScheme::CatmullClark, 1);
    assert!(error.to_string().contains("vertex 0: 2 edges meet"), "{error}");
    let error = refused(&prism(257), MeshScheme::DooSabin, 1);
    assert!(error.to_string().contains("a face of 257 vertices"), "{error}");
    assert!(refine_mesh(&prism(100), MeshScheme::CatmullClark, 1).is_ok());
}
