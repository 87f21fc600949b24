//! The fields Q(2cos(2π/n)).

use super::error::MAX_CONDUCTOR;
use super::fixed::cosines;
use super::symmetric::{cyclotomic, prime_divisors, product};
use crate::exact::Integer;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Q(θ), θ = 2cos(2π/n), of degree m = φ(n)/2 ≥ 2, where n is not 2 mod 4 (Q(ζ_2n) =
/// Q(ζ_n) for odd n).
///
/// Its elements are Σ_{k<m} a_k C_k with C_0 = 1, C_k = 2cos(2πk/n): polynomials in
/// θ of degree below m, as C_k is a monic polynomial of degree k in θ. With integers
/// a_k these are all of `Z[θ]`, the ring of integers.
#[derive(Debug)]
pub(super) struct Field {
    conductor: usize,
    degree: usize,
    /// Sums C_h + Σ a_k C_k that are 0, of falling degree h, as h and the (k, a_k) with
    /// a_k ≠ 0 and k < h: Φ_d(x^{n/d}), which Φ_n divides, for products d of the first
    /// primes in n, with 4 for 2. The fewer primes, the fewer terms; the last is Φ_n.
    relations: Vec<Relation>,
    /// The integers within 1 of 2^64·C_k, k = 0, …, m − 1: none is above 2^65.
    words: Vec<i128>,
}

/// The (k, a_k) of a sum.
pub(super) type Terms = Vec<(usize, i64)>;

/// h and the (k, a_k).
type Relation = (usize, Terms);

/// The fields used so far, by conductor.
static FIELDS: Mutex<BTreeMap<usize, Arc<Field>>> = Mutex::new(BTreeMap::new());

/// Cosines in fixed point.
type Table = Arc<Vec<Integer>>;

/// The tables used so far, by conductor and level.
static TABLES: Mutex<BTreeMap<(usize, u32), Table>> = Mutex::new(BTreeMap::new());

/// The sums of [`Field::reduced`] so far, by conductor.
static REDUCED: Mutex<BTreeMap<usize, Arc<Vec<Terms>>>> = Mutex::new(BTreeMap::new());

/// The data behind these locks is only ever added to, and so never left broken.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Field {
    /// The field of this conductor, computed once for the whole program.
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

    /// The binary digits of the approximations of a level.
    pub(super) fn bits(level: u32) -> u32 {
        64_u32.checked_shl(level).filter(|&bits| bits > 0).expect("it fits in memory")
    }

    /// The integers within 1 of 2^bits·2cos(2πk/n), k = 0, …, m − 1.
    pub(super) fn table(&self, level: u32) -> Table {
        let key = (self.conductor, level);
        if let Some(table) = lock(&TABLES).get(&key) {
            return Arc::clone(table);
        }
        let table = Arc::new(cosines(self.conductor, self.degree, Field::bits(level)));
        Arc::clone(lock(&TABLES).entry(key).or_insert(table))
    }

    /// [`table`](Self::table) of level 0.
    pub(super) fn words(&self) -> &[i128] {
        &self.words
    }

    /// What [`Field::find_reduced`](Self::find_reduced) finds, found once for the whole
    /// program.
    pub(super) fn reduced(&self) -> Arc<Vec<Terms>> {
        if let Some(found) = lock(&REDUCED).get(&self.conductor) {
            return Arc::clone(found);
        }
        let found = Arc::new(self.find_reduced());
        Arc::clone(lock(&REDUCED).entry(self.conductor).or_insert(found))
    }

    /// The index in 0, …, ⌊n/2⌋ of the same cosine as k.
    pub(super) fn fold(&self, k: usize) -> usize {
        let k = k % self.conductor;
        k.min(self.conductor - k)
    }

    /// Room for the coefficients of C_0, …, C_⌊n/2⌋.
    pub(super) fn room(&self) -> Vec<Integer> {
        vec![Integer::zero(); self.conductor / 2 + 1]
    }

    /// Σ a_k C_k for k = 0, …, ⌊n/2⌋, in the basis of the first m: from the top, a_k C_{k−h}
    /// times the shortest relation of degree h ≤ k, which is 0, is taken away.
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

    /// The element with every C_k replaced by C_{k·multiplier}: an automorphism, for
    /// a multiplier prime to n.
    pub(super) fn conjugate(&self, element: &[Integer], multiplier: usize) -> Vec<Integer> {
        let mut sum = self.room();
        for (k, coefficient) in element.iter().enumerate() {
            sum[self.fold(k * multiplier)] += coefficient;
        }
        self.reduce(sum)
    }
}

/// Φ_d(x^{n/d}) as a sum of cosines, for a divisor d ≥ 3 of n.
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
