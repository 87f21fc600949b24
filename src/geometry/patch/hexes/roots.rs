//! The pieces of level 1 of a solid.

use super::neighbourhood::{Parts, frames, least};
use crate::patch::mesh::roots::{Root, Roots};
use crate::patch::shapes::library::Shapes;
use crate::patch::shapes::neighbourhood::Neighbourhood;
use crate::solid::{Complex, SolidError};
use std::collections::HashMap;

/// The most shapes of neighbourhoods that weights are computed for.
const MAX_SHAPES: usize = 2_000;

/// The pieces of level 1 of a solid, and their shapes.
///
/// # Errors
/// When there are too many different shapes.
pub(crate) fn hex_roots(complex: &Complex, shapes: &mut Shapes) -> Result<Roots, SolidError> {
    let mut parts = Parts::new(complex);
    // Neighbourhoods that have been met, with their shapes and the orders of their points there.
    let mut orders: HashMap<Vec<u32>, (usize, Vec<u32>)> = HashMap::new();
    let mut roots = Roots { all: Vec::new(), points: Vec::new() };
    let frame = frames()[0];
    for part in 0..8 * complex.cells.len() {
        let raw = parts.around(part, &frame);
        if !orders.contains_key(&raw.key) {
            let best = least(&mut parts, part);
            let shape = shapes.shape(&best);
            if shapes.count() > MAX_SHAPES {
                let reason = format!(
                    "the cells meet in more than {MAX_SHAPES} different ways, which is too many \
                     for bounds of distances; take a more regular mesh, or a part of this one"
                );
                return Err(SolidError::TooMuch { reason });
            }
            orders.insert(raw.key.clone(), (shape, order(&raw, &best)));
        }
        let (shape, order) = &orders[&raw.key];
        let first = roots.points.len();
        let number = |place: &u32| u32::try_from(raw.points[*place as usize]).unwrap_or(u32::MAX);
        roots.points.extend(order.iter().map(number));
        roots.all.push(Root { face: part / 8, part: part % 8, shape: *shape, first });
    }
    Ok(roots)
}

/// Where the points of one list are in another one.
fn order(raw: &Neighbourhood, best: &Neighbourhood) -> Vec<u32> {
    let place = |point: &usize| raw.points.iter().position(|known| known == point);
    let index = |point: &usize| u32::try_from(place(point).unwrap_or(0)).unwrap_or(0);
    best.points.iter().map(index).collect()
}
