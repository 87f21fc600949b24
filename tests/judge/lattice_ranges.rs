//! Claims about ranges of a parameter of masks on Z^d, and their certificates.

use super::lattice_limits::{agreed, altered};
use crate::common::claims::{HEAD, paper};
use subcert::audit::Word;
use subcert_check::{Outcome, check};

const SCHEMES: &str = "
    [[scheme]]\nname = 'courant'\nparameters.w = { about = 'weight' }
    symbol = '(1+x)*(1+y)*(1+x*y)/2*(1+w*(3-x-y-1/(x*y)))'
    [[scheme]]\nname = 'quincunx'\nparameters.w = { about = 'weight' }\nparameters.v = { about = 'weight' }
    symbol = '1+v*(x+1/x)+w*(y+1/y)'\ndilation = [[1,1],[1,-1]]
    [[scheme]]\nname = 'zwart-powell'\nparameters.w = { about = 'weight' }
    symbol = '(1+x)*(1+y)/2*(1+w*(1-x))'\ndilation = [[1,1],[1,-1]]
    [[scheme]]\nname = 'loop2'\nparameters.w = { about = 'weight' }
    symbol = '(1+x)^2*(1+y)^2*(1+x*y)^2/16*(1+w*(1-x))'
    [[scheme]]\nname = 'bent'\nparameters.w = { about = 'weight' }
    symbol = '(1+x)*(1+y)*(1+x*y)/2*(1+abs(w)*(1-x))'
";

/// The scheme of quincunx in which the weights of two directions depend on w.
const TWO_PLACES: &str = "quincunx:v=1/2-w,w=w";

/// A claim of C^m of a scheme for these ends.
fn claim(scheme: &str, m: usize, ends: &str) -> String {
    format!(
        "{SCHEMES}[[range]]\nid = 'c'\nlocus = 'l'\nscheme = '{scheme}'\nvariable = 'w'\nsmoothness = '{m}'\n{ends}\n"
    )
}

/// The verdict on a claim, on which the checker has to agree, and the certificate. Where `certified` is false, there is none.
fn verdict(scheme: &str, m: usize, ends: &str, certified: bool) -> (Word, String) {
    agreed(&claim(scheme, m, ends), certified)
}

#[test]
fn ranges() {
    for (scheme, m, ends, expected) in [
        ("courant:w=w", 0, "from = '-1/10'\nto = '1/10'\nclosed = true", Word::Confirmed),
        ("courant:w=w", 0, "from = '-1'\nto = '1'", Word::Refuted),
        // Sum rules of order 2 hold for all w, and no more.
        ("courant:w=w", 2, "from = '-1/10'\nto = '1/10'", Word::Refuted),
        // s^m is irrational, so that products of two steps are taken.
        ("zwart-powell:w=w", 1, "from = '-1/100'\nto = '1/100'", Word::Confirmed),
        ("loop2:w=w", 2, "from = '-0.010'\nto = '0.010'", Word::Confirmed),
        // The variable stands for a half of itself, and in two places.
        ("quincunx:v=1/2-w/2,w=w/2", 0, "from = '1/4'\nto = '2/3'", Word::Confirmed),
        (TWO_PLACES, 0, "from = '1/4'\nto = '2'", Word::Refuted),
        // At 1/4 they are C^0, and at w = 0 too.
        (TWO_PLACES, 0, "from = '1/10'\nto = '1/5'\nonly = true", Word::Refuted),
    ] {
        assert_eq!(verdict(scheme, m, ends, true).0, expected, "{scheme}, {m}, {ends}");
    }
}

/// Where there is no end, or all other values are said to be worse, there is no certificate.
#[test]
fn not_certified() {
    for (scheme, m, ends, expected) in [
        ("courant:w=w", 0, "to = '1/10'", Word::Refuted),
        (TWO_PLACES, 0, "from = '-1/2'\nto = '1'\nonly = true", Word::Open),
    ] {
        let certified = expected == Word::Refuted;
        assert_eq!(verdict(scheme, m, ends, certified).0, expected, "{scheme}, {m}, {ends}");
    }
    let bent = paper(&claim("bent:w=w", 0, "from = '0'\nto = '1/10'"));
    let error = subcert::audit::audit(&bent).expect_err("no polynomial").to_string();
    assert!(error.contains("not polynomial in `w`"), "{error}");
}

/// The butterfly scheme is C^1 for weights between 0 and 1/8.
#[test]
fn butterfly() {
    let ends = "from = '1/100'\nto = '1/10'";
    let (word, text) = verdict("butterfly-regular:w=w", 1, ends, true);
    assert_eq!(word, Word::Confirmed);
    assert!(text.contains("\n  tile hexagon +\n"));
    // The same pieces show nothing of a wider range.
    let wide = claim("butterfly-regular:w=w", 1, "from = '0'\nto = '1/4'");
    let report = check(&format!("{HEAD}{wide}"), &[&text]).expect("a claim file");
    assert!(matches!(report.claims[0].2, Outcome::Invalid(..)), "{:?}", report.claims[0].2);
}

/// The scheme and the ends of a claim that is confirmed by pieces, and of one for which the same pieces would prove what is false.
const PIECES: (&str, usize, &str) = ("courant:w=w", 0, "from = '-1/10'\nto = '1/10'");

/// A line that is left out, doubled, exchanged with the next, or has another number shows nothing false: of a claim that is refuted no confirmation is valid, and
/// of one that is confirmed no refutation.
#[test]
fn altered_certificates() {
    let (mut count, mut accepted) = (0, Vec::new());
    let (scheme, m, ends) = PIECES;
    let (_, confirmed) = verdict(scheme, m, ends, true);
    let (_, refuted) = verdict(scheme, m, "from = '-1'\nto = '1'", true);
    let body = |text: &str| {
        let (_, body) = text.split_once("  smoothness 0\n").expect("the order");
        body.to_owned()
    };
    let start = |text: &str| text.split_inclusive("  smoothness 0\n").next().unwrap().to_owned();
    for (ends, text) in [
        // Of the claim that is false: the lines of the one that is true, on wider pieces.
        (
            "from = '-1'\nto = '1'",
            format!("{}{}", start(&refuted), body(&confirmed))
                .replace("piece -1/10 1/10", "piece -1 1"),
        ),
        ("from = '-1'\nto = '1'", refuted.replace("  refuted\n", "  confirmed\n")),
        ("from = '-1/10'\nto = '1/10'", format!("{}{}", start(&confirmed), body(&refuted))),
    ] {
        let source = format!("{HEAD}{}", claim(scheme, m, ends));
        let lines: Vec<&str> = text.lines().collect();
        let first =
            lines.iter().position(|line| line.starts_with("  smoothness")).expect("a claim");
        for at in (first..lines.len() - 1).filter(|at| *at < 20 || at % 8 == 0) {
            for altered in altered(&lines, at) {
                count += 1;
                let report = check(&source, &[&altered]);
                if report.is_ok_and(|report| matches!(report.claims[0].2, Outcome::Valid)) {
                    accepted.push(lines[at].to_owned());
                }
            }
        }
    }
    assert!(count > 1_000, "{count}");
    assert!(accepted.is_empty(), "{accepted:?}");
}
