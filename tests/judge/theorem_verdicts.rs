//! Verdicts of theorems: witnesses against a naive refinement, and bounds that are known
//! to be true or false.

use crate::common::claims::{HEAD, judged, paper, theorem, without_tables};
use crate::common::r;
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::audit::{
    Control, Correction, Outcome, Place, Refutation, TheoremFinding, TheoremVerdict,
};
use subcert::bound::{Constants, SoundBound};
use subcert::certificate::certificate;
use subcert::claim::{Quantity, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::scheme::{Mask, parse_local_rules, parse_scheme};
use subcert_check::check;

/// A control polygon that stays where its ends are, refined point by point.
struct Naive<'a> {
    mask: &'a Mask,
    first: i64,
    points: &'a [i64],
    known: BTreeMap<(u32, i64), Rational>,
}

impl Naive<'_> {
    fn point(&mut self, level: u32, i: i64) -> Rational {
        if level == 0 {
            let last = self.points.len() - 1;
            let at = usize::try_from(i - self.first).unwrap_or(0).min(last);
            return Rational::from(self.points[at]);
        }
        if let Some(known) = self.known.get(&(level, i)) {
            return known.clone();
        }
        let arity = i64::try_from(self.mask.arity()).unwrap();
        let row = self.mask.rules().rows()[usize::try_from(i.rem_euclid(arity)).unwrap()].clone();
        let start = i.div_euclid(arity) + self.mask.offset();
        let mut sum = Rational::zero();
        for (j, weight) in (start..).zip(&row) {
            sum += &(weight * &self.point(level - 1, j));
        }
        self.known.insert((level, i), sum.clone());
        sum
    }

    /// P^k(t).
    fn at(&mut self, level: u32, t: &Rational) -> Rational {
        let scale = Rational::from(self.mask.arity()).pow(i32::try_from(level).unwrap());
        let place = t * &scale;
        let floor = place.floor();
        let part = &place - &Rational::from(floor.clone());
        let i = floor.to_i64().unwrap();
        let (left, right) = (self.point(level, i), self.point(level, i + 1));
        (Rational::one() - &part) * left + part * right
    }
}

/// Checks the data of a refutation on a curve by refining it.
fn check_curve(finding: &TheoremFinding<'_>, refutation: &Refutation) {
    let name = refutation.case.split(", ").next().unwrap();
    // Parameters of a scheme are separated by commas without spaces.
    let scheme = parse_scheme(name).unwrap_or_else(|error| panic!("{name}: {error}"));
    let own = scheme.masks()[0];
    let mask = own.with_offset(finding.theorem.tried.offset.unwrap_or(own.offset()));
    let violation = &refutation.violation;
    let Control::Polygon(polygon) = &violation.attained.control else { return };
    assert!(polygon.points.windows(2).all(|pair| (pair[1] - pair[0]).abs() == 1));
    let (first, points, known) = (polygon.first, &polygon.points[..], BTreeMap::new());
    let mut naive = Naive { mask: &mask, first, points, known };
    let k = violation.level;
    let value = violation.attained.value.as_rational().unwrap();
    let bound = violation.bound.as_rational().unwrap();
    match &violation.attained.place {
        Place::Difference(i) => {
            let difference = naive.point(k, i + 1) - naive.point(k, *i);
            assert_eq!(difference.abs(), *value);
        }
        Place::Point(i) => {
            let scale = Rational::from(mask.arity()).pow(i32::try_from(k + 1).unwrap());
            let t = &Rational::from(*i) / &scale;
            let step = naive.point(k + 1, *i) - naive.at(k, &t);
            assert_eq!(step.abs(), *value);
        }
        Place::Parameter(t) => {
            // Some levels later the polygon is so near to the limit that the sound bound
            // leaves no doubt.
            let deep = k + 14;
            let sound = SoundBound::curve(&Constants::new(mask.clone()), 4).unwrap();
            let rest = sound.levels(deep).unwrap().pop().unwrap();
            let distance = (naive.at(deep, t) - naive.at(k, t)).abs();
            assert!((&distance - value).abs() <= rest, "{}: {distance} ± {rest}", finding.id);
            assert!(distance - rest > *bound, "{}: not beyond {bound}", finding.id);
        }
        place => panic!("{place:?} on a curve"),
    }
    assert!(value > bound);
}

/// The same on a Doo–Sabin face, the points of which tend to their mean.
fn check_face(finding: &TheoremFinding<'_>, refutation: &Refutation) {
    let violation = &refutation.violation;
    let Control::Points(heights) = &violation.attained.control else { return };
    let ring = parse_local_rules(refutation.case.split(", ").next().unwrap()).unwrap();
    for (a, b) in ring.edges() {
        assert!((heights[*a].1 - heights[*b].1).abs() <= 1);
    }
    let mut points: Vec<RealCyclotomic> =
        heights.iter().map(|(_, height)| Rational::from(*height).into()).collect();
    for _ in 0..violation.level {
        points = ring.refine(&points);
    }
    let at = |name: &str| (0..points.len()).find(|a| ring.name(*a) == name).unwrap();
    let value = match (violation.quantity, &violation.attained.place) {
        (Quantity::Difference, Place::Edge([a, b])) => &points[at(a)] - &points[at(b)],
        _ if finding.theorem.tried.interpolant.is_some() => return,
        (Quantity::Step, Place::Named(place)) => {
            &ring.refine(&points)[at(place)] - &points[at(place)]
        }
        (Quantity::Distance, Place::Named(place)) => {
            let sum = points.iter().fold(RealCyclotomic::from(0), |sum, point| &sum + point);
            &points[at(place)] - &(&sum / &RealCyclotomic::from(points.len()))
        }
        (_, place) => panic!("{}: {place:?}", finding.id),
    };
    let value = if value < RealCyclotomic::from(0) { -&value } else { value };
    assert_eq!(value, violation.attained.value, "{}", finding.id);
    assert!(value > violation.bound);
}

#[test]
fn witnesses_stand_a_naive_refinement() {
    let (mut curves, mut rings) = (0, 0);
    for key in ["mustafa2007-bajaj", "khan2019-newton", "khan2022-doo-sabin", "mustafa2020-nary"] {
        let paper = without_tables(key);
        for finding in &judged(&paper).theorems {
            let Some(refutation) = &finding.refutation else { continue };
            match &refutation.violation.attained.control {
                Control::Polygon(_) => {
                    check_curve(finding, refutation);
                    curves += 1;
                }
                Control::Points(_) => {
                    check_face(finding, refutation);
                    rings += 1;
                }
                Control::Net { .. } => {}
            }
        }
    }
    assert!(curves >= 4 && rings >= 6, "{curves} curves, {rings} rings");
}

/// Theorem 5 of Mustafa et al. 2020 by hand: of the polygon 0, 1, 0 the quinary 3-point
/// scheme makes a curve that is 15/16 away from it at 0; σT/(1 − T) is 3/5·(193/625)^0 over
/// 1 − 193/625, which is 125/144.
#[test]
fn the_exponent_of_mustafa_2020() {
    let paper = without_tables("mustafa2020-nary");
    let audit = judged(&paper);
    let finding = audit.theorems.iter().find(|finding| finding.theorem.id == "theorem-5").unwrap();
    let refutation = finding.refutation.as_ref().unwrap();
    assert_eq!(refutation.case, "quinary-three-point, c = 2");
    let Control::Polygon(polygon) = &refutation.violation.attained.control else { panic!() };
    assert_eq!((polygon.first, &polygon.points[..]), (0, &[0, 1, 0][..]));
    assert_eq!(refutation.violation.attained.value, r(15, 16).into());
    assert_eq!(refutation.violation.bound, r(125, 144).into());
    // No single correction saves it; the exponent and the steps of a block together do.
    assert!(finding.repairs.iter().all(|repair| repair.corrections.len() >= 2));
    let proved = |repair: &&subcert::audit::Repair| {
        repair.proved
            && repair.corrections.iter().all(|i| {
                matches!(finding.corrections[*i], Correction::Block | Correction::AllSteps)
            })
    };
    assert_eq!(finding.repairs.iter().filter(proved).count(), 1);
    // With c = 1 the theorem is true of every scheme tried.
    let single = finding.cases.iter().filter(|case| case.label.ends_with("c = 1"));
    assert!(single.clone().count() >= 4);
    assert!(single.into_iter().all(|case| case.outcome == Outcome::Proved));
}

/// Chaikin's curve is within 2^−k/2 of its polygons, and the cubic B-spline within 4^−k/3;
/// both are attained.
#[test]
fn known_bounds_and_bounds_a_little_smaller() {
    let cases = [
        ("chaikin", "distance", "beta/2*(1/2)^k", TheoremVerdict::Proved),
        ("chaikin", "distance", "beta*49/100*(1/2)^k", TheoremVerdict::Refuted),
        ("chaikin", "distance", "beta*beta/2*(1/2)^k/beta", TheoremVerdict::Proved),
        // False, but only from level 35 on.
        ("chaikin", "distance", "beta*(49/100)^k", TheoremVerdict::Open),
        ("chaikin", "difference", "beta*(1/2)^k", TheoremVerdict::Proved),
        // As sharp as can be, but differences only halve: 40 shows no more than that.
        ("b-spline:degree=3", "distance", "beta/3*(1/4)^k", TheoremVerdict::Open),
        ("b-spline:degree=3", "distance", "beta/3*(1/2)^k", TheoremVerdict::Proved),
        ("b-spline:degree=3", "distance", "3/10*beta*(1/2)^k", TheoremVerdict::Refuted),
        ("b-spline:degree=3", "step", "beta/4*(1/2)^k", TheoremVerdict::Proved),
        ("b-spline:degree=3", "step", "beta/5*(1/2)^k", TheoremVerdict::Refuted),
        // A power for every two levels.
        ("b-spline:degree=3", "distance", "beta/3*(1/4)^floor(k/2)", TheoremVerdict::Proved),
        ("b-spline:degree=3", "distance", "beta/15*(1/4)^floor(k/2)", TheoremVerdict::Refuted),
        ("b-spline:degree=3", "depth", "levels(1/4, epsilon*3)", TheoremVerdict::Open),
        ("b-spline:degree=3", "depth", "levels(1/4, epsilon*4)", TheoremVerdict::Refuted),
        // A negative number of levels presupposes something that does not hold.
        ("chaikin", "depth", "-7", TheoremVerdict::Open),
        ("chaikin", "depth", "1", TheoremVerdict::Refuted),
    ];
    for (scheme, bounds, by, verdict) in cases {
        let from = if bounds == "depth" { "" } else { "from = '0'\n" };
        let fields = format!("scheme = '{scheme}'\nbounds = '{bounds}'\nby = '{by}'\n{from}");
        let paper = paper(&theorem(&fields));
        let audit = judged(&paper);
        let finding = &audit.theorems[0];
        assert_eq!(finding.verdict, verdict, "{scheme}, {bounds} ≤ {by}: {:?}", finding.cases);
        if let Some(refutation) = &finding.refutation {
            check_curve(finding, refutation);
        }
    }
}

#[test]
fn proofs_by_hand_stand_on_claims_that_hold() {
    let equation =
        |right| format!("[[equation]]\nid = 'e'\nlocus = '(e)'\nleft = '1'\nright = '{right}'\n");
    let by_hand = theorem("says = 'x'\nproved_by = 'here'\nproof_uses = ['e']");
    let verdict =
        |right| judged(&paper(&format!("{}{by_hand}", equation(right)))).theorems[0].verdict;
    assert_eq!(verdict("1"), TheoremVerdict::Proved);
    assert_eq!(verdict("2"), TheoremVerdict::Open);
    let refuted = paper(&theorem("says = 'x'\nrefuted_by = 'here'"));
    assert_eq!(judged(&refuted).theorems[0].verdict, TheoremVerdict::Refuted);
    // A proof of the program goes before a text that refutes.
    let proved = "scheme = 'chaikin'\nbounds = 'distance'\nby = 'beta/2*(1/2)^k'\nfrom = '0'\nrefuted_by = 'here'";
    assert_eq!(judged(&paper(&theorem(proved))).theorems[0].verdict, TheoremVerdict::Proved);
    // Data go before a proof.
    let both = "scheme = 'chaikin'\nbounds = 'distance'\nby = 'beta/3*(1/2)^k'\nfrom = '0'\nproved_by = 'here'";
    assert_eq!(judged(&paper(&theorem(both))).theorems[0].verdict, TheoremVerdict::Refuted);
}

/// The limits of degree 2 are as near as 4^−k, where each point has its natural parameter, half a step before i/n^k.
#[test]
fn theorems_about_natural_parameters_are_judged_there() {
    let found = |by: &str, more: &str| {
        let of =
            format!("scheme = 'chaikin'\nbounds = 'distance'\nby = '{by}'\nfrom = '0'\n{more}");
        let paper = paper(&theorem(&of));
        let audit = judged(&paper);
        let report = check(&paper.source.text, &[&certificate(&audit).text]).expect("a claim file");
        (audit.theorems[0].verdict, matches!(report.claims[0].2, subcert_check::Outcome::Valid))
    };
    let natural = "parameters = 'natural'";
    assert_eq!(found("beta*4^(-k)", ""), (TheoremVerdict::Refuted, true));
    assert_eq!(found("beta*4^(-k)", "parameters = 'indexed'"), (TheoremVerdict::Refuted, true));
    assert_eq!(found("beta*4^(-k)", natural), (TheoremVerdict::Open, false));
    assert_eq!(found("beta*4^(-k)/5", natural), (TheoremVerdict::Refuted, true));
    let wrong = |more: &str| {
        let of = format!("bounds = 'distance'\nby = 'beta'\nfrom = '0'\n{more}");
        let text = format!("{HEAD}{}", theorem(&of));
        read_paper(&SourceText::new("t.toml", text)).unwrap_err().message
    };
    assert!(wrong("parameters = 'greville'").contains("names no parameters"));
    assert!(wrong("parameters = 'natural'\noffset = '0'").contains("where points are"));
}

/// The scheme of THEOREMS 47: 0, …, 0, 1, 1, … has a difference of 2^k at level k.
#[test]
fn rules_that_sum_to_1_need_not_converge() {
    let rule = vec![Rational::from(2), Rational::from(-1)];
    let mask = Mask::new(vec![rule.clone(), rule], 0).unwrap();
    let mut naive = Naive { mask: &mask, first: -1, points: &[0, 1], known: BTreeMap::new() };
    for k in 0..6 {
        let difference = naive.point(k, 0) - naive.point(k, -1);
        assert_eq!(difference, Rational::from(1 << k));
    }
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// σβT^k/(1 − T) and what it rests on are true of every scheme with T = T_1 < 1, at
    /// every offset.
    #[test]
    fn true_bounds_are_never_refuted(u in -8_i64..=16, v in -8_i64..=16, offset in -2_i64..=1) {
        let scheme = format!(
            "[[scheme]]\nname = 'two'\nmask = [['1 - {u}/16', '{u}/16'], ['{v}/16', '1 - {v}/16']]\n"
        );
        let sigma = format!("displacement(offset = {offset})");
        let bounds = [
            ("distance", format!("{sigma}*beta*contraction(1)^k/(1 - contraction(1))")),
            ("step", format!("{sigma}*beta*contraction(1)^k")),
            ("difference", "beta*contraction(1)^k".to_owned()),
        ];
        for (bounds, by) in bounds {
            let fields = format!(
                "scheme = 'two'\nbounds = '{bounds}'\nby = '{by}'\nfrom = '0'\noffset = '{offset}'\n\
                 supposes = {{ value = 'contraction(1)', below = '1' }}"
            );
            let paper = paper(&format!("{scheme}{}", theorem(&fields)));
            let audit = judged(&paper);
            let outcome = &audit.theorems[0].cases[0].outcome;
            let fits = matches!(outcome, Outcome::Proved | Outcome::Outside(_));
            prop_assert!(fits, "{bounds}, u = {u}/16, v = {v}/16: {outcome:?}");
        }
    }
}
