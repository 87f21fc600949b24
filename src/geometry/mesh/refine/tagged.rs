//! Creases and texture coordinates of the next level, which Catmull–Clark and Loop share.

use super::super::crease::Tags;
use super::super::error::MeshError;
use super::super::point::{Point, combination};
use super::super::polygon::PolygonMesh;
use super::super::texture::Texture;
use crate::exact::{Rational, Scalar};
use std::collections::BTreeMap;
use std::ops::Range;

/// The new point of an inner edge: the midpoint and the `smooth` point of the scheme, blended by the
/// sharpness of the edge.
pub(super) fn edge_point<S: Scalar>(
    mesh: &PolygonMesh<S>,
    edge: usize,
    smooth: impl FnOnce() -> Point<S>,
) -> Point<S> {
    let tags = mesh.tags();
    if !tags.has_sharp() {
        return smooth();
    }
    let weight = tags.edge_weight(mesh.connectivity(), edge);
    let [p, q] = mesh.connectivity().edges()[edge].ends.map(|end| &mesh.points()[end]);
    if weight.is_zero() {
        smooth()
    } else if weight == Rational::one() {
        midpoint(p, q)
    } else {
        blended(&smooth(), &midpoint(p, q), &weight)
    }
}

/// Gives the next level the tags and texture coordinates of this one. `children` says which new faces
/// are parts of a face. The new mesh has the vertices, then the edges, of this one as its first
/// points.
pub(super) fn carry<S: Scalar>(
    mesh: &PolygonMesh<S>,
    refined: PolygonMesh<S>,
    children: impl Fn(usize) -> Range<usize>,
    texture: impl FnOnce(&Texture) -> Texture,
) -> Result<PolygonMesh<S>, MeshError> {
    let texture = mesh.texture().map(texture);
    if mesh.tags().is_plain() {
        return refined.with_texture(texture);
    }
    let tags = tags(mesh, &refined, children)?;
    refined.with_tags(tags).with_texture(texture)
}

fn tags<S>(
    mesh: &PolygonMesh<S>,
    refined: &PolygonMesh<S>,
    children: impl Fn(usize) -> Range<usize>,
) -> Result<Tags, MeshError> {
    let (old, connectivity) = (mesh.tags(), mesh.connectivity());
    let mut tags = Tags::default();
    (tags.boundary, tags.creasing) = (old.boundary, old.creasing);
    for (&vertex, sharp) in old.vertices() {
        tags.corner(refined.connectivity(), vertex, sharp.lowered())?;
    }
    for hole in old.holes(connectivity) {
        for face in children(hole) {
            tags.hole(refined.connectivity(), face)?;
        }
    }
    if old.edges().is_empty() {
        return Ok(tags);
    }
    let vertices = connectivity.point_count();
    // What the edges of a vertex become, for each vertex at a sharp edge.
    let mut around = BTreeMap::new();
    for (new, edge) in refined.connectivity().edges().iter().enumerate() {
        let [vertex, middle] = [edge.ends[0].min(edge.ends[1]), edge.ends[0].max(edge.ends[1])];
        let Some(parent) = middle.checked_sub(vertices).filter(|_| vertex < vertices) else {
            continue;
        };
        if !old.edges().contains_key(&parent) {
            continue;
        }
        let (star, own) = around.entry(vertex).or_insert_with(|| {
            let star = connectivity.star(vertex);
            let own = old.children(connectivity, &star);
            (star, own)
        });
        let place = star.edges.iter().position(|edge| *edge == parent);
        tags.set_edge(new, place.and_then(|place| own[place].clone()));
    }
    Ok(tags)
}

/// (1 − w)·p + w·q.
pub(super) fn blended<S: Scalar>(p: &Point<S>, q: &Point<S>, weight: &Rational) -> Point<S> {
    let [first, second] =
        [&Rational::one() - weight, weight.clone()].map(|share| S::from_rational(&share));
    combination([(&first, p), (&second, q)])
}

/// (p + q)/2.
pub(super) fn midpoint<S: Scalar>(p: &Point<S>, q: &Point<S>) -> Point<S> {
    let half = S::from_rational(&Rational::new(1, 2));
    combination([(&half, p), (&half, q)])
}
