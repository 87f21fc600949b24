//! `keeps_ratios`, against brute force.

use crate::masks::{relation_of, values};
use crate::zeros::{Numbers, float};
use std::fmt::Write as _;
use subcert_check::Outcome;

#[test]
fn ratios_that_are_known() {
    values(&[
        ("keeps_ratios(hat, 1, 1)", "1"),
        ("keeps_ratios(hat, 1, 7/5)", "1"),
        ("keeps_ratios(hat, 1, 2*cos(pi/5))", "1"),
        // The first differences of corner cutting keep them for 1/(r + 3) ≤ w ≤ r/(3r + 1), and w is 1/3 or 1/4.
        ("keeps_ratios(two, 1, 1)", "1"),
        ("keeps_ratios(two, 1, 9)", "1"),
        ("keeps_ratios(cutting, 1, 10^9)", "0"),
        ("keeps_ratios(golden, 1, 5)", "0"),
        ("keeps_ratios(golden, 1, 11/2)", "1"),
        ("keeps_ratios(golden, 1, 1/(2*cos(pi/5) - 3/2) - 3)", "1"),
        ("keeps_ratios(golden, 1, 1/(2*cos(pi/5) - 3/2) - 3 - 1/10^9)", "0"),
        ("keeps_ratios(haar, 1, 3)", "0"),
        ("keeps_ratios(haar, 0, 3)", "1"),
        ("keeps_ratios(four, 1, 1)", "1"),
        ("keeps_ratios(four, 4, 2)", "0"),
        ("keeps_ratios(wild, 0, 2)", "0"),
    ]);
}

/// Conditions on a window are least where each ratio is 1/r or r.
#[test]
fn ratios_by_brute_force() {
    let (mut numbers, mut seen) = (Numbers(11), [0; 2]);
    for round in 0..120 {
        let n = 2 + usize::from(round % 3 == 0);
        let length = 1 + usize::try_from(numbers.around(3).abs()).unwrap_or(0);
        let positive = numbers.around(1) != 0;
        let entry = |numbers: &mut Numbers| {
            let c = numbers.around(4);
            if positive { 5 + c } else { c }
        };
        let b: Vec<i64> = (0..length).map(|_| entry(&mut numbers)).collect();
        let total: i64 = b.iter().sum();
        if total == 0 || b[0] == 0 || b[length - 1] == 0 {
            continue;
        }
        let r = [1.0, 2.0, 4.0, 8.0][round % 4];
        let sign = if total < 0 { -1.0 } else { 1.0 };
        let count = 2 + (length + 1) / n + 1;
        let keeps = (0_u32..1 << count).all(|word| {
            let mut d = vec![1.0];
            for i in 0..count {
                d.push(d[i] * if word >> i & 1 == 1 { r } else { 1.0 / r });
            }
            // The points on which the window has all influence.
            let image = |j: usize| -> f64 {
                let places = d.iter().enumerate();
                let of = |(i, d): (usize, &f64)| {
                    let b = j.checked_sub(n * i).and_then(|k| b.get(k));
                    b.map_or(0.0, |b| sign * float(*b) * d)
                };
                places.map(of).sum()
            };
            (length + 1..n * (count + 1) - 1).all(|j| {
                let (this, next) = (image(j), image(j + 1));
                this >= 0.0 && next <= r * this && this <= r * next
            })
        });
        let mut text = String::from("0");
        for (k, c) in b.iter().enumerate() {
            let _ = write!(text, " + ({c})*z^{k}");
        }
        let sigma = if n == 2 { "(1 + z)" } else { "(1 + z + z^2)" };
        let shift = numbers.around(3);
        let scheme =
            format!("[[scheme]]\nname = 's'\nsymbol = 'z^({shift})*{sigma}*({text})/({total})'\n");
        let states = format!("keeps_ratios(s, 1, {r}) = {}", i64::from(keeps));
        let lines = format!("states {states}\n holds 1");
        let found = relation_of(&scheme, &format!("states = '{states}'"), &lines);
        assert_eq!(found, Outcome::Valid, "{text} {n} {states}");
        seen[usize::from(keeps)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] >= 10, "{seen:?}");
}
