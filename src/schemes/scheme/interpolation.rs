//! Masks from polynomial interpolation.

use super::mask::{Mask, MaskError};
use super::rules::{MAX_ARITY, MAX_WIDTH, RulesError};
use crate::exact::Rational;

/// The mask whose rule α evaluates, at t_α = (2α+1)/(2n), the polynomial of
/// degree at most 2j+1 through the points (m, x_{i+m}), m = −j, …, j+1:
///
/// a_{α,r} = Π_{m≠r−j} (t_α − m)/(r−j−m), r = 0, …, 2j+1, offset −j.
///
/// The scheme `newton` of the catalogue has the same masks, computed by formula (3.23) of
/// Khan, Omar and Mustafa 2019.
///
/// # Errors
/// When n or 2j+2 is out of range.
pub fn lagrange_mask(j: u32, n: u32) -> Result<Mask, MaskError> {
    let (arity, width) = (n as usize, 2 * j as usize + 2);
    if !(2..=MAX_ARITY).contains(&arity) {
        return Err(RulesError::Arity(arity).into());
    }
    if width > MAX_WIDTH {
        return Err(RulesError::Width(width).into());
    }
    let nodes: Vec<i64> = (-i64::from(j)..=i64::from(j) + 1).collect();
    let rule = |alpha: u32| -> Vec<Rational> {
        let t = Rational::new(2 * alpha + 1, 2 * n);
        let weight = |node: &i64| {
            let others = nodes.iter().filter(|other| *other != node);
            others.fold(Rational::one(), |product, other| {
                product * (&t - Rational::from(*other)) / Rational::from(node - other)
            })
        };
        nodes.iter().map(weight).collect()
    };
    Mask::new((0..n).map(rule).collect(), -i64::from(j))
}
