//! T_c of the 6-point scheme (w = 3/256): the integer kernel, and against it the
//! generic walk on fractions and on f64.

use divan::{Bencher, black_box};
use subcert::bound::{Order, power_norm, power_norm_generic};
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::scheme::{Rules, parse_scheme};

fn main() {
    divan::main();
}

fn six_point() -> Rules {
    let scheme = parse_scheme("six-point:w=3/256").expect("a catalogue entry");
    scheme.masks()[0].difference()
}

#[divan::bench(args = [8, 12, 16])]
fn exact(bencher: Bencher, levels: u32) {
    let rules = six_point();
    bencher.bench(|| power_norm(black_box(&rules), levels, Order::Adjoint));
}

#[divan::bench(args = [8, 12, 16])]
fn f64_walk(bencher: Bencher, levels: u32) {
    let rules: Rules<f64> = six_point().map(nearest);
    bencher.bench(|| power_norm_generic(black_box(&rules), levels, Order::Adjoint));
}

#[divan::bench(args = [8], sample_count = 10)]
fn exact_on_fractions(bencher: Bencher, levels: u32) {
    let rules: Rules<Rational> = six_point();
    bencher.bench(|| power_norm_generic(black_box(&rules), levels, Order::Adjoint));
}
