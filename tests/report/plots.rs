//! Pictures of schemes: what stands where, and the words in place of what is not drawn.

use super::document::{Piece, read, text, within};
use subcert::exact::Rational;
use subcert::facts::Drawing;
use subcert::float::nearest;
use subcert::limit::Limit;
use subcert::report::html::Plot;
use subcert::scheme::parse_scheme;

fn svg(scheme: &str) -> String {
    let region = [[-1, 1].map(Rational::from), [-1, 1].map(Rational::from)];
    let drawing = Drawing::of(scheme, &region, 60).expect("a scheme");
    Plot::of(scheme, &drawing).to_svg()
}

/// The places of the first line of a class.
fn line(pieces: &[Piece], class: &str) -> Vec<(f64, f64)> {
    let group = within(pieces, |piece| piece.is("g", class));
    let line = group.iter().find(|piece| piece.is("polyline", "line")).expect("a line");
    let points = line.attribute("points").expect("places");
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let place = |pair: &str| pair.split_once(',').map(|(x, y)| (number(x), number(y)));
    points.split(' ').map(|pair| place(pair).expect("a pair")).collect()
}

/// The places and numbers of ticks along an axis.
fn ticks(pieces: &[Piece], anchor: &str, axis: &str) -> Vec<(f64, f64)> {
    let labels = pieces.windows(2).filter(|pair| pair[0].attribute("text-anchor") == Some(anchor));
    let tick = |pair: &[Piece]| Some((text(&pair[1..]).parse().ok()?, pair[0].number(axis)));
    labels.filter_map(tick).collect()
}

/// The number at a place, by the first and the last tick.
fn scale(ticks: &[(f64, f64)]) -> impl Fn(f64) -> f64 {
    let [(from, at), .., (to, end)] = *ticks else { panic!("ticks") };
    move |place| from + (place - at) * (to - from) / (end - at)
}

/// The curve goes through exact values of the limit, which are found in another way, within a pixel's tenth.
#[test]
fn the_curve_goes_through_exact_values() {
    let scheme = "four-point:w=1/16";
    let pieces = read(&svg(scheme));
    let places = line(&pieces, "c1");
    let until = pieces.iter().position(|piece| piece.is("g", "c1")).expect("the curve");
    let (x, y) = (ticks(&pieces[..until], "middle", "x"), ticks(&pieces[..until], "end", "y"));
    let y: Vec<(f64, f64)> = y.into_iter().map(|(value, place)| (value, place - 4.0)).collect();
    let (parameter, value) = (scale(&x), scale(&y));
    let pixel = (value(0.0) - value(1.0)).abs();
    let mask = parse_scheme(scheme).expect("a scheme").masks()[0].clone();
    let limit = Limit::new(&mask).expect("it converges");
    assert!(places.len() > 160, "{} places", places.len());
    let steps = (places.len() - 1) / 6;
    for (j, (across, up)) in (-3 * i64::try_from(steps).expect("few")..).zip(&places) {
        let t = Rational::from(j) / Rational::from(steps);
        assert!((parameter(*across) - nearest(&t)).abs() < 0.02, "{t}: {across}");
        let exact = nearest(&limit.at(&t).expect("few digits").coefficient(0));
        assert!((value(*up) - exact).abs() < 0.3 * pixel, "{t}: {} is not {exact}", value(*up));
    }
    // What is drawn at t, t + 1, … sums to 1.
    for start in 0..steps {
        let sum: f64 = places.iter().skip(start).step_by(steps).map(|(_, up)| value(*up)).sum();
        let twice = if start == 0 { 1.0 } else { 0.0 };
        assert!((sum - 1.0).abs() < 2.0 * pixel + twice * 1e-9, "{start}: {sum}");
    }
}

/// One file: no script, nothing that is loaded, words for those who do not see it, and colours for both modes.
#[test]
fn a_file_stands_alone() {
    for scheme in ["chaikin", "doo-sabin:n=5", "colella-heil", "six-point", "daubechies-4"] {
        let svg = svg(scheme);
        let pieces = read(&svg);
        assert!(pieces[0].attribute("xmlns").is_some(), "{scheme}");
        assert_eq!(pieces[0].attribute("role"), Some("img"), "{scheme}");
        for name in ["title", "desc"] {
            let words =
                within(&pieces, |piece| matches!(piece, Piece::Start(own, _) if own == name));
            assert!(text(&words).contains(scheme) || scheme.starts_with("doo"), "{scheme}: {name}");
        }
        assert!(svg.contains("prefers-color-scheme:dark"), "{scheme}");
        for not in ["<script", "href", "url(", "NaN", "inf,"] {
            assert!(!svg.contains(not), "{scheme}: {not}");
        }
    }
}

/// What does not exist or is open is said and not drawn.
#[test]
fn what_is_not_known_is_said() {
    let words = |scheme: &str| {
        let pieces = read(&svg(scheme));
        text(&within(&pieces, |piece| matches!(piece, Piece::Start(own, _) if own == "desc")))
    };
    assert!(words("chaikin").contains("φ″ is not drawn: not all limits are C²."));
    let diverges = words("four-point:w=1/2");
    assert!(diverges.contains("There is no picture: the scheme diverges"), "{diverges}");
    assert!(diverges.contains("No limit is drawn: the scheme diverges"), "{diverges}");
    let ring = words("bajaj:N=4");
    assert!(ring.contains("valence"), "{ring}");
    let map = words("colella-heil");
    assert!(map.contains("C⁰: ") && map.contains("% open"), "{map}");
    let range = words("four-point");
    assert!(range.contains("C¹ for "), "{range}");
}
