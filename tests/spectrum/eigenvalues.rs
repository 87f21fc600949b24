//! Eigenvalues against traces of powers of the whole matrix, closed formulas and regular valences.

use super::{SCHEMES, cosine, number, power_sum, spectrum};
use crate::common::r;
use subcert::exact::{
    Rational, Real, RealCyclotomic, RealExpression, Scalar, format::fixed, format::short,
};
use subcert::float::nearest;
use subcert::scheme::{LocalRules, Orbit};
use subcert::spectrum::{Eigenvalue, Spectrum, SpectrumError, surroundings};

/// tr(M), tr(M²), … up to this power, by products of the whole matrix.
fn traces(ring: &LocalRules, powers: usize) -> Vec<RealCyclotomic> {
    let size = ring.point_count();
    let unit = |i: usize| (0..size).map(|j| RealCyclotomic::from(i64::from(i == j))).collect();
    let mut rows: Vec<Vec<RealCyclotomic>> = (0..size).map(unit).collect();
    let mut traces = Vec::new();
    for _ in 0..powers {
        rows = rows.iter().map(|row| ring.pull_back(row)).collect();
        traces.push(RealCyclotomic::total((0..size).map(|i| &rows[i][i])));
    }
    traces
}

// The power sums of the eigenvalues are the traces of the powers. They determine the eigenvalues once
// there are as many as points.
#[test]
fn power_sums_are_traces() {
    for scheme in SCHEMES {
        for n in [3, 4, 5, 8] {
            let rings = surroundings(scheme, Some(n)).expect("rules");
            let wider = rings.wider.as_ref().expect("a wider ring");
            let spectrum = rings.spectrum().expect("a spectrum");
            let count: usize = spectrum.eigenvalues.iter().map(|one| one.multiplicity).sum();
            assert_eq!(count, wider.point_count());
            for (k, trace) in (1..).zip(traces(wider, 4)) {
                assert_eq!(power_sum(&spectrum, k), trace.into(), "{scheme} {n}: power {k}");
            }
            // The ring alone has some of these eigenvalues.
            let alone = Spectrum::of(&rings.ring).expect("a spectrum");
            for one in &alone.eigenvalues {
                let found = spectrum.eigenvalues.iter().find(|other| other.real == one.real);
                assert!(found.is_some_and(|found| found.multiplicity >= one.multiplicity));
            }
            for (k, trace) in (1..).zip(traces(&rings.ring, rings.ring.point_count().min(7))) {
                assert_eq!(power_sum(&alone, k), trace.into(), "{scheme} {n}: power {k}");
            }
        }
    }
}

// λ = (c + 5 + √((c + 9)(c + 1)))/16 (Catmull–Clark), for every valence.
#[test]
fn closed_formulas() {
    let one = number(r(1, 1));
    for n in 3..=30 {
        let c = RealExpression::from(cosine(1, n));
        let plus = |k: i64| c.plus(&number(r(k, 1)));
        let root = plus(9).times(&plus(1)).sqrt().expect("a positive number");
        let catmull_clark = plus(5).plus(&root).over(&number(r(16, 1)));
        let loops = c.over(&number(r(4, 1))).plus(&number(r(3, 8)));
        let sqrt3 = plus(1).times(&number(r(2, 9)));
        let expected = [
            ("catmull-clark", catmull_clark),
            ("doo-sabin", number(r(1, 2))),
            ("loop", loops.clone()),
            ("loop-warren", loops.clone()),
            ("sqrt3", sqrt3),
        ];
        for (scheme, value) in expected {
            let spectrum = spectrum(scheme, n);
            let [first, second, ..] = &spectrum.eigenvalues[..] else { panic!("two at least") };
            assert_eq!((&first.real, first.multiplicity, &first.blocks[..]), (&one, 1, &[0][..]));
            assert_eq!(second.real, value, "{scheme} {n}");
            assert_eq!((second.multiplicity, &second.blocks[..]), (2, &[1, n - 1][..]));
        }
        // Loop's weights are such that block 0 has λ².
        let found = spectrum("loop", n);
        let square = loops.times(&loops);
        let with = |one: &&Eigenvalue| one.real == square && one.blocks.contains(&0);
        assert!(found.eigenvalues.iter().any(|one| with(&one)), "loop {n}");
    }
}

// At the regular valence 4, Catmull–Clark's matrix on 5×5 points is the tensor square of that of the cubic
// B-spline on 5 points, with the eigenvalues 1, 1/2, 1/4, 1/8, 1/8. At valence 6, Loop's matrix has
// the eigenvalues 1, 1/2, 1/2 and 1/4 three times, and Doo–Sabin's at valence 4 is that of biquadratics:
// 1, 1/2, 1/4, 1/4 twice over.
#[test]
fn regular_valences() {
    let of = |scheme: &str, n: usize| -> Vec<Rational> {
        let found = spectrum(scheme, n);
        let value = |one: &Eigenvalue| {
            let value = one.real.as_rational().expect("a rational eigenvalue").clone();
            std::iter::repeat_n(value, one.multiplicity)
        };
        found.eigenvalues.iter().flat_map(value).collect()
    };
    let products = |values: &[Rational]| {
        let mut products: Vec<Rational> =
            values.iter().flat_map(|x| values.iter().map(move |y| x * y)).collect();
        products.sort_by(|a, b| b.cmp(a));
        products
    };
    let powers = |exponents: &[i32]| -> Vec<Rational> {
        exponents.iter().map(|k| r(1, 2).pow(*k)).collect()
    };
    assert_eq!(of("catmull-clark", 4), products(&powers(&[0, 1, 2, 3, 3])));
    assert_eq!(of("doo-sabin", 4), products(&powers(&[0, 1, 2, 2])));
    assert_eq!(of("loop", 6)[..6], powers(&[0, 1, 1, 2, 2, 2]));
    assert_eq!(of("loop", 6), of("loop-warren", 6));
}

#[test]
fn at_most_as_large_as_stated() {
    assert_eq!(
        surroundings("catmull-clark", Some(99))
            .expect("rules")
            .wider
            .map(|ring| ring.point_count()),
        Some(595)
    );
    assert_eq!(surroundings("catmull-clark", Some(100)).expect("rules").wider, None);
}

/// A ring of n points with these weights of the points i, i + 1, …
fn circulant(weights: &[Rational]) -> LocalRules {
    let n = weights.len();
    let row = |i: usize| (0..n).map(|j| weights[(j + n - i) % n].clone().into()).collect();
    let orbits = vec![Orbit { name: "corner".to_owned(), count: n }];
    let edges = (0..n).map(|i| (i, (i + 1) % n)).collect();
    LocalRules::new(orbits, (0..n).map(row).collect(), edges).expect("a ring")
}

#[test]
fn rings_without_these_symmetries_are_refused() {
    let turned = circulant(&[r(1, 2), r(1, 2), r(0, 1), r(0, 1)]);
    assert!(matches!(Spectrum::of(&turned), Err(SpectrumError::NoReflection { .. })));
    let mut rows: Vec<Vec<RealCyclotomic>> =
        (0..4).map(|i| ring_row(&circulant(&[r(1, 2), r(1, 4), r(0, 1), r(1, 4)]), i)).collect();
    rows[0].swap(1, 2);
    let orbits = vec![Orbit { name: "corner".to_owned(), count: 4 }];
    let edges = vec![(0, 1), (1, 2), (2, 3), (3, 0)];
    let uneven = LocalRules::new(orbits, rows, edges).expect("a ring");
    assert!(matches!(Spectrum::of(&uneven), Err(SpectrumError::NotSymmetric)));
    let pair = circulant(&[r(1, 2), r(1, 2)]);
    assert!(matches!(Spectrum::of(&pair), Err(SpectrumError::NoRotation)));
}

fn ring_row(ring: &LocalRules, i: usize) -> Vec<RealCyclotomic> {
    ring.weights().row(i).cloned().collect()
}

// Two cycles a and b that turn into each other: a' = b − a/5 around, b' = −a: blocks with eigenvalues
// x ± iy. Their modulus is the root of the determinant of the block.
#[test]
fn complex_eigenvalues() {
    let n = 5;
    let unit = |at: usize, value: Rational| {
        let mut row = vec![RealCyclotomic::from(0); 2 * n];
        row[at] = value.into();
        row
    };
    let rows = |i: usize| {
        let mut row = if i < n { unit(n + i, r(1, 2)) } else { unit(i - n, r(-1, 2)) };
        let rest = if i < n { r(1, 2) } else { r(3, 2) };
        for j in 0..n {
            let at = if i < n { j } else { n + j };
            row[at] = row[at].plus(&RealCyclotomic::from(&rest / r(5, 1)));
        }
        row
    };
    let orbits = ["a", "b"].map(|name| Orbit { name: name.to_owned(), count: n }).to_vec();
    let edges = (0..n).flat_map(|i| [(i, (i + 1) % n), (i, n + i)]).collect();
    let ring = LocalRules::new(orbits, (0..2 * n).map(rows).collect(), edges).expect("a ring");
    let spectrum = Spectrum::of(&ring).expect("a spectrum");
    let pair = spectrum.eigenvalues.iter().find(|one| one.imaginary.is_some()).expect("a pair");
    // Blocks 1 to 4 are [[0, 1/2], [−1/2, 0]].
    assert_eq!(pair.imaginary, Some(number(r(1, 2))));
    assert_eq!((pair.real.sign(), fixed(&pair.modulus, 3)), (0, "0.500".to_owned()));
    assert_eq!((pair.multiplicity, &pair.blocks[..]), (4, &[1, 2, 3, 4][..]));
    assert!(spectrum.conditions.subdominant.is_none() && spectrum.tangents.is_none());
}

/// Cubic factors with a pair of complex roots: the powers of all roots sum to the traces of powers of the matrix.
#[test]
fn cubic_factors_with_complex_roots() {
    for n in [5, 8, 11] {
        let ring = surroundings("butterfly", Some(n)).expect("a ring").ring;
        let found = spectrum("butterfly", n);
        assert!(found.eigenvalues.iter().any(|one| one.imaginary.is_some()));
        let count = ring.point_count();
        let entry = |a: usize, b: usize| nearest(ring.weights().entry(a, b));
        let trace: f64 = (0..count).map(|a| entry(a, a)).sum();
        let square: f64 = (0..count)
            .flat_map(|a| (0..count).map(move |b| (a, b)))
            .map(|(a, b)| entry(a, b) * entry(b, a))
            .sum();
        let (mut sum, mut squares) = (0.0, 0.0);
        for one in &found.eigenvalues {
            let decimal = |x| short(x, 14).parse::<f64>().expect("a number");
            let (x, y) = (decimal(&one.real), one.imaginary.as_ref().map_or(0.0, decimal));
            let times = f64::from(u16::try_from(one.multiplicity).expect("small"));
            let times = if one.imaginary.is_some() { 2.0 * times } else { times };
            sum += times * x;
            squares += times * (x * x - y * y);
            assert!((decimal(&one.modulus) - x.hypot(y)).abs() < 1e-12);
        }
        assert!(
            (sum - trace).abs() < 1e-9 && (squares - square).abs() < 1e-9,
            "{n}: {sum} {squares}"
        );
    }
}
