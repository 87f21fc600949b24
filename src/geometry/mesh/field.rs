//! The conditions of the schemes' rules on a mesh, and the fields of the cosines in these rules.

use super::MAX_VALENCE;
use super::connectivity::Connectivity;
use super::error::MeshError;
use super::point::Point;
use super::polygon::PolygonMesh;
use super::scheme::MeshScheme;
use crate::exact::{MAX_CONDUCTOR, Rational, RealCyclotomic, Scalar, common_conductor};
use num_integer::gcd;
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
/// large for `count` points, so that any two of them can be compared.
///
/// # Errors
/// When the field or the numbers in it are beyond the caps.
pub(crate) fn check_common_field(
    connectivity: &Connectivity,
    points: &[Point<RealCyclotomic>],
    scheme: MeshScheme,
    count: usize,
) -> Result<(), MeshError> {
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
    if matches!(scheme, MeshScheme::DooSabin | MeshScheme::Loop) {
        inner_valences(connectivity).try_for_each(|(_, n)| include(cosine_conductor(n)))?;
    }
    if scheme == MeshScheme::DooSabin {
        let faces = connectivity.faces().iter();
        faces.map(|face| cosine_conductor(face.len())).try_for_each(&mut include)?;
    }
    check_terms(count, count.saturating_mul(degree(conductor)))
}

/// Checks that each of these points, of which only the conductors are known, is in a field within the cap, and that all
/// together have not too many terms. `place` says of the number of a point where it is.
///
/// # Errors
/// When a field or the numbers are beyond the caps.
pub(super) fn check_fields(
    points: &[Point<Conductor>],
    place: impl Fn(usize) -> String,
) -> Result<(), MeshError> {
    let mut fields = Fields::default();
    for (number, point) in points.iter().enumerate() {
        fields.take(point, |n| {
            let reason = format!(
                "{} needs {}: take a lower level, fewer valences, or for triangles loop-warren, whose weights are \
                 rational",
                place(number),
                too_various(n)
            );
            MeshError::TooMuch { reason }
        })?;
    }
    check_terms(points.len(), fields.terms)
}

/// Checks that the limit of each of these vertices, with the conductor of the field that it is in, is within the caps, and
/// that the normals are not too much work: each is divided by its length in this field.
///
/// # Errors
/// When a field, or the work, is beyond the caps.
pub(super) fn check_limits(
    limits: impl IntoIterator<Item = (usize, Conductor)>,
) -> Result<(), MeshError> {
    let mut fields = Fields::default();
    let (mut count, mut work) = (0_usize, 0_usize);
    for (point, conductor) in limits {
        let degree = fields.take(&[conductor], |n| MeshError::Vertex {
            point,
            reason: format!(
                "its limit needs {}: take fewer valences, or a scheme with rational weights, such as catmull-clark",
                too_various(n)
            ),
        })?;
        count = count.saturating_add(1);
        work = work.saturating_add(degree.saturating_pow(3));
    }
    check_terms(count, fields.terms)?;
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

fn too_various(conductor: u64) -> String {
    format!(
        "the field of 2cos(2π/n) for n = {conductor}, since the valences that meet there are too various; at most n = \
         {MAX_CONDUCTOR} is computed in"
    )
}

fn check_terms(count: usize, terms: usize) -> Result<(), MeshError> {
    if terms <= MAX_COEFFICIENTS {
        return Ok(());
    }
    let degree = terms.div_ceil(count.max(1));
    let reason = format!(
        "{count} points whose coordinates are sums of {degree} cosines on average; at most \
         {MAX_COEFFICIENTS} terms of a coordinate are worked on, for all points together: take a \
         lower level or fewer valences, or for triangles loop-warren, whose weights are rational"
    );
    Err(MeshError::TooMuch { reason })
}

/// The degrees of fields, each computed once, and their sum over all points.
#[derive(Default)]
struct Fields {
    degrees: BTreeMap<u64, usize>,
    terms: usize,
}

impl Fields {
    /// Takes in the numbers of a point; their greatest degree, or the error of a conductor beyond the cap.
    fn take(
        &mut self,
        numbers: &[Conductor],
        error: impl Fn(u64) -> MeshError,
    ) -> Result<usize, MeshError> {
        let mut most = 1;
        for Conductor(n) in numbers {
            let within = u32::try_from(*n).ok().filter(|n| *n <= MAX_CONDUCTOR);
            let n = within.ok_or_else(|| error(*n))?;
            most = most.max(*self.degrees.entry(n.into()).or_insert_with(|| degree(n)));
        }
        self.terms = self.terms.saturating_add(most);
        Ok(most)
    }
}

/// Of a number only the n of a field Q(2cos(2π/n)) that it is in; 0 for the number 0. Sums and products of these say in which
/// fields those of the numbers are, before they are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Conductor(u64);

impl Conductor {
    pub(super) fn of(x: &RealCyclotomic) -> Conductor {
        Conductor(if x.sign() == 0 { 0 } else { x.conductor().into() })
    }

    /// The field of all coordinates of these points, and of the cosines of a valence.
    pub(super) fn around<'a>(
        valence: Option<usize>,
        points: impl IntoIterator<Item = &'a Point<RealCyclotomic>>,
    ) -> Conductor {
        let cosine = Conductor(valence.map_or(1, cosine_conductor).into());
        points.into_iter().flatten().fold(cosine, |all, x| all.plus(&Conductor::of(x)))
    }
}

impl Scalar for Conductor {
    fn from_rational(value: &Rational) -> Conductor {
        Conductor(u64::from(value.sign() != 0))
    }

    fn plus(&self, other: &Conductor) -> Conductor {
        match (self.0, other.0) {
            (0, n) | (n, 0) => Conductor(n),
            // Beyond u64 it is far beyond the cap.
            (m, n) => Conductor((m / gcd(m, n)).saturating_mul(n)),
        }
    }

    fn minus(&self, other: &Conductor) -> Conductor {
        self.plus(other)
    }

    fn times(&self, other: &Conductor) -> Conductor {
        if self.0 == 0 || other.0 == 0 { Conductor(0) } else { self.plus(other) }
    }
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
