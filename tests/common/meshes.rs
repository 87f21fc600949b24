//! Faces of meshes of tests.

/// The faces of a prism over a polygon of n vertices, the points of one polygon before those of the other.
pub fn prism_faces(n: usize) -> Vec<Vec<usize>> {
    let sides = (0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]);
    sides.chain([(0..n).rev().collect(), (n..2 * n).collect()]).collect()
}

/// The quadrilaterals of a grid of points, row by row, or the two triangles of each.
pub fn grid_faces(rows: usize, columns: usize, triangles: bool) -> Vec<Vec<usize>> {
    let mut faces = Vec::new();
    for i in 0..rows - 1 {
        for j in 0..columns - 1 {
            let k = i * columns + j;
            if triangles {
                faces.push(vec![k, k + 1, k + columns + 1]);
                faces.push(vec![k, k + columns + 1, k + columns]);
            } else {
                faces.push(vec![k, k + 1, k + columns + 1, k + columns]);
            }
        }
    }
    faces
}
