//! One instance of a theorem, its bound with all numbers put in.

use crate::claim::{Paper, Statement, THEOREM_NAMES, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, Resolved};
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{HandConstant, Refiner};
use crate::formula::{Expr, LocatedFormula, Node, is_builtin};
use crate::judge::theorem::case::{Case, Stage};
use crate::judge::theorem::evaluate::{LEVEL, TOLERANCE};
use crate::scheme::{LocalRules, Scheme};
use std::collections::BTreeMap;

/// An instance of a theorem, with numbers in place of names.
pub(crate) struct Instance {
    /// The scheme of masks.
    pub(crate) resolved: Option<Resolved>,
    /// What refines its data; masks at the offsets at which they are compared with their limit.
    pub(crate) refiner: Refiner,
    /// What puts the points with which a step of a ring is compared, if not themselves.
    pub(crate) interpolant: Option<LocalRules>,
    /// The values of parameters.
    pub(crate) values: BTreeMap<String, Rational>,
    /// The constants in the bound; the cells that print them are not yet looked for.
    pub(crate) constants: Vec<HandConstant>,
    /// The bound with all numbers put in.
    pub(crate) bound: String,
}

/// The instance with this label, at a level or, for a depth, at a tolerance; the spread is 1.
pub(crate) fn instance(
    paper: &Paper,
    theorem: &Theorem,
    label: &str,
    (level, tolerance): (u32, &RealCyclotomic),
) -> Result<Option<Instance>, Diagnostic> {
    let (library, stage) = (Library::new(paper), Stage::default());
    let cases = Case::all(paper, theorem, &library, &stage)?;
    let Some(case) = cases.iter().find(|case| case.label == label) else { return Ok(None) };
    let (by, name) = match &theorem.statement {
        Statement::Bound { by, .. } => (by, (LEVEL, Some(Rational::from(level)))),
        Statement::Depth(by) => (by, (TOLERANCE, tolerance.as_rational().cloned())),
        Statement::Other(_) => return Ok(None),
    };
    let (name, Some(value)) = name else { return Ok(None) };
    let settings = case.prepared(by, Settings::default());
    let mut numbers =
        Numbers { case, by, names: [(name, value)], settings: &settings, constants: Vec::new() };
    let bound = numbers.put_in(&by.expr).to_string();
    let constants = numbers.constants;
    let offset = theorem.tried.offset;
    let scheme = case.resolved.as_ref().map(|scheme| scheme.at(offset));
    let masks = scheme.iter().flat_map(Scheme::iter).cloned().collect();
    let ring = case.setting.as_ref().and_then(|setting| setting.ring());
    let interpolant = case.setting.as_ref().and_then(|setting| setting.interpolant().cloned());
    Ok(Some(Instance {
        resolved: case.resolved.clone(),
        interpolant,
        refiner: ring.map_or(Refiner::Masks(masks), |ring| Refiner::Ring(ring.clone())),
        values: case.values.clone(),
        constants,
        bound,
    }))
}

/// Replaces names and functions of schemes by numbers.
struct Numbers<'n, 'a> {
    case: &'n Case<'a>,
    by: &'n LocatedFormula,
    names: [(&'n str, Rational); 1],
    settings: &'n Settings,
    constants: Vec<HandConstant>,
}

impl Numbers<'_, '_> {
    fn put_in(&mut self, expr: &Expr) -> Expr {
        let node = match &expr.node {
            Node::Name(_) => return self.number(expr),
            Node::Call { function, .. } if !is_builtin(function) => return self.number(expr),
            Node::Call { function, arguments, options } => Node::Call {
                function: function.clone(),
                arguments: arguments.iter().map(|part| self.put_in(part)).collect(),
                options: options.clone(),
            },
            Node::Negate(operand) => Node::Negate(Box::new(self.put_in(operand))),
            Node::Power(base, exponent) => {
                Node::Power(Box::new(self.put_in(base)), Box::new(self.put_in(exponent)))
            }
            Node::Chain(first, rest) => {
                let first = Box::new(self.put_in(first));
                let rest = rest.iter().map(|(operator, part)| (*operator, self.put_in(part)));
                Node::Chain(first, rest.collect())
            }
            // An expression that depends on the index has no value here, and is kept.
            Node::Fold { fold, index, from, to, body } => Node::Fold {
                fold: *fold,
                index: index.clone(),
                from: Box::new(self.put_in(from)),
                to: Box::new(self.put_in(to)),
                body: Box::new(self.put_in(body)),
            },
            Node::Indexed { .. } | Node::Number(_) => expr.node.clone(),
        };
        Expr { node, span: expr.span.clone() }
    }

    /// The value of a name or of a call; the expression itself if the value is irrational.
    fn number(&mut self, expr: &Expr) -> Expr {
        let value = self.case.evaluate_part(self.by, expr, &self.names, self.settings);
        let Ok(Ok(value)) = value else { return expr.clone() };
        let name = expr.to_string();
        let plain = THEOREM_NAMES.contains(&&name[..]) || self.case.values.contains_key(&name);
        if !plain && self.constants.iter().all(|known| known.name != name) {
            let definition = self.case.definitions(self.settings).get(&name);
            let formula = definition.map_or_else(|| name.clone(), |formula| formula.text.clone());
            self.constants.push(HandConstant { name, formula, value: value.clone(), cell: None });
        }
        match value.as_rational() {
            Some(number) => Expr { node: Node::Number(number.clone()), span: expr.span.clone() },
            None => expr.clone(),
        }
    }
}
