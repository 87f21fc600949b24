//! What separates an algebraic number from 0.
//!
//! A number x = U/L with algebraic integers U and L, whose conjugates are at most 2^u and 2^l in absolute value, in a field of degree at most D
//! over the rationals, is 0 or |x| ≥ 2^−((D − 1)u + l): the norm of U is an integer, and |L| ≤ 2^l (Burnikel, Funke, Mehlhorn, Schirra and
//! Schmitt 2001).

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Number, Q};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::Signed as _;
use std::collections::BTreeMap;

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
    /// The size of a number of a field Q(x), x = 2cos(2π/n): integers on 1, x, x², … over a denominator. All conjugates of x are at most 2.
    pub fn of(number: &Number) -> Size {
        let (n, coordinates) = number.coordinates();
        let bottom = number.bottom();
        let terms = (0_u64..).zip(&coordinates).map(|(i, c)| {
            let top = (c * Q::from_integer(bottom.clone())).to_integer();
            top.abs() << i
        });
        let upper: BigInt = terms.sum();
        Size { upper: upper.bits(), lower: bottom.bits(), field: n.into(), roots: BTreeMap::new() }
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
        let field = (self.field / 2).max(1);
        let degree = self.roots.values().fold(field, |all, degree| all.saturating_mul(*degree));
        degree.saturating_sub(1).saturating_mul(self.upper).saturating_add(self.lower)
    }
}
