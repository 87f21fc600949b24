//! Shapes in space, seen from two sides: those behind are drawn first.

use super::frame::WIDTH;
use maud::{Markup, html};

/// A point in space.
pub(super) type Place = [f64; 3];

/// The height of the pictures.
const HEIGHT: f64 = 300.0;

/// What is left free around the shapes.
const MARGIN: f64 = 14.0;

/// From where the shapes are seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Views {
    /// From above, from two corners: for graphs of functions.
    Above,
    /// From two opposite sides: what one does not show, the other mostly does.
    Opposite,
}

impl Views {
    /// For each view its name, and two angles in degrees: around the z axis, and above the plane of x and y.
    fn angles(self) -> [(&'static str, f64, f64); 2] {
        match self {
            Views::Above => [("from the right", -62.0, 24.0), ("from the left", -118.0, 24.0)],
            Views::Opposite => [("one side", -58.0, 24.0), ("the other side", 122.0, -24.0)],
        }
    }
}

/// A shape with its class.
struct Shape {
    corners: Vec<Place>,
    class: String,
    /// Whether it is a face; otherwise a line.
    closed: bool,
}

/// Shapes, and marks that are drawn before all of them.
#[derive(Default)]
pub(super) struct Scene {
    shapes: Vec<Shape>,
    marks: Vec<[Place; 2]>,
}

impl Scene {
    /// A face.
    pub(super) fn face(&mut self, corners: Vec<Place>, class: impl Into<String>) {
        self.shapes.push(Shape { corners, class: class.into(), closed: true });
    }

    /// A line.
    pub(super) fn line(&mut self, corners: Vec<Place>, class: impl Into<String>) {
        self.shapes.push(Shape { corners, class: class.into(), closed: false });
    }

    /// Two points that are compared.
    pub(super) fn mark(&mut self, ends: [Place; 2]) {
        self.marks.push(ends);
    }

    /// Both views side by side; what stands below them begins at this height.
    pub(super) fn drawn(&self, views: Views) -> (Markup, f64) {
        let width = WIDTH / 2.0;
        let panels = views.angles().into_iter().zip([0.0, width]);
        let drawing = html! {
            @for ((name, around, above), left) in panels {
                (self.view(Camera::at(around, above), (left, width)))
                text.soft x=(left + width / 2.0) y=(HEIGHT + 12.0) text-anchor="middle" { (name) }
            }
        };
        (drawing, HEIGHT + 24.0)
    }

    fn view(&self, camera: Camera, (left, width): (f64, f64)) -> Markup {
        let places = self.shapes.iter().flat_map(|shape| &shape.corners);
        let all: Vec<(f64, f64)> =
            places.chain(self.marks.iter().flatten()).map(|place| camera.plane(place)).collect();
        let side = |of: fn(&(f64, f64)) -> f64| {
            let values = all.iter().map(of);
            values.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)))
        };
        let (x, y) = (side(|place| place.0), side(|place| place.1));
        let room = [(width, x), (HEIGHT, y)]
            .map(|(room, (low, high))| (room - 2.0 * MARGIN) / (high - low).max(f64::MIN_POSITIVE));
        let scale = room[0].min(room[1]);
        let middle = (f64::midpoint(x.0, x.1), f64::midpoint(y.0, y.1));
        let at = |place: &Place| {
            let (right, up) = camera.plane(place);
            let x = left + width / 2.0 + scale * (right - middle.0);
            let y = HEIGHT / 2.0 - scale * (up - middle.1);
            (tenth(x), tenth(y))
        };
        let mut order: Vec<(f64, &Shape)> =
            self.shapes.iter().map(|shape| (camera.depth(&shape.corners), shape)).collect();
        order.sort_by(|one, other| one.0.total_cmp(&other.0));
        html! {
            @for (_, shape) in order {
                path class=(shape.class) d=(path(shape, at)) {}
            }
            @for [one, other] in &self.marks {
                @let (one, other) = (at(one), at(other));
                line.bad x1=(one.0) y1=(one.1) x2=(other.0) y2=(other.1) {}
                circle.bad cx=(one.0) cy=(one.1) r="3.5" {}
                circle.bad cx=(other.0) cy=(other.1) r="3.5" {}
            }
        }
    }
}

/// The commands of a path, with steps from corner to corner: these are short.
fn path(shape: &Shape, at: impl Fn(&Place) -> (f64, f64)) -> String {
    let mut text = String::new();
    let mut last: Option<(f64, f64)> = None;
    for (x, y) in shape.corners.iter().map(at) {
        match last {
            None => text.push_str(&format!("M{x} {y}l")),
            Some((from_x, from_y)) => {
                text.push_str(&format!("{} {} ", tenth(x - from_x), tenth(y - from_y)));
            }
        }
        last = Some((x, y));
    }
    let end = text.trim_end().len();
    text.truncate(end);
    text.extend(shape.closed.then_some('z'));
    text
}

/// To a tenth of a pixel.
fn tenth(x: f64) -> f64 {
    // Not −0.
    (x * 10.0).round() / 10.0 + 0.0
}

/// A direction from which all is seen, without perspective.
struct Camera {
    right: Place,
    up: Place,
    /// From the shapes to the eye.
    toward: Place,
}

impl Camera {
    fn at(around: f64, above: f64) -> Camera {
        let (sin, cos) = around.to_radians().sin_cos();
        let (rise, flat) = above.to_radians().sin_cos();
        Camera {
            right: [-sin, cos, 0.0],
            up: [-rise * cos, -rise * sin, flat],
            toward: [flat * cos, flat * sin, rise],
        }
    }

    fn plane(&self, place: &Place) -> (f64, f64) {
        (dot(&self.right, place), dot(&self.up, place))
    }

    /// How near to the eye the middle of the corners is.
    fn depth(&self, corners: &[Place]) -> f64 {
        let count = f64::from(u32::try_from(corners.len()).unwrap_or(u32::MAX)).max(1.0);
        corners.iter().map(|place| dot(&self.toward, place)).sum::<f64>() / count
    }
}

fn dot(one: &Place, other: &Place) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
