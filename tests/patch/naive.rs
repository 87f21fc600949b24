//! The definition: meshes refined as a whole, and their limit points against the mesh of a level at
//! the same parameters.

use super::{Mesh, depth, distances, examples, moved};
use crate::common::r;
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic, Scalar};
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, Point, PolygonMesh, limit_points, refine_mesh};

type Numbers = PolygonMesh<RealCyclotomic>;
type P = Point<f64>;

fn mean(points: &[P]) -> P {
    let count = f64::from(u32::try_from(points.len()).expect("few"));
    [0, 1, 2].map(|i| points.iter().map(|point| point[i]).sum::<f64>() / count)
}

fn minus(p: &P, q: &P) -> P {
    [0, 1, 2].map(|i| p[i] - q[i])
}

fn length([p, q]: [&P; 2]) -> f64 {
    (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt()
}

/// Means of the vertices of faces or edges.
fn means(groups: impl Iterator<Item = Vec<usize>>, values: &[P]) -> Vec<P> {
    groups.map(|group| mean(&group.iter().map(|&v| values[v]).collect::<Vec<_>>())).collect()
}

fn edges(mesh: &Numbers) -> impl Iterator<Item = Vec<usize>> + '_ {
    mesh.connectivity().edges().iter().map(|edge| edge.ends.to_vec())
}

fn rounded(mesh: &Numbers) -> Vec<P> {
    mesh.points().iter().map(|point| point.each_ref().map(nearest)).collect()
}

/// The greatest distance of the limit points of level `level` + `more` from the mesh of that level.
fn sampled(control: &Mesh, scheme: MeshScheme, level: u32, more: u32) -> f64 {
    let differences = differences(control, scheme, level, more);
    differences.iter().map(|x| length([x, &[0.0; 3]])).fold(0.0, f64::max)
}

/// Those limit points less the points of the mesh of level `level` at the same parameters.
pub(super) fn differences(control: &Mesh, scheme: MeshScheme, level: u32, more: u32) -> Vec<P> {
    let exact = control.map(|x| RealCyclotomic::from(x.clone()));
    let mut mesh = refine_mesh(&exact, scheme, level).expect("small");
    if scheme == MeshScheme::DooSabin {
        return differences_at_faces(mesh, more);
    }
    let mut values = rounded(&mesh);
    for _ in 0..more {
        let mut next = values.clone();
        next.extend(means(edges(&mesh), &values));
        if [MeshScheme::CatmullClark, MeshScheme::Bajaj].contains(&scheme) {
            next.extend(means(mesh.faces().iter().cloned(), &values));
        }
        values = next;
        mesh = refine_mesh(&mesh, scheme, 1).expect("small");
    }
    let limits = limit_points(&mesh, scheme).expect("small");
    // Holes are no part of the surface.
    let holes = mesh.tags().holes(mesh.connectivity());
    let seen = |vertex: &usize| {
        holes.is_empty()
            || !mesh.connectivity().star(*vertex).faces.iter().all(|x| holes.contains(x))
    };
    let difference = |(value, limit): (&P, &Option<subcert::mesh::LimitPoint>)| {
        let limit = limit.as_ref().expect("a limit").position.each_ref().map(nearest);
        minus(&limit, value)
    };
    let pairs = values.iter().zip(&limits).enumerate().filter(|(vertex, _)| seen(vertex));
    pairs.map(|(_, pair)| difference(pair)).collect()
}

/// Doo and Sabin's faces tend to their centroids. The mesh of the first level is bilinear between a vertex,
/// the middles of two edges and a centroid.
fn differences_at_faces(mut mesh: Numbers, more: u32) -> Vec<P> {
    let points = rounded(&mesh);
    let mut at_edges = means(edges(&mesh), &points);
    let mut at_faces = means(mesh.faces().iter().cloned(), &points);
    let mut at_points = points;
    let mut differences = Vec::new();
    for _ in 0..=more {
        let connectivity = mesh.connectivity();
        let mut corners = Vec::new();
        for (face, vertices) in mesh.faces().iter().enumerate() {
            let own = connectivity.face_edges(face);
            for (i, &vertex) in vertices.iter().enumerate() {
                let before = own[(i + own.len() - 1) % own.len()];
                let quarter =
                    [at_points[vertex], at_edges[own[i]], at_faces[face], at_edges[before]];
                corners.push((vertex, face, mean(&quarter)));
            }
        }
        // The new faces: of faces, of inner edges, of inner vertices.
        let inner: Vec<usize> =
            (0..connectivity.point_count()).filter(|&v| !connectivity.star(v).boundary).collect();
        let mut new_faces = at_faces.clone();
        let inner_edges = connectivity.edges().iter().zip(&at_edges);
        new_faces.extend(inner_edges.filter(|(edge, _)| edge.other.is_some()).map(|(_, x)| *x));
        new_faces.extend(inner.iter().map(|&vertex| at_points[vertex]));
        let next = refine_mesh(&mesh, MeshScheme::DooSabin, 1).expect("small");
        let centres = means(next.faces().iter().cloned(), &rounded(&next));
        // Only the quarters at inner vertices are in the surface: faces with one, edges with one, and
        // vertices.
        let inside = |v: &usize| inner.contains(v);
        let mut counts: Vec<bool> =
            mesh.faces().iter().map(|face| face.iter().any(inside)).collect();
        let inner_edges = connectivity.edges().iter().filter(|edge| edge.other.is_some());
        counts.extend(inner_edges.map(|edge| edge.ends.iter().any(inside)));
        counts.extend(inner.iter().map(|_| true));
        for ((value, centre), counted) in new_faces.iter().zip(&centres).zip(counts) {
            if counted {
                differences.push(minus(centre, value));
            }
        }
        // Between the corners of one face, and of two.
        let across = |edge: &subcert::mesh::Edge| {
            let ends = edge.ends.map(|end| corners[end]);
            let [(v, f, _), (w, g, _)] = ends;
            let own = connectivity.edges().iter().position(|edge| {
                if v == w {
                    let faces = [edge.face.0, edge.other.map_or(usize::MAX, |other| other.0)];
                    edge.ends.contains(&v) && faces.contains(&f) && faces.contains(&g)
                } else {
                    edge.ends == [v, w] || edge.ends == [w, v]
                }
            });
            let middle = at_edges[own.expect("an edge")];
            mean(&[middle, if v == w { at_points[v] } else { at_faces[f] }])
        };
        let new_edges = next.connectivity().edges().iter().map(across).collect();
        at_points = corners.iter().map(|corner| corner.2).collect();
        (at_edges, at_faces, mesh) = (new_edges, new_faces, next);
    }
    differences
}

/// Whether so many limit points can be computed exactly in a test.
fn small(mesh: &Mesh, level: u32) -> bool {
    mesh.connectivity().corner_count() * 4_usize.pow(level + 2) <= 1_500
}

pub(super) fn check(
    mesh: &Mesh,
    scheme: MeshScheme,
    tolerance: &Rational,
) -> Result<(), TestCaseError> {
    let found = distances(mesh, scheme).depth(tolerance).expect("a depth");
    let limit = nearest(tolerance);
    let [lower, upper] = found.distance;
    prop_assert!(lower <= upper && upper <= 1.05 * limit.max(lower), "{found:?}");
    prop_assert!(found.apart <= upper * (1.0 + 1e-9), "{found:?}");
    if small(mesh, found.level) {
        let sample = sampled(mesh, scheme, found.level, 2);
        prop_assert!(
            sample <= upper * (1.0 + 1e-9) + 1e-12,
            "{scheme:?}: {sample} > {upper} {found:?}"
        );
        prop_assert!(sample <= limit * (1.0 + 1e-9), "{scheme:?}: {sample} > {limit}");
        prop_assert!(sample >= 0.8 * lower, "{scheme:?}: {sample} < {lower}");
    }
    if let Some(few) = found.too_few {
        if found.level > few + 1 {
            prop_assert!(small(mesh, few + 1), "{found:?}");
            let sample = sampled(mesh, scheme, few + 1, 2);
            prop_assert!((sample - limit).abs() <= 1e-9 * limit, "{scheme:?}: {sample} {found:?}");
        }
        let far = found.beyond.as_ref().expect("a witness");
        prop_assert!(length([&far.on_mesh, &far.on_limit]) > limit * (1.0 - 1e-9));
        if small(mesh, few) {
            let sample = sampled(mesh, scheme, few, 2);
            prop_assert!(sample >= 0.8 * limit, "{scheme:?}: {sample} at level {few}");
        }
    } else if let Some(open) = found.level.checked_sub(1) {
        // Nothing but a tie is left open.
        prop_assert!(small(mesh, open), "{found:?}");
        let sample = sampled(mesh, scheme, open, 2);
        prop_assert!((sample - limit).abs() <= 1e-9 * limit, "{scheme:?}: {sample} {found:?}");
    }
    Ok(())
}

#[test]
fn sampled_limit_points_are_within_the_tolerance_and_the_witness_is_not() {
    for scheme in MeshScheme::ALL {
        for mesh in examples(scheme) {
            for tolerance in [r(1, 2), r(1, 12), r(1, 50)] {
                check(&mesh, scheme, &tolerance).unwrap_or_else(|error| panic!("{error}"));
            }
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(10))]

    #[test]
    fn any_points(
        (scheme, mesh) in prop::sample::select(MeshScheme::ALL.to_vec()).prop_flat_map(|scheme| {
            let mesh = prop::sample::select(examples(scheme)).prop_flat_map(moved);
            (Just(scheme), mesh)
        }),
        tolerance in (1_i64..40).prop_map(|q| r(3, q)),
    ) {
        check(&mesh, scheme, &tolerance)?;
    }
}

/// The limit of a corner of the cube is at half its distance from the centre, by √3/2 away: the
/// greatest distance of the whole surface from the cube.
#[test]
fn the_cube_by_hand() {
    let found = depth(&super::cube(), MeshScheme::CatmullClark, &r(1, 1));
    let expected = 0.75_f64.sqrt();
    assert_eq!((found.level, found.too_few), (0, None));
    assert!(found.distance[0] <= expected * (1.0 + 1e-12));
    assert!((found.distance[1] - expected).abs() < 2e-3 * expected, "{found:?}");
    let half = Rational::new(1, 2);
    assert!(Scalar::minus(&r(3, 4), &half.times(&half)).sign() > 0);
}
