//! The quantities of the comparison with other systems: their exact values and our times, as
//! JSON on stdout. `benches/peers/run.sh` runs it.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};
use subcert::bound::{Order, power_norm, walked_norm};
use subcert::exact::{
    Integer, IntegerPolynomial, Rational, RealAlgebraic, RealCyclotomic, cosine_polynomial,
};
use subcert::scheme::{Rules, parse_scheme};

/// The least time of several runs, in seconds, and the value.
fn timed<T>(mut run: impl FnMut() -> T) -> (T, f64) {
    let begin = Instant::now();
    let (mut best, mut runs) = (Duration::MAX, 0);
    loop {
        let start = Instant::now();
        let value = run();
        best = best.min(start.elapsed());
        runs += 1;
        if runs >= 3 && begin.elapsed() > Duration::from_millis(100) {
            return (value, best.as_secs_f64());
        }
    }
}

fn texts(values: &[Integer]) -> Vec<String> {
    values.iter().map(Integer::to_string).collect()
}

/// T_c of the 6-point scheme.
fn contraction(rules: &Rules, c: u32) -> Value {
    let (norm, seconds) = timed(|| power_norm(rules, c, Order::Adjoint));
    let norm = norm.expect("in reach");
    let (walked, walk_seconds) = timed(|| walked_norm(rules, c, Order::Adjoint));
    assert_eq!(walked.as_ref(), Ok(&norm), "both kernels");
    let rows = rules.rows().iter();
    let mask: Vec<Vec<String>> =
        rows.map(|row| row.iter().map(Rational::to_string).collect()).collect();
    json!({
        "kind": "contraction", "argument": c.to_string(), "mask": mask, "seconds": seconds,
        "walk_seconds": walk_seconds, "value": norm.value.to_string(),
    })
}

/// The minimal polynomial of 2cos(2π/n).
fn minimal_polynomial(n: u32) -> Value {
    let (polynomial, seconds) = timed(|| cosine_polynomial(n));
    json!({
        "kind": "minimal polynomial", "argument": n.to_string(), "seconds": seconds,
        "value": texts(polynomial.coefficients()),
    })
}

/// The sign of cos(2π/n) less a fraction of `bits` binary digits next to it.
fn sign(n: u32, bits: u32) -> Value {
    let cosine = RealCyclotomic::cosine(&Rational::new(1, n)).expect("below the cap");
    let scale = Rational::from(2).pow(bits.cast_signed());
    let scaled = &cosine * &RealCyclotomic::from(scale.clone());
    let near = Rational::from(scaled.floor() + Integer::from(n % 2)) / scale;
    let off = &cosine - &RealCyclotomic::from(near.clone());
    let ((sign, refinements), seconds) = timed(|| off.clone().sign_with_refinements());
    json!({
        "kind": "sign", "argument": format!("{n}, {bits} bits"), "n": n, "near": near.to_string(),
        "seconds": seconds, "value": sign, "refinements": refinements,
    })
}

/// The roots from 0 to 1/4 of the entries of (2D)^c for the 4-point scheme with a free weight
/// w: between them T_c is a polynomial in w.
fn range(c: u32) -> Value {
    let polynomials = four_point_entries(c);
    let quarter = Rational::new(1, 4);
    let (count, seconds) = timed(|| {
        let found = |p: &IntegerPolynomial| {
            RealAlgebraic::roots_between(p, Some(Rational::zero()), Some(quarter.clone())).len()
        };
        polynomials.iter().map(found).sum::<usize>()
    });
    let polynomials: Vec<Vec<String>> =
        polynomials.iter().map(|polynomial| texts(polynomial.coefficients())).collect();
    json!({
        "kind": "range", "argument": c.to_string(), "polynomials": polynomials,
        "seconds": seconds, "value": count,
    })
}

/// The different entries of (2D)^c that are not constant, for the rules 2D = (2w, 1, −2w),
/// (−2w, 1, 2w).
fn four_point_entries(c: u32) -> Vec<IntegerPolynomial> {
    let mut different: Vec<IntegerPolynomial> = Vec::new();
    for class in 0..2_i64.pow(c) {
        let mut row = BTreeMap::from([(class, vec![Integer::one()])]);
        for _ in 0..c {
            row = coarser(&row);
        }
        for entry in row.into_values().map(IntegerPolynomial::new) {
            if entry.degree().is_some_and(|degree| degree > 0) && !different.contains(&entry) {
                different.push(entry);
            }
        }
    }
    different
}

/// A row times 2D; its entries are polynomials in w, lowest degree first.
fn coarser(row: &BTreeMap<i64, Vec<Integer>>) -> BTreeMap<i64, Vec<Integer>> {
    let mut coarse: BTreeMap<i64, Vec<Integer>> = BTreeMap::new();
    for (index, entry) in row {
        let sign = if index.rem_euclid(2) == 0 { 2 } else { -2 };
        let times_w = |factor: i32| {
            let shifted = entry.iter().map(|x| x * Integer::from(factor));
            std::iter::once(Integer::zero()).chain(shifted).collect::<Vec<Integer>>()
        };
        let terms = [times_w(sign), entry.clone(), times_w(-sign)];
        for (column, term) in (index.div_euclid(2)..).zip(terms) {
            let sum = coarse.entry(column).or_default();
            sum.resize(sum.len().max(term.len()), Integer::zero());
            for (x, y) in sum.iter_mut().zip(term) {
                *x += &y;
            }
        }
    }
    coarse
}

fn main() {
    let scheme = parse_scheme("six-point:w=3/256").expect("a catalogue entry");
    let rules = scheme.masks()[0].difference();
    let records = (8..=18).step_by(2).map(|c| contraction(&rules, c));
    let minimal = [37, 74, 148, 499, 1000, 5000].map(minimal_polynomial);
    let signs = [(5, 40), (37, 40), (148, 40), (148, 400), (500, 40), (500, 400)];
    let signs = signs.map(|(n, bits)| sign(n, bits));
    let ranges = [2, 4, 6].map(range);
    let records: Vec<Value> = records.chain(minimal).chain(signs).chain(ranges).collect();
    println!("{}", Value::from(records));
}
