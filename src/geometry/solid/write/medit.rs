//! MEDIT.

use super::super::hexes::HexMesh;
use crate::exact::Rational;
use crate::mesh::{BeyondF64, decimals, one_line};
use std::fmt::Write as _;

/// A solid as MEDIT `.mesh`, ascii: the nearest f64 of each coordinate, as the shortest decimal that
/// reads back. All references are 0.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, to_medit};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// assert!(to_medit(&mesh, "a cube")?.ends_with("Hexahedra\n1\n1 2 4 3 5 6 8 7 0\nEnd\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_medit(mesh: &HexMesh<Rational>, title: &str) -> Result<String, BeyondF64> {
    let mut text = format!(
        "MeshVersionFormatted 2\n# {}\nDimension 3\nVertices\n{}\n",
        one_line(title),
        mesh.points().len()
    );
    for point in mesh.points() {
        writeln!(text, "{} 0", decimals(point)?.join(" ")).expect("memory");
    }
    let cells = mesh.cells();
    writeln!(text, "Hexahedra\n{}", cells.len()).expect("memory");
    for cell in &cells {
        let corners = cell.map(|corner| (corner + 1).to_string());
        writeln!(text, "{} 0", corners.join(" ")).expect("memory");
    }
    text.push_str("End\n");
    Ok(text)
}
