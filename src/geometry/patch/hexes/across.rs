//! A piece that is the same in each layer, divided in the section only: its layers stay as far from each
//! other as they are (`proofs/THEOREMS.md`, 102).

use super::grid::MASKS;
use super::layers::Layers;
use crate::patch::number::{Number, Row, index};
use crate::patch::shapes::regular::number;
use crate::solid::Complex;
use std::collections::{BTreeMap, BTreeSet};

/// The weights of such a piece.
#[derive(Clone, Debug)]
pub(crate) struct Across<W> {
    /// The parts of the section.
    pub(crate) parts: Vec<AcrossPart<W>>,
    /// For each Bézier coefficient across the layers, and each corner of the section: the point of the
    /// coefficient's section there, and that of the trilinear interpolant.
    pub(crate) nodes: Vec<(Row<W>, Row<W>)>,
}

/// A part of the section with all layers.
#[derive(Clone, Debug)]
pub(crate) struct AcrossPart<W> {
    /// The part of the piece whose shape it has.
    pub(crate) part: usize,
    /// Its points, over those of the piece.
    pub(crate) points: Vec<Row<W>>,
    /// Its corners in the interpolant of the piece, over the corners of the piece.
    pub(crate) base: Vec<Row<W>>,
}

/// Where points of the next level are: the columns that they are in the middle of, and twice their height in
/// layers.
struct Places<'a> {
    complex: &'a Complex,
    /// The column and the layer of each point.
    of: Vec<(usize, usize)>,
}

impl Places<'_> {
    fn place(&self, point: usize) -> (BTreeSet<usize>, usize) {
        let complex = self.complex;
        let (vertices, edges) = (complex.points, complex.points + complex.edges.len());
        let faces = edges + complex.faces.len();
        let around: &[usize] = match point {
            _ if point < vertices => &[point],
            _ if point < edges => &complex.edges[point - vertices],
            _ if point < faces => &complex.faces[point - edges].corners,
            _ => &complex.cells[point - faces],
        };
        let height: usize = around.iter().map(|&point| self.of[point].1).sum();
        (around.iter().map(|&point| self.of[point].0).collect(), 2 * height / around.len())
    }
}

/// The weights of a piece with these layers; `rows` are those of the points of its parts, in 3 dimensions.
pub(super) fn across<W: Number>(
    complex: &Complex,
    layers: &Layers,
    wanted: &[usize],
    rows: &[Row<W>],
    parts: &[Vec<usize>],
) -> Across<W> {
    let mut of = vec![(0, 0); complex.points];
    for (layer, points) in layers.iter().enumerate() {
        for (column, &point) in points.iter().enumerate() {
            of[point as usize] = (column, layer);
        }
    }
    let places = Places { complex, of };
    let row_of: BTreeMap<usize, &Row<W>> = wanted.iter().copied().zip(rows).collect();
    let mut all = Vec::new();
    for (part, points) in parts.iter().enumerate() {
        let found: Vec<(BTreeSet<usize>, usize)> =
            points.iter().map(|&point| places.place(point)).collect();
        let least = found.iter().map(|(_, height)| *height).min().unwrap_or(0);
        // Of the two parts above each other the lower one: its layers are at 1/2, 1, 3/2 and 2.
        if least != 1 {
            continue;
        }
        let layer = |height: usize| height - least;
        let point = |(point, (_, height)): (&usize, &(BTreeSet<usize>, usize))| {
            let mut section: BTreeMap<u32, W> = BTreeMap::new();
            for (old, weight) in row_of[point] {
                let column = places.of[*old as usize].0;
                let at = layers[layer(*height)][column];
                section
                    .entry(at)
                    .and_modify(|sum| sum.accumulate(weight))
                    .or_insert_with(|| weight.clone());
            }
            section.into_iter().collect()
        };
        let corner = |(columns, height): &(BTreeSet<usize>, usize)| {
            let mean: Vec<u32> = (0..8)
                .filter(|&own| {
                    let (column, own_layer) = places.of[own];
                    own_layer == layer(*height) && columns.contains(&column)
                })
                .map(index)
                .collect();
            let share: W = number(1, i64::try_from(mean.len()).unwrap_or(1).max(1));
            mean.into_iter().map(|own| (own, share.clone())).collect()
        };
        all.push(AcrossPart {
            part,
            points: points.iter().zip(&found).map(point).collect(),
            base: found[..8].iter().map(corner).collect(),
        });
    }
    Across { parts: all, nodes: nodes(&places, layers) }
}

fn nodes<W: Number>(places: &Places<'_>, layers: &Layers) -> Vec<(Row<W>, Row<W>)> {
    let corners = |layer: usize| (0..8).filter(move |&own| places.of[own].1 == layer);
    let mut nodes = Vec::with_capacity(16);
    for (high, mask) in (0..4_i64).zip(MASKS) {
        for low_corner in corners(1) {
            let column = places.of[low_corner].0;
            let weights = layers.iter().zip(mask).filter(|(_, weight)| *weight != 0);
            let row = weights.map(|(layer, weight)| (layer[column], number(weight, 6)));
            let above = corners(2).filter(|&own| places.of[own].0 == column);
            let low = [(index(low_corner), 3 - high)].into_iter();
            let plain = low.chain(above.map(|own| (index(own), high)));
            let plain = plain.filter(|(_, weight)| *weight != 0);
            nodes.push((row.collect(), plain.map(|(own, w)| (own, number(w, 3))).collect()));
        }
    }
    nodes
}
