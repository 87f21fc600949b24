//! Reading schemes from TOML.

use super::composed::composed_of;
use super::definition::{CatalogueFacts, Coefficients, ParameterSpec, SchemeDefinition};
use super::error::SchemeError;
use super::fields::{MaskTable, definitions, formula, identifier};
use super::lattice::integers::VectorTable;
use super::local::file::{EdgeTable, OrbitTable, WeightTable};
use super::spanned::Spanned;
use super::toml_file::from_toml;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{LocatedFormula, is_identifier};
use crate::suggestion::known;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A scheme in TOML, as a whole file or as an entry `[[scheme]]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SchemeTable {
    /// The name by which claims call it, with its place.
    pub name: Spanned<String>,
    /// What it is.
    #[serde(default)]
    pub(super) title: String,
    /// Where it is defined.
    #[serde(default)]
    pub(super) source: String,
    /// Values of the parameters for tables: `['w=1/16']`.
    #[serde(default)]
    pub(super) samples: Vec<String>,
    /// The parameters.
    #[serde(default)]
    pub(super) parameters: BTreeMap<Spanned<String>, ParameterTable>,
    /// Names with formulas that the coefficients use.
    #[serde(default, rename = "let")]
    pub(super) definitions: BTreeMap<Spanned<String>, Spanned<String>>,
    /// The index offset of the limit: a formula, or `first`.
    pub(super) offset: Option<Spanned<String>>,
    /// How many points a point becomes: with `entry`, and where it may stand with `symbol`, whose value at z = 1 it is.
    pub(super) arity: Option<Spanned<String>>,
    /// How many coefficients a rule has, with `entry`.
    pub(super) width: Option<Spanned<String>>,
    /// One formula for all coefficients, in alpha and r.
    pub(super) entry: Option<Spanned<String>>,
    /// The rules: `[['3/4', '1/4'], ['1/4', '3/4']]`, or the mask in one text: `'[1, 3, 3, 1]/4'`.
    pub(super) mask: Option<Spanned<MaskTable>>,
    /// The symbol of the mask, a Laurent polynomial in z: `'z^-1*(1 + z)^3/4'`.
    pub(super) symbol: Option<Spanned<String>>,
    /// Whether this is a filter: rules with any sums. It has a `symbol`, and the arity 2 if there is no other.
    pub(super) filter: Option<Spanned<bool>>,
    /// Of a ring: the number of points of each orbit.
    pub(super) orbits: Option<OrbitTable>,
    /// Of a ring: for each orbit of new points, the weights of the orbits of old points.
    pub(super) weights: Option<WeightTable>,
    /// Of a ring: pairs of points. Of a mask on Z^d: the vectors along which data are compared, if these are not the axes.
    pub(super) edges: Option<EdgeTable>,
    /// Of a mask on Z^d: the dilation matrix, row by row; 2I if there is none.
    pub(super) dilation: Option<VectorTable>,
    /// Of a mask on Z^d that is a list of lists: the indices of the coefficient at 0, counted from 0.
    pub(super) origin: Option<Spanned<Vec<Spanned<String>>>>,
    /// The directions of a box spline: `[[1, 0], [0, 1], [1, 1]]`.
    pub(super) r#box: Option<VectorTable>,
    /// The scheme that `name` is an alias of. Allowed in claim files only.
    pub(super) r#use: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = "a table such as { default = '1/16' }, or {} where a value must be given"
)]
pub(super) struct ParameterTable {
    /// Its value where none is given.
    default: Option<Spanned<String>>,
    /// Its least value; it is then a whole number.
    least: Option<Spanned<String>>,
    /// What it is.
    #[serde(default)]
    about: String,
}

/// Finds the schemes whose symbols others use, by name.
pub type OtherSchemes<'a> = dyn Fn(&str) -> Option<Arc<SchemeDefinition>> + 'a;

/// Reads one scheme from the text of a TOML file.
pub(super) fn read_scheme_with(
    source: &Arc<SourceText>,
    others: &OtherSchemes<'_>,
) -> Result<SchemeDefinition, Diagnostic> {
    let table: SchemeTable = from_toml(source)?;
    table.define(source, others)
}

/// The schemes of a file that has several, such as a claim file.
#[derive(Deserialize)]
struct Several {
    scheme: Vec<SchemeTable>,
}

/// Whether a file has several schemes.
#[derive(Deserialize)]
struct HasSeveral {
    scheme: Option<IgnoredAny>,
}

/// Reads a scheme from the text of a TOML file: the one that stands there alone, or under `[[scheme]]` the one of this name.
///
/// # Errors
/// As [`read_scheme`]; also when there is no scheme of this name, and when there are several and no name is given.
pub(super) fn read_one_scheme(
    source: &Arc<SourceText>,
    name: Option<&str>,
    others: &OtherSchemes<'_>,
) -> Result<SchemeDefinition, Diagnostic> {
    let tables = match from_toml::<HasSeveral>(source) {
        Ok(HasSeveral { scheme: Some(_) }) => from_toml::<Several>(source)?.scheme,
        _ => vec![from_toml::<SchemeTable>(source)?],
    };
    let names: Vec<&str> = tables.iter().map(|table| table.name.get_ref().as_str()).collect();
    let written = |name: &&str| format!("`{}:{name}`", source.name);
    let found = match (name, &tables[..]) {
        (None, [only]) => Some(only),
        (None, _) => None,
        (Some(name), _) => tables.iter().find(|table| table.name.get_ref() == name),
    };
    let Some(table) = found else {
        let places: Vec<String> = names.iter().map(written).collect();
        let help = format!("write {}", places.join(" or "));
        let message = name.map_or_else(
            || "this file has several schemes".to_owned(),
            |name| {
                format!("this file has no scheme `{name}`{}", known(name, names.iter().copied()))
            },
        );
        let error = Diagnostic::new(
            source,
            tables.first().map_or(0..0, |first| first.name.span()),
            message,
        );
        return Err(match name {
            Some(name) if is_identifier(name) => {
                error.with_help(format!("{help}; a parameter is given as {name}=…"))
            }
            _ => error.with_help(help),
        });
    };
    if let Some(other) = table.alias() {
        let message = format!("`{}` stands for another scheme", table.name.get_ref());
        let help = format!("write `{}` itself", other.get_ref());
        return Err(Diagnostic::new(source, other.span(), message).with_help(help));
    }
    // The schemes before it in the file have their names there.
    let mut earlier: BTreeMap<&str, Arc<SchemeDefinition>> = BTreeMap::new();
    for before in tables.iter().take_while(|before| !std::ptr::eq(*before, table)) {
        if before.alias().is_none() && !before.is_ring() {
            let known = |name: &str| before_or_elsewhere(&names, &earlier, others, name);
            let defined = Arc::new(before.define(source, &known)?);
            earlier.insert(before.name.get_ref(), defined);
        }
    }
    let known = |name: &str| before_or_elsewhere(&names, &earlier, others, name);
    table.define(source, &known)
}

/// A scheme that stands before this one, or one from elsewhere if the file has none of this name.
fn before_or_elsewhere(
    names: &[&str],
    earlier: &BTreeMap<&str, Arc<SchemeDefinition>>,
    others: &OtherSchemes<'_>,
    name: &str,
) -> Option<Arc<SchemeDefinition>> {
    if names.contains(&name) { earlier.get(name).cloned() } else { others(name) }
}

impl SchemeTable {
    /// The scheme that this table is an alias of, if the table defines nothing else.
    #[must_use]
    pub fn alias(&self) -> Option<&Spanned<String>> {
        let own = self.offset.is_some()
            || self.arity.is_some()
            || self.width.is_some()
            || self.entry.is_some()
            || self.mask.is_some()
            || self.symbol.is_some()
            || self.filter.is_some()
            || self.is_ring()
            || self.dilation.is_some()
            || self.origin.is_some()
            || self.r#box.is_some()
            || !self.parameters.is_empty()
            || !self.definitions.is_empty();
        self.r#use.as_ref().filter(|_| !own)
    }

    /// The scheme definition in this table.
    ///
    /// # Errors
    /// When fields contradict each other, or a formula or a name is none.
    pub fn define(
        &self,
        source: &Arc<SourceText>,
        others: &OtherSchemes<'_>,
    ) -> Result<SchemeDefinition, Diagnostic> {
        let mut parameters = BTreeMap::new();
        for (name, table) in &self.parameters {
            let default = table.default.as_ref().map(|text| formula(source, text)).transpose()?;
            let least = table.least.as_ref().map(|text| formula(source, text)).transpose()?;
            let spec = ParameterSpec { default, least, about: table.about.clone() };
            parameters.insert(identifier(source, name)?, spec);
        }
        let definitions = definitions(source, &self.definitions)?;
        let stated = self.offset.as_ref().map(|text| formula(source, text)).transpose()?;
        let (own, coefficients) = self.coefficients(source, &definitions)?;
        let others = self.others(source, &coefficients, &definitions, others)?;
        Ok(SchemeDefinition {
            name: self.name.get_ref().clone(),
            title: self.title.clone(),
            citation: self.source.clone(),
            samples: self.samples.clone(),
            parameters,
            facts: CatalogueFacts::default(),
            definitions,
            offset: own.or(stated),
            is_filter: self.filter.as_ref().is_some_and(|filter| *filter.get_ref()),
            coefficients,
            others,
        })
    }

    /// The schemes of whose symbols that of this one is made.
    fn others(
        &self,
        source: &Arc<SourceText>,
        coefficients: &Coefficients,
        definitions: &BTreeMap<String, LocatedFormula>,
        others: &OtherSchemes<'_>,
    ) -> Result<BTreeMap<String, Arc<SchemeDefinition>>, Diagnostic> {
        let Some(text) = &self.symbol else { return Ok(BTreeMap::new()) };
        let own = match coefficients {
            Coefficients::Symbol(symbol) => vec![&symbol.formula],
            Coefficients::Lattice(lattice) => lattice.formulas(),
            _ => Vec::new(),
        };
        let formulas = definitions.values().chain(own);
        let names = formulas.flat_map(|formula| composed_of(&formula.expr));
        let other = |name: String| {
            let missing = || SchemeError::NoOther { name: name.clone() };
            let found = others(&name);
            let found =
                found.ok_or_else(|| Diagnostic::new(source, text.span(), missing().to_string()));
            Ok((name.clone(), found?))
        };
        names.map(other).collect()
    }

    pub(super) fn is_ring(&self) -> bool {
        self.orbits.is_some() || self.weights.is_some() || (self.edges.is_some() && !self.is_mask())
    }

    /// Whether this has coefficients of a mask.
    pub(super) fn is_mask(&self) -> bool {
        self.mask.is_some() || self.symbol.is_some() || self.r#box.is_some()
    }
}
