//! Headers of tables: numbers, or schemes.

use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

const PAPER: &str = "key = 'axes'\npaper = { authors = [], title = '', venue = '', year = '' }\n";

/// A file with one table with these fields.
fn read(fields: &str) -> Result<Paper, Diagnostic> {
    let table = "[[table]]\nid = 't'\nlocus = ''\nvalue = 'contraction(c)'\n";
    read_paper(&SourceText::new("axes.toml", format!("{PAPER}{table}{fields}\n")))
}

const C: &str = "{ name = 'c', values = ['1', '2'] }";
const SCHEMES: &str = "{ schemes = ['chaikin', \
                       { printed = 'Hexa', scheme = 'six-point:w=c/100', note = 'so called' }] }";

/// The scheme of each cell.
fn schemes(paper: &Paper) -> Vec<Vec<String>> {
    let table = &paper.tables[0];
    let scheme = |row: usize, column: usize| {
        table.scheme_at(row, column).map_or(String::new(), |one| one.reference.to_string())
    };
    let rows = table.cells.iter().enumerate();
    rows.map(|(row, cells)| (0..cells.len()).map(|column| scheme(row, column)).collect()).collect()
}

#[test]
fn the_scheme_of_a_cell_is_that_of_its_row_or_column() {
    let cells = "cells = [['1', '2'], ['3', '4']]";
    let rows = read(&format!("rows = {SCHEMES}\ncolumns = {C}\n{cells}")).expect("a file");
    let columns = read(&format!("rows = {C}\ncolumns = {SCHEMES}\n{cells}")).expect("a file");
    let (first, second) = ("chaikin", "six-point:w=c/100");
    assert_eq!(schemes(&rows), [[first, first], [second, second]]);
    assert_eq!(schemes(&columns), [[first, second], [first, second]]);
    let axis = rows.tables[0].rows.as_ref().expect("rows");
    let printed: Vec<&str> = axis.entries.iter().map(|entry| entry.printed.as_str()).collect();
    assert_eq!(
        (&axis.label[..], axis.name(), &printed[..]),
        ("scheme", None, &["chaikin", "Hexa"][..])
    );
    assert_eq!(axis.entries[1].note.as_deref(), Some("so called"));
    let one = read(&format!("scheme = 'chaikin'\ncolumns = {C}\ncells = [['1', '2']]"));
    assert_eq!(schemes(&one.expect("a file")), [[first, first]]);
}

#[test]
fn what_is_ambiguous_is_refused_with_its_place_and_a_remedy() {
    let one = "schemes = ['chaikin']";
    let cells = "cells = [['1', '2']]";
    for (fields, place, message) in [
        (
            format!("scheme = 'chaikin'\nrows = {{ {one} }}\ncolumns = {C}\n{cells}"),
            "['chaikin']",
            "each cell of this table has two schemes",
        ),
        (
            format!("rows = {{ {one} }}\ncolumns = {SCHEMES}\n{cells}"),
            "['chaikin', {",
            "each cell of this table has two schemes",
        ),
        (
            format!("rows = {{ name = 'scheme', {one} }}\ncolumns = {C}\n{cells}"),
            "'scheme'",
            "headers that are schemes have no name in formulas",
        ),
        (
            format!("rows = {{ values = ['1'], {one} }}\ncolumns = {C}\n{cells}"),
            "{ values",
            "headers are given either by `values` or by `schemes`",
        ),
        (
            format!("rows = {{ label = 'x' }}\ncolumns = {C}\n{cells}"),
            "{ label",
            "headers are given either by `values` or by `schemes`",
        ),
        (
            format!("rows = {{ values = ['1'] }}\ncolumns = {C}\n{cells}"),
            "{ values",
            "numbers need the `name` that has these values in formulas",
        ),
    ] {
        let error = read(&fields).expect_err(&fields);
        assert_eq!(error.message, message, "{fields}");
        assert!(error.source.text[error.span.start..].starts_with(place), "{fields}\n{error}");
        assert!(error.help.is_some(), "{fields}");
    }
    for (headers, message) in [
        ("[]", "at least one header is needed"),
        ("['four-point:w']", "name=value"),
        ("[{ printed = 'x' }]", "missing field `scheme`"),
        ("[{ printed = 'x', scheme = 'chaikin', read = '1' }]", "unknown field `read`"),
    ] {
        let fields = format!("rows = {{ schemes = {headers} }}\ncolumns = {C}\n{cells}");
        let error = read(&fields).expect_err(&fields);
        assert!(error.to_string().contains(message), "{error}");
    }
    // The index of a sum in a header hides the name of the other axis.
    let hidden = "'four-point:w=sum(c = 0..1, c)/16'";
    let fields = format!("rows = {{ schemes = [{hidden}] }}\ncolumns = {C}\n{cells}");
    let error = read(&fields).expect_err("a hidden name");
    assert!(error.to_string().contains("the index `c` hides another meaning"), "{error}");
    assert!(error.source.text[error.span.start..].starts_with(hidden));
}

/// An array is no table, though it holds the fields in their order.
#[test]
fn a_figure_is_a_table() {
    let with = |figures: &str| {
        read(&format!("columns = {C}\ncells = [['1', '2']]\nfigures = [{figures}]"))
    };
    assert_eq!(with("{ locus = 'F' }").expect("a file").tables[0].figures[0].locus, "F");
    for figures in ["['F']", "[1]", "'F'"] {
        let error = with(figures).expect_err(figures);
        assert!(error.to_string().contains("expected a table such as { locus"), "{error}");
        assert!(error.source.text[error.span.start..].starts_with(figures), "{error}");
    }
}

#[test]
fn an_index_has_no_schemes() {
    let equation = "[[equation]]\nid = 'e'\nlocus = ''\nleft = '1'\nright = '1'\n\
                    indices = [{ name = 'i', schemes = ['chaikin'] }]\n";
    let error = read_paper(&SourceText::new("axes.toml", format!("{PAPER}{equation}")));
    let error = error.expect_err("no index");
    assert_eq!(error.message, "an index needs either `values`, or `from` and `to`");
}

#[test]
fn an_index_has_each_value_once() {
    let equation = "[[equation]]\nid = 'e'\nlocus = ''\nleft = ['1', '2']\nright = '1'\n\
                    indices = [{ name = 'i', values = ['1', '1.0'] }]\n";
    let error = read_paper(&SourceText::new("axes.toml", format!("{PAPER}{equation}")));
    let error = error.expect_err("one index for two cases");
    assert_eq!(error.message, "the value 1.0 stands here twice");
    assert!(error.source.text[error.span.start..].starts_with("'1.0'"), "{error}");
}
