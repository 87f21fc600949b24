//! The named schemes against what is published about them.

use crate::common::{int, mask, r};
use std::collections::BTreeMap;
use subcert::exact::{FieldElement, Integer, Polynomial, Rational, Scalar};
use subcert::formula::{Parameters, evaluate, parse};
use subcert::scheme::{
    AnyScheme, Mask, MaskError, RulesError, catalogue, find, lagrange_mask, parse_algebraic,
    parse_any_scheme, parse_local_rules,
};

fn sums_to_one<S: Scalar + PartialEq>(mask: &Mask<S>, name: &str) {
    for row in mask.rules().rows() {
        assert!(S::total(row) == S::from_rational(&Rational::one()), "{name}");
    }
}

#[test]
fn every_entry_is_an_affine_mask_with_a_citation() {
    let names: Vec<&str> = catalogue().iter().map(|entry| entry.name.as_str()).collect();
    assert!(names.is_sorted_by(|a, b| a < b), "sorted, none twice: {names:?}");
    for entry in catalogue() {
        let name = &entry.name;
        assert!(find(name).is_some_and(|found| found.name == *name));
        assert!(!entry.title.is_empty(), "{name}");
        assert!(
            entry.citation.contains(char::is_numeric),
            "{name} cites nobody: {}",
            entry.citation
        );
        assert!(entry.parameters.values().all(|spec| !spec.about.is_empty()), "{name}");
        if entry.is_ring() {
            continue;
        }
        assert!(!entry.references().is_empty(), "{name} has no sample");
        for reference in entry.references() {
            match parse_any_scheme(&reference) {
                Ok(AnyScheme::Uniform(scheme)) => sums_to_one(scheme.masks()[0], &reference),
                // These are read only if each class sums to 1.
                Ok(AnyScheme::Lattice(mask)) => assert!(mask.coefficients().len() > 1, "{name}"),
                _ => sums_to_one(&parse_algebraic(&reference).unwrap(), &reference),
            }
        }
    }
    assert!(catalogue().iter().filter(|entry| entry.is_lattice()).count() >= 25);
    assert!(catalogue().len() >= 100);
    assert!(find("no-such-scheme").is_none());
}

// The mask with symbols, evaluated, is the mask with numbers.
#[test]
fn symbolic_masks_agree_with_numbers() {
    let mut symbolic_entries = 0;
    for entry in catalogue() {
        let names = entry.parameters.keys();
        let values: BTreeMap<_, _> = names.map(|name| (name.clone(), r(3, 29))).collect();
        let symbols =
            values.keys().map(|name| (name.clone(), Polynomial::variable(name))).collect();
        // Rules of integers, and irrational coefficients, are no polynomials.
        let (Ok(symbolic), Ok(numbers)) = (entry.mask(&symbols), entry.mask(&values)) else {
            continue;
        };
        let parameters = Parameters(values.clone());
        let at = |p: &Polynomial| evaluate(&parse(&p.to_string()).unwrap(), &parameters).unwrap();
        assert_eq!(symbolic.map(at), numbers, "{}", entry.name);
        let constant = symbolic.rules().rows().iter().flatten().all(|a| a.as_constant().is_some());
        assert_eq!(constant, values.is_empty(), "{}", entry.name);
        symbolic_entries += usize::from(!constant);
    }
    assert!(symbolic_entries >= 13);
}

fn over(denominator: i64, rows: &[&[i64]]) -> Vec<Vec<Rational>> {
    rows.iter().map(|row| row.iter().map(|&p| r(p, denominator)).collect()).collect()
}

#[test]
fn published_masks() {
    for (scheme, offset, rows) in [
        ("chaikin", 0, over(4, &[&[3, 1], &[1, 3]])),
        ("newton:j=0,n=2", 0, over(4, &[&[3, 1], &[1, 3]])),
        ("newton:j=0,n=3", 0, over(6, &[&[5, 1], &[3, 3], &[1, 5]])),
        // Dyn, Floater and Hormann 2005.
        ("newton:j=1,n=2", -1, over(128, &[&[-7, 105, 35, -5], &[-5, 35, 105, -7]])),
        (
            "newton:j=1,n=3",
            -1,
            over(1296, &[&[-55, 1155, 231, -35], &[-81, 729, 729, -81], &[-35, 231, 1155, -55]]),
        ),
        ("six-point:w=3/256", -2, over(256, &[&[0, 0, 256, 0, 0, 0], &[3, -25, 150, 150, -25, 3]])),
        ("six-point:w=0", -2, over(16, &[&[0, 0, 16, 0, 0, 0], &[0, -1, 9, 9, -1, 0]])),
        ("four-point", -1, over(16, &[&[0, 16, 0, 0], &[-1, 9, 9, -1]])),
        ("b-spline:degree=1", 0, over(2, &[&[2, 0], &[1, 1]])),
        ("b-spline:degree=3", -1, over(8, &[&[1, 6, 1], &[0, 4, 4]])),
    ] {
        let mask = mask(scheme);
        assert_eq!(mask.rules().rows(), rows, "{scheme}");
        assert_eq!(mask.offset(), offset, "{scheme}");
    }
    let ternary = mask("ternary-four-point-approximating");
    assert_eq!(ternary, mask("newton:j=1,n=3"));
    assert_eq!(ternary.rules().rows()[0], [r(-55, 1296), r(385, 432), r(77, 432), r(-35, 1296)]);
}

// Formula (3.23) and Lagrange's, and the sum that either makes.
#[test]
fn newton_is_lagrange() {
    for j in 0..=4_u32 {
        for n in 2..=8_u32 {
            let newton = mask(&format!("newton:j={j},n={n}"));
            assert_eq!(lagrange_mask(j, n), Ok(newton), "j = {j}, n = {n}");
        }
    }
    let refusal = |j, n| lagrange_mask(j, n).unwrap_err();
    assert_eq!(refusal(1, 1), MaskError::Rules(RulesError::Arity(1)));
    assert_eq!(refusal(1, u32::MAX), MaskError::Rules(RulesError::Arity(u32::MAX as usize)));
    assert_eq!(refusal(128, 2), MaskError::Rules(RulesError::Width(258)));
    assert_eq!(refusal(u32::MAX, 2), MaskError::Rules(RulesError::Width(2 * (1 << 32))));
}

/// Whether the rules take t^d at the integers to t^d at the points i + τ_α.
fn reproduces(mask: &Mask, degree: i32, tau: impl Fn(usize) -> Rational) -> bool {
    mask.rules().rows().iter().enumerate().all(|(alpha, row)| {
        let terms =
            (mask.offset()..).zip(row).map(|(node, a)| a * Rational::from(node).pow(degree));
        terms.sum::<Rational>() == tau(alpha).pow(degree)
    })
}

// The degree up to which a scheme reproduces polynomials, and no further.
#[test]
fn polynomial_reproduction() {
    let primal = |n: i64| move |alpha: usize| r(int(alpha), n);
    for (scheme, arity, degree) in [
        ("four-point", 2, 3),
        ("four-point:w=1/20", 2, 1),
        ("six-point:w=3/256", 2, 5),
        ("six-point:w=0", 2, 3),
        ("ternary-four-point:mu=1/11", 3, 2),
        ("ternary-four-point:mu=1/27", 3, 3),
        ("ternary-three-point:a=1/3", 3, 1),
        ("ternary-three-point:a=2/9", 3, 2),
        ("b-spline:degree=1", 2, 1),
    ] {
        let mask = mask(scheme);
        for d in 0..=degree {
            assert!(reproduces(&mask, d, primal(arity)), "{scheme} and t^{d}");
        }
        assert!(!reproduces(&mask, degree + 1, primal(arity)), "{scheme}: {degree} is sharp");
    }
    // Centred at rule 2: the quinary scheme reproduces quadratics.
    let quinary = mask("quinary-three-point");
    let centred = |alpha: usize| r(int(alpha) - 2, 5);
    assert!((0..=2).all(|d| reproduces(&quinary, d, centred)));
    assert!(!reproduces(&quinary, 3, centred));
    for j in 0..4_i32 {
        for n in 2..6_i64 {
            let newton = mask(&format!("newton:j={j},n={n}"));
            let dual = |alpha: usize| r(2 * int(alpha) + 1, 2 * n);
            assert!((0..2 * j + 2).all(|d| reproduces(&newton, d, dual)));
            assert!(!reproduces(&newton, 2 * j + 2, dual));
        }
    }
}

// Σ_k C(d+1, k)z^k/2^d, split by parity; degree 2 is Chaikin's.
#[test]
fn b_splines() {
    assert_eq!(mask("b-spline:degree=2"), mask("chaikin"));
    for degree in 1..12_u32 {
        let mask = mask(&format!("b-spline:degree={degree}"));
        let mut symbol = BTreeMap::new();
        for (alpha, row) in (0..).zip(mask.rules().rows()) {
            for (j, a) in (0_i64..).zip(row).filter(|(_, a)| !a.is_zero()) {
                // x_m enters x'_{2i+α} for i + o + j = m: the place 2i + α, less 2m.
                symbol.insert(alpha - 2 * (mask.offset() + j), a.clone());
            }
        }
        let scale = Integer::from(2).pow(degree);
        let pascal: Vec<Rational> = (0..=degree + 1)
            .map(|k| Rational::new(Integer::binomial(degree + 1, k), scale.clone()))
            .collect();
        let places: Vec<i64> = symbol.keys().copied().collect();
        assert!(places.windows(2).all(|pair| pair[1] == pair[0] + 1), "{places:?}");
        assert_eq!(symbol.into_values().collect::<Vec<_>>(), pascal);
    }
}

/// The integer translates of an orthonormal scaling function are so if Σ a_s a_{s+2k} is 2 for k = 0 and 0 for all
/// other k (Daubechies 1988): in the field of the coefficients, exactly.
#[test]
fn orthonormal_filters() {
    for name in ["haar", "daubechies-4", "daubechies-6", "daubechies-8", "coiflet-6"] {
        let mask = parse_algebraic(name).unwrap();
        let mut coefficients = BTreeMap::new();
        for (alpha, row) in (0_i64..).zip(mask.rules().rows()) {
            for (r, a) in (0_i64..).zip(row) {
                coefficients.insert(alpha - 2 * r, a.clone());
            }
        }
        for k in 0..mask.width() {
            let shift = 2 * i64::try_from(k).unwrap();
            let products: Vec<FieldElement> = coefficients
                .iter()
                .filter_map(|(s, a)| Some(a.times(coefficients.get(&(s + shift))?)))
                .collect();
            let expected = FieldElement::from_rational(&Rational::from(if k == 0 { 2 } else { 0 }));
            assert!(FieldElement::total(&products) == expected, "{name}, k = {k}");
        }
    }
}

/// Kobbelt's rules: cubic polynomials are reproduced at valence 4; and face points are their own mirror image, so that they are the
/// same by rows and by columns, at every valence.
#[test]
fn kobbelt_by_rows_and_columns() {
    let places = [(1, 0), (1, 1), (2, 0), (2, 1), (1, 2), (2, 2)];
    let turned = |(a, b): (i64, i64), turns: usize| (0..turns).fold((a, b), |(a, b), _| (-b, a));
    let mut points = vec![(0, 0)];
    for place in places {
        points.extend((0..4).map(|turns| turned(place, turns)));
    }
    let ring = parse_local_rules("kobbelt:N=4").expect("rules");
    for (p, q) in (0..=3).flat_map(|p| (0..=3).map(move |q| (p, q))) {
        let value = |(a, b): (i64, i64), scale: i64| r(a, scale).pow(p) * r(b, scale).pow(q);
        for (row, place) in points.iter().enumerate() {
            let terms = points.iter().enumerate().map(|(column, old)| {
                ring.weights().entry(row, column).as_rational().expect("rational") * &value(*old, 1)
            });
            let sum = terms.fold(Rational::zero(), |sum, x| sum + x);
            assert_eq!(sum, value(*place, 2), "{place:?} {p} {q}");
        }
    }
    // (orbit, its mirror image, i to shift − i).
    let mirror = [(1, 1, 1), (2, 2, 0), (3, 3, 1), (4, 5, 0), (5, 4, 0), (6, 6, 0)];
    for scheme in ["kobbelt:N=3", "kobbelt:N=5", "kobbelt:N=6", "kobbelt:N=9", "kobbelt:N=7,w=1/20"]
    {
        let ring = parse_local_rules(scheme).expect("rules");
        let n = ring.orbits()[1].count;
        let weight =
            |orbit: usize, i: usize| ring.weights().entry(1 + n, 1 + (orbit - 1) * n + i % n);
        for (orbit, other, shift) in mirror {
            for i in 0..n {
                assert_eq!(weight(orbit, i), weight(other, n + shift - i), "{scheme} {orbit} {i}");
            }
        }
    }
}
