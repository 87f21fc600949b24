//! The hexahedron: how its corners, edges and faces are numbered.
//!
//! Corner j is at (j & 1, j >> 1 & 1, j >> 2 & 1) of a unit cube.

/// The corners in the order of files: around the bottom, then around the top above them.
pub(crate) const FILE_ORDER: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

/// The ends of the edges, four in each direction.
pub(super) const EDGES: [[usize; 2]; 12] = [
    [0, 1],
    [2, 3],
    [4, 5],
    [6, 7],
    [0, 2],
    [1, 3],
    [4, 6],
    [5, 7],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
];

/// The corners of the faces, counter-clockwise from outside. Face 2a + s is where coordinate a is s.
pub(crate) const FACES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// The edge between two corners that differ in one coordinate.
pub(super) fn edge_between(left: usize, right: usize) -> usize {
    let (low, axis) = (left.min(right), (left ^ right).trailing_zeros() as usize);
    // The other two coordinates, the lower one first.
    let bits = [0, 1, 2].into_iter().filter(|other| *other != axis).map(|other| low >> other & 1);
    4 * axis + bits.enumerate().map(|(place, bit)| bit << place).sum::<usize>()
}

/// A corner, or the middle of an edge, a face or the cell: where part `part` of a hexahedron, the one at
/// that corner, has its own corner `corner`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Middle {
    Corner(usize),
    Edge(usize),
    Face(usize),
    Cell,
}

/// Corner `corner` of the part of a hexahedron that is at its corner `part`: halfway between the two.
pub(super) fn middle(part: usize, corner: usize) -> Middle {
    let differ = part ^ corner;
    match differ.count_ones() {
        0 => Middle::Corner(part),
        1 => Middle::Edge(edge_between(part, corner)),
        2 => {
            let axis = (7 ^ differ).trailing_zeros() as usize;
            Middle::Face(2 * axis + (part >> axis & 1))
        }
        _ => Middle::Cell,
    }
}
