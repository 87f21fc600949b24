//! Reading schemes from TOML.

use super::composed::composed_of;
use super::definition::{
    CatalogueFacts, Coefficients, ParameterSpec, RuleFormulas, SchemeDefinition,
};
use super::error::SchemeError;
use super::fields::{MaskTable, definitions, formula, identifier, rules};
use super::local_file::{EdgeTable, OrbitTable, WeightTable, ring};
use super::local_formulas::{LocalFormulas, NEW_INDEX, OLD_INDEX};
use super::spanned::Spanned;
use super::toml_file::from_toml;
use super::typed::symbol::SymbolFormula;
use super::typed::{self, Typed};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{LocatedFormula, SYMBOL_VARIABLE, is_identifier};
use crate::suggestion::known;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::BTreeMap;
use std::ops::Range;
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
    title: String,
    /// Where it is defined.
    #[serde(default)]
    source: String,
    /// Values of the parameters for tables: `['w=1/16']`.
    #[serde(default)]
    samples: Vec<String>,
    /// The parameters.
    #[serde(default)]
    parameters: BTreeMap<Spanned<String>, ParameterTable>,
    /// Names with formulas that the coefficients use.
    #[serde(default, rename = "let")]
    definitions: BTreeMap<Spanned<String>, Spanned<String>>,
    /// The index offset of the limit: a formula, or `first`.
    offset: Option<Spanned<String>>,
    /// How many points a point becomes: with `entry`, and where it may stand with `symbol`, whose value at z = 1 it is.
    arity: Option<Spanned<String>>,
    /// How many coefficients a rule has, with `entry`.
    width: Option<Spanned<String>>,
    /// One formula for all coefficients, in alpha and r.
    entry: Option<Spanned<String>>,
    /// The rules: `[['3/4', '1/4'], ['1/4', '3/4']]`, or the mask in one text: `'[1, 3, 3, 1]/4'`.
    mask: Option<Spanned<MaskTable>>,
    /// The symbol of the mask, a Laurent polynomial in z: `'z^-1*(1 + z)^3/4'`.
    symbol: Option<Spanned<String>>,
    /// Of a ring: the number of points of each orbit.
    orbits: Option<OrbitTable>,
    /// Of a ring: for each orbit of new points, the weights of the orbits of old points.
    weights: Option<WeightTable>,
    /// Of a ring: pairs of points.
    edges: Option<EdgeTable>,
    /// The scheme that `name` is an alias of. Allowed in claim files only.
    r#use: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = "a table such as { default = '1/16' }, or {} where a value must be given"
)]
struct ParameterTable {
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
            let known = |name: &str| earlier.get(name).cloned().or_else(|| others(name));
            let defined = Arc::new(before.define(source, &known)?);
            earlier.insert(before.name.get_ref(), defined);
        }
    }
    let known = |name: &str| earlier.get(name).cloned().or_else(|| others(name));
    table.define(source, &known)
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
            || self.is_ring()
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
        let (Coefficients::Symbol(symbol), Some(text)) = (coefficients, &self.symbol) else {
            return Ok(BTreeMap::new());
        };
        let formulas = definitions.values().chain([&symbol.formula]);
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

    fn is_ring(&self) -> bool {
        self.orbits.is_some() || self.weights.is_some() || self.edges.is_some()
    }

    /// The coefficients, and the offset of a mask that is one text.
    fn coefficients(
        &self,
        source: &Arc<SourceText>,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<(Option<LocatedFormula>, Coefficients), Diagnostic> {
        if let Some(other) = &self.r#use {
            return Err(Diagnostic::new(
                source,
                other.span(),
                "`use` stands alone, in claim files",
            )
            .with_help("write `name` and `use` only, or the scheme's own mask"));
        }
        if self.is_ring() {
            let formulas = self.ring(source)?;
            return Ok((None, Coefficients::LocalRules(Box::new(formulas))));
        }
        if let (Some(symbol), None, None, None) =
            (&self.symbol, &self.mask, &self.width, &self.entry)
        {
            let formula = self.symbol(source, symbol)?;
            return Ok((None, Coefficients::Symbol(Box::new(formula))));
        }
        let symbol = self.symbol.is_some();
        match (&self.mask, &self.arity, &self.width, &self.entry) {
            (Some(mask), None, None, None) if !symbol => match mask.get_ref() {
                MaskTable::Rules(rules) => {
                    Ok((None, Coefficients::Listed(self::rules(source, mask.span(), rules)?)))
                }
                MaskTable::Text(text) => self.text(source, mask.span(), text, definitions),
            },
            (None, Some(arity), Some(width), Some(entry)) if !symbol => {
                let formulas = RuleFormulas {
                    arity: formula(source, arity)?,
                    width: formula(source, width)?,
                    entry: formula(source, entry)?,
                };
                Ok((None, Coefficients::Rule(Box::new(formulas))))
            }
            _ => Err(Diagnostic::new(
                source,
                self.name.span(),
                "a scheme needs either `mask`, or `symbol`, or `arity`, `width` and `entry`",
            )
            .with_help(
                "mask = '[1, 3, 3, 1]/4' is the mask in one text, and mask = [['3/4', '1/4'], \
                 ['1/4', '3/4']] lists the rules; symbol = '(1 + z)^3/4' is the symbol; `entry` is one formula for all coefficients, in alpha = 0..arity-1 and r = 0..width-1; a ring has \
                 `orbits`, `weights` and `edges` instead",
            )),
        }
    }
}

impl SchemeTable {
    /// The mask in one text, which has its offset.
    fn text(
        &self,
        source: &Arc<SourceText>,
        span: Range<usize>,
        text: &str,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<(Option<LocatedFormula>, Coefficients), Diagnostic> {
        if let Some(offset) = &self.offset {
            let message =
                "a mask in one text has its offset: point 0 stays at the coefficient in its middle";
            return Err(Diagnostic::new(source, offset.span(), message).with_help(
                "leave out `offset`, or list the rules: mask = [['3/4', '1/4'], ['1/4', '3/4']]",
            ));
        }
        let Some(start) = source.text[span.clone()].find(text) else {
            let message = "a mask in one text is written without escapes";
            return Err(Diagnostic::new(source, span, message)
                .with_help("write it in single quotes: mask = '[1, 3, 3, 1]/4'"));
        };
        let start = span.start + start;
        let Typed { offset, rows, .. } =
            typed::mask(source, start..start + text.len(), definitions, &BTreeMap::new())?;
        Ok((Some(offset), Coefficients::Listed(rows)))
    }

    /// The symbol, which fixes the offset.
    fn symbol(
        &self,
        source: &Arc<SourceText>,
        symbol: &Spanned<String>,
    ) -> Result<SymbolFormula, Diagnostic> {
        if let Some(offset) = &self.offset {
            let message = "a symbol has its offset: the coefficient of z^k makes the point k of the next level from point 0";
            return Err(Diagnostic::new(source, offset.span(), message)
                .with_help("leave out `offset`, and multiply the symbol by a power of z to shift it, as in z^-2*(1 + z)^4/8"));
        }
        for name in self.parameters.keys().chain(self.definitions.keys()) {
            if name.get_ref() == SYMBOL_VARIABLE {
                let message = "`z` is the variable of the symbol";
                return Err(
                    Diagnostic::new(source, name.span(), message).with_help("take another name")
                );
            }
        }
        let arity = self.arity.as_ref().map(|text| formula(source, text)).transpose()?;
        let read = SymbolFormula::read(source, symbol.span(), symbol.get_ref())?;
        Ok(SymbolFormula { arity, ..read })
    }

    fn ring(&self, source: &Arc<SourceText>) -> Result<LocalFormulas, Diagnostic> {
        let at_name = |message: &str| Diagnostic::new(source, self.name.span(), message);
        let of_mask = [&self.offset, &self.arity, &self.width, &self.entry, &self.symbol];
        if self.mask.is_some() || of_mask.iter().any(|field| field.is_some()) {
            let message = "a scheme has either a mask or a ring, not both";
            return Err(at_name(message).with_help(
                "`mask`, `symbol`, `arity`, `width`, `entry` and `offset` make a mask; `orbits`, `weights` \
                 and `edges` a ring",
            ));
        }
        let (Some(orbits), Some(weights), Some(edges)) = (&self.orbits, &self.weights, &self.edges)
        else {
            return Err(at_name("a ring needs `orbits`, `weights` and `edges`").with_help(
                "orbits = { vertex = '1', edge = 'N' }; [weights.edge] with vertex = '3/4' and \
                 edge = 'kronecker(i, j)/4'; edges = [['vertex', 'edge[i]']]",
            ));
        };
        for name in self.parameters.keys().chain(self.definitions.keys()) {
            if [NEW_INDEX, OLD_INDEX].contains(&name.get_ref().as_str()) {
                let message = format!("`{}` is an index of the points of a ring", name.get_ref());
                return Err(
                    Diagnostic::new(source, name.span(), message).with_help("take another name")
                );
            }
        }
        ring(source, orbits, weights, edges)
    }
}
