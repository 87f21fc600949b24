//! Reads SCHEME as a scheme or a ring.

use super::Scheme;
use super::catalogue;
use super::definition::SchemeDefinition;
use super::error::{ReferenceError, SchemeError};
use super::file::read_scheme;
use super::local_rules::LocalRules;
use super::mask::Mask;
use super::reference::{Instance, Reference};
use super::typed::{is_typed, typed};
use crate::diagnostic::SourceText;
use crate::exact::{AlgebraicNumber, FieldElement, Rational, RealCyclotomic};
use crate::formula::{Parameters, Value};
use std::collections::BTreeMap;
use std::path::Path;

/// The greatest size of a scheme file, in bytes.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// The two kinds of schemes that SCHEME can name.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyScheme {
    /// A scheme with the same rules everywhere: one mask, or two for a tensor product.
    Uniform(Scheme<Rational>),
    /// Rules around one extraordinary vertex or face.
    LocalRules(LocalRules<RealCyclotomic>),
}

impl From<Scheme> for AnyScheme {
    fn from(scheme: Scheme) -> AnyScheme {
        AnyScheme::Uniform(scheme)
    }
}

impl From<LocalRules> for AnyScheme {
    fn from(rules: LocalRules) -> AnyScheme {
        AnyScheme::LocalRules(rules)
    }
}

/// The exact scheme that SCHEME names: a catalogue entry such as `six-point:w=3/256`, a file such as
/// `my.toml:w=1/16`, a mask such as `[1, 3, 3, 1]/4`, `1/4*{1, 3, 3, 1}` or `[w, 1/2, 1 - 2*w, 1/2, w]:w=1/8`, or two with ` x ` between them.
///
/// A mask `[a_0, …, a_L]` has the arity n = Σ_s a_s, and refines x'_m = Σ_j a_{m − nj + ⌊L/2⌋} x_j.
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
    Named::read(text)?.ring()
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
    let named = Named::read(text)?;
    let (Some(valence), [instance]) = (valence, &named.instances()?[..]) else {
        return named.ring();
    };
    let definition = named.definition(&instance.name)?;
    if !definition.is_ring() {
        return named.ring();
    }
    let mut parameters = instance.parameters.clone();
    definition.set_valence(text.trim(), &mut parameters, valence)?;
    definition.ring(&parameters)
}

/// The scheme or the ring that SCHEME names.
///
/// # Errors
/// As [`parse_scheme`] and [`parse_local_rules`].
///
/// ```
/// use subcert::scheme::{AnyScheme, parse_any_scheme};
///
/// assert!(matches!(parse_any_scheme("chaikin")?, AnyScheme::Uniform(_)));
/// assert!(matches!(parse_any_scheme("doo-sabin:n=5")?, AnyScheme::LocalRules(_)));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_any_scheme(text: &str) -> Result<AnyScheme, SchemeError> {
    let named = Named::read(text)?;
    let names: Vec<&str> = named.reference.names().collect();
    match names[..] {
        [name] if named.definition(name)?.is_ring() => named.ring().map(AnyScheme::LocalRules),
        _ => named.scheme().map(AnyScheme::Uniform),
    }
}

/// The mask that SCHEME names, with coefficients of one real field Q(α): in its formulas and in the values of its
/// parameters, `sqrt` and `root` are numbers.
///
/// # Errors
/// As [`parse_scheme`], when this is a tensor product, and when the coefficients are in no field within the caps.
///
/// ```
/// use subcert::exact::format::fixed;
/// use subcert::scheme::parse_algebraic;
///
/// let mask = parse_algebraic("four-point:w=sqrt(2)/32")?;
/// assert_eq!(fixed(&mask.rules().rows()[1][0], 8), "-0.04419417");
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn parse_algebraic(text: &str) -> Result<Mask<FieldElement>, SchemeError> {
    let named = Named::read(text)?;
    let (instance, definition) = named.factor(&Parameters::<AlgebraicNumber>::default())?;
    // The coefficients of a mask are in one field.
    let mask = definition.mask(&instance.parameters)?;
    Ok(mask.map(|c| c.element().clone()))
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
        known: catalogue::catalogue().iter().map(|entry| entry.name.clone()).collect(),
    })
}

/// A reference, with the definitions in the files that it names, and of the masks in it.
pub(super) struct Named<'a> {
    text: &'a str,
    reference: Reference,
    defined: BTreeMap<String, SchemeDefinition>,
}

impl Named<'_> {
    pub(super) fn read(text: &str) -> Result<Named<'_>, SchemeError> {
        let reference = Reference::parse(text)?;
        let mut defined = BTreeMap::new();
        for name in reference.names() {
            if is_file(name) {
                // An error calls the scheme by what is typed: the name in the file is unknown outside of it.
                let definition = SchemeDefinition { name: name.to_owned(), ..read_file(name)? };
                defined.insert(name.to_owned(), definition);
            } else if is_typed(name) {
                let definition = typed(name).map_err(|error| SchemeError::File(Box::new(error)))?;
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

    fn instances<V: Value>(&self) -> Result<Vec<Instance<V>>, SchemeError> {
        self.instances_in(&Parameters::default())
    }

    /// What SCHEME names where it is no tensor product.
    pub(super) fn factor<V: Value>(
        &self,
        parameters: &Parameters<V>,
    ) -> Result<(Instance<V>, &SchemeDefinition), SchemeError> {
        let mut instances = self.instances_in(parameters)?;
        let (Some(instance), true) = (instances.pop(), instances.is_empty()) else {
            return Err(SchemeError::TensorProduct { scheme: self.text.trim().to_owned() });
        };
        let definition = self.definition(&instance.name)?;
        Ok((instance, definition))
    }

    fn instances_in<V: Value>(
        &self,
        parameters: &Parameters<V>,
    ) -> Result<Vec<Instance<V>>, SchemeError> {
        self.reference.instances(parameters).map_err(|error| {
            let text = self.text.to_owned();
            SchemeError::Reference(ReferenceError::Formula { text, error })
        })
    }

    fn scheme(&self) -> Result<Scheme<Rational>, SchemeError> {
        let instances = self.instances()?.into_iter();
        let mask = |instance: Instance| self.definition(&instance.name)?.mask(&instance.parameters);
        Ok(Scheme::of(instances.map(mask).collect::<Result<Vec<Mask>, SchemeError>>()?))
    }

    fn ring(&self) -> Result<LocalRules<RealCyclotomic>, SchemeError> {
        match &self.instances()?[..] {
            [instance] => self.definition(&instance.name)?.ring(&instance.parameters),
            _ => Err(SchemeError::NotRing { scheme: self.text.trim().to_owned() }),
        }
    }
}

fn is_file(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "toml")
}

/// The error that the directory or file at `path` is not a scheme; `None` if nothing is
/// there.
fn other_file(path: &str) -> Option<SchemeError> {
    let found = std::fs::metadata(path).ok()?;
    let extension = Path::new(path).extension().unwrap_or_default();
    let what = match (found.is_dir(), extension.to_str()) {
        (true, _) => "a directory",
        (false, Some("csv" | "json" | "txt")) => "a file of points or of results",
        _ => "a file that does not end in .toml",
    };
    Some(SchemeError::OtherFile { path: path.to_owned(), what })
}

fn read_file(path: &str) -> Result<SchemeDefinition, SchemeError> {
    let unreadable = |reason: String| SchemeError::Unreadable { path: path.to_owned(), reason };
    let text = crate::diagnostic::read_text(Path::new(path), MAX_FILE_BYTES).map_err(unreadable)?;
    read_scheme(&SourceText::new(path, text)).map_err(|error| SchemeError::File(Box::new(error)))
}
