//! Readings: how the options of functions are understood.

use std::cell::RefCell;
use std::collections::BTreeMap;

/// A respect in which a definition can be read in several ways.
pub struct Choice {
    /// Its name in certificates.
    pub name: &'static str,
    /// The option that says which way is printed.
    option: &'static str,
    /// The functions that take this option; of the last two choices, none.
    functions: &'static [&'static str],
    /// The ways, the default first.
    pub ways: &'static [&'static str],
}

/// The family of readings, but for what the claim file declares.
#[rustfmt::skip]
pub const CHOICES: [Choice; 10] = [
    Choice { name: "order", option: "order", functions: &["contraction", "norm", "tensor", "convolution"], ways: &["adjoint", "forward"] },
    Choice { name: "suprema", option: "suprema", functions: &["tensor", "convolution_norm"], ways: &["independent", "joint"] },
    Choice { name: "contraction-terms", option: "terms", functions: &["contraction"], ways: &["each", "total"] },
    Choice { name: "displacement-terms", option: "terms", functions: &["displacement", "surface_displacement"], ways: &["each", "total"] },
    Choice { name: "offset", option: "offset", functions: &["displacement"], ways: &["own", "0"] },
    Choice { name: "recursion", option: "recursion", functions: &["convolution", "convolved", "convolution_norm"], ways: &["derived", "printed"] },
    Choice { name: "exponent", option: "exponent", functions: &["levels"], ways: &["level", "block"] },
    Choice { name: "rounded", option: "rounded", functions: &["levels"], ways: &["up", "nearest", "down"] },
    Choice { name: "decimals", option: "", functions: &[], ways: &["nearest", "cut", "away"] },
    Choice { name: "tolerance", option: "", functions: &[], ways: &["exact", "less", "more"] },
];

/// How a definition is read: as printed, but for some choices.
#[derive(Debug, Default)]
pub struct Reading {
    /// The words of the choices that are not as printed, by name.
    pub words: BTreeMap<String, String>,
    /// The choices that options were asked for, with their words as printed.
    pub consulted: RefCell<BTreeMap<&'static str, String>>,
}

impl Reading {
    /// The word for an option of a function that prints another.
    pub fn word(&self, function: &str, option: &str, printed: &str) -> String {
        let fits =
            |choice: &&Choice| choice.option == option && choice.functions.contains(&function);
        let Some(choice) = CHOICES.iter().find(fits) else { return printed.to_owned() };
        self.consulted.borrow_mut().entry(choice.name).or_insert_with(|| printed.to_owned());
        self.words.get(choice.name).map_or(printed, String::as_str).to_owned()
    }
}
