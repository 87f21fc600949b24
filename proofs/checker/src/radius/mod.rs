//! Certificates of joint spectral radii, and of the smoothness that follows from them:
//! `proofs/format/radius.md`.

mod blocks;
mod element;
mod field;
mod given;
mod independence;
mod matrices;
mod moduli;
mod read;
mod smoothness;

use crate::numbers::linear;
use crate::numbers::{Meter, Q};
use crate::text::{
    At, Line, RadiusChecked as Checked, RadiusReason, RadiusRejection, Stop, Text, require,
};
use element::Element;
use field::Field;
use given::symbol;
use independence::is_independent;
use matrices::{Matrix, multiplied, sign_of_determinant, times, zeros};
use moduli::has_modulus;
use num_traits::Signed as _;
use read::{Certificate, Leading, Lower};
use std::fmt;
use std::ops::Range;
use std::rc::Rc;

pub use read::{is_basis, is_bound};

/// A square matrix of fractions, row by row.
pub type Rational = Vec<Vec<Q>>;

/// What a valid certificate proves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Radius {
    /// The spectral radius is at least q^{1/l}.
    pub at_least: Option<(Q, usize)>,
    /// It is at most this.
    pub at_most: Q,
    /// The order of the differences, of a mask.
    pub order: Option<usize>,
    /// The limits of the scheme are C^m for this m.
    pub continuous: Option<usize>,
    /// Not all of them are C^m for this m.
    pub not_continuous: Option<usize>,
}

/// Checks a certificate of a joint spectral radius.
///
/// # Errors
/// The line that is wrong, and the reason.
pub fn check_radius(text: &str) -> Result<Radius, RadiusRejection> {
    let (certificate, meter) = (Certificate::read(text)?, Meter::default());
    checked(&certificate, &meter)
}

/// Whether the shifts of the limit function of a mask are linearly independent (THEOREMS.md, 108).
pub fn has_independent_shifts(rules: &[Vec<Q>]) -> Result<bool, Stop> {
    let elements = |rule: &Vec<Q>| rule.iter().map(Element::fraction).collect();
    let elements: Vec<Vec<Element>> = rules.iter().map(elements).collect();
    is_independent(&symbol(&elements), rules.len(), &Meter::default())
}

/// The same of the coefficients of a symbol, numbers p(α) by the coefficients of p: α is the root between two numbers of a
/// polynomial, which come in this order.
pub fn has_independent_shifts_over(
    symbol: &[Vec<Q>],
    n: usize,
    (polynomial, low, high): (Vec<Q>, Q, Q),
    meter: &Meter,
) -> Result<bool, Stop> {
    let halvings = Stop::Capped("the halvings of an interval");
    let field = Field::new(polynomial, low, high).ok_or(halvings.clone())?;
    let field = Rc::new(field);
    let symbol: Vec<Element> = symbol.iter().map(|a| Element::of(a, Some(&field))).collect();
    let found = is_independent(&symbol, n, meter)?;
    if field.gave_up() { Err(halvings) } else { Ok(found) }
}

/// Checks the lines of a certificate about the rules of a mask, which end with the line `end`. What is wrong with the
/// rules is so in the line `first`.
pub fn check_mask(
    rules: &[Vec<Q>],
    first: usize,
    lines: &[Line<'_>],
    end: usize,
    meter: &Meter,
) -> Result<Radius, RadiusRejection> {
    let coordinates = |rule: &Vec<Q>| rule.iter().map(|entry| vec![entry.clone()]).collect();
    let rules = rules.iter().map(|rule| (first, coordinates(rule))).collect();
    checked(&Certificate::embedded(rules, lines, end)?, meter)
}

/// Checks the lines from `basis` to the last `image` about these matrices, of which there is one at least, and all are of one size. The
/// last of the lines is `end`.
pub fn check_matrices(
    matrices: &[Rational],
    lines: &[Line<'_>],
    end: usize,
    meter: &Meter,
) -> Result<Radius, RadiusRejection> {
    let certificate = Certificate::bounds(lines, end)?;
    let row = |row: &Vec<Q>| row.iter().map(Element::fraction).collect();
    let matrices = matrices.iter().map(|matrix| matrix.iter().map(row).collect()).collect();
    bounded(&certificate, matrices, meter)
}

/// The blocks on the diagonal of these matrices, of which there is one at least, and all are of one size, in the basis that the lines `basis`, `inverse`
/// and `blocks` say; for each block its matrices. Without lines all is one block. The last of the lines is `end`.
pub fn blocks(
    matrices: &[Rational],
    lines: &[Line<'_>],
    end: usize,
    meter: &Meter,
) -> Result<Vec<Vec<Rational>>, RadiusRejection> {
    let known = Certificate::basis(lines)?;
    let row = |row: &Vec<Q>| row.iter().map(Element::fraction).collect();
    let elements = matrices.iter().map(|matrix| matrix.iter().map(row).collect()).collect();
    let (diagonal, places) = known.applied(elements, end, meter)?;
    let fraction = |x: &Element| x.as_fraction().unwrap_or_default();
    let part = |matrix: &Matrix, place: &Range<usize>| -> Rational {
        let row = |row: &Vec<Element>| row[place.clone()].iter().map(fraction).collect();
        matrix[place.clone()].iter().map(row).collect()
    };
    let block = |place: &Range<usize>| diagonal.iter().map(|matrix| part(matrix, place)).collect();
    Ok(places.iter().map(block).collect())
}

fn checked(certificate: &Certificate, meter: &Meter) -> Checked<Radius> {
    bounded(certificate, certificate.matrices(meter)?, meter)
}

/// What a certificate says of these matrices.
fn bounded(certificate: &Certificate, matrices: Vec<Matrix>, meter: &Meter) -> Checked<Radius> {
    let Certificate { lower, field, end, .. } = certificate;
    let (matrices, blocks) = certificate.blocks.applied(matrices, *end, meter)?;
    if let Some(lower) = lower {
        check_lower(&matrices, &blocks, lower, meter).at(lower.line)?;
    }
    check_hull(&matrices, certificate, meter)?;
    let at_least = lower.as_ref().map(|lower| (lower.bound.clone(), lower.product.len()));
    let (continuous, not_continuous) = smoothness::check(certificate, meter)?;
    let decided = field.as_ref().is_none_or(|field| !field.gave_up());
    let halvings = Stop::Capped("the halvings of an interval");
    require(decided, RadiusReason::Stopped(halvings)).at(*end)?;
    let order = certificate.order.map(|(_, order)| order);
    Ok(Radius { at_least, at_most: certificate.bound.clone(), order, continuous, not_continuous })
}

/// A real eigenvalue of at least q shows itself by the sign of the characteristic polynomial of a block at q, and others by where its zeros are.
fn check_lower(
    matrices: &[Matrix],
    blocks: &[Range<usize>],
    lower: &Lower,
    meter: &Meter,
) -> Checked<()> {
    let mut product = linear::unit(matrices[0].len(), [0, 1].map(Element::whole));
    for &factor in &lower.product {
        product = multiplied(&product, matrices.get(factor).ok_or(RadiusReason::NoSuch)?, meter)?;
    }
    let mut shown = false;
    for block in blocks {
        let part = product[block.clone()].iter().map(|row| row[block.clone()].to_vec()).collect();
        shown = shown || reaches(part, lower, meter)?;
    }
    let shown = shown && lower.bound.is_positive();
    require(shown, RadiusReason::NoEigenvalue(Text(lower.bound.to_string())))
}

fn reaches(product: Matrix, lower: &Lower, meter: &Meter) -> Checked<bool> {
    if lower.kind == Leading::Modulus {
        return Ok(has_modulus(&product, &lower.bound, meter)?);
    }
    let mut shifted = product;
    let (one, bound) = (Element::whole(1), Element::fraction(&lower.bound));
    for (i, row) in shifted.iter_mut().enumerate() {
        for (j, x) in row.iter_mut().enumerate() {
            let negative = lower.kind == Leading::Negative;
            *x = if negative { x.clone() } else { Element::whole(0).minus(x) };
            if i == j {
                x.add_product(&bound, &one, meter)?;
            }
        }
    }
    Ok(sign_of_determinant(&shifted, meter)? <= 0)
}

/// Every image of a row is a combination whose coefficients, with the remainder, are at most the bound.
fn check_hull(matrices: &[Matrix], certificate: &Certificate, meter: &Meter) -> Checked<()> {
    let size = matrices[0].len();
    let (one, bound) = (Element::whole(1), Element::fraction(&certificate.bound));
    let inverse = Element::fraction(&certificate.unit.recip());
    let unit = [Element::whole(0), Element::fraction(&certificate.unit)];
    let mut rows: Matrix = linear::unit(size, unit);
    for (line, row) in &certificate.rows {
        require(row.len() == size, RadiusReason::Size).at(*line)?;
        rows.push(row.iter().map(Element::fraction).collect());
    }
    let image = |row: &[Element], matrix: &Matrix, terms: &[(usize, Q)]| -> Checked<()> {
        meter.spend(zeros(size))?;
        let mut rest = times(row, matrix, meter)?;
        let mut cost = Element::whole(0);
        for (place, factor) in terms {
            let other = rows.get(*place).ok_or(RadiusReason::NoSuch)?;
            let less = Element::fraction(factor).negated();
            for (x, v) in rest.iter_mut().zip(other) {
                x.add_product(&less, v, meter)?;
            }
            cost.add_product(&less.size(), &one, meter)?;
        }
        let mut remainder = Element::whole(0);
        for x in &rest {
            remainder.add_product(&x.size(), &one, meter)?;
        }
        cost.add_product(&remainder, &inverse, meter)?;
        if cost.minus(&bound).sign() <= 0 {
            return Ok(());
        }
        let most = Text(certificate.bound.to_string());
        Err(RadiusReason::Outside(Text(cost.text()), most).into())
    };
    let mut images = certificate.images.iter();
    for (row, matrix) in rows.iter().flat_map(|row| matrices.iter().map(move |it| (row, it))) {
        let reason = RadiusReason::ImagesMissing;
        let missing = RadiusRejection { line: certificate.end, reason };
        let (line, terms) = images.next().ok_or(missing)?;
        image(row, matrix, terms).at(*line)?;
    }
    let more = images.next().map(|(line, _)| *line);
    require(more.is_none(), RadiusReason::TooMany).at(more.unwrap_or_default())
}

impl fmt::Display for Radius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the radius is at most {}", Text(self.at_most.to_string()))?;
        if let Some((bound, degree)) = &self.at_least {
            let root = if *degree == 1 { String::new() } else { format!("^(1/{degree})") };
            write!(f, " and at least {}{root}", Text(bound.to_string()))?;
        }
        if let Some(m) = self.continuous {
            write!(f, "; the limits are C^{m}")?;
        }
        if let Some(m) = self.not_continuous {
            write!(f, "; not all limits are C^{m}")?;
        }
        Ok(())
    }
}
