//! Limit points and normals: against the left eigenvectors of the catalogue's rules, known
//! weights, and deep refinement.

use super::{Mesh, cube, examples, grid, number, octahedron, points, star_mesh, tetrahedron};
use crate::common::{r, ring};
use proptest::prelude::*;
use subcert::exact::{Rational, Real, RealCyclotomic, Scalar};
use subcert::limit::LocalLimit;
use subcert::mesh::{LimitPoint, MeshScheme, Point, limit_points, refine_mesh};

fn limits(mesh: &Mesh, scheme: MeshScheme) -> Vec<Option<LimitPoint>> {
    limit_points(mesh, scheme).expect("a mesh within the caps")
}

fn position(mesh: &Mesh, scheme: MeshScheme, vertex: usize) -> Point<RealCyclotomic> {
    limits(mesh, scheme)[vertex].as_ref().expect("a limit point").position.clone()
}

/// p·factor.
fn scaled(point: &Point<RealCyclotomic>, factor: &RealCyclotomic) -> Point<RealCyclotomic> {
    point.each_ref().map(|x| x.times(factor))
}

#[test]
fn known_limit_points() {
    // (9 + 4 − 1)/24 of the corner, for Catmull–Clark.
    let half = scaled(&cube().points()[6], &r(1, 2).into());
    assert_eq!(position(&cube(), MeshScheme::CatmullClark, 6), half);
    // The corner of three faces: (1 + 1/2 + 1/2)/3.
    let part = scaled(&cube().points()[6], &r(2, 3).into());
    assert_eq!(position(&cube(), MeshScheme::DooSabin, 6), part);
    // 1 − 4/(4 + 3/(8·31/256)).
    let part = scaled(&octahedron().points()[0], &r(24, 55).into());
    assert_eq!(position(&octahedron(), MeshScheme::Loop, 0), part);
    // Loop's and Warren's weights are the same for 3 neighbours: 3/16, and so 1 − 4/5.
    let part = scaled(&tetrahedron().points()[1], &r(1, 5).into());
    for scheme in [MeshScheme::Loop, MeshScheme::LoopWarren] {
        assert_eq!(position(&tetrahedron(), scheme, 1), part);
    }
}

/// Of the outer points, only those with n faces around a vertex have rules of the catalogue.
fn agrees_with_ring(scheme: MeshScheme, n: usize, points: &[Point<RealCyclotomic>]) {
    let rules = ring(&format!("{}:N={n}", scheme.name()));
    let points = &points[..rules.point_count()];
    let mesh = star_mesh(scheme, n, points);
    let weights = LocalLimit::new(&rules).expect("a limit");
    for x in 0..3 {
        let terms = weights.weights().iter().zip(points);
        let expected = terms.fold(RealCyclotomic::zero(), |sum, (weight, point)| {
            sum.plus(&weight.times(&point[x]))
        });
        assert_eq!(position(&mesh, scheme, 0)[x], expected, "{scheme:?} {n}");
    }
}

/// The normal of a refined mesh is λ² times that of the mesh.
fn normal_shrinks(scheme: MeshScheme, mesh: &Mesh, vertex: usize, factor: &RealCyclotomic) {
    let refined = refine_mesh(mesh, scheme, 1).expect("small");
    let normal = |mesh: &Mesh| limits(mesh, scheme)[vertex].clone().unwrap().normal.unwrap();
    let expected = scaled(normal(mesh).plain(), &factor.times(factor));
    assert_eq!(*normal(&refined).plain(), expected, "{scheme:?}");
    assert!(normal(&refined).rooted().is_none());
}

/// The same at a Catmull–Clark vertex of another valence than 4: λ = (5 + c + √d)/16, and
/// d = (1 + c)(9 + c) is under the root of the normals too.
fn normal_with_root_shrinks(n: usize, points: &[Point<RealCyclotomic>]) {
    let mesh = star_mesh(MeshScheme::CatmullClark, n, &points[..=2 * n]);
    let refined = refine_mesh(&mesh, MeshScheme::CatmullClark, 1).expect("small");
    let normal = |mesh: &Mesh| limits(mesh, MeshScheme::CatmullClark)[0].clone().unwrap().normal;
    let (before, after) = (normal(&mesh).unwrap(), normal(&refined).unwrap());
    let ((p, (q, d)), (found, root)) =
        ((before.plain(), before.rooted().unwrap()), (after.plain(), after.rooted().unwrap()));
    let c = RealCyclotomic::cosine(&Rational::new(1, n)).expect("small");
    let number = |p: i64| RealCyclotomic::from(p);
    assert_eq!(*d, c.plus(&number(1)).times(&c.plus(&number(9))));
    assert_eq!(root.1, d);
    // λ² = u + w√d.
    let five = c.plus(&number(5));
    let part = RealCyclotomic::from(r(1, 256));
    let u = five.times(&five).plus(d).times(&part);
    let w = five.times(&number(2)).times(&part);
    for x in 0..3 {
        assert_eq!(found[x], p[x].times(&u).plus(&q[x].times(&w).times(d)), "{n}");
        assert_eq!(root.0[x], p[x].times(&w).plus(&q[x].times(&u)), "{n}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(4))]

    #[test]
    fn positions_are_left_eigenvectors_of_the_catalogue(points in points(17)) {
        for scheme in [MeshScheme::CatmullClark, MeshScheme::Loop, MeshScheme::LoopWarren] {
            for n in 3..=8 {
                agrees_with_ring(scheme, n, &points);
            }
        }
    }

    #[test]
    fn tangents_are_eigenvectors_too(points in points(17)) {
        let half = RealCyclotomic::from(r(1, 2));
        normal_shrinks(MeshScheme::CatmullClark, &star_mesh(MeshScheme::CatmullClark, 4, &points[..9]), 0, &half);
        for n in [3, 5, 6, 7, 8] {
            normal_with_root_shrinks(n, &points);
        }
        for n in [3, 4, 5, 7, 8] {
            let cosine = RealCyclotomic::cosine(&Rational::new(1, n)).expect("small");
            let lambda = cosine.times(&r(1, 4).into()).plus(&r(3, 8).into());
            for scheme in [MeshScheme::Loop, MeshScheme::LoopWarren] {
                let mesh = star_mesh(scheme, n, &points[..=n]);
                normal_shrinks(scheme, &mesh, 0, &lambda);
            }
        }
    }
}

/// The new mesh has the same limit, at the vertices that it keeps.
#[test]
fn refinement_moves_no_limit() {
    for scheme in [MeshScheme::CatmullClark, MeshScheme::Loop, MeshScheme::LoopWarren] {
        for mesh in examples(scheme) {
            let refined = refine_mesh(&mesh, scheme, 1).expect("small");
            let (before, after) = (limits(&mesh, scheme), limits(&refined, scheme));
            for (vertex, (before, after)) in before.iter().zip(&after).enumerate() {
                let [before, after] = [before, after].map(|limit| limit.as_ref().expect("a limit"));
                assert_eq!(before.position, after.position, "{scheme:?}, vertex {vertex}");
            }
        }
    }
}

#[test]
fn regular_boundary_normals() {
    let half = RealCyclotomic::from(r(1, 2));
    for vertex in [1, 2, 3, 5] {
        normal_shrinks(MeshScheme::CatmullClark, &grid(4, 5, false), vertex, &half);
        normal_shrinks(MeshScheme::LoopWarren, &grid(4, 5, true), vertex, &half);
    }
    // At a corner of one face that is no corner of the rules, λ is 1/2 along the boundary and 1/4 across.
    let mesh = grid(4, 5, false);
    let refined = refine_mesh(&mesh, MeshScheme::CatmullClark, 1).expect("small");
    let normal = |mesh| limits(mesh, MeshScheme::CatmullClark)[0].clone().unwrap().normal.unwrap();
    let expected = scaled(normal(&mesh).plain(), &RealCyclotomic::from(r(1, 8)));
    assert_eq!(*normal(&refined).plain(), expected);
}

/// The vertices of a deep level, at first those of the mesh, are near the limit points, and the faces around
/// them are nearly orthogonal to the normals.
#[test]
fn deep_levels_are_near_the_limit() {
    for (scheme, mesh) in [
        (MeshScheme::CatmullClark, cube()),
        (MeshScheme::CatmullClark, grid(4, 4, false)),
        (MeshScheme::LoopWarren, octahedron()),
        (MeshScheme::LoopWarren, grid(4, 5, true)),
        (MeshScheme::Loop, tetrahedron()),
    ] {
        let deep = refine_mesh(&mesh, scheme, 5).expect("small");
        for (vertex, limit) in limits(&mesh, scheme).iter().enumerate() {
            let limit = limit.as_ref().expect("a limit point");
            for x in 0..3 {
                let distance = deep.points()[vertex][x].minus(&limit.position[x]).magnitude();
                assert!(distance < number(&r(1, 60)), "{scheme:?} {vertex}: {distance}");
            }
            let Ok(normal) = &limit.normal else { continue };
            let normal = normal.unit().map(|x| number(&subcert::float::exact(x).expect("finite")));
            let around = deep.connectivity().star(vertex).neighbours;
            let edge = |i: usize| -> Point<RealCyclotomic> {
                let (p, q) = (&deep.points()[around[i]], &deep.points()[vertex]);
                std::array::from_fn(|x| p[x].minus(&q[x]))
            };
            let facet = cross(&edge(0), &edge(1));
            let error = cross(&facet, &normal);
            assert!(dot(&facet, &normal).sign() > 0, "{scheme:?} {vertex}: inwards");
            // |sin| < 1/5.
            let bound = dot(&facet, &facet).times(&dot(&normal, &normal)).times(&r(1, 25).into());
            assert!(dot(&error, &error) < bound, "{scheme:?} {vertex}");
        }
    }
}

fn cross(p: &Point<RealCyclotomic>, q: &Point<RealCyclotomic>) -> Point<RealCyclotomic> {
    let minor = |i: usize, j: usize| p[i].times(&q[j]).minus(&p[j].times(&q[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot(p: &Point<RealCyclotomic>, q: &Point<RealCyclotomic>) -> RealCyclotomic {
    (0..3).fold(RealCyclotomic::zero(), |sum, i| sum.plus(&p[i].times(&q[i])))
}

/// Symmetry gives the normals of a cube at its corners, where they have roots, and of its sides.
#[test]
fn normals_of_the_cube() {
    let third = 1.0 / 3.0_f64.sqrt();
    for (vertex, limit) in limits(&cube(), MeshScheme::CatmullClark).iter().enumerate() {
        let unit = limit.as_ref().unwrap().normal.as_ref().unwrap().unit();
        for x in 0..3 {
            let sign = f64::from(cube().points()[vertex][x].sign());
            assert!((unit[x] - sign * third).abs() < 1e-15, "{unit:?}");
        }
    }
    let refined = refine_mesh(&cube(), MeshScheme::CatmullClark, 1).expect("small");
    let sides = &limits(&refined, MeshScheme::CatmullClark)[20..];
    let unit = sides[0].as_ref().unwrap().normal.as_ref().unwrap().unit();
    assert_eq!(unit.map(subcert::float::shortest), ["0.0", "0.0", "-1.0"]);
}

/// A Doo–Sabin surface ends before the boundary of its mesh; inside, the limits are the centres of
/// faces, which stay where they are.
#[test]
fn doo_sabin_limits() {
    let mesh = grid(4, 4, false);
    let found = limits(&mesh, MeshScheme::DooSabin);
    let inner = [5, 6, 9, 10];
    assert!((0..16).all(|v| found[v].is_some() == inner.contains(&v)));
    // The biquadratic B-spline at the middle of its knots: (1, 6, 1)/8 in each direction.
    let weights = [1, 6, 1];
    for x in 0..3 {
        let mut sum = RealCyclotomic::zero();
        for (i, a) in weights.iter().enumerate() {
            for (j, b) in weights.iter().enumerate() {
                let factor = RealCyclotomic::from(Rational::new(a * b, 64));
                sum = sum.plus(&mesh.points()[4 * i + j][x].times(&factor));
            }
        }
        assert_eq!(found[5].as_ref().unwrap().position[x], sum);
    }
    let deep = refine_mesh(&cube(), MeshScheme::DooSabin, 3).expect("small");
    let limit = limits(&cube(), MeshScheme::DooSabin)[6].clone().expect("a limit").position;
    let centre = |face: &Vec<usize>| -> Point<RealCyclotomic> {
        std::array::from_fn(|x| {
            face.iter()
                .fold(RealCyclotomic::zero(), |sum, v| sum.plus(&deep.points()[*v][x]))
                .times(&Rational::new(1, face.len()).into())
        })
    };
    assert!(deep.faces().iter().any(|face| face.len() == 3 && centre(face) == limit));
}
