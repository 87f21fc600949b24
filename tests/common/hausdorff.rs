//! The Hausdorff distance of closed meshes from their limit surfaces by dense samples: code of its own, from the
//! definitions, slow, in f64, and not proved.

use std::collections::HashMap;

pub type P = [f64; 3];

// Tests are not optimised: what is called most has no closures.
fn add(p: P, q: P, factor: f64) -> P {
    [p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]]
}

fn mean(points: impl IntoIterator<Item = P>) -> P {
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for point in points {
        sum = add(sum, point, 1.0);
        count += 1.0;
    }
    sum.map(|x| x / count)
}

/// The schemes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    CatmullClark,
    /// The boundary of a solid.
    Bajaj,
    DooSabin,
    Loop,
}

/// A closed mesh.
#[derive(Clone)]
pub struct Plain {
    pub points: Vec<P>,
    pub faces: Vec<Vec<usize>>,
}

fn number(n: usize) -> f64 {
    f64::from(u32::try_from(n).expect("few"))
}

impl Plain {
    /// For each directed edge, the face that has it.
    fn edges(&self) -> HashMap<(usize, usize), usize> {
        let mut edges = HashMap::new();
        for (number, face) in self.faces.iter().enumerate() {
            for i in 0..face.len() {
                edges.insert((face[i], face[(i + 1) % face.len()]), number);
            }
        }
        edges
    }

    /// For each vertex, pairs of a neighbour and the face after the edge to it, in turn.
    fn stars(&self) -> Vec<Vec<(usize, usize)>> {
        let edges = self.edges();
        let mut stars = vec![Vec::new(); self.points.len()];
        for face in &self.faces {
            for i in 0..face.len() {
                let vertex = face[i];
                if stars[vertex].is_empty() {
                    let first = face[(i + 1) % face.len()];
                    let mut at = first;
                    loop {
                        let face = edges[&(vertex, at)];
                        stars[vertex].push((at, face));
                        let vertices = &self.faces[face];
                        let place = vertices.iter().position(|&x| x == vertex).expect("there");
                        at = vertices[(place + vertices.len() - 1) % vertices.len()];
                        if at == first {
                            break;
                        }
                    }
                }
            }
        }
        stars
    }

    fn centroid(&self, face: usize) -> P {
        mean(self.faces[face].iter().map(|&v| self.points[v]))
    }

    pub fn refined(&self, rule: Rule) -> Plain {
        let (edges, stars) = (self.edges(), self.stars());
        let points = &self.points;
        if rule == Rule::DooSabin {
            let mut new = Vec::new();
            let mut place = HashMap::new();
            let mut faces = Vec::new();
            for (number_of, face) in self.faces.iter().enumerate() {
                let n = face.len();
                let mut own = Vec::new();
                for i in 0..n {
                    let mut point = [0.0; 3];
                    for j in 0..n {
                        let angle =
                            2.0 * std::f64::consts::PI * (number(i) - number(j)) / number(n);
                        let weight = if i == j {
                            (number(n) + 5.0) / (4.0 * number(n))
                        } else {
                            (3.0 + 2.0 * angle.cos()) / (4.0 * number(n))
                        };
                        point = add(point, points[face[j]], weight);
                    }
                    place.insert((number_of, face[i]), new.len());
                    own.push(new.len());
                    new.push(point);
                }
                faces.push(own);
            }
            for (&(v, w), &face) in &edges {
                if v < w {
                    let other = edges[&(w, v)];
                    let corner = |face, vertex| place[&(face, vertex)];
                    faces.push(vec![
                        corner(face, w),
                        corner(face, v),
                        corner(other, v),
                        corner(other, w),
                    ]);
                }
            }
            for (vertex, star) in stars.iter().enumerate() {
                faces.push(star.iter().map(|&(_, face)| place[&(face, vertex)]).collect());
            }
            return Plain { points: new, faces };
        }
        let mut new = Vec::new();
        for (vertex, star) in stars.iter().enumerate() {
            let n = number(star.len());
            let ring = mean(star.iter().map(|&(at, _)| points[at]));
            let point = points[vertex];
            new.push(if rule == Rule::Loop {
                let beta = loop_beta(star.len());
                add(point.map(|x| x * (1.0 - n * beta)), ring, n * beta)
            } else {
                let middle = mean(star.iter().map(|&(at, _)| mean([points[at], point])));
                let face = mean(star.iter().map(|&(_, face)| self.centroid(face)));
                if rule == Rule::Bajaj {
                    new.push(mean([point, middle, middle, face]));
                    continue;
                }
                let sum = add(add(face, middle, 2.0), point, n - 3.0);
                sum.map(|x| x / n)
            });
        }
        let mut place = HashMap::new();
        for (&(v, w), &face) in &edges {
            if v < w {
                let other = edges[&(w, v)];
                let point = if rule == Rule::Loop {
                    let third = |face: usize| {
                        *self.faces[face].iter().find(|&&x| x != v && x != w).expect("a triangle")
                    };
                    let ends = mean([points[v], points[w]]);
                    let sides = mean([points[third(face)], points[third(other)]]);
                    add(ends.map(|x| 0.75 * x), sides, 0.25)
                } else {
                    mean([points[v], points[w], self.centroid(face), self.centroid(other)])
                };
                place.insert((v, w), new.len());
                new.push(point);
            }
        }
        let middle = |v: usize, w: usize| place[&(v.min(w), v.max(w))];
        let mut faces = Vec::new();
        for (number, face) in self.faces.iter().enumerate() {
            let n = face.len();
            let next = |i: usize| middle(face[i % n], face[(i + 1) % n]);
            if rule == Rule::Loop {
                (0..3).for_each(|i| faces.push(vec![face[i], next(i), next(i + 2)]));
                faces.push(vec![next(0), next(1), next(2)]);
            } else {
                let centre = new.len();
                new.push(self.centroid(number));
                (0..n).for_each(|i| faces.push(vec![face[i], next(i), centre, next(i + n - 1)]));
            }
        }
        Plain { points: new, faces }
    }

    /// The limit points of the vertices, or of the faces (Doo–Sabin), as a surface of triangles.
    fn limit(&self, rule: Rule) -> Vec<[P; 3]> {
        let stars = self.stars();
        if rule == Rule::DooSabin {
            let corners = |star: &Vec<(usize, usize)>| {
                star.iter().map(|&(_, face)| self.centroid(face)).collect::<Vec<P>>()
            };
            return stars.iter().flat_map(|star| fan(&corners(star))).collect();
        }
        let limits: Vec<P> = stars
            .iter()
            .enumerate()
            .map(|(vertex, star)| {
                let (n, point) = (number(star.len()), self.points[vertex]);
                let ring = mean(star.iter().map(|&(at, _)| self.points[at]));
                if rule == Rule::Loop {
                    let omega = 1.0 / (n + 3.0 / (8.0 * loop_beta(star.len())));
                    return add(point.map(|x| x * (1.0 - n * omega)), ring, n * omega);
                }
                let opposite = mean(star.iter().map(|&(_, face)| {
                    let vertices = &self.faces[face];
                    let place = vertices.iter().position(|&x| x == vertex).expect("there");
                    self.points[vertices[(place + 2) % 4]]
                }));
                let n = if rule == Rule::Bajaj { 4.0 } else { n };
                add(add(point.map(|x| x * n), ring, 4.0), opposite, 1.0).map(|x| x / (n + 5.0))
            })
            .collect();
        let corners = |face: &Vec<usize>| face.iter().map(|&v| limits[v]).collect::<Vec<P>>();
        self.faces.iter().flat_map(|face| split(&corners(face))).collect()
    }

    /// The mesh as small triangles: quadrilaterals are bilinear, larger faces fans around their centroids.
    fn triangles(&self, pieces: usize) -> Vec<[P; 3]> {
        let mut all = Vec::new();
        for face in &self.faces {
            let corners: Vec<P> = face.iter().map(|&v| self.points[v]).collect();
            if let [a, b, c, d] = corners[..] {
                let at = |i: usize, j: usize| {
                    let (s, t) = (number(i) / number(pieces), number(j) / number(pieces));
                    let low = add(a.map(|x| x * (1.0 - s)), b, s);
                    let high = add(d.map(|x| x * (1.0 - s)), c, s);
                    add(low.map(|x| x * (1.0 - t)), high, t)
                };
                for i in 0..pieces {
                    for j in 0..pieces {
                        all.extend(split(&[
                            at(i, j),
                            at(i + 1, j),
                            at(i + 1, j + 1),
                            at(i, j + 1),
                        ]));
                    }
                }
            } else {
                let coarse = if corners.len() == 3 {
                    vec![[corners[0], corners[1], corners[2]]]
                } else {
                    fan(&corners)
                };
                let mut parts = coarse;
                let mut size = 1;
                while size < pieces {
                    parts = parts.into_iter().flat_map(quarters).collect();
                    size *= 2;
                }
                all.extend(parts);
            }
        }
        all
    }
}

fn loop_beta(n: usize) -> f64 {
    let angle = 2.0 * std::f64::consts::PI / number(n);
    (0.625 - (0.375 + angle.cos() / 4.0).powi(2)) / number(n)
}

fn quarters([a, b, c]: [P; 3]) -> [[P; 3]; 4] {
    let [ab, bc, ca] = [mean([a, b]), mean([b, c]), mean([c, a])];
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

fn fan(corners: &[P]) -> Vec<[P; 3]> {
    let (centre, n) = (mean(corners.iter().copied()), corners.len());
    (0..n).map(|i| [corners[i], corners[(i + 1) % n], centre]).collect()
}

/// Triangles of a small face.
fn split(corners: &[P]) -> Vec<[P; 3]> {
    if let [a, b, c] = *corners { vec![[a, b, c]] } else { fan(corners) }
}

/// Triangles in a tree of boxes.
struct Tree {
    low: P,
    high: P,
    kind: Kind,
}

enum Kind {
    Leaf(Vec<[P; 3]>),
    Node(Box<[Tree; 2]>),
}

impl Tree {
    fn new(mut triangles: Vec<[P; 3]>) -> Tree {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in triangles.iter().flatten() {
            for i in 0..3 {
                (low[i], high[i]) = (low[i].min(point[i]), high[i].max(point[i]));
            }
        }
        if triangles.len() <= 8 {
            return Tree { low, high, kind: Kind::Leaf(triangles) };
        }
        let axis = (0..3).max_by(|&i, &j| (high[i] - low[i]).total_cmp(&(high[j] - low[j])));
        let axis = axis.expect("three");
        let middle = triangles.len() / 2;
        let key = |triangle: &[P; 3]| triangle.iter().map(|point| point[axis]).sum::<f64>();
        triangles.select_nth_unstable_by(middle, |x, y| key(x).total_cmp(&key(y)));
        let rest = triangles.split_off(middle);
        Tree { low, high, kind: Kind::Node(Box::new([Tree::new(triangles), Tree::new(rest)])) }
    }

    fn box_distance(&self, p: P) -> f64 {
        let mut square = 0.0;
        for (x, (low, high)) in p.iter().zip(self.low.iter().zip(&self.high)) {
            let out = if x < low { low - x } else { x - high };
            if out > 0.0 {
                square += out * out;
            }
        }
        square
    }

    /// Lowers `best` to the squared distance of a point.
    fn nearest(&self, p: P, best: &mut f64) {
        if self.box_distance(p) >= *best {
            return;
        }
        match &self.kind {
            Kind::Leaf(triangles) => {
                for triangle in triangles {
                    *best = best.min(to_triangle(p, triangle));
                }
            }
            Kind::Node(parts) => {
                let [left, right] = [&parts[0], &parts[1]];
                let swap = left.box_distance(p) > right.box_distance(p);
                let [first, second] = if swap { [right, left] } else { [left, right] };
                first.nearest(p, best);
                second.nearest(p, best);
            }
        }
    }
}

fn dot(p: P, q: P) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

/// The squared distance of a point from a triangle: by its plane where the foot is inside, else by its edges.
fn to_triangle(p: P, [a, b, c]: &[P; 3]) -> f64 {
    let (u, v, w) = (add(*b, *a, -1.0), add(*c, *a, -1.0), add(p, *a, -1.0));
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let (wu, wv) = (dot(w, u), dot(w, v));
    let area = uu * vv - uv * uv;
    if area > 0.0 {
        let (s, t) = ((wu * vv - wv * uv) / area, (wv * uu - wu * uv) / area);
        if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
            let off = add(add(w, u, -s), v, -t);
            return dot(off, off);
        }
    }
    let (off, way) = (add(p, *b, -1.0), add(*c, *b, -1.0));
    to_edge(w, u, uu).min(to_edge(w, v, vv)).min(to_edge(off, way, dot(way, way)))
}

/// The squared distance of a point from an edge: where the point is seen from one end, and the other end, of this square.
fn to_edge(off: P, way: P, square: f64) -> f64 {
    let t = if square > 0.0 { (dot(way, off) / square).clamp(0.0, 1.0) } else { 0.0 };
    let off = add(off, way, -t);
    dot(off, off)
}

fn farthest(points: impl Iterator<Item = P>, tree: &Tree, start: f64) -> f64 {
    let mut greatest = start * start;
    for point in points {
        // Most points are near: a first bound from the greatest so far would need all of them.
        let mut best = f64::INFINITY;
        tree.nearest(point, &mut best);
        greatest = greatest.max(best);
    }
    greatest.sqrt()
}

/// The Hausdorff distance of two sets of triangles, by the corners of each.
#[allow(dead_code, reason = "the benchmark has closed meshes alone")]
pub fn of_triangles(first: Vec<[P; 3]>, second: Vec<[P; 3]>) -> f64 {
    let points = [&first, &second].map(|x| x.iter().flatten().copied().collect::<Vec<P>>());
    let [from, to] = [Tree::new(first), Tree::new(second)];
    let there = farthest(points[0].iter().copied(), &to, 0.0);
    farthest(points[1].iter().copied(), &from, there)
}

/// H_0, …, H_{levels − 1}: the limit by the points of level `dense`, the mesh of level k by 2^(`fine` − k) parts of
/// each edge, two at least.
pub fn distances(control: &Plain, rule: Rule, levels: u32, dense: u32, fine: u32) -> Vec<f64> {
    let mut limit = control.clone();
    for _ in 0..dense {
        limit = limit.refined(rule);
    }
    let limit = limit.limit(rule);
    let surface = Tree::new(limit.clone());
    let mut mesh = control.clone();
    let mut all = Vec::new();
    for level in 0..levels {
        let pieces = 1 << fine.saturating_sub(level).max(1);
        let triangles = mesh.triangles(pieces);
        let there = farthest(triangles.iter().map(|x| x[0]), &surface, 0.0);
        let there = farthest(mesh.points.iter().copied(), &surface, there);
        let tree = Tree::new(triangles);
        all.push(farthest(limit.iter().map(|x| x[0]), &tree, there));
        mesh = mesh.refined(rule);
    }
    all
}
