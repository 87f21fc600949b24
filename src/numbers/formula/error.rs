//! Errors of formulas, with their places.

use super::ast::Span;
use crate::cap::Cap;
use crate::diagnostic::Diagnostic;
use crate::suggestion::known_here as names;

/// The greatest length of a formula, in bytes.
pub const MAX_FORMULA_LENGTH: usize = 4_096;

/// The greatest nesting depth of parentheses, brackets, signs and exponents in a formula.
pub const MAX_NESTING: usize = 64;

/// An error in a formula, with the byte range of its cause.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct FormulaError {
    /// What is wrong.
    pub kind: FormulaErrorKind,
    /// The place, as a range of bytes of the formula.
    pub span: Span,
    /// The place in a definition, when the error is in a definition that the formula
    /// names.
    pub definition: Option<Box<Diagnostic>>,
}

/// What is wrong with a formula.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormulaErrorKind {
    /// The text does not follow the grammar here.
    #[error("expected {0}")]
    Expected(&'static str),
    /// A number that [`parse_decimal`](crate::exact::parse_decimal) refuses.
    #[error("{0}")]
    Number(crate::exact::NumberError),
    /// More than [`MAX_FORMULA_LENGTH`] bytes.
    #[error("a formula of {0} bytes; at most {MAX_FORMULA_LENGTH} are read")]
    TooLong(usize),
    /// Nested deeper than [`MAX_NESTING`].
    #[error("nested more than {MAX_NESTING} deep")]
    TooDeep,
    /// A name that the context does not know.
    #[error("unknown name `{name}`{}", names(.name, .known.iter().map(String::as_str)))]
    UnknownName {
        /// The name.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A parameter that exists, but has no value.
    #[error("`{0}` has no value")]
    Unstated(String),
    /// A function that neither the language nor the context has.
    #[error("unknown function `{name}`{}", names(.name, .known.iter().map(String::as_str)))]
    UnknownFunction {
        /// The name.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A function that does not accept its arguments or options.
    #[error("{0}")]
    Call(String),
    /// A value that does not exist, in a well-formed formula.
    #[error("{0}")]
    Undefined(String),
    /// A value that is not computed.
    #[error("{0}")]
    BeyondCap(Cap),
    /// x/0.
    #[error("division by zero")]
    DivisionByZero,
    /// The maximum or minimum over an empty range.
    #[error("the range is empty, so that there is no greatest or least value")]
    EmptyRange,
    /// An operation that the type of values does not have, such as |w| for a symbol w.
    #[error("{0}")]
    Unsupported(&'static str),
    /// An integer was needed.
    #[error("{what} must be an integer, and is {value}")]
    NotAnInteger {
        /// What must be an integer.
        what: &'static str,
        /// Its value.
        value: String,
    },
    /// A cosine that is not a number of the type of values.
    #[error(transparent)]
    Cosine(#[from] crate::exact::CosineError),
    /// A root that is not a number of the type of values.
    #[error(
        "{0} is not rational, as the numbers have to be here; `subcert scheme`, `smoothness`, `plot` and `table` take masks with \
         such numbers"
    )]
    Irrational(String),
    /// A number that is not one of the type of values.
    #[error(
        "{0} is not a number of a field Q(2cos(2π/n)): such numbers are for a [[relation]] without symbols, for masks without \
         free parameters, for the parameters of schemes, and for constants of programs"
    )]
    OtherReal(String),
    /// A root that does not exist, or is beyond the caps.
    #[error(transparent)]
    Field(#[from] crate::exact::FieldError),
    /// An angle other than a rational multiple of π.
    #[error("`cos` needs a rational multiple of `pi`, such as cos(2*pi*j/n); this is {0}")]
    Angle(String),
    /// π outside an angle.
    #[error("`pi` stands for an angle, and only inside `cos`, as in cos(2*pi*j/n)")]
    PiOutsideCosine,
}

impl FormulaErrorKind {
    /// Something is too large.
    pub(crate) fn too_large(what: &'static str, most: u64) -> FormulaErrorKind {
        FormulaErrorKind::BeyondCap(Cap::new(what, most))
    }

    /// Whether the value is a number, and only not one of the type of values.
    #[must_use]
    pub fn is_other_real(&self) -> bool {
        matches!(self, FormulaErrorKind::OtherReal(_))
    }

    /// The cap that the value is beyond, if nothing else is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            FormulaErrorKind::BeyondCap(cap) => Some(cap.clone()),
            FormulaErrorKind::Cosine(error) => error.cap(),
            FormulaErrorKind::Field(error) => error.cap(),
            _ => None,
        }
    }
}

/// Why a name or function of a context gives no value. The evaluator adds the place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CallError {
    /// The context has no such function. The list names the functions it has.
    UnknownFunction(Vec<String>),
    /// The arguments or options do not fit. The text says what is required.
    Misuse(String),
    /// The value does not exist. The text says why.
    Undefined(String),
    /// The value is not computed.
    BeyondCap(Cap),
    /// An error in a formula that the function stands for.
    Inner(FormulaErrorKind),
    /// An error in a definition in a file, and its place there.
    Definition(FormulaErrorKind, Box<Diagnostic>),
}
