//! Figures that plot numbers of tables.

use super::document::{Piece, read, within};
use crate::common::claims::{HEAD, judged, paper};
use crate::common::papers::{AUDITS, PAGES};
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert::report::html::audit_page;

const TABLE: &str = "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nvalue = 'w*c'\n\
    rows = { name = 'c', values = ['1', '2', '4'] }\n\
    columns = { name = 'w', values = ['1', '2', '3'] }\n\
    cells = [['1', '2', '3'], ['2', '4', '6'], ['4', '9', '12']]\n";

fn figure(figures: &str) -> Vec<Piece> {
    let paper = paper(&format!("{TABLE}figures = {figures}\n"));
    let pieces = read(&audit_page(&judged(&paper), None, None).expect("a page"));
    let title = "Figure 1: as printed, and as it should be";
    let place = pieces.iter().position(|piece| *piece == Piece::Text(title.to_owned()));
    within(&pieces[place.expect("a figure") - 2..], |piece| piece.attribute("role") == Some("img"))
}

/// The panels have one scale: 9 stands where it is printed for 8, which is the mean of 4 and 12.
#[test]
fn a_figure_stands_beside_what_it_should_show() {
    let pieces = figure("[{ locus = 'Figure 1', lines = ['1', '4'] }]");
    let dots: Vec<f64> = pieces
        .iter()
        .filter(|piece| piece.is("circle", "dot"))
        .map(|dot| dot.number("cy"))
        .collect();
    assert_eq!(dots.len(), 12, "two lines of three numbers, twice");
    let (printed, due) = dots.split_at(6);
    for right in [0, 1, 2, 3, 5] {
        assert!((printed[right] - due[right]).abs() < 1e-9, "what is right is the same: {dots:?}");
    }
    assert!((due[4] - f64::midpoint(due[3], due[5])).abs() < 0.2, "{dots:?}");
    let unit = (due[3] - due[5]) / 8.0;
    assert!((due[4] - printed[4] - unit).abs() < 0.3, "{dots:?}");
    let all = figure("[{ locus = 'Figure 1' }]");
    assert_eq!(all.iter().filter(|piece| piece.is("circle", "dot")).count(), 18);
    // Columns, where the names are theirs.
    let columns = figure("[{ locus = 'Figure 1', lines = ['3'] }]");
    assert_eq!(columns.iter().filter(|piece| piece.is("circle", "dot")).count(), 6);
}

#[test]
fn lines_are_headers() {
    let message = |figures: &str| {
        let text = format!("{HEAD}{TABLE}figures = {figures}\n");
        let error = read_paper(&SourceText::new("k.toml", text)).expect_err("an error");
        error.to_string()
    };
    let wrong = message("[{ locus = 'Figure 1', lines = ['1', '5'] }]");
    assert!(wrong.contains("is not a header of a row"), "{wrong}");
    let unknown = message("[{ locus = 'Figure 1', rows = ['1'] }]");
    assert!(unknown.contains("rows"), "{unknown}");
    let many = format!("[{}]", "{ locus = 'F' },".repeat(17));
    assert!(message(&many).contains("16 figures at most"), "{}", message(&many));
}

/// The three papers whose texts say which table a figure plots.
#[test]
fn figures_of_the_papers_are_drawn() {
    let count = |key: &str| {
        let at = AUDITS.iter().position(|audit| audit.paper.key == key).expect("the paper");
        let page = &PAGES[at];
        page.matches(": as printed, and as it should be</title>").count()
    };
    let drawn = ["khan2019-newton", "khan2022-doo-sabin", "mustafa2020-nary"].map(count);
    assert_eq!(drawn, [3, 2, 8]);
}
