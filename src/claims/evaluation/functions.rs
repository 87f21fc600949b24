//! The names and the usage of the functions that claims can call.

use crate::formula::CallError;

/// The calls of all functions, each with its meaning, for help texts.
pub const QUANTITIES: [(&str, &str); 54] = [
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
    ("coefficient(k)", "a_k, a coefficient of the symbol; of a mask on Z^d coefficient(i, j)"),
    ("symbol_at(z)", "Σ a_k z^k"),
    ("support()", "the length of the support of the basic limit function"),
    ("support_start()", "where this support begins"),
    ("support_end()", "where it ends"),
    ("symmetric()", "1 if the mask reads the same from both ends, else 0"),
    ("interpolating()", "1 if all points are kept, else 0"),
    ("sum_rules()", "the order of the sum rules, the number of factors (1 + z + … + z^(n-1))/n"),
    ("generation()", "the greatest degree of which all polynomials are limits"),
    (
        "reproduction(parameters = natural|indexed)",
        "the greatest degree of which all polynomials are the limits of their values",
    ),
    (
        "approximation_order(data = sampled|adapted)",
        "the degree of reproduction plus 1; the order of the sum rules",
    ),
    ("moment(m)", "∫ x^m φ(x) dx"),
    (
        "limit_value(x, derivative = m)",
        "φ(x), φ the limit of 1 at 0 and 0 elsewhere, or its derivative of the order m",
    ),
    ("integral(x, y)", "∫ φ from x to y"),
    ("inner_product(k, with = NAME)", "∫ φ(x) ψ(x - k) dx; ψ is φ without `with`"),
    ("riesz_lower()", "the least value of Σ cos(kξ) ∫ φ(x) φ(x - k) dx"),
    ("riesz_upper()", "the greatest one"),
    ("overshoot()", "the greatest value of limits of data from 0 to 1"),
    ("gibbs()", "the greatest value of the limit of a step from 0 to 1"),
    ("smoothness()", "the greatest m for which all limits are C^m; -1 if some are not continuous"),
    ("hoelder()", "the Hölder exponent of the limits"),
    ("sobolev()", "the Sobolev exponent of φ, in the sense of L²"),
    ("eigenvalue(j)", "the j-th greatest real eigenvalue of the local matrix of a mask"),
    ("independent()", "1 if the shifts of φ are linearly independent, else 0"),
    ("same(with = NAME)", "1 if both schemes have the same symbol, else 0"),
    (
        "eigenvalue(N, k, j)",
        "of rules around a vertex or on a face at valence N: the j-th greatest real eigenvalue of block k",
    ),
    ("subdominant(N)", "their subdominant eigenvalue λ"),
    (
        "curvature(N, part = both|elliptic|hyperbolic)",
        "the greatest absolute value of the eigenvalues after λ over λ²: curvature is bounded if it is 1, and 0 if it is less",
    ),
    (
        "limit_weight(N, orbit = NAME)",
        "the weight of each point of an orbit in the limit of the vertex",
    ),
    (
        "tangent_weight(N, j, orbit = NAME, tangent = first|second)",
        "the weight of point j of an orbit in a tangent at the vertex",
    ),
    ("positive()", "1 if the limits of all non-negative data are not negative, else 0"),
    ("monotone()", "1 if the limits of all increasing data increase, else 0"),
    ("convex()", "1 if the limits of all convex data are convex, else 0"),
    ("keeps_ratios(m, r)", "1 if ratios of m-th differences stay between 1/r and r, else 0"),
    ("vanishing_moments()", "the number of factors 1 - z of the symbol"),
    ("hurwitz()", "1 if all zeros of the symbol have negative real parts, else 0"),
    ("modulus(t)", "|a(z)| at z = e^(2πit)"),
    ("modulus_lower()", "the least value of |a(z)| on the unit circle"),
    ("modulus_upper()", "the greatest one"),
    ("orthogonal()", "1 if Σ a_k a_(k+nm) is n for m = 0 and else 0, else 0"),
    ("biorthogonal(with = NAME)", "the same of a_k and the b_k of another scheme"),
];

pub(crate) fn name_of(usage: &str) -> &str {
    usage.split('(').next().unwrap_or(usage)
}

/// The functions that are about no scheme.
const WITHOUT_SCHEME: [&str; 3] = ["levels", "convolved", "convolution_norm"];

/// The functions of filters, which read coefficients and do not need that rules sum to 1.
const OF_FILTERS: [&str; 12] = [
    "arity",
    "biorthogonal",
    "coefficient",
    "hurwitz",
    "modulus",
    "modulus_lower",
    "modulus_upper",
    "orthogonal",
    "same",
    "symbol_at",
    "symmetric",
    "vanishing_moments",
];

/// Whether the function with this name may be about a filter.
pub(crate) fn takes_filters(function: &str) -> bool {
    OF_FILTERS.contains(&function)
}

/// Whether the function with this name may be about a scheme.
pub(crate) fn is_about_scheme(function: &str) -> bool {
    let mut names = QUANTITIES.iter().map(|(usage, _)| name_of(usage));
    names.any(|name| name == function) && !WITHOUT_SCHEME.contains(&function)
}

pub(crate) fn check_name(function: &str) -> Result<(), CallError> {
    let names = QUANTITIES.iter().map(|(usage, _)| name_of(usage));
    if names.clone().any(|name| name == function) {
        return Ok(());
    }
    Err(CallError::UnknownFunction(names.map(str::to_owned).collect()))
}
