//! What separates an algebraic number from 0.
//!
//! A number x = U/L with algebraic integers U and L, whose conjugates are at most 2^u and 2^l in absolute value, in a field of degree at most D
//! over the rationals, is 0 or |x| ≥ 2^−((D − 1)u + l): the norm of U is an integer, and |L| ≤ 2^l (Burnikel, Funke, Mehlhorn, Schirra and
//! Schmitt 2001).

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Number, Q};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};
use std::collections::BTreeMap;

/// The greatest n whose residues are counted.
const MAX_COUNTED: u64 = 10_000;

/// The greatest n of a field whose degree is taken as it is.
const MAX_SMALL: u32 = 24;

/// The exponents of the bounds, and the field: that of 2cos(2π/n) with some roots adjoined.
#[derive(Clone, Debug)]
pub struct Size {
    upper: u64,
    lower: u64,
    field: u64,
    /// The degree of each root, by what it is a root of.
    roots: BTreeMap<String, u64>,
}

impl Size {
    /// The size of a number, and how it is made. √d is a root, since its field of cosines may have a great degree.
    pub fn of(meter: &Meter, number: &Number) -> Result<(Size, String), Stop> {
        let (n, coordinates) = number.coordinates();
        if n > MAX_SMALL {
            meter.spend(number.cost_in_field(number))?;
            if let Some([half, square]) = quadratic(number)? {
                let above = number.plus(-1, &half.clone().into())?.sign()?;
                let root = Size::in_field(&square.clone().into());
                let root = root.square_root(&format!("sqrt({square})"));
                let key = format!("{half}+{above}*sqrt({square})");
                return Ok((Size::in_field(&half.into()).sum(&root), key));
            }
        }
        Ok((Size::in_field(number), format!("{n}:{coordinates:?}")))
    }

    /// The size of a number of a field Q(x), x = 2cos(2π/n): integers on 1, x, x², … over a denominator. All conjugates of x are at most 2.
    fn in_field(number: &Number) -> Size {
        let (n, coordinates) = number.coordinates();
        let bottom = number.bottom();
        let terms = (0_u32..).zip(&coordinates).map(|(i, c)| {
            let top = (c * Q::from_integer(bottom.clone())).to_integer();
            // Each power of x is at most 2 times the one before.
            top.abs() * BigInt::from(2).pow(i)
        });
        let upper: BigInt = terms.sum();
        // The least exponents with upper ≤ 2^u and bottom ≤ 2^l.
        let bits = |size: BigInt| (size - BigInt::one()).max(BigInt::zero()).bits();
        Size { upper: bits(upper), lower: bits(bottom), field: n.into(), roots: BTreeMap::new() }
    }

    /// A common field.
    fn together(&self, other: &Size) -> Size {
        let mut roots = self.roots.clone();
        roots.extend(other.roots.iter().map(|(key, degree)| (key.clone(), *degree)));
        let field = self.field.lcm(&other.field);
        Size { upper: 0, lower: 0, field, roots }
    }

    /// The size of a sum or a difference: (UL′ ± U′L)/LL′.
    pub fn sum(&self, other: &Size) -> Size {
        let upper = self.upper.saturating_add(other.lower);
        let upper = upper.max(other.upper.saturating_add(self.lower)).saturating_add(1);
        Size { upper, lower: self.lower.saturating_add(other.lower), ..self.together(other) }
    }

    /// The size of a product.
    pub fn product(&self, other: &Size) -> Size {
        let upper = self.upper.saturating_add(other.upper);
        Size { upper, lower: self.lower.saturating_add(other.lower), ..self.together(other) }
    }

    /// The size of 1/x.
    pub fn inverse(&self) -> Size {
        Size { upper: self.lower, lower: self.upper, ..self.clone() }
    }

    /// The size of √x = √(UL)/L.
    pub fn square_root(&self, key: &str) -> Size {
        let mut root = self.clone();
        root.upper = self.upper.saturating_add(self.lower).div_ceil(2);
        root.roots.insert(key.to_owned(), 2);
        root
    }

    /// The size of a root of a polynomial whose coefficients have these sizes, the constant one first. With a common denominator the
    /// coefficients are algebraic integers C_i, and C_d·α is a root of y^d + Σ C_i C_d^{d−1−i} y^i, at most 2·max |C_i C_d^{d−1−i}|^{1/(d−i)}.
    pub fn root(coefficients: &[Size], key: &str) -> Option<Size> {
        let degree = u64::try_from(coefficients.len()).ok()?.checked_sub(1)?;
        let (leading, others) = coefficients.split_last()?;
        let common = coefficients.iter().fold(0_u64, |sum, c| sum.saturating_add(c.lower));
        let whole = |c: &Size| c.upper.saturating_add(common);
        let bound = (0_u64..).zip(others).map(|(i, c)| {
            let steps = degree.saturating_sub(i).max(1);
            let powers = whole(leading).saturating_mul(steps.saturating_sub(1));
            whole(c).saturating_add(powers).div_ceil(steps)
        });
        let upper = bound.max()?.saturating_add(1);
        let field = coefficients.iter().fold(leading.clone(), |all, c| all.together(c));
        let mut root = Size { upper, lower: whole(leading), ..field };
        root.roots.insert(key.to_owned(), degree);
        Some(root)
    }

    /// An exponent e: the number is 0, or at least 2^−e in absolute value.
    pub fn separation(&self) -> u64 {
        // Q(2cos(2π/n)) has half as many dimensions as there are residues prime to n.
        let residues = if self.field <= MAX_COUNTED {
            (1..=self.field).filter(|k| k.gcd(&self.field) == 1).count() as u64
        } else {
            self.field
        };
        let field = (residues / 2).max(1);
        let degree = self.roots.values().fold(field, |all, degree| all.saturating_mul(*degree));
        degree.saturating_sub(1).saturating_mul(self.upper).saturating_add(self.lower)
    }
}

/// The p and q of a number p ± √q that is not rational, if there are such rational numbers: its square is 2px + q − p².
fn quadratic(x: &Number) -> Result<Option<[Q; 2]>, Stop> {
    let (n, of_x) = x.coordinates();
    let Some((place, c)) = of_x.iter().enumerate().skip(1).find(|(_, c)| !c.is_zero()) else {
        return Ok(None);
    };
    let square = x.times(x)?;
    let (same, of_square) = square.coordinates();
    let (zero, two) = (Q::zero(), Q::from_integer(2.into()));
    let half = of_square.get(place).filter(|_| same == n).unwrap_or(&zero) / c / &two;
    let rest = square.plus(-1, &x.times(&(&half * &two).into())?)?;
    Ok(rest.rational().map(|rest| [half.clone(), rest + &half * &half]))
}
