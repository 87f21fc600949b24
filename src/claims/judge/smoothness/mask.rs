//! What is known of the limits of a mask.

use crate::claim::PrintedValences;
use crate::diagnostic::Diagnostic;
use crate::evaluation::Limits;
use crate::evaluation::limits::LimitScheme;
use crate::finding::{KnownLimits, LatticeLimits, Reason};
use crate::lattice::LatticeSmoothness;
use crate::scheme::{LatticeMask, Mask};
use crate::smoothness::Smoothness;
use crate::stop::Stop;

/// A mask has no valences.
pub(super) fn no_valences(scheme: &LimitScheme<'_>, valences: &PrintedValences) -> Diagnostic {
    scheme
        .error(format!("`valences = '{}'` of a mask", valences.text))
        .with_help("valences are those of rules around a vertex or on a face, such as `loop`")
}

/// What is proved of the limits of a mask on Z^d.
pub(super) fn lattice_limits(mask: LatticeMask) -> KnownLimits {
    let smoothness = LatticeSmoothness::until(&mask, &Stop::default());
    KnownLimits::Lattice(Box::new(LatticeLimits { mask, smoothness }))
}

/// What is proved of the limits of a mask, or the cap that its rules are beyond.
pub(super) fn limits(mask: Mask) -> Result<KnownLimits, Reason> {
    let smoothness = Smoothness::of(&mask)?;
    Ok(KnownLimits::Limits(Box::new(Limits { mask, smoothness })))
}
