//! A reading as the functions of a claim see it: a point of the family of readings.

use crate::claim::{Alternative, Paper};
use crate::evaluation::choices::{FAMILY, HEADER, ORDER};
use crate::evaluation::{Choice, Copied, Effect};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{Expr, LocatedFormula, is_builtin};
use crate::scheme::Instance;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// How a claim's formula is read. The default reads it as printed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Settings {
    words: Vec<(&'static str, &'static str)>,
    /// The paper's definitions with some replaced, when any are.
    pub(crate) definitions: Option<Rc<BTreeMap<String, LocatedFormula>>>,
    /// The places of these alternatives in the claim file.
    replaced: Vec<usize>,
    /// Values of parameters that replace their own.
    pub(crate) parameters: BTreeMap<String, Rational>,
    /// The values of definitions, where they are known.
    pub(crate) known: BTreeMap<String, RealCyclotomic>,
    /// The quantity that is taken from another place of the paper.
    pub(crate) copied: Option<Copied>,
    /// The place, among the schemes of the paper's tables, of the scheme that replaces the cell's
    /// own.
    pub(crate) scheme: Option<usize>,
    /// The number of the point that becomes number 0, where masks are read forwards.
    pub(crate) first: usize,
    /// The values of definitions in the rows so far.
    pub(crate) rows: RowValues,
    /// The printed word of every choice consulted.
    consulted: RefCell<BTreeMap<&'static str, String>>,
}

/// The values of definitions in a row: the row, the scheme and the parameters that are assumed, with
/// the values.
type OfRow = (usize, Vec<Instance>, BTreeSet<String>, Rc<BTreeMap<String, RealCyclotomic>>);

/// The values of definitions in some rows under one reading. Another reading starts with none.
#[derive(Debug, Default)]
pub(crate) struct RowValues(RefCell<Vec<OfRow>>);

impl Clone for RowValues {
    fn clone(&self) -> RowValues {
        RowValues::default()
    }
}

impl RowValues {
    /// The values in this row, if they are known.
    pub(crate) fn get(
        &self,
        row: usize,
        scheme: &[Instance],
        assume: &BTreeSet<String>,
    ) -> Option<Rc<BTreeMap<String, RealCyclotomic>>> {
        let known = self.0.borrow();
        let mut same = known.iter().rev().filter(|one| one.0 == row && one.2 == *assume);
        same.find(|one| one.1 == scheme).map(|one| Rc::clone(&one.3))
    }

    pub(crate) fn keep(
        &self,
        row: usize,
        scheme: &[Instance],
        assume: &BTreeSet<String>,
        values: &Rc<BTreeMap<String, RealCyclotomic>>,
    ) {
        let one = (row, scheme.to_vec(), assume.clone(), Rc::clone(values));
        self.0.borrow_mut().push(one);
    }
}

/// The choices that a formula may depend on: those of the functions that it calls.
pub(crate) fn choices_of(expr: &Expr) -> BTreeSet<&'static str> {
    let called = expr.functions();
    let depends = |choice: &&Choice| match choice.effect {
        Effect::Option { functions, .. } => functions.iter().any(|name| called.contains(name)),
        Effect::Decimal | Effect::Header => false,
    };
    FAMILY.iter().copied().filter(depends).map(|choice| choice.key).collect()
}

/// What the value of a definition may depend on.
pub(crate) struct Depends {
    choices: BTreeSet<&'static str>,
    /// The places of alternatives.
    alternatives: BTreeSet<usize>,
    /// The names that occur; `None` if the value leads to a scheme, whose parameters are others.
    parameters: Option<BTreeSet<String>>,
}

impl Depends {
    /// What this definition may depend on, and the definitions that it leads to, itself included,
    /// whichever alternative stands for a definition. `header`: whether headers are tolerances.
    pub(crate) fn of<'p>(
        paper: &'p Paper,
        name: &'p str,
        header: bool,
    ) -> (Depends, BTreeSet<&'p str>) {
        let (mut led, mut waiting) = (BTreeSet::new(), vec![name]);
        let (mut choices, mut alternatives) = (BTreeSet::new(), BTreeSet::new());
        let mut parameters = Some(BTreeSet::new());
        while let Some(name) = waiting.pop() {
            let Some((name, own)) = paper.definitions.get_key_value(name) else { continue };
            if !led.insert(&name[..]) {
                continue;
            }
            let others = paper.alternatives.iter().enumerate().filter(|(_, one)| one.of == *name);
            let mut formulas = vec![own];
            for (place, other) in others {
                alternatives.insert(place);
                formulas.push(&other.value);
            }
            for formula in formulas {
                choices.extend(choices_of(&formula.expr));
                waiting.extend(formula.expr.names());
                if !formula.expr.functions().iter().all(|name| is_builtin(name)) {
                    parameters = None;
                }
                if let Some(parameters) = &mut parameters {
                    parameters.extend(formula.expr.names().into_iter().map(str::to_owned));
                }
            }
        }
        if header {
            choices.insert(HEADER.key);
        }
        (Depends { choices, alternatives, parameters }, led)
    }
}

/// The part of a reading that certain values depend on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Restricted {
    words: Vec<(&'static str, &'static str)>,
    replaced: Vec<usize>,
    parameters: BTreeMap<String, Rational>,
    first: usize,
}

impl Settings {
    /// The reading with these words, each after the key of its choice.
    pub(crate) fn new(words: Vec<(&'static str, &'static str)>) -> Settings {
        Settings { words, ..Settings::default() }
    }

    /// The word of a function's option under this reading; `printed` is the word in the claim.
    /// Notes that the choice was consulted.
    pub(crate) fn option<'w>(&self, function: &str, option: &str, printed: &'w str) -> &'w str {
        let chosen = FAMILY.iter().find(|choice| match choice.effect {
            Effect::Option { option: name, functions } => {
                name == option && functions.contains(&function)
            }
            Effect::Decimal | Effect::Header => false,
        });
        let Some(choice) = chosen else { return printed };
        self.consulted.borrow_mut().entry(choice.key).or_insert_with(|| printed.to_owned());
        self.word(choice).unwrap_or(printed)
    }

    /// The word of a choice, if it differs from the printed one.
    pub(crate) fn word(&self, choice: &Choice) -> Option<&'static str> {
        self.words.iter().find(|(name, _)| *name == choice.key).map(|(_, word)| *word)
    }

    /// The part of this reading that a value depends on.
    pub(crate) fn restricted(&self, depends: &Depends) -> Restricted {
        let words = self.words.iter().filter(|(name, _)| depends.choices.contains(name));
        let replaced = self.replaced.iter().filter(|place| depends.alternatives.contains(place));
        let parameters = self.parameters.iter();
        let parameters = parameters.filter(|(name, _)| match &depends.parameters {
            // The members of a family are no names.
            Some(names) => names.contains(&name[..]) || name.contains('['),
            None => true,
        });
        Restricted {
            words: words.copied().collect(),
            replaced: replaced.copied().collect(),
            parameters: parameters.map(|(name, value)| (name.clone(), value.clone())).collect(),
            first: if depends.choices.contains(ORDER.key) { self.first } else { 0 },
        }
    }

    /// This reading with another value for a parameter.
    pub(crate) fn with_parameter(&self, name: &str, value: &Rational) -> Settings {
        let mut settings = self.clone();
        settings.parameters.insert(name.to_owned(), value.clone());
        settings
    }

    /// This reading with another scheme of the paper's tables.
    pub(crate) fn with_scheme(&self, number: usize) -> Settings {
        Settings { scheme: Some(number), ..self.clone() }
    }

    /// This reading without a quantity from another place.
    pub(crate) fn without_copied(&self) -> Settings {
        Settings { copied: None, ..self.clone() }
    }

    /// Replaces a definition by the alternative at this place in the claim file.
    pub(crate) fn replace(
        &mut self,
        printed: &BTreeMap<String, LocatedFormula>,
        place: usize,
        alternative: &Alternative,
    ) {
        let definitions = self.definitions.get_or_insert_with(|| Rc::new(printed.clone()));
        Rc::make_mut(definitions).insert(alternative.of.clone(), alternative.value.clone());
        self.replaced.push(place);
    }

    /// The choices that were consulted, each with its printed word.
    pub(crate) fn consulted(&self) -> BTreeMap<&'static str, String> {
        self.consulted.borrow().clone()
    }
}
