//! The butterfly scheme on meshes in f64, with nothing but edges and the triangles beside them: how rings of generic data
//! wind around the vertex, and what is proved.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;
use subcert::characteristic::{Refutation, Verdict, Vertex};

type C = (f64, f64);

/// Triangles, counterclockwise, with a value at each vertex; vertex 0 is the extraordinary one.
struct Mesh {
    triangles: Vec<[usize; 3]>,
    values: Vec<C>,
}

/// Some numbers that no symmetry has.
fn generic(i: usize) -> C {
    let i = f64::from(u16::try_from(i).expect("few points"));
    ((i * i * 0.37 + i).sin(), (i * i * 0.73 - 2.0 * i).cos())
}

impl Mesh {
    /// n sectors of triangles up to a distance.
    fn new(n: usize, far: usize) -> Mesh {
        let mut index: BTreeMap<(usize, usize, usize), usize> = BTreeMap::new();
        let mut at = |s: usize, a: usize, b: usize| {
            let key = match (a, b) {
                (0, 0) => (0, 0, 0),
                (0, b) => ((s + 1) % n, b, 0),
                (a, b) => (s, a, b),
            };
            let next = index.len();
            *index.entry(key).or_insert(next)
        };
        at(0, 0, 0);
        let mut triangles = Vec::new();
        for s in 0..n {
            for a in 0..far {
                for b in 0..far - a {
                    triangles.push([at(s, a, b), at(s, a + 1, b), at(s, a, b + 1)]);
                    if a + b + 2 <= far {
                        triangles.push([at(s, a + 1, b), at(s, a + 1, b + 1), at(s, a, b + 1)]);
                    }
                }
            }
        }
        let values = (0..index.len()).map(generic).collect();
        Mesh { triangles, values }
    }

    /// The vertices opposite to directed edges.
    fn opposite(&self) -> BTreeMap<(usize, usize), usize> {
        let sides = |[a, b, c]: &[usize; 3]| [((*a, *b), *c), ((*b, *c), *a), ((*c, *a), *b)];
        self.triangles.iter().flat_map(sides).collect()
    }

    /// The vertices around vertex 0, in order.
    fn link(&self) -> Vec<usize> {
        let opposite = self.opposite();
        let first = self.triangles.iter().find(|t| t.contains(&0)).expect("a triangle");
        let start = *first.iter().find(|v| **v != 0).expect("a vertex");
        let mut link = vec![start];
        loop {
            let next = opposite[&(0, link[link.len() - 1])];
            if next == start {
                return link;
            }
            link.push(next);
        }
    }

    /// The next level, less what has not all its points, up to a distance of vertex 0.
    fn refined(&self, far: usize) -> Mesh {
        let opposite = self.opposite();
        let mut values = self.values.clone();
        let mut middle: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for &(a, b) in opposite.keys().filter(|(a, b)| a < b) {
            let beside = |x: usize, y: usize| opposite.get(&(x, y)).copied();
            let (Some(c), Some(d)) = (beside(a, b), beside(b, a)) else { continue };
            let far = [beside(c, b), beside(a, c), beside(b, d), beside(d, a)];
            let [Some(e), Some(f), Some(g), Some(h)] = far else { continue };
            let terms = [
                (a, 8.0),
                (b, 8.0),
                (c, 2.0),
                (d, 2.0),
                (e, -1.0),
                (f, -1.0),
                (g, -1.0),
                (h, -1.0),
            ];
            let sum = terms.iter().fold((0.0, 0.0), |sum: C, (v, w)| {
                (sum.0 + w * self.values[*v].0, sum.1 + w * self.values[*v].1)
            });
            middle.insert((a, b), values.len());
            values.push((sum.0 / 16.0, sum.1 / 16.0));
        }
        let mid = |a: usize, b: usize| middle.get(&(a.min(b), a.max(b))).copied();
        let mut triangles = Vec::new();
        for &[a, b, c] in &self.triangles {
            if let (Some(x), Some(y), Some(z)) = (mid(a, b), mid(b, c), mid(c, a)) {
                triangles.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]]);
            }
        }
        Mesh { triangles, values }.cropped(far)
    }

    /// The triangles whose vertices are at most so far from vertex 0.
    fn cropped(self, far: usize) -> Mesh {
        let mut near = BTreeSet::from([0]);
        for _ in 0..far {
            let beside = self.triangles.iter().filter(|t| t.iter().any(|v| near.contains(v)));
            near = beside.flatten().copied().collect();
        }
        let new: BTreeMap<usize, usize> = near.iter().enumerate().map(|(i, v)| (*v, i)).collect();
        let kept = self.triangles.iter().filter(|t| t.iter().all(|v| near.contains(v)));
        let triangles = kept.map(|t| t.map(|v| new[&v])).collect();
        // As seen from vertex 0, and of the size 1.
        let (x, y) = self.values[0];
        let moved: Vec<C> =
            near.iter().map(|v| (self.values[*v].0 - x, self.values[*v].1 - y)).collect();
        let size = moved.iter().fold(0.0_f64, |most, v| most.max(v.0.hypot(v.1)));
        Mesh { triangles, values: moved.iter().map(|v| (v.0 / size, v.1 / size)).collect() }
    }
}

#[test]
fn rings_of_the_butterfly_scheme_wind_as_is_proved() {
    for n in [3, 4, 5, 7, 9, 10] {
        let mut mesh = Mesh::new(n, 4);
        for _ in 0..60 {
            mesh = mesh.refined(4);
        }
        let ring: Vec<C> = mesh.link().iter().map(|v| mesh.values[*v]).collect();
        let turns = ring
            .iter()
            .zip(ring.iter().cycle().skip(1))
            .map(|(a, b)| (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1) / (2.0 * PI));
        let turns = turns.sum::<f64>();
        let verdict = Vertex::of("butterfly", Some(n)).expect("a spectrum").verdict;
        match n {
            // All neighbours are on one side: the surface has a cusp.
            3 => {
                assert!(turns.abs() < 0.1, "{turns}");
                let Verdict::Refuted(Refutation::Block0 { size: 3, .. }) = verdict else {
                    panic!("{verdict:?}")
                };
            }
            4..=7 => {
                assert!((turns.abs() - 1.0).abs() < 1e-6, "{n}: {turns}");
                assert!(matches!(verdict, Verdict::Open(_)), "{n}: {verdict:?}");
            }
            _ => {
                assert!((turns.abs() - 2.0).abs() < 1e-6, "{n}: {turns}");
                assert!(
                    matches!(verdict, Verdict::Refuted(Refutation::Winds { .. })),
                    "{n}: {verdict:?}"
                );
            }
        }
    }
}

/// Zorin (2000) shows by other means that the scheme is C¹ for valences 4 to 7 alone.
#[test]
fn butterfly_is_refuted_at_valence_3_and_from_8_on() {
    for n in 3..=24 {
        let verdict = Vertex::of("butterfly", Some(n)).expect("a spectrum").verdict;
        assert_eq!(
            matches!(verdict, Verdict::Refuted(_)),
            !(4..=7).contains(&n),
            "{n}: {verdict:?}"
        );
    }
}
