//! Bounds of smoothness on the pieces of a parameter: by sum rules and independent shifts, and by contraction.

use crate::masks::relation_of;
use subcert_check::Outcome;

/// The four-point scheme, corner cutting and others. The shifts of `tied` are dependent for w² = 2, where S is 1 and the limits are C^1.
const SCHEMES: &str = "
[[scheme]]
name = 'fp'
symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'
parameters.w = { about = 'tension' }
[[scheme]]
name = 'cut'
symbol = 'w + (1-w)*z + (1-w)*z^2 + w*z^3'
parameters.w = {}
[[scheme]]
name = 'leaning'
symbol = '(1 + z)^2/2*(w + (1 - w)*z)'
parameters.w = {}
[[scheme]]
name = 'tied'
symbol = '(1 + z)*((1 + z^2)^2/4 + (w^2 - 2)*z*(1 - z)^2)'
parameters.w = {}
[[scheme]]
name = 'thrice'
symbol = '(1 + z + z^2)^2/3*(w + (1 - 2*w)*z + w*z^2)'
parameters.w = {}
[[scheme]]
name = 'roots'
symbol = '(1 + z)/2*((1 - w)*(1 + z) + w*(1 + z^7))'
parameters.w = {}
[[scheme]]
name = 'hat'
symbol = '(1 + z)^2/(2*z)'
";

/// A claim: the entries of `for`, `only`, and what is stated.
type Claim = (&'static str, bool, &'static str);

const FOUR: &str = "limits fp:w=1/16\n order 4\n product 0\n eigenvalue positive 4\n at-most 4\n unit 1\n image\n image\n image\n image\n continuous 1\n not-continuous 2\n end\n ";
const HAT: &str = "limits hat\n order 2\n product 1\n eigenvalue positive 2\n at-most 2\n unit 1\n image\n image\n continuous 0\n not-continuous 1\n end\n ";
/// Bounds that are wider than necessary.
const LOOSE: &str = "limits fp:w=1/16\n order 4\n product 0\n eigenvalue positive 4\n at-most 9\n unit 1\n image\n image\n image\n image\n continuous 0\n end\n ";
const ROOT: &str = "root:-2,0,1:1:2";
const SMALL: &str = "'-1/4 < v < 1/4'";
const SMOOTH: &str = "'0 < v < 1/8'";

fn outcome((of, only, states): Claim, limits: &str, verdict: &str) -> Outcome {
    let only = if only { "only = true\n" } else { "" };
    let fields = format!("states = '{states}'\nfor = {of}\n{only}");
    relation_of(SCHEMES, &fields, &format!("{limits}states {states}\n {verdict}"))
}

/// The opposite of a comparison.
fn opposite(states: &str) -> Option<String> {
    let (at, sign) = [" <= ", " >= ", " < ", " > ", " != ", " = "]
        .into_iter()
        .find_map(|sign| Some((states.find(sign)?, sign)))?;
    let other = match sign {
        " < " => " >= ",
        " <= " => " > ",
        " > " => " <= ",
        " >= " => " < ",
        " = " => " != ",
        _ => " = ",
    };
    Some(format!("{}{other}{}", &states[..at], &states[at + sign.len()..]))
}

#[rustfmt::skip]
const HOLD: &[(Claim, &str)] = &[
    (("'real v'", false, "smoothness(fp, w = v) < 2"), FOUR),
    (("'real v'", false, "(smoothness(fp, w = v)) <= 1"), FOUR),
    (("'real v'", false, "2 > smoothness(fp, w = v)"), FOUR),
    (("'real v'", false, "2 != smoothness(fp, w = v)"), FOUR),
    (("'v < 1/16'", false, "smoothness(fp, w = v) < 2"), ""),
    (("'real v'", false, "smoothness(fp, w = v) < 4"), ""),
    (("'real v'", false, "smoothness(fp, w = v) >= -1"), ""),
    (("'real v'", false, "smoothness(fp, w = v) < 2 + v^2"), FOUR),
    ((SMALL, false, "hoelder(fp, w = v) <= 2"), FOUR),
    ((SMALL, false, "hoelder(fp, w = v) <= 2"), LOOSE),
    ((SMOOTH, false, "hoelder(fp, w = v) >= 1"), LOOSE),
    (("'-1/4 < v < 1/16'", false, "hoelder(fp, w = v) <= 2"), ""),
    (("'0 < v < 1/16'", false, "hoelder(fp, w = v) < 2 + v"), ""),
    ((SMOOTH, false, "smoothness(fp, w = v) >= 1"), ""),
    ((SMOOTH, false, "hoelder(fp, w = v) >= 1"), ""),
    ((SMOOTH, false, "smoothness(fp, w = v) = 1"), FOUR),
    (("'0 < v < 1/16'", false, "smoothness(fp, w = v) = 1"), ""),
    ((SMOOTH, false, "smoothness(fp, w = v) > v"), ""),
    ((SMALL, false, "smoothness(fp, w = v) > -1"), ""),
    ((SMALL, false, "0 <= smoothness(fp, w = v)"), ""),
    (("'0 < v < 1/16'", false, "smoothness(fp, w = v) <= smoothness(leaning, w = v)"), ""),
    ((SMOOTH, false, "smoothness(fp, w = v) > smoothness(hat)"), HAT),
    (("'0 < v < 1/2'", false, "smoothness(leaning, w = v) = 1"), ""),
    (("'0 < v < 1'", false, "smoothness(leaning, w = v) >= 1"), ""),
    (("'-1 < v < 1/4'", false, "smoothness(cut, w = v) < 1"), ""),
    (("'v > 1/2'", false, "smoothness(cut, w = v) < 1"), ""),
    (("'0 < v < 1/2'", false, "smoothness(cut, w = v) >= 0"), ""),
    (("'1.42 < v < 1.49'", false, "smoothness(tied, w = v) < 1"), ""),
    (("'sqrt(2) < v < 3/2'", false, "smoothness(tied, w = v) < 1"), ""),
    (("'3/2 < v < 2'", false, "smoothness(tied, w = v) != 1"), ""),
    (("'v < 1'", false, "smoothness(thrice, w = v) <= 2"), ""),
    (("'v > 1'", false, "smoothness(thrice, w = v) <= 1"), ""),
    (("'v < 1/3'", false, "smoothness(thrice, w = v) <= 1"), ""),
    (("'0 < v < 1/3'", false, "smoothness(thrice, w = v) >= 0"), ""),
];

#[test]
fn what_the_bounds_show() {
    let mut wrong = Vec::new();
    for (claim, limits) in HOLD {
        let found = outcome(*claim, limits, "holds reals");
        if found != Outcome::Valid {
            wrong.push(format!("{claim:?}: {found:?}"));
        }
        let opposite: &str = opposite(claim.2).expect("a sign").leak();
        for at in ["1/20", "0", "1/16", "3/8", "3", "1.45", "1.7", "-1/8", "1/4"] {
            let lines = format!("fails reals\n false {at}");
            assert_ne!(outcome(*claim, limits, &lines), Outcome::Valid, "{claim:?}: {lines}");
        }
        let contrary = outcome((claim.0, false, opposite), limits, "holds reals");
        assert_ne!(contrary, Outcome::Valid, "{claim:?}: {opposite}");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The contrary of what the bounds show is false, at any value.
#[test]
fn what_the_bounds_refute() {
    for (claim, limits, at) in [
        (("'real v'", false, "smoothness(fp, w = v) >= 2"), "", "1/20"),
        (("'real v'", false, "smoothness(fp, w = v) >= 2"), FOUR, "1/16"),
        (("'real v'", false, "smoothness(fp, w = v) >= 2"), "", ROOT),
        ((SMALL, false, "hoelder(fp, w = v) < 2"), FOUR, "1/16"),
        ((SMALL, false, "hoelder(fp, w = v) > 2"), FOUR, "1/16"),
        ((SMOOTH, false, "smoothness(fp, w = v) < 1"), "", "1/16"),
        ((SMOOTH, false, "smoothness(fp, w = v) <= 0"), "", "root:-1,0,200:0:1"),
        (("'0 <= v < 1/8'", false, "smoothness(fp, w = v) >= 1"), HAT, "0"),
        (("'0 < v < 1/2'", false, "smoothness(cut, w = v) < 1"), "", "1/4"),
        (("'0 < v < 1/2'", false, "smoothness(cut, w = v) >= 1"), "", "1/3"),
        (("'v > 0'", false, "smoothness(cut, w = v) >= 1"), "", ROOT),
        // There are two sum rules at this end.
        (("'1.42 < v <= 3/2'", false, "smoothness(tied, w = v) < 1"), "", "3/2"),
        (("'v > 1'", false, "smoothness(thrice, w = v) > 1"), "", ROOT),
    ] {
        let lines = format!("fails reals\n false {at}");
        let found = outcome(claim, limits, &lines);
        assert_eq!(found, Outcome::Valid, "{claim:?}: {lines}");
        assert_ne!(outcome(claim, limits, "holds reals"), Outcome::Valid, "{claim:?}");
        let opposite: &str = opposite(claim.2).expect("a sign").leak();
        let opposite = (claim.0, false, opposite);
        assert_ne!(outcome(opposite, limits, &lines), Outcome::Valid, "{opposite:?}: {lines}");
    }
}

/// What is left open where bounds do not decide, a call is no whole side, or no line `limits` is there.
#[test]
fn what_is_left_open() {
    for (claim, limits) in [
        // At 1/16 there are four sum rules.
        (("'real v'", false, "smoothness(fp, w = v) < 2"), ""),
        (("'real v'", false, "smoothness(fp, w = v) <= 1"), HAT),
        (("'real v'", false, "hoelder(fp, w = v) <= 2"), FOUR),
        (("'0 <= v < 1/8'", false, "smoothness(fp, w = v) >= 1"), FOUR),
        ((SMOOTH, false, "smoothness(fp, w = v) + 0 >= 1"), ""),
        ((SMOOTH, false, "-smoothness(fp, w = v) <= -1"), ""),
        ((SMOOTH, false, "smoothness(fp, w = v) in {1}"), ""),
        ((SMOOTH, false, "smoothness(fp, w = v) = 1"), ""),
        ((SMALL, false, "smoothness(fp, w = v) != 1/2"), ""),
        ((SMOOTH, false, "smoothness(hat) <= 1"), ""),
        ((SMOOTH, false, "smoothness(fp, w = v) > sobolev(fp, w = v) - 9"), ""),
        // The shifts are dependent at one number.
        (("'real v'", false, "smoothness(cut, w = v) < 3"), ""),
        (("'1/4 < v < 3/4'", false, "smoothness(cut, w = v) < 1"), ""),
        (("'v = 1/4'", true, "smoothness(cut, w = v) >= 1"), ""),
        (("'1.4 < v < 1.49'", false, "smoothness(tied, w = v) < 1"), ""),
        (("'1.4 < v < 1.49'", false, "hoelder(tied, w = v) <= 1"), ""),
        (("'1.4 < v <= sqrt(2)'", false, "smoothness(tied, w = v) < 1"), ""),
        // The shifts are dependent for 1, and there are three sum rules for 1/3.
        (("'real v'", false, "smoothness(thrice, w = v) <= 2"), ""),
        (("'v < 1'", false, "smoothness(thrice, w = v) <= 1"), ""),
    ] {
        for verdict in ["holds reals", "fails reals\n false 1/2", "fails reals\n false 1/16"] {
            let found = outcome(claim, limits, verdict);
            assert_ne!(found, Outcome::Valid, "{claim:?}: {verdict}");
        }
        let found = outcome(claim, limits, "holds reals");
        assert!(matches!(found, Outcome::Incomplete(_)), "{claim:?}: {found:?}");
    }
}

/// What is false at one number that is not rational.
#[test]
fn one_irrational_number() {
    let with = |states: &'static str, of: &'static str, only: bool, verdict: &str| {
        let only = if only { "only = true\n" } else { "" };
        let fields = format!("scheme = 'cut:w=v^2/8'\nstates = '{states}'\nfor = '{of}'\n{only}");
        relation_of(SCHEMES, &fields, &format!("states {states}\n {verdict}"))
    };
    let rough = "smoothness() < 1";
    assert_eq!(with(rough, "1 < v < sqrt(2)", false, "holds reals"), Outcome::Valid);
    assert_eq!(with(rough, "sqrt(2) < v < 2", false, "holds reals"), Outcome::Valid);
    assert_ne!(with(rough, "1 < v < 2", false, "holds reals"), Outcome::Valid);
    assert_ne!(with(rough, "1 < v <= sqrt(2)", false, "holds reals"), Outcome::Valid);
    let at = format!("fails reals\n false {ROOT}");
    assert_eq!(with(rough, "1 < v < 2", false, &at), Outcome::Valid);
    let beside = "fails reals\n false root:-3,0,1:1:2";
    assert_ne!(with(rough, "1 < v < 2", false, beside), Outcome::Valid);
    let smooth = "smoothness() >= 1";
    assert_eq!(with(smooth, "sqrt(2) <= v <= sqrt(2)", false, "holds reals"), Outcome::Valid);
    assert_ne!(with(smooth, "1 < v <= sqrt(2)", false, "holds reals"), Outcome::Valid);
    assert_eq!(with(smooth, "1 < v < 2", false, beside), Outcome::Valid);
}

/// Corner cutting is C^1 for w = 1/4 only. The weights are none for which the shifts are dependent.
#[test]
fn if_and_only_if() {
    for (scheme, of, states) in [
        ("cut:w=1/4-(v-1)^2", "v = 1", "smoothness() >= 1"),
        ("cut:w=1/4-(v-1)^2", "v = 1", "smoothness() > 0"),
        ("cut:w=1/4-(v-1)^2", "v != 1", "smoothness() < 1"),
        ("cut:w=1/4-(v-1)^2", "1 <= v <= 1", "smoothness() >= 1"),
        ("cut:w=1/4-(v^2-3)^2*(v^2-2)^2", "v = 1", "support() = 3"),
    ] {
        let fields =
            format!("scheme = '{scheme}'\nstates = '{states}'\nfor = '{of}'\nonly = true\n");
        let lines = |verdict: &str| format!("states {states}\n {verdict}");
        let found = |verdict: &str| relation_of(SCHEMES, &fields, &lines(verdict));
        let is = states.contains("smoothness");
        assert_eq!(found("holds reals") == Outcome::Valid, is, "{fields}");
        for at in ["0", "1", "2", "1/2", "-1", ROOT] {
            for word in ["false", "true"] {
                let verdict = format!("fails reals\n {word} {at}");
                assert!(!is || found(&verdict) != Outcome::Valid, "{fields}{verdict}");
            }
        }
    }
}

/// The numbers for which shifts are dependent, and no others.
#[test]
fn independence() {
    for (of, states) in [
        ("'v = 1/2, 1'", "not independent(cut, w = v)"),
        ("'v = 1'", "not independent(roots, w = v)"),
        ("'v = 1'", "not independent(thrice, w = v)"),
    ] {
        assert_eq!(outcome((of, true, states), "", "holds reals"), Outcome::Valid, "{states}");
        let other = outcome(("'v = 1/3, 1'", true, states), "", "holds reals");
        assert_ne!(other, Outcome::Valid, "{states}");
    }
    let found = outcome(("'v = 1/2'", true, "not independent(cut, w = v)"), "", "holds reals");
    assert_ne!(found, Outcome::Valid);
    // It diverges there, and is interpolating.
    let found = outcome(("'v = -1/2'", true, "not independent(fp, w = v)"), "", "holds reals");
    assert_eq!(found, Outcome::Valid);
    for at in ["1/2", "1"] {
        let lines = format!("fails reals\n false {at}");
        let claim = ("'v > 0'", false, "independent(cut, w = v)");
        assert_eq!(outcome(claim, "", &lines), Outcome::Valid);
    }
    let claim = ("'v > 0'", false, "independent(tied, w = v)");
    assert_eq!(outcome(claim, "", &format!("fails reals\n false {ROOT}")), Outcome::Valid);
    let claim = ("'sqrt(2) <= v <= sqrt(2)'", false, "not independent(tied, w = v)");
    assert_eq!(outcome(claim, "", "holds reals"), Outcome::Valid);
}
