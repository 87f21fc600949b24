//! The definition: every hexahedron is divided, and every point moves to the mean of the centroids of the
//! new cells around it, or of the new faces of the boundary.

use crate::common::r;
use crate::common::solids::{Solid, integer, mean, moved, origins, solids, tetrahedron};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::exact::Rational;
use subcert::mesh::Point;
use subcert::solid::refine_solid;

/// The faces of a cell in the order of files, as sets of places.
const SIDES: [[usize; 4]; 6] =
    [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// The refined points by the vertices that they are in the middle of, with no use of the order of
/// anything.
fn by_definition(solid: &Solid) -> BTreeMap<Vec<usize>, Point<Rational>> {
    let mut split: BTreeMap<Vec<usize>, Point<Rational>> = BTreeMap::new();
    let mut cells: Vec<Vec<Vec<usize>>> = Vec::new();
    for cell in solid.cells() {
        for corner in 0..8 {
            // The faces, edges and the cell that have the corner: sets of places that are closed under
            // the coordinates.
            let bits = |place: usize| [0, 1, 3, 2, 4, 5, 7, 6][place];
            let part = (0..8_usize).map(|axes| {
                let inside = |place: &usize| (bits(*place) ^ bits(corner)) & (7 ^ axes) == 0;
                let mut key: Vec<usize> = (0..8).filter(inside).map(|place| cell[place]).collect();
                key.sort_unstable();
                split.entry(key.clone()).or_insert_with(|| mean(solid.points(), &key));
                key
            });
            cells.push(part.collect());
        }
    }
    // Corner `axes` of a part is at these coordinates of it.
    let side = |cell: &[Vec<usize>], axis: usize, s: usize| -> Vec<Vec<usize>> {
        let on = |axes: &usize| axes >> axis & 1 == s;
        let mut keys: Vec<Vec<usize>> = (0..8).filter(on).map(|axes| cell[axes].clone()).collect();
        keys.sort();
        keys
    };
    let mut sides: BTreeMap<Vec<Vec<usize>>, usize> = BTreeMap::new();
    for cell in &cells {
        for (axis, s) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)] {
            *sides.entry(side(cell, axis, s)).or_default() += 1;
        }
    }
    let outer: Vec<Vec<Vec<usize>>> =
        sides.into_iter().filter(|(_, count)| *count == 1).map(|(side, _)| side).collect();
    let centroid = |keys: &[Vec<usize>]| -> Point<Rational> {
        let points: Vec<Point<Rational>> = keys.iter().map(|key| split[key].clone()).collect();
        mean(&points, &(0..points.len()).collect::<Vec<usize>>())
    };
    let around = |key: &Vec<usize>| {
        let faces: Vec<_> = outer.iter().filter(|side| side.contains(key)).collect();
        let centroids: Vec<Point<Rational>> = if faces.is_empty() {
            cells.iter().filter(|cell| cell.contains(key)).map(|cell| centroid(cell)).collect()
        } else {
            faces.into_iter().map(|side| centroid(side)).collect()
        };
        mean(&centroids, &(0..centroids.len()).collect::<Vec<usize>>())
    };
    split.keys().map(|key| (key.clone(), around(key))).collect()
}

fn as_defined(solid: &Solid) {
    let refined = refine_solid(solid, 1).expect("small");
    let expected = by_definition(solid);
    assert_eq!(expected.len(), refined.points().len());
    for (key, point) in origins(solid, &refined).iter().zip(refined.points()) {
        assert_eq!(&expected[key], point, "{key:?}");
    }
}

#[test]
fn solids_are_refined_as_defined() {
    for solid in solids() {
        as_defined(&solid);
        as_defined(&refine_solid(&solid, 1).expect("small"));
        let faces: usize = solid.boundary_faces().len();
        let sides = solid.cells().len() * SIDES.len();
        assert_eq!((sides - faces) % 2, 0);
    }
}

proptest! {
    #![proptest_config(crate::common::cases(8))]

    #[test]
    fn on_any_points(solid in moved(tetrahedron())) {
        as_defined(&solid);
    }
}

/// A point with eight cells by hand: 27 weights (1, 6, 1) ⊗ (1, 6, 1) ⊗ (1, 6, 1)/512.
#[test]
fn by_hand() {
    let solid = crate::common::solids::grid([2, 2, 2], |_| true);
    let refined = refine_solid(&solid, 1).expect("small");
    let centre = solid
        .points()
        .iter()
        .zip(0..)
        .find(|(_, k)| solid.cells().iter().filter(|cell| cell.contains(k)).count() == 8);
    let (_, centre) = centre.expect("an inner point");
    let mut weights = vec![0_i64; solid.points().len()];
    for cell in solid.cells() {
        let at = cell.iter().position(|point| *point == centre).expect("it is in all cells");
        let bits = [0_usize, 1, 3, 2, 4, 5, 7, 6];
        for (place, &point) in cell.iter().enumerate() {
            weights[point] = [216, 36, 6, 1][(bits[place] ^ bits[at]).count_ones() as usize];
        }
    }
    assert_eq!(weights.iter().sum::<i64>(), 512);
    for i in 0..3 {
        let terms = weights.iter().zip(solid.points());
        let sum: Rational = terms.map(|(weight, point)| r(*weight, 512) * &point[i]).sum();
        assert_eq!(refined.points()[centre][i], sum);
    }
    assert_eq!(integer(refined.points().len()), 125);
}
