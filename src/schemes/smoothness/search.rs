//! The search for parameters inside and outside.

use super::excluded::{excluded, first_words, included};
use super::parametric::{PolynomialMatrix, bernstein, multiplied};
use crate::exact::{Interval, IntervalSet, Rational, RationalPolynomial, RealAlgebraic};
use crate::joint::{MatrixSet, MatrixSetError, contracts, expanding_product};
use std::collections::BTreeSet;

/// Intervals that are not wider than this are not divided.
const WIDTH: (i64, i64) = (1, 16_384);

/// The most factors of a product whose eigenvalues are taken as functions of the parameter.
const MAX_FACTORS: usize = 6;

/// The largest matrices whose determinants are taken as functions of the parameter.
const MAX_SIZE: usize = 10;

/// The most factors of a product, times the size: the degree of its determinants, for masks that are
/// linear in the parameter.
const MAX_DEGREE: usize = 16;

/// The most products.
const MAX_WORDS: usize = 48;

/// Parameters of up to 4 to this power are looked at.
const FAR: i32 = 8;

/// The most intervals that are looked at.
const MAX_PIECES: usize = 1_500;

/// What is known of a line of parameters.
pub(super) struct Search {
    matrices: Vec<PolynomialMatrix>,
    /// The greatest degree of an entry, at least 1.
    degree: usize,
    pub(super) inside: IntervalSet,
    pub(super) outside: IntervalSet,
    words: BTreeSet<Vec<usize>>,
    pieces: usize,
}

impl Search {
    pub(super) fn new(matrices: Vec<PolynomialMatrix>) -> Result<Search, MatrixSetError> {
        let entries = matrices.iter().flatten().flatten();
        let degree = entries.filter_map(RationalPolynomial::degree).max().unwrap_or(0).max(1);
        let mut search = Search {
            matrices,
            degree,
            inside: IntervalSet::default(),
            outside: IntervalSet::default(),
            words: BTreeSet::new(),
            pieces: 0,
        };
        search.set_at(&Rational::zero())?;
        for word in first_words(search.matrices.len()) {
            search.exclude(&word);
        }
        Ok(search)
    }

    fn set_at(&self, value: &Rational) -> Result<MatrixSet, MatrixSetError> {
        let row = |row: &Vec<RationalPolynomial>| row.iter().map(|p| p.value_at(value)).collect();
        let matrix = |matrix: &PolynomialMatrix| matrix.iter().map(row).collect();
        MatrixSet::new(self.matrices.iter().map(matrix).collect())
    }

    /// Adds to the outside where this product shows it.
    fn exclude(&mut self, word: &[usize]) {
        let size = self.matrices.first().map_or(0, Vec::len);
        let large = size > MAX_SIZE || size * word.len() > MAX_DEGREE;
        if large
            || word.len() > MAX_FACTORS
            || self.words.len() == MAX_WORDS
            || self.words.contains(word)
        {
            return;
        }
        let factors = word.iter().map(|&i| self.matrices[i].clone());
        let product = factors.reduce(|product, matrix| multiplied(&product, &matrix));
        let Some(product) = product else { return };
        self.words.insert(word.to_vec());
        let excluded = excluded(word, &product, |value| self.set_at(value).ok());
        self.outside = self.outside.union(&excluded);
    }

    /// Divides the line between the ends of what is known until all is decided, or too narrow.
    pub(super) fn run(&mut self, known: &IntervalSet) -> Result<(), MatrixSetError> {
        self.look_far(known)?;
        let ends = known.ends().chain(self.outside.ends()).flat_map(|(end, _)| {
            let (low, high) = end.bounds();
            [low, high]
        });
        let ends: Vec<Rational> = ends.collect();
        let one = Rational::one();
        let zero = Rational::zero();
        let low = (ends.iter().min().unwrap_or(&zero) - &one).floor();
        let high = (ends.iter().max().unwrap_or(&zero) + &one).ceil();
        let line = (Rational::from(low), Rational::from(high));
        self.divide(line, known, &Rational::new(WIDTH.0, WIDTH.1))
    }

    /// Divides an interval until all is decided, or narrower than `width`.
    pub(super) fn divide(
        &mut self,
        interval: (Rational, Rational),
        known: &IntervalSet,
        width: &Rational,
    ) -> Result<(), MatrixSetError> {
        let mut waiting = vec![interval];
        while let Some((a, b)) = waiting.pop() {
            let piece = closed(&a, &b);
            if self.outside.covers(&piece) || known.covers(&piece) || self.pieces == MAX_PIECES {
                continue;
            }
            self.pieces += 1;
            if self.is_inside(&a, &b)? {
                self.inside = self.inside.union(&IntervalSet::from(piece));
                continue;
            }
            if &b - &a <= *width {
                continue;
            }
            let middle = (&a + &b) / Rational::from(2);
            self.look_at(&middle, known)?;
            waiting.push((a, middle.clone()));
            waiting.push((middle, b));
        }
        Ok(())
    }

    /// Looks for products that exclude parameters far away.
    fn look_far(&mut self, known: &IntervalSet) -> Result<(), MatrixSetError> {
        for exponent in -1..FAR {
            for sign in [1, -1] {
                let value = Rational::from(4).pow(exponent) * Rational::from(sign);
                self.look_at(&value, known)?;
            }
        }
        Ok(())
    }

    /// Looks for a product that excludes a parameter which is not decided yet.
    fn look_at(&mut self, value: &Rational, known: &IntervalSet) -> Result<(), MatrixSetError> {
        let decided = self.outside.contains(value) || known.contains(value);
        if decided || self.words.len() == MAX_WORDS {
            return Ok(());
        }
        if let Some(word) = expanding_product(&self.set_at(value)?) {
            self.exclude(&word);
        }
        Ok(())
    }

    /// Whether the radius is below 1 on the whole interval.
    fn is_inside(&self, a: &Rational, b: &Rational) -> Result<bool, MatrixSetError> {
        let middle = (a + b) / Rational::from(2);
        if self.outside.contains(a) || self.outside.contains(b) || self.outside.contains(&middle) {
            return Ok(false);
        }
        let parts = self.matrices.iter().flat_map(|matrix| bernstein(matrix, self.degree, (a, b)));
        let set = MatrixSet::new(parts.collect())?;
        Ok(contracts(&set, &self.set_at(&middle)?))
    }
}

fn closed(a: &Rational, b: &Rational) -> Interval {
    let end = |x: &Rational| included(&RealAlgebraic::from(x.clone()));
    Interval { low: end(a), high: end(b) }
}
