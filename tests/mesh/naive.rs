//! Refinement written out from the papers, by searching all faces for what meets.

use super::{Mesh, cube, examples};
use subcert::exact::{Rational, RealCyclotomic, Scalar};
use subcert::mesh::{MeshScheme, Point, refine_mesh};

/// Each face as its points, in no order.
type Faces = Vec<Vec<Point<RealCyclotomic>>>;

fn scaled(p: i64, q: i64, points: &[Point<RealCyclotomic>]) -> Point<RealCyclotomic> {
    let factor = RealCyclotomic::from(Rational::new(p, q));
    std::array::from_fn(|i| {
        points.iter().fold(RealCyclotomic::zero(), |sum, x| sum.plus(&x[i])).times(&factor)
    })
}

fn mean(points: &[Point<RealCyclotomic>]) -> Point<RealCyclotomic> {
    scaled(1, i64::try_from(points.len()).expect("small"), points)
}

/// The faces with an edge between these vertices.
fn faces_at_edge(mesh: &Mesh, a: usize, b: usize) -> Vec<usize> {
    let has = |face: &Vec<usize>| {
        (0..face.len()).any(|i| {
            let edge = [face[i], face[(i + 1) % face.len()]];
            edge == [a, b] || edge == [b, a]
        })
    };
    (0..mesh.faces().len()).filter(|&face| has(&mesh.faces()[face])).collect()
}

fn faces_at(mesh: &Mesh, vertex: usize) -> Vec<usize> {
    (0..mesh.faces().len()).filter(|&face| mesh.faces()[face].contains(&vertex)).collect()
}

fn neighbours(mesh: &Mesh, vertex: usize) -> Vec<usize> {
    let joined = |other: &usize| !faces_at_edge(mesh, vertex, *other).is_empty();
    (0..mesh.points().len()).filter(joined).collect()
}

fn boundary_neighbours(mesh: &Mesh, vertex: usize) -> Vec<usize> {
    let all = neighbours(mesh, vertex);
    all.into_iter().filter(|&other| faces_at_edge(mesh, vertex, other).len() == 1).collect()
}

fn at(mesh: &Mesh, vertices: &[usize]) -> Vec<Point<RealCyclotomic>> {
    vertices.iter().map(|&v| mesh.points()[v].clone()).collect()
}

fn boundary_point(mesh: &Mesh, v: usize, ends: &[usize]) -> Point<RealCyclotomic> {
    scaled(1, 1, &[scaled(3, 4, &at(mesh, &[v])), scaled(1, 8, &at(mesh, ends))])
}

/// (F + 2R + (n − 3)P)/n; of the boundary of solids (F + 2R + P)/4.
fn catmull_clark(mesh: &Mesh, of_solids: bool) -> Faces {
    let centre = |face: usize| mean(&at(mesh, &mesh.faces()[face]));
    let edge = |a: usize, b: usize| {
        let faces = faces_at_edge(mesh, a, b);
        let ends = at(mesh, &[a, b]);
        if faces.len() == 1 {
            return mean(&ends);
        }
        mean(&[&ends[..], &[centre(faces[0]), centre(faces[1])]].concat())
    };
    let vertex = |v: usize| {
        let ends = boundary_neighbours(mesh, v);
        if !ends.is_empty() {
            return boundary_point(mesh, v, &ends);
        }
        let faces: Vec<_> = faces_at(mesh, v).into_iter().map(centre).collect();
        let n = if of_solids { 4 } else { i64::try_from(faces.len()).expect("small") };
        let middles: Vec<_> =
            neighbours(mesh, v).into_iter().map(|w| mean(&at(mesh, &[v, w]))).collect();
        scaled(
            1,
            n,
            &[mean(&faces), scaled(2, 1, &[mean(&middles)]), scaled(n - 3, 1, &at(mesh, &[v]))],
        )
    };
    let mut all = Vec::new();
    for (index, face) in mesh.faces().iter().enumerate() {
        for (i, &v) in face.iter().enumerate() {
            let (next, last) =
                (face[(i + 1) % face.len()], face[(i + face.len() - 1) % face.len()]);
            all.push(vec![vertex(v), edge(v, next), centre(index), edge(last, v)]);
        }
    }
    all
}

/// a_0 = 1/4 + 5/(4n), a_j = (3 + 2cos(2πj/n))/(4n).
fn doo_sabin(mesh: &Mesh) -> Faces {
    let corner = |face: usize, v: usize| {
        let vertices = &mesh.faces()[face];
        let n = vertices.len();
        let i = vertices.iter().position(|w| *w == v).expect("a vertex of the face");
        let share = RealCyclotomic::from(Rational::new(1, 4 * n));
        let weight = |j: usize| {
            let turn = Rational::new(j, n);
            let cosine = RealCyclotomic::cosine(&turn).expect("a small valence");
            let sum = cosine.times(&2.into()).plus(&3.into()).times(&share);
            if j == 0 { sum.plus(&Rational::new(1, 4).into()) } else { sum }
        };
        std::array::from_fn(|x| {
            (0..n).fold(RealCyclotomic::zero(), |sum, j| {
                sum.plus(&weight(j).times(&mesh.points()[vertices[(i + j) % n]][x]))
            })
        })
    };
    let mut all: Faces = Vec::new();
    for (index, face) in mesh.faces().iter().enumerate() {
        all.push(face.iter().map(|&v| corner(index, v)).collect());
    }
    for a in 0..mesh.points().len() {
        for b in neighbours(mesh, a).into_iter().filter(|b| a < *b) {
            if let [f, g] = faces_at_edge(mesh, a, b)[..] {
                all.push(vec![corner(f, a), corner(f, b), corner(g, a), corner(g, b)]);
            }
        }
        if boundary_neighbours(mesh, a).is_empty() {
            all.push(faces_at(mesh, a).into_iter().map(|face| corner(face, a)).collect());
        }
    }
    all
}

/// Loop 1987, page 48; Warren's weights where `warren`.
fn triangles(mesh: &Mesh, warren: bool) -> Faces {
    let edge = |a: usize, b: usize| {
        let faces = faces_at_edge(mesh, a, b);
        if faces.len() == 1 {
            return mean(&at(mesh, &[a, b]));
        }
        let opposite = |face: &usize| {
            let vertices = mesh.faces()[*face].iter().copied();
            vertices.into_iter().find(|v| *v != a && *v != b).expect("a triangle")
        };
        let wings: Vec<usize> = faces.iter().map(opposite).collect();
        scaled(1, 1, &[scaled(3, 8, &at(mesh, &[a, b])), scaled(1, 8, &at(mesh, &wings))])
    };
    let vertex = |v: usize| {
        let ends = boundary_neighbours(mesh, v);
        if !ends.is_empty() {
            return boundary_point(mesh, v, &ends);
        }
        let around = neighbours(mesh, v);
        let n = around.len();
        let number = |p: i64, q: i64| RealCyclotomic::from(Rational::new(p, q));
        let beta = if warren {
            if n == 3 { number(3, 16) } else { Rational::new(3, 8 * n).into() }
        } else {
            let cosine = RealCyclotomic::cosine(&Rational::new(1, n)).expect("a small valence");
            let inner = number(3, 8).plus(&cosine.times(&number(1, 4)));
            number(5, 8).minus(&inner.times(&inner)).times(&Rational::new(1, n).into())
        };
        let rest = number(1, 1).minus(&beta.times(&Rational::from(n).into()));
        let sum = scaled(1, 1, &at(mesh, &around));
        std::array::from_fn(|x| mesh.points()[v][x].times(&rest).plus(&sum[x].times(&beta)))
    };
    let mut all = Vec::new();
    for face in mesh.faces() {
        let [a, b, c] = face[..] else { panic!("a triangle") };
        for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
            all.push(vec![vertex(a), edge(a, b), edge(a, c)]);
        }
        all.push(vec![edge(a, b), edge(b, c), edge(c, a)]);
    }
    all
}

fn sorted(mut faces: Faces) -> Faces {
    for face in &mut faces {
        face.sort();
    }
    faces.sort();
    faces
}

#[test]
fn whole_meshes_are_refined_as_the_papers_say() {
    for scheme in MeshScheme::ALL {
        for (index, mesh) in examples(scheme).iter().enumerate() {
            let expected = match scheme {
                MeshScheme::CatmullClark => catmull_clark(mesh, false),
                MeshScheme::Bajaj => catmull_clark(mesh, true),
                MeshScheme::DooSabin => doo_sabin(mesh),
                MeshScheme::Loop => triangles(mesh, false),
                MeshScheme::LoopWarren => triangles(mesh, true),
            };
            let refined = refine_mesh(mesh, scheme, 1).expect("a mesh within the caps");
            let found = refined.faces().iter().map(|face| at(&refined, face)).collect();
            assert!(sorted(found) == sorted(expected), "{scheme:?}, mesh {index}");
        }
    }
}

#[test]
fn a_second_level_too() {
    for scheme in [MeshScheme::CatmullClark, MeshScheme::DooSabin] {
        let first = refine_mesh(&cube(), scheme, 1).expect("a mesh within the caps");
        let second = refine_mesh(&cube(), scheme, 2).expect("a mesh within the caps");
        let expected = match scheme {
            MeshScheme::CatmullClark => catmull_clark(&first, false),
            _ => doo_sabin(&first),
        };
        let found = second.faces().iter().map(|face| at(&second, face)).collect();
        assert!(sorted(found) == sorted(expected), "{scheme:?}");
    }
}
