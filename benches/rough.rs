//! T_c and Λ_c of the masks of `rough/masks.txt`: `cargo bench --bench rough -- 64`, with the number of
//! levels, and optionally the numbers of the first mask and of the one after the last. With `T` only T_c is
//! computed, with `norm` only Λ_c.
//!
//! A line has the number of the mask, its arity and width, the seconds for T_c and for Λ_c, and both values; –
//! where the caps on work end the search.

use std::time::Instant;
use subcert::bound::{Order, PowerSearch};
use subcert::exact::{Rational, format::short};
use subcert::scheme::{Mask, Rules};

const MASKS: &str = include_str!("rough/masks.txt");

/// The mask of a line `q: row; row; …`, of coefficients times q.
fn mask(line: &str) -> Mask {
    let (q, rows) = line.split_once(':').expect("q before a colon");
    let q: i64 = q.parse().expect("an integer q");
    let number = |x: &str| Rational::new(x.parse::<i64>().expect("an integer"), q);
    let rows = rows.split(';').map(|row| row.split_whitespace().map(number).collect());
    Mask::new(rows.collect(), 0).expect("a mask")
}

fn timed(rules: &Rules, levels: u32) -> (f64, String) {
    let start = Instant::now();
    let found = PowerSearch::new(rules, Order::Adjoint).with_extreme_rows().norm(levels);
    let value = found.map_or_else(|_| "–".to_owned(), |norm| short(&norm.value, 6));
    (start.elapsed().as_secs_f64(), value)
}

fn main() {
    let only = |name: &str| std::env::args().any(|one| one == name);
    let (skip_t, skip_norm) = (only("norm"), only("T"));
    let numbers: Vec<usize> = std::env::args().filter_map(|one| one.parse().ok()).collect();
    let number = |i: usize, default| numbers.get(i).copied().unwrap_or(default);
    let levels = u32::try_from(number(0, 64)).expect("few levels");
    let (first, last) = (number(1, 0), number(2, 100));
    for (i, line) in MASKS.lines().enumerate().take(last).skip(first) {
        let mask = mask(line);
        let (difference, scheme) = (mask.difference(), mask.rules());
        let skipped = || (0.0, String::new());
        let t = if skip_t { skipped() } else { timed(&difference, levels) };
        let norm = if skip_norm { skipped() } else { timed(scheme, levels) };
        let (n, width) = (mask.arity(), mask.width());
        println!("{i:3} {n} {width} {:8.3} {:8.3}  {} {}", t.0, norm.0, t.1, norm.1);
    }
}
