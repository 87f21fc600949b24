//! Nets, refined by one mask along each index.

use super::curve::{Curve, Row, at_clamped};
use super::{Q, int};
use num_traits::One;

#[derive(Clone, Debug)]
pub struct Net(pub [Curve; 2]);

impl Net {
    /// The value of a product of functionals for a net that stays where its border is.
    pub fn of(rows: &[Row; 2], first: [i64; 2], points: &[Vec<i64>]) -> Q {
        let at = |i, j| {
            let row = &points[at_clamped(first[0], points.len(), i)];
            int(row[at_clamped(first[1], row.len(), j)])
        };
        let inner = |i: i64| rows[1].iter().map(move |(j, b)| b * at(i, *j)).sum::<Q>();
        rows[0].iter().map(|(i, a)| a * inner(*i)).sum()
    }

    /// A bound of ‖P^∞ − P^level‖ where both spreads are 1.
    ///
    /// At a point of the next level, the step is ((S − I)⊗R + I⊗(R − J))x with the rules S and R and the
    /// linear interpolations I and J: at most σ_1Λ_2 times the differences along the first index and
    /// σ_2 times those along the second. These are, i levels later, at most T_iΛ'_i and T'_iΛ_i, each of
    /// which a block of c levels multiplies by its value for i = c.
    pub fn remainder(&self, level: u32) -> Option<Q> {
        let [first, second] = &self.0;
        let along = |one: &Curve, other: &Curve| {
            let product = |c| one.greatest_difference(c) * other.norm(c);
            let most = one.levels_within(130).min(other.levels_within(130));
            let c = (1..=most).find(|c| product(*c) < Q::one())?;
            let upper = |level: u32| {
                let blocks = if level > most { (level - most).div_ceil(c) } else { 0 };
                product(level - blocks * c) * num_traits::pow(product(c), blocks as usize)
            };
            Some((level..level + c).map(upper).sum::<Q>() / (Q::one() - product(c)))
        };
        let step = first.greatest_step(0) * second.norm(1);
        Some(step * along(first, second)? + second.greatest_step(0) * along(second, first)?)
    }
}
