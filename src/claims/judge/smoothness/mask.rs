//! What is known of the limits of a mask.

use crate::claim::PrintedValences;
use crate::diagnostic::Diagnostic;
use crate::evaluation::Limits;
use crate::evaluation::limits::LimitScheme;
use crate::finding::Reason;
use crate::scheme::Mask;
use crate::smoothness::Smoothness;

/// A mask has no valences.
pub(super) fn no_valences(scheme: &LimitScheme<'_>, valences: &PrintedValences) -> Diagnostic {
    scheme
        .error(format!("`valences = '{}'` of a mask", valences.text))
        .with_help("valences are those of rules around a vertex or on a face, such as `loop`")
}

/// What is proved of the limits of a mask, or the cap that its rules are beyond.
pub(super) fn limits(mask: Mask) -> Result<Limits, Reason> {
    let smoothness = Smoothness::of(&mask)?;
    Ok(Limits { mask, smoothness })
}
