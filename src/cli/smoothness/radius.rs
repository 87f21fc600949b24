//! A joint spectral radius, for `smoothness` and `jsr`.

use crate::cli::console::interrupt::reason;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::between;
use crate::cli::console::save::save;
use serde::Serialize;
use std::path::Path;
use subcert::exact::Enclosure;
use subcert::joint::{Entry, Hull, JointRadius, MAX_FACTORS, MAX_ROWS, MatrixSet};
use subcert::report::json::Exact;
use subcert::report::{down, up};

/// The joint spectral radius of n matrices.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Radius {
    /// The size of the matrices.
    pub(crate) size: usize,
    /// The order of the differences that they refine, which are scaled by n to this power; absent for
    /// matrices of a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) order: Option<usize>,
    /// The matrices; irrational entries are polynomials in t.
    pub(crate) matrices: Vec<Vec<Vec<String>>>,
    /// The factors of a product of large spectral radius, in the order of multiplication, counted from 0.
    product: Vec<usize>,
    /// The radius is at least the root of this degree …
    degree: usize,
    /// … of this number.
    root: Exact,
    /// A decimal that is not above the radius.
    lower: String,
    /// A decimal that is not below it.
    upper: String,
    /// Whether the radius is that root.
    pub(crate) exact: bool,
    /// The number of rows of the invariant hull.
    rows: usize,
    /// Why the search ended early, with the bounds that it had found; absent where it did not.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
    /// The bounds in words.
    #[serde(skip)]
    between: String,
    /// The lower bound in words.
    #[serde(skip)]
    at_least: String,
    /// The upper bound in words; `None` where every product of so many factors is 0.
    #[serde(skip)]
    pub(crate) at_most: Option<String>,
}

impl Radius {
    /// That of matrices, which words call by this letter.
    pub(crate) fn of<F: Entry>(
        set: &MatrixSet<F>,
        letter: char,
        order: Option<usize>,
        radius: &JointRadius,
    ) -> Radius {
        let texts = |matrix: &Vec<Vec<F>>| {
            matrix.iter().map(|row| row.iter().map(F::to_string).collect()).collect()
        };
        let (size, bounds) =
            (set.size(), Enclosure::new(radius.root_enclosure().lower().clone(), radius.upper()));
        let product = radius.product.iter().map(|i| format!("{letter}_{i}"));
        let product = product.collect::<Vec<String>>().join(" ");
        Radius {
            size,
            order,
            matrices: set.matrices().iter().map(texts).collect(),
            product: radius.product.clone(),
            degree: radius.degree,
            root: Exact::of(&radius.root),
            lower: down(bounds.lower()),
            upper: up(bounds.upper()),
            exact: radius.exact,
            ended: radius.stopped.then(reason),
            rows: radius.hull.as_ref().map_or(0, |hull| size + hull.rows.len()),
            between: between(&bounds),
            at_least: format!("{}: of the product {product}", root_text(radius)),
            at_most: radius.hull.as_ref().map(|hull| upper_text(size, radius, hull)),
        }
    }

    /// It in words.
    pub(crate) fn facts(&self) -> Vec<(String, String)> {
        let facts = [("ϱ", &self.between), ("at least", &self.at_least)];
        let facts = facts.into_iter().chain(self.at_most.as_ref().map(|most| ("at most", most)));
        facts.map(|(name, text)| (name.to_owned(), text.clone())).collect()
    }
}

/// The lower bound in words.
fn root_text(radius: &JointRadius) -> String {
    let JointRadius { root, degree, .. } = radius;
    let value = match root.as_rational() {
        Some(value) => value.to_string(),
        None => format!("x, {}", irrational(root)),
    };
    if *degree == 1 { value } else { format!("(1/{degree})-th power of {value}") }
}

/// The upper bound in words.
fn upper_text(size: usize, radius: &JointRadius, hull: &Hull) -> String {
    let of_blocks = radius.reduction.as_ref().map(|reduction| {
        if reduction.blocks.len() == 1 {
            return "in a basis of its own".to_owned();
        }
        let sizes: Vec<String> = reduction.blocks.iter().map(|b| b.size().to_string()).collect();
        format!("of the diagonal blocks of sizes {} in a common basis", sizes.join(", "))
    });
    let by = match of_blocks {
        Some(of_blocks) => of_blocks,
        None if radius.bounded => "by an extremal hull".to_owned(),
        None => "as the spectral radius of one matrix".to_owned(),
    };
    if !radius.exact {
        let rows = size + hull.rows.len();
        let blocks = if radius.reduction.is_some() { format!(" {by}") } else { String::new() };
        return format!("{}, by an invariant hull of {rows} rows{blocks}", up(&hull.bound));
    }
    let power = i32::try_from(radius.degree).expect("a short product");
    if radius.bounded || radius.root.cmp_rational(&hull.bound.pow(power)).is_eq() {
        return format!("the same, {by}: this is ϱ");
    }
    format!("the same, {by}: this is ϱ; a certificate proves {}", up(&hull.bound))
}

/// What is said where the bounds of a radius or an exponent do not meet.
pub(crate) fn apart(of: &str, radius: &Radius) -> String {
    if let Some(ended) = &radius.ended {
        return format!("The bounds{of} do not meet: {ended}.");
    }
    format!(
        "The bounds{of} do not meet: no hull of up to {MAX_ROWS} rows is found that is extremal for a real eigenvalue of a \
         product of up to {MAX_FACTORS} factors."
    )
}

fn irrational(root: &subcert::exact::RealAlgebraic) -> String {
    let polynomial = root.minimal_polynomial().unwrap_or_else(|| root.polynomial());
    format!("x = {} a root of {polynomial}", subcert::exact::format::short(root, 12))
}

/// Writes a certificate, if there is one.
pub(crate) fn write_certificate(path: &Path, text: Option<String>) -> Outcome {
    let path_text = path.display();
    let text = text.ok_or_else(|| {
        Failure::Input(format!("there is nothing to certify in `{path_text}`: the radius is 0"))
    })?;
    save(path, &text)
        .map_err(|error| Failure::Input(format!("cannot write `{path_text}`: {error}")))
}
