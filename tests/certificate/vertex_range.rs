//! Claims about the weights for which surfaces are C¹ at a vertex: verdicts, certificates, and certificates that are
//! changed.

use crate::common::claims::{HEAD, judged, paper};
use subcert::audit::{KnownLimits, SmoothnessFinding};
use subcert::certificate::certificate;
use subcert_check::{Outcome, check};

/// Loop's rules with the weight β of each point next to the vertex. At valence n, surfaces are C¹ for |5/8 − nβ| < λ;
/// λ = 1/2 for n = 6, so that β is from 1/48 to 3/16.
const SCHEME: &str = r"
[[scheme]]
name = 'own'
parameters = { N = {}, beta = {} }
orbits = { vertex = '1', edge = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]
weights.vertex = { vertex = '1 - N*beta', edge = 'beta' }
weights.edge = { vertex = '3/8', edge = '(3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8' }
let = { turn = 'mod(j - i, N)' }
";

/// Valences, what is stated, the verdict, and whether the checker confirms it.
const CLAIMS: [(&str, &str, &str, bool); 8] = [
    ("6", "from = '1/48'\nto = '3/16'", "confirmed", false),
    // At the ends two eigenvalues have the same modulus, and nothing is proved.
    ("6", "from = '1/48'\nto = '3/16'\nonly = true", "open", false),
    ("6", "from = '1/40'\nto = '3/16'\nonly = true", "refuted", true),
    ("6", "from = '0.02'\nto = '3/16'", "refuted", true),
    ("6", "from = '0.021'\nto = '0.188'", "rounding", false),
    ("3..4", "from = '1/40'\nto = '3/16'", "refuted", true),
    ("5..6", "from = '1/10'\nto = '3/20'", "confirmed", false),
    ("all", "from = '1/40'\nto = '1/10'", "refuted", true),
];

fn claim(place: usize, valences: &str, states: &str) -> String {
    format!(
        "[[range]]\nid = 'c{place}'\nlocus = ''\nvariable = 'b'\nscheme = 'own:beta=b'\nsmoothness = '1'\n\
         valences = '{valences}'\n{states}\n"
    )
}

fn claims() -> String {
    let claims = CLAIMS.iter().enumerate();
    let claims = claims.map(|(place, (valences, states, ..))| claim(place, valences, states));
    format!("{SCHEME}{}", claims.collect::<String>())
}

/// The values that refute a claim, and whether they are in the printed range.
fn witnesses(finding: &SmoothnessFinding<'_>) -> Vec<(usize, bool)> {
    let KnownLimits::VertexRanges(found) = &finding.known else { panic!("{:?}", finding.known) };
    let witness = found.iter().filter_map(|one| Some((one.range.order, one.witness.as_ref()?)));
    witness.map(|(order, witness)| (order, witness.inside)).collect()
}

/// The claim, what stands in its block, and what is put there.
const CHANGES: [(usize, &str, &str); 10] = [
    (3, "at ", "contraction 99999 nonsense\n  at "),
    (3, "refuted", "confirmed"),
    (3, "at ", "at 1/10 # "),
    (3, "at ", "at 1/2 # "),
    (3, "vertex 6", "vertex 5"),
    (3, "valences 6", "valences 5"),
    (3, "smoothness 1", "smoothness 0"),
    (3, "variable b", "variable beta"),
    (2, "at ", "at 1/10 # "),
    (5, "vertex 3", "vertex 7"),
];

#[test]
fn ranges_of_rules_are_judged_and_refutations_certified() {
    let claims = claims();
    let paper = paper(&claims);
    let audit = judged(&paper);
    for (finding, (valences, states, verdict, _)) in audit.smoothness.iter().zip(&CLAIMS) {
        assert_eq!(
            finding.verdict.word().name(),
            *verdict,
            "{valences}, {states}: {:?}",
            finding.known
        );
    }
    assert_eq!(witnesses(&audit.smoothness[2]), [(6, false)]);
    assert_eq!(witnesses(&audit.smoothness[3]), [(6, true)]);
    assert_eq!(witnesses(&audit.smoothness[5])[0], (3, true));
    let written = certificate(&audit);
    let text = format!("{HEAD}{claims}");
    let report = check(&text, &[&written.text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    for ((_, id, outcome), (.., certified)) in report.claims.iter().zip(&CLAIMS) {
        assert_eq!(matches!(outcome, Outcome::Valid), *certified, "{id}: {outcome:?}");
    }
    let block = |place: usize| {
        let begin = written.text.find(&format!("range c{place}\n")).expect("a block");
        let lines = written.text[begin..].lines().enumerate();
        let own = lines.take_while(|(place, line)| *place == 0 || line.starts_with(' '));
        own.fold(String::new(), |text, (_, line)| text + line + "\n")
    };
    let outcome = |place: usize, block: &str| {
        let changed = format!("subcert-certificate 4\npaper k\n{block}end 1\n");
        let report = check(&text, &[&changed]).expect("a claim file");
        let found = report.claims.into_iter().find(|(_, id, _)| *id == format!("c{place}"));
        found.expect("the claim").2
    };
    for (place, from, to) in CHANGES {
        let block = block(place).replacen(&format!("  {from}"), &format!("  {to}"), 1);
        let found = outcome(place, &block);
        assert!(
            matches!(found, Outcome::Invalid(..)),
            "{place}: {from} as {to}: {found:?}\n{block}"
        );
    }
    // What refutes a narrower or a wider claim does not refute the true one.
    for place in [2, 3] {
        let other = block(place).replacen(&format!("range c{place}"), "range c0", 1);
        assert!(matches!(outcome(0, &other), Outcome::Invalid(..)), "{other}");
    }
}

#[test]
fn what_cannot_be_a_range_of_rules_is_refused() {
    let own = "scheme = 'own:beta=b'\nsmoothness = '1'\nfrom = '1/40'";
    for (states, said) in [
        (
            "scheme = 'own:beta=b'\nsmoothness = '2'\nvalences = '6'\nfrom = '1/40'".to_owned(),
            "C^1",
        ),
        (own.to_owned(), "N"),
        (format!("{own}\nvalences = '2'"), "does not name valences"),
        (
            "scheme = 'four-point:w=b'\nsmoothness = '1'\nvalences = '6'\nfrom = '0'".to_owned(),
            "of a mask",
        ),
        (
            "scheme = 'chaikin'\nvalue = 'b'\nbelow = '1'\nvalences = '6'\nfrom = '0'".to_owned(),
            "beside",
        ),
        (
            "scheme = 'own:N=6,beta=b'\nsmoothness = '1'\nvalences = '6'\nfrom = '1/40'".to_owned(),
            "valence",
        ),
    ] {
        let source =
            format!("{HEAD}{SCHEME}[[range]]\nid = 'c'\nlocus = ''\nvariable = 'b'\n{states}\n");
        let source = subcert::diagnostic::SourceText::new("k.toml", source);
        let error = match subcert::claim::read_paper(&source) {
            Err(error) => error.to_string(),
            Ok(paper) => match subcert::audit::audit(&paper) {
                Err(error) => error.to_string(),
                Ok(_) => panic!("{states}"),
            },
        };
        assert!(error.contains(said), "{states}: {error}");
    }
}
