//! The sign of a polynomial on a square or a triangle.

use super::ball::Ball;
use super::bernstein::Form;
use crate::exact::{Rational, Scalar};

/// The most bisections of a piece.
pub const MAX_BISECTIONS: usize = 24;

/// The most parts of a piece.
const MAX_PARTS: usize = 4096;

/// A point of a piece.
pub type Place = [Rational; 2];

/// What is known of the sign of a function on a piece.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Signs {
    /// Whether the function is positive everywhere.
    pub(super) positive: bool,
    /// The most bisections that were needed.
    pub(super) bisections: usize,
    /// Points with a positive and with a negative value.
    pub(super) witnesses: [Option<Place>; 2],
}

/// The coefficients of a function in Bernstein form are bounds of it; those at corners are values. A piece is
/// bisected until all coefficients are positive, both signs are found, or the cap is met.
pub(super) fn signs<R: Scalar>(form: &Form<R>, sign: &impl Fn(&R) -> Option<i8>) -> Signs {
    let mut found = Signs { positive: true, ..Signs::default() };
    let mut places: Vec<Place> =
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|place| place.map(Rational::from)).to_vec();
    places.truncate(form.corners().len());
    let (mut waiting, mut parts) = (vec![(form.clone(), places, 0)], 0);
    while let Some((form, places, bisections)) = waiting.pop() {
        parts += 1;
        found.bisections = found.bisections.max(bisections);
        for (value, place) in form.corners().into_iter().zip(&places) {
            let which = match sign(value) {
                Some(1) => 0,
                Some(-1) => 1,
                _ => continue,
            };
            found.witnesses[which].get_or_insert_with(|| place.clone());
        }
        if form.coefficients().all(|x| sign(x) == Some(1)) {
            continue;
        }
        found.positive = false;
        let decided = found.witnesses.iter().all(Option::is_some);
        if decided || form.coefficients().all(|x| sign(x) == Some(-1)) {
            if decided {
                return found;
            }
            continue;
        }
        if bisections == MAX_BISECTIONS || parts + waiting.len() > MAX_PARTS {
            found.bisections = MAX_BISECTIONS;
            return found;
        }
        // Not positive only if a part is not.
        found.positive = found.witnesses[1].is_none();
        for (half, corners) in form.halves().into_iter().zip(half_places(&places)) {
            waiting.push((half, corners, bisections + 1));
        }
    }
    found
}

/// A part of a piece on which all coefficients have one sign.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// The bisections that lead to it.
    pub(super) path: String,
    /// The least absolute value of a coefficient.
    pub(super) least: Rational,
    /// Whether the coefficients are positive.
    pub(super) positive: bool,
    /// A corner of it.
    pub(super) near: Place,
}

/// Parts that cover a piece, on each of which all coefficients have one sign, the same for all; none where they are not
/// found within the caps.
pub(super) fn boxes(form: &Form<Ball>) -> Vec<Part> {
    let mut places: Vec<Place> =
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|place| place.map(Rational::from)).to_vec();
    places.truncate(form.corners().len());
    let side = form.corners().into_iter().find_map(|x| x.sign().filter(|sign| *sign != 0));
    let (mut waiting, mut parts) = (vec![(form.clone(), places, String::new())], Vec::new());
    while let Some((form, places, path)) = waiting.pop() {
        if form.coefficients().all(|x| x.sign() == side && x.is_apart()) {
            let size = |x: &Ball| x.lower().abs().min(x.upper().abs());
            let least = form.coefficients().map(size).min().expect("a coefficient");
            let corners = form.corners().into_iter().map(size).zip(&places);
            let near = corners.min_by(|(a, _), (b, _)| a.cmp(b)).expect("a corner").1.clone();
            parts.push(Part { path, least, positive: side == Some(1), near });
            continue;
        }
        let wrong = form.corners().into_iter().any(|x| x.is_apart() && x.sign() != side);
        if wrong || path.len() == MAX_BISECTIONS || parts.len() + waiting.len() > MAX_PARTS {
            return Vec::new();
        }
        // The first half is looked at first.
        let halves = form.halves().into_iter().zip(half_places(&places)).zip(['0', '1']);
        for ((half, corners), digit) in halves.collect::<Vec<_>>().into_iter().rev() {
            waiting.push((half, corners, format!("{path}{digit}")));
        }
    }
    parts
}

/// The corners of the halves, in their order.
fn half_places(places: &[Place]) -> [Vec<Place>; 2] {
    let middle =
        |a: &Place, b: &Place| -> Place { [0, 1].map(|i| (&a[i] + &b[i]) / Rational::from(2)) };
    match places {
        [origin, u, v] => {
            let cut = middle(origin, u);
            [origin, u].map(|end| vec![v.clone(), end.clone(), cut.clone()])
        }
        [origin, u, v, both] => {
            let (low, high) = (middle(origin, u), middle(v, both));
            [
                vec![origin.clone(), v.clone(), low.clone(), high.clone()],
                vec![low, high, u.clone(), both.clone()],
            ]
        }
        _ => unreachable!("three or four corners"),
    }
}
