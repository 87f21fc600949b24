//! Theorems as claims: reading, and what they rest on.

use subcert::audit::{PaperAudit, TheoremFinding, Word, audit};
use subcert::claim::{Kind, Paper, Quantity, Statement, embedded, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

const HEAD: &str = "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n";

fn read(text: &str) -> Result<Paper, Diagnostic> {
    read_paper(&SourceText::new("k.toml", format!("{HEAD}{text}")))
}

fn paper(text: &str) -> Paper {
    read(text).unwrap_or_else(|error| panic!("{error}"))
}

fn equation(id: &str, right: &str) -> String {
    format!("[[equation]]\nid = '{id}'\nlocus = '({id})'\nleft = '1'\nright = '{right}'\n")
}

fn theorem(id: &str, rests: &str) -> String {
    format!("[[theorem]]\nid = '{id}'\nlocus = 'Theorem {id}'\nsays = 'x'\nrests = [{rests}]\n")
}

fn failing(audit: &PaperAudit<'_>, id: &str) -> Vec<String> {
    let found = |finding: &&TheoremFinding<'_>| finding.theorem.id == id;
    let finding = audit.theorems.iter().find(found).expect("the theorem");
    finding.failing.iter().map(|premise| premise.id.to_owned()).collect()
}

#[test]
fn what_is_bounded_and_from_which_level_on() {
    let paper = paper(
        "[[theorem]]\nid = 'a'\nlocus = 'Theorem 1'\nbounds = 'step'\nby = 'beta/2^k'\nfrom = '1'\n\
         [[theorem]]\nid = 'b'\nlocus = 'Theorem 2'\nbounds = 'depth'\nby = 'levels(1/2, epsilon)'\n\
         [[theorem]]\nid = 'c'\nlocus = 'Remark 1'\nsays = 'something else'\n",
    );
    let [step, depth, other] = &paper.theorems[..] else { panic!("three theorems") };
    assert!(matches!(
        &step.statement,
        Statement::Bound { quantity: Quantity::Step, by, from: 1 } if by.text == "beta/2^k"
    ));
    assert!(matches!(&depth.statement, Statement::Depth(by) if by.text == "levels(1/2, epsilon)"));
    assert!(matches!(&other.statement, Statement::Other(says) if says == "something else"));
}

/// A theorem rests on what it names, and on what the theorems that it names rest on.
#[test]
fn failing_premises_are_followed_through_theorems() {
    let text = [
        equation("right", "1"),
        equation("wrong", "2"),
        equation("unused", "2"),
        theorem("first", "'right', 'wrong'"),
        theorem("second", "'first'"),
        theorem("third", "'right'"),
        // Two theorems that rest on each other are followed once.
        theorem("fourth", "'fifth', 'wrong'"),
        theorem("fifth", "'fourth'"),
        "[[table]]\nid = 'table'\nlocus = 'T'\nvalue = '1'\n\
         columns = { name = 'c', values = ['1', '2'] }\ncells = [['1', '5']]\n"
            .to_owned(),
        theorem("sixth", "'table', 'second'"),
    ];
    let paper = paper(&text.concat());
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(failing(&audit, "first"), ["wrong"]);
    assert_eq!(failing(&audit, "second"), ["wrong"]);
    assert!(failing(&audit, "third").is_empty());
    assert_eq!(failing(&audit, "fifth"), ["wrong"]);
    assert_eq!(failing(&audit, "sixth"), ["table", "wrong"]);
    assert_eq!(audit.tally(&[Kind::Theorem]).of(Word::Open), 6);
}

#[test]
fn malformed_theorems() {
    let bound = "bounds = 'distance'\nby = 'beta/2^k'\nfrom = '0'\n";
    let cases: [(&str, &str, &str); 10] = [
        ("", "needs `bounds` and `by`, or `says`", "'t'"),
        ("bounds = 'distance'\n", "needs `bounds` and `by`, or `says`", "'t'"),
        (&format!("{bound}says = 'x'\n"), "needs `bounds` and `by`, or `says`", "'t'"),
        (&bound.replace("distance", "distanse"), "`distanse` is nothing to bound", "'distanse'"),
        (&bound.replace("from = '0'\n", ""), "needs the first level", "'distance'"),
        (&bound.replace("'0'", "'-1'"), "`-1` is not a level", "'-1'"),
        (&bound.replace("distance", "depth"), "a depth has no first level", "'0'"),
        (&bound.replace("2^k", "2^"), "expected a number", ""),
        ("says = 'x'\nrests = ['e']\n", "`e` is no other claim", "'e'"),
        ("says = 'x'\nrests = ['t']\n", "`t` is no other claim", "'t'"),
    ];
    for (text, message, place) in cases {
        let text = format!("[[theorem]]\nid = 't'\nlocus = 'l'\n{text}");
        let error = read(&text).err().unwrap_or_else(|| panic!("{text}: no error"));
        assert!(error.to_string().contains(message), "no `{message}` in: {error}");
        let underlined = &error.source.text[error.span.clone()];
        assert!(place.is_empty() || underlined == place, "{underlined}: {error}");
    }
}

/// Every bound of the embedded papers has a value, at a scheme of its kind and at plain
/// values of its parameters, and no bound of a distance or step grows with the level.
#[test]
fn bounds_of_the_papers_have_values() {
    for embedded in embedded() {
        let example = match embedded.key {
            "mustafa2007-ternary" => "ternary-four-point-approximating",
            "khan2019-newton" => "newton:j=0,n=3",
            _ => "six-point:w=3/256",
        };
        let source = SourceText::new(embedded.key, embedded.text);
        let paper = read_paper(&source).unwrap_or_else(|error| panic!("{error}"));
        for theorem in &paper.theorems {
            let (Statement::Bound { by, .. } | Statement::Depth(by)) = &theorem.statement else {
                continue;
            };
            let scheme = theorem.scheme.as_ref().map(|scheme| scheme.reference.to_string());
            let table = format!(
                "[[table]]\nid = 'values'\nlocus = 'none'\nscheme = '{}'\nvalue = '{}'\n\
                 given = {{ beta = '1', beta_1 = '1', beta_2 = '1', beta_3 = '1', c = '1', \
                 epsilon = '1/100', alpha_2 = '1/4', mu = '-1/3', n = '3' }}\n\
                 columns = {{ name = 'k', values = ['1', '2', '3'] }}\ncells = 'lost'\n",
                scheme.as_deref().unwrap_or(example),
                by.text
            );
            let text = format!("{}\n{table}", embedded.text);
            let mut paper = read_paper(&SourceText::new(embedded.key, text))
                .unwrap_or_else(|error| panic!("{error}"));
            paper.tables.retain(|table| table.id == "values");
            paper.equations.clear();
            paper.theorems.clear();
            let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
            let cells = &audit.tables[0].cells[0];
            let values: Vec<_> = cells.iter().filter_map(|cell| cell.exact.clone()).collect();
            assert_eq!(values.len(), 3, "{}: {:?}", theorem.id, cells[0].undefined);
            // The sums of Theorem 3 of Khan et al. 2022 are empty or 0 for n = 3.
            assert!(values[2] <= values[0] && values[2].sign() >= 0, "{}: {values:?}", theorem.id);
        }
    }
}
