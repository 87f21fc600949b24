//! Solids of tests.

use super::r;
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::mesh::Point;
use subcert::solid::HexMesh;

pub type Solid = HexMesh<Rational>;

/// A cell with its corners by coordinates, in the order of files.
pub const FILE_ORDER: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

pub fn integer(x: usize) -> i64 {
    i64::try_from(x).expect("small")
}

/// Points on no plane and no circle, one for each number.
fn bumpy(k: usize, [x, y, z]: [usize; 3]) -> Point<Rational> {
    let [x, y, z] = [x, y, z].map(|x| Rational::from(5 * x));
    let bump = |p: usize, q: usize| r(integer((p * k * k + q * k + 3) % 7), 2);
    [x + bump(2, 3), y + bump(3, 1), z + bump(1, 5)]
}

/// Those cells of a grid that are wanted, on moved points.
pub fn grid(sizes: [usize; 3], wanted: impl Fn([usize; 3]) -> bool) -> Solid {
    let [a, b, c] = sizes;
    let mut places: Vec<[usize; 3]> = Vec::new();
    let mut cells = Vec::new();
    for index in 0..a * b * c {
        let cell = [index % a, index / a % b, index / (a * b)];
        if !wanted(cell) {
            continue;
        }
        cells.push(FILE_ORDER.map(|corner| {
            let place = [0, 1, 2].map(|i| cell[i] + (corner >> i & 1));
            places.iter().position(|known| *known == place).unwrap_or_else(|| {
                places.push(place);
                places.len() - 1
            })
        }));
    }
    let points = places.into_iter().enumerate().map(|(k, place)| bumpy(k, place)).collect();
    HexMesh::new(points, &cells).expect("a solid")
}

/// n columns of cells around an edge, of so many layers; with a gap between the last and the first where
/// it is not closed.
pub fn star(n: usize, layers: usize, closed: bool) -> Solid {
    let ring = if closed { 2 * n } else { 2 * n + 1 };
    let at = |layer: usize, k: usize| layer * (ring + 1) + k;
    let mut cells = Vec::new();
    for layer in 0..layers {
        for i in 0..n {
            let base = [0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % ring];
            let [bottom, top] = [layer, layer + 1].map(|layer| base.map(|k| at(layer, k)));
            cells.push([&bottom[..], &top[..]].concat().try_into().expect("eight corners"));
        }
    }
    let points = (0..(layers + 1) * (ring + 1)).map(|k| {
        let (layer, place) = (k / (ring + 1), k % (ring + 1));
        bumpy(k, [place * place % 11, place * 3 % 7, 3 * layer])
    });
    HexMesh::new(points.collect(), &cells).expect("a solid")
}

/// A tetrahedron as four hexahedra: an inner vertex with four edges of three cells each.
pub fn tetrahedron() -> Solid {
    let mut keys: Vec<Vec<usize>> = Vec::new();
    let mut number = |mut key: Vec<usize>| {
        key.sort_unstable();
        keys.iter().position(|known| *known == key).unwrap_or_else(|| {
            keys.push(key);
            keys.len() - 1
        })
    };
    // Even permutations, so that all cells have the same orientation.
    let cells: Vec<[usize; 8]> = [[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]]
        .map(|[a, others @ ..]| {
            FILE_ORDER.map(|corner| {
                let chosen = (0..3).filter(|i| corner >> i & 1 == 1).map(|i| others[i]);
                number(chosen.chain([a]).collect())
            })
        })
        .to_vec();
    let corners = [[0, 0, 0], [9, 1, 0], [2, 8, 1], [1, 2, 10]];
    let mean = |key: &Vec<usize>| {
        let sum = |i: usize| key.iter().map(|&corner| corners[corner][i]).sum::<i64>();
        [0, 1, 2].map(|i| r(sum(i), integer(key.len())))
    };
    HexMesh::new(keys.iter().map(mean).collect(), &cells).expect("a solid")
}

/// Solids of all kinds: regular, with inner edges and vertices of other numbers of cells, with convex and
/// concave edges and corners of the boundary.
pub fn solids() -> Vec<Solid> {
    vec![
        grid([1, 1, 1], |_| true),
        grid([3, 2, 2], |_| true),
        grid([2, 2, 2], |cell| cell != [1, 1, 1]),
        grid([3, 2, 3], |[x, _, z]| x == 0 || z == 0),
        star(3, 2, true),
        star(5, 1, true),
        star(5, 2, false),
        tetrahedron(),
    ]
}

/// Any small rational points in place of those of the solid.
pub fn moved(solid: Solid) -> impl Strategy<Value = Solid> {
    let coordinate = || (-20_i64..20, 1_i64..5).prop_map(|(p, q)| r(p, q));
    let point = (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| [x, y, z]);
    let points = prop::collection::vec(point, solid.points().len());
    points.prop_map(move |points| solid.with_points(points))
}

/// For each point of the next level the vertices of the cell, face or edge that it is in the middle of, by
/// the documented order of the cells of the next level.
pub fn origins(control: &Solid, refined: &Solid) -> Vec<Vec<usize>> {
    let mut origins = vec![Vec::new(); refined.points().len()];
    let (old, new) = (control.cells(), refined.cells());
    for (index, cell) in new.iter().enumerate() {
        let (parent, part) = (old[index / 8], index % 8);
        for (place, &point) in cell.iter().enumerate() {
            let corner = FILE_ORDER[place];
            // The corners that agree with both, where these agree.
            let between = |c: &usize| (c ^ part) & (7 ^ part ^ corner) == 0;
            let mut key: Vec<usize> = (0..8)
                .filter(between)
                .map(|c| parent[FILE_ORDER.iter().position(|known| *known == c).expect("8")])
                .collect();
            key.sort_unstable();
            assert!(origins[point].is_empty() || origins[point] == key, "one point, one origin");
            origins[point] = key;
        }
    }
    origins
}

/// The mean of these points.
pub fn mean(points: &[Point<Rational>], numbers: &[usize]) -> Point<Rational> {
    let share = r(1, integer(numbers.len()));
    [0, 1, 2].map(|i| numbers.iter().map(|&k| points[k][i].clone()).sum::<Rational>() * &share)
}
