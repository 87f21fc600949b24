//! The constants that a table's values are computed from, and where they are attained.

use crate::bound::{Budget, Constants, Operator, Order, PowerSearch};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::CellReading;
use crate::evaluation::library::Resolved;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evaluation::trace::{Noted, NotedConstant};
use crate::exact::{Integer, Rational, RealCyclotomic};
use crate::judge::later::is_long;
use crate::limit::first_contraction;
use crate::scheme::{Instance, Rules};
use std::collections::BTreeSet;
use std::rc::Rc;

/// The most steps of all searches for the certificate of one table or theorem.
pub(crate) const MAX_STEPS: u64 = 1_000_000_000;

/// If T_c < 1 has at most this many residue classes, the checker finds it without a line of its
/// own.
const MAX_CLASSES: u64 = 1 << 12;

/// A constant of a cell, with the residue class that attains it.
#[derive(Clone, Debug, PartialEq)]
pub struct AttainedConstant {
    /// The row, counted from 0.
    pub row: usize,
    /// The column, counted from 0.
    pub column: usize,
    /// The call that gives it, in the scope of the cell.
    pub formula: String,
    /// The residue class mod n^c, in the product of sequences, that attains the constant.
    pub class: Integer,
    /// The constant.
    pub value: RealCyclotomic,
}

/// A constant T_c or Λ_c with too many residue classes to compute each, and the bounds that exclude
/// the other classes.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchedConstant {
    /// The scheme.
    pub scheme: Instance,
    /// Whether it is T_c or Λ_c.
    pub operator: Operator,
    /// The order in which the sequence is read.
    pub order: Order,
    /// c.
    pub levels: u32,
    /// The residue class mod n^c, in the product of sequences, that attains the constant.
    pub class: Integer,
    /// The constant.
    pub value: Rational,
    /// Bounds of the norms of lower powers.
    pub powers: Powers,
}

/// Bounds of ‖E^m‖, where R = sE: `proofs/THEOREMS.md`, 60 to 63.
#[derive(Clone, Debug, PartialEq)]
pub enum Powers {
    /// One bound for all m.
    All(Rational),
    /// One bound for each m from 1 to c − 1.
    Each(Vec<Rational>),
}

impl NotedConstant {
    fn key(&self) -> (Instance, Operator, Order, u32) {
        (self.instance.clone(), self.operator, self.order, self.levels)
    }

    fn rules(&self) -> &Rules {
        match self.operator {
            Operator::Difference => self.constants.difference(),
            Operator::Scheme => self.constants.mask().rules(),
        }
    }

    /// The class of a row: row r at the offset o has the coefficients of the class r +
    /// (o + N − 1)(n + … + n^c) mod n^c of the product of the sequences.
    fn class(&self, row: &Integer) -> Integer {
        let n = Integer::from(self.rules().arity());
        let powers: Integer = (1..self.levels).map(|k| n.pow(k)).sum();
        let shift = Integer::from(self.rules().offset()) + Integer::from(self.rules().width() - 1);
        (row + powers * shift).div_rem_floor(&n.pow(self.levels)).1
    }

    fn formula(&self) -> String {
        let function = match self.operator {
            Operator::Difference => "contraction",
            Operator::Scheme => "norm",
        };
        let order = if self.order == Order::Forward { ", order = forward" } else { "" };
        let scheme = self.named.as_ref().map_or(String::new(), |name| format!(", scheme = {name}"));
        format!("{function}({}{order}{scheme})", self.levels)
    }

    /// The constant with the bounds that a search tree needs; `None` beyond the caps of a search.
    fn searched(&self, budget: &Budget) -> Option<SearchedConstant> {
        let mut search = PowerSearch::new(self.rules(), self.order).with_budget(budget.clone());
        let found = search.search(self.levels)?.norm;
        let rests = search.tree(self.levels)?.operators.pop()?;
        let powers = match rests.uniform {
            Some(uniform) => Powers::All(uniform.bound),
            None => Powers::Each(rests.totals[1..].to_vec()),
        };
        Some(SearchedConstant {
            scheme: self.instance.clone(),
            operator: self.operator,
            order: self.order,
            levels: self.levels,
            class: self.class(&found.class),
            value: found.value,
            powers,
        })
    }
}

/// The constants T_c < 1 that show convergence, of those masks whose first T_c < 1 has more than
/// 4,096 residue classes.
pub(crate) fn convergence(scheme: &Resolved, budget: &Budget) -> Vec<SearchedConstant> {
    let masks = scheme.instances.iter().zip(scheme.constants.iter());
    let of = |(instance, constants): (&Instance, &Rc<Constants>)| {
        let rules = constants.difference();
        let levels = first_contraction(rules)?;
        let few = (rules.arity() as u64).checked_pow(levels).is_some_and(|n| n <= MAX_CLASSES);
        let (operator, order, named) = (Operator::Difference, Order::Adjoint, None);
        let (instance, constants) = (instance.clone(), Rc::clone(constants));
        let constant = NotedConstant { instance, constants, operator, levels, order, named };
        if few { None } else { constant.searched(budget) }
    };
    masks.filter_map(of).collect()
}

/// The constants of all cells as printed, each once, in the first cell that needs it: those whose
/// residue classes can all be computed, and the others. If the table is `read_otherwise`, the
/// others are given in both orders.
pub(crate) fn constants(
    judge: &Evaluator<'_>,
    read_otherwise: bool,
    budget: &Budget,
) -> Result<(Vec<AttainedConstant>, Vec<SearchedConstant>), Diagnostic> {
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let (mut attained, mut searched) = (Vec::<AttainedConstant>::new(), Vec::new());
    let (mut known, mut large) = (BTreeSet::new(), BTreeSet::new());
    let settings = &Settings::default();
    for row in 0..judge.table.cells.len() {
        for column in 0..judge.table.cells[row].len() {
            let Noted { constants, norms } =
                judge.constants(CellReading { row, column, assume: &assume, settings })?;
            for noted in constants {
                let orders = [noted.order, Order::Adjoint, Order::Forward];
                let asked = if read_otherwise { 3 } else { 1 };
                if is_long(noted.rules(), noted.levels) {
                    let both = orders[..asked].iter().map(|&order| (order, noted.clone()));
                    let both = both.map(|(order, noted)| NotedConstant { order, ..noted });
                    let new = both.filter(|noted| large.insert(noted.key()));
                    searched.extend(new.filter_map(|noted| noted.searched(budget)));
                } else if noted.levels > 0 && known.insert((noted.key(), noted.named.clone())) {
                    let mut search =
                        PowerSearch::new(noted.rules(), noted.order).with_budget(budget.clone());
                    let Ok(found) = search.norm(noted.levels) else { continue };
                    let (formula, value) = (noted.formula(), found.value.into());
                    let class = noted.class(&found.class);
                    attained.push(AttainedConstant { row, column, formula, class, value });
                }
            }
            for norm in norms {
                let (formula, class, value) = (norm.formula, norm.index.into(), norm.value);
                let new = AttainedConstant { row, column, formula, class, value };
                let same = |old: &AttainedConstant| {
                    (&old.formula, &old.class, &old.value) == (&new.formula, &new.class, &new.value)
                };
                if !attained.iter().any(same) {
                    attained.push(new);
                }
            }
        }
    }
    Ok((attained, searched))
}
