//! Errors of scheme references in formulas.

use crate::claim::LocatedReference;
use crate::diagnostic::Diagnostic;
use crate::formula::{CallError, FormulaError};
use crate::scheme::{Reference, SchemeError};

/// The error of a scheme, at the place that names the scheme or, for a scheme of the claim file, at
/// a place in its definition.
pub(crate) fn scheme_error(located: &LocatedReference, error: &SchemeError) -> Diagnostic {
    match error {
        SchemeError::File(inner) if inner.source == located.source => (**inner).clone(),
        // The place is in the file of a scheme of the catalogue, which nobody has to mend.
        SchemeError::File(inner) => Diagnostic {
            help: inner.help.clone(),
            cap: inner.cap.clone(),
            ..Diagnostic::new(&located.source, located.span.clone(), inner.message.clone())
        },
        other => Diagnostic::new(&located.source, located.span.clone(), other.to_string())
            .with_cap(other.cap()),
    }
}

/// The error of a reference, at the place that names the scheme, or in the definition of one of the claim file.
pub(crate) fn located(located: &LocatedReference, error: &Unresolved) -> Diagnostic {
    match error {
        Unresolved::Scheme(error) => scheme_error(located, error),
        Unresolved::Formula(error) => in_parameters(located, error),
    }
}

/// The error of a formula in the parameters of a reference.
pub(crate) fn in_parameters(located: &LocatedReference, error: &FormulaError) -> Diagnostic {
    let message = format!("in its parameters: {error}");
    Diagnostic::new(&located.source, located.span.clone(), message).with_cap(error.kind.cap())
}

/// Why a reference of a claim gives no mask.
pub(crate) enum Unresolved {
    /// A formula has no value: for a parameter that the paper does not state, a
    /// finding; otherwise an error of the claim file.
    Formula(FormulaError),
    /// There is no such scheme.
    Scheme(SchemeError),
}

pub(crate) fn reference(name: &str) -> Result<Reference, CallError> {
    Reference::parse(name).map_err(|error| CallError::Misuse(error.to_string()))
}

pub(crate) fn unresolved(name: &str, error: Unresolved) -> CallError {
    match error {
        Unresolved::Formula(error) => CallError::Inner(error.kind),
        Unresolved::Scheme(error) => match error.cap() {
            Some(cap) => CallError::BeyondCap(cap),
            None => CallError::Misuse(format!("scheme `{name}`: {error}")),
        },
    }
}
