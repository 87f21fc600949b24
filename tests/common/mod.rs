//! Random masks and polygons, and the refinement of a polygon written out.

#![allow(dead_code, reason = "each test crate uses its part")]

pub mod claims;
pub mod hausdorff;
pub mod hausdorff_cases;
pub mod meshes;
pub mod papers;
pub mod solids;

use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::scheme::{LocalRules, Mask, Orbit, Rules, Scheme, parse_local_rules, parse_scheme};

/// A quarter of so many random cases; all of them where `SUBCERT_CASES` is `all`, as in `.ci/defects.py`.
pub fn cases(all: u32) -> ProptestConfig {
    let asked = std::env::var("SUBCERT_CASES").is_ok_and(|cases| cases == "all");
    ProptestConfig::with_cases(if asked { all } else { all.div_ceil(4) })
}

pub fn r(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

pub fn int(n: usize) -> i64 {
    i64::try_from(n).expect("a small number")
}

/// The first mask of a scheme.
pub fn mask(scheme: &str) -> Mask {
    match parse_scheme(scheme) {
        Ok(Scheme::Curve(mask) | Scheme::Tensor(mask, _)) => mask,
        Err(error) => panic!("{error}"),
    }
}

pub fn rational() -> impl Strategy<Value = Rational> {
    (-9_i64..10, 1_i64..7).prop_map(|(p, q)| r(p, q))
}

pub fn rows(arity: usize, width: usize) -> impl Strategy<Value = Vec<Vec<Rational>>> {
    prop::collection::vec(prop::collection::vec(rational(), width), arity)
}

/// Arity and width of random rules.
pub fn shape(arity: usize, width: usize) -> impl Strategy<Value = (usize, usize)> {
    (2..=arity, 1..=width)
}

/// Any rules with offset −5, …, 5.
pub fn rules(arity: usize, width: usize) -> impl Strategy<Value = Rules> {
    (shape(arity, width), -5_i64..6).prop_flat_map(|((arity, width), offset)| {
        rows(arity, width).prop_map(move |rows| Rules::new(rows, offset).expect("rules"))
    })
}

/// Any affine mask: one coefficient of each rule makes its sum 1.
pub fn affine(arity: usize, width: usize) -> impl Strategy<Value = Mask> {
    (rules(arity, width), any::<prop::sample::Index>()).prop_map(|(rules, place)| {
        let (mut rows, place) = (rules.rows().to_vec(), place.index(rules.width()));
        for row in &mut rows {
            let rest: Rational = row.iter().sum();
            row[place] += &(Rational::one() - rest);
        }
        Mask::new(rows, rules.offset()).expect("an affine mask")
    })
}

/// Masks near convex ones, so that many of them contract.
pub fn gentle(arity: usize, width: usize) -> impl Strategy<Value = Mask> {
    affine(arity, width).prop_map(|mask| {
        let even = r(1, int(mask.width()));
        let mix = |x: &Rational| x * r(1, 40) + &even * r(39, 40);
        let rows = mask.rules().rows().iter().map(|row| row.iter().map(mix).collect()).collect();
        Mask::new(rows, mask.offset()).unwrap()
    })
}

pub fn polygon(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(rational(), count)
}

/// The index i of a closed polygon.
pub fn at(points: &[Rational], index: i64) -> &Rational {
    &points[usize::try_from(index.rem_euclid(int(points.len()))).expect("not negative")]
}

/// x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}, as it stands.
pub fn refine(rules: &Rules, points: &[Rational]) -> Vec<Rational> {
    let rule = |i: usize, row: &Vec<Rational>| -> Rational {
        let terms = row.iter().enumerate();
        terms.map(|(j, a)| a * at(points, int(i) + rules.offset() + int(j))).sum()
    };
    (0..points.len()).flat_map(|i| rules.rows().iter().map(move |row| rule(i, row))).collect()
}

/// Δ_i = x_{i+1} − x_i.
pub fn differences(points: &[Rational]) -> Vec<Rational> {
    (0..points.len()).map(|i| at(points, int(i) + 1) - &points[i]).collect()
}

pub fn largest(values: &[Rational]) -> Rational {
    values.iter().map(Rational::abs).max().unwrap_or_else(Rational::zero)
}

/// The ring of a scheme.
pub fn ring(scheme: &str) -> LocalRules {
    parse_local_rules(scheme).unwrap_or_else(|error| panic!("{error}"))
}

/// A connected mesh of 2 to `most` points: each is joined to an earlier one, and some
/// edges are added.
pub fn mesh(most: usize) -> impl Strategy<Value = (usize, Vec<(usize, usize)>)> {
    let index = any::<prop::sample::Index>;
    (2..=most).prop_flat_map(move |count| {
        let tree = prop::collection::vec(index(), count - 1);
        let more = prop::collection::vec((0..count, 0..count), 0..4);
        (tree, more).prop_map(move |(tree, more)| {
            let tree = tree.iter().zip(1..).map(|(earlier, point)| (earlier.index(point), point));
            (count, tree.chain(more.into_iter().filter(|(a, b)| a != b)).collect())
        })
    })
}

/// Any ring of up to `most` points: one weight of each row makes its sum 1.
pub fn any_ring(most: usize) -> impl Strategy<Value = LocalRules<Rational>> {
    mesh(most).prop_flat_map(|(count, edges)| {
        let rows = prop::collection::vec(prop::collection::vec(rational(), count), count);
        rows.prop_map(move |mut rows| {
            for (a, row) in rows.iter_mut().enumerate() {
                let rest: Rational = row.iter().sum();
                row[a] += &(Rational::one() - rest);
            }
            let orbits = vec![Orbit { name: "p".to_owned(), count }];
            LocalRules::new(orbits, rows, edges.clone()).expect("an affine ring")
        })
    })
}
