//! A joint spectral radius in words, for `smoothness` and `jsr`.

use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::save::save;
use crate::cli::json::smoothness as form;
use std::path::Path;
use subcert::exact::{Enclosed, Integer, Rational, format::fixed};
use subcert::joint::{Entry, Hull, JointRadius, MatrixSet};
use subcert::report::json::Exact;

/// The digits after the point of bounds.
const PLACES: u32 = 12;

/// A decimal of [`PLACES`] places that is not above the number.
pub(crate) fn down(x: &Rational) -> String {
    let unit = Rational::from(Integer::power_of_ten(PLACES));
    fixed(&(Rational::from((x * &unit).floor()) / unit), PLACES)
}

/// A decimal of [`PLACES`] places that is not below the number.
pub(crate) fn up(x: &Rational) -> String {
    let unit = Rational::from(Integer::power_of_ten(PLACES));
    fixed(&(Rational::from((x * &unit).ceil()) / unit), PLACES)
}

/// M_0 M_1 M_1.
pub(crate) fn product_text(radius: &JointRadius, letter: &str) -> String {
    let factors = radius.product.iter().map(|i| format!("{letter}_{i}"));
    factors.collect::<Vec<String>>().join(" ")
}

/// The lower bound in words.
pub(crate) fn root_text(radius: &JointRadius) -> String {
    let JointRadius { root, degree, .. } = radius;
    let value = match root.as_rational() {
        Some(value) => value.to_string(),
        None => format!("x, {}", irrational(root)),
    };
    if *degree == 1 { value } else { format!("(1/{degree})-th power of {value}") }
}

/// The upper bound in words.
pub(crate) fn upper_text(size: usize, radius: &JointRadius, hull: &Hull) -> String {
    let of_blocks = radius.reduction.as_ref().map(|reduction| {
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
pub(crate) fn apart(of: &str) -> String {
    format!(
        "The bounds{of} do not meet: no hull of up to 1200 rows is found that is extremal for a real eigenvalue of a \
         product of up to 14 factors."
    )
}

fn irrational(root: &subcert::exact::RealAlgebraic) -> String {
    let polynomial = root.minimal_polynomial().unwrap_or_else(|| root.polynomial());
    format!("x = {} a root of {polynomial}", subcert::exact::format::short(root, 12))
}

pub(crate) fn radius_form<F: Entry>(
    set: &MatrixSet<F>,
    order: Option<usize>,
    radius: &JointRadius,
) -> form::Radius {
    let texts = |matrix: &Vec<Vec<F>>| {
        matrix.iter().map(|row| row.iter().map(F::to_string).collect()).collect()
    };
    form::Radius {
        size: set.size(),
        order,
        matrices: set.matrices().iter().map(texts).collect(),
        product: radius.product.clone(),
        degree: radius.degree,
        root: Exact::of(&radius.root),
        lower: down(radius.root_enclosure().lower()),
        upper: up(&radius.upper()),
        exact: radius.exact,
        rows: radius.hull.as_ref().map_or(0, |hull| set.size() + hull.rows.len()),
    }
}

/// An enclosure as decimals that are rounded outwards, or the number that it is.
pub(crate) fn between(low: &Rational, high: &Rational) -> String {
    if low == high {
        return low.to_string();
    }
    format!("from {} to {}", down(low), up(high))
}

/// The value of an exact exponent or radius: the ends of a narrow enclosure.
pub(crate) fn ends(value: &impl Enclosed) -> (Rational, Rational) {
    let enclosure = value.enclosure(1);
    (enclosure.lower().clone(), enclosure.upper().clone())
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
