//! Regular pieces, which nearly all are after a few levels: their points are found without unfolding what is around them.

use super::neighbourhood::Neighbourhood;
use crate::mesh::{Connectivity, Tags};
use crate::patch::number::index;

/// The most vertices of a regular face, and faces around a regular vertex.
const MOST: [usize; 2] = [4, 6];

/// The faces around the vertices of a regular face, from the face itself on, and which of their vertices these are.
pub(crate) struct Fans {
    /// How many vertices each face has, and how many faces each vertex.
    count: usize,
    valence: usize,
    faces: [[(usize, usize); MOST[1]]; MOST[0]],
}

impl Fans {
    /// Those of a triangle at three inner vertices of valence 6 with triangles around, or of a quadrilateral at four of
    /// valence 4 with quadrilaterals, where nothing is sharp in the mesh.
    pub(crate) fn of(connectivity: &Connectivity, tags: &Tags, face: usize) -> Option<Fans> {
        let count = connectivity.faces()[face].len();
        let valence = match count {
            3 => 6,
            4 => 4,
            _ => return None,
        };
        if !tags.is_plain() {
            return None;
        }
        let mut fans = Fans { count, valence, faces: [[(face, 0); MOST[1]]; MOST[0]] };
        for (corner, fan) in fans.faces[..count].iter_mut().enumerate() {
            let start = (face, corner);
            let mut at = start;
            for (r, place) in fan[..valence].iter_mut().enumerate() {
                if connectivity.faces()[at.0].len() != count || r > 0 && at == start {
                    return None;
                }
                *place = at;
                at = connectivity.next(at)?;
            }
            if at != start {
                return None;
            }
        }
        Some(fans)
    }

    /// Point `turn` of a face of a fan, from the vertex on.
    fn point(&self, connectivity: &Connectivity, [fan, r, turn]: [usize; 3]) -> usize {
        let (face, corner) = self.faces[fan][r];
        connectivity.faces()[face][(corner + turn) % self.count]
    }
}

/// Where the points of the [`Neighbourhood`] of a regular piece are in its fans; this is the same for all of them.
pub(crate) struct Regular {
    pub(crate) shape: usize,
    count: usize,
    places: Vec<[usize; 3]>,
}

impl Regular {
    /// As it is in the neighbourhood of this piece; `None` where two points are one in the mesh.
    pub(crate) fn new(
        connectivity: &Connectivity,
        fans: &Fans,
        neighbourhood: &Neighbourhood,
        shape: usize,
    ) -> Option<Regular> {
        let (count, valence) = (fans.count, fans.valence);
        let all = || {
            (0..count).flat_map(|fan| {
                (0..valence).flat_map(move |r| (0..count).map(move |turn| [fan, r, turn]))
            })
        };
        let place = |&point: &usize| all().find(|at| fans.point(connectivity, *at) == point);
        let places = neighbourhood.points.iter().map(place).collect::<Option<Vec<_>>>()?;
        let mut points = neighbourhood.points.clone();
        points.sort_unstable();
        points.dedup();
        (points.len() == places.len()).then_some(Regular { shape, count, places })
    }

    /// Whether these are fans of such a piece.
    pub(crate) fn has(&self, fans: &Fans) -> bool {
        self.count == fans.count
    }

    /// Appends the points of a piece with these fans.
    pub(crate) fn points(&self, connectivity: &Connectivity, fans: &Fans, points: &mut Vec<u32>) {
        let point = |at: &[usize; 3]| index(fans.point(connectivity, *at));
        points.extend(self.places.iter().map(point));
    }
}
