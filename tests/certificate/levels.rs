//! Certificates of theorems about single schemes that finitely many levels prove, and of wrong
//! ones, before the checker.

use proptest::prelude::*;
use subcert::audit::{LevelEvidence, Levels, PaperAudit, TheoremVerdict, audit};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, check};

const HEAD: &str = r#"
key = "levels"
[paper]
authors = []
title = ""
venue = ""
year = ""
[define]
T = 'contraction(1)'
Z = 'tensor(1)'
sigma = 'displacement()'
rate = '9/16'
two_levels = 'rate^floor(k/2)'
[[scheme]]
name = "skew"
mask = [['1/2', '3/8', '1/8'], ['1/4', '1/4', '1/2'], ['0', '1', '0']]
offset = '-1'
[[scheme]]
name = "middle"
parameters.N = { about = "valence" }
orbits = { vertex = '1', edge = 'N', face = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'face[i]'], ['face[i]', 'edge[i + 1]']]
weights.vertex = { vertex = '1' }
weights.edge = { vertex = '1/2', edge = 'kronecker(i, j)/2' }
weights.face = { vertex = '1/2', face = 'kronecker(i, j)/2' }
"#;

/// A claim file with one theorem, and perhaps another scheme.
fn paper(scheme: &str, fields: &str) -> Paper {
    let theorem = format!("[[theorem]]\nid = 't'\nlocus = ''\ntitle = ''\n{fields}\n");
    let text = format!("{HEAD}{scheme}{theorem}");
    read_paper(&SourceText::new("test", text)).unwrap_or_else(|error| panic!("{error}"))
}

fn fields(scheme: &str, bounds: &str, by: &str, more: &str) -> String {
    format!("scheme = '{scheme}'\nbounds = '{bounds}'\nby = '{by}'\n{more}")
}

fn judged(paper: &Paper) -> PaperAudit<'_> {
    audit(paper).unwrap_or_else(|error| panic!("{error}"))
}

/// What the checker says of the theorem, and the certificate.
fn outcome(audit: &PaperAudit<'_>) -> (Outcome, String) {
    let written = certificate(audit).text;
    let report = check(&audit.paper.source.text, &[&written]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}\n{written}", report.broken);
    let theorem = report.claims.into_iter().next().expect("a theorem");
    (theorem.2, written)
}

/// What the checker says if the levels that prove another bound are said to prove the one of this
/// claim file; `None` unless it is refuted.
fn forged(paper: &Paper, levels: &Levels) -> Option<(Outcome, String)> {
    let mut audit = judged(paper);
    let finding = &mut audit.theorems[0];
    if finding.verdict != TheoremVerdict::Refuted {
        return None;
    }
    finding.refutation = None;
    finding.verdict = TheoremVerdict::Proved;
    finding.levels = Some(levels.clone());
    Some(outcome(&audit))
}

/// Scheme, quantity, bound, further fields. All of them are proved.
const PROVED: [(&str, &str, &str, &str); 25] = [
    ("chaikin", "difference", "beta/2^k", "from = '0'"),
    ("chaikin", "distance", "sigma*beta*T^k/(1 - T)", "from = '0'"),
    ("chaikin", "distance", "beta*(1/2)^(k + 1)", "from = '3'"),
    ("b-spline:degree=3", "distance", "0.34*beta*(1/2)^k", "from = '0'"),
    ("b-spline:degree=3", "step", "beta/4*(1/2)^k", "from = '0'"),
    ("b-spline:degree=3", "distance", "beta*(1/4)^floor(k/2)/2", "from = '1'"),
    ("four-point", "difference", "2*beta*two_levels", "from = '0'"),
    ("four-point", "difference", "5/4*beta*(3/5)^k", "from = '0'"),
    ("four-point", "step", "beta*two_levels/16 + beta*two_levels/16", "from = '0'"),
    ("four-point", "distance", "-beta*(-1/3)*T^k", "from = '0'"),
    ("four-point", "distance", "3*beta*T^k", "from = '0'\noffset = '0'"),
    ("quinary-three-point", "step", "sigma*beta*T^k", "from = '1'"),
    ("skew", "difference", "2*beta*(3/4)^(2*k)/(3/4)^k", "from = '2'"),
    ("skew", "distance", "3*beta*(3/4)^k", "from = '0'"),
    ("chaikin x chaikin", "difference", "beta*(1/2)^k", "from = '0'"),
    ("chaikin x four-point", "difference", "beta*(5/8)^k", "from = '0'"),
    ("chaikin x four-point", "step", "beta*3/8*(5/8)^k", "from = '0'"),
    ("four-point x chaikin", "step", "beta*3/8*(5/8)^k", "from = '1'"),
    ("chaikin x chaikin", "distance", "beta*(1/2)^k", "from = '0'"),
    ("four-point x chaikin", "distance", "2*beta*(25/32)^k", "from = '1'\noffset = '-1'"),
    ("doo-sabin:n=5", "difference", "beta*(13/20)^k", "from = '0'"),
    ("doo-sabin:n=5", "distance", "beta*2*(cos(pi/5) - 1/5)^k", "from = '1'"),
    ("doo-sabin:n=4", "step", "beta/2*(1/2)^k", "from = '0'"),
    ("catmull-clark:N=3", "step", "2*beta*(3/4)^k", "from = '0'\ninterpolant = 'middle:N=3'"),
    ("bajaj:N=4", "difference", "beta*(9/16)^floor(k/2)", "from = '0'"),
];

#[test]
fn proofs_by_finitely_many_levels_have_valid_certificates() {
    let (mut kinds, mut false_bounds) = ([0; 3], 0);
    for (scheme, bounds, by, more) in PROVED {
        let right = paper("", &fields(scheme, bounds, by, more));
        let audit = judged(&right);
        let finding = &audit.theorems[0];
        assert_eq!(
            finding.verdict,
            TheoremVerdict::Proved,
            "{scheme}: {bounds} <= {by}: {:?}",
            finding.cases
        );
        let (found, text) = outcome(&audit);
        assert_eq!(found, Outcome::Valid, "{text}");
        let levels = finding.levels.as_ref().expect("levels");
        kinds[match levels.evidence.as_ref().expect("evidence") {
            LevelEvidence::Suprema => 0,
            LevelEvidence::Later(_) => 1,
            LevelEvidence::Flows { .. } => 2,
        }] += 1;
        for factor in ["0", "1/10", "2/3", "9/10", "99/100"] {
            let wrong = paper("", &fields(scheme, bounds, &format!("{factor}*({by})"), more));
            if let Some((found, text)) = forged(&wrong, levels) {
                assert!(matches!(found, Outcome::Invalid(..)), "{found:?}: {text}");
                false_bounds += 1;
            }
        }
    }
    assert!(kinds.iter().all(|count| *count >= 4), "{kinds:?}");
    assert!(false_bounds > 75, "{false_bounds}");
}

/// What finitely many levels do not prove, or not so that a certificate shows it.
#[test]
fn what_is_not_proved_so() {
    let open = [
        // For a net that has no differences along the first index, it is false.
        ("chaikin x chaikin", "difference", "beta_1/2^k"),
        // Not a product of powers, and not proportional to the spread.
        ("chaikin", "difference", "beta*(1 + k)/2^k"),
        ("chaikin", "difference", "beta/2^k + beta/3^k"),
        // It is proportional to the spreads 1 and 2 alone.
        ("chaikin", "difference", "beta*(1 + (beta - 1)*(beta - 2))/2^k"),
        ("b-spline:degree=3", "distance", "beta/3*(1/4)^k"),
    ];
    for (scheme, bounds, by) in open {
        let paper = paper("", &fields(scheme, bounds, by, "from = '0'"));
        let audit = judged(&paper);
        assert_eq!(audit.theorems[0].verdict, TheoremVerdict::Open, "{bounds} <= {by}");
        assert!(matches!(outcome(&audit).0, Outcome::Incomplete(Some(_))));
    }
    // The distance of the cubic B-spline is 1/3 exactly: no sound bound is as small.
    let exact = "beta/3*(1/2)^k";
    let paper = paper("", &fields("b-spline:degree=3", "distance", exact, "from = '0'"));
    let audit = judged(&paper);
    assert_eq!(audit.theorems[0].verdict, TheoremVerdict::Proved);
    assert_eq!(outcome(&audit).0, Outcome::Incomplete(None));
    assert!(certificate(&audit).omitted[0].why.contains("no sound bound"));
}

proptest! {
    #![proptest_config(crate::common::cases(16))]

    /// σβT^k/(1 − T) and what it rests on, for random schemes and their tensor products.
    #[test]
    fn bounds_of_random_schemes(
        u in -8_i64..=16,
        v in -8_i64..=16,
        offset in -2_i64..=1,
        factor in 1_i64..=100,
    ) {
        let mask = format!("[['1 - {u}/16', '{u}/16'], ['{v}/16', '1 - {v}/16']]");
        let scheme = format!("[[scheme]]\nname = 'two'\nmask = {mask}\noffset = '{offset}'\n");
        let net = "(sigma*norm(1) + sigma)";
        let cases = [
            ("two", "difference", "beta*T^k".to_owned(), "T"),
            ("two", "step", "sigma*beta*T^k".to_owned(), "T"),
            ("two", "distance", "sigma*beta*T^k/(1 - T)".to_owned(), "T"),
            ("two x two", "difference", "beta*Z^k".to_owned(), "Z"),
            ("two x two", "step", format!("{net}*beta*Z^k"), "Z"),
            ("two x two", "distance", format!("{net}*beta*Z^k/(1 - Z)"), "Z"),
        ];
        for (name, bounds, by, constant) in cases {
            let more = format!("from = '0'\nsupposes = {{ value = '{constant}', below = '1' }}");
            let right = paper(&scheme, &fields(name, bounds, &by, &more));
            let audit = judged(&right);
            let finding = &audit.theorems[0];
            let (found, text) = outcome(&audit);
            let Some(levels) = &finding.levels else {
                // What it supposes does not hold.
                prop_assert_eq!(finding.verdict, TheoremVerdict::Open, "{}", text);
                continue;
            };
            prop_assert_eq!(found, Outcome::Valid, "{}", text);
            let by = format!("{factor}/101*({by})");
            let wrong = paper(&scheme, &fields(name, bounds, &by, &more));
            if let Some((found, text)) = forged(&wrong, levels) {
                prop_assert!(matches!(found, Outcome::Invalid(..)), "{found:?}: {text}");
            }
        }
    }
}
