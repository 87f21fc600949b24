//! Parts of a mesh.

use super::connectivity::Connectivity;
use super::crease::Tags;
use super::error::MeshError;
use super::point::Point;
use super::polygon::PolygonMesh;
use std::collections::{HashMap, HashSet};

/// These faces, and all that are up to so many steps from them, from vertex to vertex.
pub(crate) fn grown(connectivity: &Connectivity, faces: &[usize], steps: u32) -> Vec<usize> {
    let mut all = faces.to_vec();
    let mut met: HashSet<usize> = faces.iter().copied().collect();
    let mut begin = 0;
    for _ in 0..steps {
        let end = all.len();
        for at in begin..end {
            for &vertex in &connectivity.faces()[all[at]] {
                for face in connectivity.star(vertex).faces {
                    if met.insert(face) {
                        all.push(face);
                    }
                }
            }
        }
        begin = end;
    }
    all
}

/// The faces in groups of at most `size` that hang together, as far as they do.
pub(crate) fn groups(connectivity: &Connectivity, faces: &[usize], size: usize) -> Vec<Vec<usize>> {
    let mut left: HashSet<usize> = faces.iter().copied().collect();
    let mut groups = Vec::new();
    for &start in faces {
        if !left.remove(&start) {
            continue;
        }
        let mut group = vec![start];
        let mut at = 0;
        while at < group.len() && group.len() < size {
            for &vertex in &connectivity.faces()[group[at]] {
                for face in connectivity.star(vertex).faces {
                    if group.len() < size && left.remove(&face) {
                        group.push(face);
                    }
                }
            }
            at += 1;
        }
        groups.push(group);
    }
    groups
}

/// The mesh of these faces alone, in their order, and the numbers that its vertices had. A vertex at which they are
/// several fans is several vertices.
pub(crate) fn cut<S: Clone>(
    mesh: &PolygonMesh<S>,
    faces: &[usize],
) -> Result<(PolygonMesh<S>, Vec<usize>), MeshError> {
    let connectivity = mesh.connectivity();
    let numbers: HashMap<usize, usize> = faces.iter().enumerate().map(|(i, &x)| (x, i)).collect();
    let mut new: Vec<Vec<usize>> =
        faces.iter().map(|&face| vec![usize::MAX; mesh.faces()[face].len()]).collect();
    let (mut points, mut origins): (Vec<Point<S>>, Vec<usize>) = (Vec::new(), Vec::new());
    for (number, &face) in faces.iter().enumerate() {
        for corner in 0..new[number].len() {
            if new[number][corner] != usize::MAX {
                continue;
            }
            let vertex = mesh.faces()[face][corner];
            let star = connectivity.star(vertex);
            let count = star.faces.len();
            let at = star.faces.iter().position(|&x| x == face).unwrap_or(0);
            let place = |i: usize| {
                let number = *numbers.get(&star.faces[i])?;
                Some((number, star.corners[i]))
            };
            // From this face on in both directions, to faces that are left out or the end of the fan.
            let ahead = (at + 1..at + count).take_while(|i| *i < count || !star.boundary);
            let ahead = ahead.map(|i| place(i % count)).take_while(Option::is_some).flatten();
            let behind = (1..count).take_while(|i| *i <= at || !star.boundary);
            let behind = behind.map(|i| place((at + count - i) % count));
            let behind = behind.take_while(Option::is_some).flatten();
            let all: Vec<(usize, usize)> =
                place(at).into_iter().chain(ahead).chain(behind).collect();
            for (face, corner) in all {
                new[face][corner] = points.len();
            }
            points.push(mesh.points()[vertex].clone());
            origins.push(vertex);
        }
    }
    let part = PolygonMesh::new(points, new)?;
    let tags = tags(mesh, &part, faces, &origins)?;
    Ok((part.with_tags(tags), origins))
}

/// What is sharp in a part of a mesh, and which of its faces are holes. The faces at its own boundary may differ from
/// those of the mesh.
fn tags<S>(
    mesh: &PolygonMesh<S>,
    part: &PolygonMesh<S>,
    faces: &[usize],
    origins: &[usize],
) -> Result<Tags, MeshError> {
    let (connectivity, old) = (mesh.connectivity(), mesh.tags());
    let mut tags = Tags::default();
    if old.is_plain() {
        return Ok(tags);
    }
    tags.creasing = old.creasing;
    for (number, edge) in part.connectivity().edges().iter().enumerate() {
        let before = connectivity.face_edges(faces[edge.face.0])[edge.face.1];
        tags.set_edge(number, old.edges().get(&before).cloned());
    }
    for (vertex, &origin) in origins.iter().enumerate() {
        let sharp = old.vertex(origin, &connectivity.star(origin)).cloned();
        tags.corner(part.connectivity(), vertex, sharp)?;
    }
    for (face, before) in faces.iter().enumerate() {
        if old.is_hole(connectivity, *before) {
            tags.hole(part.connectivity(), face)?;
        }
    }
    Ok(tags)
}
