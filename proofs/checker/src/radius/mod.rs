//! Certificates of joint spectral radii, and of the smoothness that follows from them. FORMAT.md,
//! «Joint spectral radii».

mod field;
mod given;
mod independence;
mod matrices;
mod number;
mod read;
mod smoothness;

use crate::decimal::{Q, int};
use crate::meter::Meter;
use crate::reject::{RadiusReason, RadiusRejection, Stop, Text};
use field::Element;
use independence::is_independent;
use matrices::{Matrix, determinant, multiplied, scaled_times, symmetric_square};
use num_traits::Signed as _;
use number::Number;
use read::{Certificate, Lower};
use std::fmt;

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
    if certificate.field.is_some() {
        checked::<Element>(&certificate, &meter)
    } else {
        checked::<Q>(&certificate, &meter)
    }
}

/// The rules of a mask that a claim speaks of, and the line of the certificate where they are needed.
pub struct Mask {
    /// The rules.
    pub rules: Vec<Vec<Q>>,
    /// The line.
    pub line: usize,
}

impl Mask {
    /// Whether the shifts of the limit function are linearly independent (THEOREMS.md, 108).
    pub fn is_independent(&self) -> bool {
        let width = self.rules.first().map_or(0, Vec::len);
        let places = (0..width).rev().flat_map(|j| self.rules.iter().map(move |rule| (j, rule)));
        let symbol: Vec<Q> = places.map(|(j, rule)| rule[j].clone()).collect();
        is_independent(&symbol, self.rules.len())
    }
}

/// Checks the numbered lines of a certificate about a mask, which end with the line `end`.
pub fn check_mask(
    mask: &Mask,
    lines: &[(usize, &str)],
    end: usize,
    meter: &Meter,
) -> Result<Radius, RadiusRejection> {
    let coordinates = |rule: &Vec<Q>| rule.iter().map(|entry| vec![entry.clone()]).collect();
    let rules = mask.rules.iter().map(|rule| (mask.line, coordinates(rule))).collect();
    checked::<Q>(&Certificate::embedded(rules, lines, end)?, meter)
}

fn checked<N: Number>(certificate: &Certificate, meter: &Meter) -> Result<Radius, RadiusRejection> {
    let matrices: Vec<Matrix<N>> = certificate.matrices()?;
    if let Some(lower) = &certificate.lower {
        check_lower(&matrices, lower, meter)?;
    }
    check_hull(&matrices, certificate, meter)?;
    let at_least = certificate.lower.as_ref().map(|lower| (lower.bound.clone(), lower.degree()));
    let (continuous, not_continuous) = smoothness::check::<N>(certificate)?;
    if certificate.field.as_ref().is_some_and(|field| field.gave_up()) {
        let reason = RadiusReason::Stopped(Stop::Capped("the halvings of an interval"));
        return Err(RadiusRejection { line: certificate.end, reason });
    }
    let order = certificate.order.map(|(_, order)| order);
    Ok(Radius { at_least, at_most: certificate.bound.clone(), order, continuous, not_continuous })
}

/// A real eigenvalue of at least q shows itself by the sign of the characteristic polynomial at q.
fn check_lower<N: Number>(
    matrices: &[Matrix<N>],
    lower: &Lower,
    meter: &Meter,
) -> Result<(), RadiusRejection> {
    let at = |reason| RadiusRejection { line: lower.line, reason };
    let capped = |stop: Stop| at(RadiusReason::Stopped(stop));
    let size = matrices[0].len();
    let mut product = matrices::unit(size);
    for &factor in &lower.product {
        let matrix = matrices.get(factor).ok_or_else(|| at(RadiusReason::NoSuch))?;
        product = multiplied(&product, matrix, meter).map_err(capped)?;
    }
    let mut shifted = if lower.conjugate {
        let pairs = (size * (size + 1) / 2) as u64;
        meter.spend(8 * pairs * pairs).map_err(capped)?;
        symmetric_square(&product)
    } else {
        product
    };
    for (i, row) in shifted.iter_mut().enumerate() {
        for (j, x) in row.iter_mut().enumerate() {
            *x = if lower.negative { x.clone() } else { N::whole(0).minus(x) };
            if i == j {
                *x = x.plus(&N::fraction(&lower.bound));
            }
        }
    }
    let value = determinant(shifted, meter).map_err(capped)?;
    if lower.bound.is_positive() && value.sign() <= 0 {
        return Ok(());
    }
    Err(at(RadiusReason::NoEigenvalue(Text(lower.bound.to_string()))))
}

/// Every image of a row is a combination whose coefficients, with the remainder, are at most the bound.
fn check_hull<N: Number>(
    matrices: &[Matrix<N>],
    certificate: &Certificate,
    meter: &Meter,
) -> Result<(), RadiusRejection> {
    let size = matrices[0].len();
    let entries = matrices.iter().flatten().flatten().map(Number::cost).sum::<u64>();
    let at = |line, reason| RadiusRejection { line, reason };
    let bound = N::fraction(&certificate.bound);
    let inverse = certificate.unit.recip();
    let mut rows: Vec<Vec<Q>> = matrices::unit(size);
    for row in rows.iter_mut().flatten() {
        *row *= &certificate.unit;
    }
    for (line, row) in &certificate.rows {
        if row.len() != size {
            return Err(at(*line, RadiusReason::Size));
        }
        rows.push(row.clone());
    }
    let mut images = certificate.images.iter();
    for row in &rows {
        let of_row: u64 = row.iter().map(Number::cost).sum();
        for matrix in matrices {
            let (line, terms) =
                images.next().ok_or(at(certificate.end, RadiusReason::ImagesMissing))?;
            let steps = size as u64 * (of_row + terms.len() as u64) + entries;
            meter.spend(steps).map_err(|stop| at(*line, RadiusReason::Stopped(stop)))?;
            let mut rest = scaled_times(row, matrix);
            let mut coefficients = int(0);
            for (place, factor) in terms {
                let other = rows.get(*place).ok_or(at(*line, RadiusReason::NoSuch))?;
                for (x, v) in rest.iter_mut().zip(other) {
                    *x = x.minus(&N::fraction(&(factor * v)));
                }
                coefficients += factor.abs();
            }
            let remainder = rest.iter().fold(N::whole(0), |sum, x| sum.plus(&x.size()));
            let cost = remainder.scaled(&inverse).plus(&N::fraction(&coefficients));
            if cost.minus(&bound).sign() > 0 {
                let (cost, bound) = (Text(cost.text()), Text(certificate.bound.to_string()));
                return Err(at(*line, RadiusReason::Outside(cost, bound)));
            }
        }
    }
    match images.next() {
        Some((line, _)) => Err(at(*line, RadiusReason::TooMany)),
        None => Ok(()),
    }
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
