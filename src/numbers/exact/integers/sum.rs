//! Sums of products of quotients and square roots.

use super::quotient::Quotient;
use crate::exact::{Polynomial, Rational};
use std::cmp::Ordering;

/// The most square roots in one function.
const MAX_RADICALS: usize = 3;

/// The most terms of the polynomials of a function.
pub(super) const MAX_TERMS: usize = 2_000;

/// Σ_S f_S Π_{s∈S} √d_s.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Sum {
    pub(super) radicals: Vec<Polynomial>,
    /// One for each S: d_i belongs to S if bit i of the place is 1.
    pub(super) coefficients: Vec<Quotient>,
}

impl From<Quotient> for Sum {
    fn from(quotient: Quotient) -> Sum {
        Sum { radicals: Vec::new(), coefficients: vec![quotient] }
    }
}

impl Sum {
    pub(super) fn term_count(&self) -> usize {
        let radicals = self.radicals.iter().map(Polynomial::term_count).sum::<usize>();
        radicals + self.coefficients.iter().map(Quotient::term_count).sum::<usize>()
    }

    /// The coefficients of this over more radicals, of which all of its own are some.
    fn over(&self, radicals: &[Polynomial]) -> Vec<Quotient> {
        let zero = Quotient::constant(&Rational::zero());
        let mut found = vec![zero; 1 << radicals.len()];
        let place = |d: &Polynomial| radicals.iter().position(|other| other == d).unwrap_or(0);
        let places: Vec<usize> = self.radicals.iter().map(place).collect();
        for (set, coefficient) in self.coefficients.iter().enumerate() {
            let own = places.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
            found[own.map(|(_, place)| 1 << place).sum::<usize>()] = coefficient.clone();
        }
        found
    }

    /// Both over the radicals of both.
    pub(super) fn together(
        &self,
        other: &Sum,
    ) -> Option<(Vec<Polynomial>, Vec<Quotient>, Vec<Quotient>)> {
        let mut radicals = self.radicals.clone();
        for radical in &other.radicals {
            if !radicals.contains(radical) {
                radicals.push(radical.clone());
            }
        }
        let small = self.term_count().saturating_mul(other.term_count()) <= MAX_TERMS * 50;
        (radicals.len() <= MAX_RADICALS && small).then(|| {
            let (left, right) = (self.over(&radicals), other.over(&radicals));
            (radicals, left, right)
        })
    }
}

/// The product of two sums.
pub(super) fn product(
    left: &[Quotient],
    right: &[Quotient],
    radicals: &[Polynomial],
) -> Vec<Quotient> {
    let mut found = vec![Quotient::constant(&Rational::zero()); left.len()];
    for (i, a) in left.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
        for (j, b) in right.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
            let both = radicals.iter().enumerate().filter(|(bit, _)| (i & j) >> bit & 1 == 1);
            let term = both.fold(a.times(b), |term, (_, d)| term.times(&Quotient::from(d.clone())));
            found[i ^ j] = found[i ^ j].plus(&term);
        }
    }
    found
}

/// With the last radical d: the norm p² − q²d of p + q√d.
fn norm(p: &[Quotient], q: &[Quotient], d: &Polynomial, others: &[Polynomial]) -> Vec<Quotient> {
    let minus = Quotient::from(d.clone()).negated();
    let squares = product(p, p, others).into_iter().zip(product(q, q, others));
    squares.map(|(p, q)| p.plus(&q.times(&minus))).collect()
}

/// The sign of p + q√d is that of p and q, or that of p times that of p² − q²d.
pub(super) fn sign_of(sum: &[Quotient], radicals: &[Polynomial], first: i64) -> Option<Ordering> {
    let Some((d, others)) = radicals.split_last() else { return sum[0].sign_from(first) };
    let (p, q) = sum.split_at(sum.len() / 2);
    if q.iter().all(Quotient::is_zero) {
        return sign_of(p, others, first);
    }
    let (own, of_root) = (sign_of(p, others, first)?, sign_of(q, others, first)?);
    if of_root.is_eq() || own == of_root {
        return Some(own);
    }
    if own.is_eq() {
        return Some(of_root);
    }
    Some(match sign_of(&norm(p, q, d, others), others, first)? {
        Ordering::Equal => Ordering::Equal,
        Ordering::Greater => own,
        Ordering::Less => of_root,
    })
}

pub(super) fn inverse_of(
    sum: &[Quotient],
    radicals: &[Polynomial],
    first: i64,
) -> Option<Vec<Quotient>> {
    let Some((d, others)) = radicals.split_last() else {
        return Some(vec![sum[0].inverse_from(first)?]);
    };
    let (p, q) = sum.split_at(sum.len() / 2);
    if q.iter().all(Quotient::is_zero) {
        let zero = Quotient::constant(&Rational::zero());
        let mut found = inverse_of(p, others, first)?;
        found.resize(sum.len(), zero);
        return Some(found);
    }
    let inverse = inverse_of(&norm(p, q, d, others), others, first)?;
    let mut found = product(p, &inverse, others);
    found.extend(product(q, &inverse, others).iter().map(Quotient::negated));
    Some(found)
}
