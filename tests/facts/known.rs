//! Facts that stand in the literature or follow by hand.

use crate::common::{mask, r};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::facts::{
    CurveFacts, FamilyFacts, PointPlacement, SchemeFacts, VALENCES, atlas_references, centre,
    is_interpolating, kind, parameter_facts, points,
};
use subcert::limit::natural_shift;
use subcert::scheme::{Mask, Scheme, parse_any_scheme, parse_scheme};
use subcert::smoothness::Symbol;

#[test]
fn kinds_of_schemes() {
    let found = |name: &str| {
        let facts = CurveFacts::of_rational(&mask(name));
        (facts.kind, facts.interpolating, facts.points, facts.centre)
    };
    let (primal, dual) = (Some(PointPlacement::Primal), Some(PointPlacement::Dual));
    assert_eq!(found("four-point:w=1/16"), (primal, true, 4, Some(r(0, 1))));
    assert_eq!(found("chaikin"), (dual, false, 2, Some(r(-1, 2))));
    assert_eq!(found("b-spline:degree=3"), (primal, false, 3, Some(r(0, 1))));
    assert_eq!(found("ternary-four-point:mu=1/11"), (primal, true, 4, Some(r(0, 1))));
    assert_eq!(found("ternary-four-point-approximating"), (dual, false, 4, Some(r(-1, 4))));
    assert_eq!(found("colella-heil:a=1/2,b=1/4"), (None, false, 2, None));
}

/// Values of the cubic B-spline, the limit of one of its points, and of Chaikin's, which moves.
#[test]
fn limits() {
    let cubic = CurveFacts::of_rational(&mask("b-spline:degree=3")).limit.expect("a limit");
    assert_eq!(cubic.values(), [(-1, r(1, 6)), (0, r(2, 3)), (1, r(1, 6))]);
    assert!(cubic.at_shift.is_none());
    let chaikin = CurveFacts::of_rational(&mask("chaikin")).limit.expect("a limit");
    assert_eq!(chaikin.values(), [(-1, r(1, 2)), (0, r(1, 2))]);
    let (shift, stencil) = chaikin.at_shift.expect("a shift");
    let weights: Vec<(i64, Rational)> = stencil.terms().map(|(i, c)| (i, c.clone())).collect();
    assert_eq!((shift, weights), (r(-1, 2), vec![(-1, r(1, 8)), (0, r(3, 4)), (1, r(1, 8))]));
}

/// B-splines of degree d generate degree d and reproduce lines; Deslauriers and Dubuc's reproduce all that they
/// generate, and the dual four-point scheme cubics of the quartics that it generates.
#[test]
fn generated_and_reproduced() {
    for (name, generated, reproduced) in [
        ("chaikin", 2, 1),
        ("b-spline:degree=5", 5, 1),
        ("dubuc-deslauriers:m=3", 5, 5),
        ("dual-four-point:w=1/128", 4, 3),
        ("corner-cutting:w=1/5", 0, 0),
    ] {
        let facts = CurveFacts::of_rational(&mask(name));
        assert_eq!((facts.sum_rules - 1, facts.reproduction), (generated, reproduced), "{name}");
    }
}

/// Chaikin's points are 1/8 of a second difference from the limit, which falls by 4: 4^{-k}/4 for differences up to 1. At
/// i/2^k they are half a difference off, 2^{-k}/2. The cubic spline's are 1/6 of a second difference, 4^{-k}/3, from it.
#[test]
fn depths_of_splines() {
    let least = |base: i64, start: Rational| {
        let far = |k: &u32| &start * &Rational::from(base).pow(-i32::try_from(*k).expect("small"));
        (0..9).find(|k| far(k) <= r(1, 100)).expect("a level")
    };
    for (name, indexed, natural) in [
        ("chaikin", least(2, r(1, 2)), least(4, r(1, 4))),
        ("b-spline:degree=3", least(4, r(1, 3)), least(4, r(1, 3))),
    ] {
        let depths = CurveFacts::of_rational(&mask(name)).depths;
        let found = [depths.indexed, depths.natural].map(|depth| depth.expect("a depth").upper);
        assert_eq!(found, [indexed, natural], "{name}");
    }
}

/// A new point against the linear interpolant: w of one difference less w of another, and a quarter of one.
#[test]
fn displacements() {
    let found = |name: &str| CurveFacts::of_rational(&mask(name)).displacement;
    assert_eq!(found("four-point:w=1/16"), r(1, 8));
    assert_eq!(found("chaikin"), r(1, 4));
}

/// Deslauriers and Dubuc's schemes reproduce as they generate; divergence and irrational numbers leave facts open.
#[test]
fn open_facts() {
    let exact = CurveFacts::of_rational(&mask("dubuc-deslauriers:m=2"));
    assert_eq!(exact.open(), []);
    let diverges = CurveFacts::of_rational(&mask("four-point:w=1"));
    assert_eq!(diverges.smoothness.as_ref().expect("decided").continuity_fails, Some(0));
    let open: Vec<&str> = diverges.open().iter().map(|(fact, _)| *fact).collect();
    assert_eq!(open, ["depth, indexed", "depth, natural", "limit values"]);
    let Ok(SchemeFacts::Algebraic(irrational)) = SchemeFacts::of("daubechies-4") else {
        panic!("of another kind");
    };
    // Daubechies: 2 − log_2(1 + √3) = 0.5500…
    let hoelder = irrational.smoothness.as_ref().expect("decided").hoelder.clone();
    let exponent = hoelder.expect("it converges").formula.expect("exact");
    assert!(exponent.to_string().starts_with("2 - log_2("), "{exponent}");
    assert_eq!((irrational.sum_rules, irrational.columns.contraction.len()), (2, 8));
}

/// The four-point scheme of Dyn, Gregory and Levin is C^0 for |w| < 1/4 at least, C^1 about 0 < w ≤ 1/8, and never C^2.
#[test]
fn ranges() {
    let (ranges, reason) = parameter_facts("four-point", "w").expect("ranges");
    assert_eq!(ranges.len(), 2, "{reason}");
    assert!(ranges[0].inside.contains(&r(1, 5)) && ranges[1].inside.contains(&r(1, 10)));
    assert!(ranges[0].outside.contains(&r(3, 4)) && ranges[1].outside.contains(&r(-1, 100)));
    assert!(parameter_facts("four-point", "v").is_err());
}

/// Families of weights at a vertex: Loop's own weight is inside at each valence, and at 6 the ends are known, where
/// 5/8 − 6β is −1/2 and 1/2.
#[test]
fn families_of_weights() {
    let family = FamilyFacts::of("loop-weight:beta=1/16").expect("a family");
    assert_eq!(family.parameter, "beta");
    let valences: Vec<usize> = family.ranges.iter().filter_map(|one| one.valence).collect();
    assert_eq!(valences, VALENCES.collect::<Vec<usize>>());
    for one in &family.ranges {
        let n = one.valence.expect("a valence");
        // Loop's weights, rounded: 3/16 at 3, 31/256 at 4, and 3/(8n) of Warren from 6 on.
        let beta = match n {
            3 => r(3, 16),
            4 => r(31, 256),
            5 => r(21, 250),
            n => Rational::new(3, 8 * i64::try_from(n).expect("small")),
        };
        assert!(one.m == 1 && one.inside.contains(&beta), "n = {n}");
        assert!(!one.outside.contains(&beta), "n = {n}");
    }
    let [six] = &FamilyFacts::of("loop-weight:N=6,beta=1/16").expect("a family").ranges[..] else {
        panic!("one valence");
    };
    assert_eq!(six.inside.describe("b"), "1/48 < b < 3/16");
    // Two weights, none, and rules whose regular part is not known.
    for name in ["ball-storry:N=5,beta=3/10,gamma=1/20", "loop", "sqrt3-weight:N=6,alpha=1/3"] {
        assert!(FamilyFacts::of(name).is_none(), "{name}");
    }
}

#[test]
fn surfaces_at_all_valences() {
    let Ok(SchemeFacts::Surface(found)) = SchemeFacts::of("doo-sabin") else {
        panic!("of another kind");
    };
    let valences: Vec<usize> = found.iter().map(|(valence, _)| *valence).collect();
    assert_eq!(valences, VALENCES.collect::<Vec<usize>>());
    for (_, vertex) in found {
        let vertex = vertex.expect("eigenvalues");
        let half = vertex.spectrum.conditions.subdominant.expect("λ");
        assert_eq!(half.to_string(), "1/2");
    }
}

#[test]
fn the_atlas_has_every_entry_and_reads_each() {
    let entries = atlas_references();
    assert!(entries.len() >= 60, "{}", entries.len());
    for (entry, references) in entries {
        assert!(!references.is_empty(), "{}", entry.name);
    }
    assert!(matches!(SchemeFacts::of("chaikin x chaikin"), Ok(SchemeFacts::Lattice(_))));
    assert!(SchemeFacts::of("no-such-scheme").is_err());
}

/// Where a symmetric mask of the catalogue keeps lines, its centre is the natural shift.
#[test]
fn centres() {
    let references = atlas_references().into_iter().flat_map(|(_, references)| references);
    let masks = references.filter_map(|name| match parse_scheme(&name) {
        Ok(Scheme::Curve(mask)) => Some((name, mask)),
        _ => None,
    });
    let mut compared = 0;
    for (name, mask) in masks {
        let shift = natural_shift(&mask);
        if let (Some(centre), true) = (centre(&Symbol::of(&mask)), shift.keeps_lines) {
            assert_eq!(centre, shift.shift, "{name}");
            compared += 1;
        }
    }
    assert!(compared > 50, "{compared}");
}

proptest! {
    /// A shift of all indices changes neither the kind nor the points.
    #[test]
    fn shifts(mask in crate::common::affine(4, 5), by in -3_i64..4) {
        let found = |mask: &Mask| {
            let kind = centre(&Symbol::of(mask)).and_then(|place| kind(mask.arity(), &place));
            (kind, points(mask), is_interpolating(mask))
        };
        let rows = mask.rules().rows();
        let reversed = rows.iter().rev().map(|row| row.iter().rev().cloned().collect());
        let folded = rows.iter().zip(reversed).map(|(row, other): (_, Vec<Rational>)| {
            row.iter().zip(&other).map(|(a, b)| (a + b) * r(1, 2)).collect()
        });
        // The mean of a mask and its mirror image is symmetric.
        let symmetric = Mask::new(folded.collect(), mask.offset()).expect("affine");
        prop_assert!(found(&symmetric).0.is_some());
        prop_assert_eq!(found(&symmetric), found(&symmetric.with_offset(mask.offset() + by)));
    }
}

/// Typed masks and files have facts as entries do.
#[test]
fn typed_masks() {
    let of = |name: &str| match parse_any_scheme(name).map(|_| SchemeFacts::of(name)) {
        Ok(Ok(SchemeFacts::Rational(facts))) => (facts.sum_rules, facts.columns),
        _ => panic!("{name}"),
    };
    assert_eq!(of("[1, 3, 3, 1]/4"), of("chaikin"));
}
