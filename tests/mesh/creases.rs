//! Creases, corners, boundaries and holes.
//!
//! `.ci/opensubdiv.py` compares the same rules with OpenSubdiv.

use super::{Mesh, cube, grid, mesh, octahedron, prism, star_mesh};
use crate::common::r;
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic, Scalar};
use subcert::mesh::{
    Boundary, Creasing, LimitPoint, MeshError, MeshScheme, Point, PolygonMesh, Sharpness, Tags,
    VertexMask, limit_points, refine_mesh,
};

fn sharp(p: i64, q: i64) -> Option<Sharpness> {
    Sharpness::new(&r(p, q))
}

fn refined(mesh: &Mesh, scheme: MeshScheme, level: u32) -> Mesh {
    refine_mesh(mesh, scheme, level).expect("a small mesh")
}

fn limits(mesh: &Mesh, scheme: MeshScheme) -> Vec<LimitPoint> {
    let limits = limit_points(mesh, scheme).expect("a small mesh");
    limits.into_iter().map(|limit| limit.expect("a limit")).collect()
}

/// The mesh with these edges as creases.
fn creased(mesh: &Mesh, creases: &[([usize; 2], Option<Sharpness>)]) -> Mesh {
    let mut tags = Tags::default();
    for (ends, sharp) in creases {
        tags.crease(mesh.connectivity(), *ends, sharp.clone()).expect("an edge");
    }
    mesh.clone().with_tags(tags)
}

/// A sharp edge that runs through the middle of a grid cuts it in two: the surface is that of both parts
/// with their own boundaries.
#[test]
fn an_infinite_crease_is_a_boundary_of_both_sides() {
    for (triangles, scheme) in [(false, MeshScheme::CatmullClark), (true, MeshScheme::LoopWarren)] {
        let whole = grid(5, 3, triangles);
        let line = [([6, 7], sharp(10, 1)), ([7, 8], sharp(12, 1))];
        let (below, above) = (0..9, 6..15);
        let found = refined(&creased(&whole, &line), scheme, 3);
        for part in [below, above] {
            let start = part.start;
            let faces = whole.faces().iter().filter(|face| face.iter().all(|v| part.contains(v)));
            let faces = faces.map(|face| face.iter().map(|v| v - part.start).collect()).collect();
            let points = whole.points()[part.clone()].to_vec();
            let part = PolygonMesh::new(points, faces).expect("a surface");
            // Three sharp edges meet at the ends of the line: they are corners.
            let mut tags = Tags::default();
            for end in [6, 8] {
                let end = end - start;
                tags.corner(part.connectivity(), end, sharp(10, 1)).expect("a vertex");
            }
            let part = refined(&part.with_tags(tags), scheme, 3);
            assert!(part.points().iter().all(|point| found.points().contains(point)));
        }
        let smooth = refined(&whole, scheme, 3);
        assert!(!found.points().iter().all(|point| smooth.points().contains(point)));
    }
}

/// With one sharp edge of sharpness s between 0 and 1, new points are (1 − s) smooth + s sharp.
#[test]
fn a_fraction_blends_the_two_rules() {
    let ring = |s: Option<Sharpness>| {
        let ends = [[4, 5], [5, 6], [6, 7], [7, 4]];
        refined(&creased(&cube(), &ends.map(|ends| (ends, s.clone()))), MeshScheme::CatmullClark, 1)
    };
    let (smooth, third, full) = (ring(None), ring(sharp(1, 3)), ring(sharp(1, 1)));
    for ((p, q), w) in smooth.points().iter().zip(full.points()).zip(third.points()) {
        for x in 0..3 {
            let blend = p[x].times(&r(2, 3).into()).plus(&q[x].times(&r(1, 3).into()));
            assert_eq!(w[x], blend);
        }
    }
    assert!(third.tags().is_plain() && full.tags().is_plain());
    let later = ring(sharp(5, 2));
    assert_eq!(later.points(), full.points());
    assert!(later.tags().edges().values().all(|one| *one == Sharpness::Finite(r(3, 2))));
    assert_eq!(later.tags().edges().len(), 8);
}

/// 3/4 of its own sharpness and 1/4 of the mean of the others, less 1.
#[test]
fn chaikin_by_hand() {
    let mut tags = Tags::default();
    tags.creasing = Creasing::Chaikin;
    let mesh = octahedron();
    for (end, s) in [(0, sharp(3, 1)), (1, sharp(2, 1)), (2, sharp(1, 1)), (3, sharp(10, 1))] {
        tags.crease(mesh.connectivity(), [4, end], s).expect("an edge");
    }
    let star = mesh.connectivity().star(4);
    let found = tags.children(mesh.connectivity(), &star);
    let of = |end: usize| {
        found[star.neighbours.iter().position(|v| *v == end).expect("a neighbour")].clone()
    };
    // 9/4 + 3/8 − 1, 3/2 + 1/2 − 1, 3/4 + 5/8 − 1.
    assert_eq!([of(0), of(1), of(2)], [sharp(13, 8), sharp(1, 1), sharp(3, 8)]);
    assert_eq!(of(3), Some(Sharpness::Infinite));
    tags.creasing = Creasing::Uniform;
    let found = tags.children(mesh.connectivity(), &star);
    assert_eq!(found.iter().filter(|one| one.is_some()).count(), 3);
}

/// An edge of sharpness 1/2 that stays sharp at one end has the weight 1/2, and at both ends the weight 1.
#[test]
fn a_fraction_beside_sharper_edges() {
    let mesh = octahedron();
    let connectivity = mesh.connectivity();
    let edge = connectivity.edges().iter().position(|edge| [[0, 4], [4, 0]].contains(&edge.ends));
    let mut tags = Tags::default();
    tags.creasing = Creasing::Chaikin;
    tags.crease(connectivity, [4, 0], sharp(1, 2)).expect("an edge");
    let weight = |tags: &Tags| tags.edge_weight(connectivity, edge.expect("an edge"));
    assert_eq!(weight(&tags), r(1, 2));
    // 3/8 + 9/4 − 1 is above 0.
    tags.crease(connectivity, [4, 1], sharp(9, 1)).expect("an edge");
    assert_eq!(weight(&tags), r(1, 2));
    tags.crease(connectivity, [0, 5], sharp(9, 1)).expect("an edge");
    assert_eq!(weight(&tags), r(1, 1));
    tags.creasing = Creasing::Uniform;
    assert_eq!(weight(&tags), r(1, 2));
}

#[test]
fn which_rule_a_vertex_has() {
    let mesh = grid(4, 4, false);
    let mask = |tags: &Tags, v: usize| {
        tags.vertex_mask(mesh.connectivity(), v, &mesh.connectivity().star(v))
    };
    let mut tags = Tags::default();
    assert_eq!(mask(&tags, 0), VertexMask::Crease([1, 4]));
    tags.boundary = Boundary::Corner;
    assert_eq!((mask(&tags, 0), mask(&tags, 5)), (VertexMask::Corner, VertexMask::Smooth));
    tags.crease(mesh.connectivity(), [5, 6], sharp(1, 2)).expect("an edge");
    assert_eq!(mask(&tags, 5), VertexMask::Smooth);
    tags.crease(mesh.connectivity(), [9, 5], sharp(1, 2)).expect("an edge");
    assert!(matches!(mask(&tags, 5), VertexMask::Crease(ends) if ends.contains(&9)));
    tags.crease(mesh.connectivity(), [5, 1], sharp(1, 2)).expect("an edge");
    // Three sharp edges at both: one is inside, two are the boundary.
    assert_eq!([mask(&tags, 5), mask(&tags, 1)], [VertexMask::Corner, VertexMask::Corner]);
    let missing = tags.crease(mesh.connectivity(), [0, 5], sharp(1, 1));
    assert_eq!(missing, Err(MeshError::NoEdge { ends: [0, 5] }));
    assert!(tags.corner(mesh.connectivity(), 16, sharp(1, 1)).is_err());
    assert!(tags.hole(mesh.connectivity(), 9).is_err());
    assert_eq!((sharp(0, 1), sharp(-1, 1), sharp(999, 1)), (None, None, Some(Sharpness::Infinite)));
}

#[test]
fn holes_at_the_boundary() {
    let mesh = grid(5, 5, false);
    let mut tags = Tags::default();
    tags.boundary = Boundary::None;
    tags.hole(mesh.connectivity(), 5).expect("a face");
    let holes = tags.holes(mesh.connectivity());
    assert_eq!(holes.len(), 13);
    let next = refined(&mesh.clone().with_tags(tags.clone()), MeshScheme::CatmullClark, 2);
    assert_eq!(next.tags().holes(next.connectivity()).len(), 13 * 16);
    let plain = refined(&mesh, MeshScheme::CatmullClark, 2);
    assert_eq!(plain.points(), next.points());
    // A boundary that is sharp by itself stays.
    let around: Vec<[usize; 2]> = mesh
        .connectivity()
        .edges()
        .iter()
        .filter(|edge| edge.other.is_none())
        .map(|edge| edge.ends)
        .collect();
    for ends in around {
        tags.crease(mesh.connectivity(), ends, sharp(10, 1)).expect("an edge");
    }
    assert_eq!(tags.holes(mesh.connectivity()).len(), 1);
}

#[test]
fn doo_sabin_has_no_creases() {
    let mesh = creased(&cube(), &[([0, 1], sharp(1, 1))]);
    let error = refine_mesh(&mesh, MeshScheme::DooSabin, 1).expect_err("no rules");
    assert!(error.to_string().contains("no rules for creases"), "{error}");
    assert!(limit_points(&mesh, MeshScheme::DooSabin).is_err());
}

/// One tangent runs along the crease and is halved by each refinement, the other across it; both
/// directions stay, and so do the normals of all sectors.
#[test]
fn normals_of_sectors_do_not_turn() {
    let points = |count: usize| -> Vec<Point<RealCyclotomic>> {
        let number = |i: usize| i64::try_from(i * i * 7 % 23).expect("small");
        (0..count).map(|i| [number(i), number(i + 5), number(2 * i + 1)].map(Into::into)).collect()
    };
    let mut seen = 0;
    for n in 3..=8 {
        for (scheme, count) in
            [(MeshScheme::CatmullClark, 2 * n + 1), (MeshScheme::LoopWarren, n + 1)]
        {
            let star = star_mesh(scheme, n, &points(count));
            for other in 2..=n {
                let line = [([0, 1], sharp(10, 1)), ([0, other], sharp(10, 1))];
                let before = creased(&star, &line);
                let after = refined(&before, scheme, 1);
                let [before, after] = [&before, &after].map(|mesh| limits(mesh, scheme)[0].clone());
                assert_eq!(before.position, after.position);
                assert_eq!(before.sectors.len(), 2);
                for (one, two) in before.sectors.iter().zip(&after.sectors) {
                    let unit = |sector: &subcert::mesh::Sector| {
                        let tangents = sector.tangents.as_ref().expect("a crease");
                        tangents.normal().map(|normal| normal.unit())
                    };
                    // A single face has a Jordan block: its normals only tend to one direction.
                    if one.faces.len() == 1 && scheme == MeshScheme::CatmullClark {
                        continue;
                    }
                    let (Some(one), Some(two)) = (unit(one), unit(two)) else { continue };
                    let apart = (0..3).map(|x| (one[x] - two[x]).abs()).fold(0.0, f64::max);
                    assert!(apart < 1e-12, "{scheme:?} {n} {other}: {one:?} {two:?}");
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 60, "{seen}");
}

/// Meshes with everything in them.
fn tagged() -> impl Strategy<Value = (MeshScheme, Mesh)> {
    let any_sharp = prop_oneof![
        3 => Just(None),
        2 => (1_i64..20).prop_map(|p| sharp(p, 8)),
        2 => Just(sharp(10, 1)),
    ];
    let all = prop::collection::vec(any_sharp, 40);
    let shape = prop_oneof![
        Just((MeshScheme::CatmullClark, cube())),
        Just((MeshScheme::CatmullClark, prism(5))),
        Just((MeshScheme::CatmullClark, grid(3, 4, false))),
        Just((MeshScheme::LoopWarren, octahedron())),
        Just((MeshScheme::LoopWarren, grid(3, 4, true))),
        Just((
            MeshScheme::Loop,
            mesh(
                &[[0, 0, 0], [4, 0, 1], [1, 4, 0], [-3, 3, 2], [-4, -2, 0], [2, -5, 1]],
                &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 5], &[0, 5, 1]]
            )
        )),
    ];
    let boundary = prop_oneof![Just(Boundary::None), Just(Boundary::Edge), Just(Boundary::Corner)];
    (shape, all, boundary, any::<bool>()).prop_map(|((scheme, mesh), sharps, boundary, chaikin)| {
        let mut tags = Tags::default();
        tags.boundary = boundary;
        tags.creasing = if chaikin { Creasing::Chaikin } else { Creasing::Uniform };
        for (edge, sharp) in mesh.connectivity().edges().iter().zip(&sharps) {
            tags.crease(mesh.connectivity(), edge.ends, sharp.clone()).expect("an edge");
        }
        for (vertex, sharp) in (0..mesh.points().len()).zip(sharps.iter().rev()).step_by(5) {
            tags.corner(mesh.connectivity(), vertex, sharp.clone()).expect("a vertex");
        }
        (scheme, mesh.with_tags(tags))
    })
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    /// The limit is that of every level: at creases, corners, ends of creases, and where sharpness falls.
    #[test]
    fn refinement_moves_no_limit((scheme, mesh) in tagged()) {
        let next = refined(&mesh, scheme, 1);
        let (before, after) = (limits(&mesh, scheme), limits(&next, scheme));
        for (vertex, (before, after)) in before.iter().zip(&after).enumerate() {
            prop_assert_eq!(&before.position, &after.position, "vertex {}", vertex);
        }
    }

    /// Sharpness falls to nothing after as many levels as it says, and what is infinite stays.
    #[test]
    fn sharpness_falls((scheme, mesh) in tagged()) {
        let later = refined(&mesh, scheme, 3);
        let left = later.tags().edges().values().chain(later.tags().vertices().values());
        prop_assert!(left.into_iter().all(|one| *one == Sharpness::Infinite));
    }
}

#[test]
fn a_corner_stays_where_it_is() {
    let mut tags = Tags::default();
    tags.corner(cube().connectivity(), 6, sharp(10, 1)).expect("a vertex");
    let mesh = cube().with_tags(tags);
    assert_eq!(limits(&mesh, MeshScheme::CatmullClark)[6].position, cube().points()[6]);
    // One level of a corner of sharpness 1/2: half of the way that the smooth rule goes.
    let mut tags = Tags::default();
    tags.corner(cube().connectivity(), 6, sharp(1, 2)).expect("a vertex");
    let half = refined(&cube().with_tags(tags), MeshScheme::CatmullClark, 1);
    let smooth = refined(&cube(), MeshScheme::CatmullClark, 1);
    let mean = |x: usize| cube().points()[6][x].plus(&smooth.points()[6][x]);
    for x in 0..3 {
        assert_eq!(half.points()[6][x].times(&Rational::from(2).into()), mean(x));
    }
}
