//! Definitions, what is given, and names that mean two things.

use crate::random_papers::choices::Choices;
use crate::random_papers::formula::{Tree, call, name, number, of, times};
use crate::random_papers::naive::Q;
use std::collections::BTreeMap;

/// How careful a paper is with its names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mood {
    /// Every name has one meaning.
    Clear,
    /// Values go before values: of a table before those of the paper, of a theorem before both.
    Shadowing,
    /// A definition, or a value of the paper, is called like what a claim speaks of.
    Ambiguous,
}

/// `[define]` and `[given]`.
#[derive(Clone, Debug)]
pub struct Names {
    pub mood: Mood,
    /// The name that has two meanings, or two values.
    pub double: Option<String>,
    pub definitions: BTreeMap<String, Tree>,
    pub given: BTreeMap<String, Q>,
    /// Of definitions: name, label, formula.
    pub alternatives: Vec<(String, String, Tree)>,
}

/// What an ambiguous paper may call a definition or a value: spreads, levels, tolerances, columns,
/// values of theorems, indices, symbols, parameters.
const DOUBLE: [&str; 16] = [
    "k", "beta", "beta_1", "epsilon", "c", "w", "lev", "spread", "tol", "h", "i", "a", "N", "v",
    "beta_3", "pi",
];

impl Names {
    pub fn new(choices: &mut Choices) -> Names {
        let mood = [Mood::Clear, Mood::Clear, Mood::Clear, Mood::Shadowing, Mood::Ambiguous];
        let mood = choices.of(&mood);
        let one = || call("contraction", &[number(1, 1)]);
        let two = || call("contraction", &[number(2, 1)]);
        let mut definitions: BTreeMap<String, Tree> = [
            ("T", one()),
            ("delta", call("contraction", &[name("c")])),
            ("sigma", call("displacement", &[])),
            (
                "rate",
                choices.of(&[number(1, 2), number(2, 3), call("min", &[name("T"), number(3, 4)])]),
            ),
            ("power", of('^', name("rate"), name("k"))),
            ("bound", times(times(name("sigma"), name("beta")), of('^', name("T"), name("k")))),
            ("series", of('/', name("bound"), of('-', number(1, 1), name("T")))),
            ("third", choices.of(&[number(1, 3), times(number(1, 3), number(2, 1))])),
            ("term", of('^', name("third"), name("h"))),
            ("mixed", choices.of(&[times(one(), two()), of('+', one(), name("rate")), two()])),
        ]
        .map(|(name, tree)| (name.to_owned(), tree))
        .into();
        let mut given = BTreeMap::from([("size".to_owned(), Q::new(1.into(), 10.into()))]);
        let label = |name: &str, tree| (name.to_owned(), "otherwise".to_owned(), tree);
        let alternatives =
            vec![label("mixed", of('+', one(), name("T"))), label("rate", number(1, 3))];
        let value = choices.of(&[
            Q::new(1.into(), 1.into()),
            Q::new(1.into(), 2.into()),
            Q::new(0.into(), 1.into()),
        ]);
        let mut double = None;
        if mood == Mood::Shadowing {
            let name = choices.of(&["c", "spread", "lev", "w", "N", "tol"]).to_owned();
            double = Some(format!("{name} is given"));
            given.insert(name, value);
        } else if mood == Mood::Ambiguous {
            let name = choices.of(&DOUBLE).to_owned();
            let of_level = times(Tree::Name("k".to_owned()), number(1, 2));
            let trees =
                [Tree::Number(value.clone()), one(), of_level, Tree::Name("beta".to_owned())];
            if choices.once_in(3) {
                double = Some(format!("{name} is given"));
                given.insert(name, value);
            } else {
                double = Some(format!("{name} is defined"));
                definitions.insert(name, choices.of(&trees));
            }
        }
        Names { mood, double, definitions, given, alternatives }
    }

    pub fn text(&self) -> String {
        let lines = |entries: Vec<(String, String)>| {
            let lines = entries.into_iter().map(|(name, value)| format!("{name} = '{value}'"));
            lines.collect::<Vec<String>>().join(
                "
",
            )
        };
        let definitions = self.definitions.iter();
        let definitions =
            definitions.map(|(name, tree)| (name.clone(), tree.to_string())).collect();
        let given = self.given.iter().map(|(name, value)| (name.clone(), value.to_string()));
        let alternatives = self.alternatives.iter().map(|(of, label, value)| {
            format!("[[alternative]]\nof = '{of}'\nlabel = '{label}'\nvalue = '{value}'\n")
        });
        format!(
            "[define]\n{}\n[given]\n{}\n{}",
            lines(definitions),
            lines(given.collect()),
            alternatives.collect::<Vec<String>>().concat()
        )
    }
}
