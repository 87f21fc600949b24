//! Corrected tables in LaTeX. `.ci/latex.py` compiles those of the papers.

use crate::common::claims::{judged, paper};
use subcert::exact::Rational;
use subcert::report::corrected_table;

#[test]
fn wrong_numbers_are_replaced_and_right_ones_stay() {
    let paper = paper(
        "[[table]]\nid = 't'\nlocus = 'T_1'\ntitle = 'a & b'\nvalue = 'w/3'\n\
         rows = { name = 'c', values = ['1'] }\n\
         columns = { name = 'w', values = ['1', '2', '3'] }\ncells = [['0.3333', '0.7654', '1.0000']]\n",
    );
    let latex = corrected_table(&judged(&paper).tables[0]);
    for part in [
        "\\begin{table}\n\\centering\n\\caption{a \\& b}\n\\begin{tabular}{lrrr}",
        "c \\textbackslash{} w & 1 & 2 & 3 \\\\",
        "1 & 0.3333 & \\textbf{0.6667} & 1.0000 \\\\",
        "% bold: the value of the printed definition\n",
    ] {
        assert!(latex.contains(part), "no {part} in {latex}");
    }
    assert!(!latex.contains("promise") && !latex.contains("checkable"), "{latex}");
}

/// Chaikin's sound bound is 2^−k/2 (T_1 = 1/2, displacement 1/4): a smaller printed bound is replaced by one that is
/// not smaller than it.
#[test]
fn a_broken_promise_is_replaced_by_one_that_is_kept() {
    let paper = paper(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nscheme = 'chaikin'\nvalue = '1/3/2^k'\n\
         promise = { level = 'k', spread = '1' }\n\
         columns = { name = 'k', values = ['1', '7'] }\ncells = [['0.1667', '0.0026']]\n",
    );
    let audit = judged(&paper);
    let latex = corrected_table(&audit.tables[0]);
    let numbers: Vec<Rational> = latex
        .split("\\textbf{")
        .skip(1)
        .map(|rest| rest.split('}').next().expect("a number"))
        .map(|text| subcert::exact::parse_rational(text).expect("a number"))
        .collect();
    let [first, second] = &numbers[..] else { panic!("{latex}") };
    let sound = |k: i32| Rational::new(1, 2) * Rational::new(1, 2).pow(k);
    assert!(*first >= sound(1) && *second >= sound(7), "{latex}");
    assert!(*second <= sound(7) * Rational::new(100_001, 100_000), "{latex}");
    assert!(latex.contains("keeps the promise"), "{latex}");
}

/// A definition that keeps the promise replaces a wrong number, rounded up: 2/3/2^k is more than 2^−k/2.
#[test]
fn a_definition_that_keeps_the_promise_stays() {
    let paper = paper(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nscheme = 'chaikin'\nvalue = '2/3/2^k'\n\
         promise = { level = 'k', spread = '1' }\n\
         columns = { name = 'k', values = ['1', '2'] }\ncells = [['0.3334', '0.9']]\n",
    );
    let latex = corrected_table(&judged(&paper).tables[0]);
    // 1/3 is not 0.3334, and 1/6 not 0.9.
    assert!(latex.contains("\\textbf{0.333334} & \\textbf{0.166667}"), "{latex}");
    assert!(!latex.contains('*'), "{latex}");
}
