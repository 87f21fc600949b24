//! Shapes in space, seen from two sides: those behind are drawn first.

use crate::report::html::picture::plane::frame::WIDTH;
use maud::{Markup, html};

/// A point in space.
pub(super) type Place = [f64; 3];

/// The greatest height of the pictures.
const MAX_HEIGHT: f64 = 300.0;

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

    /// Both views side by side, each of its own size; what stands below them begins at the height.
    pub(super) fn drawn(&self, views: Views) -> (Markup, f64) {
        let width = WIDTH / 2.0;
        let panels = views.angles().into_iter().zip([0.0, width]);
        let panels: Vec<(&str, Panel)> = panels
            .map(|((name, around, above), left)| {
                (name, self.panel(Camera::at(around, above), (left, width)))
            })
            .collect();
        let height = panels.iter().map(|(_, panel)| panel.height()).fold(0.0, f64::max);
        let drawing = html! {
            @for (name, panel) in &panels {
                (self.view(panel, height))
                text.soft x=(panel.left + width / 2.0) y=(height + 12.0) text-anchor="middle" { (name) }
            }
        };
        (drawing, height + 24.0)
    }

    fn panel(&self, camera: Camera, (left, width): (f64, f64)) -> Panel {
        let places = self.shapes.iter().flat_map(|shape| &shape.corners);
        let all: Vec<(f64, f64)> =
            places.chain(self.marks.iter().flatten()).map(|place| camera.plane(place)).collect();
        let side = |of: fn(&(f64, f64)) -> f64| {
            let values = all.iter().map(of);
            values.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)))
        };
        let (x, y) = (side(|place| place.0), side(|place| place.1));
        let room = [(width, x), (MAX_HEIGHT, y)]
            .map(|(room, (low, high))| (room - 2.0 * MARGIN) / (high - low).max(f64::MIN_POSITIVE));
        Panel { camera, left, width, x, y, scale: room[0].min(room[1]) }
    }

    fn view(&self, panel: &Panel, height: f64) -> Markup {
        let at = |place: &Place| panel.at(place, height);
        let depth = |shape: &Shape| panel.camera.depth(&shape.corners);
        let mut order: Vec<(f64, &Shape)> =
            self.shapes.iter().map(|shape| (depth(shape), shape)).collect();
        order.sort_by(|one, other| one.0.total_cmp(&other.0));
        html! {
            @for (_, shape) in order {
                path class=(shape.class) d=(path(shape, at)) {}
            }
            @for [one, other] in &self.marks {
                @let (one, other) = (at(one), at(other));
                line.bad x1=(one.0) y1=(one.1) x2=(other.0) y2=(other.1) {}
                @for (x, y) in [one, other] {
                    circle.halo cx=(x) cy=(y) r="4.5" {}
                    circle.bad cx=(x) cy=(y) r="4.5" {}
                }
            }
        }
    }
}

/// A view in its half of the picture.
struct Panel {
    camera: Camera,
    left: f64,
    width: f64,
    /// The ends of all shapes, to the right and upwards.
    x: (f64, f64),
    y: (f64, f64),
    scale: f64,
}

impl Panel {
    fn height(&self) -> f64 {
        (self.scale * (self.y.1 - self.y.0) + 2.0 * MARGIN).ceil()
    }

    fn at(&self, place: &Place, height: f64) -> (f64, f64) {
        let (right, up) = self.camera.plane(place);
        let x =
            self.left + self.width / 2.0 + self.scale * (right - f64::midpoint(self.x.0, self.x.1));
        let y = height / 2.0 - self.scale * (up - f64::midpoint(self.y.0, self.y.1));
        (tenth(x), tenth(y))
    }
}

/// The commands of a path, with steps from corner to corner: these are short.
fn path(shape: &Shape, at: impl Fn(&Place) -> (f64, f64)) -> String {
    let places: Vec<(f64, f64)> = shape.corners.iter().map(at).collect();
    let Some((x, y)) = places.first() else { return String::new() };
    let steps = places.windows(2).map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        format!("{} {}", tenth(to.0 - from.0), tenth(to.1 - from.1))
    });
    let end = if shape.closed { "z" } else { "" };
    format!("M{x} {y}l{}{end}", steps.collect::<Vec<String>>().join(" "))
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
