//! Reduced echelon forms of short numbers, by way of primes.

use super::elimination::echelon;
use super::modular::Modulus;
use crate::exact::{Integer, Rational};
use crate::stop::check;

/// The most primes of a reduced echelon form.
const MAX_PRIMES: usize = 256;

/// The same as [`echelon`](crate::exact::echelon) of rational rows, where numbers on the way are long and those of the result short.
///
/// The form is computed modulo primes until the rational numbers of small size that it may stand for are the same for more of them. It is right if each row
/// of the matrix is the combination of its rows with the entries at the pivots as coefficients, which is checked: its rank is not greater then, and not
/// less than modulo a prime.
///
/// # Panics
/// Never: primes are below 2^31.
///
/// ```
/// use subcert::exact::{Rational, echelon, short_echelon};
///
/// let row = |entries: [i64; 3]| entries.map(|x| Rational::new(x, 7)).to_vec();
/// let rows = vec![row([2, 4, 6]), row([1, 2, 4]), row([3, 6, 10])];
/// assert_eq!(short_echelon(rows.clone()), echelon(rows));
/// ```
#[must_use]
pub fn short_echelon(rows: Vec<Vec<Rational>>) -> (Vec<Vec<Rational>>, Vec<usize>) {
    let mut known: Option<(Vec<usize>, Integer, Vec<Vec<Integer>>)> = None;
    let mut tried = 0;
    let mut next = 1;
    for p in Modulus::greatest().downwards().take(MAX_PRIMES) {
        check();
        let Some(residues) = p.residues(&rows) else { continue };
        let (reduced, pivots) = p.echelon(residues);
        tried += 1;
        known = match known {
            Some((before, modulus, values)) if before == pivots => {
                let inverse = p.inverse_of(&modulus);
                let row = |(row, more): (Vec<Integer>, Vec<u64>)| {
                    let pairs = row.iter().zip(more);
                    pairs.map(|(x, r)| p.lifted(x, r, (&modulus, inverse))).collect()
                };
                let values = values.into_iter().zip(reduced).map(row).collect();
                Some((before, modulus.clone() * Integer::from(p.prime()), values))
            }
            // Modulo few primes the rank is less, or pivots stand later.
            Some(better) if (better.0.len(), &pivots) >= (pivots.len(), &better.0) => Some(better),
            _ => {
                let row = |row: Vec<u64>| row.into_iter().map(Integer::from).collect();
                Some((pivots, Integer::from(p.prime()), reduced.into_iter().map(row).collect()))
            }
        };
        if tried < next {
            continue;
        }
        next *= 2;
        let Some((pivots, modulus, values)) = &known else { continue };
        let row = |row: &Vec<Integer>| row.iter().map(|x| of_residue(x, modulus)).collect();
        let candidate: Option<Vec<Vec<Rational>>> = values.iter().map(row).collect();
        if let Some(candidate) = candidate.filter(|reduced| spans(reduced, pivots, &rows)) {
            return (candidate, pivots.clone());
        }
    }
    echelon(rows)
}

/// Whether each row is the combination of reduced rows that its entries at the pivots say.
fn spans(reduced: &[Vec<Rational>], pivots: &[usize], rows: &[Vec<Rational>]) -> bool {
    rows.iter().all(|row| {
        let mut rest = row.clone();
        for (of_pivot, pivot) in
            reduced.iter().zip(pivots).filter(|(_, pivot)| !row[**pivot].is_zero())
        {
            let entries = rest.iter_mut().zip(of_pivot).filter(|(_, v)| !v.is_zero());
            entries.for_each(|(x, v)| *x -= &(&row[*pivot] * v));
        }
        rest.iter().all(Rational::is_zero)
    })
}

/// The fraction a/b = x modulo m with |a|, b ≤ √(m/2), if there is one: the extended algorithm of Euclid, stopped in the middle.
fn of_residue(x: &Integer, modulus: &Integer) -> Option<Rational> {
    if x.is_zero() {
        return Some(Rational::zero());
    }
    let small = |x: &Integer| x * x * Integer::from(2) <= *modulus;
    let (mut above, mut below) = (modulus.clone(), x.clone());
    let (mut first, mut second) = (Integer::zero(), Integer::one());
    while !small(&below) {
        let quotient = above.div_floor(&below);
        (above, below) = (below.clone(), above - &quotient * &below);
        (first, second) = (second.clone(), first - &quotient * &second);
    }
    (small(&second) && !second.is_zero()).then(|| Rational::new(below, second))
}
