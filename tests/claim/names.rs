//! A name means one thing in a claim: a file in which one has two meanings is refused, with both
//! places.

use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

const PAPER: &str = "key = 'names'\npaper = { authors = [], title = '', venue = '', year = '' }\n";

fn read(claims: &str) -> Result<Paper, Diagnostic> {
    read_paper(&SourceText::new("names.toml", format!("{PAPER}{claims}")))
}

/// A table with these fields.
fn table(fields: &str) -> String {
    format!("[[table]]\nid = 't'\nlocus = ''\n{fields}\ncells = [['1']]\n")
}

const COLUMNS: &str = "columns = { name = 'x', values = ['1'] }";

#[test]
fn two_meanings_are_refused_with_both_places() {
    let theorem = |more: &str| {
        format!(
            "[[theorem]]\nid = 'q'\nlocus = ''\nscheme = 'chaikin'\nbounds = 'difference'\n\
             by = 'beta*(1/2)^k'\nfrom = '0'\n{more}"
        )
    };
    let equation =
        |more: &str| format!("[[equation]]\nid = 'e'\nlocus = ''\nleft = '1'\nright = '1'\n{more}");
    for (claims, name) in [
        (format!("[define]\nk = '0'\n{}", theorem("")), "k"),
        (theorem("values = { epsilon = ['1'] }"), "epsilon"),
        (format!("[define]\nx = '0'\n{}", table(&format!("value = '1'\n{COLUMNS}"))), "x"),
        ("[define]\nd = '0'\n[given]\nd = '1'\n".to_owned(), "d"),
        (table(&format!("value = '1'\n{COLUMNS}\ngiven = {{ x = '2' }}")), "x"),
        (table(&format!("value = '1'\n{COLUMNS}\ngiven = {{ y = '2' }}\nunstated.y = '3'")), "y"),
        (
            table(
                "value = '1'\nrows = { name = 'x', values = ['2'] }\n\
                columns = { name = 'x', values = ['1'] }",
            ),
            "x",
        ),
        (equation("symbols = ['i']\nindices = [{ name = 'i', values = ['1'] }]"), "i"),
        (equation("symbols = ['a', 'a']"), "a"),
    ] {
        let error = read(&claims).expect_err(&claims);
        assert_eq!(error.message, format!("`{name}` has two meanings here"), "{claims}");
        assert!(error.other.is_some() && error.help.is_some(), "{claims}");
        assert_eq!(error.to_string().matches("names.toml").count(), 1);
    }
}

/// A name that stands for a product is no factor of one: no axis is left out.
#[test]
fn a_product_of_products_has_too_many_axes() {
    let of = |scheme: &str| {
        let fields = format!("scheme = '{scheme}'\nvalue = 'contraction(1)'\n{COLUMNS}");
        let product = "[[scheme]]\nname = 'p'\nuse = 'chaikin x chaikin'\n";
        let paper = read(&format!("{product}{}", table(&fields))).expect("a paper");
        subcert::audit::audit(&paper).map(|_| ()).map_err(|error| error.message)
    };
    assert_eq!(of("p"), Ok(()));
    for scheme in ["p x chaikin", "chaikin x p"] {
        let error = of(scheme).expect_err("three axes");
        assert!(error.contains("tensor product has two factors"), "{error}");
    }
}

#[test]
fn a_proof_by_hand_uses_no_theorem() {
    let theorem = |id: &str, more: &str| {
        format!("[[theorem]]\nid = '{id}'\nlocus = ''\nsays = 'x'\nproved_by = 'here'\n{more}\n")
    };
    let claims = |used: &str| {
        format!(
            "[[equation]]\nid = 'e'\nlocus = ''\nleft = '1'\nright = '1'\n{}{}",
            theorem("p", ""),
            theorem("q", &format!("proof_uses = ['{used}']"))
        )
    };
    assert!(read(&claims("e")).is_ok());
    let error = read(&claims("p")).expect_err("a theorem");
    assert!(error.message.contains("`p`, which is a theorem itself"), "{error}");
    assert!(error.help.is_some_and(|help| help.contains("`rests`")));
}

#[test]
fn only_a_stated_value_is_hidden() {
    for claims in [
        format!("[given]\nx = '2'\n{}", table(&format!("value = 'x'\n{COLUMNS}"))),
        format!("[given]\ny = '2'\n{}", table(&format!("value = 'y'\n{COLUMNS}\ngiven.y = '1'"))),
    ] {
        let paper = read(&claims).unwrap_or_else(|error| panic!("{error}"));
        let audit = subcert::audit::audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        let cell = &audit.tables[0].cells[0][0];
        assert_eq!(cell.verdict, subcert::audit::Verdict::Confirmed, "{claims}");
    }
}

#[test]
fn an_index_of_a_sum_hides_nothing() {
    for (define, fields) in [
        ("d = '1'", "value = 'sum(d = 1..1, d)'"),
        ("d = 'x'", "value = 'sum(x = 1..1, d)'"),
        ("d = 'sum(w = 1..1, w)'", "value = 'd'\ngiven = { w = '2' }"),
        ("q = '1'\ng = '1'", "value = 'convolved(1, 2, 2, 0, 0, sequence = g)'"),
    ] {
        let claims = format!("[define]\n{define}\n{}", table(&format!("{fields}\n{COLUMNS}")));
        let error = read(&claims).expect_err(&claims);
        assert!(error.message.contains("hides another meaning"), "{error}");
        assert!(error.other.is_some(), "{claims}");
    }
    // Inside of equations, sums may run over what an index of the equation is called.
    read(
        "[define]\nd = 'i'\n[[equation]]\nid = 'e'\nlocus = ''\nleft = 'sum(i = 1..2, d)'\n\
          right = '3'\nindices = [{ name = 'i', values = ['7'] }]\n",
    )
    .unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn theorems_mention_their_own_names_where_these_mean_something() {
    let theorem = |fields: &str| {
        read(&format!(
            "[define]\nd = 'k'\n[given]\nbeta = '1/4'\n[[theorem]]\nid = 't'\nlocus = ''\n{fields}"
        ))
    };
    let bound = "scheme = 'chaikin'\nbounds = 'difference'\nfrom = '0'";
    assert!(theorem(&format!("{bound}\nby = 'beta*(1/2)^d'")).is_ok());
    for fields in [
        format!("{bound}\nby = 'beta'\nsupposes = {{ value = 'beta', below = '1/2' }}"),
        format!("{bound}\nby = 'beta'\nsupposes = {{ value = '1', below = 'd' }}"),
        format!("{bound}\nby = 'epsilon*beta'"),
        "scheme = 'chaikin'\nbounds = 'depth'\nby = 'k'".to_owned(),
        "scheme = 'six-point:w=beta'\nbounds = 'difference'\nfrom = '0'\nby = 'beta'".to_owned(),
    ] {
        let error = theorem(&fields).expect_err(&fields);
        assert!(error.message.ends_with("has no meaning here"), "{error}");
    }
}

/// Reports name alternatives of a definition by their labels.
#[test]
fn alternatives_of_one_definition_have_different_labels() {
    let alternatives = |second: &str, label: &str| {
        format!(
            "[define]\nx = '1'\ny = '1'\n[[alternative]]\nof = 'x'\nlabel = 'other'\nvalue = '2'\n\
             [[alternative]]\nof = '{second}'\nlabel = '{label}'\nvalue = '3'\n"
        )
    };
    let error = read(&alternatives("x", "other")).expect_err("one label");
    assert_eq!(error.message, "two alternatives of `x` have the label `other`");
    assert!(error.other.is_some());
    assert!(read(&alternatives("x", "third")).is_ok());
    assert!(read(&alternatives("y", "other")).is_ok());
}
