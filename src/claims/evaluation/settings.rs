//! A reading as the functions of a claim see it: a point of the family of readings.

use crate::claim::Alternative;
use crate::evaluation::choices::FAMILY;
use crate::evaluation::{Choice, Copied, Effect};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{Expr, LocatedFormula};
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
    /// The printed word of every choice consulted.
    consulted: RefCell<BTreeMap<&'static str, String>>,
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

/// The part of a reading that certain values depend on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Restricted {
    words: Vec<(&'static str, &'static str)>,
    replaced: Vec<usize>,
    parameters: BTreeMap<String, Rational>,
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

    /// The part of this reading that concerns these choices, the definitions and the parameters.
    pub(crate) fn restricted(&self, choices: &BTreeSet<&'static str>) -> Restricted {
        let words = self.words.iter().filter(|(name, _)| choices.contains(name));
        let replaced = self.replaced.clone();
        Restricted {
            words: words.copied().collect(),
            replaced,
            parameters: self.parameters.clone(),
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
