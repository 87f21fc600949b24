//! Relations for all real values of an index, or for those between two ends: the pieces of their line.

use crate::masks::relation_of;
use subcert_check::Outcome;

/// The four-point scheme with a tension, and masks whose ends are 0 for an irrational number.
const SCHEMES: &str = "
[define]
between = 'sum(i = 1..2, abs(v - i))'
[given]
given = '5'
[[scheme]]
name = 'fp'
symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'
parameters.w = { about = 'tension' }
[[scheme]]
name = 'hat'
symbol = '(1 + z)^2/(2*z)'
[[scheme]]
name = 'box'
symbol = '1 + z'
[[scheme]]
name = 'bent'
symbol = '(1 + z)^2/2 + (w^2 - 2)*(z^5 - z)'
parameters.w = {}
[[scheme]]
name = 'daubechies'
symbol = '(1 + z)^2/2*((1 + w) + (1 - w)*z)/2'
parameters.w = {}
[[scheme]]
name = 'raised'
symbol = '(w/z + 1 + (1 - w)*z)*(1 + z)/2'
parameters.w = {}
[[scheme]]
name = 'leaning'
symbol = '(1 + z)^2/2*(w + (1 - w)*z)'
parameters.w = {}
";

/// A claim: the scheme, the entries of `for`, `only`, what is stated, and the lines that say what is so.
type Claim = (&'static str, &'static str, bool, &'static str, &'static str);

const FP: &str = "fp:w=v";
const LEBESGUE: &str = "lebesgue-singular:a=v";
const SMALL: &str = "'-1/4 < v < 1/4'";
const BETWEEN: &str = "'0 < v < 1'";
const ROOT: &str = "root:-2,0,1:1:2";
const FALSE_AT_ROOT: &str = "fails reals\n false root:-2,0,1:1:2";

#[rustfmt::skip]
const CLAIMS: &[Claim] = &[
    (FP, "'real v'", false, "sum_rules() >= 2", "holds reals"),
    (FP, "'real v'", false, "sum_rules() in {2, 4}", "holds reals"),
    (FP, "'real v'", false, "generation() = 1", "fails reals\n false 1/16"),
    (FP, "'v = 1/16'", true, "sum_rules() = 4", "holds reals"),
    (FP, "'v = 1/16'", true, "reproduction() = 3", "holds reals"),
    (FP, "'v = 0.0625, 1/16'", true, "approximation_order() > 2", "holds reals"),
    (FP, "'v = 1/16, 1'", true, "reproduction() = 3", "fails reals\n false 1"),
    (FP, "'v = 1'", true, "reproduction() = 3", "fails reals\n true 1/16"),
    (FP, "'v > 0'", true, "reproduction() = 1", "fails reals\n true -1"),
    (FP, "'real v'", false, "reproduction() = 3", "fails reals\n false 0"),
    (FP, "'v != 1/16'", true, "reproduction() = 1", "holds reals"),
    (FP, "'real v'", false, "interpolating()", "holds reals"),
    (FP, "'real v'", false, "not interpolating()", "fails reals\n false 1/3"),
    (FP, "'real v'", false, "symmetric()", "holds reals"),
    (FP, "'real v'", false, "support() = 6", "fails reals\n false 0"),
    (FP, "'v ≠ 0'", true, "support() = 6", "holds reals"),
    (FP, "'v = 0'", true, "support_end() = 1", "holds reals"),
    (FP, "'real v'", false, "support_start() in {-1, -3}", "holds reals"),
    (FP, "'-1/4 < v < 1/4'", true, "contraction(1) < 1", "holds reals"),
    (FP, "'-1/4 <= v < 1/4'", false, "contraction(1) < 1", "fails reals\n false -1/4"),
    (FP, "'1/4 > v > -0.2'", true, "contraction(1) < 1", "fails reals\n true -1/5"),
    (FP, "'real v'", false, "contraction(1) = 1/2 + 2*abs(v)", "holds reals"),
    (FP, "'real v'", false, "norm() >= 1", "holds reals"),
    (FP, "'real v'", false, "moment(1) = 0", "holds reals"),
    (FP, "'v = 1/16'", true, "moment(2) = 0", "holds reals"),
    (FP, "'v < 1/16'", true, "moment(2) > 0", "holds reals"),
    (FP, "'v = 0'", true, "same(with = hat)", "holds reals"),
    (FP, "'real v'", false, "not orthogonal()", "holds reals"),
    (FP, "'real v'", false, "symbol_at(-1) = 0", "holds reals"),
    (FP, "'real v'", false, "coefficient(3) + v = 0", "holds reals"),
    ("", "'real v'", false, "sum_rules(fp, w = v) ≥ 2", "holds reals"),
    ("", "'real v'", false, "v*(1-v) <= 1/4", "holds reals"),
    ("", "'real v'", false, "v*(1-v) < 1/4", "fails reals\n false 1/2"),
    ("", "'v ≠ 1/2'", true, "v*(1-v) < 1/4", "holds reals"),
    ("", "'real v'", false, "v^2 != 2", FALSE_AT_ROOT),
    ("", "'v > 0'", false, "v^2 != 2", FALSE_AT_ROOT),
    ("", "'v != sqrt(2)'", false, "v^2 != 2", "fails reals\n false root:-2,0,1:-2:-1"),
    ("", "'v < sqrt(2)'", false, "v^2 < 2", "fails reals\n false root:-2,0,1:-2:-1"),
    ("", "'v > sqrt(2)'", false, "v^2 > 2", "holds reals"),
    ("", "'v ≥ 2*cos(pi/5)'", false, "v^2 ≥ v + 1", "holds reals"),
    ("", "'-sqrt(2)/8 < v < sqrt(2)/8'", true, "32*v^2 < 1", "holds reals"),
    ("", "'-sqrt(2)/8 < v ≤ sqrt(2)/8'", true, "32*v^2 < 1", "fails reals\n false root:-1,0,32:0:1"),
    ("", "'-sqrt(2)/8 < v < 1/8'", true, "32*v^2 < 1", "fails reals\n true 1/7"),
    ("", "'0 <= v <= 0'", true, "v^2 = 0", "holds reals"),
    ("", "'0 <= v < 1/4'", true, "v in [0, 1/4)", "holds reals"),
    ("", "'1/4 > v >= 0'", true, "v in [0, 1/4]", "fails reals\n true 0.25"),
    ("", "'real v'", false, "abs(v) = max(v, -v)", "holds reals"),
    ("", "'v > 0'", true, "abs(v) = v", "fails reals\n true 0"),
    ("", "['n = 1..3', 'real v']", false, "(n - v)^2 >= 0", "holds reals"),
    ("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", "fails reals\n false 2 2"),
    ("", "['real v', 'n = 1, 2']", false, "-1 <= v^2 < n", "fails reals\n false 5 2 2"),
    ("", "['real v', '(n, m) = (1, 2), (3, 4)']", false, "v + n < v + m", "holds reals"),
    ("bent:w=v", "'real v'", false, "width() = 3", FALSE_AT_ROOT),
    ("bent:w=v", "'real v'", false, "support() = 5", FALSE_AT_ROOT),
    ("bent:w=v", "'v > 0'", false, "sum_rules() = 1", FALSE_AT_ROOT),
    ("bent:w=v", "'real v'", false, "mask(0, 0) = 0", FALSE_AT_ROOT),
    ("bent:w=v", "'real v'", false, "mask(0, 0) in {0, 1/2}", "holds reals"),
    ("fp:w=abs(v)", "'v = 1/16, -1/16'", true, "sum_rules() = 4", "holds reals"),
    ("fp:w=v^2/32", "'v > 0'", false, "sum_rules() = 2", FALSE_AT_ROOT),
    ("fp:w=v^2/32", "'v > 0'", false, "moment(2) != 0", FALSE_AT_ROOT),
    ("fp:w=v^2/32", "'v > 0'", false, "reproduction() = 1", FALSE_AT_ROOT),
    ("", "'real v'", false, "between >= 1", "holds reals"),
    ("", "'1 <= v <= 2'", true, "between = 1", "holds reals"),
    ("", "'1 <= v < 2'", true, "between = 1", "fails reals\n true 2"),
    ("", "'real given'", false, "given = 5", "fails reals\n false 4"),
    ("daubechies:w=v", "'real v'", false, "not orthogonal()", "fails reals\n false root:-3,0,1:1:2"),
    ("daubechies:w=v", "'v > 0'", false, "orthogonal()", "fails reals\n false 2"),
    ("", SMALL, false, "limit_value(fp, 1/2, w = v) = 1/2 + v", "holds reals"),
    ("", SMALL, false, "limit_value(fp, 1/2, w = v) = 1/2 - v", "fails reals\n false 1/8"),
    (FP, SMALL, false, "limit_value(1/4) = 3/4 + 3*v/2", "holds reals"),
    (FP, SMALL, false, "limit_value(1/4) >= 3/4", "fails reals\n false -1/8"),
    (FP, "'0 <= v < 1/4'", false, "limit_value(1/4) >= 3/4", "holds reals"),
    (FP, SMALL, false, "limit_value(3) = 0", "holds reals"),
    (FP, "'-1/8 < v < 1/8'", false, "limit_value(1/2)^2 != 2/3", "holds reals"),
    (FP, "'-1/8 < v < 1/8'", false, "8*limit_value(1/2)^2 != 3", "fails reals\n false root:-1,8,8:0:1/8"),
    ("", "'-1/8 < v < 1/8'", false, "integral(fp, -3, 3, w = v) = 1", "holds reals"),
    ("", "'-1/8 < v < 1/8'", false, "integral(fp, -3, 3, w = v) > 1", "fails reals\n false 1/16"),
    ("", "'1/100 < v < 1/8'", false, "not positive(fp, w = v)", "holds reals"),
    ("", "'1/100 < v < 1/8'", false, "positive(fp, w = v)", "fails reals\n false 1/16"),
    (FP, "'0 <= v < 1/8'", false, "not positive()", "fails reals\n false 0"),
    (FP, "'0 < v < 1/8'", false, "not monotone()", "holds reals"),
    (FP, "'-1/8 < v < 1/8'", false, "convex() <= (1 - v^2)^2", "holds reals"),
    (FP, "'-1/8 < v < 1/8'", false, "not convex()", "fails reals\n false 0"),
    ("", "'0 < v < 1/2'", false, "positive(corner-cutting, w = v)", "holds reals"),
    ("", "'0 < v < 1/2'", false, "not positive(corner-cutting, w = v)", "fails reals\n false 1/4"),
    ("corner-cutting:w=v", "'0 < v < 1/2'", false, "limit_value(0) = 1/2", "holds reals"),
    ("corner-cutting:w=v", "'0 < v < 1/2'", false, "limit_value(0) = 2*v", "fails reals\n false 1/3"),
    ("corner-cutting:w=v", "'1/4 < v < 1/2'", false, "not convex()", "holds reals"),
    (LEBESGUE, BETWEEN, false, "limit_value(-1/2) = v", "holds reals"),
    (LEBESGUE, BETWEEN, false, "limit_value(-1/2) = 1/2", "fails reals\n false 1/3"),
    (LEBESGUE, BETWEEN, false, "limit_value(-3/4) = v^2", "holds reals"),
    (LEBESGUE, BETWEEN, false, "limit_value(-1/4) = v + (1 - v)*v", "holds reals"),
    (LEBESGUE, BETWEEN, false, "2*limit_value(-3/4) != 1", "fails reals\n false root:-1,0,2:0:1"),
    (LEBESGUE, BETWEEN, false, "(2*limit_value(-3/4) - 1)^2 >= 0", "holds reals"),
    (LEBESGUE, BETWEEN, false, "integral(-1, 0) = v", "holds reals"),
    (LEBESGUE, BETWEEN, false, "integral(-1, 0) = 1 - v", "fails reals\n false 1/3"),
    (LEBESGUE, BETWEEN, false, "integral(-7, -1/2) = v^2/2", "holds reals"),
    (LEBESGUE, BETWEEN, false, "2*integral(-1, 0)^2 != 1", "fails reals\n false root:-1,0,2:0:1"),
    (LEBESGUE, BETWEEN, false, "(2*integral(-1, 0)^2 - 1)^2 >= 0", "holds reals"),
    (LEBESGUE, BETWEEN, false, "monotone()", "holds reals"),
    (LEBESGUE, BETWEEN, false, "not monotone()", "fails reals\n false 1/3"),
    (LEBESGUE, BETWEEN, false, "not convex()", "fails reals\n false 1/2"),
    (LEBESGUE, "'0 < v < 1/2'", false, "not convex()", "holds reals"),
    ("raised:w=v", BETWEEN, false, "limit_value(1/2, derivative = 1) = 1 - 2*v", "holds reals"),
    ("raised:w=v", BETWEEN, false, "limit_value(1/2, derivative = 1) > 0", "fails reals\n false 1/2"),
    ("raised:w=v", BETWEEN, false, "limit_value(0) = v", "holds reals"),
    ("leaning:w=v", BETWEEN, false, "convex()", "holds reals"),
    ("leaning:w=v", BETWEEN, false, "not convex()", "fails reals\n false 1/2"),
    ("leaning:w=v", "'-1/4 < v < 0'", false, "not convex()", "holds reals"),
    ("leaning:w=v", "'-1/4 < v < 0'", false, "convex()", "fails reals\n false -1/8"),
    ("leaning:w=v", "'-1/2 < v < 3/2'", false, "limit_value(1) = v", "holds reals"),
    ("leaning:w=v", "'-1/2 < v < 3/2'", false, "limit_value(1) = 1 - v", "fails reals\n false 0"),
    (LEBESGUE, BETWEEN, false, "inner_product(-1, with = box) = v", "holds reals"),
    (LEBESGUE, BETWEEN, false, "inner_product(-1, with = box) = 1/2", "fails reals\n false 1/3"),
];

fn fields((scheme, of, only, states, _): &Claim) -> String {
    let scheme = if scheme.is_empty() { String::new() } else { format!("scheme = '{scheme}'\n") };
    let only = if *only { "only = true\n" } else { "" };
    format!("{scheme}states = '{states}'\nfor = {of}\n{only}")
}

fn outcome(claim: &Claim, lines: &str) -> Outcome {
    relation_of(SCHEMES, &fields(claim), &format!("states {}\n {lines}", claim.3))
}

fn valid(claim: &Claim, lines: &str) -> bool {
    outcome(claim, lines) == Outcome::Valid
}

#[test]
fn what_is_true_is_accepted() {
    let wrong: Vec<String> = CLAIMS
        .iter()
        .map(|claim| (claim, outcome(claim, claim.4)))
        .filter(|(_, found)| *found != Outcome::Valid)
        .map(|(claim, found)| format!("{claim:?}: {found:?}"))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The opposite verdict, with any of the witnesses; other lines; and lines twice.
#[test]
fn forged_certificates_are_refused() {
    for claim in CLAIMS {
        let lines = claim.4;
        let holds = lines == "holds reals";
        let mut forged = vec![
            format!("{lines}\n {lines}"),
            format!("{lines}\n false 0"),
            format!("{lines} 1"),
            lines.replace(" reals", ""),
            lines.replace("reals", "all"),
            lines.replace("reals", "1"),
            "tried 24".into(),
            "fails reals".into(),
            "fails 1\n case 0 = 1".into(),
            String::new(),
        ];
        if !holds {
            forged.push("holds reals".into());
            let (_, witness) = lines.split_once('\n').expect("a witness");
            forged.extend([
                format!("{lines}\n{witness}"),
                format!("fails reals 1\n{witness}"),
                format!("holds reals\n{witness}"),
                witness.trim().into(),
                if witness.contains("true") {
                    lines.replace("true", "false")
                } else {
                    lines.replace("false", "true")
                },
            ]);
        }
        for at in ["0", "1/16", "1", "-1", "1/3", "1/2", "2", ROOT, "root:-3,0,1:1:2"] {
            if holds {
                for word in ["false", "true"] {
                    forged.extend(
                        ["", " 1", " 2"].map(|more| format!("fails reals\n {word} {at}{more}")),
                    );
                }
            }
        }
        for lines in forged {
            assert!(!valid(claim, &lines), "{claim:?}: {lines}");
        }
    }
}

/// Witnesses that are none.
#[test]
fn wrong_witnesses() {
    for (claim, lines) in [
        ((FP, "'real v'", false, "reproduction() = 3", ""), "false 1/16"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "true 1/16"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "false"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "false 0 1"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "false v"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "false sqrt(2)"),
        ((FP, "'real v'", false, "reproduction() = 3", ""), "case 0 = 1"),
        ((FP, "'v = 1/16'", true, "reproduction() = 3", ""), "false 0"),
        ((FP, "'v = 1/16'", true, "reproduction() = 3", ""), "true 1/16"),
        ((FP, "'v = 1'", true, "reproduction() = 3", ""), "true 1/17"),
        ((FP, "'real v'", false, "support() = 6", ""), "false 1/16"),
        ((FP, "'v > 0'", false, "support() = 6", ""), "false 0"),
        ((FP, "'-1/4 < v < 1/4'", false, "contraction(1) < 1", ""), "false 1/4"),
        ((FP, "'-1/4 < v < 1/4'", true, "contraction(1) < 1", ""), "true 1/4"),
        ((FP, "'-1/4 < v < 1/4'", false, "contraction(1) < 1", ""), "true 1/5"),
        (("", "'real v'", false, "v^2 != 2", ""), "false 1.4142135623730951"),
        (("", "'real v'", false, "v^2 != 2", ""), "false root:-2,0,1:-2:2"),
        (("", "'real v'", false, "v^2 != 2", ""), "false root:-3,0,1:1:2"),
        (("", "'v < 0'", false, "v^2 != 2", ""), "false root:-2,0,1:1:2"),
        (("", "'v < sqrt(2)'", false, "v^2 != 2", ""), "false root:-2,0,1:1:2"),
        (("", "'v != sqrt(2)'", false, "v^2 != 2", ""), "false root:-2,0,1:1:2"),
        (("", "'v > sqrt(2)'", false, "v < 2", ""), "false root:-2,0,1:1:2"),
        (("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", ""), "false 4 4"),
        (("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", ""), "false 2 3"),
        (("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", ""), "false 2"),
        (("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", ""), "false 2/1 2"),
        (("", "['n = 1..3', 'real v']", false, "(n - v)^2 > 0", ""), "false 2 2 1"),
        (("", "['real v', 'n = 1, 2']", false, "-1 <= v^2 < n", ""), "false 5 2 1"),
        (("", "['real v', 'n = 1, 2']", false, "-1 <= v^2 < n", ""), "false 5 2 3"),
        (("", "['real v', 'n = 1, 2']", false, "-1 <= v^2 < n", ""), "false 5 2"),
        (("", "['real v', 'n = 1, 2']", false, "-1 <= v^2 < n", ""), "false 2 5 2"),
    ] {
        assert!(!valid(&claim, &format!("fails reals\n {lines}")), "{claim:?}: {lines}");
    }
}

/// Without `only` the first of these is true, and with it false; and so on.
#[test]
fn only_says_more() {
    for (scheme, of, states) in [
        (FP, "'v > 1'", "support() = 6"),
        (FP, "'v = 1/16'", "sum_rules() >= 2"),
        (FP, "'-1/5 < v < 1/4'", "contraction(1) < 1"),
        (FP, "'-1/4 < v <= 1/5'", "contraction(1) < 1"),
        ("", "'v > 1'", "v >= 1"),
        ("", "'v != 1'", "v^2 >= 0"),
        ("", "'v > sqrt(2)'", "v^2 >= 2"),
    ] {
        assert!(!valid(&(scheme, of, true, states, ""), "holds reals"), "{of}: {states}");
        let listed = of.contains("= 1/16");
        // Without `only`, listed numbers are cases.
        let lines = if listed { "holds 1" } else { "holds reals" };
        assert!(valid(&(scheme, of, false, states, ""), lines), "{of}: {states}");
    }
    assert!(!valid(&(FP, "'v = 1/16'", true, "reproduction() = 3", ""), "holds 1"));
    assert!(!valid(&(FP, "'v = 1/16'", false, "reproduction() = 3", ""), "holds reals"));
}

/// What is written otherwise than the grammar says is accepted with no verdict.
#[test]
fn what_is_no_claim() {
    for (of, only) in [
        ("'1 < v > 0'", false),
        ("'0 < v >= 0'", false),
        ("'1 < v < 0'", false),
        ("'0 < v < 0'", false),
        ("'0 <= v < 0'", false),
        ("'sqrt(2) < v < sqrt(2)'", false),
        ("'0 < v < 1 < 2'", false),
        ("'0 != v'", false),
        ("'0 < v != 1'", false),
        ("'v < '", false),
        ("'v < w'", false),
        ("'v < 1/0'", false),
        ("'v > delta'", false),
        ("'v => 0'", false),
        ("'v == 0'", false),
        ("'real v > 0'", false),
        ("'real v, u'", false),
        ("['real v', 'u > 0']", false),
        ("['real v', 'all n']", false),
        ("['real v', 'n = 1..0']", false),
        ("['real v', 'n = 1..v']", false),
        ("['n = 1..2', 'v < n']", false),
        ("['real v', 'n = 1']", true),
        ("['v = 1', 'n = 1']", true),
        ("'v = 1..3'", true),
        ("'(v, u) = (1, 2)'", true),
        ("'all v'", true),
        ("[]", true),
        ("'real v'\nsymbols = ['w']", false),
        ("'real v'\nsymbols = ['q']\nhypotheses = ['q[1] = 1']", false),
        ("'v = 1'\nsymbols = ['w']", true),
    ] {
        for states in ["v^2 + 1 > 0", "v^2 + 1 < 0", "1 = 1", "1 = 2"] {
            for lines in ["holds reals", "fails reals\n false 1", "fails reals\n true 1", "holds 1"]
            {
                let claim = ("", of, only, states, "");
                assert!(!valid(&claim, lines), "{of}: {states}: {lines}");
            }
        }
    }
    for states in ["v ≈ 1", "1.0 ~ 1", "v = v = v ≈ 1"] {
        for lines in ["holds reals", "fails reals\n false 3", "fails reals\n false 3 1"] {
            assert!(!valid(&("", "'real v'", false, states, ""), lines), "{states}: {lines}");
        }
    }
    // Names that are words of the grammar.
    for of in ["'real > 0'", "'all > 0'", "'0 < all < 1'", "'real real'"] {
        let name = if of.contains("all") { "all" } else { "real" };
        let states = format!("{name}^2 >= 0");
        let fields = format!("states = '{states}'\nfor = {of}");
        let found = relation_of(SCHEMES, &fields, &format!("states {states}\n holds reals"));
        assert_eq!(found, Outcome::Valid, "{of}");
    }
}

/// No lines about constants stand beside real values.
#[test]
fn no_constants() {
    let constant = "constant hat contraction adjoint 1 0 1/2\n powers\n";
    let lines = |rest: &str| format!("{constant} states v^2 >= 0\n {rest}");
    let real = relation_of(SCHEMES, "states = 'v^2 >= 0'\nfor = 'real v'", &lines("holds reals"));
    assert!(matches!(real, Outcome::Invalid(..)), "{real:?}");
    let listed = relation_of(SCHEMES, "states = 'v^2 >= 0'\nfor = 'v = 1'", &lines("holds 1"));
    assert_eq!(listed, Outcome::Valid);
}

/// Where something has no value for some number, or none on a piece, the claim is open.
#[test]
fn what_has_no_value_is_left_open() {
    for (scheme, of, states) in [
        (FP, "'real v'", "hoelder() >= -1"),
        (FP, "'0 < v < 1/16'", "overshoot() >= 1"),
        (FP, "'0 < v < 1/16'", "limit_value(1/3) > 0"),
        (FP, "'0 < v < 1/16'", "limit_value(v) > 0"),
        (FP, "'0 < v < 1/16'", "limit_value(1, derivative = 2) < 0"),
        (LEBESGUE, "'0 < v < 1'", "inner_product(0) > 0"),
        (LEBESGUE, "'0 < v < 1'", "riesz_upper() = 1"),
        (LEBESGUE, "'0 < v <= 1'", "limit_value(-1/2) = v"),
        ("bent:w=v", "'1 < v < 2'", "limit_value(0) = 1"),
        (FP, "'real v'", "limit_value(0) = 1"),
        (FP, "'real v'", "eigenvalue(1) >= 0"),
        (FP, "'real v'", "riesz_lower() >= 0"),
        ("fp:w=1/v", "'v > 0'", "sum_rules() >= 2"),
        ("", "'v > 1'", "1/v < 1"),
        ("", "'real v'", "floor(v) <= v"),
        ("", "'real v'", "2^v > 0"),
        ("", "'v >= 0'", "sqrt(v) >= 0"),
        ("", "'real v'", "v^2 > sqrt(2)*v - 1"),
        ("", "'real v'", "kronecker(v, 2)"),
        ("", "'real v'", "u = u"),
    ] {
        for only in [false, true] {
            let found = outcome(&(scheme, of, only, states, ""), "holds reals");
            assert!(matches!(found, Outcome::Incomplete(Some(_))), "{states}: {found:?}");
        }
    }
    // These are 0 or 1 for two numbers only.
    for states in ["v", "not (v*(v-1))", "v in {v, 1/v}"] {
        assert!(!valid(&("", "'real v'", false, states, ""), "holds reals"), "{states}");
    }
}
