//! What is no solid.

use subcert::exact::Rational;
use subcert::solid::{HexMesh, SolidError};

fn mesh(points: usize, cells: &[[usize; 8]]) -> Result<HexMesh<Rational>, SolidError> {
    let point = |k: usize| [k, k * k, 3 * k + 1].map(Rational::from);
    HexMesh::new((0..points).map(point).collect(), cells)
}

const FIRST: [usize; 8] = [0, 1, 2, 3, 4, 5, 6, 7];
const ABOVE: [usize; 8] = [4, 5, 6, 7, 8, 9, 10, 11];

#[test]
fn cells_that_fit() {
    let two = mesh(12, &[FIRST, ABOVE]).expect("a solid");
    assert_eq!((two.boundary_faces().len(), two.edges().len()), (10, 20));
    // Two solids that do not touch are one mesh.
    let apart = mesh(16, &[FIRST, FIRST.map(|k| k + 8)]).expect("two solids");
    assert_eq!(apart.boundary_faces().len(), 12);
}

#[test]
fn cells_that_do_not_fit() {
    let error = |points, cells: &[[usize; 8]]| mesh(points, cells).expect_err("no solid");
    assert_eq!(error(0, &[]), SolidError::Empty);
    assert_eq!(error(7, &[FIRST]), SolidError::NoPoint { cell: 0, point: 7, count: 7 });
    assert_eq!(error(8, &[[0, 1, 2, 3, 4, 5, 6, 0]]), SolidError::Twice { cell: 0, point: 0 });
    assert_eq!(error(9, &[FIRST]), SolidError::Isolated { point: 8 });
    // A third cell at the face 4, 5, 6, 7.
    let third = error(16, &[FIRST, ABOVE, [7, 6, 5, 4, 12, 13, 14, 15]]);
    assert!(matches!(third, SolidError::ThirdCell { cell: 2, first: 0, .. }), "{third:?}");
    // Inside out, in its place.
    let inside_out = error(12, &[FIRST, [8, 9, 10, 11, 4, 5, 6, 7]]);
    let expected =
        |error: &SolidError| matches!(error, SolidError::Orientation { cell: 1, first: 0, .. });
    assert!(expected(&inside_out), "{inside_out:?}");
    // Twice the same cell.
    assert!(expected(&error(8, &[FIRST, FIRST])));
    let twisted = error(12, &[FIRST, [4, 6, 5, 7, 8, 9, 10, 11]]);
    assert!(matches!(twisted, SolidError::Twisted { cell: 1, first: 0, .. }), "{twisted:?}");
    // Only an edge, or a point, in common.
    let edge = error(14, &[FIRST, [6, 7, 8, 9, 10, 11, 12, 13]]);
    assert!(matches!(edge, SolidError::Loose { point: 6, cell: 0 }), "{edge:?}");
    let point = error(15, &[FIRST, [7, 8, 9, 10, 11, 12, 13, 14]]);
    assert!(matches!(point, SolidError::Loose { point: 7, cell: 0 }), "{point:?}");
}

/// Cells around a point that hang together by faces, but enclose a gap that ends in an edge.
#[test]
fn a_gap_between_cells() {
    // 3 × 3 × 2 cells without the middle of the lower layer: the edges of the hole are fine. A ring of
    // columns that meets itself at an edge is not.
    let place = |x: usize, y: usize, z: usize| x + 4 * (y + 4 * z);
    let cell = |x: usize, y: usize, z: usize| {
        let square =
            |z| [place(x, y, z), place(x + 1, y, z), place(x + 1, y + 1, z), place(x, y + 1, z)];
        let (bottom, top) = (square(z), square(z + 1));
        std::array::from_fn(|k| if k < 4 { bottom[k] } else { top[k - 4] })
    };
    let wanted = |x: usize, y: usize, z: usize| (x, y) != (1, 1) || z == 1;
    let solid = |wanted: &dyn Fn(usize, usize, usize) -> bool| {
        let mut cells: Vec<[usize; 8]> = Vec::new();
        for index in 0..18 {
            let (x, y, z) = (index % 3, index / 3 % 3, index / 9);
            if wanted(x, y, z) {
                cells.push(cell(x, y, z));
            }
        }
        let mut used: Vec<usize> = cells.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        let number = |k: usize| used.iter().position(|x| *x == k).expect("used");
        let cells: Vec<[usize; 8]> = cells.iter().map(|cell| cell.map(number)).collect();
        mesh(used.len(), &cells)
    };
    assert!(solid(&wanted).is_ok());
    // Diagonal columns over a full layer: the edge between them is in cells that hang together only
    // by the layer below.
    let diagonal = |x: usize, y: usize, z: usize| z == 0 || (x == y && x < 2);
    let error = solid(&diagonal).expect_err("no solid");
    assert!(matches!(error, SolidError::Loose { .. }), "{error:?}");
}
