//! The numbers of each valence.

use crate::exact::{RealCyclotomic, RealExpression};
use crate::scheme::LocalRules;
use crate::spectrum::{Spectrum, SpectrumError, Surroundings};

/// The most weights of all valences of a table together.
pub const MAX_TABLE_WEIGHTS: usize = 1_000_000;

/// What a table says of one valence.
#[derive(Clone, Debug)]
pub struct Row {
    /// n.
    pub valence: usize,
    /// The name of each orbit, and whether it has n points rather than one.
    pub orbits: Vec<(String, bool)>,
    /// The weights of a point of each orbit in the new point of the first orbit, if that is a single
    /// point; otherwise of all points in its point 0.
    pub rule: Vec<RealCyclotomic>,
    /// λ.
    pub subdominant: RealExpression,
    /// The weight of a point of each orbit in the limit.
    pub limit: Vec<RealCyclotomic>,
    /// For the points of the orbits of n points, the weights in two tangents.
    pub tangents: [Vec<RealExpression>; 2],
}

/// Why there is no table.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// There is no spectrum.
    #[error(transparent)]
    Spectrum(#[from] SpectrumError),
    /// There are no stencils.
    #[error(
        "valence {valence}: there is no subdominant eigenvalue that is positive, double and of the blocks 1 \
         and n − 1, and so there are no tangents; `subcert spectrum` shows the eigenvalues. Take other valences"
    )]
    NoStencils {
        /// The valence.
        valence: usize,
    },
    /// Orbits of other numbers of points.
    #[error(
        "valence {valence}: the orbit `{orbit}` has {count} points; tables are written of orbits of 1 or {valence} \
         points"
    )]
    Orbit {
        /// The valence.
        valence: usize,
        /// The orbit.
        orbit: String,
        /// The number of its points.
        count: usize,
    },
    /// Too many numbers.
    #[error(
        "the tangents of all valences have more than {MAX_TABLE_WEIGHTS} weights; take fewer valences"
    )]
    TooMany,
    /// The rules of two valences have different orbits.
    #[error("the orbits at valence {valence} are others than at the first valence")]
    Different {
        /// The valence.
        valence: usize,
    },
}

impl Row {
    /// That of the rules of one valence.
    ///
    /// # Errors
    /// When there is no spectrum, or the rules have no stencils or other orbits than those of 1 or n
    /// points.
    ///
    /// # Panics
    /// Never.
    pub fn of(rings: &Surroundings) -> Result<Row, TableError> {
        let spectrum = rings.known_spectrum()?;
        let Spectrum { order: valence, conditions, limit, tangents, .. } = spectrum;
        let none = || TableError::NoStencils { valence };
        let subdominant = conditions.subdominant.ok_or_else(none)?;
        let (limit, tangents) = (limit.ok_or_else(none)?, tangents.ok_or_else(none)?);
        let ring = &rings.ring;
        if let Some(orbit) = ring.orbits().iter().find(|one| ![1, valence].contains(&one.count)) {
            let (orbit, count) = (orbit.name.clone(), orbit.count);
            return Err(TableError::Orbit { valence, orbit, count });
        }
        let starts = starts(ring);
        let full = |point: usize| {
            let orbit = starts.iter().rposition(|start| *start <= point).unwrap_or(0);
            ring.orbits()[orbit].count > 1
        };
        let turning = |weights: Vec<RealExpression>| {
            let placed = weights.into_iter().enumerate().filter(|(point, _)| full(*point));
            placed.map(|(_, weight)| weight).collect()
        };
        let row: Vec<RealCyclotomic> = ring.weights().row(0).cloned().collect();
        let single = ring.orbits()[0].count == 1;
        let first = |weights: &[RealCyclotomic]| -> Vec<RealCyclotomic> {
            starts.iter().map(|&start| weights[start].clone()).collect()
        };
        Ok(Row {
            valence,
            orbits: ring.orbits().iter().map(|one| (one.name.clone(), one.count > 1)).collect(),
            rule: if single { first(&row) } else { row },
            subdominant,
            limit: first(&limit),
            tangents: tangents.map(turning),
        })
    }
}

/// The first point of each orbit.
fn starts(ring: &LocalRules) -> Vec<usize> {
    let counts = ring.orbits().iter().map(|orbit| orbit.count);
    counts.scan(0, |next, count| Some(std::mem::replace(next, *next + count))).collect()
}
