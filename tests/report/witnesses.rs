//! Witnesses on nets and rings: what stands where.

use super::document::{Piece, read, within};
use crate::common::papers::{AUDITS, PAGES};
use crate::common::ring;
use subcert::audit::{Attained, Control, Kept, Place, Refiner};
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::limit::{LocalDistances, LocalLimit};
use subcert::report::Sheet;
use subcert::report::html::{FindingPage, Picture};

/// The pieces of a page with these pictures.
pub(super) fn pieces(pictures: &[Picture]) -> Vec<Piece> {
    let sheet = &Sheet::default();
    read(&FindingPage { sentence: "", sheet, pictures, command: "" }.to_html())
}

/// The ends of the lines of a class, in the first of the two views: those of the paths `Mx yldx dy`.
fn lines(pieces: &[Piece], class: &str) -> Vec<[(f64, f64); 2]> {
    let line = |piece: &Piece| {
        let path = piece.attribute("d")?.replace(['M', 'l'], " ");
        let numbers: Vec<f64> =
            path.split_whitespace().map(|x| x.parse().expect("a number")).collect();
        let [x, y, across, down] = numbers[..] else { return None };
        Some([(x, y), (x + across, y + down)])
    };
    let of_class = |piece: &&Piece| piece.attribute("class") == Some(class);
    let all: Vec<_> = pieces.iter().filter(of_class).filter_map(line).collect();
    let half = all.len() / 2;
    all[..half].to_vec()
}

/// A point of a ring stands above the same place at all levels. There the control data are integers and the limit is
/// one number, so that their distances say what a pixel is; the marked distance is then the exact one.
#[test]
fn a_ring_stands_at_its_heights() {
    for (scheme, level) in [("doo-sabin:n=5", 2), ("catmull-clark:N=3", 1), ("loop:N=6", 1)] {
        let ring = ring(scheme);
        let limit = LocalLimit::new(&ring).expect("a limit");
        let witness = LocalDistances::new(limit).constant(level).expect("a distance");
        let exact = nearest(&witness.distance);
        let points: Vec<(String, i64)> =
            witness.ring.iter().enumerate().map(|(a, x)| (ring.name(a), *x)).collect();
        let attained = Attained {
            control: Control::Points(points),
            place: Place::Named(ring.name(witness.point)),
            value: witness.distance,
        };
        let refiner = Refiner::Ring(ring.clone());
        let drawn = Picture::of_data(&refiner, &attained, level, &Rational::new(1, 100), [0.0; 2]);
        let pieces = pieces(&[drawn.expect("a picture")]);
        let (control, limit) = (lines(&pieces, "net c6"), lines(&pieces, "line c2"));
        assert_eq!(control.len(), ring.edges().len(), "{scheme}");
        // Above the limit, at both ends of an edge of the control ring.
        let above = |line: &[(f64, f64); 2]| {
            let same = |other: &&[(f64, f64); 2]| {
                (0..2).all(|end| (line[end].0 - other[end].0).abs() < 0.15)
            };
            let below = limit.iter().find(same).expect("an edge above the same places");
            [below[0].1 - line[0].1, below[1].1 - line[1].1]
        };
        // Ends of an edge differ by 0 or 1: the greatest difference is 1.
        let steps = control.iter().map(|line| (above(line)[1] - above(line)[0]).abs());
        let unit = steps.fold(0.0, f64::max);
        let bad = pieces.iter().find(|piece| piece.is("line", "bad")).expect("the place");
        let found = (bad.number("y1") - bad.number("y2")).abs() / unit;
        assert!((found - exact).abs() < 0.4 / unit + 0.01 * exact, "{scheme}: {found}, {exact}");
        assert!((bad.number("x1") - bad.number("x2")).abs() < 0.11, "{scheme}: one place");
    }
}

/// Data on nets whose drawn distance is not the exact one are not drawn.
#[test]
fn witnesses_on_nets_and_rings_are_drawn() {
    let (mut expected, mut drawn) = ([0, 0], [0, 0]);
    for (audit, page) in AUDITS.iter().zip(&*PAGES) {
        let title = |title: &str| page.matches(&format!("<title>{title}</title>")).count();
        drawn[0] += title("Control net, level and limit");
        drawn[1] += title("Control ring, level and limit");
        let refuted = audit.theorems.iter().filter_map(|finding| finding.refutation.as_ref());
        let theorems = refuted.map(|refutation| &refutation.violation.attained);
        let broken = |cells: &Vec<Vec<subcert::audit::CellFinding>>| {
            cells.iter().flatten().find_map(|cell| match &cell.kept {
                Some(Kept::No(broken)) => Some(broken.attained.clone()),
                _ => None,
            })
        };
        let tables = audit.tables.iter().filter_map(|finding| broken(&finding.cells));
        for attained in theorems.cloned().chain(tables) {
            match attained.control {
                Control::Net { .. } => expected[0] += 1,
                Control::Points(_) => expected[1] += 1,
                Control::Polygon(_) => {}
            }
        }
    }
    assert_eq!(drawn[0], expected[0], "nets");
    // Steps from an interpolant are no distances between two rings.
    assert!(drawn[1] >= 8 && drawn[1] <= expected[1], "{drawn:?} of {expected:?}");
}

#[test]
fn pictures_have_titles_and_descriptions() {
    for page in &*PAGES {
        let pieces = read(page);
        for (place, piece) in pieces.iter().enumerate() {
            if !matches!(piece, Piece::Start(name, _) if name == "svg") {
                continue;
            }
            let svg = within(&pieces[place..], |_| true);
            let has = |wanted: &str| {
                svg.windows(2).any(|pair| {
                    matches!((&pair[0], &pair[1]), (Piece::Start(name, _), Piece::Text(_)) if name == wanted)
                })
            };
            assert_eq!(piece.attribute("role"), Some("img"));
            assert!(has("title") && has("desc"), "{:?}", &svg[..3]);
        }
    }
}
