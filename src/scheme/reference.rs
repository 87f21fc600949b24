//! SCHEME: a catalogue name or a file, with parameters.

use super::Scheme;
use super::catalogue;
use super::definition::SchemeDefinition;
use super::file::read_scheme;
use super::mask::Mask;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::Rational;
use crate::formula::{
    Context, Expr, FormulaError, Parameters, Value, evaluate, is_identifier, parse,
};
use std::collections::BTreeMap;
use std::path::Path;

/// The longest SCHEME that is read, in bytes.
const MAX_REFERENCE_LENGTH: usize = 4_096;

/// The largest scheme file that is read, in bytes.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// Why a text is not a scheme reference.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReferenceError {
    /// It does not have the form `name:parameter=value,…`.
    #[error(
        "`{text}` is not a scheme: {reason}; write `six-point:w=3/256`, `newton:j=1,n=3`, or \
             two of these with ` x ` between them for a tensor product"
    )]
    Form {
        /// The text.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A parameter's value is not a formula.
    #[error("in `{text}`: {error}")]
    Formula {
        /// The value's text.
        text: String,
        /// What is wrong with it.
        error: FormulaError,
    },
}

/// Why a reference gives no scheme.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SchemeError {
    /// It is not a reference.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// There is no scheme of this name.
    #[error("unknown scheme `{name}`; known: {}; or give the path of a .toml file", .known.join(", "))]
    Unknown {
        /// The name.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A parameter has neither a value nor a default.
    #[error("`{scheme}` needs its parameter `{parameter}`: write `{scheme}:{parameter}=…`")]
    MissingParameter {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
    },
    /// A parameter that the scheme does not have.
    #[error("`{scheme}` has no parameter `{parameter}`{}", parameters(.known))]
    UnknownParameter {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
        /// Those it has.
        known: Vec<String>,
    },
    /// A file that cannot be read.
    #[error("cannot read `{path}`: {reason}")]
    Unreadable {
        /// The path.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// An error in the scheme's file.
    #[error("{0}")]
    File(Box<Diagnostic>),
}

fn parameters(known: &[String]) -> String {
    if known.is_empty() {
        "; it has none".to_owned()
    } else {
        format!("; it has: {}", known.join(", "))
    }
}

/// A scheme reference: one name with parameter formulas, or two for a tensor
/// product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    parts: Vec<Part>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Part {
    name: String,
    parameters: BTreeMap<String, (String, Expr)>,
}

impl Reference {
    /// Reads `name`, `name:p=formula,q=formula`, or two of these with ` x `
    /// between them.
    ///
    /// # Errors
    /// When the text has another form, or a parameter's value is not a formula.
    pub fn parse(text: &str) -> Result<Reference, ReferenceError> {
        let form = |reason: &str| ReferenceError::Form {
            text: text.chars().take(80).collect(),
            reason: reason.to_owned(),
        };
        if text.len() > MAX_REFERENCE_LENGTH {
            return Err(form("it is too long"));
        }
        let parts: Vec<&str> = text.split(" x ").collect();
        if parts.len() > 2 {
            return Err(form("a tensor product has two factors"));
        }
        let read = |part: &&str| -> Result<Part, ReferenceError> {
            let (name, arguments) = split_name(part.trim());
            if name.is_empty() {
                return Err(form("the name is missing"));
            }
            let mut parameters = BTreeMap::new();
            for argument in split_top_level(arguments) {
                let Some((parameter, value)) = argument.split_once('=') else {
                    return Err(form("a parameter is given as name=value"));
                };
                let (parameter, value) = (parameter.trim(), value.trim());
                if !is_identifier(parameter) {
                    return Err(form("a parameter's name is a letter, then letters and digits"));
                }
                let expr = parse(value)
                    .map_err(|error| ReferenceError::Formula { text: value.to_owned(), error })?;
                if parameters.insert(parameter.to_owned(), (value.to_owned(), expr)).is_some() {
                    return Err(form("a parameter is given twice"));
                }
            }
            Ok(Part { name: name.to_owned(), parameters })
        };
        Ok(Reference { parts: parts.iter().map(read).collect::<Result<Vec<Part>, _>>()? })
    }

    /// The names of the schemes that this refers to, one per factor.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().map(|part| part.name.as_str())
    }

    /// The scheme, its parameters evaluated in `context`, its names looked up by
    /// `find`. The inner error is one of evaluation.
    ///
    /// # Errors
    /// When a name is unknown, a parameter has no value, or there is no mask.
    pub fn resolve<'a, V: Value + PartialEq>(
        &self,
        context: &dyn Context<V>,
        find: impl Fn(&str) -> Result<&'a SchemeDefinition, SchemeError>,
    ) -> Result<Result<Scheme<V>, SchemeError>, FormulaError> {
        let mut masks = Vec::with_capacity(2);
        for part in &self.parts {
            let mut values = BTreeMap::new();
            for (name, (_, expr)) in &part.parameters {
                values.insert(name.clone(), evaluate(expr, context)?);
            }
            let mask = find(&part.name).and_then(|definition| definition.mask(&values));
            match mask {
                Ok(mask) => masks.push(mask),
                Err(error) => return Ok(Err(error)),
            }
        }
        let mut masks = masks.into_iter();
        Ok(Ok(match (masks.next(), masks.next()) {
            (Some(first), Some(second)) => Scheme::Tensor(first, second),
            (Some(only), None) => Scheme::Curve(only),
            (None, _) => unreachable!("a reference has one part or two"),
        }))
    }
}

/// The name before the first colon; the colon of a path such as `C:` is not it.
fn split_name(part: &str) -> (&str, &str) {
    let path_end = part.find(".toml").map_or(0, |start| start + ".toml".len());
    match part[path_end..].find(':') {
        Some(colon) => (&part[..path_end + colon], &part[path_end + colon + 1..]),
        None => (part, ""),
    }
}

/// The pieces between commas that stand outside all parentheses.
fn split_top_level(text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut depth, mut start) = (0_usize, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                pieces.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    if !text[start..].trim().is_empty() {
        pieces.push(&text[start..]);
    }
    pieces
}

/// The exact scheme that SCHEME names: a catalogue entry such as
/// `six-point:w=3/256`, a file such as `my.toml:w=1/16`, or two with ` x `
/// between them.
///
/// # Errors
/// When there is no such scheme, a parameter is missing, or the file is not one.
///
/// ```
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("newton:j=1,n=3")?;
/// assert_eq!(scheme.masks()[0].arity(), 3);
/// assert!(parse_scheme("six-point").unwrap_err().to_string().contains("`w`"));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_scheme(text: &str) -> Result<Scheme<Rational>, SchemeError> {
    let reference = Reference::parse(text)?;
    let mut files = BTreeMap::new();
    for name in reference.names().filter(|name| is_file(name)) {
        files.insert(name.to_owned(), read_file(name)?);
    }
    let find = |name: &str| match files.get(name) {
        Some(definition) => Ok(definition),
        None => find_in_catalogue(name),
    };
    reference.resolve(&Parameters::<Rational>::default(), find).unwrap_or_else(|error| {
        Err(SchemeError::Reference(ReferenceError::Formula { text: text.to_owned(), error }))
    })
}

/// The catalogue entry of this name.
pub(crate) fn find_in_catalogue(name: &str) -> Result<&'static SchemeDefinition, SchemeError> {
    catalogue::find(name).ok_or_else(|| SchemeError::Unknown {
        name: name.to_owned(),
        known: catalogue::catalogue().iter().map(|entry| entry.name.clone()).collect(),
    })
}

fn is_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "toml")
}

fn read_file(path: &str) -> Result<SchemeDefinition, SchemeError> {
    let unreadable = |reason: String| SchemeError::Unreadable { path: path.to_owned(), reason };
    let text = crate::diagnostic::read_text(Path::new(path), MAX_FILE_BYTES).map_err(unreadable)?;
    read_scheme(&SourceText::new(path, text)).map_err(|error| SchemeError::File(Box::new(error)))
}

/// The mask of a scheme for curves.
impl TryFrom<Scheme> for Mask {
    type Error = Scheme;
    fn try_from(scheme: Scheme) -> Result<Mask, Scheme> {
        match scheme {
            Scheme::Curve(mask) => Ok(mask),
            tensor @ Scheme::Tensor(..) => Err(tensor),
        }
    }
}
