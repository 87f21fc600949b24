//! T_c of the 6-point scheme (w = 3/256) and of others: branch and bound, and against it the
//! walk over all rows on integers, on f64 and on fractions.

use divan::{Bencher, black_box};
use subcert::bound::{Order, PowerSearch, power_norm_generic, walked_norm};
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::scheme::{Rules, parse_scheme};

fn main() {
    divan::main();
}

fn difference(scheme: &str) -> Rules {
    parse_scheme(scheme).expect("a catalogue entry").masks()[0].difference()
}

fn six_point() -> Rules {
    difference("six-point:w=3/256")
}

#[divan::bench(args = [8, 12, 16, 20, 64, 256], sample_count = 10)]
fn exact(bencher: Bencher, levels: u32) {
    let rules = six_point();
    bencher.bench(|| PowerSearch::new(black_box(&rules), Order::Adjoint).search(levels));
}

#[divan::bench(args = [
    "four-point",
    "ternary-four-point-approximating",
    "quaternary-four-point:mu=0",
    "quinary-three-point",
], sample_count = 10)]
fn exact_64_levels(bencher: Bencher, scheme: &str) {
    let rules = difference(scheme);
    bencher.bench(|| PowerSearch::new(black_box(&rules), Order::Adjoint).search(64));
}

#[divan::bench(args = [8, 12, 16])]
fn every_row(bencher: Bencher, levels: u32) {
    let rules = six_point();
    bencher.bench(|| walked_norm(black_box(&rules), levels, Order::Adjoint));
}

#[divan::bench(args = [8, 12, 16])]
fn every_row_in_f64(bencher: Bencher, levels: u32) {
    let rules: Rules<f64> = six_point().map(nearest);
    bencher.bench(|| power_norm_generic(black_box(&rules), levels, Order::Adjoint));
}

#[divan::bench(args = [8], sample_count = 10)]
fn every_row_on_fractions(bencher: Bencher, levels: u32) {
    let rules: Rules<Rational> = six_point();
    bencher.bench(|| power_norm_generic(black_box(&rules), levels, Order::Adjoint));
}
