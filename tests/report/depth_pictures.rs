//! Pictures of depths.

use super::document::{Piece, text, within};
use super::witnesses::pieces;
use crate::common::mask;
use subcert::exact::Rational;
use subcert::limit::{ControlPolygon, Distances, Limit, Parametrisation};
use subcert::report::Sheet;
use subcert::report::html::{ColouredFaces, FarPolygon, FindingPage, LevelLine, Levels, Picture};

/// Triangles in a row, with these values.
fn triangles(values: &[f64]) -> (Vec<[f64; 3]>, Vec<Vec<usize>>) {
    let x = |i: usize| f64::from(u32::try_from(i).expect("few"));
    let points = (0..values.len() + 2).map(|i| [x(i), x(i % 2), 0.0]).collect();
    (points, (0..values.len()).map(|i| vec![i, i + 1, i + 2]).collect())
}

fn coloured(values: &[f64]) -> Option<Picture> {
    let (points, faces) = triangles(values);
    let values_are = "distance".to_owned();
    let (points, faces) = (&points[..], &faces[..]);
    let place = Some([0.0; 3]);
    Picture::of_faces(&ColouredFaces {
        name: "m",
        values_are,
        points,
        faces,
        values,
        place,
        note: "",
    })
}

/// How many paths have each class.
fn classes(pieces: &[Piece], class: &str) -> usize {
    pieces
        .iter()
        .filter(|piece| {
            matches!(piece, Piece::Start(name, _) if name == "path")
                && piece.attribute("class") == Some(class)
        })
        .count()
}

#[test]
fn a_colour_is_an_eighth_of_the_greatest_value() {
    let values: Vec<f64> = (0..=16).map(f64::from).collect();
    let pieces = pieces(&[coloured(&values).expect("a picture")]);
    // Of 0, 1, …, 16 the first eighth has 0 to 2, and each other one two numbers; there are two views.
    assert_eq!(classes(&pieces, "h h0"), 6);
    for class in 1..8 {
        assert_eq!(classes(&pieces, &format!("h h{class}")), 4, "{class}");
    }
    assert!(coloured(&[]).is_none());
    // Nothing is far from anything.
    let flat = super::witnesses::pieces(&[coloured(&[0.0, 0.0]).expect("a picture")]);
    assert_eq!(classes(&flat, "h h0"), 4);
}

#[test]
fn of_many_faces_the_worst_are_in_colour() {
    let values: Vec<f64> = (0..200_000).map(|i| f64::from(i % 1_000)).collect();
    let picture = [coloured(&values).expect("a picture")];
    let sheet = &Sheet::default();
    let page = FindingPage { sentence: "", sheet, pictures: &picture, command: "" }.to_html();
    assert!(page.len() < 1_000_000, "{} bytes", page.len());
    let pieces = pieces(&picture);
    assert_eq!(classes(&pieces, "h h7"), 6_000, "the greatest 3,000 of 200,000, twice");
    let grey = classes(&pieces, "h grey");
    assert!(grey > 5_000 && grey <= 6_000, "{grey}");
    assert!(
        text(&pieces).contains("Of 200000 faces the 3000 with the greatest values are in colour")
    );
}

#[test]
fn what_is_behind_is_drawn_first() {
    // Two parallel squares: seen from one side, the other one is behind.
    let square = |y: f64| [[0.0, y, 0.0], [1.0, y, 0.0], [1.0, y, 1.0], [0.0, y, 1.0]];
    let points: Vec<[f64; 3]> = square(0.0).into_iter().chain(square(1.0)).collect();
    let faces = vec![vec![0, 1, 2, 3], vec![4, 5, 6, 7]];
    let values_are = "distance".to_owned();
    let picture = Picture::of_faces(&ColouredFaces {
        name: "m",
        values_are,
        points: &points,
        faces: &faces,
        values: &[1.0, 0.0],
        place: None,
        note: "",
    });
    let pieces = pieces(&[picture.expect("a picture")]);
    let order: Vec<&str> = pieces
        .iter()
        .filter(|piece| matches!(piece, Piece::Start(name, _) if name == "path"))
        .filter_map(|piece| piece.attribute("class"))
        .collect();
    // From y < 0 the square at 0 is in front, and from the other side behind.
    assert_eq!(order, ["h h0", "h h7", "h h7", "h h0"]);
}

#[test]
fn levels_stand_at_their_logarithms() {
    let line = LevelLine {
        name: "distance".to_owned(),
        values: vec![(0, 1.0), (1, 0.1), (2, 0.01), (3, 0.0)],
        met: Some(2),
        is_constant: false,
    };
    let tolerance = Rational::new(1, 20);
    let promised = vec![(1, "by formula".to_owned())];
    let levels = Levels { tolerance: &tolerance, lines: vec![line], promised };
    let pieces = pieces(&[Picture::of_levels(&levels).expect("a picture")]);
    let dots: Vec<(f64, f64)> = pieces
        .iter()
        .filter(|piece| piece.is("circle", "dot"))
        .map(|dot| (dot.number("cx"), dot.number("cy")))
        .collect();
    let [first, second, third] = dots[..] else { panic!("0 has no logarithm: {dots:?}") };
    assert!((second.1 - first.1 - (third.1 - second.1)).abs() < 0.3, "{dots:?}");
    assert!((second.0 - first.0 - (third.0 - second.0)).abs() < 0.3, "{dots:?}");
    let ring = pieces.iter().find(|piece| piece.is("circle", "ring")).expect("a ring");
    assert!((ring.number("cx") - third.0).abs() < 0.2);
    let epsilon =
        pieces.iter().find(|piece| piece.is("line", "frame")).expect("a line").number("y1");
    let expected = first.1 + (second.1 - first.1) * 20.0_f64.log10();
    assert!((epsilon - expected).abs() < 0.3, "{epsilon} {expected}");
    let promised =
        pieces.iter().find(|piece| piece.is("line", "bad")).expect("a line").number("x1");
    assert!((promised - second.0).abs() < 0.2);
}

/// The drawn distance against the exact one, by the ticks of the picture.
#[test]
fn the_place_of_a_polygon_is_as_far_as_the_exact_distance() {
    let points = [[0, 0], [4, 0], [5, 3], [0, 4]].map(|point| point.map(Rational::from));
    let coordinates: Vec<Vec<Rational>> = (0..2)
        .map(|axis| points.iter().map(|point: &[Rational; 2]| point[axis].clone()).collect())
        .collect();
    let mut seen = 0;
    for scheme in ["chaikin", "b-spline:degree=3", "four-point:w=1/16"] {
        for closed in [true, false] {
            let mask = mask(scheme);
            let distances =
                Distances::placed(&Limit::new(&mask).expect("a limit"), Parametrisation::Natural)
                    .expect("distances");
            let polygon = if closed {
                ControlPolygon::closed(&coordinates[0])
            } else {
                ControlPolygon::open(&coordinates[0])
            };
            let width = Rational::new(1, 1_000_000);
            // The four-point scheme needs six points for a piece of an open polygon.
            let Ok(found) = distances.of_polygon(&polygon, 1, &width) else { continue };
            let pictures = Picture::of_polygon(&FarPolygon {
                mask: &mask,
                coordinates: &coordinates,
                closed,
                shift: distances.shift(),
                level: 1,
                coordinate: 0,
                parameter: &found.parameter,
                distance: found.enclosure.lower(),
            });
            assert_eq!(pictures.len(), 2, "{scheme}");
            let pieces = pieces(&pictures[1..]);
            let picture = within(&pieces, |piece| piece.attribute("role") == Some("img"));
            let ticks: Vec<(f64, f64)> = picture
                .windows(2)
                .filter(|pair| pair[0].attribute("text-anchor") == Some("end"))
                .filter_map(|pair| Some((text(&pair[1..]).parse().ok()?, pair[0].number("y"))))
                .collect();
            let [first, .., last] = &ticks[..] else { panic!("ticks") };
            let pixel = ((last.0 - first.0) / (last.1 - first.1)).abs();
            let bad = picture.iter().find(|piece| piece.is("line", "bad")).expect("the place");
            let drawn = (bad.number("y1") - bad.number("y2")).abs() * pixel;
            let exact = subcert::float::nearest(found.enclosure.lower());
            assert!(
                (drawn - exact).abs() < 0.02 * exact + 0.25 * pixel,
                "{scheme}: {drawn} {exact}"
            );
            seen += 1;
        }
    }
    assert!(seen >= 4, "{seen}");
}
