//! Laws of random masks on Z^d, and the definitions as naive twins.

use crate::common::{cases, r};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::bound::{Order, power_norm};
use subcert::exact::Rational;
use subcert::lattice::{
    Edges, Functional, LatticeConstants, Steps, attractor, displacement, factors, natural_shift,
    proves, reproduction, sum_rules, window,
};
use subcert::scheme::{Dilation, LatticeMask, Mask, Point, catalogue, parse_scheme, sum};
use subcert::smoothness::{Symbol, reproduction_degree};

fn dilations() -> impl Strategy<Value = Dilation> {
    let all = [
        [[2, 0], [0, 2]],
        [[1, 1], [1, -1]],
        [[1, -1], [1, 1]],
        [[1, 2], [-2, -1]],
        [[2, -1], [1, -2]],
        [[0, 2], [-1, 0]],
        [[2, 0], [0, 3]],
        [[1, 3], [1, -1]],
        [[-2, 0], [0, -2]],
    ];
    prop::sample::select(all.to_vec())
        .prop_map(|rows| Dilation::new(&rows.map(|row| row.to_vec())).expect("it expands"))
}

fn edges() -> impl Strategy<Value = Vec<Point>> {
    let all = vec![
        vec![[1, 0, 0], [0, 1, 0]],
        vec![[1, 0, 0], [0, 1, 0], [1, 1, 0]],
        vec![[1, 0, 0], [0, 1, 0], [1, -1, 0]],
        vec![[1, 0, 0], [0, 1, 0], [1, 2, 0]],
        vec![[2, 1, 0], [1, 1, 0]],
    ];
    prop::sample::select(all)
}

/// A mask with random coefficients, those at the digits such that each class sums to 1.
fn masks() -> impl Strategy<Value = LatticeMask> {
    let terms = prop::collection::btree_map((-2_i64..3, -2_i64..3), -4_i64..5, 1..9);
    (dilations(), edges(), terms).prop_map(|(dilation, edges, terms)| {
        let mut all: BTreeMap<Point, Rational> = BTreeMap::new();
        let mut sums = vec![Rational::one(); dilation.class_count()];
        for ((x, y), c) in terms {
            sums[dilation.split([x, y, 0]).0] -= &r(c, 8);
            all.insert([x, y, 0], r(c, 8));
        }
        for (digit, rest) in dilation.digits().iter().zip(sums) {
            *all.entry(*digit).or_insert_with(Rational::zero) += &rest;
        }
        LatticeMask::new(dilation, all, edges).expect("each class sums to 1")
    })
}

/// (Sp)_α = Σ_β a(α − Mβ) p_β, by the definition.
pub(super) fn refined(mask: &LatticeMask, net: &Functional<Rational>) -> Functional<Rational> {
    let mut refined = BTreeMap::new();
    for (place, value) in net {
        for (at, c) in mask.coefficients() {
            let place = sum(mask.dilation().times(*place), *at);
            *refined.entry(place).or_insert_with(Rational::zero) += &(c * value);
        }
    }
    refined
}

fn applied(functional: &Functional<Rational>, net: &Functional<Rational>) -> Rational {
    functional.iter().filter_map(|(place, c)| Some(c * net.get(place)?)).sum()
}

proptest! {
    #![proptest_config(cases(96))]

    /// Digits and quotients: α = Mβ + ε, one digit for each class.
    #[test]
    fn classes(dilation in dilations(), x in -50_i64..50, y in -50_i64..50) {
        let (class, quotient) = dilation.split([x, y, 0]);
        prop_assert_eq!(sum(dilation.times(quotient), dilation.digits()[class]), [x, y, 0]);
        prop_assert_eq!(dilation.class_count() as u64, dilation.determinant().unsigned_abs());
        prop_assert_eq!(dilation.digits()[0], [0, 0, 0]);
    }

    /// The rows of two steps, and their differences, are those of two steps by the definition.
    #[test]
    fn steps(mask in masks(), net in prop::collection::btree_map((-2_i64..3, -2_i64..3), -9_i64..10, 1..9)) {
        let net: Functional<Rational> =
            net.into_iter().map(|((x, y), value)| ([x, y, 0], Rational::from(value))).collect();
        let twice = refined(&mask, &refined(&mask, &net));
        let steps = Steps::none(&mask).next().next();
        let at = |place: Point| twice.get(&place).cloned().unwrap_or_else(Rational::zero);
        for (place, row) in steps.rows() {
            prop_assert_eq!(applied(&row, &net), at(place));
        }
        for (place, edge, difference) in steps.differences() {
            prop_assert_eq!(applied(&difference, &net), at(sum(place, edge)) - at(place));
        }
    }

    /// T_c is proved from both sides, and submultiplicative; Λ_c is at least 1.
    #[test]
    fn constants(mask in masks()) {
        let edges = Edges::new(mask.edges(), 2);
        let mut constants = LatticeConstants::new(&mask);
        let mut found = Vec::new();
        for _ in 0..3 {
            constants.advance().expect("few classes");
            let contraction = constants.contraction().expect("few places");
            prop_assert!(proves(&contraction.functional, &edges, &contraction.norm));
            for (_, _, functional) in constants.steps().differences() {
                let norm = edges.norm(&functional).expect("few places");
                prop_assert!(norm.value <= contraction.value && proves(&functional, &edges, &norm));
            }
            prop_assert!(constants.norm() >= Rational::one());
            found.push(contraction.value);
        }
        prop_assert!(found[1] <= &found[0] * &found[0] && found[2] <= &found[1] * &found[0]);
    }

    /// Data of polynomials of a degree below K give polynomials, and for some monomial of degree K they do not.
    #[test]
    fn polynomials(mask in masks()) {
        let order = sum_rules(&mask);
        prop_assert!(order >= 1 && reproduction(&mask) < order);
        let shift = natural_shift(&mask);
        // The centre of mass: τ = M^{−1}(τ + m_1).
        for (i, row) in mask.dilation().rows().enumerate() {
            let image: Rational = row.iter().zip(&shift).map(|(m, x)| Rational::from(*m) * x).sum();
            let scale = Rational::from(mask.dilation().class_count()).recip();
            let mean: Rational =
                mask.coefficients().iter().map(|(at, c)| c * &Rational::from(at[i])).sum();
            prop_assert_eq!(image, &shift[i] + &(mean * scale));
        }
    }

    /// No net moves by more than σ at any point, and σ is not less than what moves the points of level 1.
    #[test]
    fn displacements(mask in masks()) {
        let edges = Edges::new(mask.edges(), 2);
        let zero = vec![Rational::zero(), Rational::zero()];
        let Some(sigma) = displacement(&mask, &zero).expect("few places") else { return Ok(()) };
        // At the points of level 1 above those of level 0 the difference is a rule less a point.
        for (place, row) in Steps::none(&mask).next().rows() {
            let Some(under) = mask.dilation().divided(place) else { continue };
            let mut functional = row;
            *functional.entry(under).or_insert_with(Rational::zero) -= &Rational::one();
            functional.retain(|_, c| !c.is_zero());
            prop_assert!(edges.norm(&functional).expect("few places").value <= sigma);
        }
    }

    /// Each point of the window has one before it, and no point around it does.
    #[test]
    fn windows(mask in masks()) {
        let points = window(&mask).expect("a small window");
        let digits = mask.dilation().digits();
        let before = |place: Point| {
            mask.coefficients().keys().any(|at| digits.iter().any(|digit| {
                let image = mask.dilation().times(place);
                let from = std::array::from_fn(|i| image[i] - at[i] + digit[i]);
                points.contains(&from)
            }))
        };
        prop_assert!(points.iter().all(|place| before(*place)));
        let around = points.iter().flat_map(|p| [[p[0] + 1, p[1], 0], [p[0], p[1] - 1, 0]]);
        prop_assert!(around.into_iter().all(|place| points.contains(&place) || !before(place)));
    }
}

/// Products as masks on Z^2 have the numbers of their factors: the norms, the sum rules, the reproduction, and along one axis T_c.
#[test]
fn products_of_the_catalogue() {
    let haar = parse_scheme("[1, 1]").expect("a mask");
    let mut count = 0;
    for reference in catalogue().iter().flat_map(subcert::scheme::SchemeDefinition::references) {
        let Ok(scheme) = parse_scheme(&reference) else { continue };
        let Ok(mask) = Mask::try_from(scheme) else { continue };
        if mask.arity() > 3 || mask.arity() * mask.width() > 18 {
            continue;
        }
        let symbol = Symbol::of(&mask);
        let net = LatticeMask::product(&[&mask, &mask]).expect("a small mask");
        assert_eq!(sum_rules(&net) as usize, symbol.sum_rules().0, "{reference}");
        assert_eq!(reproduction(&net) as usize, reproduction_degree(&mask), "{reference}");
        let found = factors(&net).expect("it is a product");
        assert!(found.iter().all(|one| Symbol::of(one) == symbol), "{reference}");
        let line = LatticeMask::product(&[&mask, haar.masks()[0]]).expect("a small mask");
        let edges = Edges::new(line.edges(), 2);
        let mut constants = LatticeConstants::new(&line);
        for c in 1..=2 {
            constants.advance().expect("few classes");
            let along =
                constants.steps().differences().into_iter().filter(|(_, edge, _)| edge[0] == 1);
            let norms =
                along.map(|(_, _, difference)| edges.norm(&difference).expect("few places").value);
            let contraction =
                power_norm(&mask.difference(), c, Order::Adjoint).expect("few classes").value;
            assert_eq!(norms.max().expect("differences"), contraction, "T_{c} of {reference}");
            let norm = power_norm(mask.rules(), c, Order::Adjoint).expect("few classes").value;
            assert_eq!(constants.norm(), norm, "Λ_{c} of {reference}");
        }
        count += 1;
    }
    assert!(count > 20, "{count} schemes");
}

/// The attractor of the digits of nI is the cube, whose integer points are its corners.
#[test]
fn cubes() {
    let three = Dilation::scalar(3, 3).expect("a dilation");
    let points = attractor(&three, &three.digits().iter().copied().collect()).expect("few points");
    assert_eq!(points.len(), 8);
    assert!(points.iter().flatten().all(|x| *x == 0 || *x == 1));
}
