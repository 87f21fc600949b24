//! Sectors between sharp edges: the matrix of the rules, its characteristic polynomial and left eigenvectors, limits of meshes,
//! and many refinements.

use super::number;
use crate::common::r;
use std::cmp::Ordering;
use subcert::exact::{Rational, Real, RealCyclotomic, RealExpression, Scalar};
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, PolygonMesh, Sharpness, Tags, limit_points};
use subcert::spectrum::{MAX_SECTOR_FACES, Sector, SpectrumError};

type Row = Vec<Rational>;

/// Σ of multiples of rows.
fn mix(terms: &[(Rational, &Row)]) -> Row {
    let length = terms[0].1.len();
    let entry = |i: usize| terms.iter().fold(r(0, 1), |sum, (w, row)| &sum + &(w * &row[i]));
    (0..length).map(entry).collect()
}

/// The new points of a sector as combinations of the old ones, from the words of the rules: face points are means, edge points means of the
/// ends and the face points beside, or (3, 3, 1, 1)/8; sharp edges have midpoints.
fn matrix(scheme: &str, faces: usize, corner: bool) -> Vec<Row> {
    let quadrilaterals = scheme == "catmull-clark";
    let points = faces + 2 + if quadrilaterals { faces } else { 0 };
    let unit = |at: usize| -> Row { (0..points).map(|i| r(i64::from(i == at), 1)).collect() };
    let v = unit(0);
    let edge = |i: usize| unit(1 + i);
    let face = |i: usize| unit(2 + faces + i);
    let mean = |rows: &[&Row]| {
        let share = Rational::new(1, rows.len());
        mix(&rows.iter().map(|row| (share.clone(), *row)).collect::<Vec<_>>())
    };
    let face_point = |i: usize| mean(&[&v, &edge(i), &face(i), &edge(i + 1)]);
    let vertex = if corner {
        v.clone()
    } else {
        mix(&[(r(3, 4), &v), (r(1, 8), &edge(0)), (r(1, 8), &edge(faces))])
    };
    let mut rows = vec![vertex];
    for i in 0..=faces {
        rows.push(if i == 0 || i == faces {
            mean(&[&v, &edge(i)])
        } else if quadrilaterals {
            mean(&[&v, &edge(i), &face_point(i - 1), &face_point(i)])
        } else {
            let near = [(r(3, 8), &v), (r(3, 8), &edge(i))];
            let far = [(r(1, 8), &edge(i - 1)), (r(1, 8), &edge(i + 1))];
            mix(&near.into_iter().chain(far).collect::<Vec<_>>())
        });
    }
    if quadrilaterals {
        rows.extend((0..faces).map(face_point));
    }
    rows
}

/// det(x − M) from the constant term upwards, by Hessenberg's form and its recurrence.
fn characteristic(mut m: Vec<Row>) -> Row {
    let n = m.len();
    for step in 1..n.saturating_sub(1) {
        let Some(pivot) = (step..n).find(|&i| !m[i][step - 1].is_zero()) else { continue };
        m.swap(step, pivot);
        m.iter_mut().for_each(|row| row.swap(step, pivot));
        for i in step + 1..n {
            let factor = &m[i][step - 1] / &m[step][step - 1];
            for j in 0..n {
                m[i][j] = &m[i][j] - &(&factor * &m[step][j]);
            }
            for row in &mut m {
                row[step] = &row[step] + &(&factor * &row[i]);
            }
        }
    }
    // p_k = (x − h_kk) p_{k−1} − Σ_i h_{i,k} (h_{i+1,i} … h_{k,k−1}) p_{i−1}.
    let mut found: Vec<Row> = vec![vec![r(1, 1)]];
    for k in 0..n {
        let mut next = vec![r(0, 1)];
        next.extend(found[k].clone());
        let mut product = r(1, 1);
        for i in (0..=k).rev() {
            let factor = &product * &m[i][k];
            for (target, c) in next.iter_mut().zip(&found[i]) {
                *target = &*target - &(&factor * c);
            }
            if i > 0 {
                product = &product * &m[i][i - 1];
            }
        }
        found.push(next);
    }
    found.pop().expect("the last")
}

fn sectors() -> impl Iterator<Item = (&'static str, usize, bool)> {
    let schemes = ["catmull-clark", "loop"];
    schemes.into_iter().flat_map(|scheme| {
        (1..=8).flat_map(move |faces| [false, true].map(|corner| (scheme, faces, corner)))
    })
}

fn sector(scheme: &str, faces: usize, corner: bool) -> Sector {
    Sector::of(scheme, faces, corner).unwrap_or_else(|error| panic!("{error}"))
}

// Every printed number is a root as often as it is said to be, and there are as many as points.
#[test]
fn eigenvalues_are_the_roots() {
    for (scheme, faces, corner) in sectors() {
        let found = sector(scheme, faces, corner);
        let mut polynomial = characteristic(matrix(scheme, faces, corner));
        let points = polynomial.len() - 1;
        assert_eq!(found.orbits.iter().map(|orbit| orbit.count).sum::<usize>(), points);
        assert_eq!(found.eigenvalues.iter().map(|one| one.multiplicity).sum::<usize>(), points);
        let most = found.eigenvalues.iter().map(|one| one.multiplicity).max().expect("one");
        for derivative in 0..=most {
            for one in found.eigenvalues.iter().filter(|one| derivative <= one.multiplicity) {
                let terms = polynomial.iter().rev();
                let value = terms
                    .fold(number(r(0, 1)), |sum, c| sum.times(&one.real).plus(&number(c.clone())));
                assert_eq!(
                    value.sign() == 0,
                    derivative < one.multiplicity,
                    "{scheme} {faces} {corner}: {} in derivative {derivative}",
                    one.real
                );
            }
            let factors = polynomial.iter().enumerate().skip(1);
            polynomial = factors.map(|(k, c)| &Rational::from(k) * c).collect();
        }
        let mut blocks: Vec<usize> =
            found.eigenvalues.iter().flat_map(|one| one.blocks.clone()).collect();
        blocks.sort_unstable();
        let each = if scheme == "loop" { 1 } else { 2 };
        let mut expected = vec![0; 3];
        expected.extend((1..faces).flat_map(|j| std::iter::repeat_n(j, each)));
        if scheme != "loop" {
            expected.push(faces);
        }
        assert_eq!(blocks, expected);
    }
}

/// wM for a row w.
fn pulled_back(matrix: &[Row], weights: &[RealExpression]) -> Vec<RealExpression> {
    let entry = |b: usize| {
        let terms = weights.iter().zip(matrix);
        terms.fold(number(r(0, 1)), |sum, (w, row)| sum.plus(&w.times(&number(row[b].clone()))))
    };
    (0..matrix.len()).map(entry).collect()
}

fn expressions(weights: &[RealCyclotomic]) -> Vec<RealExpression> {
    weights.iter().map(|weight| RealExpression::from(weight.clone())).collect()
}

#[test]
fn stencils_are_left_eigenvectors() {
    for (scheme, faces, corner) in sectors() {
        let (found, matrix) = (sector(scheme, faces, corner), matrix(scheme, faces, corner));
        let check = |weights: &[RealExpression], value: &RealExpression, total: i8| {
            let expected: Vec<RealExpression> = weights.iter().map(|w| w.times(value)).collect();
            assert_eq!(pulled_back(&matrix, weights), expected, "{scheme} {faces} {corner}");
            assert_eq!(RealExpression::total(weights).sign(), total);
        };
        check(&expressions(&found.limit), &number(r(1, 1)), 1);
        assert_eq!(RealCyclotomic::total(&found.limit), RealCyclotomic::from(1));
        assert_eq!(found.along.len(), if corner { 2 } else { 1 });
        for along in &found.along {
            check(&expressions(along), &number(r(1, 2)), 0);
        }
        let Some(across) = found.across else {
            assert_eq!((faces, corner), (1, true));
            continue;
        };
        // The sign of cos(π/F), and of cos(π/F) − 1/2.
        let regular = if scheme == "loop" { 3 } else { 2 };
        assert_eq!(across.side, faces.cmp(&regular), "{scheme} {faces}");
        assert_eq!(across.side, across.eigenvalue.cmp(&number(r(1, 2))));
        match across.stencil {
            None => assert!(corner && across.side == Ordering::Equal),
            Some(stencil) => {
                check(&stencil, &across.eigenvalue, 0);
                // It goes into the sector.
                let inner = if faces == 1 { &stencil[1] } else { &stencil[2] };
                assert_eq!(inner.sign(), 1);
            }
        }
    }
}

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
        let Some(normal) = &limit.normal else {
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
    let centred = |points: &mut Vec<[f64; 3]>| {
        let origin = sum(&weights, points);
        points.iter_mut().for_each(|x| (0..3).for_each(|i| x[i] -= origin[i]));
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
                points.iter_mut().for_each(|x| *x = x.map(|x| x / 40_000.0));
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

// Loop and Warren differ at smooth vertices alone; what is no such scheme is refused.
#[test]
fn names_and_numbers() {
    assert_eq!(sector("loop", 5, false), sector("loop-warren", 5, false));
    let error = |scheme: &str, faces| Sector::of(scheme, faces, false).expect_err("an error");
    assert!(matches!(error("doo-sabin", 3), SpectrumError::NoSectors { .. }));
    for faces in [0, MAX_SECTOR_FACES + 1, usize::MAX] {
        assert!(matches!(error("loop", faces), SpectrumError::Faces { .. }));
    }
    assert_eq!(sector("catmull-clark", MAX_SECTOR_FACES, true).limit.len(), 130);
    assert_eq!(sector("catmull-clark", 2, false).name(5), "face[1]");
}
