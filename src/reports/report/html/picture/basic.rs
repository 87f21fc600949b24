//! The basic limit function and its derivatives.

use crate::exact::Rational;
use crate::facts::CurveShape;
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{Frame, points};
use crate::report::html::picture::plane::panel::Panel;
use crate::report::html::picture::plane::scale::Scale;
use crate::smoothness::{BasicValues, Coefficient};
use maud::html;

/// The height of one function.
const HEIGHT: f64 = 190.0;

/// The names and colours of functions.
const NAMES: [(&str, &str); 4] = [("φ", "c1"), ("φ′", "c2"), ("φ″", "c3"), ("φ‴", "c4")];

/// The functions one below the other, on one scale of parameters.
pub(crate) fn basic<F: Coefficient>(scheme: &str, shape: &CurveShape<F>) -> Panel {
    let title = format!("{scheme}: the basic limit function");
    let Some(first) = shape.functions.first() else {
        let reason = shape.end.as_deref().unwrap_or("nothing is known");
        return Panel::of_words(title, format!("There is no picture: {reason}."));
    };
    let drawn = shape.functions.iter().zip(NAMES).zip(0_u8..);
    let (low, high) = (at(first, first.first), at(first, last(first)));
    let drawing = html! {
        @for ((function, (name, class)), row) in drawn {
            @let top = f64::from(row) * HEIGHT;
            @let frame = Frame { x: (56.0, 624.0), y: (top + HEIGHT - 30.0, top + 12.0) };
            @let values: Vec<f64> = function.values.iter().map(nearest).collect();
            @let ends = values.iter().fold((0.0_f64, 0.0_f64), |(low, high), y| (low.min(*y), high.max(*y)));
            @let x = Scale::new((low, high), frame.x, false);
            @let y = Scale::new(ends, (frame.y.0 - 10.0, frame.y.1 + 10.0), false);
            @let places: Vec<(f64, f64)> = (function.first..).zip(&values).map(|(j, value)| (x.at(at(function, j)), y.at(*value))).collect();
            @let ticks: Vec<(f64, String)> = x.ticks().into_iter().map(|(value, label)| (x.at(value), label)).collect();
            (frame.drawn(&ticks, &y))
            line.frame x1=(frame.x.0) x2=(frame.x.1) y1=(y.at(0.0)) y2=(y.at(0.0)) {}
            g class=(class) {
                polyline.line points=(points(&places)) {}
                text.name.over x=(frame.x.1 - 8.0) y=(frame.y.1 + 20.0) text-anchor="end" { (name) }
            }
        }
    };
    let count = shape.functions.len();
    let names: Vec<&str> = NAMES.iter().take(count).map(|(name, _)| *name).collect();
    let grids: Vec<String> = shape
        .functions
        .iter()
        .map(|f| Rational::from(f.arity).pow(-(f.level.cast_signed())).to_string())
        .collect();
    let grid = if grids.iter().all(|grid| *grid == grids[0]) {
        grids[0].clone()
    } else {
        grids.join(", ")
    };
    let rest = match (NAMES.get(count), &shape.end) {
        (Some((name, _)), Some(reason)) => format!(" {name} is not drawn: {reason}."),
        _ => " Higher derivatives are not drawn.".to_owned(),
    };
    let says = format!(
        "{}: exact values at the multiples of {grid} in the support, rounded to a tenth of a unit of the picture and joined \
         by lines.{rest}",
        names.join(", "),
    );
    Panel {
        title,
        says,
        height: f64::from(u8::try_from(count).unwrap_or(u8::MAX)) * HEIGHT,
        drawing,
    }
}

fn at<F: Coefficient>(function: &BasicValues<F>, j: i64) -> f64 {
    let steps = Rational::from(function.arity).pow(function.level.cast_signed());
    nearest(&(Rational::from(j) / steps))
}

fn last<F>(function: &BasicValues<F>) -> i64 {
    function.first + i64::try_from(function.values.len()).unwrap_or(i64::MAX) - 1
}
