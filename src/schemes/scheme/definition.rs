//! Scheme definitions: formulas over parameters, and the masks that they give.

use super::composed::{Composed, SymbolOf, Symbols};
use super::error::{SchemeError, at_values};
use super::lattice::formulas::LatticeFormulas;
use super::lattice::mask::LatticeMask;
use super::local::formulas::LocalFormulas;
use super::mask::{Mask, MaskError};
use super::rules::{MAX_ARITY, MAX_WIDTH, RulesError};
use super::typed::symbol::{Arity, SymbolFormula};
use crate::cap::Cap;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::common_conductor;
use crate::formula::{FormulaErrorKind, LocatedFormula, Value};
use serde::Deserialize;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// What helps where decimals do not add up.
pub(super) const ROUNDED: &str =
    "if the coefficients are rounded, write the exact ones, such as 1/3 for 0.33";

/// A parameter of a scheme.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParameterSpec {
    /// The value used when none is given; `None` when a value must be given.
    pub default: Option<LocatedFormula>,
    /// Its least value, such as a valence of 3, if it is a whole number.
    pub least: Option<LocatedFormula>,
    /// A description.
    pub about: String,
}

/// What is known of rules of the catalogue beyond themselves, so that no other list names them. A regular part is
/// `bicubic`, `box-spline` or `biquadratic`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CatalogueFacts {
    /// The regular part of which these rules are the model.
    pub model: Option<String>,
    /// The regular part, where the eigenvalues are in order at all valences (`proofs/THEOREMS.md`, 135).
    pub ordered: Option<String>,
    /// The rules between sharp edges: `catmull-clark` or `loop`.
    pub sector: Option<String>,
    /// How many steps of the scheme these rules are, where one step turns the points: a whole number as text.
    pub steps: Option<String>,
}

/// A scheme as defined in a file: a mask or a ring, as formulas over parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SchemeDefinition {
    /// Its name, as used in SCHEME.
    pub name: String,
    /// A description.
    pub title: String,
    /// Where it was published.
    pub citation: String,
    /// Values of its parameters, such as `w=1/16`, whose schemes stand for the family in tables.
    pub samples: Vec<String>,
    /// Its parameters, under their names.
    pub parameters: BTreeMap<String, ParameterSpec>,
    /// What the catalogue knows of it.
    pub facts: CatalogueFacts,
    pub(super) definitions: BTreeMap<String, LocatedFormula>,
    pub(super) offset: Option<LocatedFormula>,
    /// Whether its rules may have any sums.
    pub(super) is_filter: bool,
    pub(super) coefficients: Coefficients,
    /// The schemes of whose symbols its own is made.
    pub(super) others: BTreeMap<String, Arc<SchemeDefinition>>,
}

/// The three ways to define a mask, a mask on Z^d, and the definition of a ring.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Coefficients {
    /// One formula for each coefficient.
    Listed(Vec<Vec<LocatedFormula>>),
    /// One formula for all coefficients a_{α,j}, where α is called `alpha` and j is
    /// called `r`.
    Rule(Box<RuleFormulas>),
    /// A Laurent polynomial, which has the offset.
    Symbol(Box<SymbolFormula>),
    /// A mask on Z^d.
    Lattice(Box<LatticeFormulas>),
    /// A ring: formulas for the weights between orbits of points.
    LocalRules(Box<LocalFormulas>),
}

/// The formulas of [`Coefficients::Rule`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RuleFormulas {
    pub(super) arity: LocatedFormula,
    pub(super) width: LocatedFormula,
    pub(super) entry: LocatedFormula,
}

/// The most symbols of other schemes in one, those in them included.
pub(super) const MAX_OTHERS: u64 = 64;

impl SchemeDefinition {
    /// The references that stand for this scheme in tables: with each of its samples, or its name alone if
    /// every parameter has a default. There are none of rules that need a valence.
    ///
    /// ```
    /// let scheme = subcert::scheme::find("ternary-four-point").expect("of the catalogue");
    /// assert_eq!(scheme.references(), ["ternary-four-point:mu=1/11", "ternary-four-point:mu=1/10"]);
    /// ```
    #[must_use]
    pub fn references(&self) -> Vec<String> {
        let name = &self.name;
        if self.samples.is_empty() && self.parameters.values().all(|spec| spec.default.is_some()) {
            return vec![name.clone()];
        }
        self.samples.iter().map(|sample| format!("{name}:{sample}")).collect()
    }

    /// The mask at these parameter values, over any [`Value`]. With
    /// [`Polynomial`](crate::exact::Polynomial) values the mask stays symbolic; with
    /// [`RealCyclotomic`](crate::exact::RealCyclotomic) values it may contain cosines.
    ///
    /// # Errors
    /// When this is a ring, a parameter is missing or unknown, a formula has no value,
    /// the coefficients have no [`common_conductor`], or they are not a mask.
    pub fn mask<V: Value + PartialEq>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<Mask<V>, SchemeError> {
        if self.is_filter {
            return Err(SchemeError::Filter { scheme: self.name.clone() });
        }
        self.mask_or_filter(values)
    }

    /// The mask, or the coefficients of a filter as rules that may have any sums.
    ///
    /// # Errors
    /// As [`SchemeDefinition::mask`], for all but filters.
    pub fn mask_or_filter<V: Value + PartialEq>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<Mask<V>, SchemeError> {
        self.mask_within(values, &Cell::new(MAX_OTHERS))
    }

    /// Whether this is a filter, whose rules may have any sums.
    #[must_use]
    pub fn is_filter(&self) -> bool {
        self.is_filter
    }

    /// Whether this is a mask on Z^d.
    #[must_use]
    pub fn is_lattice(&self) -> bool {
        matches!(self.coefficients, Coefficients::Lattice(_))
    }

    /// The mask on Z^d at these values of the parameters.
    ///
    /// # Errors
    /// When this is none, and as [`SchemeDefinition::mask`].
    pub fn lattice<V: Value + PartialEq>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<LatticeMask<V>, SchemeError> {
        self.lattice_within(values, &Cell::new(MAX_OTHERS))
    }

    fn lattice_within<V: Value + PartialEq>(
        &self,
        values: &BTreeMap<String, V>,
        left: &Cell<u64>,
    ) -> Result<LatticeMask<V>, SchemeError> {
        let Coefficients::Lattice(formulas) = &self.coefficients else {
            return Err(SchemeError::NotLattice { scheme: self.name.clone() });
        };
        let parameters = self.complete(values)?;
        let mask = formulas.mask(&self.definitions, &parameters, &self.composed(left));
        mask.map_err(|error| SchemeError::File(Box::new(at_values(error, &parameters))))
    }

    /// The symbols of the schemes whose symbols that of this one uses.
    pub(super) fn composed<'a, V: Value + PartialEq>(
        &'a self,
        left: &'a Cell<u64>,
    ) -> Composed<'a, impl Symbols<V>> {
        Composed {
            names: self.others.keys().map(String::as_str).collect(),
            symbol: |name: &str, values: &BTreeMap<String, V>| self.other(name, values, left),
        }
    }

    /// The symbol of a scheme which that of this one uses, of which so many are `left`.
    fn other<V: Value + PartialEq>(
        &self,
        name: &str,
        values: &BTreeMap<String, V>,
        left: &Cell<u64>,
    ) -> Result<SymbolOf<V>, SchemeError> {
        let missing = || SchemeError::NoOther { name: name.to_owned() };
        let other = self.others.get(name).ok_or_else(missing)?;
        left.set(left.get().checked_sub(1).ok_or_else(|| {
            let (source, span) = self.whole();
            let cap = Cap::new("the number of symbols of other schemes in one", MAX_OTHERS);
            let diagnostic = Diagnostic::new(source, span, cap.to_string());
            SchemeError::File(Box::new(diagnostic.with_cap(Some(cap))))
        })?);
        if other.is_lattice() {
            return other.lattice_within(values, left).map(|mask| SymbolOf::lattice(&mask));
        }
        other.mask_within(values, left).map(|mask| SymbolOf::curve(&mask))
    }

    fn mask_within<V: Value + PartialEq>(
        &self,
        values: &BTreeMap<String, V>,
        left: &Cell<u64>,
    ) -> Result<Mask<V>, SchemeError> {
        let parameters = self.complete(values)?;
        let mut offset = match &self.offset {
            Some(formula) => {
                self.integer(formula, &parameters, &[], "the offset", -10_000..10_001)?
            }
            None => 0,
        };
        let rows = match &self.coefficients {
            Coefficients::Listed(rows) => rows
                .iter()
                .map(|row| row.iter().map(|entry| self.value(entry, &parameters, &[])).collect())
                .collect::<Result<Vec<Vec<V>>, SchemeError>>()?,
            Coefficients::Rule(rule) => {
                let size =
                    |formula, what, range| self.integer(formula, &parameters, &[], what, range);
                let arity = size(&rule.arity, "the arity", 2..cap(MAX_ARITY))?;
                let width = size(&rule.width, "the width", 1..cap(MAX_WIDTH))?;
                let coefficient =
                    |alpha, r| self.value(&rule.entry, &parameters, &[("alpha", alpha), ("r", r)]);
                (0..arity)
                    .map(|alpha| (0..width).map(|r| coefficient(alpha, r)).collect())
                    .collect::<Result<Vec<Vec<V>>, SchemeError>>()?
            }
            Coefficients::Symbol(symbol) => {
                let size = |it| self.integer(it, &parameters, &[], "the arity", 2..cap(MAX_ARITY));
                let stated = symbol.arity.as_ref().map(size).transpose()?;
                let stated = stated.and_then(|n| usize::try_from(n).ok());
                let arity = if self.is_filter {
                    Arity::OfFilter(stated.unwrap_or(2))
                } else {
                    Arity::OfSum(stated)
                };
                let composed = self.composed(left);
                let rules = symbol.rules(&self.definitions, &parameters, arity, &composed);
                let rows;
                (rows, offset) = rules.map_err(|error| SchemeError::File(Box::new(error)))?;
                rows
            }
            Coefficients::Lattice(_) => {
                return Err(SchemeError::Lattice { scheme: self.name.clone() });
            }
            Coefficients::LocalRules(_) => {
                return Err(SchemeError::LocalRules { scheme: self.name.clone() });
            }
        };
        let rows = self.in_one_field(rows)?;
        let mask =
            if self.is_filter { Mask::filter(rows, offset) } else { Mask::new(rows, offset) };
        mask.map_err(|error| {
            let refusal = self.refusal(&error);
            SchemeError::File(Box::new(at_values(refusal, &parameters)))
        })
    }

    /// Whether this is a mask whose offset is not stated, and therefore 0.
    #[must_use]
    pub fn leaves_offset_out(&self) -> bool {
        use Coefficients::{Listed, Rule};
        self.offset.is_none() && matches!(self.coefficients, Listed(_) | Rule(_))
    }

    /// An error unless some field within the cap contains all `coefficients`.
    pub(super) fn check_common_field<'a, V: Value + 'a>(
        &self,
        coefficients: impl Iterator<Item = &'a V>,
    ) -> Result<(), SchemeError> {
        let mut conductors = coefficients.map(Value::conductor);
        let all = conductors.try_fold(1, common_conductor);
        all.map(|_| ()).map_err(|error| self.apart(&error.into()))
    }

    /// The error that no field within the caps has all coefficients.
    fn apart(&self, error: &FormulaErrorKind) -> SchemeError {
        let (source, span) = self.whole();
        let diagnostic = Diagnostic::new(source, span, error.to_string());
        SchemeError::File(Box::new(diagnostic.with_cap(error.cap())))
    }

    /// The coefficients in one field; an error when no field within the caps has them.
    fn in_one_field<V: Value>(&self, rows: Vec<Vec<V>>) -> Result<Vec<Vec<V>>, SchemeError> {
        let lengths: Vec<usize> = rows.iter().map(Vec::len).collect();
        let all = V::together(rows.into_iter().flatten().collect());
        let all = all.map_err(|error| self.apart(&error))?;
        let mut all = all.into_iter();
        Ok(lengths.into_iter().map(|length| all.by_ref().take(length).collect()).collect())
    }

    /// The error that the coefficients are not a mask, at their place in the file.
    fn refusal(&self, error: &MaskError) -> Diagnostic {
        let (source, span) = match (&self.coefficients, error) {
            (
                Coefficients::Listed(rows),
                MaskError::NotAffine { rule, .. }
                | MaskError::Rules(RulesError::Ragged { rule, .. }),
            ) => (&rows[*rule][0].source, extent(&rows[*rule..=*rule])),
            _ => self.whole(),
        };
        let diagnostic = Diagnostic::new(source, span.clone(), error.to_string());
        let decimal = source.text.get(span).is_some_and(|text| text.contains('.'));
        let affine = matches!(error, MaskError::NotAffine { .. });
        let helped = if affine && decimal { diagnostic.with_help(ROUNDED) } else { diagnostic };
        helped.with_cap(error.cap())
    }

    /// The place that spans all coefficients.
    fn whole(&self) -> (&Arc<SourceText>, Range<usize>) {
        match &self.coefficients {
            Coefficients::Rule(rule) => (&rule.entry.source, rule.entry.span.clone()),
            Coefficients::Listed(rows) => (&rows[0][0].source, extent(rows)),
            Coefficients::Symbol(symbol) => (&symbol.formula.source, symbol.formula.span.clone()),
            Coefficients::Lattice(formulas) => (&formulas.source, formulas.span.clone()),
            Coefficients::LocalRules(ring) => ring.whole(),
        }
    }
}

fn cap(max: usize) -> i64 {
    i64::try_from(max).unwrap_or(i64::MAX - 1) + 1
}

/// The place that spans all coefficients of these rows. No row is empty, as the reader refuses empty rows.
fn extent(rows: &[Vec<LocatedFormula>]) -> Range<usize> {
    let spans = || rows.iter().flatten().map(|formula| &formula.span);
    let start = spans().map(|span| span.start).min().expect("the reader refuses empty rules");
    start..spans().map(|span| span.end).max().unwrap_or(start)
}
