//! Where a vertex has no normal.

use super::vertex::LimitPoint;
use std::collections::BTreeMap;

/// Why a limit point has no normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NoNormal {
    /// Its two tangents are parallel, or one is 0.
    Parallel,
    /// Several sectors meet there, and each may have a normal of its own.
    Sectors,
    /// One crease ends there.
    CreaseEnd,
    /// A corner whose refined points tend to no plane, or with fewer than two sharp edges.
    Corner,
    /// More than 32 faces lie between two sharp edges, or the field of the tangents is too large.
    TooLarge,
    /// It is not computed, as for nets and solids.
    NotComputed,
}

impl NoNormal {
    /// The reason in JSON and in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            NoNormal::Parallel => "parallel tangents",
            NoNormal::Sectors => "several sectors",
            NoNormal::CreaseEnd => "crease end",
            NoNormal::Corner => "corner",
            NoNormal::TooLarge => "too large",
            NoNormal::NotComputed => "not computed",
        }
    }

    /// The reason, after the number of vertices.
    fn words(self) -> &'static str {
        match self {
            NoNormal::Parallel => "whose two tangents are parallel",
            NoNormal::Sectors => {
                "between several sharp edges, where each side has its own (in JSON)"
            }
            NoNormal::CreaseEnd => "where a crease ends",
            NoNormal::Corner => "at corners without known tangents",
            NoNormal::TooLarge => {
                "with more than 32 faces between sharp edges, or in too large a field"
            }
            NoNormal::NotComputed => "for which no normal is computed",
        }
    }
}

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
