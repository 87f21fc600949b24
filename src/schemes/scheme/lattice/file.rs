//! Masks on Z^d in TOML.

use super::formulas::LatticeFormulas;
use super::integers::Vectors;
use super::read::{DILATION, EDGES, ORIGIN, Stated, has_lattice_variable};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{FreeNames, LATTICE_VARIABLES, LocatedFormula, parse};
use crate::scheme::fields::{MaskTable, rules};
use crate::scheme::file::SchemeTable;
use crate::scheme::spanned::Spanned;
use crate::scheme::typed::nested::{is_nested, nested};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

impl SchemeTable {
    /// The mask on Z^d in this table, if there is one.
    ///
    /// # Errors
    /// When fields contradict each other, or one is malformed.
    pub(in crate::scheme) fn lattice(
        &self,
        source: &Arc<SourceText>,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<Option<LatticeFormulas>, Diagnostic> {
        let stated = self.stated(source)?;
        let symbol = self
            .symbol
            .as_ref()
            .filter(|symbol| self.in_two_variables(symbol.get_ref(), definitions));
        let lists = match self.mask.as_ref().map(Spanned::get_ref) {
            Some(MaskTable::Text(text)) => is_nested(text),
            Some(MaskTable::Rules(_)) => !stated.is_empty(),
            None => false,
        };
        if stated.is_empty() && symbol.is_none() && !lists && self.r#box.is_none() {
            return Ok(None);
        }
        self.refuse_others(source)?;
        let formulas = match (&self.symbol, &self.mask, &self.r#box) {
            (Some(text), None, None) => {
                self.refuse_variables(source)?;
                stated.symbol(source, text.span(), text.get_ref(), definitions)
            }
            (None, Some(mask), None) => stated.listed(source, mask.span(), list(source, mask)?),
            (None, None, Some(directions)) => {
                stated.box_spline(source, &Vectors::of_table(source, directions)?)
            }
            _ => {
                let message = "a mask on Z^d needs either `symbol`, or `mask`, or `box`";
                Err(Diagnostic::new(source, self.name.span(), message).with_help(
                    "symbol = '(1 + x)*(1 + y)*(1 + x*y)/2' is the symbol, mask = '[[1, 1], [1, 1]]' lists coefficients, box = [[1, 0], [0, 1], [1, 1]] \
                     has the directions of a box spline",
                ))
            }
        };
        formulas.map(Some)
    }

    /// What is stated beside the coefficients.
    fn stated(&self, source: &Arc<SourceText>) -> Result<Stated, Diagnostic> {
        let vectors = |table| Vectors::of_table(source, table);
        let origin = self.origin.as_ref().map(|origin| {
            let text = |word: &Spanned<String>| word.get_ref().clone();
            let words: Vec<String> = origin.get_ref().iter().map(text).collect();
            Vectors::of_text(source, origin.span(), &format!("[{}]", words.join(",")))
        });
        let edges = self.edges.as_ref().filter(|_| self.orbits.is_none() && self.weights.is_none());
        Ok(Stated {
            dilation: self.dilation.as_ref().map(vectors).transpose()?,
            edges: edges.filter(|_| !self.is_ring()).map(vectors).transpose()?,
            origin: origin.transpose()?,
        })
    }

    /// Whether a symbol, or a definition that it names, has x or y, and these are no parameters.
    fn in_two_variables(&self, text: &str, definitions: &BTreeMap<String, LocatedFormula>) -> bool {
        let Ok(expr) = parse(text) else { return false };
        let names = FreeNames::new(definitions).of(&expr);
        let own = || self.parameters.keys().chain(self.definitions.keys());
        has_lattice_variable(&names, |name| own().any(|known| known.get_ref() == name))
    }

    /// Refuses fields that masks on Z^d have not.
    fn refuse_others(&self, source: &Arc<SourceText>) -> Result<(), Diagnostic> {
        let fields = [
            ("offset", self.offset.as_ref().map(Spanned::span)),
            ("arity", self.arity.as_ref().map(Spanned::span)),
            ("width", self.width.as_ref().map(Spanned::span)),
            ("entry", self.entry.as_ref().map(Spanned::span)),
            ("filter", self.filter.as_ref().map(Spanned::span)),
            ("orbits", self.orbits.as_ref().map(Spanned::span)),
        ];
        let found = fields.into_iter().find_map(|(name, span)| Some((name, span?)));
        let found: Option<(&str, Range<usize>)> = found;
        found.map_or(Ok(()), |(name, span)| {
            let message = format!("a mask on Z^d has no `{name}`");
            let help = format!(
                "it has `symbol`, `mask` or `box`, and beside it `{DILATION}`, `{EDGES}` and `{ORIGIN}`"
            );
            Err(Diagnostic::new(source, span, message).with_help(help))
        })
    }

    fn refuse_variables(&self, source: &Arc<SourceText>) -> Result<(), Diagnostic> {
        let names = self.parameters.keys().chain(self.definitions.keys());
        let is_variable =
            |name: &&Spanned<String>| LATTICE_VARIABLES.contains(&&name.get_ref()[..]);
        names.into_iter().find(is_variable).map_or(Ok(()), |name| {
            let message = format!("`{}` is a variable of the symbol", name.get_ref());
            Err(Diagnostic::new(source, name.span(), message).with_help("take another name"))
        })
    }
}

/// The coefficients of lists of lists, with their indices.
fn list(
    source: &Arc<SourceText>,
    mask: &Spanned<MaskTable>,
) -> Result<Vec<(Vec<i64>, LocatedFormula)>, Diagnostic> {
    match mask.get_ref() {
        MaskTable::Rules(listed) => {
            let rows = rules(source, mask.span(), listed)?;
            let row = |(i, row): (i64, Vec<LocatedFormula>)| {
                (0_i64..)
                    .zip(row)
                    .map(move |(j, formula)| (vec![i, j], formula))
                    .collect::<Vec<_>>()
            };
            Ok((0..).zip(rows).flat_map(row).collect())
        }
        MaskTable::Text(text) => {
            let Some(start) = source.text[mask.span()].find(text) else {
                let message = "a mask in one text is written without escapes";
                return Err(Diagnostic::new(source, mask.span(), message)
                    .with_help("write it in single quotes: mask = '[[1, 1], [1, 1]]'"));
            };
            let start = mask.span().start + start;
            nested(source, start..start + text.len())
        }
    }
}
