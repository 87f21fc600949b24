//! All errors of a claim file at once.

use super::{TemporaryFile, assert_parts, refused, subcert};

const PAPER: &str =
    "key = 'k'\n[paper]\nauthors = ['A B']\ntitle = 't'\nvenue = 'v'\nyear = '2026'\n";

#[test]
fn independent_errors_are_shown_together() {
    let text = format!(
        "{PAPER}[define]\nA = '2*('\nB = '1'\n\
         [[table]]\nid = 'ragged'\nlocus = 'l'\nvalue = 'B'\n\
         columns = {{ name = 'c', values = ['1', '2'] }}\ncells = [['0.5']]\n\
         [[equation]]\nid = 'right'\nlocus = 'l'\nleft = '1'\nright = 'B'\n\
         [[equation]]\nid = 'one-sided'\nlocus = 'l'\nleft = '1'\n\
         [[theorem]]\nid = 'premise'\nlocus = 'l'\nsays = 's'\nrests = ['rigth']\n"
    );
    let file = TemporaryFile::new("errors.toml", &text);
    let message = refused(["audit", file.path()]);
    let parts = [
        "expected a number, a name or `(`",
        "1 cells, and 2 column headers",
        "an equation needs `left` and `right`",
        "`rigth` is no other claim of this file; did you mean `right`?",
        "\n\n4 errors\n",
    ];
    assert_parts(&message, &parts);
    let places: Vec<usize> = parts.iter().map(|part| message.find(part).expect("there")).collect();
    assert!(places.is_sorted(), "in the order of the file: {message}");
}

/// Names are looked up when claims are judged; a definition that several use is refused once.
#[test]
fn unknown_names_of_several_claims_are_shown_together() {
    let equation = |id: &str, right: &str| {
        format!("[[equation]]\nid = '{id}'\nlocus = 'l'\nleft = '1'\nright = '{right}'\n")
    };
    let claims =
        [equation("a", "taw"), equation("b", "T"), equation("c", "T"), equation("d", "ab(1)")];
    let text = format!("{PAPER}[define]\ntau = '1'\nT = 'gamma'\n{}", claims.concat());
    let assert = subcert(["audit", "-"]).stdin(text).assert().code(2);
    let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert_parts(
        &message,
        &[
            "unknown name `taw`; did you mean `tau`?",
            "unknown name `gamma`",
            "unknown function `ab`; did you mean `abs`?",
            "\n\n3 errors\n",
        ],
    );
}

#[test]
fn one_error_is_not_counted() {
    let message = refused(["audit", "Cargo.toml"]);
    assert!(!message.contains("errors"), "{message}");
}
