//! Whether limits keep positivity, monotonicity and convexity, against data that are refined many times.

use crate::masks::relation;
use std::fmt::Write as _;
use subcert_check::Outcome;

/// Numbers that look random.
struct Numbers(u64);

impl Numbers {
    /// One from `least` to `most`.
    fn next(&mut self, least: i32, most: i32) -> i32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        least + i32::try_from((self.0 >> 33) % u64::from(least.abs_diff(most) + 1)).unwrap_or(0)
    }
}

/// The places of data. All are refined; those that need points beyond are left out.
const POINTS: usize = 14;

/// x_i = Σ_k a_{i−nk} x_k, where all of these points are known.
fn refined(mask: &[f64], n: usize, data: &[f64]) -> Vec<f64> {
    let reach = mask.len().div_ceil(n) * n;
    // The points k with a_{i−nk} in the mask.
    let point = |i: usize| -> f64 {
        mask.iter()
            .enumerate()
            .skip(i % n)
            .step_by(n)
            .map(|(place, a)| a * data[(i - place) / n])
            .sum()
    };
    (reach..n * data.len()).map(point).collect()
}

/// The least m-th difference at a distance of some points.
fn least(data: &[f64], m: usize, distance: usize) -> f64 {
    let weights: &[f64] = match m {
        0 => &[1.0],
        1 => &[-1.0, 1.0],
        _ => &[1.0, -2.0, 1.0],
    };
    let difference = |i: usize| {
        weights.iter().enumerate().map(|(place, w)| w * data[i + place * distance]).sum::<f64>()
    };
    (0..data.len().saturating_sub(m * distance)).map(difference).fold(f64::INFINITY, f64::min)
}

/// The least m-th difference of refined data whose own m-th differences are not negative, at coarse distances. It is about that
/// of the limit.
fn lowest(mask: &[f64], n: usize, m: usize, numbers: &mut Numbers) -> f64 {
    let levels = if n == 2 { 12 } else { 8 };
    let mut lowest = f64::INFINITY;
    for round in 0..4 {
        // The first data have one difference only.
        let mut data: Vec<f64> = (0..POINTS)
            .map(|i| {
                if round == 0 {
                    f64::from(u8::from(i == POINTS / 2))
                } else {
                    numbers.next(0, 3).into()
                }
            })
            .collect();
        for _ in 0..m {
            let mut sum = -4.0;
            data = data
                .iter()
                .map(|x| {
                    sum += x;
                    sum
                })
                .collect();
        }
        for _ in 0..levels {
            data = refined(mask, n, &data);
        }
        for level in 4..levels {
            let distance = n.pow(level);
            lowest = lowest.min(least(&data, m, distance));
        }
    }
    lowest
}

/// What the checker finds: 1, 0, or nothing.
fn found(symbol: &str, function: &str) -> Option<bool> {
    let states = format!("{function}(tested)");
    let fields = format!("states = '{states}'\n[[scheme]]\nname = 'tested'\nsymbol = '{symbol}'");
    let outcome = |lines: &str| relation(&fields, &format!("states {states}\n {lines}"));
    match (outcome("holds 1"), outcome("fails 1\n case = -1")) {
        (Outcome::Valid, Outcome::Invalid(..)) => Some(true),
        (Outcome::Invalid(..), Outcome::Valid) => Some(false),
        (Outcome::Incomplete(_), Outcome::Incomplete(_)) => None,
        other => panic!("{symbol}: {other:?}"),
    }
}

#[test]
fn refined_data_have_the_shapes() {
    let mut numbers = Numbers(7);
    let mut counts = [[0; 3]; 3];
    for _ in 0..400 {
        let n = if numbers.next(0, 2) == 0 { 3 } else { 2 };
        // σ^p times other factors.
        let power = numbers.next(1, 3);
        let other: Vec<i32> = (0..numbers.next(1, 4)).map(|_| numbers.next(-2, 4)).collect();
        let total: i32 = other.iter().sum();
        if total <= 0 || other[0] == 0 || other[other.len() - 1] == 0 {
            continue;
        }
        let mut mask: Vec<f64> = other.iter().map(|c| f64::from(*c) / f64::from(total)).collect();
        let mut symbol = String::from("(0");
        for (k, c) in other.iter().enumerate() {
            let _ = write!(symbol, " + ({c})*z^{k}");
        }
        let sigma = if n == 2 { "1 + z" } else { "1 + z + z^2" };
        let _ = write!(symbol, ")/{total}*(({sigma})/{n})^{power}*{n}");
        for _ in 0..power {
            let mut product = vec![0.0; mask.len() + n - 1];
            for (k, a) in mask.iter().enumerate() {
                for sum in &mut product[k..k + n] {
                    *sum += a / if n == 2 { 2.0 } else { 3.0 };
                }
            }
            mask = product;
        }
        for a in &mut mask {
            *a *= if n == 2 { 2.0 } else { 3.0 };
        }
        for (m, function) in ["positive", "monotone", "convex"].iter().enumerate() {
            let found = found(&symbol, function);
            counts[m][found.map_or(2, usize::from)] += 1;
            let Some(found) = found else { continue };
            let lowest = lowest(&mask, n, m, &mut numbers);
            assert_eq!(found, lowest > -1e-9, "{function}: {symbol}: {lowest}");
        }
    }
    println!("{counts:?}");
    assert!(counts.as_flattened().iter().all(|count| *count > 5), "{counts:?}");
}
