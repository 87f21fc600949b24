//! Reads SCHEME as a scheme or a ring.

use super::Scheme;
use super::axes::MAX_AXES;
use super::catalogue;
use super::definition::SchemeDefinition;
use super::error::{ReferenceError, SchemeError};
use super::file::{read_one_scheme, read_scheme_with};
use super::lattice::mask::LatticeMask;
use super::local::rules::LocalRules;
use super::mask::Mask;
use super::reference::{Part, Reference, in_file, split_name};
use super::typed::{is_typed, typed};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Rational, RealCyclotomic};
use crate::files::permitted;
use crate::formula::{Expr, FreeNames, Parameters, Value, evaluate};
use std::collections::BTreeMap;
use std::hash::Hash;
use std::path::Path;
use std::sync::Arc;

/// The greatest size of a scheme file, in bytes.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// The exact scheme that SCHEME names: a catalogue entry such as `six-point:w=3/256`, a file such as
/// `my.toml:w=1/16`, a mask such as `[1, 3, 3, 1]/4`, `1/4*{1, 3, 3, 1}` or `[w, 1/2, 1 - 2*w, 1/2, w]:w=1/8`, its symbol such as `z^-1*(1+z)^3/4`, or two with ` x ` between them.
///
/// A mask `[a_0, …, a_L]` has the arity n = Σ_s a_s, and refines x'_m = Σ_j a_{m − nj + ⌊L/2⌋} x_j. A symbol
/// Σ_k a_k z^k has the arity n = Σ_k a_k, and refines x'_m = Σ_j a_{m − nj} x_j.
///
/// # Errors
/// When there is no such scheme, it is a ring, a parameter is missing, or the file is not
/// a scheme file.
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
    Named::read(text)?.scheme()
}

/// Whether SCHEME names rules around a vertex or on a face, also where it leaves their parameters open.
///
/// # Errors
/// When there is no such scheme, or the file is not a scheme file.
///
/// ```
/// use subcert::scheme::names_ring;
///
/// assert!(names_ring("loop")? && names_ring("loop:N=5")?);
/// assert!(!names_ring("newton")?);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn names_ring(text: &str) -> Result<bool, SchemeError> {
    let named = Named::read(text)?;
    match named.reference.names().collect::<Vec<&str>>()[..] {
        [name] => Ok(named.definition(name)?.is_ring()),
        _ => Ok(false),
    }
}

/// The definition that SCHEME names, without the values that it gives to parameters: of the catalogue, of a file, or of a mask in it. Its name is
/// that in SCHEME.
///
/// # Errors
/// When there is no such scheme, the file is not a scheme file, or this is a tensor product.
///
/// ```
/// use subcert::scheme::find_definition;
///
/// let definition = find_definition("four-point:w=1/16")?;
/// assert_eq!((&definition.name[..], definition.parameters.len()), ("four-point", 1));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn find_definition(text: &str) -> Result<SchemeDefinition, SchemeError> {
    let named = Named::read(text)?;
    match named.reference.names().collect::<Vec<&str>>()[..] {
        [name] => named.definition(name).cloned(),
        _ => Err(SchemeError::TensorProduct { scheme: text.trim().to_owned() }),
    }
}

/// The exact ring that SCHEME names: a catalogue entry such as `doo-sabin:n=5`, or a
/// file.
///
/// # Errors
/// When there is no such scheme, it is not a ring, a parameter is missing, or the file is
/// not a scheme file.
///
/// ```
/// use subcert::scheme::parse_local_rules;
///
/// let ring = parse_local_rules("catmull-clark:N=5")?;
/// assert_eq!(ring.point_count(), 11);
/// assert_eq!(ring.weights().entry(0, 0).to_string(), "13/20");
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_local_rules(text: &str) -> Result<LocalRules<RealCyclotomic>, SchemeError> {
    Named::read(text)?.ring(None)
}

/// The ring that SCHEME names, with `valence` for its parameter `N` or `n`, if one is given.
///
/// # Errors
/// As [`parse_local_rules`], and when a valence is given and the ring has no such parameter, or SCHEME
/// states it too.
///
/// ```
/// use subcert::scheme::{parse_local_rules, parse_rules_of_valence};
///
/// assert_eq!(parse_rules_of_valence("loop", Some(5))?, parse_local_rules("loop:N=5")?);
/// assert!(parse_rules_of_valence("loop:N=5", Some(5)).is_err());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_rules_of_valence(
    text: &str,
    valence: Option<usize>,
) -> Result<LocalRules<RealCyclotomic>, SchemeError> {
    Named::read(text)?.ring(valence)
}

/// Reads one scheme from the text of a TOML file.
///
/// # Errors
/// When the text is not TOML, a key is unknown or missing, or a formula is malformed. The
/// error points at the place.
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::scheme::read_scheme;
///
/// let text = r#"
/// name = "corner"
/// parameters.w = { default = "1/4" }
/// mask = [['1-w', 'w'], ['w', '1-w']]
/// "#;
/// let scheme = read_scheme(&SourceText::new("corner.toml", text))?;
/// assert_eq!(scheme.name, "corner");
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_scheme(source: &Arc<SourceText>) -> Result<SchemeDefinition, Diagnostic> {
    read_scheme_with(source, &other)
}

/// A scheme of the catalogue whose symbol others may use.
fn other(name: &str) -> Option<Arc<SchemeDefinition>> {
    catalogue::find(name).cloned().map(Arc::new)
}

/// For each factor of SCHEME, the path of its file if the file defines a mask without an offset,
/// which is then 0. `None` for a scheme of the catalogue, for a ring, and for a file that states an
/// offset.
///
/// # Errors
/// When SCHEME is no reference, or a file cannot be read.
pub fn files_without_offset(text: &str) -> Result<Vec<Option<String>>, SchemeError> {
    let named = Named::read(text)?;
    let without = |name: &str| {
        let definition = named.defined.get(name)?;
        definition.leaves_offset_out().then(|| name.to_owned())
    };
    Ok(named.reference.names().map(without).collect())
}

/// The catalogue entry of this name; the error lists the names that exist.
///
/// # Errors
/// When there is no entry of this name.
pub fn find_in_catalogue(name: &str) -> Result<&'static SchemeDefinition, SchemeError> {
    catalogue::find(name).ok_or_else(|| SchemeError::Unknown {
        name: name.to_owned(),
        described: catalogue::described(name).iter().map(|entry| entry.name.clone()).collect(),
        known: catalogue::catalogue().iter().map(|entry| entry.name.clone()).collect(),
    })
}

/// A reference, with the definitions in the files that it names, and of the masks in it.
pub(super) struct Named<'a> {
    pub(super) text: &'a str,
    pub(super) reference: Reference,
    defined: BTreeMap<String, SchemeDefinition>,
}

impl Named<'_> {
    pub(super) fn read(text: &str) -> Result<Named<'_>, SchemeError> {
        let reference =
            Reference::parse(text).map_err(|error| named_value(text).unwrap_or(error))?;
        let mut defined = BTreeMap::new();
        for part in reference.parts() {
            let name = &part.name[..];
            if let (Some(vectors), false) = (part.vectors.keys().next(), is_typed(name)) {
                let reason = format!(
                    "`{vectors}` is stated of a mask that is typed, and is a part of the definition of others"
                );
                return Err(ReferenceError::form(&part.text, &reason).into());
            }
            if let Some((path, own)) = in_file(name) {
                // An error calls the scheme by what is typed: the name in the file is unknown outside of it.
                let definition = read_file(path, own)?;
                let definition = SchemeDefinition { name: name.to_owned(), ..definition };
                defined.insert(name.to_owned(), definition);
            } else if is_typed(name) {
                let definition = typed(name, &part.parameters, &part.vectors, &other)
                    .map_err(|error| SchemeError::File(Box::new(error)))?;
                defined.insert(name.to_owned(), definition);
            }
        }
        Ok(Named { text, reference, defined })
    }

    pub(super) fn definition(&self, name: &str) -> Result<&SchemeDefinition, SchemeError> {
        match self.defined.get(name) {
            Some(definition) => Ok(definition),
            None => find_in_catalogue(name).map_err(|error| other_file(name).unwrap_or(error)),
        }
    }

    /// What SCHEME names where it is no tensor product, with a valence that is given apart, if rules around a vertex
    /// or on a face are named.
    pub(super) fn factor<V: Value>(
        &self,
        parameters: &Parameters<V>,
        valence: Option<usize>,
    ) -> Result<Factor<'_, V>, SchemeError> {
        match self.reference.parts() {
            [part] => self.factor_of(part, parameters, valence),
            _ => Err(SchemeError::TensorProduct { scheme: self.text.trim().to_owned() }),
        }
    }

    /// One factor with the values of its parameters. In the formula of a value, a name is one of these `parameters`, or
    /// another parameter of the same factor.
    pub(super) fn factor_of<'n, V: Value>(
        &'n self,
        part: &'n Part,
        parameters: &Parameters<V>,
        valence: Option<usize>,
    ) -> Result<Factor<'n, V>, SchemeError> {
        let definition = self.definition(&part.name)?;
        let mut values = BTreeMap::new();
        if let Some(valence) = valence.filter(|_| definition.is_ring()) {
            definition.set_valence(&part.text, &part.parameters, &mut values, valence)?;
        }
        let none = BTreeMap::new();
        let mut free = FreeNames::new(&none);
        let mut rest: Vec<(&String, &Expr)> = part.parameters.iter().collect();
        while !rest.is_empty() {
            let known =
                Parameters(values.clone().into_iter().chain(parameters.0.clone()).collect());
            let mut missing = |expr: &Expr| {
                let is_missing = |name: &String| {
                    definition.parameters.contains_key(name) && !known.0.contains_key(name)
                };
                free.of(expr).into_iter().find(is_missing)
            };
            let (ready, later): (Vec<_>, Vec<_>) =
                rest.into_iter().partition(|(_, expr)| missing(expr).is_none());
            for (name, expr) in &ready {
                let value = evaluate(expr, &known).map_err(|error| {
                    let text = self.text.to_owned();
                    SchemeError::Reference(ReferenceError::Formula { text, error })
                })?;
                values.insert((*name).clone(), value);
            }
            if let (true, Some((_, expr))) = (ready.is_empty(), later.first()) {
                let name = missing(expr).expect("it is not ready");
                if part.parameters.contains_key(&name) {
                    let reason = format!("the value of `{name}` is given by itself");
                    return Err(ReferenceError::form(&part.text, &reason).into());
                }
                let value = definition.default_value(&name, &values);
                values.insert(name, value.map_err(|error| error.of_scheme(&part.text))?);
            }
            rest = later;
        }
        Ok(Factor { text: &part.text, definition, parameters: values })
    }

    pub(super) fn masks(&self) -> Result<Vec<Mask>, SchemeError> {
        let none = Parameters::default();
        let mask = |part: &Part| self.factor_of(part, &none, None)?.mask();
        self.reference.parts().iter().map(mask).collect()
    }

    pub(super) fn scheme(&self) -> Result<Scheme<Rational>, SchemeError> {
        if self.reference.parts().len() > MAX_AXES {
            return Err(SchemeError::Lattice { scheme: self.text.trim().to_owned() });
        }
        Ok(Scheme::of(self.masks()?))
    }

    pub(super) fn ring(
        &self,
        valence: Option<usize>,
    ) -> Result<LocalRules<RealCyclotomic>, SchemeError> {
        match self.reference.parts() {
            [part] => self.factor_of(part, &Parameters::default(), valence)?.ring(),
            _ => Err(SchemeError::NotRing { scheme: self.text.trim().to_owned() }),
        }
    }
}

/// A factor of SCHEME, with values of its parameters.
pub(super) struct Factor<'a, V> {
    text: &'a str,
    pub(super) definition: &'a SchemeDefinition,
    pub(super) parameters: BTreeMap<String, V>,
}

impl<V: Value + Eq + Hash> Factor<'_, V> {
    pub(super) fn ring(&self) -> Result<LocalRules<V>, SchemeError> {
        self.definition.ring(&self.parameters).map_err(|error| error.of_scheme(self.text))
    }
}

impl<V: Value + PartialEq> Factor<'_, V> {
    pub(super) fn lattice(&self) -> Result<LatticeMask<V>, SchemeError> {
        self.definition.lattice(&self.parameters).map_err(|error| error.of_scheme(self.text))
    }

    pub(super) fn mask(&self) -> Result<Mask<V>, SchemeError> {
        self.definition.mask(&self.parameters).map_err(|error| error.of_scheme(self.text))
    }
}

/// The error that a value stands without the name of its parameter, where there is only one that it can be of.
fn named_value(text: &str) -> Option<ReferenceError> {
    let (name, value) = split_name(text.trim());
    if value.trim().is_empty() || value.contains(['=', ':']) || value.contains(" x ") {
        return None;
    }
    let definition = find_definition(name).ok()?;
    let mut names = definition.parameters.keys();
    let (Some(parameter), None) = (names.next(), names.next()) else { return None };
    let value = if value.trim() == parameter { "…" } else { value };
    let write = format!("{name}:{parameter}={value}");
    Some(ReferenceError::Unnamed { text: text.trim().to_owned(), write })
}

/// The error that the directory or file at `path` is not a scheme; `None` if nothing is
/// there.
fn other_file(path: &str) -> Option<SchemeError> {
    permitted(path.as_ref()).ok()?;
    let found = std::fs::metadata(path).ok()?;
    let extension = Path::new(path).extension().unwrap_or_default();
    let what = match (found.is_dir(), extension.to_str()) {
        (true, _) => "a directory",
        (false, Some("csv" | "json" | "txt")) => "a file of points or of results",
        _ => "a file that does not end in .toml",
    };
    Some(SchemeError::OtherFile { path: path.to_owned(), what })
}

fn read_file(path: &str, own: Option<&str>) -> Result<SchemeDefinition, SchemeError> {
    let unreadable = |reason: String| SchemeError::Unreadable { path: path.to_owned(), reason };
    let text = crate::diagnostic::read_text(Path::new(path), MAX_FILE_BYTES).map_err(unreadable)?;
    read_one_scheme(&SourceText::new(path, text), own, &other)
        .map_err(|error| SchemeError::File(Box::new(error)))
}
