//! What `subcert smoothness` and `subcert jsr` write.

use serde::Serialize;
use subcert::report::json::Exact;

/// How smooth the limits of a scheme are.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Smoothness<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The number t in which the coefficients are polynomials; absent where all are rational.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<Field>,
    /// The arity.
    pub arity: usize,
    /// The ends of the support of the basic limit function, when x^k_i belongs to i/n^k.
    pub support: [Exact; 2],
    /// The order of the sum rules.
    pub sum_rules: usize,
    /// The degree up to which polynomials are generated.
    pub generation: usize,
    /// The degree up to which polynomials are reproduced.
    pub reproduction: usize,
    /// The natural shift s: the point x^k_i belongs to (i + s)/n^k. Null where lines are not kept.
    pub natural_shift: Option<Exact>,
    /// The order of approximation of smooth functions by limits of their values.
    pub approximation_order: usize,
    /// Whether the shifts of the basic limit function are linearly independent; null where the scheme is
    /// not shown to converge.
    pub independent: Option<bool>,
    /// The largest m for which the limits are proven to be C^m; null where convergence is not proven.
    pub continuity: Option<usize>,
    /// The least m for which it is proven that not all limits are C^m; null where there is none.
    pub continuity_fails: Option<usize>,
    /// For m = 0, 1, … up to `continuity` the proof by contraction; null where none is found.
    pub contractions: Vec<Option<Contraction>>,
    /// The radius of which the exponent is made.
    pub radius: Radius,
    /// The Hölder exponent; null where convergence is not proven.
    pub hoelder: Option<Hoelder>,
}

/// The field of irrational coefficients.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Field {
    /// The minimal polynomial of t.
    pub minimal_polynomial: String,
    /// t.
    pub decimal: String,
}

/// That the differences of a derived scheme contract.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Contraction {
    /// The number c of levels.
    pub c: u32,
    /// The norm, below 1.
    pub norm: Exact,
}

/// The critical Hölder exponent.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Hoelder {
    /// A decimal that is not above it.
    pub lower: String,
    /// A decimal that is not below it.
    pub upper: String,
    /// The exponent as a formula; null where the bounds do not meet.
    pub exact: Option<String>,
    /// Whether it is attained; null where that is open.
    pub attained: Option<bool>,
}

/// The joint spectral radius of n matrices.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Radius {
    /// The size of the matrices.
    pub size: usize,
    /// The order of the differences that they refine, which are scaled by n to this power; absent for
    /// matrices of a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<usize>,
    /// The matrices; irrational entries are polynomials in t.
    pub matrices: Vec<Vec<Vec<String>>>,
    /// The factors of a product of large spectral radius, in the order of multiplication, counted from 0.
    pub product: Vec<usize>,
    /// The radius is at least the root of this degree …
    pub degree: usize,
    /// … of this number.
    pub root: Exact,
    /// A decimal that is not above the radius.
    pub lower: String,
    /// A decimal that is not below it.
    pub upper: String,
    /// Whether the radius is that root.
    pub exact: bool,
    /// The number of rows of the invariant hull.
    pub rows: usize,
}

/// What `subcert jsr` writes.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JointRadius<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The file.
    pub file: &'a str,
    /// The radius.
    #[serde(flatten)]
    pub radius: Radius,
}
