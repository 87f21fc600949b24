//! Faces in colours by a value, from two sides.

use super::space::{Scene, Views};
use crate::exact::{Rational, format::short};
use crate::float::nearest;
use crate::report::html::picture::plane::frame::{WIDTH, picture};
use crate::report::html::typeset::typeset;
use maud::{Markup, html};

/// The most faces in colour, and as many of the others in grey at most.
const MAX_COLOURED: usize = 3_000;

/// The most corners of a face that are drawn.
const MAX_CORNERS: usize = 64;

/// How many colours there are.
const COLOURS: u8 = 8;

/// The classes of the colours, from the least value to the greatest.
const CLASSES: [&str; COLOURS as usize] =
    ["h h0", "h h1", "h h2", "h h3", "h h4", "h h5", "h h6", "h h7"];

/// Faces with a value for each, such as bounds of their distances from a limit.
#[derive(Clone, Debug)]
pub struct ColouredFaces<'f> {
    /// What is shown, as `cube.obj`.
    pub name: &'f str,
    /// What the values are, as `distance at level 3`.
    pub values_are: String,
    /// The points.
    pub points: &'f [[f64; 3]],
    /// The corners of the faces.
    pub faces: &'f [Vec<usize>],
    /// A value for each face, at least 0.
    pub values: &'f [f64],
    /// The place of the greatest value.
    pub place: Option<[f64; 3]>,
    /// What else there is to say.
    pub note: &'f str,
}

/// The faces as a picture: at most 3,000 in colour, those with the greatest values, and as many of the others in
/// grey. `None` where there are none.
pub(crate) fn faces(faces: &ColouredFaces<'_>) -> Option<Markup> {
    let ColouredFaces { name, values_are, values, place, note, .. } = faces;
    let count = faces.faces.len().min(values.len());
    if count == 0 {
        return None;
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|one, other| values[*other].total_cmp(&values[*one]).then(one.cmp(other)));
    let (coloured, others) = order.split_at(count.min(MAX_COLOURED));
    let step = others.len().div_ceil(MAX_COLOURED).max(1);
    let grey: Vec<usize> = others.iter().copied().step_by(step).collect();
    let greatest = values[order[0]].max(0.0);
    let mut scene = Scene::default();
    let mut draw = |face: usize, class: &str| {
        let corners = faces.faces[face].iter().take(MAX_CORNERS);
        let corners: Vec<[f64; 3]> =
            corners.filter_map(|i| faces.points.get(*i)).copied().collect();
        scene.face(corners, class);
    };
    for &face in coloured {
        draw(face, heat(values[face], greatest));
    }
    for &face in &grey {
        draw(face, "h grey");
    }
    if let Some(place) = place {
        scene.mark([*place; 2]);
    }
    let (scene, height) = scene.drawn(Views::Opposite);
    let (bar, height) = bar(greatest, height);
    let capped = if others.is_empty() {
        String::new()
    } else {
        format!(
            " Of {count} faces the {} with the greatest values are in colour, and {} of the others in grey.",
            coloured.len(),
            grey.len()
        )
    };
    let at = if place.is_some() {
        " The ring is where it is greatest, also behind the faces."
    } else {
        ""
    };
    let says = format!(
        "{name}, the {values_are} of each face, from 0 to {}, seen from two opposite sides.{at}{capped}{}{note}",
        digits(greatest),
        if note.is_empty() { "" } else { " " }
    );
    let title = format!("{name}: the {values_are} as colours");
    let drawing = html! { (scene) (bar) };
    Some(html! {
        figure {
            (picture(&title, &says, height, &drawing))
            figcaption { (typeset(&says)) }
        }
    })
}

/// The class of a value among those from 0 to the greatest.
pub(super) fn heat(value: f64, greatest: f64) -> &'static str {
    let limits = (1..COLOURS).map(|place| greatest * f64::from(place) / f64::from(COLOURS));
    let place = limits.take_while(|limit| value > *limit).count();
    CLASSES[place]
}

/// The colours with their values, below a picture of this height.
fn bar(greatest: f64, height: f64) -> (Markup, f64) {
    let (left, side) = (WIDTH / 4.0, WIDTH / 2.0 / f64::from(COLOURS));
    let at = |place: u8| left + side * f64::from(place);
    let bar = html! {
        @for (place, class) in (0..COLOURS).zip(CLASSES) {
            rect class=(class) x=(at(place)) y=(height + 6.0) width=(side) height="12" {}
        }
        @for place in [0, COLOURS / 2, COLOURS] {
            @let value = greatest * f64::from(place) / f64::from(COLOURS);
            text.soft x=(at(place)) y=(height + 32.0) text-anchor="middle" { (digits(value)) }
        }
    };
    (bar, height + 40.0)
}

fn digits(value: f64) -> String {
    let exact: Option<Rational> = crate::float::exact(value);
    exact
        .filter(|exact| nearest(exact).is_finite())
        .map_or_else(|| "0".to_owned(), |exact| short(&exact, 3))
}
