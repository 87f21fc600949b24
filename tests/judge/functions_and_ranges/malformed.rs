//! Malformed claims about a free parameter: errors with their place.

use super::HEAD;
use subcert::audit::audit;
use subcert::claim::read_paper;
use subcert::diagnostic::{Diagnostic, SourceText};

/// The error of reading or judging a paper, and what it underlines.
fn refused(text: &str) -> (Diagnostic, String) {
    let source = SourceText::new("k.toml", format!("{HEAD}{text}"));
    let error = match read_paper(&source) {
        Err(error) => error,
        Ok(paper) => audit(&paper).err().unwrap_or_else(|| panic!("{text}: no error")),
    };
    let place = error.source.text[error.span.clone()].to_owned();
    (error, place)
}

#[test]
fn malformed_claims() {
    let function = |rest: &str| {
        format!(
            "[[function]]\nid = 'f'\nlocus = 'l'\nvariable = 'x'\nscheme = 'four-point:w=x'\n{rest}"
        )
    };
    let range = |rest: &str| {
        format!("[[range]]\nid = 'r'\nlocus = 'l'\nvariable = 'x'\nvalue = 'abs(x)'\n{rest}")
    };
    let cases: [(String, &str, &str); 20] = [
        (function("left = 'x'\nright = 'y'\n"), "unknown name `y`; known here: x", "y"),
        (function("left = 'x'\n"), "missing field `right`", ""),
        (function("left = 'x'\nright = 'x'\nwhere = 'x'\n"), "unknown field `where`", "where"),
        (function("left = 'x/x'\nright = 'x'\n"), "not piecewise polynomial in `x`", "'x/x'"),
        (function("left = 'x'\nright = '1/(1 + x)'\n"), "not piecewise polynomial", "'1/(1 + x)'"),
        (function("left = 'x'\nright = '1/0'\n"), "division by zero", "0"),
        (function("left = 'x'\nright = 'floor(x)'\n"), "no value while", "floor(x)"),
        (
            function("left = 'x'\nright = 'contraction(x)'\n"),
            "a number of levels",
            "contraction(x)",
        ),
        (
            function("left = 'x'\nright = 'surface_displacement(1, 1, 1)'\n"),
            "`surface_displacement` is not computed",
            "surface_displacement(1, 1, 1)",
        ),
        (
            function("left = 'x'\nright = 'displacement(offset = x)'\n"),
            "`own`, `best` or an integer",
            "displacement(offset = x)",
        ),
        (
            function("left = 'x'\nright = 'norm(1, rounded = up)'\n"),
            "no option `rounded`",
            "norm(1, rounded = up)",
        ),
        (
            function("left = 'x'\nright = 'x'\n").replace("four-point:w=x", "four-pint:w=x"),
            "unknown scheme `four-pint`",
            "'four-pint:w=x'",
        ),
        (
            function("left = 'x'\nright = 'x'\n").replace("variable = 'x'", "variable = '2'"),
            "`2` cannot be a name",
            "'2'",
        ),
        (
            function("left = 'x'\nright = 'norm(1)'\n").replace("scheme = 'four-point:w=x'\n", ""),
            "needs a scheme",
            "norm(1)",
        ),
        (range("from = '0'\nto = '1'\n"), "either `below` or `at_most`", "'r'"),
        (range("below = '1'\n"), "needs its printed ends", "'r'"),
        (range("below = '1'\nfrom = '1'\nto = '0'\n"), "0 is not above", "'0'"),
        (range("below = '1'\nto = '1/2/3'\n"), "unexpected `/`", "'1/2/3'"),
        (range("below = 'x'\nto = '1'\n"), "unknown name `x`", "x"),
        (
            range("below = '1'\nto = '1'\n")
                + &function("left = 'x'\nright = 'x'\n").replace("'f'", "'r'"),
            "`r` is used twice",
            "'r'",
        ),
    ];
    for (text, message, place) in cases {
        let (error, underlined) = refused(&text);
        assert!(error.to_string().contains(message), "no `{message}` in: {error}");
        if !place.is_empty() {
            assert_eq!(underlined, place, "{error}");
        }
    }
}
