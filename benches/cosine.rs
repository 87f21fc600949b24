//! Q(2cos(2π/n)): minimal polynomials, sign decisions, inverses, and the
//! eigenvalues of a Doo–Sabin face.

use divan::{Bencher, black_box};
use subcert::exact::{Rational, RealCyclotomic, cosine_polynomial};

fn main() {
    refinements();
    divan::main();
}

/// How often enclosures are refined for the signs of cos(2πj/n) less a fraction within
/// 2^−`bits` of it, j = 1, …, 50; and how often they would be, were they refined at once as
/// far as what separates a number f of `Z[2cos(2π/n)]` from 0 asks for: its norm is not 0,
/// and so |f| ≥ (Σ 2|a_k|)^−(m−1), m the degree of the field.
fn refinements() {
    println!(
        "{:>6} {:>5} {:>10} {:>12} {:>14}",
        "n", "bits", "decisions", "refinements", "by separation"
    );
    for (n, bits) in [(5, 40), (5, 400), (148, 40), (148, 100), (500, 40), (500, 400), (4999, 40)] {
        let degree = cosine_polynomial(n).degree().expect("a minimal polynomial");
        let decisions = (n / 2).min(50);
        let refined: u32 =
            (1..=decisions).map(|j| near(j, n, bits).sign_with_refinements().1).sum();
        // 2^bits·2cos(2πj/n) less an even integer of up to bits + 2 binary digits.
        let needed = (degree - 1) * (bits as usize + 3);
        let separated = decisions * needed.div_ceil(64).max(1).next_power_of_two().ilog2();
        println!("{n:>6} {bits:>5} {decisions:>10} {refined:>12} {separated:>14}");
    }
}

/// cos(2πj/n) less the greatest fraction of `bits` binary digits below it.
fn near(j: u32, n: u32, bits: u32) -> RealCyclotomic {
    let scale = Rational::from(2).pow(bits.cast_signed());
    let scaled = &cosine(j, n) * &RealCyclotomic::from(scale.clone());
    &cosine(j, n) - &RealCyclotomic::from(Rational::from(scaled.floor()) / scale)
}

fn cosine(j: u32, n: u32) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(j, n)).expect("below the cap")
}

#[divan::bench(args = [148, 499, 500, 1000, 4999, 5000])]
fn minimal_polynomial(n: u32) {
    black_box(cosine_polynomial(black_box(n)));
}

/// The sign of cos(2π/n) less a fraction within 2^−`bits` of it.
#[divan::bench(args = [(5, 40), (148, 40), (500, 40), (500, 400), (4999, 40)])]
fn sign(bencher: Bencher, (n, bits): (u32, u32)) {
    let off = near(1, n, bits);
    bencher.bench(|| black_box(&off).sign_with_refinements());
}

#[divan::bench(args = [5, 37, 148, 499], sample_count = 10)]
fn inverse(bencher: Bencher, n: u32) {
    let number = &cosine(1, n) + &(&RealCyclotomic::from(Rational::new(5, 3)) * &cosine(2, n));
    bencher.bench(|| black_box(&number).recip());
}

#[divan::bench(args = [7, 37, 148], sample_count = 10)]
fn minimal_polynomial_of_a_number(bencher: Bencher, n: u32) {
    let number = &cosine(1, n) + &(&RealCyclotomic::from(Rational::new(5, 3)) * &cosine(2, n));
    bencher.bench(|| black_box(&number).minimal_polynomial());
}

#[divan::bench(args = [5, 12, 37, 148], sample_count = 10)]
fn doo_sabin_eigenvalues(bencher: Bencher, n: u32) {
    let weight = |j: u32| {
        let cosine = &RealCyclotomic::from(Rational::new(2, 4 * n)) * &cosine(j, n);
        let plain = Rational::new(if j == 0 { n + 3 } else { 3 }, 4 * n);
        &cosine + &RealCyclotomic::from(plain)
    };
    bencher.bench(|| {
        let weights: Vec<RealCyclotomic> = (0..n).map(weight).collect();
        let eigenvalue = |m: u32| {
            let terms = weights.iter().zip(0..).map(|(w, j)| w * &cosine(j * m, n));
            terms.fold(RealCyclotomic::from(0), |sum, term| &sum + &term)
        };
        (0..n).map(eigenvalue).collect::<Vec<RealCyclotomic>>()
    });
}
