//! A point of the family: what the functions of a claim are told.

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
    /// The places of the alternatives that stand for them.
    replaced: Vec<usize>,
    /// Values for parameters instead of their own.
    pub(crate) parameters: BTreeMap<String, Rational>,
    /// The values of definitions, where they are known.
    pub(crate) known: BTreeMap<String, RealCyclotomic>,
    /// What is taken from another place of the paper.
    pub(crate) copied: Option<Copied>,
    /// The place of the scheme, among those of the paper's tables, instead of the cell's own.
    pub(crate) scheme: Option<usize>,
    /// What each choice that the formula depends on is as printed.
    consulted: RefCell<BTreeMap<&'static str, String>>,
}

/// The choices that a formula may depend on, whatever its values are: those of the functions that it
/// calls.
pub(crate) fn choices_of(expr: &Expr) -> BTreeSet<&'static str> {
    let called = expr.functions();
    let depends = |choice: &&Choice| match choice.effect {
        Effect::Option { functions, .. } => functions.iter().any(|name| called.contains(name)),
        Effect::Decimal | Effect::Header => false,
    };
    FAMILY.iter().copied().filter(depends).map(|choice| choice.key).collect()
}

/// The part of a reading that some values depend on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Restricted {
    words: Vec<(&'static str, &'static str)>,
    replaced: Vec<usize>,
    parameters: BTreeMap<String, Rational>,
}

impl Settings {
    /// The reading that differs in these choices, given by name and word.
    pub(crate) fn new(words: Vec<(&'static str, &'static str)>) -> Settings {
        Settings { words, ..Settings::default() }
    }

    /// The word for an option of a function, which the claim gives as `printed`.
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

    /// The word of a choice, when it is not as printed.
    pub(crate) fn word(&self, choice: &Choice) -> Option<&'static str> {
        self.words.iter().find(|(name, _)| *name == choice.key).map(|(_, word)| *word)
    }

    /// What of this is other than printed in some choices, and in definitions.
    pub(crate) fn restricted(&self, choices: &BTreeSet<&'static str>) -> Restricted {
        let words = self.words.iter().filter(|(name, _)| choices.contains(name));
        let replaced = self.replaced.clone();
        Restricted {
            words: words.copied().collect(),
            replaced,
            parameters: self.parameters.clone(),
        }
    }

    /// The same with a value for a parameter.
    pub(crate) fn with_parameter(&self, name: &str, value: &Rational) -> Settings {
        let mut settings = self.clone();
        settings.parameters.insert(name.to_owned(), value.clone());
        settings
    }

    /// The same for another scheme of the paper's tables.
    pub(crate) fn with_scheme(&self, number: usize) -> Settings {
        Settings { scheme: Some(number), ..self.clone() }
    }

    /// The same with nothing taken from another place.
    pub(crate) fn without_copied(&self) -> Settings {
        Settings { copied: None, ..self.clone() }
    }

    /// Replaces a definition by the alternative of this place in the claim file.
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

    /// The choices that options were asked for, with their words as printed.
    pub(crate) fn consulted(&self) -> BTreeMap<&'static str, String> {
        self.consulted.borrow().clone()
    }
}
