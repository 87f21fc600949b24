//! Schemes that are none here, recognised by how they are written.

use crate::formula::{FreeNames, parse};
use std::collections::BTreeMap;

/// The names of variables in papers on masks of several variables.
const VARIABLES: [&str; 7] = ["z1", "z2", "z3", "z_1", "z_2", "z_3", "z₁"];

/// Why a text is no symbol of a mask, and what to write, if it is that of another kind of schemes; `known` are the names that have
/// a meaning in it.
pub(super) fn foreign_symbol(text: &str, known: &[&str]) -> Option<(String, &'static str)> {
    if text.contains("[[") {
        let message = "this is a matrix: schemes with matrices as coefficients, such as Hermite and vector schemes, are not taken";
        return Some((
            message.to_owned(),
            "a coefficient is a number; equations between single coefficients can be claimed",
        ));
    }
    let none = BTreeMap::new();
    let names = FreeNames::new(&none).of(&parse(text).ok()?);
    let other = names
        .iter()
        .find(|name| VARIABLES.contains(&name.as_str()) && !known.contains(&name.as_str()))?;
    Some((
        format!(
            "`{other}` stands for a variable: a mask of several variables is written in x, y and z"
        ),
        "a mask of curves has the one variable z, as in (1 + z)^3/4, and one of nets x and y, as in (1 + x)*(1 + y)*(1 + x*y)/2; give other names \
         values under `parameters` or `let`",
    ))
}
