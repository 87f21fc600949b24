//! Claims about the smoothness of masks on Z^d, and their certificates.

use crate::common::claims::{judged, paper};
use subcert::audit::Word;
use subcert::certificate::certificate;
use subcert_check::{Outcome, check};

const SCHEMES: &str = "
    [[scheme]]\nname = 'zp'\nbox = [[1,0],[0,1],[1,1],[1,-1]]
    [[scheme]]\nname = 'loop2'\nsymbol = '(1+x)^2*(1+y)^2*(1+x*y)^2/16'
    [[scheme]]\nname = 'quincunx'\nsymbol = '1+(x+1/x+y+1/y)/4'\ndilation = [[1,1],[1,-1]]
    [[scheme]]\nname = 'midedge'\nsymbol = '(1+x)*(1+y)/2'\ndilation = [[1,1],[1,-1]]
    [[scheme]]\nname = 'root3'\nsymbol = '1+(x+1/x+y+1/y+x/y+y/x)/3'\ndilation = [[1,2],[-2,-1]]\nedges = [[1,0],[0,1],[1,-1]]
    [[scheme]]\nname = 'bicubic'\nsymbol = '(1+x)^4*(1+y)^4/64'
    [[scheme]]\nname = 'mixed'\nsymbol = '(1+x)^2/2*(1+y+y^2)^3/9'\ndilation = [[2,0],[0,3]]
    [[scheme]]\nname = 'solid'\nsymbol = '(1+x)*(1+y)*(1+z)*(1+x*y*z)/2'
    [[scheme]]\nname = 'apart'\nsymbol = '(1+x^3)^2*(1+y)^2/4'
    [[scheme]]\nname = 'sheared'\nsymbol = '(1+x)*(1+y)*(1+x*y)/2+(x-1)*(y-1)*(x-1/y)'
    [[scheme]]\nname = 'skew'\nsymbol = '(1+x)^2/(2*x)*(1+y+y^2)^2/(3*y^2)*(1+(x-1)^2*(y-1)^2/90)'\ndilation = [[2,0],[0,3]]
";

/// The verdict on the one claim of a file, on which the checker has to agree, and the certificate. Where `certified` is false, there is none.
pub fn agreed(claims: &str, certified: bool) -> (Word, String) {
    let paper = paper(claims);
    let audit = judged(&paper);
    let word = audit.smoothness[0].verdict.word();
    let text = certificate(&audit).text;
    let report = check(&paper.source.text, &[&text]).expect("a claim file");
    let (_, _, outcome) = &report.claims[0];
    let agrees = match outcome {
        Outcome::Valid => certified,
        Outcome::Incomplete(_) => !certified,
        _ => false,
    };
    assert!(agrees, "{claims}: {word}, {outcome:?}\n{text}");
    (word, text)
}

fn verdict(kind: &str, fields: &str, certified: bool) -> Word {
    agreed(&format!("{SCHEMES}[[{kind}]]\nid = 'c'\nlocus = 'l'\n{fields}"), certified).0
}

#[test]
fn orders() {
    for (scheme, says, expected) in [
        ("zp", "continuous = '1'\nnot_continuous = '2'", Word::Confirmed),
        ("zp", "continuous = '2'", Word::Refuted),
        ("loop2", "continuous = '2'", Word::Confirmed),
        ("loop2", "not_continuous = '2'", Word::Refuted),
        ("quincunx", "continuous = '0'\nnot_continuous = '1'", Word::Confirmed),
        ("midedge", "continuous = '2'", Word::Refuted),
        ("root3", "continuous = '0'", Word::Confirmed),
        ("bicubic", "continuous = '2'\nnot_continuous = '3'", Word::Confirmed),
        ("mixed", "continuous = '0'\nnot_continuous = '1'", Word::Confirmed),
        ("mixed", "continuous = '1'", Word::Refuted),
        ("solid", "not_continuous = '1'", Word::Confirmed),
        ("apart", "not_continuous = '0'", Word::Confirmed),
        ("apart", "continuous = '0'", Word::Refuted),
        ("sheared", "not_continuous = '0'", Word::Confirmed),
        ("skew", "continuous = '0'", Word::Confirmed),
    ] {
        let fields = format!("scheme = '{scheme}'\n{says}\n");
        assert_eq!(verdict("smoothness", &fields, true), expected, "{fields}");
    }
    // Of an anisotropic M only C^0 is decided.
    assert_eq!(verdict("smoothness", "scheme = 'skew'\ncontinuous = '1'\n", false), Word::Open);
}

#[test]
fn exponents() {
    for (scheme, says, expected) in [
        ("zp", "value = '2'", Word::Confirmed),
        ("zp", "value = '2 - 1/10^6'", Word::Refuted),
        ("loop2", "at_least = '3'\nat_most = '3'", Word::Confirmed),
        ("loop2", "at_most = '5/2'", Word::Refuted),
        ("quincunx", "printed = '0.6115'", Word::Confirmed),
        ("quincunx", "printed = '0.6116'", Word::Rounding),
        ("quincunx", "printed = '0.612'", Word::Confirmed),
        ("quincunx", "printed = '0.62'", Word::Rounding),
        ("quincunx", "printed = '0.63'", Word::Refuted),
        ("root3", "value = '2*log_3(3/2)'", Word::Confirmed),
        ("root3", "value = '2*log_3(3/2) + 1/10^4'", Word::Refuted),
        ("bicubic", "value = '3'", Word::Confirmed),
        ("mixed", "value = '1'", Word::Confirmed),
        ("mixed", "at_least = '11/10'", Word::Refuted),
        ("apart", "value = '1'", Word::Refuted),
    ] {
        let fields = format!("scheme = '{scheme}'\n{says}\n");
        assert_eq!(verdict("exponent", &fields, true), expected, "{fields}");
    }
}

/// Of so many lines of a certificate at most each is altered.
const LINES: usize = 50;

/// A line that is left out, doubled, exchanged with the next, or has another number shows nothing false: the claim may be proved by what is left, but its
/// contrary never is.
#[test]
fn altered_certificates() {
    let mut accepted = 0;
    let mut count = 0;
    for (kind, fields, word, contrary) in [
        ("smoothness", "scheme = 'zp'\ncontinuous = '1'\n", "confirmed", "refuted"),
        ("smoothness", "scheme = 'bicubic'\ncontinuous = '3'\n", "refuted", "confirmed"),
        ("exponent", "scheme = 'quincunx'\nprinted = '0.6115'\n", "confirmed", "refuted"),
        ("exponent", "scheme = 'root3'\nvalue = '2*log_3(3/2)'\n", "confirmed", "refuted"),
        ("smoothness", "scheme = 'apart'\nnot_continuous = '0'\n", "confirmed", "refuted"),
        ("smoothness", "scheme = 'solid'\nnot_continuous = '1'\n", "confirmed", "refuted"),
    ] {
        let paper = paper(&format!("{SCHEMES}[[{kind}]]\nid = 'c'\nlocus = 'l'\n{fields}"));
        let text = certificate(&judged(&paper)).text;
        let opposite = text.replace(&format!("  {word}\n"), &format!("  {contrary}\n"));
        assert_ne!(text, opposite);
        let lines: Vec<&str> = opposite.lines().collect();
        let first = lines.iter().position(|line| line.starts_with("  scheme")).expect("a claim");
        // Of long certificates some lines, evenly.
        for at in (first..lines.len() - 1).step_by(lines.len().div_ceil(LINES)) {
            for altered in altered(&lines, at) {
                count += 1;
                let report = check(&paper.source.text, &[&altered]);
                let valid = report.is_ok_and(|report| matches!(report.claims[0].2, Outcome::Valid));
                accepted += usize::from(valid);
            }
        }
    }
    assert!(count > 1_000, "{count}");
    assert_eq!(accepted, 0);
}

/// The lines with one of them changed.
pub(super) fn altered(lines: &[&str], at: usize) -> Vec<String> {
    let text = |lines: Vec<String>| lines.join("\n") + "\n";
    let own = || lines.iter().map(|line| (*line).to_owned()).collect::<Vec<String>>();
    let mut all = Vec::new();
    let mut without = own();
    without.remove(at);
    all.push(text(without));
    let mut doubled = own();
    doubled.insert(at, lines[at].to_owned());
    all.push(text(doubled));
    let mut exchanged = own();
    exchanged.swap(at, at - 1);
    all.push(text(exchanged));
    for (old, new) in [("1", "0"), ("0", "1"), ("2", "1"), ("1", "2"), (" ", " -"), ("1", "1/2")] {
        if let Some(place) = lines[at].rfind(old).filter(|place| *place > 1) {
            let mut changed = own();
            changed[at].replace_range(place..=place, new);
            all.push(text(changed));
        }
    }
    all
}
