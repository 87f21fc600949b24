//! The conditions of the schemes' rules on a mesh, and the field of the cosines in these rules.

use super::connectivity::Connectivity;
use super::error::MeshError;
use super::point::Point;
use super::polygon::PolygonMesh;
use super::scheme::MeshScheme;
use super::{MAX_POINTS, MAX_VALENCE};
use crate::exact::{RealCyclotomic, common_conductor};
use num_integer::{gcd, lcm};
use std::collections::BTreeMap;

/// The most rational coefficients of all points together, for each coordinate.
const MAX_COEFFICIENTS: usize = 4_000_000;

/// The most work for normals: Σ D³ over the vertices, where D is the degree of the field of a normal.
const MAX_NORMAL_WORK: usize = 1 << 25;

/// Checks that the scheme has rules for every face and every vertex.
///
/// # Errors
/// When a face or an inner vertex has too many vertices or neighbours, an inner vertex has two
/// neighbours, or Loop's rules meet a face that is no triangle.
pub(crate) fn check_rules(
    connectivity: &Connectivity,
    scheme: MeshScheme,
) -> Result<(), MeshError> {
    let triangles = scheme.is_triangular();
    for (face, vertices) in connectivity.faces().iter().enumerate() {
        let count = vertices.len();
        if triangles && count != 3 {
            let reason = format!(
                "a face of {count} vertices: `{}` refines triangles; split the face into triangles, \
                 or take catmull-clark",
                scheme.name()
            );
            return Err(MeshError::Face { face, reason });
        }
        if count > MAX_VALENCE {
            return Err(MeshError::large_face(face, count));
        }
    }
    for (point, valence) in inner_valences(connectivity) {
        if !(3..=MAX_VALENCE).contains(&valence) {
            let reason = format!(
                "{valence} edges meet at this inner vertex; there are rules for 3 to {MAX_VALENCE}"
            );
            return Err(MeshError::Vertex { point, reason });
        }
    }
    Ok(())
}

/// Checks that the scheme has rules for creases and texture coordinates, if there are any.
///
/// # Errors
/// When there are tags and the scheme is Doo–Sabin's or Bajaj's, or texture coordinates and it is Doo–Sabin's.
pub(crate) fn check_tags<S>(mesh: &PolygonMesh<S>, scheme: MeshScheme) -> Result<(), MeshError> {
    let name = scheme.name();
    let untagged = [MeshScheme::DooSabin, MeshScheme::Bajaj].contains(&scheme);
    let reason = if untagged && !mesh.tags().is_plain() {
        format!(
            "{name} has no rules for creases, corners, holes and boundaries; remove the tags, or take \
             catmull-clark"
        )
    } else if scheme == MeshScheme::DooSabin && mesh.texture().is_some() {
        format!("{name} does not carry texture coordinates on; remove them, or take catmull-clark")
    } else {
        return Ok(());
    };
    Err(MeshError::Attribute { reason })
}

/// The vertices that are not at the boundary, with the number of their edges.
pub(super) fn inner_valences(
    connectivity: &Connectivity,
) -> impl Iterator<Item = (usize, usize)> + '_ {
    let stars = (0..connectivity.point_count()).map(|point| (point, connectivity.star(point)));
    stars.filter(|(_, star)| !star.boundary).map(|(point, star)| (point, star.valence()))
}

/// Checks that all coordinates, and the cosines of all valences, are in one field that is not too
/// large for `count` points.
///
/// # Errors
/// When the field or the numbers in it are beyond the caps.
pub(crate) fn check_field(
    connectivity: &Connectivity,
    points: &[Point<RealCyclotomic>],
    scheme: MeshScheme,
    tangents: bool,
    count: usize,
) -> Result<(), MeshError> {
    if count > MAX_POINTS {
        return Err(MeshError::TooManyPoints { points: count });
    }
    let rational = points.iter().flatten().all(|x| x.as_rational().is_some());
    let mut conductor = 1;
    let mut include = |other: u32| match common_conductor(conductor, other) {
        Ok(common) => {
            conductor = common;
            Ok(())
        }
        Err(error) => {
            Err(MeshError::TooMuch { reason: format!("the valences are too various: {error}") })
        }
    };
    points.iter().flatten().try_for_each(|x| include(x.conductor()))?;
    let vertices = match scheme {
        MeshScheme::DooSabin | MeshScheme::Loop => true,
        // Each normal is in a field of its own where the coordinates are rational.
        MeshScheme::CatmullClark | MeshScheme::Bajaj | MeshScheme::LoopWarren => {
            tangents && !rational
        }
    };
    if vertices {
        inner_valences(connectivity).try_for_each(|(_, n)| include(cosine_conductor(n)))?;
    }
    if scheme == MeshScheme::DooSabin {
        let faces = connectivity.faces().iter();
        faces.map(|face| cosine_conductor(face.len())).try_for_each(&mut include)?;
    }
    let degree = degree(conductor);
    if count.saturating_mul(degree) > MAX_COEFFICIENTS {
        let reason = format!(
            "{count} points whose coordinates are sums of up to {degree} cosines; at most \
             {MAX_COEFFICIENTS} terms of a coordinate are worked on, for all points together: take a \
             lower level or fewer valences, or for triangles loop-warren, whose weights are rational"
        );
        return Err(MeshError::TooMuch { reason });
    }
    if tangents { check_normals(connectivity, points) } else { Ok(()) }
}

/// Checks that the normals are not too much work: each is divided by its length in the field of
/// its point and of the cosines of its valence.
fn check_normals(
    connectivity: &Connectivity,
    points: &[Point<RealCyclotomic>],
) -> Result<(), MeshError> {
    let common = points.iter().flatten().fold(1, |n, x| lcm(n, x.conductor()));
    let mut degrees = BTreeMap::new();
    let mut work = 0_usize;
    for (_, n) in inner_valences(connectivity) {
        let of_field = || degree(lcm(common, cosine_conductor(n)));
        work = work.saturating_add(degrees.entry(n).or_insert_with(of_field).pow(3));
    }
    if work > MAX_NORMAL_WORK {
        let reason = format!(
            "normals of too large valences: the cubes of the degrees of their fields have the sum \
             {work}, and at most {MAX_NORMAL_WORK} is worked on; take a smaller mesh, or `subcert \
             refine`, which has no normals"
        );
        return Err(MeshError::TooMuch { reason });
    }
    Ok(())
}

/// The n of the field Q(2cos(2π/n)) that cos(2π/`valence`) needs; 1 where it is rational.
fn cosine_conductor(valence: usize) -> u32 {
    let n = u32::try_from(valence).unwrap_or(u32::MAX);
    match n {
        0..=4 | 6 => 1,
        _ if n % 4 == 2 => n / 2,
        _ => n,
    }
}

/// The degree of Q(2cos(2π/n)): φ(n)/2, or 1 for n = 1.
fn degree(conductor: u32) -> usize {
    let units = (1..=conductor).filter(|k| gcd(*k, conductor) == 1).count();
    units.div_ceil(2)
}
