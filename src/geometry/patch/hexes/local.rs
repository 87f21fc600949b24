//! What one level makes of a hexahedron and those around it, as rows of weights.

use super::across::across;
use super::grid::Grid;
use super::layers::{Layers, layers};
use super::neighbourhood::{Parts, least};
use crate::exact::{Rational, RealCyclotomic};
use crate::patch::number::{Number, Row, index};
use crate::patch::shapes::neighbourhood::Neighbourhood;
use crate::patch::shapes::rules::{Rules, mean_of, rows};
use crate::solid::{Complex, limit_rows, part_corners, refined_points};

/// A hexahedron, which comes first, with all that share a corner with it. Corners 0 to 7 are its own.
pub(crate) struct HexLocal {
    pub(crate) complex: Complex,
    grid: Option<Grid>,
    /// Of a piece that is not regular.
    pub(crate) layers: Option<Layers>,
}

/// The neighbourhoods of the eight parts of the first cell.
pub(crate) fn parts_of(complex: &Complex) -> Vec<Neighbourhood> {
    let mut parts = Parts::new(complex);
    (0..8).map(|part| least(&mut parts, part)).collect()
}

impl HexLocal {
    /// # Panics
    /// Never: a part of a solid fits together.
    pub(crate) fn new(points: usize, cells: &[Vec<usize>]) -> HexLocal {
        let corners = |cell: &Vec<usize>| std::array::from_fn(|corner| cell[corner]);
        let cells: Vec<[usize; 8]> = cells.iter().map(corners).collect();
        let grid = Grid::of(points, &cells);
        let layers = if grid.is_none() { layers(points, &cells) } else { None };
        let complex = Complex::new(points, cells).expect("a part of a solid");
        HexLocal { complex, grid, layers }
    }

    /// The weights, where the parts need these points of the next level; `parts` has the points of each
    /// part among all points of the next level, its corners first.
    pub(crate) fn rules<W: Number>(&self, wanted: &[usize], parts: &[Vec<usize>]) -> Rules<W> {
        let own: Vec<Row<W>> = (0..8).map(|corner| mean_of(&[corner])).collect();
        let base: Vec<Vec<Row<W>>> = parts.iter().map(|points| self.split(&points[..8])).collect();
        let weight = |(point, weight): (usize, Rational)| {
            (index(point), W::of(&RealCyclotomic::from(weight)))
        };
        let limit = |row: Vec<(usize, Rational)>| row.into_iter().map(weight).collect();
        let limits = limit_rows(&self.complex, &(0..8).collect::<Vec<usize>>());
        let refined =
            rows(self.complex.points, wanted, |units| refined_points(&self.complex, &units));
        let across = self
            .layers
            .as_ref()
            .map(|layers| across(&self.complex, layers, wanted, &refined, parts));
        Rules {
            refined,
            across,
            split: base.clone(),
            base,
            nodes: own.iter().map(|row| (row.clone(), row.clone())).collect(),
            own: Some(own),
            limits: limits.into_iter().map(limit).collect(),
            regular: self.grid.as_ref().map(|grid| (grid.bezier(), grid.bends())),
        }
    }

    /// The trilinear interpolant of the first cell at these points of the next level, which are corners of
    /// its parts.
    fn split<W: Number>(&self, corners: &[usize]) -> Vec<Row<W>> {
        let row = |corner: &usize| {
            let place = (0..64).find(|place| {
                let [part, own] = [place / 8, place % 8];
                part_corners(&self.complex, 0, part)[own] == *corner
            });
            // Halfway between two corners of a cube: the mean of those that agree where they do.
            let [part, own] = [place.unwrap_or(0) / 8, place.unwrap_or(0) % 8];
            let between = |corner: &usize| (corner ^ part) & !(part ^ own) == 0;
            mean_of(&(0..8).filter(between).collect::<Vec<usize>>())
        };
        corners.iter().map(row).collect()
    }
}
