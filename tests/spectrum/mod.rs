//! Spectra of rings: closed formulas, traces of powers, regular valences, stencils, tables; sectors between sharp edges.

mod conditions;
mod eigenvalues;
mod every;
mod sectors;
mod stencils;
mod table;

use subcert::exact::{Rational, RealCyclotomic, RealExpression, Scalar};
use subcert::spectrum::{Spectrum, surroundings};

/// The schemes with their own wider rings.
const SCHEMES: [&str; 5] = ["catmull-clark", "doo-sabin", "loop", "loop-warren", "sqrt3"];

fn spectrum(scheme: &str, n: usize) -> Spectrum {
    let rings = surroundings(scheme, Some(n)).unwrap_or_else(|error| panic!("{error}"));
    rings.spectrum().unwrap_or_else(|error| panic!("{scheme} {n}: {error}"))
}

fn number(value: Rational) -> RealExpression {
    RealExpression::from(value)
}

/// cos(2πk/n).
fn cosine(k: usize, n: usize) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(k, n)).expect("a small field")
}

/// The sum of the powers of degree `power` of all eigenvalues.
fn power_sum(spectrum: &Spectrum, power: usize) -> RealExpression {
    let mut sum = RealExpression::zero();
    for one in &spectrum.eigenvalues {
        assert!(one.imaginary.is_none());
        let value = (1..power).fold(one.real.clone(), |value, _| value.times(&one.real));
        sum = sum.plus(&value.times(&number(Rational::from(one.multiplicity))));
    }
    sum
}
