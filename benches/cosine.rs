//! Q(2cos(2π/n)): minimal polynomials, sign decisions, inverses, and the
//! eigenvalues of a Doo–Sabin face.

use divan::{Bencher, black_box};
use subcert::exact::{Rational, RealCyclotomic, cosine_polynomial};

fn main() {
    divan::main();
}

fn cosine(j: u32, n: u32) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(j, n)).expect("below the cap")
}

#[divan::bench(args = [148, 499, 500, 1000, 4999, 5000])]
fn minimal_polynomial(n: u32) {
    black_box(cosine_polynomial(black_box(n)));
}

/// The sign of cos(2π/n) less a fraction within 2^−`bits` of it.
#[divan::bench(args = [(5, 40), (500, 40), (500, 400), (4999, 40)])]
fn sign(bencher: Bencher, (n, bits): (u32, u32)) {
    let scale = Rational::from(2).pow(bits.cast_signed());
    let scaled = &cosine(1, n) * &RealCyclotomic::from(scale.clone());
    let near = RealCyclotomic::from(Rational::from(scaled.floor()) / scale);
    let off = &cosine(1, n) - &near;
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
