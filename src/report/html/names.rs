//! Names of the formula language as mathematicians write them.

use maud::{Markup, html};

/// Greek letters, by their names.
const GREEK: [(&str, &str); 28] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Lambda", "Λ"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// A name: Greek where it names a letter, with an index after its first underscore.
pub(super) fn name(text: &str) -> Markup {
    match text.split_once('_') {
        Some((base, index)) if !base.is_empty() && !index.is_empty() => {
            html! { msub { (letter(base)) mrow { (letter(index)) } } }
        }
        _ => letter(text),
    }
}

fn letter(text: &str) -> Markup {
    let greek = GREEK.iter().find(|(spelled, _)| *spelled == text);
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return html! { mn { (text) } };
    }
    html! { mi { (greek.map_or(text, |(_, letter)| letter)) } }
}
