//! Meshes with creases, corners, boundaries and holes, refined with their tags.

use super::naive::check;
use super::{Mesh, bumpy, cube, depth, distances, fan, octahedron, prism};
use crate::common::hausdorff::of_triangles;
use crate::common::r;
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::float::nearest;
use subcert::mesh::{
    Boundary, Creasing, MeshScheme, Point, PolygonMesh, Sharpness, Tags, limit_points, refine_mesh,
};
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
        assert!(depth.level.is_some_and(|level| level <= parametric), "{depth:?}");
        let place = depth.beyond.as_ref().expect("level 0 is not enough");
        assert!(place.distance >= nearest(&tolerance));
        assert!(place.vertex.is_none_or(|vertex| mesh.faces()[place.face].contains(&vertex)));
    }
}

/// The mesh with these edges, vertices and faces sharp, or holes.
fn tagged(
    mesh: &Mesh,
    edges: &[([usize; 2], Rational)],
    vertices: &[(usize, Rational)],
    holes: &[usize],
) -> Mesh {
    let mut tags = mesh.tags().clone();
    for (ends, value) in edges {
        tags.crease(mesh.connectivity(), *ends, Sharpness::new(value)).expect("an edge");
    }
    for (vertex, value) in vertices {
        tags.corner(mesh.connectivity(), *vertex, Sharpness::new(value)).expect("a vertex");
    }
    for hole in holes {
        tags.hole(mesh.connectivity(), *hole).expect("a face");
    }
    mesh.clone().with_tags(tags)
}

/// Ends of creases, corners of two kinds, finite sharpness, holes and boundaries.
fn others() -> Vec<(MeshScheme, Mesh)> {
    let infinite = || r(10, 1);
    let quadrilaterals = [
        tagged(&cube(), &[([0, 1], infinite())], &[], &[]),
        tagged(
            &cube(),
            &[([0, 1], infinite()), ([1, 3], infinite()), ([5, 1], infinite())],
            &[],
            &[],
        ),
        tagged(&cube(), &[], &[(3, infinite()), (4, r(3, 2))], &[]),
        tagged(&cube(), &[([4, 5], r(3, 4)), ([5, 7], r(5, 2)), ([7, 6], infinite())], &[], &[2]),
        tagged(
            &prism(5),
            &[([0, 1], infinite()), ([1, 2], infinite()), ([2, 3], r(1, 2))],
            &[],
            &[],
        ),
        bounded(bumpy(4, 4, false), Boundary::Corner),
        bounded(bumpy(5, 5, false), Boundary::None),
        tagged(
            &bumpy(4, 4, false),
            &[([1, 5], infinite()), ([5, 9], infinite()), ([6, 7], r(4, 3))],
            &[],
            &[4],
        ),
        tagged(&fan(4, false, false), &[([0, 3], infinite())], &[], &[]),
    ];
    let triangles = [
        tagged(&octahedron(), &[([0, 1], infinite()), ([1, 2], r(7, 5))], &[(5, infinite())], &[]),
        tagged(
            &octahedron(),
            &[([0, 4], infinite()), ([1, 4], infinite()), ([2, 4], infinite())],
            &[],
            &[0],
        ),
        bounded(bumpy(4, 4, true), Boundary::Corner),
        tagged(&fan(5, true, false), &[([0, 3], r(1, 3))], &[(1, r(2, 1))], &[]),
    ];
    let quadrilaterals = quadrilaterals.into_iter().map(|mesh| (MeshScheme::CatmullClark, mesh));
    let triangles = triangles.into_iter().enumerate();
    let triangles = triangles.map(|(i, mesh)| {
        (if i % 2 == 0 { MeshScheme::Loop } else { MeshScheme::LoopWarren }, mesh)
    });
    quadrilaterals.chain(triangles).collect()
}

fn agrees(mesh: &Mesh, scheme: MeshScheme, tolerance: &Rational) -> Result<(), TestCaseError> {
    check(mesh, scheme, tolerance)?;
    let guaranteed = a_priori(mesh, scheme, tolerance).expect("a level");
    let found = depth(mesh, scheme, tolerance);
    prop_assert!(found.level <= guaranteed.level, "{found:?}, {guaranteed:?}");
    bounds_hold(mesh, scheme, 0, 2)?;
    bounds_hold(mesh, scheme, 1, 2)
}

fn bounds_hold(
    mesh: &Mesh,
    scheme: MeshScheme,
    level: u32,
    more: u32,
) -> Result<(), TestCaseError> {
    let bounds = distances(mesh, scheme).faces(level);
    for (face, sampled) in face_samples(mesh, scheme, level, more).into_iter().enumerate() {
        let [lower, upper] = bounds[face];
        prop_assert!(
            sampled <= upper * (1.0 + 1e-9) + 1e-12,
            "{face}, {level}: {sampled} > {upper}"
        );
        prop_assert!(lower <= sampled * 1.25 + 1e-12, "{face}, {level}: {sampled} < {lower}");
    }
    Ok(())
}

/// For each face the greatest distance of its limit points, `more` levels later, from the mesh of a level. Holes have 0.
fn face_samples(mesh: &Mesh, scheme: MeshScheme, level: u32, more: u32) -> Vec<f64> {
    let mut samples = vec![0.0_f64; mesh.faces().len()];
    let (fine, limits, values) = refined_with_values(mesh, scheme, level, more);
    let holes = fine.tags().holes(fine.connectivity());
    let parts = |size: usize| if scheme == MeshScheme::CatmullClark { size } else { 4 };
    let owners: Vec<usize> = (0..mesh.faces().len())
        .flat_map(|face| {
            std::iter::repeat_n(face, parts(mesh.faces()[face].len()) << (2 * (level + more) - 2))
        })
        .collect();
    for (face, vertices) in
        fine.faces().iter().enumerate().filter(|(face, _)| !holes.contains(face))
    {
        for &v in vertices {
            let off = [0, 1, 2].map(|i| (limits[v][i] - values[v][i]).powi(2));
            let sample = &mut samples[owners[face]];
            *sample = sample.max(off.iter().sum::<f64>().sqrt());
        }
    }
    samples
}

#[test]
fn limit_points_of_all_that_is_sharp_are_within_the_tolerance() {
    for (i, (scheme, mesh)) in others().into_iter().enumerate() {
        for tolerance in [r(1, 2), r(1, 12), r(1, 50)] {
            agrees(&mesh, scheme, &tolerance).unwrap_or_else(|error| panic!("{i}: {error}"));
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(16))]

    /// Any edges and vertices of any sharpness, by both rules for how it falls.
    #[test]
    fn any_sharpness(
        which in 0_usize..6,
        edges in prop::collection::vec((0_usize..1_000, 0_usize..5), 0..8),
        vertices in prop::collection::vec((0_usize..1_000, 0_usize..5), 0..2),
        chaikin in any::<bool>(),
        boundary in 0_usize..3,
        tolerance in (1_i64..40).prop_map(|q| r(3, q)),
    ) {
        let (scheme, mesh) = [
            (MeshScheme::CatmullClark, cube()),
            (MeshScheme::CatmullClark, prism(5)),
            (MeshScheme::CatmullClark, bumpy(4, 4, false)),
            (MeshScheme::Loop, octahedron()),
            (MeshScheme::LoopWarren, bumpy(4, 4, true)),
            (MeshScheme::Loop, fan(7, true, true)),
        ][which].clone();
        let values = [r(1, 2), r(4, 3), r(5, 1), r(10, 1), r(10, 1)];
        let all = mesh.connectivity().edges();
        let edges: Vec<_> =
            edges.iter().map(|(at, s)| (all[at % all.len()].ends, values[*s].clone())).collect();
        let vertices: Vec<_> = vertices
            .iter()
            .map(|(at, s)| (at % mesh.points().len(), values[*s].clone()))
            .collect();
        let mesh = tagged(&mesh, &edges, &vertices, &[]);
        let mut tags = mesh.tags().clone();
        tags.boundary = Boundary::NAMES[boundary].0;
        tags.creasing = if chaikin { Creasing::Chaikin } else { Creasing::Uniform };
        let holes = tags.holes(mesh.connectivity()).len();
        prop_assume!(holes < mesh.faces().len());
        agrees(&mesh.with_tags(tags), scheme, &tolerance)?;
    }
}

/// By Chaikin's rule an edge of sharpness 3/10 stays sharp beside sharper ones at both ends, one of which is no edge of a
/// face at the first end, or of its neighbours. Its far end is so high that this changes the limit of a face by a half of a
/// hundredth, as samples after three levels show.
#[test]
fn sharp_edges_that_do_not_touch_the_face() {
    let turns = [[1, 0], [1, 1], [0, 1], [-1, 0], [-1, -1], [0, -1]];
    // Each direction once.
    for (turn, [i, j]) in turns.into_iter().enumerate().step_by(2) {
        let number = |[i, j]: [i64; 2]| usize::try_from(5 * (2 + i) + 2 + j).expect("inside");
        let [a, b, beyond] = [[0, 0], [i, j], [2 * i, 2 * j]].map(number);
        let mut points: Vec<[i64; 3]> = (0..25).map(|at| [at / 5, at % 5, 0]).collect();
        points[a][2] = 8;
        points[b][2] = 1000;
        let faces = crate::common::meshes::grid_faces(5, 5, true);
        let sharp = [
            ([a, b], r(3, 10)),
            ([a, number(turns[(turn + 2) % 6])], r(13, 2)),
            ([b, beyond], r(99, 10)),
        ];
        let mesh = tagged(&super::mesh(&points, faces), &sharp, &[], &[]);
        let mut tags = mesh.tags().clone();
        tags.creasing = Creasing::Chaikin;
        let mesh = mesh.with_tags(tags);
        bounds_hold(&mesh, MeshScheme::Loop, 0, 3)
            .unwrap_or_else(|error| panic!("{i} {j}: {error}"));
    }
}

type Values = Vec<[f64; 3]>;

/// The mesh of some levels after a level, its limit points, and the mesh of the level at the same parameters.
fn refined_with_values(
    mesh: &Mesh,
    scheme: MeshScheme,
    level: u32,
    more: u32,
) -> (PolygonMesh<RealCyclotomic>, Values, Values) {
    let exact = mesh.map(|x| RealCyclotomic::from(x.clone()));
    let mut fine = refine_mesh(&exact, scheme, level).expect("small");
    let to_f64 = |point: &Point<RealCyclotomic>| point.each_ref().map(nearest);
    let mut values: Values = fine.points().iter().map(to_f64).collect();
    for _ in 0..more {
        let mean = |points: &[usize]| {
            let count = f64::from(u32::try_from(points.len()).expect("few"));
            [0, 1, 2].map(|i| points.iter().map(|&v| values[v][i]).sum::<f64>() / count)
        };
        let mut next = values.clone();
        next.extend(fine.connectivity().edges().iter().map(|edge| mean(&edge.ends)));
        if scheme == MeshScheme::CatmullClark {
            next.extend(fine.faces().iter().map(|face| mean(face)));
        }
        fine = refine_mesh(&fine, scheme, 1).expect("small");
        values = next;
    }
    let limits = limit_points(&fine, scheme).expect("small");
    let limits =
        limits.iter().map(|limit| to_f64(&limit.as_ref().expect("a limit").position)).collect();
    (fine, limits, values)
}

/// The limit and the mesh of a level as triangles between limit points, and points of the mesh, of some levels later.
fn triangles(mesh: &Mesh, scheme: MeshScheme, level: u32, more: u32) -> [Vec<[[f64; 3]; 3]>; 2] {
    let (fine, limits, values) = refined_with_values(mesh, scheme, level, more);
    let holes = fine.tags().holes(fine.connectivity());
    let faces = fine.faces().iter().enumerate().filter(|(face, _)| !holes.contains(face));
    let all: Vec<[usize; 3]> = faces
        .flat_map(|(_, face)| (2..face.len()).map(|i| [face[0], face[i - 1], face[i]]))
        .collect();
    [limits, values].map(|points| all.iter().map(|ends| ends.map(|v| points[v])).collect())
}

/// The least level of sets, against samples.
#[test]
fn all_that_is_sharp_as_sets_of_points() {
    for (i, (scheme, mesh)) in others().into_iter().enumerate() {
        let quadrilaterals = mesh.faces().iter().all(|face| face.len() == 4);
        if scheme == MeshScheme::CatmullClark && !quadrilaterals {
            continue;
        }
        let found = MeshDistances::new(mesh.clone(), scheme).expect("small").without_apart();
        let tolerance = r(1, 12);
        let depth = found.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few");
        let level = depth.level.expect("a level");
        assert!(level <= found.depth(&tolerance).expect("few").level);
        let sampled = |level: u32| {
            let [limit, _] = triangles(&mesh, scheme, 0, 4);
            let [_, polygons] = triangles(&mesh, scheme, level, 4 - level.min(3));
            of_triangles(limit, polygons)
        };
        if level <= 3 {
            assert!(sampled(level) <= nearest(&tolerance) * 1.02, "{i}: {depth:?}");
        }
        if let Some(few) = depth.too_few.filter(|few| *few <= 3) {
            assert!(sampled(few) >= nearest(&tolerance) * 0.98, "{i}: {depth:?}");
            assert_eq!(few + 1, level, "{i}");
        }
    }
}

/// Heights over three faces at a boundary vertex: the longest edge, 1, shrinks to 3/4 in one level.
#[test]
fn edges_shrink_no_faster_than_is_said() {
    let heights = [0, 0, -1, -1, 1, -1, -2, 0];
    let faces = vec![vec![0, 1, 5, 2], vec![0, 2, 6, 3], vec![0, 3, 7, 4]];
    let mesh = super::mesh(&heights.map(|x| [x, 0, 0]), faces);
    let exact = mesh.map(|x| RealCyclotomic::from(x.clone()));
    let next = refine_mesh(&exact, MeshScheme::CatmullClark, 1).expect("small");
    let longest = |mesh: &PolygonMesh<RealCyclotomic>| {
        let height = |end: usize| nearest(&mesh.points()[end][0]);
        let edges = mesh.connectivity().edges().iter();
        edges.map(|edge| (height(edge.ends[0]) - height(edge.ends[1])).abs()).fold(0.0, f64::max)
    };
    assert_eq!((longest(&exact), longest(&next)), (1.0, 0.75));
    let guaranteed = a_priori(&mesh, MeshScheme::CatmullClark, &r(1, 10)).expect("a level");
    assert!((guaranteed.ratio - 0.75).abs() < 1e-15);
    let ended = tagged(&cube(), &[([0, 1], r(10, 1))], &[], &[]);
    let guaranteed = a_priori(&ended, MeshScheme::CatmullClark, &r(1, 10)).expect("a level");
    assert!((guaranteed.ratio - 5.0 / 6.0).abs() < 1e-15);
}

#[test]
fn what_has_no_distance_is_refused() {
    let refused = |mesh: Mesh, scheme| {
        MeshDistances::new(mesh, scheme).map(|_| ()).expect_err("refused").to_string()
    };
    let loops = creased(&cube(), &[4, 5, 7, 6]);
    assert!(refused(loops, MeshScheme::DooSabin).contains("no rules for creases"));
    let holes = tagged(&cube(), &[], &[], &[0, 1, 2, 3, 4, 5]);
    assert!(refused(holes, MeshScheme::CatmullClark).contains("the surface is empty"));
}
