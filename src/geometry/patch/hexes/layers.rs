//! Pieces that are the same in each layer: a surface times a line (`proofs/THEOREMS.md`, 102).

use crate::patch::number::index;
use std::collections::{BTreeMap, BTreeSet};

/// How many layers of points a piece of this kind has.
const COUNT: usize = 4;

/// The points of the layers, each in the same order: column i has point i of each. Column 0 has a corner of
/// the piece.
pub(crate) type Layers = [Vec<u32>; COUNT];

/// The layers of the cells around a piece, which comes first with corners 0 to 7; `None` where the cells
/// are not the same in three layers.
pub(super) fn layers(points: usize, cells: &[[usize; 8]]) -> Option<Layers> {
    (0..3).find_map(|axis| along(axis, points, cells))
}

fn along(axis: usize, points: usize, cells: &[[usize; 8]]) -> Option<Layers> {
    // The point above each, in the direction of the axis in the first cell.
    let mut above: BTreeMap<usize, usize> = BTreeMap::new();
    let mut below: BTreeMap<usize, usize> = BTreeMap::new();
    for corners in cells {
        for low in (0..8).filter(|corner| corner >> axis & 1 == 0) {
            let (low, high) = (corners[low], corners[low | 1 << axis]);
            if *above.entry(low).or_insert(high) != high || *below.entry(high).or_insert(low) != low
            {
                return None;
            }
        }
    }
    let lowest: Vec<usize> = (0..points).filter(|point| !below.contains_key(point)).collect();
    let mut columns: Vec<[usize; COUNT]> = Vec::with_capacity(lowest.len());
    for point in lowest {
        let mut column = [point; COUNT];
        for layer in 1..COUNT {
            column[layer] = *above.get(&column[layer - 1])?;
        }
        if above.contains_key(&column[COUNT - 1]) {
            return None;
        }
        columns.push(column);
    }
    if COUNT * columns.len() != points {
        return None;
    }
    let first = columns.iter().position(|column| column[1] == 0)?;
    columns.swap(0, first);
    let place = |point: usize| {
        columns.iter().enumerate().find_map(|(column, points)| {
            Some((column, points.iter().position(|known| *known == point)?))
        })
    };
    let places: Option<Vec<(usize, usize)>> = (0..points).map(place).collect();
    let places = places?;
    // The columns of the cells of each layer.
    let mut sections: [BTreeSet<Vec<usize>>; COUNT - 1] = Default::default();
    for corners in cells {
        let low: Vec<(usize, usize)> = (0..8)
            .filter(|corner| corner >> axis & 1 == 0)
            .map(|corner| places[corners[corner]])
            .collect();
        let layer = low[0].1;
        let mut section: Vec<usize> = low.iter().map(|(column, _)| *column).collect();
        section.sort_unstable();
        let flat = layer + 1 < COUNT && low.iter().all(|(_, own)| *own == layer);
        if !flat || !sections[layer].insert(section) {
            return None;
        }
    }
    let same = sections.windows(2).all(|pair| pair[0] == pair[1]);
    let layer = |layer: usize| columns.iter().map(|column| index(column[layer])).collect();
    same.then(|| [layer(0), layer(1), layer(2), layer(3)])
}
