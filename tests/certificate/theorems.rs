//! Certificates of theorems and promises, and of wrong ones, before the checker.

use subcert::audit::{Kept, PaperAudit, Place, TheoremVerdict, Violation, audit};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert_check::{Outcome, check};

/// Theorems that are false for curves at an offset, for nets of two schemes, and for rings,
/// with and without an interpolant; and tables whose promises are kept, or not.
const CLAIMS: &str = r#"
key = "theorems"
[paper]
authors = []
title = ""
venue = ""
year = ""
[define]
T = 'contraction(1)'
[[scheme]]
name = "skew"
parameters.w = { about = "a weight" }
mask = [['1/2', '1/2 - w', 'w'], ['1/4', '1/4', '1/2'], ['0', '1', '0']]
offset = '-1'
[[scheme]]
name = "keep"
parameters.N = { about = "valence" }
orbits = { vertex = '1', edge = 'N', face = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'face[i]'], ['face[i]', 'edge[i + 1]']]
weights.vertex = { vertex = '1' }
weights.edge = { vertex = '1/2', edge = 'kronecker(i, j)/2' }
weights.face = { vertex = '1/2', face = 'kronecker(i, j)/2' }
[[theorem]]
id = "distance"
locus = ""
title = ""
scheme = "skew:w=v"
values.v = ['1/5', '1/8']
bounds = "distance"
by = 'beta*T^k/10'
from = '1'
rests = []
[[theorem]]
id = "moved"
locus = ""
title = ""
scheme = "skew:w=1/8"
offset = '2'
bounds = "step"
by = 'beta/10'
from = '1'
[[theorem]]
id = "difference"
locus = ""
title = ""
schemes = ["quinary-three-point"]
bounds = "difference"
by = 'beta*contraction(2)^k'
from = '1'
[[theorem]]
id = "depth"
locus = ""
title = ""
schemes = ["six-point:w=w"]
values.w = ['1/100']
bounds = "depth"
by = 'levels(1/2, 20*epsilon/beta)'
[[theorem]]
id = "net-difference"
locus = ""
title = ""
schemes = ["chaikin x ternary-four-point:mu=1/3"]
bounds = "difference"
by = '(beta_1 + beta_2)*(1/4)^k'
from = '0'
[[theorem]]
id = "net-step"
locus = ""
title = ""
schemes = ["skew:w=1/8 x chaikin"]
bounds = "step"
by = '(beta_1 + 2*beta_2 + beta_3)/100'
from = '0'
[[theorem]]
id = "net-distance"
locus = ""
title = ""
schemes = ["chaikin x skew:w=1/8"]
bounds = "distance"
by = '(beta_1 + 2*beta_2 + beta_3)/100'
from = '1'
[[theorem]]
id = "ring-difference"
locus = ""
title = ""
schemes = ["catmull-clark:N=5"]
bounds = "difference"
by = 'beta/3^k'
from = '1'
[[theorem]]
id = "ring-step"
locus = ""
title = ""
schemes = ["bajaj:N=n", "catmull-clark:N=n"]
values.n = ['5', '3']
interpolant = "keep:N=n"
bounds = "step"
by = 'beta/100'
from = '0'
[[theorem]]
id = "ring-distance"
locus = ""
title = ""
schemes = ["doo-sabin:n=7"]
bounds = "distance"
by = 'beta*cos(2*pi/7)/4^k'
from = '1'
[[theorem]]
id = "ring-kept"
locus = ""
title = ""
schemes = ["catmull-clark:N=3"]
interpolant = "keep:N=3"
bounds = "distance"
by = 'beta/100'
from = '0'
[[theorem]]
id = "true"
locus = ""
title = ""
schemes = ["chaikin"]
bounds = "difference"
by = 'beta*T^k'
from = '0'
[[table]]
id = "curve"
locus = ""
title = ""
scheme = "skew:w=1/8"
value = 'scale*x'
unstated = { scale = '1/3' }
promise = { level = 'k', spread = 'scale' }
rows = { name = "x", values = ['6/5', '0.001'] }
columns = { name = "k", values = ['0', '1'] }
cells = [['0.4', '0.4'], ['0.000', '0.000']]
[[table]]
id = "net"
locus = ""
title = ""
scheme = "quinary-three-point x quinary-three-point"
value = 'levels(1/5, epsilon/100)'
promise = { tolerance = 'epsilon', spread = '1', offset = '0' }
columns = { name = "epsilon", values = ['1/10', '1/2'] }
cells = [['4', '1']]
[[table]]
id = "ring"
locus = ""
title = ""
value = 'levels(1/2, epsilon)'
promise = { tolerance = 'epsilon', spread = '2', ring = 'doo-sabin:n=n' }
rows = { name = "n", values = ['4', '5'] }
columns = { name = "epsilon", values = ['1/10', '1/100'] }
cells = [['4', '7'], ['9', '7']]
"#;

fn paper() -> Paper {
    read_paper(&SourceText::new("test", CLAIMS)).expect("a claim file")
}

/// What the checker says of a claim of an audit.
fn outcome(audit: &PaperAudit<'_>, id: &str) -> Outcome {
    let written = certificate(audit);
    let report = check(&audit.paper.source.text, &[&written.text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    let claim = report.claims.into_iter().find(|(_, claim, _)| claim == id);
    claim.expect("a claim of this id").2
}

#[test]
fn refuted_theorems_have_valid_certificates() {
    let paper = paper();
    let audit = audit(&paper).expect("an audit");
    for finding in &audit.theorems {
        let id = &finding.theorem.id;
        let outcome = outcome(&audit, id);
        if id == "true" {
            assert_eq!(finding.verdict, TheoremVerdict::Open, "{id}");
            assert!(matches!(outcome, Outcome::Incomplete(Some(_))), "{id}: {outcome:?}");
        } else {
            assert_eq!(finding.verdict, TheoremVerdict::Refuted, "{id}");
            assert_eq!(outcome, Outcome::Valid, "{id}: {}", certificate(&audit).text);
        }
    }
}

/// A change, and what it is.
type Change<'c> = (&'static str, &'c dyn Fn(&mut Violation));

#[test]
fn wrong_refutations_are_rejected() {
    let paper = paper();
    let right = audit(&paper).expect("an audit");
    let rejected = |audit: &PaperAudit<'_>, id: &str, what: &str| {
        let outcome = outcome(audit, id);
        assert!(matches!(outcome, Outcome::Invalid(..)), "{id}, {what}: {outcome:?}");
    };
    let mut altered = audit(&paper).expect("an audit");
    let one = RealCyclotomic::from(Rational::one());
    for (place, finding) in right.theorems.iter().enumerate() {
        let id = &finding.theorem.id;
        if finding.refutation.is_none() {
            altered.theorems[place].refutation.clone_from(&right.theorems[0].refutation);
            rejected(&altered, id, "the refutation of another theorem");
        }
        let Some(kept) = &finding.refutation else { continue };
        let changes: [Change<'_>; 4] = [
            ("a larger value", &|wrong| wrong.attained.value = &wrong.attained.value + &one),
            ("a larger bound", &|wrong| wrong.bound = &wrong.bound + &one),
            ("another level", &|wrong| wrong.level += 1),
            ("another place", &|wrong| wrong.attained.place = elsewhere(&wrong.attained.place)),
        ];
        for (what, change) in changes {
            let mut refutation = kept.clone();
            change(&mut refutation.violation);
            altered.theorems[place].refutation = Some(refutation);
            rejected(&altered, id, what);
        }
        altered.theorems[place].refutation = Some(kept.clone());
    }
}

fn elsewhere(place: &Place) -> Place {
    match place {
        Place::Parameter(t) => Place::Parameter(t + &Rational::from(50)),
        Place::Parameters([s, t]) => Place::Parameters([s + &Rational::from(50), t.clone()]),
        Place::Point(i) => Place::Point(i + 50),
        Place::Difference(i) => Place::Difference(i + 50),
        Place::Points([i, j]) => Place::Points([i + 50, *j]),
        Place::Along(at, axis) => Place::Along(*at, 1 - axis),
        Place::Named(_) => Place::Named("nowhere".to_owned()),
        Place::Edge([a, _]) => Place::Edge([a.clone(), a.clone()]),
    }
}

#[test]
fn promises_are_checked() {
    let paper = paper();
    let right = audit(&paper).expect("an audit");
    let counts = |kept: fn(&Kept) -> bool| {
        let cells = right.tables.iter().flat_map(|table| table.cells.iter().flatten());
        cells.filter(|cell| cell.kept.as_ref().is_some_and(kept)).count()
    };
    assert!(counts(|kept| *kept == Kept::Yes) >= 3);
    assert!(counts(|kept| matches!(kept, Kept::No(_))) >= 4);
    assert!(certificate(&right).text.contains("\n  flow "));
    let mut altered = audit(&paper).expect("an audit");
    for (table, id) in ["curve", "net", "ring"].into_iter().enumerate() {
        assert_eq!(outcome(&right, id), Outcome::Valid, "{}", certificate(&right).text);
        let rows = right.tables[table].cells.len();
        for row in 0..rows {
            for column in 0..right.tables[table].cells[row].len() {
                let kept = right.tables[table].cells[row][column].kept.clone();
                let cell = |audit: &mut PaperAudit<'_>, kept| {
                    audit.tables[table].cells[row][column].kept = kept;
                };
                if let Some(Kept::No(broken)) = &kept {
                    let mut broken = broken.clone();
                    broken.distance = &broken.distance + &RealCyclotomic::from(Rational::one());
                    cell(&mut altered, Some(Kept::No(broken)));
                    let refused = outcome(&altered, id);
                    assert!(matches!(refused, Outcome::Invalid(..)), "{id}: {refused:?}");
                    if id == "ring" {
                        // No flow costs little enough.
                        cell(&mut altered, Some(Kept::Yes));
                        let refused = outcome(&altered, id);
                        assert!(matches!(refused, Outcome::Invalid(..)), "{id}: {refused:?}");
                    }
                }
                cell(&mut altered, kept);
            }
        }
    }
}

/// A mask of which the first T_c < 1 has more than 4,096 residue classes: the certificate of a
/// theorem that it refutes shows that it converges.
#[test]
fn a_scheme_that_converges_late_refutes_a_theorem() {
    let claims = r#"
        key = "late"
        [paper]
        authors = []
        title = ""
        venue = ""
        year = ""
        [[scheme]]
        name = "late"
        mask = [['3/16', '1/4', '9/16'], ['15/16', '1/3', '-13/48'], ['7/24', '0', '17/24']]
        [[theorem]]
        id = "deep"
        locus = ""
        title = ""
        schemes = ["late"]
        bounds = "distance"
        by = 'beta/100'
        from = '1'
    "#;
    let paper = read_paper(&SourceText::new("late.toml", claims)).unwrap();
    let audit = audit(&paper).unwrap();
    assert_eq!(audit.theorems[0].verdict, TheoremVerdict::Refuted);
    let certificate = certificate(&audit).text;
    assert!(certificate.contains("\n  constant "), "{certificate}");
    let report = check(claims, &[&certificate]).expect("a claim file");
    let valid = report.claims.iter().all(|(.., outcome)| matches!(outcome, Outcome::Valid));
    assert!(valid, "{:?}", report.claims);
}
