//! The formulas of a theorem in one case.

use crate::diagnostic::Diagnostic;
use crate::evaluation::quantity::Quantities;
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::Reason;
use crate::formula::{FormulaErrorKind, FreeNames, LocatedFormula, Scope, evaluate};
use crate::judge::theorem::case::Case;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

/// The names of the spread of the control data, which is 1. Curves and rings have only the first
/// name, nets have all.
pub(crate) const SPREADS: [&str; 4] = ["beta", "beta_1", "beta_2", "beta_3"];

/// The names of the level in a bound and of the tolerance in a depth.
pub(crate) const LEVEL: &str = "k";

pub(crate) const TOLERANCE: &str = "epsilon";

/// A value, or why there is none.
pub(crate) type Evaluated = Result<RealCyclotomic, Reason>;

impl Case<'_> {
    pub(crate) fn functions<'s>(&'s self, settings: &'s Settings) -> Quantities<'s> {
        let (library, scheme) = (self.library, self.resolved.clone());
        Quantities { library, scheme, settings, noted: None, last_levels: RefCell::default() }
    }

    pub(crate) fn scope<'s>(
        &'s self,
        functions: &'s Quantities<'s>,
        names: &[(&'s str, Rational)],
    ) -> Scope<'s, RealCyclotomic> {
        let definitions = functions.settings.definitions.as_deref();
        let mut scope = Scope::new(definitions.unwrap_or(&self.paper.definitions), functions);
        scope = scope.with_all(&functions.settings.known).with_formulas(&self.stated);
        for (name, value) in &self.values {
            scope = scope.with(name, value.clone().into());
        }
        for name in self.spreads() {
            scope = scope.with(*name, Rational::one().into());
        }
        for (name, value) in names {
            scope = scope.with(*name, value.clone().into());
        }
        scope
    }

    /// The names of the spread that have a meaning for this scheme.
    fn spreads(&self) -> &'static [&'static str] {
        let net = self.resolved.as_ref().is_some_and(|scheme| scheme.instances.len() == 2);
        if net { &SPREADS } else { &SPREADS[..1] }
    }

    /// The value of a formula where these names have these values, and the spread is 1.
    pub(crate) fn evaluate(
        &self,
        formula: &LocatedFormula,
        names: &[(&str, Rational)],
        settings: &Settings,
    ) -> Result<Evaluated, Diagnostic> {
        self.evaluate_part(formula, &formula.expr, names, settings)
    }

    /// The value of a part of a formula, or of another formula in its place.
    pub(crate) fn evaluate_part(
        &self,
        formula: &LocatedFormula,
        part: &crate::formula::Expr,
        names: &[(&str, Rational)],
        settings: &Settings,
    ) -> Result<Evaluated, Diagnostic> {
        let functions = self.functions(settings);
        match evaluate(part, &self.scope(&functions, names)) {
            Ok(value) => Ok(Ok(value)),
            Err(error) => match (&error.kind, error.kind.cap()) {
                (kind @ FormulaErrorKind::Undefined(_), _) => Ok(Err(kind.clone().into())),
                (FormulaErrorKind::DivisionByZero, _) => Ok(Err(Reason::DividesByZero)),
                (_, Some(cap)) => Ok(Err(cap.into())),
                (_, None) => Err(formula.diagnostic(&error)),
            },
        }
    }

    /// The reading with the values of those definitions in a formula that depend on neither
    /// the level nor the tolerance nor the spread: they are computed once for all of these.
    pub(crate) fn prepared(&self, formula: &LocatedFormula, mut settings: Settings) -> Settings {
        let definitions = self.definitions(&settings);
        let mut free = FreeNames::new(definitions);
        let same = |name: &String| self.values.contains_key(name) && !varies(name);
        let (mut met, mut waiting) = (BTreeSet::new(), vec![formula]);
        let mut known = BTreeMap::new();
        while let Some(formula) = waiting.pop() {
            for name in formula.expr.names() {
                let Some((name, definition)) = definitions.get_key_value(name) else { continue };
                if self.has_value(name) || !met.insert(name) {
                    continue;
                }
                if !free.of_name(name).iter().all(same) {
                    waiting.push(definition);
                } else if let Ok(Ok(value)) = self.evaluate(definition, &[], &settings) {
                    known.insert(name.clone(), value);
                }
            }
        }
        settings.known = known;
        settings
    }

    /// Whether the bound of the theorem is proportional to the spread.
    pub(crate) fn is_linear(&self, by: &LocatedFormula, k: u32) -> Result<bool, Diagnostic> {
        if let Some(linear) = self.linear.get() {
            return Ok(*linear);
        }
        let settings = self.prepared(by, Settings::default());
        let mut names: Vec<(&str, Rational)> =
            self.spreads().iter().map(|name| (*name, Rational::from(2))).collect();
        names.push((LEVEL, Rational::from(k)));
        let once = self.evaluate(by, &[(LEVEL, Rational::from(k))], &settings)?;
        let twice = self.evaluate(by, &names, &settings)?;
        let linear = match (once, twice) {
            (Ok(once), Ok(twice)) => &once + &once == twice,
            _ => true,
        };
        Ok(*self.linear.get_or_init(|| linear))
    }

    /// The definitions of the paper under a reading.
    pub(crate) fn definitions<'s>(
        &'s self,
        settings: &'s Settings,
    ) -> &'s BTreeMap<String, LocatedFormula> {
        settings.definitions.as_deref().unwrap_or(&self.paper.definitions)
    }

    /// Whether a name has a value in this case, even if there is a definition of this name.
    pub(crate) fn has_value(&self, name: &str) -> bool {
        self.values.contains_key(name) || self.spreads().contains(&name)
    }
}

/// Whether a name can have several values in one case.
fn varies(name: &str) -> bool {
    SPREADS.contains(&name) || [LEVEL, TOLERANCE].contains(&name)
}
