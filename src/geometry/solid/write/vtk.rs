//! Legacy VTK.

use super::super::hexes::HexMesh;
use crate::exact::Rational;
use crate::mesh::{BeyondF64, decimals, one_line};
use std::fmt::Write as _;

/// The most characters of a title in VTK.
const MAX_TITLE: usize = 255;

/// A solid as legacy VTK: the nearest f64 of each coordinate, as the shortest decimal that reads back.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, to_vtk};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// assert!(to_vtk(&mesh, "a cube")?.ends_with("CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n12\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_vtk(mesh: &HexMesh<Rational>, title: &str) -> Result<String, BeyondF64> {
    let title: String = one_line(title).chars().take(MAX_TITLE).collect();
    let mut text = format!(
        "# vtk DataFile Version 3.0\n{title}\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
        mesh.points().len()
    );
    for point in mesh.points() {
        writeln!(text, "{}", decimals(point)?.join(" ")).expect("memory");
    }
    let cells = mesh.cells();
    writeln!(text, "CELLS {} {}", cells.len(), 9 * cells.len()).expect("memory");
    for cell in &cells {
        let corners = cell.map(|corner| corner.to_string());
        writeln!(text, "8 {}", corners.join(" ")).expect("memory");
    }
    writeln!(text, "CELL_TYPES {}", cells.len()).expect("memory");
    text.push_str(&"12\n".repeat(cells.len()));
    Ok(text)
}
