//! Pictures of findings: what stands where.

use super::document::{Piece, read, text, within};
use crate::common::claims::{judged, paper};
use crate::common::papers::{AUDITS, PAGES};
use subcert::audit::Kept;
use subcert::exact::RealCyclotomic;
use subcert::float::nearest;
use subcert::report::html::audit_page;

fn page(claims: &str) -> Vec<Piece> {
    let paper = paper(claims);
    read(&audit_page(&judged(&paper), None, None).expect("a page"))
}

/// The numbers on the vertical axis of a picture, with their places.
fn ticks(picture: &[Piece]) -> Vec<(f64, f64)> {
    let labels = picture.windows(2).filter(|pair| pair[0].attribute("text-anchor") == Some("end"));
    let tick = |pair: &[Piece]| Some((text(&pair[1..]).parse().ok()?, pair[0].number("y") - 4.0));
    labels.filter_map(tick).collect()
}

#[test]
fn printed_numbers_stand_where_their_logarithms_do() {
    let values = ["1", "0.1", "0.02", "0.0001"];
    let claims = format!(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nvalue = 'w'\n\
         columns = {{ name = 'w', values = {values:?} }}\ncells = [['1', '0.1', '0.05', '0.0001']]\n"
    );
    let pieces = page(&claims);
    let picture = within(&pieces, |piece| piece.attribute("role") == Some("img"));
    let rings: Vec<f64> = picture
        .iter()
        .filter(|piece| piece.is("circle", "ring"))
        .map(|ring| ring.number("cy"))
        .collect();
    assert_eq!(rings.len(), 4);
    // Equal quotients are equal distances: from 1 to 0.1 as a third of that from 0.1 to 0.0001.
    assert!(((rings[1] - rings[0]) * 3.0 - (rings[3] - rings[1])).abs() < 0.5, "{rings:?}");
    let expected = rings[0] + (rings[1] - rings[0]) * -(0.05_f64.log10());
    assert!((rings[2] - expected).abs() < 0.2, "{rings:?}");
    let dots = picture.iter().filter(|piece| piece.is("circle", "dot"));
    let dots: Vec<f64> = dots.map(|dot| dot.number("cy")).collect();
    assert!(
        dots[2] > rings[2] && (dots[0] - rings[0]).abs() < 0.2,
        "0.02 is below the printed 0.05: {dots:?}"
    );
    let crosses = picture.iter().filter(|piece| piece.is("path", "bad")).count();
    assert_eq!(crosses, 1, "one cell is wrong");
}

/// The distance at the marked place of the drawing of data that exceed a bound, in a section that has one, and
/// what a pixel is.
fn drawn(section: &[Piece]) -> Option<(f64, f64)> {
    let title = Piece::Text("Control polygon, level and limit".to_owned());
    let place = section.iter().position(|piece| *piece == title)?;
    // Before the text stand the tags of the title and of the picture.
    let picture = within(&section[place - 2..], |piece| piece.attribute("role") == Some("img"));
    let [first, .., last] = &ticks(&picture)[..] else { panic!("ticks") };
    let bad = picture.iter().find(|piece| piece.is("line", "bad")).expect("the place");
    let height = (bad.number("y1") - bad.number("y2")).abs();
    let pixel = ((last.0 - first.0) / (last.1 - first.1)).abs();
    Some((height * pixel, pixel))
}

/// The drawing finds the distance by refinement in f64; the audit found it exactly.
#[test]
fn the_place_of_a_refutation_is_as_far_as_the_exact_distance() {
    let mut seen = [0, 0];
    for (audit, page) in AUDITS.iter().zip(&*PAGES) {
        let pieces = read(page);
        let section = |id: &str| within(&pieces, |piece| piece.attribute("id") == Some(id));
        let check = |id: &str, exact: &RealCyclotomic| {
            let exact = nearest(exact);
            let Some((found, pixel)) = drawn(&section(id)) else { return 0 };
            // Both ends are rounded to a tenth of a pixel, and so are the ticks.
            let near = (found - exact).abs() < 0.02 * exact + 0.25 * pixel;
            assert!(near, "{id}: {found}, {exact}, {pixel}");
            1
        };
        for finding in &audit.theorems {
            let Some(refutation) = &finding.refutation else { continue };
            seen[0] += check(&finding.theorem.id, &refutation.violation.attained.value);
        }
        for finding in &audit.tables {
            let broken = finding.cells.iter().flatten().find_map(|cell| match &cell.kept {
                Some(Kept::No(broken)) => Some(broken),
                _ => None,
            });
            let Some(broken) = broken else { continue };
            seen[1] += check(&finding.table.id, &broken.attained.value);
        }
    }
    assert!(seen[0] >= 4 && seen[1] >= 3, "{seen:?} pictures");
}

#[test]
fn digits_of_a_misprint_are_marked() {
    let pieces = page(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nvalue = 'w'\n\
         columns = { name = 'w', values = ['0.123456', '2'] }\ncells = [['0.128456', '2']]\n",
    );
    let digits = within(&pieces, |piece| piece.is("div", "digits"));
    assert_eq!(text(&digits), "printed 0.128456\nexact   0.123456");
    let marked = digits
        .windows(2)
        .filter(|pair| matches!(&pair[0], Piece::Start(name, _) if name == "mark"));
    let marked: Vec<String> = marked.map(|pair| text(&pair[1..])).collect();
    assert_eq!(marked, ["8", "3"]);
}

#[test]
fn a_range_stands_above_the_exact_set() {
    let pieces = page(
        "[[range]]\nid = 'r'\nlocus = 'R'\ntitle = 'r'\nvariable = 'w'\nvalue = 'w^2'\nbelow = '1/4'\n\
         from = '-0.25'\nto = '0.5'\nclosed = true\n",
    );
    let picture = within(&pieces, |piece| piece.attribute("role") == Some("img"));
    let lines: Vec<(f64, f64)> = picture
        .iter()
        .filter(|piece| piece.is("line", "line"))
        .map(|line| (line.number("x1"), line.number("x2")))
        .collect();
    // Exactly −1/2 < w < 1/2, printed −1/4 ≤ w ≤ 1/2: the printed one begins a quarter of the set later.
    let [exact, printed] = lines[..] else { panic!("{lines:?}") };
    assert!((printed.1 - exact.1).abs() < 0.2, "{lines:?}");
    assert!(((printed.0 - exact.0) * 4.0 - (exact.1 - exact.0)).abs() < 0.8, "{lines:?}");
    assert_eq!(picture.iter().filter(|piece| piece.is("circle", "ring")).count(), 2);
    assert_eq!(picture.iter().filter(|piece| piece.is("circle", "dot")).count(), 2);
}

/// Chaikin's T_1 is 1/2 and its displacement 1/4, so that the sound bound of level k is 2^−k/2: it meets
/// 1/1000 from level 9 on.
#[test]
fn the_sound_bound_meets_the_tolerance_at_the_ring() {
    let pieces = page(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nscheme = 'chaikin'\nvalue = '1'\n\
         promise = { tolerance = 'epsilon', spread = '1' }\n\
         columns = { name = 'epsilon', values = ['1/1000', '1/10'] }\ncells = [['1', '1']]\n",
    );
    let title = pieces.windows(2).position(|pair| {
        matches!(&pair[0], Piece::Start(name, _) if name == "title")
            && pair[1] == Piece::Text("Sound bound against the level".to_owned())
    });
    let picture = within(&pieces[title.expect("the picture") - 1..], |_| true);
    let place = |piece: &Piece| (piece.number("cx"), piece.number("cy"));
    let dots: Vec<(f64, f64)> =
        picture.iter().filter(|piece| piece.is("circle", "dot")).map(place).collect();
    assert_eq!(dots.len(), 12, "levels 0 to 11");
    let ring = picture.iter().find(|piece| piece.is("circle", "ring")).map(place).expect("a ring");
    let at = dots.iter().position(|dot| (dot.0 - ring.0).abs() < 0.01).expect("its dot");
    assert_eq!(at, 9);
    let epsilon =
        picture.iter().find(|piece| piece.is("line", "frame")).expect("a line").number("y1");
    assert!(dots[9].1 > epsilon && dots[8].1 < epsilon, "{dots:?} {epsilon}");
    // Halves at each level are equal steps.
    for pair in dots.windows(3) {
        assert!((pair[0].1 + pair[2].1 - 2.0 * pair[1].1).abs() < 0.3, "{dots:?}");
    }
}
