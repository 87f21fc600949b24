//! Limits and normals of meshes, and the points of fine levels.

use super::super::number;
use super::{expressions, matrix, sector, sectors};
use crate::common::r;
use std::cmp::Ordering;
use subcert::exact::{RealCyclotomic, RealExpression, Scalar};
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, PolygonMesh, Sharpness, Tags, limit_points};

/// The faces of a sector alone: its vertex is at the boundary.
fn fan(scheme: &str, faces: usize, corner: bool) -> PolygonMesh<RealCyclotomic> {
    let count = i64::try_from(2 * faces + 2).expect("a small number");
    let point = |i: i64| [i * i % 7 + 2 * i, i * i * i % 11 - i, (5 * i + i * i) % 13];
    let own = |i: usize| match scheme {
        "loop" => vec![0, 1 + i, 2 + i],
        _ => vec![0, 1 + i, 2 + faces + i, 2 + i],
    };
    let count = if scheme == "loop" { 2 + i64::try_from(faces).expect("few") } else { count };
    let points = (0..count).map(|i| point(i).map(RealCyclotomic::from)).collect();
    let mesh = PolygonMesh::new(points, (0..faces).map(own).collect()).expect("a mesh");
    if !corner {
        return mesh;
    }
    let mut tags = Tags::default();
    tags.corner(mesh.connectivity(), 0, Some(Sharpness::Infinite)).expect("a vertex");
    mesh.with_tags(tags)
}

/// Σ w_i x_i.
fn applied(weights: &[RealExpression], mesh: &PolygonMesh<RealCyclotomic>) -> [RealExpression; 3] {
    [0, 1, 2].map(|axis| {
        let terms = weights.iter().zip(mesh.points());
        let product = |(w, x): (&RealExpression, &[RealCyclotomic; 3])| {
            w.times(&RealExpression::from(x[axis].clone()))
        };
        terms.map(product).fold(number(r(0, 1)), |sum, term| sum.plus(&term))
    })
}

fn cross(a: &[RealExpression; 3], b: &[RealExpression; 3]) -> [RealExpression; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i].times(&b[j]).minus(&a[j].times(&b[i])))
}

fn cross_f64(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| a[i] * b[j] - a[j] * b[i])
}

fn dot(a: &[RealExpression; 3], b: &[RealExpression; 3]) -> RealExpression {
    a.iter().zip(b).fold(number(r(0, 1)), |sum, (x, y)| sum.plus(&x.times(y)))
}

// The limits of meshes come from formulas of their own, which agree with OpenSubdiv.
#[test]
fn limits_and_normals_are_those_of_meshes() {
    let mut compared = 0;
    for (scheme, faces, corner) in sectors() {
        let (found, mesh) = (sector(scheme, faces, corner), fan(scheme, faces, corner));
        let kind = if scheme == "loop" { MeshScheme::Loop } else { MeshScheme::CatmullClark };
        let limits = limit_points(&mesh, kind).expect("limits");
        let limit = limits[0].as_ref().expect("a limit");
        let position = limit.position.clone().map(RealExpression::from);
        assert_eq!(applied(&expressions(&found.limit), &mesh), position);
        let stencils: Vec<Vec<RealExpression>> = if corner {
            found.along.iter().map(|one| expressions(one)).collect()
        } else {
            let across = found.across.and_then(|across| across.stencil).expect("a tangent");
            vec![expressions(&found.along[0]), across]
        };
        let tangents = stencils.iter().map(|one| applied(one, &mesh)).collect::<Vec<_>>();
        let Ok(normal) = &limit.normal else {
            assert!(corner && faces > 1);
            continue;
        };
        compared += 1;
        let root = |i: usize| match normal.rooted() {
            None => number(r(0, 1)),
            Some((q, d)) => {
                let root = RealExpression::from(d.clone()).sqrt().expect("a positive number");
                RealExpression::from(q[i].clone()).times(&root)
            }
        };
        let normal =
            [0, 1, 2].map(|i| RealExpression::from(normal.plain()[i].clone()).plus(&root(i)));
        for tangent in &tangents {
            assert_eq!(dot(&normal, tangent).sign(), 0, "{scheme} {faces} {corner}");
        }
        assert_eq!(dot(&normal, &cross(&tangents[0], &tangents[1])).sign(), 1);
    }
    // All creases; corners of one face, and of two triangles.
    assert_eq!(compared, 16 + 3);
}

/// The points of level k, less the limit of the vertex and times a factor, in f64.
fn scaled(scheme: &str, faces: usize, corner: bool, k: u32, factor: f64) -> Vec<[f64; 3]> {
    let matrix: Vec<Vec<f64>> =
        matrix(scheme, faces, corner).iter().map(|row| row.iter().map(nearest).collect()).collect();
    let mesh = fan(scheme, faces, corner);
    let limit = sector(scheme, faces, corner).limit;
    let mut points: Vec<[f64; 3]> =
        mesh.points().iter().map(|x| [0, 1, 2].map(|i| nearest(&x[i]))).collect();
    let sum = |weights: &[f64], points: &[[f64; 3]]| {
        [0, 1, 2].map(|i| weights.iter().zip(points).map(|(w, x)| w * x[i]).sum::<f64>())
    };
    let weights: Vec<f64> = limit.iter().map(nearest).collect();
    // The limit is subtracted at every step: what rounding adds to it would grow.
    let centred = |points: &mut [[f64; 3]]| {
        let origin = sum(&weights, points);
        for x in points {
            *x = [0, 1, 2].map(|i| x[i] - origin[i]);
        }
    };
    centred(&mut points);
    for _ in 0..k {
        points = matrix.iter().map(|row| sum(row, &points).map(|x| x * factor)).collect();
        centred(&mut points);
    }
    points
}

// What `subcert spectrum --sector` says of the points of level k.
#[test]
fn points_tend_to_the_stated_lines_and_planes() {
    for (scheme, faces, corner) in sectors() {
        let (found, mesh) = (sector(scheme, faces, corner), fan(scheme, faces, corner));
        let vector = |stencil: &[RealExpression]| applied(stencil, &mesh).map(|x| nearest(&x));
        let along: Vec<[f64; 3]> =
            found.along.iter().map(|one| vector(&expressions(one))).collect();
        let across = found.across.as_ref();
        let side = across.map_or(Ordering::Less, |across| across.side);
        let length = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let unit = |x: [f64; 3]| x.map(|entry| entry / length(x));
        // The distance from a line through 0, or from a plane.
        let off_line = |x: [f64; 3], line: [f64; 3]| length(cross_f64(x, unit(line)));
        let off_plane = |x: [f64; 3], [a, b]: [[f64; 3]; 2]| {
            let normal = unit(cross_f64(a, b));
            (0..3).map(|i| x[i] * normal[i]).sum::<f64>().abs()
        };
        let tangent = || {
            let stencil = across.and_then(|one| one.stencil.as_ref()).expect("a stencil");
            vector(stencil)
        };
        let (points, off): (_, Box<dyn Fn([f64; 3]) -> f64>) = match (corner, side) {
            (false, Ordering::Less) => {
                let line = along[0];
                (scaled(scheme, faces, corner, 40, 2.0), Box::new(move |x| off_line(x, line)))
            }
            (true, Ordering::Equal) => {
                let line = [0, 1, 2].map(|i| along[0][i] + along[1][i]);
                let mut points = scaled(scheme, faces, corner, 40_000, 2.0);
                for x in &mut points {
                    *x = x.map(|x| x / 40_000.0);
                }
                (points, Box::new(move |x| off_line(x, line)))
            }
            (_, Ordering::Greater) => {
                let value = across.map(|one| nearest(&one.eigenvalue)).expect("an eigenvalue");
                let line = tangent();
                let points = scaled(scheme, faces, corner, 400, 1.0 / value);
                (points, Box::new(move |x| off_line(x, line)))
            }
            (false, Ordering::Equal) | (true, Ordering::Less) => {
                let second = if corner { along[1] } else { tangent() };
                let plane = [along[0], second];
                (scaled(scheme, faces, corner, 80, 2.0), Box::new(move |x| off_plane(x, plane)))
            }
        };
        let most = points.iter().map(|x| length(*x)).fold(0.0, f64::max);
        assert!(most > 1e-2, "{scheme} {faces} {corner}: {most}");
        for x in &points {
            assert!(off(*x) < 1e-2 * most, "{scheme} {faces} {corner}: {x:?}");
        }
    }
}

// Near a crease, normals tend to that of both tangents; inside of the sector to another one, where block 2 outweighs the crease.
#[test]
fn normals_of_many_faces_have_no_limit() {
    for (scheme, faces, _) in sectors().filter(|(_, faces, corner)| *faces > 2 && !corner) {
        let across = sector(scheme, faces, false).across.expect("an eigenvalue");
        let most = if scheme == "loop" { 6 } else { 4 };
        assert_eq!(across.second_above, faces > most, "{scheme} {faces}");
        if faces == most {
            continue;
        }
        let points = scaled(scheme, faces, false, 60, 1.0 / nearest(&across.eigenvalue));
        let normal = |i: usize| {
            let side = |j: usize| [0, 1, 2].map(|axis| points[1 + j][axis] - points[0][axis]);
            let normal = cross_f64(side(i), side(i + 1));
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            normal.map(|x| x / length)
        };
        let between = cross_f64(normal(0), normal(faces / 2));
        let sine = between.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert_eq!(sine > 0.02, faces > most, "{scheme} {faces}: {sine}");
    }
}

// The three vectors of the text are independent for these points, so that no plane has all of them.
#[test]
fn corners_of_many_faces_have_no_tangent_plane() {
    for (scheme, faces) in [("catmull-clark", 3), ("loop", 4), ("catmull-clark", 7)] {
        let (found, mesh) = (sector(scheme, faces, true), fan(scheme, faces, true));
        let across = found.across.expect("an eigenvalue").stencil.expect("a stencil");
        let [a, b] = [0, 1].map(|i| applied(&expressions(&found.along[i]), &mesh));
        assert_ne!(dot(&cross(&a, &b), &applied(&across, &mesh)).sign(), 0, "{scheme} {faces}");
    }
}
