//! One claim judged with what it needs, against the audit of the whole paper; and what its cells are
//! computed from.

use crate::common::claims::{judged, paper};
use subcert::audit::{PaperAudit, audit_claim, by_hand, claims_needed, working};
use subcert::claim::{Paper, read_paper_file};
use subcert::exact::RealCyclotomic;

/// Two schemes with tables that leave w open, so that the second has it from the first; a table of a
/// third scheme; and a theorem that rests on an equation and on another theorem.
const CLAIMS: &str = "[define]\nT = 'contraction(c)'\n\
    [[table]]\nid = 'gives'\nlocus = 'Table 1'\nscheme = 'four-point:w=w'\nvalue = 'T'\n\
    unstated = ['w']\ncolumns = { name = 'c', values = ['1', '2', '3'] }\n\
    cells = [['0.586000', '0.300396', '0.150834']]\n\
    [[table]]\nid = 'takes'\nlocus = 'Table 2'\nscheme = 'six-point:w=w/4'\nvalue = 'T'\n\
    unstated = ['w']\ncolumns = { name = 'c', values = ['1', '2'] }\ncells = 'lost'\n\
    [[table]]\nid = 'apart'\nlocus = 'Table 3'\nscheme = 'chaikin'\nvalue = 'T'\n\
    columns = { name = 'c', values = ['1', '2'] }\ncells = [['0.5', '0.25']]\n\
    [[equation]]\nid = 'e'\nlocus = '(1)'\nleft = '1'\nright = '2'\n\
    [[equation]]\nid = 'f'\nlocus = '(2)'\nleft = '1'\nright = '1'\n\
    [[theorem]]\nid = 't'\nlocus = 'Theorem 1'\nsays = 'x'\nrests = ['e']\n\
    [[theorem]]\nid = 'u'\nlocus = 'Theorem 2'\nrests = ['t']\nscheme = 'chaikin'\n\
    bounds = 'difference'\nby = 'beta*T^k/2'\nfrom = '0'\nvalues.c = ['1']\n";

/// What an audit says of a claim.
fn said(audit: &PaperAudit<'_>, id: &str) -> String {
    let table = audit.tables.iter().find(|finding| finding.table.id == id);
    if let Some(finding) = table {
        return format!(
            "{:?} {:?} {:?}",
            finding.cells,
            finding.recovered,
            finding.searches().count()
        );
    }
    let equations = audit.equations.iter().filter(|finding| finding.equation.id == id);
    let equations = equations.map(|finding| format!("{:?}", finding.verdict));
    let functions = audit.functions.iter().filter(|finding| finding.claim.id == id);
    let functions = functions.map(|finding| format!("{:?}", finding.verdict));
    let ranges = audit.ranges.iter().filter(|finding| finding.claim.id == id);
    let ranges = ranges.map(|finding| String::from(finding.verdict()));
    let theorems = audit.theorems.iter().filter(|finding| finding.theorem.id == id);
    let theorems = theorems.map(|finding| {
        let hand = by_hand(audit, finding).expect("no error");
        format!("{:?} {:?} {:?} {hand:?}", finding.verdict, finding.failing, finding.cases)
    });
    equations.chain(functions).chain(ranges).chain(theorems).collect()
}

/// Every claim alone as in the whole audit; gives the number of tables that each took.
fn alone(paper: &Paper) -> Vec<(String, usize)> {
    let whole = judged(paper);
    let ids = whole.claims().into_iter().map(|claim| claim.id);
    let one = |id: &str| {
        let part = audit_claim(paper, id, &|| {}).expect("no error");
        assert!(!said(&whole, id).is_empty());
        assert_eq!(said(&part, id), said(&whole, id), "{id}");
        assert_eq!(part.findings().count(), claims_needed(paper, id), "{id}");
        (id.to_owned(), part.tables.len())
    };
    ids.map(one).collect()
}

#[test]
fn a_claim_is_judged_with_what_it_needs() {
    let counts = alone(&paper(CLAIMS));
    let tables = |id: &str| counts.iter().find(|(other, _)| other == id).expect(id).1;
    assert_eq!(["gives", "takes", "apart", "t", "u"].map(tables), [2, 2, 1, 0, 0]);
    for file in ["examples/first-paper.toml", "examples/my-paper.toml"] {
        let paper = read_paper_file(std::path::Path::new(file)).expect("a file").expect("claims");
        alone(&paper);
    }
}

/// The definition that a cell is said to equal has the value of the cell; what it is computed from
/// has the values of the headers, and that of w which was recovered.
#[test]
fn the_working_of_a_cell_ends_in_its_value() {
    let paper = paper(CLAIMS);
    let audit = judged(&paper);
    let mut seen = 0;
    for finding in &audit.tables {
        for (row, cells) in finding.cells.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let working = working(&audit, finding, (row, column)).expect("no error");
                let exact = cell.exact.clone().map(|exact| ("T".to_owned(), exact));
                assert_eq!(working.definitions, Vec::from_iter(exact), "{}", cell.id);
                let (name, c) = &working.parameters[0];
                let header = column + 1;
                assert!(name == "c" && c.to_string() == header.to_string(), "{}", cell.id);
                seen += 1;
            }
        }
    }
    assert_eq!(seen, 7);
    let first = working(&audit, &audit.tables[0], (0, 1)).expect("no error");
    let value: RealCyclotomic = crate::common::r(300_396, 1_000_000).into();
    let scheme: Vec<String> = first.scheme.iter().map(ToString::to_string).collect();
    assert_eq!(
        (scheme, &first.definitions[0].1),
        (vec!["four-point:w=43/1000".to_owned()], &value)
    );
}
