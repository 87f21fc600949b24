//! Why a vertex has no normal.

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
    pub(super) fn words(self) -> &'static str {
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
