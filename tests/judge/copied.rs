//! Readings that take a quantity from another place of the paper. Tables are printed as a careless
//! author would, by a computation of their own; the audit has to find out what was copied, and the
//! checker to agree.

use crate::common::claims::{HEAD, judged, paper};
use proptest::prelude::*;
use subcert::audit::{Copied, Difference, Explanation, PaperAudit, Verdict};
use subcert::certificate::certificate;
use subcert::exact::Rational;
use subcert::exact::format::{fixed, scientific};
use subcert_check::{Outcome, check};

/// The constant of a row: 7/3 + a/(b + 1).
fn constant(a: i64, b: i64) -> Rational {
    Rational::new(7, 3) + Rational::new(a, b + 1)
}

/// With which constants the table is printed.
#[derive(Clone, Copy, Debug)]
enum Author {
    /// With those that another table prints.
    Rounds,
    /// All with that of the first row.
    Repeats,
    /// With that of another b, which another table has.
    Confuses,
}

/// A table of constants with two digits, and one of K·z/3 + 1/7 that was computed with them.
fn claims(author: Author, rows: &[i64], b: i64) -> String {
    let used = |a: i64| match author {
        Author::Rounds => rounded(&scientific(&constant(a, b), 3)),
        Author::Repeats => constant(rows[0], b),
        Author::Confuses => constant(a, b + 3),
    };
    let list = |cells: Vec<String>| format!("['{}']", cells.join("', '"));
    let constants = rows.iter().map(|&a| list(vec![scientific(&constant(a, b), 3)]));
    let cell = |a: i64, z: i64| fixed(&(used(a) * Rational::new(z, 3) + Rational::new(1, 7)), 6);
    let cells = rows.iter().map(|&a| list((1..=4).map(|z| cell(a, z)).collect()));
    let headers = list(rows.iter().map(ToString::to_string).collect());
    format!(
        "[define]\nK = '7/3 + a/(b + 1)'\n\
         [[table]]\nid = 'constants'\nlocus = 'Table 1'\nvalue = 'K'\n\
         rows = {{ name = 'a', values = {headers} }}\ncolumns = {{ name = 'b', values = ['{b}'] }}\n\
         cells = [{}]\n\
         [[table]]\nid = 'values'\nlocus = 'Table 2'\nvalue = 'K*z/3 + 1/7'\n\
         given = {{ b = '{b}' }}\nrows = {{ name = 'a', values = {headers} }}\n\
         columns = {{ name = 'z', values = ['1', '2', '3', '4'] }}\ncells = [{}]\n\
         [[table]]\nid = 'other'\nlocus = 'Table 3'\nvalue = 'b'\n\
         columns = {{ name = 'b', values = ['{}'] }}\ncells = [['{}']]\n",
        constants.collect::<Vec<_>>().join(", "),
        cells.collect::<Vec<_>>().join(", "),
        b + 3,
        b + 3,
    )
}

fn rounded(text: &str) -> Rational {
    subcert::exact::parse_decimal(text).expect("a decimal").value()
}

/// The checker says the same.
fn certified(claims: &str, audit: &PaperAudit<'_>) {
    let text = certificate(audit).text;
    let report = check(&format!("{HEAD}{claims}"), &[&text]).expect("a claim file");
    for (_, id, outcome) in &report.claims {
        assert_eq!(outcome, &Outcome::Valid, "{id}\n{text}");
    }
}

/// Every digit of a copied table is changed: nothing explains it.
fn not_copied(start: i64, b: i64, off: u32) {
    let rows = [start, start + 1, start + 2];
    let claims = claims(Author::Repeats, &rows, b);
    let (before, after) = claims.split_once("id = 'values'").expect("the table");
    let (head, cells) = after.split_once("cells = ").expect("cells");
    // Every digit is another one.
    let other = |c: char| {
        c.to_digit(10).map_or(c, |d| char::from_digit((d + off) % 10, 10).expect("a digit"))
    };
    let (cells, rest) = cells.split_once("[[table]]").expect("the next table");
    let cells: String = cells.chars().map(other).collect();
    let claims = format!("{before}id = 'values'{head}cells = {cells}[[table]]{rest}");
    let paper = paper(&claims);
    let audit = judged(&paper);
    let cells = audit.tables[1].cells.iter().flatten();
    assert!(cells.clone().all(|cell| cell.verdict != Verdict::OtherReading), "{claims}");
    assert!(cells.clone().any(|cell| cell.verdict == Verdict::Refuted), "{claims}");
    certified(&claims, &audit);
}

/// Here one cell of twelve is explained by luck.
#[test]
fn one_cell_by_luck_is_no_reading() {
    not_copied(33, 8, 8);
}

proptest! {
    #[test]
    fn what_was_copied_is_found(
        author in prop_oneof![
            Just(Author::Rounds), Just(Author::Repeats), Just(Author::Confuses)
        ],
        start in 1_i64..40,
        step in 1_i64..9,
        b in 1_i64..20,
    ) {
        let rows: Vec<i64> = (0..3).map(|i| start + i * step).collect();
        // Numbers that two digits after the point give exactly are as they should be.
        let exact = |a: i64| rounded(&scientific(&constant(a, b), 3)) == constant(a, b);
        prop_assume!(!matches!(author, Author::Rounds) || !rows.iter().all(|&a| exact(a)));
        let claims = claims(author, &rows, b);
        let paper = paper(&claims);
        let audit = judged(&paper);
        let search = audit.tables[1].search.as_ref().expect("a search");
        let best = search.best.first();
        prop_assert!(best.is_some_and(|best| best.count() == 12), "{claims}");
        // Two copies may give the same numbers: the one that was made is among the best.
        let made = |difference: &Difference| match (author, difference) {
            (Author::Rounds, Difference::Copied(Copied::Printed { of, table, .. })) => {
                of == "K" && table == "constants"
            }
            (Author::Repeats, Difference::Copied(Copied::Parameter { name, value, .. })) => {
                name == "a" && *value == Rational::from(rows[0])
            }
            (Author::Confuses, Difference::Copied(Copied::Parameter { name, value, .. })) => {
                name == "b" && *value == Rational::from(b + 3)
            }
            _ => false,
        };
        let found = search.best.iter().any(|best| matches!(&best.differences[..], [one] if made(one)));
        prop_assert!(found, "{:?}", search.best.iter().map(Explanation::differs).collect::<Vec<_>>());
        certified(&claims, &audit);
    }

    /// Numbers that come from nowhere stay refuted, and the whole family is in the certificate.
    #[test]
    fn what_was_not_copied_is_refuted(start in 1_i64..40, b in 1_i64..20, off in 3_u32..9) {
        not_copied(start, b, off);
    }
}

/// By hand: of the 4-point scheme T_1 = 5/8 with w = 1/16, and 3/4 with w = 1/8; Chaikin's is 1/2. The
/// first column was computed with the T_1 of the third.
#[test]
fn a_column_of_another_scheme_is_found() {
    let text = "[define]\nT = 'contraction(1)'\n[[table]]\nid = 't'\nlocus = 'Table 1'\n\
        value = 'T^k/(1 - T)/7'\nrows = { name = 'k', values = ['1', '2', '3', '4'] }\n\
        columns = { label = 's', schemes = ['four-point:w=1/16', 'chaikin', 'four-point:w=1/8'] }\n\
        cells = [['0.428571', '0.142857', '0.428571'], ['0.321429', '0.0714286', '0.321429'], \
        ['0.241071', '0.0357143', '0.241071'], ['0.180804', '0.0178571', '0.180804']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let finding = &audit.tables[0];
    for cell in finding.cells.iter().map(|row| &row[0]) {
        let read = cell.as_read.as_ref().expect("a reading");
        assert_eq!(
            (read.differs().as_str(), &cell.verdict),
            ("T of four-point:w=1/8", &Verdict::OtherReading)
        );
    }
    let others = finding.cells.iter().flat_map(|row| [&row[1], &row[2]]);
    assert!(others.into_iter().all(|cell| cell.verdict == Verdict::Confirmed));
    certified(text, &audit);
}

/// Tolerances 2^−3, 2^−4, 2^−7, … with one digit. By hand: with r = 97/100, one halving takes
/// log 2/−log r = 22.757 levels, and with 99/100 it takes 68.968.
#[test]
fn tolerances_that_were_computed_are_found() {
    let text = "[[table]]\nid = 't'\nlocus = 'Table 1'\nvalue = 'levels(r, epsilon)'\n\
        promise = { tolerance = 'epsilon', spread = '1' }\n\
        rows = { name = 'r', values = ['1/2', '97/100', '99/100'] }\n\
        columns = { name = 'epsilon', values = ['0.1', '0.06', '0.008', '0.001', '0.0001'] }\n\
        cells = [['3', '4', '7', '10', '13'], ['69', '92', '160', '228', '296'], \
        ['207', '276', '483', '690', '897']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let best = audit.tables[0].search.as_ref().and_then(|search| search.best.first());
    let best = best.expect("a reading");
    let [Difference::Copied(Copied::Tolerance { line: 0, .. })] = &best.differences[..] else {
        panic!("{}", best.differs());
    };
    assert_eq!(best.count(), 15);
    certified(text, &audit);
}
