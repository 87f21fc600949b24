//! The rules of a scheme in TOML: a mask, a symbol, a formula for all coefficients, or a ring.

use super::definition::{Coefficients, RuleFormulas};
use super::fields::{self, MaskTable, formula};
use super::file::SchemeTable;
use super::foreign::foreign_symbol;
use super::local::file::ring;
use super::local::formulas::{LocalFormulas, NEW_INDEX, OLD_INDEX};
use super::spanned::Spanned;
use super::typed::symbol::SymbolFormula;
use super::typed::{self, Typed};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{LocatedFormula, SYMBOL_VARIABLE};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

impl SchemeTable {
    /// The coefficients, and the offset of a mask that is one text.
    pub(super) fn coefficients(
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
        if let (Some(filter), None) = (&self.filter, &self.symbol) {
            let message = "a filter is given by its `symbol`";
            return Err(Diagnostic::new(source, filter.span(), message)
                .with_help("write filter = true with symbol = '(1 - z)^2/4'"));
        }
        if let Some(lattice) = self.lattice(source, definitions)? {
            return Ok((None, Coefficients::Lattice(Box::new(lattice))));
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
                MaskTable::Rules(listed) => {
                    Ok((None, Coefficients::Listed(fields::rules(source, mask.span(), listed)?)))
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
                 ['1/4', '3/4']] lists the rules; symbol = '(1 + z)^3/4' is the symbol, in x, y and z that of a mask on Z^d; `entry` is one formula for all coefficients, in alpha = 0..arity-1 and r = 0..width-1; a ring has \
                 `orbits`, `weights` and `edges` instead",
            )),
        }
    }

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
        let names = self.parameters.keys().chain(self.definitions.keys());
        let names: Vec<&str> = names.map(|name| name.get_ref().as_str()).collect();
        if let Some((message, help)) = foreign_symbol(symbol.get_ref(), &names) {
            return Err(Diagnostic::new(source, symbol.span(), message).with_help(help));
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
