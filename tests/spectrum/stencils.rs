//! Stencils: exact eigenvectors, limits of meshes, and many refinements.

use super::{SCHEMES, number, spectrum};
use crate::common::r;
use subcert::exact::{Enclosed, Rational, RealCyclotomic, RealExpression, Scalar};
use subcert::mesh::{MeshScheme, PolygonMesh, limit_points};
use subcert::scheme::LocalRules;
use subcert::spectrum::surroundings;

/// wM for a row w.
fn pulled_back(ring: &LocalRules, row: &[RealExpression]) -> Vec<RealExpression> {
    ring.map(|weight| RealExpression::from(weight.clone())).pull_back(row)
}

#[test]
fn stencils_are_left_eigenvectors() {
    for scheme in SCHEMES {
        for n in [3, 4, 5, 6, 7, 12] {
            let ring = surroundings(scheme, Some(n)).expect("rules").ring;
            let found = spectrum(scheme, n);
            let limit = found.limit.expect("a limit");
            assert_eq!(ring.pull_back(&limit), limit, "{scheme} {n}");
            assert_eq!(RealCyclotomic::total(&limit), RealCyclotomic::from(1));
            let value = found.conditions.subdominant.expect("a subdominant eigenvalue");
            let [first, second] = found.tangents.expect("tangents");
            for tangent in [&first, &second] {
                let expected: Vec<RealExpression> =
                    tangent.iter().map(|weight| weight.times(&value)).collect();
                assert_eq!(pulled_back(&ring, tangent), expected, "{scheme} {n}");
                assert_eq!(RealExpression::total(tangent).sign(), 0);
            }
            // They are cos and sin at the points of the first orbit of n points, and so independent.
            let start = ring.orbits().iter().take_while(|orbit| orbit.count == 1).count();
            let at = |i: usize| (&first[start + i], &second[start + i]);
            assert_eq!((at(0).0, at(0).1.sign()), (&number(r(1, 1)), 0));
            let circle = at(1).0.times(at(1).0).plus(&at(1).1.times(at(1).1));
            assert_eq!((circle, at(1).1.sign()), (number(r(1, 1)), 1));
        }
    }
}

/// A closed mesh with two vertices of valence n: a double pyramid of triangles, or two rings of 2n points
/// with n quadrilaterals on either side.
fn lantern(n: usize, triangles: bool) -> PolygonMesh<RealCyclotomic> {
    let (ring, pole) = if triangles { (n, n) } else { (2 * n, 4 * n) };
    let point = |i: usize| {
        let i = i64::try_from(i).expect("a small number");
        [3 * i % 7 + i, i * i % 11, 5 * i % 13].map(RealCyclotomic::from)
    };
    let mut faces = Vec::new();
    for i in 0..n {
        if triangles {
            faces.push(vec![pole, i, (i + 1) % n]);
            faces.push(vec![pole + 1, (i + 1) % n, i]);
        } else {
            let (a, b, c) = (2 * i, 2 * i + 1, (2 * i + 2) % ring);
            faces.push(vec![pole, a, b, c]);
            faces.push(vec![pole + 1, ring + c, ring + b, ring + a]);
            faces.extend([vec![b, a, ring + a, ring + b], vec![c, b, ring + b, ring + c]]);
        }
    }
    PolygonMesh::new((0..pole + 2).map(point).collect(), faces).expect("a closed mesh")
}

// The limits of meshes come from formulas of their own.
#[test]
fn limits_are_those_of_meshes() {
    for n in [3, 5, 6, 9] {
        for (scheme, triangles) in [
            (MeshScheme::CatmullClark, false),
            (MeshScheme::Loop, true),
            (MeshScheme::LoopWarren, true),
        ] {
            let mesh = lantern(n, triangles);
            let limits = limit_points(&mesh, scheme).expect("limits");
            let pole = mesh.points().len() - 2;
            let position = &limits[pole].as_ref().expect("an inner vertex").position;
            let stencil = spectrum(scheme.name(), n).limit.expect("a limit");
            // The vertex, its neighbours, and the opposite points of its faces.
            let around: Vec<usize> = if triangles {
                std::iter::once(pole).chain(0..n).collect()
            } else {
                let [edges, faces] = [0, 1].map(|first| (0..n).map(move |i| 2 * i + first));
                std::iter::once(pole).chain(edges).chain(faces).collect()
            };
            assert_eq!(around.len(), stencil.len());
            for (axis, expected) in position.iter().enumerate() {
                let terms = stencil.iter().zip(&around);
                let terms: Vec<RealCyclotomic> =
                    terms.map(|(w, &i)| w.times(&mesh.points()[i][axis])).collect();
                assert_eq!(RealCyclotomic::total(&terms), *expected, "{scheme:?} {n}");
            }
        }
    }
}

// After k refinements the ring is near its limit p, and (x^k − p)/λ^k is near a combination of the right
// eigenvectors that the tangents measure.
#[test]
fn stencils_are_limits_of_refinements() {
    for (scheme, n) in [("loop-warren", 4), ("catmull-clark", 5), ("sqrt3", 3), ("doo-sabin", 6)] {
        let ring = surroundings(scheme, Some(n)).expect("rules").ring;
        let found = spectrum(scheme, n);
        let start: Vec<RealCyclotomic> = (0..ring.point_count())
            .map(|i| RealCyclotomic::from(i64::try_from(i * i % 17).expect("a small number")))
            .collect();
        let value = |weights: &[RealCyclotomic], points: &[RealCyclotomic]| {
            let terms: Vec<RealCyclotomic> =
                weights.iter().zip(points).map(|(w, x)| w.times(x)).collect();
            RealCyclotomic::total(&terms)
        };
        let limit = value(found.limit.as_ref().expect("a limit"), &start);
        let mut points = start;
        for _ in 0..60 {
            points = ring.refine(&points);
        }
        for x in &points {
            let off = x.minus(&limit).enclosure(2);
            let most = off.lower().abs().max(off.upper().abs());
            assert!(most < Rational::power_of_ten(-12), "{scheme} {n}: {most}");
        }
    }
}

// The rules on two rings are those of the ring on the inner ring, and nothing else.
#[test]
fn the_ring_is_the_inner_part() {
    for scheme in SCHEMES {
        for n in [3, 4, 7] {
            let rings = surroundings(scheme, Some(n)).expect("rules");
            let wider = rings.wider.expect("a wider ring");
            for a in 0..rings.ring.point_count() {
                let inner: Vec<RealCyclotomic> = rings.ring.weights().row(a).cloned().collect();
                let row: Vec<RealCyclotomic> = wider.weights().row(a).cloned().collect();
                assert_eq!(row[..inner.len()], inner, "{scheme} {n}");
                assert!(row[inner.len()..].iter().all(|weight| weight.sign() == 0));
            }
        }
    }
}
