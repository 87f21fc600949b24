//! The basic limit function of a mask on Z^d: contour lines, and its graph.

use super::faces::heat;
use super::plane::frame::{WIDTH, points};
use super::plane::panel::Panel;
use super::space::{Scene, Views};
use crate::exact::Rational;
use crate::facts::LatticeShape;
use crate::float::nearest;
use crate::scheme::Point;
use maud::html;
use std::collections::{BTreeMap, BTreeSet};

/// The height of the contour lines.
const HEIGHT: f64 = 420.0;
const MARGIN: f64 = 16.0;

/// The values of contour lines, in tenths of the greatest value.
const TENTHS: [i8; 14] = [-9, -7, -5, -3, -1, 1, 2, 3, 4, 5, 6, 7, 8, 9];

/// The greatest height of the graph, as a part of its width.
const STEEP: f64 = 0.5;

/// A corner of a triangle: its place in the plane, and the value there.
type Corner = ((f64, f64), f64);

/// Places and values of a shape.
struct Grid<'s> {
    values: BTreeMap<Point, f64>,
    /// M^{−k} applied to the first two unit vectors.
    steps: [(f64, f64); 2],
    shape: &'s LatticeShape,
}

impl<'s> Grid<'s> {
    fn of(shape: &'s LatticeShape) -> Grid<'s> {
        let step = |axis: usize| {
            let unit: Vec<Rational> = (0..shape.dilation.dimension())
                .map(|i| Rational::from(i64::from(i == axis)))
                .collect();
            let place = (0..shape.level).fold(unit, |x, _| shape.dilation.inverse_times(&x));
            (nearest(&place[0]), nearest(&place[1]))
        };
        let values = shape.values.iter().map(|(place, value)| (*place, nearest(value)));
        Grid { values: values.collect(), steps: [step(0), step(1)], shape }
    }

    fn value(&self, place: &Point) -> f64 {
        self.values.get(place).copied().unwrap_or(0.0)
    }

    #[allow(clippy::cast_precision_loss, reason = "indices of a picture are small")]
    fn corner(&self, place: Point) -> Corner {
        let [u, v] = self.steps;
        let (i, j) = (place[0] as f64, place[1] as f64);
        ((i * u.0 + j * v.0, i * u.1 + j * v.1), self.value(&place))
    }

    /// The corners (α, α + e₁, α + e₁ + e₂, α + e₂) of the cells at one of which φ is not 0.
    fn cells(&self) -> Vec<[Corner; 4]> {
        let mut cells = BTreeSet::new();
        for place in self.values.keys() {
            for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                cells.insert([place[0] - i, place[1] - j, place[2]]);
            }
        }
        let around = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let cell = |at: &Point| around.map(|(i, j)| self.corner([at[0] + i, at[1] + j, at[2]]));
        cells.iter().map(cell).collect()
    }

    /// The greatest absolute value.
    fn greatest(&self) -> f64 {
        self.values.values().fold(0.0, |most, value| value.abs().max(most))
    }

    /// What the values are of.
    fn places(&self) -> String {
        let level = self.shape.level;
        match self.shape.slice {
            None => format!("at the points M^-{level} α, α in Z^2"),
            Some(z) => {
                format!("at the points M^-{level} α, α in Z^3 with the third coordinate {z}")
            }
        }
    }
}

/// Contour lines of φ.
pub(crate) fn contours(scheme: &str, shape: &LatticeShape) -> Panel {
    let title = format!("{scheme}: contour lines of the basic limit function");
    let grid = Grid::of(shape);
    let (cells, greatest) = (grid.cells(), grid.greatest());
    let all = || cells.iter().flatten().map(|(place, _)| *place);
    let ends = |of: fn((f64, f64)) -> f64| {
        all().map(of).fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (x, y) = (ends(|place| place.0), ends(|place| place.1));
    let scale = ((WIDTH - 2.0 * MARGIN) / (x.1 - x.0)).min((HEIGHT - 2.0 * MARGIN) / (y.1 - y.0));
    let left = (WIDTH - scale * (x.1 - x.0)) / 2.0;
    let at = |(a, b): (f64, f64)| (left + scale * (a - x.0), HEIGHT - MARGIN - scale * (b - y.0));
    let drawing = html! {
        @for tenth in TENTHS {
            @let height = f64::from(tenth) / 10.0 * greatest;
            g class=(class(tenth)) {
                @for [from, to] in lines(&cells, height) {
                    polyline.line points=(points(&[at(from), at(to)])) {}
                }
            }
        }
    };
    let says = format!(
        "Lines at 1, 2, …, 9 tenths of the greatest of the exact values {}, which is {greatest:.4}, and at negative tenths where there are any. Between these values φ is taken to be linear.",
        grid.places()
    );
    Panel { title, says, height: HEIGHT, drawing }
}

/// The graph of φ, from two sides.
pub(crate) fn surface(scheme: &str, shape: &LatticeShape) -> Panel {
    let title = format!("{scheme}: the basic limit function");
    let grid = Grid::of(shape);
    let cells = grid.cells();
    let xs = || cells.iter().flatten().map(|((x, _), _)| *x);
    let width = xs().fold(f64::MIN, f64::max) - xs().fold(f64::MAX, f64::min);
    let scale = STEEP * width / grid.greatest();
    let mut scene = Scene::default();
    for cell in &cells {
        let corners = cell.map(|((x, y), value)| [x, y, value * scale]);
        let mean = cell.iter().map(|(_, value)| value.max(0.0)).sum::<f64>() / 4.0;
        scene.face(corners.to_vec(), heat(mean, grid.greatest()));
    }
    let (drawing, height) = scene.drawn(Views::Above);
    let says = format!(
        "Exact values {}, and heights that are scaled so that the greatest is {STEEP} of the width.",
        grid.places()
    );
    Panel { title, says, height, drawing }
}

fn class(tenth: i8) -> &'static str {
    match tenth {
        ..=0 => "c2",
        1..=3 => "c6",
        4..=6 => "c1",
        _ => "c3",
    }
}

/// The segments on which the values are a height, of each of the two triangles of a cell.
fn lines(cells: &[[Corner; 4]], height: f64) -> Vec<[(f64, f64); 2]> {
    let mut all = Vec::new();
    for [a, b, c, d] in cells {
        for triangle in [[a, b, c], [a, c, d]] {
            let sides = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (triangle[i], triangle[j]));
            let mut ends = sides.into_iter().filter_map(|(one, other)| crossed(one, other, height));
            if let (Some(from), Some(to)) = (ends.next(), ends.next()) {
                all.push([from, to]);
            }
        }
    }
    all
}

/// Where the values between two corners cross a height.
fn crossed(one: &Corner, other: &Corner, height: f64) -> Option<(f64, f64)> {
    let (below, above) = (one.1 < height, other.1 < height);
    (below != above).then(|| {
        let t = (height - one.1) / (other.1 - one.1);
        let between = |a: f64, b: f64| a + t * (b - a);
        (between(one.0.0, other.0.0), between(one.0.1, other.0.1))
    })
}
