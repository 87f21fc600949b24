//! What the lines of a block show of the limits of a scheme: of a mask of curves, or of a mask on Z^d.

use super::curve::{CurveProof, mask};
use super::lattice::LatticeProof;
use crate::claims::Paper;
use crate::formulas::Scope;
use crate::functions::exponent::LogSum;
use crate::text::{Block, Checked, Reason, Toml, Verdict, require};

/// What is shown of limits.
pub enum LimitProof {
    /// Of a mask of curves.
    Curve(CurveProof),
    /// Of a mask on Z^d.
    Lattice(LatticeProof),
}

impl LimitProof {
    /// Reads the lines about the claim's scheme, in this scope, and checks them.
    pub fn read<'a>(
        paper: &'a Paper<'a>,
        claim: &Toml,
        scope: &Scope<'_>,
        block: &mut Block<'_>,
    ) -> Checked<LimitProof> {
        let reference = claim.text("scheme").ok_or(Reason::Single)?;
        if paper.library.is_lattice(reference) {
            let lattice = paper.library.lattice(reference, scope)?;
            return LatticeProof::read(paper, &lattice, block).map(LimitProof::Lattice);
        }
        CurveProof::read(paper, mask(paper, claim, scope)?, block).map(LimitProof::Curve)
    }

    /// Whether all limits are C^m.
    pub fn continuous(&self, m: usize) -> bool {
        match self {
            LimitProof::Curve(proof) => proof.continuous(m),
            LimitProof::Lattice(proof) => proof.continuous(m),
        }
    }

    /// Whether not all limits are C^m.
    pub fn not_continuous(&self, m: usize) -> bool {
        match self {
            LimitProof::Curve(proof) => proof.not_continuous(m),
            LimitProof::Lattice(proof) => proof.not_continuous(m),
        }
    }

    /// Whether the scheme diverges.
    pub fn diverges(&self) -> bool {
        self.not_continuous(0)
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    pub fn at_least(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        match self {
            LimitProof::Curve(proof) => proof.at_least(value, strictly),
            LimitProof::Lattice(proof) => proof.at_least(value, strictly),
        }
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    pub fn at_most(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        match self {
            LimitProof::Curve(proof) => proof.at_most(value, strictly),
            LimitProof::Lattice(proof) => proof.at_most(value, strictly),
        }
    }
}

/// The verdict that follows: refuted if a part is refuted, confirmed if all are shown.
pub fn verdict(confirmed: bool, refuted: bool) -> Checked<Verdict> {
    require(confirmed || refuted, Reason::NotShown)?;
    Ok(if refuted { Verdict::Refuted } else { Verdict::Confirmed })
}
