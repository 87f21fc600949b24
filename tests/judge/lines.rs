//! Readings of single rows and columns, slips under a reading, and tables that
//! contradict each other.

use proptest::prelude::*;
use subcert::audit::{Contradiction, Line, PaperAudit, Search, Slip, Verdict, audit};
use subcert::bound::{Constants, Operator, Order};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, format::fixed};
use subcert::scheme::{Scheme, parse_scheme};
use subcert_check::{Outcome, check};

/// A paper of tables with rows n and columns c, each with an id, a formula, more keys
/// and cells.
fn paper(tables: &[(&str, &str, &str, &[Vec<String>])]) -> Paper {
    let mut text =
        "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n".to_owned();
    for (id, value, rest, cells) in tables {
        let list = |count: usize| {
            (1..=count).map(|i| format!("'{i}'")).collect::<Vec<String>>().join(", ")
        };
        let row = |row: &Vec<String>| {
            let cells: Vec<String> = row.iter().map(|cell| format!("'{cell}'")).collect();
            format!("[{}]", cells.join(", "))
        };
        let rows: Vec<String> = cells.iter().map(row).collect();
        let table = format!(
            "[[table]]\nid = '{id}'\nlocus = 'Table {id}'\nscheme = 'quinary-three-point'\n\
             value = '{value}'\n{rest}\nrows = {{ name = 'r', values = [{}] }}\n\
             columns = {{ name = 'c', values = [{}] }}\ncells = [{}]\n",
            list(cells.len()),
            list(cells[0].len()),
            rows.join(", "),
        );
        text.push_str(&table);
    }
    read_paper(&SourceText::new("k.toml", text)).unwrap_or_else(|error| panic!("{error}"))
}

/// The audit, which its certificate proves.
fn judged(paper: &Paper) -> PaperAudit<'_> {
    let audit = audit(paper).unwrap_or_else(|error| panic!("{error}"));
    let written = certificate(&audit);
    assert_eq!(written.omitted, []);
    let report = check(&paper.source.text, &[&written.text]).expect("a claim file");
    for (_, id, outcome) in report.claims {
        assert_eq!(outcome, Outcome::Valid, "{id}: {}", written.text);
    }
    audit
}

/// T_c of the quinary 3-point scheme, whose two orders differ from c = 2 on.
fn contraction(c: u32, order: Order) -> Rational {
    let Ok(Scheme::Curve(mask)) = parse_scheme("quinary-three-point") else { panic!("a curve") };
    Constants::new(mask).norm(Operator::Difference, c, order).expect("few classes")
}

const VALUE: &str = "contraction(c, order = adjoint)*r";

fn cells(rows: i64, forward: impl Fn(i64) -> bool) -> Vec<Vec<String>> {
    let row = |r: i64| {
        let order = if forward(r) { Order::Forward } else { Order::Adjoint };
        (1..=4).map(|c| fixed(&(contraction(c, order) * Rational::from(r)), 7)).collect()
    };
    (1..=rows).map(row).collect()
}

fn search<'s>(audit: &'s PaperAudit<'_>) -> &'s Search {
    audit.tables[0].search.as_ref().expect("a search")
}

/// The rows before row 2 of three are as printed, or all cells are nonsense but those of
/// that row: its own reading is found, and only it.
#[test]
fn a_row_with_its_own_reading() {
    assert_ne!(contraction(2, Order::Forward), contraction(2, Order::Adjoint));
    let hidden = cells(3, |r| r == 2);
    let mut nonsense = hidden.clone();
    for (column, cell) in ["0.3141593", "0.2718282", "0.5772157", "0.6931472"].iter().enumerate() {
        nonsense[0][column] = (*cell).to_owned();
        nonsense[2][column] = cell.replace('2', "4");
    }
    for cells in [hidden, nonsense] {
        let paper = paper(&[("t", VALUE, "", &cells)]);
        let audit = judged(&paper);
        let search = search(&audit);
        // Row 2 has one cell that both orders give.
        let read = |column: usize| &audit.tables[0].cells[1][column];
        assert_eq!(read(0).verdict, Verdict::Confirmed);
        for column in 1..4 {
            assert_eq!(read(column).verdict, Verdict::OtherReading);
            assert_eq!(read(column).as_read.as_ref().unwrap().differs(), "masks read forwards");
        }
        let lines: Vec<(Line, usize)> =
            search.lines.iter().map(|line| (line.line, line.best.count())).collect();
        let whole = search.best.first().map_or(0, subcert::audit::Explanation::count);
        assert!(lines == [(Line::Row(1), 3)] || (lines.is_empty() && whole == 4), "{lines:?}");
    }
}

/// A row that is shifted by a column, under the reading of the table, is a misprint.
#[test]
fn a_shifted_row_and_an_exchanged_pair() {
    let mut cells = cells(4, |_| true);
    let first = cells[1].remove(0);
    cells[1].push(first);
    cells[3].swap(1, 2);
    let paper = paper(&[("t", VALUE, "", &cells)]);
    let audit = judged(&paper);
    let verdict = |row: usize, column: usize| &audit.tables[0].cells[row][column].verdict;
    for column in 0..3 {
        assert_eq!(*verdict(1, column), Verdict::Misprint(Slip::Neighbour(0, 1)));
    }
    assert_eq!(*verdict(3, 1), Verdict::Misprint(Slip::Exchanged(0, 1)));
    assert_eq!(*verdict(3, 2), Verdict::Misprint(Slip::Exchanged(0, -1)));
}

fn about(contradictions: &[Contradiction]) -> Vec<(&str, Vec<String>)> {
    contradictions
        .iter()
        .map(|one| (one.about.as_str(), one.sides.iter().map(|s| s.needs.to_string()).collect()))
        .collect()
}

fn says(words: [&str; 2]) -> Vec<String> {
    words.map(str::to_owned).to_vec()
}

/// One table needs the masks forwards and β = 1/5, the other backwards and β = 3/7.
#[test]
fn tables_that_contradict_each_other_and_tables_that_agree() {
    let value = "contraction(c, order = adjoint)*r*beta";
    let rest = "unstated = ['beta']";
    let scaled = |order: Order, beta: &Rational| -> Vec<Vec<String>> {
        let cell = |r: i64, c: u32| fixed(&(contraction(c, order) * Rational::from(r) * beta), 7);
        (1..=3).map(|r| (1..=4).map(|c| cell(r, c)).collect()).collect()
    };
    let (fifth, other) = (Rational::new(1, 5), Rational::new(3, 7));
    let first = scaled(Order::Forward, &fifth);
    let second = scaled(Order::Adjoint, &other);
    let paper_of =
        |second: &[Vec<String>]| paper(&[("a", value, rest, &first), ("b", value, rest, second)]);
    let against = paper_of(&second);
    let audit = judged(&against);
    assert_eq!(
        about(&audit.contradictions),
        [
            ("order", says(["masks read backwards", "masks read forwards"])),
            ("beta", says(["beta = 1/5", "beta = 3/7"])),
        ]
    );
    let place = &audit.contradictions[0].sides[1].places[0];
    assert_eq!((place.table.as_str(), place.explained), ("a", 12));
    assert!(place.otherwise < 11, "{place:?}");
    assert!(judged(&paper_of(&first)).contradictions.is_empty());
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// Rows of random digits are explained by no reading, of the table or of a row.
    #[test]
    fn random_rows_are_not_explained(
        digits in prop::collection::vec(prop::collection::vec(1000_i64..10_000, 4), 3),
    ) {
        let cell = |digits: &i64| format!("0.{digits}");
        let cells: Vec<Vec<String>> =
            digits.iter().map(|row| row.iter().map(cell).collect()).collect();
        let value = "contraction(c, order = adjoint)*tensor(c)*r*beta";
        let paper = paper(&[("t", value, "unstated = { beta = '1' }", &cells)]);
        let audit = judged(&paper);
        let search = search(&audit);
        prop_assert!(search.best.is_empty() && search.lines.is_empty());
    }
}
