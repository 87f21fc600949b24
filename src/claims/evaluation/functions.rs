//! The names and the usage of the functions that claims can call.

use crate::formula::CallError;

/// The calls of all functions, each with its meaning, for help texts.
pub const QUANTITIES: [(&str, &str); 13] = [
    ("contraction(c, order = adjoint|forward)", "T_c; with `terms = total` and c = 1, max |Σ b|"),
    ("norm(c, order = adjoint|forward)", "Λ_c, the norm of the scheme"),
    ("tensor(c, order = …, suprema = independent|joint)", "T_c·Λ_c of the tensor product"),
    ("displacement(terms = each|total, offset = own|best|0|-1|…)", "σ"),
    ("surface_displacement(x1, x2, x3, terms = each|total)", "ν for the spreads x1, x2, x3"),
    (
        "levels(ratio, x, c, rounded = up|nearest|down, exponent = level|block)",
        "the logarithm of x to the base `ratio`; with c, which may be left out, and \
         `exponent = block` c times that",
    ),
    ("mask(alpha, j)", "a coefficient of the mask; 0 beyond its ends"),
    ("difference(beta, j)", "a coefficient of the difference mask"),
    (
        "convolution(c, l, f, order = adjoint|forward, recursion = derived|printed)",
        "E^c_{l,f}, a coefficient of c convolutions of the difference mask",
    ),
    (
        "convolved(c, n, length, l, f, sequence = NAME, index = q, recursion = derived|printed)",
        "the same for arity n and the sequence that the definition NAME gives in the index q",
    ),
    (
        "convolution_norm(c, n, length, last, sequence = NAME, with = NAME, suprema = …, index = q, \
         recursion = …)",
        "the largest Σ_l |E^c_{l,f}| over the n^c values of f up to `last`; with a second sequence, \
         the product of both, with independent or joint suprema",
    ),
    ("arity()", "n"),
    ("width()", "N"),
];

pub(crate) fn name_of(usage: &str) -> &str {
    usage.split('(').next().unwrap_or(usage)
}

pub(crate) fn check_name(function: &str) -> Result<(), CallError> {
    let names = QUANTITIES.iter().map(|(usage, _)| name_of(usage));
    if names.clone().any(|name| name == function) {
        return Ok(());
    }
    Err(CallError::UnknownFunction(names.map(str::to_owned).collect()))
}
