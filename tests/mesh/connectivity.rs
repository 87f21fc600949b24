//! What is a surface, and what is none.

use super::{cube, grid, prism};
use subcert::mesh::{Connectivity, MeshError};

fn refused(points: usize, faces: &[&[usize]]) -> MeshError {
    let faces = faces.iter().map(|face| face.to_vec()).collect();
    Connectivity::new(points, faces).expect_err("no surface")
}

#[test]
fn what_is_no_surface() {
    assert_eq!(refused(3, &[]), MeshError::Empty);
    assert_eq!(refused(2, &[&[0, 1]]), MeshError::FewVertices { face: 0, count: 2 });
    assert_eq!(refused(3, &[&[0, 1, 3]]), MeshError::NoPoint { face: 0, point: 3, count: 3 });
    assert_eq!(refused(3, &[&[0, 1, 2, 1]]), MeshError::Twice { face: 0, point: 1 });
    assert_eq!(refused(4, &[&[0, 1, 2]]), MeshError::Isolated { point: 3 });
    let third = refused(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]);
    assert_eq!(third, MeshError::NonManifoldEdge { ends: [0, 1], face: 2, first: 0 });
    let turned = refused(4, &[&[0, 1, 2], &[0, 1, 3]]);
    assert_eq!(turned, MeshError::Orientation { ends: [0, 1], face: 1, first: 0 });
    let two_fans = refused(5, &[&[0, 1, 2], &[0, 3, 4]]);
    assert_eq!(two_fans, MeshError::NonManifoldVertex { point: 0, face: 1 });
    let huge = refused(3, &[&[0, 1, usize::MAX]]);
    assert!(huge.to_string().contains("does not exist"), "{huge}");
    assert!(matches!(refused(2_000_000, &[&[0, 1, 2]]), MeshError::TooManyPoints { .. }));
}

/// Faces and neighbours of a star go around the vertex in order.
#[test]
fn stars_are_in_order() {
    for mesh in [cube(), prism(5), grid(3, 4, false), grid(3, 4, true)] {
        let connectivity = mesh.connectivity();
        let mut corners = 0;
        for vertex in 0..mesh.points().len() {
            let star = connectivity.star(vertex);
            let n = star.faces.len();
            corners += n;
            assert_eq!(star.valence(), n + usize::from(star.boundary));
            for i in 0..n {
                let face = &mesh.faces()[star.faces[i]];
                let corner = star.corners[i];
                assert_eq!(face[corner], vertex);
                assert_eq!(face[(corner + 1) % face.len()], star.neighbours[i]);
                let next = (i + 1) % star.neighbours.len();
                assert_eq!(face[(corner + face.len() - 1) % face.len()], star.neighbours[next]);
                let edge = &connectivity.edges()[star.edges[i]];
                assert!(edge.ends.contains(&vertex) && edge.ends.contains(&star.neighbours[i]));
                assert_eq!(star.boundary && i == 0, edge.other.is_none());
            }
        }
        assert_eq!(corners, connectivity.corner_count());
    }
}

#[test]
fn euler_characteristics() {
    for (mesh, characteristic) in [(cube(), 2), (prism(7), 2), (grid(3, 4, false), 1)] {
        let connectivity = mesh.connectivity();
        let counted = mesh.points().len() + mesh.faces().len();
        assert_eq!(counted - connectivity.edges().len(), characteristic);
    }
}
