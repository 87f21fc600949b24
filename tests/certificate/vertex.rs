//! Claims about surfaces at a vertex or on a face: their verdicts, their certificates, and certificates that are changed.

use crate::common::claims::{HEAD, judged, paper};
use subcert::certificate::certificate;
use subcert_check::{Outcome, check};

/// Schemes with own weights, and claims with their expected verdicts.
const SCHEMES: &str = r"
[[scheme]]
name = 'heavy'
parameters.N = {}
orbits = { vertex = '1', edge = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]
weights.vertex = { vertex = '19/20', edge = '1/20/N' }
weights.edge = { vertex = '3/8', edge = '(3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8' }
let = { turn = 'mod(j - i, N)' }
[[scheme]]
name = 'edges'
parameters = { N = {}, l = {} }
orbits = { vertex = '1', edge = 'N', corner = 'N', outer = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]'], ['edge[i]', 'corner[i]'], ['edge[i]', 'outer[i]']]
weights.corner = { vertex = '1/8', edge = '3*(here + next)/8', corner = 'here/8' }
weights.outer = { vertex = '1/16', edge = '5*here/8 + (next + last)/16', corner = '(here + last)/16', outer = 'here/16' }
weights.vertex = { vertex = '5/8', edge = '3/8/N' }
weights.edge = { vertex = '3/8', edge = 'kronecker(turn, 0)/8 + (1/2 + (2*l - 1/4)*cos(2*pi*turn/N) + cos(4*pi*turn/N)/4)/N' }
let = { turn = 'mod(j - i, N)', here = 'kronecker(turn, 0)', next = 'kronecker(turn, 1)', last = 'kronecker(turn, N - 1)' }
[[scheme]]
name = 'folding'
parameters.n = {}
orbits = { face = 'n' }
edges = [['face[i]', 'face[i + 1]']]
weights.face = { face = '1/n/10 + 9/10*kronecker(i, j)' }
[[scheme]]
name = 'face'
parameters = { l = {}, m = {} }
orbits = { face = '5' }
edges = [['face[i]', 'face[i + 1]']]
weights.face = { face = '(1 + 2*l*cos(2*pi*(j - i)/5) + 2*m*cos(4*pi*(j - i)/5))/5' }
";

/// Claims: scheme, valences, what is stated, and the verdict.
const CLAIMS: [(&str, &str, &str, &str, bool); 24] = [
    ("catmull-clark", "3..8", "continuous = '1'", "confirmed", true),
    ("loop", "3..8", "continuous = '1'", "confirmed", true),
    ("loop-warren", "3..5", "continuous = '1'", "confirmed", true),
    ("doo-sabin", "3..8", "continuous = '1'", "confirmed", true),
    ("loop:N=5", "", "continuous = '1'", "confirmed", true),
    ("loop:N=5", "", "not_continuous = '1'", "refuted", true),
    ("loop", "all", "continuous = '1'", "confirmed", true),
    ("heavy", "all", "continuous = '1'", "refuted", true),
    ("heavy", "6", "not_continuous = '1'", "confirmed", true),
    ("folding:n=3", "", "continuous = '1'", "refuted", true),
    ("face:l=1/2,m=1/5", "", "continuous = '1'", "confirmed", true),
    ("face:l=3/10,m=1/2", "", "not_continuous = '1'", "confirmed", true),
    ("face:l=-1/2,m=1/5", "", "continuous = '1'", "refuted", true),
    ("face:l=1/2,m=1/2", "", "continuous = '1'", "open", false),
    ("sqrt3", "5", "continuous = '1'", "open", false),
    ("loop", "7", "not_continuous = '2'", "confirmed", false),
    ("face:l=3/2,m=1/5", "", "continuous = '0'", "open", false),
    ("face:l=1/2,m=-3/2", "", "continuous = '1'", "refuted", true),
    ("face:l=1,m=1/5", "", "not_continuous = '1'", "confirmed", false),
    ("edges:N=7,l=1/2", "", "continuous = '1'", "confirmed", true),
    ("edges:N=7,l=99/100", "", "not_continuous = '1'", "confirmed", true),
    // The valence stands in the reference.
    ("loop-weight:beta=3/(8*N)", "4..6", "continuous = '1'", "confirmed", true),
    ("loop-weight:beta=(n-3)/8", "4", "continuous = '1'", "confirmed", true),
    (
        "loop-weight:beta=kronecker(N, 4)/16 + kronecker(N, 5)",
        "4..5",
        "continuous = '1'",
        "refuted",
        true,
    ),
];

fn claims() -> String {
    let claim = |(place, (scheme, valences, states, ..)): (
        usize,
        &(&str, &str, &str, &str, bool),
    )| {
        let valences =
            if valences.is_empty() { String::new() } else { format!("valences = '{valences}'\n") };
        format!(
            "[[smoothness]]\nid = 'c{place}'\nlocus = ''\nscheme = '{scheme}'\n{valences}{states}\n"
        )
    };
    format!("{SCHEMES}{}", CLAIMS.iter().enumerate().map(claim).collect::<String>())
}

/// The line that is changed first, what stands there, and what is put there.
const CHANGES: [(&str, &str, &str); 31] = [
    ("c4", "vertex 5", "vertex 6"),
    ("c4", "part box-spline", "part bicubic"),
    ("c4", "eigenvalue 1", "eigenvalue 2"),
    ("c4", "eigenvalue 1", "eigenvalue 0"),
    ("c4", "eigenvalue 1 ", "eigenvalue 1 1/"),
    ("c4", "below ", "below 1/100000"),
    ("c4", "below ", "below 9"),
    ("c4", "below ", "below -"),
    ("c4", "jacobian +", "jacobian -"),
    ("c4", "box 0 -", "box 0 0"),
    ("c4", "box 0 -", "box 1 -"),
    ("c4", "box 1 - ", "box 1 - 9999"),
    ("c4", "box 1 - ", "box 1 - -"),
    ("c4", "box 2 -", "# box 2 -"),
    ("c4", "confirmed", "refuted"),
    ("c4", "scheme loop:N=5", "scheme loop:N=6"),
    ("c4", "states-continuous 1", "states-continuous 0"),
    ("c5", "refuted", "confirmed"),
    ("c0", "valences 3..8", "valences 3..9"),
    ("c0", "vertex 4", "vertex 5"),
    ("c7", "outer", "jacobian +"),
    ("c9", "positive ", "positive 1"),
    ("c9", "positive ", "negative "),
    ("c11", "eigenvalue 2", "eigenvalue 1"),
    ("c19", "box 11 -", "# box 11 -"),
    ("c19", "box 3 - ", "box 3 - 9"),
    ("c20", "positive ", "negative "),
    ("c17", "diverges 2 -", "diverges 2 +"),
    ("c17", "diverges 2 -", "diverges 1 -"),
    ("c17", "diverges 2 -", "diverges 3 -"),
    ("c17", "diverges 2 -", "diverges 2 - 1"),
];

#[test]
fn claims_are_judged_and_certified_and_changed_certificates_are_rejected() {
    let claims = claims();
    let paper = paper(&claims);
    let audit = judged(&paper);
    for (finding, (scheme, valences, states, verdict, _)) in audit.smoothness.iter().zip(&CLAIMS) {
        assert_eq!(
            finding.verdict.word().name(),
            *verdict,
            "{scheme} {valences} {states}: {:?}",
            finding.known
        );
    }
    let written = certificate(&audit);
    let text = format!("{HEAD}{claims}");
    let report = check(&text, &[&written.text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    for ((_, id, outcome), (scheme, _, states, _, certified)) in report.claims.iter().zip(&CLAIMS) {
        let valid = matches!(outcome, Outcome::Valid | Outcome::Cited(_));
        assert_eq!(matches!(outcome, Outcome::Cited(_)), *id == "c6", "{id}: {outcome:?}");
        assert_eq!(valid, *certified, "{id}, {scheme}, {states}: {outcome:?}");
    }
    for (id, from, to) in CHANGES {
        // The block of this claim alone.
        let begin = written.text.find(&format!("smoothness {id}\n")).expect("a block");
        let lines = written.text[begin..].lines().enumerate();
        let own = lines.take_while(|(place, line)| *place == 0 || line.starts_with(' '));
        let block: String = own.fold(String::new(), |text, (_, line)| text + line + "\n");
        let at = block.find(from).unwrap_or_else(|| panic!("{id}: {from}"));
        let block = format!("{}{to}{}", &block[..at], &block[at + from.len()..]);
        let changed = format!("subcert-certificate 4\npaper k\n{block}end 1\n");
        let report = check(&text, &[&changed]).expect("a claim file");
        let found = report.claims.iter().find(|(_, claim, _)| claim == id).expect("the claim");
        assert!(matches!(found.2, Outcome::Invalid(..)), "{id}: {from} as {to}: {:?}", found.2);
    }
}

#[test]
fn what_has_no_valences_is_refused() {
    for (claim, said) in [
        ("scheme = 'chaikin'\ncontinuous = '1'\nvalences = '5'", "of a mask"),
        ("scheme = 'loop'\ncontinuous = '1'\nvalences = '2'", "does not name valences"),
        ("scheme = 'loop'\ncontinuous = '1'\nvalences = '9..5'", "does not name valences"),
        ("scheme = 'loop'\ncontinuous = '1'\nvalences = '3..1000'", "does not name valences"),
        ("scheme = 'loop:N=5'\ncontinuous = '1'\nvalences = '5'", "valence"),
        ("scheme = 'loop-weight:beta=3/(8*N)'\ncontinuous = '1'", "unknown name `N`"),
        ("scheme = 'loop'\ncontinuous = '1'", "N"),
    ] {
        let source = format!("{HEAD}[[smoothness]]\nid = 'c'\nlocus = ''\n{claim}\n");
        let source = subcert::diagnostic::SourceText::new("k.toml", source);
        let error = match subcert::claim::read_paper(&source) {
            Err(error) => error.to_string(),
            Ok(paper) => match subcert::audit::audit(&paper) {
                Err(error) => error.to_string(),
                Ok(_) => panic!("{claim}"),
            },
        };
        assert!(error.contains(said), "{claim}: {error}");
        assert_eq!(error.matches("error: ").count(), 1, "{claim}: {error}");
    }
}
