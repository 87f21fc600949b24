//! Exponents of Sobolev, and those of lines `limits`.

use crate::masks::{outcome, relation_of, values};
use subcert_check::Outcome;

#[test]
fn sobolev_of_splines_and_wavelets() {
    values(&[
        ("sobolev(haar)", "1/2"),
        ("sobolev(hat)", "3/2"),
        ("sobolev(two)", "5/2"),
        ("sobolev(cubic)", "7/2"),
        ("sobolev(bell)", "17/2"),
        ("sobolev(ternary)", "3/2"),
        ("sobolev(daubechies)", "1"),
    ]);
}
/// The bounds that a formula has, for now.
fn bounds(formula: &str) {
    let start = std::time::Instant::now();
    let found = outcome(&format!("{formula} = 0"), "holds 1");
    let text = format!("{found:?}");
    if let Some((_, rest)) = text.split_once("DEBUG ") {
        let words: Vec<f64> = rest
            .split(|c: char| c == ' ' || c == '"')
            .take(2)
            .map(|w| {
                let (a, b) = w.split_once('/').unwrap_or((w, "1"));
                let cut = |x: &str| -> f64 {
                    let x = x.trim_end_matches('.');
                    x.parse::<f64>().unwrap_or(f64::NAN)
                };
                cut(a) / cut(b)
            })
            .collect();
        eprintln!("{formula}: {words:?} {:e} {:?}", words[1] - words[0], start.elapsed());
    } else {
        eprintln!("{formula}: {text} {:?}", start.elapsed());
    }
}
#[test]
fn show() {
    for s in [
        "four",
        "late",
        "third",
        "endless",
        "averaged",
        "golden",
        "daubechies",
        "hat",
        "haar",
        "cubic",
        "bell",
        "mirrored",
        "later",
        "cutting",
        "dual",
        "round",
    ] {
        bounds(&format!("riesz_lower({s})"));
        bounds(&format!("riesz_upper({s})"));
    }
    for f in [
        "inner_product(haar, 0)",
        "inner_product(haar, 1)",
        "inner_product(haar, 0, with = hat)",
        "independent(haar)",
        "independent(averaged)",
        "independent(daubechies)",
        "same(hat, with = hat)",
        "same(hat, with = b-spline)",
        "same(scheme = b-spline, degree=3, with = cubic)",
    ] {
        bounds(f);
    }
}
