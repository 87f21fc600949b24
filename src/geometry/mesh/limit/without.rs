//! Vertices without a normal, counted.

use super::missing::NoNormal;
use super::vertex::LimitPoint;
use std::collections::BTreeMap;

/// How many vertices have no normal, and why, in a sentence; `None` where all have one.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{MeshScheme, PolygonMesh, limit_points, without_normals};
///
/// let points = [[0, 0, 0], [1, 0, 0], [2, 0, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// let told = without_normals(&limit_points(&mesh, MeshScheme::Loop)?);
/// assert_eq!(told.unwrap(), "3 of 3 vertices have no normal: 3 whose two tangents are parallel");
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
#[must_use]
pub fn without_normals(limits: &[Option<LimitPoint>]) -> Option<String> {
    let mut counts: BTreeMap<Option<NoNormal>, usize> = BTreeMap::new();
    for limit in limits {
        let reason = limit.as_ref().map(|limit| limit.normal.as_ref().err().copied());
        match reason {
            None => *counts.entry(None).or_default() += 1,
            Some(Some(reason)) => *counts.entry(Some(reason)).or_default() += 1,
            Some(None) => {}
        }
    }
    let (missing, all) = (counts.values().sum::<usize>(), limits.len());
    let reasons = counts.iter().map(|(reason, count)| match reason {
        None => format!("{count} at the boundary, which the surface does not reach"),
        Some(reason) => format!("{count} {}", reason.words()),
    });
    let reasons: Vec<String> = reasons.collect();
    (missing > 0)
        .then(|| format!("{missing} of {all} vertices have no normal: {}", reasons.join("; ")))
}
