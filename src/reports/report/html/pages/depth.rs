//! Pictures of depths: distances as colours, bounds against the level, data that need one level more, and control
//! polygons.

use super::finding::Picture;
use crate::audit::{Attained, Refiner};
use crate::claim::Quantity;
use crate::exact::{Rational, format::short};
use crate::float::nearest;
use crate::report::html::picture::{self, ColouredFaces, Exceeding, FarPolygon, LevelChart, Line};

/// A line of a picture of levels.
#[derive(Clone, Debug)]
pub struct LevelLine {
    /// Its name, in a word or two.
    pub name: String,
    /// Levels, with the values there; only positive ones are drawn.
    pub values: Vec<(u32, f64)>,
    /// The level from which on the tolerance is met.
    pub met: Option<u32>,
    /// Whether these are constants, which are not compared with the tolerance.
    pub is_constant: bool,
}

/// Bounds and distances against the level.
#[derive(Clone, Debug)]
pub struct Levels<'l> {
    /// The tolerance ε.
    pub tolerance: &'l Rational,
    /// The lines, at most four.
    pub lines: Vec<LevelLine>,
    /// Levels that a formula promises to be enough, with what is said of them.
    pub promised: Vec<(u32, String)>,
}

impl Picture {
    /// Faces in colours by their values, from two opposite sides; `None` where there are none.
    ///
    /// ```
    /// use subcert::report::html::{ColouredFaces, Picture};
    ///
    /// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let (values_are, note) = ("distance at level 0".to_owned(), "");
    /// let (faces, values) = (&[vec![0, 1, 2]][..], &[0.5][..]);
    /// let faces = ColouredFaces { name: "a", values_are, points: &points, faces, values, place: None, note };
    /// assert!(Picture::of_faces(&faces).is_some());
    /// ```
    #[must_use]
    pub fn of_faces(faces: &ColouredFaces<'_>) -> Option<Picture> {
        picture::faces(faces).map(Picture)
    }

    /// Values against the level on a logarithmic scale; `None` where none is positive.
    #[must_use]
    pub fn of_levels(levels: &Levels<'_>) -> Option<Picture> {
        let Levels { tolerance, lines, promised } = levels;
        let names: Vec<&str> = lines.iter().map(|line| line.name.as_str()).collect();
        let met = lines.iter().filter_map(|line| Some((line, line.met?)));
        let met =
            met.map(|(line, level)| format!(" The {} meets it from level {level} on.", line.name));
        let says = format!(
            "The {} against the level, on a logarithmic scale. The line across is the tolerance ε = {}.{}",
            names.join(", the "),
            short(*tolerance, 6),
            met.collect::<String>()
        );
        let line = |(line, class): (&LevelLine, &'static str)| Line {
            name: line.name.clone(),
            class,
            is_dashed: line.is_constant,
            values: line.values.clone(),
            ring: line.met,
        };
        let chart = LevelChart {
            title: "Against the level".to_owned(),
            says,
            tolerance: nearest(*tolerance),
            lines: lines.iter().zip(["c1", "c2", "c3", "c4"]).map(line).collect(),
            promised: promised.clone(),
        };
        chart.drawn().map(Picture)
    }

    /// Control data that are too far from their limit at a level, for the spread 1: points of level k are at
    /// (i + s)/n^k, of a net and (j + t)/m^k, with s and t in `shift`. `None` where there is no picture of the data.
    #[must_use]
    pub fn of_data(
        refiner: &Refiner,
        attained: &Attained,
        level: u32,
        most: &Rational,
        shift: [f64; 2],
    ) -> Option<Picture> {
        let (quantity, most, said) = (Quantity::Distance, most.clone().into(), "wanted");
        picture::witness(refiner, &Exceeding { quantity, level, attained, most, said, shift })
            .map(Picture)
    }

    /// A control polygon with its limit, and the place of the greatest distance.
    #[must_use]
    pub fn of_polygon(polygon: &FarPolygon<'_>) -> Vec<Picture> {
        picture::control_polygon(polygon).into_iter().map(Picture).collect()
    }
}
