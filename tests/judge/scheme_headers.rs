//! Tables whose headers are schemes, and names that hand on their parameters.

use subcert::audit::{CellFinding, Kept, PaperAudit, Verdict, audit};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, check};

const PAPER: &str = "key = 'k'\npaper = { authors = [], title = '', venue = '', year = '' }\n\
                     [define]\nT = 'contraction(c)'\ndepth = 'levels(contraction(1), epsilon)'\n\
                     [[scheme]]\nname = 'mine'\nuse = 'four-point:w=v'\n\
                     [[scheme]]\nname = 'twice'\nuse = 'mine:v=2*w'\n\
                     [[scheme]]\nname = 'plain'\nuse = 'six-point:w=w x chaikin'\n";

fn paper(tables: &str) -> Paper {
    read_paper(&SourceText::new("k.toml", format!("{PAPER}{tables}"))).expect("a file")
}

fn judged(paper: &Paper) -> PaperAudit<'_> {
    audit(paper).unwrap_or_else(|error| panic!("{error}"))
}

/// A table of constants T_c with these fields.
fn table(fields: &str, cells: &str) -> String {
    format!(
        "[[table]]\nid = 't'\nlocus = 'T'\nvalue = 'T'\npromise = {{ level = 'c', spread = '1' }}\n\
         {fields}\ncells = {cells}\n"
    )
}

/// What a cell is, whatever table it stands in.
fn of_cell(cell: &CellFinding) -> (Verdict, Option<String>, Option<bool>) {
    let kept = cell.kept.as_ref().map(|kept| matches!(kept, Kept::Yes));
    (cell.verdict.clone(), cell.exact.as_ref().map(ToString::to_string), kept)
}

const C: &str = "{ name = 'c', values = ['1', '2', '3'] }";

/// Each of these references, with printed T_1, T_2, T_3.
const ROWS: [(&str, &str); 4] = [
    ("chaikin", "['0.5', '0.25', '0.125']"),
    ("mine:v=1/16", "['0.625', '0.328', '0.177']"),
    ("twice:w=1/32", "['0.5', '0.25', '0.125']"),
    ("four-point:w=1/(8*(c + 1))", "['0.625', '0.3', '0.2']"),
];

#[test]
fn each_row_is_as_in_a_table_of_its_own() {
    let schemes = ROWS.map(|(scheme, _)| format!("'{scheme}'")).join(", ");
    let cells = ROWS.map(|(_, cells)| cells).join(", ");
    let rows = format!("rows = {{ schemes = [{schemes}] }}\ncolumns = {C}");
    let rows = paper(&table(&rows, &format!("[{cells}]")));
    let rows = judged(&rows);
    for ((scheme, cells), found) in ROWS.into_iter().zip(&rows.tables[0].cells) {
        let alone = format!("scheme = '{scheme}'\ncolumns = {C}");
        let alone = paper(&table(&alone, &format!("[{cells}]")));
        let alone = judged(&alone);
        for (column, cell) in found.iter().enumerate() {
            // The other rows count when one looks for readings, which no cell here has.
            assert_eq!(of_cell(cell), of_cell(&alone.tables[0].cells[0][column]), "{scheme}");
        }
    }
    let locus = &rows.tables[0].cells[1][2].locus;
    assert_eq!(locus, "T, scheme = mine:v=1/16, c = 3");
}

#[test]
fn columns_are_as_rows() {
    let table = |rows: &str, columns: &str, cells: &str| {
        format!(
            "[[table]]\nid = 't'\nlocus = 'T'\nvalue = 'depth'\nunstated = ['w']\n\
             promise = {{ tolerance = 'epsilon', spread = '1' }}\n\
             rows = {rows}\ncolumns = {columns}\ncells = {cells}\n"
        )
    };
    let schemes = "{ schemes = ['chaikin', 'mine:v=1/16', 'twice'] }";
    let epsilon = "{ name = 'epsilon', values = ['0.1', '0.01'] }";
    let rows = paper(&table(schemes, epsilon, "[['4', '7'], ['5', '10'], ['5', '9']]"));
    let columns = paper(&table(epsilon, schemes, "[['4', '5', '5'], ['7', '10', '9']]"));
    let (rows, columns) = (judged(&rows), judged(&columns));
    let mut open = 0;
    for (row, cells) in rows.tables[0].cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            assert_eq!(of_cell(cell), of_cell(&columns.tables[0].cells[column][row]));
            open += usize::from(cell.unknown.is_some() || !cell.assumed.is_empty());
        }
    }
    // Only the scheme with the parameter that is not stated needs it.
    assert_eq!(open, 2);
}

#[test]
fn their_certificates_are_accepted() {
    let schemes = "{ schemes = ['chaikin', { printed = 'Hexa', scheme = 'six-point:w=3/256' }] }";
    let rows = format!("rows = {schemes}\ncolumns = {C}");
    for cells in [
        "[['0.5', '0.25', '0.125'], ['0.695', '0.4', '0.2']]",
        "[['0.5', '0.2', '0.125'], ['0.695', '0.004', '0.2']]",
    ] {
        let paper = paper(&table(&rows, cells));
        let certificate = certificate(&judged(&paper)).text;
        let report = check(&paper.source.text, &[&certificate]).expect("a claim file");
        let valid = report.claims.iter().all(|(.., outcome)| *outcome == Outcome::Valid);
        assert!(valid && report.claims.len() == 1, "{certificate}");
    }
}

/// The error of a table of this scheme.
fn refused(scheme: &str) -> String {
    let paper = paper(&table(
        &format!("rows = {{ schemes = ['{scheme}'] }}\ncolumns = {C}"),
        "[['1', '1', '1']]",
    ));
    audit(&paper).expect_err(scheme).to_string()
}

#[test]
fn a_name_hands_on_no_other_parameter() {
    for (scheme, says) in [
        (
            "mine:w=1/16",
            "`mine` stands for `four-point:w=v`, and hands on no parameter `w`; it has: v",
        ),
        (
            "twice:v=1/16",
            "`twice` stands for `mine:v=2*w`, and hands on no parameter `v`; it has: w",
        ),
        ("plain:v=1", "it has: w"),
    ] {
        let error = refused(scheme);
        assert!(error.contains(says), "{error}");
        assert!(error.contains(&format!("'{scheme}'")), "{error}");
    }
}
