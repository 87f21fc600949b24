//! Meshes with infinitely sharp creases, refined with their tags.

use super::naive::check;
use super::{Mesh, bumpy, cube, distances, octahedron, prism};
use crate::common::r;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::mesh::{Boundary, MeshError, MeshScheme, Sharpness, Tags};
use subcert::patch::{FaceSurface, MeshDistances, a_priori};

/// The mesh with a crease through these vertices, back to the first one.
fn creased(mesh: &Mesh, around: &[usize]) -> Mesh {
    let mut tags = mesh.tags().clone();
    for (i, &from) in around.iter().enumerate() {
        let ends = [from, around[(i + 1) % around.len()]];
        tags.crease(mesh.connectivity(), ends, Some(Sharpness::Infinite)).expect("an edge");
    }
    mesh.clone().with_tags(tags)
}

/// The mesh with this rule at its boundary.
fn bounded(mesh: Mesh, boundary: Boundary) -> Mesh {
    let mut tags = Tags::default();
    tags.boundary = boundary;
    mesh.with_tags(tags)
}

fn meshes() -> Vec<(MeshScheme, Mesh)> {
    let ring: Vec<usize> = (0..5).collect();
    let two = creased(&creased(&prism(5), &ring), &[5, 6, 7, 8, 9]);
    let mut all = vec![
        (MeshScheme::CatmullClark, creased(&cube(), &[4, 5, 7, 6])),
        (MeshScheme::CatmullClark, two),
        (MeshScheme::Loop, creased(&octahedron(), &[0, 1, 2, 3])),
        (MeshScheme::LoopWarren, creased(&octahedron(), &[0, 4, 2, 5])),
    ];
    // Without a boundary, its rules say nothing.
    all.push((MeshScheme::CatmullClark, bounded(cube(), Boundary::Corner)));
    all
}

#[test]
fn limit_points_of_creased_meshes_are_within_the_tolerance() {
    for (scheme, mesh) in meshes() {
        for tolerance in [r(1, 2), r(1, 12), r(1, 50)] {
            check(&mesh, scheme, &tolerance).unwrap_or_else(|error| panic!("{error}"));
            let guaranteed = a_priori(&mesh, scheme, &tolerance).expect("a level");
            let found = distances(&mesh, scheme).depth(&tolerance).expect("a depth");
            assert!(found.level <= guaranteed.level);
            let vertices = [&found.worst, &found.beyond].map(|place| place.as_ref()?.vertex);
            assert!(vertices.into_iter().flatten().all(|v| v < mesh.points().len()), "{found:?}");
        }
    }
}

/// The distance as sets is between that at equal parameters and nothing, and the far point has a vertex of the mesh.
#[test]
fn creased_meshes_as_sets_of_points() {
    for (scheme, mesh) in meshes() {
        let distances = MeshDistances::new(mesh.clone(), scheme).expect("small").without_apart();
        let tolerance = r(1, 20);
        let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few");
        let parametric = distances.depth(&tolerance).expect("few").level;
        assert!(depth.level <= parametric, "{depth:?}");
        let place = depth.beyond.as_ref().expect("level 0 is not enough");
        assert!(place.distance >= nearest(&tolerance));
        assert!(place.vertex.is_none_or(|vertex| mesh.faces()[place.face].contains(&vertex)));
    }
}

#[test]
fn what_else_is_said_of_a_mesh_is_refused() {
    let refused = |mesh: Mesh, scheme| {
        let error = MeshDistances::new(mesh, scheme).map(|_| ()).expect_err("refused");
        (error.point(), error.to_string())
    };
    let catmull_clark = MeshScheme::CatmullClark;
    let tagged = |set: &dyn Fn(&Mesh, &mut Tags) -> Result<(), MeshError>| {
        let (mesh, mut tags) = (cube(), Tags::default());
        set(&mesh, &mut tags).expect("there");
        mesh.with_tags(tags)
    };
    let two = || Sharpness::new(&Rational::from(2));
    let finite = tagged(&|mesh, tags| tags.crease(mesh.connectivity(), [0, 1], two()));
    let (point, message) = refused(finite, catmull_clark);
    assert!(point == Some(0) && message.contains("sharpness 2"), "{message}");
    let dart =
        tagged(&|mesh, tags| tags.crease(mesh.connectivity(), [0, 1], Some(Sharpness::Infinite)));
    let (point, message) = refused(dart, catmull_clark);
    assert!(point == Some(0) && message.contains("a crease ends at this vertex"), "{message}");
    let corner =
        tagged(&|mesh, tags| tags.corner(mesh.connectivity(), 3, Some(Sharpness::Infinite)));
    assert!(refused(corner, catmull_clark).1.contains("sharp by itself"));
    let three = creased(&creased(&cube(), &[4, 5, 7, 6]), &[0, 1, 5, 4]);
    assert!(refused(three, catmull_clark).1.contains("3 creases and boundary edges"));
    let hole = tagged(&|mesh, tags| tags.hole(mesh.connectivity(), 2));
    assert!(refused(hole, catmull_clark).1.contains("holes"));
    for (boundary, words) in [(Boundary::None, "holes"), (Boundary::Corner, "sharp by itself")] {
        let open = bounded(bumpy(4, 4, false), boundary);
        assert!(refused(open, catmull_clark).1.contains(words));
    }
    let loops = creased(&cube(), &[4, 5, 7, 6]);
    assert!(refused(loops, MeshScheme::DooSabin).1.contains("no rules for creases"));
}
