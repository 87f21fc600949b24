//! Reading claims about smoothness: what is wrong is refused, with its place and a remedy.

use crate::common::claims::HEAD;
use subcert::audit::audit;
use subcert::claim::{SmoothnessKind, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

/// The first error of a file with this claim, read or judged.
fn error(kind: &str, fields: &str) -> Diagnostic {
    let text = format!("{HEAD}[[{kind}]]\nid = 'c'\nlocus = 'l'\n{fields}\n");
    let source = SourceText::new("k.toml", text);
    match read_paper(&source) {
        Err(error) => error,
        Ok(paper) => audit(&paper).err().unwrap_or_else(|| panic!("{fields} is accepted")),
    }
}

#[test]
fn bad_claims_are_refused_with_their_place() {
    let range = "scheme = 'four-point:w=w'\nvariable = 'w'\n";
    let smooth = format!("{range}smoothness = '1'\n");
    for (kind, fields, at, says) in [
        ("smoothness", "scheme = 'chaikin'".to_owned(), "'c'", "needs `continuous`"),
        ("smoothness", "continuous = '1'".to_owned(), "'c'", "`scheme` is missing"),
        (
            "smoothness",
            "scheme = 'chaikin'\ncontinuous = '1/2'".to_owned(),
            "'1/2'",
            "not an order",
        ),
        ("smoothness", "scheme = 'chaikin'\ncontinuous = '65'".to_owned(), "'65'", "not an order"),
        (
            "smoothness",
            "scheme = 'chaikin'\ncontinuous = '2'\nnot_continuous = '1'".to_owned(),
            "'c'",
            "are C^1 too",
        ),
        (
            "smoothness",
            "scheme = 'chaikin'\ncontinuous = '1'\nabsent = 'x'".to_owned(),
            "'c'",
            "needs `continuous`",
        ),
        (
            "smoothness",
            "scheme = 'chaikin x chaikin'\ncontinuous = '1'".to_owned(),
            "'chaikin x chaikin'",
            "for curves",
        ),
        (
            "smoothness",
            "scheme = 'four-point:w=z'\ncontinuous = '1'".to_owned(),
            "'four-point:w=z'",
            "z",
        ),
        ("exponent", "scheme = 'chaikin'".to_owned(), "'c'", "needs one of"),
        (
            "exponent",
            "scheme = 'chaikin'\nvalue = '2'\nprinted = '2'".to_owned(),
            "'c'",
            "needs one of",
        ),
        ("exponent", "scheme = 'chaikin'\nprinted = '4 - log'".to_owned(), "'4 - log'", ""),
        ("exponent", "scheme = 'chaikin'\nvalue = 'log_2(0)'".to_owned(), "'log_2(0)'", "form"),
        ("exponent", "scheme = 'chaikin'\nvalue = 'log_2(3)^2'".to_owned(), "'log_2(3)^2'", "form"),
        ("exponent", "scheme = 'chaikin'\nvalue = '1/log_2(3)'".to_owned(), "'1/log_2(3)'", "form"),
        ("exponent", "scheme = 'chaikin'\nvalue = 'log_1(3)'".to_owned(), "log_1(3)", "log_1"),
        ("exponent", "scheme = 'chaikin'\nvalue = 'w'".to_owned(), "w", "w"),
        (
            "exponent",
            "scheme = 'chaikin'\nvalue = '2^1000'".to_owned(),
            "'2^1000'",
            "binary digits",
        ),
        ("range", format!("{smooth}below = '1'\nfrom = '0'"), "'1'", "no place beside"),
        ("range", format!("{range}from = '0'"), "'c'", "either `value` or `smoothness`"),
        ("range", smooth.clone(), "'c'", "printed ends"),
        ("range", format!("{smooth}from = '1/5'\nto = '1/8'"), "'1/8'", "not above"),
        ("range", format!("{smooth}from = 'x'"), "x", "x"),
        (
            "range",
            format!(
                "{range}value = 'contraction(1)'\nbelow = '1'\nfrom = '0'\nto = '1'\nonly = true"
            ),
            "true",
            "`only`",
        ),
        (
            "range",
            "scheme = 'four-point:w=1/(1+w)'\nvariable = 'w'\nsmoothness = '1'\nfrom = '0'"
                .to_owned(),
            "'four-point:w=1/(1+w)'",
            "not polynomial",
        ),
        (
            "range",
            format!("{smooth}from = '0'\nto = 'cos(pi/101)'"),
            "'cos(pi/101)'",
            "too complicated",
        ),
    ] {
        let error = error(kind, &fields);
        let place = &error.source.text[error.span.clone()];
        assert!(place.contains(at), "{fields}: at {place}");
        assert!(error.to_string().contains(says), "{fields}: {error}");
    }
}

#[test]
fn bad_tables_of_orders_and_exponents_are_refused_with_their_place() {
    let table = |schemes: &str, columns: &str, cells: &str| {
        format!("rows = {{ schemes = {schemes} }}\ncolumns = {columns}\ncells = {cells}")
    };
    let one = |cell: &str| table("['chaikin']", "['order']", &format!("[[{cell}]]"));
    let values = |scheme: &str, values: &str, cells: &str| {
        format!(
            "{scheme}rows = {{ name = 'w', values = {values} }}\ncolumns = ['exponent']\ncells = {cells}"
        )
    };
    let of = "scheme = 'four-point:w=w'\n";
    for (fields, at, says) in [
        (table("['chaikin', 'chaikin']", "['order']", "[[1], [2]]"), "'chaikin'", "twice"),
        (values(of, "['1/2', '0.50']", "[['1'], ['1']]"), "'0.50'", "twice"),
        (table("[]", "['order']", "[]"), "[]", "at least one header"),
        (table("['chaikin']", "[]", "[[]]"), "[]", "at least one column"),
        (table("['chaikin']", "['order', 'order']", "[[1, 1]]"), "'order'", "twice"),
        (table("['chaikin']", "['degree']", "[[1]]"), "'degree'", "order, continuous"),
        (table("['chaikin']", "['order']", "[]"), "[]", "0 rows of cells, and 1 row headers"),
        (table("['chaikin']", "['order']", "[[1, 1]]"), "[1, 1]", "2 cells, and 1 columns"),
        (one("'-'"), "[['-']]", "no cell states anything"),
        (
            one("{ printed = '-', read = '3', note = 'n' }"),
            "{ printed = '-', read = '3', note = 'n' }",
            "nothing is printed",
        ),
        (one("''"), "[['']]", "no cell states anything"),
        (one("{ printed = 'C', read = '—', note = 'n' }"), "[[", "no cell states anything"),
        (one("'C^2'"), "'C^2'", "not an order"),
        (one("-1"), "-1", "not an order"),
        (one("64"), "64", "`65` is not an order"),
        (one("99999999999999999999"), "99999999999999999999", "not an order"),
        (one("1.5"), "1.5", "1.5"),
        (one("{ printed = 'C2', read = '2' }"), "read", "note"),
        (values(of, "['1/16']", "[['two']]"), "'two'", "two"),
        (values(of, "['x']", "[['2']]"), "'x'", "x"),
        (values("", "['1/16']", "[['2']]"), "'c'", "`scheme` is missing"),
        (values("scheme = 'four-point:w=v'\n", "['1/16']", "[['2']]"), "'four-point:w=v'", "v"),
        (format!("scheme = 'chaikin'\n{}", one("1")), "'chaikin'", "two schemes"),
        (
            format!("{}\n[define]\nw = '1'", values(of, "['1/16']", "[['2']]")),
            "'1/16'",
            "two meanings",
        ),
        (
            format!("{}\n[[exponent]]\nid = 'c.1.order'\nlocus = ''\nabsent = 'x'", one("1")),
            "'c",
            "used twice",
        ),
        (
            format!("{}\n[[exponent]]\nid = 'c'\nlocus = ''\nabsent = 'x'", one("1")),
            "'c'",
            "used twice",
        ),
    ] {
        let error = error("regularity", &fields);
        let place = &error.source.text[error.span.clone()];
        assert!(place.contains(at), "{fields}: at {place}");
        assert!(error.to_string().contains(says), "{fields}: {error}");
    }
}

#[test]
fn each_kind_has_its_table() {
    let text = format!(
        "{HEAD}[[exponent]]\nid = 'e'\nlocus = ''\nscheme = 'chaikin'\nvalue = '2'\n\
         [[range]]\nid = 'r'\nlocus = ''\nscheme = 'four-point:w=w'\nvariable = 'w'\nsmoothness = '1'\nfrom = '0'\n\
         [[smoothness]]\nid = 's'\nlocus = ''\nscheme = 'chaikin'\ncontinuous = '1'\n"
    );
    let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
    let kinds: Vec<(&str, SmoothnessKind)> =
        paper.smoothness.iter().map(|claim| (&claim.id[..], claim.kind)).collect();
    let expected = [
        ("s", SmoothnessKind::Continuity),
        ("e", SmoothnessKind::Exponent),
        ("r", SmoothnessKind::Range),
    ];
    assert_eq!(kinds, expected);
    assert!(paper.ranges.is_empty());
}
