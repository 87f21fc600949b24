//! What `subcert schemes` writes.

use serde::Serialize;

/// The catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Catalogue<'a> {
    /// The version of this form.
    pub schema: u32,
    /// Its schemes.
    pub schemes: Vec<Scheme<'a>>,
}

/// A scheme of the catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Scheme<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it is.
    pub title: &'a str,
    /// The publication that it is from.
    pub source: &'a str,
    /// `mask`, or `ring` around a vertex or a face.
    pub kind: &'static str,
    /// Its parameters.
    pub parameters: Vec<Parameter<'a>>,
}

/// A parameter of a scheme.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Parameter<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its value where none is given; null where one must be.
    pub default: Option<&'a str>,
    /// What it is.
    pub about: &'a str,
}
