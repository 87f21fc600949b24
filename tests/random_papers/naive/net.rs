//! Nets, refined by one mask along each index.

use super::curve::{Curve, Row, at_clamped};
use super::{Q, int};

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

    /// A bound of ‖P^∞ − P^level‖ where both spreads are 1, and some T_c < 1 of each mask.
    ///
    /// P^∞ and P^level are products of the functionals of the masks: P⊗Q − p⊗q =
    /// (P − p)⊗Q + p⊗(Q − q). The first is at most the remainder of the first mask times ‖Q‖, the
    /// second ‖p‖ times the remainder of the second. Both norms are at most that of a level plus
    /// twice its remainder, since differences are at most twice the points; for p take the sum of
    /// two remainders.
    pub fn remainder(&self, level: u32) -> Option<Q> {
        let [first, second] = &self.0;
        let norm = |one: &Curve| {
            let known = one.levels_within(130);
            Some(one.norm(known) + one.remainder(known)? * int(2))
        };
        let (p, q) = (first.remainder(level)?, second.remainder(level)?);
        Some(&p * norm(second)? + (norm(first)? + &p * int(2)) * q)
    }
}
