//! Legacy VTK, ascii: an unstructured grid of hexahedra or voxels.

use crate::diagnostic::{Diagnostic, SourceText};
use crate::mesh::{Parts, vtk_cell, vtk_solid};
use crate::solid::cube::FILE_ORDER;
use std::ops::Range;
use std::sync::Arc;

/// The types of cells that are read.
const VOXEL: usize = 11;
const HEXAHEDRON: usize = 12;

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let mut parts = Parts::new(source, 0);
    for ((corners, place), (kind, kind_place)) in vtk_solid(source, &mut parts)? {
        let corners = hexahedron(source, corners, &place, kind, kind_place)?;
        parts.face(corners, place)?;
    }
    Ok(parts)
}

/// The corners in the order of a hexahedron.
fn hexahedron(
    source: &Arc<SourceText>,
    corners: Vec<usize>,
    place: &Range<usize>,
    kind: usize,
    kind_place: Range<usize>,
) -> Result<Vec<usize>, Diagnostic> {
    if ![VOXEL, HEXAHEDRON].contains(&kind) {
        let message = format!("a cell of type {kind}{}", vtk_cell(kind));
        return Err(Diagnostic::new(source, kind_place, message)
            .with_place(place.clone(), "the cell")
            .with_help(
                "the scheme refines hexahedra (type 12) and voxels (11); save only the hexahedra",
            ));
    }
    if corners.len() != 8 {
        let message = format!("a hexahedron of {} corners; it has 8", corners.len());
        return Err(Diagnostic::new(source, place.clone(), message));
    }
    Ok(if kind == VOXEL { FILE_ORDER.map(|corner| corners[corner]).to_vec() } else { corners })
}
