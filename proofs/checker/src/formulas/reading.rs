//! Readings of definitions: the meanings of the options of functions.

use std::cell::RefCell;
use std::collections::BTreeMap;

/// A choice between several ways to read a definition.
pub struct Choice {
    /// The name in certificates.
    pub name: &'static str,
    /// The option that says which way is printed.
    option: &'static str,
    /// The functions that take this option. The last two choices have none.
    functions: &'static [&'static str],
    /// The ways. The default is the first.
    pub ways: &'static [&'static str],
}

/// All choices of a family of readings. The claim file may declare other definitions, too.
#[rustfmt::skip]
pub const CHOICES: [Choice; 10] = [
    Choice { name: "order", option: "order", functions: &["contraction", "norm", "tensor", "convolution"], ways: &["adjoint", "forward"] },
    Choice { name: "suprema", option: "suprema", functions: &["tensor", "convolution_norm"], ways: &["independent", "joint"] },
    Choice { name: "contraction-terms", option: "terms", functions: &["contraction"], ways: &["each", "total"] },
    Choice { name: "displacement-terms", option: "terms", functions: &["displacement", "surface_displacement"], ways: &["each", "total"] },
    Choice { name: "offset", option: "offset", functions: &["displacement"], ways: &["own", "0", "best"] },
    Choice { name: "recursion", option: "recursion", functions: &["convolution", "convolved", "convolution_norm"], ways: &["derived", "printed"] },
    Choice { name: "exponent", option: "exponent", functions: &["levels"], ways: &["level", "block"] },
    Choice { name: "rounded", option: "rounded", functions: &["levels"], ways: &["up", "nearest", "down"] },
    Choice { name: "decimals", option: "", functions: &[], ways: &["nearest", "cut", "away"] },
    Choice { name: "tolerance", option: "", functions: &[], ways: &["exact", "less", "more"] },
];

/// A reading of definitions. It differs from the printed text in some choices.
#[derive(Debug, Default)]
pub struct Reading {
    /// The words of the choices that are read otherwise, by name.
    pub words: BTreeMap<String, String>,
    /// The choices that were consulted, with their printed words.
    pub consulted: RefCell<BTreeMap<&'static str, String>>,
}

impl Reading {
    /// The word of a function's option under this reading.
    pub fn word(&self, function: &str, option: &str, printed: &str) -> String {
        let fits =
            |choice: &&Choice| choice.option == option && choice.functions.contains(&function);
        let Some(choice) = CHOICES.iter().find(fits) else { return printed.to_owned() };
        self.consulted.borrow_mut().entry(choice.name).or_insert_with(|| printed.to_owned());
        self.words.get(choice.name).map_or(printed, String::as_str).to_owned()
    }
}
