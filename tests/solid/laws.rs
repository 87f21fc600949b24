//! Laws: affine maps, later levels, limits, the boundary's own rules, B-splines on grids.

use crate::common::solids::{Solid, grid, integer, moved, solids, tetrahedron};
use crate::common::{r, ring};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::exact::{Rational, RealCyclotomic, Scalar};
use subcert::mesh::Point;
use subcert::solid::{HexMesh, refine_solid, solid_limit_points};

fn affine([x, y, z]: &Point<Rational>) -> Point<Rational> {
    let times = |factor: i64, x: &Rational| Rational::from(factor) * x;
    [
        times(2, x) - times(3, y) + times(1, z) + r(1, 3),
        times(1, x) + times(5, z) - r(7, 2),
        times(4, y) - times(1, z) + Rational::from(11),
    ]
}

#[test]
fn affine_maps_commute() {
    for solid in solids() {
        let image = solid.with_points(solid.points().iter().map(affine).collect());
        let here = refine_solid(&solid, 1).expect("small");
        let there = refine_solid(&image, 1).expect("small");
        let mapped: Vec<_> = here.points().iter().map(affine).collect();
        assert_eq!(mapped, there.points());
    }
}

/// A vertex keeps its number and its limit at all levels.
#[test]
fn limits_stay_and_levels_add_up() {
    for solid in solids() {
        let once = refine_solid(&solid, 1).expect("small");
        let [before, after] = [&solid, &once].map(solid_limit_points);
        assert_eq!(before[..], after[..before.len()]);
        let twice = refine_solid(&solid, 2).expect("small");
        assert_eq!(refine_solid(&once, 1).expect("small"), twice);
        // Points come nearer to their limits.
        let limits = solid_limit_points(&twice);
        let far = |points: &[Point<Rational>], limits: &[Point<Rational>]| -> Rational {
            let pairs = points.iter().zip(limits).flat_map(|(p, q)| p.iter().zip(q));
            pairs.map(|(x, y)| (x - y).abs()).max().expect("points")
        };
        assert!(far(twice.points(), &limits) * Rational::from(3) < far(solid.points(), &before));
    }
}

/// Numbering points and cells otherwise, and looking at cells from another side, changes only numbers.
#[test]
fn numbers_do_not_matter() {
    for solid in solids() {
        let count = solid.points().len();
        let mut points = solid.points().to_vec();
        points.reverse();
        let turned = |[a, b, c, d, e, f, g, h]: [usize; 8]| {
            [b, f, g, c, a, e, h, d].map(|point| count - 1 - point)
        };
        let cells: Vec<[usize; 8]> = solid.cells().into_iter().rev().map(turned).collect();
        let other = HexMesh::new(points, &cells).expect("the same solid");
        let sorted = |solid: &Solid| {
            let mut points = refine_solid(solid, 1).expect("small").points().to_vec();
            points.sort();
            points
        };
        assert_eq!(sorted(&solid), sorted(&other));
    }
}

/// The boundary is refined by the rules `bajaj` of the catalogue, and its limits are those of
/// `proofs/THEOREMS.md`, 70: (4c + 4E + F)/9.
#[test]
fn the_boundary_has_the_rules_of_the_catalogue() {
    for solid in solids() {
        let refined = refine_solid(&solid, 1).expect("small");
        let limits = solid_limit_points(&solid);
        // The next vertex and the opposite one, around each vertex of the boundary.
        let mut corners: BTreeMap<usize, BTreeMap<usize, (usize, usize)>> = BTreeMap::new();
        for face in solid.boundary_faces() {
            for i in 0..4 {
                let [v, next, opposite, before] = [0, 1, 2, 3].map(|j| face[(i + j) % 4]);
                corners.entry(v).or_default().insert(next, (opposite, before));
            }
        }
        for (vertex, around) in corners {
            let n = around.len();
            let rules = ring(&format!("bajaj:N={n}"));
            let (mut edges, mut faces) = (Vec::new(), Vec::new());
            let mut edge = *around.keys().next().expect("a face");
            for _ in 0..n {
                let (opposite, before) = around[&edge];
                edges.push(edge);
                faces.push(opposite);
                edge = before;
            }
            let all: Vec<usize> = [vertex].into_iter().chain(edges).chain(faces).collect();
            let row: Vec<RealCyclotomic> = rules.weights().row(0).cloned().collect();
            for (i, found) in limits[vertex].iter().enumerate() {
                let at = |k: usize| RealCyclotomic::from(solid.points()[all[k]][i].clone());
                let expected = row
                    .iter()
                    .enumerate()
                    .fold(RealCyclotomic::zero(), |sum, (k, w)| sum.plus(&w.times(&at(k))));
                assert_eq!(RealCyclotomic::from(refined.points()[vertex][i].clone()), expected);
                let total = |range: std::ops::Range<usize>| -> Rational {
                    range.map(|k| solid.points()[all[k]][i].clone()).sum()
                };
                let share = r(1, integer(9 * n));
                let limit = r(4, 9) * &solid.points()[vertex][i]
                    + (total(1..n + 1) * Rational::from(4) + total(n + 1..2 * n + 1)) * share;
                assert_eq!(*found, limit);
            }
        }
    }
}

/// One level of cubic B-splines on a row of values, the ends kept.
fn spline(row: &[Rational]) -> Vec<Rational> {
    let mut refined = Vec::new();
    for (i, x) in row.iter().enumerate() {
        let inner = i > 0 && i + 1 < row.len();
        refined.push(if inner {
            (&row[i - 1] + &row[i + 1] + Rational::from(6) * x) * r(1, 8)
        } else {
            x.clone()
        });
        refined.extend(row.get(i + 1).map(|next| (x + next) * r(1, 2)));
    }
    refined
}

/// On a grid all but the points of its twelve edges are those of the tensor product, with the boundary as
/// it is refined by itself.
#[test]
fn grids_are_tensor_products() {
    let sizes = [3, 2, 4];
    let solid = grid(sizes, |_| true);
    // Point (x, y, z) of a grid of cells, by the corners of the cells.
    let place = |cells: &[[usize; 8]], sizes: [usize; 3], order: &dyn Fn([usize; 3]) -> usize| {
        let mut at: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        for index in 0..sizes.iter().product::<usize>() {
            let cell =
                [index % sizes[0], index / sizes[0] % sizes[1], index / (sizes[0] * sizes[1])];
            let corners = cells[order(cell)];
            for (k, bits) in crate::common::solids::FILE_ORDER.into_iter().enumerate() {
                at.insert([0, 1, 2].map(|i| cell[i] + (bits >> i & 1)), corners[k]);
            }
        }
        at
    };
    let number = |[x, y, z]: [usize; 3]| x + sizes[0] * (y + sizes[1] * z);
    let old = place(&solid.cells(), sizes, &number);
    let refined = refine_solid(&solid, 1).expect("small");
    let fine = sizes.map(|size| 2 * size);
    let new = place(&refined.cells(), fine, &|cell: [usize; 3]| {
        let part: usize = (0..3).map(|i| (cell[i] & 1) << i).sum();
        8 * number(cell.map(|x| x / 2)) + part
    });
    for coordinate in 0..3 {
        let mut values: BTreeMap<[usize; 3], Rational> =
            old.iter().map(|(at, &k)| (*at, solid.points()[k][coordinate].clone())).collect();
        for axis in 0..3 {
            let mut rows: BTreeMap<[usize; 3], Vec<Rational>> = BTreeMap::new();
            for (mut at, value) in values {
                at[axis] = 0;
                rows.entry(at).or_default().push(value);
            }
            values = rows
                .into_iter()
                .flat_map(|(at, row)| {
                    spline(&row).into_iter().enumerate().map(move |(i, value)| {
                        let mut at = at;
                        at[axis] = i;
                        (at, value)
                    })
                })
                .collect();
        }
        let mut compared = 0;
        for (at, value) in &values {
            let ends = (0..3).filter(|&i| at[i] == 0 || at[i] == fine[i]).count();
            if ends < 2 {
                assert_eq!(&refined.points()[new[at]][coordinate], value, "{at:?}");
                compared += 1;
            }
        }
        assert!(compared > 150);
    }
}

proptest! {
    #![proptest_config(crate::common::cases(8))]

    #[test]
    fn limits_stay_on_any_points(solid in moved(tetrahedron())) {
        let once = refine_solid(&solid, 1).expect("small");
        let [before, after] = [&solid, &once].map(solid_limit_points);
        prop_assert_eq!(&before[..], &after[..before.len()]);
    }
}
