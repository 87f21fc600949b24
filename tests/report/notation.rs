//! Texts are written as they are typed, and each output typesets them.

use super::document::{Piece, read, text, within};
use super::html::check;
use crate::common::papers::PAGES;
use proptest::prelude::*;
use subcert::report::html::FindingPage;
use subcert::report::{Grid, Sheet, unicode};

fn sheet(text: &str) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.text(text);
    sheet
}

/// The paragraph of a page.
fn html(text: &str) -> String {
    let page = FindingPage { sentence: text, sheet: &sheet(""), pictures: &[], command: "" };
    let page = page.to_html();
    let from = page.find("<strong>").expect("the sentence") + "<strong>".len();
    page[from..page.find("</strong>").expect("its end")].to_owned()
}

#[test]
fn one_text_in_each_output() {
    for (typed, plain, markdown, page, latex) in [
        (
            "C^1, not C^12",
            "C¹, not C¹²",
            "C¹, not C¹²",
            "<var>C</var><sup>1</sup>, not <var>C</var><sup>12</sup>",
            "$C^{1}$, not $C^{12}$",
        ),
        (
            "all T_c <= 1",
            "all T_c ≤ 1",
            "all T\\_c ≤ 1",
            "all <var>T</var><sub><var>c</var></sub> ≤ 1",
            "all $T_{c}$ $\\leq$ 1",
        ),
        ("n >= 3", "n ≥ 3", "n ≥ 3", "<var>n</var> ≥ 3", "$n$ $\\geq$ 3"),
        (
            "beta = 1, where omega_0",
            "beta = 1, where omega_0",
            "beta = 1, where omega\\_0",
            "<var>β</var> = 1, where <var>ω</var><sub>0</sub>",
            "$\\beta$ = 1, where $\\omega_{0}$",
        ),
        (
            "a 3 < b < c1 or |w|",
            "a 3 < b < c1 or |w|",
            "a 3 &lt; b &lt; c1 or \\|w\\|",
            "a 3 < <var>b</var> < c1 or |<var>w</var>|",
            "a 3 $<$ $b$ $<$ c1 or $|$$w$$|$",
        ),
        (
            "x_-2, …, x_1",
            "x₋₂, …, x₁",
            "x₋₂, …, x₁",
            "<var>x</var><sub>−2</sub>, …, <var>x</var><sub>1</sub>",
            "$x_{-2}$, $\\dots$, $x_{1}$",
        ),
        ("3.1·10^-5", "3.1·10⁻⁵", "3.1·10⁻⁵", "3.1·10<sup>−5</sup>", "3.1$\\cdot$10$^{-5}$"),
        (
            "‖Δ^{k+1}‖",
            "‖Δᵏ⁺¹‖",
            "‖Δᵏ⁺¹‖",
            "‖<var>Δ</var><sup>k+1</sup>‖",
            "$\\Vert$$\\Delta^{k+1}$$\\Vert$",
        ),
        (
            "x^k_i at -1/2",
            "x^k_i at -1/2",
            "x^k\\_i at -1/2",
            "<var>x</var><sup><var>k</var></sup><sub><var>i</var></sub> at −1/2",
            "$x_{i}^{k}$ at -1/2",
        ),
        (
            "6 - log_2(9)",
            "6 - log_2(9)",
            "6 - log\\_2(9)",
            "6 - log<sub>2</sub>(9)",
            "6 - $\\log_{2}$(9)",
        ),
        // What may be typed again: formulas, code, names.
        (
            "1 + 2*w^2",
            "1 + 2*w^2",
            "1 + 2\\*w^2",
            "1 + 2*<var>w</var><sup>2</sup>",
            "1 + 2*$w^{2}$",
        ),
        (
            "add `--a_b|c^2`",
            "add `--a_b|c^2`",
            "add `--a_b\\|c^2`",
            "add <code>--a_b|c^2</code>",
            "add \\texttt{--a\\_b$|$c\\textasciicircum{}2}",
        ),
        (
            "a_b.obj and dir/my_file",
            "a_b.obj and dir/my_file",
            "a\\_b.obj and dir/my\\_file",
            "a_b.obj and dir/my_file",
            "a\\_b.obj and dir/my\\_file",
        ),
        ("mine:w_1=1/2", "mine:w_1=1/2", "mine:w\\_1=1/2", "mine:w_1=1/2", "mine:w\\_1=1/2"),
        (
            "a lone ` stays",
            "a lone ` stays",
            "a lone \\` stays",
            "a lone ` stays",
            "a lone ` stays",
        ),
    ] {
        assert_eq!(unicode(typed), plain);
        assert_eq!(sheet(typed).to_text(None).trim_end(), plain, "{typed}");
        assert_eq!(sheet(typed).to_markdown().trim_end(), markdown, "{typed}");
        assert_eq!(html(typed).replace("&gt;", ">").replace("&lt;", "<"), page, "{typed}");
        assert_eq!(sheet(typed).to_latex().trim_end(), format!("% {typed}"));
        let document = sheet(typed).to_latex_document();
        assert!(document.contains(&format!("\n{latex}\n")), "{latex} is not in {document}");
    }
}

/// The signs of a text without those that are typed for scripts and code, in the order of the alphabet.
fn signs(text: &str) -> String {
    let small = |from: &str, to: &str, c: char| {
        from.chars().zip(to.chars()).find(|(small, _)| *small == c).map(|(_, sign)| sign)
    };
    let plain = |c: char| {
        small("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ᶜⁱʲᵏᵐⁿ", "0123456789-+cijkmn", c)
            .or_else(|| small("₀₁₂₃₄₅₆₇₈₉₋₊−", "0123456789-+-", c))
            .unwrap_or(c)
    };
    let text = text.replace('≤', "<=").replace('≥', ">=");
    let mut signs: Vec<char> = text.chars().map(plain).filter(|c| !"_^{}`".contains(*c)).collect();
    signs.sort_unstable();
    signs.into_iter().collect()
}

proptest! {
    /// Whatever is typed, nothing of it is lost.
    #[test]
    fn nothing_is_lost(text in "[aCβkmu_^{}()0-9`<>=|.√* −-]{0,14}") {
        prop_assert_eq!(signs(&unicode(&text)), signs(&text));
        prop_assert_eq!(signs(&unicode(&unicode(&text))), signs(&text));
        let page = FindingPage { sentence: &text, sheet: &sheet(""), pictures: &[], command: "" };
        let shown = self::text(&within(&read(&page.to_html()), |piece| piece.is("p", "headline")));
        prop_assert_eq!(signs(&shown.replace('μ', "mu")), signs(&text));
    }
}

/// A column is as wide as what is shown in it.
#[test]
fn tables_are_aligned_as_shown() {
    let mut sheet = Sheet::default();
    sheet.grid(Grid::of(["C^1", "b"], [vec!["10^-12".to_owned(), "1".to_owned()]], 1));
    let text = sheet.to_text(None);
    let lines: Vec<usize> = text
        .lines()
        .filter(|line| !line.contains(['─', '═']))
        .map(|line| line.trim_end().chars().count())
        .collect();
    assert!(lines.iter().all(|length| *length == lines[0]), "{text}");
    assert!(text.contains("C¹") && text.contains("10⁻¹²"), "{text}");
}

/// Facts and pictures stand side by side where there is room for both, and what is wide has the whole page.
#[test]
fn pages_have_two_columns() {
    let mut page_sheet = Sheet::default();
    page_sheet.grid(Grid::of(["a", "b"], [vec!["1".to_owned(), "2".to_owned()]], 1));
    page_sheet.grid(Grid::of(["a"; 8], [vec!["1234567".to_owned(); 8]], 1));
    let page = FindingPage { sentence: "", sheet: &page_sheet, pictures: &[], command: "" };
    let pieces = check(&page.to_html());
    let is = |class: &'static str| move |piece: &Piece| piece.is("div", class);
    let beside = within(&pieces, is("beside"));
    let tables = |class: &str| beside.iter().filter(|piece| piece.is("div", class)).count();
    assert_eq!((tables("scroll"), tables("wide")), (2, 1));
    for page in &*PAGES {
        let pieces = read(page);
        let style = text(&within(
            &pieces,
            |piece| matches!(piece, Piece::Start(name, _) if name == "style"),
        ));
        let columns = style.split("min-width:1100px").nth(1).expect("a rule for wide windows");
        assert!(columns.starts_with("){.beside,.claim{columns:2"), "{columns}");
        assert!(pieces.iter().any(|piece| piece.is("div", "beside")));
    }
}
