//! References to schemes, and what they mean.

use super::Draft;
use super::scheme::{CATALOGUE, catalogue};
use crate::random_papers::choices::Choices;
use crate::random_papers::formula::Env;
use crate::random_papers::formula::Tree;
use crate::random_papers::naive::{Curve, LocalRules, Net, Q};
use num_traits::ToPrimitive;
use std::collections::BTreeMap;

/// What data are refined by.
#[derive(Clone, Debug)]
pub enum Shape {
    Curve(Curve),
    Net(Net),
    LocalRules(LocalRules, Option<LocalRules>),
}

impl Shape {
    /// Whether its distances are found slowly.
    pub fn is_wide(&self) -> bool {
        let wide = |curve: &Curve| {
            let size = curve.rules.len() * curve.rules[0].len();
            size > 8 || curve.greatest_difference(1) >= Q::new(9.into(), 10.into())
        };
        match self {
            Shape::Curve(curve) => wide(curve),
            Shape::Net(Net(pair)) => pair.iter().any(wide),
            Shape::LocalRules(..) => false,
        }
    }
}

/// A scheme and values that a theorem speaks of.
#[derive(Clone, Debug)]
pub struct Instance {
    /// As the claim refers to it.
    pub reference: String,
    pub values: Vec<(String, Q)>,
    /// At the schemes' own offsets.
    pub shape: Shape,
}

/// A reference to one factor: its text, and the parameter as a formula.
#[derive(Clone, Debug)]
pub enum Factor {
    Own(usize, Option<Tree>),
    Catalogue(&'static str),
}

impl Factor {
    pub fn new(choices: &mut Choices, parameter: &Tree) -> Factor {
        match choices.below(6) {
            0..=2 => Factor::Own(0, Some(parameter.clone())),
            3 => Factor::Own(1, Some(parameter.clone())),
            4 => Factor::Own(1, None),
            _ => Factor::Catalogue(choices.of(&CATALOGUE)),
        }
    }

    pub fn text(&self, draft: &Draft) -> String {
        match self {
            Factor::Own(place, Some(w)) => format!("{}:w={w}", draft.families[*place].name),
            Factor::Own(place, None) => draft.families[*place].name.clone(),
            Factor::Catalogue(name) => (*name).to_owned(),
        }
    }

    /// The scheme where names have these values; none if its parameter has none.
    pub fn at(&self, draft: &Draft, env: &Env<'_>) -> Option<Curve> {
        match self {
            Factor::Own(place, w) => {
                let family = &draft.families[*place];
                let w = match w {
                    Some(w) => env.value(w)?,
                    None => family.default.clone()?,
                };
                Some(family.at(&w))
            }
            Factor::Catalogue(name) => Some(catalogue(name)),
        }
    }
}

/// The names that have a value in a theorem before its bound is looked at, by the letter.
pub fn environment<'d>(draft: &'d Draft, chosen: &[(String, Q)]) -> Env<'d> {
    let mut values: BTreeMap<String, Q> = draft.names.given.clone();
    values.extend(chosen.iter().cloned());
    Env { values, definitions: Some(&draft.names.definitions), scheme: None }
}

/// The valence that a formula gives.
pub fn valence(env: &Env<'_>, formula: &Tree) -> Option<usize> {
    let value = env.value(formula)?;
    value
        .is_integer()
        .then(|| value.to_integer().to_usize())
        .flatten()
        .filter(|n| (3..=5).contains(n))
}
