//! A sample polygon at several levels, beside its limit.

use super::frame::points;
use super::panel::Panel;
use super::scale::Scale;
use crate::facts::{CurveShape, LEVELS};
use crate::float::nearest;
use crate::smoothness::Coefficient;
use maud::html;

/// The room of one level, with the line above it that names it.
const ROOM: (f64, f64) = (208.0, 176.0);
const NAME: f64 = 22.0;
const MARGIN: f64 = 10.0;

/// How many levels stand beside each other.
const BESIDE: usize = 3;

/// Levels of at most so many points have dots.
const MAX_DOTS: usize = 30;

/// A closed line through places of the picture, without the points that fall on the place before.
fn path(places: &[(f64, f64)]) -> String {
    let mut places: Vec<(f64, f64)> =
        places.iter().copied().chain(places.first().copied()).collect();
    places.dedup();
    points(&places)
}

/// The levels in rows.
pub(crate) fn sample<F: Coefficient>(scheme: &str, shape: &CurveShape<F>) -> Panel {
    let rounded = |line: &Vec<[F; 2]>| -> Vec<[f64; 2]> {
        line.iter().map(|point| point.each_ref().map(nearest)).collect()
    };
    let levels: Vec<Vec<[f64; 2]>> = shape.levels.iter().map(rounded).collect();
    let limit = shape.limit.as_ref().map(rounded);
    let all = || levels.iter().chain(limit.iter()).flatten();
    let ends = |axis: usize| {
        all().fold((f64::MAX, f64::MIN), |(low, high), place| {
            (low.min(place[axis]), high.max(place[axis]))
        })
    };
    let (across, up) = (ends(0), ends(1));
    let size = |(low, high): (f64, f64)| (high - low).max(f64::MIN_POSITIVE);
    let unit =
        ((ROOM.0 - 2.0 * MARGIN) / size(across)).min((ROOM.1 - NAME - 2.0 * MARGIN) / size(up));
    let rows = levels.len().div_ceil(BESIDE);
    let place = |i: usize| f64::from(u8::try_from(i).unwrap_or(u8::MAX));
    let drawing = html! {
        @for (k, level) in levels.iter().enumerate() {
            @let left = 8.0 + place(k % BESIDE) * ROOM.0 + (ROOM.0 - unit * size(across)) / 2.0;
            @let bottom = (place(k / BESIDE) + 1.0) * ROOM.1 - MARGIN;
            @let x = Scale::new(across, (left, left + unit * size(across)), false);
            @let y = Scale::new(up, (bottom, bottom - unit * size(up)), false);
            @let places: Vec<(f64, f64)> = level.iter().map(|point| (x.at(point[0]), y.at(point[1]))).collect();
            text x=(8.0 + (place(k % BESIDE) + 0.5) * ROOM.0) y=(place(k / BESIDE) * ROOM.1 + NAME - 4.0) text-anchor="middle" { "level " (k) }
            @if let Some(limit) = &limit {
                @let limit: Vec<(f64, f64)> = limit.iter().map(|point| (x.at(point[0]), y.at(point[1]))).collect();
                g.c2 { polyline.line points=(path(&limit)) {} }
            }
            g.c1 {
                polyline.net points=(path(&places)) {}
                @if places.len() <= MAX_DOTS {
                    @for (x, y) in &places { circle.dot cx=(x) cy=(y) r="2.5" {} }
                }
            }
        }
    };
    let last = levels.len().saturating_sub(1);
    let fewer = if last < LEVELS {
        format!(" Later levels have too many points and are not drawn, up to level {LEVELS}.")
    } else {
        String::new()
    };
    let of_limit = match (&shape.limit, &shape.end) {
        (Some(limit), _) => {
            format!(
                "; the limit, in the other colour, is drawn through {} of its points",
                limit.len()
            )
        }
        (None, Some(reason)) => format!(". No limit is drawn: {reason}"),
        (None, None) => ". No limit is drawn".to_owned(),
    };
    Panel {
        title: format!("{scheme}: a closed polygon of six points, refined"),
        says: format!(
            "Levels 0 to {last}, computed exactly and rounded to a tenth of a unit of the picture{of_limit}.{fewer}"
        ),
        height: place(rows) * ROOM.1,
        drawing,
    }
}
