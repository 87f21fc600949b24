//! The fields Q(2cos(2π/n)).

use super::error::MAX_CONDUCTOR;
use super::fixed::cosines;
use super::symmetric::{cyclotomic, prime_divisors, product};
use crate::exact::Integer;
use crate::stop::check;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Q(θ), θ = 2cos(2π/n), of degree m = φ(n)/2 ≥ 2, where n ≢ 2 mod 4. (For odd n, 2n
/// gives the same field as n.)
///
/// Its elements are Σ_{k<m} a_k C_k with C_0 = 1 and C_k = 2cos(2πk/n) for k ≥ 1. Since
/// C_k is a monic polynomial of degree k in θ, these are the polynomials in θ of degree
/// below m. The elements with integers a_k form `Z[θ]`, the ring of integers.
#[derive(Debug)]
pub(super) struct Field {
    conductor: usize,
    degree: usize,
    /// Relations C_h + Σ_{k<h} a_k C_k = 0 in order of decreasing degree h, each as h and
    /// the (k, a_k) with a_k ≠ 0. They are the polynomials Φ_d(x^{n/d}), multiples of
    /// Φ_n, where d is the product of the first 1, 2, … primes that divide n, with 4 in
    /// place of 2. Fewer primes give fewer terms. The last relation is Φ_n (degree m).
    relations: Vec<Relation>,
    /// Integers within 1 of 2^64·2cos(2πk/n), k = 0, …, m − 1. None exceeds 2^65 in
    /// absolute value.
    words: Vec<i128>,
}

/// The pairs (k, a_k) of a sum Σ a_k C_k.
pub(super) type Terms = Vec<(usize, i64)>;

/// h and the (k, a_k) of a relation C_h + Σ a_k C_k = 0.
type Relation = (usize, Terms);

/// The fields used so far, by conductor.
static FIELDS: Mutex<BTreeMap<usize, Arc<Field>>> = Mutex::new(BTreeMap::new());

/// Cosines in fixed point.
type Table = Arc<Vec<Integer>>;

/// The tables used so far, by conductor and level.
static TABLES: Mutex<BTreeMap<(usize, u32), Table>> = Mutex::new(BTreeMap::new());

/// The sums of [`Field::reduced`] so far, by conductor.
static REDUCED: Mutex<BTreeMap<usize, Arc<Vec<Terms>>>> = Mutex::new(BTreeMap::new());

/// The data behind these locks only grows, so a panic elsewhere cannot leave it
/// inconsistent.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Field {
    /// The field of this conductor; it is built once and then shared.
    ///
    /// # Panics
    /// When the degree would be below 2, or the conductor is 2 mod 4 or beyond
    /// [`MAX_CONDUCTOR`].
    pub(super) fn of(conductor: usize) -> Arc<Field> {
        assert!(
            conductor <= MAX_CONDUCTOR as usize,
            "arithmetic in the field of 2cos(2π/{conductor}), beyond the cap of {MAX_CONDUCTOR}"
        );
        assert!(conductor >= 5 && conductor % 4 != 2, "a field other than Q, in normal form");
        let mut fields = lock(&FIELDS);
        let field = fields.entry(conductor).or_insert_with(|| {
            let divisors = prime_divisors(conductor).into_iter().scan(1, |d, p| {
                *d *= if p == 2 { 4 } else { p };
                Some(*d)
            });
            let relations: Vec<Relation> = divisors.map(|d| relation(conductor, d)).collect();
            let degree = relations.last().map_or(0, |(degree, _)| *degree);
            let words = cosines(conductor, degree, Field::bits(0)).iter().map(word).collect();
            Arc::new(Field { conductor, degree, relations, words })
        });
        Arc::clone(field)
    }

    pub(super) fn conductor(&self) -> usize {
        self.conductor
    }

    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    /// The (k, a_k) with a_k ≠ 0 and k < m in Ψ_n = C_m + Σ a_k C_k.
    pub(super) fn relation(&self) -> &[(usize, i64)] {
        self.relations.last().map_or(&[], |(_, relation)| relation)
    }

    /// The number 64·2^level of binary digits of the approximations at `level`.
    pub(super) fn bits(level: u32) -> u32 {
        64_u32.checked_shl(level).filter(|&bits| bits > 0).expect("it fits in memory")
    }

    /// Integers within 1 of 2^bits·2cos(2πk/n), k = 0, …, m − 1, for the `bits` of this
    /// level.
    pub(super) fn table(&self, level: u32) -> Table {
        let key = (self.conductor, level);
        if let Some(table) = lock(&TABLES).get(&key) {
            return Arc::clone(table);
        }
        let table = Arc::new(cosines(self.conductor, self.degree, Field::bits(level)));
        Arc::clone(lock(&TABLES).entry(key).or_insert(table))
    }

    /// The [`table`](Self::table) of level 0, as machine integers.
    pub(super) fn words(&self) -> &[i128] {
        &self.words
    }

    /// The result of [`Field::find_reduced`](Self::find_reduced), computed once and then
    /// shared.
    pub(super) fn reduced(&self) -> Arc<Vec<Terms>> {
        if let Some(found) = lock(&REDUCED).get(&self.conductor) {
            return Arc::clone(found);
        }
        let found = Arc::new(self.find_reduced());
        Arc::clone(lock(&REDUCED).entry(self.conductor).or_insert(found))
    }

    /// The index j in 0, …, ⌊n/2⌋ with cos(2πj/n) = cos(2πk/n).
    pub(super) fn fold(&self, k: usize) -> usize {
        let k = k % self.conductor;
        k.min(self.conductor - k)
    }

    /// Zeros, one for each of the coefficients of C_0, …, C_⌊n/2⌋.
    pub(super) fn room(&self) -> Vec<Integer> {
        vec![Integer::zero(); self.conductor / 2 + 1]
    }

    /// Σ_{k≤⌊n/2⌋} a_k C_k in the basis C_0, …, C_{m−1}. For k from the top down to m, it
    /// subtracts a_k C_{k−h} times a relation of degree h ≤ k, whose value is 0. Among these
    /// relations it takes the one with the fewest terms.
    pub(super) fn reduce(&self, mut coefficients: Vec<Integer>) -> Vec<Integer> {
        let mut relations = self.relations.iter().peekable();
        for k in (self.degree..coefficients.len()).rev() {
            while relations.next_if(|(degree, _)| *degree > k).is_some() {}
            let (degree, relation) = relations.peek().expect("that of degree m is the last");
            let top = std::mem::replace(&mut coefficients[k], Integer::zero());
            if top.is_zero() {
                continue;
            }
            let shift = k - degree;
            let (_, second, times) = product(shift, *degree);
            subtract(&mut coefficients[second], &top, i64::from(times));
            for &(j, a) in relation {
                let (first, second, times) = product(shift, j);
                subtract(&mut coefficients[first], &top, a);
                subtract(&mut coefficients[second], &top, a * i64::from(times));
            }
        }
        coefficients.truncate(self.degree);
        coefficients
    }

    /// The product of two elements of `Z[θ]`.
    pub(super) fn multiply(&self, left: &[Integer], right: &[Integer]) -> Vec<Integer> {
        let mut sum = self.room();
        let terms = |factor: &[Integer]| -> Vec<usize> {
            (0..factor.len()).filter(|&k| !factor[k].is_zero()).collect()
        };
        let right_terms = terms(right);
        for i in terms(left) {
            check();
            for &j in &right_terms {
                let value = &left[i] * &right[j];
                let (first, second, times) = product(i, j);
                sum[self.fold(first)] += &value;
                for _ in 0..times {
                    sum[second] += &value;
                }
            }
        }
        self.reduce(sum)
    }

    /// The element with every C_k replaced by C_{k·multiplier}. For a multiplier coprime
    /// to n this is an automorphism of the field.
    pub(super) fn conjugate(&self, element: &[Integer], multiplier: usize) -> Vec<Integer> {
        let mut sum = self.room();
        for (k, coefficient) in element.iter().enumerate() {
            sum[self.fold(k * multiplier)] += coefficient;
        }
        self.reduce(sum)
    }
}

/// The relation Φ_d(x^{n/d}) = 0 at x = e^{2πi/n} as a sum of cosines, for a divisor d ≥
/// 3 of n.
fn relation(n: usize, d: usize) -> Relation {
    let mut coefficients = cyclotomic(d);
    coefficients.pop();
    let degree = coefficients.len() * (n / d);
    let terms = coefficients.into_iter().enumerate().filter(|(_, a)| *a != 0);
    (degree, terms.map(|(k, a)| (k * (n / d), a)).collect())
}

fn word(cosine: &Integer) -> i128 {
    cosine.to_i128().expect("at most 2·2^64 + 1")
}

/// target −= factor·times.
fn subtract(target: &mut Integer, factor: &Integer, times: i64) {
    match times {
        0 => {}
        1 => *target -= factor,
        -1 => *target += factor,
        _ => *target -= &(factor * Integer::from(times)),
    }
}
