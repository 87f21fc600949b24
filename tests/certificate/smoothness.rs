//! Certificates of claims about smoothness, checked, and the papers that have such claims.

use crate::common::claims::{DEPENDENT, DEPENDENT_SCHEME, HEAD, judged, paper};
use std::path::Path;
use subcert::audit::{KnownLimits, audit};
use subcert::certificate::certificate;
use subcert::claim::read_paper_file;
use subcert::exact::Rational;
use subcert_check::{Outcome, check};

/// The papers with claims about smoothness, and the claims of each that no certificate carries.
const PAPERS: [(&str, &[&str]); 23] = [
    ("cohen1992", &[]),
    ("deboor1987", &[]),
    ("dong2007", &[]),
    ("dubuc1986", &["dubuc1986:exponent"]),
    ("dyn1987", &[]),
    ("dyn1991", &[]),
    ("dyn2005", &[]),
    ("hassan2002", &["hassan2002:only"]),
    ("hassan2003", &[]),
    ("hechler2009", &["hechler2009:sharp"]),
    ("hormann2008", &[]),
    ("ko2007", &[]),
    ("kobbelt2000", &["kobbelt2000:tangent-plane"]),
    ("lane1980", &[]),
    ("loop1987", &[]),
    ("mustafa2009", &[]),
    ("peters1997", &["peters1997:tangent-plane"]),
    ("peters1998", &[]),
    ("rioul1992", &["rioul1992:four-points"]),
    ("rossignac2008", &["rossignac2008:tangent", "rossignac2008:third"]),
    ("siddiqi2007", &[]),
    ("siddiqi2013", &[]),
    ("warren1995", &[]),
];

/// The papers about surfaces at all valences, whose certificates cite a theorem.
const ALL_VALENCES: [&str; 3] = ["loop1987", "peters1998", "warren1995"];

#[test]
fn the_claims_of_the_papers_hold_and_are_certified() {
    for (key, omitted) in PAPERS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/claims/smoothness");
        let path = path.join(format!("{key}.toml"));
        let paper = read_paper_file(&path).expect("a file").expect("a claim file");
        assert_eq!(paper.key, key);
        let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        for finding in &audit.smoothness {
            let expected = match (key, &finding.claim.id[..]) {
                ("hechler2009", _) => "rounding",
                // The regular parts of their surfaces are not known here.
                ("kobbelt2000" | "peters1997", "tangent-plane") => "open",
                _ => "confirmed",
            };
            assert_eq!(finding.verdict.word().name(), expected, "{}", finding.id);
        }
        assert!(audit.errata().errata.is_empty());
        let certificate = certificate(&audit);
        let left_out: Vec<&str> = certificate.omitted.iter().map(|one| one.id.as_str()).collect();
        assert_eq!(left_out, omitted);
        let text = std::fs::read_to_string(&path).expect("a file");
        let report = check(&text, &[&certificate.text]).expect("a claim file");
        assert!(report.broken.is_empty(), "{:?}", report.broken);
        for (_, id, outcome) in &report.claims {
            let without = omitted.contains(&&format!("{key}:{id}")[..]);
            let by_theorem = ALL_VALENCES.contains(&key);
            let accepted = match outcome {
                Outcome::Incomplete(None) => without,
                Outcome::Cited(_) => by_theorem,
                Outcome::Valid => !without && !by_theorem,
                _ => false,
            };
            assert!(accepted, "{key}:{id}: {outcome:?}");
        }
    }
}

#[test]
fn what_the_radius_does_not_show_is_left_out() {
    let claims = "[[exponent]]\nid = 'attained'\nlocus = ''\nscheme = 'chaikin'\nvalue = '2'\nattained = true\n\
                  [[exponent]]\nid = 'base'\nlocus = ''\nscheme = 'chaikin'\nat_least = 'log_3(2)'\n\
                  [[exponent]]\nid = 'open'\nlocus = ''\nscheme = 'chaikin'\nvalue = 'log_3(9) + log_5(5) - 1'\n\
                  [[range]]\nid = 'only'\nlocus = ''\nscheme = 'ternary-four-point:mu=w'\nvariable = 'w'\n\
                  smoothness = '2'\nfrom = '1/15'\nto = '1/9'\nonly = true\n\
                  [[range]]\nid = 'hulls'\nlocus = ''\nscheme = 'four-point:w=w'\nvariable = 'w'\n\
                  smoothness = '1'\nfrom = '0'\nto = '0.1927'\n";
    let paper = paper(claims);
    let written = certificate(&judged(&paper));
    let left_out: Vec<&str> = written.omitted.iter().map(|one| one.id.as_str()).collect();
    assert_eq!(left_out, ["k:attained", "k:base", "k:open", "k:only", "k:hulls"]);
    assert_eq!(written.blocks, 0);
    let report = check(&format!("{HEAD}{claims}"), &[&written.text]).expect("a claim file");
    assert!(report.claims.iter().all(|(_, _, outcome)| *outcome == Outcome::Incomplete(None)));
}

/// The claim is about another symbol: (1 + z)(1 + z²)((1 − w) + (1 + w)z)/4 times g(z)/g(z²), g = 1 + z.
#[test]
fn a_range_of_dependent_shifts_is_certified() {
    let claim = format!(
        "[[range]]\nid = 'c'\nlocus = ''\n{DEPENDENT}from = '-1'\nto = '1'\n{DEPENDENT_SCHEME}"
    );
    let text = certificate(&judged(&paper(&claim))).text;
    assert!(text.contains("\n  shifts 1 1\n"), "{text}");
    let valid = |text: &str| {
        let report = check(&format!("{HEAD}{claim}"), &[text]).expect("a claim file");
        report.claims[0].2 == Outcome::Valid
    };
    assert!(valid(&text));
    for wrong in
        ["", "  shifts 1 2\n", "  shifts 1 1\n  shifts 1 1\n", "  shifts 1 0\n", "  shifts 2\n"]
    {
        assert!(!valid(&text.replace("  shifts 1 1\n", wrong)), "{wrong}");
    }
}

/// An end of two digits stands for what is less than a unit away: the same value refutes it for the program and for the
/// checker, and another value refutes it for neither.
#[test]
fn rounded_ends_of_ranges_have_one_rule() {
    let claim = |ends: &str| {
        format!(
            "[[range]]\nid = 'c'\nlocus = ''\nscheme = 'four-point:w=w'\nvariable = 'w'\nsmoothness = '1'\n{ends}\n"
        )
    };
    let refuted = |ends: &str| {
        let own = paper(&claim(ends));
        let audit = judged(&own);
        let KnownLimits::Range(range) = &audit.smoothness[0].known else { panic!("a range") };
        let at = range.witness.as_ref().expect("a value").at.clone();
        (at, certificate(&audit).text)
    };
    // C^1 up to 0.19273, and these are a value beyond it, and one below it that the claim leaves out.
    let (beyond, inside) =
        (refuted("from = '0'\nto = '1/5'"), refuted("from = '0'\nto = '1/8'\nonly = true"));
    // The verdict of the program, and whether the checker takes the certificate with this value.
    let says = |ends: &str, verdict: &str, (at, certificate): &(Rational, String), valid: bool| {
        let claim = claim(ends);
        assert_eq!(judged(&paper(&claim)).smoothness[0].verdict.word().name(), verdict, "{ends}");
        let report = check(&format!("{HEAD}{claim}"), &[certificate]).expect("a claim file");
        assert_eq!(report.claims[0].2 == Outcome::Valid, valid, "{ends}: {at:?}");
    };
    let q = Rational::new;
    for (ends, verdict, least) in [
        ("to = '0.20'", "rounding", q(19, 100)),
        ("to = '0.200'", "refuted", q(199, 1000)),
        ("to = '0.21'", "refuted", q(1, 5)),
        ("to = '0.2'", "refuted", q(1, 5)),
        ("to = '0.193'", "rounding", q(192, 1000)),
        ("to = '1'", "refuted", q(1, 1)),
        ("to = '0.19'", "confirmed", q(18, 100)),
    ] {
        says(&format!("from = '0'\n{ends}"), verdict, &beyond, beyond.0 <= least);
    }
    for (ends, verdict, most) in [
        ("to = '0.18'", "refuted", q(19, 100)),
        ("to = '0.193'", "rounding", q(194, 1000)),
        ("to = '0.1'", "refuted", q(1, 10)),
        ("to = '0.11'", "refuted", q(12, 100)),
    ] {
        says(&format!("from = '0'\nonly = true\n{ends}"), verdict, &inside, inside.0 >= most);
    }
    // Between ends that are less than two units apart nothing is certain; they are taken as they stand.
    for (ends, valid) in
        [("from = '0.19'\nto = '0.20'", true), ("from = '0.18'\nto = '0.21'", true)]
    {
        says(ends, "refuted", &beyond, valid);
    }
}

#[test]
fn cells_of_tables_are_certified_one_by_one() {
    let claims = "[given]\nw = '1/4'\n[[regularity]]\nid = 't'\nlocus = ''\nrows = { schemes = ['chaikin', 'six-point:w=3/256'] }\n\
                  columns = ['order', 'exponent', 'value']\ncells = [[1, '2', '2'], [2, '2.85', '6 - log_2(9)']]\n\
                  [[regularity]]\nid = 'u'\nlocus = ''\nscheme = 'four-point:w=w'\nrows = { name = 'w', values = ['1/16', '3/64'] }\n\
                  columns = ['continuous', 'exponent']\ncells = [['1', '-'], ['-', '1.5']]\n\
                  [[exponent]]\nid = 'e'\nlocus = ''\nscheme = 'four-point:w=w'\ngiven = { w = '3/64' }\nprinted = '1.415'\n";
    let own = paper(claims);
    let audit = judged(&own);
    let verdicts: Vec<_> =
        audit.smoothness.iter().map(|one| (&one.id[2..], one.verdict.word().name())).collect();
    assert_eq!(
        verdicts,
        [
            ("t.1.order", "confirmed"),
            ("t.2.order", "confirmed"),
            ("u.1.continuous", "confirmed"),
            ("e", "confirmed"),
            ("t.1.exponent", "confirmed"),
            ("t.1.value", "confirmed"),
            // It is 2.830….
            ("t.2.exponent", "refuted"),
            ("t.2.value", "confirmed"),
            // It is 1.415…: with the unit 1/10, 1.5 is rounded away from 0.
            ("u.2.exponent", "rounding"),
        ]
    );
    let written = certificate(&audit);
    assert!(written.omitted.is_empty(), "{:?}", written.omitted);
    let invalid = |claims: &str| {
        let report = check(&format!("{HEAD}{claims}"), &[&written.text]).expect("a claim file");
        assert_eq!(report.claims.len() + report.broken.len(), 9);
        let invalid = report.claims.into_iter().filter(|(_, _, found)| *found != Outcome::Valid);
        invalid.map(|(_, id, _)| id).collect::<Vec<String>>()
    };
    assert!(invalid(claims).is_empty());
    // A certificate of one table is none of another.
    assert_eq!(invalid(&claims.replace("[[1, '2'", "[[2, '2'")), ["t.1.order"]);
    assert_eq!(invalid(&claims.replace("'2.85'", "'2.83'")), ["t.2.exponent"]);
    assert_eq!(invalid(&claims.replace("['1/16', '3/64']", "['1/16', '1/8']")), ["u.2.exponent"]);
    assert_eq!(invalid(&claims.replace("given = { w = '3/64' }\n", "")), ["e"]);
    for (right, wrong) in [
        ("['order', 'exponent', 'value']", "['order', 'exponent', 'order']"),
        ("['order', 'exponent', 'value']", "['order', 'exponent', 'printed']"),
        ("[[1, '2', '2'], ", "["),
        ("[[1, '2', '2'], ", "[[1, '2'], "),
        ("id = 'u'", "id = 't'"),
        ("id = 'u'", "id = 'u'\nvalue = '2'"),
        ("scheme = 'four-point:w=w'\nrows", "rows"),
    ] {
        assert!(
            check(&format!("{HEAD}{}", claims.replacen(right, wrong, 1)), &[]).is_err(),
            "{wrong}"
        );
    }
}
