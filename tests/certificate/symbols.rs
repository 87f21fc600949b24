//! Schemes by their symbols, before the checker.

use subcert::audit::{EquationVerdict, audit};
use subcert::certificate::certificate;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, check};

const PAPER: &str = "key = 'k'\n[paper]\nauthors = ['A B']\ntitle = 't'\nvenue = 'v'\nyear = '2026'\n\
    [[scheme]]\nname = 'four'\nparameters.w = {}\nsymbol = '2*s^2/z*(1 - 2*w*rest/z^2)'\n\
    [scheme.let]\ns = '(1 − z^2)/(1 − z)/2'\nrest = '(1 - z)^2*(1 + z^2)'\n\
    [[scheme]]\nname = 'three'\narity = '3'\nsymbol = 'sum(j = -1..1, z^j)^3/9'\n\
    [[equation]]\nid = 'four'\nlocus = 'l'\nscheme = 'four:w=1/16'\n\
    indices = [{ name = 'j', values = ['0', '1', '2', '3'] }]\nleft = ['-1/16', '9/16', '9/16', '-1/16']\n\
    right = 'mask(1, j)'\n\
    [[equation]]\nid = 'three'\nlocus = 'l'\nscheme = 'three'\n\
    indices = [{ name = 'i', values = ['0', '1', '2'] }]\nleft = ['1/9', '7/9', '1/9']\nright = 'mask(0, i)'\n\
    [[table]]\nid = 'offset'\nlocus = 'l'\nscheme = 'four:w=1/16'\nvalue = 'c*displacement()'\n\
    columns = { name = 'c', values = ['1', '2', '4'] }\ncells = [['0.125', '0.25', '0.5']]\n";

/// The ids of the equations that the checker accepts in a certificate; none of a file that it refuses.
fn accepted(claims: &str, written: &str) -> Vec<String> {
    let Ok(report) = check(claims, &[written]) else { return Vec::new() };
    let valid = report.claims.into_iter().filter(|(_, _, outcome)| *outcome == Outcome::Valid);
    valid.map(|(_, id, _)| id).collect()
}

/// The checker multiplies symbols out on its own, and has the rules and the offset of the program.
#[test]
fn the_checker_reads_symbols() {
    let paper = read_paper(&SourceText::new("test", PAPER)).expect("a claim file");
    let audit = audit(&paper).expect("an audit");
    for finding in &audit.equations {
        assert!(matches!(finding.verdict, EquationVerdict::Holds { .. }), "{finding:?}");
    }
    let written = certificate(&audit).text;
    let mut all = accepted(PAPER, &written);
    all.sort();
    assert_eq!(all, ["four", "offset", "three"]);
    // Another symbol, of which the certificate says what is wrong.
    for (old, new, lost) in [
        ("2*s^2/z*", "2*s^2*", "offset"),
        ("rest/z^2", "rest/z^3", "four"),
        ("1 - 2*w", "1 - 3*w", "four"),
        ("(1 + z^2)'", "(1 + z)'", "four"),
        ("sum(j = -1..1, z^j)^3/9", "sum(j = 0..2, z^j)^2/3", "three"),
        // What is no symbol of a mask.
        ("(1 − z)/2'", "(1 − 2*z)/2'", "four"),
        ("^3/9", "^3/8", "three"),
        ("arity = '3'", "arity = '2'", "three"),
        ("arity = '3'", "offset = '-1'", "three"),
        ("arity = '3'", "mask = '[1, 1]'", "three"),
        ("parameters.w = {}", "parameters.w = {}\nparameters.z = { default = '1' }", "four"),
        ("sum(j = -1..1, z^j)^3/9", "abs(z)", "three"),
        ("sum(j = -1..1, z^j)^3/9", "sum(j = -1..1, z^j)^1000000/9", "three"),
    ] {
        let claims = PAPER.replace(old, new);
        assert_ne!(claims, PAPER, "{old}");
        assert!(!accepted(&claims, &written).contains(&lost.to_owned()), "{new}");
        // The program has not what the certificate says either.
        let read = read_paper(&SourceText::new("test", &claims[..]));
        let holds = read.as_ref().ok().and_then(|paper| {
            let audit = subcert::audit::audit(paper).ok()?;
            let finding = audit.equations.iter().find(|finding| finding.equation.id == lost)?;
            Some(matches!(finding.verdict, EquationVerdict::Holds { .. }))
        });
        assert_ne!(holds, Some(true), "{new}");
    }
}
